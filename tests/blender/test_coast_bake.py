# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bake of a coast where it is stopped, killed or refused, and of other regions. What every bake
has is in test_bake_life.py."""

import shutil

import bpy
import numpy as np
import other_blender
import pytest
from conftest import failing, keyed, pixels, save, start_another_blender, times
from libocean_addon.bake import bake_record, exr_files, render_check
from libocean_addon.bundled import libocean
from libocean_addon.coast import coast_bake
from libocean_addon.look import material as water_material
from subjects import Coast, same
from test_detail import nodes_of, shown_by


@pytest.fixture
def shot(coast, scene, tmp_path):
    """A coast in a saved file, with all that a bake has."""
    Coast().prepare_bake(coast)
    scene.frame_start, scene.frame_end = 1, 4
    save(tmp_path / "shot.blend")
    return bpy.data.objects["Water"]


def seen(ob) -> dict[str, np.ndarray]:
    bpy.context.scene.frame_set(2)
    return Coast().shown(ob)


def test_the_library_ends_its_work_when_a_bake_is_stopped(shot, tmp_path, monkeypatch):
    jobs, watch = [], coast_bake.RegionJob._watch

    def stopping(job, done, total):
        jobs.append(job)
        job.stop.set()
        watch(job, done, total)

    monkeypatch.setattr(coast_bake.RegionJob, "_watch", stopping)
    assert bpy.ops.libocean.bake() == {"CANCELLED"}
    assert len(jobs) == 1 and jobs[0].failure is None and jobs[0].done == 0
    assert not shot.libocean.use_bake and not list((tmp_path / "ocean_bake").rglob(".*"))


def test_what_the_library_refuses_meanwhile_is_said(shot, monkeypatch):
    def refuse(_job, _sea, _resolved, frame):
        if frame.number == 2:
            raise libocean.Error("water.level = 9e9: is out of range", 0)
        return True

    monkeypatch.setattr(coast_bake.RegionJob, "_bake", refuse)
    said = failing(bpy.ops.libocean.bake)
    assert "After 2 frames: " in said and "is out of range" in said
    assert not shot.libocean.use_bake


def test_a_bake_that_is_killed_goes_on(shot, tmp_path):
    done = start_another_blender(other_blender.bake_until_killed, tmp_path / "shot.blend")
    done.communicate()
    assert done.returncode == -9
    folder = tmp_path / "ocean_bake" / "Water"
    before = {name: at for name, at in times(folder).items() if name.startswith("shot.")}
    assert 9 < len(before) < 6 * 9
    live = seen(shot)
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    after = times(folder)
    assert {name: after[name] for name in before} == before
    assert same(seen(shot), live)


def test_another_region_is_baked_anew(shot):
    bpy.ops.libocean.bake()
    shot.libocean.use_bake = False
    shot.libocean_coast.region = (50.0, 40.0, 90.0, 100.0)
    shot.libocean_coast.use_region = True
    live = seen(shot)
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    assert same(seen(shot), live)


def test_a_bake_has_the_near_detail_of_the_live_coast(shot, scene):
    shot.data.materials.append(water_material.make("jerlov_ii"))
    shot.libocean.use_detail = True
    scene.frame_start = scene.frame_end = 2
    scene.frame_set(2)
    live = shown_by(shot)
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    place = bake_record.place_of(shot)
    for field, slope in zip(exr_files.DETAIL, live, strict=False):
        assert np.array_equal(pixels(place.file(field, 2))[..., :2], slope)
    tree = nodes_of(shot)[0].node_tree
    assert {node.image.source for node in tree.nodes if node.type == "TEX_IMAGE"} == {"SEQUENCE"}
    assert "depth" in {node.attribute_name for node in tree.nodes if node.type == "ATTRIBUTE"}
    assert render_check.find(scene, [2]).errors == []


def test_an_animated_region_is_refused(shot):
    keyed(shot.libocean_coast, cell={1: 4.0, 4: 8.0})
    assert "region are animated" in failing(bpy.ops.libocean.bake)


def test_a_render_without_its_files_is_refused(shot, scene):
    bpy.ops.libocean.bake()
    assert render_check.find(scene, [2]).errors == []
    place = bake_record.place_of(shot)
    lost, other = (exr_files.path(place.path, place.stem, "depth", frame) for frame in (2, 3))
    lost.unlink()
    (text,) = render_check.find(scene, [2]).errors
    assert "Water: files of the bake are missing, of the frames 2" in text
    shutil.copy(other, lost)
    (text,) = render_check.find(scene, [2]).errors
    assert "show another sea" in text
