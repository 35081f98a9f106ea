# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The outline of a hull: where its sides are at stations along its own x axis, at several levels.

triangles of an object -> segments at each level -> lowest and highest y at each station -> text
"""

from __future__ import annotations

import dataclasses
import functools
import json

import numpy as np

STATIONS = 64
LEVELS = 12
_INSET = 1e-4  # of the first and the last station and level, as a share


@dataclasses.dataclass(frozen=True)
class Outline:
    """Lengths in metres of the sea, in axes that are turned as the object."""

    begin: tuple[float, float, float]
    """The first x, 0, and the z of the lowest level."""
    size: tuple[float, float, float]
    """Along x, y and z."""
    low: list[list[float]]
    """The lowest y by level and station; the highest where the object is not."""
    high: list[list[float]]

    def text(self) -> str:
        return json.dumps(dataclasses.asdict(self))

    def pixels(self) -> np.ndarray:
        """Returns the image: lowest and highest y, the lowest level first."""
        made = np.zeros((LEVELS, STATIONS, 4), np.float32)
        made[..., 0], made[..., 1] = self.low, self.high
        return made


@functools.lru_cache(maxsize=16)
def read(text: str) -> Outline | None:
    """Returns the outline of a text; None for an empty one. It is called at each frame."""
    if not text:
        return None
    told = json.loads(text)
    return Outline(tuple(told["begin"]), tuple(told["size"]), told["low"], told["high"])


def _crossings(corners: np.ndarray, level: float) -> np.ndarray:
    """Returns the segments on which triangles cross a level, (n, 2, 3). corners: (n, 3, 3)."""
    over = corners[..., 2] > level
    count = over.sum(axis=1)
    crossed = count % 3 != 0
    # The corner that lies alone on its side comes first.
    alone = (over == (count == 1)[:, None])[crossed]
    order = (alone.argmax(axis=1)[:, None] + np.arange(3)) % 3
    corners = np.take_along_axis(corners[crossed], order[..., None], axis=1)
    tip, others = corners[:, :1], corners[:, 1:]
    share = (level - tip[..., 2:]) / (others[..., 2:] - tip[..., 2:])
    return tip + share * (others - tip)


def _sides(segments: np.ndarray, stations: np.ndarray) -> np.ndarray:
    """Returns the lowest and the highest y of segments at each station; NaN without any."""
    order = np.argsort(segments[..., 0], axis=1)
    ordered = np.take_along_axis(segments, order[..., None], axis=1)
    (from_x, from_y), (to_x, to_y) = ordered[:, 0, :2].T, ordered[:, 1, :2].T
    slope = (to_y - from_y) / np.maximum(to_x - from_x, 1e-12)
    sides = np.full((2, len(stations)), np.nan)
    for number, x in enumerate(stations):
        met = (from_x <= x) & (x <= to_x)
        if met.any():
            y = from_y[met] + (x - from_x[met]) * slope[met]
            sides[:, number] = y.min(), y.max()
    return sides


def of_triangles(corners: np.ndarray, still: float) -> Outline | None:
    """Returns the outline of triangles, (n, 3, 3), in the object's axes; None where they do not
    cross still water. Over still water the sides never come closer: where a boat has no deck, or
    ends, no wave comes in. The lowest level is at half the draught: the floor of a boat is too flat
    for the faces of a sea."""
    line = _crossings(corners, still)
    if len(line) == 0:
        return None
    bottom, width = 0.5 * (still + float(corners[..., 2].min())), float(np.ptp(line[..., 1]))
    top = min(float(corners[..., 2].max()), still + max(width, 2.0 * (still - bottom)))
    near = corners[corners[..., 2].min(axis=1) < top]
    begin, length = float(near[..., 0].min()), float(np.ptp(near[..., 0]))
    shares = np.linspace(_INSET, 1.0 - _INSET, STATIONS)
    rows = np.array(
        [
            _sides(_crossings(near, level), begin + length * shares)
            for level in bottom + (top - bottom) * np.linspace(_INSET, 1.0 - _INSET, LEVELS)
        ]
    )
    for level in range(1, LEVELS):
        if bottom + (top - bottom) * level / (LEVELS - 1) > still:
            for side, widest in enumerate((np.fmin, np.fmax)):
                rows[level, side] = widest(rows[level, side], rows[level - 1, side])
    rows[np.isnan(rows)] = 0.5 * (np.nanmin(rows) + np.nanmax(rows))
    low, high = rows.round(4).transpose(1, 0, 2).tolist()
    size = length, max(width, 1e-3), top - bottom
    return Outline((begin, 0.0, bottom), size, low, high)
