# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Slope tiles of the waves too short for a map, as a material and a bake know them. No Blender in
here: a bake runs in a thread of its own.

    `Sea.detail` of a frame -> bands -> group of the material (detail.py), files (bake_job.py)
"""

from __future__ import annotations

from typing import NamedTuple

SAMPLES = 512  # a side of a tile
MOST_BANDS = 3  # of the library


class Band(NamedTuple):
    """A tile without its slopes."""

    tile: float
    """Its side and period [m]."""
    longest_wave: float
    shortest_wave: float
    mean_square: float
    """The mean square of the slopes, as a bilinear reader finds them."""


def lost_slopes(found) -> float:
    """Returns the mean square slope of all waves that the map beside a libocean.Detail lacks."""
    return found.residual + sum(band.variance_x + band.variance_y for band in found.bands)


def band_of(found) -> Band:
    """Returns the band of a libocean.DetailBand."""
    return Band(found.tile, found.longest_wave, found.shortest_wave, found.mean_square)
