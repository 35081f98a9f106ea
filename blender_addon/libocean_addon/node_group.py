# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The node group of the modifier: it reads finished fields from float images, nothing else.

    position + origin -> / tile size -> + half a texel -> image -> offset, attributes

Each image is read once: a field is evaluated anew by every node that uses it, a captured one is
not.
"""

from __future__ import annotations

import bpy

from . import compat

VERSION = 1
MARK = "libocean"  # custom property of a group: the version that built it

FIELDS = ("Displacement", "Velocity", "Normal")
"""The images; each has a twin for renders. Foam is the alpha of the first."""


def render_twin(name: str) -> str:
    return f"{name} Render"


class _Builder:
    """Short words for what a node group is made of."""

    def __init__(self, group) -> None:
        self.group = group

    def node(self, kind: str, **settings):
        made = self.group.nodes.new(kind)
        for key, value in settings.items():
            setattr(made, key, value)
        return made

    def link(self, output, socket) -> None:
        self.group.links.new(output, socket)

    def math(self, operation: str, *operands):
        """Vector math; an operand is an output or a value."""
        made = self.node("ShaderNodeVectorMath", operation=operation)
        for socket, operand in zip(made.inputs, operands, strict=False):
            self.feed(operand, socket)
        return made.outputs["Vector"]

    def scale(self, vector, factor):
        made = self.node("ShaderNodeVectorMath", operation="SCALE")
        self.feed(vector, made.inputs[0])
        self.feed(factor, made.inputs["Scale"])
        return made.outputs["Vector"]

    def feed(self, value, socket) -> None:
        if isinstance(value, bpy.types.NodeSocket):
            self.link(value, socket)
        else:
            socket.default_value = value

    def switch(self, kind: str, condition, off, on):
        made = self.node("GeometryNodeSwitch", input_type=kind)
        self.link(condition, compat.active(made.inputs, "Switch"))
        self.feed(off, compat.active(made.inputs, "False"))
        self.feed(on, compat.active(made.inputs, "True"))
        return compat.active(made.outputs, "Output")

    def store(self, geometry, name: str, kind: str, value):
        made = self.node("GeometryNodeStoreNamedAttribute", data_type=kind, domain="POINT")
        made.inputs["Name"].default_value = name
        self.link(geometry, made.inputs["Geometry"])
        self.link(value, compat.active(made.inputs, "Value"))
        return made.outputs["Geometry"]

    def texture(self, image, coordinates, interpolation: str):
        made = self.node(
            "GeometryNodeImageTexture", extension="REPEAT", interpolation=interpolation
        )
        self.link(image, made.inputs["Image"])
        self.link(coordinates, made.inputs["Vector"])
        return made


def _declare(group) -> None:
    """The group's sockets."""
    socket = compat.add_socket
    socket(group, "Geometry", "NodeSocketGeometry")
    for name in FIELDS:
        socket(group, name, "NodeSocketImage")
        socket(group, render_twin(name), "NodeSocketImage")
    socket(group, "Tile Size", "NodeSocketFloat", default_value=100.0, min_value=1e-3)
    socket(group, "Half Texel", "NodeSocketFloat")
    socket(group, render_twin("Half Texel"), "NodeSocketFloat")
    socket(group, "Origin", "NodeSocketVector")
    socket(group, "Mask", "NodeSocketString")
    for name in ("Use Mask", "Use Foam", "Use Velocity", "Use Normal"):
        socket(group, name, "NodeSocketBool")
    socket(group, "Geometry", "NodeSocketGeometry", output=True)


def _build(group, interpolation: str) -> None:
    _declare(group)
    b = _Builder(group)
    inputs = b.node("NodeGroupInput").outputs
    viewport = b.node("GeometryNodeIsViewport").outputs[0]

    def shown(name: str, kind: str):
        """An input or its twin for renders."""
        return b.switch(kind, viewport, inputs[render_twin(name)], inputs[name])

    position = b.node("GeometryNodeInputPosition").outputs[0]
    place = b.math("DIVIDE", b.math("ADD", position, inputs["Origin"]), inputs["Tile Size"])
    place = b.math("ADD", place, shown("Half Texel", "FLOAT"))

    named = b.node("GeometryNodeInputNamedAttribute", data_type="FLOAT")
    b.link(inputs["Mask"], named.inputs["Name"])
    mask = b.switch("FLOAT", inputs["Use Mask"], 1.0, compat.active(named.outputs, "Attribute"))

    displacement = b.texture(shown("Displacement", "IMAGE"), place, interpolation)
    geometry, offset = compat.capture(group, inputs["Geometry"], displacement.outputs["Color"])
    parts = b.node("FunctionNodeSeparateColor")
    b.link(offset, parts.inputs["Color"])
    foam = b.node("ShaderNodeMath", operation="MULTIPLY")
    b.link(parts.outputs["Alpha"], foam.inputs[0])
    b.link(mask, foam.inputs[1])
    stored = b.store(geometry, "foam", "FLOAT", foam.outputs["Value"])
    geometry = b.switch("GEOMETRY", inputs["Use Foam"], geometry, stored)

    velocity = b.texture(shown("Velocity", "IMAGE"), place, interpolation)
    stored, velocity = compat.capture(group, geometry, velocity.outputs["Color"])
    velocity = b.scale(velocity, mask)
    # Cycles takes `velocity` for motion blur and shows shaders zeros in its place.
    stored = b.store(stored, "velocity", "FLOAT_VECTOR", velocity)
    stored = b.store(stored, "ocean_velocity", "FLOAT_VECTOR", velocity)
    geometry = b.switch("GEOMETRY", inputs["Use Velocity"], geometry, stored)

    up = (0.0, 0.0, 1.0)
    normal = b.texture(shown("Normal", "IMAGE"), place, interpolation).outputs["Color"]
    normal = b.math("ADD", b.scale(b.math("SUBTRACT", normal, up), mask), up)
    stored = b.store(geometry, "ocean_normal", "FLOAT_VECTOR", normal)
    geometry = b.switch("GEOMETRY", inputs["Use Normal"], geometry, stored)

    moved = b.node("GeometryNodeSetPosition")
    b.link(geometry, moved.inputs["Geometry"])
    b.link(b.scale(offset, mask), moved.inputs["Offset"])
    b.link(moved.outputs["Geometry"], b.node("NodeGroupOutput").inputs[0])
    for number, made in enumerate(group.nodes):
        made.location = (220 * (number // 4), -240 * (number % 4))


def is_ours(group) -> bool:
    return group is not None and MARK in group


def get(*, on_texels: bool):
    """The group: made when there is none. on_texels: for meshes whose vertices lie on samples; they
    take the nearest one, to the bit."""
    interpolation = "Closest" if on_texels else "Linear"
    name = f".libocean.v{VERSION} {interpolation}"
    for group in bpy.data.node_groups:
        if group.name == name and is_ours(group) and group.library is None:
            return group
    group = bpy.data.node_groups.new(name, "GeometryNodeTree")
    group[MARK] = VERSION
    if hasattr(group, "is_modifier"):  # 4.0
        group.is_modifier = True
    _build(group, interpolation)
    return group


def modifiers(ob) -> list:
    """The ocean modifiers of an object."""
    return [m for m in ob.modifiers if m.type == "NODES" and is_ours(m.node_group)]


def assign(modifier, values: dict) -> None:
    """Sets inputs of the modifier by their names."""
    identifiers = compat.input_identifiers(modifier.node_group)
    for name, value in values.items():
        compat.set_input(modifier, identifiers[name], value)


def value(modifier, name: str):
    return compat.get_input(modifier, compat.input_identifiers(modifier.node_group)[name])
