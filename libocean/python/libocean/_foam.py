# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Textures of foam: numpy arrays out of ocean_foam_texture."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np

from . import _abi
from ._answers import pointer_to
from ._checks import text, whole
from ._library import call


def _call(request: _abi.FoamTextureRequest, threads: int = 0) -> float:
    options = _abi.Options(ctypes.sizeof(_abi.Options), whole("threads", threads, 0, 1024))
    period = ctypes.c_double()
    call("ocean_foam_texture", request, options, period)
    return period.value


def foam_texture(kind: str, *, size: int = 1024, seed: int = 1, threads: int = 0) -> Any:
    """Returns a texture of foam that tiles: float32 [j, i], size texels per side, a power of two,
    64 .. 4096. kind: "lace", "bubbles" or "streaks", which lie along x. A place is white where its
    value is below the cover, 0 .. 1: `texture < cover` is the share `cover` of the area, read
    bilinearly. Low values are the last to vanish. foam_texture_period() returns the side of a
    tile."""
    request = _abi.FoamTextureRequest(
        ctypes.sizeof(_abi.FoamTextureRequest),
        text("kind", kind),
        whole("size", size, 64, 4096),
        whole("seed", seed, 0, 2**32 - 1),
    )
    _call(request)
    texture = np.empty((request.size, request.size), np.float32)
    request.data, request.count = pointer_to(texture), texture.size
    _call(request, threads)
    return texture


def foam_texture_period(kind: str) -> float:
    """Returns the side of the tile that a kind of texture is made for [m]."""
    return _call(
        _abi.FoamTextureRequest(ctypes.sizeof(_abi.FoamTextureRequest), text("kind", kind), 64)
    )
