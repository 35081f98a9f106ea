# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A crest on cue is an empty at a frame: the mesh has the crest there, wherever the empty is put,
and files, copies, undo and bakes keep it."""

import math

import bpy
import numpy as np
import pytest
from conftest import NO_PAST, add_ocean, finish, plane, positions, presets_with
from layouts import Layout, drawn_by
from libocean_addon.bundled import libocean
from libocean_addon.sea import crest_panels, crests, facts, live, parameter_values
from libocean_addon.shared import changes, drafts
from mathutils import Vector

SEA = {"patch_size": 200.0, "wind_speed": 12.0}
PLACE = (25.0, -37.5)  # a vertex of a patch of 64 samples


@pytest.fixture
def ocean():
    return add_ocean(64, kind="PATCH", use_material=False, sea=SEA)


def add_crest(place=PLACE, frame=49, **settings):
    scene = bpy.context.scene
    scene.frame_set(frame)
    scene.cursor.location = (*place, 5.0)
    assert bpy.ops.libocean.add_crest(**settings) == {"FINISHED"}
    row = next(ob for ob in scene.objects if ob.libocean.crests).libocean.crests[-1]
    return row, row.empty


def vertex_at(ob, place) -> np.ndarray:
    """Where the vertex of a place of the mesh is shown."""
    flat = np.array([v.co[:2] for v in ob.data.vertices])
    near = np.hypot(*(flat - place).T)
    assert near.min() < 1e-4
    return positions(ob)[near.argmin()]


def assert_crest(ob, place, height: float) -> None:
    """The vertex is the sea's point at its own place, as high as asked for."""
    bpy.context.view_layer.update()
    assert ob.libocean.problem == ""
    np.testing.assert_allclose(vertex_at(ob, place), (*place, height), atol=1e-4)


def state(ob) -> dict:
    return facts.sea_state(ob)


def test_a_crest_is_where_its_empty_is(scene, ocean):
    hs = state(ocean)["significant_wave_height"]["asked"]
    row, empty = add_crest()
    assert empty.location[:] == (*PLACE, 0.0)
    assert (row.frame, row.height, row.unit, row.use_time) == (
        49.0,
        pytest.approx(1.2),
        "HS",
        False,
    )
    assert_crest(ocean, PLACE, 1.2 * hs)
    scene.frame_set(70)
    assert vertex_at(ocean, PLACE)[2] < 1.0 * hs
    scene.frame_set(49)
    # Wherever it goes, also by a parent.
    empty.location = (-50.0, 12.5, 3.0)
    assert_crest(ocean, (-50.0, 12.5), 1.2 * hs)
    carrier = bpy.data.objects.new("carrier", None)
    scene.collection.objects.link(carrier)
    empty.parent, carrier.location = carrier, (75.0, 0.0, 0.0)
    assert_crest(ocean, (25.0, 12.5), 1.2 * hs)
    # And whatever is set.
    row.height, row.unit = 2.0, "METRES"
    assert_crest(ocean, (25.0, 12.5), 2.0)
    row.height = -1.0
    assert_crest(ocean, (25.0, 12.5), -1.0)
    row.frame = 70
    bpy.ops.libocean.go_to_crest()
    assert scene.frame_current == 70
    assert_crest(ocean, (25.0, 12.5), -1.0)
    # A seed keeps it.
    ocean.libocean.seed = 5
    assert_crest(ocean, (25.0, 12.5), -1.0)


def test_the_time_is_that_of_its_frame_or_its_own(scene, ocean):
    ocean.libocean.start, ocean.libocean.first_frame = 100.0, 1001
    scene.render.fps = 25
    row, _ = add_crest(frame=1026)
    assert state(ocean)["crests"][0]["time"] == pytest.approx(101.0)
    scene.render.fps = 50
    bpy.context.view_layer.update()
    assert state(ocean)["crests"][0]["time"] == pytest.approx(100.5)
    # With a time of one's own the crest has that of the moment, and keeps it.
    ocean.libocean.use_custom_time, ocean.libocean.custom_time = True, 7.0
    other, _ = add_crest(place=(-60.0, 40.0), height=0.5)
    assert (other.use_time, other.time) == (True, 7.0)
    ocean.libocean.custom_time = 8.0
    assert [crest["time"] for crest in state(ocean)["crests"]] == [100.5, 7.0]
    ocean.libocean.use_custom_time = False
    ocean.libocean.active_crest = 1
    bpy.ops.libocean.go_to_crest()
    assert scene.frame_current == 1001 + round((7.0 - 100.0) * 50)


@pytest.mark.parametrize("follow_world", [True, False])
def test_a_moved_and_turned_ocean_has_the_crest_at_the_empty(scene, ocean, follow_world):
    ocean.libocean.follow_world = follow_world
    ocean.location, ocean.rotation_euler.z = (300.0, 25.0, 4.0), math.radians(90.0)
    bpy.context.view_layer.update()
    world = ocean.matrix_world @ Vector((*PLACE, 0.0))
    _, empty = add_crest(place=world[:2])
    assert empty.location.z == 4.0
    bpy.context.view_layer.update()
    hs = state(ocean)["significant_wave_height"]["asked"]
    there = vertex_at(ocean, PLACE)
    np.testing.assert_allclose(there, (*PLACE, 1.2 * hs), atol=5e-4)
    (crest,) = state(ocean)["crests"]
    expected = world[:2] if follow_world else PLACE
    np.testing.assert_allclose((crest["x"], crest["y"]), expected, atol=1e-4)


def test_a_direction_is_that_of_the_empty(ocean):
    row, empty = add_crest(height=0.8)
    empty.rotation_euler.z = math.radians(40.0)
    values = live.current_values(ocean.libocean, bpy.context.scene)
    assert values.crests["crests.0.direction"] == ""
    row.use_direction = True
    values = live.current_values(ocean.libocean, bpy.context.scene)
    assert float(values.crests["crests.0.direction"]) == pytest.approx(40.0)
    ocean.libocean.follow_world, ocean.rotation_euler.z = False, math.radians(30.0)
    bpy.context.view_layer.update()
    values = live.current_values(ocean.libocean, bpy.context.scene)
    assert float(values.crests["crests.0.direction"]) == pytest.approx(10.0, abs=1e-3)


def test_what_the_library_says_names_the_empty(ocean):
    row, empty = add_crest()
    empty.name = "Hero"
    row.height = 1.3
    assert any(text.startswith("Hero: ") and "1.30 Hs" in text for text in facts.warnings_of(ocean))
    row.height = 2.5
    assert ocean.libocean.problem.startswith('Hero, height = "2.5 Hs": is higher than waves get')
    row.height, row.unit = 80.0, "METRES"
    assert ocean.libocean.problem.startswith("Hero, height = 80 m: is ")
    assert facts.state_of(ocean) is None and facts.warnings_of(ocean) == []
    row.height, row.unit = 1.0, "HS"
    assert ocean.libocean.problem == ""
    add_crest(place=(PLACE[0] + 1.0, PLACE[1]), height=-1.0)
    assert "contradicts the crests near it" in ocean.libocean.problem
    bpy.ops.libocean.remove_crest()
    assert ocean.libocean.problem == ""
    ocean.libocean.take_lines = '[take]\nlines = ["1 wind_speed 9"]\n'
    ocean.libocean.seed = 3
    assert "plays no take" in ocean.libocean.problem


def test_sixteen_crests_and_no_more(ocean):
    with changes.quiet():
        for i in range(crests.MOST):
            ocean.libocean.crests.add().empty = bpy.data.objects.new(f"c{i}", None)
            bpy.context.scene.collection.objects.link(ocean.libocean.crests[-1].empty)
    with pytest.raises(RuntimeError, match="at most 16 crests"):
        bpy.ops.libocean.add_crest()


def test_a_crest_without_its_empty_is_none(ocean):
    row, empty = add_crest()
    bpy.data.objects.remove(empty)
    bpy.context.view_layer.update()
    assert "crests" not in state(ocean)
    row, empty = add_crest()
    bpy.context.scene.collection.objects.unlink(empty)
    bpy.context.view_layer.update()
    assert "crests" not in state(ocean)
    ocean.libocean.active_crest = 1
    bpy.ops.libocean.remove_crest()
    assert len(ocean.libocean.crests) == 1


def test_removing_a_crest_removes_its_empty_unless_a_copy_has_it(ocean):
    _, empty = add_crest()
    name = empty.name
    bpy.ops.object.select_all(action="DESELECT")
    ocean.select_set(True)
    bpy.ops.object.duplicate()
    copy = bpy.context.object
    assert copy != ocean and copy.libocean.crests[0].empty == ocean.libocean.crests[0].empty
    hs = state(ocean)["significant_wave_height"]["asked"]
    assert_crest(copy, PLACE, 1.2 * hs)
    bpy.ops.libocean.remove_crest()
    assert name in bpy.data.objects and "crests" not in state(copy)
    bpy.context.view_layer.objects.active = ocean
    assert_crest(ocean, PLACE, 1.2 * hs)
    bpy.ops.libocean.remove_crest()
    assert name not in bpy.data.objects and "crests" not in state(ocean)


def test_a_preset_keeps_crests_and_a_file_brings_its_own(ocean, tmp_path):
    _, empty = add_crest()
    with presets_with(resolution=64, **NO_PAST):
        bpy.ops.libocean.load_preset(preset="beaufort_7")
    assert ocean.libocean.crests[0].empty == empty
    hs = state(ocean)["significant_wave_height"]["asked"]
    assert state(ocean)["crests"][0]["height"] == pytest.approx(1.2 * hs)
    saved = tmp_path / "saved.toml"
    assert bpy.ops.libocean.save_sea(filepath=str(saved)) == {"FINISHED"}
    assert '[[crests]]\ntime = 2.0\nx = 25.0\ny = -37.5\nheight = "1.2 Hs"\n' in saved.read_text()
    bpy.ops.libocean.load_sea(filepath=str(saved))
    assert ocean.libocean.crests[0].empty == empty  # it has them already
    with libocean.open(saved) as sea:
        sea.set_all({"crests.0.x": "50.123456789", "crests.0.direction": "15"})
        saved.write_text(sea.text)
    bpy.ops.libocean.load_sea(filepath=str(saved))
    (row,) = ocean.libocean.crests
    assert row.empty.location.x == pytest.approx(50.123456789)
    assert math.degrees(row.empty.rotation_euler.z) == pytest.approx(15.0)
    assert (row.use_time, row.time, row.use_direction) == (True, 2.0, True)
    assert len([ob for ob in bpy.data.objects if ob.type == "EMPTY"]) == 1
    values = parameter_values.values_of(ocean.libocean).crests
    assert values["crests.0.x"] == "50.123456789" and values["crests.0.direction"] == "15"
    row.empty.location.x = 60.0
    assert parameter_values.values_of(ocean.libocean).crests["crests.0.x"] == "60"


def test_files_undo_and_earlier_versions_keep_it(ocean, tmp_path):
    hs = state(ocean)["significant_wave_height"]["asked"]
    bpy.ops.ed.undo_push(message="before")
    add_crest()
    bpy.ops.ed.undo_push(message="crest")
    bpy.data.objects["Ocean crest"].location.x = 50.0
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="moved")
    bpy.ops.ed.undo()
    assert_crest(bpy.data.objects["Ocean"], PLACE, 1.2 * hs)
    bpy.ops.ed.undo()
    assert not bpy.data.objects["Ocean"].libocean.crests
    assert "crests" not in state(bpy.data.objects["Ocean"])
    bpy.ops.ed.redo()
    assert_crest(bpy.data.objects["Ocean"], PLACE, 1.2 * hs)
    path = str(tmp_path / "shot.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    ocean = bpy.data.objects["Ocean"]
    assert_crest(ocean, PLACE, 1.2 * hs)
    # An earlier version kept the crests of a file as text.
    with changes.quiet():
        crests.remove(ocean.libocean, 0)
        ocean.libocean.crest_values = (
            '{"crests.0.time": "2", "crests.0.x": "25", "crests.0.y": "-37.5", '
            '"crests.0.height": "1.2 Hs", "crests.0.direction": ""}'
        )
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    ocean = bpy.data.objects["Ocean"]
    assert ocean.libocean.crest_values == "" and len(ocean.libocean.crests) == 1
    assert_crest(ocean, PLACE, 1.2 * hs)


def test_linked_and_overridden_oceans_keep_it(ocean, tmp_path):
    hs = state(ocean)["significant_wave_height"]["asked"]
    add_crest()
    path = str(tmp_path / "asset.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_homefile(use_empty=True)
    scene = bpy.context.scene
    scene.frame_set(49)
    with bpy.data.libraries.load(path, link=True) as (_, into):
        into.objects = ["Ocean"]
    linked = bpy.data.objects["Ocean"]
    scene.collection.objects.link(linked)
    bpy.context.view_layer.update()
    assert_crest(linked, PLACE, 1.2 * hs)
    own = linked.override_create(remap_local_usages=True)
    bpy.context.view_layer.objects.active = own
    add_crest(place=(-50.0, 50.0), height=0.7)
    shot = str(tmp_path / "shot.blend")
    bpy.ops.wm.save_as_mainfile(filepath=shot)
    bpy.ops.wm.open_mainfile(filepath=shot)
    (own,) = (ob for ob in bpy.context.scene.objects if ob.libocean.crests)
    assert own.override_library is not None
    assert [round(row.height, 3) for row in own.libocean.crests] == [1.2, 0.7]
    assert_crest(own, (-50.0, 50.0), 0.7 * hs)


def test_a_bake_has_it(ocean, tmp_path):
    hs = state(ocean)["significant_wave_height"]["asked"]
    add_crest()
    ocean.libocean.bake.directory = str(tmp_path / "bake")
    assert bpy.ops.libocean.bake(frame_start=49, frame_end=49) == {"FINISHED"}
    assert ocean.libocean.use_bake
    assert_crest(ocean, PLACE, 1.2 * hs)


def test_the_empty_of_a_crest_stands_for_its_ocean(scene, ocean):
    _, empty = add_crest()
    plane(100.0, 2)
    other = add_ocean(64, kind="PATCH", use_material=False, sea=SEA)
    bpy.context.view_layer.objects.active = empty
    add_crest(place=(0.0, 50.0), height=0.5)
    assert (len(ocean.libocean.crests), len(other.libocean.crests)) == (2, 0)
    bpy.context.view_layer.objects.active = None
    assert not bpy.ops.libocean.add_crest.poll()  # which of the two?
    bpy.context.view_layer.objects.active = empty
    bpy.ops.libocean.remove_crest()
    assert [row.height for row in ocean.libocean.crests] == [0.5]


def test_the_panels_show_it(ocean):
    row, empty = add_crest()
    shown = drawn_by(crest_panels.crests_panel)
    assert {"frame", "height", "unit", "use_direction"} < set(shown) and "time" not in shown
    row.use_time = True
    assert "time" in drawn_by(crest_panels.crests_panel)
    assert not crest_panels.empty_panel.poll(bpy.context)
    bpy.context.view_layer.objects.active = empty
    assert crest_panels.empty_panel.poll(bpy.context)
    assert "height" in drawn_by(crest_panels.empty_panel)
    for empty_of_list in (empty, None):
        row.empty = empty_of_list
        drawn = []
        crest_panels.CrestList.draw_item(None, None, Layout(drawn), None, row, 0, None, "")
        assert ("name" in drawn) == (empty_of_list is not None)


def test_the_highest_crest_of_the_frames_is_found(scene, ocean, capfd):
    ocean.location.x = 1000.0
    bpy.context.view_layer.update()
    add_crest(height=2.0, frame=20)
    scene.frame_start, scene.frame_end = 1, 97
    assert bpy.ops.libocean.find_crest() == {"FINISHED"}
    assert 1 <= scene.frame_current <= 97 and scene.frame_current != 20
    there = scene.cursor.location
    assert abs(there.x - 1000.0) <= 100.0 and abs(there.y) <= 100.0 and there.z == 0.0
    ocean.libocean.crests[0].height = 0.1  # which the search left out
    with libocean.parse(without_crests(ocean, scene)) as sea:
        found = sea.find_crest(0.0, 4.0)
        best = max(sea.surface(t, fields=["height"]).height.max() for t in (0.0, 1.0, 2.0, 3.0))
        at = sea.query([there[:2]], (scene.frame_current - 1) / 24.0, foam=False)[0, 2]
    assert found.height > best and at == pytest.approx(found.height, rel=0.05)
    frame = scene.frame_current
    scene.cursor.location = (0.0, 0.0, 9.0)
    scene.frame_set(3)
    bpy.ops.libocean.find_crest(go_to_frame=False, move_cursor=False)
    assert scene.frame_current == 3 != frame and scene.cursor.location.z == 9.0


def without_crests(ob, scene) -> str:
    values = live.current_values(ob.libocean, scene)
    values.crests = {}
    return values.text()


def test_a_dragged_empty_shows_drafts(scene, waiting):
    ocean = add_ocean(128, kind="PATCH", use_material=False, sea=SEA | {"foam_lifetime": 5})
    _, empty = add_crest()
    finish()
    for x in (20.0, 22.0, 24.0):
        empty.location.x = x
        bpy.context.view_layer.update()
        assert drafts.is_draft(ocean.name_full)
    finish()
    assert not drafts.is_draft(ocean.name_full)
    assert state(ocean)["crests"][0]["x"] == 24.0
