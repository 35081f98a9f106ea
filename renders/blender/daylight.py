# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sun, the sky and the light of the sheets of hosts; Blender takes its sky from POV-Ray."""

import math
from pathlib import Path

import bpy


def sun_colour(altitude: float) -> tuple[float, float, float]:
    """Ocean_Sun_Colour of povray_macros/ocean/sky.inc: of a white surface that faces the sun."""
    air = 1.0 / (math.sin(math.radians(altitude)) + 0.50572 * (altitude + 6.07995) ** -1.6364)
    return tuple(2.2 * math.exp(-each * air) for each in (0.09, 0.14, 0.27))


def add_sun(scene, altitude: float, bearing: float) -> None:
    """A white surface sends back irradiance over pi."""
    colour = sun_colour(altitude)
    lamp = bpy.data.lights.new("Sun", "SUN")
    lamp.energy = math.pi * max(colour)
    lamp.color = tuple(part / max(colour) for part in colour)
    lamp.angle = math.radians(0.533)
    ob = bpy.data.objects.new("Sun", lamp)
    ob.rotation_euler = (0.0, math.radians(90.0 - altitude), math.radians(bearing))
    scene.collection.objects.link(ob)


def add_sky(scene, picture: str) -> None:
    """Equirectangular, +x in its middle."""
    world = bpy.data.worlds.new("Sky")
    scene.world = world
    if bpy.app.version < (5, 0):
        world.use_nodes = True
    nodes = world.node_tree.nodes
    texture = nodes.new("ShaderNodeTexEnvironment")
    texture.image = bpy.data.images.load(str(Path(picture).resolve()))
    texture.image.colorspace_settings.name = "Non-Color"  # in each Blender
    world.node_tree.links.new(texture.outputs["Color"], nodes["Background"].inputs["Color"])


def render_light(scene, picture: str, samples: int, size: str) -> None:
    """Renders by Cycles into an EXR file of light, as linear as it was. size: WIDTHxHEIGHT."""
    scene.render.engine = "CYCLES"
    scene.cycles.samples = samples
    scene.cycles.use_denoising = False
    scene.render.resolution_x, scene.render.resolution_y = map(int, size.split("x"))
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.filepath = str(Path(picture).resolve())
    bpy.ops.render.render(write_still=True)
