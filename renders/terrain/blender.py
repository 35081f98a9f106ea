# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Land in Blender, made from nothing through the add-on's operators: a valley at noon from a ridge.

usage: blender --background --python renders/terrain/blender.py -- PICTURE [SAMPLES] [PERCENT]

The add-on must be installed. PICTURE ends in .jpg or .png.
"""

import math
import os
import sys
from pathlib import Path

import bpy
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parents[1] / "blender"))
import scenes  # noqa: E402

PRESET = "tujunga"
RESOLUTION = 1024  # of the preset: a sample every 16 m
TILES = 5  # of the coarser land around the tile in front
SUN = (33.0, -90.0)  # elevation and bearing of the sun, degrees: noon in winter at 34 north
VISIBILITY = 120000.0  # [m] very clear weather

# A ridge under snow, and the view along its flank over the valley to the range behind it.
PLACE = (4391.0, -983.0)  # [m] in the tile
EYE = 40.0  # [m] above the ground
HEADING = 180.0  # degrees counter-clockwise from +x
PITCH = -0.12  # rise over distance


def terrain(name: str, mesh_resolution: int, tiles: int):
    bpy.ops.libocean.add_terrain(
        preset=PRESET, mesh_resolution=str(mesh_resolution), tiles=tiles, use_material=False
    )
    ob = bpy.context.object
    ob.name = name
    ob.libocean_terrain.resolution = RESOLUTION
    return ob


def ground_at(ob, x: float, y: float) -> float:
    """Returns the height of the vertex of a tile that is nearest to a place [m]."""
    mesh = ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    side = math.isqrt(len(mesh.vertices))
    cell = ob.libocean_terrain.patch_size / (side - 1)
    column, row = (round(part / cell) + side // 2 for part in (x, y))
    return mesh.vertices[row * side + column].co.z


def valley(scene):
    """Makes the tile in front, with a vertex on each sample, and coarser land all around it, a
    little lower so that the two do not touch; and the scene's camera."""
    near = terrain("Near", RESOLUTION, 1)
    far = terrain("Far", RESOLUTION // 4, TILES)
    far.location.z = -10.0
    for ob in (far, near):
        bpy.ops.object.select_all(action="DESELECT")
        ob.select_set(True)
        bpy.context.view_layer.objects.active = ob
        bpy.ops.libocean.add_terrain_material(visibility=VISIBILITY)
    place = Vector((*PLACE, ground_at(near, *PLACE) + EYE))
    heading = math.radians(HEADING)
    way = Vector((math.cos(heading), math.sin(heading), PITCH))
    scenes.camera(scene, place, place + 100.0 * way, 26.0)


def render(scene, picture: str, samples: int, size=(1280, 720), percent: int = 100) -> None:
    render = scene.render
    render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.max_bounces = samples, 4
    scene.cycles.use_denoising = scenes.can_denoise()
    render.resolution_x, render.resolution_y = size
    render.resolution_percentage = percent
    render.image_settings.file_format = "JPEG" if picture.endswith(".jpg") else "PNG"
    render.image_settings.quality = 92
    scene.view_settings.view_transform = "Filmic"
    scene.view_settings.look = "Medium High Contrast"
    render.filepath = os.path.abspath(picture)
    bpy.ops.render.render(write_still=True)


def main(picture: str, samples: int = 64, percent: int = 100) -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scenes.enable_addon()
    scene = bpy.context.scene
    elevation, bearing = SUN
    scenes.sky(scene, elevation=elevation, azimuth=bearing, strength=0.10, dust=0.1)
    sky = next(node for node in scene.world.node_tree.nodes if node.type == "TEX_SKY")
    sky.altitude = 1500.0  # [m] of the camera
    valley(scene)
    render(scene, picture, samples, percent=percent)


if __name__ == "__main__":
    given = sys.argv[sys.argv.index("--") + 1 :]
    main(given[0], *(int(number) for number in given[1:3]))
