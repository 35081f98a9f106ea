# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs the add-on, where it is another than before, and runs tests in a Blender with a profile of
its own, emptied before.

usage: start_blender.py --blender PROGRAM --library LIBOCEAN --profile FOLDER -- PYTEST_ARGUMENT...

PROGRAM is a Blender, or a Python that has Blender as its module bpy. The wheels of OpenEXR that
scripts/openexr-wheels fetched are packed too. Profiles side by side share what was packed.
"""

import argparse
import fcntl
import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parents[1]


def sources(library: Path, wheels: list[Path]) -> list[Path]:
    """The files that the zips are made of, and what makes them."""
    addon = [path for path in (ROOT / "blender_addon").rglob("*") if path.is_file()]
    version = ROOT / "libocean" / "include" / "ocean" / "version.hpp"
    wrapper = [path for path in (ROOT / "libocean" / "python").rglob("*") if path.is_file()]
    found = [*addon, *wrapper, version, ROOT / "LICENSE", library, *wheels]
    return sorted(path for path in found if path.suffix != ".pyc")


def pack(library: Path, kept: Path, folder: Path) -> tuple[Path, Path]:
    """Puts the zips of the add-on with this library into a folder: for Blender before 4.2, and for
    later ones. `kept` has those that were packed last, for all who ask at the same time."""
    wheels = sorted((ROOT / "build" / "openexr").glob("*.whl"))
    digest = hashlib.sha256()
    for path in sources(library, wheels):
        digest.update(f"{path} {path.stat().st_size} ".encode() + path.read_bytes())
    packed = kept / digest.hexdigest()
    kept.mkdir(parents=True, exist_ok=True)
    with open(kept.with_suffix(".lock"), "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not packed.exists():
            shutil.rmtree(kept)
            unfinished = kept / "unfinished"
            make_wheel = ROOT / "libocean" / "python" / "make_wheel.py"
            run = [sys.executable, make_wheel, "--output", kept / "wheels", library]
            own = subprocess.run(run, check=True, stdout=subprocess.PIPE, text=True).stdout.split()
            command = [sys.executable, ROOT / "blender_addon" / "package.py", *own, *wheels]
            command += ["--output", unfinished]
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
            unfinished.rename(packed)
        for path in packed.iterdir():
            os.link(path, folder / path.name)
    return next(folder.glob("libocean_addon-*.zip")), next(folder.glob("libocean-*.zip"))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--blender", required=True)
    parser.add_argument("--library", type=Path, required=True)
    parser.add_argument("--profile", type=Path, required=True)
    parser.add_argument("arguments", nargs="+")
    asked = parser.parse_args()

    shutil.rmtree(asked.profile, ignore_errors=True)
    folders = {name: asked.profile / name.lower() for name in ("CONFIG", "SCRIPTS", "DATAFILES")}
    for folder in folders.values():
        folder.mkdir(parents=True)
    legacy, extension = pack(asked.library, asked.profile.parent / "packed", asked.profile)
    environment = {f"BLENDER_USER_{name}": str(folder) for name, folder in folders.items()}
    environment["OCEAN_EXTENSION"] = str(extension.resolve())
    start = [asked.blender]
    if not Path(asked.blender).name.startswith("python"):
        start += ["--background", "--factory-startup", "--python-exit-code", "1", "--python"]
    return subprocess.run(
        [*start, HERE / "run_in_blender.py", "--", legacy, *asked.arguments],
        env={**os.environ, **environment},
    ).returncode


if __name__ == "__main__":
    sys.exit(main())
