# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean terrain fit` on a crop of SRTM: the rings are those that numpy measures, the terrain file
makes land of that spectrum, and what the command cannot do is a sentence."""

import json

import numpy
import OpenImageIO
import pytest
from conftest import DATA

BED = DATA / "elevation" / "jacksboro.tif"


def facts(ocean, *arguments) -> dict:
    return json.loads(ocean.good("terrain fit", *arguments, "--json"))


@pytest.fixture
def bed(ocean) -> str:
    """The elevation model as raw floats."""
    done = ocean("terrain import", BED, "-o", "bed.flt")
    if "built without libtiff" in done.stderr:
        pytest.skip("the program was built without libtiff")
    assert done.returncode == 0, done.stderr
    return "bed.flt"


def numpy_rings(heights, dx, dy, edges):
    """The mean density in rings, by numpy: plane removed, Hann window, no padding."""
    rows, columns = heights.shape
    y, x = numpy.mgrid[0:rows, 0:columns]
    design = numpy.stack([numpy.ones(heights.size), x.ravel(), y.ravel()], axis=1)
    plane = numpy.linalg.lstsq(design, heights.ravel(), rcond=None)[0]
    window = numpy.outer(*(0.5 - 0.5 * numpy.cos(2 * numpy.pi * (numpy.arange(n) + 0.5) / n)
                           for n in (rows, columns)))  # fmt: skip
    spectrum = numpy.fft.fft2((heights - (design @ plane).reshape(heights.shape)) * window)
    density = numpy.abs(spectrum) ** 2 * dx * dy / (4 * numpy.pi**2 * (window**2).sum())
    kx = 2 * numpy.pi * numpy.fft.fftfreq(columns, dx)
    ky = 2 * numpy.pi * numpy.fft.fftfreq(rows, dy)
    ring = numpy.digitize(numpy.hypot(kx[None, :], ky[:, None]), edges)
    return [density[ring == i].mean() for i in range(1, len(edges))]


def test_the_rings_are_those_that_numpy_measures(ocean, bed):
    n = 256  # a power of two: nothing is padded, and both sum the same waves
    dx, dy = json.loads(ocean.good("terrain import", bed, "--json"))["cell"]
    edges = f"0,0,{(n - 0.5) * dx},{(n - 0.5) * dy}"
    ocean.good("terrain import", bed, "-o", "square.flt", "--crop", edges)
    bed = "square.flt"
    heights = numpy.fromfile(ocean.folder / bed, "<f4").reshape(n, n).astype(float)
    lowest = 2 * 2 * numpy.pi / (n * min(dx, dy))
    end = 0.8 * numpy.pi / max(dx, dy)
    count = int(numpy.ceil(4 * numpy.log2(end / lowest)))
    edges = [lowest * 2 ** (i / 4) for i in range(count)] + [end]
    expected = numpy_rings(heights, dx, dy, edges)
    ocean.good("terrain fit", bed, "--rings", "rings.csv", "--seeds", "4")
    rings = numpy.genfromtxt(ocean.folder / "rings.csv", delimiter=",", names=True)
    assert rings.dtype.names == (
        "wavenumber", "density", "count", "model", "scatter", "residual")  # fmt: skip
    assert rings["density"] == pytest.approx(expected, rel=1e-6)
    assert (rings["wavenumber"] >= edges[:-1]).all() and (rings["wavenumber"] < edges[1:]).all()


def test_the_table_law_has_the_density_of_the_land(ocean, bed):
    report = facts(ocean, bed, "-o", "land.toml")
    assert report["law"] == "table" and report["error_above_lowest"] <= 0.05
    assert [octave["error"] <= 0.05 for octave in report["octaves"][1:]].count(True) >= 5
    assert report["octaves"][0]["scatter"] > report["octaves"][3]["scatter"] > 0
    model, terrain = report["model"], report["terrain"]
    assert terrain["rms"] == pytest.approx(model["rms"], rel=0.2)
    assert terrain["slopes"][0] == pytest.approx(model["slopes"][0], rel=0.15)
    # Real slopes end where those of Gaussian land go on.
    assert terrain["slopes"][2] > model["slopes"][2]
    # The file needs the elevation model no more, and makes land.
    for name in ("bed.flt", "bed.hdr", "bed.prj"):
        (ocean.folder / name).unlink()
    text = (ocean.folder / "land.toml").read_text()
    assert text.startswith("# Fitted by `ocean terrain fit` to bed.flt, law table.\n")
    assert 'measured = "bed.flt"' in text and "[terrain.measured_rings]" in text
    assert "The rings decide. beta is" in text
    ocean.good("terrain land.toml -o land.exr")
    heights = OpenImageIO.ImageBuf(str(ocean.folder / "land.exr")).get_pixels()[:, :, 0]
    assert heights.shape == (512, 512)
    assert heights.std() == pytest.approx(model["rms"], rel=0.6)  # one seed


def test_a_broken_law_has_a_few_parameters(ocean, bed):
    report = facts(ocean, bed, "-o", "land.toml", "--law", "broken", "--seeds", "4")
    parameters = {each["name"]: each["value"] for each in report["parameters"]}
    assert list(parameters) == ["beta", "break_wavelength", "break_beta"]
    assert 1.0 < parameters["beta"] < 1.7 and 2.3 < parameters["break_beta"] < 3.0
    assert 500 < parameters["break_wavelength"] < 3000
    text = (ocean.folder / "land.toml").read_text()
    assert "measured_rings" not in text and "breaks = [[" in text
    assert "The rings decide" not in text
    assert ocean.good("info land.toml")
    ridged = facts(ocean, bed, "--law", "broken", "--ridge", "--seeds", "4")
    assert len(ridged["parameters"]) == 6
    one = facts(ocean, bed, "--law", "one", "--seeds", "4")
    assert one["law"] == "one" and one["error_above_lowest"] > report["error_above_lowest"]
    assert any("the table law follows the rings" in warning for warning in one["warnings"])


def test_the_report_can_be_read_and_the_plot_shows_spectrum_and_relief(ocean, bed):
    plot = ("terrain fit", bed, "--plot", "fit.png", "--seeds", "4")
    lines = ocean.good(*plot).splitlines()
    assert lines[0].startswith("model    403 x 344 cells, 30.05 km x 31.81 km")
    assert any(line.startswith("slope 99 %") for line in lines)
    assert max(len(line) for line in lines) <= 80
    image = OpenImageIO.ImageBuf(str(ocean.folder / "fit.png"))
    pixels = image.get_pixels()[:, :, :3]
    height, width = pixels.shape[:2]
    assert width >= 1500 and height == 990
    # Two reliefs on the right have many greys; the density's panel is mostly white.
    right = pixels[150:900, int(0.78 * width) : int(0.95 * width)]
    assert len(numpy.unique((255 * right[..., 0]).round())) > 60
    assert (pixels[150:650, 200 : width // 2] > 0.8).all(axis=2).mean() > 0.8
    ocean.good(*plot, "-q")  # its own
    (ocean.folder / "fit.png").write_bytes(b"\x89PNG mine")
    assert "'fit.png' exists" in ocean.bad(*plot)


def test_land_that_cannot_be_fitted_is_a_sentence(ocean):
    folder = ocean.folder
    header = "ncols {0}\nnrows {0}\nxllcorner 0\nyllcorner 0\ncellsize 9\n"
    (folder / "flat.asc").write_text(header.format(40) + "5 " * 1600)
    (folder / "hole.asc").write_text(header.format(40) + "5 " * 1599 + "-9999")
    for file, words in {
        "flat.asc": "flat land has no spectrum to fit",
        "hole.asc": "`ocean terrain import hole.asc --holes fill -o bed.flt`",
    }.items():
        assert words in ocean.bad("terrain fit", file), file
