# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Particles of spray through the Python wrapper."""

import numpy as np
import pytest

import libocean


@pytest.fixture
def windy(sea):
    sea.set("wind_speed", 20.0)
    return sea


def test_spray_is_arrays_of_one_length(windy):
    spray = windy.spray(3.0)
    count = len(spray.id)
    assert count > 100
    assert {name: (array.shape, array.dtype.name) for name, array in spray._asdict().items()} == {
        "position": ((count, 3), "float64"),
        "velocity": ((count, 3), "float32"),
        "age": ((count,), "float32"),
        "life": ((count,), "float32"),
        "radius": ((count,), "float32"),
        "id": ((count,), "uint64"),
    }
    assert len(np.unique(spray.id)) == count
    assert ((spray.age >= 0) & (spray.age < spray.life) & (spray.life <= 2.0)).all()
    assert ((spray.radius > 1e-5) & (spray.radius < 1e-3)).all()
    assert not np.array_equal(windy.spray(3.1).position, spray.position)


def test_settings_count(windy):
    usual = len(windy.spray(3.0).id)
    assert windy.spray(3.0, lifetime=0.5).life.max() <= 0.5
    assert 1.7 * usual < len(windy.spray(3.0, density=0.5).id) < 2.3 * usual
    assert len(windy.spray(3.0, most=usual // 4).id) <= usual // 4
    assert len(windy.spray(3.0, density=0.0).id) == 0
    windy.set("wind_speed", 6.0)
    assert len(windy.spray(3.0).id) == 0


@pytest.mark.parametrize(
    "name, value", [("lifetime", 11.0), ("density", -1.0), ("most", 0), ("lifetime", np.nan)]
)
def test_bad_settings_are_refused(windy, name, value):
    with pytest.raises(libocean.InvalidValueError, match=f"spray: {name} ="):
        windy.spray(3.0, **{name: value})


def test_regions_that_do_not_fit_are_refused(windy):
    with pytest.raises(libocean.InvalidValueError, match=r"spray: region: .* allowed: \(4,\)"):
        windy.spray(3.0, region=(0.0, 0.0, 40.0))
    with pytest.raises(libocean.Error, match="it repeats"):
        windy.spray(3.0, region=(0.0, 0.0, 40.0, 40.0))
