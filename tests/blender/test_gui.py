# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The user interface as it is drawn: a real window of the usual width, every panel open, nothing in
the console. OCEAN_SCREENSHOT=FILE.png keeps the picture, that of the add-on's README."""

import os

import bpy
import numpy as np
import other_blender
from conftest import in_another_blender, needs_window, pixels_of


@needs_window
def test_every_panel_is_drawn_without_a_word_in_the_console(tmp_path):
    picture = os.environ.get("OCEAN_SCREENSHOT", str(tmp_path / "p.png"))
    said = in_another_blender(other_blender.draw_every_panel, picture, size=(1920, 3200))
    assert "rror" not in said, said
    image = bpy.data.images.load(picture)
    assert 300 < image.size[0] < 360  # as wide as people have it
    assert np.std(pixels_of(image)[..., :3]) > 0.05
