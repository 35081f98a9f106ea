# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""How fast a terrain is on one thread: heights and both slopes, against eleven octaves of Perlin
noise by FastNoiseSIMD, whose heights have no slopes, and against numpy's transforms, interleaved.

usage: terrain.py [SIDE ...]     in a Python with numpy; FastNoiseSIMD where pyfastnoisesimd imports
"""

import sys

import numpy as np
from rounds import measured, print_table

import libocean

try:
    import pyfastnoisesimd
except ImportError:
    pyfastnoisesimd = None

OCTAVES = 11


class Ours:
    """A terrain whose beta changes with every call: a slider."""

    def __init__(self, side: int) -> None:
        self.side = side
        self.terrain = self._made()
        self.maps = np.empty((3, side, side, 1), np.float32)
        self.beta = 2.0

    def _made(self) -> libocean.Terrain:
        return libocean.terrain(threads=1, resolution=self.side, patch_size=2000.0)

    def refilter(self) -> None:
        self.beta = 4.1 - self.beta
        self.terrain.set("beta", self.beta)
        names = (("height",), ("slope_x",), ("slope_y",))
        self.terrain.fill(list(zip(self.maps, names, strict=True)))

    def cold(self) -> None:
        self.terrain.close()
        self.terrain = self._made()
        self.refilter()


class FastNoise:
    def __init__(self, side: int) -> None:
        self.side = side
        self.noise = pyfastnoisesimd.Noise(seed=1, numWorkers=1)
        self.noise.noiseType = pyfastnoisesimd.NoiseType.PerlinFractal
        self.noise.fractal.octaves = OCTAVES
        self.noise.frequency = 1e-3

    def heights(self) -> None:
        self.noise.genAsGrid((self.side, self.side))


class Numpy:
    """The transforms of numpy over noise that is kept, its amplitudes made new."""

    def __init__(self, side: int) -> None:
        self.side = side
        n = np.arange(side // 2 + 1)
        m = np.fft.fftfreq(side, 1.0 / side)
        self.kx, self.ky = 1j * n[None, :], 1j * m[:, None]
        self.square = n[None, :] ** 2.0 + m[:, None] ** 2.0
        self.square[0, 0] = 1.0
        shape = self.square.shape
        draw = np.random.default_rng(1)
        self.noise = draw.standard_normal(shape) + 1j * draw.standard_normal(shape)
        self.beta = 2.0

    def refilter(self) -> None:
        self.beta = 4.1 - self.beta
        h = self.noise * self.square ** (-0.5 * self.beta)
        for field in (h, self.kx * h, self.ky * h):
            np.fft.irfft2(field, s=(self.side, self.side))


def main() -> None:
    sides = [int(side) for side in sys.argv[1:]] or [1024, 2048]
    columns = []
    for side in sides:
        ours = Ours(side)
        works = {
            "ours: refiltered, height and both slopes": ours.refilter,
            "ours: from nothing": ours.cold,
            "numpy: the same, refiltered": Numpy(side).refilter,
        }
        if pyfastnoisesimd is not None:
            name = f"FastNoiseSIMD: {OCTAVES} octaves of Perlin, height alone"
            works[name] = FastNoise(side).heights
        columns.append(measured(works))
    print_table("one thread, ms", sides, columns)
    if pyfastnoisesimd is None:
        print("\npyfastnoisesimd does not import here: FastNoise was not measured.")


if __name__ == "__main__":
    main()
