# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of a node group that reads finished fields from images, of seas as of terrains.

    position, turned, + origin -> / tile size -> + half a texel -> image -> offset, attributes

What lies turned in the world shows the same field: it looks where it is in the world, and what it
finds is turned back. Most things are not turned, and a patch's vertices lie on samples: these have
a branch of their own, of which a switch of geometry runs one.
"""

from __future__ import annotations

from collections.abc import Callable

from . import compat
from .node_builder import Builder

SMALLEST_TURN = 1e-6
"""Radians: less is what single precision makes of none."""


class Turn:
    """Between an object's own axes and the world's; None: they are the same."""

    def __init__(self, b: Builder, euler) -> None:
        self.b, self.euler = b, euler

    def to_world(self, vector):
        return vector if self.euler is None else self.b.rotate(vector, self.euler)

    def to_local(self, vector):
        return vector if self.euler is None else self.b.rotate(vector, self.euler, back=True)


def place_on_map(b: Builder, turn: Turn, *, origin, period, half_texel):
    """Returns the texture coordinates of a vertex in the map of one period."""
    position = turn.to_world(b.node("GeometryNodeInputPosition").outputs[0])
    place = b.math("DIVIDE", b.math("ADD", position, origin), period)
    return b.math("ADD", place, half_texel)


def place_in_map(b: Builder, turn: Turn, inputs):
    """Returns the texture coordinates of a vertex, which stay between Low and High: those of a map
    that does not repeat end at its outer samples."""
    place = place_on_map(
        b,
        turn,
        origin=inputs["Origin"],
        period=inputs["Map Size"],
        half_texel=inputs["Half Texels"],
    )
    return b.math("MINIMUM", b.math("MAXIMUM", place, inputs["Low"]), inputs["High"])


def attribute(b: Builder, name: str, kind: str = "FLOAT_VECTOR"):
    """Returns a value that the points have; 0 without it."""
    named = b.node("GeometryNodeInputNamedAttribute", data_type=kind)
    named.inputs["Name"].default_value = name
    return compat.active(named.outputs, "Attribute")


def mask(b: Builder, inputs):
    """Returns the value of the attribute in the input Mask; 1 unless Use Mask is set."""
    named = b.node("GeometryNodeInputNamedAttribute", data_type="FLOAT")
    b.link(inputs["Mask"], named.inputs["Name"])
    return b.switch("FLOAT", inputs["Use Mask"], 1.0, compat.active(named.outputs, "Attribute"))


def toward_up(b: Builder, normal, share):
    """Returns a normal that is (0, 0, 1) where the share of a mask is 0."""
    up = (0.0, 0.0, 1.0)
    return b.math("ADD", b.scale(b.math("SUBTRACT", normal, up), share), up)


def tilted(b: Builder, normal, slopes):
    """Returns a normal on which slopes (x, y) of other waves lie, to first order in both."""
    steep = b.scale(b.math("MULTIPLY", slopes, (1.0, 1.0, 0.0)), b.parts(normal)[2])
    return b.math("NORMALIZE", b.math("SUBTRACT", normal, steep))


def branches(
    b: Builder,
    inputs,
    displaced: Callable,
    *,
    name: str,
    on_samples=None,
    euler=None,
    geometry=None,
):
    """Returns the geometry of displaced(b, inputs, turn, interpolation), in a nested group for each
    way to look: level, turned and, where `on_samples` holds, from the nearest sample, to the bit.
    name: of the nested groups. on_samples: an output, None without that way; euler: the object's
    turn in the world; geometry: in place of the input Geometry."""
    given = {socket.name: socket for socket in inputs if socket.name}
    if geometry is not None:
        given["Geometry"] = geometry

    def branch(*, turned: bool, interpolation: str = "Linear"):
        def make(b: Builder, *sockets):
            inside = dict(zip(given, sockets, strict=True))
            return [displaced(b, inside, turned, interpolation)]

        variant = "turned" if turned else interpolation.lower()
        return b.nested(f"{name} {variant}", make, *given.values())[0]

    level = branch(turned=False)
    if on_samples is not None:
        nearest = branch(turned=False, interpolation="Closest")
        level = b.switch("GEOMETRY", on_samples, level, nearest)
    angle = b.math("LENGTH", euler, result="Value")
    is_turned = b.number("GREATER_THAN", angle, SMALLEST_TURN)
    return b.switch("GEOMETRY", is_turned, level, branch(turned=True))
