# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean foam-texture`: covers that hold in the file, headers, the same bytes."""

import numpy as np
import OpenImageIO
import pytest


def image(ocean, name):
    buffer = OpenImageIO.ImageBuf(str(ocean.folder / name))
    assert not buffer.has_error, buffer.geterror()
    return buffer.spec(), buffer.get_pixels(OpenImageIO.FLOAT)[::-1, :, 0]


def share_below(texture, cover):
    """Returns the share of bilinear samples at random points between texels."""
    random = np.random.default_rng(5)
    right, up = np.roll(texture, -1, 1), np.roll(texture, -1, 0)
    corner = np.roll(right, -1, 0)
    below = []
    for _ in range(8):
        u, v = random.random((2, *texture.shape), np.float32)
        reads = (texture * (1 - u) + right * u) * (1 - v) + (up * (1 - u) + corner * u) * v
        below.append((reads < cover).mean())
    return np.mean(below)


def make(ocean, kind, name, *arguments):
    said = ocean.good("foam-texture", kind, "-o", name, *arguments)
    assert said == f"{name}\n"
    return image(ocean, name)


@pytest.mark.parametrize("kind, period", [("lace", "12"), ("bubbles", "1.3"), ("streaks", "97")])
def test_every_file_is_white_on_the_share_of_its_cover(ocean, kind, period):
    for name, arguments, pixels in (
        ("a.png", [], "uint16"),
        ("a.exr", [], "half"),
        ("f.exr", ["--type", "float"], "float"),
    ):
        spec, texture = make(ocean, kind, name, "--size", "512", *arguments)
        assert (spec.width, spec.height, spec.nchannels) == (512, 512, 1)
        assert str(spec.format) == pixels
        for cover in (0.02, 0.1, 0.5, 0.9):
            assert abs(share_below(texture, cover) - cover) < 0.002
        if name.endswith("png"):
            assert np.abs(texture - texture_of_header(ocean, kind, period)).max() < 1e-5


def texture_of_header(ocean, kind, period):
    spec, texture = make(ocean, kind, "h.exr", "--size", "512", "--type", "float", "--seed", "1")
    assert spec.channelnames == ("Y",)
    assert spec.getattribute("ocean:foam_texture") == kind
    assert spec.getattribute("ocean:period") == period
    assert spec.getattribute("ocean:seed") == "1"
    assert spec.getattribute("ocean:unit") == "1"
    assert spec.getattribute("ocean:version") in ocean.good("--version")
    assert spec.getattribute("wrapmodes") == "periodic"
    return texture


def test_bytes_are_the_same_every_run(ocean):
    for extension in ("png", "exr"):
        for number, threads in enumerate(("1", "3", "1")):
            name = f"{extension}/{number}.{extension}"
            make(ocean, "lace", name, "--size", "64", "--threads", threads, "--seed", "4294967295")
        assert len(set(ocean.hashes(extension).values())) == 1
        assert len(ocean.files(extension)) == 3  # and no temporary
        make(ocean, "lace", f"{extension}/other.{extension}", "--size", "64")
        assert len(set(ocean.hashes(extension).values())) == 2


def test_quiet_says_nothing_and_the_help_all(ocean):
    assert ocean.good("foam-texture lace -o a.png --size 64 -q") == ""
    text = " ".join(ocean.good("foam-texture --help").split())
    for words in ("lace 12 m", "streaks 97 m", "bubbles 1.3 m", "64 .. 4096", "cover"):
        assert words in text


def test_a_folder_that_cannot_be_written(ocean):
    assert "/dev/full" in ocean.shell(
        "ln -s /dev/full full.png; $OCEAN foam-texture lace --size 64 -o full.png"
    ).stderr.replace("full.png", "/dev/full")
