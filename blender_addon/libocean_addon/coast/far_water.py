# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The water around the map of a coast: still, and as rough to light as the waves of the sea, so
that the sea goes on to the horizon."""

from __future__ import annotations

import numpy as np

from ..shared import meshes
from ..terrain.extent import Extent

_FAR = 40e3
"""[m] from the map to the outer border."""
_SQUARES = (0, 1, 2, 4, 6, 8, 9, 10)
"""The first corners of the squares of 4 x 4 corners, without the one in the middle."""
_INNER = (5, 6, 10, 9)
"""The corners of the map among them, counter-clockwise."""
_SLOPE = np.array([[1.0, 1.0, -0.2], [-1.0, 1.0, -0.2], [-1.0, -1.0, -0.2], [1.0, -1.0, -0.2]])
"""The ways from them into the map and below it."""


def _vertices(extent: Extent, depth: float) -> np.ndarray:
    """Returns 4 x 4 corners, the inner ones those of the map, and eight of a slope below its
    border, which closes the gap where the waves there are low: four above, four at the depth."""
    low = np.array(extent.origin)
    high = low + extent.size
    east, north = np.stack([low - _FAR, low, high, high + _FAR], axis=1)
    corners = np.zeros((4, 4, 3), np.float32)
    corners[..., 0] = east[None, :]
    corners[..., 1] = north[:, None]
    level = corners.reshape(-1, 3)
    upper = level[list(_INNER)]
    return np.concatenate([level, upper, upper + 5.0 * depth * _SLOPE])


def follow(ob, extent: Extent, state: dict) -> None:
    """Has an object lie around the map, unless it does, is linked or being edited. extent: the
    samples of the map; state: of the sea."""
    if not meshes.is_ours(ob) or ob.mode != "OBJECT":
        return
    variance = state["mean_square_slope"]["resolved"]
    height = state["significant_wave_height"]["resolved"]

    def make(mesh) -> None:
        level = np.array(_SQUARES)[:, None] + np.array([0, 1, 5, 4])
        side = np.arange(4)
        after = (side + 1) % 4
        slope = np.stack([16 + side, 16 + after, 20 + after, 20 + side], axis=1)
        vertices = _vertices(extent, height)
        meshes.fill(mesh, vertices, np.concatenate([level, slope]))
        layer = mesh.attributes.new("slope_variance", "FLOAT", "POINT")
        layer.data.foreach_set("value", np.full(len(vertices), variance, np.float32))

    meshes.follow(ob, f"around {extent.origin} {extent.size} {variance!r} {height!r}", make)
