# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A land that exists once while its whole is made in the background, and as a mesh around the
camera."""

import threading
import time

import bpy
import numpy as np
import pytest
from conftest import attribute, finish, keyed, positions, reopened, rest, work_on
from libocean_addon.shared import drafts, life, meshes
from libocean_addon.terrain import camera_mesh, live, material, node_group, open_terrain
from libocean_addon.terrain.subject import TERRAIN
from test_land import CARVED, PLACED, add_land, assert_is_land, library_of


def test_a_tile_of_an_earlier_version_gets_todays_nodes():
    bpy.ops.libocean.add_terrain(preset="seed_smooth", use_material=False)
    ob = bpy.context.object
    want = positions(ob)
    (modifier,) = node_group.modifiers(ob)
    modifier.node_group[node_group.FAMILY.mark] = 1
    modifier.node_group.name = ".libocean.terrain.v1"
    life.show_now(TERRAIN, ob)
    assert modifier.node_group[node_group.FAMILY.mark] == node_group.VERSION
    assert np.array_equal(positions(ob), want)


# In the background ----------------------------------------------------------------


@pytest.fixture
def carved(tmp_path, waiting, monkeypatch):
    """A land with streams in a window, whole, of which a map takes long, as one of 1024 samples a
    side does."""
    ob = add_land(tmp_path, CARVED)
    monkeypatch.setattr(open_terrain.OpenTerrain, "is_quick", lambda _self: False)
    finish()
    return ob


def test_a_draft_that_takes_long_is_left_out(carved, monkeypatch):
    monkeypatch.setattr(open_terrain, "_SLOW_DRAFT", 0.0)
    carved.libocean_terrain.stream_seed = 3  # makes a draft, by which it is known to be slow
    finish()
    before = positions(carved)
    carved.libocean_terrain.stream_seed = 4
    assert np.array_equal(positions(carved), before)
    job = work_on()
    while job.is_alive():
        assert drafts.line()[0].startswith("Terrain: 64 x 36 samples")
        time.sleep(0.001)
    assert 0.0 < job.share <= 1.0


def test_a_coarse_grid_stands_in_for_a_large_land(carved, monkeypatch):
    monkeypatch.setattr(live, "LARGE", 1000)
    whole = positions(carved)
    carved.libocean_terrain.stream_seed = 3
    grid = positions(carved)
    assert len(grid) == (meshes.DRAFT_SAMPLES + 1) ** 2
    assert np.abs(grid.min(0) - whole.min(0))[:2].max() < 1e-2
    assert np.abs(grid.max(0) - whole.max(0))[:2].max() < 1e-2
    finish()
    assert len(positions(carved)) == len(whole)


def test_a_material_does_not_wait_for_the_land(carved, tmp_path, monkeypatch):
    monkeypatch.setattr(open_terrain.OpenTerrain, "read_state", None)
    ob = add_land(tmp_path, CARVED, use_material=True)
    assert drafts.is_draft(ob.name_full)
    (ground,) = material.grounds(ob)
    assert ground.inputs["Snow Line"].default_value > positions(ob)[:, 2].max()


# Around the camera ----------------------------------------------------------------


@pytest.fixture
def detailed(tmp_path, eye):
    land = add_land(tmp_path, PLACED)
    land.libocean_terrain.lod_spacing = 2.0
    land.libocean_terrain.use_lod = True
    return land


def assert_is_around(ob, place) -> None:
    with library_of(ob) as terrain:
        want = terrain.mesh(place, spacing=2.0, farthest=20000.0)
    assert np.array_equal(positions(ob), want.positions.astype(np.float32))
    assert len(ob.data.polygons) == len(want.corners)


def test_the_mesh_is_the_librarys_around_the_camera(detailed):
    assert detailed.libocean_terrain.problem == ""
    assert_is_around(detailed, (512.0, 1024.0, 64.0))
    heights = attribute(detailed, node_group.HEIGHT)
    assert np.array_equal(heights, positions(detailed)[:, 2])
    assert attribute(detailed, "slope").max() > 0.1
    detailed.libocean_terrain.use_lod = False
    assert_is_land(detailed)


def test_a_small_move_of_the_camera_makes_no_new_mesh(detailed, eye):
    made = meshes.made_of(detailed.data)
    eye.location.x += 20.0
    bpy.context.view_layer.update()
    assert meshes.made_of(detailed.data) == made
    eye.location.x += 20.0
    bpy.context.view_layer.update()
    assert meshes.made_of(detailed.data) != made
    assert_is_around(detailed, (576.0, 1024.0, 64.0))


def test_the_mesh_lies_by_the_object(detailed, eye):
    detailed.location = (512.0, 0.0, 0.0)
    bpy.context.view_layer.update()
    assert_is_around(detailed, (0.0, 1024.0, 64.0))


def test_a_frame_of_an_animated_camera_has_its_own_mesh(detailed, eye, scene):
    keyed(eye, location={frame: (x, 1024.0, 64.0) for frame, x in ((1, 0.0), (2, 1024.0))})
    for frame, x in ((2, 1024.0), (1, 0.0)):
        scene.frame_set(frame)
        assert_is_around(detailed, (x, 1024.0, 64.0))


def test_without_a_camera_the_mesh_is_a_plain_one(detailed, scene):
    scene.camera = None
    bpy.context.view_layer.update()
    assert not camera_mesh.is_around_camera(detailed.data)
    assert_is_land(detailed)


def test_in_a_window_the_mesh_follows_in_the_background(
    detailed,
    eye,
    waiting,
    monkeypatch,
):
    threads = []

    def make(*arguments):
        threads.append(threading.current_thread())
        return camera_mesh.make_vertices(*arguments)

    monkeypatch.setattr(open_terrain, "make_vertices", make)
    before = rest(detailed)
    eye.location.x += 128.0
    bpy.context.view_layer.update()
    assert np.array_equal(rest(detailed), before)
    finish()
    assert_is_around(detailed, (640.0, 1024.0, 64.0))
    assert len(threads) == 1 and threads[0] is not threading.main_thread()


def test_another_land_makes_another_mesh(detailed):
    detailed.libocean_terrain.seed = 9
    assert_is_around(detailed, (512.0, 1024.0, 64.0))


def test_the_mesh_is_saved_with_its_file(detailed, tmp_path):
    want = positions(detailed)
    assert np.array_equal(positions(reopened(tmp_path / "land.blend", "Terrain")), want)
