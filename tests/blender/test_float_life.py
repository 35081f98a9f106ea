# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects ride the water of a sea and of a coast where the library says, follow steps, values,
files and bakes; on the land of a coast they are refused."""

import math

import bpy
import numpy as np
import pytest
from conftest import add_ocean, failing, finish, plane, push, reopened, work_on
from layouts import drawn_by
from libocean_addon.floating import floating
from libocean_addon.shared import drafts
from test_coast import library_of

BODY = (50.0, 60.0, 30.0, 8.0, 3.0)


def add_boat(place=BODY[:2]):
    ob = plane(1.0, 2, "Boat")
    ob.scale = (8.0, 3.0, 1.0)
    ob.location = (*place, 0.0)
    ob.rotation_euler.z = math.radians(30)
    bpy.context.view_layer.update()
    return ob


@pytest.fixture(params=["sea", "coast"])
def water(request):
    """An object whose water has waves."""
    if request.param == "sea":
        return add_ocean(64, kind="PATCH", preset="beaufort_6", use_material=False)
    return request.getfixturevalue("coast")


@pytest.fixture
def boat(request):
    water = request.getfixturevalue("water" if "water" in request.fixturenames else "coast")
    ob = add_boat()
    assert bpy.ops.libocean.add_float(ocean=water.name) == {"FINISHED"}
    return ob


def pose_of(boat) -> tuple[np.ndarray, np.ndarray]:
    """Returns place and axes, in columns."""
    matrix = np.array(boat.evaluated_get(bpy.context.evaluated_depsgraph_get()).matrix_world)
    return matrix[:3, 3], matrix[:3, :3] / np.linalg.norm(matrix[:3, :3], axis=0)


def assert_rides(boat, ob, frame: float, body=BODY) -> None:
    with library_of(ob) as sea:
        pose = sea.float_pose([body], sea.time_of_frame(frame))
    place, axes = pose_of(boat)
    assert place == pytest.approx((*body[:2], pose.position[0][2]), abs=1e-4)
    assert np.abs(axes[:, 0] - pose.forward[0]).max() < 1e-5
    assert np.abs(axes[:, 2] - pose.up[0]).max() < 1e-5


def test_a_boat_lies_where_the_library_says(water, boat, scene):
    assert (boat.libocean_float.length, boat.libocean_float.width) == pytest.approx((8.0, 3.0))
    heights = set()
    for frame in (1, 30, 200, 31):
        scene.frame_set(frame)
        assert_rides(boat, water, frame)
        heights.add(round(boat.matrix_world.translation.z, 3))
    assert len(heights) == 4
    assert tuple(boat.location) == (*BODY[:2], 0.0)  # its own place stays its own
    assert boat.libocean_float.problem == ""


def test_a_boat_follows_another_wind(water, boat):
    water.libocean.waves[0].wind_speed = 6.0
    bpy.context.view_layer.update()
    assert_rides(boat, water, 1)


def test_floating_is_undone_and_redone(water):
    name = water.name
    add_boat()
    push("Before")
    bpy.ops.libocean.add_float(ocean=name)
    push("After")
    bpy.ops.ed.undo()
    assert bpy.data.objects["Boat"].libocean_float.ocean is None
    bpy.ops.ed.redo()
    assert_rides(bpy.data.objects["Boat"], bpy.data.objects[name], 1)


def test_a_file_is_opened_with_its_boats(water, boat, tmp_path):
    name = water.name
    boat = reopened(tmp_path / "boat.blend", "Boat", 20)
    assert_rides(boat, bpy.data.objects[name], 20)
    assert len(boat.constraints) == 1


def test_the_motion_of_a_boat_is_baked(water, boat, scene):
    scene.frame_start, scene.frame_end = 1, 4
    assert bpy.ops.libocean.bake_float() == {"FINISHED"}
    scene.frame_set(3)
    assert_rides(boat, water, 3)
    assert bpy.ops.libocean.free_float() == {"FINISHED"}
    scene.frame_set(50)
    assert_rides(boat, water, 50)


# Of a coast -----------------------------------------------------------------------


def test_a_coast_that_is_moved_takes_its_boats_along(coast, boat):
    coast.location, coast.rotation_euler.z = (3.0, -7.0, 1.5), math.radians(90)
    place = coast.matrix_basis @ bpy.data.objects["Boat"].location.to_3d()
    boat.location = (*place.xy, 0.0)
    bpy.context.view_layer.update()
    with library_of(coast) as sea:
        pose = sea.float_pose([(*BODY[:2], 30.0 - 90.0, 8.0, 3.0)], 0.0)
    assert pose_of(boat)[0][2] == pytest.approx(pose.position[0][2] + 1.5, abs=1e-4)


DRY = {"dry land": (160.0, 80.0), "no water": (-40.0, 60.0)}


@pytest.mark.parametrize("words", DRY)
def test_land_is_refused_in_a_sentence(coast, words):
    ob = add_boat(DRY[words])
    said = failing(bpy.ops.libocean.add_float, ocean=coast.name)
    assert f"Boat: At {DRY[words][0]:.1f}" in said and words in said
    assert ob.libocean_float.ocean is None and not ob.constraints
    assert tuple(ob.matrix_world.translation) == (*DRY[words], 0.0)


def test_a_boat_that_runs_aground_stays_at_its_place_and_says_so(coast, boat):
    for place, words in ((DRY["dry land"], "dry land"), (BODY[:2], "")):
        boat.location = (*place, 0.0)
        bpy.context.view_layer.update()
        bpy.context.view_layer.update()
        assert words in boat.libocean_float.problem
        if words:
            assert words in " ".join(drawn_by(floating.float_panel))
            assert boat.matrix_world.translation.z == pytest.approx(0.0, abs=1e-6)
    assert boat.libocean_float.problem == ""
    assert_rides(boat, coast, 1)


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
    assert_rides(boat, coast, 1)
