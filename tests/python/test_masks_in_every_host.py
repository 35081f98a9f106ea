# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A mask is a row of land_mask.hpp. Each text that a host must write itself has all masks of the
table, or the test names the place that lacks one; and the library has values for each row."""

import re
from pathlib import Path

import numpy as np
import pytest

import libocean

ROOT = Path(__file__).parents[2]
TABLE = (ROOT / "libocean/include/ocean/land_mask.hpp").read_text()
ROWS = re.findall(r'detail::mask\((\w+), "(.*?)", (\w+,\s*"[^)]*)\)', TABLE)
EVERY = [name for name, _, _ in ROWS]
HULLS = re.findall(r"LandMask::(\w+)", re.search(r"kHullMasks = [^;]*", TABLE)[0])
OF_SEAS = [name for name, _, rest in ROWS if rest.endswith(("kSeaKind", "{}"))]
SEA = [name for name in OF_SEAS if name not in HULLS]
LAND = [name for name, _, rest in ROWS if not rest.endswith("kSeaKind")]
LAND_BYTES = [name for name, unit, _ in ROWS if name in LAND and not unit]
"""The masks that POV-Ray's map of a land holds: flow is an area."""

PYTHON = "libocean/python/libocean"
ADDON = "blender_addon/libocean_addon"
PLACES = [
    ("libocean/include/libocean.h", r"enum \{\s*OCEAN_DX,.*?\};", "OCEAN_{upper}", EVERY),
    (f"{PYTHON}/_surface.py", r"_MASK_TEXTS = \{.*?\n\}", '"{name}"', EVERY),
    (f"{PYTHON}/_surface.py", r"class Surface\(.*?def __init__", "{name}: Array", EVERY),
    (f"{PYTHON}/_sea.py", r"def region\(.*?def fill_region", '"{name}"', OF_SEAS),
    (f"{PYTHON}/_sea.py", r"def fill_region\(.*?self\._call", '"{name}"', OF_SEAS),
    ("libocean/core/land/terrain.cpp", r"ChannelSet terrain_channels\(.*?\n\}", "{name}", LAND),
    ("povray_macros/terrain.inc.in", r"^//.*?#ifndef", "Terrain_{title}", LAND_BYTES),
    ("povray_macros/terrain.inc.in", r"// -+ At a place.*?#macro", "Terrain_{title}", LAND_BYTES),
    ("povray_macros/README.md", r"## Terrain.*", "Terrain_{title}", LAND_BYTES),
    (f"{ADDON}/terrain/node_group.py", r"MASKS = \{.*?\n\}", '"{name}"', LAND),
    ("blender_addon/README.md", r"\*\*Masks\.\*\*[^\n]*", "`{name}`", LAND),
    (f"{ADDON}/coast/node_group.py", r"CHANNELS = \{.*?\n\}", '"{name}"', SEA),
    (f"{ADDON}/coast/node_group.py", r"FILES = \{.*?\n\}", '"{name}"', SEA),
    (f"{ADDON}/bake/exr_files.py", r"_OF_COASTS = [^\n]*", '"{name}"', SEA),
]

ISLAND = """libocean = 1
[terrain]
kind = "placed"
resolution = 64
patch_size = 2400.0
rms = 60.0
mean = 90.0
beta = 2.0
island = 300.0
seed = 3
[terrain.coast]
shelter = 60.0
"""


def test_the_table_is_read():
    names = re.search(r"enum class LandMask \{(.*?)\}", TABLE, re.S)[1]
    assert re.findall(r"\w+", names) == EVERY == list(libocean.MASKS)
    assert set(OF_SEAS) | set(LAND) == set(EVERY)
    assert HULLS and set(HULLS) < set(OF_SEAS)
    assert set(SEA) & set(LAND) and set(LAND) - set(LAND_BYTES)


@pytest.mark.parametrize("file, section, spelling, masks", PLACES)
def test_a_host_has_the_masks_of_the_table(file, section, spelling, masks):
    found = re.search(section, (ROOT / file).read_text(), re.S | re.M)
    assert found, f"{file} has no section {section}"
    lacking = []
    for name in masks:
        word = spelling.format(name=name, upper=name.upper(), title=name.capitalize())
        if not re.search(rf"(?<!\w){re.escape(word)}(?!\w)", found[0]):
            lacking.append(word)
    assert not lacking, f"{file} lacks {', '.join(lacking)} in {section}"


def test_lands_have_values_for_each_mask():
    with_values = set()
    for section in "[terrain.gullies]", "[terrain.stream]":  # which exclude each other
        with libocean.parse_terrain(ISLAND + section) as land:
            own = land.domain
            for name in LAND:
                try:
                    maps = land.region(own.origin, own.samples, own.cell, [name])
                except libocean.Error:
                    continue
                if np.ptp(maps[name]) > 0:
                    with_values.add(name)
    assert set(LAND) - with_values == set()


def test_a_sea_over_a_bed_has_values_for_each_of_its_masks(sea):
    sea.set_bed(np.tile(np.linspace(-12.0, 3.0, 61), (40, 1)), cell=5.0)
    maps = sea.region(2.0, (60.0, 50.0), (90, 24), 2.5, SEA)
    assert [name for name in SEA if np.ptp(maps[name]) == 0] == []


def test_a_sea_with_hulls_has_values_for_each_of_its_masks_and_no_other():
    hull = "libocean = 1\n[[hulls]]\ntrack = [[-120, -960, 0], [120, 960, 0]]"
    place = (2.0, (-90.0, -20.0), (50, 20), 2.0)
    with libocean.parse(hull) as sea:
        maps = sea.region(*place, HULLS)
        assert [name for name in HULLS if np.ptp(maps[name]) == 0] == []
        for name in set(EVERY) - set(HULLS):
            with pytest.raises(
                libocean.UnsupportedError, match=f"no {name}; its masks: trail, dry"
            ):
                sea.region(*place, [name])
