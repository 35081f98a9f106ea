# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The wheel with the library inside, as pip installs it, without a source tree and a network."""

import os
import re
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PYTHON = ROOT / "libocean" / "python"
LIBRARY = os.environ["LIBOCEAN_LIBRARY"]


def make(folder: Path) -> Path:
    command = [sys.executable, PYTHON / "make_wheel.py", "--output", folder, LIBRARY]
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True)
    return Path(done.stdout.strip())


@pytest.fixture(scope="module")
def wheel(tmp_path_factory) -> Path:
    return make(tmp_path_factory.mktemp("wheel"))


def test_pip_installs_it_and_the_example_of_its_page_runs(wheel, tmp_path):
    environment = {"PATH": "/usr/bin:/bin", "HOME": str(tmp_path)}

    def run(*command) -> str:
        done = subprocess.run(
            [str(word) for word in command], cwd=tmp_path, env=environment, text=True,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        )  # fmt: skip
        assert done.returncode == 0, done.stdout
        return done.stdout

    # NumPy is the system's.
    run("/usr/bin/python3", "-m", "venv", "--system-site-packages", tmp_path / "venv")
    python = tmp_path / "venv/bin/python"
    run(python, "-m", "pip", "install", "--no-index", "--no-deps", wheel)
    (example,) = re.findall(r"```python\n(.*?)```", (PYTHON / "README.md").read_text(), re.S)
    height = float(run(python, "-I", "-c", example).splitlines()[0])
    assert 2.0 < height < 4.0  # Beaufort 6: a significant wave height of 3 m
    assert "site-packages" in run(python, "-I", "-c", "import libocean; print(libocean.__file__)")


def test_it_holds_types_licences_and_what_an_index_shows(wheel):
    project = tomllib.loads((PYTHON / "pyproject.toml").read_text())["project"]
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        (info,) = {name.split("/")[0] for name in names if ".dist-info/" in name}
        metadata = archive.read(f"{info}/METADATA").decode()
        assert archive.read(f"{info}/LICENSE") == (ROOT / "LICENSE").read_bytes()
        bundled = archive.read(f"{info}/LICENSES-bundled.txt").decode()
    assert "libocean/py.typed" in names
    assert {"toml++", "JSON for Modern C++", "zlib"} <= set(re.findall(r"^(.+?) \(", bundled, re.M))
    version = re.search(r"^Version: (.*)$", metadata, re.M)[1]
    assert version == project["version"] == wheel.name.split("-")[1]
    assert metadata.endswith((PYTHON / "README.md").read_text())
    assert re.search(r"-py3-none-manylinux_2_\d+_x86_64\.whl$", wheel.name)


def test_the_same_library_gives_the_same_bytes(wheel, tmp_path):
    assert make(tmp_path).read_bytes() == wheel.read_bytes()
