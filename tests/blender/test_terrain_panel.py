# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels of a terrain show the settings that apply, and its material is tuned in them. What
holds for all panels is in test_panels.py."""

import bpy
import pytest
from conftest import add_ocean, camera, failing
from layouts import drawn_by
from libocean_addon.shared import meshes
from libocean_addon.terrain import look_panels, panels

PANELS = (*panels.CLASSES, *look_panels.CLASSES)


@pytest.fixture
def terrain():
    bpy.ops.libocean.add_terrain(preset="seed_smooth")
    return bpy.context.object


def said() -> str:
    return " ".join(drawn_by(panels.terrain_panel))


def everything() -> list[str]:
    return drawn_by(*PANELS)


def test_what_does_not_apply_is_not_there(terrain):
    settings = terrain.libocean_terrain
    shown = set(everything())
    assert {"rms", "mean", "beta", "outer_scale", "libocean.add_break"} <= shown
    assert not {"ridge_gain", "ridge_spread", "direction", "breaks"} & shown
    settings.use_range = True
    assert not {"rms", "mean"} & set(everything())
    settings.measured = "/nowhere.csv"
    assert not {"beta", "outer_scale", "libocean.add_break"} & set(everything())
    settings.shape = "MESH"
    assert not {"tiles", "mesh_resolution_list"} & set(everything())


def test_what_is_unusual_is_said(terrain, scene):
    assert "Clip End" not in said()
    camera(scene, far=100.0)
    assert "sees 100 m far" in said()
    scene.camera = None
    terrain.scale.x = 2.0
    bpy.context.view_layer.update()
    assert "scaled unevenly" in said()
    terrain.libocean_terrain.mask = "nothing"
    assert "nothing is no vertex group" in said()
    scene.unit_settings.scale_length = 0.01
    assert "takes a Blender unit for a metre" in said()
    assert "66,049 vertices" in said() and "256 x 256 samples" in said()


def test_settings_that_others_undo_are_said(terrain, monkeypatch):
    monkeypatch.setattr(meshes, "MAX_SAMPLES", 8 * 32)  # 4096 take seconds
    settings = terrain.libocean_terrain
    settings.tiles, settings.mesh_resolution = 8, 32
    assert "vertices along each" not in said()
    settings.mesh_resolution = 64
    assert "8 tiles have at most 32 vertices along each, not 64" in said()
    settings.tiles, settings.mesh_resolution = 1, 64
    settings.use_lod = True
    assert "no effect" not in said()
    settings.follow_world = True
    assert "Mask and Anchor to the world have no effect with Level of Detail" in said()


def test_the_library_warns_in_the_words_of_the_panel(terrain):
    terrain.libocean_terrain.beta = 0.5
    assert "look like noise; a larger Beta" in said() or "a larger beta" in said()
    terrain.libocean_terrain.rms = 0.0
    assert "flat" in said()


def test_a_sea_and_a_terrain_are_not_on_one_object(terrain):
    assert "has a terrain" in failing(bpy.ops.libocean.add_modifier)
    add_ocean(64, use_material=False)
    assert "has an ocean" in failing(bpy.ops.libocean.add_terrain_modifier)
