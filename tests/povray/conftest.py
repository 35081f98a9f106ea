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


TELL = '#macro Tell(Value) #debug concat("V ", str(Value, 0, 12), "\\n") #end\n'


def tell(*values) -> str:
    """The words of a scene that tells these values."""
    return "".join(f'#debug concat("V ", str({value}, 0, 12), "\\n")\n' for value in values)


def flat(cover="0", foam="0", dx="0", dz="0") -> str:
    """The words of a scene whose sea has other functions than its maps."""
    functions = {"Cover": cover, "Foam": foam, "DX": dx, "DZ": dz}
    return "".join(
        f"#undef Ocean_{name}\n#declare Ocean_{name} = function(x, z) {{ {value} }}\n"
        for name, value in functions.items()
    )


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

    head = '#include "ocean.inc"\n'
    load = 'Ocean_Load("sea_0001")\n'

    def run(self, scene: str, *arguments, **options) -> str:
        """Returns POV-Ray's log of a scene, which includes ocean.inc first."""
        return povray(self.path, "#version 3.7;\n" + self.head + scene, *arguments, **options)

    def seen(self, scene: str, *arguments, settings="", **options):
        """Returns the picture of a scene after Ocean_Load, as read_png does."""
        settings = f"global_settings {{ assumed_gamma 1.0 {settings} }}\n"
        self.run(settings + self.load + scene, *arguments, **options)
        return read_png(self.path / "out.png")

    def told(self, scene: str, **options):
        """Returns what a scene tells after Ocean_Load, by Tell or tell()."""
        return floats_of(self.run(self.load + TELL + scene, **options))

    def error(self, scene: str) -> str:
        """Returns the log of a scene that POV-Ray refuses, in a line."""
        return " ".join(self.run(scene, good=False).split())


def ocean(folder: Path, *arguments, **options):
    """Runs a command, whose first words may be one text."""
    words = [*str(arguments[0]).split(), *map(str, arguments[1:])]
    return subprocess.run([OCEAN, *words], cwd=folder, capture_output=True, text=True, **options)


def povray(folder: Path, scene: str, *arguments, width=8, height=8, good=True) -> str:
    """Renders to out.png, 16 bits a channel, linear."""
    (folder / "test.pov").write_text(scene)
    command = f"povray test.pov +Oout.png +W{width} +H{height} -D -A +FN16 File_Gamma=1.0 +WT2"
    done = subprocess.run(
        [*command.split(), *map(str, arguments)], cwd=folder, capture_output=True, text=True
    )
    assert (done.returncode == 0) == good, done.stderr[-3000:]
    return done.stderr


def render_as_it_is(folder: Path, name="scene.pov", *arguments):
    """Renders a scene of a folder by POV-Ray's own settings, to its file; returns the log."""
    command = ["povray", name, *arguments, "-D", "-A"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[-2000:]
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
