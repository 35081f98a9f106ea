# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of the node group that adds the wakes of hulls to the sea's fields.

    place in the world -> place in the wake's image -> colour, 0 outside -> sum

A wake has an image for each field, and an input for its place. Without an image it is 0.
"""

from __future__ import annotations

from collections.abc import Callable

from ..shared import compat, field_nodes
from ..shared.node_builder import Builder

COUNT = 4
"""The max number of wakes that are shown."""
FIELDS = {"Displacement": "", "Velocity": " Velocity", "Normal": " Slopes"}
"""The ends of the names of a wake's images, by the sea's field to which they belong."""
USE = "Use Wakes"
IN_MAPS = "Wakes in Maps"
IN_MAPS_HELP = (
    "The maps of a patch are sums of sea and wakes at its vertices, with the trail as the alpha of "
    "the normals"
)
WHITECAP = "Whitecap"
_WHITECAP_HELP = (
    "The Jacobian where whitecaps begin, by how much less they are whole, and the exponent that "
    "turns foam into cover"
)
_PLACE_HELP = (
    "Where the ocean is in the wake's images (x, y: 0 .. 1), and their number in a metre (z)"
)


def image_input(hull: int, field: str) -> str:
    return f"Wake {hull + 1}{FIELDS[field]}"


def place_input(hull: int) -> str:
    return f"Wake {hull + 1} Place"


def image_inputs() -> list[str]:
    return [image_input(hull, field) for hull in range(COUNT) for field in FIELDS]


def declare(group) -> None:
    """The sockets of all wakes."""
    compat.add_socket(group, USE, "NodeSocketBool")
    compat.add_socket(group, IN_MAPS, "NodeSocketBool", description=IN_MAPS_HELP)
    compat.add_socket(group, WHITECAP, "NodeSocketVector", description=_WHITECAP_HELP)
    for name in image_inputs():
        compat.add_socket(group, name, "NodeSocketImage")
    for hull in range(COUNT):
        compat.add_socket(group, place_input(hull), "NodeSocketVector", description=_PLACE_HELP)


def _read(b: Builder, image, place, position, interpolation: str):
    """Returns colour and alpha of a wake's image at a position, from the ocean on [m]."""
    there = b.math("MULTIPLY_ADD", position, b.parts(place)[2], place)
    color = b.texture(image, there, interpolation, extension="CLIP")
    return [color, color.node.outputs["Alpha"]]


def broken(b: Builder, inputs, geometry):
    """Returns the geometry with foam where the sum of sea and wakes breaks now, by the attribute
    jacobian."""

    def make(b: Builder, geometry, whitecap):
        begin, width, power = b.parts(whitecap)
        jacobian = field_nodes.attribute(b, "jacobian", "FLOAT")
        fall = b.number("SUBTRACT", begin, jacobian)
        foam = b.number("DIVIDE", fall, width, clamp=True)
        before = field_nodes.attribute(b, "foam", "FLOAT")
        geometry = b.store(geometry, "foam", "FLOAT", b.number("MAXIMUM", before, foam))
        foam = b.number("DIVIDE", fall, width, clamp=True)
        before = field_nodes.attribute(b, "cover", "FLOAT")
        cover = b.number("MAXIMUM", before, b.number("POWER", foam, power))
        return [b.store(geometry, "cover", "FLOAT", cover)]

    foamy = b.nested("bow foam", make, geometry, inputs[WHITECAP])[0]
    return b.switch("GEOMETRY", inputs["Use Foam"], geometry, foamy)


class Wakes:
    """The sums of all wakes at the vertices, which have not been displaced yet."""

    def __init__(self, b: Builder, inputs, turn, interpolation: str) -> None:
        """interpolation: of the sea's maps; where the vertices lie on their samples, they lie on
        those of the wakes."""
        self.b, self.inputs, self.interpolation = b, inputs, interpolation
        self.position = turn.to_world(b.node("GeometryNodeInputPosition").outputs[0])

    def _sums(self, field: str):
        """Returns the sums of colours and of alphas. The last wake comes first: those without an
        image are constants, and cost nothing for each vertex."""

        def make(b: Builder, position, *given) -> list:
            sums = None
            for image, place in reversed(list(zip(given[::2], given[1::2], strict=True))):
                color, alpha = _read(b, image, place, position, self.interpolation)
                if sums is not None:
                    color = b.math("ADD", color, sums[0])
                    alpha = b.number("ADD", alpha, sums[1])
                sums = color, alpha
            return [*sums]

        names = [
            name for hull in range(COUNT) for name in (image_input(hull, field), place_input(hull))
        ]
        given = (self.inputs[name] for name in names)
        return self.b.nested(f"wakes {self.interpolation.lower()}", make, self.position, *given)

    def added(self, geometry, field: str, make: Callable):
        """Returns make(geometry, vector, alpha) with what all wakes add to a field; without wakes
        make(geometry)."""
        vector, alpha = self._sums(field)
        waked = geometry
        if field != "Normal":  # two attributes read it, and an image is dear to read
            whole = self.b.color(*self.b.parts(vector), alpha)
            waked, vector = compat.capture(self.b.group, geometry, whole)
            alpha = self.b.alpha(vector)
        waked = make(waked, vector, alpha)
        return self.b.switch("GEOMETRY", self.inputs[USE], make(geometry), waked)

    def in_maps(self, geometry, make: Callable):
        """Returns make() if the maps are sums of sea and wakes; else the geometry."""
        if self.interpolation != "Closest":
            return geometry
        return self.b.switch("GEOMETRY", self.inputs[IN_MAPS], geometry, make())


class NoWakes:
    """In the place of Wakes: a bake has none."""

    def added(self, geometry, _field: str, make: Callable):
        return make(geometry)

    def in_maps(self, geometry, _make: Callable):
        return geometry
