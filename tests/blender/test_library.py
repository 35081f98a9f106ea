# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Seas of other files: linked objects, instances of collections, library overrides."""

import shutil

import bpy
import numpy as np
import pytest
from conftest import (
    add_horizon,
    add_ocean,
    assert_shown_without_the_add_on,
    camera,
    empty,
    factory_settings,
    picture_settings,
    positions,
    reopened,
    save,
    times,
)
from libocean_addon.bake import bake_record, bake_state
from libocean_addon.sea import parameter_values
from libocean_addon.shared import mesh_content


@pytest.fixture
def asset(tmp_path, monkeypatch):
    """A file with a small sea in a collection, whose mesh it holds smaller; its path and how the
    sea looks at frame 10."""
    monkeypatch.setattr(mesh_content, "_SIDE", 10)
    ob = add_ocean(64, kind="PATCH", preset="beaufort_6")
    bpy.context.scene.frame_set(10)
    want = positions(ob)
    collection = bpy.data.collections.new("Sea")
    bpy.context.scene.collection.children.link(collection)
    collection.objects.link(ob)
    path = save(tmp_path / "asset.blend")
    factory_settings(use_empty=True)
    return path, want


def linked(path, kind: str, name: str):
    with bpy.data.libraries.load(str(path), link=True) as (_, into):
        setattr(into, kind, [name])
    return getattr(into, kind)[0]


def test_an_instance_of_a_linked_collection_shows_its_sea(asset):
    path, want = asset
    empty = bpy.data.objects.new("Instance", None)
    empty.instance_type = "COLLECTION"
    empty.instance_collection = linked(path, "collections", "Sea")
    bpy.context.collection.objects.link(empty)
    bpy.context.scene.frame_set(10)
    shown = []
    for instance in bpy.context.evaluated_depsgraph_get().object_instances:
        if instance.is_instance:
            mesh = instance.object.data
            shown.append(np.empty(3 * len(mesh.vertices), np.float32))
            mesh.vertices.foreach_get("co", shown[-1])
    assert len(shown) == 1
    assert np.abs(shown[0].reshape(-1, 3) - want).max() <= 1e-6


# Overrides ----------------------------------------------------------------------


@pytest.fixture
def overridden(tmp_path):
    """A function that gives a shot that overrides the ocean of asset.blend, baked there or not."""

    def make(*, baked: bool = False, name: str = "asset", kind: str = "PATCH"):
        sea = {"patch_size": 100.0, "foam_coverage": "threshold", "foam_lifetime": 1.0}
        empty()
        few = {"kind": "PATCH"} if kind == "PATCH" else {"vertices": 20000}
        add = add_ocean if kind == "PATCH" else add_horizon
        add(32, sea=sea, preset="beaufort_6", use_material=False, **few)
        bpy.context.scene.frame_start = bpy.context.scene.frame_end = 2
        path = save(tmp_path / name / "asset.blend")
        if baked:
            bpy.ops.libocean.bake()
            bpy.ops.wm.save_mainfile()
        empty()
        bpy.context.scene.frame_start = bpy.context.scene.frame_end = 2
        save(tmp_path / "shot.blend")
        return overriding(path)

    return make


def overriding(path):
    ob = linked(path, "objects", "Ocean").override_create(remap_local_usages=True)
    bpy.context.collection.objects.link(ob)
    bpy.context.view_layer.objects.active = ob
    return ob


def opened_again(tmp_path):
    return reopened(tmp_path / "shot.blend", "Ocean")


def shown(ob, frame: int = 2) -> np.ndarray:
    bpy.context.scene.frame_set(frame)
    return positions(ob).copy()


def test_an_override_that_is_baked_plays_its_bake(overridden, tmp_path):
    ob = overridden()
    live = shown(ob)
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    assert np.array_equal(shown(ob), live)
    ob = opened_again(tmp_path)
    assert np.array_equal(shown(ob), live)
    assert ob.libocean.bake.folder == "//ocean_bake/Ocean/" and ob.libocean.use_bake
    assert len(list((tmp_path / "ocean_bake" / "Ocean").glob("shot.displacement.*"))) == 3
    assert bake_state.faults(ob) == []
    # A farm needs no add-on for it.
    assert_shown_without_the_add_on(tmp_path / "shot.blend", {("Ocean", "position", 2): live})
    # Another sea is baked over it, and plays.
    ob.libocean.choppiness = 0.25
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    other = shown(ob)
    assert np.abs(other - live).max() > 0.1
    assert np.array_equal(shown(opened_again(tmp_path)), other)
    # Freed, it is live, as it was linked; one modifier shows it.
    ob = bpy.context.object
    bpy.ops.libocean.free_bake()
    ob.libocean.choppiness = 1.0
    assert np.array_equal(shown(ob), live)
    ob = opened_again(tmp_path)
    assert np.array_equal(shown(ob), live)
    (modifier,) = ob.modifiers
    assert modifier.show_viewport and modifier.show_render and not ob.libocean.use_bake


def test_a_baked_override_of_a_horizon_plays_on_the_whole_mesh(overridden, tmp_path):
    """The library's file holds a small one, since its sea is live there."""
    ob = overridden(kind="HORIZON")
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    baked = shown(ob)
    assert len(baked) > 10_000
    assert np.array_equal(shown(opened_again(tmp_path)), baked)
    assert_shown_without_the_add_on(tmp_path / "shot.blend", {("Ocean", "position", 2): baked})


def test_an_override_of_a_baked_ocean_plays_that_bake(overridden, tmp_path):
    ob = overridden(baked=True)
    want = shown(ob)
    assert np.ptp(want[:, 2]) > 0.5
    ob = opened_again(tmp_path)
    assert np.array_equal(shown(ob), want)
    asset = tmp_path / "asset" / "ocean_bake" / "Ocean"
    assert bake_record.place_of(ob).path == asset
    assert bake_state.faults(ob) == []
    # Live in the shot, and the library's bake again.
    ob.libocean.use_bake = False
    ob.libocean.choppiness = 0.25
    live = shown(ob)
    assert np.abs(live - want).max() > 0.1
    ob = opened_again(tmp_path)
    assert np.abs(shown(ob) - live).max() < 1e-6
    ob.libocean.use_bake = True
    assert np.array_equal(shown(ob), want)
    assert np.array_equal(shown(opened_again(tmp_path)), want)
    # Baked in the shot, that one, and the library's stays.
    before = times(asset)
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    assert np.array_equal(shown(bpy.context.object), live)
    ob = opened_again(tmp_path)
    assert np.array_equal(shown(ob), live)
    assert bake_record.place_of(ob).path == tmp_path / "ocean_bake" / "Ocean"
    assert times(asset) == before


def test_a_shot_changes_what_it_needs(overridden, tmp_path):
    """Each of a sea's properties, its wave systems and what is shown."""
    ob = overridden()
    settings = ob.libocean
    before = shown(ob)
    settings.choppiness, settings.seed = 0.5, 7
    settings.waves[0].wind_speed, settings.waves[0].use_significant_wave_height = 17.0, True
    settings.use_velocity, settings.mask, settings.use_custom_time = False, "still", True
    settings.custom_time = 3.0
    settings.mask = ""
    assert bpy.ops.libocean.add_waves() == {"FINISHED"}
    settings.waves[1].wind_speed = 4.0
    live = shown(ob)
    assert np.abs(live - before).max() > 0.1
    ob = opened_again(tmp_path)
    settings = ob.libocean
    assert (settings.choppiness, settings.seed, settings.custom_time) == (0.5, 7, 3.0)
    assert [waves.wind_speed for waves in settings.waves] == [17.0, 4.0]
    assert not settings.use_velocity
    assert np.abs(shown(ob) - live).max() < 1e-6


def test_oceans_of_one_name_from_two_files_are_baked_apart(overridden, tmp_path):
    one = overridden()
    path = tmp_path / "b" / "asset.blend"
    path.parent.mkdir()
    shutil.copy(tmp_path / "asset" / "asset.blend", path)
    seas = []
    for ob, choppiness in ((one, 1.0), (overriding(path), 0.25)):
        bpy.context.view_layer.objects.active = ob
        ob.libocean.choppiness = choppiness
        assert bpy.ops.libocean.bake() == {"FINISHED"}
        seas.append(shown(ob))
    assert np.abs(seas[0] - seas[1]).max() > 0.1
    first = opened_again(tmp_path)
    assert np.array_equal(shown(first), seas[0])
    second = next(ob for ob in bpy.data.objects if ob.override_library and ob != first)
    assert np.array_equal(shown(second), seas[1])


def test_missing_files_of_a_linked_bake_stop_a_render(overridden, tmp_path, capfd):
    """These are an override, a linked object and an instance of a linked collection."""
    ob = overridden(baked=True)
    scene = bpy.context.scene
    camera(scene)
    picture_settings(scene, 4)
    scene.frame_set(2)
    bpy.ops.render.render()
    (tmp_path / "asset" / "ocean_bake" / "Ocean" / "asset.displacement.0002.exr").unlink()
    theirs = ob.override_library.reference

    def said() -> str:
        capfd.readouterr()
        with pytest.raises(RuntimeError, match="no camera"):
            bpy.ops.render.render()
        return capfd.readouterr().err

    assert "Ocean: files of the bake are missing, of the frames 2 " in said()
    bpy.data.objects.remove(ob)
    bpy.ops.render.render()
    scene.collection.objects.link(theirs)
    assert "Ocean: files of the bake are missing, of the frames 2 " in said()


def test_paths_of_a_library_go_from_its_file(overridden, tmp_path):
    def of(ob) -> str:
        return parameter_values.values_of(ob.libocean).waves[0].values["file"]

    ob = overridden()
    theirs = ob.override_library.reference
    for waves in (theirs.libocean.waves[0], ob.libocean.waves[0]):
        waves.file = "//buoys\\n1.csv"
    assert of(theirs) == of(ob) == str(tmp_path / "asset" / "buoys" / "n1.csv")
    ob.libocean.waves[0].file = "//n2.csv"
    assert of(ob) == str(tmp_path / "n2.csv")


def test_an_override_that_blender_made_of_itself_keeps_its_bake(asset, tmp_path):
    """Blender calls the override of a whole collection a system override and keeps nothing of
    it."""
    path, _ = asset
    scene = bpy.context.scene
    scene.frame_start = scene.frame_end = 2
    save(tmp_path / "shot.blend")
    collection = linked(path, "collections", "Sea")
    scene.collection.children.link(collection)
    made = collection.override_hierarchy_create(scene, bpy.context.view_layer)
    (ob,) = made.objects
    assert ob.override_library.is_system_override
    bpy.context.view_layer.objects.active = ob
    ob.libocean.choppiness = 0.25
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    want = shown(ob)
    assert np.ptp(want[:, 2]) > 0.5
    ob = opened_again(tmp_path)
    assert np.array_equal(shown(ob), want)
    assert ob.libocean.choppiness == 0.25 and ob.libocean.use_bake
