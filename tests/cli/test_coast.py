# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A sea over a bed as its users bake and query it: regions, the same from any start, and a sentence
for all that knows one period only."""

import csv
import io

import numpy as np
import pytest
from coasts import REGION, SEA, image


def test_a_region_is_the_surface_that_queries_find(coast):
    coast.good(
        "bake",
        "sea.toml",
        "-o",
        "s.exr",
        *REGION,
        "--frames",
        "5",
        "--axes",
        "zup",
        "--products",
        "displacement,depth,breaking,wetness",
    )
    offsets = image(coast.folder / "s.displacement.0005.exr")
    assert offsets.shape == (16, 31, 3)
    depth = image(coast.folder / "s.depth.0005.exr")
    wetness = image(coast.folder / "s.wetness.0005.exr")
    assert depth[:, 0].min() > 6.0 and depth[:, -1].max() < 0.0
    assert wetness[:, 0].min() == 1.0 and wetness[:, -1].max() < 0.2
    labels = np.stack(np.meshgrid(40 + 4.0 * np.arange(31), 20 + 4.0 * np.arange(16)), -1)
    places = (labels + offsets[..., :2]).reshape(-1, 2)
    coast.write("points.csv", "x,y\n" + "".join(f"{x:.7f},{y:.7f}\n" for x, y in places))
    answer = coast.good("query", "sea.toml", "--time", str(4 / 24), "--points", "points.csv")
    rows = list(csv.DictReader(io.StringIO(answer)))
    heights = np.array([float(row["height"]) for row in rows])
    assert np.abs(heights - offsets[..., 2].ravel()).max() < 1e-4


def test_a_frame_alone_is_the_frame_in_sequence_and_from_its_own_header(coast):
    products = ("--products", "displacement,foam")
    coast.good("bake", "sea.toml", "-o", "a/s.####.exr", *REGION, "--frames", "30-32", *products)
    coast.good("bake", "sea.toml", "-o", "b/s.####.exr", *REGION, "--frames", "32", *products)
    coast.good("bake", "--from", "a/s.foam.0032.exr", "-o", "c/s.####.exr", *products)
    for name in ("s.displacement.0032.exr", "s.foam.0032.exr"):
        alone = (coast.folder / "b" / name).read_bytes()
        assert alone == (coast.folder / "a" / name).read_bytes()
        assert alone == (coast.folder / "c" / name).read_bytes()


def test_without_a_region_the_whole_bed_is_baked(coast):
    coast.good("bake", "sea.toml", "-o", "s.exr", "--products", "height")
    assert image(coast.folder / "s.exr").shape == (26, 46)


def test_beds_that_do_not_suit_their_waves_are_warned_of(coast):
    shown = coast("info", "sea.toml", "--set", "waves.0.wind_direction=180")
    assert "no wave reaches the bed" in shown.stderr
    shown = coast("info", "sea.toml", "--set", "grid.patch_size=100")
    assert "repeat every 100 m" in shown.stderr


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("--region", "0,0,10"), "give both"),
        (("--region", "0,0,10", "--cell", "1"), "four numbers are needed"),
        (("--region", "10,0,0,10", "--cell", "1"), "X1 must be above X0"),
        (("--region", "0,0,10,10", "--cell", "0"), "--cell"),
        (("--region", "0,0,10,10", "--cell", "nan"), "--cell"),
        (("--region", "0,0,1e5,10", "--cell", "1"), "the region has 100001 samples along x"),
        (("--region", "0,0,10,10", "--cell", "20"), "the region has 1 samples along x"),
        ((*REGION, "--resolution", "64"), "--resolution is for whole maps"),
        ((*REGION, "--products", "wear"), "only a terrain has it"),
        ((*REGION, "--products", "caustics"), "this sea has a bed"),
        ((*REGION, "--products", "detail"), "this sea has a bed"),
        ((*REGION, "--backend", "dft"), "made on the CPU alone"),
        (("--set", "seabed=none.asc"), "no such file"),
        (("--set", "seabed_unit=yard"), "seabed_unit"),
        (("--set", "seabed_sign=left"), "seabed_sign"),
        (("--set", "seabed_origin=[1]"), "seabed_origin"),
        (("--set", "level=nan"), "level"),
        (("--set", "time.take=some.take"), "some.take"),
        (("--set", "waves.0.wind_speed=0"), "no waves"),
    ],
)
def test_what_cannot_be_baked_is_one_sentence(coast, arguments, sentence):
    done = coast("bake", "sea.toml", "-o", "out/s.exr", *arguments)
    assert done.returncode == 2
    assert sentence in done.stderr.splitlines()[-1]
    assert not (coast.folder / "out").exists() or not list((coast.folder / "out").glob("*.exr"))


def test_an_open_sea_has_no_region(coast):
    coast.write("open.toml", SEA.replace('seabed = "bed.asc"\n', ""))
    assert "has no bed" in coast.bad("bake", "open.toml", "-o", "s.exr", *REGION)


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
    coast.good("gauge", "sea.toml", "--points", "points.csv", *record, "-o", "g.csv", "-q")
    lines = csv.DictReader((coast.folder / "g.csv").read_text().splitlines())
    read = [float(row["elevation"]) for row in lines]
    assert np.abs(np.array(read) - rows[1][:, 2]).max() < 1e-6
