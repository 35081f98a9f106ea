# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The float images through which fields reach the node group."""

from __future__ import annotations

import bpy
import numpy as np


def make(owner: str, field: str, shape: tuple[int, int], blank: tuple[float, float, float, float]):
    """Returns a new image of one field of an object. owner: the object's name. shape: rows and
    columns. blank: the colour of an image that nothing fills, after loading or without the add-on;
    Blender's default, alpha 1, would be foam everywhere."""
    image = bpy.data.images.new(
        f".{owner} {field}", *reversed(shape), alpha=True, float_buffer=True, is_data=True
    )
    image.alpha_mode = "CHANNEL_PACKED"
    image.generated_color = blank
    return image


def let_go(image) -> bool:
    """Unpacks an image that Blender packed into the file, as it offers to do with modified images
    at its end. Returns whether the image was packed; its pixels are lost then."""
    if image.packed_file is None:
        return False
    image.unpack(method="REMOVE")
    image.source = "GENERATED"
    return True


def resize(image, shape: tuple[int, int]) -> None:
    height, width = shape
    if tuple(image.size) != (width, height):
        image.generated_width = width
        image.generated_height = height
        if tuple(image.size) != (width, height):
            image.scale(width, height)


def fill(image, pixels: np.ndarray) -> None:
    """pixels: (rows, columns, 4), float32, the bottom row first."""
    image.pixels.foreach_set(pixels.ravel())
    image.update_tag()


def aligned(shape: tuple[int, int]) -> np.ndarray:
    """(rows, columns, 4), float32, on the boundary to which the library writes fastest."""
    count = shape[0] * shape[1] * 4
    memory = np.zeros(count + 16, dtype=np.float32)
    first = (-memory.ctypes.data % 64) // 4
    return memory[first : first + count].reshape(*shape, 4)
