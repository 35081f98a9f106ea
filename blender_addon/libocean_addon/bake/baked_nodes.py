# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of the node group that plays a bake: image sequences by the scene's time, which takes
neither the add-on nor a handler.

    scene time -> bake's frame, clamped -> floor and ceiling -> two images -> mixed -> (x, y, z)
"""

from __future__ import annotations

from ..sea import ring_nodes, wake_nodes
from ..shared import compat

FIELDS = ("Displacement", "Cover", "Velocity", "Normal", "Jacobian")

ON_SAMPLES = "On Samples"
ON_SAMPLES_HELP = "The map has a sample for each vertex of the patch"

LOST_SLOPES = "Of the waves that the finest map leaves out"
COVER_POWER = "Cover Power"
COVER_POWER_HELP = "The share of the water that foam hides is foam to this power"
USE_JACOBIAN = "Use Jacobian"
USE_JACOBIAN_HELP = "Bakes of earlier versions have none: it is 1"

# The scene's time, in single precision, may fall short of a frame by its last bits.
_ALMOST = 1e-4


def declare(group, kind: str) -> None:
    """The group's sockets."""
    socket = compat.add_socket
    socket(group, "Geometry", "NodeSocketGeometry")
    for name in FIELDS:
        for image in (name, ring_nodes.far_image(name)) if kind == "HORIZON" else (name,):
            socket(group, image, "NodeSocketImage")
    if kind == "HORIZON":
        ring_nodes.declare(group)
    socket(group, "Slope Variance", "NodeSocketFloat", description=LOST_SLOPES)
    socket(group, COVER_POWER, "NodeSocketFloat", default_value=1.0, description=COVER_POWER_HELP)
    socket(group, "Tile Size", "NodeSocketFloat", default_value=100.0, min_value=1e-3)
    socket(group, "Half Texel", "NodeSocketFloat")
    socket(group, "Follow World", "NodeSocketBool")
    socket(group, ON_SAMPLES, "NodeSocketBool", description=ON_SAMPLES_HELP)
    socket(group, "First", "NodeSocketFloat", description="The first frame that has files")
    socket(group, "Last", "NodeSocketFloat", description="The last frame that has files")
    socket(
        group,
        "Frame Length",
        "NodeSocketFloat",
        default_value=1.0,
        min_value=1e-3,
        description="What a frame lasts where the scene's time is remapped",
    )
    socket(group, "Mask", "NodeSocketString")
    for name in ("Use Mask", "Use Foam", "Use Velocity", "Use Normal"):
        socket(group, name, "NodeSocketBool")
    socket(group, USE_JACOBIAN, "NodeSocketBool", description=USE_JACOBIAN_HELP)
    socket(group, "Geometry", "NodeSocketGeometry", output=True)


class BakedFields:
    """The fields as image sequences, in the files' axes."""

    def __init__(self, builder, inputs) -> None:
        self.b, self.inputs = builder, inputs
        b = builder
        time = b.node("GeometryNodeInputSceneTime").outputs["Frame"]
        frame = b.number("DIVIDE", time, inputs["Frame Length"])
        frame = b.number("MAXIMUM", frame, inputs["First"])
        frame = b.number("MINIMUM", frame, inputs["Last"])
        self.before = b.number("FLOOR", b.number("ADD", frame, _ALMOST))
        # On a frame this is the same one: nothing more is read.
        self.after = b.number("CEIL", b.number("SUBTRACT", frame, _ALMOST))
        self.fraction = b.number("MAXIMUM", b.number("SUBTRACT", frame, self.before), 0.0)

    def _self(self):
        whole = self.b.node("GeometryNodeObjectInfo")
        self.b.link(self.b.node("GeometryNodeSelfObject").outputs[0], whole.inputs["Object"])
        return whole

    def turn(self):
        return self.b.scale(self._self().outputs["Rotation"], self.inputs["Follow World"])

    def origin(self):
        b = self.b
        whole = self._self()
        # Only the place within a period counts, and in single precision it counts most near 0.
        place = b.math("MODULO", whole.outputs["Location"], self.inputs["Tile Size"])
        place = b.math("MULTIPLY", place, (1.0, 1.0, 0.0))
        return b.scale(place, self.inputs["Follow World"])

    def world_origin(self):
        place = self.b.math("MULTIPLY", self._self().outputs["Location"], (1.0, 1.0, 0.0))
        return self.b.scale(place, self.inputs["Follow World"])

    def half_texel(self):
        return self.inputs["Half Texel"]

    def read(self, name: str, place, interpolation: str):
        """The images before and after."""
        image, frames = self.inputs[name], (self.before, self.after)
        return (self.b.texture(image, place, interpolation, frame) for frame in frames)

    def from_file(self, color, alpha):
        """The vector, from the axes tnb: (x, z, y)."""
        x, z, y = self.b.parts(color)
        return self.b.color(x, y, z, alpha)

    def color(self, field: str, place, interpolation: str):
        mixed = self.b.mix(*self.read(field, place, interpolation), self.fraction)
        return self.from_file(mixed, self.lost_slopes())

    def far(self, field: str, place):
        images = self.read(ring_nodes.far_image(field), place, "Linear")
        if not self.has_alpha(field):
            return self.from_file(self.b.mix(*images, self.fraction), 1.0)
        mixed = self.b.mix_colors(*images, self.fraction)
        return self.from_file(mixed, self.b.alpha(mixed))

    def has_alpha(self, field: str) -> bool:
        """Returns whether the fourth component of a field holds the variance of the slopes left
        out."""
        return field == "Normal"

    def lost_slopes(self):
        return self.inputs["Slope Variance"]

    def wakes(self, _turn, _interpolation):
        return wake_nodes.NoWakes()

    def hulls(self, geometry):
        return geometry

    def cover_power(self):
        return self.inputs[COVER_POWER]

    def cover(self, _displacement, lookup):
        return self.b.parts(lookup.color("Cover"))[0]

    def jacobian(self, _velocity, lookup):
        baked = self.b.parts(lookup.color("Jacobian"))[0]
        return self.b.switch("FLOAT", self.inputs[USE_JACOBIAN], 1.0, baked)
