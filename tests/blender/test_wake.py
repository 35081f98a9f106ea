# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The wakes of a sea file's hulls: in every kind of mesh as the library's region has them, at any
frame alone, under floats too."""

import bpy
import numpy as np
import pytest
from conftest import (
    add_horizon,
    add_ocean,
    attribute,
    plane,
    positions,
    reopened,
    rest,
    sea_of,
)
from libocean_addon.bundled import libocean
from libocean_addon.sea import facts, hull_values, wake_nodes, wakes
from libocean_addon.shared import changes, modifier_groups

HULL = """
[[hulls]]
length = 12.0
beam = 3.0
draught = 0.8
wake_resolution = 64
track = [[-60.0, {from_}, {y}], [60.0, {to}, {y}]]
"""
BOAT = HULL.format(from_=-240.0, to=240.0, y=10.0)
OTHER = HULL.format(from_=300.0, to=-300.0, y=-30.0)
SEA = """libocean = 1
[grid]
resolution = 64
patch_size = 256.0
[surface]
foam_lifetime = 0.0
[[waves]]
wind_speed = 7.0
"""


def load(ob, hulls: str, path) -> None:
    path.write_text(SEA + hulls)
    bpy.context.view_layer.objects.active = ob
    assert bpy.ops.libocean.load_sea(filepath=str(path)) == {"FINISHED"}
    assert ob.libocean.problem == ""


@pytest.fixture
def ocean(tmp_path):
    ob = add_ocean(64, kind="PATCH")
    load(ob, BOAT + OTHER, tmp_path / "boats.toml")
    return ob


def region(ob, time: float) -> dict:
    """Returns the library's maps at the vertices of a patch of 64 cells."""
    fields = ["displacement", "velocity", "normal"]
    with sea_of(ob) as sea:
        maps = sea.region(time, (-128.0, -128.0), (65, 65), 4.0, fields)
        maps["height"] = 4.0 * sea.region(time, (0.0, 0.0), (65, 65), 4.0)["displacement"].std()
    return maps


def of_vertices(values: np.ndarray) -> np.ndarray:
    return values.reshape(-1, values.shape[-1])


def offsets(ob) -> np.ndarray:
    return positions(ob) - rest(ob)


def give(ob, hulls: dict[str, str]) -> None:
    hull_values.assign(ob.libocean, hulls)
    changes.tell(ob.libocean)


def wake_shown(ob) -> np.ndarray:
    """Returns by how much the wakes move the vertices."""
    hulls, before = hull_values.texts_of(ob.libocean.hulls), positions(ob)
    give(ob, {})
    shown = before - positions(ob)
    give(ob, hulls)
    return shown


def wake_at(ob, labels: np.ndarray, time: float) -> np.ndarray:
    """Returns the sum of the wakes at labels that lie 2 m apart, from (-200, -200) on."""
    total = np.zeros((201, 201, 3), np.float32)
    with sea_of(ob) as sea:
        for hull in range(sea.wake_count):
            one = np.empty_like(total)
            sea.fill_wake(hull, time, [(one, ("dx", "dy", "height"))], (-200.0, -200.0), 2.0)
            total += one
    index = (labels[:, :2] + 200.0) / 2.0
    assert np.abs(index - np.rint(index)).max() < 1e-3
    column, row = np.rint(index).astype(int).T
    return total[row, column]


def test_a_patch_is_the_region_of_the_library_at_any_frame_alone(scene, ocean):
    shown = {}
    for frame in (1, 40, 120, 40, 1):
        scene.frame_set(frame)
        found = offsets(ocean)
        assert (shown.setdefault(frame, found) == found).all()
    scene.frame_set(120)
    maps = region(ocean, 119 / 24)
    error = np.abs(shown[120] - of_vertices(maps["displacement"])).max(axis=0)
    assert error[2] < 1e-5 * maps["height"]
    assert error[:2].max() < 2e-5  # places 128 m away, in single precision
    velocity, normal = of_vertices(maps["velocity"]), of_vertices(maps["normal"])
    assert np.abs(attribute(ocean, "ocean_velocity") - velocity).max() < 1e-4
    # To first order in the slopes of both.
    assert (attribute(ocean, "ocean_normal") - normal).std() < 0.05 * normal[:, :2].std()


def test_maps_of_sea_and_wakes_show_the_sums_of_the_nodes(scene, ocean, monkeypatch):
    ocean.location = (5.0, -9.0, 0.0)
    names = ("ocean_velocity", "ocean_normal", "jacobian", "foam", "cover", "trail")
    shown = []
    for in_maps in (True, False):
        scene.frame_set(30)
        use = {wake_nodes.IN_MAPS: in_maps, wake_nodes.USE: not in_maps}
        assert {name: modifier_groups.value(ocean.modifiers[0], name) for name in use} == use
        shown.append([positions(ocean), *(attribute(ocean, name) for name in names)])
        monkeypatch.setattr(wakes, "vertices_of", lambda picture: None)
        scene.frame_set(1)
    for found, wanted in zip(*shown, strict=True):
        assert np.ptp(found) > 0.1 and np.abs(found - wanted).max() < 2e-5


def change_nothing(ob):
    pass


def array_before(ob):
    ob.modifiers.new("Array", "ARRAY")
    bpy.ops.object.modifier_move_to_index(modifier="Array", index=0)


def moved_corner(ob):
    ob.data.vertices[0].co.x -= 4.0


@pytest.mark.parametrize(
    "change, in_maps",
    [
        (change_nothing, True),
        (array_before, False),
        (moved_corner, False),
        (lambda ob: setattr(ob.libocean, "mask", "painted"), False),
        (lambda ob: setattr(ob.libocean, "use_normal", False), False),
        (lambda ob: setattr(ob.libocean, "render_resolution", 128), False),
    ],
)
def test_meshes_that_are_other_than_made_have_images_of_wakes(scene, ocean, change, in_maps):
    change(ocean)
    scene.frame_set(2)
    assert modifier_groups.value(ocean.modifiers["Ocean"], wake_nodes.IN_MAPS) == in_maps
    assert modifier_groups.value(ocean.modifiers["Ocean"], wake_nodes.USE) != in_maps


def test_white_water_is_that_of_the_library(scene, ocean):
    scene.frame_set(30)
    with sea_of(ocean) as sea:
        maps = sea.region(29 / 24, (-128.0, -128.0), (65, 65), 4.0, ["trail", "foam", "cover"])
    trail, wanted = attribute(ocean, "trail"), maps["trail"].ravel()
    # Towards the end of the square it fades.
    with sea_of(ocean) as sea:
        squares = [sea.wake_domain(hull, 29 / 24) for hull in range(sea.wake_count)]
    near = np.ones(len(trail), bool)
    for square in squares:
        half = 0.5 * square.samples * square.cell
        off = np.abs(rest(ocean)[:, :2] - np.array(square.origin) - half).max(axis=1)
        near &= off < 0.7 * half
    assert near.sum() > 200 and trail[near].max() > 0.1
    assert np.abs(trail - wanted)[near].max() < 1e-5 and (trail <= wanted + 1e-5).all()
    foam, jacobian = attribute(ocean, "foam"), attribute(ocean, "jacobian")
    assert (foam - maps["foam"].ravel()).std() < 0.2 * maps["foam"].std()
    give(ocean, {})
    calm = attribute(ocean, "foam")
    assert (foam >= calm).all() and (foam > calm + 0.1).sum() > 5
    assert jacobian[foam > calm + 0.1].max() < jacobian.max()
    with pytest.raises(KeyError):
        attribute(ocean, "trail")


def test_a_patch_that_is_smaller_and_finer_than_a_wake_is_the_region_too(scene, ocean):
    ocean.libocean.patch_size, ocean.libocean.mesh_resolution = 64.0, 128
    ocean.libocean.resolution = 128
    scene.frame_set(30)
    with sea_of(ocean) as sea:
        wake = sea.wake_domain(0, 29 / 24)
        wanted = sea.region(29 / 24, (-32.0, -32.0), (129, 129), 0.5)["displacement"]
    assert wake.cell > 1.0 and wake.cell * wake.samples > 128.0
    assert np.abs(offsets(ocean) - of_vertices(wanted)).max() < 2e-5


def test_without_hulls_it_is_the_open_sea_again_to_the_bit(ocean):
    names = ("ocean_velocity", "ocean_normal", "jacobian")
    with_wakes, waked = positions(ocean), [attribute(ocean, name) for name in names]
    give(ocean, {})
    calm = positions(ocean)
    assert np.abs(with_wakes - calm).max() > 0.1
    for name, found in zip(names, waked, strict=True):
        assert (attribute(ocean, name) != found).any()
    with sea_of(ocean) as sea:
        height = sea.surface(0.0).height
    index = (np.arange(65) - 32) % 64
    assert (calm[:, 2] == height[np.ix_(index, index)].ravel()).all()
    (modifier,) = ocean.modifiers
    found = [modifier_groups.value(modifier, name) for name in wake_nodes.image_inputs()]
    assert found == [None] * len(found)


def test_beyond_the_square_there_is_no_wake(tmp_path):
    ob = add_ocean(64, kind="PATCH")
    load(ob, BOAT.replace("length = 12.0", "length = 6.0"), tmp_path / "small.toml")
    with sea_of(ob) as sea:
        wake = sea.wake_domain(0, 0.0)
    half = wake.samples * wake.cell / 2
    assert half < 100.0
    shown = wake_shown(ob)
    beyond = np.abs(rest(ob)[:, :2] - (np.array(wake.origin) + half)).max(axis=1) > half
    assert (shown[beyond] == 0.0).all() and beyond.sum() > 500 and shown.any()


@pytest.mark.parametrize("follow", [True, False])
def test_an_ocean_elsewhere_shows_the_wake_at_its_place(scene, ocean, follow):
    ocean.libocean.follow_world = follow
    ocean.location = (38.0, -22.0, 0.0)
    scene.frame_set(30)
    labels = rest(ocean) + (np.array([38.0, -22.0, 0.0]) if follow else 0.0)
    shown, wanted = wake_shown(ocean), wake_at(ocean, labels, 29 / 24)
    assert np.abs(wanted).max() > 0.1 and np.abs(shown - wanted).max() < 2e-5


def test_a_turned_ocean_shows_the_wake_at_its_place(scene, ocean):
    ocean.rotation_euler.z = 0.6
    scene.frame_set(30)
    turn = np.array(ocean.matrix_world.to_3x3())
    shown, labels = wake_shown(ocean) @ turn.T, rest(ocean) @ turn.T
    some = np.flatnonzero(np.abs(shown[:, 2]) > 0.05)[::20]
    wanted, one = np.zeros((len(some), 3)), np.empty((2, 2, 3), np.float32)
    with sea_of(ocean) as sea:
        for row, label in zip(wanted, labels[some, :2].tolist(), strict=True):
            for hull in (0, 1):
                sea.fill_wake(hull, 29 / 24, [(one, ("dx", "dy", "height"))], label, 1.0)
                row += one[0, 0]
    # Between the samples of its images it is linear.
    assert len(some) > 10 and (shown[some] - wanted).std() < 0.1 * wanted.std()


def test_the_rings_of_a_horizon_have_it_too(scene, tmp_path):
    horizon = add_horizon(64, 20000)
    load(horizon, BOAT, tmp_path / "boat.toml")
    bpy.ops.object.camera_add(location=(0.0, 0.0, 20.0))
    scene.camera = bpy.context.object
    scene.frame_set(12)
    labels, shown = attribute(horizon, "label")[:, :2], wake_shown(horizon)
    farthest = np.abs(labels).max(axis=1)
    is_even = np.abs(labels / 4.0 - np.rint(labels / 4.0)).max(axis=1) < 1e-4
    on_lattice = is_even & (farthest < 199.0)
    wanted = wake_at(horizon, labels[on_lattice], 11 / 24)
    assert on_lattice.sum() > 1000 and np.abs(wanted).max() > 0.1
    assert np.abs(shown[on_lattice] - wanted).max() < 2e-5
    assert farthest.max() > 400.0 and (shown[farthest > 400.0] == 0.0).all()


def test_more_hulls_than_are_shown_are_said(ocean, tmp_path):
    before = facts.warnings_of(ocean)
    assert not any("hulls" in warning for warning in before)
    load(ocean, (BOAT + OTHER) * 3, tmp_path / "fleet.toml")
    said = "The sea has 6 hulls, and the wakes of the first 4 are shown"
    assert facts.warnings_of(ocean) == [*before, said]
    assert wake_nodes.COUNT == 4


def test_a_float_rides_the_wake_of_another_hull(scene, ocean):
    with sea_of(ocean) as sea:
        wake = np.zeros((1, 40, 1), np.float32)
        wake = np.vstack([wake, wake])
        sea.fill_wake(0, 29 / 24, [(wake, ["height"])], (-45.0, 10.0), 1.0)
        place = (-45.0 + float(np.argmax(wake[0, :, 0])), 10.0)
    boat = plane(1.0, 2, "Boat")
    boat.location = (*place, 0.0)
    assert bpy.ops.libocean.add_float(ocean=ocean.name) == {"FINISHED"}
    scene.frame_set(30)
    height = boat.evaluated_get(bpy.context.evaluated_depsgraph_get()).matrix_world.translation.z
    with sea_of(ocean) as sea:
        pose = sea.float_pose([(*place, 0.0, 1.0, 1.0)], 29 / 24)
    give(ocean, {})
    with sea_of(ocean) as sea:
        calm = sea.float_pose([(*place, 0.0, 1.0, 1.0)], 29 / 24)
    assert height == pytest.approx(pose.position[0][2], abs=1e-4)
    assert height > calm.position[0][2] + 0.05


def test_hulls_are_kept_by_files_copies_undo_and_saved_seas(scene, ocean, tmp_path):
    before = offsets(ocean)
    saved = tmp_path / "saved.toml"
    assert bpy.ops.libocean.save_sea(filepath=str(saved)) == {"FINISHED"}
    with libocean.open(saved) as sea:
        assert sea.wake_count == 2
    ocean.select_set(True)
    assert bpy.ops.object.duplicate() == {"FINISHED"}
    copy = bpy.context.object
    assert copy != ocean
    scene.frame_set(2)
    scene.frame_set(1)
    assert (offsets(copy) == before).all()
    ocean = reopened(tmp_path / "boats.blend", ocean.name, 1)
    assert (offsets(ocean) == before).all()
