# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Seas that are kept open, one for each object, and the filling of the images that show them.

    parameters (evaluated: keyframes and drivers count) + time -> libocean -> float images -> nodes

Blender's data is never held from call to call: objects are found anew, by the node groups that they
use, and seas by the names of their objects. Objects that play a bake are left alone.
"""

from __future__ import annotations

import contextlib
import dataclasses
import threading
from collections.abc import Callable, Iterator

import bpy
import numpy as np
from bpy.app.handlers import persistent

from . import atlas, baked, compat, images, meshes, node_group, properties, sea_text
from .native import libocean

CHANNELS = atlas.FINEST

# Of a sea at rest.
BLANKS = {
    "Displacement": (0.0, 0.0, 0.0, 0.0),
    "Velocity": (0.0, 0.0, 0.0, 0.0),
    "Normal": (0.0, 0.0, 1.0, 0.0),
}


# One open sea -----------------------------------------------------------------


class OpenSea:
    """The library's sea of one object, its buffers, and what was shown last."""

    def __init__(self) -> None:
        self.lock = threading.Lock()  # renders run in a thread of their own
        self.sea = None
        self.values: sea_text.SeaValues | None = None
        self.changes = 0
        self.state: dict | None = None  # read_state()
        self.point_sea = None
        self.point_changes = 0
        self.buffers: dict[tuple[str, int], np.ndarray] = {}
        self.shown: dict[str, tuple] = {}  # by image: what it holds

    def follow(self, values: sea_text.SeaValues) -> None:
        """Makes it the sea of these values. Raises libocean.Error and stays what it was."""
        if values == self.values:
            return
        if self.sea is None or values.structure() != self.values.structure():
            self._open(values)
        else:
            before = self.values.by_name()
            try:
                for name, text in values.by_name().items():
                    if before[name] != text:
                        self.sea.set(name, text)
            except libocean.Error:
                # One after the other is not always allowed where all together are.
                self._open(values)
        self.values = values
        self.state = None
        self.changes += 1

    def _open(self, values: sea_text.SeaValues) -> None:
        text = sea_text.write(properties.TABLE, values)
        opened = libocean.parse(text, base_dir=bpy.path.abspath("//") or None)
        if self.sea is not None:
            self.sea.close()
        self.sea = opened

    def for_points(self):
        """The same sea in another handle: maps and points at the same time would each undo what
        the library keeps for the other."""
        if self.point_sea is None or self.point_changes != self.changes:
            if self.point_sea is not None:
                self.point_sea.close()
            self.point_sea = libocean.parse(self.sea.text)
            self.point_changes = self.changes
        return self.point_sea

    def buffer(self, name: str, size: int) -> np.ndarray:
        """What goes into an image for maps of size x size samples."""
        if (name, size) not in self.buffers:
            # Of one size for the viewport and one for renders.
            kept = {s for _, s in self.buffers} - {size}
            if len(kept) > 1:
                self.buffers.clear()
            shape = (size, size) if name in CHANNELS else atlas.shape(size)
            self.buffers[name, size] = images.aligned(shape)
        return self.buffers[name, size]

    def read_state(self) -> dict:
        if self.state is None:
            self.state = self.sea.state
        return self.state

    def show(self, time: float, size: int, targets: dict[str, bpy.types.Image]) -> None:
        """Fills these images, by the inputs of the node group, with the maps of `time`."""
        with self.lock:
            self._show(time, size, targets)

    def _show(self, time: float, size: int, targets: dict[str, bpy.types.Image]) -> None:
        for image in targets.values():
            if images.let_go(image):
                self.shown.pop(image.name_full, None)
        state = (self.changes, time, size)
        stale = {
            name: image
            for name, image in targets.items()
            if self.shown.get(image.name_full) != state
        }
        if not stale:
            return
        far = [field for field in CHANNELS if node_group.far_image(field) in stale]
        fields = [field for field in CHANNELS if field in stale or field in far]
        self.sea.fill(time, [(self.buffer(field, size), CHANNELS[field]) for field in fields])
        if far:
            if "Normal" in far:
                self.buffer("Normal", size)[..., 3] = atlas.lost_slopes(self.read_state(), size)
            finest = {field: self.buffer(field, size) for field in far}
            atlases = {field: self.buffer(node_group.far_image(field), size) for field in far}
            atlas.fill(self.sea, time, size, finest, atlases, self.read_state())
        for name, image in stale.items():
            pixels = self.buffer(name, size)
            images.resize(image, pixels.shape[:2])
            images.fill(image, pixels)
            self.shown[image.name_full] = state

    def close(self) -> None:
        for handle in (self.sea, self.point_sea):
            if handle is not None:
                handle.close()


_seas: dict[str, OpenSea] = {}

followers: list[Callable[[object, Moment], None]] = []
"""Called with the depsgraph, or None, and the moment after the seas of a scene were shown."""


def sea_of(ob) -> OpenSea:
    return _seas.setdefault(ob.name_full, OpenSea())


def forget(names: set[str]) -> None:
    """After undo and loading: what images hold is not known any more, and of the seas there are
    those of the objects with these names."""
    for name in list(_seas):
        if name in names:
            _seas[name].shown.clear()
        else:
            _seas.pop(name).close()


# Objects ----------------------------------------------------------------------


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
    values = properties.values_of(settings)
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


# Handlers ---------------------------------------------------------------------

_locked_by_us: set[str] = set()  # scenes


def _own_images(oceans: list[bpy.types.Object]) -> None:
    """A copy of an object shows images of its own."""
    owners: dict[str, str] = {}
    for ob in oceans:
        for modifier in node_group.live_modifiers(ob):
            for name in node_group.image_inputs(modifier.node_group):
                image = node_group.value(modifier, name)
                if image is None:
                    continue
                if owners.setdefault(image.name_full, ob.name_full) != ob.name_full:
                    node_group.assign(modifier, {name: None})


@persistent
def _frame_changed(scene, depsgraph=None) -> None:
    rendering = depsgraph is not None and depsgraph.mode == "RENDER"
    show_all(ocean_objects(), scene, depsgraph, rendering=rendering)


@persistent
def _depsgraph_updated(scene, depsgraph) -> None:
    if depsgraph.mode == "RENDER":
        return
    if any(isinstance(update.id, bpy.types.Object) for update in depsgraph.updates):
        oceans = ocean_objects()
        _own_images(oceans)
        show_all(oceans, scene, depsgraph)


@persistent
def _data_replaced(*_) -> None:
    oceans = ocean_objects()
    forget({ob.name_full for ob in oceans})
    show_all(oceans, bpy.context.scene)


@persistent
def _lock_interface(scene, *_) -> None:
    """Blender may not draw what a render in another thread rewrites."""
    if ocean_objects() and not scene.render.use_lock_interface:
        scene.render.use_lock_interface = True
        _locked_by_us.add(scene.name_full)


@persistent
def _unlock_interface(scene, *_) -> None:
    if scene.name_full in _locked_by_us:
        _locked_by_us.remove(scene.name_full)
        scene.render.use_lock_interface = False


_HANDLERS = {
    "frame_change_post": _frame_changed,
    "depsgraph_update_post": _depsgraph_updated,
    "load_post": _data_replaced,
    "undo_post": _data_replaced,
    "redo_post": _data_replaced,
    "render_init": _lock_interface,
    "render_complete": _unlock_interface,
    "render_cancel": _unlock_interface,
}


def _remove_handlers() -> None:
    for name, handler in _HANDLERS.items():
        handlers = getattr(bpy.app.handlers, name)
        if handler in handlers:
            handlers.remove(handler)


def register() -> None:
    for name, handler in _HANDLERS.items():
        getattr(bpy.app.handlers, name).append(handler)
    properties.listener = parameters_changed
    compat.remove_handlers_at_exit(_remove_handlers)


def unregister() -> None:
    _remove_handlers()
    properties.listener = None
    for sea in _seas.values():
        sea.close()
    _seas.clear()
