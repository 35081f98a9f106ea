# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Textures that OpenImageIO's maketx makes of our maps, by the line of the README: they repeat,
keep every value and what the header says, and a coarser level is the mean of four."""

import re
import subprocess
from pathlib import Path

import OpenImageIO
import pytest

ROOT = Path(__file__).resolve().parent.parent.parent


def readme_line() -> list[str]:
    """`maketx --wrap periodic ...`, without the names of files."""
    line = re.search(r"^maketx (.*?)( +#.*)?$", (ROOT / "docs/renderers.md").read_text(), re.M)
    words = line[1].split()
    assert words[-3].endswith(".exr") and words[-2:-1] == ["-o"]
    return ["maketx", *words[:-3]]


def levels(path):
    """The spec of a file, and the pixels of each level."""
    image = OpenImageIO.ImageInput.open(str(path))
    spec, found = image.spec(), []
    while image.seek_subimage(0, len(found)):
        found.append(image.read_image("float"))
    image.close()
    return spec, found


@pytest.mark.parametrize("product", ["displacement", "foam", "caustics"])
def test_the_line_of_the_readme(ocean, product):
    # Strong enough for foam.
    ocean.good("bake sea.toml -o s.exr --products", product, "--set", "wind_speed=16")
    command = [*readme_line(), "s.exr", "-o", "s.tx.exr"]
    subprocess.run(command, check=True, cwd=ocean.folder, timeout=120)
    plain_spec, (plain,) = levels(ocean.folder / "s.exr")
    spec, made = levels(ocean.folder / "s.tx.exr")
    assert spec.getattribute("wrapmodes") == "periodic,periodic"
    assert spec.tile_width > 0 and str(spec.format) == "float"
    for name in ("period", "axes", "field", "sea"):
        assert spec.getattribute(f"ocean:{name}") == plain_spec.getattribute(f"ocean:{name}")
    assert [level.shape[0] for level in made] == [64, 32, 16, 8, 4, 2, 1]
    assert (made[0] == plain).all() and plain.std() > 1e-3
    for fine, coarse in zip(made, made[1:], strict=False):
        half = coarse.shape[0]
        mean = fine.reshape(half, 2, half, 2, -1).mean(axis=(1, 3))
        assert abs(coarse.reshape(mean.shape) - mean).max() < 1e-5
    # Another filter would not be the mean.
    other = [word if word != "box" else "lanczos3" for word in command]
    assert other != command
    subprocess.run(other, check=True, cwd=ocean.folder, timeout=120)
    mean = plain.reshape(32, 2, 32, 2, -1).mean(axis=(1, 3))
    wrong = levels(ocean.folder / "s.tx.exr")[1][1].reshape(mean.shape)
    assert abs(wrong - mean).max() > 1e-3
