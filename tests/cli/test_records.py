# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean records`: what a file of measured spectra holds, for people and for programs."""

import gzip
import json
import re
import resource
import shutil
import subprocess

import pytest
from conftest import BUOY, DATA, OCEAN, table

SPECTRA = DATA / "spectra"


def rows(text):
    return [line.split() for line in text.splitlines()]


def test_a_line_for_each_record_under_a_header(ocean):
    header, *lines = rows(ocean.good("records", SPECTRA / "ww3_station_44097.spec"))
    assert header == ["time,", "UTC", "station", "latitude", "longitude", "depth/m", "Hs/m", "Tp/s",
                      "Te/s", "Tm01/s", "from", "spread"]  # fmt: skip
    assert [line[0] for line in lines] == [f"2022-09-12T0{hour}:00" for hour in (6, 7, 8, 9)]
    assert lines[0][1:] == ["44097", "40.9800", "-71.1200", "46.6", "1.16", "13.6", "11.5",
                            "9.8", "114", "26"]  # fmt: skip


def test_unknown_values_are_a_dash_or_null(ocean):
    ocean.write("one.csv", "frequency,density\n0.1,1\n0.2,3\n0.4,2\n")
    _, line = rows(ocean.good("records one.csv"))
    assert line == ["-", "-", "-", "-", "-", "3.35", "5.0", "4.6", "4.0", "-", "-"]
    (record,) = json.loads(ocean.good("records one.csv --json"))
    assert record == {
        "time": "",
        "station": "",
        "latitude": None,
        "longitude": None,
        "depth": None,
        "significant_wave_height": pytest.approx(4.0 * 0.7**0.5),
        "peak_period": 5.0,
        "energy_period": pytest.approx((0.05 / 0.1 + 0.45 / 0.2 + 0.2 / 0.4) / 0.7),
        "mean_period": pytest.approx(0.7 / (0.05 * 0.1 + 0.45 * 0.2 + 0.2 * 0.4)),
        "mean_direction": None,
        "coming_from": None,
        "directional_spread": None,
        "directions": "none",
        "frequencies": 3,
        "warnings": [],
    }


@pytest.mark.parametrize(
    ("name", "told"), table("records")["formats"].items(), ids=lambda part: str(part)[:40]
)
def test_formats_are_recognised_by_content_packed_or_not(ocean, name, told):
    count, directions = told
    records = json.loads(ocean.good("records", SPECTRA / name, "--json"))
    assert len(records) == count
    assert {record["directions"] for record in records} == {directions}
    if name.endswith(".gz") or name == BUOY.name:
        return  # the companions of these are found by name
    content = (SPECTRA / name).read_bytes()
    # Datawell's name tells the station and the time.
    other = "anything.at.all" if not name.endswith(".spt") else name
    ocean.write(other, gzip.compress(content))
    assert json.loads(ocean.good("records", other, "--json")) == records


@pytest.mark.parametrize(
    "name", [name for name in table("records")["formats"] if re.match("spotter|buoy|triaxys", name)]
)
def test_a_sea_saved_from_a_buoys_file_needs_it_no_more(ocean, name):
    shutil.copy(SPECTRA / name, ocean.folder)
    ocean.write("b.toml", f'libocean = 1\n[[waves]]\nspectrum = "measured"\nfile = "{name}"\n')
    before = ocean.good("info b.toml --json")
    ocean.write("saved.toml", ocean.good("info b.toml --sea-file"))
    (ocean.folder / name).unlink()
    assert ocean.good("info saved.toml --json") == before
    assert "no such file" in ocean.bad("info b.toml")


def test_a_buoy_whose_companions_are_packed_keeps_its_directions(ocean):
    for part in "wdijk":
        packed = SPECTRA / "ndbc_historical" / f"41010{part}2020.txt.gz"
        if part in "wj":
            ocean.write(packed.stem, gzip.decompress(packed.read_bytes()))
        else:
            shutil.copy(packed, ocean.folder)
    here = json.loads(ocean.good("records 41010w2020.txt --json"))
    there = ocean.good("records", SPECTRA / "ndbc_historical" / "41010w2020.txt.gz", "--json")
    assert here == json.loads(there)
    (ocean.folder / "41010k2020.txt.gz").unlink()
    without = json.loads(ocean.good("records 41010w2020.txt --json"))
    assert {record["directions"] for record in without} == {"none"}


def test_a_bomb_is_refused_in_little_memory(ocean):
    """3 MiB that unpack to 3 GiB, in a process that may have a quarter of one."""
    bomb = gzip.compress(bytes(64 << 20)) * 48  # members in a row
    assert len(bomb) < 4 << 20
    ocean.write("bomb.gz", bomb)
    limit = 256 << 20
    done = subprocess.run(
        [OCEAN, "records", "bomb.gz"], cwd=ocean.folder, capture_output=True, text=True,
        check=False, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)),
    )  # fmt: skip
    assert done.returncode == 2
    assert "bomb.gz: gzip: unpacks to more than the 512 MiB allowed" in done.stderr
