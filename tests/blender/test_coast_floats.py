# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects ride the water of a coast where the library says, follow steps and values, and are
refused on land."""

import math

import bpy
import numpy as np
import pytest
from conftest import finish, plane, reopen, work_on
from libocean_addon.floating import floating
from libocean_addon.shared import drafts
from test_coast import library_of
from test_floating import assert_rides
from test_terrain_panel import drawn_by

BODY = (50.0, 60.0, 30.0, 8.0, 3.0)


def add_boat(place=BODY[:2]):
    ob = plane(1.0, 2, "Boat")
    ob.scale = (8.0, 3.0, 1.0)
    ob.location = (*place, 0.0)
    ob.rotation_euler.z = math.radians(30)
    bpy.context.view_layer.update()
    return ob


@pytest.fixture
def boat(coast):
    ob = add_boat()
    assert bpy.ops.libocean.add_float(ocean=coast.name) == {"FINISHED"}
    return ob


def assert_rides_coast(boat, ob, frame: int, body=BODY) -> None:
    with library_of(ob) as sea:
        assert_rides(boat, sea.float_pose([body], sea.time_of_frame(frame)))


def test_a_boat_lies_where_the_library_says(coast, boat, scene):
    heights = set()
    for frame in (1, 30, 200, 31):
        scene.frame_set(frame)
        assert_rides_coast(boat, coast, frame)
        heights.add(round(boat.matrix_world.translation.z, 3))
    assert len(heights) == 4
    assert boat.libocean_float.problem == ""


def test_a_boat_follows_another_wind(coast, boat):
    coast.libocean.waves[0].wind_speed = 6.0
    bpy.context.view_layer.update()
    assert_rides_coast(boat, coast, 1)


def test_a_coast_that_is_moved_takes_its_boats_along(coast, boat):
    coast.location, coast.rotation_euler.z = (3.0, -7.0, 1.5), math.radians(90)
    place = coast.matrix_basis @ bpy.data.objects["Boat"].location.to_3d()
    boat.location = (*place.xy, 0.0)
    bpy.context.view_layer.update()
    with library_of(coast) as sea:
        pose = sea.float_pose([(*BODY[:2], 30.0 - 90.0, 8.0, 3.0)], 0.0)
    matrix = np.array(boat.evaluated_get(bpy.context.evaluated_depsgraph_get()).matrix_world)
    assert matrix[2, 3] == pytest.approx(pose.position[0][2] + 1.5, abs=1e-4)


DRY = {"dry land": (160.0, 80.0), "no water": (-40.0, 60.0)}


@pytest.mark.parametrize("said", DRY)
def test_land_is_refused_in_a_sentence(coast, said):
    ob = add_boat(DRY[said])
    with pytest.raises(RuntimeError, match=rf"Boat: At {DRY[said][0]:.1f}.*{said}"):
        bpy.ops.libocean.add_float(ocean=coast.name)
    assert ob.libocean_float.ocean is None and not ob.constraints
    assert tuple(ob.matrix_world.translation) == (*DRY[said], 0.0)


def test_a_boat_that_runs_aground_stays_at_its_place_and_says_so(coast, boat):
    boat.location = (*DRY["dry land"], 0.0)
    bpy.context.view_layer.update()
    bpy.context.view_layer.update()
    assert "dry land" in boat.libocean_float.problem
    assert "dry land" in " ".join(drawn_by(floating.FloatPanel))
    assert boat.matrix_world.translation.z == pytest.approx(0.0, abs=1e-6)
    boat.location = (*BODY[:2], 0.0)
    bpy.context.view_layer.update()
    bpy.context.view_layer.update()
    assert boat.libocean_float.problem == ""
    assert_rides_coast(boat, coast, 1)


def test_a_boat_stays_until_the_new_water_is_made(coast, boat, waiting, slow):
    before = boat.matrix_world.copy()
    coast.libocean.waves[0].wind_speed = 6.0
    work_on()
    bpy.context.view_layer.update()
    assert boat.matrix_world == before
    finish()
    bpy.context.view_layer.update()
    assert boat.matrix_world != before
    drafts.allowed = False
    assert_rides_coast(boat, coast, 1)


def test_floating_is_undone_and_redone(coast):
    add_boat()
    bpy.ops.ed.undo_push(message="Before")
    bpy.ops.libocean.add_float(ocean=coast.name)
    bpy.ops.ed.undo_push(message="After")
    bpy.ops.ed.undo()
    assert bpy.data.objects["Boat"].libocean_float.ocean is None
    bpy.ops.ed.redo()
    assert_rides_coast(bpy.data.objects["Boat"], bpy.data.objects["Water"], 1)


def test_a_file_is_opened_with_its_boats(coast, boat, tmp_path):
    reopen(tmp_path / "boat.blend")
    bpy.context.scene.frame_set(20)
    assert_rides_coast(bpy.data.objects["Boat"], bpy.data.objects["Water"], 20)


def test_the_motion_of_a_boat_is_baked(coast, boat, scene):
    scene.frame_start, scene.frame_end = 1, 4
    assert bpy.ops.libocean.bake_float() == {"FINISHED"}
    scene.frame_set(3)
    assert_rides_coast(boat, coast, 3)
    assert bpy.ops.libocean.free_float() == {"FINISHED"}
