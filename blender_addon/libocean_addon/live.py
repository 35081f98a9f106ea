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
from collections.abc import Callable, Iterator

import bpy

from . import atlas, baked, images, meshes, node_group, parameter_values, sea_text
from .native import libocean
from .open_sea import OpenSea, sea_of

# Of a sea at rest.
BLANKS = {
    "Displacement": (0.0, 0.0, 0.0, 0.0),
    "Velocity": (0.0, 0.0, 0.0, 0.0),
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
    return sorted(found, key=lambda ob: (ob.library is None, ob.name_full))


@dataclasses.dataclass(frozen=True)
class Moment:
    """When, and for whom."""

    scene: bpy.types.Scene
    rendering: bool

    def time(self, settings, values: sea_text.SeaValues) -> float:
        """Seconds of the sea at the scene's frame, which may be between two."""
        return time_at(self.scene.frame_current_final, settings, values)


def time_at(frame: float, settings, values: sea_text.SeaValues) -> float:
    """Seconds of the sea at a frame of the scene."""
    if settings.use_custom_time:
        return settings.custom_time
    frames = frame - float(values.values["first_frame"])
    return float(values.values["start"]) + frames / float(values.values["fps"])


def frame_rate(scene) -> float:
    return scene.render.fps / scene.render.fps_base


def current_values(settings, scene) -> sea_text.SeaValues:
    values = parameter_values.values_of(settings)
    if settings.use_scene_frame_rate:
        rate = frame_rate(scene)
        values.values["fps"] = repr(rate)
    return values


def _targets(ob, modifier, size: int, *, render: bool, shared: bool) -> dict:
    """The images of the fields in use, made where they are missing. shared: those of the viewport
    serve renders too."""
    settings = ob.libocean
    wanted = {
        "Displacement": True,
        "Velocity": settings.use_velocity,
        "Normal": settings.use_normal,
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


def show(ob, depsgraph, moment: Moment) -> None:
    """Brings what an object shows up to date."""
    if ob.libocean.kind == "HORIZON":
        for modifier in node_group.modifiers(ob):
            node_group.assign(modifier, {"Camera": moment.scene.camera})
    modifiers = node_group.live_modifiers(ob)
    if not modifiers:
        return
    seen = ob.evaluated_get(depsgraph) if depsgraph else ob
    settings = seen.libocean
    values = current_values(settings, moment.scene)
    sea = sea_of(ob)
    problem = ""
    try:
        sea.follow(values)
        own = sea.sea.map_resolution()
        sizes = (settings.viewport_resolution or own, settings.render_resolution or own)
        shared = sizes[0] == sizes[1]
        size = sizes[1] if moment.rendering else sizes[0]
        time = moment.time(settings, values)
        for modifier in modifiers:
            targets = _targets(ob, modifier, size, render=moment.rendering, shared=shared)
            _set_inputs(ob, seen, modifier, values, sizes)
            if settings.kind == "HORIZON":
                node_group.assign(modifier, {"Samples": float(samples_of(settings, own))})
            sea.show(time, size, targets)
    except libocean.Error as failure:
        problem = str(failure)
    if ob.libocean.problem != problem:
        ob.libocean.problem = problem


def _set_inputs(ob, seen, modifier, values: sea_text.SeaValues, sizes: tuple[int, int]) -> None:
    settings = ob.libocean
    period = float(values.values["patch_size"])
    # Only the place within a period counts, and in single precision it counts most near 0.
    place = seen.matrix_world.translation if settings.follow_world else (0.0, 0.0)
    origin = (place[0] % period, place[1] % period, 0.0)
    state = sea_of(ob).read_state()
    node_group.assign(
        modifier,
        {
            "Tile Size": period,
            "Half Texel": 0.5 / sizes[0],
            node_group.render_twin("Half Texel"): 0.5 / sizes[1],
            "Slope Variance": atlas.lost_slopes(state, sizes[0]),
            node_group.render_twin("Slope Variance"): atlas.lost_slopes(state, sizes[1]),
            "Origin": origin,
            "Mask": settings.mask,
            "Use Mask": bool(settings.mask),
            "Use Foam": settings.use_foam,
            "Use Velocity": settings.use_velocity,
            "Use Normal": settings.use_normal,
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


def show_all(oceans, scene, depsgraph=None, *, rendering: bool = False) -> None:
    if _paused:
        return
    moment = Moment(scene, rendering)
    for ob in oceans:
        show(ob, depsgraph, moment)
    for follower in followers:
        follower(depsgraph, moment)


def parameters_changed(ob) -> None:
    """After a property was set from the user interface or a script."""
    if not node_group.modifiers(ob):
        return
    if baked.follow(ob):
        sea_of(ob).shown.clear()
    moment = Moment(bpy.context.scene, rendering=False)
    show(ob, None, moment)
    for follower in followers:
        follower(None, moment)
    if ob.libocean.use_bake:
        return
    sea = sea_of(ob)
    ours = ob.libocean.kind != "MESH" and ob.data.library is None
    if ours and sea.sea is not None and ob.mode == "OBJECT":
        _follow(ob, sea)


def _follow(ob, sea: OpenSea) -> None:
    """Makes the mesh that is ours fit the sea."""
    settings, period = ob.libocean, float(sea.values.values["patch_size"])
    own = sea.sea.map_resolution()
    if settings.kind == "PATCH":
        meshes.follow_patch(ob, period, own)
    else:
        samples = samples_of(settings, own)
        meshes.follow_horizon(
            ob, period / samples, settings.horizon_vertices, settings.horizon_distance
        )


def float_pose(ob, body: tuple[float, ...], moment: Moment):
    """libocean.FloatPose of one body on the sea of an object; None where there is none."""
    sea = sea_of(ob)
    if ob.libocean.use_bake:  # nobody else asks the library then
        with contextlib.suppress(libocean.Error):
            sea.follow(current_values(ob.libocean, moment.scene))
    if sea.sea is None:
        return None
    return sea.for_points().float_pose([body], moment.time(ob.libocean, sea.values))


def samples_of(settings, own: int) -> int:
    """Cells of the finest ring of a horizon in a period. own: the sea's map resolution."""
    return max(own, settings.viewport_resolution, settings.render_resolution)


def map_resolution(ob) -> int | None:
    """Samples a side that the sea of an object has by itself; None where there is no sea."""
    sea = sea_of(ob).sea
    return None if sea is None else sea.map_resolution()


def state_of(ob) -> list[tuple[str, str]] | None:
    """What the sea of an object is, for reading: labels and texts."""
    sea = sea_of(ob)
    if sea.sea is None:
        return None
    state = sea.read_state()

    def metres(value: float) -> str:
        return f"{value:.2f} m"

    return [
        ("Significant wave height", metres(state["significant_wave_height"]["resolved"])),
        ("Peak period", f"{state['peak_period']['resolved']:.1f} s"),
        ("Energy resolved", f"{state['energy_resolved']:.1%}"),
        ("Shortest wave", metres(state["map_shortest_wave"])),
    ]


def warnings_of(ob) -> list[str]:
    """What of it people should know."""
    sea = sea_of(ob)
    return sea.read_state()["warnings"] if sea.sea is not None else []
