# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A sea with a hull: its wake is in regions and queries, out of maps of one period, and goes with
the file."""

import csv
import io

import pytest
from bake_runs import BOAT

HULL = BOAT + 'track_file = "boat.csv"\n'
REGION = ("--region=-40,-20,60,40", "--cell", "2")
FRAME = ("--frames", "1", "--products", "displacement")


@pytest.fixture
def boat(ocean):
    sea = ocean.folder / "sea.toml"
    sea.write_text(sea.read_text() + HULL)
    ocean.write("boat.csv", "time,x,y\n-60,-240,0\n60,240,0\n")
    ocean.write("points.csv", "x,y\n-20,6\n")
    return ocean


def height(ocean, sea, *options) -> float:
    """The height at the point beside the boat."""
    points = ("--points", "points.csv", "--time", "0", "--no-foam")
    rows = csv.DictReader(io.StringIO(ocean.good("query", sea, *points, *options)))
    return float(next(rows)["height"])


def test_a_baked_region_needs_no_track_file(boat):
    boat.good("bake", "sea.toml", *REGION, "-o", "wake.exr", *FRAME)
    first = height(boat, "sea.toml")
    (boat.folder / "boat.csv").unlink()
    assert height(boat, "wake.exr") == first
    boat.good("bake", "--from", "wake.exr", "-o", "again.exr", *FRAME)
    files = [boat.folder / name for name in ("wake.exr", "again.exr")]
    assert files[0].read_bytes() == files[1].read_bytes()


def test_the_wake_counts_and_maps_of_a_period_warn(boat):
    without = height(boat, "sea.toml", "--set", "hulls.0.factor=0")
    assert abs(height(boat, "sea.toml") - without) > 0.02
    done = boat("bake", "sea.toml", "-o", "p.exr", *FRAME)
    assert done.returncode == 0 and "wakes of hulls do not repeat" in done.stderr


def test_gauges_and_volumes_have_the_wake(boat):
    gauge = ("--points", "points.csv", "--from", "0", "--to", "1", "--rate", "2", "-o", "g.csv")
    still = "hulls.0.factor=0"
    rows = {}
    for name, more in ("wake", ()), ("none", ("--set", still)):
        boat.good("gauge", "sea.toml", *gauge, *more)
        text = (boat.folder / "g.csv").read_text().splitlines()[1]
        rows[name] = [float(word) for word in text.split(",")]
        boat.good("bake", "sea.toml", *REGION, "-o", f"{name}.vdb", "--frames", "1", *more)
    elevation, up = (abs(rows["wake"][k] - rows["none"][k]) for k in (4, 9))
    assert elevation > 0.02 and up > 0.02
    assert rows["wake"][4] == pytest.approx(height(boat, "sea.toml"), abs=2e-4)
    volumes = [(boat.folder / f"{name}.vdb").read_bytes() for name in rows]
    assert volumes[0] != volumes[1]
