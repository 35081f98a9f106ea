# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture of the panel of an ocean beside its modifier, in a window that is 1920 pixels wide.

usage: blender --factory-startup --window-geometry 0 0 1920 2200 \\
           --python renders/blender/panel.py -- PICTURE.png

The add-on must be installed.
"""

import os
import sys
import traceback
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
import scenes  # noqa: E402

PICTURE = str(Path(sys.argv[sys.argv.index("--") + 1]).resolve())


def prepare() -> None:
    window = bpy.context.window_manager.windows[0]
    for area in window.screen.areas:
        if area.type == "VIEW_3D":
            area.type = "INFO"  # a 3D view takes seconds to draw without a graphics card
    scenes.enable_addon()
    bpy.ops.mesh.primitive_plane_add()
    bpy.ops.libocean.add(preset="beaufort_6")
    bpy.context.object.libocean.use_detail = True
    editor = next(area for area in window.screen.areas if area.type == "PROPERTIES")
    editor.spaces.active.context = "MODIFIER"


def shoot() -> float | None:
    """Returns the seconds until the next try while the sea is a draft."""
    drafts = next(each for name, each in sys.modules.items() if name.endswith(".shared.drafts"))
    if drafts.progress(bpy.context.object.name_full) is not None:
        return 2.0
    window = bpy.context.window_manager.windows[0]
    editor = next(area for area in window.screen.areas if area.type == "PROPERTIES")
    with bpy.context.temp_override(window=window, area=editor):
        bpy.ops.screen.screenshot_area(filepath=PICTURE)
    bpy.ops.wm.quit_blender()
    return None


def reported(step):
    """Ends Blender where a step fails; a timer's exception would leave the window open."""

    def run():
        try:
            return step()
        except Exception:
            traceback.print_exc()
            os._exit(1)

    return run


bpy.context.preferences.view.show_splash = False
bpy.app.timers.register(reported(prepare), first_interval=2.0)
bpy.app.timers.register(reported(shoot), first_interval=10.0)
