# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Slope tiles of the waves too short for a map, as a material and a bake know them. No Blender in
here: a bake runs in a thread of its own.

    `Sea.detail` of a frame -> bands -> group of the material (detail.py), files (bake_job.py)
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

SAMPLES = 512  # a side of a tile
MOST_BANDS = 3  # of the library


class Band(NamedTuple):
    """What is known of a tile beside its slopes."""

    tile: float
    """Its side and period, metres."""
    longest_wave: float
    shortest_wave: float
    mean_square: float
    """Of the slopes, as they are read."""


def band_of(found) -> Band:
    """found: libocean.DetailBand of a frame."""
    mean_square = read_mean_square(found.slope)
    return Band(found.tile, found.longest_wave, found.shortest_wave, mean_square)


def read_mean_square(slope: np.ndarray) -> float:
    """What bilinear reads have of samples (n, n, 2): (2, 1) / 3 along each side of their covariance
    at lags 0 and 1. The shortest waves are five texels long: 3 % less than the samples; these are
    one draw of the waves, whose variance is the spectrum's to some percent."""

    def lag(i: int, j: int) -> float:
        return float(np.vdot(slope, np.roll(slope, (j, i), (0, 1))))

    along = 2.0 * (lag(1, 0) + lag(0, 1)) + 0.5 * (lag(1, 1) + lag(1, -1))
    return (4.0 * lag(0, 0) + along) / 9.0 / (slope.size / 2)
