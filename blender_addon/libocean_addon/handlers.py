# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's handlers: seas, terrains and coasts follow its frames, edits, undo, files and
renders."""

from __future__ import annotations

import threading

import bpy
from bpy.app.handlers import persistent

from . import versions
from .bake import render_check
from .coast import coast_job, open_coast
from .coast import live as coast_live
from .coast import node_group as coast_group
from .floating import floating
from .look import foam_images
from .sea import live, node_group, open_sea, stored_horizon
from .shared import compat, drafts, failures, hooks, meshes, modifier_groups
from .spray import spray
from .terrain import live as terrain_live
from .terrain import node_group as terrain_group
from .terrain import open_terrain

_locked_by_us: set[str] = set()  # scenes


@persistent
@failures.log_once
def _frame_changed(scene, depsgraph=None) -> None:
    rendering = depsgraph is not None and depsgraph.mode == "RENDER"
    if rendering:
        render_check.require_stopped()
    live.show_all(live.ocean_objects(), scene, depsgraph, rendering=rendering, passing=True)
    terrain_live.show_all(depsgraph, rendering=rendering, passing=True)
    coast_live.show_all(scene, depsgraph, rendering=rendering, passing=True)


@persistent
@failures.log_once
def _depsgraph_updated(scene, depsgraph) -> None:
    if depsgraph.mode == "RENDER":
        return
    # A collection or the scene changes when an object comes or goes.
    kinds = (bpy.types.Object, bpy.types.Collection, bpy.types.Scene)
    if any(isinstance(update.id, kinds) for update in depsgraph.updates):
        oceans, terrains = live.ocean_objects(), terrain_live.terrain_objects()
        coasts = coast_live.coast_objects()
        drafts.keep_only({ob.name_full for ob in [*oceans, *terrains, *coasts]})
        stored_horizon.make_whole(oceans)  # linked, appended, or of a file that was not written
        modifier_groups.own_images(oceans, node_group.live_modifiers, node_group.image_inputs)
        modifier_groups.own_images(terrains, terrain_group.modifiers, terrain_group.image_inputs)
        modifier_groups.own_images(coasts, coast_group.modifiers, coast_group.image_inputs)
        live.show_all(oceans, scene, depsgraph)
        terrain_live.show_all(depsgraph)
        coast_live.show_all(scene, depsgraph)
        for ob in oceans:
            if meshes.is_stand_in(ob.data):  # out of the asset library
                live.follow_mesh(ob)
                foam_images.share()


@persistent
@failures.log_once
def _data_replaced(*_) -> None:
    render_check.forget()
    oceans, terrains = live.ocean_objects(), terrain_live.terrain_objects()
    coasts = coast_live.coast_objects()
    drafts.keep_only({ob.name_full for ob in [*oceans, *terrains, *coasts]})
    drafts.forget_stops()
    open_sea.forget({ob.name_full for ob in oceans})
    open_terrain.forget({ob.name_full for ob in terrains})
    open_coast.forget({ob.name_full for ob in coasts})
    stored_horizon.make_whole(oceans)
    for ob in oceans:
        versions.upgrade(ob)
    live.show_all(oceans, bpy.context.scene)
    for ob in oceans:  # one that was not there yet when the values of an undo step were kept
        live.follow_mesh(ob)
    # From 4.0 on nothing knows where it is in the world before it is evaluated.
    seen_by_camera = any(ob.libocean_terrain.use_lod for ob in terrains)
    terrain_live.show_all(bpy.context.evaluated_depsgraph_get() if seen_by_camera else None)
    for ob in terrains:
        terrain_live.follow_mesh(ob)
    coast_live.show_all(bpy.context.scene)
    if oceans or coasts:
        live.follow(bpy.context.evaluated_depsgraph_get(), bpy.context.scene)


@persistent
@failures.log_once
def _saving(*_) -> None:
    render_check.restore()
    live.complete_meshes()
    terrain_live.complete_meshes()
    spray.empty_all()  # which is an update: it comes again
    stored_horizon.put_aside(live.ocean_objects())


@persistent
@failures.log_once
def _saved(*_) -> None:
    stored_horizon.make_whole(live.ocean_objects())


@persistent
@failures.log_once
def _before_frame(scene, *_) -> None:
    render_check.check(scene)


def complete() -> None:
    """Blocks until nothing is a draft, before a render. Says so in the console if that fails."""
    is_whole = drafts.complete()
    if threading.current_thread() is threading.main_thread():
        stored_horizon.make_whole(live.ocean_objects())
        live.complete_meshes()
        terrain_live.complete_meshes()
        return
    if not is_whole or live.has_draft_meshes() or terrain_live.has_draft_meshes():
        subjects = " and the ".join(_subjects_in_draft()) or "scene"
        print(f"libocean: the render shows a draft of the {subjects}", flush=True)


def _subjects_in_draft() -> list[str]:
    """Returns the names of the subjects that have a draft in place of maps or of a mesh."""

    def is_any_draft(objects) -> bool:
        return any(drafts.is_draft(ob.name_full) for ob in objects)

    has_draft = {
        "sea": is_any_draft(live.ocean_objects()) or live.has_draft_meshes(),
        "terrain": is_any_draft(terrain_live.terrain_objects()) or terrain_live.has_draft_meshes(),
        "coast": is_any_draft(coast_live.coast_objects()),
    }
    return [subject for subject, found in has_draft.items() if found]


@persistent
@failures.log_once
def _lock_interface(scene, *_) -> None:
    """Locks the interface: Blender must not draw images that a render in another thread
    rewrites."""
    render_check.begin()
    complete()
    terrain_live.begin_render()
    has_subjects = (
        live.ocean_objects() or terrain_live.terrain_objects() or coast_live.coast_objects()
    )
    if has_subjects and not scene.render.use_lock_interface:
        scene.render.use_lock_interface = True
        _locked_by_us.add(scene.name_full)


@persistent
@failures.log_once
def _unlock_interface(scene, *_) -> None:
    terrain_live.end_render()
    render_check.restore()
    if scene.name_full in _locked_by_us:
        _locked_by_us.remove(scene.name_full)
        scene.render.use_lock_interface = False


_HANDLERS = {
    "frame_change_post": _frame_changed,
    "depsgraph_update_post": _depsgraph_updated,
    "load_post": _data_replaced,
    "undo_post": _data_replaced,
    "redo_post": _data_replaced,
    "save_pre": _saving,
    "save_post": _saved,
    "render_init": _lock_interface,
    "render_pre": _before_frame,
    "render_complete": _unlock_interface,
    "render_cancel": _unlock_interface,
}


def _remove_handlers() -> None:
    for name, handler in _HANDLERS.items():
        handlers = getattr(bpy.app.handlers, name)
        if handler in handlers:
            handlers.remove(handler)


def _sea_changed(ob) -> None:
    """Shows an object whose sea was changed: an ocean, or the water of a coast."""
    if not live.parameters_changed(ob):
        coast_live.parameters_changed(ob)


_MAKERS = (live.make_draft_job, terrain_live.make_draft_job, coast_live.make_draft_job)


def _make_draft_job(name: str) -> drafts.Job | None:
    jobs = (make(name) for make in _MAKERS)
    return next((job for job in jobs if job is not None), None)


def _finish_draft_job(name: str, job: drafts.Job) -> None:
    finish = live.finish_draft_job
    if isinstance(job, open_terrain.TerrainJob):
        finish = terrain_live.finish_draft_job
    elif isinstance(job, coast_job.CoastJob):
        finish = coast_live.finish_draft_job
    finish(name, job)


def _wake() -> None:
    """Shows the seas and lands of a file that was opened before the add-on was switched on."""
    if live.ocean_objects() or terrain_live.terrain_objects() or coast_live.coast_objects():
        _data_replaced()


def _wake_soon() -> None:
    """Calls _wake(): with a window from a timer, without one at once, since no timer runs before
    the script of a command line."""
    if bpy.app.background:
        with compat.all_data():
            _wake()
    elif not bpy.app.timers.is_registered(_wake):
        bpy.app.timers.register(_wake, first_interval=0.0)


def register() -> None:
    for name, handler in _HANDLERS.items():
        getattr(bpy.app.handlers, name).append(handler)
    hooks.connect(
        hooks.Hooks(
            property_changed={
                "sea": _sea_changed,
                "terrain": terrain_live.parameters_changed,
                "coast": coast_live.parameters_changed,
            },
            make_draft_job=_make_draft_job,
            finish_draft_job=_finish_draft_job,
            followers=(floating.ride_all, spray.show_all),
        )
    )
    compat.remove_handlers_at_exit(_remove_handlers)
    _wake_soon()


def unregister() -> None:
    if bpy.app.timers.is_registered(_wake):
        bpy.app.timers.unregister(_wake)
    _remove_handlers()
    hooks.disconnect()
    open_sea.close_all()
    open_terrain.close_all()
    open_coast.close_all()
