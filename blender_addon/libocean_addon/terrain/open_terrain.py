# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Open terrains, one for each object: the library's handles, the maps that were made last, and what
the images hold.

    Extent + terrain -> Maps: pixels of the ground, and of the masks of each group -> images
"""

from __future__ import annotations

import time

import numpy as np

from ..shared import drafts, images, paths
from ..shared.compat import tr_label
from ..shared.native import libocean
from ..shared.open_subject import OpenByObject, OpenSubject, changed
from . import extent as extents
from .camera_mesh import CameraVertices, CameraView, make_vertices
from .extent import Extent
from .node_group import CHANNELS, GROUND, MASKS, image_of
from .terrain_text import TerrainValues

_RESOLUTION = "terrain.resolution"
_FIRST = 1e-7  # [s a sample] that a first map is expected to take
_SMALLEST = 64  # samples a side of a terrain that draws a draft
_SLOW_DRAFT = 0.35
"""[s] A draft that takes longer is left out while values move: the land stays as it was."""

Maps = dict[str, np.ndarray]
"""Pixels (rows, columns, 4) by the input of the node group."""


def own_extent(terrain) -> Extent:
    """Returns the samples of a terrain's own map."""
    own = terrain.domain
    return Extent(own.origin, own.cell, own.samples, own.wraps)


def fill_maps(terrain, extent: Extent, groups: tuple[str, ...], maps: Maps | None = None) -> Maps:
    """Returns the maps of an extent, in the arrays of `maps` where they fit. groups: the groups
    whose masks the land has."""
    channels = {GROUND: CHANNELS}
    for group in groups:
        channels[image_of(group)] = (*MASKS[group], "")[:4]
    made = {}
    for name in channels:
        before = (maps or {}).get(name)
        fits = before is not None and before.shape[:2] == extent.shape
        made[name] = before if fits else images.aligned(extent.shape)
    buffers = [(made[name], channels[name]) for name in channels]
    if extent.is_own and extent.wraps and not groups:
        terrain.fill(buffers)
    else:
        terrain.fill_region(buffers, extent.origin, extent.cell)
    return made


class TerrainJob(drafts.Job):
    """Makes the whole maps and the readings of a terrain, in a clone of it."""

    def __init__(self, terrain, key: tuple, extent: Extent, groups: tuple[str, ...]) -> None:
        super().__init__(key)
        self.terrain, self.extent, self.groups = terrain, extent, groups
        self.view: CameraView | None = None
        """The camera around which a mesh is wanted too."""
        self.maps: Maps | None = None
        self.vertices: CameraVertices | None = None
        self.state: dict | None = None
        self.seconds_a_sample = 0.0

    def work(self) -> None:
        self.require_wanted()
        maps = self.maps
        if maps is None:
            begun = time.perf_counter()
            maps = fill_maps(self.terrain, self.extent, self.groups)
            self.seconds_a_sample = (time.perf_counter() - begun) / self.extent.count
        self.require_wanted()
        if self.view is not None:
            self.vertices = make_vertices(self.terrain, self.view)
        self.require_wanted()
        self.state = self.terrain.state
        self.maps = maps

    def close(self) -> None:
        self.terrain.close()

    def status_text(self, name: str) -> str:
        columns, rows = self.extent.samples
        text = tr_label("{}: {} x {} samples", name, columns, rows)
        return f"{text}, {self.share:.0%}" if self.ticks else text


class OpenTerrain(OpenSubject):
    """The library's terrain of one object, its maps, and the content of its images."""

    def __init__(self) -> None:
        super().__init__()
        self.groups: tuple[str, ...] = ()
        """The groups of parameters whose masks the land has."""
        self.region: tuple[tuple[float, ...], float] | None = None
        """Corners and cell of the region to show; None: the land's own samples."""
        self.view: CameraView | None = None
        """The camera around which the mesh was requested last."""
        self.vertices: CameraVertices | None = None
        """The mesh around the camera that was made last."""
        self.vertices_of: tuple | None = None  # its changes and view
        self._draft = None  # the handle with fewer samples
        self._draft_values: TerrainValues | None = None
        self._draft_seconds = 0.0
        self._built = -1  # the changes for which the handle has built the parts of maps
        self._maps: Maps = {}
        self._filled: tuple | None = None  # changes, extent and groups of the maps
        self._whole: tuple | None = None  # the same of the last whole map
        self._seconds = _FIRST  # a sample of the last whole map

    @property
    def size(self) -> int:
        """Returns the samples along the longer side of the terrain's own map."""
        return max(self.own.samples)

    @property
    def own(self) -> Extent:
        return own_extent(self.handle)

    @property
    def extent(self) -> Extent:
        """Returns the samples of the whole map that is shown. Raises ExtentError."""
        if self.region is None:
            return self.own
        return extents.of_region(*self.region, self.own)

    @property
    def key(self) -> tuple:
        """Returns the values that the whole map depends on. Raises ExtentError."""
        return self.changes, self.extent, self.groups

    def _open(self, values: TerrainValues):
        return libocean.parse_terrain(
            values.text(), base_dir=paths.blend_folder(), progress=drafts.tell_watcher_of_share
        )

    def follow(self, values: TerrainValues) -> None:
        super().follow(values)
        self.groups = values.groups()

    def state_for_look(self) -> dict:
        """Returns the state of the terrain; in a draft, the state of the terrain with fewer
        samples, without waiting for the whole."""
        is_behind = self._draft is not None and self._draft_values == self.values
        if self.state is None and self._built != self.changes and is_behind:
            return self._draft.state
        return self.read_state()

    def is_whole(self) -> bool:
        """Returns whether the whole map of these values was shown or made for it."""
        return self._whole == self.key

    def is_quick(self) -> bool:
        """Returns whether a whole map takes less time than a user notices."""
        extent = self.extent
        is_small = self.pace.size >= max(extent.samples) and not self.is_carved()
        return is_small or self._seconds * extent.count < drafts.SECONDS / 2

    def is_carved(self) -> bool:
        """Returns whether streams or a shore shape the land, which take seconds at any size."""
        return "stream" in self.groups or "coast" in self.groups

    def show(self, image_named: dict) -> Extent:
        """Fills the images with the whole maps. image_named: images by inputs."""
        extent, key = self.extent, self.key
        with self.lock:
            stale = self.stale(image_named, key)
            if stale and self._filled != key:
                begun = time.perf_counter()
                self._fill(self.handle, extent, key)
                self._seconds = (time.perf_counter() - begun) / extent.count
                self._built = self.changes
            self.put(image_named, stale, self._maps, key)
            self._whole = key
        return extent

    def show_draft(self, image_named: dict) -> Extent:
        """Fills the images with maps of the same terrain with fewer samples, and so without its
        shortest waves. If that takes too long, the images keep their content."""
        held = self.shown.get(image_named[GROUND].name_full)
        if held is not None and self._draft_seconds > _SLOW_DRAFT:
            return held[1]
        with self.lock:
            begun = time.perf_counter()
            draft, extent = self._draft_and_extent()
            key = (self.changes, extent, self.groups)
            stale = self.stale(image_named, key)
            if stale:
                self._fill(draft, extent, key)
                self.put(image_named, stale, self._maps, key)
                self._draft_seconds = time.perf_counter() - begun
                self.pace.note(self.pace.size, self._draft_seconds, max(self.extent.samples) // 2)
        return extent

    def _draft_and_extent(self) -> tuple:
        """Returns the handle and the samples of a draft: the terrain with fewer samples, or fewer
        of its samples where it is built or is an elevation model, which has no others."""
        whole, step = self.extent, 1
        while max(whole.samples) > self.pace.size * step:
            step *= 2
        if self._built == self.changes or self.values.values["base"]:
            return self.handle, whole.coarser(step)
        resolution = int(self.values.values["resolution"])
        side = resolution // step if whole.is_own else min(resolution, self.pace.size)
        draft = self._draft_of(max(_SMALLEST, side))
        return draft, own_extent(draft) if whole.is_own else whole.coarser(step)

    def _fill(self, terrain, extent: Extent, key: tuple) -> None:
        self._filled = None  # until the library has returned
        self._maps = fill_maps(terrain, extent, self.groups, self._maps)
        self._filled = key

    def _draft_of(self, size: int):
        """Returns the handle of the same terrain with so many samples per side."""
        if self._draft is None:
            self._draft, self._draft_values = self.handle.clone(), self.values
        self._draft.set_all({**changed(self._draft_values, self.values), _RESOLUTION: str(size)})
        self._draft_values = self.values
        return self._draft

    def job(self, view: CameraView | None = None) -> TerrainJob:
        """Returns the job that makes the whole maps, and the mesh around a camera. Raises
        ExtentError."""
        job = TerrainJob(self.handle.clone(), (self.key, view), self.extent, self.groups)
        job.view = view
        if self._filled == self.key:
            job.maps = self._maps
        return job

    def adopt(self, job: TerrainJob) -> bool:
        """Replaces handle and maps by the results of a job that has ended. Returns False if the job
        is of no use."""
        if job.failure is not None or job.key[0] != self.key:
            job.close()
            return False
        with self.lock:
            self.handle.close()
            self.handle, self.state, self.view = job.terrain, job.state, job.view
            self._maps, self._filled, self._whole = job.maps, self.key, self.key
            self._built = self.changes
            if job.seconds_a_sample > 0.0:
                self._seconds = job.seconds_a_sample
            if job.vertices is not None:
                self.vertices, self.vertices_of = job.vertices, (self.changes, job.view)
        return True

    def mesh_around(self, view: CameraView) -> CameraVertices:
        """Returns the mesh around a camera, made if it is another than the last one."""
        if not self.has_mesh_around(view):
            self.vertices = make_vertices(self.handle, view)
            self.vertices_of = (self.changes, view)
        return self.vertices

    def has_mesh_around(self, view: CameraView) -> bool:
        """Returns whether the mesh around a camera is the one that was made last."""
        return self.vertices_of == (self.changes, view)

    def extent_in(self, image) -> Extent | None:
        """Returns the samples of the map that an image holds; None if it is unknown."""
        held = self.shown.get(image.name_full)
        return None if held is None else held[1]

    def close(self) -> None:
        if self._draft is not None:
            self._draft.close()
        self._draft = None
        super().close()


TERRAINS = OpenByObject(OpenTerrain)
terrain_of = TERRAINS.of
