# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""EXR files as OpenImageIO, exrheader and exrcheck read them.

Claims: values, order and sign of components, orientation, pixel types, compression, header strings
and the layered layout are those of the architecture; half and PXR24 err by their rounding only.
make_exr_samples writes the files from the formula that `sample` repeats.
"""

import os
import shutil
import subprocess

import numpy
import OpenImageIO as oiio
import pytest

N = 64
DX, DY, HEIGHT, NX, NY, NZ, SLOPE_X, SLOPE_Y, JACOBIAN, WHITECAP, FOAM, VX, VY, VZ = range(14)
DX_X, DY_Y, DX_Y, COVER = range(14, 18)
PRODUCTS = {
    "height": [HEIGHT],
    "displacement": [DX, DY, HEIGHT],
    "slope": [SLOPE_X, SLOPE_Y],
    "normal": [NX, NY, NZ],
    "jacobian": [JACOBIAN],
    "whitecap": [WHITECAP],
    "foam": [FOAM],
    "velocity": [VX, VY, VZ],
    "derivatives": [DX_X, DY_Y, DX_Y],
    "cover": [COVER],
}


def sample(channel):
    """[j, i], j from the south."""
    i, j = numpy.meshgrid(numpy.arange(N), numpy.arange(N))
    x, y = 2 * numpy.pi * i / N, 2 * numpy.pi * j / N
    shape = numpy.sin(x + 0.1 * channel) + 0.5 * numpy.cos(2 * y + x + 0.3 * channel)
    return (1 + channel) * shape


@pytest.fixture(scope="session")
def folder(tmp_path_factory):
    path = tmp_path_factory.mktemp("exr")
    subprocess.run([os.environ["OCEAN_EXR_SAMPLES"], str(path)], check=True)
    return path


def read(path):
    """Channel name -> ([j, i] with the bottom scanline first, type), and the spec."""
    image = oiio.ImageInput.open(str(path))
    assert image, oiio.geterror()
    spec = image.spec()
    pixels = image.read_image("float")
    assert not image.seek_subimage(1, 0), "more than one part"
    types = [str(spec.channelformat(c)) for c in range(spec.nchannels)]
    image.close()
    return {name: (pixels[::-1, :, c], types[c]) for c, name in enumerate(spec.channelnames)}, spec


def expected_type(product, forced_half):
    return "float" if product in ("displacement", "velocity") and not forced_half else "half"


def tolerance(values, kind):
    """Half of the last of 11 bits, or a float's own rounding."""
    return numpy.abs(values) * (2.0**-11 if kind == "half" else 2.0**-23) + 1e-6


@pytest.mark.parametrize("product", PRODUCTS)
@pytest.mark.parametrize("suffix", ["", ".half"])
def test_separate(folder, product, suffix):
    channels, spec = read(folder / f"{product}{suffix}.exr")
    kind = expected_type(product, suffix == ".half")
    sources = PRODUCTS[product]
    if len(sources) == 1:
        expected = {"Y": sample(sources[0])}
    elif len(sources) == 2:
        expected = {"R": sample(sources[0]), "G": sample(sources[1]), "B": numpy.zeros((N, N))}
    elif product == "derivatives":  # no vector
        expected = dict(zip("RGB", map(sample, sources), strict=True))
    else:  # tnb: x, z, y
        x, y, z = (sample(c) for c in sources)
        expected = {"R": x, "G": z, "B": y}
    assert list(channels) == list(expected), "what a reader takes first"
    for name, values in expected.items():
        pixels, found = channels[name]
        assert found == kind
        assert numpy.all(numpy.abs(pixels - values) <= tolerance(values, kind)), name
    assert spec.getattribute("compression") == "zip"


@pytest.mark.parametrize("axes,order", [("zup", "+x+y+z"), ("yup", "+x+z-y"), ("tnb", "+x+z+y")])
def test_axes(folder, axes, order):
    channels, spec = read(folder / f"{axes}.exr")
    source = {"x": VX, "y": VY, "z": VZ}
    for name, sign, component in zip("RGB", order[0::2], order[1::2], strict=True):
        expected = float(sign + "1") * sample(source[component])
        assert numpy.abs(channels[name][0] - expected).max() < 1e-5
    assert spec.getattribute("ocean:axes") == axes


@pytest.mark.parametrize("compression", ["none", "rle", "zips", "zip", "piz", "pxr24"])
def test_compression(folder, compression):
    channels, spec = read(folder / f"{compression}.exr")
    assert spec.getattribute("compression") == compression
    truth = sample(HEIGHT)
    error = numpy.abs(channels["G"][0] - truth)
    if compression == "pxr24":  # 15 bits and the hidden one
        assert numpy.all(error <= numpy.abs(truth) * 2.0**-16 + 1e-6)
        assert error.max() > 1e-6, "PXR24 of floats is not exact"
    else:
        assert error.max() < 1e-6


def test_header_strings(folder):
    _, spec = read(folder / "displacement.exr")
    expected = {
        "ocean:sea": "libocean = 1\nseed = 3\n",
        "ocean:frame": "7",
        "ocean:time": "12.25",
        "ocean:axes": "tnb",
        "ocean:period": "100",
        "ocean:field": "displacement",
        "ocean:unit": "m",
        "wrapmodes": "periodic",
    }
    for name, value in expected.items():
        assert spec.getattribute(name) == value, name
    assert spec.getattribute("ocean:version")
    for name in ("chromaticities", "capDate", "DateTime", "HostComputer"):
        assert spec.getattribute(name) is None, name


def test_slope_and_scalars_have_no_axes(folder):
    for product in ("slope", "height"):
        assert read(folder / f"{product}.exr")[1].getattribute("ocean:axes") == "zup"
    assert read(folder / "slope.exr")[1].getattribute("ocean:unit") == "1"


def test_layered(folder):
    channels, spec = read(folder / "layered.exr")
    assert list(channels)[:4] == ["R", "G", "B", "A"]
    assert all(len(name.split(".")[-1]) == 1 for name in channels)
    truth = {
        "R": DX,
        "G": HEIGHT,
        "B": DY,
        "normal.X": NX,
        "normal.Y": NZ,
        "normal.Z": NY,
        "velocity.X": VX,
        "velocity.Y": VZ,
        "velocity.Z": VY,
        "slope.X": SLOPE_X,
        "slope.Y": SLOPE_Y,
        "height.V": HEIGHT,
        "jacobian.V": JACOBIAN,
        "whitecap.V": WHITECAP,
        "foam.V": FOAM,
        "derivatives.X": DX_X,
        "derivatives.Y": DY_Y,
        "derivatives.Z": DX_Y,
        "cover.V": COVER,
    }
    assert set(channels) == set(truth) | {"A"}
    for name, channel in truth.items():
        pixels, kind = channels[name]
        values = sample(channel)
        bare_or_velocity = len(name) == 1 or name.startswith("velocity")
        assert kind == ("float" if bare_or_velocity else "half")
        assert numpy.all(numpy.abs(pixels - values) <= tolerance(values, kind)), name
    assert numpy.all(channels["A"][0] == 1.0)
    assert spec.getattribute("ocean:field") == ",".join(PRODUCTS)


@pytest.mark.parametrize("tool", ["exrheader", "exrcheck"])
def test_openexr_tools_accept_them(folder, tool):
    if shutil.which(tool) is None:
        pytest.skip(f"{tool} is not installed")
    files = sorted(str(f) for f in folder.glob("*.exr"))
    assert len(files) > 20
    result = subprocess.run([tool, *files], capture_output=True, text=True)
    assert result.returncode == 0, result.stdout + result.stderr
    if tool == "exrheader":
        assert 'wrapmodes (type string): "periodic"' in result.stdout
        assert "multipart" not in result.stdout
