# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Open terrains, one for each object: the library's handles, the map that was made last, and what
the image holds.
"""

from __future__ import annotations

import contextlib
import threading
import time
from collections.abc import Iterator

import bpy
import numpy as np

from ..shared import drafts, images
from ..shared.compat import tr_label
from ..shared.native import libocean
from ..shared.open_by_object import OpenByObject
from .node_group import CHANNELS
from .terrain_text import TerrainValues

_RESOLUTION = "terrain.resolution"
_FIRST = 1e-7  # [s a sample] that a first map is expected to take


class TerrainJob(drafts.Job):
    """Makes the whole map and the readings of a terrain, in a clone of it."""

    def __init__(self, terrain, changes: int, size: int) -> None:
        super().__init__((changes, size))
        self.terrain, self.changes, self.size = terrain, changes, size
        self.pixels: np.ndarray | None = None
        self.state: dict | None = None
        self.seconds_a_sample = 0.0

    def work(self) -> None:
        # The library does not look up within a call: some seconds at most, beside the user's work.
        self._require_wanted()
        pixels = images.aligned((self.size, self.size))
        begun = time.perf_counter()
        self.terrain.fill([(pixels, CHANNELS)])
        self.seconds_a_sample = (time.perf_counter() - begun) / self.size**2
        self._require_wanted()
        self.state = self.terrain.state
        self.pixels = pixels

    def _require_wanted(self) -> None:
        if self.is_cancelled():
            raise drafts.CancelledError

    def close(self) -> None:
        self.terrain.close()

    def said(self, name: str) -> str:
        return tr_label("{}: {} x {} samples", name, self.size, self.size)


class OpenTerrain:
    """The library's terrain of one object, its map, and what was shown last."""

    def __init__(self) -> None:
        self.lock = threading.Lock()  # renders run in a thread of their own
        self.terrain = None
        self.values: TerrainValues | None = None
        self.changes = 0
        self.state: dict | None = None  # read_state()
        self.state_before: dict | None = None  # of the values before these
        self.pace = drafts.Pace()
        self._draft = None  # the handle with fewer samples
        self._draft_values: TerrainValues | None = None
        self._pixels: np.ndarray | None = None
        self._filled: tuple | None = None  # changes and size of the map in _pixels
        self._whole: tuple | None = None  # changes and size of the last whole map
        self._shown: dict[str, tuple] = {}  # by image: the changes and size of its map
        self._seconds = _FIRST  # a sample of the last whole map

    @property
    def size(self) -> int:
        """Returns the samples per side of the whole map."""
        return self.terrain.map_resolution()

    def follow(self, values: TerrainValues) -> None:
        """Makes it the terrain of these values; raises libocean.Error and leaves it unchanged
        otherwise."""
        if values == self.values:
            return
        if self.terrain is None or values.structure() != self.values.structure():
            base_dir = bpy.path.abspath("//") or None
            opened = libocean.parse_terrain(
                values.text(), base_dir=base_dir, progress=drafts.tell_watcher
            )
            self.close()
            self.terrain = opened
        else:
            self.terrain.set_all(_changed(self.values, values))
        self.values = values
        self.state_before = self.state or self.state_before
        self.state = None
        self.changes += 1

    def read_state(self) -> dict:
        if self.state is None:
            self.state = self.terrain.state
        return self.state

    def is_whole(self) -> bool:
        """Returns whether the whole map of these values was shown or made for it."""
        return self._whole == (self.changes, self.size)

    def is_quick(self) -> bool:
        """Returns whether a whole map takes less time than a user notices."""
        return self.pace.size >= self.size or self._seconds * self.size**2 < drafts.SECONDS / 2

    def show(self, image) -> None:
        """Fills the image with the whole map."""
        size = self.size
        with self._stale(image, size) as is_stale:
            if is_stale:
                if self._filled != (self.changes, size):
                    begun = time.perf_counter()
                    self._fill(self.terrain, size)
                    self._seconds = (time.perf_counter() - begun) / size**2
                self._put(image)
        self._whole = (self.changes, size)

    def show_draft(self, image) -> None:
        """Fills the image with the map of the same terrain with fewer samples, and so without its
        shortest waves."""
        size = min(self.size, self.pace.size)
        with self._stale(image, size) as is_stale:
            if is_stale:
                begun = time.perf_counter()
                self._fill(self._draft_of(size), size)
                self._put(image)
                self.pace.note(size, time.perf_counter() - begun, self.size // 2)

    @contextlib.contextmanager
    def _stale(self, image, size: int) -> Iterator[bool]:
        """Yields whether an image holds another map than the present one of that size."""
        with self.lock:
            if images.let_go(image):
                self._shown.pop(image.name_full, None)
            yield self._shown.get(image.name_full) != (self.changes, size)
            self._shown[image.name_full] = (self.changes, size)

    def _fill(self, terrain, size: int) -> None:
        if self._pixels is None or len(self._pixels) != size:
            self._pixels = images.aligned((size, size))
        self._filled = None  # until the library has returned
        terrain.fill([(self._pixels, CHANNELS)])
        self._filled = (self.changes, size)

    def _put(self, image) -> None:
        images.resize(image, self._pixels.shape[:2])
        images.fill(image, self._pixels)

    def _draft_of(self, size: int):
        """Returns the handle of the same terrain with so many samples per side."""
        if self._draft is None:
            self._draft, self._draft_values = self.terrain.clone(), self.values
        changed = _changed(self._draft_values, self.values)
        self._draft.set_all({**changed, _RESOLUTION: str(size)})
        self._draft_values = self.values
        return self._draft

    def job(self) -> TerrainJob:
        """Returns the job that makes the whole map."""
        return TerrainJob(self.terrain.clone(), self.changes, self.size)

    def take_over(self, job: TerrainJob) -> bool:
        """Replaces handle and map by those of a job that has ended. Returns False if the job is of
        no use."""
        if job.failure is not None or job.changes != self.changes:
            job.close()
            return False
        with self.lock:
            self.terrain.close()
            self.terrain, self.state = job.terrain, job.state
            self._pixels, self._filled, self._whole = job.pixels, job.key, job.key
            self._seconds = job.seconds_a_sample
        return True

    def forget_images(self) -> None:
        """Forgets, after undo and loading, what images hold."""
        self._shown.clear()

    def close(self) -> None:
        for handle in (self.terrain, self._draft):
            if handle is not None:
                handle.close()
        self.terrain = self._draft = None


def _changed(before: TerrainValues, now: TerrainValues) -> dict[str, str]:
    """Returns the parameters that differ, by their paths."""
    return dict(now.by_name().items() - before.by_name().items())


_terrains = OpenByObject(OpenTerrain)
terrain_of = _terrains.of
forget = _terrains.forget
close_all = _terrains.close_all
