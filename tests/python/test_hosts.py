# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""What hosts do to their process: they change its folder and its locale."""

import copy
import hashlib
import json
import os
import pickle
import subprocess
import sys

import numpy as np
import pytest

import libocean

RECORDS = """time,frequency,density
2026-01-01T00:00Z,0.05,0
2026-01-01T00:00Z,0.1,4
2026-01-01T00:00Z,0.15,1
2026-01-01T00:00Z,0.2,0.2
2026-01-01T01:00Z,0.05,0
2026-01-01T01:00Z,0.1,16
2026-01-01T01:00Z,0.15,1
2026-01-01T01:00Z,0.2,0.2
"""
SEA = """libocean = 1
[grid]
resolution = 64
patch_size = 400.5
[[waves]]
spectrum = "measured"
file = "buoy.csv"
record = "2026-01-01T00:00Z"
"""


@pytest.fixture
def opened(tmp_path, monkeypatch):
    """Seas that were opened by relative names, from a folder that is left then."""
    for name in ("project", "elsewhere"):
        (tmp_path / name).mkdir()
    (tmp_path / "project" / "buoy.csv").write_text(RECORDS)
    (tmp_path / "project" / "sea.toml").write_text(SEA)
    monkeypatch.chdir(tmp_path)
    seas = [libocean.open("project/sea.toml"), libocean.parse(SEA, base_dir="project")]
    monkeypatch.chdir(tmp_path / "project")
    seas.append(libocean.parse(SEA))
    monkeypatch.chdir(tmp_path / "elsewhere")
    yield seas
    for sea in seas:
        sea.close()


@pytest.mark.parametrize("twin", [copy.copy, lambda sea: pickle.loads(pickle.dumps(sea))])
def test_a_sea_keeps_its_folder(opened, twin):
    for sea in opened:
        other = twin(sea)
        for subject in (sea, other):
            first = subject.surface(0.0).height.std()
            subject.set("waves.0.record", "2026-01-01T01:00Z")
            assert subject.surface(0.0).height.std() > 1.5 * first
        other.close()


LOCALE = """
import json, locale, sys
import libocean
name, folder = sys.argv[1:]
locale.setlocale(locale.LC_ALL, name)
assert name == "C" or locale.str(1.5) == "1,5"
sea = libocean.open(folder + "/bed.toml")
sea.set("wind_speed", 7.75)
errors = []
for change in (lambda: sea.set("wind_speed", 1e9), lambda: sea.query([[1.5, float("nan")]], 0.0)):
    try:
        change()
    except libocean.Error as error:
        errors.append(str(error))
land = libocean.terrain(beta=2.25, rms=40.5, patch_size=2000)
state = {key: value for key, value in sea.state.items() if "second" not in key}
print(json.dumps([sea.text, errors, str(sea), land.text, state["bed"], state["warnings"]]))
"""
BED = """libocean = 1
[grid]
resolution = 64
patch_size = 90.5
[water]
depth = 20.5
seabed = "bed.asc"
[[waves]]
spectrum = "jonswap"
wind_speed = 6.75
"""


def told(folder, name: str) -> list:
    """What a program says whose locale is this one."""
    run = subprocess.run(
        [sys.executable, "-c", LOCALE, name, folder],
        env=os.environ | {"LOCPATH": str(folder)},
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stderr
    return json.loads(run.stdout)


@pytest.fixture
def beach(tmp_path):
    """A folder with a sea over a bed, and the locale of German hosts."""
    german = str(tmp_path / "de_DE.UTF-8")
    subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", german], capture_output=True)
    heights = " ".join(f"{-20.5 + 0.55 * i:g}" for i in range(41))
    head = "ncols 41\nnrows 41\nxllcenter 0.5\nyllcenter 0.25\ncellsize 7.5\n"
    (tmp_path / "bed.asc").write_text(head + f"{heights}\n" * 41)
    (tmp_path / "bed.toml").write_text(BED)
    return tmp_path


def test_numbers_have_points_in_every_locale(beach):
    assert told(beach, "de_DE.UTF-8") == told(beach, "C")


def test_a_bed_that_a_german_host_saved_opens_with_a_warning(beach):
    with libocean.open(beach / "bed.toml") as sea:
        text, bed = sea.text, sea.state["bed"]
    rows = np.tile(np.loadtxt(beach / "bed.asc", skiprows=5, max_rows=1), (41, 1))
    german = hashlib.sha256(b"41 7,5\n41 7,5\n" + rows.astype("<f4").tobytes()).hexdigest()
    assert bed["sha256"] in text
    saved = beach / "german.toml"
    saved.write_text(text.replace(bed["sha256"], german))
    with libocean.open(saved) as sea:
        assert sea.state["bed"]["sha256"] == bed["sha256"]
        (warning,) = (said for said in sea.state["warnings"] if "decimal commas" in said)
        assert "save the file again" in warning
        assert sea.text == text
    saved.write_text(text.replace(bed["sha256"], german[:-1] + "x"))
    with pytest.raises(libocean.Error, match="is another bed"):
        libocean.open(saved)
