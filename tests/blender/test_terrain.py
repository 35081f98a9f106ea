# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The evaluated mesh of a terrain is libocean's land, on tiles and on other meshes, with the values
of every file."""

import bpy
import numpy as np
import pytest
from conftest import attribute, evaluated_mesh, failing, plane, positions, rest
from libocean_addon.bundled import libocean
from libocean_addon.shared import changes
from libocean_addon.terrain import live, node_group, parameter_values, terrain_text
from libocean_addon.terrain.parameters import PARAMETERS
from libocean_addon.terrain.subject import TERRAIN


def add_terrain(resolution: int = 64, preset: str = "seed_smooth", **arguments):
    """Adds a terrain with maps of so many samples, without a material."""
    arguments.setdefault("use_material", False)
    assert bpy.ops.libocean.add_terrain(preset=preset, **arguments) == {"FINISHED"}
    ob = bpy.context.object
    ob.libocean_terrain.resolution = resolution
    return ob


def library_of(ob):
    """Returns the library's own terrain of the values in the panel."""
    return libocean.parse_terrain(parameter_values.values_of(ob.libocean_terrain).text())


def on_samples(field: np.ndarray, tiles: int = 1) -> np.ndarray:
    """Returns a field at the vertices of tiles: the origin in the middle, the seam on both
    sides."""
    n = len(field)
    index = (np.arange(n * tiles + 1) - n * tiles // 2) % n
    return field[np.ix_(index, index)].reshape(len(index) ** 2, *field.shape[2:])


def assert_is_land(ob, tolerance: float = 1e-5, tiles: int = 1) -> None:
    with library_of(ob) as terrain:
        surface = terrain.surface()
        rms = float(surface.height.std())
        height = on_samples(surface.height, tiles)
        normal = on_samples(surface.normal, tiles)
    got = positions(ob)
    assert np.abs(got[:, 2] - height).max() <= tolerance * rms
    assert np.abs(got[:, :2] - rest(ob)[:, :2]).max() == 0.0
    assert np.abs(attribute(ob, node_group.NORMAL) - normal).max() <= 1e-6
    assert np.abs(attribute(ob, node_group.HEIGHT) - height).max() <= tolerance * rms


@pytest.fixture
def terrain():
    return add_terrain()


# One surface ----------------------------------------------------------------------


def is_tile(preset: str) -> bool:
    with libocean.terrain_preset(preset) as terrain:
        return terrain.domain.wraps


# Land that exists once is in test_land.py.
@pytest.mark.parametrize("preset", filter(is_tile, libocean.terrain_presets()))
def test_a_tile_is_the_land_of_the_library(preset):
    ob = add_terrain(128, preset)
    assert len(ob.data.vertices) == 129**2
    assert_is_land(ob)


@pytest.mark.parametrize("tiles", [2, 3])
def test_tiles_repeat_the_land(terrain, tiles):
    terrain.libocean_terrain.tiles = tiles
    assert len(terrain.data.vertices) == (64 * tiles + 1) ** 2
    assert_is_land(terrain, tiles=tiles)


def test_a_mesh_coarser_than_the_map_shows_every_other_sample(terrain):
    terrain.libocean_terrain.mesh_resolution = 32
    with library_of(terrain) as library:
        height = on_samples(library.surface().height[::2, ::2])
    assert np.abs(positions(terrain)[:, 2] - height).max() <= 1e-5 * height.std()


def test_any_mesh_is_raised_where_it_lies():
    ob = plane(300.0, 40)
    assert bpy.ops.libocean.add_terrain_modifier() == {"FINISHED"}
    ob.libocean_terrain.resolution, ob.libocean_terrain.patch_size = 256, 1000.0
    with library_of(ob) as library:
        height, cell = library.surface().height, 1000.0 / 256
    place = rest(ob)[:, :2].astype(float) / cell
    first = np.floor(place).astype(int)
    u, v = (place - first).T
    i, j = first.T

    def corner(di, dj):
        return height[(j + dj) % 256, (i + di) % 256].astype(float)

    want = (corner(0, 0) * (1 - u) + corner(1, 0) * u) * (1 - v)
    want += (corner(0, 1) * (1 - u) + corner(1, 1) * u) * v
    assert np.abs(positions(ob)[:, 2] - want).max() <= 2e-5 * height.std()
    assert "UVMap" in ob.data.uv_layers


def test_the_mesh_has_a_map_of_the_tile(terrain):
    mesh = evaluated_mesh(terrain)
    uv = np.empty(2 * len(mesh.loops), np.float32)
    mesh.uv_layers["UVMap"].data.foreach_get("uv", uv)
    corners = np.empty(len(mesh.loops), np.int32)
    mesh.loops.foreach_get("vertex_index", corners)
    period = terrain.libocean_terrain.patch_size
    assert np.abs(uv.reshape(-1, 2) * period - positions(terrain)[corners, :2]).max() <= 1e-4


def test_a_mask_keeps_the_ground_level(terrain):
    group = terrain.vertex_groups.new(name="Field")
    group.add(list(range(len(terrain.data.vertices) // 2)), 1.0, "REPLACE")
    terrain.libocean_terrain.mask = "Field"
    half = len(terrain.data.vertices) // 2
    assert np.abs(positions(terrain)[half:, 2]).max() == 0.0
    assert np.abs(positions(terrain)[:half, 2]).max() > 1.0


def test_land_that_is_anchored_stays_while_the_object_moves(terrain):
    settings = terrain.libocean_terrain
    before = positions(terrain)[:, 2]
    terrain.location.x = 64.0 * settings.patch_size / 256
    bpy.context.view_layer.update()
    assert np.abs(positions(terrain)[:, 2] - before).max() == 0.0  # it moves with its object
    settings.follow_world = True
    bpy.context.view_layer.update()
    moved = positions(terrain)[:, 2].reshape(65, 65)
    want = np.roll(before.reshape(65, 65)[:-1, :-1], -16, axis=1)
    assert np.abs(moved[:-1, :-1] - want).max() <= 1e-4


# Values ---------------------------------------------------------------------------


def test_every_preset_comes_back_from_properties_as_it_was(terrain):
    for preset in libocean.terrain_presets():
        with libocean.terrain_preset(preset) as want, changes.quiet():
            parameter_values.assign(terrain.libocean_terrain, terrain_text.read(want))
            with library_of(terrain) as got:
                assert got.text == want.text


WHOLE = """libocean = 1
[terrain]
resolution = 64
patch_size = 800.0
range = [-12.3456789012, 345.678901234]
outer_scale = 700.0
breaks = [[123.456789012, 2.7], [20.0, 1.9]]
ridge_wavelength = 100.0
ridge_direction = 33.0
anisotropy = 1.5
[[terrain.layer]]
period = 400.0
gain = 0.3
seed = 4000000000
[[terrain.layer]]
period = 266.66666666666669
"""


def test_a_number_that_is_changed_loses_the_digits_of_the_file(terrain, tmp_path):
    path = tmp_path / "whole.toml"
    path.write_text(WHOLE)
    bpy.ops.libocean.load_terrain(filepath=str(path))
    terrain.libocean_terrain.breaks[0] = 150.0
    with library_of(terrain) as library:
        assert library.get("breaks") == "[[150, 2.7], [20, 1.9]]"
        assert library.get("terrain.layer.0.seed") == "4000000000"


RINGS = """libocean = 1
[terrain]
resolution = 64
measured = "rings.csv"
[terrain.measured_rings]
wavenumber = [0.01, 0.1, 1.0]
density = [40000.0, 30.0, 0.01]
"""


@pytest.fixture
def measured(terrain, tmp_path):
    """Returns a terrain with a measured spectrum, as a resolved file holds it."""
    path = tmp_path / "measured.toml"
    path.write_text(RINGS)
    assert bpy.ops.libocean.load_terrain(filepath=str(path)) == {"FINISHED"}
    return terrain


def test_a_measured_spectrum_is_kept_without_its_file(measured):
    settings = measured.libocean_terrain
    assert settings.problem == ""
    for seed in (7, 1):
        settings.seed = seed
        assert_is_land(measured)


def test_the_spectrum_of_a_file_is_kept_in_the_settings(measured):
    settings = measured.libocean_terrain
    kept = settings.measured_rings
    assert not live.keep_spectrum(TERRAIN.look_up(measured))  # it is
    with changes.quiet():
        settings.measured_rings = ""  # as the property of the file's name leaves it
    assert live.keep_spectrum(TERRAIN.look_up(measured))
    assert settings.measured_rings == kept


def test_a_file_that_is_gone_is_said_and_the_law_comes_back(measured):
    settings = measured.libocean_terrain
    settings.outer_scale, settings.use_rms = 50.0, False
    assert settings.problem == ""  # the law does not count
    settings.measured = "//gone.csv"
    assert "gone.csv" in settings.problem
    settings.measured = ""
    assert settings.problem == ""
    with library_of(measured) as library:
        assert library.get("outer_scale") == "50"
    assert_is_land(measured)


def test_a_range_takes_the_place_of_rms_and_mean(terrain):
    settings = terrain.libocean_terrain
    settings.mean = 500.0
    settings.range = (-20.0, 30.0)
    assert settings.use_range and settings.problem == ""
    heights = positions(terrain)[:, 2]
    assert heights.min() == pytest.approx(-20.0) and heights.max() == pytest.approx(30.0)
    settings.use_range = False
    assert positions(terrain)[:, 2].mean() == pytest.approx(500.0, abs=2.0)


def test_breaks_and_layers_come_and_go(terrain):
    settings = terrain.libocean_terrain
    for _ in range(8):
        assert bpy.ops.libocean.add_break() == {"FINISHED"}
    assert settings.problem == ""
    assert "at most 8 breaks" in failing(bpy.ops.libocean.add_break)
    bpy.ops.libocean.remove_break(number=3)
    assert len(parameter_values.values_of(settings).values["breaks"].split("], [")) == 7
    for _ in range(3):
        assert bpy.ops.libocean.add_terrain_layer() == {"FINISHED"}
    assert_is_land(terrain)
    bpy.ops.libocean.remove_terrain_layer(number=1)
    assert [layer.seed for layer in settings.layers] == [2, 4]
    assert "no layer 9" in failing(bpy.ops.libocean.remove_terrain_layer, number=8)
    assert_is_land(terrain)


def test_every_parameter_is_a_property(terrain):
    bpy.ops.libocean.add_terrain_layer()
    for entry in PARAMETERS.rows:
        owner = terrain.libocean_terrain
        owner = owner.layers[0] if entry["section"] == "terrain.layer" else owner
        prop = owner.bl_rna.properties[entry["key"]]
        assert prop.name == entry["label"] and entry["help"].rstrip(".") in prop.description
        if entry["type"] == "float":
            assert prop.soft_min == pytest.approx(entry["soft_min"])
