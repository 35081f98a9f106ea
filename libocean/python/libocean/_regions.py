# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Regions: rectangles of a terrain, or of a sea over a bed, written into arrays."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from . import _abi, _library
from ._answers import Array
from ._checks import columns_and_rows, number, row, words
from ._library import choose
from ._maps import Map, named_arrays, outputs_of, require_layout
from ._surface import PRODUCTS, channel_number


def region_arrays(fields: Iterable[str], samples: tuple[int, int]) -> dict[str, Map]:
    """Returns a new array for each field of a region of so many columns and rows."""
    columns, rows = columns_and_rows(samples)
    names = words("fields", fields)
    if not names:
        raise _library.error("a region needs the name of a field", _abi.INVALID_ARGUMENT)
    maps: dict[str, Map] = {}
    for name in names:
        choose("field", name, tuple(PRODUCTS))
        channels = tuple(channel_number(channel) for channel in PRODUCTS[name].channels)
        vector = (len(channels),) if len(channels) > 1 else ()
        maps[name] = (np.empty((rows, columns, *vector), np.float32), channels)
    return maps


def region_buffers(buffers: Iterable[tuple[Array, Sequence[str]]]) -> list[Map]:
    """Returns the buffers of fill_region() with the numbers of their channels. Raises Error for
    arrays that the library cannot write into."""
    arrays = named_arrays(buffers)
    if len({array.shape[:2] for array, _ in arrays}) != 1:
        raise _library.error("arrays of one shape are needed", _abi.INVALID_ARGUMENT)
    for array, names in arrays:
        require_layout(array, names, array.shape[1])
    return [
        (array, tuple(channel_number(name) if name else -1 for name in names))
        for array, names in arrays
    ]


def region_request(origin: tuple[float, float], cell: float, maps: Iterable[Map], axes: str) -> Any:
    """Returns the request that writes a region into arrays of one shape."""
    listed = list(maps)
    rows, columns = listed[0][0].shape[:2]
    outputs = outputs_of(listed)
    turn = choose("axes", axes, _abi.AXES)
    for output in outputs:
        output.axes = turn
    return _abi.RegionRequest(
        ctypes.sizeof(_abi.RegionRequest),
        *(*row("origin", origin, 2), number("cell", cell)),
        *(columns, rows, outputs, len(listed), ctypes.sizeof(_abi.Output)),
    )
