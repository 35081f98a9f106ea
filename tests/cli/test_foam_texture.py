# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean foam-texture`: covers that hold in the file, headers, the same bytes."""

import numpy as np
import pytest

import libocean


def make(ocean, kind, name, *arguments):
    said = ocean.good("foam-texture", kind, "-o", name, *arguments)
    assert said == f"{name}\n"
    spec, pixels = ocean.image(name)
    return spec, pixels[..., 0]


@pytest.mark.parametrize("kind, period", [("lace", "12"), ("bubbles", "1.3"), ("streaks", "97")])
def test_every_file_is_the_texture_of_the_library(ocean, kind, period):
    truth = libocean.foam_texture(kind, size=512, seed=1)
    for name, arguments, pixels, rounding in (
        ("a.png", [], "uint16", 0.51 / 65535),
        ("a.exr", [], "half", 2.0**-12),
        ("f.exr", ["--type", "float", "--seed", "1"], "float", 0.0),
    ):
        spec, texture = make(ocean, kind, name, "--size", "512", *arguments)
        assert texture.shape == (512, 512) and spec.nchannels == 1
        assert str(spec.format) == pixels
        assert np.abs(texture - truth).max() <= rounding
    assert spec.channelnames == ("Y",)
    assert spec.getattribute("ocean:foam_texture") == kind
    assert spec.getattribute("ocean:period") == period
    assert spec.getattribute("ocean:seed") == "1"
    assert spec.getattribute("ocean:unit") == "1"
    assert spec.getattribute("ocean:version") in ocean.good("--version")
    assert spec.getattribute("wrapmodes") == "periodic"


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
