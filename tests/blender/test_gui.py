# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The user interface as it is drawn: a real window of the usual width, every panel open, nothing in
the console. OCEAN_SCREENSHOT=FILE.png keeps the picture, that of the add-on's README."""

import os
from pathlib import Path

import bpy
import numpy as np
from in_window import needs_window, run_steps

STEPS = """
from libocean_addon.sea import open_sea, panels
from libocean_addon.shared import drafts

for panel in panels.CLASSES:  # all of them open
    if getattr(panel, "bl_options", None):
        bpy.utils.unregister_class(panel)
        panel.bl_options = set()
        bpy.utils.register_class(panel)


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
        bpy.ops.screen.screenshot_area(filepath=arguments[0])


steps = [add, show, rest, is_whole, photograph]
"""


@needs_window
def test_every_panel_is_drawn_without_a_word_in_the_console(tmp_path):
    picture = Path(os.environ.get("OCEAN_SCREENSHOT", tmp_path / "p.png"))
    run_steps(tmp_path, STEPS, picture, size=(1920, 3200))
    image = bpy.data.images.load(str(picture))
    pixels = np.array(image.pixels[:], np.float32)
    assert 300 < image.size[0] < 360  # as wide as people have it
    assert np.std(pixels.reshape(-1, 4)[:, :3]) > 0.05
