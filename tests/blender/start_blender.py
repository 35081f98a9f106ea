# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs the add-on and runs tests in a Blender with a profile of its own, emptied before.

usage: start_blender.py --blender PROGRAM --library LIBOCEAN --profile FOLDER -- PYTEST_ARGUMENT...

PROGRAM is a Blender, or a Python that has Blender as its module bpy. The wheels of OpenEXR that
scripts/openexr-wheels fetched are packed too.
"""

import argparse
import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parents[1]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--blender", required=True)
    parser.add_argument("--library", required=True)
    parser.add_argument("--profile", type=Path, required=True)
    parser.add_argument("arguments", nargs="+")
    asked = parser.parse_args()

    shutil.rmtree(asked.profile, ignore_errors=True)
    folders = {name: asked.profile / name.lower() for name in ("CONFIG", "SCRIPTS", "DATAFILES")}
    for folder in folders.values():
        folder.mkdir(parents=True)
    wheels = sorted((ROOT / "build" / "openexr").glob("*.whl"))
    packed = subprocess.run(
        [sys.executable, ROOT / "blender_addon" / "package.py", "--library", asked.library]
        + [f"--wheel={wheel}" for wheel in wheels]
        + ["--output", asked.profile],
        check=True,
        stdout=subprocess.PIPE,
        text=True,
    )
    legacy, extension = packed.stdout.split()
    environment = {f"BLENDER_USER_{name}": str(folder) for name, folder in folders.items()}
    environment["OCEAN_EXTENSION"] = str(Path(extension).resolve())
    start = [asked.blender]
    if not Path(asked.blender).name.startswith("python"):
        start += ["--background", "--factory-startup", "--python-exit-code", "1", "--python"]
    return subprocess.run(
        [*start, HERE / "run_in_blender.py", "--", legacy, *asked.arguments],
        env={**os.environ, **environment},
    ).returncode


if __name__ == "__main__":
    sys.exit(main())
