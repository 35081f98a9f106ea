# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A terrain after each step and in each file: undo, copies, keyframes, linked data, overrides."""

import bpy
import numpy as np
import pytest
from conftest import positions, rest
from test_terrain import add_terrain, assert_is_land


@pytest.fixture
def terrain():
    return add_terrain()


# Steps ----------------------------------------------------------------------------


STEPS = {
    "parameter": lambda ob: setattr(ob.libocean_terrain, "beta", 1.7),
    "resolution": lambda ob: setattr(ob.libocean_terrain, "resolution", 128),
    "size": lambda ob: setattr(ob.libocean_terrain, "patch_size", 300.0),
    "tiles": lambda ob: setattr(ob.libocean_terrain, "tiles", 2),
    "preset": lambda _: bpy.ops.libocean.load_terrain_preset(preset="jacksboro"),
    "break": lambda _: bpy.ops.libocean.add_break(),
    "layer": lambda _: bpy.ops.libocean.add_terrain_layer(),
}


@pytest.mark.parametrize("step", STEPS)
def test_each_step_is_undone_and_redone(terrain, step):
    name = terrain.name
    bpy.ops.ed.undo_push(message="Before")
    before = positions(terrain)
    STEPS[step](terrain)
    bpy.ops.ed.undo_push(message="After")
    after = positions(terrain)
    bpy.ops.ed.undo()
    ob = bpy.data.objects[name]
    assert np.array_equal(positions(ob), before)
    bpy.ops.ed.redo()
    ob = bpy.data.objects[name]
    assert np.array_equal(positions(ob), after)
    assert not np.array_equal(before, after)


def test_adding_and_deleting_are_undone_and_redone():
    bpy.ops.ed.undo_push(message="Nothing")
    ob = add_terrain()
    want = positions(ob)
    bpy.ops.ed.undo_push(message="Added")
    bpy.ops.object.delete()
    bpy.ops.ed.undo_push(message="Deleted")
    bpy.ops.ed.undo()
    assert np.array_equal(positions(bpy.data.objects["Terrain"]), want)
    bpy.ops.ed.undo()
    assert "Terrain" not in bpy.data.objects
    bpy.ops.ed.redo()
    assert np.array_equal(positions(bpy.data.objects["Terrain"]), want)
    bpy.ops.ed.redo()
    assert "Terrain" not in bpy.data.objects


@pytest.mark.parametrize("linked", [True, False], ids=["Alt-D", "Shift-D"])
def test_a_copy_has_a_land_of_its_own(terrain, linked):
    bpy.ops.object.duplicate(linked=linked)
    copy = bpy.context.object
    assert copy is not terrain
    before = positions(terrain)
    assert np.array_equal(positions(copy), before)
    copy.libocean_terrain.seed = 5
    bpy.context.view_layer.update()
    assert np.array_equal(positions(terrain), before)
    assert_is_land(copy)
    copy.libocean_terrain.patch_size = 128.0
    bpy.context.view_layer.update()
    assert np.array_equal(positions(terrain), before)
    assert_is_land(copy)


def test_keyframes_and_drivers_move_the_land(terrain, scene):
    settings = terrain.libocean_terrain
    for frame, beta in ((1, 1.5), (11, 2.5)):
        settings.beta = beta
        terrain.keyframe_insert("libocean_terrain.beta", frame=frame)
    driver = terrain.driver_add("libocean_terrain.mean").driver
    driver.expression = "frame * 2"
    for frame in (6, 11, 1):
        scene.frame_set(frame)
        assert positions(terrain)[:, 2].mean() == pytest.approx(2.0 * frame, abs=1.0)
        assert_is_land(terrain)


# Files ----------------------------------------------------------------------------


@pytest.fixture
def saved(terrain, tmp_path):
    """Returns a file with a terrain in a collection, and how it looks."""
    bpy.ops.libocean.add_break()
    want = positions(terrain)
    collection = bpy.data.collections.new("Land")
    bpy.context.scene.collection.children.link(collection)
    collection.objects.link(terrain)
    path = tmp_path / "land.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    return path, want


def test_a_file_is_opened_as_it_was_saved(saved):
    path, want = saved
    bpy.ops.wm.open_mainfile(filepath=str(path))
    assert np.array_equal(positions(bpy.data.objects["Terrain"]), want)


@pytest.mark.parametrize("link", [True, False], ids=["linked", "appended"])
def test_a_terrain_of_another_file_shows_its_land(saved, link):
    path, want = saved
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    with bpy.data.libraries.load(str(path), link=link) as (_, into):
        into.objects = ["Terrain"]
    ob = into.objects[0]
    bpy.context.collection.objects.link(ob)
    bpy.context.view_layer.update()
    assert np.array_equal(positions(ob), want)


def test_an_override_has_a_land_of_its_own_and_keeps_it(saved, tmp_path):
    path, want = saved
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    with bpy.data.libraries.load(str(path), link=True) as (_, into):
        into.objects = ["Terrain"]
    ob = into.objects[0].override_create(remap_local_usages=True)
    bpy.context.collection.objects.link(ob)
    bpy.context.view_layer.update()
    assert np.array_equal(positions(ob), want)
    ob.libocean_terrain.seed = 9
    ob.libocean_terrain.use_rms, ob.libocean_terrain.rms = True, 3.0
    changed = positions(ob)
    assert changed[:, 2].std() == pytest.approx(3.0, rel=0.05)
    shot = tmp_path / "shot.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(shot))
    bpy.ops.wm.open_mainfile(filepath=str(shot))
    assert np.array_equal(positions(bpy.data.objects["Terrain"]), changed)


def test_without_the_add_on_a_file_shows_level_ground(saved):
    path, want = saved
    bpy.ops.preferences.addon_disable(module="libocean_addon")
    try:
        bpy.ops.wm.open_mainfile(filepath=str(path))
        ob = bpy.data.objects["Terrain"]
        assert np.abs(positions(ob)[:, 2]).max() == 0.0
        assert np.array_equal(positions(ob)[:, :2], want[:, :2])
    finally:
        bpy.ops.preferences.addon_enable(module="libocean_addon")


def test_applied_it_is_a_mesh_for_good(terrain):
    want = positions(terrain)
    bpy.ops.object.modifier_apply(modifier="Terrain")
    assert np.array_equal(rest(terrain), want)
    assert len(terrain.modifiers) == 0
