# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Runs the `ocean` program of the environment variable OCEAN in a folder of its own."""

import hashlib
import json
import os
import resource
import shutil
import subprocess
import time
import tomllib
from pathlib import Path

import OpenImageIO
import pytest
from bake_runs import BAKE, pattern
from coasts import BEACH, SEA, grid

OCEAN = os.environ.get("OCEAN", "")
if not Path(OCEAN).is_file():
    pytest.exit("set OCEAN to the path of the program; ctest does", returncode=1)
DATA = Path(__file__).resolve().parent.parent / "data"
# The preview makes no use of a display that is there.
KEPT = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
BUOY = DATA / "spectra" / "ndbc_41010.data_spec"

# Small enough that a bake takes milliseconds.
SMALL_SEA = """libocean = 1
[grid]
resolution = 64
patch_size = 200.0
[[waves]]
spectrum = "jonswap"
wind_speed = 9.0
wind_direction = 30.0
"""
# Enough wind for spray.
GALE = """libocean = 1
[grid]
resolution = 128
patch_size = 160.0
[surface]
choppiness = 1.2
[[waves]]
spectrum = "jonswap"
wind_speed = 20.0
wind_direction = 30.0
fetch = 100000.0
"""


def table(name: str) -> dict:
    """A table of the folder `rows`."""
    return tomllib.loads(Path(__file__).with_name("rows").joinpath(f"{name}.toml").read_text())


def words_of(arguments) -> list[str]:
    """The words of a call, the first of which may be a line of words."""
    return [word for first in arguments[:1] for word in str(first).split()] + [
        str(word) for word in arguments[1:]
    ]


class Program:
    """The program and the folder that it runs in."""

    def __init__(self, folder: Path):
        self.folder = folder

    def __call__(self, *arguments, **options) -> subprocess.CompletedProcess:
        return subprocess.run(
            [OCEAN, *words_of(arguments)],
            cwd=self.folder,
            capture_output=True,
            text=True,
            timeout=options.pop("timeout", 120),
            **options,
        )

    def good(self, *arguments) -> str:
        """Standard output of a run that succeeds."""
        done = self(*arguments)
        assert done.returncode == 0, done.stderr
        return done.stdout

    def bake(self, *arguments) -> list[str]:
        return self.good("bake sea.toml", *words_of(arguments)).splitlines()

    def merge(self, output: str) -> None:
        """Checks a bake of shards and joins their manifests to that of the whole."""
        self.good("check", output, "--merge")

    def bad(self, *arguments, code: int = 2) -> str:
        """The one line that a run prints which fails with this exit code."""
        return check_failure(self(*arguments), code)

    def shell(self, script: str) -> subprocess.CompletedProcess:
        """A line of bash, with $OCEAN as the program."""
        return subprocess.run(
            ["bash", "-c", script],
            cwd=self.folder,
            capture_output=True,
            text=True,
            timeout=120,
            env={**os.environ, "OCEAN": OCEAN},
        )

    def write(self, name: str, text: str | bytes) -> Path:
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def image(self, name: str):
        """The spec of an image and its pixels, the southern row first."""
        buffer = OpenImageIO.ImageBuf(str(self.folder / name))
        assert not buffer.has_error, buffer.geterror()
        return buffer.spec(), buffer.get_pixels(OpenImageIO.FLOAT)[::-1]

    def bytes_of(self, name: str) -> bytes:
        return (self.folder / name).read_bytes()

    def files(self, folder: str = "out") -> list[str]:
        """Returns the names of the files in a folder, including hidden ones."""
        return sorted(path.name for path in (self.folder / folder).iterdir())

    def hashes(self, folder: str) -> dict[str, str]:
        """Returns the hashes of all files in a folder, including the manifest and hidden ones."""
        return {
            path.name: hashlib.sha256(path.read_bytes()).hexdigest()
            for path in sorted((self.folder / folder).iterdir())
        }

    def manifest(self, path: str) -> dict[str, dict]:
        """The entries of a manifest by the names of the files."""
        content = json.loads((self.folder / path).read_text())
        assert content["libocean_manifest"] == 1
        names = [entry["name"] for entry in content["files"]]
        assert names == sorted(set(names))
        return {entry["name"]: entry for entry in content["files"]}


def cpu_seconds(process: subprocess.Popen) -> float:
    """Returns the processor time [s] of all threads of a running program: a measure of its progress
    that does not depend on the load of the machine."""
    return time.clock_gettime(~process.pid << 3 | 2)  # as clock_getcpuclockid() makes it


def kill_at(process: subprocess.Popen, seconds: float) -> None:
    """Kills the program when it has used that much processor time, unless it has ended."""
    while process.poll() is None and cpu_seconds(process) < seconds:
        time.sleep(0.001)
    process.kill()
    process.wait(timeout=120)


def children_seconds() -> float:
    """Returns the processor time [s] of all child processes that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def check_failure(done: subprocess.CompletedProcess, code: int) -> str:
    assert done.returncode == code, (done.returncode, done.stdout, done.stderr)
    lines = done.stderr.splitlines()
    assert len(lines) == 1 and lines[0].startswith("ocean: "), done.stderr
    return lines[0]


@pytest.fixture
def ocean(tmp_path) -> Program:
    program = Program(tmp_path)
    program.write("sea.toml", SMALL_SEA)
    program.write("buoy.toml", f'libocean = 1\n[[waves]]\nspectrum = "measured"\nfile = "{BUOY}"\n')
    return program


@pytest.fixture
def coast(ocean) -> Program:
    """The program in a folder with a sea over a beach."""
    ocean.write("bed.asc", grid(BEACH))
    ocean.write("sea.toml", SEA)
    return ocean


@pytest.fixture
def display(tmp_path, monkeypatch):
    """The name of a screen of 1280 x 800, on which there is nothing; its pixels are in the file
    Xvfb_screen0 of the test's folder. Windows keep their lists of recent files there."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    if shutil.which("Xvfb") is None:
        pytest.fail("Xvfb is needed")
    read, write = os.pipe()
    command = ["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x800x24", "-nolisten", "tcp"]
    command += ["-fbdir", str(tmp_path)]
    command += ["-noreset"]  # else it is not to be reached for a moment after each client
    server = subprocess.Popen(command, pass_fds=[write], stderr=subprocess.DEVNULL)
    os.close(write)
    with os.fdopen(read) as pipe:
        yield ":" + pipe.readline().strip()
    server.terminate()
    server.wait()


@pytest.fixture
def expected(ocean):
    """The names and hashes of ten frames baked in one run, including the manifest."""
    ocean.good(*BAKE, pattern("whole"))
    hashes = ocean.hashes("whole")
    assert len(hashes) == 21
    return hashes
