# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean gauge`: records of virtual wave gauges, their files and statistics."""

import csv
import io
import json
import signal
import subprocess
import time

import numpy as np
import pytest
from conftest import OCEAN, cpu_seconds

COLUMNS = ["time", "gauge", "x", "y", "elevation", "slope_x", "slope_y", "velocity_x",
           "velocity_y", "velocity_z", "pressure"]  # fmt: skip
RECORD = ["--from", "0", "--to", "10", "--rate", "4"]


@pytest.fixture
def gauge(ocean):
    """Runs `ocean gauge sea.toml` with the points given as text; rows of the CSV by gauge."""

    def run(points, *arguments, record=RECORD, sea="sea.toml"):
        ocean.write("points.csv", points)
        ocean.good("gauge", sea, "--points", "points.csv", *record, "-o", "g.csv", "-q", *arguments)
        rows = list(csv.DictReader(io.StringIO((ocean.folder / "g.csv").read_text())))
        assert list(rows[0]) == COLUMNS
        gauges = {}
        for row in rows:
            numbers = {name: float(row[name]) for name in COLUMNS if name != "gauge"}
            gauges.setdefault(row["gauge"], []).append(numbers)
        return gauges

    return run


def column(rows, name):
    return np.array([row[name] for row in rows])


def test_a_line_for_each_time_and_gauge_both_ends_included(gauge):
    gauges = gauge('name,x,y\n"west, deep",0,0\nmast,50,20\n')
    assert list(gauges) == ["west, deep", "mast"]
    for rows in gauges.values():
        assert column(rows, "time") == pytest.approx(np.arange(41) / 4)
    assert set(column(gauges["mast"], "x")) == {50.0}
    assert list(gauge("x,y\n1,2\n3,4\n")) == ["1", "2"]


def test_npy_holds_the_numbers_of_the_csv(ocean, gauge):
    gauges = gauge("x,y,z\n0,0,0\n50,20,-3\n")
    ocean.good("gauge sea.toml --points points.csv", *RECORD, "-o", "g.npy", "-q")
    array = np.load(ocean.folder / "g.npy")
    assert array.shape == (41, 2, 10) and array.dtype == np.float64
    names = [name for name in COLUMNS if name != "gauge"]
    for g, rows in enumerate(gauges.values()):
        for c, name in enumerate(names):
            assert array[:, g, c] == pytest.approx(column(rows, name), rel=1e-8, abs=1e-12), name


def test_the_record_is_the_same_for_any_number_of_threads(ocean):
    ocean.write("points.csv", "x,y\n0,0\n33,44\n")
    for threads in ("1", "2", "3"):
        sea = "gauge sea.toml --points points.csv --from 0 --to 40 --rate 5 -q -o"
        ocean.good(sea, f"{threads}.npy", "--threads", threads)
    one, two, three = ((ocean.folder / f"{n}.npy").read_bytes() for n in "123")
    assert one == two == three


def test_a_moving_gauge_reads_what_fixed_ones_read_where_it_is(gauge):
    moving = gauge("name,x,y,velocity_x,velocity_y\nship,10,20,3,-1\n")["ship"]
    assert moving[40]["x"] == 40.0 and moving[40]["y"] == 10.0
    fixed = gauge("name,x,y\nship,40,10\n")["ship"]
    assert moving[40] == fixed[40]
    assert moving[0] != fixed[0]


def test_a_track_is_straight_between_its_times(gauge):
    rows = gauge("name,time,x,y,z\nauv,-1,0,0,0\nauv,4,50,0,-5\nauv,20,50,160,-5\n")["auv"]
    at = {row["time"]: row for row in rows}
    assert (at[0.0]["x"], at[0.0]["y"]) == (10.0, 0.0)
    assert (at[4.0]["x"], at[4.0]["y"]) == (50.0, 0.0)
    assert (at[10.0]["x"], at[10.0]["y"]) == (50.0, 60.0)
    still = gauge("name,x,y,z\nauv,10,0,-1\n")["auv"]
    assert at[0.0] == still[0]


def test_json_and_table_agree_with_the_record(ocean, gauge):
    long = ["--from", "0", "--to", "300", "--rate", "2"]
    rows = gauge("name,x,y\nbuoy,0,0\n", record=long)["buoy"]
    run = ["gauge", "sea.toml", "--points", "points.csv", *long]
    report = json.loads(ocean.good(*run, "--json", "-q"))
    assert (report["from"], report["to"], report["samples"]) == (0, 300, 601)
    (buoy,) = report["gauges"]
    elevation = column(rows, "elevation")
    height = buoy["significant_wave_height"]
    assert height["value"] == pytest.approx(4.0 * np.std(elevation), rel=1e-6)
    assert height["lower"] < height["value"] < height["upper"]
    level = elevation - elevation.mean()
    crossings = int(np.sum((level[:-1] < 0) & (level[1:] >= 0)))
    assert buoy["waves"] == crossings - 1
    assert buoy["degrees_of_freedom"] >= 40
    header, line = ocean.good(*run, "-q").splitlines()
    assert header.split()[:4] == ["gauge", "waves", "Hs", "[m]"]
    assert line.split()[:3] == ["buoy", str(crossings - 1), f"{height['value']:.3g}"]


def test_the_spectrum_holds_the_variance(ocean, gauge):
    rows = gauge("x,y\n0,0\n", "--spectrum", "s.csv", "--degrees-of-freedom", "10",
                 record=["--from", "0", "--to", "300", "--rate", "2"])["1"]  # fmt: skip
    header, *lines = (ocean.folder / "s.csv").read_text().splitlines()
    assert header == "gauge,frequency,density,lower,upper"
    f, density, lower, upper = np.array([line.split(",")[1:] for line in lines], float).T
    assert np.sum(density) * f[1] == pytest.approx(np.var(column(rows, "elevation")), rel=1e-6)
    assert f[-1] == 1.0
    assert (lower <= density).all() and (density <= upper).all()


def test_a_short_record_has_no_limits_and_says_so(ocean):
    ocean.write("points.csv", "x,y\n0,0\n")
    run = ["gauge", "sea.toml", "--points", "points.csv", *RECORD]
    done = ocean(*run, "--json")
    assert done.returncode == 0
    assert "too short" in done.stderr
    (gauge,) = json.loads(done.stdout)["gauges"]
    assert gauge["significant_wave_height"]["lower"] is None


def test_a_flat_sea_has_no_waves(ocean):
    ocean.write("points.csv", "x,y\n0,0\n")
    sea = "gauge sea.toml --set wind_speed=0 --points points.csv"
    report = json.loads(ocean.good(f"{sea} --from 0 --to 100 --rate 4 --json -q"))
    (gauge,) = report["gauges"]
    assert gauge["waves"] == 0
    assert gauge["significant_wave_height"] == {"value": 0, "lower": 0, "upper": 0}


def test_a_small_patch_is_warned_of(ocean):
    ocean.write("points.csv", "x,y\n0,0\n")
    run = ["gauge", "sea.toml", "--points", "points.csv", "--from", "0", "--to", "900",
           "--rate", "0.5", "--set", "resolution=32"]  # fmt: skip
    assert "grid.patch_size = 200 m" in ocean(*run).stderr
    assert ocean(*run, "--set", "patch_size=20000").stderr == ""


def test_an_interrupted_run_leaves_nothing(ocean):
    ocean.write("points.csv", "x,y\n0,0\n")
    run = ["gauge", "sea.toml", "--set", "resolution=512", "-q", "--points", "points.csv"]
    run += ["--from", "0", "--to", "1e5", "--rate", "4", "-o", "g.csv", "--spectrum", "s.csv"]
    process = subprocess.Popen([OCEAN, *run], cwd=ocean.folder, text=True, stderr=subprocess.PIPE)
    while cpu_seconds(process) < 0.3:  # it computes
        assert process.poll() is None
        time.sleep(0.01)
    process.send_signal(signal.SIGINT)
    assert process.communicate(timeout=120)[1] == "ocean: interrupted\n"
    assert process.returncode == 130
    assert ocean.files(".") == ["buoy.toml", "points.csv", "sea.toml"]


def test_points_come_from_standard_input_too(ocean):
    done = ocean("gauge sea.toml --points -", *RECORD, "--json", "-q", input="x,y\n1,2\n")
    assert done.returncode == 0
    assert [gauge["name"] for gauge in json.loads(done.stdout)["gauges"]] == ["1"]
