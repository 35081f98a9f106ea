# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The relief of the covers of land, as nodes: stones, tufts, crowns and drifts that no mesh has.

place -> grain of five wavelengths, each left out where a pixel holds it -> edges of covers
grain, steepness of the cover -> normal, and less light in the hollows
waves of the land that a mesh around the camera lacks at its distance -> normal
"""

from __future__ import annotations

from ..look import pixel_angle, water_shader
from ..look.foam_nodes import blend
from ..shared.shader_builder import Tree

WAVELENGTHS = (16.0, 4.0, 1.0, 0.25, 0.0625)
"""[m] Of the grain. This rule and its numbers are those of shaders/preview/ground_relief.glsl."""
_FADE = (0.3, 0.9)
"""The pixels of a wavelength, inverted, between which it fades."""
STEEPNESS = {
    "Grass": (0.08, 0.22, 0.40, 0.0),
    "Dry Grass": (0.08, 0.22, 0.40, 0.0),
    "Forest": (0.30, 0.30, 0.20, 0.0),
    "Scree": (0.20, 0.30, 0.36, 1.0),
    "Rock": (0.25, 0.40, 0.40, 0.0),
    "Snow": (0.08, 0.05, 0.04, 0.0),
    "Sand": (0.02, 0.02, 0.04, 0.0),
}
"""Slopes of the relief of each cover: of the two longest waves, of that of 1 m, and of the two
shortest; and the share of its waves that are stones, round above clefts."""
NUMBERS = (
    (
        "Relief",
        1.0,
        0.0,
        10.0,
        "Steepness of stones, tufts, crowns and drifts near the eye; 0: none",
    ),
    (
        "Pixel Angle",
        pixel_angle.DEFAULT,
        0.0,
        1.0,
        "Angle of a pixel of the picture, in radians: finer relief is left out. 0: never",
    ),
    (
        "Land Slope",
        0.0,
        0.0,
        10.0,
        "Slope of each wave of the land itself, of 64, 16 and 4 m, where the mesh is too coarse "
        "for it",
    ),
    (
        "Mesh Angle",
        0.0,
        0.0,
        1.0,
        "Cell of the mesh over its distance to the camera; 0: it has all waves of the land",
    ),
)
_LONGEST = 64.0
"""[m] Of the waves of the land."""
_LACKS = (0.2, 0.5)
"""The cells of a wavelength, inverted, between which the mesh loses it."""
_SLOPE = 1.7
"""The deviation of the slope of grain of steepness 1 along an axis."""
_STEP = 0.15
"""The wavelengths between two places whose difference is a slope."""
_CONTRAST = 4.8  # Blender's noise has a deviation of about 0.13 around 0.5
_BREAKS = (0.30, 0.30, 0.25, 0.15, 0.10)
"""How much each wavelength moves the edges of covers, in shares of a cover."""
_DARK = 0.7
"""The light that hollows lack, in slopes of the relief."""
_UNEVEN = 0.8
"""How much a noise of the ground makes relief stronger: of equal strength it would look woven."""
_CLEFT = 0.6
"""How much the next longer wave moves the clefts between stones, which would lie in rows else."""
_ROUND = 1.6
"""The slope of stones, in slopes of the grain."""
_STRAW = 0.45
"""The share of dry grass in the driest grass."""


def _wave(t: Tree, place, along, across, side, length) -> list:
    """Returns the grain of a wavelength, about -1 .. 1, and its slopes along two directions. side:
    of a pixel on the ground [m]."""
    inverse = t.number("DIVIDE", 1.0, length)
    at = t.scale(place, inverse)

    def read(where):
        made = t.node("ShaderNodeTexNoise")
        t.feed(where, made.inputs["Vector"])
        made.inputs["Scale"].default_value = 1.0
        made.inputs["Detail"].default_value = 0.0
        return made.outputs["Fac"]

    here = read(at)
    wave = t.number("SUBTRACT", 1.0, t.eased(*_FADE, t.number("MULTIPLY", side, inverse)))
    wave = t.number("MULTIPLY", wave, _CONTRAST)
    results = [t.number("MULTIPLY", t.number("SUBTRACT", here, 0.5), wave)]
    for way in (along, across):
        beside = read(t.math("ADD", at, t.scale(way, _STEP)))
        slope = t.number("DIVIDE", t.number("SUBTRACT", beside, here), _STEP)
        results.append(t.number("MULTIPLY", slope, wave))
    return results


def _stones(t: Tree, value, along, across, before, share) -> list:
    """Returns the grain of a wavelength and its slopes where a share of it is stones. before: the
    value of the next longer wave."""
    cleft = t.number("MULTIPLY_ADD", before, _CLEFT, value)
    facing = t.number("MULTIPLY", t.number("SIGN", cleft), _ROUND)
    slope = blend(t, 1.0, facing, share)
    return [value, *(t.number("MULTIPLY", part, slope) for part in (along, across))]


class Grain:
    """The grain at a place, in a group with the inputs NUMBERS. normal: of the land; noise: longer
    than the grain, about -1 .. 1, which makes it stronger and weaker."""

    def __init__(self, t: Tree, inputs, normal, noise) -> None:
        self.normal = normal
        uneven = t.number("MULTIPLY_ADD", noise, _UNEVEN, 0.9)
        uneven = t.number("MINIMUM", t.number("MAXIMUM", uneven, 0.25), 1.6)
        self.amount = t.number("MULTIPLY", inputs["Relief"], uneven)
        self.along = t.math("NORMALIZE", t.math("CROSS_PRODUCT", (0.0, 1.0, 0.0), normal))
        self.across = t.math("CROSS_PRODUCT", normal, self.along)
        place = t.node("ShaderNodeTexCoord").outputs["Object"]
        self.side = water_shader.footprint(t, inputs["Pixel Angle"])
        self.waves = []
        for length in (_LONGEST, *WAVELENGTHS):
            value = t.node("ShaderNodeValue").outputs[0]
            value.default_value = length
            given = (place, self.along, self.across, self.side, value)
            self.waves.append(t.nested("ground grain", _wave, *given))
        self.longest = self.waves.pop(0)
        distance = t.node("ShaderNodeCameraData").outputs["View Distance"]
        cell = t.number("MULTIPLY", distance, inputs["Mesh Angle"])
        slope = t.number("MULTIPLY", inputs["Land Slope"], 1.0 / _SLOPE)
        self.of_land = [
            t.number("MULTIPLY", slope, t.eased(*(share * length for share in _LACKS), cell))
            for length in (_LONGEST, *WAVELENGTHS[:2])
        ]
        """The steepness of each wave of the land that the mesh lacks."""
        self.moves = t.number("MULTIPLY", self._sum(t, 0, _BREAKS), self.amount)
        finest = t.number("DIVIDE", self.side, WAVELENGTHS[1])
        seen = t.number("SUBTRACT", 1.0, t.eased(*_FADE, finest))
        self.seen = t.number("MULTIPLY", seen, self.amount, clamp=True)

    def _sum(self, t: Tree, part: int, weights, waves=None):
        """Returns the sum of a part of all waves. weights: one for each wavelength; waves: others
        than the grain's."""
        total = 0.0
        for wave, weight in zip(waves or self.waves, weights, strict=True):
            total = t.number("MULTIPLY_ADD", wave[part], weight, total)
        return total

    def straw(self, t: Tree):
        """Returns the share of dry grass among the other grass."""
        return t.number("MULTIPLY", t.eased(0.0, 0.8, self.moves), _STRAW)

    def broken(self, t: Tree, share):
        """Returns the share of a cover whose edge follows the grain: where there is none of it, or
        nothing else, it stays so."""

        def make(t: Tree, share, moves, seen) -> list:
            other = t.number("SUBTRACT", 1.0, share)
            free = t.number("MULTIPLY", t.number("MULTIPLY", share, other), 4.0)
            moved = t.number("MULTIPLY_ADD", free, moves, share)
            sharp = t.eased(0.25, 0.75, moved)
            change = t.number("SUBTRACT", sharp, share)
            return [t.number("MULTIPLY_ADD", change, seen, share)]

        return t.nested("ground edge", make, share, self.moves, self.seen)[0]

    def relief(self, t: Tree, colour, steepness, stones) -> tuple:
        """Returns the colour in the light that its hollows have, and the normal of the relief.
        steepness, stones: as of STEEPNESS."""
        before = [[t.node("ShaderNodeValue").outputs[0]], *self.waves]
        before[0][0].default_value = 0.0
        waves = [
            t.nested("ground stones", _stones, *wave, longer[0], stones)
            for wave, longer in zip(self.waves, before, strict=False)
        ]
        coarse, middle, fine = t.parts(t.scale(steepness, self.amount))
        weights = (coarse, coarse, middle, fine, fine)
        light = t.number("MULTIPLY_ADD", self._sum(t, 0, weights, waves), _DARK, 1.0)
        light = t.number("MINIMUM", t.number("MAXIMUM", light, 0.25), 1.75)
        own = [t.number("ADD", coarse, land) for land in self.of_land[1:]]
        weights = (self.of_land[0], *own, *weights[2:])
        slopes = [self._sum(t, part, weights, [self.longest, *waves]) for part in (1, 2)]
        tilt = t.math("ADD", t.scale(self.along, slopes[0]), t.scale(self.across, slopes[1]))
        return t.scale(colour, light), t.math("NORMALIZE", t.math("SUBTRACT", self.normal, tilt))
