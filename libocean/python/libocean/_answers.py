# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The values that a Sea and a Terrain return beside maps, and the arrays that they arrive in."""

from __future__ import annotations

import ctypes
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _abi

Array = npt.NDArray[np.float32]

GAUGE_COLUMNS = (
    *("time", "x", "y", "elevation", "slope_x", "slope_y"),
    *("velocity_x", "velocity_y", "velocity_z", "pressure"),
)
"""The columns of Sea.gauges()."""

SAMPLE: np.dtype[Any] = np.dtype(_abi.Sample)
WATER_SAMPLE: np.dtype[Any] = np.dtype(_abi.WaterSample)
DETAIL_BAND: np.dtype[Any] = np.dtype(_abi.DetailBand)
SPRAY_PARTICLE: np.dtype[Any] = np.dtype(_abi.SprayParticle)

_C_TYPES: dict[np.dtype[Any], Any] = {
    np.dtype(kind): kind
    for kind in (
        *(ctypes.c_float, ctypes.c_double, ctypes.c_uint32),
        *(_abi.Sample, _abi.WaterSample, _abi.DetailBand, _abi.SprayParticle),
    )
}


def pointer_to(array: npt.NDArray[Any]) -> Any:
    """Returns a C pointer to the items of an array, by their type: where libocean.h wants another
    one, ctypes raises. The pointer keeps the array."""
    return array.ctypes.data_as(ctypes.POINTER(_C_TYPES[array.dtype]))


class Samples(NamedTuple):
    """The shown surface at n points, as arrays of n rows."""

    height: Array
    """(n,) [m]."""
    normal: Array
    """(n, 3), unit, up."""
    velocity: Array
    """(n, 3), of the shown point [m/s]."""
    foam: Array
    """(n,), 0 .. 1; NaN where it was not requested."""
    label: npt.NDArray[np.float64]
    """(n, 2), the undisplaced coordinate of the shown point [m]."""
    folded: npt.NDArray[np.bool_]
    """(n,), True where several sheets lie above the point; this is the top one."""
    undecided: npt.NDArray[np.bool_]
    """(n,), True where the sea is so folded that not all sheets were found: perhaps this is not the
    top one."""
    height_error: float
    """The rms difference of the heights from the exact sum over all waves [m]."""


class Water(NamedTuple):
    """The motion of the water at n points, as arrays of n rows."""

    velocity: Array
    """(n, 3) [m/s]."""
    pressure: Array
    """(n,), without the hydrostatic part [Pa]."""


class WakeDomain(NamedTuple):
    """The samples of the wake of a hull, a square that does not wrap."""

    origin: tuple[float, float]
    """The place of sample (0, 0) [m]."""
    cell: float
    """The distance of samples [m]."""
    samples: int
    """Along a side."""


class FloatPose(NamedTuple):
    """The planes on which n floating bodies lie, as arrays of n rows."""

    position: Array
    """(n, 3): x and y of the body, height of the plane there [m]."""
    up: Array
    """(n, 3), unit vectors of the tilted bodies."""
    forward: Array
    """(n, 3), unit vectors of the tilted bodies."""
    pitch: Array
    """(n,), bow up [degrees]."""
    roll: Array
    """(n,), port side up [degrees]."""


class DetailBand(NamedTuple):
    """Slopes of waves too short for a map, over a tile that repeats."""

    slope: Array
    """(samples, samples, 2): dh/dx and dh/dy by label, sample [j, i] at (i, j) tile / samples."""
    shortest_wave: float
    """[m]."""
    longest_wave: float
    """[m]."""
    tile: float
    """Side and period of the map [m]."""
    variance_x: float
    """E[hx^2] of the slopes hx, hy: the integral of the spectrum over the band."""
    variance_y: float
    """E[hy^2]."""
    covariance: float
    """E[hx hy]."""
    mean_square: float
    """The mean of hx^2 + hy^2 over this frame's map, as a bilinear reader finds it."""

    def as_struct(self) -> npt.NDArray[Any]:
        """Returns the band as an ocean_detail_band, an array of one item."""
        return np.array([self[1:]], dtype=DETAIL_BAND)


class Detail(NamedTuple):
    """The waves too short for a map, at one time."""

    bands: list[DetailBand]
    """The band of the longest waves first; empty if the map holds all waves."""
    residual: float
    """Mean square slope of the waves shorter than all bands: roughness at any distance."""


class FoundCrest(NamedTuple):
    """The highest point of a crest."""

    time: float
    """[s]"""
    x: float
    """East, of the shown point [m]."""
    y: float
    """North [m]."""
    height: float
    """Over still water [m]."""


class Spray(NamedTuple):
    """Particles of spray, each a parcel of drops of one size, as arrays of n rows."""

    position: npt.NDArray[np.float64]
    """(n, 3) [m]. A particle is born within one period and may leave it; copies of it a period away
    are equally valid, but not those of a region."""
    velocity: Array
    """(n, 3) [m/s]."""
    age: Array
    """(n,), since birth [s]."""
    life: Array
    """(n,), the age at which it ends [s]."""
    radius: Array
    """(n,), of each of its drops [m]."""
    id: npt.NDArray[np.uint64]
    """(n,), constant from birth to end, and in every turn of a loop."""
