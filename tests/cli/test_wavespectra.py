# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean` reads spectra as an independent package does: wavespectra, which this test installs.

The package's numbers for the committed samples also stand in tests/data/wavespectra.json, made by
the command at the top of wavespectra_reference.py.
"""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import DATA, OCEAN

PACKAGES = ("wavespectra==4.9.0", "netCDF4==1.7.5.1.post1")
REFERENCE = Path(__file__).with_name("wavespectra_reference.py")
COMMITTED = json.loads((DATA / "wavespectra.json").read_text())

HEIGHT = 0.005  # relative
ANGLE = 2.0  # degrees


def turned(a: float, b: float) -> float:
    return abs((a - b + 180.0) % 360.0 - 180.0)


@pytest.fixture(scope="session")
def fresh(tmp_path_factory):
    """Files and numbers made now, by the package in an environment of its own."""
    environment = Path(OCEAN).resolve().parents[1] / "wavespectra"
    python = environment / "bin" / "python"
    stamp = environment / "-".join(PACKAGES)
    if not stamp.exists():
        subprocess.run([sys.executable, "-m", "venv", "--clear", environment], check=True)
        pip = [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
        pip += ["--no-compile"]  # of a hundred thousand lines, a few are imported, once
        subprocess.run([*pip, *PACKAGES], check=True, timeout=280)
        stamp.touch()
    folder = tmp_path_factory.mktemp("made")
    done = subprocess.run(
        [python, REFERENCE, folder], check=True, capture_output=True, text=True, timeout=120
    )
    return folder, json.loads(done.stdout)


def check_records(ocean, path: Path, expected: list[dict]):
    """Checks the output of `ocean records`, and the sea made of each record."""
    found = json.loads(ocean.good("records", path, "--json"))
    assert len(found) == len(expected)
    # wavespectra sorts by time; NDBC lists the newest first.
    found.sort(key=lambda record: record["time"])
    for ours, theirs in zip(found, expected, strict=True):
        assert ours["time"] == theirs["time"]
        compare(ours, theirs)
    return found


def compare(ours: dict, theirs: dict):
    height = theirs["significant_wave_height"]
    assert abs(ours["significant_wave_height"] / height - 1.0) < HEIGHT, (ours, theirs)
    # The same bin, but for the digits of a period.
    assert ours["peak_period"] == pytest.approx(theirs["peak_period"], rel=1e-5), (ours, theirs)
    if theirs["coming_from"] is None:
        assert ours["coming_from"] is None and ours["directional_spread"] is None
        return
    assert turned(ours["coming_from"], theirs["coming_from"]) < ANGLE, (ours, theirs)
    assert abs(ours["directional_spread"] - theirs["directional_spread"]) < ANGLE, (ours, theirs)


def check_sea(ocean, path: Path, expected: dict, place: dict):
    """The same numbers from the table of the sea that takes the record."""
    choice = [f'record = "{expected["time"]}"']
    if place["latitude"] is not None:
        choice.append(f'place = "{place["latitude"]},{place["longitude"]}"')
    ocean.write(
        "measured.toml",
        "libocean = 1\n[grid]\nresolution = 64\npatch_size = 4000.0\n[[waves]]\n"
        f'spectrum = "measured"\nfile = "{path}"\n' + "\n".join(choice) + "\n",
    )
    state = json.loads(ocean.good("info", "measured.toml", "--json"))
    compare(
        {
            "significant_wave_height": state["significant_wave_height"]["asked"],
            "peak_period": state["peak_period"]["asked"],
            "coming_from": 270.0 - state["mean_direction"]["asked"],
            "directional_spread": state["directional_spread"]["asked"],
        },
        expected,
    )


@pytest.mark.parametrize("name", COMMITTED["samples"])
def test_samples_agree_with_the_committed_numbers(ocean, name):
    path = DATA / "spectra" / name
    expected = COMMITTED["samples"][name]
    found = check_records(ocean, path, expected)
    for i in {0, len(expected) // 2, len(expected) - 1}:
        # A sea has directions even where the buoy has none.
        if expected[i]["coming_from"] is not None:
            check_sea(ocean, path, expected[i], found[i])


@pytest.mark.parametrize("name", COMMITTED["made"])
def test_files_of_its_writers_are_read_alike(ocean, fresh, name):
    folder, numbers = fresh
    expected = numbers["made"][name]
    found = check_records(ocean, folder / name, expected)
    for i in {0, 1, len(expected) - 1}:
        check_sea(ocean, folder / name, expected[i], found[i])


def test_committed_numbers_are_what_the_package_says_today(fresh):
    numbers = fresh[1]
    assert numbers.keys() == COMMITTED.keys()
    for kind, files in numbers.items():
        assert files.keys() == COMMITTED[kind].keys()
        for name, records in files.items():
            for now, then in zip(records, COMMITTED[kind][name], strict=True):
                assert now == pytest.approx(then, rel=1e-4), name


def test_every_place_of_a_file_can_be_chosen(ocean, fresh):
    folder, _ = fresh
    heights = set()
    for place in ("-38.17,174.67", "-38.5,-176.2", "54.25,12.5"):
        ocean.write(
            "place.toml",
            f'libocean = 1\n[[waves]]\nspectrum = "measured"\nfile = "{folder}/places.nc"\n'
            f'place = "{place}"\nrecord = "2016-10-12T00:00"\n',
        )
        assert f'place = "{place}"' in ocean.good("info", "place.toml", "--sea-file")
        state = json.loads(ocean.good("info", "place.toml", "--json"))
        heights.add((state["significant_wave_height"]["asked"], state["mean_direction"]["asked"]))
    assert len(heights) == 3


def test_a_sea_saved_from_netcdf_needs_the_file_no_more(ocean, fresh):
    (ocean.folder / "places.nc").write_bytes((fresh[0] / "places.nc").read_bytes())
    ocean.write(
        "model.toml",
        'libocean = 1\n[[waves]]\nspectrum = "measured"\nfile = "places.nc"\nplace = "3"\n',
    )
    before = ocean.good("info", "model.toml", "--json")
    ocean.write("saved.toml", ocean.good("info", "model.toml", "--sea-file"))
    (ocean.folder / "places.nc").unlink()
    assert ocean.good("info", "saved.toml", "--json") == before
    assert "no such file" in ocean.bad("info", "model.toml")
