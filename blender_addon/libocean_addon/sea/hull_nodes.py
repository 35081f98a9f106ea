# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of the node group that marks the water inside hulls, at the displaced vertices.

    place -> in the object's own axes -> beside its sides there -> attributes hull and dry

A hull is where its object is, and its outline (hull_outline.py) is an image: stations by levels.
"""

from __future__ import annotations

from ..shared import compat, field_nodes
from ..shared.node_builder import Builder
from .hull_outline import LEVELS, STATIONS

COUNT = 4
"""The max number of hulls that are marked."""
NUMBER = "Hulls"
HULL = "hull"
"""Attribute, a vector: the share of a hull's length at which a vertex is plus a number of the hull
(see beside()), and its distances to both sides, positive inside [m]. Between the vertices it is as
straight as the outline, so that a shader finds the water line in the middle of a face."""
DRY = "dry"
_STEP = 256.0  # between the numbers of hulls: what lies between two of them means none
_FARTHEST = 100.0  # share of the length
_IN_THE_AIR = -1.0  # share of the height of the outline, from its lowest level
_BEGIN_HELP = "Of the outline: its first x and its lowest z, in the axes of the object [m]"
_SIZE_HELP = "Of the outline along x, y and z [m]"


def object_input(hull: int) -> str:
    return f"Hull {hull + 1}"


def outline_input(hull: int) -> str:
    return f"Hull {hull + 1} Outline"


def begin_input(hull: int) -> str:
    return f"Hull {hull + 1} Begin"


def size_input(hull: int) -> str:
    return f"Hull {hull + 1} Size"


def object_inputs() -> list[str]:
    return [object_input(hull) for hull in range(COUNT)]


def outline_inputs() -> list[str]:
    return [outline_input(hull) for hull in range(COUNT)]


def declare(group) -> None:
    """The sockets of all hulls."""
    compat.add_socket(group, NUMBER, "NodeSocketFloat")
    for hull in range(COUNT):
        compat.add_socket(group, object_input(hull), "NodeSocketObject")
        compat.add_socket(group, outline_input(hull), "NodeSocketImage")
        compat.add_socket(group, begin_input(hull), "NodeSocketVector", description=_BEGIN_HELP)
        compat.add_socket(group, size_input(hull), "NodeSocketVector", description=_SIZE_HELP)


def beside(b: Builder, stored):
    """Returns the number of the hull that a value of HULL means, 1 .. COUNT, 0 without one; by how
    much the share of the length lies within 0 .. 1, and the distance within the sides [m]. Both are
    negative outside. b: of geometry or of a shader."""
    coded, right, left = b.parts(stored)
    number = b.number("ROUND", b.number("MULTIPLY", coded, 1.0 / _STEP))
    along = b.number("MULTIPLY_ADD", number, -_STEP, coded)
    from_middle = b.number("ABSOLUTE", b.number("SUBTRACT", along, 0.5))
    return number, b.number("SUBTRACT", 0.5, from_middle), b.number("MINIMUM", right, left)


def _depth(b: Builder, to_end, to_side, length):
    """Returns how far inside a hull a vertex is; negative outside [m]."""
    return b.number("MINIMUM", to_side, b.number("MULTIPLY", to_end, length))


def _mark(b: Builder, geometry, hull, outline, begin, size, number, *, first: bool) -> list:
    """Returns the geometry with the marks of a hull. first: no other one has left any."""
    info = b.node("GeometryNodeObjectInfo", transform_space="RELATIVE")
    b.link(hull, info.inputs["Object"])
    position = b.node("GeometryNodeInputPosition").outputs[0]
    place = b.math("SUBTRACT", position, info.outputs["Location"])
    own = b.in_axes(place, info.outputs["Rotation"])
    y = b.parts(own)[1]
    length, width, _ = b.parts(size)
    along, _, up = b.parts(b.math("DIVIDE", b.math("SUBTRACT", own, begin), size))
    steps, first_step = (
        (1.0 - 1.0 / STATIONS, 1.0 - 1.0 / LEVELS, 0.0),
        (0.5 / STATIONS, 0.5 / LEVELS, 0.0),
    )
    texel = b.math("MULTIPLY_ADD", b.vector(along, up, 0.0), steps, first_step)
    sides = b.texture(outline, texel, "Linear", extension="EXTEND")
    low, high = b.components(sides)[:2]
    near = b.number("MINIMUM", b.number("MAXIMUM", along, -_FARTHEST), _FARTHEST)
    coded = b.number("MULTIPLY_ADD", number, _STEP, near)
    # Water far below a hull in the air stays.
    below = b.number("MAXIMUM", b.number("SUBTRACT", _IN_THE_AIR, up), 0.0)
    low = b.number("MULTIPLY_ADD", below, 1000.0, low)
    value = b.vector(coded, b.number("SUBTRACT", y, low), b.number("SUBTRACT", high, y))
    if not first:
        before = field_nodes.attribute(b, HULL)
        known, *of_known = beside(b, before)
        _, *of_this = beside(b, value)
        depths = (_depth(b, *of, length) for of in (of_this, of_known))
        nearer = b.number("GREATER_THAN", *depths)
        is_none = b.number("LESS_THAN", known, 0.5)
        value = b.switch("VECTOR", b.number("MAXIMUM", nearer, is_none), before, value)
    # Where the node has no selection, all vertices get the value.
    reach = b.number("MULTIPLY_ADD", length, 1.5, 5.0)
    is_near = b.number("LESS_THAN", b.math("LENGTH", place, result="Value"), reach)
    geometry = b.store(geometry, HULL, "FLOAT_VECTOR", value, is_near)

    known, *of_known = beside(b, field_nodes.attribute(b, HULL))
    inside = b.number("DIVIDE", _depth(b, *of_known, length), b.number("MULTIPLY", width, 0.1))
    share = b.number("ADD", inside, 0.5, clamp=True)
    if not first:
        share = b.number("MULTIPLY", share, b.number("COMPARE", known, number, 0.25))
        share = b.number("MAXIMUM", share, field_nodes.attribute(b, DRY, "FLOAT"))
    return [b.store(geometry, DRY, "FLOAT", share, is_near)]


def marked(b: Builder, inputs, geometry):
    """Returns the geometry with the attributes of all hulls that are given."""
    for hull in range(COUNT):
        number = b.node("ShaderNodeValue").outputs[0]
        number.default_value = hull + 1.0
        names = (object_input, outline_input, begin_input, size_input)
        given = (inputs[name(hull)] for name in names)

        def mark(b: Builder, *operands, first=hull == 0) -> list:
            return _mark(b, *operands, first=first)

        name = "hull" if hull == 0 else "another hull"
        with_it = b.nested(name, mark, geometry, *given, number)[0]
        is_given = b.number("GREATER_THAN", inputs[NUMBER], hull + 0.5)
        geometry = b.switch("GEOMETRY", is_given, geometry, with_it)
    return geometry
