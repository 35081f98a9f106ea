# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Brings the images and inputs of objects with an ocean up to date.

    parameters (evaluated: keyframes and drivers count) + time -> libocean -> float images -> nodes

Blender's data is never held from call to call: objects are found again by the node groups that they
use, and seas (open_sea) by the names of their objects. Objects that play a bake are left alone.
handlers call it, and changes of properties by way of hooks.
"""

from __future__ import annotations

import contextlib
import dataclasses
from collections.abc import Iterator

import bpy

from ..bake import baked
from ..bake.baked_nodes import COVER_POWER
from ..look import detail, sun_focus
from ..shared import console, drafts, failures, hooks, images, meshes, modifier_groups
from ..shared.compat import tr_label
from ..shared.native import libocean
from . import atlas, horizon_mesh, messages, node_group, parameter_values, sea_text
from .ocean import Ocean, look_up
from .open_sea import COVER, NO_COVER, QUICK, OpenSea, sea_of
from .sea_job import SeaJob

# The values of a sea at rest.
BLANKS = {
    "Displacement": (0.0, 0.0, 0.0, 0.0),
    "Velocity": (0.0, 0.0, 0.0, 1.0),
    "Normal": (0.0, 0.0, 1.0, 0.0),
}


ocean_objects = node_group.FAMILY.objects


@dataclasses.dataclass(frozen=True)
class Moment:
    """The scene at its frame, and the purpose of showing it."""

    scene: bpy.types.Scene
    rendering: bool
    moving: bool = False
    """True if a draft suffices for now: values move, or time plays."""
    is_redraw: bool = False
    """True if Blender may redraw the same frame unprompted (e.g. after a driver edit): a draft of
    that frame stays one."""

    @classmethod
    def of(cls, scene: bpy.types.Scene, *, rendering: bool, passing: bool) -> Moment:
        """Returns the moment of a scene. passing: Blender reports that the frame has changed."""
        return cls(
            scene,
            rendering,
            moving=drafts.allows_draft(rendering=rendering, passing=passing),
            is_redraw=drafts.is_redraw(rendering=rendering, passing=passing),
        )

    def time(self, settings, sea: OpenSea) -> float:
        """Returns the sea's time at the scene's frame [s], which may lie between two frames."""
        time = own_time(settings)
        return sea.sea.time_of_frame(self.scene.frame_current_final) if time is None else time


def own_time(settings) -> float | None:
    """Returns the custom time of the settings [s]; None if the frame's time counts."""
    return settings.custom_time if settings.use_custom_time else None


def frame_rate(scene) -> float:
    return scene.render.fps / scene.render.fps_base


def current_values(settings, scene) -> sea_text.SeaValues:
    values = parameter_values.values_of(settings)
    if settings.use_scene_frame_rate:
        rate = frame_rate(scene)
        values.values["fps"] = repr(rate)
    return values


def _targets(ob, modifier, size: int, *, render: bool, shared: bool, draft: bool = False) -> dict:
    """Returns the images of the fields in use, making missing ones. shared: the viewport's images
    serve renders too. A draft has the displacement alone."""
    settings = ob.libocean
    wanted = {
        "Displacement": True,
        "Velocity": settings.use_velocity and not draft,
        "Normal": settings.use_normal and not draft,
    }
    is_horizon = node_group.kind_of(modifier.node_group) == "HORIZON"
    targets = {}
    for field, used in wanted.items():
        if not used:
            continue
        shapes = {field: (size, size)}
        if is_horizon:
            shapes[node_group.far_image(field)] = atlas.shape(size)
        for name, shape in shapes.items():
            targets[name] = _target(ob.name, modifier, name, shape, BLANKS[field], render, shared)
    return targets


def _target(owner: str, modifier, name: str, shape, blank, render: bool, shared: bool):
    names = [node_group.render_twin(name)] if render else [name]
    if shared:
        names = [name, node_group.render_twin(name)]
    image = modifier_groups.value(modifier, names[0])
    if image is None or (render and not shared and image == modifier_groups.value(modifier, name)):
        label = f"{name} render" if render and not shared else name
        image = images.make(owner, label.lower(), shape, blank)
    modifier_groups.assign(modifier, dict.fromkeys(names, image))
    return image


_SMALLEST = 32  # samples a side of a map


def prepare(ob, modifier) -> None:
    """Gives a new sea its images before it is shown. A copy in a scene that is made without images
    would keep the frame at which it was made."""
    _targets(ob, modifier, _SMALLEST, render=False, shared=True)


def show(ocean: Ocean, depsgraph, moment: Moment) -> None:
    """Brings the images and inputs of an ocean up to date."""
    ob, modifiers = ocean.ob, ocean.live
    if ob.libocean.kind == "HORIZON":
        for modifier in ocean.modifiers:
            modifier_groups.assign(modifier, {"Camera": moment.scene.camera})
    if not modifiers:
        baked.show_detail(ob)
        return
    seen = ob.evaluated_get(depsgraph) if depsgraph else ob
    values = current_values(seen.libocean, moment.scene)
    problem = ""
    try:
        ocean.sea.follow(values)
        for modifier in modifiers:
            _show_in(ocean, seen, modifier, moment)
        if ob.libocean.kind != "MESH" and not meshes.is_made(ob.data):
            problem = tr_label(
                "{} is a mesh of your own, which no patch or horizon replaces: kind MESH shows the "
                "sea on it",
                ob.data.name,
            )
    except (libocean.Error, MemoryError) as failure:
        problem = messages.of_error(failure, len(values.waves))
    except Exception as failure:  # a fault of the add-on, which ends neither a frame nor an edit
        problem = failures.sentence(failure)
    if ob.libocean.problem != problem:
        ob.libocean.problem = problem


def map_sizes(settings, sea: OpenSea) -> tuple[int, int]:
    """Returns the samples per side of the maps in the viewport and in renders."""
    own = sea.sea.map_resolution()
    return settings.viewport_resolution or own, settings.render_resolution or own


def spray_settings(settings) -> dict:
    """Returns the arguments of libocean.Sea.spray."""
    return {name: getattr(settings, f"spray_{name}") for name in ("lifetime", "density", "most")}


def channel_of(settings) -> str:
    return COVER if settings.use_foam else NO_COVER


def _show_in(ocean: Ocean, seen, modifier, moment: Moment) -> None:
    """Fills the images of a modifier and sets its other inputs. seen: the object, evaluated."""
    ob, sea, settings = ocean.ob, ocean.sea, seen.libocean
    sizes = map_sizes(settings, sea)
    shared = sizes[0] == sizes[1]
    size = sizes[1] if moment.rendering else sizes[0]
    at, channel = moment.time(settings, sea), channel_of(settings)
    name = ob.name_full
    key = (sea.changes, at, size, channel)
    may_wait = moment.moving or (moment.is_redraw and drafts.wants(name, key))
    draft = may_wait and not sea.is_ready(at, size, channel)
    if draft:
        # While time plays only foam is behind; while values move, all of the sea.
        known = sea.ready is not None and sea.ready[:2] == (sea.changes, size)
        drawn = size if known else min(size, sea.pace.size)
        targets = _targets(ob, modifier, drawn, render=False, shared=shared, draft=True)
        sea.show_draft(at, drawn, size, targets, channel)
        drafts.ask(name, key, rest=not drafts.is_playing())
    else:
        targets = _targets(ob, modifier, size, render=moment.rendering, shared=shared)
        with console.work(name, "maps"):
            sea.show(at, size, targets, channel)
        if not moment.rendering:
            drafts.forget(name, key, more_follows=settings.use_spray)
            if meshes.is_draft(ob.data):
                follow_mesh(ob)
    names = [node_group.render_twin(COVER_POWER) if moment.rendering else COVER_POWER]
    if shared:
        names = [COVER_POWER, node_group.render_twin(COVER_POWER)]
    power = sea.cover_power(at, size, QUICK[channel] if draft else channel)
    modifier_groups.assign(modifier, dict.fromkeys(names, power))
    _set_inputs(ob, seen, modifier, sea.values, sizes, draft=draft)
    if not draft:
        with console.work(name, "near detail"):
            detail.follow(ocean, settings, at, size)
        sun_focus.follow(ocean, at)
        state = sea.read_state()
        lost = [atlas.lost_slopes(state, samples) for samples in sizes]
        names = ("Slope Variance", node_group.render_twin("Slope Variance"))
        modifier_groups.assign(modifier, dict(zip(names, lost, strict=True)))
    if settings.kind == "HORIZON":
        own = sea.sea.map_resolution()
        modifier_groups.assign(modifier, {"Samples": float(samples_of(settings, own))})


def _set_inputs(
    ob, seen, modifier, values: sea_text.SeaValues, sizes: tuple[int, int], *, draft: bool
) -> None:
    settings = ob.libocean
    period = float(values.values["patch_size"])
    # Only the place within a period counts, and in single precision it counts most near 0.
    place, turn = (0.0, 0.0), (0.0, 0.0, 0.0)
    if settings.follow_world:
        place = seen.matrix_world.translation
        turn = tuple(seen.matrix_world.to_euler("XYZ"))
    origin = (place[0] % period, place[1] % period, 0.0)
    # A draft in the viewport has fewer samples than are asked for.
    shown = modifier_groups.value(modifier, "Displacement")
    samples = shown.size[0] if shown is not None else sizes[0]
    modifier_groups.assign(
        modifier,
        {
            "Tile Size": period,
            "Half Texel": 0.5 / samples,
            node_group.render_twin("Half Texel"): 0.5 / sizes[1],
            "Origin": origin,
            node_group.WORLD_ORIGIN: (place[0], place[1], 0.0),
            "Turn": turn,
            node_group.ON_SAMPLES: meshes.is_on_samples(ob.data, min(samples, sizes[1])),
            "Mask": settings.mask,
            "Use Mask": bool(settings.mask),
            "Use Foam": settings.use_foam,
            "Use Velocity": settings.use_velocity and not draft,
            "Use Normal": settings.use_normal and not draft,
        },
    )


_paused = False


@contextlib.contextmanager
def paused() -> Iterator[None]:
    """Shows nothing of the frames that pass meanwhile."""
    global _paused
    _paused = True
    try:
        yield
    finally:
        _paused = False


def is_paused() -> bool:
    return _paused


def show_all(
    oceans, scene, depsgraph=None, *, rendering: bool = False, passing: bool = False
) -> None:
    """Shows all these objects. passing: Blender says that the frame has changed."""
    if _paused:
        return
    moment = Moment.of(scene, rendering=rendering, passing=passing)
    for ob in oceans:
        show(look_up(ob), depsgraph, moment)
    for follower in hooks.connected().followers:
        follower(depsgraph, moment)


def follow(depsgraph, scene) -> None:
    """Has floats and spray follow the seas of a scene."""
    for follower in hooks.connected().followers:
        follower(depsgraph, Moment(scene, rendering=False, moving=drafts.allowed))


def parameters_changed(ob) -> bool:
    """Shows an object after one of its properties was set in the user interface or by a script.
    Returns False for an object that is no ocean."""
    ocean = look_up(ob)
    if not ocean.modifiers:
        return False
    ob.update_tag()  # without it the evaluated object keeps the old values
    if baked.follow(ob, ocean.modifiers):
        ocean.sea.shown.clear()
        ocean = look_up(ob)
    moment = Moment(bpy.context.scene, rendering=False, moving=drafts.allowed)
    show(ocean, None, moment)
    for follower in hooks.connected().followers:
        follower(None, moment)
    # While a draft is shown, the mesh is rebuilt only once values rest, except a new, empty mesh.
    draft = drafts.is_draft(ob.name_full)
    if not draft or meshes.is_empty(ob.data):
        follow_mesh(ob, draft=draft)
    return True


def follow_mesh(ob, *, draft: bool = False) -> None:
    """Makes a mesh of the add-on fit the sea, and labels a mesh of the user. A linked mesh stays as
    its file has it, unless it is a stand-in. draft: with few vertices, until the sea is whole."""
    sea, settings = sea_of(ob.name_full), ob.libocean
    is_local = ob.library is None and ob.data.library is None
    ours = is_local or meshes.is_stand_in(ob.data)
    if not ours or settings.use_bake or sea.sea is None or ob.mode != "OBJECT":
        return
    period, own = float(sea.values.values["patch_size"]), sea.sea.map_resolution()
    with console.work(ob.name_full, "mesh"):
        if settings.kind == "MESH":
            meshes.label_users(ob.data, period)
        elif not meshes.is_made(ob.data):
            return
        elif settings.kind == "PATCH":
            samples = settings.mesh_resolution or meshes.automatic(own)
            meshes.follow_patch(ob, period, samples, draft=draft)
        else:
            samples = samples_of(settings, own)
            horizon_mesh.follow_horizon(
                ob,
                period / samples,
                settings.horizon_vertices,
                settings.horizon_distance,
                draft=draft,
            )


def complete_meshes() -> None:
    """Makes the meshes whole that are drafts, before a render or for a file that is saved."""
    for ob in ocean_objects():
        if meshes.is_draft(ob.data):
            follow_mesh(ob)


def has_draft_meshes() -> bool:
    return any(meshes.is_draft(ob.data) for ob in ocean_objects())


# The whole sea after a draft --------------------------------------------------


def _named(name: str):
    return next((ob for ob in ocean_objects() if ob.name_full == name), None)


def make_draft_job(name: str) -> SeaJob | None:
    ob = _named(name)
    sea = None if ob is None or ob.libocean.use_bake else sea_of(ob.name_full)
    if sea is None or sea.sea is None or ob.libocean.problem:
        return None
    settings = ob.libocean
    at = Moment(bpy.context.scene, rendering=False).time(settings, sea)
    spray = spray_settings(settings) if settings.use_spray else None
    return sea.job(at, map_sizes(settings, sea)[0], channel_of(settings), spray)


def finish_draft_job(name: str, job: SeaJob) -> None:
    ob = _named(name)
    if ob is None or job.is_cancelled():
        job.close()
        return
    sea = sea_of(ob.name_full)
    if sea.adopt(job):
        follow_mesh(ob)
        show_all([ob], bpy.context.scene)
    elif isinstance(job.failure, (libocean.Error, MemoryError)):
        ob.libocean.problem = messages.of_error(job.failure, len(sea.values.waves))


def float_pose(ob, body: tuple[float, ...], moment: Moment):
    """Returns the libocean.FloatPose of one body on the sea of an object; None without a sea."""
    sea = sea_of(ob.name_full)
    if ob.libocean.use_bake:  # live.show does not give it its parameters then
        with contextlib.suppress(libocean.Error):
            sea.follow(current_values(ob.libocean, moment.scene))
    if sea.sea is None:
        return None
    return sea.for_points().float_pose([body], moment.time(ob.libocean, sea))


def samples_of(settings, own: int) -> int:
    """Returns the cells of a horizon's finest ring in a period. own: the sea's map resolution."""
    return max(own, settings.viewport_resolution, settings.render_resolution)
