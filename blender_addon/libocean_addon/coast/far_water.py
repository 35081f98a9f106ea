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


def _vertices(extent: Extent) -> np.ndarray:
    """Returns 4 x 4 corners, the inner ones those of the map."""
    low = np.array(extent.origin)
    high = low + extent.size
    east, north = np.stack([low - _FAR, low, high, high + _FAR], axis=1)
    corners = np.zeros((4, 4, 3), np.float32)
    corners[..., 0] = east[None, :]
    corners[..., 1] = north[:, None]
    return corners.reshape(-1, 3)


def follow(ob, extent: Extent, state: dict) -> None:
    """Has an object lie around the map, unless it does, is linked or being edited. extent: the
    samples of the map; state: of the sea."""
    if not meshes.is_ours(ob) or ob.mode != "OBJECT":
        return
    variance = state["mean_square_slope"]["resolved"]

    def make(mesh) -> None:
        first = np.array(_SQUARES)[:, None]
        meshes.fill(mesh, _vertices(extent), first + np.array([0, 1, 5, 4]))
        layer = mesh.attributes.new("slope_variance", "FLOAT", "POINT")
        layer.data.foreach_set("value", np.full(16, variance, np.float32))

    meshes.follow(ob, f"around {extent.origin} {extent.size} {variance!r}", make)
