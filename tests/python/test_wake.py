# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Sea.fill_wake: the waves of one hull alone."""

import numpy as np
import pytest
from conftest import SMALL

import libocean

HULL = """
[[hulls]]
length = 12.0
beam = 3.0
draught = 0.8
wake_resolution = 64
track = [[-60.0, {}, 20.0], [60.0, {}, 20.0]]
"""
HULLS = HULL.format(-240.0, 240.0) + HULL.format(300.0, -300.0)
FIELDS = ["dx", "dy", "height", "vx", "vy", "vz", "slope_x", "slope_y", "dx_x", "dy_y", "dx_y"]
ORIGIN, CELL, SHAPE = (-60.0, -20.0), 2.5, (30, 40)


@pytest.fixture
def busy():
    with libocean.parse(SMALL + HULLS) as sea:
        yield sea


def buffers(shape=SHAPE):
    groups = FIELDS[:3], FIELDS[3:6], FIELDS[6:9], FIELDS[9:]
    return [(np.zeros((*shape, len(names)), np.float32), names) for names in groups]


def joined(filled):
    return np.concatenate([array for array, _ in filled], axis=-1)


def wake(sea, hull, time=1.5):
    filled = buffers()
    sea.fill_wake(hull, time, filled, ORIGIN, CELL)
    return joined(filled)


def test_a_region_of_the_sea_is_the_open_sea_and_its_wakes(busy):
    whole, calm = buffers(), buffers()
    busy.fill_region(1.5, whole, ORIGIN, CELL)
    # The sea with a hull that makes no waves is the open sea.
    busy.set_all({"hulls.0.factor": 0.0, "hulls.1.factor": 0.0})
    busy.fill_region(1.5, calm, ORIGIN, CELL)
    busy.set_all({"hulls.0.factor": 1.0, "hulls.1.factor": 1.0})
    waves = joined(calm)[..., 2].std() * 4
    both = [wake(busy, hull) for hull in range(busy.wake_count)]
    difference = joined(whole) - joined(calm)
    assert np.abs(difference).max() > 0.01 * waves
    assert np.abs(difference - sum(both)).max() < 1e-5 * waves
    assert (wake(busy, 0) == both[0]).all()
    with libocean.parse(busy.text, threads=1) as alone:
        assert (wake(alone, 1) == both[1]).all()


def test_its_square_moves_with_the_hull_and_beyond_it_there_is_no_wake(busy):
    before, now = busy.wake_domain(0, 0.0), busy.wake_domain(0, 1.5)
    side = now.cell * now.samples
    assert now.samples == 64 and side >= 16 * 12.0
    assert now.origin[0] < 4.0 * 1.5 < now.origin[0] + side
    steps = (now.origin[0] - before.origin[0]) / now.cell
    assert steps > 0.0 and steps == pytest.approx(round(steps), abs=1e-9)
    shape, cell = (now.samples + 2, now.samples + 2), now.cell
    filled = buffers(shape)
    busy.fill_wake(0, 1.5, filled, (now.origin[0] - cell, now.origin[1] - cell), cell)
    found = joined(filled)
    rim = np.ones(shape, bool)
    rim[1:-1, 1:-1] = False
    assert (found[rim] == 0.0).all() and np.abs(found[~rim]).max() > 0.0


def test_its_trail_is_that_of_the_region_and_fades_towards_the_border(busy):
    square = busy.wake_domain(0, 40.0)
    shape = (square.samples, square.samples)
    busy.set("hulls.1.trail_lifetime", 0.0)
    own, whole = (np.zeros((*shape, 1), np.float32) for _ in range(2))
    busy.fill_wake(0, 40.0, [(own, ["trail"])], square.origin, square.cell)
    busy.fill_region(40.0, [(whole, ["trail"])], square.origin, square.cell)
    place = np.abs(np.arange(square.samples) / square.samples - 0.5)
    off = np.maximum(place[:, None], place[None, :])
    middle = off < 0.37
    assert own.max() > 0.5 and (own[middle] == whole[middle]).all()
    border = off > 0.49
    assert whole[border].max() > 0.05 and own[border].max() < 0.01


@pytest.mark.parametrize("axes", ["zup", "yup"])
def test_a_wake_is_added_to_the_open_sea_in_the_buffers(busy, axes):
    channels = [("vx", "vy", "vz"), ("dx", "dy", "height", "trail"), ("slope_x", "jacobian")]
    normal = [("nx", "ny", "nz", "")]
    square = busy.wake_domain(0, 1.5)
    # One corner of the region lies beyond the square.
    origin = square.origin[0] - 10.0, square.origin[1] - 10.0
    rng = np.random.default_rng(1)

    def arrays(groups):
        return [(rng.random((*SHAPE, len(names)), np.float32), names) for names in groups]

    sums, alone, wake_normal = arrays(channels), arrays(channels), arrays(normal)
    tilted = arrays(normal)
    tilted[0][0][..., 2 if axes == "zup" else 1] += 3.0
    before = [array.copy() for array, _ in [*sums, *tilted]]
    busy.add_wake(0, 1.5, [*sums, *tilted], origin, 3.0 * CELL, axes)
    busy.fill_wake(0, 1.5, [*alone, *wake_normal], origin, 3.0 * CELL, axes)
    alone[2][0][..., 1] -= 1.0  # of still water
    for (found, _), (wake, _), open_sea in zip(sums, alone, before, strict=False):
        assert np.abs(wake).max() > 0.0
        assert (found == open_sea + wake).all()
        assert (found[0] == open_sea[0]).all()
    up, level = (2, [0, 1]) if axes == "zup" else (1, [0, 2])
    wake, wanted, found = wake_normal[0][0][..., :3], before[3][..., :3].copy(), tilted[0][0]
    wanted[..., level] += wanted[..., up, None] * wake[..., level] / wake[..., up, None]
    wanted /= np.linalg.norm(wanted, axis=-1, keepdims=True)
    changed = np.abs(wake[..., level]).max(axis=-1) > 0.0
    assert np.abs(found[..., :3] - wanted)[changed].max() < 1e-6
    assert (found[..., 3] == before[3][..., 3]).all() and (found[0] == before[3][0]).all()


def test_hulls_that_are_not_there_foam_and_masks_are_refused(sea, busy):
    assert sea.wake_count == 0 and busy.wake_count == 2
    with pytest.raises(libocean.InvalidValueError, match="hull = 0; allowed: none"):
        sea.wake_domain(0, 0.0)
    array = np.zeros((4, 4, 1), np.float32)
    with pytest.raises(libocean.InvalidValueError, match="hull = 2; allowed: 0 .. 1"):
        busy.fill_wake(2, 0.0, [(array, ["height"])], ORIGIN, CELL)
    for channel in ("foam", "cover", "whitecap", "depth", "dry"):
        with pytest.raises(libocean.UnsupportedError, match="no foam and no mask but its trail"):
            busy.fill_wake(0, 0.0, [(array, [channel])], ORIGIN, CELL)
    with pytest.raises(libocean.UnsupportedError, match="nx, ny and nz in one output"):
        busy.add_wake(0, 0.0, [(array, ["nz"])], ORIGIN, CELL)
