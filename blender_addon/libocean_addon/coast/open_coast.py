# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Open coasts, one for each object: the library's handle of the sea, its maps, its bed, and what
the images hold.

    SeaValues -> sea over a bed; View -> CoastJob or at once -> images; bed -> mesh of the land
"""

from __future__ import annotations

import dataclasses
import math
import time

from ..sea import messages
from ..sea.clock import Clock
from ..sea.open_sea import OpenSea
from ..sea.sea_text import SeaValues
from ..shared import drafts, paths
from ..shared.open_subject import OpenByObject, ShownImages
from ..shared.progress import Progress
from ..terrain.extent import Extent
from .bed_sea import BedSea
from .coast_job import Bed, CoastJob, Maps, View, fill_maps, make_bed
from .node_group import DISPLACEMENT, FOAM, WETNESS

_CHEAP_ADVANCE = 3.0  # [s] of the sea that foam advances while a user waits
_COARSE, _QUICK = "coarse", "quick"  # begin the keys of drafts
_OF_BED = ("level", "seabed", "seabed_origin", "seabed_unit", "seabed_sign")


def _pasts(view: View) -> tuple[str, ...]:
    """Returns the fields of a view that the library follows from their past."""
    return tuple(name for name in view.fields if name in (FOAM, WETNESS))


class OpenCoast(ShownImages):
    """The library's sea over the bed of one object, its maps, and the content of its images."""

    def __init__(self) -> None:
        super().__init__()
        self.values: SeaValues | None = None
        """The values to show, which the handle takes when it is free."""
        self.open_sea = OpenSea()
        """The sea without its bed, for what a coast shows of it; it follows when that is shown."""
        self._held = BedSea()
        self._clock = Clock()
        self._base_dir: str | None = None
        self._job: CoastJob | None = None  # the job that has the handle
        self._draft: CoastJob | None = None  # the quick one that has ended last
        self._prepared = -1  # the changes for which the library knows where waves go
        self._advanced: tuple | None = None  # changes, extent, fields and time of the last past
        self._bed: Bed | None = None
        self._bed_of: tuple | None = None  # its values and extent
        self._maps: Maps = {}
        self._filled: tuple | None = None  # the key of the maps
        self._seconds = math.inf  # a sample of the last whole maps

    # The sea --------------------------------------------------------------------

    @property
    def sea(self):
        """The handle. A caller holds the lock and has opened it."""
        return self._held.sea

    @property
    def state(self) -> dict | None:
        """The state of the sea that the handle has; None before the first one."""
        return self._held.state

    @property
    def own(self) -> Extent | None:
        """The samples of the bed that the handle has."""
        return self._held.own

    def follow(self, values: SeaValues) -> None:
        """Makes these the values to show. Raises libocean.Error for files that are not named."""
        messages.require_files(values)
        if values != self.values:
            self.values = values
            self.changes += 1
            self._base_dir = paths.blend_folder()

    def open(self) -> None:
        """Has the handle take the values to show. Blocks until it is free. Raises
        libocean.Error."""
        with self.lock:
            if self._held.values != self.values:
                self._end_job(None)
                self._held.adopt(self.values, self._base_dir)

    def is_busy(self) -> bool:
        """Returns whether a job has the handle: a call of it would wait."""
        return self._job is not None and self._job.is_alive()

    def is_cheap(self) -> bool:
        """Returns whether the handle is free, and knows where the waves of the values go."""
        return self._prepared == self.changes and not self.is_busy()

    def time_of(self, frame: float) -> float:
        """Returns the sea's time at a frame [s], without the handle."""
        return self._clock.time_of(self.values, frame)

    # The region -----------------------------------------------------------------

    def key(self, view: View) -> tuple:
        return self.changes, view

    def _bed_words(self) -> tuple[str, ...]:
        values = self.values
        return values.bed, *(values.values[name] for name in _OF_BED)

    def bed(self, extent: Extent) -> Bed | None:
        """Returns the bed on these samples; None before it is known."""
        return self._bed if self._bed_of == (*self._bed_words(), extent) else None

    # Images ---------------------------------------------------------------------

    def is_ready(self, view: View) -> bool:
        """Returns whether the whole maps of a view are there, or can be made while a user waits."""
        if self._filled == self.key(view):
            return True
        if not self.is_cheap():
            return False
        extent = view.region.extent(self.own)
        if self.bed(extent) is None or not self._is_plain(view, extent):
            return False
        return self._seconds * extent.count < drafts.SECONDS

    def _has_past(self, view: View, extent: Extent) -> bool:
        """Returns whether the library has the past of foam and wet ground at hand."""
        what = (self.changes, extent, _pasts(view))
        known = self._advanced is not None and self._advanced[:-1] == what
        return known and 0.0 <= view.time - self._advanced[-1] <= _CHEAP_ADVANCE

    def show(self, view: View, image_named: dict) -> Extent:
        """Fills the images, by the inputs of the node group, with the whole maps of a view. Blocks
        until they are made. Returns their samples. Raises libocean.Error and ExtentError."""
        key = self.key(view)
        with self.lock:
            self._end_job(key)
            self.open()
            extent = view.region.extent(self.own)
            stale = self.stale(image_named, (key, extent))
            if (stale or self.bed(extent) is None) and self._filled != key:
                self.require_bed(extent)
                is_plain, begun = self._is_plain(view, extent), time.perf_counter()
                self._maps = fill_maps(self.sea, view, extent, self._maps)
                self._note(view, extent, time.perf_counter() - begun, is_plain)
            self.put(image_named, stale, self._maps, (key, extent))
        return extent

    def _is_plain(self, view: View, extent: Extent) -> bool:
        """Returns whether maps of a view take no longer than the maps of any frame of a shot."""
        is_known = self._prepared == self.changes
        return is_known and (not _pasts(view) or self._has_past(view, extent))

    def _note(self, view: View, extent: Extent, seconds: float, is_plain: bool) -> None:
        """Notes that the whole maps of a view were made."""
        if is_plain:
            self._seconds = seconds / extent.count
        self._filled, self._prepared = self.key(view), self.changes
        if _pasts(view):
            self._advanced = (self.changes, extent, _pasts(view), view.time)

    def require_bed(self, extent: Extent) -> Bed:
        """Returns the bed on these samples, made if it is unknown. A caller holds the lock and has
        opened the handle. Raises libocean.Error."""
        if self.bed(extent) is None:
            self._keep_bed(extent, make_bed(self.sea, extent))
        return self._bed

    def _keep_bed(self, extent: Extent, bed: Bed) -> None:
        self._bed, self._bed_of = bed, (*self._bed_words(), extent)

    def show_draft(self, view: View, image_named: dict) -> Extent | None:
        """Fills the images with coarser maps of a view, if the handle is free and the library knows
        where the waves go; otherwise the images keep their content. Makes the bed at once where the
        handle has it. Returns the samples of the content; None for water at rest."""
        whole = view.region.extent(self.own)
        if self._held.values == self.values and not self.is_busy():
            with self.lock:
                self.require_bed(whole)
        if self._draft is not None and self._draft.key == self.key(view):
            return self._put_draft(image_named)
        if not self.is_cheap():
            return self.extent_in(image_named[DISPLACEMENT])
        coarse = whole.coarser(whole.step_for(self.pace.size))
        draft = dataclasses.replace(view, fields=tuple(image_named))
        key = (_COARSE, coarse, *self.key(draft))
        with self.lock:
            stale = self.stale(image_named, (key, coarse))
            if stale:
                begun = time.perf_counter()
                self._maps = fill_maps(self.sea, draft, coarse, self._maps, quick=True)
                self._filled = None
                seconds = time.perf_counter() - begun
                self.pace.note(self.pace.size, seconds, max(whole.samples) // 2)
            self.put(image_named, stale, self._maps, (key, coarse))
        return coarse

    def _put_draft(self, image_named: dict) -> Extent:
        """Fills the images with the maps of the quick job."""
        job = self._draft
        content = ((_QUICK, *job.key), job.extent)
        with self.lock:
            self.put(image_named, self.stale(image_named, content), job.maps, content)
        return job.extent

    def is_whole(self, image) -> bool:
        """Returns whether an image holds a whole map, of this view or of one before."""
        shown = self.shown.get(image.name_full)
        return shown is not None and shown[0][0] not in (_COARSE, _QUICK)

    def extent_in(self, image) -> Extent | None:
        """Returns the samples that an image holds; None for one that nothing has filled."""
        shown = self.shown.get(image.name_full)
        return None if shown is None else shown[1]

    # In the background ----------------------------------------------------------

    def job(self, view: View) -> CoastJob:
        """Returns the job that makes the maps of a view, and lends it the handle."""
        held = self._held
        job = CoastJob(
            self.key(view), held, self.values, self._base_dir, view, lambda: self._held is held
        )
        # Foam and wet ground wait for their past, which the water of another sea does not.
        job.is_quick = self._prepared != self.changes and bool(_pasts(view))
        if job.is_quick:
            job.progress = Progress(0.0, 0.5)
        elif self._draft is not None and self._draft.key == job.key:
            job.progress = Progress(0.5, 1.0)
        if self._bed_of is not None and self._bed_of[:-1] == self._bed_words():
            job.bed_known = self._bed_of[-1]
        if job.bed_known is not None:
            job.is_plain = self._is_plain(view, job.bed_known)
        self._job = job
        return job

    def _end_job(self, key: tuple | None) -> None:
        """Takes the handle back: waits for a job that makes the maps of this key, ends others."""
        job = self._job
        if job is None or not job.is_alive():
            return
        if job.key != key:
            job.cancel()
        job.join()
        if not job.is_cancelled():
            self.adopt(job)

    def adopt(self, job: CoastJob) -> bool:
        """Keeps the maps of a job that has ended. Returns False if the job is of no use."""
        if job.failure is not None or job.key[0] != self.changes or job.lent is not self._held:
            job.close()
            return False
        with self.lock:
            if job.bed is not None:
                self._keep_bed(job.extent, job.bed)
            if job.is_quick:
                self._draft, self._prepared = job, self.changes
                return True
            self._maps, self._draft = job.maps, None
            self._note(job.view, job.extent, job.seconds, job.is_plain)
        return True

    def forget_images(self) -> None:
        super().forget_images()
        self.open_sea.forget_images()

    def close(self) -> None:
        self.open_sea.close()
        held, self._held = self._held, BedSea()
        if not self.is_busy():
            held.close()  # otherwise its job closes it
        self._clock.close()


COASTS = OpenByObject(OpenCoast)
coast_of = COASTS.of
