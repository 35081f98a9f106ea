# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The header of an OpenVDB file, read by hand. No Blender in here."""

from __future__ import annotations

import os
import struct
from pathlib import Path


class FileError(Exception):
    """No VDB file, or not all of it."""


def read_header(path: Path) -> dict[str, str]:
    """The texts of a file that is whole. By hand, since OpenVDB believes what sizes it claims."""
    with open(path, "rb") as file:
        size = os.fstat(file.fileno()).st_size

        def take(count: int) -> bytes:
            if count > size - file.tell():
                raise FileError
            return file.read(count)

        def number(form: str = "<I") -> int:
            return struct.unpack(form, take(struct.calcsize(form)))[0]

        if number("<Q") != 0x56444220:  # "VDB "
            raise FileError
        take(3 * 4 + 1 + 36)  # versions, whether grids have offsets, a UUID
        texts = {}
        for _ in range(number()):
            name, kind, value = (take(number()) for _ in range(3))
            if kind == b"string":
                texts[name.decode(errors="replace")] = value.decode(errors="replace")
        for _ in range(number()):  # grids, each up to where it says it ends
            for _ in ("name", "type", "whose instance"):
                take(number())
            take(2 * 8)
            end = number("<q")
            if not file.tell() < end <= size:
                raise FileError
            file.seek(end)
        if file.tell() != size:
            raise FileError
        return texts
