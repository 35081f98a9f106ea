# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Slope tiles of the waves too short for a map, through the Python wrapper."""

import numpy as np
import pytest

import libocean


def read_square(slope):
    """The mean square over all places, straight lines between samples: Gauss's two points a side
    are exact."""
    squares = []
    for along in (0.5 - 12**-0.5, 0.5 + 12**-0.5):
        for across in (0.5 - 12**-0.5, 0.5 + 12**-0.5):
            read = slope.astype(float)
            read = read + along * (np.roll(read, -1, 1) - read)
            read = read + across * (np.roll(read, -1, 0) - read)
            squares.append(np.square(read).sum(2).mean())
    return np.mean(squares)


def test_bands_are_slope_maps_with_what_they_hold(sea):
    detail = sea.detail(3.0, samples=256)
    assert len(detail.bands) == 3
    for band, before in zip(detail.bands, [None, *detail.bands], strict=False):
        assert band.slope.shape == (256, 256, 2)
        assert band.slope.dtype == np.float32
        assert before is None or band.longest_wave == before.shortest_wave
        assert band.tile == pytest.approx(max(1.0, 8.3 * band.longest_wave))
        variance = band.variance_x + band.variance_y
        assert read_square(band.slope) == pytest.approx(variance, rel=0.15)
        assert band.mean_square == pytest.approx(read_square(band.slope), rel=1e-6)
        assert band.covariance > 0.0  # the wind blows towards 30 degrees
    assert detail.bands[-1].shortest_wave == 0.012
    first = detail.bands[0]
    assert not np.array_equal(sea.detail(4.0, samples=256).bands[0].slope, first.slope)
    assert sea.detail(3.0, 32, samples=256).bands[0].longest_wave > first.longest_wave


@pytest.mark.parametrize("settings", [{"samples": 300}, {"samples": 2048}, {"resolution": 100}])
def test_bad_settings_are_refused(sea, settings):
    with pytest.raises(libocean.Error, match=next(iter(settings))):
        sea.detail(3.0, **settings)
