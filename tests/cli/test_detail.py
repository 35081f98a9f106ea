# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean bake --products detail`: slope tiles beside a map, with headers that make them again."""

import numpy as np
import pytest

SMALL = ("--detail-samples", "256")


def numbers(spec, name):
    return [float(part) for part in spec.getattribute(f"ocean:{name}").split(",")]


def test_each_band_has_a_file_of_its_own(ocean):
    names = ocean.bake("-o o/s.####.exr --products height,detail")
    bands = [f"o/s.detail{band}.0001.exr" for band in (1, 2, 3)]
    assert names == ["o/s.height.0001.exr", *bands]
    longest = None
    for band, name in enumerate(bands, 1):
        spec, pixels = ocean.image(name)
        assert pixels.shape == (512, 512, 3) and str(spec.format) == "half"
        assert spec.channelnames == ("R", "G", "B") and (pixels[..., 2] == 0).all()
        assert spec.getattribute("ocean:field") == f"detail{band}"
        assert spec.getattribute("wrapmodes") == "periodic"
        assert spec.getattribute("ocean:map_resolution") == "64"
        assert spec.getattribute("ocean:period") == "200"
        (wave,) = numbers(spec, "longest_wave")
        assert longest in (None, wave)
        (longest,) = numbers(spec, "shortest_wave")
        assert numbers(spec, "tile") == [pytest.approx(8.3 * wave)]
        along_x, along_y, _ = numbers(spec, "slope_variance")
        found = np.square(pixels[..., :2], dtype=float).mean((0, 1))
        assert found == pytest.approx([along_x, along_y], rel=0.2)
        assert 1e-4 < numbers(spec, "slope_residual")[0] < 1e-3
    assert longest == 0.012
    ocean.bake("-o alone.exr --products detail2")
    assert ocean.bytes_of("alone.exr") == ocean.bytes_of(bands[1])


def test_bands_begin_where_the_map_ends(ocean):
    ocean.bake("-o s.exr --products detail1 --resolution 256", *SMALL)
    spec, pixels = ocean.image("s.exr")
    assert pixels.shape[0] == 256 and spec.getattribute("ocean:map_resolution") == "256"
    # The sea's own modes end first: 64 of them.
    assert numbers(spec, "longest_wave") == [pytest.approx(200 / 31.5)]


def test_options_win_over_the_header(ocean):
    ocean.bake("-o b.exr --products detail1", *SMALL)
    ocean.good("bake --from b.exr -o other.exr --detail-samples 512")
    assert ocean.image("other.exr")[1].shape[0] == 512
    # Another product gets none of the strings of detail.
    ocean.good("bake --from b.exr -o h.exr --products height")
    spec, pixels = ocean.image("h.exr")
    assert pixels.shape[0] == 64 and spec.getattribute("ocean:tile") is None


def test_a_take_changes_the_tiles_of_each_frame(ocean):
    (ocean.folder / "wind.take").write_text("0.0 wind_speed 16\n")
    frames = ("--frames", "1,25", "--set", "take=wind.take", *SMALL)
    ocean.bake("-o o/s.####.exr --products detail1", *frames)
    calm, windy = (ocean.image(f"o/s.detail1.00{n}.exr") for n in ("01", "25"))
    assert numbers(windy[0], "slope_variance")[0] > 1.1 * numbers(calm[0], "slope_variance")[0]
    assert windy[1].std() > 1.05 * calm[1].std()
