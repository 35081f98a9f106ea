# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes know the undisplaced coordinate of each vertex: as an attribute and, in Blenders that
share unchanged layers between frames, as a UV map."""

import bpy
import numpy as np
import pytest
from conftest import add_ocean, attribute, plane, presets_with, reopened, rest
from libocean_addon.shared import compat

SEA = {"foam_lifetime": 1.0}


def own_labels(mesh) -> np.ndarray:
    values = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.attributes["label"].data.foreach_get("vector", values)
    return values.reshape(-1, 3)


def uv_of_corners(mesh) -> np.ndarray:
    values = np.empty(2 * len(mesh.loops), np.float32)
    mesh.uv_layers["UVMap"].data.foreach_get("uv", values)
    return values.reshape(-1, 2)


def assert_labelled(ob) -> None:
    mesh, period = ob.data, ob.libocean.patch_size
    labels = own_labels(mesh)
    assert np.array_equal(labels[:, :2], rest(ob)[:, :2])
    assert not labels[:, 2].any()
    if not compat.SHARES_LAYERS:
        assert not mesh.uv_layers
        return
    corners = np.empty(len(mesh.loops), np.int32)
    mesh.loops.foreach_get("vertex_index", corners)
    assert np.abs(uv_of_corners(mesh) * period - labels[corners, :2]).max() < 1e-5 * period
    assert len(mesh.uv_layers) == 1


def test_a_patch_has_them_whatever_its_size(scene, tmp_path):
    ob = add_ocean(64, sea=SEA, kind="PATCH", preset="beaufort_6")
    assert_labelled(ob)
    if compat.SHARES_LAYERS:
        assert (uv_of_corners(ob.data).min(), uv_of_corners(ob.data).max()) == (-0.5, 0.5)
    for name, value in (("patch_size", 70.0), ("mesh_resolution", 128), ("resolution", 32)):
        setattr(ob.libocean, name, value)
        assert_labelled(ob)
    assert len(ob.data.vertices) == 129**2
    assert_labelled(reopened(tmp_path / "sea.blend", "Ocean"))


def test_frames_leave_them_alone(scene):
    """They are written with the mesh, not with a frame."""
    ob = add_ocean(64, sea=SEA, kind="PATCH", preset="beaufort_6")
    ob.libocean.use_foam = False
    before = own_labels(ob.data)
    scene.frame_set(20)
    assert np.array_equal(attribute(ob, "label"), before)
    if compat.SHARES_LAYERS:
        evaluated = ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
        assert np.array_equal(uv_of_corners(evaluated), uv_of_corners(ob.data))
    # Foam has the label of the world: where it is white.
    ob.location.x = 3.0
    ob.libocean.use_foam = True
    bpy.context.view_layer.update()
    world = before + np.float32([3.0, 0.0, 1.0])
    assert np.abs(attribute(ob, "label") - world).max() < 1e-5


def test_a_patch_of_an_earlier_version_gets_them(scene):
    ob = add_ocean(64, sea=SEA, kind="PATCH", preset="beaufort_6")
    ob.data.attributes.remove(ob.data.attributes["label"])
    while ob.data.uv_layers:
        ob.data.uv_layers.remove(ob.data.uv_layers[0])
    ob.libocean.choppiness = 0.5
    assert_labelled(ob)


@pytest.mark.parametrize("has_uv", [False, True])
def test_the_mesh_of_a_modifier_has_them_but_keeps_its_own(scene, has_uv):
    ob = plane(40.0, 8)
    while ob.data.uv_layers:
        ob.data.uv_layers.remove(ob.data.uv_layers[0])
    if has_uv:
        ob.data.uv_layers.new(name="Mine")
    with presets_with(resolution=64, **SEA):
        assert bpy.ops.libocean.add_modifier() == {"FINISHED"}
    if has_uv:
        assert [layer.name for layer in ob.data.uv_layers] == ["Mine"]
        assert "label" not in ob.data.attributes
        return
    assert_labelled(ob)
    ob.libocean.patch_size = 25.0
    assert_labelled(ob)
    ob.data.attributes.remove(ob.data.attributes["label"])  # the user does not want it
    ob.libocean.patch_size = 50.0
    assert "label" not in ob.data.attributes
