# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""While values of a large terrain move a draft with fewer samples is shown; at rest, in a render
and in a saved file the whole land."""

import bpy
import numpy as np
import pytest
from conftest import finish, positions, save
from libocean_addon import handlers
from libocean_addon.shared import drafts, meshes, modifier_groups
from libocean_addon.terrain import facts, live, node_group, open_terrain

WHOLE = 512


@pytest.fixture
def terrain(monkeypatch):
    """A terrain of which a whole map takes long, as one of 4096 samples a side does."""
    bpy.ops.libocean.add_terrain(preset="seed_smooth", use_material=False)
    ob = bpy.context.object
    ob.libocean_terrain.resolution = WHOLE
    monkeypatch.setattr(open_terrain.OpenTerrain, "is_quick", lambda _self: False)
    return ob


def image_side(ob) -> int:
    (modifier,) = node_group.modifiers(ob)
    return modifier_groups.value(modifier, node_group.GROUND).size[0]


def test_readings_do_not_wait_for_the_whole_land(terrain, waiting, monkeypatch):
    before = facts.state_of(terrain)
    terrain.libocean_terrain.use_rms, terrain.libocean_terrain.rms = True, 3.0
    with monkeypatch.context() as patch:
        patch.setattr(open_terrain.OpenTerrain, "read_state", None)
        assert facts.state_of(terrain) == before
    finish()
    assert ("RMS height", "3 m") in facts.state_of(terrain)


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


def test_a_saved_file_has_the_whole_mesh(waiting, tmp_path, monkeypatch):
    monkeypatch.setattr(meshes, "DRAFT_SAMPLES", 64)
    bpy.ops.libocean.add_terrain(preset="earth", mesh_resolution="128", use_material=False)
    ob = bpy.context.object
    assert meshes.is_draft(ob.data)
    save(tmp_path / "land.blend")
    assert not meshes.is_draft(ob.data) and len(ob.data.vertices) == 129**2


def test_a_small_terrain_is_whole_at_once(waiting):
    bpy.ops.libocean.add_terrain(preset="seed_smooth", use_material=False)
    ob = bpy.context.object
    for beta in (1.9, 1.8):
        open_terrain.terrain_of(ob.name_full)._seconds = 1e-9
        ob.libocean_terrain.beta = beta
        assert image_side(ob) == 256 and drafts.progress(ob.name_full) is None


def test_a_coarse_grid_stands_in_for_a_large_mesh_while_values_move(
    terrain, waiting, monkeypatch, scene
):
    """The library is quick here: Blender takes its time with the vertices."""
    terrain.libocean_terrain.mesh_resolution = 128
    finish()
    monkeypatch.setattr(open_terrain.OpenTerrain, "is_quick", lambda _self: True)
    monkeypatch.setattr(live, "LARGE", 10000)
    monkeypatch.setattr(meshes, "DRAFT_SAMPLES", 64)
    settings = terrain.libocean_terrain
    whole = len(terrain.data.vertices)
    assert whole == 129**2
    for tiles in (1, 2):
        settings.tiles = tiles
        finish()
        settings.rms = 5.0 + tiles
        heights = positions(terrain)
        assert len(heights) < whole / 3  # the mesh itself is as it was
        assert np.ptp(heights[:, 0]) == pytest.approx(tiles * settings.patch_size)
        assert heights[:, 2].std() == pytest.approx(settings.rms, rel=0.05)
        finish()
        assert len(positions(terrain)) == (128 * tiles + 1) ** 2
    settings.rms = 9.0
    handlers.complete()
    assert len(positions(terrain)) == (128 * 2 + 1) ** 2
    assert positions(terrain)[:, 2].std() == pytest.approx(9.0, rel=0.05)
