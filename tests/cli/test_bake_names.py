# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean bake`: the grammar of -o and --frames, and the names of files. What they refuse is in
refusals/bake.toml."""

import pytest


def bake(ocean, *arguments):
    return ocean.good("bake", "sea.toml", *arguments).splitlines()


@pytest.mark.parametrize(
    ("output", "arguments", "names", "manifest"),
    [
        (
            "o/s.####.exr",
            [],
            ["o/s.displacement.0001.exr", "o/s.normal.0001.exr", "o/s.foam.0001.exr"],
            "o/s.manifest.json",
        ),
        ("o/s.####.exr", ["--products", "height"], ["o/s.height.0001.exr"], "o/s.manifest.json"),
        (
            "s.exr",
            [],
            ["s.displacement.0001.exr", "s.normal.0001.exr", "s.foam.0001.exr"],
            "s.manifest.json",
        ),
        ("s.exr", ["--products", "height"], ["s.exr"], "s.manifest.json"),
        (
            "s.exr",
            ["--products", "height", "--frames", "1,2"],
            ["s.height.0001.exr", "s.height.0002.exr"],
            "s.manifest.json",
        ),
        ("s.exr", ["--layout", "layered"], ["s.exr"], "s.manifest.json"),
        ("s.#.exr", ["--layout", "layered"], ["s.0001.exr"], "s.manifest.json"),
        ("s.###.EXR", ["--layout", "layered"], ["s.001.EXR"], "s.manifest.json"),
        ("s_##.exr", ["--products", "slope"], ["s_slope_01.exr"], "s.manifest.json"),
        ("s%03d.exr", ["--products", "slope"], ["s.slope.001.exr"], "s.manifest.json"),
        ("s-$F6.exr", ["--products", "slope"], ["s-slope-000001.exr"], "s.manifest.json"),
        (
            "s.%d.exr",
            ["--products", "slope", "--frames", "12345"],
            ["s.slope.12345.exr"],
            "s.manifest.json",
        ),
        (
            "s.##.exr",
            ["--products", "slope", "--frames", "12345"],
            ["s.slope.12345.exr"],
            "s.manifest.json",
        ),
        ("####.exr", ["--products", "slope"], ["slope.0001.exr"], "manifest.json"),
        ("a.b/s.v2.exr", ["--products", "slope"], ["a.b/s.v2.exr"], "a.b/s.v2.manifest.json"),
        ("s.png", [], ["s.png", "s.png.txt", "s.png.inc"], "s.manifest.json"),
        (
            "s.png",
            ["--frames", "1-2"],
            [
                f"s.{frame}.png{suffix}"
                for frame in ("0001", "0002")
                for suffix in ("", ".txt", ".inc")
            ],
            "s.manifest.json",
        ),
        ("s_####.inc", [], ["s_0001.inc"], "s.manifest.json"),
    ],
)
def test_names_of_files(ocean, output, arguments, names, manifest):
    assert bake(ocean, "-o", output, *arguments) == names
    made = {
        str(path.relative_to(ocean.folder)) for path in ocean.folder.rglob("*") if path.is_file()
    }
    assert made == {"sea.toml", "buoy.toml", manifest, *names}
    assert sorted(ocean.manifest(manifest)) == sorted(name.split("/")[-1] for name in names)


def test_a_pattern_has_the_digits_that_the_help_states(ocean):
    said = " ".join(ocean.good("bake", "--help").split())
    assert "A lone # is four digits, two or more are one digit each" in said
    for pattern, name in (("#", "a.0005.exr"), ("##", "a.05.exr"), ("####", "a.0005.exr")):
        ocean.good("bake", "sea.toml", "-o", f"{name}.d/a.{pattern}.exr", "--products", "height",
                   "--frames", "5-6")  # fmt: skip
        assert name.replace("a.", "a.height.") in ocean.files(f"{name}.d")


@pytest.mark.parametrize(
    ("frames", "numbers"),
    [
        ("7", ["0007"]),
        ("1-3", ["0001", "0002", "0003"]),
        ("1-9x3", ["0001", "0004", "0007"]),
        ("5,1-2,9", ["0005", "0001", "0002", "0009"]),
        ("1-3,2-4", ["0001", "0002", "0003", "0004"]),
        ("-3", ["-003"]),
        ("-3--1", ["-003", "-002", "-001"]),
        ("-1-1", ["-001", "0000", "0001"]),
    ],
)
def test_frame_grammar(ocean, frames, numbers):
    names = bake(ocean, "-o", "s.####.exr", "--products", "height", "--frames", frames)
    assert names == [f"s.height.{number}.exr" for number in numbers]
