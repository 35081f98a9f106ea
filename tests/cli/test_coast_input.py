# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""What users give a coast: a bad file of a bed is one sentence with its number, and what is odd but
possible is computed, with a warning where it matters. Other refusals are in refusals/coast.toml."""

import numpy as np
import pytest
from coasts import BEACH, REGION, SEA, grid, image
from conftest import BUOY, table

HEADER = "ncols 46\nnrows 26\nxllcenter 0\nyllcenter 0\ncellsize 4\nbyteorder LSBFIRST\n"
FLOATS = BEACH[::-1].astype("<f4").tobytes()
DEEP = np.full((26, 46), -400.0)
MEASURED = f'[[waves]]\nspectrum = "measured"\nfile = "{BUOY}"\n'
BACK = '[[waves]]\nspectrum = "jonswap"\nwind_speed = 6.0\nwind_direction = 180\nfetch = 20000.0\n'


# A header may lie so that all sizes agree: it describes another bed, whose oddities are warned of.
def test_rows_and_columns_in_exchange_are_another_coast(coast):
    coast.write("sea.toml", SEA.replace("bed.asc", "bed.flt"))
    coast.write("bed.flt", FLOATS)
    coast.write("bed.hdr", HEADER.replace("ncols 46\nnrows 26", "ncols 26\nnrows 46"))
    shown = coast("bake sea.toml -o s.exr", *REGION, "--products", "height")
    assert "the waves come in over 73.9 % of those sides in water shallower" in shown.stderr
    assert "48.4 % of the region lies beyond the bed, 0 .. 100 m along x" in shown.stderr


def test_a_changed_or_missing_bed_is_told_by_its_hash(coast):
    # Above 1 MB of heights the text holds the hash alone.
    coast.write("bed.asc", grid(np.tile(BEACH, (24, 10))))
    coast.write("held.toml", coast.good("info sea.toml --sea-file"))
    coast.write("bed.asc", grid(np.tile(BEACH, (24, 10)) + 0.5))
    message = coast.bad("bake held.toml -o s.exr", *REGION)
    assert "is another bed: its hash is" in message and "allowed: the bed with the hash" in message
    (coast.folder / "bed.asc").unlink()
    assert "no such file" in coast.bad("bake held.toml -o s.exr", *REGION)


def test_another_unit_needs_the_file_of_the_bed(coast):
    # The text holds heights, but in metres they are those of another unit.
    coast.write("held.toml", coast.good("info sea.toml --sea-file"))
    (coast.folder / "bed.asc").unlink()
    coast.good("info held.toml")
    message = coast.bad("info held.toml --set seabed_unit=ft")
    assert 'water.seabed = "bed.asc": bed.asc: no such file' in message, message
    assert "or leave both as they were" in message and "has changed" not in message


BEDS = {
    "beach": BEACH, "land": np.abs(BEACH) + 1.0, "level": np.zeros((26, 46)), "deep": DEEP,
    "shallow": DEEP / 133.0, "upside down": -BEACH, "in feet": BEACH / 0.3048,
}  # fmt: skip


@pytest.mark.parametrize("row", table("coast_input")["warned"], ids=lambda row: row["says"][:60])
def test_an_unsuitable_coast_is_planned_and_baked_with_a_warning(coast, row):
    sentence = row["says"]
    coast.write("bed.asc", grid(BEDS[row.get("bed", "beach")]))
    chosen = ["--set", row["set"]] if "set" in row else []
    bake = ("bake", "sea.toml", "-o", "s.exr", *REGION, "--products", "height", *chosen)
    planned = coast(*bake, "-n")
    assert planned.returncode == 0 and sentence in planned.stderr, planned.stderr
    assert not (coast.folder / "s.exr").exists()
    done = coast(*bake)
    assert done.returncode == 0, done.stderr
    assert sentence in done.stderr, done.stderr
    assert np.isfinite(image(coast.folder / "s.exr")).all()


def test_cells_of_spray_that_are_wider_than_breakers_are_told(coast):
    coast.write("bed.asc", grid(BEACH[:3], 120.0))
    bake = ("bake", "sea.toml", "--frames", "1", "--set", "wind_speed=14")
    spray = (*bake, "-o", "s.ply", "--products", "spray", "--spray-lifetime", "0.05")
    shown = coast(*spray)
    assert shown.returncode == 0, shown.stderr
    assert "spray over a bed of 5400 m is emitted on cells of 5.27 m" in shown.stderr
    assert "is emitted on" not in coast(*bake, "-o", "h.exr", "--products", "height").stderr


def test_points_beyond_the_bed_and_in_its_ground_are_counted(coast):
    coast.write("points.csv", "x,y\n50,50\n150,50\n500,50\n-9,50\n")
    query = ("query", "sea.toml", "--time", "3", "--points", "points.csv", "--no-foam")
    shown = coast(*query, "--orbital", "-8").stderr
    assert "2 of 4 points lie beyond the bed (water.seabed), where the sea is open" in shown
    assert "2 of 4 points lie in the ground of the bed" in shown
    assert "in the ground" not in coast(*query).stderr
    gauge = ("--points", "points.csv", "--from", "0", "--to", "1", "--rate", "1")
    shown = coast("gauge sea.toml", *gauge).stderr
    assert "2 of 4 points lie beyond the bed" in shown
    assert "1 of 4 points lie in the ground of the bed" in shown  # still water's level on land
    assert "refine = 3; allowed" in coast(*query, "--refine", "3").stderr.splitlines()[-1]


def displacement(coast, sea: str, *arguments):
    """Frame 5 of a sea."""
    coast.good(
        "bake", sea, "-o", f"{sea}.exr", "--products", "displacement", "--type", "float",
        "--frames", "5", "--axes", "zup", "-q", *arguments,
    )  # fmt: skip
    return image(coast.folder / f"{sea}.exr")


@pytest.mark.parametrize(
    ("edit", "samples"),
    [
        (lambda sea: sea, 64),
        (lambda sea: sea + BACK, 64),
        (lambda sea: sea.replace("[[waves]]", "cascades = 3\n[[waves]]", 1), 256),
        (lambda sea: sea + "[surface]\nchoppiness = 2.0\n", 64),
        (lambda sea: sea + "[time]\nloop_period = 20\n", 64),
        (lambda sea: sea.split("[[waves]]")[0] + MEASURED, 64),
    ],
    ids=["wind", "systems", "cascades", "choppy", "loop", "measured"],
)
def test_over_deep_ground_every_sea_is_the_open_one(coast, edit, samples):
    open_sea = SEA.replace('seabed = "bed.asc"\n', "").replace("depth = 12.0", "depth = 900.0")
    coast.write("open.toml", edit(open_sea))
    coast.write("bed.asc", grid(np.full((3, 3), -900.0), 500.0))
    coast.write("deep.toml", edit(SEA.replace("depth = 12.0", "depth = 900.0")))
    cell = 200.0 / samples
    side = 200.0 - cell
    expected = displacement(coast, "open.toml", "--resolution", samples)
    found = displacement(coast, "deep.toml", "--region", f"0,0,{side},{side}", "--cell", cell)
    assert found.shape == expected.shape
    assert np.abs(found - expected).max() < 2e-6 * 4.0 * expected[..., 2].std()
