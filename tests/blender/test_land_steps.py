# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A land that exists once after each step and in each file, while its whole is made in the
background, and as a mesh around the camera."""

import threading
import time

import bpy
import numpy as np
import pytest
from conftest import attribute, pixels, positions, rest, shine
from libocean_addon import handlers
from libocean_addon.shared import drafts, life, meshes
from libocean_addon.terrain import camera_mesh, live, material, node_group, open_terrain
from libocean_addon.terrain.subject import TERRAIN
from test_land import CARVED, PLACED, add_land, assert_is_land, library_of
from test_terrain_drafts import rest as finish
from test_terrain_drafts import waiting  # noqa: F401, a fixture


@pytest.fixture
def land(tmp_path):
    return add_land(tmp_path, PLACED)


def set_region(ob) -> None:
    settings = ob.libocean_terrain
    settings.region_cell, settings.region = 2.0, (0.0, 600.0, 100.0, 700.0)
    settings.use_region = True


# Steps ----------------------------------------------------------------------------


STEPS = {
    "gullies": lambda ob: setattr(ob.libocean_terrain, "use_gullies", True),
    "region": set_region,
    "origin": lambda ob: setattr(ob.libocean_terrain, "origin", (10.0, 20.0)),
    "tile": lambda ob: setattr(ob.libocean_terrain, "kind", "tile"),
    "detail": lambda ob: setattr(ob.libocean_terrain, "use_lod", True),
    "file": lambda _: bpy.ops.libocean.load_terrain_preset(preset="seed_smooth"),
}


@pytest.mark.parametrize("step", STEPS)
def test_each_step_is_undone_and_redone(land, step, eye):
    name = land.name
    bpy.ops.ed.undo_push(message="Before")
    before = positions(land)
    STEPS[step](land)
    bpy.ops.ed.undo_push(message="After")
    after = positions(land)
    assert before.shape != after.shape or not np.array_equal(before, after) or step == "gullies"
    bpy.ops.ed.undo()
    assert np.array_equal(positions(bpy.data.objects[name]), before)
    bpy.ops.ed.redo()
    assert np.array_equal(positions(bpy.data.objects[name]), after)


def test_a_copy_has_a_land_of_its_own(land):
    bpy.ops.object.duplicate(linked=True)
    copy = bpy.context.object
    before = positions(land)
    assert np.array_equal(positions(copy), before)
    set_region(copy)
    copy.libocean_terrain.use_gullies = True
    bpy.context.view_layer.update()
    assert np.array_equal(positions(land), before)
    assert "wear" in copy.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.attributes
    assert_is_land(land)


def test_keyframes_move_the_land(land, scene):
    settings = land.libocean_terrain
    for frame, height in ((1, 30.0), (11, 90.0)):
        settings.island = height
        land.keyframe_insert("libocean_terrain.island", frame=frame)
    for frame in (11, 1):
        scene.frame_set(frame)
        assert settings.island == pytest.approx(30.0 if frame == 1 else 90.0)
        assert_is_land(land)


# Files ----------------------------------------------------------------------------


@pytest.fixture
def saved(land, tmp_path):
    land.libocean_terrain.use_gullies = True
    want = positions(land), attribute(land, "wear")
    path = tmp_path / "land.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    return path, want


def test_a_file_is_opened_as_it_was_saved(saved):
    path, (places, wear) = saved
    bpy.ops.wm.open_mainfile(filepath=str(path))
    ob = bpy.data.objects["Terrain"]
    assert np.array_equal(positions(ob), places)
    assert np.array_equal(attribute(ob, "wear"), wear)


def linked(path):
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    with bpy.data.libraries.load(str(path), link=True) as (_, into):
        into.objects = ["Terrain"]
    return into.objects[0]


def test_a_linked_land_is_that_of_its_file(saved):
    path, (places, wear) = saved
    ob = linked(path)
    bpy.context.collection.objects.link(ob)
    bpy.context.view_layer.update()
    assert np.array_equal(positions(ob), places)
    assert np.array_equal(attribute(ob, "wear"), wear)


def test_an_override_has_a_land_of_its_own_and_keeps_it(saved, tmp_path):
    path, (places, _wear) = saved
    ob = linked(path).override_create(remap_local_usages=True)
    bpy.context.collection.objects.link(ob)
    bpy.context.view_layer.update()
    assert np.array_equal(positions(ob), places)
    ob.libocean_terrain.gullies_depth = 0.1
    changed = positions(ob)
    assert not np.array_equal(changed, places)
    shot = tmp_path / "shot.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(shot))
    bpy.ops.wm.open_mainfile(filepath=str(shot))
    assert np.array_equal(positions(bpy.data.objects["Terrain"]), changed)


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
def carved(tmp_path, waiting, monkeypatch):  # noqa: F811
    """A land with streams in a window, whole, of which a map takes long, as one of 1024 samples a
    side does."""
    ob = add_land(tmp_path, CARVED)
    monkeypatch.setattr(open_terrain.OpenTerrain, "is_quick", lambda _self: False)
    finish()
    return ob


def work_on(ob):
    """Waits until the whole of an object is in the making; returns the job."""
    while drafts.at_work() is None:
        time.sleep(drafts.step())
    return drafts.at_work()[1]


def test_the_land_stays_while_a_new_one_takes_long(carved, monkeypatch):
    monkeypatch.setattr(open_terrain, "_SLOW_DRAFT", 0.0)
    carved.libocean_terrain.stream_seed = 3  # makes a draft, by which it is known to be slow
    finish()
    before = positions(carved)
    assert_is_land(carved)
    carved.libocean_terrain.stream_seed = 4
    assert np.array_equal(positions(carved), before)
    job = work_on(carved)
    while job.is_alive():
        assert drafts.line()[0].startswith("Terrain: 64 x 36 samples")
        time.sleep(0.001)
    assert 0.0 < job.share <= 1.0
    finish()
    assert not np.array_equal(positions(carved), before)
    assert_is_land(carved)


def test_work_that_is_stopped_leaves_the_land(carved, monkeypatch):
    monkeypatch.setattr(open_terrain, "_SLOW_DRAFT", 0.0)
    carved.libocean_terrain.stream_seed = 3
    finish()
    before = positions(carved)
    carved.libocean_terrain.stream_seed = 4
    job = work_on(carved)
    assert bpy.ops.libocean.stop_draft(name=carved.name_full) == {"FINISHED"}
    job.join()
    drafts.step()
    assert drafts.is_stopped(carved.name_full)
    assert np.array_equal(positions(carved), before)
    handlers.complete()  # a render has the whole
    assert_is_land(carved)


def test_a_file_that_is_saved_meanwhile_opens_whole(carved, tmp_path):
    carved.libocean_terrain.stream_seed = 4
    work_on(carved)
    path = tmp_path / "land.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    finish()
    want = positions(carved)
    bpy.ops.wm.open_mainfile(filepath=str(path))
    finish()
    assert np.array_equal(positions(bpy.data.objects["Terrain"]), want)


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
def eye(scene):
    """The scene's camera, low over the land."""
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.location = (512.0, 1024.0, 64.0)
    camera.data.clip_end = 1e5
    scene.collection.objects.link(camera)
    scene.camera = camera
    bpy.context.view_layer.update()
    return camera


@pytest.fixture
def detailed(land, eye):
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
    for frame, x in ((1, 0.0), (2, 1024.0)):
        eye.location.x = x
        eye.keyframe_insert("location", frame=frame)
    for frame, x in ((2, 1024.0), (1, 0.0)):
        scene.frame_set(frame)
        assert_is_around(detailed, (x, 1024.0, 64.0))


def test_frames_of_a_render_have_their_own_meshes(detailed, eye, scene, tmp_path):
    for frame, x in ((1, 0.0), (2, 1024.0)):
        eye.location.x = x
        eye.keyframe_insert("location", frame=frame)
    eye.data.type, eye.data.ortho_scale = "ORTHO", 500.0
    eye.location.z = 64.0
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising = 1, False
    scene.render.resolution_x = scene.render.resolution_y = 48
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    made = bpy.data.materials.new("Places")
    made.use_nodes = True
    shine(detailed, made, made.node_tree.nodes.new("ShaderNodeNewGeometry").outputs["Position"])
    scene.frame_start, scene.frame_end = 1, 2
    scene.render.filepath = str(tmp_path / "live_")
    bpy.ops.render.render(animation=True)
    for frame in (1, 2):
        scene.frame_set(frame)
        live_frame = pixels(tmp_path / f"live_{frame:04d}.exr")
        still = detailed.copy()
        still.data = bpy.data.meshes.new_from_object(
            detailed.evaluated_get(bpy.context.evaluated_depsgraph_get())
        )
        still.modifiers.clear()
        scene.collection.objects.link(still)
        detailed.hide_render = True
        scene.render.filepath = str(tmp_path / "still.exr")
        bpy.ops.render.render(write_still=True)
        frozen = pixels(tmp_path / "still.exr")
        assert np.array_equal(live_frame, frozen) and np.ptp(frozen[..., 2]) > 1.0
        bpy.data.objects.remove(still)
        detailed.hide_render = False


def test_without_a_camera_the_mesh_is_a_plain_one(detailed, scene):
    scene.camera = None
    bpy.context.view_layer.update()
    assert not camera_mesh.is_around_camera(detailed.data)
    assert_is_land(detailed)


def test_in_a_window_the_mesh_follows_in_the_background(
    detailed,
    eye,
    waiting,  # noqa: F811
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
    path = tmp_path / "land.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    bpy.ops.wm.open_mainfile(filepath=str(path))
    assert np.array_equal(positions(bpy.data.objects["Terrain"]), want)
