# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What an object with an ocean shows is brought up to date.

    parameters (evaluated: keyframes and drivers count) + time -> libocean -> float images -> nodes

Blender's data is never held from call to call: objects are found anew, by the node groups that they
use, and seas (open_sea) by the names of their objects. Objects that play a bake are left alone.
handlers and the properties' listener call it.
"""

from __future__ import annotations

import contextlib
import dataclasses
import math
from collections.abc import Callable, Iterator

import bpy

from ..bake import baked
from ..bake.baked_nodes import COVER_POWER
from ..look import detail, sun_focus
from ..shared import images, messages
from ..shared.native import libocean
from . import atlas, drafts, meshes, node_group, parameter_values, sea_text
from .open_sea import COVER, NO_COVER, QUICK, OpenSea, sea_of

# Of a sea at rest.
BLANKS = {
    "Displacement": (0.0, 0.0, 0.0, 0.0),
    "Velocity": (0.0, 0.0, 0.0, 1.0),
    "Normal": (0.0, 0.0, 1.0, 0.0),
}

followers: list[Callable[[object, Moment], None]] = []
"""Called with the depsgraph, or None, and the moment after the seas of a scene were shown."""


def ocean_objects() -> list[bpy.types.Object]:
    """Every object with an ocean modifier, linked ones first."""
    groups = [group for group in bpy.data.node_groups if node_group.is_ours(group)]
    if not groups:
        return []
    users = bpy.data.user_map(subset=groups, value_types={"OBJECT"})
    found = {ob for objects in users.values() for ob in objects if node_group.modifiers(ob)}
    found = {ob for ob in found if not _is_dormant(ob)}
    return sorted(found, key=lambda ob: (ob.library is None, ob.name_full))


def _is_dormant(ob) -> bool:
    """In an asset library that is open, where nobody looks at it."""
    return meshes.is_stand_in(ob) and not ob.users_scene


@dataclasses.dataclass(frozen=True)
class Moment:
    """When, and for whom."""

    scene: bpy.types.Scene
    rendering: bool
    moving: bool = False
    """Whether a draft will do for now: values move, or time plays."""

    def time(self, settings, sea: OpenSea) -> float:
        """Returns the sea's time at the scene's frame [s], which may lie between two frames."""
        time = own_time(settings)
        return sea.sea.time_of_frame(self.scene.frame_current_final) if time is None else time


def own_time(settings) -> float | None:
    """Returns the time that the settings say instead of the frame's [s]; None: the frame's."""
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
    """The images of the fields in use, made where they are missing. shared: those of the viewport
    serve renders too. A draft has the displacement alone."""
    settings = ob.libocean
    wanted = {
        "Displacement": True,
        "Velocity": settings.use_velocity and not draft,
        "Normal": settings.use_normal and not draft,
    }
    targets = {}
    for field, used in wanted.items():
        if not used:
            continue
        shapes = {field: (size, size)}
        if settings.kind == "HORIZON":
            shapes[node_group.far_image(field)] = atlas.shape(size)
        for name, shape in shapes.items():
            targets[name] = _target(ob, modifier, name, shape, BLANKS[field], render, shared)
    return targets


def _target(ob, modifier, name: str, shape, blank, render: bool, shared: bool):
    names = [node_group.render_twin(name)] if render else [name]
    if shared:
        names = [name, node_group.render_twin(name)]
    image = node_group.value(modifier, names[0])
    if image is None or (render and not shared and image == node_group.value(modifier, name)):
        label = f"{name} render" if render and not shared else name
        image = images.make(ob, label.lower(), shape, blank)
    node_group.assign(modifier, dict.fromkeys(names, image))
    return image


_SMALLEST = 32  # samples a side of a map


def prepare(ob, modifier) -> None:
    """Gives a sea that nobody shows yet its images: brought in twice without any, the second one
    goes on showing the frame at which it came."""
    _targets(ob, modifier, _SMALLEST, render=False, shared=True)


def show(ob, depsgraph, moment: Moment) -> None:
    """Brings what an object shows up to date."""
    if ob.libocean.kind == "HORIZON":
        for modifier in node_group.modifiers(ob):
            node_group.assign(modifier, {"Camera": moment.scene.camera})
    modifiers = node_group.live_modifiers(ob)
    if not modifiers:
        baked.show_detail(ob)
        return
    seen = ob.evaluated_get(depsgraph) if depsgraph else ob
    settings = seen.libocean
    values = current_values(settings, moment.scene)
    sea = sea_of(ob)
    problem = ""
    try:
        sea.follow(values)
        for modifier in modifiers:
            _show_in(ob, seen, modifier, sea, moment)
    except libocean.Error as failure:
        problem = messages.of_error(failure, len(values.waves))
    if ob.libocean.problem != problem:
        ob.libocean.problem = problem


def _sizes(settings, sea: OpenSea) -> tuple[int, int]:
    """Samples a side of the maps in the viewport and in renders."""
    own = sea.sea.map_resolution()
    return settings.viewport_resolution or own, settings.render_resolution or own


def spray_settings(settings) -> dict:
    """What libocean's spray takes."""
    return {name: getattr(settings, f"spray_{name}") for name in ("lifetime", "density", "most")}


def _channel(settings) -> str:
    return COVER if settings.use_foam else NO_COVER


def _show_in(ob, seen, modifier, sea: OpenSea, moment: Moment) -> None:
    """Fills the images of a modifier and sets its other inputs."""
    settings = seen.libocean
    sizes = _sizes(settings, sea)
    shared = sizes[0] == sizes[1]
    size = sizes[1] if moment.rendering else sizes[0]
    at, channel = moment.time(settings, sea), _channel(settings)
    name = ob.name_full
    draft = moment.moving and not sea.is_ready(at, size, channel)
    if draft:
        # While time plays only foam is behind; while values move, all of the sea.
        known = sea.ready is not None and sea.ready[:2] == (sea.changes, size)
        drawn = size if known else min(size, sea.pace.size)
        targets = _targets(ob, modifier, drawn, render=False, shared=shared, draft=True)
        sea.show_draft(at, drawn, size, targets, channel)
        drafts.ask(name, rest=not drafts.is_playing())
    else:
        targets = _targets(ob, modifier, size, render=moment.rendering, shared=shared)
        sea.show(at, size, targets, channel)
        if not moment.rendering:
            drafts.forget(name)
    names = [node_group.render_twin(COVER_POWER) if moment.rendering else COVER_POWER]
    if shared:
        names = [COVER_POWER, node_group.render_twin(COVER_POWER)]
    power = sea.cover_power(at, size, QUICK[channel] if draft else channel)
    node_group.assign(modifier, dict.fromkeys(names, power))
    _set_inputs(ob, seen, modifier, sea.values, sizes, draft=draft)
    if not draft:
        detail.follow(ob, settings, sea, at, size)
        sun_focus.follow(ob, sea, at)
        state = sea.read_state()
        lost = [atlas.lost_slopes(state, samples) for samples in sizes]
        names = ("Slope Variance", node_group.render_twin("Slope Variance"))
        node_group.assign(modifier, dict(zip(names, lost, strict=True)))
    if settings.kind == "HORIZON":
        own = sea.sea.map_resolution()
        node_group.assign(modifier, {"Samples": float(samples_of(settings, own))})


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
    shown = node_group.value(modifier, "Displacement")
    samples = shown.size[0] if shown is not None else sizes[0]
    node_group.assign(
        modifier,
        {
            "Tile Size": period,
            "Half Texel": 0.5 / samples,
            node_group.render_twin("Half Texel"): 0.5 / sizes[1],
            "Origin": origin,
            node_group.WORLD_ORIGIN: (place[0], place[1], 0.0),
            "Turn": turn,
            node_group.ON_SAMPLES: meshes.is_on_samples(ob, min(samples, sizes[1])),
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
    """Frames pass of which nothing is shown."""
    global _paused
    _paused = True
    try:
        yield
    finally:
        _paused = False


def show_all(
    oceans, scene, depsgraph=None, *, rendering: bool = False, passing: bool = False
) -> None:
    """passing: a frame has come. Where nothing plays, it may be one of a render of the viewport,
    which waits for its foam."""
    if _paused:
        return
    playing = drafts.is_playing()
    moving = drafts.allowed and not rendering and (playing or not passing)
    moment = Moment(scene, rendering, moving)
    for ob in oceans:
        show(ob, depsgraph, moment)
    for follower in followers:
        follower(depsgraph, moment)


def follow(depsgraph, scene) -> None:
    """What rides the seas of a scene is put where it belongs."""
    for follower in followers:
        follower(depsgraph, Moment(scene, rendering=False, moving=drafts.allowed))


def parameters_changed(ob) -> None:
    """After a property was set from the user interface or a script."""
    if not node_group.modifiers(ob):
        return
    ob.update_tag()  # else what is evaluated goes on having the values of before
    if baked.follow(ob):
        sea_of(ob).shown.clear()
    moment = Moment(bpy.context.scene, rendering=False, moving=drafts.allowed)
    show(ob, None, moment)
    for follower in followers:
        follower(None, moment)
    # Behind a draft it follows when values rest; a new one is not to be without a mesh so long.
    if drafts.progress(ob.name_full) is None or meshes.is_empty(ob):
        follow_mesh(ob)


def follow_mesh(ob) -> None:
    """Makes a mesh that is ours fit the sea. Linked ones are as their files have them, but for
    those that have no mesh in there."""
    sea = sea_of(ob)
    is_local = ob.library is None and ob.data.library is None
    ours = ob.libocean.kind != "MESH" and (is_local or meshes.is_stand_in(ob))
    if not ours or ob.libocean.use_bake or sea.sea is None or ob.mode != "OBJECT":
        return
    settings, period = ob.libocean, float(sea.values.values["patch_size"])
    own = sea.sea.map_resolution()
    if settings.kind == "PATCH":
        meshes.follow_patch(ob, period, settings.mesh_resolution or meshes.automatic(own))
    else:
        samples = samples_of(settings, own)
        meshes.follow_horizon(
            ob, period / samples, settings.horizon_vertices, settings.horizon_distance
        )


# The whole sea after a draft --------------------------------------------------


def _named(name: str):
    return next((ob for ob in ocean_objects() if ob.name_full == name), None)


def _job(name: str) -> drafts.Job | None:
    ob = _named(name)
    sea = None if ob is None or ob.libocean.use_bake else sea_of(ob)
    if sea is None or sea.sea is None or ob.libocean.problem:
        return None
    settings = ob.libocean
    at = Moment(bpy.context.scene, rendering=False).time(settings, sea)
    spray = spray_settings(settings) if settings.use_spray else None
    return sea.job(at, _sizes(settings, sea)[0], _channel(settings), spray)


def _finish(name: str, job: drafts.Job) -> None:
    ob = _named(name)
    if ob is None:
        job.sea.close()
        return
    sea = sea_of(ob)
    if sea.take_over(job):
        follow_mesh(ob)
        show_all([ob], bpy.context.scene)
    elif isinstance(job.failure, (libocean.Error, MemoryError)):
        ob.libocean.problem = messages.of_error(job.failure, len(sea.values.waves))


drafts.make_job, drafts.finish = _job, _finish


def float_pose(ob, body: tuple[float, ...], moment: Moment):
    """libocean.FloatPose of one body on the sea of an object; None where there is none."""
    sea = sea_of(ob)
    if ob.libocean.use_bake:  # nobody else asks the library then
        with contextlib.suppress(libocean.Error):
            sea.follow(current_values(ob.libocean, moment.scene))
    if sea.sea is None:
        return None
    return sea.for_points().float_pose([body], moment.time(ob.libocean, sea))


def samples_of(settings, own: int) -> int:
    """Cells of the finest ring of a horizon in a period. own: the sea's map resolution."""
    return max(own, settings.viewport_resolution, settings.render_resolution)


def map_resolution(ob) -> int | None:
    """Samples a side that the sea of an object has by itself; None where there is no sea."""
    sea = sea_of(ob).sea
    return None if sea is None else sea.map_resolution()


def map_sizes(ob) -> tuple[int, int] | None:
    """Samples a side of the maps in the viewport and in renders."""
    sea = sea_of(ob)
    return None if sea.sea is None else _sizes(ob.libocean, sea)


def image_bytes(ob) -> int:
    """Of the images that hold the maps, in the viewport and in renders where those are others."""
    settings, sizes = ob.libocean, set(map_sizes(ob))
    fields = 1 + settings.use_velocity + settings.use_normal
    if settings.kind == "HORIZON":
        samples = sum(size * size + math.prod(atlas.shape(size)) for size in sizes)
    else:
        samples = sum(size * size for size in sizes)
    return 16 * fields * samples


def cascade_divisors(ob) -> list[int]:
    """By what the period is divided for each cascade of the sea that is shown."""
    sea = sea_of(ob).sea
    if sea is None:
        return [1]
    period = float(sea.get("patch_size"))
    return [round(period / of_cascade) for of_cascade in sea.cascade_periods]


def peak_wavelength(ob) -> float | None:
    """Metres, in deep water; None where there are no waves."""
    sea = sea_of(ob)
    period = None if sea.sea is None else _state(ob, sea)["peak_period"]["resolved"]
    if not period:
        return None
    return float(sea.values.values["gravity"]) * period**2 / (2.0 * math.pi)


def share_within_limits(ob) -> float | None:
    """How much of the wave height the limits of the wavelength leave; None without limits."""
    sea = sea_of(ob)
    if sea.sea is None or not sea.has_limits() or drafts.progress(ob.name_full) is not None:
        return None
    return sea.share_within_limits()


def _state(ob, sea: OpenSea) -> dict:
    """While a draft is shown, what was known before it: a slider is not to wait for this."""
    if sea.state is None and sea.state_before is not None and drafts.progress(ob.name_full) == 0.0:
        return sea.state_before
    return sea.read_state()


def sea_state(ob) -> dict | None:
    """Of the sea of an object, as `ocean info` has it; None where there is no sea."""
    sea = sea_of(ob)
    return None if sea.sea is None else _state(ob, sea)


def state_of(ob) -> list[tuple[str, str]] | None:
    """What the sea of an object is, for reading: labels and texts."""
    sea = sea_of(ob)
    if sea.sea is None:
        return None
    state = _state(ob, sea)

    def metres(value: float) -> str:
        return f"{value:.2f} m"

    return [
        ("Wave height", metres(state["significant_wave_height"]["resolved"])),
        ("Peak period", f"{state['peak_period']['resolved']:.1f} s"),
        ("Energy resolved", f"{state['energy_resolved']:.1%}"),
        ("Shortest wave", metres(state["map_shortest_wave"])),
    ]


def warnings_of(ob) -> list[str]:
    """What of it people should know."""
    sea = sea_of(ob)
    if sea.sea is None:
        return []
    systems = len(sea.values.waves)
    return [messages.in_words(text, systems) for text in _state(ob, sea)["warnings"]]
