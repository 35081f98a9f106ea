# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean bake`: the grammar of -o and --frames, and the names of files. What they refuse is in
refusals/bake.toml."""

import pytest
from conftest import table


@pytest.mark.parametrize("row", table("bake_names")["names"], ids=lambda row: row["words"])
def test_names_of_files(ocean, row):
    names, manifest = row["files"].split(), row.get("manifest", "s.manifest.json")
    assert ocean.bake(f"-o {row['words']}") == names
    made = {
        str(path.relative_to(ocean.folder)) for path in ocean.folder.rglob("*") if path.is_file()
    }
    assert made == {"sea.toml", "buoy.toml", manifest, *names}
    assert sorted(ocean.manifest(manifest)) == sorted(name.split("/")[-1] for name in names)


def test_a_pattern_has_the_digits_that_the_help_states(ocean):
    said = " ".join(ocean.good("bake --help").split())
    assert "A lone # is four digits, two or more are one digit each" in said
    for pattern, name in (("#", "a.0005.exr"), ("##", "a.05.exr"), ("####", "a.0005.exr")):
        ocean.bake(f"-o {name}.d/a.{pattern}.exr --products height --frames 5-6")
        assert name.replace("a.", "a.height.") in ocean.files(f"{name}.d")


@pytest.mark.parametrize(("frames", "numbers"), table("bake_names")["frames"].items())
def test_frame_grammar(ocean, frames, numbers):
    names = ocean.bake("-o s.####.exr --products height --frames", frames)
    assert names == [f"s.height.{number}.exr" for number in numbers.split()]
