# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The textures of foam (libocean.foam_texture) as images: packed, so that a file renders without
the add-on; one of each kind in a file, whatever shows it.

    values 0 .. 1 -> 16 bits, PNG -> packed image, Non-Color
"""

from __future__ import annotations

import concurrent.futures
import struct
import zlib

import bpy
import numpy as np

from ..shared.native import libocean

SIDES = {"lace": 1024, "bubbles": 512, "streaks": 512}
"""Texels a side: 3 MB in all."""
MARK = "libocean_foam"  # custom property of an image: the values it was made of
_VERSION = 1


def png(values: np.ndarray) -> bytes:
    """The file of a grey image of values 0 .. 1 in 16 bits; the first row is at the bottom."""
    height, width = values.shape
    samples = np.rint(values[::-1].astype(np.float64) * 65535.0).astype(">u2")
    bytes_ = samples.view(np.uint8).reshape(height, 2 * width)
    rows = np.ones((height, 1 + 2 * width), np.uint8)  # each as differences to the texel before
    rows[:, 1:3] = bytes_[:, :2]
    rows[:, 3:] = bytes_[:, 2:] - bytes_[:, :-2]

    def chunk(name: bytes, data: bytes) -> bytes:
        return (
            struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
        )

    header = struct.pack(">IIBBBBB", width, height, 16, 0, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", zlib.compress(rows.tobytes(), 6))
        + chunk(b"IEND", b"")
    )


def _make(kind: str) -> bytes:
    return png(libocean.foam_texture(kind, size=SIDES[kind]))


_made: dict[str, concurrent.futures.Future[bytes]] = {}


def prepare() -> None:
    """Begins to make the textures in a thread, while Blender builds the nodes that show them."""
    if not _made:
        pool = concurrent.futures.ThreadPoolExecutor(1)
        _made.update((kind, pool.submit(_make, kind)) for kind in SIDES)
        pool.shutdown(wait=False)


def _packed(kind: str) -> bytes:
    """Returns the packed image of a kind, made once for all files of a session."""
    prepare()
    return _made[kind].result()


def _of(kind: str) -> list:
    """Returns the images of this file, of one kind."""
    mark = f"{kind} {_VERSION}"
    images = (image for image in bpy.data.images if image.get(MARK) == mark)
    return [image for image in images if image.library is None and image.packed_file is not None]


def get(kind: str):
    """Returns the image of a kind, made if it is missing."""
    for image in _of(kind):
        return image
    image = bpy.data.images.new(f".libocean foam {kind}", 1, 1, is_data=True)
    image.pack(data=_packed(kind), data_len=len(_packed(kind)))
    image.source = "FILE"
    image.colorspace_settings.name = "Non-Color"
    image.alpha_mode = "NONE"
    image[MARK] = f"{kind} {_VERSION}"
    return image


def share() -> None:
    """Has all users show the first image of each kind, if an appended asset brought more of
    them."""
    for kind in SIDES:
        first, *others = _of(kind) or [None]
        for other in others:
            other.user_remap(first)
