# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spray in Blender is the library's: the same particles at every frame, over the mesh, blurred
along their way, and gone when it is off."""

import math
import threading

import bpy
import numpy as np
import other_blender
import pytest
from conftest import (
    add_horizon,
    add_ocean,
    camera,
    in_another_blender,
    keyed,
    light,
    opened,
    picture_settings,
    plane,
    rendered,
    save,
    sea_of,
    updates_of,
)
from libocean_addon.bundled import libocean
from libocean_addon.sea import live
from libocean_addon.shared import changes, drafts
from libocean_addon.spray import spray, spray_nodes

SIZE = 50.0


@pytest.fixture
def ocean(scene):
    """A small sea in a storm."""
    scene.render.engine = "CYCLES"  # which draws points in every version
    sea = {"patch_size": 300.0}
    ob = add_ocean(128, sea=sea, kind="PATCH", preset="beaufort_9", use_material=False)
    with changes.quiet():
        ob.libocean.spray_size = SIZE
    ob.libocean.use_spray = True
    return ob


def points(ocean) -> dict[str, np.ndarray]:
    """The attributes of the points beside an ocean's mesh, as evaluated."""
    graph = bpy.context.evaluated_depsgraph_get()
    clouds = [
        instance.object.data
        for instance in graph.object_instances
        if instance.object.type == "POINTCLOUD" and instance.object.name == ocean.name
    ]
    assert len(clouds) <= 1
    found = {}
    for attribute in clouds[0].attributes if clouds else ():
        if attribute.name not in ("position", *spray_nodes.ATTRIBUTES):
            continue
        vector = attribute.data_type == "FLOAT_VECTOR"
        kind = np.int32 if attribute.data_type == "INT" else np.float32
        values = np.empty(len(attribute.data) * (3 if vector else 1), kind)
        attribute.data.foreach_get("vector" if vector else "value", values)
        found[attribute.name] = values.reshape(-1, 3) if vector else values
    return found


def low_bits(ids) -> np.ndarray:
    return (ids & 0xFFFFFFFF).astype(np.uint32).view(np.int32)


def over(xy, low, period: float) -> np.ndarray:
    """The copies of places that lie in the period from a corner on."""
    return low + np.mod(xy - low, period)


def assert_is_spray(ocean, time: float, low=(-150.0, -150.0), shown=None, **settings) -> None:
    """All of the library's particles and no others, in single precision, over the period of 300 m
    from a corner on. shown: other points than the ocean has."""
    with sea_of(ocean) as sea:
        expected = sea.spray(time, **settings)
    shown = shown or points(ocean)
    assert len(expected.id) > 100
    assert len(shown["id"]) == len(expected.id)
    ours, theirs = np.argsort(shown["id"]), np.argsort(low_bits(expected.id))
    assert np.array_equal(shown["id"][ours], low_bits(expected.id)[theirs])
    place = expected.position.copy()
    place[:, :2] = over(place[:, :2], np.array(low), 300.0)
    assert np.abs(shown["position"][ours] - place[theirs]).max() <= 2.0**-23 * np.abs(place).max()
    for name in ("velocity", "age", "life"):
        assert np.array_equal(shown[name][ours], getattr(expected, name)[theirs]), name
    assert shown["radius"][ours] == pytest.approx(SIZE * expected.radius[theirs], rel=1e-6)


def noted_sprays(monkeypatch) -> list:
    """Returns a list that receives the thread of each spray that is made from now on."""
    makers, make = [], libocean.Sea.spray

    def noting(sea, *arguments, **settings):
        makers.append(threading.current_thread())
        return make(sea, *arguments, **settings)

    monkeypatch.setattr(libocean.Sea, "spray", noting)
    return makers


def test_the_points_are_the_librarys_particles(scene, ocean):
    for frame in (49, 50, 20):
        scene.frame_set(frame)
        assert_is_spray(ocean, (frame - 1) / 24)


def test_a_particle_keeps_its_id_from_frame_to_frame(scene, ocean):
    scene.frame_set(49)
    before = points(ocean)
    scene.frame_set(50)
    after = points(ocean)
    _, old, new = np.intersect1d(before["id"], after["id"], return_indices=True)
    assert len(old) > 0.9 * len(before["id"])
    assert np.array_equal(before["life"][old], after["life"][new])
    moved = after["position"][new] - before["position"][old]
    moved[:, :2] = over(moved[:, :2], -150.0, 300.0)  # one that leaves the patch comes in again
    mean = (before["velocity"][old] + after["velocity"][new]) / 2
    assert np.abs(moved - mean / 24).max() < 0.1  # drops of that size are slowed down fast


def test_keyframes_and_the_seas_own_time_are_followed(scene, ocean):
    settings = ocean.libocean
    settings.use_custom_time = True
    keyed(settings, custom_time={1: 5.0, 11: 7.0}, spray_density={1: 0.25, 11: 1.0})
    counts = []
    for frame in (1, 11):
        scene.frame_set(frame)
        time, density = settings.custom_time, settings.spray_density
        assert_is_spray(ocean, time, density=density)
        counts.append(len(points(ocean)["id"]))
    assert (time, density) == (7.0, 1.0)
    assert counts[1] > 2 * counts[0]


def test_a_change_of_the_sea_and_of_the_settings(scene, ocean):
    scene.frame_set(50)
    ocean.libocean.seed = 7
    ocean.libocean.spray_lifetime = 0.5
    assert points(ocean)["life"].max() <= 0.5
    assert_is_spray(ocean, 49 / 24, lifetime=0.5)
    before = points(ocean)["radius"]
    ocean.libocean.spray_size = 2.0 * SIZE
    assert points(ocean)["radius"] == pytest.approx(2.0 * before, rel=1e-6)


# Where the object is --------------------------------------------------------------


def test_an_ocean_that_is_moved_is_anchored_to_the_world(scene, ocean):
    ocean.location, ocean.scale = (470.0, -80.0, 3.0), (2.0, 2.0, 2.0)
    scene.frame_set(50)
    shown = points(ocean)
    # The object's own axes: scale and height are its matrix's.
    shown["position"] = shown["position"] + np.float32((470.0, -80.0, 0.0))
    assert_is_spray(ocean, 49 / 24, (320.0, -230.0), shown)
    ocean.libocean.follow_world = False
    assert_is_spray(ocean, 49 / 24)


def test_over_a_turned_mesh_of_any_size_lie_copies(scene):
    """A rectangle of one period and a half by one, turned: as many as its area has, all over it,
    each at the place of a particle or of its copy a period on."""
    scene.render.engine = "CYCLES"
    ob = plane(300.0, 61)
    ob.scale.x = 1.5
    bpy.ops.object.transform_apply(scale=True)
    bpy.ops.libocean.add_modifier()
    bpy.ops.libocean.load_preset(preset="beaufort_9")
    ob.libocean.resolution, ob.libocean.patch_size = 128, 300.0
    ob.location, ob.rotation_euler.z = (470.0, -80.0, 0.0), math.radians(37)
    ob.libocean.use_spray = True
    scene.frame_set(50)
    shown = points(ob)
    with sea_of(ob) as sea:
        expected = sea.spray(49 / 24)
    place = shown["position"].astype(float)
    assert (np.abs(place[:, :2]) <= (225.001, 150.001)).all()
    assert place[:, 0].min() < -215.0
    assert place[:, 0].max() > 215.0
    turn = np.array(ob.matrix_world.to_3x3(), float)
    world = place @ turn.T + (470.0, -80.0, 0.0)
    known = dict(zip(low_bits(expected.id).tolist(), range(len(expected.id)), strict=True))
    rows = [known[number] for number in shown["id"].tolist()]
    off = world - expected.position[rows]
    off[:, :2] = over(off[:, :2], -150.0, 300.0)
    assert np.abs(off).max() < 1e-3
    velocity = shown["velocity"] @ turn.T
    assert np.abs(velocity - expected.velocity[rows]).max() < 1e-4
    assert 1.3 < len(rows) / len(expected.id) < 1.7
    # Every particle is there once or twice, and none at one place twice.
    assert set(rows) == set(range(len(expected.id)))
    assert len(np.unique(np.round(place, 3), axis=0)) == len(place)


def test_a_horizon_has_it_around_the_camera(scene):
    camera(scene, (1000.0, 200.0, 5.0))
    scene.render.engine = "CYCLES"
    ob = add_horizon(128, 5000, sea={"patch_size": 300}, preset="beaufort_9", use_material=False)
    ob.libocean.spray_size = SIZE
    ob.libocean.use_spray = True
    scene.frame_set(50)
    assert_is_spray(ob, 49 / 24, (850.0, 50.0))


@pytest.mark.skipif(bpy.app.version >= (4, 2), reason="Eevee draws points")
def test_where_eevee_draws_no_points_there_are_spheres(scene, ocean):
    scene.frame_set(50)
    shown = points(ocean)
    scene.render.engine = "BLENDER_EEVEE"
    scene.frame_set(51)
    scene.frame_set(50)
    assert points(ocean) == {}
    graph = bpy.context.evaluated_depsgraph_get()
    places = np.array(
        [
            np.array(instance.matrix_world)  # of which there is one, for all
            for instance in graph.object_instances
            if instance.is_instance and instance.object.type == "MESH"
        ]
    )
    assert np.array_equal(places[:, :3, 3], shown["position"])
    assert places[:, 0, 0] == pytest.approx(shown["radius"], rel=1e-5)


# Off, and nothing to show -----------------------------------------------------------


def test_off_means_gone(scene, ocean):
    objects, meshes = len(bpy.data.objects), len(bpy.data.meshes)
    ocean.libocean.use_spray = False
    assert points(ocean) == {}
    assert spray_nodes.modifier_of(ocean) is None
    assert (len(bpy.data.objects), len(bpy.data.meshes)) == (objects - 1, meshes - 1)
    ocean.libocean.use_spray = True
    ocean.modifiers.remove(live.node_group.modifiers(ocean)[0])
    scene.frame_set(3)
    assert points(ocean) == {}


def test_a_calm_sea_has_none_and_says_why(scene, ocean):
    bpy.ops.libocean.load_preset(preset="beaufort_3")
    assert points(ocean).get("id", np.empty(0)).size == 0
    assert "above 7 m/s" in spray.state_of(ocean)[0]
    ocean.libocean.waves[0].wind_speed = 20.0
    assert points(ocean)["id"].size > 0
    assert f"{points(ocean)['id'].size:,} points" == spray.state_of(ocean)[0]
    ocean.libocean.loop_period = 3.0
    assert "max age 1.5 s: half of the loop" in spray.state_of(ocean)[0]
    ocean.libocean.spray_density = 0.0
    assert points(ocean).get("id", np.empty(0)).size == 0
    assert "at this time" in spray.state_of(ocean)[0]


def test_what_the_library_refuses_is_told_and_shows_nothing(scene, ocean, monkeypatch):
    monkeypatch.setattr(
        live, "spray_settings", lambda _: {"lifetime": 99.0, "density": 1.0, "most": 1}
    )
    scene.frame_set(3)
    assert "lifetime = 99" in ocean.libocean.spray_problem
    assert spray.state_of(ocean) == (ocean.libocean.spray_problem, "ERROR")
    assert points(ocean).get("id", np.empty(0)).size == 0
    monkeypatch.undo()
    scene.frame_set(4)
    assert ocean.libocean.spray_problem == ""
    assert points(ocean)["id"].size > 0


# Copies, undo, files ----------------------------------------------------------------


def test_a_copy_has_spray_of_its_own(scene, ocean):
    scene.frame_set(50)
    twin = ocean.copy()
    bpy.context.collection.objects.link(twin)
    bpy.context.view_layer.update()
    twin.libocean.seed = 9
    for ob in (ocean, twin):
        assert_is_spray(ob, 49 / 24)
    bpy.data.objects.remove(ocean)
    scene.frame_set(51)
    assert_is_spray(twin, 50 / 24)


def test_undo_and_redo(scene, ocean):
    scene.frame_set(50)
    bpy.ops.ed.undo_push(message="before")
    ocean.libocean.use_spray = False
    bpy.ops.ed.undo_push(message="off")
    bpy.ops.ed.undo()
    assert_is_spray(bpy.data.objects["Ocean"], 49 / 24)
    bpy.ops.ed.redo()
    assert points(bpy.data.objects["Ocean"]) == {}


def test_a_saved_file_holds_no_points(scene, ocean, tmp_path):
    scene.frame_set(50)
    before = points(ocean)
    path = save(tmp_path / "storm.blend")
    assert np.array_equal(points(ocean)["position"], before["position"])  # it goes on being shown
    in_another_blender(other_blender.count_no_points, path)
    ocean = opened(path, "Ocean")
    assert np.array_equal(points(ocean)["position"], before["position"])
    assert np.array_equal(points(ocean)["id"], before["id"])


def test_a_bake_that_plays_has_it_live(scene, ocean, tmp_path):
    save(tmp_path / "storm.blend")
    bpy.ops.libocean.bake(frame_start=2, frame_end=2)
    assert ocean.libocean.use_bake
    ocean.libocean.seed = 7  # of the sea in the panel, not of the bake
    for frame in (2, 3):
        scene.frame_set(frame)
        assert_is_spray(ocean, (frame - 1) / 24)


# Hulls ------------------------------------------------------------------------------

BOAT = """libocean = 1
[grid]
resolution = 64
patch_size = 128.0
[surface]
foam_coverage = "threshold"
foam_threshold = 0.85
[[waves]]
wind_speed = 15.0
significant_wave_height = 0.05
[[hulls]]
length = 12.0
beam = 3.0
draught = 0.8
factor = 8.0
wake_resolution = 64
track = [[-60.0, -480.0, 10.0], [60.0, 480.0, 10.0]]
"""
REGION = {"lifetime": 0.3, "density": 2.0, "region": (-64.0, -64.0, 64.0, 64.0)}


@pytest.fixture
def waked(scene, tmp_path):
    """A boat on low waves, none of which breaks beside its wake."""
    scene.render.engine = "CYCLES"
    (tmp_path / "boat.toml").write_text(BOAT)
    ob = add_ocean(64, kind="PATCH", use_material=False)
    bpy.ops.libocean.load_sea(filepath=str(tmp_path / "boat.toml"))
    with changes.quiet():
        ob.libocean.spray_lifetime, ob.libocean.spray_density = REGION["lifetime"], 2.0
    ob.libocean.use_spray = True
    return ob


def assert_is_of_region(ocean, time: float, region=REGION) -> None:
    shown = points(ocean)
    with sea_of(ocean) as sea:
        expected = sea.spray(time, **region)
    inside = (np.abs(expected.position[:, :2] - np.array(ocean.location)[:2]) < 64.0).all(axis=1)
    assert inside.sum() > 20
    assert np.array_equal(np.sort(shown["id"]), np.sort(low_bits(expected.id[inside])))
    order = np.argsort(shown["id"]), np.argsort(low_bits(expected.id[inside]))
    place = shown["position"][order[0]] + np.array((*ocean.location[:2], 0.0))
    assert np.abs(place - expected.position[inside][order[1]]).max() < 1e-4


def test_the_wake_of_a_hull_throws_spray(scene, waked):
    for frame in (25, 26, 13):
        scene.frame_set(frame)
        assert_is_of_region(waked, (frame - 1) / 24)
    # A region lies on quarters of a period, so that a patch on its way keeps its particles.
    waked.location.x = 10.0
    scene.frame_set(25)
    assert_is_of_region(waked, 1.0, {**REGION, "region": (-64.0, -64.0, 96.0, 64.0)})
    waked.libocean.hulls.clear()
    changes.tell(waked.libocean)
    assert points(waked).get("id", np.empty(0)).size == 0


def test_the_spray_of_a_wake_is_made_behind_a_draft(scene, waked, monkeypatch):
    makers = noted_sprays(monkeypatch)
    monkeypatch.setattr(drafts, "allowed", True)
    waked.libocean.waves[0].wind_speed = 16.0
    assert points(waked).get("id", np.empty(0)).size == 0
    while drafts.step() is not None:
        pass
    assert makers[0] != threading.main_thread()
    assert_is_of_region(waked, 0.0)
    drafts.close()


# While somebody waits ----------------------------------------------------------------


def test_a_draft_has_none_and_it_comes_when_values_rest(scene, ocean, monkeypatch):
    makers = noted_sprays(monkeypatch)
    monkeypatch.setattr(drafts, "allowed", True)
    ocean.libocean.waves[0].wind_speed = 22.0
    assert points(ocean).get("id", np.empty(0)).size == 0
    while drafts.step() is not None:
        pass
    assert makers[0] != threading.main_thread()  # nobody waits for its beginning
    assert_is_spray(ocean, 0.0)
    # Time that plays goes on with it: the next frame has most of it already.
    monkeypatch.setattr(drafts, "is_playing", lambda: True)
    scene.frame_set(2)
    assert_is_spray(ocean, 1 / 24)
    drafts.close()


def test_nothing_is_written_while_nothing_moves(scene, ocean):
    """Each write would make Blender evaluate the scene again, and so on forever."""
    scene.frame_set(50)
    bpy.context.view_layer.update()
    assert updates_of(ocean, 3, lambda update: update.is_updated_geometry) == set()


# Rendered ---------------------------------------------------------------------------

WIDE = 160
VIEW = 8.0  # metres


def lone_drop(scene, ocean, engine: str) -> np.ndarray:
    """A camera on one fast particle of which no other is near, large, white, against black."""
    scene.frame_set(50)
    shown = points(ocean)
    place, velocity = shown["position"], shown["velocity"]
    inside = np.abs(place[:, :2]).max(axis=1) < 140.0
    young = shown["age"] < 0.5 * shown["life"]
    for number in np.argsort(-np.abs(velocity[:, 0]) * inside * young):
        near = np.abs(place[:, [0, 2]] - place[number, [0, 2]]).max(axis=1) < VIEW
        before = place[:, 1] < place[number, 1] + 1.0
        if (near & before & (np.abs(place[:, 1] - place[number, 1]) < 10.0)).sum() == 1:
            break
    eye = camera(scene, place[number] + (0.0, -10.0, 0.0), width=VIEW)
    eye.rotation_euler.x = math.pi / 2
    eye.data.clip_start, eye.data.clip_end = 0.1, 11.0  # the drop, and not the sea behind
    picture_settings(scene, WIDE, 32)
    scene.render.engine = engine
    scene.cycles.pixel_filter_type = "BOX"
    scene.world = bpy.data.worlds.new("Black")
    scene.world.color = (0.0, 0.0, 0.0)
    if scene.world.node_tree is not None:  # 5.0: a new one has nodes, and is grey
        scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0.0
    ocean.modifiers[0].show_render = False  # the mesh lies flat, below
    with sea_of(ocean) as sea:
        expected = sea.spray(49 / 24, density=ocean.libocean.spray_density)
    return expected.velocity[low_bits(expected.id) == shown["id"][number]][0]


def light_of(scene, path, *, blur: bool):
    scene.render.use_motion_blur = blur
    scene.render.motion_blur_shutter = 0.5
    light = rendered(scene, path)[..., 0].astype(np.float64)
    light /= light.sum()
    along = (np.arange(WIDE) + 0.5 - WIDE / 2) * (VIEW / WIDE)
    x = along - light.sum(axis=0) @ along
    z = along - light.sum(axis=1) @ along
    cross = z @ light @ x
    return np.array([[light.sum(axis=0) @ x**2, cross], [cross, light.sum(axis=1) @ z**2]])


def test_motion_blur_is_as_long_as_the_way(scene, ocean, tmp_path):
    ocean.libocean.spray_material = light()
    ocean.libocean.spray_density = 0.02
    ocean.libocean.spray_size = 500.0
    velocity = lone_drop(scene, ocean, "CYCLES")
    still = light_of(scene, tmp_path / "still.exr", blur=False)
    blurred = light_of(scene, tmp_path / "blurred.exr", blur=True)
    way = velocity[[0, 2]] * 0.5 / 24  # while the shutter is open
    # A point that moves by a way w at an even speed adds w w' / 12 to the covariance.
    added = 12 * (blurred - still)
    assert np.linalg.norm(way) > 0.2
    assert added == pytest.approx(np.outer(way, way), abs=0.06 * float(way @ way))


@pytest.mark.parametrize("engine", ["CYCLES", "EEVEE"])
def test_the_material_is_white_in_both_engines(scene, ocean, tmp_path, engine):
    if engine == "EEVEE":
        engines = bpy.types.RenderSettings.bl_rna.properties["engine"].enum_items.keys()
        engine = next(name for name in engines if name.startswith("BLENDER_EEVEE"))
    ocean.libocean.spray_density = 0.02
    ocean.libocean.spray_size = 2000.0
    lone_drop(scene, ocean, engine)
    sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    bpy.context.collection.objects.link(sun)
    sun.rotation_euler.x = math.pi / 2
    sun.data.energy = math.pi  # on white, face on: 1
    red, green, blue, _ = rendered(scene, tmp_path / "drop.exr")[WIDE // 2, WIDE // 2]
    assert red == pytest.approx(green, rel=1e-3)
    assert red == pytest.approx(blue, rel=1e-3)
    assert 0.3 < red < 0.6  # half of the light goes through
