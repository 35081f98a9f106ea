# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""While values of a large terrain move a draft with fewer samples is shown; at rest, in a render
and in a saved file the whole land."""

import time

import bpy
import numpy as np
import pytest
from conftest import positions
from libocean_addon import handlers
from libocean_addon.bundled import libocean
from libocean_addon.shared import drafts, life, meshes, modifier_groups
from libocean_addon.terrain import facts, live, node_group, open_terrain, parameter_values

WHOLE = 512


@pytest.fixture
def terrain(monkeypatch):
    """A terrain of which a whole map takes long, as one of 4096 samples a side does."""
    bpy.ops.libocean.add_terrain(preset="seed_smooth", use_material=False)
    ob = bpy.context.object
    ob.libocean_terrain.resolution = WHOLE
    monkeypatch.setattr(open_terrain.OpenTerrain, "is_quick", lambda _self: False)
    return ob


@pytest.fixture
def waiting(monkeypatch):
    """As with a window in which somebody waits; the timer is called by hand."""
    monkeypatch.setattr(drafts, "allowed", True)
    yield
    drafts.close()


def image_side(ob) -> int:
    (modifier,) = node_group.modifiers(ob)
    return modifier_groups.value(modifier, node_group.GROUND).size[0]


def rest() -> None:
    """Calls the timer until it has nothing more to do."""
    while (pause := drafts.step()) is not None:
        time.sleep(pause)


def library_heights(ob, side: int) -> np.ndarray:
    """Returns the library's heights at the vertices of a tile of side x side samples."""
    with libocean.parse_terrain(parameter_values.values_of(ob.libocean_terrain).text()) as terrain:
        heights = terrain.surface().height
    step = len(heights) // side
    index = ((np.arange(side + 1) - side // 2) * step) % len(heights)
    return heights[np.ix_(index, index)].ravel()


def assert_is_whole(ob) -> None:
    assert image_side(ob) == WHOLE
    assert not meshes.is_draft(ob.data)
    side = round(len(ob.data.vertices) ** 0.5) - 1
    want = library_heights(ob, side)
    assert np.abs(positions(ob)[:, 2] - want).max() <= 1e-5 * want.std()


def test_a_moving_value_shows_a_draft_and_then_the_whole_land(terrain, waiting):
    for beta in (2.0, 1.9, 1.8):
        terrain.libocean_terrain.beta = beta
        assert image_side(terrain) < WHOLE
        assert drafts.progress(terrain.name_full) == 0.0
        # Nearly the same land: the rms counts the waves that the draft lacks.
        heights = positions(terrain)[:, 2]
        want = library_heights(terrain, round(len(heights) ** 0.5) - 1)
        assert np.std(heights - want) < 0.1 * want.std()
    rest()
    assert drafts.progress(terrain.name_full) is None
    assert_is_whole(terrain)


def test_the_next_change_stops_the_work_for_the_last(terrain, waiting):
    terrain.libocean_terrain.beta = 1.9
    while drafts.at_work() is None:
        time.sleep(drafts.step())
    job = drafts.at_work()[1]
    terrain.libocean_terrain.beta = 1.7
    assert job.is_cancelled()
    rest()
    assert_is_whole(terrain)


def test_readings_do_not_wait_for_the_whole_land(terrain, waiting, monkeypatch):
    before = facts.state_of(terrain)
    terrain.libocean_terrain.use_rms, terrain.libocean_terrain.rms = True, 3.0
    with monkeypatch.context() as patch:
        patch.setattr(open_terrain.OpenTerrain, "read_state", None)
        assert facts.state_of(terrain) == before
    rest()
    assert ("RMS height", "3 m") in facts.state_of(terrain)


def test_work_is_stopped_and_finished_by_its_buttons(terrain, waiting):
    values = parameter_values.values_of(terrain.libocean_terrain)
    terrain.libocean_terrain.seed = 3
    assert bpy.ops.libocean.stop_draft(name=terrain.name_full) == {"FINISHED"}
    assert drafts.step() == 0.25 and drafts.at_work() is None  # it waits, and does nothing
    assert drafts.is_stopped(terrain.name_full) and image_side(terrain) < WHOLE
    assert bpy.ops.libocean.finish_draft(name=terrain.name_full) == {"FINISHED"}
    rest()
    assert_is_whole(terrain)
    assert parameter_values.values_of(terrain.libocean_terrain) != values


def test_a_job_is_cancelled_between_its_parts(terrain, waiting, monkeypatch):
    terrain.libocean_terrain.seed = 3  # else the job would take the maps that there are
    job = open_terrain.terrain_of(terrain.name_full).job()
    fill, filled = type(job.terrain).fill, []

    def fill_and_cancel(filling, maps) -> None:
        fill(filling, maps)
        filled.append(True)
        job.cancel()

    monkeypatch.setattr(type(job.terrain), "fill", fill_and_cancel)
    job.start()
    job.join()
    assert filled and isinstance(job.failure, drafts.CancelledError)
    assert job.maps is None and job.state is None
    job.close()


def test_a_terrain_that_is_deleted_leaves_no_work(terrain, waiting):
    terrain.libocean_terrain.seed = 3
    while drafts.at_work() is None:
        time.sleep(drafts.step())
    bpy.data.objects.remove(terrain)
    bpy.context.view_layer.update()
    rest()
    assert drafts.at_work() is None and drafts.line() == ("", "")


def test_undo_in_a_draft_brings_the_land_back(terrain, waiting):
    drafts.allowed = False
    terrain.libocean_terrain.seed = 1
    want, name = positions(terrain), terrain.name
    bpy.ops.ed.undo_push(message="Before")
    drafts.allowed = True
    terrain.libocean_terrain.seed = 3
    bpy.ops.ed.undo_push(message="After")
    bpy.ops.ed.undo()
    rest()
    terrain = bpy.data.objects[name]
    assert np.array_equal(positions(terrain), want)
    assert_is_whole(terrain)


def test_a_render_never_holds_a_draft(terrain, waiting, scene):
    terrain.libocean_terrain.beta = 1.8
    assert image_side(terrain) < WHOLE
    handlers.complete()
    assert_is_whole(terrain)
    terrain.libocean_terrain.beta = 1.7
    life.show_all(life.all_shown(), scene, rendering=True, passing=True)
    assert_is_whole(terrain)


def test_a_saved_file_has_the_whole_mesh(terrain, waiting, tmp_path):
    bpy.ops.libocean.add_terrain(preset="earth", mesh_resolution="512", use_material=False)
    ob = bpy.context.object
    assert meshes.is_draft(ob.data)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "land.blend"))
    assert not meshes.is_draft(ob.data) and len(ob.data.vertices) == 513**2


def test_a_small_terrain_is_whole_at_once(waiting):
    bpy.ops.libocean.add_terrain(preset="seed_smooth", use_material=False)
    ob = bpy.context.object
    for beta in (1.9, 1.8):
        open_terrain.terrain_of(ob.name_full)._seconds = 1e-9
        ob.libocean_terrain.beta = beta
        assert image_side(ob) == 256 and drafts.progress(ob.name_full) is None


def test_no_memory_is_said_in_the_panel(terrain, waiting, monkeypatch):
    short = "There is not enough memory: choose fewer samples"
    long = "a map needs 900 MiB of memory, 300 MiB are available; lower terrain.resolution"
    sentences = {
        MemoryError("of arrays"): short,
        libocean.OutOfMemoryError("out of memory", 7): short,
        libocean.OutOfMemoryError(long, 7): long.replace("terrain.resolution", "Resolution"),
    }
    for failure, sentence in sentences.items():

        def fail(_job, failure=failure):
            raise failure

        monkeypatch.setattr(open_terrain.TerrainJob, "work", fail)
        terrain.libocean_terrain.seed += 1
        rest()
        assert terrain.libocean_terrain.problem == sentence
    monkeypatch.undo()


def test_a_failure_in_the_background_has_the_words_of_the_panel(terrain, waiting, monkeypatch):
    def fail(_job):
        raise libocean.Error("lower terrain.resolution", 0)

    monkeypatch.setattr(open_terrain.TerrainJob, "work", fail)
    terrain.libocean_terrain.seed = 8
    rest()
    assert terrain.libocean_terrain.problem == "lower Resolution"
    bpy.context.view_layer.update()  # does not begin the work anew
    assert terrain.libocean_terrain.problem == "lower Resolution"
    assert not drafts.is_draft(terrain.name_full)
    monkeypatch.undo()
    terrain.libocean_terrain.seed = 9
    assert terrain.libocean_terrain.problem == ""


def test_a_coarse_grid_stands_in_for_a_large_mesh_while_values_move(
    terrain, waiting, monkeypatch, scene
):
    """The library is quick here: Blender takes its time with the vertices."""
    rest()
    monkeypatch.setattr(open_terrain.OpenTerrain, "is_quick", lambda _self: True)
    monkeypatch.setattr(live, "LARGE", 100000)
    settings = terrain.libocean_terrain
    whole = len(terrain.data.vertices)
    assert whole == 513**2
    for tiles in (1, 2):
        settings.tiles = tiles
        rest()
        settings.rms = 5.0 + tiles
        heights = positions(terrain)
        assert len(heights) < whole / 3  # the mesh itself is as it was
        assert np.ptp(heights[:, 0]) == pytest.approx(tiles * settings.patch_size)
        assert heights[:, 2].std() == pytest.approx(settings.rms, rel=0.05)
        rest()
        assert len(positions(terrain)) == (512 * tiles + 1) ** 2
    settings.rms = 9.0
    handlers.complete()
    assert len(positions(terrain)) == (512 * 2 + 1) ** 2
    assert positions(terrain)[:, 2].std() == pytest.approx(9.0, rel=0.05)
