# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The whole of a coast, which takes seconds: where the waves go over the bed, the bed itself, the
maps of one time. No Blender's data in here.

    BedSea, SeaValues, View -> heights of the bed, Maps: pixels by the input of the node group
"""

from __future__ import annotations

import dataclasses
import hashlib
from collections.abc import Callable

import numpy as np

from ..sea.sea_text import SeaValues
from ..shared import drafts, images
from ..shared.compat import tr_label
from ..shared.native import libocean
from ..shared.progress import Progress
from ..terrain import extent as extents
from ..terrain.extent import Extent, ExtentError
from .bed_sea import BedSea
from .node_group import CHANNELS, DISPLACEMENT, FOAM

AUTOMATIC = 512
"""The max samples of the longer side of a region whose cell is chosen by itself."""

Maps = dict[str, np.ndarray]
"""Pixels (rows, columns, 4) by the input of the node group."""

_THOUSANDTHS = 1000
"""The total in the progress of waves over a bed. The progress of foam has the number of ticks."""
_QUICK = ("whitecap", "whitecap")
"""The channels of foam in a draft: whitecaps have no past."""


def quick_fields(fields) -> tuple[str, ...]:
    """Returns the inputs among these that a draft has."""
    return tuple(name for name in fields if name in (DISPLACEMENT, FOAM))


@dataclasses.dataclass(frozen=True)
class Region:
    """The rectangle that is shown."""

    corners: tuple[float, ...] | None
    """West, south, east and north side [m]; None: all of the bed."""
    cell: float
    """Distance of the samples [m]; 0: automatic."""

    def extent(self, own: Extent) -> Extent:
        """Returns the samples. own: the samples of the bed. Raises ExtentError."""
        corners = self.corners
        if corners is None:
            (west, south), (width, depth) = own.origin, own.size
            corners = (west, south, west + width, south + depth)
        side = max(corners[2] - corners[0], corners[3] - corners[1])
        cell = self.cell or max(side, 1e-3) / (AUTOMATIC - 1)
        return dataclasses.replace(extents.of_region(corners, cell, own), is_own=False)


def region_of(settings) -> Region:
    """Returns the region of Object.libocean_coast, as its panel shows it."""
    corners = None
    if settings.use_region:
        corners = tuple(round(part, 4) for part in settings.region)
    return Region(corners, round(settings.cell, 6))


@dataclasses.dataclass(frozen=True)
class View:
    """The part of a sea that is shown."""

    time: float
    """[s]"""
    region: Region
    fields: tuple[str, ...]
    """Inputs of the node group, in the order of its table."""


def fill_maps(
    sea, view: View, extent: Extent, maps: Maps | None = None, *, quick: bool = False
) -> Maps:
    """Returns the maps of a view on the samples of an extent, in the arrays of `maps` where they
    fit. quick: with whitecaps in place of foam. Raises libocean.Error."""
    made = {}
    for name in view.fields:
        before = (maps or {}).get(name)
        fits = before is not None and before.shape[:2] == extent.shape
        made[name] = before if fits else images.aligned(extent.shape)

    channels = {**CHANNELS, FOAM: _QUICK} if quick else CHANNELS
    buffers = [(made[name], (*channels[name], "", "", "")[:4]) for name in view.fields]
    sea.fill_region(view.time, buffers, extent.origin, extent.cell)
    return made


def _normals_of(heights: np.ndarray, cell: float) -> np.ndarray:
    """Returns the upward unit normals of heights on a grid, (rows, columns, 3), rounded to steps
    of 2^-14, so that a file holds them in half the bytes."""
    by_north, by_east = np.gradient(heights.astype(np.float64), cell)
    normals = np.stack([-by_east, -by_north, np.ones_like(by_east)], axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    return (np.rint(normals * 2.0**14) / 2.0**14).astype(np.float32)


@dataclasses.dataclass(frozen=True)
class Bed:
    """The bed on the samples of an extent."""

    heights: np.ndarray
    """[m], (rows, columns)"""
    normals: np.ndarray
    """(rows, columns, 3)"""
    mark: str
    """Tells these heights from others."""


def make_bed(sea, extent: Extent) -> Bed:
    """Returns the bed of a sea. Raises libocean.Error."""
    heights = sea.bed_region(extent.origin, extent.samples, extent.cell)
    mark = hashlib.sha256(heights.tobytes()).hexdigest()[:16]
    return Bed(heights, _normals_of(heights, extent.cell), mark)


class CoastJob(drafts.Job):
    """Makes the maps of a view of a sea, and the bed if it is unknown: quick ones, which do not
    wait for the past of foam, of a sea that is new, then the whole. It works with the handle of the
    coast, which the coast does not touch meanwhile."""

    def __init__(
        self,
        key: tuple,
        lent: BedSea,
        values: SeaValues,
        base_dir: str | None,
        view: View,
        is_owned: Callable[[], bool],
    ) -> None:
        """lent: the handle, which takes the values. is_owned(): whether the coast still has this
        handle."""
        super().__init__(key)
        self.lent, self.values, self.base_dir, self.view = lent, values, base_dir, view
        self.is_quick = False
        self.progress = Progress()
        self.bed_known: Extent | None = None
        """The samples on which the bed of these values is known."""
        self.bed: Bed | None = None
        self.extent: Extent | None = None
        self.is_plain = False
        """True if the maps take no longer than the maps of any frame of a shot."""
        self.maps: Maps | None = None
        self._is_owned = is_owned

    def work(self) -> None:
        self.require_wanted()
        self.lent.adopt(self.values, self.base_dir)
        try:
            self.extent = self.view.region.extent(self.lent.own)
        except ExtentError as failure:
            raise libocean.Error(str(failure), 0) from failure
        self.require_wanted()
        if self.bed_known != self.extent:
            self.is_plain = False
            self.bed = make_bed(self.lent.sea, self.extent)
        self.require_wanted()
        view = self.view
        if self.is_quick:
            view = dataclasses.replace(view, fields=quick_fields(view.fields))
        self.maps = fill_maps(self.lent.sea, view, self.extent, quick=self.is_quick)

    @property
    def share(self) -> float:
        """Returns the finished share of water and foam, 0 .. 1."""
        return self.progress.share

    def _watch(self, done: int, total: int) -> None:
        self.progress.note(done, total)
        super()._watch(done, total)

    def close(self) -> None:
        if not self._is_owned():
            self.lent.close()

    def status_text(self, name: str) -> str:
        if self.ticks is not None and self.ticks[1] != _THOUSANDTHS:
            return tr_label("{}: water and foam, {:.0%}", name, self.share)
        return tr_label("{}: waves over the bed, {:.0%}", name, self.share)
