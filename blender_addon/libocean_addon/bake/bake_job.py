# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The work of a bake, from plain values to files. No Blender in here: it runs in a thread of its
own, which may be asked to stop between two files.

    frames (number, seconds, sea file) -> library -> maps of a period, slope tiles -> EXR files
"""

from __future__ import annotations

import dataclasses
import threading
from collections.abc import Callable
from pathlib import Path

import numpy as np

from ..look import detail_tiles
from ..sea import atlas
from ..shared.native import libocean
from . import bake_files, exr_files


@dataclasses.dataclass(frozen=True)
class Frame:
    """A frame of the scene that a job bakes."""

    number: int
    shown: float
    """The frame of the sea that the scene shows, another one where its time is remapped."""
    sea: str
    """A sea file, not resolved."""
    time: float | None = None
    """The sea's time [s]; None until `timed`, unless the object has a time of its own."""

    def timed(self, sea) -> Frame:
        """Returns the frame with its time. sea: the libocean.Sea of its file."""
        if self.time is not None:
            return self
        return dataclasses.replace(self, time=sea.time_of_frame(self.shown))


@dataclasses.dataclass(kw_only=True)
class Job:
    """Frames that become files, one after another. Whoever runs it in a thread reads the last five
    fields meanwhile."""

    frames: list[Frame]
    base_dir: str | None
    overwrite: bool

    stop: threading.Event = dataclasses.field(default_factory=threading.Event)
    done: int = 0
    """Frames whose files are present."""
    written: int = 0
    """Frames that lacked a file before this job."""
    failure: Exception | None = None
    warning: str = ""
    """A warning about a frame."""
    marks: list[str] = dataclasses.field(default_factory=list)
    """The marks by which the files of each frame are recognised."""

    def run(self, tell: Callable[[], None] = lambda: None) -> None:
        """Writes the missing files; tell is called after each frame. An error is in `failure`."""
        try:
            self._run(tell)
        except _StoppedError:
            return
        except Exception as failure:  # of the library, the disk, OpenEXR: a thread has no caller
            self.failure = failure

    def _watch(self, _done: int, _total: int) -> None:
        if self.stop.is_set():
            raise _StoppedError

    def _run(self, tell: Callable[[], None]) -> None:
        sea, text = None, ""
        try:
            for frame in self.frames:
                if sea is None or frame.sea != text:
                    if sea is not None:
                        sea.close()
                    sea = libocean.parse(frame.sea, base_dir=self.base_dir, progress=self._watch)
                    text, resolved = frame.sea, sea.text
                timed = frame.timed(sea)
                if not self._bake(sea, resolved, timed):
                    return
                strings = sea.provenance(timed.number, timed.time)
                mark = bake_files.frame_mark(strings["ocean:sea"], strings["ocean:time"])
                self.marks.append(mark)
                self.done += 1
                tell()
        finally:
            if sea is not None:
                sea.close()

    def _bake(self, sea, resolved: str, frame: Frame) -> bool:
        """Writes the files of a frame that are missing. Returns whether all of them are present
        now: not if the job was stopped."""
        raise NotImplementedError


class _StoppedError(Exception):
    """The user has stopped a job while the library was at work."""


class OtherTilesError(Exception):
    """The slope tiles of a frame differ from the first frame's in waves and size; a bake has one
    size of each tile."""


@dataclasses.dataclass(kw_only=True)
class FieldsJob(Job):
    """Frames that become EXR files, one for each field."""

    folder: Path
    stem: str
    """The beginning of the files' names."""
    fields: list[str]
    package: object
    """The Python package OpenEXR."""
    use_detail: bool
    """True if fields of slope tiles are added when the first frame is known."""

    first_sea: str = ""
    """The resolved sea file of the first frame."""
    slope_variance: float = 0.0
    """The variance of the slopes that the first frame's map leaves out."""
    bands: list[detail_tiles.Band] = dataclasses.field(default_factory=list)
    """The bands of the first frame's slope tiles."""

    def _begin(self, sea, resolved: str, frame: Frame) -> None:
        """Keeps the values of the first frame."""
        self.first_sea = resolved
        if self.use_detail:
            found = self._detail(sea, frame.time)
            self.slope_variance = detail_tiles.lost_slopes(found)
            self.bands = [detail_tiles.band_of(band) for band in found.bands]
            self.fields = [*self.fields, *exr_files.DETAIL[: len(found.bands)]]

    def _detail(self, sea, time: float):
        """Returns the libocean.Detail beside the maps."""
        raise NotImplementedError

    def _tiles(self, bands) -> dict[str, np.ndarray]:
        """Returns slopes along the sea's own x and y, whatever the axes of vectors."""
        first, these = (
            [(band.tile, band.longest_wave, band.shortest_wave) for band in found]
            for found in (self.bands, bands)
        )
        if these != first:
            raise OtherTilesError
        nothing = np.zeros((detail_tiles.SAMPLES, detail_tiles.SAMPLES, 1), np.float32)
        slopes = [np.concatenate([band.slope, nothing], axis=2) for band in bands]
        return dict(zip(exr_files.DETAIL, slopes, strict=False))

    def _write_missing(self, provenance, make) -> bool:
        """Writes the files of a frame that are missing. make(fields): returns the maps of these
        fields by their names, all but slope tiles. Returns as _bake()."""
        paths = {
            field: exr_files.path(self.folder, self.stem, field, provenance.frame)
            for field in self.fields
        }
        missing = [
            field
            for field, path in paths.items()
            if self.overwrite or not exr_files.is_there(path, provenance, field)
        ]
        if missing and not self.stop.is_set():
            maps = make([field for field in missing if field not in exr_files.DETAIL])
            if any(field in exr_files.DETAIL for field in missing):
                detail = self._detail(provenance.sea, provenance.time)
                maps |= self._tiles(detail.bands)
                provenance = dataclasses.replace(provenance, detail=detail)
            self.written += 1
            for field in missing:
                if self.stop.is_set():
                    return False
                exr_files.write(self.package, paths[field], provenance, field, maps[field])
        return not self.stop.is_set()


@dataclasses.dataclass(kw_only=True)
class MapJob(FieldsJob):
    """Frames that become maps as EXR files."""

    resolution: int

    cover_power: float = 1.0
    """The exponent that turns the first frame's foam into its cover."""

    def _begin(self, sea, resolved: str, frame: Frame) -> None:
        super()._begin(sea, resolved, frame)
        self.slope_variance = atlas.lost_slopes(sea.state, self.resolution)
        if "cover" in self.fields:
            self.cover_power = sea.cover_power(frame.time, self.resolution)

    def _bake(self, sea, resolved: str, frame: Frame) -> bool:
        if self.done == 0:
            self._begin(sea, resolved, frame)
        provenance = exr_files.Provenance(sea, frame.number, frame.time, self.resolution)
        return self._write_missing(provenance, lambda fields: self._maps(sea, frame.time, fields))

    def _maps(self, sea, time: float, fields: list[str]) -> dict[str, np.ndarray]:
        near = [field for field in fields if not exr_files.is_far(field)]
        surface = sea.surface(time, self.resolution, near, axes=exr_files.AXES)
        maps = {field: getattr(surface, field) for field in near}
        if len(near) < len(fields):
            maps |= self._far_maps(sea, time)
        return maps

    def _far_maps(self, sea, time: float) -> dict[str, np.ndarray]:
        size = self.resolution
        finest = {name: np.empty((size, size, 4), np.float32) for name in atlas.FINEST}
        sea.fill(time, [(finest[name], atlas.FINEST[name]) for name in finest])
        atlases = {name: np.zeros((*atlas.shape(size), 4), np.float32) for name in finest}
        atlas.fill(sea, time, size, finest, atlases, sea.state)
        x, y, z, other = range(4)
        maps = {
            exr_files.far("cover"): atlases["Displacement"][..., other],
            exr_files.far("jacobian"): atlases["Velocity"][..., other],
        }
        for name, values in atlases.items():
            field = exr_files.far(name.lower())
            order = (x, z, y, other)[: len(exr_files.channels(field))]
            maps[field] = values[..., order]
        return maps

    def _detail(self, sea, time: float):
        return sea.detail(time, self.resolution, samples=detail_tiles.SAMPLES)
