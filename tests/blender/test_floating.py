# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects ride the waves: where the library says, at every frame, in renders too."""

import math

import bpy
import numpy as np
import pytest
from conftest import (
    add_ocean,
    assert_shown_without_the_add_on,
    camera,
    failing,
    keyed,
    picture_settings,
    plane,
    reopened,
    save,
    sea_of,
    updates_of,
)


@pytest.fixture
def ocean():
    return add_ocean(64, kind="PATCH", preset="beaufort_6")


@pytest.fixture
def boat(ocean):
    ob = plane(1.0, 2, "Boat")
    ob.scale = (20.0, 6.0, 1.0)
    ob.location = (40.0, -15.0, 0.0)
    ob.rotation_euler.z = math.radians(30)
    assert bpy.ops.libocean.add_float(ocean=ocean.name) == {"FINISHED"}
    return ob


def world(boat) -> np.ndarray:
    return np.array(boat.evaluated_get(bpy.context.evaluated_depsgraph_get()).matrix_world)


BODY = (40, -15, 30, 20, 6)


def assert_rides(ocean, boat, body=BODY, height=0.0, *, tilt=True) -> None:
    """body: x, y, heading, length, width; height of its own place."""
    with sea_of(ocean) as sea:
        pose = sea.float_pose([body], (bpy.context.scene.frame_current - 1) / 24)
    matrix = world(boat)
    axes = matrix[:3, :3] / np.linalg.norm(matrix[:3, :3], axis=0)
    assert matrix[:2, 3] == pytest.approx(body[:2], abs=1e-3)
    assert matrix[2, 3] == pytest.approx(pose.position[0][2] + height, abs=1e-4)
    if tilt:
        assert np.abs(axes[:, 0] - pose.forward[0]).max() < 1e-5
        assert np.abs(axes[:, 2] - pose.up[0]).max() < 1e-5
    else:
        assert np.abs(axes[:, 2] - (0, 0, 1)).max() < 1e-6


def test_a_boat_under_way(scene, ocean, boat):
    keyed(boat, location={1: (40.0, -15.0, 0.0), 101: (140.0, 35.0, 0.0)})
    for frame, place in ((1, (40, -15)), (101, (140, 35))):
        scene.frame_set(frame)
        assert_rides(ocean, boat, (*place, 30, 20, 6))


@pytest.mark.parametrize("mode", ["QUATERNION", "ZXY", "AXIS_ANGLE"])
def test_any_rotation_mode(scene, ocean, boat, mode):
    boat.rotation_mode = mode
    turn = math.radians(-50)
    if mode == "QUATERNION":
        boat.rotation_quaternion = (math.cos(turn / 2), 0, 0, math.sin(turn / 2))
    elif mode == "AXIS_ANGLE":
        boat.rotation_axis_angle = (turn, 0, 0, 1)
    else:
        boat.rotation_euler = (0, 0, turn)
    scene.frame_set(50)
    assert_rides(ocean, boat, (40, -15, -50, 20, 6))


def test_without_tilt_it_rises_and_falls(scene, ocean, boat):
    boat.libocean_float.use_tilt = False
    scene.frame_set(50)
    assert_rides(ocean, boat, tilt=False)


@pytest.mark.parametrize("follow", [True, False])
def test_on_an_ocean_that_is_moved_turned_and_scaled(scene, ocean, boat, follow):
    ocean.libocean.follow_world = follow
    ocean.location, ocean.rotation_euler.z, ocean.scale = (7, 3, 1.5), math.radians(90), (2, 2, 2)
    scene.frame_set(50)
    # Anchored to the world, its turn does not count. Else a quarter turn takes x to y.
    if follow:
        place = (7.0 + (40 - 7) / 2.0, 3.0 + (-15 - 3) / 2.0, 30, 10, 3)
    else:
        place = (-18.0 / 2.0, -33.0 / 2.0, 30 - 90, 10, 3)
    with sea_of(ocean) as sea:
        pose = sea.float_pose([place], 49 / 24)
    matrix = world(boat)
    assert matrix[2, 3] == pytest.approx(2.0 * pose.position[0][2] + 1.5, abs=1e-4)
    x, y, z = pose.up[0]
    up = (x, y, z) if follow else (-y, x, z)
    assert np.abs(matrix[:3, 2] / np.linalg.norm(matrix[:3, 2]) - up).max() < 1e-5


def test_it_lies_on_the_mesh_of_a_turned_ocean(scene, ocean, boat):
    """A float rides the sea that is seen: the mesh below a small, moved and turned float."""
    ocean.location, ocean.rotation_euler.z = (7.3, 3.1, 1.5), math.radians(37)
    boat.libocean_float.length = boat.libocean_float.width = 0.0
    ocean.libocean.resolution = 256
    scene.frame_set(50)
    seen = ocean.evaluated_get(bpy.context.evaluated_depsgraph_get())
    points = np.array([seen.matrix_world @ vertex.co for vertex in seen.data.vertices])
    near = points[np.argsort(np.hypot(points[:, 0] - 40, points[:, 1] + 15))[:4]]
    assert near[:, 2].min() - 0.02 <= world(boat)[2, 3] <= near[:, 2].max() + 0.02


def test_a_rendered_frame_has_the_boat_in_place(scene, ocean, boat, tmp_path):
    seen = {}

    def look(at, *_):
        graph = bpy.context.evaluated_depsgraph_get()
        seen[at.frame_current] = boat.evaluated_get(graph).matrix_world.translation.z

    picture_settings(scene, 8)
    camera(scene)
    scene.frame_start, scene.frame_end = 5, 7
    scene.render.filepath = str(tmp_path / "frame_")
    bpy.app.handlers.render_post.append(look)
    try:
        bpy.ops.render.render(animation=True)
    finally:
        bpy.app.handlers.render_post.remove(look)
    assert sorted(seen) == [5, 6, 7]
    with sea_of(ocean) as sea:
        for frame, height in seen.items():
            pose = sea.float_pose([(40, -15, 30, 20, 6)], (frame - 1) / 24)
            assert height == pytest.approx(pose.position[0][2], abs=1e-4)


def test_it_can_be_let_go(scene, ocean, boat):
    scene.frame_set(50)
    before = world(boat)
    assert bpy.ops.libocean.remove_float() == {"FINISHED"}
    assert np.allclose(world(boat), before, atol=1e-5)  # it stays where it is
    scene.frame_set(80)
    assert np.allclose(world(boat), before, atol=1e-5)
    assert len(boat.constraints) == 0
    assert not bpy.ops.libocean.remove_float.poll()


# Motion beside that of the waves -------------------------------------------------


def empty(name: str, location=(0.0, 0.0, 0.0), heading=0.0):
    ob = bpy.data.objects.new(name, None)
    bpy.context.collection.objects.link(ob)
    ob.location, ob.rotation_euler.z = location, math.radians(heading)
    return ob


def test_its_parent_counts(scene, ocean, boat):
    boat.parent = empty("Parent", (100.0, 20.0, 3.0), 90.0)
    bpy.context.view_layer.update()
    for frame in (50, 90):
        scene.frame_set(frame)
        assert_rides(ocean, boat, (115, 60, 120, 20, 6), 3.0)
    boat.parent.location.x += 30.0  # without a new frame
    bpy.context.view_layer.update()
    bpy.context.view_layer.update()
    assert_rides(ocean, boat, (145, 60, 120, 20, 6), 3.0)


def test_a_ship_on_a_path(scene, ocean, boat):
    points = bpy.data.curves.new("Course", "CURVE")
    points.dimensions = "3D"
    spline = points.splines.new("POLY")
    spline.points.add(1)
    spline.points[0].co, spline.points[1].co = (0, 50, 0, 1), (100, 50, 0, 1)
    course = bpy.data.objects.new("Course", points)
    bpy.context.collection.objects.link(course)
    course.rotation_euler.z = math.radians(-20)
    boat.location, boat.rotation_euler.z = (0, 0, 0), 0.0
    follow = boat.constraints.new("FOLLOW_PATH")
    follow.target, follow.use_fixed_location, follow.use_curve_follow = course, True, True
    follow.forward_axis = "FORWARD_X"
    keyed(follow, offset_factor={1: 0.1, 101: 0.9})
    bpy.context.view_layer.update()
    turn, seen = math.radians(-20), set()
    for frame in (1, 40, 101, 60):
        scene.frame_set(frame)
        x, y = 100.0 * boat.constraints["Follow Path"].offset_factor, 50.0
        place = (
            x * math.cos(turn) - y * math.sin(turn),
            x * math.sin(turn) + y * math.cos(turn),
            -20,
            20,
            6,
        )
        assert_rides(ocean, boat, place)
        seen.add(round(x, 3))
    assert len(seen) == 4


@pytest.mark.parametrize("later", [False, True])
def test_constraints_count_wherever_they_stand(scene, ocean, boat, later):
    if not later:
        bpy.ops.libocean.remove_float()
    leader = empty("Leader", (-60.0, 33.0, 0.0), -70.0)
    for kind in ("COPY_LOCATION", "COPY_ROTATION"):
        boat.constraints.new(kind).target = leader
    if not later:
        bpy.ops.libocean.add_float(ocean=ocean.name)
        boat.libocean_float.length, boat.libocean_float.width = 20, 6
    bpy.context.view_layer.update()
    scene.frame_set(50)
    assert_rides(ocean, boat, (-60, 33, -70, 20, 6))
    leader.location = (-50.0, 20.0, 1.0)
    scene.frame_set(51)
    assert_rides(ocean, boat, (-50, 20, -70, 20, 6), 1.0)


def test_nothing_is_written_while_nothing_moves(scene, ocean, boat):
    """Each write would make Blender evaluate the scene again, and so on forever."""
    boat.parent = empty("Parent", (1000.3, 2000.7, 3.0), 77.0)
    ocean.location, ocean.rotation_euler.z = (7.3, 1003.1, 0.0), 0.3
    bpy.context.view_layer.update()
    scene.frame_set(50)
    bpy.context.view_layer.update()
    assert updates_of(boat, 5) == set()


def test_a_deleted_ocean_lets_it_go(scene, ocean, boat):
    scene.frame_set(50)
    place = world(boat)
    bpy.ops.object.select_all(action="DESELECT")
    ocean.select_set(True)
    bpy.context.view_layer.objects.active = ocean
    bpy.ops.ed.undo_push(message="before")
    bpy.ops.object.delete()
    bpy.context.view_layer.update()
    assert boat.libocean_float.ocean is None
    assert len(boat.constraints) == 0
    assert np.allclose(world(boat), place, atol=1e-5)
    scene.frame_set(90)
    assert np.allclose(world(boat), place, atol=1e-5)
    bpy.ops.ed.undo_push(message="deleted")
    bpy.ops.ed.undo()
    scene, ocean, boat = bpy.context.scene, bpy.data.objects["Ocean"], bpy.data.objects["Boat"]
    assert boat.libocean_float.ocean == ocean
    scene.frame_set(50)
    assert_rides(ocean, boat)


def test_without_its_modifier_the_sea_is_flat(scene, ocean, boat):
    scene.frame_set(50)
    ocean.modifiers.clear()
    scene.frame_set(51)
    matrix = world(boat)
    assert matrix[:3, 3] == pytest.approx((40, -15, 0), abs=1e-4)
    assert matrix[:3, 2] == pytest.approx((0, 0, 1), abs=1e-6)


def test_a_copy_rides_by_itself(scene, ocean, boat):
    twin = boat.copy()
    bpy.context.collection.objects.link(twin)
    twin.location.x -= 70.0
    scene.frame_set(50)
    assert_rides(ocean, boat)
    assert_rides(ocean, twin, (-30, -15, 30, 20, 6))


def test_a_file_in_which_the_delta_transform_moved_it(scene, ocean, boat, tmp_path):
    scene.frame_set(50)
    place = world(boat)
    boat.constraints.clear()
    boat.libocean_float.property_unset("motion")
    boat.libocean_float.property_unset("version")
    boat.delta_location.z, boat.delta_rotation_euler.x = 1.2, 0.1
    assert np.allclose(world(reopened(tmp_path / "old.blend", "Boat", 50)), place, atol=1e-4)


def test_which_ocean_must_be_clear(ocean):
    add_ocean(64, kind="PATCH", preset="beaufort_2")
    plane(2.0, 2)
    assert "Which ocean" in failing(bpy.ops.libocean.add_float)
    assert "Which ocean" in failing(bpy.ops.libocean.add_float, ocean="nothing")


@pytest.mark.parametrize("mode", ["XYZ", "QUATERNION"])
def test_baked_it_moves_as_it_did_and_without_the_add_on(scene, ocean, boat, tmp_path, mode):
    boat.rotation_mode = mode
    keyed(boat, location={1: (0.0, -15.0, 0.0), 4: (9.0, -15.0, 0.0)})
    scene.frame_start, scene.frame_end = 1, 4
    live = []
    for frame in range(6):
        scene.frame_set(frame)
        live.append(world(boat))
    assert bpy.ops.libocean.bake_float() == {"FINISHED"}
    ocean.libocean.choppiness = 0.0  # which would move it
    ocean.libocean.seed = 99
    baked = {}
    for frame in range(6):
        scene.frame_set(frame)
        baked["Boat", "matrix", frame] = world(boat)
        assert np.allclose(world(boat), live[frame], atol=1e-5)
    assert_shown_without_the_add_on(save(tmp_path / "boat.blend"), baked)


def test_freed_it_rides_the_waves_again(scene, ocean, boat):
    scene.frame_start, scene.frame_end = 1, 4
    bpy.ops.libocean.bake_float()
    bpy.ops.libocean.free_float()
    for frame in (2, 50):
        scene.frame_set(frame)
        assert_rides(ocean, boat)
    assert not bpy.ops.libocean.free_float.poll()
    bpy.ops.libocean.bake_float()
    bpy.ops.libocean.remove_float()
    assert not bpy.ops.libocean.free_float.poll()
    scene.frame_set(2)
    stays = world(boat)
    scene.frame_set(4)
    assert np.array_equal(world(boat), stays)
    curves = boat.animation_data.action if boat.animation_data else None
    assert curves is None or not getattr(curves, "fcurves", ())


def test_a_boat_on_a_baked_sea_rides_it(scene, ocean, boat, tmp_path):
    save(tmp_path / "boat.blend")
    bpy.context.view_layer.objects.active = ocean
    bpy.ops.libocean.bake(frame_start=2, frame_end=2)
    scene.frame_set(3)
    assert_rides(ocean, boat)
    boat = reopened(tmp_path / "boat.blend", "Boat", 2)
    assert_rides(bpy.data.objects["Ocean"], boat)
