# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A small sea over a bed, its beds as text, and its images."""

import numpy as np
import OpenImageIO

SEA = """libocean = 1
[water]
depth = 12.0
seabed = "bed.asc"
[grid]
resolution = 64
patch_size = 200.0
[[waves]]
spectrum = "jonswap"
wind_speed = 9.0
fetch = 30000.0
"""
REGION = ("--region", "40,20,160,80", "--cell", "4")
# It rises 1:12 to the east, from 12 m of water to 3 m of land.
BEACH = np.tile(4.0 * np.arange(46) / 12.0 - 12.0, (26, 1))


def grid(heights, cell=4.0) -> str:
    """The text of an ASCII grid; heights: the southern row first."""
    heights = np.atleast_2d(heights)
    rows, columns = heights.shape
    head = f"ncols {columns}\nnrows {rows}\nxllcenter 0\nyllcenter 0\ncellsize {cell}\n"
    return head + "".join(" ".join(f"{h:.3f}" for h in row) + "\n" for row in heights[::-1])


def image(path):
    """The samples of an image, the southern row first."""
    source = OpenImageIO.ImageInput.open(str(path))
    pixels = source.read_image("float")
    source.close()
    return pixels[::-1].squeeze()
