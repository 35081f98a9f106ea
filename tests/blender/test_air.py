# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The haze of the material: the share of shaders/wave/haze.glsl, and the light of the sky that is
there, in tiny renders."""

import math

import bpy
import numpy as np
import other_blender
import pytest
from conftest import in_another_blender, keyed, plane, save
from libocean_addon.look import air, first_view, material, water_shader
from libocean_addon.shared import compat
from test_material import (
    BLACK,
    EEVEE,
    light_all_round,
    seen,
    studio,  # noqa: F401 (for each test here too)
    water,
)

VISIBILITY = 20000.0
AIR = np.array((0.5, 0.6, 0.8))


def look_far(scene, distance: float) -> None:
    """At the origin, from 10 degrees above the horizon; all rays of the picture are parallel."""
    angle = math.radians(80.0)
    scene.camera.data.clip_end = 1e6
    scene.camera.rotation_euler = (angle, 0.0, 0.0)
    scene.camera.location = (0.0, -distance * math.sin(angle), distance * math.cos(angle))


def share(distance: float) -> float:
    return 1.0 - math.exp(-3.912 * distance / VISIBILITY)


@pytest.mark.parametrize("engine", ["CYCLES", EEVEE])
@pytest.mark.parametrize("distance", [100.0, 3000.0, 20000.0])
def test_the_air_hides_what_haze_glsl_says(scene, tmp_path, distance, engine):
    scene.render.engine = engine
    ob = plane(1e5, 2)
    light_all_round(scene, (0.2, 0.1, 0.05))
    look_far(scene, distance)
    water(ob)
    clear = seen(scene, tmp_path)
    water(ob, Visibility=VISIBILITY, Air_Light=(*AIR, 1.0))
    want = clear + share(distance) * (AIR - clear)
    assert seen(scene, tmp_path) == pytest.approx(want, rel=0.02)


def test_foam_is_behind_it_too_and_mirrored_water_is_not(scene, tmp_path):
    """A mirror's picture is no direct view."""
    ob = plane(1e5, 2)
    light_all_round(scene, (0.0, 0.0, 0.0))
    water(ob, Visibility=1.0, Air_Light=(*AIR, 1.0))
    look_far(scene, 3000.0)
    assert seen(scene, tmp_path) == pytest.approx(AIR, rel=0.01)
    scene.camera.data.type = "PERSP"
    scene.camera.data.angle = 0.001
    scene.camera.location = (0.0, 0.0, -3000.0)
    scene.camera.rotation_euler = (math.pi, 0.0, 0.0)
    assert (seen(scene, tmp_path) < 1e-6).all()  # from below


def flat_sea(**options):
    """An ocean without waves, and its water."""
    bpy.ops.libocean.add(kind="PATCH", preset="beaufort_0")
    ob = bpy.context.object
    assert bpy.ops.libocean.add_material(**options) == {"FINISHED"}
    made = ob.material_slots[0].material
    node = next(node for node in made.node_tree.nodes if water_shader.is_water(node))
    return ob, made, node


def sky_at_the_horizon(scene, tmp_path) -> np.ndarray:
    """Straight into the sky, as far over the horizon as the air's light is taken from."""
    hidden = [ob for ob in scene.objects if ob.type == "MESH"]
    for ob in hidden:
        ob.hide_render = True
    camera = scene.camera
    kept = camera.matrix_world.copy()
    camera.data.type = "PERSP"
    camera.data.angle = math.radians(0.01)
    camera.rotation_euler = (math.radians(90.0) + math.asin(air._HEIGHT), 0.0, 0.0)
    found = seen(scene, tmp_path)
    camera.matrix_world = kept
    camera.data.type = "ORTHO"
    for ob in hidden:
        ob.hide_render = False
    return found


def assert_is_the_sky(scene, tmp_path, ob, node) -> None:
    """Hidden by the air all of it, water looks as the sky over the horizon."""
    node.inputs["Visibility"].default_value = 0.01
    look_far(scene, 300.0)
    found = seen(scene, tmp_path)
    want = sky_at_the_horizon(scene, tmp_path)
    print(f"\n{found} {want}")
    assert found == pytest.approx(want, rel=0.02)
    assert found.max() > 0.02


@pytest.mark.parametrize("rotation", [0.0, 1.9])
def test_its_light_is_that_of_the_sky(scene, tmp_path, rotation):
    scene.world = first_view.make_sky(12.0, 0.0)
    sky = next(node for node in scene.world.node_tree.nodes if node.type == "TEX_SKY")
    sky.sun_rotation = rotation
    ob, made, node = flat_sea(visibility=VISIBILITY)
    assert_is_the_sky(scene, tmp_path, ob, node)
    sky.sun_elevation = 0.6
    node_of_world = next(n for n in scene.world.node_tree.nodes if n.type == "BACKGROUND")
    node_of_world.inputs["Strength"].default_value *= 2.0
    assert_is_the_sky(scene, tmp_path, ob, node)


def test_of_an_image_of_the_surroundings(scene, tmp_path):
    """Turned, in colours that differ all round."""
    image = bpy.data.images.new("Surroundings", 64, 32, float_buffer=True)
    rows, columns = np.mgrid[0:32, 0:64]
    pixels = np.ones((32, 64, 4), np.float32)
    pixels[..., 0], pixels[..., 1] = 0.1 + columns / 64.0, 0.1 + rows / 32.0
    image.pixels.foreach_set(pixels.ravel())
    image.pack()
    scene.world = bpy.data.worlds.new("Surroundings")
    compat.use_nodes(scene.world)
    tree = scene.world.node_tree
    shown = next(node for node in tree.nodes if node.type == "BACKGROUND")
    texture = tree.nodes.new("ShaderNodeTexEnvironment")
    texture.image = image
    mapping, place = tree.nodes.new("ShaderNodeMapping"), tree.nodes.new("ShaderNodeTexCoord")
    mapping.inputs["Rotation"].default_value[2] = 1.0
    tree.links.new(place.outputs["Generated"], mapping.inputs["Vector"])
    tree.links.new(mapping.outputs[0], texture.inputs["Vector"])
    tree.links.new(texture.outputs["Color"], shown.inputs["Color"])
    ob, _, node = flat_sea(visibility=VISIBILITY)
    assert_is_the_sky(scene, tmp_path, ob, node)
    mapping.inputs["Rotation"].default_value[2] = 3.0
    assert_is_the_sky(scene, tmp_path, ob, node)


def test_of_a_plain_colour_that_is_animated(scene, tmp_path):
    light_all_round(scene, (0.3, 0.2, 0.1))
    shown = next(node for node in scene.world.node_tree.nodes if node.type == "BACKGROUND")
    ob, _, node = flat_sea(visibility=VISIBILITY)
    assert_is_the_sky(scene, tmp_path, ob, node)
    keyed(shown.inputs["Strength"], default_value={1: 1.0, 11: 3.0})
    shown.inputs["Color"].default_value = (0.1, 0.4, 0.2, 1.0)
    scene.frame_set(6)
    assert shown.inputs["Strength"].default_value == pytest.approx(2.0)
    assert_is_the_sky(scene, tmp_path, ob, node)


WITHOUT_AIR = 3
"""The nodes of a material of water: water, angle of a pixel, output."""


def test_made_again_it_is_made_anew(scene):
    scene.world = first_view.make_sky(12.0, 0.0)
    ob, made, node = flat_sea(visibility=VISIBILITY)
    count = len(made.node_tree.nodes)
    drivers = len(made.node_tree.animation_data.drivers)
    material.fit(made, ob, scene)
    assert len(made.node_tree.nodes) == count
    assert len(made.node_tree.animation_data.drivers) == drivers
    node.inputs["Visibility"].default_value = 0.0
    material.fit(made, ob, scene)
    assert len(made.node_tree.nodes) == WITHOUT_AIR and not node.inputs["Air Light"].is_linked


def test_without_it_nothing_is_made(scene):
    scene.world = first_view.make_sky(12.0, 0.0)
    _, made, node = flat_sea()
    assert node.inputs["Visibility"].default_value == 0.0
    assert len(made.node_tree.nodes) == WITHOUT_AIR


def test_what_somebody_put_there_stays(scene):
    scene.world = first_view.make_sky(12.0, 0.0)
    ob, made, node = flat_sea()
    own = made.node_tree.nodes.new("ShaderNodeRGB")
    made.node_tree.links.new(own.outputs[0], node.inputs["Air Light"])
    node.inputs["Visibility"].default_value = VISIBILITY
    material.fit(made, ob, scene)
    assert node.inputs["Air Light"].links[0].from_node == own


def test_a_file_keeps_it_without_the_addon(scene, tmp_path):
    light_all_round(scene, (0.3, 0.2, 0.1))
    ob, _, node = flat_sea(visibility=VISIBILITY)
    node.inputs["Visibility"].default_value = 0.01
    node.inputs["Water Colour"].default_value = BLACK
    look_far(scene, 300.0)
    scene.render.filepath = str(tmp_path / "seen.exr")
    in_another_blender(other_blender.follow_air, save(tmp_path / "sea.blend"))
