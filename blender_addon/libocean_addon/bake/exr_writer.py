# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes an image as an OpenEXR file of float scan lines, by NumPy alone: a Python package of
OpenEXR beside the library OpenEXR inside Blender ends Blender with a segmentation fault.

    header, table of offsets, then each line from the top: its number, its bytes, its channels

The format: [OpenEXR File Layout], openexr.com. No Blender in here.
"""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np

NONE, RLE = 0, 1
"""The compressions, by the format's codes."""
_FLOAT = 2
_MAGIC, _VERSION = 20000630, 2
LONG_NAMES = 1 << 10  # flag beside the version: attributes' names have more than 31 bytes
_LONGEST_SHORT_NAME = 31
_LEAST_RUN, _MOST_IN_A_RUN, _MOST_AS_THEY_ARE = 3, 128, 127


def channel_list(names: str) -> bytes:
    """Returns the attribute of float channels: name, type, linear, sampling."""
    one = b"".join(
        name.encode() + b"\0" + struct.pack("<iiii", _FLOAT, 0, 1, 1) for name in sorted(names)
    )
    return one + b"\0"


def _header(columns: int, rows: int, names: str, compression: int, strings: dict) -> bytes:
    window = struct.pack("<iiii", 0, 0, columns - 1, rows - 1)
    attributes = {
        "channels": ("chlist", channel_list(names)),
        "compression": ("compression", bytes([compression])),
        "dataWindow": ("box2i", window),
        "displayWindow": ("box2i", window),
        "lineOrder": ("lineOrder", b"\0"),  # from the top
        "pixelAspectRatio": ("float", struct.pack("<f", 1.0)),
        "screenWindowCenter": ("v2f", struct.pack("<ff", 0.0, 0.0)),
        "screenWindowWidth": ("float", struct.pack("<f", 1.0)),
        **{name: ("string", text.encode()) for name, text in strings.items()},
    }
    is_long = any(len(name.encode()) > _LONGEST_SHORT_NAME for name in attributes)
    head = struct.pack("<ii", _MAGIC, _VERSION | (LONG_NAMES if is_long else 0))
    for name, (kind, value) in sorted(attributes.items()):
        head += name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value))
        head += value
    return head + b"\0"


def _run_lengths(line: np.ndarray) -> bytes:
    """Returns the bytes of a line, long runs of one byte as a count and that byte, others behind
    their negative count."""
    begins = np.flatnonzero(np.diff(line, prepend=line[:1] ^ 1))
    lengths = np.diff(begins, append=len(line))
    is_long = lengths >= _LEAST_RUN
    whole, out, done = line.tobytes(), bytearray(), 0
    runs = zip(begins[is_long].tolist(), lengths[is_long].tolist(), strict=True)
    for begin, length in (*runs, (len(line), 0)):
        for first in range(done, begin, _MOST_AS_THEY_ARE):
            part = whole[first : min(begin, first + _MOST_AS_THEY_ARE)]
            out += bytes([256 - len(part)]) + part
        for first in range(0, length, _MOST_IN_A_RUN):
            count = min(length - first, _MOST_IN_A_RUN)
            out += bytes([count - 1, whole[begin]])
        done = begin + length
    return bytes(out)


def _compressed(line: np.ndarray) -> bytes:
    """Returns a line as the format's RLE has it: the even bytes before the odd ones, and of each
    the difference to the one before. A line that would not get shorter stays as it is."""
    sorted_bytes = np.concatenate([line[0::2], line[1::2]])
    differences = sorted_bytes.copy()
    differences[1:] -= sorted_bytes[:-1]
    differences[1:] += np.uint8(128)
    short = _run_lengths(differences)
    return short if len(short) < len(line) else line.tobytes()


def write(
    path: Path, names: str, values: np.ndarray, strings: dict[str, str], compression: int
) -> None:
    """Writes an image. names: the channel of each component of `values`, (rows, columns, n), the
    bottom row first; strings: attributes of the header. Raises OSError."""
    rows, columns, _ = values.shape
    order = sorted(range(len(names)), key=names.__getitem__)
    planes = values[::-1].transpose(0, 2, 1)[:, order]
    lines = np.ascontiguousarray(planes, "<f4").view(np.uint8).reshape(rows, -1)
    parts = [_compressed(line) if compression == RLE else line.data for line in lines]
    head = _header(columns, rows, names, compression, strings)
    sizes = np.array([8 + len(part) for part in parts], np.uint64)
    begins = len(head) + 8 * rows + np.cumsum(sizes) - sizes
    with open(path, "wb") as file:
        file.write(head + begins.astype("<u8").tobytes())
        for number, part in enumerate(parts):
            file.write(struct.pack("<ii", number, len(part)))
            file.write(part)
