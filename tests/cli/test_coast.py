# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A sea over a bed as its users bake and query it: regions, the same from any start."""

import csv
import io

import numpy as np
from coasts import image


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
