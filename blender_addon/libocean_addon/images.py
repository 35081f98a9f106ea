# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The float images through which fields reach the node group."""

from __future__ import annotations

import bpy
import numpy as np


def make(ob, field: str, size: int, blank: tuple[float, float, float, float]):
    """An image of one field of an object, of this colour wherever nobody fills it: after loading,
    without the add-on. Blender's own choice, alpha 1, would be foam everywhere."""
    image = bpy.data.images.new(
        f".{ob.name} {field}", size, size, alpha=True, float_buffer=True, is_data=True
    )
    image.alpha_mode = "CHANNEL_PACKED"
    image.generated_color = blank
    return image


def resize(image, size: int) -> None:
    if image.size[0] != size:
        image.generated_width = size
        image.generated_height = size
        if image.size[0] != size:
            image.scale(size, size)


def fill(image, pixels: np.ndarray) -> None:
    """pixels: (size, size, 4), float32, the bottom row first."""
    image.pixels.foreach_set(pixels.ravel())
    image.update_tag()


def aligned(size: int) -> np.ndarray:
    """(size, size, 4), float32, on the boundary to which the library writes fastest."""
    count = size * size * 4
    memory = np.zeros(count + 16, dtype=np.float32)
    first = (-memory.ctypes.data % 64) // 4
    return memory[first : first + count].reshape(size, size, 4)
