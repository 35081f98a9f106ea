# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The Blender add-on for this machine alone, and what a release refuses."""

import os
import re
import subprocess
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def script(name: str, *arguments) -> subprocess.CompletedProcess:
    return subprocess.run(
        [ROOT / "scripts" / name, *map(str, arguments)], capture_output=True, text=True
    )


def thumbnails() -> dict[str, bytes]:
    folder = ROOT / "blender_addon" / "libocean_addon" / "thumbnails"
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def thumbnails_in(archive: zipfile.ZipFile, folder: str) -> dict[str, bytes]:
    names = [name for name in archive.namelist() if name.startswith(folder)]
    return {name.removeprefix(folder): archive.read(name) for name in names}


def test_the_addon_for_this_linux_needs_no_other_compiler(tmp_path):
    """The wheel says which glibc the library really needs."""
    done = script("build-addon", "--linux", "--output", tmp_path)
    assert done.returncode == 0, done.stderr
    names = sorted(path.name for path in tmp_path.iterdir())
    assert len(names) == 2 and names[1].endswith("-linux-x64.zip")
    library = Path(os.environ["LIBOCEAN_LIBRARY"])
    needed = max(map(int, re.findall(rb"GLIBC_2\.(\d+)", library.read_bytes())))
    with zipfile.ZipFile(tmp_path / names[0]) as extension:
        wheels = [name for name in extension.namelist() if "wheels/libocean" in name]
        assert len(wheels) == 1
        assert thumbnails_in(extension, "thumbnails/") == thumbnails()
        assert wheels[0].endswith(f"-py3-none-manylinux_2_{max(28, needed)}_x86_64.whl")
        assert 'platforms = ["linux-x64"]' in extension.read("blender_manifest.toml").decode()
    with zipfile.ZipFile(tmp_path / names[1]) as legacy:
        assert thumbnails_in(legacy, "libocean_addon/thumbnails/") == thumbnails()
        (bundled,) = (name for name in legacy.namelist() if name.endswith("libocean.so"))
        assert legacy.read(bundled) == library.read_bytes()


@pytest.mark.skipif(not (ROOT / ".git").exists(), reason="these sources are no clone")
def test_a_release_is_of_what_is_committed(tmp_path):
    """In a clone with a change that no commit holds."""
    clone = tmp_path / "clone"
    subprocess.run(["git", "clone", "-q", "--depth", "1", f"file://{ROOT}", clone], check=True)
    (clone / "README.md").write_text("changed")
    done = subprocess.run([clone / "scripts" / "release"], capture_output=True, text=True)
    assert done.returncode == 1 and "changes that no commit holds" in done.stderr
    assert not (clone / "build").exists()
