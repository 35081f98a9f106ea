# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Add Wake: an object's size below the water and its animation are a hull of the sea."""

import json
import time

import bpy
import numpy as np
import pytest
from conftest import add_ocean, failing, keyed, positions, push, reopened
from libocean_addon.bake import bake_record, bake_state
from libocean_addon.bundled import libocean
from libocean_addon.sea import hull_values, hulls, live
from libocean_addon.shared import compat


@pytest.fixture
def ocean(scene):
    scene.frame_end = 121
    scene.render.fps = 24
    return add_ocean(64, kind="PATCH", sea={"patch_size": 256.0})


def box(name="Boat", size=(12.0, 3.0, 2.0), bottom=-0.8):
    """A box that is alone selected, its lowest point so far above still water."""
    bpy.ops.object.select_all(action="DESELECT")
    bpy.ops.mesh.primitive_cube_add(size=1.0)
    ob = bpy.context.object
    ob.name, ob.scale = name, size
    ob.location.z = bottom + size[2] / 2
    return ob


def moving(ob, speed=8.0, start=(-20.0, 5.0)):
    """Animated along x, evenly, over 121 frames of 24 a second."""
    z = ob.location.z
    keyed(ob, location={1: (*start, z), 121: (start[0] + 5.0 * speed, start[1], z)})
    for curve in compat.curves_of(ob.animation_data):
        for key in curve.keyframe_points:
            key.interpolation = "LINEAR"
    return ob


@pytest.fixture
def boat(ocean):
    return moving(box())


def rows(hull) -> np.ndarray:
    return np.array(json.loads(hull.track_lines.split("=")[1].replace(",\n]", "]")))


def test_size_and_motion_of_an_object_are_a_hull(scene, ocean, boat):
    before = positions(ocean)
    begun = time.process_time()
    assert bpy.ops.libocean.add_wake() == {"FINISHED"}
    shown = positions(ocean)
    seconds = time.process_time() - begun
    print(f"\nfirst picture after {seconds:.2f} s of the processor")
    assert seconds <= 2.0
    (hull,) = ocean.libocean.hulls
    assert (hull.source, hull.name) == (boat, "Boat")
    assert (hull.length, hull.beam, hull.draught) == pytest.approx((12.0, 3.0, 0.8), abs=1e-5)
    track = rows(hull)
    assert np.diff(track[1:-1, 0]).max() <= 0.5 + 1e-6
    # From long before the first frame on, at the first frame's speed.
    assert track[0, 0] <= -300.0 and track[-1, 0] > 5.0
    assert track[:, 1] == pytest.approx(-20.0 + 8.0 * track[:, 0], abs=1e-3)
    assert track[:, 2] == pytest.approx(5.0, abs=1e-4)
    wake = np.abs(shown - before)[:, 2]
    ahead = before[:, 0] > 0.0
    assert wake.max() > 0.1 and wake[ahead].max() < 0.1 * wake.max()
    assert scene.frame_current == 1


def test_a_turned_float_with_children_on_a_moved_ocean_has_its_own_track(scene, ocean):
    ocean.location.x = 11.0
    boat = moving(box(size=(3.0, 12.0, 2.0)))  # its bow along y
    keel = box("Keel", (0.2, 2.0, 1.0), bottom=-1.5)
    keel.location.xy = -20.0, 5.0
    keel.parent = boat
    keel.matrix_parent_inverse = boat.matrix_world.inverted()
    boat.select_set(True)
    keel.select_set(False)
    assert bpy.ops.libocean.add_float(ocean=ocean.name) == {"FINISHED"}
    assert bpy.ops.libocean.add_wake(ocean=ocean.name) == {"FINISHED"}
    (hull,) = ocean.libocean.hulls
    assert (hull.length, hull.beam) == pytest.approx((12.0, 3.0), abs=1e-4)
    assert hull.draught == pytest.approx(1.5, abs=1e-3)
    track = rows(hull)
    assert track[:, 1] == pytest.approx(-20.0 + 8.0 * track[:, 0], abs=2e-3)


def test_what_makes_no_wake_is_said(scene, ocean, boat):
    def said() -> str:
        text = failing(bpy.ops.libocean.add_wake)
        assert len(ocean.libocean.hulls) == 0
        return text

    boat.location.z += 5.0
    keyed(boat, location={1: (0.0, 0.0, 5.0)})
    scene.frame_set(1)
    assert "Boat is above the water" in said()
    box()
    assert "does not move between the frames 1 and 121: animate it first" in said()
    moving(box(size=(200.0, 0.01, 2.0)), 8.0)
    assert ": Beam = 0.01" in said()
    moving(box(), 2000.0)
    assert "the hull jumps" in said()
    moving(box())
    ocean.libocean.use_custom_time = True
    assert "Ocean has a time of its own" in said()


def test_another_animation_is_told_and_taken(scene, ocean, boat):
    bpy.ops.libocean.add_wake()
    (hull,) = ocean.libocean.hulls
    hull.beam = 4.0
    scene.frame_set(5)
    assert hull.problem == ""
    moving(boat, 4.0)
    scene.frame_set(6)
    assert "The animation of Boat has changed" in hull.problem
    before = positions(ocean)
    hulls._renew()
    (hull,) = ocean.libocean.hulls
    assert hull.problem == "" and hull.beam == 4.0
    assert rows(hull)[:, 1] == pytest.approx(-20.0 + 4.0 * rows(hull)[:, 0], abs=1e-3)
    assert scene.frame_current == 6 and (positions(ocean) != before).any()
    scene.frame_set(7)
    assert hull.problem == ""
    boat.scale.x = 20.0
    bpy.context.view_layer.objects.active = ocean
    assert bpy.ops.libocean.update_wakes() == {"FINISHED"}
    (hull,) = ocean.libocean.hulls
    assert hull.length == pytest.approx(20.0, abs=1e-4)


def test_hulls_are_saved_kept_undone_and_removed(scene, ocean, boat, tmp_path):
    calm = positions(ocean)
    push("before")
    bpy.ops.libocean.add_wake()
    push("wake")
    waked = positions(ocean)
    bpy.ops.ed.undo()
    ocean, boat = bpy.data.objects["Ocean"], bpy.data.objects["Boat"]
    assert len(ocean.libocean.hulls) == 0 and (positions(ocean) == calm).all()
    bpy.ops.ed.redo()
    ocean, boat = bpy.data.objects["Ocean"], bpy.data.objects["Boat"]
    assert len(ocean.libocean.hulls) == 1 and (positions(ocean) == waked).all()
    path = tmp_path / "saved.toml"
    bpy.context.view_layer.objects.active = ocean
    bpy.ops.libocean.save_sea(filepath=str(path))
    with libocean.open(path) as sea:
        assert sea.wake_count == 1 and float(sea.get("hulls.0.length")) == pytest.approx(12.0)
    bpy.ops.libocean.load_preset(preset="beaufort_5")  # which has no hulls
    assert [hull.source for hull in ocean.libocean.hulls] == [boat]
    ocean = reopened(tmp_path / "boat.blend", "Ocean")
    (hull,) = ocean.libocean.hulls
    assert hull.source == bpy.data.objects["Boat"] and ocean.libocean.problem == ""
    assert bpy.ops.libocean.remove_wake() == {"FINISHED"}
    assert len(ocean.libocean.hulls) == 0
    assert hull_values.texts_of(ocean.libocean.hulls) == {}


def test_a_deleted_object_makes_no_waves(ocean, boat):
    calm = positions(ocean)
    bpy.ops.libocean.add_wake()
    assert (positions(ocean) != calm).any()
    push("wake")
    assert bpy.ops.object.delete() == {"FINISHED"}
    assert len(ocean.libocean.hulls) == 0 and (positions(ocean) == calm).all()
    push("deleted")
    bpy.ops.ed.undo()
    ocean = bpy.data.objects["Ocean"]
    assert [hull.source.name for hull in ocean.libocean.hulls] == ["Boat"]
    assert (positions(ocean) != calm).any()


def test_a_bake_and_its_panel_say_that_wakes_are_left_out(scene, ocean, boat, tmp_path):
    said = (hulls.left_out(), "ERROR")
    assert said not in bake_state.state(ocean, scene)
    bpy.ops.libocean.add_wake()
    assert said in bake_state.state(ocean, scene)
    bpy.context.view_layer.objects.active = ocean
    folder = str(tmp_path)
    assert bpy.ops.libocean.bake(directory=folder, frame_start=1, frame_end=1) == {"FINISHED"}
    (hull,) = ocean.libocean.hulls
    hull.beam = 4.0
    values = live.current_values(ocean.libocean, scene)
    assert not bake_record.is_other_sea(ocean, scene, values)
