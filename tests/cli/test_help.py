# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Help is read at 80 columns: no option has more than three lines, and each format has a page."""

import os
import re
import subprocess

import pytest
from conftest import OCEAN

COMMANDS = ("info", "bake", "povray", "query", "gauge", "foam-texture", "spectrum", "records",
            "farm", "params", "presets")  # fmt: skip
PROGRAMS = [os.environ[name] for name in ("OCEAN_PREVIEW", "OCEAN_BRIDGE") if os.environ.get(name)]
HELPS = [[OCEAN, "--help"], *([OCEAN, command, "-h"] for command in COMMANDS)]
HELPS += [[program, "--help"] for program in PROGRAMS]
FORMATS = {
    "exr": ("--compression CODEC", "displacement", "out/sea.####.exr"),
    "df3": ("--far-maps", "height, offsets, foam", "out/sea.####.df3"),
    "height_field": ("none of its own", "grey PNG", "out/sea.####.png"),
    "mesh2": ("--eye X,Y,HEIGHT", "POV-Ray meshes", "out/sea.####.inc"),
    "ply": ("--spray-lifetime SECONDS", "position", "out/sea.####.ply"),
    "obj": ("--axes AXES", "normal", "out/sea.####.obj"),
    "usda": ("--products LIST", "velocity", "out/sea.####.usda"),
}
if "vdb" in subprocess.run([OCEAN, "bake", "--help"], capture_output=True, text=True).stdout:
    FORMATS["vdb"] = ("--voxel METRES", "surface", "out/sea.####.vdb")


def text_of(command: list[str]) -> str:
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.endswith("\n")
    return done.stdout


def rows_of(text: str) -> dict[str, int]:
    """The lines of each row: its name stands two blanks from the left, its text farther right."""
    rows = {}
    name = ""
    for line in text.splitlines():
        if re.match(r"  \S", line):
            name = line.split()[0].rstrip(",")
            rows[name] = 1
        elif re.match(r" {20,}\S", line):
            rows[name] += 1
    return rows


@pytest.mark.parametrize(
    "command", HELPS, ids=lambda words: " ".join(words[1:-1]) or words[0][-13:]
)
def test_no_option_has_more_than_three_lines_of_eighty_columns(command):
    text = text_of(command)
    assert max(len(line) for line in text.splitlines()) <= 80
    assert max(rows_of(text).values()) <= 3
    assert len(rows_of(text)) >= 2


@pytest.mark.parametrize("name", FORMATS)
def test_the_page_of_a_format_has_products_options_and_an_example(ocean, name):
    option, product, output = FORMATS[name]
    text = text_of([OCEAN, "bake", "--help", name])
    assert max(len(line) for line in text.splitlines()) <= 80
    assert max(rows_of(text).values()) <= 3
    flat = " ".join(text.split())
    assert (
        option in flat and product in flat and f"ocean bake preset:beaufort_5 -o {output}" in flat
    )
    # The general help has the format in one line.
    row = next(line for line in ocean.good("bake --help").splitlines() if f"  {name} " in line)
    assert output[-4:] in row and rows_of(row) == {name: 1}


def test_the_example_of_a_page_runs(ocean):
    for name in FORMATS:
        text = text_of([OCEAN, "bake", "--help", name]).split("Example:\n")[1].split("\n\n")[0]
        words = text.replace("\\\n", " ").split()
        assert words[:2] == ["ocean", "bake"]
        ocean.good(*words[1:], "-n", "--set", "grid.resolution=64")


def test_a_format_is_found_by_its_name_and_its_extension(ocean):
    page = ocean.good("bake --help mesh2")
    for words in (["--help", "inc"], ["--help", ".inc"], ["-h", "mesh2"], ["--help=mesh2"]):
        assert ocean.good("bake", *words) == page


def test_help_of_another_word_is_refused_with_the_one_meant(ocean):
    message = ocean.bad("bake --help", "vdx" if "vdb" in FORMATS else "exs")
    assert re.search(r"unknown format '\w+'; did you mean \w+\?; known: exr, df3", message)
    # A sea is no page.
    assert ocean.good("bake --help sea.toml") == ocean.good("bake --help")


def test_shared_options_with_other_texts_point_to_the_pages(ocean):
    text = " ".join(ocean.good("bake --help").split())
    assert "--axes AXES Differs: see the help of exr, ply, obj, usda" in text
    assert text.count("Maximum age of a particle of spray") == 1
