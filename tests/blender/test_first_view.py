# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Add > Ocean Scene: sky, sun and camera; the first picture is one of a sea."""

import math

import bpy
import numpy as np
import pytest
from conftest import (
    NO_PAST,
    camera,
    factory_settings,
    picture_settings,
    presets_with,
    push,
    taken,
    white,
)
from libocean_addon.look import first_view


def seen(tmp_path, width=96, samples=8):
    scene = bpy.context.scene
    picture_settings(scene, width, samples)
    scene.render.resolution_y = 54 * width // 96
    return taken(scene, tmp_path)


@pytest.fixture
def default_file():
    """Cube, lamp and camera, as Blender begins."""
    factory_settings()
    bpy.data.objects.remove(bpy.data.objects["Cube"])
    return bpy.context.scene


def test_the_first_picture_shows_sky_over_a_darker_sea(default_file, tmp_path):
    default_file.camera.data.lens = 35.0
    before = default_file.camera, default_file.world
    assert bpy.ops.libocean.add_scene() == {"FINISHED"}
    ocean = bpy.context.object
    assert ocean.libocean.kind == "HORIZON" and ocean.libocean.problem == ""
    assert default_file.camera.name == "Ocean Camera"
    picture = seen(tmp_path)  # the bottom row first
    brightness = picture.mean(axis=2)
    horizon = 54 / 2 + 96 * 28.0 / 36.0 * math.tan(math.radians(5.0))  # 28 mm of 36, 5 degrees
    sky, sea = brightness[int(horizon) + 3 :], brightness[: int(horizon) - 3]
    assert 0.1 < np.median(sky) < 1.0, "neither black nor white at exposure 0"
    assert 0.01 < np.median(sea) < 0.7 * np.median(sky)
    assert np.quantile(sea, 0.99) > 3.0 * np.median(sea), "no glitter, no foam"
    # The edge is level and where the camera says; below it may be a white crest.
    between = (np.median(sky) + np.median(sea)) / 2.0
    for half in (brightness[:, :48], brightness[:, 48:]):
        edge = np.flatnonzero(np.median(half, axis=1) < between)[-1] + 1
        assert abs(edge - horizon) < 1.5
    # Nothing of the user's is lost.
    assert before[0] in set(bpy.data.objects) and before[1].use_fake_user


def test_it_is_undone_in_one_step(default_file, waiting):
    push()
    names = {ob.name for ob in bpy.data.objects}
    with presets_with(resolution=64, **NO_PAST):
        bpy.ops.libocean.add_scene("EXEC_DEFAULT", True)
    added = {ob.name for ob in bpy.data.objects} - names
    assert added == {"Ocean", "Ocean Camera", "Ocean Sun"}
    bpy.ops.ed.undo()
    assert {ob.name for ob in bpy.data.objects} == names
    assert bpy.context.scene.world.name == "World"


@pytest.mark.parametrize("elevation", [0.0, 3.0, 17.0, 90.0])
def test_the_lamp_stands_where_the_sky_is_brightest(default_file, waiting, elevation):
    """Its direction, and its light falls to red and to nothing as it sets."""
    with presets_with(resolution=64, **NO_PAST):
        bpy.ops.libocean.add_scene(sun_elevation=math.radians(elevation), sun_bearing=0.3)
    sun = bpy.data.objects["Ocean Sun"]
    bpy.context.view_layer.update()
    direction = np.array(sun.matrix_world)[:3, 2]  # it shines along -z
    azimuth = math.pi + 0.3
    height = math.radians(elevation)
    wanted = [math.cos(height) * math.cos(azimuth), math.cos(height) * math.sin(azimuth)]
    assert direction == pytest.approx([*wanted, math.sin(height)], abs=1e-5)
    nodes = bpy.context.scene.world.node_tree.nodes
    sky = next(node for node in nodes if node.type == "TEX_SKY")
    assert sky.sun_elevation == pytest.approx(height)
    assert (sun.data.energy > 0.0) == (elevation > 0.0)


def test_the_suns_light_grows_and_whitens():
    lights = np.array([first_view.sun_irradiance(e) for e in np.linspace(0, 90, 91)])
    assert (np.diff(lights, axis=0) >= 0.0).all()
    shares = lights[1:, 2] / lights[1:, 0]
    assert (np.diff(shares) > -1e-9).all()


@pytest.mark.parametrize("elevation", [5.0, 45.0])
def test_the_lamp_lights_as_the_skys_own_disc_does(scene, tmp_path, elevation):
    """A white plane that faces the sun, with the one and with the other."""
    scene.world = first_view.make_sky(elevation, 0.0)
    sun = first_view.make_sun(elevation, 0.0)
    bpy.ops.mesh.primitive_plane_add(rotation=sun.rotation_euler)
    bpy.context.object.data.materials.append(white())
    eye = camera(scene, width=1.0)
    eye.matrix_world = sun.rotation_euler.to_matrix().to_4x4()
    eye.location = 3.0 * eye.matrix_world.to_3x3().col[2]
    texture = next(n for n in scene.world.node_tree.nodes if n.type == "TEX_SKY")
    sky = seen(tmp_path, 32, 64).mean(axis=(0, 1))
    scene.collection.objects.link(sun)
    lamp = seen(tmp_path, 32, 64).mean(axis=(0, 1)) - sky
    scene.collection.objects.unlink(sun)
    texture.sun_disc = True
    disc = seen(tmp_path, 32, 64).mean(axis=(0, 1)) - sky
    assert lamp == pytest.approx(disc, rel=0.03, abs=0.02)
