# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean terrain`, and what `info`, `params` and `presets` say of terrains."""

import json

import numpy as np
import pytest

LAND = """libocean = 1
[terrain]
resolution = 64
patch_size = 640.0
beta = 1.9
rms = 12.0
mean = 1000.0
"""


@pytest.fixture
def land(ocean):
    ocean.write("land.toml", LAND)
    return ocean


def test_a_file_of_other_tiles_is_not_kept(land):
    assert land.good("terrain land.toml -o land.exr") == "land.exr\n"
    one = land.bytes_of("land.exr")
    land.good("terrain land.toml --tiles 2x3 -o land.exr --skip-existing -q")
    assert land.bytes_of("land.exr") != one


def test_stages_are_images(land):
    for stage in ("noise", "transform", "filter", "filtered", "height"):
        land.good("terrain land.toml --stage", stage, "-o", f"{stage}.exr", "-q")
    _, noise = land.image("noise.exr")
    spec, filtered = land.image("filtered.exr")
    assert noise.std() == pytest.approx(1.0, abs=0.05)
    assert np.sqrt(np.sum(filtered.astype(float) ** 2)) == pytest.approx(12.0, rel=1e-5)
    assert spec.getattribute("ocean:unit") == "m"


def test_the_spectrum_of_a_terrain_is_its_rings(land):
    header, *rows = land.good("spectrum land.toml --seeds 4").splitlines()
    assert header.startswith("wavenumber,wavelength_m,count,density,asked_m4")
    table = np.array([[float(cell) for cell in row.split(",")] for row in rows])
    slope = np.polyfit(np.log(table[4:, 0]), np.log(table[4:, 4]), 1)[0]
    assert slope == pytest.approx(-3.8, abs=0.02)
    assert np.abs(np.log10(table[6:, 5] / table[6:, 4])).max() < 0.2
    land.good("spectrum land.toml --plot plot.png -o rings.csv")
    of_plot = json.loads(land.good("info --json plot.png"))
    assert of_plot["rms"]["asked"] == pytest.approx(12.0)
    land.write("again.toml", LAND.replace("beta = 1.9\n", 'measured = "rings.csv"\n'))
    land.good("terrain again.toml -o again.exr -q")


def test_info_says_what_was_asked_for_and_what_the_tile_holds(land):
    state = json.loads(land.good("info --json land.toml"))
    assert state["rms"]["asked"] == pytest.approx(12.0)
    assert state["rms"]["resolved"] == pytest.approx(12.0, rel=1e-6)
    assert state["mean"] == 1000.0 and state["cell"] == 10.0
    total = sum(octave["rms"]["resolved"] ** 2 for octave in state["octaves"])
    assert np.sqrt(total) == pytest.approx(12.0, rel=0.01)
    text = land.good("info land.toml")
    assert "density k^-3.8, H = 0.9, D = 2.1" in text
    land.good("terrain land.toml -o land.ply -q")
    assert json.loads(land.good("info --json land.ply"))["rms"] == state["rms"]
    resolved = land.good("info --sea-file land.ply")
    assert resolved.startswith("# A terrain") and "beta = 1.9" in resolved


def test_set_changes_a_parameter(land):
    land.good("terrain land.toml --set rms=3 --set beta=2.5 -o x.exr -q")
    _, heights = land.image("x.exr")
    assert heights.std() == pytest.approx(3.0, rel=1e-5)


def test_presets_and_parameters_are_listed_by_kind(ocean):
    listed = ocean.good("presets")
    assert listed.index("Seas\n") < listed.index("beaufort_0") < listed.index("Terrains\n")
    assert listed.index("Terrains\n") < listed.index("tujunga")
    kinds = {row["name"]: row["kind"] for row in json.loads(ocean.good("presets --json"))}
    assert kinds["tujunga"] == "terrain" and kinds["beaufort_5"] == "sea"
    assert "[terrain]" in ocean.good("presets tujunga")
    assert "beta = 2" in ocean.good("params terrain")
    assert "wind_speed" in ocean.good("params sea")
    keys = {row["key"] for row in json.loads(ocean.good("params terrain --json"))}
    assert {"beta", "breaks", "range", "period"} <= keys
