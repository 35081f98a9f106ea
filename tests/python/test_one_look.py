# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Foam is the same in every host: its sizes and colours are written in four languages, here they
are compared as text."""

import re
from pathlib import Path

import pytest

import libocean

ROOT = Path(__file__).parents[2]
NUMBER = r"[-+]?[0-9]*\.?[0-9]+(?:e[-+]?[0-9]+)?"


def text(path):
    return (ROOT / path).read_text()


SHADER = text("shaders/preview/foam_look.glsl")
MACROS = "".join(path.read_text() for path in ROOT.glob("povray_macros/ocean/*.inc"))
NODES = text("blender_addon/libocean_addon/look/foam_nodes.py") + text(
    "blender_addon/libocean_addon/look/water_shader.py"
)
LIBRARY = text("libocean/include/ocean/internal/foam_texture.hpp")
EXPORTER = text("libocean/io/povray/foam_declarations.cpp")


def value_of(source, name):
    """The one number, or the numbers in brackets, that a name is set to."""
    found = re.findall(rf"\b{name}\s*=\s*(?:vec3)?([<(][^>)]*[>)]|{NUMBER})", source)
    assert len(found) == 1, f"{name}: {found}"
    return [float(number) for number in re.findall(NUMBER, found[0])]


def tile_and_cell(kind):
    found = re.search(rf'"{kind}", ({NUMBER}), ({NUMBER})', LIBRARY)
    assert float(found[1]) == libocean.foam_texture_period(kind)
    return float(found[1]), float(found[2])


@pytest.mark.parametrize(
    "kind, host, tile, cell",
    [
        ("lace", SHADER, "lace_tile", "lace_cell"),
        ("bubbles", SHADER, "bubble_tile", "bubble_cell"),
        ("streaks", SHADER, "streak_tile", None),
        ("lace", MACROS, "Ocean_Foam_Tile_", "Ocean_Lace_Cell_"),
        ("bubbles", MACROS, "Ocean_Bubble_Tile_", "Ocean_Bubble_Cell_"),
        ("streaks", MACROS, "Ocean_Streak_Tile_", None),
        ("lace", NODES, "TILE", "_LACE_CELL"),
        ("bubbles", NODES, "_BUBBLE_TILE", "_BUBBLE_CELL"),
        ("streaks", NODES, "_STREAK_TILE", None),
    ],
)
def test_textures_are_as_large_as_the_library_makes_them(kind, host, tile, cell):
    asked = tile_and_cell(kind)
    assert value_of(host, tile) == [asked[0]]
    if cell is not None:
        assert value_of(host, cell) == [asked[1]]


@pytest.mark.parametrize(
    "shader, macros, nodes",
    [
        ("foam_span", "Ocean_Foam_Span_", "_SPAN"),
        ("foam_height", None, "_HEIGHT"),
        ("foam_plume", "Ocean_Foam_Plume_", "_PLUME"),
        ("thin_foam", "Ocean_Thin_Foam_", "_THIN_FOAM"),
        ("thick_foam", "Ocean_Thick_Foam_", "_THICK_FOAM"),
        ("foam_edge", "Ocean_Foam_Edge_", None),
        ("swash_cover", "Ocean_Swash_Cover_", "_SWASH"),
        ("swash_behind", "Ocean_Swash_Behind_", "_BEHIND"),
        ("swash_tip", "Ocean_Swash_Tip_", "_TIP"),
        ("swash_line", "Ocean_Swash_Line_", "_LINE"),
        ("swash_sheet", "Ocean_Swash_Sheet_", "_SHEET"),
    ],
)
def test_foam_looks_the_same(shader, macros, nodes):
    asked = value_of(SHADER, shader)
    assert macros is None or value_of(MACROS, macros) == asked
    assert nodes is None or value_of(NODES, nodes) == asked


def test_the_exporter_reckons_with_the_macros_span():
    assert value_of(EXPORTER, "kSpan") == value_of(MACROS, "Ocean_Foam_Span_")


def test_shallow_water_looks_the_same():
    sand, shade = text("shaders/preview/sand.glsl"), rf"wet_sand_albedo = ({NUMBER}) \* sand_albedo"
    wet = [float(re.search(shade, sand)[1]) * part for part in value_of(sand, "sand_albedo")]
    assert value_of(NODES, "WET_SAND") == pytest.approx(wet)
    detail = text("blender_addon/libocean_addon/look/detail.py")
    water = text("shaders/preview/water_at.glsl")
    assert value_of(detail, "_SHALLOW") == value_of(water, "detail_depth")
