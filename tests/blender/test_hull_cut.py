# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The water inside the objects that make a wake is marked on the points, and the ocean material
leaves it out: in an open boat one sees its floor."""

import bpy
import numpy as np
import pytest
from conftest import add_ocean, attribute, keyed, positions, push, reopened
from libocean_addon.look import material
from libocean_addon.sea import hull_nodes, hull_outline
from libocean_addon.shared import compat, modifier_groups

LENGTH, WIDTH, TOP, BOTTOM = 16.0, 6.0, 2.0, -1.0


@pytest.fixture
def ocean(scene):
    scene.frame_end = 49
    ob = add_ocean(64, kind="PATCH", sea={"patch_size": 64.0})
    # Waves of any height would hide what the box hides.
    ob.libocean.waves[0].wind_speed = 3.0
    return ob


def trough(
    name="Boat", place=(0.0, 4.0), turn=0.0, *, size=(LENGTH, WIDTH), way=12.0, frames=(1, 49)
):
    """A box without a lid, whose length lies along x: it moves twice a way [m] in these frames."""
    bpy.ops.object.select_all(action="DESELECT")
    x, y = size[0] / 2, size[1] / 2
    corners = [(a * x, b * y, z) for z in (BOTTOM, TOP) for a in (-1, 1) for b in (-1, 1)]
    faces = [(0, 1, 3, 2), (0, 2, 6, 4), (1, 5, 7, 3), (0, 4, 5, 1), (2, 3, 7, 6)]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(corners, [], faces)
    ob = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(ob)
    ob.rotation_euler.z = turn
    half = way * np.array([np.cos(turn), np.sin(turn)])
    ends = (np.array(place) - half, np.array(place) + half)
    keyed(ob, location={frame: (*end, 0.0) for frame, end in zip(frames, ends, strict=True)})
    for curve in compat.curves_of(ob.animation_data):
        for key in curve.keyframe_points:
            key.interpolation = "LINEAR"
    ob.select_set(True)
    bpy.context.view_layer.objects.active = ob
    return ob


def add_boat(ocean, **arguments):
    """Adds one that makes a small wake: over its floor and below its edge."""
    ob = trough(**arguments)
    assert bpy.ops.libocean.add_wake(ocean=ocean.name) == {"FINISHED"}
    ocean.libocean.hulls[-1].factor = 0.05
    return ob


@pytest.fixture
def boat(ocean):
    return add_boat(ocean)


def within(ocean, boat) -> np.ndarray:
    """Returns by how much each vertex lies within the sides of a boat; negative outside [m]."""
    to_boat = np.array(boat.matrix_world.inverted() @ ocean.matrix_world)
    place = positions(ocean) @ to_boat[:3, :3].T + to_boat[:3, 3]
    return np.minimum(LENGTH / 2 - np.abs(place[:, 0]), WIDTH / 2 - np.abs(place[:, 1]))


def test_what_is_inside_is_dry(scene, ocean, boat):
    for frame in (1, 25, 40, 1):
        scene.frame_set(frame)
        inside = within(ocean, boat)
        wanted = np.clip(0.5 + inside / (0.1 * WIDTH), 0.0, 1.0)
        dry = attribute(ocean, "dry")
        assert np.abs(dry - wanted).max() < 2e-3 and (dry == 1.0).sum() > 50
    ocean.libocean.use_hull_cut = False
    with pytest.raises(KeyError):
        attribute(ocean, "dry")
    ocean.libocean.use_hull_cut = True
    assert (attribute(ocean, "dry") == dry).all()


def test_it_turns_with_the_boat_on_a_turned_ocean(scene, ocean):
    ocean.rotation_euler.z, ocean.location.x = 0.4, 5.0
    boat = add_boat(ocean, turn=1.1)
    scene.frame_set(30)
    inside, dry = within(ocean, boat), attribute(ocean, "dry")
    assert (dry[inside > 0.5] == 1.0).all() and (dry[inside < -0.5] == 0.0).all()
    assert (inside > 0.5).sum() > 50


def test_two_boats_side_by_side_are_both_dry_and_the_water_between_them_is_not(scene, ocean, boat):
    other = add_boat(ocean, name="Other", place=(0.0, 4.0 + 1.5 * WIDTH))
    scene.frame_set(25)
    inside = np.maximum(within(ocean, boat), within(ocean, other))
    dry, hull = attribute(ocean, "dry"), attribute(ocean, hull_nodes.HULL)
    wanted = np.clip(0.5 + inside / (0.1 * WIDTH), 0.0, 1.0)
    assert np.abs(dry - wanted).max() < 2e-3
    numbers = np.rint(hull[:, 0] / 256.0)
    assert set(numbers[inside > 0.0]) == {1.0, 2.0}


def test_files_and_undo_keep_it(scene, ocean, boat, tmp_path):
    scene.frame_set(10)
    dry = attribute(ocean, "dry")
    push("wake")
    bpy.context.view_layer.objects.active = ocean
    ocean.select_set(True)
    assert bpy.ops.libocean.remove_wake() == {"FINISHED"}
    with pytest.raises(KeyError):
        attribute(ocean, "dry")
    push("removed")
    bpy.ops.ed.undo()
    ocean = reopened(tmp_path / "boat.blend", "Ocean", 10)
    assert (attribute(ocean, "dry") == dry).all()
    (modifier,) = ocean.modifiers
    assert modifier_groups.value(modifier, "Hull 1") == bpy.data.objects["Boat"]
    bpy.data.objects.remove(bpy.data.objects["Boat"])
    scene = bpy.context.scene
    scene.frame_set(11)
    with pytest.raises(KeyError):
        attribute(ocean, "dry")


def lit(scene, path) -> np.ndarray:
    """Returns a rendered picture, (rows, columns, 3)."""
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(str(path))
    pixels = np.empty(len(image.pixels), np.float32)
    image.pixels.foreach_get(pixels)
    return pixels.reshape(image.size[1], image.size[0], 4)[..., :3]


def test_an_open_boat_from_above_holds_no_water(scene, ocean, boat, tmp_path):
    """Its floor, which the water would cover, glows red."""
    red = bpy.data.materials.new("Red")
    compat.use_nodes(red)
    red.node_tree.nodes.clear()
    glow = red.node_tree.nodes.new("ShaderNodeEmission")
    glow.inputs["Color"].default_value = (1.0, 0.0, 0.0, 1.0)
    output = red.node_tree.nodes.new("ShaderNodeOutputMaterial")
    red.node_tree.links.new(glow.outputs[0], output.inputs["Surface"])
    boat.data.materials.append(red)
    ocean.libocean.hulls[0].trail_lifetime = 0.0  # foam would be lit by the boat
    ocean.data.materials.clear()
    ocean.data.materials.append(material.make("jerlov_ii"))
    scene.frame_set(25)
    bpy.ops.object.camera_add(location=(*boat.matrix_world.translation.xy, 30.0))
    camera = scene.camera = bpy.context.object
    camera.data.type, camera.data.ortho_scale = "ORTHO", 24.0
    scene.render.engine, scene.cycles.samples = "CYCLES", 4
    scene.cycles.use_denoising = False
    scene.render.resolution_x = scene.render.resolution_y = 48
    scene.view_settings.view_transform = "Standard"
    picture = lit(scene, tmp_path / "cut.png")
    is_red = (picture[..., 0] > 0.7) & (picture[..., 1] < 0.2)
    columns, rows = (np.abs(np.arange(48) - 23.5) * 0.5,) * 2
    inside = (columns[None, :] < LENGTH / 2 - 0.5) & (rows[:, None] < WIDTH / 2 - 0.5)
    assert is_red[inside].all()
    outside = (columns[None, :] > LENGTH / 2 + 1.0) | (rows[:, None] > WIDTH / 2 + 1.0)
    assert not is_red[outside].any()
    ocean.libocean.use_hull_cut = False
    picture = lit(scene, tmp_path / "whole.png")
    assert not ((picture[..., 0] > 0.7) & (picture[..., 1] < 0.2))[inside].any()


def test_an_outline_narrows_with_the_hull_and_never_over_the_water():
    """A wedge: its sides meet in the keel, and lean in over the water again."""
    profile = ((-1.0, 0.0), (0.0, 1.0), (1.0, 0.5))
    sides = [(x, sign * y, z) for x in (0.0, 4.0) for sign in (-1, 1) for z, y in profile]
    quads = [(n, n + 1, n + 7, n + 6) for n in (0, 1, 3, 4)]
    corners = np.array(sides)[[c for a, b, c, d in quads for c in ((a, b, c), (a, c, d))]]
    outline = hull_outline.of_triangles(corners, 0.0)
    half = np.array(outline.high)[:, 30]
    z = np.linspace(-0.5, 1.0, hull_outline.LEVELS)
    assert (outline.begin[2], *outline.size) == pytest.approx((-0.5, 4.0, 2.0, 1.5))
    assert half == pytest.approx(np.minimum(1.0 + z, half.max()), abs=1e-3)
    assert half.max() > 0.9
    assert np.array(outline.low)[:, 30] == pytest.approx(-half)
    assert hull_outline.of_triangles(corners, 2.0) is None
    assert hull_outline.read(outline.text()) == outline and hull_outline.read("") is None
