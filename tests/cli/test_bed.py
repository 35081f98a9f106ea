# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A sea with a bed: `ocean info` describes it, and its faults are one line."""

import json

SEA = 'libocean = 1\n[water]\ndepth = 6.0\nseabed = "bed.asc"\n[grid]\nresolution = 64\n'


def grid() -> str:
    head = "ncols 21\nnrows 5\nxllcorner 0\nyllcorner 0\ncellsize 5\n"
    row = " ".join(str(i - 9.5) for i in range(21))
    return head + (row + "\n") * 5


def test_info_describes_the_bed_and_the_text_holds_it(ocean):
    ocean.write("coast/sea.toml", SEA)
    ocean.write("coast/bed.asc", grid())
    text = ocean.good("info coast/sea.toml")
    assert "21 x 5 samples 5 m apart, from (0, 0) m" in text
    assert "-9.5 to 10.5 m over still water" in text
    assert "47.6 % is wet, 28.6 % shallower than the sea" in text
    bed = json.loads(ocean.good("info coast/sea.toml --json"))["bed"]
    assert bed["samples"] == [21, 5] and bed["wet_share"] == 10 / 21
    assert f"SHA-256 {bed['sha256']}" in text
    ocean.write("elsewhere/sea.toml", ocean.good("info coast/sea.toml --sea-file"))
    again = json.loads(ocean.good("info elsewhere/sea.toml --json"))["bed"]
    assert again == bed


def test_set_takes_a_bed_from_where_the_user_stands(ocean):
    ocean.write("coast/sea.toml", "libocean = 1\n[grid]\nresolution = 64\n")
    ocean.write("bed.asc", grid())
    assert "21 x 5" in ocean.good("info coast/sea.toml --set seabed=bed.asc")


def test_a_folder_for_povray_has_the_coast(ocean):
    ocean.write("sea.toml", SEA)
    ocean.write("bed.asc", grid())
    files = ocean.good("povray sea.toml -o f -n").split()
    for name in ("coast.inc", "coast_0001.df3", "land.df3", "sea_0001.df3", "scene.pov"):
        assert f"f/{name}" in files, name
