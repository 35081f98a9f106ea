# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders in a real window, which run in a thread of their own: each frame has its own surface,
which is made while the render waits."""

import numpy as np
import other_blender
import pytest
from conftest import in_another_blender, needs_window, pixels

pytestmark = needs_window


@pytest.mark.parametrize(("kind", "relief", "count"), [("coast", 0.1, 4), ("land", 1.0, 6)])
def test_renders_in_a_window_have_the_surface_of_their_frame(tmp_path, kind, relief, count):
    """Frames of an animation, a frame whose render begins while a draft is shown, and the last
    frame of an animation during which the land changes are those of renders that wait for all."""
    said = in_another_blender(other_blender.render_while_it_changes, tmp_path, kind)
    assert "a draft" not in said and "rror" not in said, said
    stills = {path.stem.removeprefix("still_"): pixels(path) for path in tmp_path.glob("still_*")}
    assert len(stills) == count
    for picture, wanted in stills.items():
        assert np.ptp(wanted[..., 2]) > relief
        assert np.array_equal(pixels(tmp_path / f"window_{picture}.exr"), wanted), picture
    assert not np.array_equal(stills["0001"], stills["0002"])
    last = max(picture for picture in stills if picture.isdigit())
    assert not np.array_equal(stills[last], stills["pressed"])
