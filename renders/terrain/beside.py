# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The ridge of beside.jpg in Blender: the eye and the sun that the preview and POV-Ray have in the
other columns.

usage: blender --background --python renders/terrain/beside.py -- PICTURE ELEVATION BEARING

The add-on must be installed. ELEVATION and BEARING are those of the sun, in degrees, the bearing
counter-clockwise from +x.
"""

import math
import sys
from pathlib import Path

import bpy
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parent))
import blender as land  # noqa: E402
from blender import scenes  # noqa: E402

PLACE = (-32.0, -1344.0)  # [m] 16352, 15040 of the tile of 16384 m, which is centred here
EYE = 1.7  # [m] above the ground
HEADING, PITCH, ANGLE = 352.0, -5.0, 50.0  # degrees
SNOW_LINE = 1640.0  # [m]


def main(picture: str, elevation: float, bearing: float, samples: int = 48) -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scenes.enable_addon()
    scene = bpy.context.scene
    low = elevation < 15.0
    scenes.sky(
        scene, elevation=elevation, azimuth=bearing, strength=0.22 if low else 0.09, dust=0.3
    )
    near = land.terrain("Near", land.RESOLUTION, 1)
    far = land.terrain("Far", land.RESOLUTION // 4, land.TILES)
    far.location.z = -10.0
    for ob in (far, near):
        bpy.ops.object.select_all(action="DESELECT")
        ob.select_set(True)
        bpy.context.view_layer.objects.active = ob
        bpy.ops.libocean.add_terrain_material(visibility=90000.0)
        for node in ob.active_material.node_tree.nodes:
            if node.type == "GROUP" and "Snow Line" in node.inputs:
                node.inputs["Snow Line"].default_value = SNOW_LINE
    place = Vector((*PLACE, land.ground_at(near, *PLACE) + EYE))
    heading = math.radians(HEADING)
    way = Vector((math.cos(heading), math.sin(heading), math.tan(math.radians(PITCH))))
    lens = 18.0 / math.tan(math.radians(0.5 * ANGLE))
    scenes.camera(scene, place, place + 100.0 * way, lens)
    land.render(scene, picture, samples, (640, 360))


if __name__ == "__main__":
    given = sys.argv[sys.argv.index("--") + 1 :]
    main(given[0], float(given[1]), float(given[2]), *(int(number) for number in given[3:4]))
