# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How an object shows a sea: images and inputs of its modifiers, and its mesh.

    parameters (evaluated: keyframes and drivers count) + time -> libocean -> float images -> nodes

shared/life.py calls it by the row in subject.py.
"""

from __future__ import annotations

import contextlib
import math

from ..bake import baked
from ..bake.baked_nodes import COVER_POWER
from ..look import detail, sun_focus
from ..shared import console, field_nodes, images, meshes, modifier_groups
from ..shared.compat import tr_label
from ..shared.native import libocean
from ..shared.subject import Moment, Picture, Shown
from . import atlas, horizon_mesh, hull_cut, node_group, parameter_values, sea_text, wakes
from .open_sea import COVER, NO_COVER, QUICK, OpenSea, sea_of
from .sea_job import SeaJob

# The values of a sea at rest.
BLANKS = {
    "Displacement": (0.0, 0.0, 0.0, 0.0),
    "Velocity": (0.0, 0.0, 0.0, 1.0),
    "Normal": (0.0, 0.0, 1.0, 0.0),
}


ocean_objects = node_group.FAMILY.objects


def time_of(moment: Moment, settings, sea: OpenSea) -> float:
    """Returns a sea's time at the scene's frame [s], which may lie between two frames."""
    time = own_time(settings)
    return sea.handle.time_of_frame(moment.scene.frame_current_final) if time is None else time


def own_time(settings) -> float | None:
    """Returns the custom time of the settings [s]; None if the frame's time counts."""
    return settings.custom_time if settings.use_custom_time else None


def frame_rate(scene) -> float:
    return scene.render.fps / scene.render.fps_base


def current_values(settings, scene) -> sea_text.SeaValues:
    rate = repr(frame_rate(scene)) if settings.use_scene_frame_rate else ""
    return parameter_values.values_of(settings, rate)


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


def place(shown: Shown, moment: Moment) -> None:
    """Has the rings of a horizon follow the camera of the scene."""
    if shown.ob.libocean.kind == "HORIZON":
        for modifier in shown.modifiers:
            modifier_groups.assign(modifier, {"Camera": moment.scene.camera})


def fault_of(ob) -> str:
    """Returns a sentence on a mesh that cannot show the sea; "" otherwise."""
    if ob.libocean.kind == "MESH" or meshes.is_made(ob.data):
        return ""
    return tr_label(
        "{} is a mesh of your own, which no patch or horizon replaces: kind MESH shows the sea "
        "on it",
        ob.data.name,
    )


def map_sizes(settings, sea: OpenSea) -> tuple[int, int]:
    """Returns the samples per side of the maps in the viewport and in renders."""
    own = sea.handle.map_resolution()
    return settings.viewport_resolution or own, settings.render_resolution or own


def spray_settings(settings) -> dict:
    """Returns the arguments of libocean.Sea.spray."""
    return {name: getattr(settings, f"spray_{name}") for name in ("lifetime", "density", "most")}


def channel_of(settings) -> str:
    return COVER if settings.use_foam else NO_COVER


class SeaPicture(Picture):
    """The maps of a sea at a time. While time plays only foam is behind in a draft; while values
    move, all of the sea."""

    def prepare(self) -> None:
        settings, sea, moment = self.seen.libocean, self.opened, self.moment
        self.settings = settings
        self.sizes = map_sizes(settings, sea)
        self.is_shared = self.sizes[0] == self.sizes[1]
        self.size = self.sizes[1] if moment.rendering else self.sizes[0]
        self.time, self.channel = time_of(moment, settings, sea), channel_of(settings)
        self.place, self.turn = (0.0, 0.0), (0.0, 0.0, 0.0)
        if settings.follow_world:
            world = self.seen.matrix_world
            self.place, self.turn = tuple(world.translation[:2]), tuple(world.to_euler("XYZ"))
        self.is_turned = math.hypot(*self.turn) > field_nodes.SMALLEST_TURN
        self.vertices = wakes.vertices_of(self)
        self.key = (sea.changes, self.time, self.size, self.channel)
        self.more_follows = settings.use_spray
        self.ends_draft = not moment.rendering

    def is_ready(self) -> bool:
        return self.opened.is_ready(self.time, self.size, self.channel)

    def show_draft(self) -> None:
        sea, size = self.opened, self.size
        known = sea.ready is not None and sea.ready[:2] == (sea.changes, size)
        drawn = size if known else min(size, sea.pace.size)
        targets = _targets(
            self.ob, self.modifier, drawn, render=False, shared=self.is_shared, draft=True
        )
        sea.show_draft(self.time, drawn, size, targets, self.channel)

    def show_whole(self) -> None:
        vertices = self.vertices
        side = self.size if vertices is None else vertices.cells + 1
        targets = _targets(
            self.ob, self.modifier, side, render=self.moment.rendering, shared=self.is_shared
        )
        self.opened.show(self.time, self.size, targets, self.channel, vertices)

    def set_inputs(self, *, draft: bool) -> None:
        names = [COVER_POWER, node_group.render_twin(COVER_POWER)]
        if not self.is_shared:
            names = names[1:] if self.moment.rendering else names[:1]
        channel = QUICK[self.channel] if draft else self.channel
        power = self.opened.cover_power(self.time, self.size, channel)
        modifier_groups.assign(self.modifier, dict.fromkeys(names, power))
        _set_inputs(self, draft=draft)
        if not draft:
            with console.work(self.ob.name_full, "near detail"):
                detail.follow(self.ob, self.opened, self.settings, self.time, self.size)
            sun_focus.follow(self.shown, self.time)
            state = self.opened.read_state()
            lost = [atlas.lost_slopes(state, samples) for samples in self.sizes]
            names = ("Slope Variance", node_group.render_twin("Slope Variance"))
            modifier_groups.assign(self.modifier, dict(zip(names, lost, strict=True)))
        if self.settings.kind == "HORIZON":
            modifier_groups.assign(self.modifier, {"Samples": float(self.ring_samples())})

    def ring_samples(self) -> int:
        return samples_of(self.settings, self.opened.handle.map_resolution())


def _set_inputs(picture: SeaPicture, *, draft: bool) -> None:
    ob, modifier, sizes = picture.ob, picture.modifier, picture.sizes
    settings = ob.libocean
    period = float(picture.opened.values.values["patch_size"])
    x, y = picture.place
    # A draft in the viewport has fewer samples than are asked for.
    shown = modifier_groups.value(modifier, "Displacement")
    samples = shown.size[0] if shown is not None else sizes[0]
    on_samples = meshes.is_on_samples(ob.data, min(samples, sizes[1]))
    # Only the place within a period counts, and in single precision it counts most near 0.
    origin = (x % period, y % period, 0.0)
    if on_samples and settings.kind == "PATCH" and not picture.is_turned:
        # Half-way between two samples, nodes would take now the one, now the other.
        cell = period / max(samples, sizes[1])
        origin = tuple(math.floor(place / cell + 0.5) * cell for place in origin)
    modifier_groups.assign(
        modifier,
        {
            "Tile Size": period,
            "Half Texel": 0.5 / samples,
            node_group.render_twin("Half Texel"): 0.5 / sizes[1],
            "Origin": origin,
            node_group.WORLD_ORIGIN: (x, y, 0.0),
            "Turn": picture.turn,
            node_group.ON_SAMPLES: on_samples,
            "Mask": settings.mask,
            "Use Mask": bool(settings.mask),
            "Use Foam": settings.use_foam,
            "Use Velocity": settings.use_velocity and not draft,
            "Use Normal": settings.use_normal and not draft,
            **(picture.vertices.inputs() if picture.vertices and not draft else {}),
        },
    )
    wakes.follow(picture, draft=draft)
    hull_cut.follow(picture)


def before_change(shown: Shown) -> bool:
    """Follows a change between live and baked, and of the mesh's kind. Returns whether a modifier
    got another node group."""
    has_other = baked.follow(shown.ob, shown.modifiers)
    if has_other:
        shown.opened.shown.clear()
    return has_other


def follow_mesh(shown: Shown, *, draft: bool = False) -> None:
    """Makes a mesh of the add-on fit the sea, and labels a mesh of the user. A linked mesh stays as
    its file has it, unless it is a stand-in. draft: with few vertices, until the sea is whole."""
    ob, sea, settings = shown.ob, shown.opened, shown.ob.libocean
    is_local = ob.library is None and ob.data.library is None
    ours = is_local or meshes.is_stand_in(ob.data)
    if not ours or settings.use_bake or sea.handle is None or ob.mode != "OBJECT":
        return
    period, own = float(sea.values.values["patch_size"]), sea.handle.map_resolution()
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


def job(shown: Shown) -> SeaJob | None:
    """Returns the job that makes the whole of an object; None without a sea."""
    sea, settings = shown.opened, shown.ob.libocean
    if settings.use_bake or sea.handle is None:
        return None
    at = time_of(Moment.of_change(), settings, sea)
    size = map_sizes(settings, sea)[0]
    return sea.job(at, size, channel_of(settings), spray=settings.use_spray)


def float_pose(ob, body: tuple[float, ...], moment: Moment):
    """Returns the libocean.FloatPose of one body on the sea of an object; None without a sea."""
    sea = sea_of(ob.name_full)
    if ob.libocean.use_bake:  # it gets no parameters by being shown then
        with contextlib.suppress(libocean.Error):
            sea.follow(current_values(ob.libocean, moment.scene))
    if sea.handle is None:
        return None
    return sea.for_points().float_pose([body], time_of(moment, ob.libocean, sea))


def samples_of(settings, own: int) -> int:
    """Returns the cells of a horizon's finest ring in a period. own: the sea's map resolution."""
    return max(own, settings.viewport_resolution, settings.render_resolution)
