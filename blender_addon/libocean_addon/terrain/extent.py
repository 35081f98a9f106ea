# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Extents: where the samples of a map lie on a land.

the terrain's own domain, or a region of the settings -> Extent -> map, mesh, inputs of the nodes
"""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from ..shared.compat import tr_label
from ..shared.failures import NotShownError

MAX_VERTICES = 4096 * 4096
"""The max number of samples, and so of vertices, of a region."""
_ENDLESS = 1e9  # periods: more than a mesh has
_SLACK = 1e-6  # of a cell: rounding error of a division


class ExtentError(NotShownError):
    """A region that cannot be shown, in a sentence for the user."""


@dataclasses.dataclass(frozen=True)
class Extent:
    """A rectangle of samples, x east and y north [m]."""

    origin: tuple[float, float]
    """The place of sample (0, 0)."""
    cell: float
    samples: tuple[int, int]
    """Columns and rows."""
    wraps: bool
    """True for the map of a whole tile, which repeats."""
    is_own: bool = True
    """False for a region that the settings name."""

    @property
    def shape(self) -> tuple[int, int]:
        """Returns rows and columns."""
        return self.samples[1], self.samples[0]

    @property
    def count(self) -> int:
        return self.samples[0] * self.samples[1]

    @property
    def map_size(self) -> tuple[float, float]:
        """Returns the sides of all texels together [m]."""
        return self.cell * self.samples[0], self.cell * self.samples[1]

    @property
    def size(self) -> tuple[float, float]:
        """Returns the sides of the land that the samples cover [m]."""
        less = 0 if self.wraps else 1
        return self.cell * (self.samples[0] - less), self.cell * (self.samples[1] - less)

    def inputs(self, place: tuple[float, float] = (0.0, 0.0)) -> dict:
        """Returns the inputs by which a node group finds a place on maps of these samples. place:
        of the object in the world, where it counts [m]."""
        half = tuple(0.5 / count for count in self.samples)
        size = self.map_size
        if self.wraps:
            # Only the place within a tile counts, and in single precision it counts most near 0.
            origin = tuple(part % period for part, period in zip(place, size, strict=True))
            low, high = (-_ENDLESS,) * 2, (_ENDLESS,) * 2
        else:
            origin = tuple(part - first for part, first in zip(place, self.origin, strict=True))
            low, high = half, tuple(1.0 - part for part in half)
        return {
            "Map Size": (*size, 1.0),
            "Half Texels": (*half, 0.0),
            "Low": (*low, 0.0),
            "High": (*high, 0.0),
            "Origin": (*origin, 0.0),
            # A linked node group of an earlier version reads these.
            "Tile Size": size[0],
            "Half Texel": half[0],
        }

    def coarser(self, step: int) -> Extent:
        """Returns the same rectangle with every step-th sample; the last ones may be left out."""
        samples = tuple(max(2, (count - 1) // step + 1) for count in self.samples)
        return dataclasses.replace(self, cell=self.cell * step, samples=samples)

    def along(self, axis: int, step: int = 1) -> np.ndarray:
        """Returns the coordinate of every step-th sample of an axis, and of the last one [m]."""
        last = self.samples[axis] - 1
        numbers = np.append(np.arange(0, last, step), last)
        return self.origin[axis] + numbers * self.cell

    def step_for(self, most: int) -> int:
        """Returns the step at which the longer side has at most so many cells."""
        return max(1, math.ceil((max(self.samples) - 1) / most))


def of_region(corners: tuple[float, ...], cell: float, own: Extent) -> Extent:
    """Returns the extent of a region (x0, y0, x1, y1) [m]. Raises ExtentError for one that is
    empty, has too many samples or reaches beyond a land that exists once."""
    x0, y0, x1, y1 = corners
    if x1 - x0 < cell or y1 - y0 < cell:
        raise ExtentError(tr_label("The region is smaller than its cell of {:g} m", cell))
    samples = tuple(int((high - low) / cell + _SLACK) + 1 for low, high in ((x0, x1), (y0, y1)))
    if samples[0] * samples[1] > MAX_VERTICES:
        raise ExtentError(
            tr_label(
                "The region has {:,} x {:,} vertices; allowed: {:,} together",
                *samples,
                MAX_VERTICES,
            )
        )
    if not own.wraps:
        sides = [(own.origin[axis], own.origin[axis] + own.size[axis]) for axis in range(2)]
        slack = _SLACK * max(own.size)
        for low, high, (first, last) in ((x0, x1, sides[0]), (y0, y1, sides[1])):
            if low < first - slack or high > last + slack:
                raise ExtentError(
                    tr_label(
                        "The region reaches beyond the land, which lies from {:g} to {:g} m east "
                        "and from {:g} to {:g} m north",
                        *sides[0],
                        *sides[1],
                    )
                )
    return Extent((x0, y0), cell, samples, wraps=False, is_own=False)
