#!/usr/bin/python3
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Uses the command of the zip for Windows as its users do, under wine: what it bakes is what the
command of this machine bakes, and what it lacks it says.

usage: windows_zip.py ZIP OCEAN WINE_PREFIX
"""

import os
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

import OpenImageIO

SEA = """libocean = 1
[grid]
resolution = 64
patch_size = 200.0
[[waves]]
spectrum = "jonswap"
wind_speed = 9.0
wind_direction = 30.0
"""
LIMIT = 1e-5  # of the largest value of a channel; libraries of mathematics differ in rounding


def pixels(path: Path):
    image = OpenImageIO.ImageBuf(str(path))
    if image.has_error:
        sys.exit(f"windows_zip: {path}: {image.geterror()}")
    return image.spec().channelnames, image.get_pixels(OpenImageIO.FLOAT)


def main() -> None:
    archive, ocean, prefix = (Path(word).resolve() for word in sys.argv[1:])
    quiet = os.environ | {
        "WINEPREFIX": str(prefix), "WINEDEBUG": "-all", "WINEDLLOVERRIDES": "mscoree,mshtml=",
    }  # fmt: skip
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        with zipfile.ZipFile(archive) as files:
            files.extractall(folder)
        program = next(folder.glob("*/ocean.exe"))

        def used(*words: str, fails: bool = False) -> str:
            done = subprocess.run(
                ["wine", program, *words], cwd=folder, env=quiet, capture_output=True, text=True
            )
            if (done.returncode != 0) != fails:
                sys.exit(f"windows_zip: {' '.join(words)}: {done.returncode}\n{done.stderr}")
            return done.stdout + done.stderr

        (folder / "sea.toml").write_text(SEA)
        assert "beaufort_6" in used("presets")
        used("bake", "sea.toml", "--frames", "1-2", "-o", "out/sea.####.exr")
        own = [ocean, "bake", "sea.toml", "--frames", "1-2", "-o", "own/sea.####.exr"]
        subprocess.run(own, cwd=folder, check=True, capture_output=True)
        images = sorted(path.name for path in (folder / "own").glob("*.exr"))
        assert len(images) == 6, images  # three products of two frames
        for image in images:
            names, here = pixels(folder / "own" / image)
            other_names, there = pixels(folder / "out" / image)
            assert names == other_names, (names, other_names)
            difference = abs(there - here).max((0, 1)) / abs(here).max((0, 1)).clip(1e-30)
            assert (difference < LIMIT).all(), (image, names, difference)
        assert "VDB" in used("bake", "sea.toml", "-o", "a.vdb", fails=True)
        assert "no such file" in used("bake", "none.toml", "-o", "a.exr", fails=True)
        subprocess.run(["wineserver", "--kill"], env=quiet, check=False)
    print(f"{archive.name}: bakes what the command here bakes")


if __name__ == "__main__":
    main()
