# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The whole of a coast, which takes seconds: where the waves go over the bed, the bed itself, the
maps of one time. No Blender's data in here.

    sea over a bed + View -> heights of the bed, Maps: pixels by the input of the node group
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable

import numpy as np

from ..shared import drafts, images
from ..shared.compat import tr_label
from ..terrain.extent import Extent
from .node_group import CHANNELS, FOAM

Maps = dict[str, np.ndarray]
"""Pixels (rows, columns, 4) by the input of the node group."""

_QUICK = ("whitecap", "whitecap")
"""The channels of foam in a draft: whitecaps have no past."""


@dataclasses.dataclass(frozen=True)
class View:
    """The part of a sea that is shown."""

    time: float
    """[s]"""
    extent: Extent
    fields: tuple[str, ...]
    """Inputs of the node group, in the order of its table."""


def fill_maps(sea, view: View, maps: Maps | None = None, *, quick: bool = False) -> Maps:
    """Returns the maps of a view, in the arrays of `maps` where they fit. quick: with whitecaps in
    place of foam. Raises libocean.Error."""
    made = {}
    for name in view.fields:
        before = (maps or {}).get(name)
        fits = before is not None and before.shape[:2] == view.extent.shape
        made[name] = before if fits else images.aligned(view.extent.shape)

    channels = {**CHANNELS, FOAM: _QUICK} if quick else CHANNELS
    buffers = [(made[name], (*channels[name], "", "")[:4]) for name in view.fields]
    sea.fill_region(view.time, buffers, view.extent.origin, view.extent.cell)
    return made


def bed_heights(sea, extent: Extent, at: float) -> np.ndarray:
    """Returns the heights of the bed on the samples of an extent [m], (rows, columns). at: a time
    [s]. Raises libocean.Error."""
    # Without choppiness a sample lies at its label, and over the bed that it has the depth of.
    choppiness = sea.get("choppiness")
    sea.set("choppiness", "0")
    try:
        maps = sea.region(at, extent.origin, extent.samples, extent.cell, ("height", "depth"))
    finally:
        sea.set("choppiness", choppiness)
    return maps["height"] - maps["depth"]


class CoastJob(drafts.Job):
    """Makes the whole maps of a view, and the bed if it is unknown. It works with the handle of the
    coast, which the coast does not touch meanwhile."""

    def __init__(self, sea, key: tuple, view: View, is_owned: Callable[[], bool]) -> None:
        """is_owned(): whether the handle is still that of its coast."""
        super().__init__(key)
        self.sea, self.view = sea, view
        self.wants_bed = False
        self.bed: np.ndarray | None = None
        self.is_plain = False
        """True if the maps take no more than those of any frame of a shot."""
        self.maps: Maps | None = None
        self._is_owned = is_owned
        self._is_at_maps = False

    def work(self) -> None:
        self._require_wanted()
        if self.wants_bed:
            self.bed = bed_heights(self.sea, self.view.extent, self.view.time)
        self._require_wanted()
        self._is_at_maps = True
        self.maps = fill_maps(self.sea, self.view)

    def _require_wanted(self) -> None:
        if self.is_cancelled():
            raise drafts.CancelledError

    def close(self) -> None:
        if not self._is_owned():
            self.sea.close()

    def said(self, name: str) -> str:
        if self._is_at_maps:
            return tr_label("{}: water and foam, {:.0%}", name, self.share)
        return tr_label("{}: waves over the bed, {:.0%}", name, self.share)
