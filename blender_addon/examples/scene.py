# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
# A sea to the horizon, saved and rendered into the current folder.
# blender -b --addons libocean_addon --python scene.py
import os

import bpy

bpy.ops.libocean.add_scene(preset="beaufort_6")
scene = bpy.context.scene
scene.render.engine = "CYCLES"
scene.cycles.samples = 16
scene.render.resolution_x, scene.render.resolution_y = 320, 180
scene.render.filepath = os.path.abspath("sea.png")
bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath("sea.blend"))
bpy.ops.render.render(write_still=True)
