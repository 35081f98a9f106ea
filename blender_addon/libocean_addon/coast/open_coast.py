# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Open coasts, one for each object: the library's handle of the sea, its maps, its bed, and what
the images hold.

    SeaValues -> sea over a bed; View -> CoastJob or at once -> images; bed -> mesh of the land
"""

from __future__ import annotations

import dataclasses
import json
import math
import threading
import time

import bpy
import numpy as np

from ..sea import messages
from ..sea.sea_text import SeaValues
from ..shared import drafts, images
from ..shared.compat import tr
from ..shared.native import libocean
from ..shared.open_by_object import OpenByObject
from ..terrain import extent as extents
from ..terrain.extent import Extent
from .coast_job import CoastJob, Maps, View, bed_heights, fill_maps
from .node_group import DISPLACEMENT, FOAM

AUTOMATIC = 512
"""The max samples of the longer side of a region whose cell is chosen by itself."""
_AT_HAND = 3.0  # [s] of the sea that foam advances while a user waits
_OF_BED = ("level", "seabed", "seabed_origin", "seabed_unit", "seabed_sign")


def own_extent(values: SeaValues, state: dict) -> Extent:
    """Returns the samples of a bed. state: that of its sea."""
    bed = state["bed"]
    origin = json.loads(values.values["seabed_origin"]) or [0.0, 0.0]
    return Extent(tuple(map(float, origin)), float(bed["cell"]), tuple(bed["samples"]), False)


class OpenCoast:
    """The library's sea over the bed of one object, its maps, and what was shown last."""

    def __init__(self) -> None:
        self.lock = threading.RLock()  # renders run in a thread of their own
        self.sea = None
        self.values: SeaValues | None = None
        self.state: dict | None = None
        self.own: Extent | None = None
        """The samples of the bed."""
        self.region: tuple[float, ...] | None = None
        """Corners of the rectangle to show [m]; None: all of the bed."""
        self.cell = 0.0
        """Distance of the samples [m]; 0: automatic."""
        self.changes = 0
        self.failed: tuple | None = None
        """The key of a view that could not be made, and the sentence that says why."""
        self.pace = drafts.Pace()
        self._job: CoastJob | None = None  # that the handle is lent to
        self._prepared = -1  # the changes for which the library knows where waves go
        self._advanced: tuple | None = None  # changes, extent and time of the last foam
        self._bed: np.ndarray | None = None
        self._bed_of: tuple | None = None  # the bed's values and extent of those heights
        self._maps: Maps = {}
        self._filled: tuple | None = None  # the key of the maps
        self._shown: dict[str, tuple] = {}  # by image: key and extent of what it holds
        self._seconds = math.inf  # a sample of the last whole maps

    # The sea --------------------------------------------------------------------

    def follow(self, values: SeaValues) -> None:
        """Makes it the sea of these values. Raises libocean.Error, after which nothing is shown
        until values follow that are right."""
        if values == self.values:
            return
        messages.require_files(values)
        before, self.values = self.values, None  # opened anew after a failure
        if before is not None and values.structure() == before.structure() and not self.is_busy():
            self.sea.set_all(dict(values.by_name().items() - before.by_name().items()))
        else:
            self._open(values)
        state = self.sea.state
        if "bed" not in state:
            raise libocean.Error(
                tr("The sea has no bed: choose a file for Sea bed, or load a sea that has one"), 0
            )
        self.values, self.state, self.own = values, state, own_extent(values, state)
        self.changes += 1

    def _open(self, values: SeaValues) -> None:
        base_dir = bpy.path.abspath("//") or None
        opened = libocean.parse(
            values.text(), base_dir=base_dir, progress=drafts.tell_watcher_of_share
        )
        if self.sea is not None and not self.is_busy():
            self.sea.close()  # else its job closes it
        self.sea, self._job = opened, None

    def is_busy(self) -> bool:
        """Returns whether a job has the handle: a call of it would wait."""
        return self._job is not None and self._job.is_alive()

    def time_of(self, frame: float) -> float:
        """Returns the sea's time at a frame [s], without the handle."""
        values = self.values.values
        first, rate = float(values["first_frame"]), float(values["fps"])
        return float(values["start"]) + (frame - first) / rate

    # The region -----------------------------------------------------------------

    @property
    def extent(self) -> Extent:
        """Returns the samples of the region that is shown. Raises ExtentError."""
        corners = self.region
        if corners is None:
            (west, south), (width, depth) = self.own.origin, self.own.size
            corners = (west, south, west + width, south + depth)
        side = max(corners[2] - corners[0], corners[3] - corners[1])
        cell = self.cell or max(side, 1e-3) / (AUTOMATIC - 1)
        return dataclasses.replace(extents.of_region(corners, cell, self.own), is_own=False)

    def key(self, view: View) -> tuple:
        return self.changes, view

    def _bed_key(self, extent: Extent) -> tuple:
        values = self.values
        return values.bed, *(values.values[name] for name in _OF_BED), extent

    def bed(self, extent: Extent) -> np.ndarray | None:
        """Returns the heights of the bed on these samples [m]; None before they are known."""
        return self._bed if self._bed_of == self._bed_key(extent) else None

    def words_of_bed(self, extent: Extent) -> str:
        """Returns the words by which a mesh of the bed is known."""
        name = {"sha256": self.state["bed"]["sha256"], "level": self.values.values["level"]}
        return f"bed {json.dumps(name)} {extent.origin} {extent.cell!r} {extent.samples}"

    # Images ---------------------------------------------------------------------

    def is_ready(self, view: View) -> bool:
        """Returns whether the whole maps of a view are there, or can be made while a user waits."""
        if self._filled == self.key(view):
            return True
        if self.is_busy() or self.bed(view.extent) is None or not self._is_plain(view):
            return False
        return self._seconds * view.extent.count < drafts.SECONDS

    def _has_past(self, view: View) -> bool:
        """Returns whether the library has the past of the foam at hand."""
        known = self._advanced is not None and self._advanced[:2] == (self.changes, view.extent)
        return known and 0.0 <= view.time - self._advanced[2] <= _AT_HAND

    def show(self, view: View, image_named: dict) -> Extent:
        """Fills the images, by the inputs of the node group, with the whole maps of a view. Blocks
        until they are made. Raises libocean.Error."""
        key = self.key(view)
        with self.lock:
            self._end_job(key)
            stale = self._stale(image_named, key)
            if (stale or self.bed(view.extent) is None) and self._filled != key:
                if self.bed(view.extent) is None:
                    self._keep_bed(view.extent, bed_heights(self.sea, view.extent, view.time))
                is_plain, begun = self._is_plain(view), time.perf_counter()
                self._maps = fill_maps(self.sea, view, self._maps)
                self._note(view, time.perf_counter() - begun, is_plain)
            self._put(image_named, stale, key, view.extent)
        return view.extent

    def _is_plain(self, view: View) -> bool:
        """Returns whether maps of a view take no more than those of any frame of a shot."""
        return self._prepared == self.changes and (FOAM not in view.fields or self._has_past(view))

    def _note(self, view: View, seconds: float, is_plain: bool) -> None:
        """Notes that the whole maps of a view were made."""
        if is_plain:
            self._seconds = seconds / view.extent.count
        self._filled, self._prepared = self.key(view), self.changes
        if FOAM in view.fields:
            self._advanced = (self.changes, view.extent, view.time)

    def _keep_bed(self, extent: Extent, heights: np.ndarray) -> None:
        self._bed, self._bed_of = heights, self._bed_key(extent)

    def show_draft(self, view: View, image_named: dict) -> Extent | None:
        """Fills the images with coarser maps of a view, if the handle is free and the library knows
        where the waves go; else they keep what they hold. Returns the samples of that; None for
        water at rest."""
        if self._prepared != self.changes or self.is_busy():
            held = self._shown.get(image_named[DISPLACEMENT].name_full)
            return None if held is None else held[1]
        coarse = view.extent.coarser(view.extent.step_for(self.pace.size))
        draft = dataclasses.replace(view, extent=coarse, fields=tuple(image_named))
        key = ("draft", *self.key(draft))
        with self.lock:
            stale = self._stale(image_named, key)
            if stale:
                begun = time.perf_counter()
                self._maps = fill_maps(self.sea, draft, self._maps, quick=True)
                self._filled = None
                seconds = time.perf_counter() - begun
                self.pace.note(self.pace.size, seconds, max(view.extent.samples) // 2)
            self._put(image_named, stale, key, coarse)
        return coarse

    def _stale(self, image_named: dict, key: tuple) -> list[str]:
        for image in image_named.values():
            if images.let_go(image):
                self._shown.pop(image.name_full, None)
        return [
            name
            for name, image in image_named.items()
            if self._shown.get(image.name_full, (None,))[0] != key
        ]

    def _put(self, image_named: dict, stale: list[str], key: tuple, extent: Extent) -> None:
        for name in stale:
            image, pixels = image_named[name], self._maps[name]
            images.resize(image, pixels.shape[:2])
            images.fill(image, pixels)
            self._shown[image.name_full] = (key, extent)

    # In the background ----------------------------------------------------------

    def job(self, view: View) -> CoastJob:
        """Returns the job that makes the whole maps of a view, and lends it the handle."""
        sea = self.sea
        job = CoastJob(sea, self.key(view), view, lambda: self.sea is sea)
        job.wants_bed = self.bed(view.extent) is None
        job.is_plain = self._is_plain(view)
        self._job = job
        return job

    def _end_job(self, key: tuple) -> None:
        """Takes the handle back: waits for a job that makes the maps of this key, ends others."""
        job = self._job
        if job is None or not job.is_alive():
            return
        if job.key != key:
            job.cancel()
        job.join()
        if not job.is_cancelled():
            self.take_over(job)

    def take_over(self, job: CoastJob) -> bool:
        """Keeps the maps of a job that has ended. Returns False if the job is of no use."""
        if job.failure is not None or job.key[0] != self.changes or job.sea is not self.sea:
            job.close()
            return False
        with self.lock:
            self._maps = job.maps
            if job.bed is not None:
                self._keep_bed(job.view.extent, job.bed)
            self._note(job.view, job.seconds, job.is_plain and not job.wants_bed)
        return True

    def forget_images(self) -> None:
        """Forgets, after undo and loading, what images hold."""
        self._shown.clear()

    def close(self) -> None:
        if self.sea is not None and not self.is_busy():
            self.sea.close()
        self.sea = None


_coasts = OpenByObject(OpenCoast)
coast_of = _coasts.of
forget = _coasts.forget
close_all = _coasts.close_all
