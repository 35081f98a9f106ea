# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Terrains in `ocean-preview`: pictures, probes, wrong options, and a window that a hand uses."""

import subprocess
import tomllib

import numpy
import pytest
from test_preview import OCEAN, good, pictures, pixels, rms, run  # noqa: F401
from test_preview import folder as sea_folder  # noqa: F401
from test_preview_files import drop, hand, recent, shown, wait_for_title  # noqa: F401

TERRAIN = """libocean = 1
[terrain]
kind = "tile"
resolution = 64
patch_size = 640.0
rms = 30.0
mean = 400.0
"""


@pytest.fixture
def folder(sea_folder):  # noqa: F811
    (sea_folder / "hills.toml").write_text(TERRAIN)
    return sea_folder


def test_a_terrain_is_recognised_by_its_file(folder):
    baked = subprocess.run([OCEAN, "terrain", "hills.toml", "-q", "-o", "baked.exr"], cwd=folder)
    assert baked.returncode == 0
    made = []
    for number, source in enumerate(("hills.toml", "baked.exr", "preset:tujunga")):
        good(folder, source, "--map", 128, "--offscreen", f"{number}.png", "--size", "64x36")
        made.append(pixels(folder / f"{number}.png"))
    assert numpy.array_equal(made[0], made[1]) and rms(made[0], made[2]) > 0.01


def test_the_probe_is_the_land(folder):
    lines = good(folder, "hills.toml --probe 110,50 --probe -333.3,7.7").splitlines()
    for line, place in zip(lines, ((110.0, 50.0), (-333.3, 7.7)), strict=True):
        x, y, ground, mesh, of_map, slope = map(float, line.split(","))
        assert (x, y) == place and 250.0 < ground < 550.0 and slope >= 0.0
        assert of_map == pytest.approx(ground, abs=0.2) and mesh == pytest.approx(of_map, abs=0.2)
    ground, of_map = (float(lines[0].split(",")[i]) for i in (2, 4))
    assert of_map == pytest.approx(ground, abs=1e-5 * 30.0)  # a sample of the map


ISLAND = """libocean = 1
[terrain]
kind = "placed"
resolution = 128
patch_size = 4096.0
rms = 100.0
mean = 150.0
island = 500.0
seed = 3
[terrain.coast]
"""


def test_an_island_stands_in_water(folder):
    (folder / "island.toml").write_text(ISLAND)
    views = {
        "above.png": "--eye 2048,2048,900 --pitch -90 --snow-line 5000 --angle 40",
        "water.png": "--eye -2000,2048,300 --pitch -90",
        "bed.png": "--eye 200,2048,300 --pitch -90 --view height",
        "default.png": "",
        # An eye far from the land, and one that would be under water.
        "away.png": "--eye 150000,2048,50",
        "shore.png": "--eye -100,2048",
    }
    made = pictures(folder, views, "island.toml", "--size", "64x36", "--samples", "1")
    warm = {}
    for name in ("water.png", "above.png"):
        red, _, blue = made[name].reshape(-1, 3).mean(axis=0)
        warm[name] = red / blue
    assert warm["water.png"] < 0.85 and warm["above.png"] > warm["water.png"] + 0.1
    assert rms(made["default.png"], made["away.png"]) > 0.02
    line = good(folder, "island.toml --probe 2048,2048 --probe -900,2048").splitlines()
    inside = [float(number) for number in line[0].split(",")]
    assert inside[3] == pytest.approx(inside[2], abs=0.5)
    assert len(line[1].split(",")) == 3  # no ground is drawn beyond the edge


def test_a_flight_has_a_budget_and_says_its_triangles(folder):
    done = run(folder, "-v hills.toml --budget 3 --size 64x36")
    stages = [row.split(",")[0] for row in done.stdout.splitlines()[1:]]
    assert stages == ["state", "sky", "land", "frame"]
    words = next(line for line in done.stderr.splitlines() if "triangles" in line).split()
    triangles = int(words[words.index("triangles,") - 1])
    assert 1000 < triangles < 300000


def test_views_and_colours_are_other_pictures(folder):
    views = ("shaded", "height", "normal", "slope", "noise", "transform", "filter", "spectrum")
    lines = {f"{view}.png": f"--view {view}" for view in views}
    lines |= {"seed.png": "--colours seed", "lines.png": "--wireframe"}
    lines |= {"snow.png": "--snow-line 0"}
    made = pictures(folder, lines, "hills.toml", "--size", "96x96", "--samples", "1")
    names = list(made)
    for i, name in enumerate(names):
        for other in names[:i]:
            assert rms(made[name], made[other]) > 0.02, f"{name} {other}"
    # The same by compute shaders, and to the last bit by another reference of the same map.
    small = ("hills.toml", "--size", "96x96", "--samples", "1", "--view", "height")
    for backend in ("gl", "radix2"):
        good(folder, *small, "--backend", backend, "--offscreen", f"{backend}.png")
        assert rms(pixels(folder / f"{backend}.png"), made["height.png"]) < 0.01


def test_an_eye_in_the_ground_is_raised_and_that_is_said(folder):
    eye = ("hills.toml", "--offscreen", "one.png", "--size", "32x32")
    done = run(folder, *eye, "--eye", "0,0,8")
    assert done.returncode == 0 and "is in the ground" in done.stderr
    assert run(folder, *eye, "--eye", "0,0").stderr == ""


def test_a_hand_goes_from_a_sea_to_a_terrain_and_back(hand, folder):  # noqa: F811
    hand.key("space")
    sea = shown(hand)

    # A terrain takes the sea's place; keys of a sea say that it does not move.
    drop(hand, folder / "hills.toml")
    hand.wait_for_line(f"opened: {folder / 'hills.toml'}")
    wait_for_title(hand, folder / "hills.toml")
    hills = shown(hand)
    assert rms(hills, sea) > 0.05
    for key in ("space", "r", "p", "p"):
        hand.key(key)
    assert rms(shown(hand), hills) < 0.01

    # A camera that walks stands on the ground, lower than at the start.
    for key in ("c", "c", "c"):
        hand.key(key)
    low = shown(hand)
    assert rms(low, hills) > 0.03
    hills = low

    # Its views, the stages among them, and back to the first one.
    for _ in range(8):
        hand.key("v")
    assert rms(shown(hand), hills) < 0.01

    # It is saved as a terrain file.
    hand.key("ctrl+s")
    hand.key("ctrl+a")
    hand.type("saved")
    hand.key("Return")
    hand.wait_for_line("written: saved.toml")
    saved = tomllib.loads((folder / "saved.toml").read_text())["terrain"]
    assert (saved["rms"], saved["mean"], saved["resolution"]) == (30.0, 400.0, 64)

    # A take is not for it, and a wrong terrain leaves it as it is.
    (folder / "wrong.toml").write_text(TERRAIN.replace("rms", "rmz"))
    (folder / "storm.take").write_text("1 wind_speed 12\n")
    for wrong, reason in (("wrong.toml", "rmz"), ("storm.take", "a terrain has none")):
        drop(hand, folder / wrong)
        hand.wait_for(lambda reason=reason: any(reason in line for line in list(hand.lines)))
    assert rms(shown(hand), hills) < 0.01

    # Undo brings the sea back.
    hand.key("ctrl+z")
    wait_for_title(hand, "sea.toml")
    assert rms(shown(hand), sea) < 0.01
    assert str(folder / "hills.toml") in recent(hand)
