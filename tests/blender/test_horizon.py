# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The rings of a horizon: one closed sheet around the camera, libocean's surface in each."""

import dataclasses
from collections import Counter

import bpy
import conftest
import numpy as np
import pytest
from conftest import (
    NO_PAST,
    add_horizon,
    attribute,
    empty,
    evaluated_mesh,
    failing,
    keyed,
    meshes_in,
    opened,
    plane,
    positions,
    presets_with,
    push,
    reopened,
    rest,
    save,
)
from libocean_addon.bundled import libocean
from libocean_addon.sea import atlas, horizon_mesh, live, ring_nodes
from libocean_addon.shared import failures, meshes

FRAMES = (1, 40, 250)
ROUND, ODD = 200.0, 137.3
# Near the middle, and far away, where the rings have moved by all kinds of steps.
CAMERAS = ((0.0, 0.0), (37.1, -12.9), (-4321.0, 1234.5))

SEA = """
libocean = 1
[grid]
resolution = 64
patch_size = {period}
[surface]
foam_lifetime = {past}
[[waves]]
spectrum = "jonswap"
wind_speed = {wind}
wind_direction = 30.0
"""


@pytest.fixture
def horizon(scene, tmp_path):
    """horizon(period, wind, camera): a small one; returns the object and the library's sea. past:
    of its foam [s], which takes as long as all else."""

    def make(period=ROUND, wind=14.0, camera=(37.1, -12.9), past=0.0):
        conftest.camera(scene, (*camera, 5.0))
        ob = add_horizon(64, 20000)
        path = tmp_path / "sea.toml"
        path.write_text(SEA.format(period=period, wind=wind, past=past))
        assert bpy.ops.libocean.load_sea(filepath=str(path)) == {"FINISHED"}
        return ob, libocean.open(path)

    return make


def levels(ob) -> np.ndarray:
    """The number of each vertex's ring, and how far it has become the next one."""
    number, share, _ = attribute(ob, ring_nodes.RING).T
    return number + share


def on_samples(ob, level: int, spacing: float) -> np.ndarray:
    """Which vertices of a ring lie on the samples of its map: all but those between two where it
    meets the finer ring."""
    index = rest(ob)[:, :2] / (spacing * 2.0**level)
    return (levels(ob) == level) & (np.abs(index - np.rint(index)).max(axis=1) < 0.25)


def want(sea, field: str, ob, camera, level: int, chosen, time: float) -> np.ndarray:
    """A field at the vertices of one ring that lie on the samples of its map."""
    period = float(sea.get("patch_size"))
    size = int(sea.get("resolution")) >> level
    cell = period / size
    first = np.floor(np.array(camera) / (2.0 * cell)) * 2.0
    index = np.rint(rest(ob)[chosen, :2] / cell + first).astype(int) % size
    maps = getattr(sea.surface(time, size), field)
    return maps[index[:, 1], index[:, 0]]


def at_rest(ob, camera, level: int, chosen, spacing: float) -> np.ndarray:
    """Where the vertices of one ring are without waves, in the object's space."""
    cell = spacing * 2.0**level
    place = rest(ob)[chosen].astype(np.float64)
    place[:, :2] += np.floor(np.array(camera) / (2.0 * cell)) * 2.0 * cell
    return place - np.array(ob.location)


def assert_rings(ob, sea, camera, time, tolerance=2e-5):
    limit = tolerance * sea.state["significant_wave_height"]["resolved"]
    spacing = float(sea.get("patch_size")) / int(sea.get("resolution"))
    for ring in (0, 1):
        chosen = on_samples(ob, ring, spacing)
        assert chosen.sum() > 500
        displacement = positions(ob)[chosen] - at_rest(ob, camera, ring, chosen, spacing)
        expected = want(sea, "displacement", ob, camera, ring, chosen, time)
        error = np.abs(displacement - expected)
        assert error[:, 2].max() <= limit
        # Far away a place is rounded more than the waves are.
        periods = np.abs(positions(ob)[chosen, :2]).max() / float(sea.get("patch_size"))
        assert error[:, :2].max() <= (limit if periods < 1 else 50 * limit)
        velocity = want(sea, "velocity", ob, camera, ring, chosen, time)
        assert np.abs(attribute(ob, "velocity")[chosen] - velocity).max() <= limit
        normal = want(sea, "normal", ob, camera, ring, chosen, time)
        assert np.abs(attribute(ob, "ocean_normal")[chosen] - normal).max() <= 2e-5
    near = levels(ob) == 0
    # A root of the cover: near 0 what is between samples by rounding alone is seen in it.
    power = sea.cover_power(time)
    foam = want(sea, "foam", ob, camera, 0, near, time)
    assert np.abs(attribute(ob, "foam")[near] ** power - foam**power).max() <= 2e-5
    cover = want(sea, "cover", ob, camera, 0, near, time)
    assert np.abs(attribute(ob, "cover")[near] - cover).max() <= 2e-5


@pytest.mark.parametrize(
    ("period", "camera"), [*((ROUND, camera) for camera in CAMERAS), (ODD, CAMERAS[-1])]
)
def test_each_ring_shows_the_map_of_its_resolution(scene, horizon, period, camera):
    ob, sea = horizon(period, camera=camera, past=1.0)
    for frame in FRAMES:
        scene.frame_set(frame)
        assert_rings(ob, sea, camera, (frame - 1) / 24)


def test_it_stays_in_the_world_while_its_object_moves(scene, horizon):
    ob, sea = horizon()
    ob.location = (333.0, -45.0, 0.0)
    scene.frame_set(10)
    assert_rings(ob, sea, (37.1, -12.9), 9 / 24)


def test_it_stays_in_the_world_while_its_object_turns(scene, horizon):
    ob, _ = horizon()
    ob.location = (310.3, -77.7, 0.0)
    bpy.context.view_layer.update()
    scene.frame_set(40)
    level, velocity = positions(ob).copy(), attribute(ob, "ocean_velocity").copy()
    ob.rotation_euler = (0.0, 0.0, 0.7)
    bpy.context.view_layer.update()
    scene.frame_set(40)
    turn = np.array(ob.matrix_world.to_3x3())
    assert np.abs(positions(ob) - level).max() > 100.0
    # A turn there and back loses the last bits of 5 km.
    assert np.abs(positions(ob) @ turn.T - level).max() < 5e-3
    near = np.abs(level[:, :2]).max(axis=1) < 500.0
    assert np.abs((positions(ob) @ turn.T - level)[near]).max() < 5e-4
    assert np.abs(attribute(ob, "ocean_velocity") @ turn.T - velocity)[near].max() < 1e-3


def test_a_file_holds_a_small_mesh_that_reaches_as_far(horizon, tmp_path):
    ob, _ = horizon()
    before = rest(ob)
    (mesh,) = meshes_in(save(tmp_path / "shot.blend"), "Ocean")
    assert 100 < len(mesh.vertices) <= 5000 < len(before)
    assert max(vertex.co.x for vertex in mesh.vertices) >= 5000.0


def test_a_small_mesh_of_an_earlier_version_becomes_whole(horizon, tmp_path):
    """It had the words that a whole one is made of, and nothing else."""
    ob, _ = horizon()
    before, rings = rest(ob), attribute(ob, ring_nodes.RING).copy()
    words = meshes.made_of(ob.data)
    small = dataclasses.replace(horizon_mesh.Horizon.of(words), most_vertices=500)
    meshes.make_again(ob.data, f"stored {words}", small.fill)
    ob.data.vertices[7].co.z = 1.0  # nothing that this version would store
    ob = opened(save(tmp_path / "shot.blend"), "Ocean", 10)
    assert np.array_equal(rest(ob), before)
    assert np.array_equal(attribute(ob, ring_nodes.RING), rings)


def test_undo_and_redo_pass_a_save(scene, horizon, tmp_path):
    ob, sea = horizon()
    scene.frame_set(10)
    seen = []
    for seed in (1, 7):
        ob.libocean.seed = seed
        push(f"seed {seed}")
        seen.append(positions(ob).copy())
    save(tmp_path / "shot.blend")
    for step, want in ((bpy.ops.ed.undo, seen[0]), (bpy.ops.ed.redo, seen[1])):
        step()
        assert np.array_equal(positions(bpy.data.objects["Ocean"]), want)
    bpy.ops.ed.undo()
    ob = reopened(tmp_path / "shot.blend", "Ocean")
    assert_rings(ob, sea, (37.1, -12.9), 9 / 24)


def _move(ob):
    ob.data.vertices[7].co.z = 1.0


def _paint(ob):
    ob.data.attributes.new("still", "FLOAT", "POINT")


def _group(ob):
    ob.vertex_groups.new(name="still").add([7], 1.0, "REPLACE")


def _share(ob):
    bpy.data.objects.new("Copy", ob.data)


@pytest.mark.parametrize("edit", [_move, _paint, _group, _share])
def test_a_horizon_that_was_edited_is_stored_whole(horizon, tmp_path, edit):
    ob, _ = horizon()
    edit(ob)
    before, layers = rest(ob), len(ob.data.attributes)
    path = save(tmp_path / "shot.blend")
    assert len(meshes_in(path, "Ocean")[0].vertices) == len(before)
    ob = opened(path, "Ocean")
    assert np.array_equal(rest(ob), before)
    assert len(ob.data.attributes) == layers


def test_a_horizon_is_whole_after_its_file_was_not_written(horizon, tmp_path):
    ob, _ = horizon()
    before = rest(ob)
    failing(bpy.ops.wm.save_as_mainfile, filepath=str(tmp_path / "none" / "shot.blend"))
    bpy.context.view_layer.update()
    assert np.array_equal(rest(ob), before)
    assert [mesh.name for mesh in bpy.data.meshes] == ["Ocean"]


@pytest.mark.parametrize("how", ["appended", "linked", "overridden"])
def test_a_horizon_from_another_file_is_whole(scene, horizon, tmp_path, how):
    ob, _ = horizon()
    before = rest(ob)
    path = save(tmp_path / "shot.blend")
    empty()
    with bpy.data.libraries.load(str(path), link=how != "appended") as (_, into):
        into.objects = ["Ocean"]
    ob = into.objects[0]
    if how == "overridden":
        ob = ob.override_create(remap_local_usages=True)
    bpy.context.collection.objects.link(ob)
    bpy.context.view_layer.update()
    assert np.array_equal(rest(ob), before)
    bpy.ops.wm.open_mainfile(filepath=str(save(tmp_path / "another.blend")))
    (ob,) = bpy.context.scene.collection.objects
    assert np.array_equal(rest(ob), before)
    assert np.ptp(positions(ob)[:, 2]) > 0.5


def test_a_modifier_that_was_removed_comes_back(scene, horizon):
    ob, sea = horizon()
    ob.modifiers.clear()
    assert bpy.ops.libocean.add_modifier() == {"FINISHED"}
    assert ob.libocean.problem == ""
    scene.frame_set(10)
    assert_rings(ob, sea, (37.1, -12.9), 9 / 24)


def test_a_patch_becomes_a_horizon_and_a_patch_again(scene, horizon):
    ob, sea = horizon()
    ob.libocean.kind = "PATCH"
    assert ob.libocean.problem == "" and len(ob.data.vertices) == 65**2
    ob.libocean.kind = "HORIZON"
    assert ob.libocean.problem == ""
    scene.frame_set(10)
    assert_rings(ob, sea, (37.1, -12.9), 9 / 24)


def test_a_mesh_of_the_user_is_never_replaced_by_a_horizon(scene):
    ob = plane(10.0, 4)
    with presets_with(resolution=64, **NO_PAST):
        bpy.ops.libocean.add_modifier()
    before = rest(ob)
    ob.libocean.kind = "HORIZON"
    assert "mesh of your own" in ob.libocean.problem
    scene.frame_set(2)
    assert np.array_equal(rest(ob), before)
    ob.libocean.kind = "MESH"
    assert ob.libocean.problem == ""


def test_what_fails_in_a_handler_is_said_in_the_panel_and_once_in_the_log(
    scene, horizon, monkeypatch, capfd
):
    ob, _ = horizon()

    def fail(*_rest, **_settings):
        raise KeyError("out of order")

    monkeypatch.setattr(failures, "_logged", set())
    with monkeypatch.context() as patch:
        patch.setattr(live, "_set_inputs", fail)
        for frame in (2, 3):
            scene.frame_set(frame)
    assert "out of order" in ob.libocean.problem
    assert capfd.readouterr().err.count("Traceback") == 1
    scene.frame_set(4)
    assert ob.libocean.problem == ""


def faces_of(mesh) -> list[tuple[int, ...]]:
    return [tuple(face.vertices) for face in mesh.polygons]


def signed_areas(mesh, places: np.ndarray) -> np.ndarray:
    """Returns the areas of the faces, seen from above."""
    areas = []
    for face in faces_of(mesh):
        x, y = places[list(face), 0], places[list(face), 1]
        areas.append(0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1)))
    return np.array(areas)


@pytest.mark.parametrize("camera", CAMERAS[1:])
def test_the_rings_are_one_sheet_without_folds(scene, horizon, camera):
    ob, _ = horizon(wind=0.0, camera=camera)
    scene.frame_set(2)
    mesh, places = evaluated_mesh(ob), positions(ob).astype(np.float64)
    edges = Counter(
        frozenset(pair)
        for face in faces_of(mesh)
        for pair in zip(face, face[1:] + face[:1], strict=True)
    )
    alone = [edge for edge, faces in edges.items() if faces == 1]
    reach = np.abs(rest(ob)[:, :2]).max(axis=1)
    assert all(reach[list(edge)].min() == reach.max() for edge in alone)
    assert max(edges.values()) == 2
    areas = signed_areas(mesh, places)
    assert areas.min() > 0.0
    side = 2.0 * reach.max()
    assert areas.sum() == pytest.approx(side * side, rel=1e-6)  # nothing covered twice
    assert len(mesh.vertices) <= 20000
    assert reach.max() >= 5000.0


def test_the_sheet_is_where_the_camera_is_at_every_frame(scene, horizon):
    ob, sea = horizon()
    keyed(scene.camera, location={1: (0.0, 0.0, 5.0), 11: (900.0, 0.0, 5.0)})
    scene.frame_set(11)
    assert_rings(ob, sea, (900.0, 0.0), 10 / 24)


def test_the_waves_stay_while_the_camera_moves(scene, horizon):
    ob, _ = horizon()
    scene.frame_set(10)
    before = {tuple(p) for p in np.round(positions(ob)[levels(ob) == 0], 2)}
    scene.camera.location.x += 50.0
    after = {tuple(p) for p in np.round(positions(ob)[levels(ob) == 0], 2)}
    assert len(before & after) > 0.3 * len(before)
    assert len(after - before) > 0.1 * len(before)


def test_the_far_sea_is_flat_and_its_slopes_become_roughness(scene, horizon):
    ob, sea = horizon()
    scene.frame_set(10)
    level = levels(ob)
    lost = attribute(ob, "slope_variance")
    asked = sea.state["mean_square_slope"]["asked"]
    shown = {m["resolution"]: m["mean_square_slope"] for m in sea.state["map_slopes"]}
    for ring in (0, 1, 3):
        assert lost[level == ring] == pytest.approx(asked - shown[64 >> ring], rel=1e-4)
    assert lost[level == level.max()] == pytest.approx(asked, rel=1e-4)
    assert np.abs(positions(ob)[level == level.max(), 2]).max() < 1e-4


def test_what_foam_hides_far_away_is_the_mean_of_what_it_hides_near(scene, horizon):
    ob, sea = horizon(wind=25.0, past=1.0)
    scene.frame_set(100)
    cover, level = attribute(ob, "cover"), levels(ob)
    mean = sea.surface(99 / 24).cover.mean()
    assert mean > 0.01
    assert cover[level >= 6] == pytest.approx(mean, rel=1e-3)
    foam = attribute(ob, "foam")[level >= 6]
    assert foam ** sea.cover_power(99 / 24) == pytest.approx(mean, rel=1e-3)


def test_what_is_averaged_stays_in_its_place():
    one = np.zeros((8, 8), np.float32)
    one[0, 4] = 1.0
    half = atlas.halved(one)
    assert half[0, 2] == 0.25
    assert half.sum() == 0.25
    one = np.roll(one, 1, axis=1)
    assert np.array_equal(atlas.halved(one)[0], np.float32([0, 0, 0.125, 0.125]))


def test_a_coarser_map_serves_the_near_rings(scene, horizon):
    ob, sea = horizon()
    ob.libocean.viewport_resolution = 32
    scene.frame_set(10)
    chosen = on_samples(ob, 1, ROUND / 64)
    got = positions(ob)[chosen] - at_rest(ob, (37.1, -12.9), 1, chosen, ROUND / 64)
    expected = want(sea, "displacement", ob, (37.1, -12.9), 1, chosen, 9 / 24)
    limit = 2e-5 * sea.state["significant_wave_height"]["resolved"]
    assert np.abs(got - expected).max() <= limit


def test_vertices_are_bounded_and_reach_the_horizon():
    for spacing in (0.02, 0.5, 4.0, 100.0):
        cells, rings = horizon_mesh.choose_rings(spacing, 1_500_000, 30_000.0)
        vertices, *_ = horizon_mesh.horizon(1.0, min(cells, 64), rings)
        assert cells % 8 == 0
        assert cells / 2 * spacing * 2 ** (rings - 1) >= 30_000.0
        count = (cells + 1) ** 2 + (rings - 1) * ((cells + 1) ** 2 - (cells // 2 + 1) ** 2)
        assert count <= 1_500_000
        if cells <= 64:
            assert len(vertices) == count
