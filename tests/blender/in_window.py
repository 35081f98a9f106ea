# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs steps in a Blender with a real window on a screen of its own, with the add-on enabled.

Steps are functions of a script that ends with a list of them, `steps`. Each returns the seconds
until the next one, or None for half a second. The script finds its `arguments` and the `window`,
which is without a 3D view. An exception ends Blender.
"""

import shutil
import subprocess
from pathlib import Path

import bpy
import pytest

_BEGIN = """
import os, sys, traceback
import bpy

arguments = sys.argv[sys.argv.index("--") + 1 :]
bpy.context.preferences.view.show_splash = False
bpy.ops.preferences.addon_enable(module="libocean_addon")
window = bpy.context.window_manager.windows[0]
for area in window.screen.areas:  # without a graphics card the 3D view takes seconds to draw
    if area.type == "VIEW_3D":
        area.type = "INFO"
"""

_END = """

def leave():
    bpy.ops.wm.quit_blender()


steps.append(leave)


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

needs_window = pytest.mark.skipif(
    not bpy.app.binary_path or not shutil.which("xvfb-run"), reason="no Blender with a window"
)


def run_steps(folder: Path, steps: str, *arguments, size: tuple[int, int]) -> str:
    """Returns what a Blender that takes these steps says. Fails where it reports an error, a
    traceback or a crash. size: of the window [pixels]."""
    script = folder / "steps.py"
    script.write_text(_BEGIN + steps + _END)
    width, height = (str(side) for side in size)
    screen = f"-screen 0 {width}x{height}x24 +extension GLX"
    command = ["xvfb-run", "-a", "-s", screen, bpy.app.binary_path, "--factory-startup"]
    command += ["--window-geometry", "0", "0", width, height, "--python", script, "--"]
    command += [str(argument) for argument in arguments]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    said = done.stdout + done.stderr
    assert done.returncode == 0, said
    assert "Traceback" not in said and "rror" not in said, said
    return said
