# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The coarser maps of a horizon in one image: maps of 1/2, 1/4 ... of the samples, down to one,
stacked from the bottom; each has a border of one texel, which repeats it, all around.

ring_nodes.Rings finds its way by the same rule.
"""

from __future__ import annotations

import math

import numpy as np

FINEST = {
    "Displacement": ("dx", "dy", "height", "cover"),
    "Velocity": ("vx", "vy", "vz", "jacobian"),
    # The fourth component is not used; skipping it would cost more.
    "Normal": ("nx", "ny", "nz", "height"),
}
"""The channels of the finest map in each image."""

_COARSER = {**FINEST, "Displacement": ("dx", "dy", "height", "height")}  # cover is averaged

_SMALLEST_MAP = 32  # of the library


def levels(size: int) -> int:
    """Returns the number of maps coarser than one of size x size samples; size is a power of
    two."""
    return round(math.log2(size))


def shape(size: int) -> tuple[int, int]:
    """Returns the rows and columns of an atlas."""
    return size - 1 + 2 * levels(size), size // 2 + 2


def put(atlas: np.ndarray, size: int, level: int, field: np.ndarray) -> None:
    """Writes a level's map, of size / 2^level samples a side, with its border."""
    side = len(field)
    bottom = size - 2 * side + 2 * (level - 1)
    block = atlas[bottom : bottom + side + 2, : side + 2]
    block[1:-1, 1:-1] = field
    block[1:-1, 0], block[1:-1, -1] = field[:, -1], field[:, 0]
    block[0], block[-1] = block[-2], block[1]


def lost_slopes(state: dict, samples: int) -> float:
    """Returns the variance of the slopes that a map with so many samples a side leaves out. state:
    of the sea."""
    shown = {m["resolution"]: m["mean_square_slope"] for m in state["map_slopes"]}
    if samples not in shown:
        return 0.0  # which the library refuses
    return max(0.0, state["mean_square_slope"]["asked"] - shown[samples])


def fill(sea, time: float, size: int, finest: dict, atlases: dict, state: dict) -> None:
    """Fills the atlases of these fields. finest: their maps of size x size samples, (n, n, 4), as
    images hold them, cover beside the displacement. The slopes that a map leaves out go where a
    normal has no fourth component."""
    above = dict(finest)
    for level in range(1, levels(size) + 1):
        side = size >> level
        below = {field: np.empty((side, side, 4), np.float32) for field in above}
        if side >= _SMALLEST_MAP:
            sea.fill(time, [(below[field], _COARSER[field]) for field in below])
        else:
            for field, map_ in below.items():
                map_[:] = halved(above[field]) if field == "Normal" else cut(above[field])
        if "Displacement" in below:
            below["Displacement"][..., 3] = halved(above["Displacement"][..., 3])
        if "Normal" in below:
            below["Normal"][..., 3] = lost_slopes(state, side)
        for field, map_ in below.items():
            put(atlases[field], size, level, map_)
        above = below


def halved(field: np.ndarray) -> np.ndarray:
    """Returns a periodic map on every other sample: means of each sample and, at half its weight,
    the two beside it, so that nothing moves. Seen from far away, cover becomes this mean."""
    for axis in (0, 1):
        even, odd = (np.swapaxes(field, 0, axis)[first::2] for first in (0, 1))
        beside = np.float32(0.25) * (odd + np.roll(odd, 1, axis=0))
        field = np.swapaxes(np.float32(0.5) * even + beside, 0, axis)
    return field


def cut(field: np.ndarray) -> np.ndarray:
    """The waves of a periodic map that one of half as many samples holds, on that map."""
    side = len(field) // 2
    spectrum = np.fft.fft2(field, axes=(0, 1))
    kept = [k % len(field) for k in range(-(side // 2) + 1, side // 2)]
    place = [k % side for k in range(-(side // 2) + 1, side // 2)]
    half = np.zeros((side, side, *field.shape[2:]), complex)
    half[np.ix_(place, place)] = spectrum[np.ix_(kept, kept)] / 4.0
    return np.fft.ifft2(half, axes=(0, 1)).real.astype(np.float32)
