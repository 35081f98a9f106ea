# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Brings the images, the inputs and the meshes of coasts up to date.

    sea (evaluated: keyframes and drivers count) + time -> libocean -> float images -> nodes
                                                                    -> heights of the bed -> land

Objects are found again by the node group that they use, and coasts (open_coast) by the names of
their objects. handlers calls it, and changes of properties by way of hooks.
"""

from __future__ import annotations

import threading

import bpy

from ..sea import live as sea_live
from ..sea import messages
from ..sea.live import Moment
from ..shared import console, drafts, failures, hooks, images, meshes, modifier_groups
from ..shared.native import libocean
from ..terrain.extent import Extent, ExtentError
from . import coast_bake, land, land_nodes, node_group
from .coast_job import CoastJob, View, quick_fields, region_of
from .node_group import BLANKS, DISPLACEMENT, WETNESS, grid_words
from .open_coast import OpenCoast, coast_of

coast_objects = node_group.FAMILY.objects


def show(ob, depsgraph, moment: Moment) -> None:
    """Brings the images and the inputs of a coast up to date, and its meshes where they may be
    changed."""
    modifiers = node_group.live_modifiers(ob)
    if not modifiers:
        return
    seen = ob.evaluated_get(depsgraph) if depsgraph else ob
    coast, settings = coast_of(ob.name_full), ob.libocean_coast
    values = sea_live.current_values(seen.libocean, moment.scene)
    problem = ""
    try:
        coast.follow(values)
        if coast.own is None:
            coast.open()
        view = view_of(coast, ob, seen, moment)
        for modifier in modifiers:
            problem = _show_in(ob, coast, modifier, view, moment)
    except ExtentError as failure:
        problem = str(failure)
    except (libocean.Error, MemoryError) as failure:
        problem = messages.of_error(failure, len(values.waves))
    except Exception as failure:  # a fault of the add-on, which ends neither a frame nor an edit
        problem = failures.sentence(failure)
    if settings.problem != problem:
        settings.problem = problem


def view_of(coast: OpenCoast, ob, seen, moment: Moment) -> View:
    """Returns the view of the coast of an object. seen: the object, evaluated or not."""
    at = sea_live.own_time(seen.libocean)
    if at is None:
        at = coast.time_of(moment.scene.frame_current_final)
    return View(at, region_of(seen.libocean_coast), node_group.wanted_fields(ob, seen))


def _is_main_thread() -> bool:
    return threading.current_thread() is threading.main_thread()


def _images_of(ob, modifier, fields) -> dict:
    """Returns the images of a modifier by their inputs, made where they are missing."""
    found = {}
    for name in fields:
        owner = land_nodes.require(ob.libocean_coast.land) if name == WETNESS else modifier
        found[name] = modifier_groups.value(owner, name)
        if found[name] is None:
            found[name] = images.make(ob.name, name.lower(), (1, 1), BLANKS[name])
            modifier_groups.assign(owner, {name: found[name]})
    return found


def _show_in(ob, coast: OpenCoast, modifier, view: View, moment: Moment) -> str:
    """Fills the images of a modifier and sets its other inputs. Returns a sentence on the reason
    why the view cannot be made; "" if it can."""
    name, key = ob.name_full, coast.key(view)
    may_wait = moment.moving or (moment.is_redraw and drafts.wants(name, key))
    draft = may_wait and not coast.is_ready(view)
    if draft:
        whole = view.region.extent(coast.own)
        quick = quick_fields(view.fields)
        image_named = _images_of(ob, modifier, quick)
        shown = coast.show_draft(view, image_named) or whole
        fields = view.fields if coast.is_whole(image_named[DISPLACEMENT]) else quick
        if coast.failed is not None and coast.failed[0] == key:
            modifier_groups.assign(modifier, node_group.water_inputs(ob, shown, fields))
            return coast.failed[1]
        drafts.ask(name, key)
    else:
        fields = view.fields
        with console.work(name, "water"):
            shown = whole = coast.show(view, _images_of(ob, modifier, fields))
        drafts.forget(name, key, more_follows=False)
    if _is_main_thread():
        follow_meshes(ob, whole)
    _wet_land(ob, coast, WETNESS in view.fields)
    modifier_groups.assign(modifier, node_group.water_inputs(ob, shown, fields))
    return ""


def _wet_land(ob, coast: OpenCoast, is_wet: bool) -> None:
    """Sets all inputs of the land's modifier but the image, or removes the modifier."""
    ground = ob.libocean_coast.land
    if not meshes.is_ours(ground):
        return
    modifier = land_nodes.modifier_of(ground)
    image = modifier_groups.value(modifier, WETNESS) if modifier is not None else None
    if not is_wet:
        land_nodes.follow(ground, None)
    elif image is not None and coast.extent_in(image) is not None:
        land_nodes.follow(ground, coast.extent_in(image))


def show_all(scene, depsgraph=None, *, rendering: bool = False, passing: bool = False) -> None:
    """Shows all coasts. passing: Blender says that the frame has changed."""
    if sea_live.is_paused():
        return
    moment = Moment.of(scene, rendering=rendering, passing=passing)
    for ob in coast_objects():
        show(ob, depsgraph, moment)


def parameters_changed(ob) -> None:
    """Shows an object after one of its properties was set in the user interface or by a script."""
    if not node_group.modifiers(ob):
        return
    ob.update_tag()  # without it the evaluated object keeps the old values
    if coast_bake.follow(ob):
        drafts.forget(ob.name_full, (), more_follows=False)
    _show_with_floats(ob)


def _show_with_floats(ob) -> None:
    moment = Moment(bpy.context.scene, rendering=False, moving=drafts.allowed)
    show(ob, None, moment)
    for follower in hooks.connected().followers:
        follower(None, moment)


# Meshes ------------------------------------------------------------------------


def follow_meshes(ob, extent: Extent) -> None:
    """Makes the grid of the water, and the land as soon as its heights are known. Linked meshes
    stay as their file has them."""
    coast = coast_of(ob.name_full)
    if ob.library is None and ob.data.library is None and ob.mode == "OBJECT":
        along = extent.along(0), extent.along(1)
        meshes.follow_grid(ob, grid_words(extent), along)
    bed = coast.bed(extent)
    if bed is not None:
        with console.work(ob.name_full, "land"):
            land.follow(ob.libocean_coast.land, extent, bed, land.run_up(coast.state))


# The whole coast after a draft ---------------------------------------------------


def _named(name: str):
    return next((ob for ob in coast_objects() if ob.name_full == name), None)


def make_draft_job(name: str) -> CoastJob | None:
    ob = _named(name)
    if ob is None or ob.libocean_coast.problem or not node_group.live_modifiers(ob):
        return None
    coast = coast_of(name)
    if coast.own is None:
        return None
    moment = Moment(bpy.context.scene, rendering=False)
    return coast.job(view_of(coast, ob, ob, moment))


def finish_draft_job(name: str, job: CoastJob) -> None:
    ob = _named(name)
    if ob is None or job.is_cancelled():
        job.close()
        return
    coast = coast_of(name)
    if coast.adopt(job):
        _show_with_floats(ob)
    elif isinstance(job.failure, (libocean.Error, MemoryError)):
        text = messages.of_error(job.failure, len(ob.libocean.waves))
        coast.failed = (job.key, text)
        ob.libocean_coast.problem = text
