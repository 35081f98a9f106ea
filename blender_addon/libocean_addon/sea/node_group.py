# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The node group of the sea's modifier: it reads finished fields from images, nothing else, by the
parts in field_nodes.py.

Each image is read once: a field is evaluated anew by every node that uses it, a captured one is
not. A live group reads images that the add-on fills; a baked one plays image sequences by the
scene's time, without the add-on (baked_nodes.py). A mesh lies where it lies; the rings of a horizon
follow the camera, and read coarser maps too (ring_nodes.py).
"""

from __future__ import annotations

from ..bake import baked_nodes
from ..bake.baked_nodes import (
    COVER_POWER,
    COVER_POWER_HELP,
    LOST_SLOPES,
    ON_SAMPLES,
    ON_SAMPLES_HELP,
)
from ..shared import compat, field_nodes, modifier_groups
from ..shared.field_nodes import Turn
from ..shared.node_builder import Builder
from . import hull_nodes, ring_nodes, wake_nodes
from .ring_nodes import far_image

VERSION = 9
MARK = "libocean"  # custom property of a group: the version that built it
_KIND = "libocean_kind"

FIELDS = ("Displacement", "Velocity", "Normal")
"""The maps; each image has a twin for renders. The alpha of the first map is the cover of foam,
whose mean is seen from far away; the alpha of the second map is the Jacobian of the displacement;
the alpha of a horizon's third map is the variance of the slopes that are left out."""


WORLD_ORIGIN = "World Origin"
WORLD_ORIGIN_HELP = "Origin, whole periods included: where the places of foam begin"


def render_twin(name: str) -> str:
    return f"{name} Render"


def _declare(group, kind: str) -> None:
    """The sockets of a live group."""
    socket = compat.add_socket
    socket(group, "Geometry", "NodeSocketGeometry")
    for name in FIELDS:
        for image in (name, far_image(name)) if kind == "HORIZON" else (name,):
            socket(group, image, "NodeSocketImage")
            socket(group, render_twin(image), "NodeSocketImage")
    if kind == "HORIZON":
        ring_nodes.declare(group)
    socket(group, "Tile Size", "NodeSocketFloat", default_value=100.0, min_value=1e-3)
    socket(group, "Half Texel", "NodeSocketFloat")
    socket(group, render_twin("Half Texel"), "NodeSocketFloat")
    socket(group, "Slope Variance", "NodeSocketFloat", description=LOST_SLOPES)
    socket(group, render_twin("Slope Variance"), "NodeSocketFloat", description=LOST_SLOPES)
    for name in (COVER_POWER, render_twin(COVER_POWER)):
        socket(group, name, "NodeSocketFloat", default_value=1.0, description=COVER_POWER_HELP)
    socket(group, "Origin", "NodeSocketVector")
    socket(group, WORLD_ORIGIN, "NodeSocketVector", description=WORLD_ORIGIN_HELP)
    socket(
        group, "Turn", "NodeSocketVector", description="Of the object in the world, as Euler XYZ"
    )
    socket(group, ON_SAMPLES, "NodeSocketBool", description=ON_SAMPLES_HELP)
    socket(group, "Mask", "NodeSocketString")
    for name in ("Use Mask", "Use Foam", "Use Velocity", "Use Normal"):
        socket(group, name, "NodeSocketBool")
    wake_nodes.declare(group)
    hull_nodes.declare(group)
    socket(group, "Geometry", "NodeSocketGeometry", output=True)


class _LiveFields:
    """Reads the fields from images that the add-on fills, with separate images for renders."""

    def __init__(self, builder: Builder, inputs) -> None:
        self.b, self.inputs = builder, inputs
        self.viewport = builder.node("GeometryNodeIsViewport").outputs[0]

    def shown(self, name: str, kind: str):
        """An input or its twin for renders."""
        twin = self.inputs[render_twin(name)]
        return self.b.switch(kind, self.viewport, twin, self.inputs[name])

    def origin(self):
        return self.inputs["Origin"]

    def world_origin(self):
        return self.inputs[WORLD_ORIGIN]

    def turn(self):
        return self.inputs["Turn"]

    def half_texel(self):
        return self.shown("Half Texel", "FLOAT")

    def color(self, field: str, place, interpolation: str):
        return self.b.texture(self.shown(field, "IMAGE"), place, interpolation)

    def far(self, field: str, place):
        return self.color(far_image(field), place, "Linear")

    def has_alpha(self, _field: str) -> bool:
        return True

    def cover_power(self):
        return self.shown(COVER_POWER, "FLOAT")

    def cover(self, displacement, _lookup):
        return self.b.alpha(displacement)

    def jacobian(self, velocity, _lookup):
        return self.b.alpha(velocity)

    def lost_slopes(self):
        return self.shown("Slope Variance", "FLOAT")

    def wakes(self, turn: Turn, interpolation: str):
        return wake_nodes.Wakes(self.b, self.inputs, turn, interpolation)

    def hulls(self, geometry):
        return hull_nodes.marked(self.b, self.inputs, geometry)


class _Flat:
    """A mesh that shows the finest map wherever it lies."""

    def __init__(self, b: Builder, inputs, fields, turn: Turn, interpolation: str) -> None:
        self.fields = fields
        self.interpolation = interpolation
        self.place = field_nodes.place_on_map(
            b,
            turn,
            origin=fields.origin(),
            period=inputs["Tile Size"],
            half_texel=fields.half_texel(),
        )

    def start(self, geometry):
        return geometry

    def color(self, field: str):
        return self.fields.color(field, self.place, self.interpolation)

    def normal(self, geometry):
        """Geometry, normal, and the variance of the slopes that the map leaves out."""
        return geometry, self.color("Normal"), self.fields.lost_slopes()


def _label(b: Builder, fields, turn: Turn):
    """Returns the undisplaced coordinate in the world [m], the same in every frame and for all
    meshes of a sea. z = 1 tells it from an absent attribute and from the mesh's own label, whose z
    is 0."""
    position = turn.to_world(b.node("GeometryNodeInputPosition").outputs[0])
    begins = b.math("ADD", fields.world_origin(), (0.0, 0.0, 1.0))
    return b.math("MULTIPLY_ADD", position, (1.0, 1.0, 0.0), begins)


def _displaced(b: Builder, inputs, fields, lookup, turn: Turn, interpolation: str):
    """The geometry with its attributes, moved."""
    group = b.group
    mask = field_nodes.mask(b, inputs)
    wakes = fields.wakes(turn, interpolation)

    geometry, offset = compat.capture(
        group, lookup.start(inputs["Geometry"]), lookup.color("Displacement")
    )
    cover = fields.cover(offset, lookup)
    stored = b.store(geometry, "cover", "FLOAT", b.number("MULTIPLY", cover, mask))
    foam = b.number("POWER", cover, b.number("DIVIDE", 1.0, fields.cover_power()))
    stored = b.store(stored, "foam", "FLOAT", b.number("MULTIPLY", foam, mask))
    stored = b.store(stored, "label", "FLOAT_VECTOR", _label(b, fields, turn))
    geometry = b.switch("GEOMETRY", inputs["Use Foam"], geometry, stored)

    stored, velocity = compat.capture(group, geometry, lookup.color("Velocity"))
    squeezed = b.number("SUBTRACT", fields.jacobian(velocity, lookup), 1.0)

    def with_velocity(stored, wake=None, squeezed_more=0.0):
        moving, all_squeezed = velocity, squeezed
        if wake is not None:
            moving = b.math("ADD", velocity, wake)
            all_squeezed = b.number("ADD", squeezed, squeezed_more)
        jacobian = b.number("MULTIPLY_ADD", all_squeezed, mask, 1.0)
        stored = b.store(stored, "jacobian", "FLOAT", jacobian)
        moving = turn.to_local(b.scale(moving, mask))
        # Cycles takes `velocity` for motion blur and shows shaders zeros in its place.
        stored = b.store(stored, "velocity", "FLOAT_VECTOR", moving)
        if wake is None:
            return b.store(stored, "ocean_velocity", "FLOAT_VECTOR", moving)
        moving = field_nodes.attribute(b, "velocity")
        stored = b.store(stored, "ocean_velocity", "FLOAT_VECTOR", moving)
        return wake_nodes.broken(b, inputs, stored)

    stored = wakes.added(stored, "Velocity", with_velocity)
    geometry = b.switch("GEOMETRY", inputs["Use Velocity"], geometry, stored)

    stored, normal, slope_variance = lookup.normal(geometry)
    normal = field_nodes.toward_up(b, normal, mask)

    def with_normal(stored, wake=None, _alpha=None):
        tilted = normal
        if wake is not None:
            tilted = field_nodes.tilted(b, normal, b.scale(wake, mask))
        return b.store(stored, "ocean_normal", "FLOAT_VECTOR", turn.to_local(tilted))

    def with_trail():
        trailed, both = compat.capture(group, geometry, lookup.color("Normal"))
        trail = b.number("MULTIPLY", b.alpha(both), 1.0, clamp=True)
        trailed = b.store(trailed, "trail", "FLOAT", trail)
        return b.store(trailed, "ocean_normal", "FLOAT_VECTOR", both)

    stored = wakes.in_maps(wakes.added(stored, "Normal", with_normal), with_trail)
    slope_variance = b.number("MULTIPLY", slope_variance, mask)
    stored = b.store(stored, "slope_variance", "FLOAT", slope_variance)
    geometry = b.switch("GEOMETRY", inputs["Use Normal"], geometry, stored)

    def displaced(geometry, wake=None, trail=None):
        if wake is not None:
            shown = b.number("MULTIPLY", trail, mask, clamp=True)
            geometry = b.store(geometry, "trail", "FLOAT", shown)
        moved = b.node("GeometryNodeSetPosition")
        b.link(geometry, moved.inputs["Geometry"])
        whole = offset if wake is None else b.math("ADD", offset, wake)
        b.link(turn.to_local(b.scale(whole, mask)), moved.inputs["Offset"])
        return moved.outputs["Geometry"]

    return wakes.added(geometry, "Displacement", displaced)


def _build(group, kind: str, *, baked: bool) -> None:
    declare, make_fields = _declare, _LiveFields
    if baked:
        declare, make_fields = baked_nodes.declare, baked_nodes.BakedFields
    declare(group, kind)
    compat.hide_inputs(group)
    b = Builder(group)
    inputs = b.node("NodeGroupInput").outputs
    fields = make_fields(b, inputs)

    def displaced(b: Builder, inputs, turned: bool, interpolation: str):
        fields = make_fields(b, inputs)
        turn = Turn(b, fields.turn() if turned else None)
        if kind == "HORIZON":
            lookup = ring_nodes.Rings(b, inputs, fields, turn)
        else:
            lookup = _Flat(b, inputs, fields, turn, interpolation)
        return _displaced(b, inputs, fields, lookup, turn, interpolation)

    result = field_nodes.branches(
        b,
        inputs,
        displaced,
        name=group.name.removeprefix(".libocean."),
        # The vertices of a patch take the nearest sample.
        on_samples=inputs[ON_SAMPLES] if kind == "PATCH" else None,
        euler=fields.turn(),
    )
    b.link(fields.hulls(result), b.node("NodeGroupOutput").inputs[0])
    b.arrange(rows=4, height=240)


FAMILY = modifier_groups.Family(MARK, VERSION)
is_ours = FAMILY.is_ours
is_old = FAMILY.is_old
all_modifiers = FAMILY.all_modifiers
modifiers = FAMILY.modifiers
in_scene = FAMILY.in_scene


def kind_of(group) -> str:
    return group[_KIND]


def get(kind: str, *, baked: bool = False):
    """Returns the group for meshes of one kind, made if it is missing. baked: one that plays a
    bake."""
    name = f".libocean.v{VERSION} {kind.capitalize()}{' Baked' if baked else ''}"

    def build(group) -> None:
        group[_KIND] = kind
        _build(group, kind, baked=baked)

    return FAMILY.get(name, build, baked=baked)


def image_inputs(group) -> list[str]:
    """Returns the names of the inputs of images."""
    fields = [*FIELDS, *baked_nodes.FIELDS]
    names = {name for field in fields for name in (field, far_image(field))}
    names |= {render_twin(name) for name in names}
    names |= {*wake_nodes.image_inputs(), *hull_nodes.outline_inputs()}
    return [name for name in compat.input_identifiers(group) if name in names]
