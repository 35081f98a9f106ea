# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The node group of the modifier: it reads finished fields from float images, nothing else.

    position + origin -> / tile size -> + half a texel -> image -> offset, attributes

Each image is read once: a field is evaluated anew by every node that uses it, a captured one is
not. The rings of a horizon read coarser maps too: see _Rings.
"""

from __future__ import annotations

import bpy

from . import compat

VERSION = 1
MARK = "libocean"  # custom property of a group: the version that built it

FIELDS = ("Displacement", "Velocity", "Normal")
"""The maps; each image has a twin for renders. Foam is the alpha of the first, and of a horizon's
third one the variance of the slopes that are left out."""


RING = "ocean_ring"
"""Attribute of a horizon's vertices: the number of the ring, how far it has become the next one,
and the size of its cells in cells of the finest."""


def render_twin(name: str) -> str:
    return f"{name} Render"


def far_image(field: str) -> str:
    """The coarser maps of a horizon, see atlas.py."""
    return f"{field} Far"


_COMPONENTS = ("Red", "Green", "Blue", "Alpha")


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

    def number(self, operation: str, *operands):
        """Math of numbers; an operand is an output or a value."""
        made = self.node("ShaderNodeMath", operation=operation)
        for socket, operand in zip(made.inputs, operands, strict=False):
            self.feed(operand, socket)
        return made.outputs["Value"]

    def mix(self, from_, to, share):
        return self.math("ADD", from_, self.scale(self.math("SUBTRACT", to, from_), share))

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


def _declare(group, *, rings: bool) -> None:
    """The group's sockets."""
    socket = compat.add_socket
    socket(group, "Geometry", "NodeSocketGeometry")
    for name in FIELDS:
        socket(group, name, "NodeSocketImage")
        socket(group, render_twin(name), "NodeSocketImage")
        if rings:
            socket(group, far_image(name), "NodeSocketImage")
            socket(group, render_twin(far_image(name)), "NodeSocketImage")
    if rings:
        socket(group, "Camera", "NodeSocketObject")
        socket(group, "Samples", "NodeSocketFloat", default_value=512.0, min_value=1.0)
    socket(group, "Tile Size", "NodeSocketFloat", default_value=100.0, min_value=1e-3)
    socket(group, "Half Texel", "NodeSocketFloat")
    socket(group, render_twin("Half Texel"), "NodeSocketFloat")
    socket(group, "Origin", "NodeSocketVector")
    socket(group, "Mask", "NodeSocketString")
    for name in ("Use Mask", "Use Foam", "Use Velocity", "Use Normal"):
        socket(group, name, "NodeSocketBool")
    socket(group, "Geometry", "NodeSocketGeometry", output=True)


class _Flat:
    """A mesh that shows the finest map wherever it lies."""

    def __init__(self, b: _Builder, inputs, shown, interpolation: str) -> None:
        self.b, self.shown, self.interpolation = b, shown, interpolation
        position = b.node("GeometryNodeInputPosition").outputs[0]
        place = b.math("DIVIDE", b.math("ADD", position, inputs["Origin"]), inputs["Tile Size"])
        self.place = b.math("ADD", place, shown("Half Texel", "FLOAT"))

    def start(self, geometry):
        return geometry

    def color(self, field: str):
        return self.b.texture(self.shown(field, "IMAGE"), self.place, self.interpolation)

    def normal(self, geometry):
        """Geometry, normal, and where it is known the slopes' variance that the map leaves out."""
        return geometry, self.color("Normal"), None


class _Rings:
    """A horizon: rings around the camera, each twice as coarse as the one inside it.

    A ring moves in steps of two of its own cells, so that its vertices stay on samples: the waves
    pass through the mesh, which never swims along with the camera. Towards its outer edge it turns
    into the next one (the share in RING), in place and in what it shows, so that neither a gap
    nor a line is seen; geometry clipmaps do so [Losasso and Hoppe 2004].
    """

    def __init__(self, b: _Builder, inputs, shown) -> None:
        self.b, self.inputs, self.shown = b, inputs, shown
        named = b.node("GeometryNodeInputNamedAttribute", data_type="FLOAT_VECTOR")
        named.inputs["Name"].default_value = RING
        self.level, self.share, self.cells = b.parts(compat.active(named.outputs, "Attribute"))
        # What follows of inputs alone is computed once, not for each vertex.
        self.texels = b.number("DIVIDE", 0.5, shown("Half Texel", "FLOAT"))
        self.coarser = b.number("DIVIDE", self.texels, inputs["Samples"])  # map than mesh
        self._move()
        self._choose_maps()

    def _move(self) -> None:
        """self.moved: where a vertex goes; self.place: where that is, in periods."""
        b, inputs = self.b, self.inputs
        level_only = (1.0, 1.0, 0.0)
        camera = b.node("GeometryNodeObjectInfo", transform_space="RELATIVE")
        b.link(inputs["Camera"], camera.inputs["Object"])
        above = b.math("ADD", camera.outputs["Location"], inputs["Origin"])
        spacing = b.number("DIVIDE", inputs["Tile Size"], inputs["Samples"])
        above = b.math("MULTIPLY", above, level_only)
        cell = b.number("MULTIPLY", self.cells, spacing)
        per_cell = b.number("DIVIDE", 1.0, cell)
        above = b.scale(above, per_cell)

        def snapped(step: float):
            return b.scale(b.math("FLOOR", b.scale(above, 1.0 / step)), step)

        steps = b.mix(snapped(2.0), snapped(4.0), self.share)
        position = b.node("GeometryNodeInputPosition").outputs[0]
        index = b.math("ADD", b.scale(position, per_cell), steps)
        per_sample = b.number("DIVIDE", 1.0, inputs["Samples"])
        self.place = b.scale(index, b.number("MULTIPLY", self.cells, per_sample))
        origin = b.math("MULTIPLY", inputs["Origin"], level_only)
        self.moved = b.math("ADD", position, b.math("SUBTRACT", b.scale(steps, cell), origin))

    def _choose_maps(self) -> None:
        """Where in the finest map, in the ring's own and in the next one's a vertex is. A map that
        is coarser than the mesh serves several rings."""
        b = self.b
        fraction = b.math("FRACTION", self.place)
        spare = b.number("ROUND", b.number("LOGARITHM", self.coarser, 2.0))  # 0 or less
        own = b.number("ADD", self.level, spare)
        divisor = b.number("MULTIPLY", self.cells, self.coarser)
        self.finest = b.math("ADD", fraction, self.shown("Half Texel", "FLOAT"))
        self.own = self._in_atlas(fraction, own, divisor)
        self.next = self._in_atlas(
            fraction, b.number("ADD", own, 1.0), b.number("MULTIPLY", divisor, 2.0)
        )
        self.on_finest = b.number("LESS_THAN", own, 0.5)
        self.blend = b.number("MULTIPLY", self.share, b.number("GREATER_THAN", own, -0.5))

    def _in_atlas(self, fraction, level, divisor):
        """The texture coordinates of a place in a map of the atlas, laid out as atlas.py says.
        divisor: 2^level."""
        b = self.b
        last = b.number("ROUND", b.number("LOGARITHM", self.texels, 2.0))
        level = b.number("MINIMUM", b.number("MAXIMUM", level, 1.0), last)
        divisor = b.number("MINIMUM", b.number("MAXIMUM", divisor, 2.0), self.texels)
        size = b.number("DIVIDE", self.texels, divisor)
        # Below it are larger maps, of texels - 2 size rows in all, and two rows of border each.
        constant = b.number("SUBTRACT", self.texels, 0.5)
        bottom = b.number("MULTIPLY_ADD", b.number("SUBTRACT", level, size), 2.0, constant)
        texel = b.math("ADD", b.scale(fraction, size), b.vector(1.5, bottom, 0.0))
        width = b.number("MULTIPLY_ADD", self.texels, 0.5, 2.0)
        height = b.number("ADD", self.texels, b.number("MULTIPLY_ADD", last, 2.0, -1.0))
        per_texel = b.vector(b.number("DIVIDE", 1.0, width), b.number("DIVIDE", 1.0, height), 0.0)
        return b.math("MULTIPLY", texel, per_texel)

    def start(self, geometry):
        """Puts the rings around the camera and keeps where each vertex looks."""
        b = self.b
        wanted = [(self.finest, self.own), (self.next, (self.on_finest, self.blend))]
        kept = []
        for first, second in wanted:
            x, y, _ = b.parts(first)
            z, w = second if isinstance(second, tuple) else b.parts(second)[:2]
            geometry, color = compat.capture(b.group, geometry, b.color(x, y, z, w))
            kept.append(b.components(color))
        (x, y, own_x, own_y), (next_x, next_y, self.on_finest, self.blend) = kept
        self.finest, self.own = b.vector(x, y, 0.0), b.vector(own_x, own_y, 0.0)
        self.next = b.vector(next_x, next_y, 0.0)
        placed = b.node("GeometryNodeSetPosition")
        b.link(geometry, placed.inputs["Geometry"])
        b.link(self.moved, placed.inputs["Position"])
        return placed.outputs["Geometry"]

    def color(self, field: str):
        b = self.b
        finest = b.texture(self.shown(field, "IMAGE"), self.finest, "Linear")
        far = self.shown(far_image(field), "IMAGE")
        own, next_ = (b.texture(far, place, "Linear") for place in (self.own, self.next))
        shown = b.switch("RGBA", self.on_finest, own, finest)
        alpha, next_alpha = b.alpha(shown), b.alpha(next_)
        more = b.number("SUBTRACT", next_alpha, alpha)
        mixed = b.parts(b.mix(shown, next_, self.blend))
        return b.color(*mixed, b.number("MULTIPLY_ADD", more, self.blend, alpha))

    def normal(self, geometry):
        geometry, normal = compat.capture(self.b.group, geometry, self.color("Normal"))
        return geometry, normal, self.b.alpha(normal)


def _build(group, kind: str) -> None:
    _declare(group, rings=kind == "Rings")
    b = _Builder(group)
    inputs = b.node("NodeGroupInput").outputs
    viewport = b.node("GeometryNodeIsViewport").outputs[0]

    def shown(name: str, kind: str):
        """An input or its twin for renders."""
        return b.switch(kind, viewport, inputs[render_twin(name)], inputs[name])

    rings = kind == "Rings"
    lookup = _Rings(b, inputs, shown) if rings else _Flat(b, inputs, shown, kind)

    named = b.node("GeometryNodeInputNamedAttribute", data_type="FLOAT")
    b.link(inputs["Mask"], named.inputs["Name"])
    mask = b.switch("FLOAT", inputs["Use Mask"], 1.0, compat.active(named.outputs, "Attribute"))

    geometry, offset = compat.capture(
        group, lookup.start(inputs["Geometry"]), lookup.color("Displacement")
    )
    foam = b.number("MULTIPLY", b.alpha(offset), mask)
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
    if slope_variance is not None:
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


LOOKUPS = {"MESH": "Linear", "PATCH": "Closest", "HORIZON": "Rings"}
"""How a kind of mesh reads the images: a patch's vertices lie on samples, and take the nearest one,
to the bit."""


def get(kind: str):
    """The group for meshes of one kind: made when there is none."""
    name = f".libocean.v{VERSION} {LOOKUPS[kind]}"
    for group in bpy.data.node_groups:
        if group.name == name and is_ours(group) and group.library is None:
            return group
    group = bpy.data.node_groups.new(name, "GeometryNodeTree")
    group[MARK] = VERSION
    if hasattr(group, "is_modifier"):  # 4.0
        group.is_modifier = True
    _build(group, LOOKUPS[kind])
    return group


def image_inputs(group) -> list[str]:
    """The names of the inputs that take images."""
    names = compat.input_identifiers(group)
    one = [name for field in FIELDS for name in (field, far_image(field)) if name in names]
    return [name for both in one for name in (both, render_twin(both))]


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
