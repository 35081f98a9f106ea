# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A sea over a bed as its users bake and query it: regions, the same from any start."""

import csv
import io

import numpy as np
from coasts import REGION, image


def test_a_region_is_the_surface_that_queries_find(coast):
    products = "--products displacement,depth,breaking,wetness"
    coast.bake(f"-o s.exr --frames 5 --axes zup {products}", *REGION)
    offsets = image(coast.folder / "s.displacement.0005.exr")
    assert offsets.shape == (16, 31, 3)
    depth = image(coast.folder / "s.depth.0005.exr")
    wetness = image(coast.folder / "s.wetness.0005.exr")
    assert depth[:, 0].min() > 6.0 and depth[:, -1].max() < 0.0
    assert wetness[:, 0].min() == 1.0 and wetness[:, -1].max() < 0.2
    labels = np.stack(np.meshgrid(40 + 4.0 * np.arange(31), 20 + 4.0 * np.arange(16)), -1)
    places = (labels + offsets[..., :2]).reshape(-1, 2)
    coast.write("points.csv", "x,y\n" + "".join(f"{x:.7f},{y:.7f}\n" for x, y in places))
    answer = coast.good("query sea.toml --time", str(4 / 24), "--points", "points.csv")
    rows = list(csv.DictReader(io.StringIO(answer)))
    heights = np.array([float(row["height"]) for row in rows])
    assert np.abs(heights - offsets[..., 2].ravel()).max() < 1e-4


def test_without_a_region_the_whole_bed_is_baked(coast):
    coast.good("bake sea.toml -o s.exr --products height")
    assert image(coast.folder / "s.exr").shape == (26, 46)


def test_beds_that_do_not_suit_their_waves_are_warned_of(coast):
    shown = coast("info sea.toml --set waves.0.wind_direction=180")
    assert "no wave reaches the bed" in shown.stderr
    shown = coast("info sea.toml --set grid.patch_size=100")
    assert "repeat every 100 m" in shown.stderr


def test_an_exact_query_and_a_gauge_find_the_surface_of_the_region(coast):
    coast.write("points.csv", "x,y\n10,50\n90,60\n135,40\n")
    ask = ("query", "sea.toml", "--time", "1", "--points", "points.csv", "--no-foam")
    rows = [
        np.array([list(map(float, row.values())) for row in csv.DictReader(io.StringIO(answer))])
        for answer in (coast.good(*ask), coast.good(*ask, "--exact"))
    ]
    difference = np.abs(rows[0] - rows[1])
    assert 0.0 < difference[:, 2].max() < 1e-5, "both interpolate, or differ by more than that"
    record = ("--from", "1", "--to", "1", "--rate", "1")
    coast.good("gauge sea.toml --points points.csv", *record, "-o", "g.csv", "-q")
    lines = csv.DictReader((coast.folder / "g.csv").read_text().splitlines())
    read = [float(row["elevation"]) for row in lines]
    assert np.abs(np.array(read) - rows[1][:, 2]).max() < 1e-6
