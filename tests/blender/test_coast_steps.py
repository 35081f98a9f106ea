# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A coast after each step and in each file, in renders, and while its whole is made in the
background."""

import threading
import time

import bpy
import numpy as np
import pytest
from conftest import pixels, positions, shine
from libocean_addon import handlers
from libocean_addon.coast import coast_job, node_group, open_coast
from libocean_addon.shared import drafts, modifier_groups
from test_coast import (  # noqa: F401, with fixtures
    COLUMNS,
    ROWS,
    add_coast,
    assert_is_sea,
    bed,
    coast,
    sea_file,
)
from test_terrain_drafts import rest as finish
from test_terrain_drafts import waiting  # noqa: F401, a fixture


def assert_is_bed(ob, level: float = 0.0) -> None:
    land = bpy.data.objects[ob.libocean_coast.land.name]
    heights = positions(land)[:, 2].reshape(ROWS, COLUMNS)
    assert np.abs(heights - bed() + level).max() <= 1e-5


# Steps ----------------------------------------------------------------------------


def test_adding_is_undone_and_redone(sea_file):  # noqa: F811
    bpy.ops.ed.undo_push(message="Before")
    add_coast(sea_file)
    bpy.ops.ed.undo_push(message="After")
    want = positions(bpy.context.object)
    bpy.ops.ed.undo()
    assert not bpy.data.objects
    bpy.ops.ed.redo()
    ob = bpy.data.objects["Water"]
    assert np.array_equal(positions(ob), want)
    assert_is_sea(ob)
    assert_is_bed(ob)


STEPS = {
    "wind": lambda ob: setattr(ob.libocean.waves[0], "wind_speed", 6.0),
    "level": lambda ob: setattr(ob.libocean, "level", 0.5),
    "cell": lambda ob: setattr(ob.libocean_coast, "cell", 8.0),
    "clip": lambda ob: setattr(ob.libocean_coast, "use_clip", False),
}


@pytest.mark.parametrize("step", STEPS)
def test_each_step_is_undone_and_redone(coast, step):  # noqa: F811
    name = coast.name

    def seen():
        ob = bpy.data.objects[name]
        return positions(ob), positions(ob.libocean_coast.land)

    bpy.ops.ed.undo_push(message="Before")
    before = seen()
    STEPS[step](coast)
    bpy.ops.ed.undo_push(message="After")
    after = seen()
    assert before[0].shape != after[0].shape or not np.array_equal(before[0], after[0])
    bpy.ops.ed.undo()
    for want, got in zip(before, seen(), strict=True):
        assert np.array_equal(want, got)
    bpy.ops.ed.redo()
    for want, got in zip(after, seen(), strict=True):
        assert np.array_equal(want, got)


def test_a_copy_has_a_sea_of_its_own(coast):  # noqa: F811
    before = positions(coast)
    bpy.ops.object.duplicate()
    copy = bpy.context.object
    assert np.array_equal(positions(copy), before)
    copy.libocean.waves[0].wind_speed = 6.0
    bpy.context.view_layer.update()
    assert np.array_equal(positions(coast), before)
    assert not np.array_equal(positions(copy), before)


def test_a_land_that_is_deleted_stays_away(coast):  # noqa: F811
    land = coast.libocean_coast.land
    with bpy.context.temp_override(selected_objects=[land]):
        bpy.ops.object.delete()
    before = bpy.data.meshes["Land"]["libocean_mesh"]
    coast.libocean.level = 0.5
    assert coast.libocean_coast.problem == "" and len(bpy.context.scene.objects) == 1
    assert bpy.data.meshes["Land"]["libocean_mesh"] == before
    assert_is_sea(coast)


def test_a_modifier_that_was_removed_comes_back(coast):  # noqa: F811
    coast.modifiers.clear()
    bpy.context.view_layer.objects.active = coast
    assert bpy.ops.libocean.add_modifier() == {"FINISHED"}
    assert coast.libocean_coast.problem == ""
    assert_is_sea(coast)
    assert_is_bed(coast)


def test_a_mesh_of_the_user_is_never_replaced_by_a_coast(coast):  # noqa: F811
    coast.modifiers.clear()
    coast.data = bpy.data.meshes.new("Own")
    coast.data.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], [(0, 1, 2)])
    with pytest.raises(RuntimeError, match="add a coast instead"):
        bpy.ops.libocean.add_modifier()
    assert not coast.modifiers and len(coast.data.vertices) == 3


# Files and renders ----------------------------------------------------------------


def test_a_file_is_opened_as_it_was_saved_without_the_bed(coast, scene, tmp_path):  # noqa: F811
    scene.frame_set(5)
    want, path = positions(coast), tmp_path / "coast.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    (tmp_path / "bed.asc").unlink()
    bpy.ops.wm.open_mainfile(filepath=str(path))
    ob = bpy.data.objects["Water"]
    assert ob.libocean_coast.problem == ""
    assert np.array_equal(positions(ob), want)
    assert_is_sea(ob)
    assert_is_bed(ob)


def test_a_coast_is_saved_as_a_sea_file(coast, tmp_path):  # noqa: F811
    path = tmp_path / "elsewhere" / "saved.toml"
    path.parent.mkdir()
    coast.libocean.level = 0.25
    assert bpy.ops.libocean.save_coast(filepath=str(path)) == {"FINISHED"}
    again = add_coast(path)
    assert np.array_equal(positions(again), positions(coast))


def test_frames_of_a_render_have_their_own_water(coast, scene, tmp_path):  # noqa: F811
    coast.libocean_coast.land.hide_render = True
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    scene.collection.objects.link(camera)
    camera.location = (60.0, 80.0, 50.0)
    camera.data.type, camera.data.ortho_scale = "ORTHO", 60.0
    scene.camera = camera
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising = 1, False
    scene.render.resolution_x = scene.render.resolution_y = 48
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    made = bpy.data.materials.new("Places")
    made.use_nodes = True
    shine(coast, made, made.node_tree.nodes.new("ShaderNodeNewGeometry").outputs["Position"])
    scene.frame_start, scene.frame_end = 1, 2
    scene.render.filepath = str(tmp_path / "live_")
    bpy.ops.render.render(animation=True)
    seen = []
    for frame in (1, 2):
        scene.frame_set(frame)
        still = coast.copy()
        still.data = bpy.data.meshes.new_from_object(
            coast.evaluated_get(bpy.context.evaluated_depsgraph_get())
        )
        still.modifiers.clear()
        scene.collection.objects.link(still)
        coast.hide_render = True
        scene.render.filepath = str(tmp_path / "still.exr")
        bpy.ops.render.render(write_still=True)
        seen.append(pixels(tmp_path / f"live_{frame:04d}.exr"))
        assert np.array_equal(seen[-1], pixels(tmp_path / "still.exr"))
        bpy.data.objects.remove(still)
        coast.hide_render = False
    assert np.abs(seen[0] - seen[1])[..., 2].max() > 0.01


# In the background ----------------------------------------------------------------


@pytest.fixture
def slow(monkeypatch):
    """As where maps take long."""
    ready = open_coast.OpenCoast.is_ready

    def is_ready(self, view) -> bool:
        return self._filled == self.key(view) and ready(self, view)

    monkeypatch.setattr(open_coast.OpenCoast, "is_ready", is_ready)


def work_on():
    """Waits until the whole of a coast is in the making; returns the job."""
    while drafts.at_work() is None:
        time.sleep(drafts.step())
    return drafts.at_work()[1]


def test_a_new_coast_is_water_at_rest_until_its_whole_is_made(
    sea_file,  # noqa: F811
    waiting,  # noqa: F811
    monkeypatch,
):
    threads = []

    def fill(*arguments, **settings):
        threads.append(threading.current_thread())
        return fill_maps(*arguments, **settings)

    fill_maps = coast_job.fill_maps
    monkeypatch.setattr(coast_job, "fill_maps", fill)
    ob = add_coast(sea_file)
    assert drafts.is_draft(ob.name_full)
    assert len(ob.data.vertices) == COLUMNS * ROWS
    assert len(positions(ob)) == COLUMNS * ROWS and np.abs(positions(ob)[:, 2]).max() == 0.0
    work_on()
    assert "waves over the bed" in drafts.line()[0] or "foam" in drafts.line()[0]
    finish()
    assert threads and threading.main_thread() not in threads
    assert drafts.progress(ob.name_full) is None
    assert_is_bed(ob)
    drafts.allowed = False
    assert_is_sea(ob)


def test_the_water_stays_while_a_new_wind_takes_long(coast, waiting, slow):  # noqa: F811
    before = positions(coast)
    for wind in (6.0, 6.5, 7.0):
        coast.libocean.waves[0].wind_speed = wind
        assert np.array_equal(positions(coast), before)
    job = work_on()
    coast.libocean.waves[0].wind_speed = 7.5
    assert job.is_cancelled()
    finish()
    assert not np.array_equal(positions(coast), before)
    drafts.allowed = False
    assert_is_sea(coast)


def test_a_frame_of_a_known_sea_is_a_coarser_draft_first(coast, waiting, slow):  # noqa: F811
    opened = open_coast.coast_of(coast.name_full)
    opened.pace.size = 16
    coast.libocean_coast.use_clip = False
    finish()
    coast.libocean.use_custom_time, coast.libocean.custom_time = True, 3.0
    (modifier,) = node_group.modifiers(coast)
    image = modifier_groups.value(modifier, node_group.DISPLACEMENT)
    assert max(image.size) <= 16 + 1
    draft = positions(coast)
    finish()
    whole = positions(coast)
    assert 0.0 < np.abs(draft - whole).max() < 4.0
    drafts.allowed = coast.libocean.use_custom_time = False
    assert_is_sea(coast)


def test_a_frame_that_is_set_meanwhile_is_whole(coast, scene, waiting, slow):  # noqa: F811
    coast.libocean.waves[0].wind_speed = 6.0
    work_on()
    scene.frame_set(4)
    assert not drafts.is_draft(coast.name_full) or drafts.at_work()[1].is_cancelled()
    drafts.allowed = False
    assert_is_sea(coast)


def test_work_that_is_stopped_leaves_the_water(coast, waiting, slow):  # noqa: F811
    before = positions(coast)
    coast.libocean.waves[0].wind_speed = 6.0
    job = work_on()
    assert bpy.ops.libocean.stop_draft(name=coast.name_full) == {"FINISHED"}
    job.join()
    drafts.step()
    assert drafts.is_stopped(coast.name_full)
    assert np.array_equal(positions(coast), before)
    handlers.complete()  # a render has the whole
    drafts.allowed = False
    assert_is_sea(coast)


def test_a_failure_in_the_background_is_a_sentence(coast, waiting, slow):  # noqa: F811
    before = positions(coast)
    coast.libocean.waves[0].wind_speed = 0.0
    finish()
    assert "no waves" in coast.libocean_coast.problem
    assert np.array_equal(positions(coast), before)
    bpy.context.view_layer.update()
    coast.libocean_coast.clip_depth = 0.4  # does not begin the work anew
    assert "no waves" in coast.libocean_coast.problem
    assert not drafts.is_draft(coast.name_full)
    coast.libocean.waves[0].wind_speed = 8.0
    finish()
    assert coast.libocean_coast.problem == ""
    drafts.allowed = False
    assert_is_sea(coast)


def test_a_file_that_is_saved_meanwhile_opens_whole(coast, waiting, slow, tmp_path):  # noqa: F811
    coast.libocean.waves[0].wind_speed = 6.0
    work_on()
    path = tmp_path / "coast.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    finish()
    want = positions(coast)
    bpy.ops.wm.open_mainfile(filepath=str(path))
    finish()
    assert np.array_equal(positions(bpy.data.objects["Water"]), want)


def test_a_coast_that_is_deleted_meanwhile_ends_its_work(coast, waiting, slow):  # noqa: F811
    coast.libocean.waves[0].wind_speed = 6.0
    job = work_on()
    bpy.data.objects.remove(coast)
    bpy.context.view_layer.update()
    assert job.is_cancelled()
    finish()
    assert drafts.at_work() is None
