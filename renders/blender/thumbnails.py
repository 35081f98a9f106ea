# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures that the asset library shows of its seas and skies, each made of the asset itself.

usage: blender --background --python renders/blender/thumbnails.py -- [FOLDER] [NAME...]

The add-on must be installed. FOLDER (default: blender_addon/libocean_addon/thumbnails) gets all of
them, or those with one of these names, such as beaufort_4_horizon.

A sea to the horizon has a weather buoy of 3 m in it, the farther away the higher the waves are: it
says how high. A patch is shown whole. A sky is seen over a gentle breeze, its sun to the left.
"""

import importlib
import math
import sys
from pathlib import Path

import bpy
import numpy as np
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parent))
import scenes  # noqa: E402 - beside this file

FOLDER = scenes.HERE.parents[1] / "blender_addon" / "libocean_addon" / "thumbnails"
SAMPLES = 256
HEADING = 180.0  # against the waves
SUN_ELEVATION = 26.0


def addon(name: str):
    """A module of the add-on, which is enabled, by whatever name it is installed."""
    enabled = next(package for package in scenes.PACKAGES if package in sys.modules)
    return importlib.import_module(f"{enabled}.{name}")


def look(scene, height: float, heading: float, lens: float, horizon: float) -> None:
    """horizon: how far above the middle it is, of half the picture."""
    camera = scene.camera
    pitch = math.atan(horizon * camera.data.sensor_width / 2.0 / lens)
    camera.location = (0.0, 0.0, height)
    camera.rotation_euler = (math.radians(90.0) - pitch, 0.0, math.radians(heading - 90.0))
    camera.data.lens = lens


def clear_frame(ocean, height: float, place) -> int:
    """The frame in which the camera, over 0, sees most of a buoy in that place over the waves
    between."""
    sea = addon("open_sea").sea_of(ocean).sea
    share = np.linspace(0.0, 1.0, 25)
    points = np.stack([share * place[0], share * place[1]], axis=1)
    best = (-math.inf, 1)
    for frame in range(1, 1500, 12):
        heights = sea.query(points, (frame - 1) / 24.0, foam=False)[:, 2]
        line = height + share * (heights[-1] + 1.0 - height)
        clear = min((line - heights)[:-2].min(), height - heights[0] - 1.5)
        best = max(best, (clear, frame))
    return best[1]


def add_scene(preset: str, sun_bearing: float) -> None:
    bpy.ops.libocean.add_scene(
        preset=preset,
        sun_elevation=math.radians(SUN_ELEVATION),
        sun_bearing=math.radians(sun_bearing),
        near_detail=False,  # as an asset comes
    )


def horizon(scene, asset) -> None:
    add_scene(asset.preset, 62.0)
    ocean = bpy.context.object
    waves = addon("live").state_of(ocean)[0][1]
    wave_height = float(waves.split()[0])
    height, lens = 2.5 + 0.9 * wave_height, 35.0 + 2.0 * wave_height
    look(scene, height, HEADING, lens, 0.28)
    distance = 14.0 + 7.0 * wave_height
    place = (-distance, distance * 6.0 / lens)
    frame = clear_frame(ocean, height, place)
    scenes.afloat(scenes.discus_buoy(), ocean, place, 25.0)
    scene.frame_set(frame)


def patch(scene, asset) -> None:
    add_scene(asset.preset, 92.0)
    bpy.data.objects.remove(bpy.context.object)
    bpy.ops.libocean.add(kind="PATCH", preset=asset.preset)
    ocean = bpy.context.object
    size = ocean.libocean.patch_size
    camera = scene.camera
    away = Vector((0.7, 0.7, 0.6)) * size * 1.85
    camera.location = away
    camera.rotation_euler = (-away).to_track_quat("-Z", "Y").to_euler()
    camera.data.lens = 50.0
    # Behind it a plain grey, which lights nothing.
    tree = scene.world.node_tree
    sky, output = tree.nodes["Background"], tree.nodes["World Output"]
    grey = tree.nodes.new("ShaderNodeBackground")
    grey.inputs["Color"].default_value = (0.3, 0.3, 0.3, 1.0)
    mix, path = tree.nodes.new("ShaderNodeMixShader"), tree.nodes.new("ShaderNodeLightPath")
    tree.links.new(path.outputs["Is Camera Ray"], mix.inputs[0])
    tree.links.new(sky.outputs[0], mix.inputs[1])
    tree.links.new(grey.outputs[0], mix.inputs[2])
    tree.links.new(mix.outputs[0], output.inputs["Surface"])
    scene.frame_set(30)


def sky(scene, asset) -> None:
    bpy.ops.libocean.add_scene(preset="beaufort_3")
    bpy.data.objects.remove(bpy.data.objects["Ocean Sun"])
    scene.world = addon("assets").make_sky(asset)
    look(scene, 4.0, addon("assets").SUN_AZIMUTH - 20.0, 24.0, -0.25)
    scene.frame_set(30)


PICTURES = {"HORIZON": horizon, "PATCH": patch, "SKY": sky}


def make(asset, folder: Path) -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scenes.enable_addon()
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples = SAMPLES
    scene.cycles.use_denoising = scenes.can_denoise()
    scene.render.resolution_x = scene.render.resolution_y = addon("assets").THUMBNAIL_SIDE
    PICTURES[asset.kind](scene, asset)
    scene.render.image_settings.file_format = "JPEG"
    scene.render.image_settings.quality = 90
    scene.render.filepath = str(folder.resolve() / asset.thumbnail.name)
    bpy.ops.render.render(write_still=True)


def main() -> None:
    arguments = sys.argv[sys.argv.index("--") + 1 :]
    folder, names = Path(arguments[0] if arguments else FOLDER), arguments[1:]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scenes.enable_addon()
    for asset in addon("assets").table():
        if not names or asset.thumbnail.stem in names:
            make(asset, folder)


main()
