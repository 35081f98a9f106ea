# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Runs `ocean povray` and POV-Ray itself in folders of their own."""

import functools
import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

import numpy
import OpenImageIO as oiio
import pytest

import libocean

OCEAN = os.environ.get("OCEAN", "")
N, PERIOD = 128, 100.0  # of the sea that sea_text gives
EXPORTS = tempfile.TemporaryDirectory(prefix="povray_exports")  # removed at the session's end


def pytest_collection_modifyitems(items):
    if shutil.which("povray") is None:
        for item in items:
            item.add_marker(pytest.mark.skip(reason="povray is not installed"))


def sea_text(resolution=N, period=PERIOD, choppiness=0.8, wind=7.0, more="", waves=""):
    return f"""libocean = 1
[grid]
resolution = {resolution}
patch_size = {period}
[surface]
choppiness = {choppiness}
{more}
[[waves]]
spectrum = "pierson_moskowitz"
wind_speed = {wind}
wind_direction = 25.0
{waves}
"""


@functools.cache
def exported(sea: str, *arguments) -> Path:
    """Returns a folder that `ocean povray` wrote once in this session; Folder copies it."""
    path = Path(tempfile.mkdtemp(dir=EXPORTS.name))
    export(path, sea, *arguments)
    return path


def export(path: Path, sea: str, *arguments):
    (path / "its_sea.toml").write_text(sea)
    done = ocean(path, "povray", "its_sea.toml", "-o", ".", *arguments)
    assert done.returncode == 0, done.stderr


class Folder:
    """A folder as `ocean povray` writes it. Tests that ask for the same sea in an empty folder
    share one, each in a copy of its own."""

    def __init__(self, path: Path, sea: str, *arguments):
        self.path = path
        path.mkdir(parents=True, exist_ok=True)
        if any(path.iterdir()):
            export(path, sea, *arguments)
        else:
            shutil.copytree(exported(sea, *arguments), path, dirs_exist_ok=True)

    def run(self, scene: str, *arguments, width=8, height=8, good=True) -> str:
        """Returns POV-Ray's log of a scene, which includes ocean.inc first."""
        return povray(
            self.path,
            '#version 3.7;\n#include "ocean.inc"\n' + scene,
            *arguments,
            width=width,
            height=height,
            good=good,
        )


def ocean(folder: Path, *arguments, **options):
    return subprocess.run(
        [OCEAN, *map(str, arguments)], cwd=folder, capture_output=True, text=True, **options
    )


def povray(folder: Path, scene: str, *arguments, width=8, height=8, good=True) -> str:
    """Renders to out.png, 16 bits a channel, linear."""
    (folder / "test.pov").write_text(scene)
    done = subprocess.run(
        [
            "povray",
            "test.pov",
            "+Oout.png",
            f"+W{width}",
            f"+H{height}",
            "-D",
            "-A",
            "+FN16",
            "File_Gamma=1.0",
            "+WT2",
            *map(str, arguments),
        ],
        cwd=folder,
        capture_output=True,
        text=True,
    )
    assert (done.returncode == 0) == good, done.stderr[-3000:]
    return done.stderr


@pytest.fixture(scope="session")
def choppy(tmp_path_factory):
    return Folder(tmp_path_factory.mktemp("choppy"), sea_text())


def surface(folder, resolution=N):
    """libocean's arrays of the folder's first frame."""
    sea = libocean.open(folder.path / "sea.toml")
    return sea.surface(0.0, resolution=resolution)


def read_png(path):
    """[row, column, channel] from 0 to 1, the bottom row first."""
    image = oiio.ImageInput.open(str(path))
    pixels = image.read_image("uint16").astype(float)[::-1] / 65535.0
    image.close()
    return pixels


def floats_of(log):
    """The values of the lines `V value` that a scene told."""
    return numpy.array([float(word) for word in re.findall(r"^V (\S+)$", log, re.MULTILINE)])


def parse_seconds(log):
    """Returns the processor time [s], which depends less on the load of the machine."""
    return float(re.search(r"Parse Time:[^%]*?([\d.]+) CPU-seconds", log).group(1))
