# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The node group of the modifier: it reads finished fields from images, nothing else.

    position + origin -> / tile size -> + half a texel -> image -> offset, attributes

Each image is read once: a field is evaluated anew by every node that uses it, a captured one is
not. A live group reads images that the add-on fills; a baked one plays image sequences by the
scene's time, without the add-on (baked_nodes.py). A mesh lies where it lies; the rings of a horizon
follow the camera, and read coarser maps too (ring_nodes.py).
"""

from __future__ import annotations

import bpy

from . import baked_nodes, compat, ring_nodes
from .baked_nodes import LOST_SLOPES
from .node_builder import Builder
from .ring_nodes import far_image

VERSION = 1
MARK = "libocean"  # custom property of a group: the version that built it
_KIND = "libocean_kind"
_BAKED = "libocean_baked"  # of one that plays a bake

FIELDS = ("Displacement", "Velocity", "Normal")
"""The maps; each image has a twin for renders. Foam is the alpha of the first, and of a horizon's
third one the variance of the slopes that are left out."""


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
    socket(group, "Origin", "NodeSocketVector")
    socket(group, "Mask", "NodeSocketString")
    for name in ("Use Mask", "Use Foam", "Use Velocity", "Use Normal"):
        socket(group, name, "NodeSocketBool")
    socket(group, "Geometry", "NodeSocketGeometry", output=True)


class _LiveFields:
    """The fields as images that the add-on fills, those for renders apart."""

    def __init__(self, builder: Builder, inputs) -> None:
        self.b, self.inputs = builder, inputs
        self.viewport = builder.node("GeometryNodeIsViewport").outputs[0]

    def shown(self, name: str, kind: str):
        """An input or its twin for renders."""
        twin = self.inputs[render_twin(name)]
        return self.b.switch(kind, self.viewport, twin, self.inputs[name])

    def origin(self):
        return self.inputs["Origin"]

    def half_texel(self):
        return self.shown("Half Texel", "FLOAT")

    def color(self, field: str, place, interpolation: str):
        return self.b.texture(self.shown(field, "IMAGE"), place, interpolation)

    def far(self, field: str, place):
        return self.color(far_image(field), place, "Linear")

    def foam(self, displacement, _lookup):
        return self.b.alpha(displacement)

    def lost_slopes(self):
        return self.shown("Slope Variance", "FLOAT")


class _Flat:
    """A mesh that shows the finest map wherever it lies."""

    def __init__(self, b: Builder, inputs, fields, kind: str) -> None:
        self.fields = fields
        # A patch's vertices lie on samples: they take the nearest one, to the bit.
        self.interpolation = "Closest" if kind == "PATCH" else "Linear"
        position = b.node("GeometryNodeInputPosition").outputs[0]
        place = b.math("DIVIDE", b.math("ADD", position, fields.origin()), inputs["Tile Size"])
        self.place = b.math("ADD", place, fields.half_texel())

    def start(self, geometry):
        return geometry

    def color(self, field: str):
        return self.fields.color(field, self.place, self.interpolation)

    def normal(self, geometry):
        """Geometry, normal, and the variance of the slopes that the map leaves out."""
        return geometry, self.color("Normal"), self.fields.lost_slopes()


def _build(group, kind: str, *, baked: bool) -> None:
    declare, make_fields = _declare, _LiveFields
    if baked:
        declare, make_fields = baked_nodes.declare, baked_nodes.BakedFields
    declare(group, kind)
    b = Builder(group)
    inputs = b.node("NodeGroupInput").outputs
    fields = make_fields(b, inputs)
    if kind == "HORIZON":
        lookup = ring_nodes.Rings(b, inputs, fields)
    else:
        lookup = _Flat(b, inputs, fields, kind)

    named = b.node("GeometryNodeInputNamedAttribute", data_type="FLOAT")
    b.link(inputs["Mask"], named.inputs["Name"])
    mask = b.switch("FLOAT", inputs["Use Mask"], 1.0, compat.active(named.outputs, "Attribute"))

    geometry, offset = compat.capture(
        group, lookup.start(inputs["Geometry"]), lookup.color("Displacement")
    )
    foam = b.number("MULTIPLY", fields.foam(offset, lookup), mask)
    stored = b.store(geometry, "foam", "FLOAT", foam)
    geometry = b.switch("GEOMETRY", inputs["Use Foam"], geometry, stored)

    stored, velocity = compat.capture(group, geometry, lookup.color("Velocity"))
    velocity = b.scale(velocity, mask)
    # Cycles takes `velocity` for motion blur and shows shaders zeros in its place.
    stored = b.store(stored, "velocity", "FLOAT_VECTOR", velocity)
    stored = b.store(stored, "ocean_velocity", "FLOAT_VECTOR", velocity)
    geometry = b.switch("GEOMETRY", inputs["Use Velocity"], geometry, stored)

    up = (0.0, 0.0, 1.0)
    stored, normal, slope_variance = lookup.normal(geometry)
    normal = b.math("ADD", b.scale(b.math("SUBTRACT", normal, up), mask), up)
    stored = b.store(stored, "ocean_normal", "FLOAT_VECTOR", normal)
    slope_variance = b.number("MULTIPLY", slope_variance, mask)
    stored = b.store(stored, "slope_variance", "FLOAT", slope_variance)
    geometry = b.switch("GEOMETRY", inputs["Use Normal"], geometry, stored)

    moved = b.node("GeometryNodeSetPosition")
    b.link(geometry, moved.inputs["Geometry"])
    b.link(b.scale(offset, mask), moved.inputs["Offset"])
    b.link(moved.outputs["Geometry"], b.node("NodeGroupOutput").inputs[0])
    for number, made in enumerate(group.nodes):
        made.location = (220 * (number // 4), -240 * (number % 4))


def is_ours(group) -> bool:
    return group is not None and MARK in group


def is_baked(group) -> bool:
    """Whether it plays a bake."""
    return is_ours(group) and _BAKED in group


def kind_of(group) -> str:
    return group[_KIND]


def get(kind: str, *, baked: bool = False):
    """The group for meshes of one kind: made when there is none. baked: one that plays a bake."""
    name = f".libocean.v{VERSION} {kind.capitalize()}{' Baked' if baked else ''}"
    for group in bpy.data.node_groups:
        if group.name == name and is_ours(group) and group.library is None:
            return group
    group = bpy.data.node_groups.new(name, "GeometryNodeTree")
    group[MARK] = VERSION
    group[_KIND] = kind
    if baked:
        group[_BAKED] = True
    if hasattr(group, "is_modifier"):  # 4.0
        group.is_modifier = True
    _build(group, kind, baked=baked)
    return group


def image_inputs(group) -> list[str]:
    """The names of the inputs that take images."""
    fields = [*FIELDS, *baked_nodes.FIELDS]
    names = {name for field in fields for name in (field, far_image(field))}
    names |= {render_twin(name) for name in names}
    return [name for name in compat.input_identifiers(group) if name in names]


def modifiers(ob) -> list:
    """The ocean modifiers of an object."""
    return [m for m in ob.modifiers if m.type == "NODES" and is_ours(m.node_group)]


def live_modifiers(ob) -> list:
    """Those that play no bake."""
    return [m for m in modifiers(ob) if not is_baked(m.node_group)]


def assign(modifier, values: dict) -> None:
    """Sets inputs of the modifier by their names."""
    identifiers = compat.input_identifiers(modifier.node_group)
    for name, value in values.items():
        compat.set_input(modifier, identifiers[name], value)


def value(modifier, name: str):
    return compat.get_input(modifier, compat.input_identifiers(modifier.node_group)[name])
