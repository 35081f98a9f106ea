# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The coast that is added without a file: an island of 600 m with beaches between its capes, and a
wind sea that runs into the largest of its bays. The terrain is the preset bay_island, a twelfth as
large, with more beaches."""

from __future__ import annotations

import json

from ..sea import sea_text
from ..sea.sea_text import SeaValues
from ..shared.native import libocean

_BED = """libocean = 1
[terrain]
kind = "placed"
resolution = 512
patch_size = 1400.0
seed = 8
beta = 1.9
rms = 18.0
mean = 66.0
outer_scale = 769.0
breaks = [[127.8, 2.5]]
island = 165.0
[terrain.stream]
slope = 0.62
[terrain.coast]
slope = 0.045
closure = 14.0
shelf = 100.0
smooth = 10.0
shelter = 100.0
width = 60.0
beaches = 0.17
"""
_SEA = """libocean = 1
[grid]
resolution = 512
patch_size = 1420.0
[water]
depth = 30.0
seabed = "island.toml"
[[waves]]
spectrum = "jonswap"
wind_speed = 9.0
significant_wave_height = 0.9
peak_period = 4.4
wind_direction = 205.0
[water.bed_terrain]
"""


def values() -> SeaValues:
    """Returns the sea of that coast, with its bed."""
    with libocean.parse(f"{_SEA}lines = {json.dumps(_BED.splitlines())}\n") as sea:
        return sea_text.read(sea)
