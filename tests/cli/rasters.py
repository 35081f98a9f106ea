# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Rasters of heights as rasterio (GDAL), tifffile and a few lines of ours write them, for the tests
of `ocean terrain import`."""

import json
import struct
import sys
import zlib
from pathlib import Path

import numpy
import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path += [str(path) for path in ROOT.glob(".venv/lib/python3.*/site-packages")]
try:
    import rasterio
    import tifffile
    from rasterio.transform import from_origin
except ImportError:
    pytest.skip(
        "rasterio and tifffile are not in .venv; scripts/test installs them",
        allow_module_level=True,
    )

COLUMNS, ROWS, CELL = 75, 50, 30.0
WEST, NORTH = 478000.0, 3800000.0


def land(dtype="float32") -> numpy.ndarray:
    """Hills of metres, the first row in the north."""
    y, x = numpy.mgrid[0:ROWS, 0:COLUMNS]
    hills = 500.0 + 200.0 * numpy.sin(x / 9.0) * numpy.cos(y / 7.0) + 3.0 * y
    if numpy.issubdtype(numpy.dtype(dtype), numpy.integer):
        hills = numpy.round(hills)
    return hills.astype(dtype)


def exact_land(dtype="float32") -> numpy.ndarray:
    """Heights without a sine: the same bits everywhere."""
    y, x = numpy.mgrid[0:ROWS, 0:COLUMNS]
    steps = (x * 37 + y * 91 + (x * y) % 13) % 997
    if numpy.issubdtype(numpy.dtype(dtype), numpy.integer):
        return steps.astype(dtype)
    return (steps / numpy.dtype(dtype).type(10)).astype(dtype)


def write_tiff(path, data, crs="EPSG:32611", transform=None, driver="GTiff", **options) -> None:
    with rasterio.open(
        path, "w", driver=driver, width=data.shape[1], height=data.shape[0], count=1,
        dtype=data.dtype, crs=crs, transform=transform or from_origin(WEST, NORTH, CELL, CELL),
        **options,
    ) as file:  # fmt: skip
        file.write(data, 1)


def placed_tags(*keys, cell=(CELL, CELL), tie=(0.0, 0.0, 0.0, WEST, NORTH, 0.0)) -> list:
    """The tags of a GeoTIFF for tifffile; its keys, four numbers each."""
    directory = (1, 1, 0, len(keys) // 4, *keys)
    return [
        (33550, "d", 3, (*cell, 0.0), True),
        (33922, "d", 6, tie, True),
        (34735, "H", len(directory), directory, True),
    ]


def write_tags(path, data, tags=(), **options) -> None:
    """A TIFF with tags that GDAL would not write."""
    tifffile.imwrite(path, data, extratags=tags, metadata=None, **options)


def facts(ocean, *arguments) -> dict:
    return json.loads(ocean.good("terrain", "import", *arguments, "--json"))


def read_back(ocean, name="bed.flt"):
    with rasterio.open(ocean.folder / name) as file:
        return file.read(1), file.transform, file.crs, file.nodata


def png(data: numpy.ndarray, color: int = 0, interlace: int = 0) -> bytes:
    """A PNG file; the samples of a row in the last axis."""
    depth = 8 * data.dtype.itemsize

    def chunk(name: bytes, body: bytes) -> bytes:
        return (
            struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
        )

    rows = b"".join(b"\0" + row.astype(data.dtype.newbyteorder(">")).tobytes() for row in data)
    header = struct.pack(">IIBBBBB", data.shape[1], data.shape[0], depth, color, 0, 0, interlace)
    body = chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + body
