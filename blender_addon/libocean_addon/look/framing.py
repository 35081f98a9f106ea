# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the camera of a new scene stands, and which way it looks: over land and water, at a shore
or at mountains, and never inside them.

    heights on a grid: Ground -> rays from many places all around -> the best picture: Eye
"""

from __future__ import annotations

import dataclasses

import numpy as np

from ..coast.coast_job import Bed
from ..terrain.extent import Extent
from ..terrain.node_group import GROUND
from ..terrain.open_terrain import fill_maps, own_extent

_SAMPLES = 256
"""The max samples along a side of the land that is looked at."""
_RAYS = 72
_WIDTH = 13
"""The rays of a picture, which is 65 degrees wide."""
_PLACES = 20
"""The places along a side that are tried."""


@dataclasses.dataclass(frozen=True)
class Eye:
    """A camera's place [m], and the way it looks: degrees counter-clockwise from +x, and degrees
    below the horizon."""

    place: tuple[float, float, float]
    heading: float
    down: float


@dataclasses.dataclass(frozen=True)
class Ground:
    """Heights on a grid, x east and y north."""

    heights: np.ndarray
    """[m], (rows, columns)"""
    origin: tuple[float, float]
    cell: float
    wraps: bool
    """True for a tile, which repeats; otherwise the land goes on as it is at its sides."""

    def sample(self, of_samples: np.ndarray, x, y) -> np.ndarray:
        """Returns numbers on the samples at the samples next to places [m]."""
        columns, rows = (
            np.rint((places - first) / self.cell).astype(int)
            for places, first in zip((x, y), self.origin, strict=True)
        )
        fit = np.mod if self.wraps else lambda numbers, count: np.clip(numbers, 0, count - 1)
        return of_samples[fit(rows, of_samples.shape[0]), fit(columns, of_samples.shape[1])]

    def highest_within(self, place: np.ndarray, distance: float) -> float:
        """Returns the highest height around a place (x, y)."""
        along = np.arange(-distance, distance + self.cell, self.cell)
        x, y = np.meshgrid(place[0] + along, place[1] + along)
        return float(self.sample(self.heights, x, y).max())


def of_bed(bed: Bed, extent: Extent) -> Ground:
    """Returns the bed of a coast, on few of its samples."""
    step = extent.step_for(_SAMPLES)
    return Ground(bed.heights[::step, ::step], extent.origin, extent.cell * step, False)


def of_terrain(terrain) -> Ground:
    """Returns the land of a terrain, on few samples."""
    own = own_extent(terrain)
    few = own.coarser(own.step_for(_SAMPLES))
    heights = fill_maps(terrain, few, ())[GROUND][..., 3]
    return Ground(heights, few.origin, few.cell, few.wraps)


def _ways() -> tuple[np.ndarray, np.ndarray]:
    turns = np.arange(_RAYS) * (2.0 * np.pi / _RAYS)
    return np.cos(turns), np.sin(turns)


def _pictures(of_rays: np.ndarray) -> np.ndarray:
    """Returns what each picture has, (places, headings, rays), of numbers by place and ray."""
    around = (np.arange(_RAYS)[:, None] + np.arange(_WIDTH) - _WIDTH // 2) % _RAYS
    return of_rays[:, around]


def _best(scores: np.ndarray) -> tuple[int, float]:
    """Returns the place of the highest score and its heading [degrees]."""
    place, heading = np.unravel_index(np.argmax(scores), scores.shape)
    return int(place), float(heading) * 360.0 / _RAYS


def shore_eye(ground: Ground, travel: float) -> Eye:
    """Returns the view along a shore on which the waves run: land over half of the picture, near
    on one side and far on the other. Over a bed without a shore it is the view from its middle
    against the waves. travel: where the waves go [degrees]."""
    heights, cell = ground.heights, ground.cell
    size = cell * max(heights.shape)
    rows, columns = np.nonzero((heights < -0.5) & (heights > -0.02 * size))
    first, last = 0.1, 0.9
    inside = [
        (numbers > first * count) & (numbers < last * count)
        for numbers, count in zip((rows, columns), heights.shape, strict=True)
    ]
    kept = np.flatnonzero(inside[0] & inside[1])
    kept = kept[:: max(1, len(kept) // _PLACES**2)]
    x = ground.origin[0] + cell * columns[kept]
    y = ground.origin[1] + cell * rows[kept]
    middle = np.array(ground.origin) + cell / 2.0 * np.array(heights.shape[::-1])
    low = 0.02 * size
    away = np.geomspace(0.02 * size, size, 48)
    east, north = _ways()
    ray_x = x[:, None, None] + east[:, None] * away
    ray_y = y[:, None, None] + north[:, None] * away
    is_land = ground.sample(heights, ray_x, ray_y) > 0.0
    hits = is_land.any(axis=2)
    if not hits.any():
        return Eye(
            (*middle, max(low, ground.highest_within(middle, low) + low)), travel + 180.0, 5.0
        )
    number = np.where(hits, is_land.argmax(axis=2), len(away) - 1)[..., None]
    distance = np.where(hits, away[number[..., 0]], np.nan)
    up_north, up_east = np.gradient(heights, cell)
    steep = np.hypot(up_east, up_north) + 1e-6
    waves = np.radians(travel)
    facing = (up_east * np.cos(waves) + up_north * np.sin(waves)) / steep
    of_hits = ground.sample(
        facing,
        np.take_along_axis(ray_x, number, 2)[..., 0],
        np.take_along_axis(ray_y, number, 2)[..., 0],
    )
    shares = _pictures(hits.astype(float)).mean(axis=2)
    logs = _pictures(np.where(hits, np.log(np.nan_to_num(distance, nan=size) / size), np.nan))
    near = np.nanmin(np.where(np.isnan(logs), 0.0, logs), axis=2)
    far = np.nanmax(np.where(np.isnan(logs), near[..., None], logs), axis=2)
    surf = np.nan_to_num(_pictures(np.where(hits, of_hits, 0.0)).mean(axis=2))
    scores = (
        3.0 * surf - 2.0 * abs(shares - 0.6) + 0.3 * (far - near) - 0.6 * abs(near - np.log(0.1))
    )
    place, heading = _best(scores)
    spot = np.array([x[place], y[place]])
    return Eye((*spot, max(0.0, ground.highest_within(spot, 0.02 * size)) + low), heading, 6.0)


def relief_eye(ground: Ground) -> Eye:
    """Returns the view of a land that is deepest: of the slopes near and far, and of mountains that
    stand out of the horizon."""
    heights, cell = ground.heights, ground.cell
    size = cell * max(heights.shape)
    margin = 0 if ground.wraps else max(heights.shape) // 8
    rows, columns = (
        np.linspace(margin, count - 1 - margin, _PLACES).astype(int) for count in heights.shape
    )
    columns, rows = (part.ravel() for part in np.meshgrid(columns, rows))
    x = ground.origin[0] + cell * columns
    y = ground.origin[1] + cell * rows
    clear = 0.01 * size
    eyes = [ground.highest_within(np.array(spot), clear) for spot in zip(x, y, strict=True)]
    z = np.array(eyes) + 0.05 * np.ptp(heights)
    away = np.geomspace(0.02 * size, 0.6 * size, 40)
    east, north = _ways()
    seen = ground.sample(
        heights,
        x[:, None, None] + east[:, None] * away,
        y[:, None, None] + north[:, None] * away,
    )
    rise = (seen - z[:, None, None]) / away
    skyline = rise.max(axis=2)
    is_visible = rise >= np.maximum.accumulate(rise, axis=2)
    depth = _pictures(is_visible.mean(axis=2)).mean(axis=2)
    sky = _pictures(skyline)
    high, stands = sky.mean(axis=2), sky.std(axis=2)
    scores = depth + 4.0 * np.minimum(stands, 0.06) - 3.0 * abs(high - 0.05)
    place, heading = _best(scores)
    return Eye((x[place], y[place], z[place]), heading, 6.0)
