# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every entry of the Add menus, in an empty scene and in that of the start-up file: it says nothing
of itself, its camera stands outside of all objects and sees them to the end, undo takes it back."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from conftest import NO_PAST, factory_settings, presets_with, push
from libocean_addon.bundled import libocean
from libocean_addon.coast import bed_sea, coast_job, first_coast
from libocean_addon.look import framing
from libocean_addon.sea import facts as sea_facts
from libocean_addon.sea import hints
from libocean_addon.sea import node_group as sea_group
from libocean_addon.shared import drafts
from libocean_addon.terrain import facts as terrain_facts
from libocean_addon.terrain import node_group as terrain_group
from mathutils import Vector

SCENES = ["libocean.add_coast_scene", "libocean.add_scene", "libocean.add_terrain_scene"]


def entries(menu: str) -> list[str]:
    """Returns the operators that the add-on draws in a menu."""
    found = []
    layout = SimpleNamespace(operator=lambda name, **_looks: found.append(name))
    for draw in getattr(bpy.types, menu)._dyn_ui_initialize():
        if draw.__module__.startswith("libocean_addon"):
            draw(SimpleNamespace(layout=layout), bpy.context)
    return sorted(found)


ENTRIES = [*entries("VIEW3D_MT_add"), *entries("VIEW3D_MT_mesh_add")]


def names() -> set[str]:
    return {ob.name for ob in bpy.data.objects}


def said_of(ob) -> list[str]:
    """Returns the problem and the warnings in the panels of an object. Those of the default coast
    are in test_coast: with few samples it has others."""
    seen = ob.evaluated_get(bpy.context.evaluated_depsgraph_get())
    said = [ob.libocean.problem, ob.libocean_coast.problem, ob.libocean_terrain.problem]
    if sea_group.modifiers(ob):
        said += [*sea_facts.warnings_of(ob), *hints.of_object(ob, seen)]
    elif terrain_group.modifiers(ob):
        said += [
            *terrain_facts.warnings_of(ob),
            *terrain_facts.hints_of(ob, seen, bpy.context.scene),
        ]
    return [text for text in said if text]


def assert_camera_is_outside(scene) -> None:
    place = scene.camera.matrix_world.translation
    graph = bpy.context.evaluated_depsgraph_get()
    assert not scene.ray_cast(graph, place, Vector((0, 0, 1)))[0], "under land or water"
    hit, below, *_ = scene.ray_cast(graph, place, Vector((0, 0, -1)))
    assert hit and (place - below).length > 1.0


def assert_nothing_is_clipped(scene) -> None:
    camera = scene.camera
    corners = [
        ob.matrix_world @ Vector(corner)
        for ob in scene.objects
        if ob.type == "MESH"
        for corner in ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).bound_box
    ]
    away = [(corner - camera.matrix_world.translation).length for corner in corners]
    assert max(away) < camera.data.clip_end


def test_the_menus_have_a_scene_for_each_subject():
    assert entries("VIEW3D_MT_add") == SCENES
    assert {"libocean.add", "libocean.add_terrain", "libocean.add_coast"} <= set(ENTRIES)


MESHES = [pytest.param(entry, True, marks=pytest.mark.slow) for entry in ENTRIES[len(SCENES) :]]


@pytest.mark.parametrize(
    ("entry", "is_empty"),
    [*((entry, False) for entry in ENTRIES), *((entry, True) for entry in SCENES), *MESHES],
)
def test_an_entry_is_a_picture_and_is_undone(entry, is_empty, small_coast, waiting, tmp_path):
    factory_settings(use_empty=is_empty)
    drafts.allowed = entry == "libocean.add_scene"  # whose whole mesh takes seconds
    before = names()
    push()
    arguments = {}
    if entry == "libocean.add_terrain_file":
        with libocean.terrain_preset("tujunga") as terrain:
            (tmp_path / "land.toml").write_text(terrain.text, encoding="utf-8")
        arguments = {"filepath": str(tmp_path / "land.toml")}
    add = getattr(bpy.ops.libocean, entry.split(".")[1])
    with presets_with(resolution=64, **NO_PAST):
        assert add("EXEC_DEFAULT", True, **arguments) == {"FINISHED"}
    scene = bpy.context.scene
    bpy.context.view_layer.update()
    assert said_of(bpy.context.object) == []
    if entry in SCENES:
        assert not names() & before, "the start-up file is in the way"
        assert_camera_is_outside(scene)
        assert_nothing_is_clipped(scene)
    else:
        assert names() >= before
    bpy.ops.ed.undo()
    assert names() == before
    assert (bpy.context.scene.camera is None) == is_empty


def test_the_view_of_the_island_is_over_its_surf():
    with libocean.parse(first_coast.values().text()) as sea:
        extent = bed_sea.extent_of(sea.get("seabed_origin"), sea.state)
        ground = framing.of_bed(coast_job.make_bed(sea, extent), extent)
        travel = sea.state["mean_direction"]["resolved"]
    eye = framing.shore_eye(ground, travel)
    place = np.array(eye.place)
    assert place[2] > ground.highest_within(place[:2], 25.0) + 8.0
    away = np.linspace(0.0, 400.0, 100)
    is_land = []
    for turn in np.radians(eye.heading + np.linspace(-30.0, 30.0, 13)):
        ray = ground.sample(
            ground.heights, place[0] + away * np.cos(turn), place[1] + away * np.sin(turn)
        )
        is_land.append((ray > 0.0).any())
    assert 3 <= sum(is_land) <= 10, "sea on one side, land on the other"


def test_without_a_shore_the_view_is_against_the_waves():
    flat = framing.Ground(np.full((32, 32), -20.0), (0.0, 0.0), 10.0, False)
    eye = framing.shore_eye(flat, 30.0)
    assert eye.heading == 210.0 and eye.place[:2] == (160.0, 160.0) and eye.place[2] > 1.0


def test_the_view_of_a_land_is_above_it_and_sees_far():
    x, y = np.meshgrid(np.arange(64), np.arange(64))
    ridges = 100.0 * np.sin(x / 10.0) * np.cos(y / 7.0)
    ground = framing.Ground(ridges, (0.0, 0.0), 20.0, False)
    eye = framing.relief_eye(ground)
    assert eye.place[2] > ground.highest_within(np.array(eye.place[:2]), 20.0)
    ahead = np.radians(eye.heading)
    places = np.array(eye.place[:2])[:, None] + np.outer(
        (np.cos(ahead), np.sin(ahead)), np.linspace(30.0, 500.0, 50)
    )
    rise = ground.sample(ground.heights, *places) - eye.place[2]
    assert rise[:5].max() < 0.0 and (rise / np.linspace(30.0, 500.0, 50)).max() < 0.25
