# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The coast that is added without a file: an island of a kilometre with bays, and a wind sea that
suits its bed. The terrain is the preset bay_island, an eighth as large."""

from __future__ import annotations

import json

from ..sea import sea_text
from ..sea.sea_text import SeaValues
from ..shared.native import libocean

_BED = """libocean = 1
[terrain]
kind = "placed"
resolution = 512
patch_size = 2048.0
seed = 8
beta = 1.9
rms = 25.0
mean = 90.0
outer_scale = 1125.0
breaks = [[187.0, 2.5]]
island = 220.0
[terrain.stream]
slope = 0.62
[terrain.coast]
slope = 0.05
shelf = 40.0
"""
_SEA = """libocean = 1
[grid]
resolution = 256
patch_size = 600.0
[water]
depth = 30.0
seabed = "island.toml"
[[waves]]
spectrum = "jonswap"
wind_speed = 9.0
significant_wave_height = 0.8
peak_period = 4.6
wind_direction = 60.0
[water.bed_terrain]
"""


def values() -> SeaValues:
    """Returns the sea of that coast, with its bed."""
    with libocean.parse(f"{_SEA}lines = {json.dumps(_BED.splitlines())}\n") as sea:
        return sea_text.read(sea)
