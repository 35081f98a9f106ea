# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Textures of foam through the Python wrapper."""

import numpy as np
import pytest

import libocean


@pytest.mark.parametrize("kind, period", [("lace", 12.0), ("bubbles", 1.3), ("streaks", 97.0)])
def test_a_cover_is_its_share_of_the_area(kind, period):
    texture = libocean.foam_texture(kind, size=256)
    assert texture.shape == (256, 256) and texture.dtype == np.float32
    assert texture.min() >= 0 and texture.max() <= 1
    assert libocean.foam_texture_period(kind) == period
    random = np.random.default_rng(5)
    u, v = random.random((2, 256, 256), np.float32)
    right, up = np.roll(texture, -1, 1), np.roll(texture, -1, 0)
    corner = np.roll(right, -1, 0)
    reads = (texture * (1 - u) + right * u) * (1 - v) + (up * (1 - u) + corner * u) * v
    for cover in (0.02, 0.1, 0.5, 0.9):
        assert abs((reads < cover).mean() - cover) < 0.05 * cover**0.5
    assert not np.array_equal(libocean.foam_texture(kind, size=256, seed=7), texture)


@pytest.mark.parametrize(
    "arguments, said",
    [
        ({"kind": "laces"}, "did you mean lace"),
        ({"kind": "lace", "size": 100}, "64 .. 4096"),
        ({"kind": "lace", "size": 2**40}, "64 .. 4096"),
        ({"kind": "lace", "size": -64}, "64 .. 4096"),
        ({"kind": "lace", "seed": -1}, "seed = -1"),
        ({"kind": "lace", "seed": 2**32}, "seed = 4294967296"),
        ({"kind": "lace", "size": 64, "threads": -1}, "threads = -1"),
    ],
)
def test_what_is_not_allowed_is_refused(arguments, said):
    with pytest.raises(libocean.InvalidValueError, match=said):
        libocean.foam_texture(**arguments)


@pytest.mark.parametrize("size", [float("nan"), 64.0, "64", None])
def test_a_size_is_a_whole_number(size):
    with pytest.raises(TypeError):
        libocean.foam_texture("lace", size=size)
