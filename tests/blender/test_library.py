# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Seas of other files: linked objects, instances of collections, library overrides."""

import bpy
import numpy as np
import pytest
from conftest import add_ocean, factory_settings, positions, rest


@pytest.fixture
def asset(tmp_path):
    """A file with a small sea in a collection; its path and how it looks at frame 10."""
    ob = add_ocean(64, kind="PATCH", preset="beaufort_6")
    bpy.context.scene.frame_set(10)
    want = positions(ob)
    collection = bpy.data.collections.new("Sea")
    bpy.context.scene.collection.children.link(collection)
    collection.objects.link(ob)
    path = tmp_path / "asset.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    factory_settings(use_empty=True)
    return path, want


def linked(path, kind: str, name: str):
    with bpy.data.libraries.load(str(path), link=True) as (_, into):
        setattr(into, kind, [name])
    return getattr(into, kind)[0]


def test_a_linked_object_shows_its_sea(asset, tmp_path):
    path, want = asset
    ob = linked(path, "objects", "Ocean")
    bpy.context.collection.objects.link(ob)
    bpy.context.scene.frame_set(10)
    assert np.abs(positions(ob) - want).max() <= 1e-6
    bpy.context.scene.frame_set(30)
    assert np.abs(positions(ob) - want).max() > 0.1
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "shot.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "shot.blend"))
    bpy.context.scene.frame_set(10)
    assert np.abs(positions(bpy.data.objects["Ocean"]) - want).max() <= 1e-6


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


def test_an_override_of_a_linked_object_shows_a_sea_of_its_own_time(asset):
    path, want = asset
    ob = linked(path, "objects", "Ocean").override_create(remap_local_usages=True)
    bpy.context.collection.objects.link(ob)
    bpy.context.scene.frame_set(10)
    assert np.abs(positions(ob) - want).max() <= 1e-6
    assert np.ptp(positions(ob)[:, 2] - rest(ob)[:, 2]) > 0.5
