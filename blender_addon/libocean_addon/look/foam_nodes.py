# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Foam in detail, as nodes: the formulas of shaders/wave/foam_lace.glsl, and the net, bubbles and
streaks that POV-Ray's material (ocean.inc) makes of them, of the same sizes.

    label, textures -> T, uniform in 0 .. 1
    cover, T, footprint of a pixel -> mask, thickness, height, bubbles

The mean of the mask is the cover, near and far. Forms without a branch: a branch is a node too.
"""

from __future__ import annotations

import dataclasses

from ..shared.node_builder import Builder
from . import foam_images

TILE = 12.0
"""Metres of a tile of the net that the lengths below belong to."""
# m, and the widest cells: kFoamTextures of ocean/internal/foam_texture.hpp
_LACE_CELL = 0.86
_BUBBLE_TILE = 1.3
_BUBBLE_CELL = 0.041
_STREAK_TILE = 97.0
_STREAK_CELL = 14.0
_LARGER_BEGINS = 0.08
_BUBBLES = 0.3
_SWASH = 0.8  # the cover of the line where a swash ends, of waves of half a metre and more
_BEHIND = 0.3  # and of the foam behind it
_TIP = 0.012  # m, the depth of the sheet below which its foam opens
_LINE = 0.045  # m, the depth where the line ends
_SHEET = 0.15  # m, the depth where the foam behind it ends
_LEAST_SHARE = 1e-3  # the formula of the sum has none of 0; this one is not seen
_SPAN = 0.35  # foam lets no more water through where its cover is above T by this
_HEIGHT = 0.043  # m, where the cover is above T by 1: 15 mm for foam that is just thick

# The formulas -------------------------------------------------------------------


def add_uniform(b: Builder, a, other, share):
    """z = a + share other, made uniform: z - s / 2, and what the trapezoid's ends differ from it,
    (max(0, s - z)^2 - max(0, z - 1)^2) / 2 s."""
    z = b.number("MULTIPLY_ADD", other, share, a)
    low = b.number("MAXIMUM", b.number("SUBTRACT", share, z), 0.0)
    high = b.number("MAXIMUM", b.number("SUBTRACT", z, 1.0), 0.0)
    ends = b.number("SUBTRACT", b.number("MULTIPLY", low, low), b.number("MULTIPLY", high, high))
    ends = b.number("DIVIDE", ends, b.number("MULTIPLY", share, 2.0))
    return b.number("ADD", b.number("MULTIPLY_ADD", share, -0.5, z), ends)


def unite_uniform(b: Builder, a, other, begins):
    """Both patterns at once; `other` joins from the cover `begins` on."""
    z = b.number("MINIMUM", a, b.number("ADD", other, begins))
    joined = b.number("SUBTRACT", z, begins, clamp=True)
    return b.number("MULTIPLY_ADD", joined, b.number("SUBTRACT", 1.0, z), z)


def foam_mask(b: Builder, cover, value, edge):
    """Returns how white a point is. The middle of the ramp is c and, within half an edge of 0 and
    1, its shift: sqrt(2 e m) - e / 2 - m for m = min(c, e / 2), nothing at m = e / 2."""
    cover = b.number("ADD", cover, 0.0, clamp=True)
    half, twice = b.number("MULTIPLY", edge, 0.5), b.number("MULTIPLY", edge, 2.0)

    def moved(share):
        near = b.number("MINIMUM", share, half)
        root = b.number("SQRT", b.number("MULTIPLY", twice, near))
        return b.number("SUBTRACT", b.number("SUBTRACT", root, half), near)

    up, down = moved(cover), moved(b.number("SUBTRACT", 1.0, cover))
    middle = b.number("ADD", cover, b.number("SUBTRACT", up, down))
    above = b.number("DIVIDE", b.number("SUBTRACT", middle, value), edge)
    return b.number("ADD", above, 0.5, clamp=True)


def foam_thickness(b: Builder, cover, value, span):
    return b.number("DIVIDE", b.number("SUBTRACT", cover, value), span, clamp=True)


def foam_mean_thickness(b: Builder, cover, span):
    """(min(c, s) / s + 1 - s / max(c, s)) / 2."""
    thin = b.number("DIVIDE", b.number("MINIMUM", b.number("MAXIMUM", cover, 0.0), span), span)
    thick = b.number("DIVIDE", span, b.number("MAXIMUM", cover, span))
    return b.number("MULTIPLY_ADD", b.number("SUBTRACT", thin, thick), 0.5, 0.5)


def foam_fade(b: Builder, footprint, cell):
    """The share of foam_faded() that is the cover: 0 .. 1 from 0.1 to 1.5 cells a pixel."""
    return b.eased(0.1, 1.5, b.number("DIVIDE", footprint, cell))


def foam_faded(b: Builder, mask, cover, footprint, cell):
    return blend(b, mask, cover, foam_fade(b, footprint, cell))


def foam_pixel_edge(b: Builder, edge, footprint, cell):
    return b.number("MINIMUM", b.number("ADD", edge, b.number("DIVIDE", footprint, cell)), 1.0)


def foam_pixel_thickness(b: Builder, thickness, mean, footprint, cell):
    blurred = b.number("MULTIPLY", b.number("DIVIDE", footprint, cell), 2.5, clamp=True)
    return blend(b, thickness, mean, blurred)


def foam_in_streaks(b: Builder, cover, streaks, share):
    return blend(b, cover, foam_mask(b, cover, streaks, 1.0), share)


def foam_bubbles(b: Builder, driven, cover, value):
    return b.number("MAXIMUM", driven, foam_mask(b, cover, value, 1.0))


def foam_swash(b: Builder, depth, there, wave_height):
    """Returns the cover of the foam where the sheet of a swash ends: a line at its tip, thinner
    foam behind. there: 1 where a depth [m] is known, else 0."""
    high = b.number("MULTIPLY", wave_height, 2.0, clamp=True)
    high = b.number("MULTIPLY", high, there)
    line = b.number("SUBTRACT", 1.0, b.eased(_TIP, _LINE, depth))
    cover = b.number("MULTIPLY_ADD", line, _SWASH - _BEHIND, _BEHIND)
    cover = b.number("MULTIPLY", cover, b.number("SUBTRACT", 1.0, b.eased(0.0, _SHEET, depth)))
    return b.number("MULTIPLY", cover, high)


def foam_tip(b: Builder, depth, there):
    """Returns the share of its cover that foam has at the end of a sheet, where its lace opens: 0
    at a depth of 0, and 1 beyond the tip."""
    opened = b.number("SUBTRACT", b.eased(0.0, _TIP, depth), 1.0)
    return b.number("MULTIPLY_ADD", opened, there, 1.0)


def footprint(b: Builder, distance, pixel_angle, view_z):
    """Side in metres of the water that a pixel sees: slope_footprint of slope_tiles.glsl."""
    up = b.number("MAXIMUM", b.number("ABSOLUTE", view_z), 0.01)
    return b.number("DIVIDE", b.number("MULTIPLY", distance, pixel_angle), b.number("SQRT", up))


def blend(b: Builder, off, on, share):
    return b.number("MULTIPLY_ADD", b.number("SUBTRACT", on, off), share, off)


# The foam -----------------------------------------------------------------------


def _read(b: Builder, kind: str, along, across):
    """Returns the texture whose tile is repeated so often along and across: bilinear, of four
    texels. Far away Eevee's own filter would average many texels, and a threshold of the mean would
    show no foam."""
    return b.nested(f"foam {kind}", lambda b, *where: [_bilinear(b, kind, *where)], along, across)[
        0
    ]


def _bilinear(b: Builder, kind: str, along, across):
    texels = foam_images.SIDES[kind]
    place = b.math("MULTIPLY_ADD", b.vector(along, across, 0.0), (texels,) * 3, (-0.5, -0.5, 0.0))
    first = b.math("FLOOR", place)
    share_x, share_y, _ = b.parts(b.math("SUBTRACT", place, first))

    def texel(x: int, y: int):
        made = b.node("ShaderNodeTexImage", image=foam_images.get(kind), interpolation="Closest")
        middle = ((0.5 + x) / texels, (0.5 + y) / texels, 0.0)
        place = b.math("MULTIPLY_ADD", first, (1.0 / texels,) * 3, middle)
        b.link(place, made.inputs["Vector"])
        return made.outputs["Color"]

    low, high = (b.mix(texel(0, y), texel(1, y), share_x) for y in (0, 1))
    # A colour would become a number by its luminance.
    return b.parts(b.mix(low, high, share_y))[0]


def _net(b: Builder, u, v):
    """The net twice, the second one 3.5 times as large and turned by atan(1/3), so that no tile is
    seen to repeat: 11 tiles are the period of both."""
    larger = (
        b.number("MULTIPLY", b.number("MULTIPLY_ADD", u, 3.0, v), 1.0 / 11.0),
        b.number("MULTIPLY", b.number("SUBTRACT", b.number("MULTIPLY", v, 3.0), u), 1.0 / 11.0),
    )
    return unite_uniform(b, _read(b, "lace", *larger), _read(b, "lace", u, v), _LARGER_BEGINS)


def _textures(b: Builder, place, inputs, bubbled):
    """T, uniform in 0 .. 1, at a place in metres, what the net alone has of it, and the streaks."""
    x, y, _ = b.parts(place)
    wind = b.number("RADIANS", inputs["Wind Direction"])
    cosine, sine = b.number("COSINE", wind), b.number("SINE", wind)
    tile = b.number("MAXIMUM", inputs["Foam Tile"], 1e-3)
    u = b.number("MULTIPLY_ADD", x, cosine, b.number("MULTIPLY", y, sine))
    v = b.number("SUBTRACT", b.number("MULTIPLY", y, cosine), b.number("MULTIPLY", x, sine))
    u, v = b.number("DIVIDE", u, tile), b.number("DIVIDE", v, tile)
    net = _net(b, b.number("DIVIDE", u, b.number("MAXIMUM", inputs["Foam Stretch"], 1e-3)), v)

    def read(kind: str, tile: float):
        often = TILE / tile
        return _read(b, kind, b.number("MULTIPLY", u, often), b.number("MULTIPLY", v, often))

    def with_(value, other, share):
        return add_uniform(b, value, other, b.number("MAXIMUM", share, _LEAST_SHARE))

    bubbly = with_(net, read("bubbles", _BUBBLE_TILE), bubbled)
    streaks = read("streaks", _STREAK_TILE)
    return with_(bubbly, streaks, inputs["Foam Streaks"]), net, streaks


@dataclasses.dataclass(frozen=True)
class Foam:
    """Sockets, and what is where."""

    mask: object
    """The whiteness, 0 .. 1."""
    thickness: object
    """The thickness of white foam: 0, thin, .. 1."""
    height: object
    """m"""
    bubbles: object
    """The amount under the surface, 0 .. 1."""


def foam(b: Builder, cover, driven, place, footprint, inputs) -> Foam:
    """cover, driven: the foam and the bubbles that breakers drove down, 0 .. 1; place, footprint:
    metres."""
    size = b.number("MULTIPLY", inputs["Foam Tile"], 1.0 / TILE)
    pixels = b.number("DIVIDE", footprint, b.number("MAXIMUM", size, 1e-3 / TILE))
    far = foam_fade(b, pixels, _LACE_CELL)
    # Any share of bubbles is uniform, so that none needs to be seen far off.
    bubbles_far = foam_fade(b, pixels, _BUBBLE_CELL)
    bubbled = b.number("MULTIPLY_ADD", bubbles_far, -_BUBBLES, _BUBBLES)
    value, net, streaks = _textures(b, place, inputs, bubbled)
    edge = foam_pixel_edge(b, b.number("MAXIMUM", inputs["Foam Edge"], 1e-3), pixels, _LACE_CELL)
    mask = foam_mask(b, cover, value, edge)
    streaks_far = foam_fade(b, pixels, _STREAK_CELL)
    share = b.number("MULTIPLY", inputs["Foam Streaks"], b.number("SUBTRACT", 1.0, streaks_far))
    mean = foam_in_streaks(b, cover, streaks, share)
    here, mean_thick = foam_thickness(b, cover, value, _SPAN), foam_mean_thickness(b, cover, _SPAN)
    # Bubbles would be as high as they are wide, and cost as much again for each of three heights.
    height = foam_thickness(b, cover, net, 1.0)
    height = b.number("MULTIPLY", height, b.number("MULTIPLY", size, _HEIGHT))
    return Foam(
        mask=blend(b, mask, mean, far),
        thickness=foam_pixel_thickness(b, here, mean_thick, pixels, _LACE_CELL),
        height=b.number("MULTIPLY", height, b.number("SUBTRACT", 1.0, far)),
        bubbles=blend(
            b, foam_bubbles(b, driven, cover, value), b.number("MAXIMUM", driven, mean), far
        ),
    )
