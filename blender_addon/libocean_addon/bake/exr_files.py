# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The files of a bake: flat EXR images, the same pixels and header strings as `ocean bake` writes.
No Blender in here: this runs in a thread of its own.

    provenance of a frame -> strings of the header -> is the file present? -> arrays -> whole file

Headers are read by hand, since a reader of images would believe the sizes that a file claims.
"""

from __future__ import annotations

import contextlib
import dataclasses
import glob
import importlib
import os
import struct
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from ..look import detail_tiles
from ..sea import atlas
from ..terrain.extent import Extent

try:
    from ..legacy.packages import load_bundled as load
except ModuleNotFoundError:  # in the extension, whose wheels Blender has installed
    load = importlib.import_module

EARLIER_STEM = "sea"
"""The stem of files of earlier versions; now it is the name of the blend file."""
_TEMPORARY = ".baking"
_MAPS = ("displacement", "cover", "velocity", "normal", "jacobian")
_OF_COASTS = ("depth", "breaking", "foam", "wetness")
_NUMBERS = ("cover", "jacobian", *_OF_COASTS)  # all else has three components
_ALIKE = {"depth": "height", "breaking": "foam", "wetness": "foam"}
"""By a field that only coasts have, a field of every sea with the same unit."""
_FAR = "_far"  # after a field's name: the coarser maps of a horizon (atlas.py)
DETAIL = tuple(f"detail{number + 1}" for number in range(detail_tiles.MOST_BANDS))
"""Slope tiles, the longest waves first: slopes along x and y, and an empty channel."""
FIELDS = (*_MAPS, *_OF_COASTS, *(f"{field}{_FAR}" for field in _MAPS), *DETAIL)
AXES = "tnb"  # (x, z, y), the default of `ocean bake`
PYTHON = f"{sys.version_info[0]}.{sys.version_info[1]}"


def load_package():
    """Returns the package OpenEXR for this Python. Raises ImportError."""
    load("Imath")  # which OpenEXR asks for when it is used
    return load("OpenEXR")


# Names and headers ------------------------------------------------------------


def far(field: str) -> str:
    return f"{field}{_FAR}"


def is_far(field: str) -> bool:
    return field.endswith(_FAR)


def shape(field: str, resolution: int) -> tuple[int, int]:
    """Returns the rows and columns of a field's files."""
    if field in DETAIL:
        return detail_tiles.SAMPLES, detail_tiles.SAMPLES
    return atlas.shape(resolution) if is_far(field) else (resolution, resolution)


def channels(field: str) -> str:
    """Returns the channels of a field's files. Cover and Jacobian are numbers; coarser normals
    carry the variance of the slopes that they leave out. Slopes have a third component, since
    Cycles reads two channels as grey and alpha."""
    if field.removesuffix(_FAR) in _NUMBERS:
        return "Y"
    return "RGBA" if field == far("normal") else "RGB"


def name(stem: str, field: str, frame: int) -> str:
    """Returns the name that `ocean bake -o FOLDER/STEM.####.exr` gives a file."""
    return f"{stem}.{field}.{frame:04d}.exr"


def path(folder: str | Path, stem: str, field: str, frame: int) -> Path:
    return Path(folder) / name(stem, field, frame)


@dataclasses.dataclass(frozen=True)
class Provenance:
    """The origin of a frame's files, as their headers state it."""

    sea: object
    """The libocean.Sea of the frame."""
    frame: int
    time: float
    """[s]"""
    resolution: int
    """Samples a side of a map; 0 with an extent."""
    extent: Extent | None = None
    """The samples of a region."""
    detail: object = None
    """The libocean.Detail of the frame; needed to write slope tiles, not to recognise them."""

    def is_region(self, field: str) -> bool:
        """Returns whether a field's file is of a region: slope tiles repeat beside one too."""
        return self.extent is not None and field not in DETAIL

    def strings(self, field: str) -> dict[str, str]:
        """Returns the strings of a field's header. Far maps name themselves beside their field."""
        if self.is_region(field):
            return {**self._strings_of_region(field), "ocean:field": field}
        product = field.removesuffix(_FAR)
        how = {"axes": AXES, "resolution": self.resolution, "detail": self.detail}
        strings = self.sea.provenance(self.frame, self.time, product, **how)
        return {**strings, "ocean:field": field}

    def _strings_of_region(self, field: str) -> dict[str, str]:
        axes = "zup" if channels(field) == "Y" else AXES
        alike = _ALIKE.get(field, field)
        strings = self.sea.provenance(self.frame, self.time, alike, axes=axes)
        strings.pop("ocean:period", None)  # a region does not repeat
        extent = self.extent
        numbers = {"origin": extent.origin, "size": extent.size, "samples": extent.samples}
        for name, pair in numbers.items():
            strings[f"ocean:{name}"] = ",".join(repr(part).removesuffix(".0") for part in pair)
        return {**strings, "ocean:resolution": str(extent.samples[0]), "ocean:wraps": "no"}

    def shape(self, field: str) -> tuple[int, int]:
        """Returns the rows and columns of a field's file."""
        return self.extent.shape if self.is_region(field) else shape(field, self.resolution)


class FileError(Exception):
    """The file is not ours, or not whole."""


class OtherKindError(FileError):
    """The EXR file has several parts, tiles or deep pixels: it is not ours."""


_LARGEST_HEADER = 16 << 20
_LONGEST_NAME = 256
_BLOCK = 1 << 13  # bytes that are read at a time: a header is shorter
# Lines in a chunk, by the format's codes: none, rle, zips, zip, piz, pxr24, b44, b44a, dwaa, dwab.
_LINES = (1, 1, 1, 16, 32, 16, 32, 32, 32, 256)


class _Reader:
    """Reads as much of the beginning of a file as is needed."""

    def __init__(self, file) -> None:
        self.file = file
        self.bytes = b""
        self.position = 0

    def _require(self, count: int) -> None:
        end = self.position + count
        while len(self.bytes) < end <= _LARGEST_HEADER and (block := self.file.read(_BLOCK)):
            self.bytes += block
        if len(self.bytes) < end:
            raise FileError

    def take(self, count: int) -> bytes:
        self._require(count)
        taken = self.bytes[self.position : self.position + count]
        self.position += count
        return taken

    def name(self) -> bytes:
        end = self.bytes.find(b"\0", self.position)
        while end < 0 and len(self.bytes) - self.position < _LONGEST_NAME:
            self._require(len(self.bytes) - self.position + 1)
            end = self.bytes.find(b"\0", self.position)
        if not 0 <= end - self.position < _LONGEST_NAME:
            raise FileError
        taken = self.bytes[self.position : end]
        self.position = end + 1
        return taken

    def number(self) -> int:
        return int.from_bytes(self.take(4), "little")


_LONG_NAMES = 1 << 10  # flag beside the version, 2: attributes' names have more than 31 bytes
_FLAGS = _LONG_NAMES | 1 << 9 | 1 << 11 | 1 << 12  # tiles, deep pixels, several parts


def _attributes(reader: _Reader) -> dict[bytes, bytes]:
    if reader.take(4) != b"\x76\x2f\x31\x01":
        raise FileError
    version = reader.number()
    if version & ~_FLAGS != 2:
        raise FileError
    if version & ~_LONG_NAMES != 2:
        raise OtherKindError
    attributes = {}
    while name := reader.name():
        reader.name()  # its type
        attributes[name] = reader.take(reader.number())
    return attributes


def _channels(names: str) -> bytes:
    """Returns the attribute of float channels: name, type, linear, sampling."""
    one = b"".join(
        name.encode() + b"\0" + struct.pack("<iiii", 2, 0, 1, 1) for name in sorted(names)
    )
    return one + b"\0"


def _offsets(reader: _Reader, rows: int, lines: int) -> tuple[int, ...]:
    """Returns the table behind the header: where each chunk begins."""
    chunks = -(-rows // lines)
    return struct.unpack(f"<{chunks}Q", reader.take(8 * chunks))


def _read_line(file, offset: int, size: int) -> int:
    """Returns the first line of the chunk at an offset; raises FileError unless it ends inside the
    file."""
    file.seek(min(offset, size))
    start = file.read(8)
    if len(start) < 8:
        raise FileError
    line, length = struct.unpack("<ii", start)
    if length <= 0 or offset + 8 + length > size:
        raise FileError
    return line


def _require_whole(file, reader: _Reader, rows: int, compression: int) -> None:
    """Raises FileError unless each chunk of the table behind the header lies inside the file."""
    lines = _LINES[compression] if compression < len(_LINES) else 1
    size = os.fstat(file.fileno()).st_size
    for number, offset in enumerate(_offsets(reader, rows, lines)):
        if _read_line(file, offset, size) != number * lines:
            raise FileError


def _require_end(file, reader: _Reader, rows: int, compression: int) -> None:
    """Raises FileError unless the last chunk ends inside the file: a file that was cut off lacks
    it, and an unfinished one has no table."""
    if rows < 1:
        raise FileError
    if compression < len(_LINES):
        offsets = _offsets(reader, rows, _LINES[compression])
        if not all(offsets):
            raise FileError
        _read_line(file, max(offsets), os.fstat(file.fileno()).st_size)


@dataclasses.dataclass(frozen=True)
class Header:
    """The header of a file; without `ocean:` strings it names no sea."""

    strings: dict[str, str]
    columns: int
    rows: int


def read_header(file_path: str | Path) -> Header:
    """Returns the header of a file that has its end: cheaper than is_there, which follows every
    chunk. Raises OSError; FileError for a file that is no EXR or was cut off; OtherKindError for an
    EXR that is no flat image of scan lines."""
    with open(file_path, "rb", buffering=0) as file:
        reader = _Reader(file)
        found = _attributes(reader)
        try:
            left, low, right, high = struct.unpack("<iiii", found[b"dataWindow"])
            _require_end(file, reader, high - low + 1, found[b"compression"][0])
        except (KeyError, IndexError, struct.error) as failure:
            raise FileError from failure
    ours = {name: text for name, text in found.items() if name.startswith(b"ocean:")}
    strings = {
        name.decode(errors="replace"): text.decode(errors="replace") for name, text in ours.items()
    }
    return Header(strings, right - left + 1, high - low + 1)


def is_there(file_path: Path, provenance: Provenance, field: str) -> bool:
    """Returns whether a file is complete and has the content that would be written, in any
    compression."""
    try:
        with open(file_path, "rb") as file:
            reader = _Reader(file)
            found = _attributes(reader)
            rows, columns = provenance.shape(field)
            wanted = {
                name.encode(): text.encode() for name, text in provenance.strings(field).items()
            }
            wanted[b"dataWindow"] = struct.pack("<iiii", 0, 0, columns - 1, rows - 1)
            wanted[b"channels"] = _channels(channels(field))
            if any(found.get(name) != value for name, value in wanted.items()):
                return False
            _require_whole(file, reader, rows, found[b"compression"][0])
    except (OSError, FileError, KeyError, IndexError):
        return False
    return True


# Writing ----------------------------------------------------------------------


class NotWholeError(Exception):
    """The file in the argument could not be written to its end."""


# As `ocean bake` compresses: ZIP saves a thirtieth of float vectors, for five times the time of a
# frame.
_NONE, _RLE = 0, 1
_MOSTLY_NOTHING = ("cover", *DETAIL)

# The package keeps Python waiting while it writes: not for longer than a blink of the interface.
_ROWS_AT_A_TIME = 64


def _write_image(
    package, path: Path, provenance: Provenance, field: str, values: np.ndarray
) -> None:
    imath = importlib.import_module("Imath")
    rows, columns = provenance.shape(field)
    names = channels(field)
    split = np.moveaxis(values, 2, 0) if len(names) > 1 else [values]
    planes = {
        name: np.ascontiguousarray(plane[::-1]) for name, plane in zip(names, split, strict=True)
    }
    header = package.Header(columns, rows)
    header["channels"] = {name: imath.Channel(imath.PixelType(2)) for name in planes}  # 2: float
    header["compression"] = imath.Compression(_RLE if field in _MOSTLY_NOTHING else _NONE)
    strings = provenance.strings(field)
    if not provenance.is_region(field):
        strings["wrapmodes"] = "periodic"
    header.update({name: text.encode() for name, text in strings.items()})
    image = package.OutputFile(str(path), header)
    try:
        for row in range(0, rows, _ROWS_AT_A_TIME):
            count = min(_ROWS_AT_A_TIME, rows - row)
            part = {name: plane[row : row + count].tobytes() for name, plane in planes.items()}
            image.writePixels(part, count)
    finally:
        image.close()


@contextlib.contextmanager
def replacing(file_path: Path) -> Iterator[Path]:
    """Yields a temporary file that takes the place of another at the end, or vanishes: a program
    that reads the other one meanwhile sees no half file."""
    mark = f"{os.getpid()}-{threading.get_ident()}{_TEMPORARY}"
    temporary = file_path.with_name(f".{file_path.name}.{mark}")
    try:
        yield temporary
        os.replace(temporary, file_path)
    finally:
        temporary.unlink(missing_ok=True)


def write(package, file_path: Path, provenance: Provenance, field: str, values: np.ndarray) -> None:
    """Writes a whole file or none. values: (rows, columns, n) or (rows, columns), the bottom row
    first, in the order of AXES."""
    with replacing(file_path) as temporary:
        _write_image(package, temporary, provenance, field, values)
        # The package does not say when the disk ends before the file does.
        if not is_there(temporary, provenance, field):
            raise NotWholeError(file_path)


def remove(folder: str | Path, stem: str) -> int:
    """Removes the files of a bake in a folder, whole ones and remains of interrupted ones, and the
    folder if it is empty then. Returns the number of files."""
    folder = Path(folder)
    names = [f"{glob.escape(stem)}.{field}.*.exr" for field in FIELDS]
    names += [f".{name}.*{_TEMPORARY}" for name in names]
    found = [file_path for name in names for file_path in folder.glob(name)]
    for file_path in found:
        file_path.unlink()
    if found and not any(folder.iterdir()):
        folder.rmdir()
    return len(found)


def inventory(
    folder: str | Path, stem: str, first: int, last: int, fields: tuple[str, ...]
) -> tuple[int, int]:
    """Returns how many frames have a file for each field, and the bytes of all files."""
    wanted = {name(stem, field, f): f for f in range(first, last + 1) for field in fields}
    seen: dict[int, int] = {}
    size = 0
    try:
        with os.scandir(folder) as entries:
            for entry in entries:
                frame = wanted.get(entry.name)
                if frame is not None:
                    seen[frame] = seen.get(frame, 0) + 1
                    size += entry.stat().st_size
    except OSError:
        return 0, 0
    return sum(count == len(fields) for count in seen.values()), size
