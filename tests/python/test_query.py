# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Questions at world points through the Python wrapper."""

import numpy as np
import pytest

import libocean

TIME = 12.0


def test_a_query_finds_the_surface_that_the_maps_show(sea):
    surface = sea.surface(TIME)
    label = 200.0 / 64 * np.arange(64)
    x = (label[None, :] + surface.displacement[..., 0]).ravel()
    y = (label[:, None] + surface.displacement[..., 1]).ravel()
    samples = sea.query(np.column_stack([x + 600.0, y - 200.0]), TIME)
    assert samples.shape == (4096, 10) and samples.dtype == np.float32
    rms = surface.height.std()
    assert np.std(samples[:, 2] - surface.height.ravel()) < 2e-3 * rms
    assert np.abs(samples[:, 3:6] - surface.normal.reshape(-1, 3)).max() < 0.03
    assert np.abs(samples[:, 6:9] - surface.velocity.reshape(-1, 3)).max() < 0.03
    np.testing.assert_allclose(samples[:, 0], x + 600.0, rtol=1e-6)


def test_float_poses_are_tilted_frames_on_the_surface(sea):
    bodies = [[10.0 * i, 5.0 * i, 20.0 * i, 4.0, 2.0] for i in range(20)]
    pose = sea.float_pose(bodies, TIME)
    assert pose.position.shape == pose.up.shape == pose.forward.shape == (20, 3)
    np.testing.assert_allclose(np.linalg.norm(pose.up, axis=1), 1.0, atol=1e-6)
    np.testing.assert_allclose(np.sum(pose.up * pose.forward, axis=1), 0.0, atol=1e-6)
    np.testing.assert_allclose(np.sin(np.radians(pose.pitch)), pose.forward[:, 2], atol=1e-6)
    port = np.cross(pose.up, pose.forward)
    np.testing.assert_allclose(np.sin(np.radians(pose.roll)), port[:, 2], atol=1e-6)
    heights = sea.query([body[:2] for body in bodies], TIME)[:, 2]
    assert np.std(pose.position[:, 2] - heights) < 0.1 * heights.std()
    # A small body lies as the surface, its bow to the north; one of 10 km is level.
    small = sea.float_pose([[30.0, 40.0, 90.0, 0.5, 0.2], [-7.0, 1e6, 0.0, 1e4, 50.0]], TIME)
    (there,) = sea.query([[30.0, 40.0]], TIME)
    assert np.abs(small.position[0] - there[:3]).max() < 1e-6
    assert np.abs(small.up[0] - there[3:6]).max() < 1e-6
    assert abs(small.forward[0, 0]) < 1e-6 and small.forward[0, 1] > 0.5
    assert small.up[1, 2] > 0.999


def test_shapes_that_are_no_points_are_refused(sea):
    assert sea.query([1.0, 2.0], TIME).shape == (1, 10)
    assert sea.query([], TIME).shape == (0, 10)
    assert sea.query(np.empty((0, 2)), TIME).shape == (0, 10)
    for points in (np.zeros((4, 3)), np.zeros((2, 2, 2)), [1.0, 2.0, 3.0, 4.0], 5.0):
        with pytest.raises(libocean.InvalidValueError, match=r"allowed: \(n, 2\)"):
            sea.query(points, TIME)
    with pytest.raises(libocean.InvalidValueError, match="y of point 1 = nan"):
        sea.query([[1.0, 2.0], [3.0, np.nan]], TIME)
    with pytest.raises(libocean.InvalidValueError, match="time"):
        sea.query([[1.0, 2.0]], np.inf)
    with pytest.raises(libocean.InvalidValueError, match="length"):
        sea.float_pose([[1.0, 2.0, 0.0, -4.0, 2.0]], TIME)


def test_samples_say_all_that_is_known_of_a_point(sea):
    points = np.random.default_rng(3).uniform(-100.0, 300.0, (200, 2))
    rows = sea.query(points, 3.0)
    samples = sea.samples(points, 3.0, foam=True)
    assert np.array_equal(samples.height, rows[:, 2])
    assert np.array_equal(samples.normal, rows[:, 3:6])
    assert np.array_equal(samples.velocity, rows[:, 6:9])
    assert np.array_equal(samples.foam, rows[:, 9])
    assert np.abs(samples.label - points).max() < 20.0
    assert not samples.undecided.any()
    without = sea.samples(points, 3.0)
    assert np.isnan(without.foam).all() and np.array_equal(without.height, samples.height)
    exact = sea.samples(points, 3.0, exact=True)
    assert exact.height_error == 0.0
    error = np.sqrt(np.mean((samples.height - exact.height) ** 2))
    assert 0.1 * samples.height_error < error < 3.0 * samples.height_error
    coarse = sea.samples(points, 3.0, resolution=32)
    assert coarse.height_error > 5.0 * samples.height_error
    with pytest.raises(libocean.InvalidValueError, match="refine"):
        sea.samples(points, 3.0, refine=3)
    assert len(sea.samples([], 3.0).height) == 0


def test_where_crests_fold_samples_say_so(sea):
    sea.set("choppiness", 4.0)
    points = np.random.default_rng(3).uniform(0.0, 200.0, (4000, 2))
    samples = sea.samples(points, 3.0)
    assert 0 < samples.folded.sum() < 2000
    assert not samples.undecided.any()


def test_water_at_any_depths_is_that_of_each_depth(sea):
    points = [(x, -2 * x, -3.0 * (x % 3)) for x in range(30)]
    water = sea.water(points, 4.0)
    for z in (0.0, -3.0, -6.0):
        rows = [i for i, point in enumerate(points) if point[2] == z]
        alone = sea.orbital_velocity([points[i][:2] for i in rows], 4.0, z)
        assert np.array_equal(water.velocity[rows], alone)
    most = [np.abs(water.pressure[k::3]).max() for k in range(3)]
    assert 60000.0 > most[0] > max(3000.0, most[1]) and most[1] > most[2] > 0.0
    exact = sea.water(points, 4.0, exact=True)
    assert np.abs(water.pressure - exact.pressure).max() < 0.01 * exact.pressure.std()
    assert exact.pressure.std() > 100.0
    with pytest.raises(libocean.Error, match="shape"):
        sea.water([(1.0, 2.0)], 4.0)


def test_water_moves_up_and_down_as_the_surface_and_less_below(sea):
    """With no displacement the shown point is the label."""
    sea.set("choppiness", 0)
    points = np.column_stack([14.6 * np.arange(100), 14.6 * np.arange(100) + 7.3])
    above, still, below = (sea.orbital_velocity(points, TIME, z) for z in (1.0, 0.0, -20.0))
    assert np.array_equal(above, still)
    assert np.abs(still[:, 2] - sea.query(points, TIME)[:, 8]).max() < 1e-5
    assert 0.0 < (below**2).sum() < 0.2 * (still**2).sum()


def test_gauges_read_the_water_and_the_surface(sea):
    track = [(2.0, 0.0, 0.0, 0.0), (6.0, 40.0, 8.0, 0.0)]
    read = sea.gauges([(10.0, 5.0, -2.0), (10.0, 5.0, -2.0, 1.0, -1.0), track], 2.0, 5.0, 2.0)
    assert read.shape == (7, 3, 10)
    assert np.array_equal(read[:, 0, 0], 2.0 + 0.5 * np.arange(7))
    assert np.allclose(read[:, 1, 1], 10.0 + read[:, 1, 0])
    assert np.allclose(read[:, 2, 2], 2.0 * (read[:, 2, 0] - 2.0))
    for row in read.reshape(-1, 10):
        (found,) = sea.query(row[1:3], row[0], foam=False)
        assert abs(row[3] - found[2]) < 0.01
        assert np.abs(row[4:6] + found[3:5] / found[5]).max() < 0.02
    water = sea.water([(10.0, 5.0, -2.0)], 3.0, exact=True)
    assert np.allclose(read[2, 0, 6:9], water.velocity[0], atol=1e-6)
    assert np.isclose(read[2, 0, 9], water.pressure[0], rtol=1e-5)
    with pytest.raises(libocean.Error, match="shape"):
        sea.gauges([(1.0, 2.0)], 0.0, 1.0, 1.0)
    with pytest.raises(libocean.Error, match="no later"):
        sea.gauges([track[::-1]], 0.0, 1.0, 1.0)


def test_masked_points_have_no_surface(sea):
    points = np.ma.array([[1.0, 2.0], [30.0, -4.0], [5.0, 6.0]], mask=[[0, 0], [0, 1], [0, 0]])
    everywhere = np.ma.getdata(points)
    whole, found = sea.query(everywhere, TIME), sea.query(points, TIME)
    assert np.isnan(found[1]).all() and np.array_equal(found[::2], whole[::2])
    samples, speeds = sea.samples(points, TIME), sea.orbital_velocity(points, TIME)
    assert np.isnan(samples.height[1]) and np.isnan(samples.normal[1]).all()
    assert np.array_equal(samples.height[::2], sea.samples(everywhere, TIME).height[::2])
    assert np.isnan(speeds[1]).all() and np.isfinite(speeds[::2]).all()
    depths = np.ma.column_stack([points, [0.0, -1.0, -2.0]])
    assert np.isnan(sea.water(depths, TIME).pressure).tolist() == [False, True, False]
    with libocean.terrain(patch_size=500, resolution=64) as land:
        assert np.isnan(land.query(points).height).tolist() == [False, True, False]
