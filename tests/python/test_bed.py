# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Sea.set_bed: an array as the bed of a sea."""

import numpy as np
import pytest

import libocean

BEACH = np.tile(np.arange(9) - 4.5, (4, 1))


def test_an_array_becomes_the_bed_and_none_removes_it(sea):
    before = sea.text
    sea.set_bed(BEACH, origin=(-20.0, 30.0), cell=5.0)
    assert sea.get("seabed_origin") == "[-20, 30]"
    bed = sea.state["bed"]
    assert bed["samples"] == [9, 4] and bed["cell"] == 5.0
    assert (bed["lowest"], bed["highest"]) == (-4.5, 3.5)
    assert bed["wet_share"] == pytest.approx(5 / 9)
    assert "[water.bed_heights]" in sea.values
    with libocean.parse(sea.text) as again:
        assert again.text == sea.text
        assert again.state["bed"] == bed
    sea.set_bed(None)
    sea.set("seabed_origin", "[]")
    assert sea.text == before and "bed" not in sea.state


def test_rows_of_any_layout_and_type_are_read(sea):
    sea.set_bed(BEACH)
    hashed = sea.state["bed"]["sha256"]
    for heights in (BEACH.tolist(), np.asfortranarray(BEACH), BEACH[::-1][::-1]):
        sea.set_bed(heights)
        assert sea.state["bed"]["sha256"] == hashed


def test_bad_beds_and_maps_that_repeat_are_refused(sea):
    with pytest.raises(ValueError, match="allowed: \\[j\\]\\[i\\]"):
        sea.set_bed(np.zeros(5))
    with pytest.raises(libocean.Error, match="column 1, row 0"):
        sea.set_bed([[0.0, np.nan], [0.0, 1.0]])
    sea.set_bed(BEACH)
    with pytest.raises(libocean.Error, match="request a region"):
        sea.surface(0.0, 32, ["height"])


def test_exact_queries_over_a_bed_sum_the_modes(sea):
    sea.set_bed(BEACH, origin=(-20.0, 0.0), cell=5.0)
    found, exact = (sea.samples([[3.0, 7.0]], 4.0, exact=exact) for exact in (False, True))
    assert abs(found.height[0] - exact.height[0]) < 1e-4 and exact.height[0] != 0.0
    assert found.height_error >= 0.0
    with pytest.raises(libocean.UnsupportedError, match="reads all waves of the grid"):
        sea.samples([[3.0, 7.0]], 4.0, exact=True, resolution=16)
    with pytest.raises(libocean.UnsupportedError):
        sea.perform(1.0, "wind_speed", 12)


def test_a_region_is_the_surface_that_queries_find(sea):
    sea.set_bed(np.tile(np.linspace(-12.0, 3.0, 61), (40, 1)), cell=5.0)
    fields = ["displacement", "depth", "foam", "normal", "velocity"]
    maps = sea.region(2.0, (60.0, 50.0), (8, 6), 9.0, fields)
    assert maps["displacement"].shape == (6, 8, 3) and maps["depth"].shape == (6, 8)
    labels = np.stack(np.meshgrid(60.0 + 9.0 * np.arange(8), 50.0 + 9.0 * np.arange(6)), axis=-1)
    places = (labels + maps["displacement"][..., :2]).reshape(-1, 2)
    found = sea.query(places, 2.0)
    heights = maps["displacement"][..., 2].ravel()
    assert np.abs(found[:, 2] - heights).max() < 1e-4
    for name, columns in (("normal", slice(3, 6)), ("velocity", slice(6, 9))):
        assert np.abs(maps[name].reshape(-1, 3) - found[:, columns]).max() < 1e-3
    bed = 0.05 * places[:, 0] - 12.0
    assert np.abs(maps["depth"].ravel() - (heights - bed)).max() < 1e-4
    buffer = np.zeros((6, 8, 2), np.float32)
    sea.fill_region(2.0, [(buffer, ["height", "depth"])], (60.0, 50.0), 9.0)
    assert (buffer[..., 0].ravel() == heights).all()
    assert (buffer[..., 1] == maps["depth"]).all()


def test_a_region_needs_a_bed(sea):
    with pytest.raises(libocean.Error, match="has no bed"):
        sea.region(0.0, (0.0, 0.0), (4, 4), 1.0)


def test_the_bed_of_a_region_is_linear_between_its_samples(sea):
    with pytest.raises(libocean.Error, match="has no bed"):
        sea.bed_region((0.0, 0.0), (4, 4), 1.0)
    sea.set_bed(BEACH, cell=5.0)
    heights = sea.bed_region((-5.0, 2.0), (8, 3), 2.5)
    assert heights.shape == (3, 8) and heights.dtype == np.float32
    expected = np.clip(-5.0 + 2.5 * np.arange(8), 0.0, 40.0) / 5.0 - 4.5
    assert np.abs(heights - expected).max() < 1e-6
    with pytest.raises(ValueError, match="columns"):
        sea.bed_region((0.0, 0.0), (1, 4), 1.0)
