# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that the files of a bake are present, whole, and of the sea that was baked. No Blender in
here.

    record of a bake, frames -> path and header of each file -> faults by kind and frame

A header is read once as long as its file keeps size and time.
"""

from __future__ import annotations

import dataclasses
import enum
import functools
import hashlib
import os
from collections.abc import Callable, Iterable
from pathlib import Path

from ..volumes import vdb_files
from . import exr_files


class Fault(enum.Enum):
    """Why a file does not show the sea of its frame."""

    MISSING = "missing"
    BROKEN = "broken"
    """The file is no EXR or VDB file, or was cut off."""
    FOREIGN = "foreign"
    """The file shows another sea, time, frame, field or size."""
    NAMELESS = "nameless"
    """Its header names no sea: an older or another program wrote the file. Such files play."""


def sea_mark(sea: str) -> str:
    """Returns a short text that stands for a resolved sea file."""
    return hashlib.sha256(sea.encode()).hexdigest()[:12]


def frame_mark(sea: str, time: str) -> str:
    """Returns a short text that stands for a sea at a time, written as headers have it."""
    return sea_mark(f"{time}\n{sea}")


@dataclasses.dataclass(frozen=True)
class Identity:
    """The content of a file, by its header."""

    sea: str
    frame_mark: str
    frame: str
    field: str
    size: tuple[int, int] | None
    """Rows and columns of an image."""


def _identity(strings: dict[str, str], size: tuple[int, int] | None) -> Identity | None:
    sea = strings.get("ocean:sea")
    if sea is None:
        return None
    mark = frame_mark(sea, strings.get("ocean:time", ""))
    frame, field = strings.get("ocean:frame", ""), strings.get("ocean:field", "")
    return Identity(sea_mark(sea), mark, frame, field, size)


def _read(path: str) -> Identity | Fault:
    try:
        if path.endswith(".vdb"):
            found = _identity(vdb_files.read_header(Path(path)), None)
        else:
            header = exr_files.read_header(path)
            found = _identity(header.strings, (header.rows, header.columns))
    except exr_files.OtherKindError:
        return Fault.NAMELESS
    except (OSError, exr_files.FileError, vdb_files.FileError):
        return Fault.BROKEN
    return found or Fault.NAMELESS


_known: dict[str, tuple[int, int, Identity | Fault]] = {}


def identity(path: str) -> Identity | Fault:
    """Returns the content of a file by its header, or the reason why it is unknown."""
    try:
        now = os.stat(path)
    except OSError:
        return Fault.MISSING
    known = _known.get(path)
    if known is None or known[:2] != (now.st_mtime_ns, now.st_size):
        known = _known[path] = (now.st_mtime_ns, now.st_size, _read(path))
    return known[2]


@dataclasses.dataclass(frozen=True)
class Expected:
    """The marks that a bake recorded, by frame; None, or a frame without one: not recorded."""

    frame_marks: dict[int, str]
    sea: str | None = None
    """The mark of the sea, if all frames have the same one."""
    resolution: int | None = None
    region: tuple[int, int] | None = None
    """Rows and columns of the images of a region."""

    def fault(self, found: Identity, frame: int, field: str | None) -> Fault | None:
        """Returns FOREIGN if a file shows another frame, sea or field. field: of an image."""
        is_other = bool(found.frame) and found.frame != str(frame)
        if field is not None:
            is_other |= bool(found.field) and found.field != field
            if self.region is not None and field not in exr_files.DETAIL:
                is_other |= found.size != self.region
            elif self.resolution is not None:
                is_other |= found.size != exr_files.shape(field, self.resolution)
        if frame in self.frame_marks:
            is_other |= found.frame_mark != self.frame_marks[frame]
        elif self.sea is not None:
            is_other |= found.sea != self.sea
        return Fault.FOREIGN if is_other else None

    @functools.cached_property
    def _marks(self) -> frozenset[str]:
        return frozenset(self.frame_marks.values())

    def knows(self, found: Identity) -> bool:
        """Returns whether a file is one of this bake's, of whichever frame."""
        return found.sea == self.sea or found.frame_mark in self._marks


Faults = dict[Fault, dict[int, str]]
"""By kind and frame, the first file that has it."""


def find(
    frames: Iterable[int],
    fields: Iterable[str | None],
    path: Callable[[str | None, int], Path | str],
    expected: Expected,
) -> Faults:
    """Returns the faults of the files of these frames. path(field, frame): the path of a file. A
    volume has one field, None."""
    faults: Faults = {}
    fields = tuple(fields)
    for frame in frames:
        for field in fields:
            file_path = str(path(field, frame))
            found = identity(file_path)
            fault = found if isinstance(found, Fault) else expected.fault(found, frame, field)
            if fault is not None:
                faults.setdefault(fault, {}).setdefault(frame, file_path)
    return faults


def in_words(frames: Iterable[int], most: int = 12) -> str:
    """Returns numbers as ranges: "3, 7-9". Of more ranges than `most` the end is left out."""
    ranges: list[list[int]] = []
    for frame in sorted(frames):
        if ranges and frame == ranges[-1][1] + 1:
            ranges[-1][1] = frame
        else:
            ranges.append([frame, frame])
    texts = [str(low) if low == high else f"{low}-{high}" for low, high in ranges]
    return ", ".join(texts if len(texts) <= most else [*texts[:most], "..."])
