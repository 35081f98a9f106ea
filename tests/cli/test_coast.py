# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A sea over a bed as its users bake and query it: regions, the same from any start."""

from coasts import image


def test_without_a_region_the_whole_bed_is_baked(coast):
    coast.good("bake sea.toml -o s.exr --products height")
    assert image(coast.folder / "s.exr").shape == (26, 46)


def test_beds_that_do_not_suit_their_waves_are_warned_of(coast):
    shown = coast("info sea.toml --set waves.0.wind_direction=180")
    assert "no wave reaches the bed" in shown.stderr
    shown = coast("info sea.toml --set grid.patch_size=100")
    assert "repeat every 100 m" in shown.stderr
