# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A sea over a bed in `ocean-preview`: pictures, probes, frame time, a window."""

import numpy
import pytest
from test_preview import COARSE, good, pictures, window
from test_preview import folder as sea_folder  # noqa: F401

OPEN = """libocean = 1
[grid]
resolution = 64
patch_size = 128.0
[water]
depth = 8.0
[[waves]]
spectrum = "jonswap"
wind_speed = 9.0
fetch = 20000.0
"""
COAST = OPEN.replace("depth = 8.0\n", 'depth = 8.0\nseabed = "bed.asc"\n')


def write_bed(folder, height):
    """The height of the bed [m] by the distance to the east [m]."""
    head = "ncols 81\nnrows 49\nxllcenter 0\nyllcenter 0\ncellsize 4\n"
    row = " ".join(f"{height(4.0 * i):.3f}" for i in range(81))
    (folder / "bed.asc").write_text(head + (row + "\n") * 49)


@pytest.fixture
def folder(sea_folder):  # noqa: F811
    """A beach that rises 1:20 to the east, 8 m of water to 4 m of land."""
    write_bed(sea_folder, lambda x: max(-8.0, (x - 240.0) / 20.0))
    (sea_folder / "sea.toml").write_text(COAST)
    (sea_folder / "open.toml").write_text(OPEN)
    return sea_folder


def test_land_water_and_surf_in_one_scene(folder):
    views = {
        "above.png": "--eye 240,96,70 --heading 90 --pitch -90 --angle 60",
        "person.png": "--eye 262,96 --heading 180 --pitch -8",
    }
    made = pictures(folder, views, "sea.toml", "--time", 20, "--size", "64x64", *COARSE)
    warmth = {}
    # From above the east is on the right; a person on the beach sees sky, water, then sand.
    above, person = made["above.png"], made["person.png"]
    for name, part in (
        ("sand", above[:, 56:]),
        ("sea", above[:, :8]),
        ("near sand", person[58:]),
    ):
        red, _, blue = part.reshape(-1, 3).mean(axis=0)
        warmth[name] = red / blue
    assert warmth["sand"] > 1.2 and warmth["near sand"] > 1.1, warmth
    assert warmth["sea"] < 0.95, warmth
    assert person[:16, :, 2].mean() > person[:16, :, 0].mean()
    # Along the shore nothing changes but the waves: no seam lies across it.
    assert numpy.abs(above[:, 56:].mean((1, 2)) - above[:, 56:].mean()).max() < 0.1


def test_the_probe_ends_with_the_water(folder):
    words = ("--eye", "224,96,2", "--probe", "224,96", "--probe", "290,96", "--size", "64x64")
    lines = good(folder, "sea.toml", *words, *COARSE)
    wet, dry = (line.split(",") for line in lines.splitlines())
    assert len(wet) == 7 and len(dry) == 2


@pytest.mark.parametrize(("height", "land"), [(3.0, True), (-8.0, False)])
def test_land_alone_and_water_alone_are_shown(folder, height, land):
    write_bed(folder, lambda x: height)
    arguments = ("--size", "16x16", *COARSE)
    views = {"a.png": "--eye 160,96,30 --heading 90 --pitch -90"}
    red, _, blue = pictures(folder, views, "sea.toml", *arguments)["a.png"].mean((0, 1))
    assert (red > blue) == land


def test_a_frame_takes_at_most_three_of_the_open_sea(folder):
    def frame(sea: str) -> float:
        words = ("--eye", "262,96,4", "--heading", "180", "--pitch", "-5", "--size", "640x360")
        lines = good(folder, sea, *words, "--budget", 2).splitlines()
        return float(next(line for line in lines if line.startswith("frame")).split(",")[1])

    # The machine may be busy with something else during one of them.
    assert any(frame("sea.toml") <= 3.0 * frame("open.toml") for _ in range(3))


def test_a_window_computes_its_coast_beside_its_pictures(folder, display):
    options = ("--size", "320x180", "--eye", "262,96", "--heading", "180")
    with window(folder, display, *options) as hand:
        hand.key("space", rest=False)  # the clock stands
        hand.rest()
        before = hand.at_rest()
        hand.key("w")
        assert before.std() > 0.05  # sky, water and sand
        hand.end()
