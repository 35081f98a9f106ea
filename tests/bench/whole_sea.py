# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""What a script pays for a frame of a sea on one thread: height, displacement and slopes by this
library, and by numpy as one would write it, interleaved.

usage: whole_sea.py [SIDE ...]     in a Python with numpy
"""

import sys

import numpy as np
from rounds import measured, print_table

import libocean

PATCH = 1000.0
GRAVITY = 9.81


class Ours:
    def __init__(self, side: int) -> None:
        values = {"grid.resolution": side, "grid.patch_size": PATCH}
        self.sea = libocean.parse(libocean.text_of_values(values), threads=1)
        names = ("height", "dx", "dy", "slope_x", "slope_y")
        self.maps = [(np.empty((side, side, 1), np.float32), (name,)) for name in names]
        self.time = 0.0

    def frame(self) -> None:
        self.time += 1.0 / 24.0
        self.sea.fill(self.time, self.maps)


class Numpy:
    """Complex amplitudes of the half plane, turned to their time; a real transform a field. The
    spectrum is of no matter for the time: each mode has the amplitude 1/k."""

    def __init__(self, side: int) -> None:
        self.side = side
        kx = 2.0 * np.pi / PATCH * np.arange(side // 2 + 1)[None, :]
        ky = 2.0 * np.pi * np.fft.fftfreq(side, PATCH / side)[:, None]
        k = np.hypot(kx, ky)
        k[0, 0] = 1.0
        draw = np.random.default_rng(1)
        noise = draw.standard_normal(k.shape) + 1j * draw.standard_normal(k.shape)
        self.amplitude = noise / k
        self.omega = np.sqrt(GRAVITY * k)
        self.factors = (1.0, -1j * kx / k, -1j * ky / k, 1j * kx, 1j * ky)
        self.time = 0.0

    def frame(self) -> None:
        self.time += 1.0 / 24.0
        h = self.amplitude * np.exp(1j * self.omega * self.time)
        for factor in self.factors:
            np.fft.irfft2(factor * h, s=(self.side, self.side))


def main() -> None:
    sides = [int(side) for side in sys.argv[1:]] or [256, 512, 1024]
    columns = [
        measured(
            {
                "ours: height, displacement and slopes": Ours(side).frame,
                "numpy: the same": Numpy(side).frame,
            }
        )
        for side in sides
    ]
    print_table("one thread, ms", sides, columns)


if __name__ == "__main__":
    main()
