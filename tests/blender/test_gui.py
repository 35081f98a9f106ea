# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The user interface as it is drawn: a real window of the usual width, every panel open, nothing in
the console. OCEAN_SCREENSHOT=FILE.png keeps the picture, that of the add-on's README."""

import os
import shutil
import subprocess
import textwrap
from pathlib import Path

import bpy
import numpy as np
import pytest

SCREEN = "-screen 0 1920x3200x24 +extension GLX"

STEPS = """
import os, sys, traceback
import bpy

bpy.context.preferences.view.show_splash = False
picture = sys.argv[sys.argv.index("--") + 1]
bpy.ops.preferences.addon_enable(module="libocean_addon")
from libocean_addon.sea import open_sea
from libocean_addon.shared import drafts
from libocean_addon import panels

for panel in panels.CLASSES:  # all of them open
    if getattr(panel, "bl_options", None):
        bpy.utils.unregister_class(panel)
        panel.bl_options = set()
        bpy.utils.register_class(panel)


window = bpy.context.window_manager.windows[0]
for area in window.screen.areas:  # without a graphics card the 3D view takes seconds to draw
    if area.type == "VIEW_3D":
        area.type = "INFO"


def in_window(operator, **arguments):
    with bpy.context.temp_override(window=window):
        assert operator(**arguments) == {"FINISHED"}


def add():
    in_window(bpy.ops.libocean.add, kind="PATCH", preset="beaufort_6")
    bpy.context.object.libocean.resolution = 128
    in_window(bpy.ops.libocean.add_waves)
    bpy.context.object.libocean.waves[1].wind_direction = 40.0
    assert drafts.progress("Ocean") is not None  # nobody has waited


def properties():
    return next(area for area in window.screen.areas if area.type == "PROPERTIES")


def show():  # known once it has been drawn
    properties().spaces.active.context = "MODIFIER"


def rest():
    if drafts.progress("Ocean") is not None:
        steps.insert(0, rest)
    return 1.0


def is_whole():
    ready = open_sea.sea_of(bpy.context.object.name_full).ready
    assert ready is not None and ready[1:3] == (128, "cover")
    return 2.0


def photograph():
    area = properties()
    region = next(region for region in area.regions if region.type == "WINDOW")
    with bpy.context.temp_override(window=window, screen=window.screen, area=area, region=region):
        bpy.ops.screen.screenshot_area(filepath=picture)


def leave():
    bpy.ops.wm.quit_blender()


steps = [add, show, rest, is_whole, photograph, leave]


def next_step():
    if not steps:  # it takes its time to leave
        return None
    try:
        return steps.pop(0)() or 0.5
    except Exception:
        traceback.print_exc()
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(1)


bpy.app.timers.register(next_step, first_interval=1.0)
"""


@pytest.mark.skipif(
    not bpy.app.binary_path or not shutil.which("xvfb-run"), reason="no Blender with a window"
)
def test_every_panel_is_drawn_without_a_word_in_the_console(tmp_path):
    script, picture = (
        tmp_path / "steps.py",
        Path(os.environ.get("OCEAN_SCREENSHOT", tmp_path / "p.png")),
    )
    script.write_text(textwrap.dedent(STEPS))
    command = ["xvfb-run", "-a", "-s", SCREEN, bpy.app.binary_path, "--factory-startup"]
    command += ["--window-geometry", "0", "0", "1920", "3200", "--python", script, "--", picture]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    said = done.stdout + done.stderr
    assert done.returncode == 0, said
    assert "Traceback" not in said and "rror" not in said, said
    image = bpy.data.images.load(str(picture))
    pixels = np.array(image.pixels[:], np.float32)
    assert 300 < image.size[0] < 360  # as wide as people have it
    assert np.std(pixels.reshape(-1, 4)[:, :3]) > 0.05
