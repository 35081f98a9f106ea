# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The evaluated water of a coast is libocean's region, clipped at the waterline, and its land the
bed; both follow frames, values, steps, files and renders."""

import bpy
import numpy as np
import pytest
from conftest import add_ocean, attribute, evaluated_mesh, failing, positions, rest
from layouts import drawn_by
from libocean_addon.bundled import libocean
from libocean_addon.coast import coast_job, cusps, first_coast, open_coast, panels, shore_mesh
from libocean_addon.coast.shore_mesh import Grid
from libocean_addon.look import material as water_material
from libocean_addon.sea import live as sea_live
from libocean_addon.shared import drafts
from libocean_addon.terrain import material as land_material
from libocean_addon.terrain import trees
from libocean_addon.terrain.extent import Extent
from test_land_look import trees_on

SEA = """libocean = 1
[water]
depth = 8.0
seabed = "bed.asc"
seabed_origin = [10.0, 20.0]
[grid]
resolution = 64
patch_size = 120.0
[surface]
foam_lifetime = 0.0
foam_coverage = "threshold"
foam_threshold = 1.0
[[waves]]
spectrum = "jonswap"
wind_speed = 8.0
"""
CELL = 4.0
COLUMNS, ROWS = 41, 31


def bed() -> np.ndarray:
    """Returns the heights of the bed [m], (rows, columns): a beach with a headland."""
    east, north = np.meshgrid(np.linspace(-8.0, 3.0, COLUMNS), np.linspace(-1.0, 1.0, ROWS))
    return np.round(east + 3.0 * np.exp(-8.0 * north**2), 3)


def write_bed(folder) -> None:
    head = f"ncols {COLUMNS}\nnrows {ROWS}\nxllcorner 0\nyllcorner 0\ncellsize {CELL}\n"
    rows = [" ".join(map(str, row)) for row in bed()[::-1]]
    (folder / "bed.asc").write_text(head + "\n".join(rows) + "\n")


def add_coast(path, **arguments):
    """Adds the coast of a file, without materials."""
    arguments = {"cell": CELL, "use_material": False, "use_wetness": False, **arguments}
    arguments.setdefault("use_fine_shore", False)
    arguments.setdefault("use_cusps", False)
    assert bpy.ops.libocean.add_coast(filepath=str(path), **arguments) == {"FINISHED"}
    ob = bpy.context.object
    assert ob.libocean_coast.problem == ""
    return ob


def library_of(ob):
    """Returns the library's own sea of the values in the panel."""
    return libocean.parse(sea_live.current_values(ob.libocean, bpy.context.scene).text())


FIELDS = ("displacement", "normal", "velocity", "jacobian")


def region_of(ob, frame: float) -> dict[str, np.ndarray]:
    """Returns the library's fields of all that lies over the bed, a value for each sample, and its
    significant wave height."""
    with library_of(ob) as sea:
        at, place = sea.time_of_frame(frame), ((10.0, 20.0), (COLUMNS, ROWS), CELL)
        found = sea.region(at, *place, FIELDS)
        found.update(sea.region(at, *place, ("depth", "breaking")))
        found.update(sea.region(at, *place, ("foam",)))
        height = sea.state["significant_wave_height"]["resolved"]
    made = {name: field.reshape(-1, *field.shape[2:]) for name, field in found.items()}
    return {**made, "Hs": height}


def assert_is_sea(ob) -> None:
    """Asserts that the water, all of it, is the library's region at the scene's frame."""
    ob.libocean_coast.use_clip = False
    assert_is_region(ob)
    ob.libocean_coast.use_clip = True


def assert_is_region(ob) -> None:
    """Asserts that water that is not clipped is the library's region at the scene's frame."""
    want = region_of(ob, bpy.context.scene.frame_current)
    tolerance = 1e-5 * want["Hs"]
    assert np.abs(positions(ob) - rest(ob) - want["displacement"]).max() <= tolerance
    assert np.abs(attribute(ob, "depth") - want["depth"]).max() <= tolerance
    for name in ("foam", "breaking", "jacobian", "velocity"):
        assert np.abs(attribute(ob, name) - want[name]).max() <= 1e-5, name
    assert np.abs(attribute(ob, "ocean_normal") - want["normal"]).max() <= 1e-5


def assert_is_bed(ob, level: float = 0.0) -> None:
    heights = positions(ob.libocean_coast.land)[:, 2].reshape(ROWS, COLUMNS)
    assert np.abs(heights - bed() + level).max() <= 1e-5


# Water and land -------------------------------------------------------------------


def test_the_water_ends_where_the_land_rises_above_it(coast):
    want = region_of(coast, 1)
    whole = (rest(coast) + want["displacement"]).reshape(ROWS, COLUMNS, 3)
    wet = (want["depth"] > -coast.libocean_coast.clip_depth).reshape(ROWS, COLUMNS)
    faces = wet[:-1, :-1] | wet[1:, :-1] | wet[:-1, 1:] | wet[1:, 1:]
    assert 0.3 < faces.mean() < 0.95  # of a coast that has both
    assert attribute(coast, "foam").max() > 0.1
    assert len(evaluated_mesh(coast).polygons) == faces.sum()
    shown = positions(coast)
    assert len(shown) < COLUMNS * ROWS
    assert shown[:, 0].max() < whole[..., 0].max() - CELL


def test_trees_grow_on_the_land_from_the_water_or_from_it(coast):
    land = coast.libocean_coast.land
    for active in (coast, land):
        bpy.context.view_layer.objects.active = active
        assert bpy.ops.libocean.add_trees() == {"FINISHED"}
        places = trees_on(land)
        assert len(places) > 5 and places[:, 2].min() >= 0.5 - 1e-3
        assert not bpy.ops.libocean.add_trees.poll()
        land.modifiers.remove(trees.FAMILY.modifiers(land)[0])


def ends_of(mesh) -> np.ndarray:
    """Returns the vertices of the sides that one face alone has."""
    corners = np.array([loop.vertex_index for loop in mesh.loops])
    counts = np.array([face.loop_total for face in mesh.polygons])
    after = np.arange(len(corners)) + 1
    after[np.cumsum(counts) - 1] -= counts
    sides = np.sort(np.stack([corners, corners[after]], axis=1))
    sides, counts = np.unique(sides, axis=0, return_counts=True)
    return np.unique(sides[counts == 1])


@pytest.mark.parametrize("fine", [False, True])
def test_no_gap_opens_between_water_and_land(coast, scene, fine):
    """The water goes on below the land wherever it ends before the border of the region."""
    coast.libocean_coast.use_fine_shore = fine
    for frame in (1, 7, 13):
        scene.frame_set(frame)
        ends = ends_of(evaluated_mesh(coast))
        label, depth = attribute(coast, "label")[ends, :2], attribute(coast, "depth")[ends]
        low, high = np.array((10.0, 20.0)), np.array((10.0, 20.0)) + CELL * np.array((40, 30))
        inside = ((label > low + 1e-3) & (label < high - 1e-3)).all(axis=1)
        assert inside.sum() > 20
        assert depth[inside].max() < 0.0


def test_water_and_land_are_finer_where_they_meet(sea_file, scene):
    """Cells of 4 m, and of 1 m in the swash; the vertices on samples have the library's values, and
    no side of a face ends within another one."""
    ob = add_coast(sea_file, use_fine_shore=True)
    ob.libocean_coast.use_clip, land = False, ob.libocean_coast.land
    want = region_of(ob, 1)
    count = COLUMNS * ROWS
    assert len(ob.data.vertices) == len(land.data.vertices) > 1.3 * count
    moved = (positions(ob) - rest(ob))[:count] - want["displacement"]
    assert np.abs(moved).max() <= 1e-5 * want["Hs"]
    heights = positions(land)[:, 2]
    assert np.abs(heights[:count].reshape(ROWS, COLUMNS) - bed()).max() <= 1e-5
    low, high = np.array((10.0, 20.0)), np.array((170.0, 140.0))
    for part in (ob, land):
        ends = rest(part)[ends_of(part.data), :2]
        assert len(ends) >= 2 * (COLUMNS + ROWS) - 4
        assert (np.isclose(ends, low) | np.isclose(ends, high)).any(axis=1).all()
    low, high = np.multiply(shore_mesh._BAND, want["Hs"])
    places = rest(land)
    for face in land.data.polygons:
        corners = list(face.vertices)
        if heights[corners].min() < high and heights[corners].max() > low:
            assert np.ptp(places[corners, :2], axis=0).max() <= 1.0 + 1e-4
    assert 4.0 in {np.ptp(places[list(face.vertices), 0]) for face in land.data.polygons}
    before = ob.data["libocean_mesh"]
    ob.libocean.waves[0].wind_speed = 8.1
    assert ob.data["libocean_mesh"] == before, "the mesh stays while values glide"


def plane_beach(slope: float, wave_height: float) -> Grid:
    """Returns a grid of cells of 2.5 m over a beach that rises along x, finer at the water."""
    extent = Extent((0.0, 0.0), 2.5, (41, 121), False, is_own=False)
    heights = np.broadcast_to(slope * (2.5 * np.arange(41) - 50.0), extent.shape)
    normals = np.broadcast_to(np.array([-slope, 0.0, 1.0]) / np.hypot(slope, 1.0), (121, 41, 3))
    return Grid(extent, coast_job.Bed(heights, normals, "beach"), wave_height)


def lobes(grid: Grid, higher: np.ndarray, level: float) -> np.ndarray:
    """Returns where water of a level ends along a beach, (places,) [m]: at the first ground above
    it, linear between vertices."""
    columns = np.rint(grid.places[:, :2] / 0.625).astype(int)
    bed = grid.bed.heights
    slope = (bed[0, 1] - bed[0, 0]) / 2.5
    rows = np.repeat(slope * (0.625 * np.arange(161) - 50.0)[:, None], 481, axis=1)
    rows[tuple(columns.T)] = grid.read(bed) + higher
    first = (rows > level).argmax(axis=0)
    low, high = (rows[first - step, np.arange(481)] for step in (1, 0))
    return 0.625 * (first - 1 + (level - low) / (high - low))


STATE = {"significant_wave_height": {"resolved": 0.9}, "peak_period": {"resolved": 4.4}}


@pytest.mark.parametrize("slope", [0.04, 0.09])
def test_water_ends_in_lobes_on_cusps_and_each_wave_in_others(slope):
    """Of 2 to 12 m along the shore, as deep on a flat beach as on a steep one; without cusps in a
    straight line."""
    grid = plane_beach(slope, 1.0)
    found = cusps.Cusps.of(grid, STATE)
    width = cusps.swash_width(STATE, slope)
    assert 1.0 <= found.spacing / (1.63 * width) < 2.0**0.5
    higher, slopes = found.at(grid)
    straight = lobes(grid, 0.0 * higher, 0.1)
    assert np.ptp(straight) < 1e-6
    low, high = (lobes(grid, higher, level) for level in (0.02, 0.14))
    for line in (low, high):
        deviation = np.std(line) / found.spacing
        assert 0.04 < deviation < 0.12, f"{deviation:.3f} spacings, by the rule 0.07"
        turns = np.diff(np.sign(np.diff(line)))
        length = 2.0 * 0.625 * len(line) / np.count_nonzero(turns)
        assert 0.2 < length / found.spacing < 1.2
    assert np.corrcoef(low, high)[0, 1] < 0.9
    bed = grid.read(grid.bed.heights)
    assert not higher[(bed < grid.band[0]) | (bed > grid.band[1])].any()
    assert np.std(slopes[(bed > 0.0) & (bed < 0.2)]) < 2.0 * slope


def test_land_has_the_cusps_and_the_water_knows_them(sea_file):
    ob = add_coast(sea_file, use_fine_shore=True, use_cusps=True)
    land = ob.libocean_coast.land
    ob.libocean_coast.use_clip = False
    raised, heights = attribute(ob, "cusp"), positions(land)[:, 2]
    near = (heights > 0.0) & (heights < 0.1)
    assert 0.01 < np.std(raised[near]) < 0.1
    assert raised.min() > -ob.libocean_coast.clip_depth, "the water goes on below"
    assert np.array_equal(heights, attribute(land, "terrain_height"))
    with_cusps = attribute(land, "terrain_normal")
    ob.libocean_coast.use_cusps = False
    assert "cusp" not in evaluated_mesh(ob).attributes
    assert np.abs(heights - positions(land)[:, 2] - raised).max() < 2e-4
    without = attribute(land, "terrain_normal")
    assert np.abs(np.linalg.norm(with_cusps, axis=1) - 1.0).max() < 1e-3
    tilted = np.abs(with_cusps - without).max(axis=1)
    assert tilted[heights < -5.0].max() < 2e-4 and tilted[near].max() > 0.02


def test_the_land_is_the_bed(coast):
    land = coast.libocean_coast.land
    assert land.parent == coast and land.name == "Land"
    heights = positions(land)[:, 2].reshape(ROWS, COLUMNS)
    assert np.abs(heights - bed()).max() <= 1e-5
    assert tuple(positions(land)[0, :2]) == (10.0, 20.0)
    assert np.array_equal(attribute(land, "terrain_height"), positions(land)[:, 2])
    beach = attribute(land, "beach")
    assert beach[heights.ravel() < 0.0].min() == 1.0 and beach[heights.ravel() > 3.0].max() == 0.0
    nx, _, nz = attribute(land, "terrain_normal").reshape(ROWS, COLUMNS, 3)[0, 5]
    assert -nx / nz == pytest.approx(11.0 / (COLUMNS - 1) / CELL, abs=1e-3)


def test_water_and_land_have_materials(sea_file):
    ob = add_coast(sea_file, use_material=True)
    land = ob.libocean_coast.land
    (ground,) = land_material.grounds(land)
    assert ground.inputs["Pixel Angle"].is_linked
    with library_of(ob) as sea:
        height = sea.state["significant_wave_height"]["resolved"]
    assert ground.inputs["Wet Line"].default_value == pytest.approx(0.3 * height)
    (water,) = water_material.waters_of(ob)
    assert water.inputs["Wave Height"].default_value == pytest.approx(height)


def test_the_automatic_cell_gives_the_longer_side_512_samples(sea_file, monkeypatch):
    monkeypatch.setattr(coast_job, "AUTOMATIC", 64)
    ob = add_coast(sea_file, cell=0.0)
    own = open_coast.coast_of(ob.name_full).own
    assert coast_job.region_of(ob.libocean_coast).extent(own).samples == (64, 48)
    assert len(ob.data.vertices) == 64 * 48


def test_a_region_shows_a_part_at_its_own_cell(coast):
    settings = coast.libocean_coast
    settings.region = (50.0, 40.0, 90.0, 100.0)
    settings.use_region, settings.use_clip = True, False
    settings.cell = 2.0
    assert settings.problem == ""
    assert len(coast.data.vertices) == 21 * 31
    with library_of(coast) as sea:
        want = sea.region(sea.time_of_frame(1), (50.0, 40.0), (21, 31), 2.0)["displacement"]
        tolerance = 1e-5 * sea.state["significant_wave_height"]["resolved"]
    assert np.abs(positions(coast) - rest(coast) - want.reshape(-1, 3)).max() <= tolerance
    assert len(settings.land.data.vertices) == 21 * 31
    settings.region = (-500.0, 40.0, 90.0, 100.0)
    assert "reaches beyond" in settings.problem


def test_without_a_file_it_is_an_island_that_suits_its_sea(tmp_path, small_coast):
    for filepath in ("", f"{tmp_path}/"):
        bpy.ops.libocean.add_coast(filepath=filepath, cell=64.0, use_material=False)
        ob = bpy.context.object
        assert ob.libocean_coast.problem == "" and ob.libocean.bed_lines
        assert np.abs(attribute(ob, "ocean_velocity")).max() > 0.1


def test_the_island_has_beaches_and_draws_no_warning_about_itself():
    with libocean.parse(first_coast.values().text()) as sea:
        state = sea.state
        own = state["bed"]["samples"], state["bed"]["cell"]
        heights = sea.bed_region((0.0, 0.0), *own)
    assert state["warnings"] == []
    assert 0.1 < 1.0 - state["bed"]["wet_share"] < 0.5
    slope = np.hypot(*np.gradient(heights, own[1]))
    assert 0.03 < np.median(slope[(heights > 0.5) & (heights < 3.0)]) < 0.12


def test_far_water_lies_around_the_map(sea_file):
    ob = add_coast(sea_file, use_far_water=True, use_material=True)
    far = ob.libocean_coast.far_water
    assert far.parent == ob and len(far.data.polygons) == 8 + 4
    assert far.material_slots[0].material == ob.material_slots[0].material
    settings = ob.libocean_coast
    for region in (None, (50.0, 40.0, 90.0, 100.0)):
        if region is not None:
            settings.region, settings.use_region = region, True
        inner = rest(far)[:16].reshape(4, 4, 3)[1:3, 1:3].reshape(-1, 3)
        corners = rest(ob)
        assert np.array_equal(inner.min(axis=0), corners.min(axis=0))
        assert np.array_equal(inner.max(axis=0), corners.max(axis=0))
        assert np.ptp(rest(far)[:, 0]) > 8e4
    assert all(face.normal.z > 0.9 for face in far.data.polygons)
    with library_of(ob) as sea:
        slopes = sea.state["mean_square_slope"]["resolved"]
        height = sea.state["significant_wave_height"]["resolved"]
    assert rest(far)[-4:, 2] == pytest.approx(-height), "a slope closes the border below troughs"
    assert attribute(far, "slope_variance") == pytest.approx(slopes, rel=1e-5)


# Values ---------------------------------------------------------------------------


def test_another_wind_and_another_level_make_another_coast(coast):
    settings = coast.libocean
    settings.waves[0].wind_speed = 6.0
    assert_is_sea(coast)
    settings.level = 1.0
    assert_is_sea(coast)
    assert_is_bed(coast, 1.0)


def test_a_bed_alone_gets_the_sea_of_the_active_ocean(sea_file):
    ocean = add_ocean(64, use_material=False)
    ocean.libocean.waves[0].wind_speed = 7.5
    ob = add_coast(sea_file.with_name("bed.asc"))
    assert ob.libocean.waves[0].wind_speed == 7.5
    assert len(ob.data.vertices) == COLUMNS * ROWS
    assert ob.libocean_coast.land is not None


def test_a_sea_without_a_bed_is_said(coast):
    coast.libocean.seabed = ""
    assert "has no bed" in coast.libocean_coast.problem


# Objects and files ----------------------------------------------------------------


def test_a_land_that_is_deleted_stays_away(coast):
    land = coast.libocean_coast.land
    with bpy.context.temp_override(selected_objects=[land]):
        bpy.ops.object.delete()
    before = bpy.data.meshes["Land"]["libocean_mesh"]
    coast.libocean.level = 0.5
    assert coast.libocean_coast.problem == "" and len(bpy.context.scene.objects) == 1
    assert bpy.data.meshes["Land"]["libocean_mesh"] == before
    assert_is_sea(coast)


def test_a_modifier_that_was_removed_comes_back(coast):
    coast.modifiers.clear()
    bpy.context.view_layer.objects.active = coast
    assert bpy.ops.libocean.add_modifier() == {"FINISHED"}
    assert coast.libocean_coast.problem == ""
    assert_is_sea(coast)
    assert_is_bed(coast)


def test_a_mesh_of_the_user_is_never_replaced_by_a_coast(coast):
    coast.modifiers.clear()
    coast.data = bpy.data.meshes.new("Own")
    coast.data.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], [(0, 1, 2)])
    assert "add a coast instead" in failing(bpy.ops.libocean.add_modifier)
    assert not coast.modifiers and len(coast.data.vertices) == 3


# The panel ------------------------------------------------------------------------


def test_the_panels_show_the_sea_and_its_bed(coast, monkeypatch):
    coast.libocean_coast.region = (50.0, 40.0, 90.0, 100.0)
    coast.libocean_coast.use_region = True
    shown = " ".join(drawn_by(*panels.CLASSES))
    for word in ("wind_speed", "seabed", "level", "swash", "cell", "region", "clip_depth", "land"):
        assert word in shown, word
    assert "libocean.add_waves" in shown and "Bed: -7.999 to 6 m" in shown
    coast.libocean_coast.region = (-500.0, 40.0, 90.0, 100.0)
    assert "reaches beyond" in " ".join(drawn_by(panels.coast_panel))
    monkeypatch.setattr(drafts, "progress", lambda _name: 0.25)
    assert "25%" in " ".join(drawn_by(panels.coast_panel))


def test_the_waves_of_a_coast_come_and_go(coast):
    assert bpy.ops.libocean.add_waves() == {"FINISHED"}
    assert_is_sea(coast)
    assert bpy.ops.libocean.remove_waves() == {"FINISHED"}
    assert_is_sea(coast)
    assert "has a coast" in failing(bpy.ops.libocean.add_modifier)
