# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of the node group that makes a horizon: where the vertices of its rings go, and which
maps they show there.

    place, camera -> ring's own lattice -> finest map, own map, next coarser map -> mixed
"""

from __future__ import annotations

from ..shared import compat, field_nodes

RING = "ocean_ring"
"""Attribute of a horizon's vertices: the number of the ring, how far it has become the next one,
and the size of its cells in cells of the finest."""


def far_image(field: str) -> str:
    """The input for the coarser maps of a field, see atlas.py."""
    return f"{field} Far"


def declare(group) -> None:
    """The sockets that only a horizon has."""
    compat.add_socket(group, "Camera", "NodeSocketObject")
    compat.add_socket(
        group,
        "Samples",
        "NodeSocketFloat",
        default_value=512.0,
        min_value=1.0,
        description="Cells of the finest ring in a period",
    )


class Rings:
    """A horizon: rings around the camera, each twice as coarse as the one inside it.

    A ring moves in steps of two of its own cells, so that its vertices stay on samples: the waves
    pass through the mesh, which never swims along with the camera. Towards its outer edge it turns
    into the next one (the share in RING), in place and in what it shows, so that neither a gap
    nor a line is seen; geometry clipmaps do so [Losasso and Hoppe 2004].
    """

    def __init__(self, b, inputs, fields, turn) -> None:
        self.b, self.inputs, self.fields, self.turn = b, inputs, fields, turn
        self.level, self.share, self.cells = b.parts(field_nodes.attribute(b, RING))
        # Values that depend on inputs alone are computed once, not for each vertex.
        self.texels = b.number("DIVIDE", 0.5, fields.half_texel())
        self.origin = fields.origin()
        self.coarser = b.number("DIVIDE", self.texels, inputs["Samples"])  # map than mesh
        self._move()
        self._choose_maps()

    def _move(self) -> None:
        """self.moved: where a vertex goes; self.place: where that is, in periods."""
        b, inputs = self.b, self.inputs
        level_only = (1.0, 1.0, 0.0)
        camera = b.node("GeometryNodeObjectInfo", transform_space="RELATIVE")
        b.link(inputs["Camera"], camera.inputs["Object"])
        above = b.math("ADD", self.turn.to_world(camera.outputs["Location"]), self.origin)
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
        origin = b.math("MULTIPLY", self.origin, level_only)
        moved = b.math("ADD", position, b.math("SUBTRACT", b.scale(steps, cell), origin))
        self.moved = self.turn.to_local(moved)

    def _choose_maps(self) -> None:
        """Where in the finest map, in the ring's own and in the next one's a vertex is. A map that
        is coarser than the mesh serves several rings."""
        b = self.b
        fraction = b.math("FRACTION", self.place)
        spare = b.number("ROUND", b.number("LOGARITHM", self.coarser, 2.0))  # 0 or less
        own = b.number("ADD", self.level, spare)
        divisor = b.number("MULTIPLY", self.cells, self.coarser)
        self.finest = b.math("ADD", fraction, self.fields.half_texel())
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
        both = (self.finest, self.own), (self.next, b.vector(self.on_finest, self.blend, 0.0))
        kept = []
        for first, second in both:
            color = b.color(*b.parts(first)[:2], *b.parts(second)[:2])
            geometry, color = compat.capture(b.group, geometry, color)
            kept.append(b.components(color))
        (x, y, own_x, own_y), (next_x, next_y, self.on_finest, self.blend) = kept
        self.finest, self.own = b.vector(x, y, 0.0), b.vector(own_x, own_y, 0.0)
        self.next = b.vector(next_x, next_y, 0.0)
        placed = b.node("GeometryNodeSetPosition")
        b.link(geometry, placed.inputs["Geometry"])
        b.link(self.moved, placed.inputs["Position"])
        return placed.outputs["Geometry"]

    def color(self, field: str):
        b, fields = self.b, self.fields
        finest = fields.color(field, self.finest, "Linear")
        own, next_ = (fields.far(field, place) for place in (self.own, self.next))
        mix = b.mix_colors if fields.has_alpha(field) else b.mix
        return mix(b.switch("RGBA", self.on_finest, own, finest), next_, self.blend)

    def normal(self, geometry):
        geometry, normal = compat.capture(self.b.group, geometry, self.color("Normal"))
        return geometry, normal, self.b.alpha(normal)
