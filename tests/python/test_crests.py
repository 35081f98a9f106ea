# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The highest crest of a sea through the Python wrapper."""

import pytest

import libocean


def test_the_highest_crest_is_a_point_of_the_surface(sea):
    crest = sea.find_crest(0.0, 20.0)
    assert isinstance(crest, libocean.FoundCrest)
    assert 0.0 <= crest.time <= 20.0
    assert 0.0 <= crest.x <= 200.0 and 0.0 <= crest.y <= 200.0
    assert sea.query([crest[1:3]], crest.time, foam=False)[0, 2] == pytest.approx(
        crest.height, rel=0.02
    )
    heights = [sea.surface(time, fields=["height"]).height.max() for time in (0.0, 7.0, 13.0)]
    assert crest.height > max(heights)


def test_a_box_bounds_the_search_and_bad_windows_are_refused(sea):
    box = (50.0, 20.0, 90.0, 60.0)
    crest = sea.find_crest(0.0, 5.0, box)
    assert 50.0 <= crest.x <= 90.0 and 20.0 <= crest.y <= 60.0
    with pytest.raises(libocean.InvalidValueError, match="to a later one"):
        sea.find_crest(5.0, 0.0)
    with pytest.raises(ValueError, match="box"):
        sea.find_crest(0.0, 5.0, (1.0, 2.0))
