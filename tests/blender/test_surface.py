# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The evaluated mesh is libocean's surface: on patches, on other meshes, everywhere in a file."""

import bpy
import numpy as np
import pytest
from conftest import add_ocean, attribute, opened, plane, positions, presets_with, rest
from libocean_addon.bundled import libocean
from test_terrain import on_samples

FRAMES = (1, 40, 250)
ROUND, ODD = 200.0, 137.3  # periods: a vertex's place is exact in one, rounded in the other

SEA = """
libocean = 1
[grid]
resolution = 64
patch_size = {period}
[surface]
foam_lifetime = {past}
[random]
seed = {seed}
[[waves]]
spectrum = "jonswap"
wind_speed = 14.0
wind_direction = 30.0
"""


@pytest.fixture
def load(tmp_path):
    """load(ob, period, seed): puts a sea into an object; returns the library's. past: of its foam
    [s], which takes as long as all else."""

    def put(ob, period=ROUND, seed=1, past=0.0):
        path = tmp_path / f"{period}_{seed}.toml"
        path.write_text(SEA.format(period=period, seed=seed, past=past))
        bpy.context.view_layer.objects.active = ob
        assert bpy.ops.libocean.load_sea(filepath=str(path)) == {"FINISHED"}
        return libocean.open(path)

    return put


def test_crests_of_a_file_are_shown_kept_and_saved(tmp_path):
    ob = add_ocean(64, kind="PATCH")
    path = tmp_path / "hero.toml"
    crest = '[[crests]]\ntime = 3.0\nx = 40.0\ny = 50.0\nheight = "1.2 Hs"\n'
    path.write_text(SEA.format(period=ROUND, seed=1, past=0.0) + crest)
    bpy.context.view_layer.objects.active = ob
    assert bpy.ops.libocean.load_sea(filepath=str(path)) == {"FINISHED"}
    ob.libocean.choppiness = 0.8
    saved = tmp_path / "saved.toml"
    assert bpy.ops.libocean.save_sea(filepath=str(saved)) == {"FINISHED"}
    assert crest in saved.read_text()
    with libocean.open(saved) as sea:
        (told,) = sea.state["crests"]
        (there,) = sea.query([(40.0, 50.0)], 3.0, foam=False)
        assert there[2] == pytest.approx(told["height"], rel=1e-2)
    name, blend = ob.name, tmp_path / "hero.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(blend))
    bpy.ops.wm.open_mainfile(filepath=str(blend))
    settings = bpy.data.objects[name].libocean
    (row,) = settings.crests
    assert row.empty.location[:] == (40.0, 50.0, 0.0) and settings.problem == ""


def significant_wave_height(sea) -> float:
    return sea.state["significant_wave_height"]["resolved"]


def patch(load, period=ROUND, **sea):
    ob = add_ocean(64, kind="PATCH")
    return ob, load(ob, period, **sea)


def at_points(sea, field: str, points: np.ndarray, time: float) -> np.ndarray:
    """A field between its samples, as Blender's linear interpolation has it, in double."""
    values = getattr(sea.surface(time), field).astype(np.float64)
    n, period = len(values), float(sea.get("patch_size"))
    place = points[:, :2].astype(np.float64) / period * n
    first = np.floor(place).astype(int)
    across = (place - first)[:, :, None] if values.ndim == 3 else place - first
    (i, j), (u, v) = first.T, (across[:, 0], across[:, 1])

    def corner(di, dj):
        return values[(j + dj) % n, (i + di) % n]

    bottom = corner(0, 0) * (1 - u) + corner(1, 0) * u
    return bottom * (1 - v) + (corner(0, 1) * (1 - u) + corner(1, 1) * u) * v


def assert_patch(ob, sea, time, tolerance=1e-5):
    surface = sea.surface(time)
    limit = tolerance * significant_wave_height(sea)
    error = np.abs(positions(ob) - rest(ob) - on_samples(surface.displacement))
    assert error.max() <= limit
    assert np.abs(attribute(ob, "velocity") - on_samples(surface.velocity)).max() <= limit
    assert np.abs(attribute(ob, "ocean_velocity") - on_samples(surface.velocity)).max() <= limit
    assert np.abs(attribute(ob, "ocean_normal") - on_samples(surface.normal)).max() <= 1e-6
    assert np.abs(attribute(ob, "foam") - on_samples(surface.foam)).max() <= 1e-6
    assert np.abs(attribute(ob, "cover") - on_samples(surface.cover)).max() <= 1e-6


@pytest.mark.parametrize("period", [ROUND, ODD])
def test_a_patch_is_the_surface(scene, load, period):
    ob, sea = patch(load, period, past=1.0)
    for frame in (*FRAMES, 2):
        scene.frame_set(frame)
        assert np.ptp(positions(ob)[:, 2]) > 0.5 * significant_wave_height(sea)
        assert_patch(ob, sea, (frame - 1) / 24)


@pytest.mark.parametrize("period", [ROUND, ODD])
@pytest.mark.parametrize(("periods", "tolerance"), [(0, 2e-5), (50, 1e-3)])
def test_any_mesh_shows_the_surface_where_it_lies(scene, load, periods, tolerance, period):
    ob = plane(period, 50)
    ob.location = ((periods + 0.37) * period, -(periods + 0.81) * period, 0)
    with presets_with(resolution=64):
        assert bpy.ops.libocean.add_modifier() == {"FINISHED"}
    sea = load(ob, period)
    for frame in FRAMES:
        scene.frame_set(frame)
        world = rest(ob) + np.array(ob.location)
        want = at_points(sea, "displacement", world, (frame - 1) / 24)
        error = np.abs(positions(ob) - rest(ob) - want).max()
        assert error <= tolerance * significant_wave_height(sea)


def test_tiles_of_a_grid_meet(scene, load):
    left, sea = patch(load)
    right = left.copy()
    bpy.context.collection.objects.link(right)
    right.location.x = ROUND
    scene.frame_set(30)
    n = 65
    a, b = (positions(ob).reshape(n, n, 3) + np.array(ob.location) for ob in (left, right))
    assert np.abs(a[:, -1] - b[:, 0]).max() <= 1e-5 * significant_wave_height(sea)


@pytest.mark.parametrize("tilt", [0.0, 0.3])
@pytest.mark.parametrize("is_patch", [True, False])
def test_what_is_turned_shows_the_same_sea(scene, load, is_patch, tilt):
    """Turned in the world it looks where it lies, and is moved as the world's sea moves."""
    if is_patch:
        ob, sea = patch(load)
    else:
        ob = plane(ROUND, 50)
        with presets_with(resolution=64):
            bpy.ops.libocean.add_modifier()
        sea = load(ob)
    ob.location, ob.rotation_euler = (31.7, -12.2, 3.0), (tilt, 0.0, 0.6)
    bpy.context.view_layer.update()
    scene.frame_set(30)
    turn = np.array(ob.matrix_world.to_3x3())
    limit = 2e-5 * significant_wave_height(sea)
    at_rest = rest(ob) @ turn.T + np.array(ob.location)
    found = positions(ob) @ turn.T + np.array(ob.location)
    want = at_points(sea, "displacement", at_rest, 29 / 24)
    assert np.abs(found - at_rest - want).max() <= limit
    for name, field in (("ocean_velocity", "velocity"), ("ocean_normal", "normal")):
        want = at_points(sea, field, at_rest, 29 / 24)
        assert np.abs(attribute(ob, name) @ turn.T - want).max() <= 2e-5


def test_what_is_not_anchored_takes_its_sea_along(scene, load):
    ob, sea = patch(load)
    ob.libocean.follow_world = False
    ob.location, ob.rotation_euler.z = (31.7, -12.2, 3.0), 0.6
    bpy.context.view_layer.update()
    scene.frame_set(30)
    assert_patch(ob, sea, 29 / 24)


def test_a_mesh_finer_or_coarser_than_its_maps(scene, load):
    ob, sea = patch(load)
    scene.frame_set(10)
    limit = 1e-5 * significant_wave_height(sea)
    for side in (128, 32):
        ob.libocean.mesh_resolution = side
        assert len(ob.data.vertices) == (side + 1) ** 2
        want = at_points(sea, "displacement", rest(ob), 9 / 24)
        assert np.abs(positions(ob) - rest(ob) - want).max() <= limit


def test_copies_that_share_a_mesh_part_when_their_periods_do(scene, load):
    ob, sea = patch(load)
    twin = ob.copy()
    bpy.context.collection.objects.link(twin)
    bpy.context.view_layer.update()
    assert twin.data == ob.data
    other = load(twin, period=ODD, seed=2)
    assert twin.data != ob.data
    scene.frame_set(10)
    assert_patch(ob, sea, 9 / 24)
    assert_patch(twin, other, 9 / 24)


def test_images_that_blender_packed_at_the_end_are_let_go(scene, load, tmp_path):
    """ "Save modified images", when Blender is left, packs what shows a sea into the file."""
    ob, sea = patch(load)
    scene.frame_set(10)
    for image in bpy.data.images:
        image.pack()
    sizes = []
    for name in ("packed.blend", "slim.blend"):
        path = tmp_path / name
        bpy.ops.wm.save_as_mainfile(filepath=str(path), compress=False)
        assert_patch(opened(path, "Ocean"), sea, 9 / 24)
        sizes.append(path.stat().st_size)
    assert sizes[1] < sizes[0] - 3 * 64 * 64 * 4


def test_a_mask_keeps_the_mesh_where_it_is(scene, load):
    ob, sea = patch(load)
    group = ob.vertex_groups.new(name="sea")
    group.add(range(65 * 32), 1.0, "REPLACE")
    ob.libocean.mask = "sea"
    scene.frame_set(10)
    moved = np.abs(positions(ob) - rest(ob)).max(axis=1)
    assert moved[65 * 32 :].max() == 0
    want = on_samples(sea.surface(9 / 24).displacement)[: 65 * 32]
    got = (positions(ob) - rest(ob))[: 65 * 32]
    assert np.abs(got - want).max() <= 1e-5 * significant_wave_height(sea)
    assert attribute(ob, "foam")[65 * 32 :].max() == 0


def test_a_take_is_played_kept_and_let_go(scene, load, tmp_path):
    ob, _ = patch(load)

    def sideways(frame: int) -> float:
        scene.frame_set(frame)
        return np.abs((positions(ob) - rest(ob))[:, :2]).max()

    free = sideways(60)
    take = tmp_path / "rising.take"
    take.write_text("0 choppiness 0\n4 choppiness 1\n")
    ob.libocean.take = str(take)
    assert ob.libocean.problem == ""
    assert sideways(60) < 0.1 * free
    assert sideways(240) > 0.5 * free
    # A saved sea has it inside.
    bpy.ops.libocean.save_sea(filepath=str(tmp_path / "sea.toml"))
    take.unlink()
    bpy.ops.libocean.load_sea(filepath=str(tmp_path / "sea.toml"))
    assert sideways(60) < 0.1 * free
    ob.libocean.take = ""
    assert sideways(60) == pytest.approx(free, rel=1e-6)


def test_a_time_of_its_own(scene, load):
    ob, sea = patch(load)
    ob.libocean.use_custom_time = True
    ob.libocean.custom_time = 12.5
    assert_patch(ob, sea, 12.5)


def test_slopes_that_the_map_leaves_out_are_told(scene, load):
    ob, sea = patch(load)
    state = sea.state
    shown = {m["resolution"]: m["mean_square_slope"] for m in state["map_slopes"]}
    for resolution in (64, 32):
        ob.libocean.viewport_resolution = resolution
        scene.frame_set(10)
        lost = state["mean_square_slope"]["asked"] - shown[resolution]
        assert lost > 0.001
        assert attribute(ob, "slope_variance") == pytest.approx(lost, rel=1e-5)


def test_viewport_and_render_have_resolutions_of_their_own(scene, load):
    ob, sea = patch(load)
    ob.libocean.viewport_resolution = 32
    scene.frame_set(10)
    coarse = sea.surface(9 / 24, 32).height
    got = (positions(ob) - rest(ob))[:, 2].reshape(65, 65)[::2, ::2]
    index = (np.arange(33) - 16) % 32
    want = coarse[np.ix_(index, index)]
    assert np.abs(got - want).max() <= 1e-5 * significant_wave_height(sea)
