# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The work of a bake, from plain values to files. No Blender in here: it runs in a thread of its
own, which may be asked to stop between two files.

    frames (number, seconds, sea file) -> library -> maps of a period -> EXR files
"""

from __future__ import annotations

import dataclasses
import threading
from collections.abc import Callable
from pathlib import Path

import numpy as np

from . import atlas, exr_files
from .native import libocean


@dataclasses.dataclass(frozen=True)
class Frame:
    """What is baked of one frame of the scene."""

    number: int
    time: float
    sea: str
    """A sea file, not resolved."""


@dataclasses.dataclass(kw_only=True)
class Job:
    """Frames that become files, one after another. Whoever runs it in a thread reads the last five
    fields meanwhile."""

    frames: list[Frame]
    base_dir: str | None
    overwrite: bool

    stop: threading.Event = dataclasses.field(default_factory=threading.Event)
    done: int = 0
    """Frames that are there."""
    written: int = 0
    """Frames of which a file was not there before."""
    failure: Exception | None = None
    warning: str = ""
    """What the user should know of a frame."""

    def run(self, tell: Callable[[], None] = lambda: None) -> None:
        """Writes what is missing; tell is called after each frame. What went wrong is in
        `failure`."""
        try:
            self._run(tell)
        except Exception as failure:  # of the library, the disk, OpenEXR: a thread has no caller
            self.failure = failure

    def _run(self, tell: Callable[[], None]) -> None:
        sea, text = None, ""
        try:
            for frame in self.frames:
                if sea is None or frame.sea != text:
                    if sea is not None:
                        sea.close()
                    sea = libocean.parse(frame.sea, base_dir=self.base_dir)
                    text, resolved = frame.sea, sea.text
                if not self._bake(sea, resolved, frame):
                    return
                self.done += 1
                tell()
        finally:
            if sea is not None:
                sea.close()

    def _bake(self, sea, resolved: str, frame: Frame) -> bool:
        """Whether all files of the frame are there now: not where it was told to stop."""
        raise NotImplementedError


@dataclasses.dataclass(kw_only=True)
class MapJob(Job):
    """Frames that become maps as EXR files."""

    folder: Path
    fields: list[str]
    resolution: int
    package: object
    """The Python package OpenEXR."""

    first_sea: str = ""
    """The resolved sea file of the first frame."""
    slope_variance: float = 0.0
    """Of the waves that the first frame's map leaves out."""
    cover_power: float = 1.0
    """Of the first frame's foam."""

    def _bake(self, sea, resolved: str, frame: Frame) -> bool:
        if self.done == 0:
            self.first_sea = resolved
            self.slope_variance = atlas.lost_slopes(sea.state, self.resolution)
            if "cover" in self.fields:
                self.cover_power = sea.cover_power(frame.time, self.resolution)
        label = exr_files.Label(
            resolved,
            frame.number,
            frame.time,
            float(sea.get("patch_size")),
            self.resolution,
            libocean.version,
        )
        paths = {field: exr_files.path(self.folder, field, frame.number) for field in self.fields}
        missing = [
            field
            for field, path in paths.items()
            if self.overwrite or not exr_files.is_there(path, label, field)
        ]
        if missing and not self.stop.is_set():
            maps = self._maps(sea, frame.time, missing)
            self.written += 1
            for field in missing:
                if self.stop.is_set():
                    return False
                exr_files.write(self.package, paths[field], label, field, maps[field])
        return not self.stop.is_set()

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
        maps = {exr_files.far("cover"): atlases["Displacement"][..., other]}
        for name, values in atlases.items():
            field = exr_files.far(name.lower())
            order = (x, z, y, other)[: len(exr_files.channels(field))]
            maps[field] = values[..., order]
        return maps
