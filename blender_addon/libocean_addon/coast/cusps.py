# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cusps of a beach: low horns and bays that swash leaves in sand, which are finer than the samples
of a bed. The water ends in lobes on them, and each wave, which reaches another height, in others.

    sea, slope of the beach -> swash -> spacing -> height over the bed and its slope at vertices

The spacing follows the swash, and the height follows spacing and slope, so that lobes are as deep
on a flat beach as on a steep one. No Blender's data in here.
"""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from .shore_mesh import Grid, steady_height

_GRAVITY = 9.81
_SPACING = 1.63
"""The spacing of cusps, in widths of the swash [Coco 1999]."""
_PROMINENCE = 0.2
"""The height of horns over bays, in spacings times the slope of the beach. [Masselink 1998] have
cusps that swash keeps where prominence times (swash / spacing)^2 is .015 to .15: .04 to .4 here."""
_SLOPES = (0.02, 0.14)
"""The beaches for which swash was measured, as kFlattestBeach of coast/surface/swash.hpp."""
_HIGHEST = 0.07
"""[m] The deviation of the highest cusps: their bays lie less deep than the water goes on below the
land, clip_depth. Higher ones are as wide as samples of a bed and belong to it."""
_NO_BEACH = 0.25
"""The slope from which ground has no cusps."""
_SAMPLES = 128
"""The samples along a side by which the slope of the beaches is known."""
_WAVES = 24
_SHARES = (0.25, 1.2)
"""The wavelengths of the relief, in spacings: all sizes between, the height as the length."""
_STEP = 2.0**-11
"""[m] Heights are multiples of it: a file holds them in half of the bytes."""


def swash_width(state: dict, slope: float) -> float:
    """Returns the distance between the ends of run-up and of backwash [m] of a sea in that state:
    the significant swash over the slope, sqrt(H0 L0 (0.563 slope^2 + 0.004)) [Stockdon 2006] eq.
    11 and 12."""
    height = state["significant_wave_height"]["resolved"]
    period = state["peak_period"]["resolved"]
    length = _GRAVITY * period * period / (2.0 * math.pi)
    return math.sqrt(height * length * (0.563 * slope * slope + 0.004)) / slope


@dataclasses.dataclass(frozen=True)
class Cusps:
    """The cusps of a beach."""

    spacing: float
    """[m]"""

    @staticmethod
    def of(grid: Grid, state: dict) -> Cusps | None:
        """Returns the cusps of a coast in that state; None of a grid that is too coarse for them
        and of one whose bed is unknown."""
        if grid.bed is None or grid.ratio == 1:
            return None
        step = grid.extent.step_for(_SAMPLES)  # each frame asks
        heights, normals = (field[::step, ::step] for field in (grid.bed.heights, grid.bed.normals))
        low, high = grid.band
        slopes = _slope_of(normals[(heights > low) & (heights < high)])
        slopes = slopes[slopes < _NO_BEACH]
        if not len(slopes):
            return None
        slope = float(np.clip(np.median(slopes), *_SLOPES))
        return Cusps(steady_height(_SPACING * swash_width(state, slope)))

    @property
    def words(self) -> str:
        """Returns the words for what the cusps of a mesh were made of."""
        return f" cusps {self.spacing!r}"

    def at(self, grid: Grid) -> tuple[np.ndarray, np.ndarray]:
        """Returns the heights of the cusps at all vertices of a grid, (n,) [m], 0 where it is
        coarse, and their slopes, (n, 2)."""
        bed, places = grid.read(grid.bed.heights), grid.places[:, :2]
        slope = _slope_of(grid.read(grid.bed.normals))
        low, high = grid.band
        share = _eased(low, 0.5 * low, bed) * (1.0 - _eased(0.6 * high, high, bed))
        share *= 1.0 - _eased(_SLOPES[1], _NO_BEACH, slope)
        is_there = share > 0.0
        size = np.clip(slope, *_SLOPES) * _PROMINENCE * self.spacing / math.sqrt(8.0)
        size = share * np.minimum(size, _HIGHEST)
        heights, slopes = np.zeros(len(places)), np.zeros((len(places), 2))
        found = self._relief(places[is_there])
        heights[is_there] = np.rint(size[is_there] * found[0] / _STEP) * _STEP
        slopes[is_there] = size[is_there, None] * found[1]
        return heights, slopes

    def _relief(self, places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Returns a field of deviation 1 and its slopes [1/m]. Numbers from the golden ratio and
        roots spread directions and phases: the relief of all files is the same."""
        heights, slopes = np.zeros(len(places)), np.zeros((len(places), 2))
        first, last = _SHARES
        shares = first * (last / first) ** ((np.arange(_WAVES) + 0.5) / _WAVES)
        weights = shares * math.sqrt(2.0) / math.sqrt(float((shares**2).sum()))
        for number, (share, weight) in enumerate(zip(shares, weights, strict=True)):
            angle = 2.0 * math.pi * (number * 0.6180339887498949 % 1.0)
            phase = 2.0 * math.pi * (number * 1.4142135623730951 % 1.0)
            way = np.array([math.cos(angle), math.sin(angle)]) * 2.0 * math.pi
            way /= share * self.spacing
            turn = places @ way + phase
            heights += weight * np.cos(turn)
            slopes -= weight * np.sin(turn)[:, None] * way
        return heights, slopes


def _slope_of(normals: np.ndarray) -> np.ndarray:
    """Returns the rise over run of ground with these normals, (..., 3)."""
    return np.hypot(normals[..., 0], normals[..., 1]) / np.maximum(normals[..., 2], 1e-3)


def _eased(low: float, high: float, value: np.ndarray) -> np.ndarray:
    share = np.clip((value - low) / (high - low), 0.0, 1.0)
    return share * share * (3.0 - 2.0 * share)
