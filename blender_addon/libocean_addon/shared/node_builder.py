# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Short words for the parts of a node group."""

from __future__ import annotations

from collections.abc import Callable

import bpy

from . import compat

_COMPONENTS = ("Red", "Green", "Blue", "Alpha")
_SOCKETS = {
    "BOOLEAN": "NodeSocketBool",
    "GEOMETRY": "NodeSocketGeometry",
    "IMAGE": "NodeSocketImage",
    "INT": "NodeSocketInt",
    "MATERIAL": "NodeSocketMaterial",
    "OBJECT": "NodeSocketObject",
    "RGBA": "NodeSocketColor",
    "SHADER": "NodeSocketShader",
    "STRING": "NodeSocketString",
    "VALUE": "NodeSocketFloat",
    "VECTOR": "NodeSocketVector",
}
_GROUP_NODES = {"GeometryNodeTree": "GeometryNodeGroup", "ShaderNodeTree": "ShaderNodeGroup"}


def _is_so(owner, name: str, value) -> bool:
    """Returns whether a property has this value already, to the bit."""
    now = getattr(owner, name)
    return (tuple(now) if isinstance(value, tuple) else now) == value


class Builder:
    """Adds nodes to a group and links them. Values are outputs of nodes, or constants.

    Blender goes through the whole group after each change, so that building takes more than the
    square of the number of nodes: nothing is set that is so by itself, places are set all at once,
    and a large group is made of nested ones.
    """

    def __init__(self, group) -> None:
        self.group = group
        self._parts: dict[str, bpy.types.NodeTree] = {}  # nested groups, by name

    def nested(self, name: str, make: Callable, *operands) -> list:
        """Returns the outputs of a nested group: those that make(builder, *inputs) returns, a list
        of outputs of nodes. operands: outputs, for the inputs. Calls with the same name share one
        group."""
        group = self._parts.get(name)
        if group is None:
            group = self._parts[name] = self._part(name, make, operands)
        made = self.node(_GROUP_NODES[self.group.bl_idname], node_tree=group)
        for socket, operand in zip(made.inputs, operands, strict=False):
            self.link(operand, socket)
        return list(made.outputs)

    def _part(self, name: str, make: Callable, operands):
        group = bpy.data.node_groups.new(f".libocean {name}", self.group.bl_idname)
        for operand in operands:
            compat.add_socket(group, operand.name, _SOCKETS[operand.type])
        inner = type(self)(group)
        inner._parts = self._parts
        inputs = inner.node("NodeGroupInput").outputs
        results = make(inner, *list(inputs)[: len(operands)])
        for result in results:
            compat.add_socket(group, result.name, _SOCKETS[result.type], output=True)
        output = inner.node("NodeGroupOutput")
        for socket, result in zip(output.inputs, results, strict=False):
            inner.link(result, socket)
        inner.arrange(rows=4)
        return group

    def node(self, kind: str, **settings):
        made = self.group.nodes.new(kind)
        for key, value in settings.items():
            if not _is_so(made, key, value):
                setattr(made, key, value)
        return made

    def link(self, output, socket) -> None:
        self.group.links.new(output, socket)

    def arrange(self, *, rows: int = 1, width: int = 220, height: int = 260) -> None:
        """Lays out all nodes in columns of so many rows."""
        nodes = self.group.nodes
        places = ((width * (n // rows), -height * (n % rows)) for n in range(len(nodes)))
        nodes.foreach_set("location", [part for place in places for part in place])

    def math(self, operation: str, *operands, result: str = "Vector"):
        """Vector math; an operand is an output or a value. result: "Value" where it is a number."""
        made = self.node("ShaderNodeVectorMath", operation=operation)
        for socket, operand in zip(made.inputs, operands, strict=False):
            self.feed(operand, socket)
        return made.outputs[result]

    def number(self, operation: str, *operands, clamp: bool = False):
        """Math of numbers; an operand is an output or a value. clamp: to 0 .. 1."""
        made = self.node("ShaderNodeMath", operation=operation, use_clamp=clamp)
        for socket, operand in zip(made.inputs, operands, strict=False):
            self.feed(operand, socket)
        return made.outputs["Value"]

    def mix(self, from_, to, share):
        return self.math("ADD", from_, self.scale(self.math("SUBTRACT", to, from_), share))

    def eased(self, low, high, value):
        """Returns 0 up to `low`, 1 from `high` on, and a smooth step between them."""
        made = self.node("ShaderNodeMapRange", interpolation_type="SMOOTHSTEP")
        for name, given in (("Value", value), ("From Min", low), ("From Max", high)):
            self.feed(given, compat.active(made.inputs, name))
        return compat.active(made.outputs, "Result")

    def parts(self, vector):
        made = self.node("ShaderNodeSeparateXYZ")
        self.link(vector, made.inputs[0])
        return made.outputs

    def vector(self, x, y, z):
        made = self.node("ShaderNodeCombineXYZ")
        for socket, value in zip(made.inputs, (x, y, z), strict=True):
            self.feed(value, socket)
        return made.outputs[0]

    def scale(self, vector, factor):
        made = self.node("ShaderNodeVectorMath", operation="SCALE")
        self.feed(vector, made.inputs[0])
        self.feed(factor, made.inputs["Scale"])
        return made.outputs["Vector"]

    def rotate(self, vector, euler, *, back: bool = False):
        """By Euler angles, XYZ; back: by the opposite turn."""
        made = self.node("ShaderNodeVectorRotate", rotation_type="EULER_XYZ", invert=back)
        self.feed(vector, made.inputs["Vector"])
        self.link(euler, made.inputs["Rotation"])
        return made.outputs["Vector"]

    def in_axes(self, vector, euler):
        """Returns a vector in the axes that Euler angles turn. They are made once, where a turn of
        the vector takes six sines a vertex."""
        axes = (self.rotate(axis, euler) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
        return self.vector(
            *(self.math("DOT_PRODUCT", vector, axis, result="Value") for axis in axes)
        )

    def feed(self, value, socket) -> None:
        if isinstance(value, bpy.types.NodeSocket):
            self.link(value, socket)
        elif not _is_so(socket, "default_value", value):
            socket.default_value = value

    def switch(self, kind: str, condition, off, on):
        """The node has sockets of all types, and a file keeps each: it stands in a nested group
        once, unless an operand is a constant."""
        operands = (condition, off, on)
        if not all(isinstance(given, bpy.types.NodeSocket) for given in operands):
            return self._switch(kind, *operands)

        def make(b: Builder, *inputs) -> list:
            return [b._switch(kind, *inputs)]

        return self.nested(f"switch {kind.lower()}", make, *operands)[0]

    def _switch(self, kind: str, condition, off, on):
        made = self.node("GeometryNodeSwitch", input_type=kind)
        self.link(condition, compat.active(made.inputs, "Switch"))
        self.feed(off, compat.active(made.inputs, "False"))
        self.feed(on, compat.active(made.inputs, "True"))
        return compat.active(made.outputs, "Output")

    def store(self, geometry, name: str, kind: str, value, selection=None):
        """selection: which points get the value, from Blender 3.6 on; in 3.4 all do."""
        made = self.node("GeometryNodeStoreNamedAttribute", data_type=kind, domain="POINT")
        if selection is not None and "Selection" in made.inputs:
            self.link(selection, made.inputs["Selection"])
        made.inputs["Name"].default_value = name
        self.link(geometry, made.inputs["Geometry"])
        self.link(value, compat.active(made.inputs, "Value"))
        return made.outputs["Geometry"]

    def texture(
        self, image, coordinates, interpolation: str, frame=None, extension: str = "REPEAT"
    ):
        made = self.node(
            "GeometryNodeImageTexture", extension=extension, interpolation=interpolation
        )
        self.link(image, made.inputs["Image"])
        self.link(coordinates, made.inputs["Vector"])
        if frame is not None:
            self.link(frame, made.inputs["Frame"])
        return made.outputs["Color"]

    def color(self, *components):
        made = self.node("FunctionNodeCombineColor")
        for value, name in zip(components, _COMPONENTS, strict=True):
            self.feed(value, made.inputs[name])
        return made.outputs["Color"]

    def components(self, color) -> list:
        made = self.node("FunctionNodeSeparateColor")
        self.link(color, made.inputs["Color"])
        return [made.outputs[name] for name in _COMPONENTS]

    def alpha(self, color):
        return self.components(color)[3]

    def mix_colors(self, from_, to, share):
        """Returns the mix of all four components."""
        first, last = self.alpha(from_), self.alpha(to)
        alpha = self.number("MULTIPLY_ADD", self.number("SUBTRACT", last, first), share, first)
        return self.color(*self.parts(self.mix(from_, to, share)), alpha)
