#!/usr/bin/python3
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Draws surf in a bay from straight above, frame by frame, from maps of the sea's region.

It was judged by this list, which is older than the picture: lines of surf walk to the beach, turn
with it and last until they arrive; foam stays behind them and fades; the water line goes up and
down; sand stays dark behind it; crests in the bay bend, and nothing jumps.
usage: surf.py FOLDER COLUMNSxROWS      writes FOLDER/0000.png ...
"""

import sys
from pathlib import Path

import numpy as np
import OpenImageIO as oiio

import libocean

CORNER, WIDTH = (840.0, 470.0), 420.0  # m, of the view
FRAMES, RATE, FIRST = 24, 8.0, 60.0
SUN = np.array([-0.62, 0.45, 0.64])
SAND, WET_SAND = np.array([0.55, 0.47, 0.34]), np.array([0.27, 0.22, 0.15])
GRASS, ROCK = np.array([0.13, 0.16, 0.05]), np.array([0.24, 0.21, 0.18])
DEEP, FOAM = np.array([0.012, 0.085, 0.115]), np.array([0.85, 0.88, 0.9])
LOSS = np.array([0.62, 0.17, 0.13])  # 1/m, of light down to the bed and up again


def ease(low, high, value):
    t = np.clip((value - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def read(maps, x, y):
    """Returns maps [j, i, ...] at places in samples, bilinear."""
    x, y = np.clip(x, 0, maps.shape[1] - 1.001), np.clip(y, 0, maps.shape[0] - 1.001)
    i, j = x.astype(int), y.astype(int)
    u, v = (x - i)[..., None], (y - j)[..., None]
    south = (1 - u) * maps[j, i] + u * maps[j, i + 1]
    return (1 - v) * south + v * ((1 - u) * maps[j + 1, i] + u * maps[j + 1, i + 1])


def frame(sea, time, columns, rows, step, lace):
    names = ["displacement", "normal", "cover", "depth", "wetness", "breaking"]
    samples = (columns + 1, rows + 1)
    maps = sea.region(time, CORNER, samples, step, names)
    all_maps = np.dstack([maps[name].reshape(rows + 1, columns + 1, -1) for name in names])
    # The label that is displayed at each pixel.
    px, py = np.meshgrid(np.arange(columns) + 0.5, np.arange(rows) + 0.5)
    x, y = px, py
    for _ in range(4):
        moved = read(all_maps, x, y)
        x, y = px - moved[..., 0] / step, py - moved[..., 1] / step
    here = read(all_maps, x, y)
    height, normal, cover, depth, wet = (
        here[..., 2],
        here[..., 3:6],
        here[..., 6:7],
        here[..., 7:8],
        here[..., 8:9],
    )
    bed = height[..., None] - depth
    # The ground, its shading by the slope of the bed.
    east, north = np.gradient(bed[..., 0], step)[::-1]
    ground_light = (SUN[2] - SUN[0] * east - SUN[1] * north) / np.sqrt(1 + east**2 + north**2)
    sand = SAND + np.clip(wet, 0, 1) * (WET_SAND - SAND)
    steep = ease(0.25, 0.5, np.hypot(east, north))[..., None]
    dry = ease(2.5, 4.0, bed)
    ground = sand + dry * (GRASS - sand)
    ground = ground + steep * (ROCK - ground)
    land = ground * (0.45 + 0.9 * np.clip(ground_light, 0, 1))[..., None]
    # The water: light from the bed, its own, and the sky in it, brighter towards the sun.
    left = np.exp(-LOSS * np.maximum(depth, 0))
    body = DEEP + left * (WET_SAND * 1.05 - DEEP)
    lit = (normal @ SUN)[..., None]
    tilt = normal[..., 0:1] * SUN[0] + normal[..., 1:2] * SUN[1]
    water = body * (0.35 + 1.0 * lit) + np.array([0.05, 0.07, 0.09]) * (1 + 3.2 * tilt)
    # White where waves break, and where the lace lies below the cover of foam.
    white = ease(-0.15, 0.15, cover - lace) * ease(0.0, 0.15, cover)
    white = np.maximum(white, ease(0.3, 0.8, here[..., 9:10]))
    water = water + white * (FOAM * (0.55 + 0.5 * lit) - water)
    colour = np.where(depth > 0.0, water, land)
    return np.clip(colour, 0, 1)[::-1] ** (1 / 2.2)


def main():
    folder = Path(sys.argv[1])
    columns, rows = map(int, sys.argv[2].split("x"))
    step = WIDTH / columns
    # A lace of noise of some metres, as uniform as the library's texture, which stays where it is.
    random = np.random.default_rng(3)
    waves = np.fft.fft2(random.normal(size=(rows, columns)))
    k = np.hypot(*np.meshgrid(np.fft.fftfreq(columns, step), np.fft.fftfreq(rows, step)))
    noise = np.fft.ifft2(waves * np.exp(-((k - 0.1) ** 2) / 0.006)).real
    lace = noise.ravel().argsort().argsort().reshape(rows, columns, 1) / noise.size
    with libocean.open(Path(__file__).parent / "beach.toml") as sea:
        for number in range(FRAMES):
            image = frame(sea, FIRST + number / RATE, columns, rows, step, lace)
            pixels = oiio.ImageBuf(oiio.ImageSpec(columns, rows, 3, oiio.UINT8))
            pixels.set_pixels(oiio.ROI.All, np.ascontiguousarray(image, np.float32))
            pixels.write(str(folder / f"{number:04}.png"))


if __name__ == "__main__":
    main()
