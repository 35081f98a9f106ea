# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A land that exists once: the evaluated mesh is the library's rectangle, with its masks as
attributes; regions of it, and files, steps and drafts of all that."""

import bpy
import numpy as np
import pytest
import test_terrain
from conftest import attribute, evaluated_mesh, plane, positions, rest
from libocean_addon.bundled import libocean
from libocean_addon.terrain import extent, node_group, parameter_values, parameters, terrain_text
from test_terrain import RINGS, WHOLE, add_terrain, library_of

PLACED = """libocean = 1
[terrain]
kind = "placed"
resolution = 64
patch_size = 1600.0
origin = [-300.0, 500.0]
size = [1600.0, 900.0]
rms = 40.0
mean = 30.0
island = 30.0
seed = 5
"""
WORN = PLACED + "[terrain.gullies]\nlongest = 200.0\n"
CARVED = PLACED + "[terrain.stream]\n[terrain.coast]\n"


def add_land(tmp_path, text: str, **arguments):
    """Adds the land of a file, without a material."""
    path = tmp_path / "land.toml"
    path.write_text(text)
    arguments.setdefault("use_material", False)
    assert bpy.ops.libocean.add_terrain_file(filepath=str(path), **arguments) == {"FINISHED"}
    ob = bpy.context.object
    assert ob.libocean_terrain.problem == ""
    return ob


@pytest.fixture
def land(tmp_path):
    return add_land(tmp_path, PLACED)


def attributes(ob) -> set[str]:
    names = [layer.name for layer in evaluated_mesh(ob).attributes]
    return {name for name in names if not name.startswith(".")}


def map_of(ob, *fields: str) -> dict[str, np.ndarray]:
    """Returns fields of the library's own map, a value for each vertex."""
    with library_of(ob) as terrain:
        own = terrain.domain
        found = terrain.region(own.origin, own.samples, own.cell, fields)
    return {name: field.reshape(-1, *field.shape[2:]) for name, field in found.items()}


def assert_is_land(ob) -> None:
    """Asserts that a mesh with a vertex on each sample is the library's own map."""
    want = map_of(ob, "height", "normal")
    got = positions(ob)
    rms = float(want["height"].std())
    assert len(got) == len(want["height"])
    assert np.abs(got[:, 2] - want["height"]).max() <= 1e-5 * rms
    assert np.abs(got[:, :2] - rest(ob)[:, :2]).max() == 0.0
    assert np.abs(attribute(ob, node_group.NORMAL) - want["normal"]).max() <= 1e-6


# The rectangle and its masks ------------------------------------------------------


def test_a_placed_land_is_the_rectangle_of_its_file(land):
    assert_is_land(land)
    with library_of(land) as terrain:
        own = terrain.domain
    assert own.samples[0] > own.samples[1] > 8
    low, high = positions(land).min(0), positions(land).max(0)
    assert tuple(low[:2]) == pytest.approx((-300.0, 500.0))
    assert high[0] == pytest.approx(1300.0, abs=0.01) and 1380.0 < high[1] <= 1400.01
    assert tuple(land.location) == (0.0, 0.0, 0.0)
    uv = np.empty(2 * len(land.data.loops), np.float32)
    land.data.uv_layers["UVMap"].data.foreach_get("uv", uv)
    assert uv.min() == 0.0 and uv.max() == 1.0


def test_a_coarser_mesh_has_every_other_sample_and_the_edge(land):
    land.libocean_terrain.mesh_resolution = 32
    want = map_of(land, "height")["height"]
    with library_of(land) as terrain:
        columns, rows = terrain.domain.samples
    east = np.append(np.arange(0, columns - 1, 2), columns - 1)
    north = np.append(np.arange(0, rows - 1, 2), rows - 1)
    want = want.reshape(rows, columns)[np.ix_(north, east)]
    assert np.array_equal(positions(land)[:, 2], want.ravel())


@pytest.mark.parametrize(
    ("text", "groups"),
    [
        (WORN, ("gullies",)),
        (WORN.replace("[-300.0, 500.0]", "[]"), ("gullies",)),
        (CARVED, ("stream", "coast")),
    ],
    ids=["gullies", "at the origin", "streams and shores"],
)
def test_masks_are_attributes(tmp_path, text, groups):
    ob = add_land(tmp_path, text)
    names = [name for group in groups for name in node_group.MASKS[group]]
    want = map_of(ob, *names, "normal")
    for name in names:
        assert np.array_equal(attribute(ob, name), want[name]), name
    nx, ny, nz = want["normal"].T.astype(float)
    assert attribute(ob, "slope") == pytest.approx(np.hypot(nx, ny) / nz, abs=1e-5)
    assert_is_land(ob)
    if "coast" not in groups:
        assert not attributes(ob) & {"flow", "beach"}
        return
    assert want["beach"].max() > 0.5 and want["flow"].max() > 1e4
    ob.libocean_terrain.use_coast = False
    assert "beach" not in attributes(ob) and "flow" in attributes(ob)
    assert_is_land(ob)


def test_a_plain_tile_has_no_further_attributes():
    names = attributes(add_terrain())
    assert node_group.NORMAL in names
    assert not names & {"slope", *(name for mask in node_group.MASKS.values() for name in mask)}


def test_a_land_of_the_menu_has_gullies():
    assert bpy.ops.libocean.add_terrain(use_material=False) == {"FINISHED"}
    gully = attribute(bpy.context.object, "gully")
    assert (gully > 0.3).mean() > 0.02


def test_a_tile_with_gullies_repeats_with_its_masks():
    ob = add_terrain(64, tiles=2)
    settings = ob.libocean_terrain
    settings.gullies_longest = 0.2 * settings.patch_size
    settings.use_gullies = True
    assert settings.problem == "" and len(ob.data.vertices) == 129**2
    wear = attribute(ob, "wear").reshape(129, 129)
    assert wear.std() > 0.05
    assert np.array_equal(wear[:65, :65], wear[64:, 64:])


def test_a_mesh_beyond_a_placed_land_has_the_height_of_its_edge(land):
    ob = plane(200.0, 20)
    bpy.ops.libocean.add_terrain_modifier()
    settings = ob.libocean_terrain
    text = PLACED.replace("[-300.0, 500.0]", "[-50.0, -50.0]").replace("[1600.0, 900.0]", "[]")
    with libocean.parse_terrain(text) as terrain:
        parameter_values.assign(settings, terrain_text.read(terrain))
    assert settings.problem == ""
    got = positions(ob)
    corner = got[(rest(ob)[:, 0] <= -50.0) & (rest(ob)[:, 1] <= -50.0), 2]
    assert len(corner) > 10 and np.ptp(corner) == 0.0
    assert np.ptp(got[:, 2]) > 1.0


# Regions --------------------------------------------------------------------------


def region_of(ob, corners, cell: float) -> np.ndarray:
    """Returns the library's heights of a region, a value for each vertex."""
    samples = [round((corners[axis + 2] - corners[axis]) / cell) + 1 for axis in range(2)]
    with library_of(ob) as terrain:
        return terrain.region(tuple(corners[:2]), tuple(samples), cell)["height"].ravel()


@pytest.mark.parametrize(
    ("kind", "corners", "cell"),
    [
        ("placed", (0.0, 600.0, 100.0, 660.0), 0.5),
        ("placed", (-300.0, 500.0, 1300.0, 1300.0), 20.0),
        ("tile", (5000.0, -5000.0, 5050.0, -4950.0), 1.0),
    ],
    ids=["fine", "whole", "of a tile"],
)
def test_a_region_is_the_librarys_to_the_bit(tmp_path, kind, corners, cell):
    ob = add_terrain() if kind == "tile" else add_land(tmp_path, PLACED)
    settings = ob.libocean_terrain
    settings.region_cell, settings.region, settings.use_region = cell, corners, True
    assert settings.problem == ""
    got = positions(ob)
    assert np.array_equal(got[:, 2], region_of(ob, corners, cell))
    assert tuple(got[0, :2]) == corners[:2] and tuple(got[-1, :2]) == corners[2:]
    settings.use_region = False
    (test_terrain.assert_is_land if kind == "tile" else assert_is_land)(ob)


def test_a_region_that_cannot_be_is_said_and_the_mesh_stays(land):
    settings = land.libocean_terrain
    before = positions(land)
    settings.region, settings.use_region = (1200.0, 600.0, 1400.0, 700.0), True
    assert "beyond the land, which lies from -300 to 1300 m east" in settings.problem
    settings.region_cell = 600.0
    assert "smaller than its cell of 600 m" in settings.problem
    settings.region_cell = 0.1
    settings.region = (0.0, 600.0, 500.0, 1100.0)
    assert "5,001 x 5,001 vertices; allowed: 16,777,216" in settings.problem
    assert np.array_equal(positions(land), before)
    settings.region_cell = 5.0
    assert settings.problem == "" and len(positions(land)) == 101**2


def test_the_max_of_vertices_is_that_of_the_tool_tip():
    prop = bpy.types.Object.bl_rna.properties["libocean_terrain"].fixed_type.properties
    assert f"{extent.MAX_VERTICES:,}" in prop["region_cell"].description


# Values ---------------------------------------------------------------------------


def test_a_switch_gives_the_value_of_a_section_alone(land):
    settings = land.libocean_terrain
    assert not settings.use_gullies
    settings.use_gullies = True
    assert settings.gullies_depth == pytest.approx(0.055)
    settings.use_gullies = False
    assert settings.gullies_depth == 0.0 and settings.problem == ""
    assert parameters.TYPICAL["stream"] == pytest.approx(0.62)
    assert parameters.TYPICAL["coast"] == pytest.approx(1.0 / 30.0)


def test_values_without_effect_are_left_out_and_come_back(land):
    settings = land.libocean_terrain
    settings.coast_width, settings.stream_creep = 77.0, 11.0
    assert settings.problem == ""
    settings.kind = "tile"
    assert settings.problem == ""
    text = parameter_values.values_of(settings).text()
    assert "island" in text and "[terrain.coast]" not in text
    settings.kind, settings.use_coast = "placed", True
    values = parameter_values.values_of(settings)
    assert values.values["coast_width"] == "77.0" and values.values["island"] == "30"


def test_what_excludes_each_other_is_said_in_the_panels_words(land):
    settings = land.libocean_terrain
    settings.use_gullies = settings.use_stream = True
    assert "Gully depth" in settings.problem and "contradicts" in settings.problem
    settings.use_gullies = False
    assert settings.problem == ""


TILE = WHOLE.replace("seed = 4000000000", "seed = 40000")
FILES = {"placed": PLACED, "worn": WORN, "carved": CARVED, "tile": TILE, "measured": RINGS}


@pytest.mark.parametrize("text", FILES.values(), ids=FILES)
def test_a_file_comes_back_as_it_was(land, tmp_path, text):
    path, saved = tmp_path / "whole.toml", tmp_path / "saved.toml"
    path.write_text(text)
    assert bpy.ops.libocean.load_terrain(filepath=str(path)) == {"FINISHED"}
    assert bpy.ops.libocean.save_terrain(filepath=str(saved)) == {"FINISHED"}
    with libocean.open_terrain(path) as want:
        assert saved.read_text() == want.text


def test_an_elevation_model_is_the_land(land, tmp_path):
    grid = np.add.outer(np.arange(20.0), 3.0 * np.sin(np.arange(30.0)))
    rows = "\n".join(" ".join(f"{value:.3f}" for value in row) for row in grid[::-1])
    header = "ncols 30\nnrows 20\nxllcorner 0\nyllcorner 0\ncellsize 10\nNODATA_value -9999\n"
    (tmp_path / "model.asc").write_text(header + rows + "\n")
    settings = land.libocean_terrain
    settings.base, settings.detail_wavelength = str(tmp_path / "model.asc"), 0.0
    assert settings.problem == ""
    assert len(positions(land)) == 30 * 20
    assert_is_land(land)
    settings.base = str(tmp_path / "gone.asc")
    assert "gone.asc" in settings.problem
