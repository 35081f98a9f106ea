# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The grid of water and land: finer where they meet. A cell beside finer ones is a fan of triangles
that has their corners, so that no gap opens wherever a field moves the vertices.

    extent, bed, band of heights -> fine cells -> Grid: places, faces -> meshes of water and land
"""

from __future__ import annotations

import dataclasses
import math
from functools import cached_property

import numpy as np

from ..shared import meshes
from ..terrain.extent import Extent
from .coast_job import Bed

_FINE = 1.0
"""[m] The max cell where water and land meet."""
_MAX_RATIO = 8
_BAND = (-0.3, 0.6)
"""The heights of the bed that waves may uncover and cover, as shares of their height."""
DRY_SAND = 1.0
"""[m] of sand above the heights that waves cover."""
_STEEP = 0.5
"""[m] A cell that rises by more is fine up to the end of the sand too, which ends within it."""


def steady_height(wave_height: float) -> float:
    """Returns a power of the root of 2 above a height [m], which stays while that glides."""
    return 2.0 ** (math.ceil(2.0 * math.log2(max(wave_height, 1e-3))) / 2.0)


@dataclasses.dataclass(frozen=True)
class Grid:
    """The samples of an extent as vertices, and further ones where it is finer."""

    extent: Extent
    bed: Bed | None
    """The bed on the samples; None before it is known."""
    wave_height: float = 0.0
    """[m] The grid is finer where waves of this height wet the bed; 0: nowhere."""

    @property
    def ratio(self) -> int:
        """Returns the fine cells along a side of the cell that they lie in; 1: there are none."""
        ratio = 1
        if self.bed is not None and self.wave_height > 0.0:
            while self.extent.cell / ratio > _FINE and ratio < _MAX_RATIO:
                ratio *= 2
        return ratio

    @property
    def fine_words(self) -> str:
        """Returns the words for the fine cells; "" without any."""
        if self.ratio == 1:
            return ""
        return f" fine {self.ratio} {self.wave_height!r} {self.bed.mark}"

    @property
    def band(self) -> tuple[float, float]:
        """Returns the heights of the bed that waves may uncover and cover [m]."""
        low, high = np.multiply(_BAND, self.wave_height)
        return float(low), float(high)

    @cached_property
    def _fine(self) -> np.ndarray:
        """Returns the columns and rows of the fine cells, (2, n)."""
        heights = self.bed.heights
        corners = np.stack([heights[:-1, :-1], heights[:-1, 1:], heights[1:, :-1], heights[1:, 1:]])
        lowest, highest = corners.min(axis=0), corners.max(axis=0)
        low, high = self.band
        high = np.where(highest - lowest > _STEEP, high + DRY_SAND, high)
        rows, columns = np.nonzero((lowest < high) & (highest > low))
        return np.stack([columns, rows])

    @cached_property
    def _parts(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Returns the places of all vertices in samples, (n, 2), the quads and the triangles."""
        columns, rows = self.extent.samples
        samples = np.stack(np.meshgrid(np.arange(columns), np.arange(rows)), axis=-1)
        samples = samples.reshape(-1, 2)
        quads = meshes.grid_faces(columns - 1, rows - 1)
        if self.ratio == 1:
            return samples, quads, np.empty((0, 3), int)
        ratio, (i, j) = self.ratio, self._fine
        step = np.arange(ratio + 1)
        x = i[:, None, None] * ratio + step[None, None, :]
        y = j[:, None, None] * ratio + step[None, :, None]
        keys = y * ((columns - 1) * ratio + 1) + x
        unique, first, inverse = np.unique(keys, return_index=True, return_inverse=True)
        x, y = (np.broadcast_to(part, keys.shape).ravel()[first] for part in (x, y))
        is_new = (x % ratio != 0) | (y % ratio != 0)
        number = np.where(is_new, len(samples) + np.cumsum(is_new) - 1, 0)
        number[~is_new] = (y // ratio * columns + x // ratio)[~is_new]
        number = number[inverse.reshape(keys.shape)]
        new = np.stack([x, y], axis=1)[is_new] / ratio
        is_fine = np.zeros(self.extent.shape, bool)  # by the cell's first corner
        is_fine[j, i] = True
        fans, middles, is_fan = self._fans(is_fine, number, len(samples) + len(new))
        is_coarse = ~(is_fine | is_fan)[:-1, :-1].ravel()
        fine = [number[:, :-1, :-1], number[:, :-1, 1:], number[:, 1:, 1:], number[:, 1:, :-1]]
        fine = np.stack([corner.ravel() for corner in fine], axis=1)
        return (
            np.concatenate([samples, new, middles]),
            np.concatenate([quads[is_coarse], fine]),
            fans,
        )

    def _fans(self, is_fine: np.ndarray, number: np.ndarray, count: int):
        """Returns the triangles of the cells beside fine ones, the places of the middles of those,
        whose numbers begin at `count`, and where the cells are. number: of the vertices of each
        fine cell."""
        rows, columns = is_fine.shape
        of_fine = np.zeros((rows + 1, columns + 1), int)  # a cell's number + 1, a border around
        of_fine[1:, 1:][is_fine] = np.arange(len(number)) + 1
        inside = of_fine[1:rows, 1:columns]
        # South, east, north and west of a cell: the side of that neighbour, counter-clockwise.
        beside = (
            (of_fine[: rows - 1, 1:columns], (-1, slice(None))),
            (of_fine[1:rows, 2 : columns + 1], (slice(None), 0)),
            (of_fine[2 : rows + 1, 1:columns], (0, slice(None, None, -1))),
            (of_fine[1:rows, : columns - 1], (slice(None, None, -1), -1)),
        )
        has = np.stack([neighbour > 0 for neighbour, _ in beside])
        is_fan = (inside == 0) & has.any(axis=0)
        kinds = np.tensordot((1, 2, 4, 8), has, 1)
        triangles, middles = [np.empty((0, 3), int)], [np.empty((0, 2))]
        for kind in np.unique(kinds[is_fan]):
            j, i = np.nonzero(is_fan & (kinds == kind))
            first = j * columns + i
            corners = (first, first + 1, first + columns + 1, first + columns)
            around = []
            for side, (neighbour, cut) in enumerate(beside):
                around.append(corners[side][:, None])
                if kind & 1 << side:
                    around.append(number[neighbour[j, i] - 1][(slice(None), *cut)][:, 1:-1])
            around = np.concatenate(around, axis=1)
            middle = np.broadcast_to(count + np.arange(len(first))[:, None], around.shape)
            fan = np.stack([middle, around, np.roll(around, -1, axis=1)], axis=-1)
            triangles.append(fan.reshape(-1, 3))
            middles.append(np.stack([i, j], axis=1) + 0.5)
            count += len(first)
        whole = np.zeros_like(is_fine)
        whole[:-1, :-1] = is_fan
        return np.concatenate(triangles), np.concatenate(middles), whole

    @property
    def places(self) -> np.ndarray:
        """Returns the vertices at level 0, (n, 3) [m], those of the samples first."""
        samples = self._parts[0]
        level = np.zeros((len(samples), 3))
        level[:, :2] = np.multiply(samples, self.extent.cell) + self.extent.origin
        return level

    @property
    def faces(self) -> tuple[np.ndarray, ...]:
        return self._parts[1:]

    def read(self, field: np.ndarray) -> np.ndarray:
        """Returns numbers or vectors on the samples, (rows, columns, ...), at all vertices, (n,
        ...), linear between the samples."""
        rows, columns = self.extent.shape
        flat = field.reshape(rows * columns, -1)
        x, y = self._parts[0][len(flat) :].T
        i, j = (np.minimum(at.astype(int), last - 2) for at, last in ((x, columns), (y, rows)))
        s, t = ((at - n)[:, None] for at, n in ((x, i), (y, j)))
        first = j * columns + i
        south = (1.0 - s) * flat[first] + s * flat[first + 1]
        north = (1.0 - s) * flat[first + columns] + s * flat[first + columns + 1]
        further = (1.0 - t) * south + t * north
        return np.concatenate([flat, further.astype(flat.dtype)]).reshape(-1, *field.shape[2:])
