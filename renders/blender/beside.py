# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A view of renders/preview/views.toml in Cycles, through the add-on's operators: the same sea,
camera and sun, and the same sky, as renders/preview/beside.pov draws it all around.

usage: blender --background --python renders/blender/beside.py -- VIEW SEA SKY.exr PICTURE.exr \\
           SAMPLES WIDTHxHEIGHT

The add-on must be installed. The picture is light, as linear as it was.
"""

import math
import sys
from pathlib import Path

import bpy

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "preview")]
import daylight  # noqa: E402
import hosts  # noqa: E402
import models  # noqa: E402
import scenes  # noqa: E402


def add_float(ocean, name: str, x: float, y: float, heading: float) -> None:
    model = models.MODELS[name]()
    mesh = bpy.data.meshes.new(name)
    points, faces, slots, smooth = [], [], [], []
    for number, part in enumerate(model.parts):
        faces += [tuple(i + len(points) for i in face) for face in part.faces]
        points += part.points
        slots += [number] * len(part.faces)
        smooth += [part.smooth] * len(part.faces)
        mesh.materials.append(scenes.paint(f"{name} {number}", part.colour, roughness=0.9))
    mesh.from_pydata(points, [], faces)
    mesh.polygons.foreach_set("material_index", slots)
    mesh.polygons.foreach_set("use_smooth", smooth)
    ob = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(ob)
    scenes.afloat(ob, ocean, (x, y), heading, length=model.length, width=model.width)


def see_as_far(visibility: float) -> None:
    """Sets the air of all materials. visibility: [m]."""
    for material in bpy.data.materials:
        for node in material.node_tree.nodes if material.node_tree else ():
            if "Visibility" in node.inputs:
                node.inputs["Visibility"].default_value = visibility


def main() -> None:
    name, sea, sky, picture, samples, size = sys.argv[sys.argv.index("--") + 1 :]
    view = hosts.view_of(name)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scenes.enable_addon()
    scene = bpy.context.scene
    camera = scenes.camera(scene, view["eye"], hosts.target(view), 50.0)
    camera.data.angle = math.radians(view["angle"])
    camera.data.clip_start = 0.05
    daylight.add_sky(scene, sky)
    daylight.add_sun(scene, *view["sun"])
    if "region" in view:
        ocean = scenes.coast_of(view["region"], view["cell"], Path(sea).resolve(), view["water"])
        settings = ocean.libocean_coast
        see_as_far(view["visibility"])
    else:
        ocean = scenes.ocean_of(Path(sea).resolve(), view["water"])
        settings = ocean.libocean
        # Anew: of this sea, sun, camera and air.
        bpy.context.view_layer.objects.active = ocean
        ocean.select_set(True)
        bpy.ops.libocean.add_material(water_type=view["water"], visibility=view["visibility"])
    for each in view["floats"]:
        add_float(ocean, *each)
    scene.frame_set(view["frame"])
    if settings.problem:
        sys.exit(settings.problem)
    daylight.render_light(scene, picture, int(samples), size)


if __name__ == "__main__":
    main()
