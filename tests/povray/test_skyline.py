# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The skyline: of a camera low over the water it is the crests near it, which are the sea's own; at
the horizon, where no pixel shows a wave, it has no spots."""

import re

import numpy
import pytest
from conftest import Folder, sea_text, surface

CELL, CELLS = 1.35, 128  # [m]: of the map of the preset beaufort_6
SIDE = CELL * CELLS
WIDTH, HEIGHT, ANGLE = 1280, 720, 60.0
COLUMNS = slice(WIDTH // 4, 3 * WIDTH // 4)  # that are rendered
FOCUS = 0.5 * WIDTH / numpy.tan(numpy.radians(0.5 * ANGLE))  # pixels


def height_between(heights, x, z):
    """Returns the linear interpolation of a periodic map [z, x], of 16 samples in a cell."""
    n = len(heights)
    u, v = x / SIDE * n, z / SIDE * n
    i, j = numpy.floor(u).astype(int), numpy.floor(v).astype(int)
    u, v = u - i, v - j

    def at(k, m):
        return heights[(j + m) % n, (i + k) % n]

    near = at(0, 0) * (1 - u) + at(1, 0) * u
    return near * (1 - v) + (at(0, 1) * (1 - u) + at(1, 1) * u) * v


def skyline(heights, eye, heading):
    """Returns the sea's own skyline in pixels above the middle row, and its distance [m]."""
    across = (numpy.arange(WIDTH) + 0.5 - 0.5 * WIDTH)[COLUMNS]
    bearing = heading - numpy.arctan(across / FOCUS)
    away = numpy.concatenate([numpy.arange(0.5, 20, 0.01), numpy.arange(20, 0.95 * SIDE, 0.04)])
    place = away[:, None] * numpy.stack([numpy.cos(bearing), numpy.sin(bearing)])[:, None, :]
    height = height_between(heights, eye[0] + place[0], eye[2] + place[1]) - eye[1]
    rise = height / (away[:, None] * numpy.cos(bearing - heading))
    return FOCUS * rise.max(0), away[rise.argmax(0)]


@pytest.mark.parametrize("number", [0, 2])
def test_the_skyline_from_a_trough_has_no_step(low_sea, number):
    """In a picture of 1280 x 720 with +A, from 1.2 m over the water."""
    folder, heights, eyes = low_sea
    x, z = eyes[number]
    eye = (x, 1.2 + height_between(heights, numpy.array(x), numpy.array(z)), z)
    heading = 0.4 + 1.6 * number
    true, away = skyline(heights, eye, heading)
    rows = int(max(true.max() + 4, -true.min() + 4))
    white = folder.seen(
        f"""#declare Eye = <{eye[0]}, {eye[1]}, {eye[2]}>;
#declare Target = Eye + <{numpy.cos(heading)}, 0, {numpy.sin(heading)}>;
camera {{ location Eye right x*image_width/image_height angle {ANGLE} look_at Target }}
background {{ rgb 1 }}
object {{ Ocean_View(Eye, Target, {ANGLE}, 1) pigment {{ rgb 0 }} }}""",
        *("+A0.1", "+AM1", "+R3", f"+SR{HEIGHT // 2 - rows + 1}", f"+ER{HEIGHT // 2 + rows}"),
        *(f"+SC{COLUMNS.start + 1}", f"+EC{COLUMNS.stop}"),
        width=WIDTH,
        height=HEIGHT,
    )[..., 0]
    part = white[HEIGHT // 2 - rows : HEIGHT // 2 + rows, COLUMNS]
    seen = rows - part.sum(0)
    # Farther than a period the sea is another one.
    far = FOCUS * (numpy.abs(heights).max() - eye[1]) / (0.9 * SIDE)
    near = (true > far + 1) & (away < 0.7 * SIDE)
    off = seen - true
    steps = numpy.abs(numpy.diff(off))[near[1:] & near[:-1]]
    print(
        f"\n{near.mean():.2f} of the columns, {away[near].min():.0f} .. {away[near].max():.0f} m:"
        f" off by {numpy.abs(off[near]).max():.2f} pixels, rms {off[near].std():.2f},"
        f" steps of {steps.max():.2f}"
    )
    assert near.mean() > 0.2
    assert steps.max() < 1
    assert numpy.abs(off[near]).max() < 1


def test_the_row_of_the_horizon_has_no_spots(choppy):
    """There the mesh hides all slopes, and pixels show the mean of the sky that these mirror, by
    the antialiasing of the folder's own settings."""
    settings = re.findall(r"^(?:Antialias|Jitter).*", (choppy.path / "ocean.ini").read_text(), re.M)
    picture = choppy.seen(
        """#declare Eye = <0, 6, 0>;
#declare Target = Eye + <1, -0.12, 0>;
camera { location Eye right x*image_width/image_height angle 60 look_at Target }
Ocean_Eye_At(Eye, 60) Ocean_Sun(24, 14) Ocean_Sky(0)
object { Ocean_View(Eye, Target, 60, 1) Ocean_Material("jerlov_ii") no_reflection }""",
        *(*settings, "+SR55", "+ER60"),
        width=320,
        height=180,
    )
    rows = picture[::-1][54:60, :, 0]
    sky, water = rows[:3], rows[3:]
    assert water.mean() < 0.9 * sky.mean()
    spots = numpy.abs(numpy.diff(water, axis=1)).mean(1)
    print("mean difference between neighbours in each row:", spots.round(4))
    assert spots.max() < 0.01


@pytest.fixture(scope="module")
def low_sea(tmp_path_factory):
    """A folder, the heights of its sea between samples, and places in troughs."""
    text = sea_text(
        resolution=CELLS,
        period=SIDE,
        choppiness=0.0,
        wind=12.3,
        more=f"shortest_wavelength = {4 * CELL}",
    )
    folder = Folder(tmp_path_factory.mktemp("low"), text)
    heights = surface(folder, 16 * CELLS).height
    cells = numpy.stack(numpy.unravel_index(numpy.argsort(heights, axis=None), heights.shape), 1)
    troughs = []
    for z, x in (cells[: len(cells) // 50] + 0.5) * CELL / 16:
        if all(numpy.hypot(x - a, z - b) > 30 for a, b in troughs):
            troughs.append((x, z))
    return folder, heights, troughs
