# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The land of a coast is as wet as the library says, at every frame, and its material shows it."""

import bpy
import numpy as np
import pytest
from conftest import attribute, evaluated_mesh, shine, taken
from layouts import drawn_by
from libocean_addon.coast import land_nodes, panels
from libocean_addon.terrain import material
from test_coast import CELL, COLUMNS, ROWS, add_coast, library_of


def wetness_of(ob, frame: float) -> np.ndarray:
    with library_of(ob) as sea:
        at = sea.time_of_frame(frame)
        return sea.region(at, (10.0, 20.0), (COLUMNS, ROWS), CELL, ("wetness",))["wetness"].ravel()


def assert_is_wet(ob, frame: float) -> None:
    want = wetness_of(ob, frame)
    assert 0.1 < (want > 0.5).mean() < 0.95
    assert np.abs(attribute(ob.libocean_coast.land, "shore_wetness") - want).max() <= 1e-5


@pytest.fixture
def wet(coast):
    coast.libocean_coast.use_wetness = True
    return coast


def test_the_land_is_as_wet_as_the_library_says(wet, scene):
    shown = []
    for frame in (1, 40, 9):
        scene.frame_set(frame)
        assert_is_wet(wet, frame)
        shown.append(attribute(wet.libocean_coast.land, "shore_wetness"))
    assert not np.array_equal(shown[0], shown[1])
    assert "use_wetness" in " ".join(drawn_by(panels.look_panel))


def test_another_wind_wets_it_otherwise(wet):
    before = attribute(wet.libocean_coast.land, "shore_wetness")
    wet.libocean.waves[0].wind_speed = 5.0
    assert_is_wet(wet, 1)
    assert not np.array_equal(attribute(wet.libocean_coast.land, "shore_wetness"), before)


def test_without_land_it_says_what_it_needs(wet):
    wet.libocean_coast.land = None
    assert "Wet ground has no effect: it needs Land" in " ".join(drawn_by(panels.look_panel))


def test_without_it_the_land_has_no_modifier(wet):
    wet.libocean_coast.use_wetness = False
    assert land_nodes.modifier_of(wet.libocean_coast.land) is None
    assert "shore_wetness" not in evaluated_mesh(wet.libocean_coast.land).attributes


def test_a_land_that_is_deleted_takes_its_wetness_along(wet):
    with bpy.context.temp_override(selected_objects=[wet.libocean_coast.land]):
        bpy.ops.object.delete()
    wet.libocean.level = 0.5
    assert wet.libocean_coast.problem == ""


@pytest.fixture
def ground(sea_file, studio):
    """The node of the land's material, all of sand without the damp band, seen from above."""
    ob = add_coast(sea_file, use_material=True)
    ob.hide_render = True
    studio.camera.data.ortho_scale = 100.0
    studio.render.resolution_x = studio.render.resolution_y = 128
    studio.camera.location = (80.0, 80.0, 100.0)
    (found,) = material.grounds(ob.libocean_coast.land)
    found.inputs["Wet Line"].default_value = -100.0
    found.inputs["Sand Line"].default_value = 100.0
    return found


def dry_and_wet(scene, tmp_path) -> list[np.ndarray]:
    found = []
    for is_wet in (False, True):
        bpy.data.objects["Water"].libocean_coast.use_wetness = is_wet
        found.append(taken(scene, tmp_path).mean(axis=2))
    return found


def test_wet_sand_is_darker(ground, scene, tmp_path):
    land = bpy.data.objects["Land"]
    shine(land, land.material_slots[0].material, ground.outputs["Colour"])
    dry, wet = dry_and_wet(scene, tmp_path)
    ratio = wet[dry > 0.0] / dry[dry > 0.0]
    assert ratio.min() < 0.6 and ratio.max() == pytest.approx(1.0, abs=1e-3)


def test_wet_sand_mirrors_the_sky(ground, scene, tmp_path):
    """On black ground water sends back what Fresnel's law says of a white sky: from above 2 %."""
    for socket in ground.inputs:
        if socket.name.endswith("Colour"):
            socket.default_value = (0.0, 0.0, 0.0, 1.0)
    scene.world = bpy.data.worlds.new("White")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    scene.cycles.samples = 16
    dry, wet = dry_and_wet(scene, tmp_path)
    land = slice(32, 96)  # within the land's outline
    assert dry.shape == (128, 128) and dry[land, land].max() == 0.0
    assert wet[land, land].max() == pytest.approx(0.02, rel=0.4)
