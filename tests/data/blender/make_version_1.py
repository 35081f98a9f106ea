# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes version_1.blend.xz: run by Blender 3.4 that has the add-on of commit 3781402, whose node group
is version 1 and whose floats are moved by their delta transforms.

    blender --background --factory-startup --python make_version_1.py -- version_1.blend.xz
"""

import lzma
import math
import sys
from pathlib import Path

import bpy

bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.preferences.addon_enable(module="libocean_addon")
scene = bpy.context.scene
bpy.ops.libocean.add(kind="PATCH", preset="beaufort_6", use_material=False)
patch = bpy.context.object
patch.libocean.resolution, patch.libocean.patch_size = 32, 100
patch.libocean.viewport_resolution = 64
bpy.ops.libocean.add(kind="HORIZON", preset="beaufort_6", use_material=False)
horizon = bpy.context.object
horizon.name = "Horizon"
horizon.libocean.resolution = 32
horizon.libocean.horizon_vertices, horizon.libocean.horizon_distance = 5000, 100
bpy.ops.mesh.primitive_plane_add(size=8, location=(10, -5, 0))
boat = bpy.context.object
boat.name = "Boat"
boat.rotation_euler.z = math.radians(30)
bpy.ops.libocean.add_float(ocean="Ocean")
scene.frame_set(50)
for brush in list(bpy.data.brushes):
    bpy.data.brushes.remove(brush)
raw = Path(sys.argv[-1]).with_suffix("")
bpy.ops.wm.save_as_mainfile(filepath=str(raw.resolve()), compress=False)
preset = 9 | lzma.PRESET_EXTREME
Path(sys.argv[-1]).write_bytes(lzma.compress(raw.read_bytes(), preset=preset))
raw.unlink()
