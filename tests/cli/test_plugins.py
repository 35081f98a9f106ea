# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A format and a channel of a host (plugins/ocean_with_plugins.cpp) are baked, hashed, resumed and
listed by --help like the library's own."""

import hashlib
import json
import os
import re
import subprocess

import numpy as np
import OpenImageIO as oiio
import pytest

SMALL = ["preset:beaufort_6", "--set", "grid.resolution=64", "--set", "grid.patch_size=60"]


def run(*arguments, cwd=None, code=0):
    command = [os.environ["OCEAN_WITH_PLUGINS"], *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, cwd=cwd, timeout=120)
    assert done.returncode == code, done.stderr
    return done


def pixels(path):
    image = oiio.ImageInput.open(str(path))
    return np.asarray(image.read_image(oiio.FLOAT))


@pytest.fixture
def baked(tmp_path):
    run("bake", *SMALL, "-o", "sea.####.stats", "--frames", "1-3", cwd=tmp_path)
    return tmp_path


def entries(folder):
    return json.loads((folder / "sea.manifest.json").read_text())["files"]


def test_help_lists_the_format_and_its_options():
    text = " ".join(run("bake", "--help").stdout.split())
    assert " stats .stats Statistics " in text
    assert "Statistics:" in text and "--digits N Decimals of a number" in text
    # Its page is made without a text of its own.
    page = " ".join(run("bake", "--help", "stats").stdout.split())
    assert page.startswith(
        "Statistics Usage: ocean bake SEA -o out/sea.####.stats [OPTIONS] Options"
    )
    assert "--digits N Decimals of a number; default 3 Example: ocean bake preset:" in page
    products = run("bake", "--help", "exr").stdout.split("Options of")[0]
    assert re.search(r"^  steepness$", products, re.MULTILINE)


@pytest.mark.parametrize("backend", ["cpu", "radix2", "dft"])
def test_the_channel_is_the_magnitude_of_the_slope_in_every_backend(tmp_path, backend):
    run("bake", *SMALL, "-o", "sea.exr", "--products", "slope,steepness", "--type", "float",
        "--backend", backend, cwd=tmp_path)  # fmt: skip
    slope = pixels(tmp_path / "sea.slope.0001.exr")
    steepness = pixels(tmp_path / "sea.steepness.0001.exr")[..., 0]
    assert steepness.std() > 0.01
    np.testing.assert_allclose(steepness, np.hypot(slope[..., 0], slope[..., 1]), rtol=1e-6)


def test_the_format_is_baked(baked):
    run("bake", *SMALL, "-o", "sea.exr", "--products", "height,steepness", "--type", "float",
        cwd=baked)  # fmt: skip
    truth = [pixels(baked / f"sea.{name}.0001.exr") for name in ("height", "steepness")]
    numbers = [float(line) for line in (baked / "sea.0001.stats").read_text().split()]
    assert numbers == pytest.approx([np.sqrt(np.mean(map_**2)) for map_ in truth], abs=6e-4)


def test_the_format_is_hashed(baked):
    listed = entries(baked)
    assert [entry["name"] for entry in listed] == [f"sea.000{n}.stats" for n in (1, 2, 3)]
    for entry in listed:
        data = (baked / entry["name"]).read_bytes()
        assert entry["sha256"] == hashlib.sha256(data).hexdigest()
        decoded = "".join(f"{float(line):.9f}" for line in data.split())
        assert entry["pixels_sha256"] == hashlib.sha256(decoded.encode()).hexdigest()
        assert entry["product"] == "height,steepness"


def test_the_format_is_resumed(baked):
    again = ["bake", *SMALL, "-o", "sea.####.stats", "--frames", "1-3", "--skip-existing"]
    assert run(*again, "-n", cwd=baked).stdout.count("kept") == 3
    before = {path: path.read_bytes() for path in baked.glob("*.stats")}
    (baked / "sea.0002.stats").write_text("0.1\n")
    forecast = run(*again, "-n", cwd=baked)
    assert forecast.stdout.count("kept") == 2
    done = run(*again, cwd=baked)
    assert "3 of 3 frames done, 2 of them skipped" in done.stderr
    assert {path: path.read_bytes() for path in baked.glob("*.stats")} == before
    # With other options it is another file.
    assert run(*again, "--digits", "4", "-n", cwd=baked).stdout.count("kept") == 0


def test_options_of_others_are_refused(tmp_path):
    done = run("bake", *SMALL, "-o", "a.stats", "--axes", "zup", cwd=tmp_path, code=2)
    assert "--axes zup: only files of type .exr, .ply, .obj, .usda and .vdb have it" in done.stderr
    done = run("bake", *SMALL, "-o", "a.exr", "--digits", "4", cwd=tmp_path, code=2)
    assert "--digits 4: only files of type .stats have it" in done.stderr
    done = run("bake", *SMALL, "-o", "a.stats", "--digits", "x", cwd=tmp_path, code=2)
    assert "--digits = x; allowed: a number, 1 .. 9" in done.stderr
