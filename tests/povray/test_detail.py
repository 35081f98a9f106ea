# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Slope tiles in Ocean_Material: that POV-Ray's normals lean by the sea's own short waves, all of
them near the eye, and by as many as pixels show farther off."""

import os
import re
import subprocess

import numpy
import pytest
from conftest import TELL, Folder, floats_of, sea_text

import libocean

NEAR = """Ocean_Eye_At(<0, 5, 0>, 60)
#declare Ocean_Pixel_ = 1e-9;
Ocean_Foam_Settings_()
Ocean_Declare_Nearness_()
Ocean_Declare_Detail_()
"""


@pytest.fixture(scope="module")
def fresh(tmp_path_factory):
    """Beaufort 4, with waves that move points by a decimetre."""
    sea = sea_text(resolution=256, period=160.0, wind=6.7)
    return Folder(tmp_path_factory.mktemp("fresh"), sea)


@pytest.fixture(scope="module")
def tiles(fresh):
    return libocean.open(fresh.path / "sea.toml").detail(0.0, 256, samples=256)


def test_the_formulas_are_those_of_slope_tiles_glsl(choppy, tmp_path):
    subprocess.run([os.environ["OCEAN_POVRAY_SAMPLES"], str(tmp_path)], check=True)
    lines = [line.split(",") for line in (tmp_path / "slope_tiles.csv").read_text().split()]
    assert len({name for name, *_ in lines}) == 3 and len(lines) > 300
    calls = [f"Tell({name}({', '.join(words[:-1])}))" for name, *words in lines]
    found = floats_of(choppy.run(TELL + "\n".join(calls)))
    expected = numpy.array([float(line[-1]) for line in lines])
    for name in sorted({line[0] for line in lines}):
        of_it = numpy.array([line[0] == name for line in lines])
        assert numpy.abs(found - expected)[of_it].max() < 1e-7, name


def test_the_tiles_are_those_of_the_sea(fresh, tiles):
    """At samples to the 16 bits of the file, half way between them the mean; x and z."""
    assert len(tiles.bands) == 2
    random = numpy.random.default_rng(5)
    j, i = random.integers(0, 256, (2, 100))
    calls = "".join(
        f"Tell(Ocean_Detail_Copy_({(a + part) / 256:.12f}, {b / 256:.12f}, {band / 2}, {axes}))\n"
        for a, b in zip(i, j, strict=True)
        for band in range(2)
        for part, axes in ((0, "1, 0"), (0, "0, 1"), (0.5, "1, 0"))
    )
    found = fresh.told(NEAR + calls).reshape(100, 2, 3)
    for band in range(2):
        slopes = tiles.bands[band].slope
        assert numpy.abs(found[:, band, 0] - slopes[j, i, 0]).max() < 6.2e-5
        assert numpy.abs(found[:, band, 1] - slopes[j, i, 1]).max() < 6.2e-5
        between = (slopes[j, i, 0] + slopes[j, (i + 1) % 256, 0]) / 2
        assert numpy.abs(found[:, band, 2] - between).max() < 6.2e-5


def test_near_slopes_are_as_steep_as_the_sea_and_do_not_repeat(fresh, tiles):
    """Over 400 tiles of each band, between samples: variances of the band, no covariance a tile
    on."""
    for band, of_sea in enumerate(tiles.bands):
        points = numpy.random.default_rng(7 + band).uniform(0, 20, (6000, 2))
        reads = [(0, "1, 0"), (0, "0, 1"), (1, "1, 0")]
        calls = "".join(
            f"Tell(Ocean_Detail_Band_({x + more:.9f}, {z:.9f}, {band / 2}, {axes}))"
            for x, z in points
            for more, axes in reads
        )
        found = fresh.told(NEAR + calls).reshape(-1, 3)
        whole = (found[:, :2] ** 2).sum(1).mean() / (of_sea.variance_x + of_sea.variance_y)
        again = (found[:, 0] * found[:, 2]).mean() / of_sea.variance_x
        print(f"\nband {band}: {whole:.4f} of its variance; a tile on {again:.3f}")
        # A mean of 6000 sums of two Gaussian squares is off by 1.5 %, a tile's own by 2 %.
        assert whole == pytest.approx(1.0, abs=0.07)
        assert abs(again) < 0.1


def lit(folder, towards, declared=""):
    """A flat sheet of 0.4 m in the light of a lamp at 45 degrees, a picture of 100 x 100."""
    return folder.seen(
        f"""{NEAR}{declared}
camera {{ orthographic location <20, 5, 30> direction -y right 0.4*x up 0.4*z }}
light_source {{ <{towards[0]}, 1, {towards[1]}>*1e7 rgb 1 parallel point_at 0 }}
plane {{ y, 0 pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 1 }}
    normal {{ function {{ Ocean_Detail_Normal_(x, y, z) }}
              60*Ocean_Far_ accuracy Ocean_Far_ }} }}""",
        width=100,
        height=100,
    )[..., 0]


def test_a_normal_leans_by_the_slope_itself(fresh):
    """The ratio of lights from two sides is (1 - slope)/(1 + slope)."""
    for axis, name in ((0, "1, 0"), (1, "0, 1")):
        lamp = numpy.eye(2)[axis]
        ratio = lit(fresh, lamp) / lit(fresh, -lamp)
        slopes = (1 - ratio) / (1 + ratio)
        j, i = numpy.random.default_rng(9 + axis).integers(0, 100, (2, 200))
        calls = "".join(
            f"Tell(Ocean_Detail_Slope_({19.8 + (a + 0.5) * 0.004}, 0,"
            f" {29.8 + (b + 0.5) * 0.004}, {name}))"
            for a, b in zip(i, j, strict=True)
        )
        expected = fresh.told(NEAR + calls)
        assert expected.std() > 0.04
        # 16 bits of light are 3e-5 of a slope.
        assert numpy.abs(slopes[j, i] - expected).max() < 1e-4


def test_shown_and_left_slopes_are_those_that_the_map_lacks(fresh, tiles):
    """At every size of a pixel; and the map's loss is the bands' and the rest."""
    text = (fresh.path / "ocean_parameters.inc").read_text()
    lost = float(re.search(r"Ocean_Lost_Slopes = array\[\d+\] { ([^,]*),", text).group(1))
    of_bands = [band.variance_x + band.variance_y for band in tiles.bands]
    assert sum(of_bands) + tiles.residual == pytest.approx(lost, rel=0.01)
    footprints = [0.0, 0.01, 0.03, 0.1, 0.2, 1.0, 10.0]
    calls = "".join(
        f"Tell(Ocean_Detail_Hidden_({footprint}))"
        + "".join(
            f"Tell(Ocean_Tile_Fade_({footprint}, Ocean_Detail_Shortest_[{b}],"
            f" Ocean_Detail_Longest_[{b}]))"
            for b in range(2)
        )
        for footprint in footprints
    )
    found = fresh.told(NEAR + calls).reshape(-1, 3)
    shown = found[:, 1] ** 2 * of_bands[0] + found[:, 2] ** 2 * of_bands[1]
    assert (shown + found[:, 0] * lost) / lost == pytest.approx(1.0, abs=0.01)
    assert found[0, 0] < 0.05 and found[-1, 0] == pytest.approx(1.0)
    assert (numpy.diff(found[:, 0]) >= 0.0).all()


def test_near_water_shows_the_slope_tiles(fresh):
    """1.6 m above the sea: fine contrast, what a pixel differs from the 9 x 9 around it, in the
    left half of the lower half of a picture."""

    def fine_contrast(declared):
        picture = fresh.seen(
            f"""{declared}
#declare Eye = <0, 1.6, 0>;
#declare Target = Eye + <10, -3, 3>;
camera {{ location Eye right x*image_width/image_height angle 60 look_at Target }}
Ocean_Eye_At(Eye, 60)
Ocean_Sun(35, 60)
Ocean_Sky(0.3)
object {{ Ocean_View(Eye, Target, 60, 0.5) Ocean_Material("jerlov_ii") no_reflection }}""",
            *("+SR81", "+EC120"), settings="max_trace_level 4", width=240, height=160,
        )  # fmt: skip
        grey = picture.mean(-1)[:80, :120]
        sums = numpy.cumsum(numpy.cumsum(numpy.pad(grey, ((1, 0), (1, 0))), 0), 1)
        means = (sums[9:, 9:] - sums[:-9, 9:] - sums[9:, :-9] + sums[:-9, :-9]) / 81
        return (grey[4:-4, 4:-4] - means).std()

    rough, silk = fine_contrast(""), fine_contrast("#declare Ocean_Detail_Bands_ = 0;")
    print(f"\nfine contrast {rough:.4f}, without tiles {silk:.4f}: {rough / silk:.1f} times")
    assert rough >= 3.0 * silk


@pytest.mark.parametrize("resolution,period", [(256, 160.0), (512, 230.0)])
def test_a_frame_is_at_most_half_as_large_again(tmp_path, resolution, period):
    folder = Folder(tmp_path, sea_text(resolution=resolution, period=period, wind=6.7))
    sizes = {path.name: path.stat().st_size for path in folder.path.glob("sea_0001*")}
    tile = sizes.pop("sea_0001_detail.df3")
    # Before foam had its cover a map had six slices of its seven.
    cover = sum(
        size // 7 for name, size in sizes.items() if re.fullmatch(r".*(1|far\d)\.df3", name)
    )
    before = sum(sizes.values()) - cover
    print(f"\n{resolution}: {(before + cover + tile) / before:.3f}")
    assert before + cover + tile <= 1.5 * before
