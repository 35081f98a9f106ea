# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs the add-on: a zip for Blender before 4.2, an extension for later ones.

usage: python3 blender_addon/package.py [--output FOLDER] WHEEL...

A wheel of libocean (libocean/python/make_wheel.py) is for one platform: it gets a zip of its own
for old Blenders, and goes as it is into the one extension. A wheel of another package, such as
OpenEXR, goes as it is into the extension where its Python is one of Blender 4.2's or later, and
unpacked into the zip of its platform. Prints the paths. The same files give the same bytes.
"""

from __future__ import annotations

import argparse
import io
import json
import sys
import zipfile
from pathlib import Path

HERE = Path(__file__).parent
NAME = "libocean_addon"
ADDON = HERE / NAME
BUNDLED = f"{NAME}/bundled"
LEGACY = "legacy/"  # of the add-on: the zip for Blender before 4.2 alone has it

# The platforms of Blender by how the tag of a wheel begins and ends.
PLATFORMS = {
    ("manylinux", "x86_64"): "linux-x64",
    ("win", "amd64"): "windows-x64",
    ("macosx", "arm64"): "macos-arm64",
}
OLDEST_EXTENSION_PYTHON = 311  # cp311, of Blender 4.2


def wheel_tags(wheel: Path) -> tuple[str, str]:
    """Returns the Python ("cp311", "py3") and Blender's platform of a wheel, by its name."""
    parts = wheel.stem.split("-")
    if wheel.suffix == ".whl" and len(parts) >= 5 and parts[-3].startswith(("cp", "py")):
        for tag in parts[-1].split("."):
            for (system, machine), platform in PLATFORMS.items():
                if tag.startswith(system) and tag.endswith(machine):
                    return parts[-3], platform
    raise argparse.ArgumentTypeError(f"{wheel} is no wheel for one Python and a known platform")


def is_ours(wheel: Path) -> bool:
    return wheel.name.startswith("libocean-")


def version() -> str:
    header = HERE.parent / "libocean" / "include" / "ocean" / "version.hpp"
    line = next(line for line in header.read_text().splitlines() if "OCEAN_VERSION " in line)
    return line.split('"')[1]


def zipped(files: dict[str, bytes]) -> bytes:
    """A zip of these files by their paths; nothing in it depends on when it is made."""
    memory = io.BytesIO()
    with zipfile.ZipFile(memory, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(name, date_time=(1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, files[name])
    return memory.getvalue()


def addon_files() -> dict[str, bytes]:
    kinds = ("*.py", "*.json", "*.po", "thumbnails/*.jpg")
    there = [path for kind in kinds for path in ADDON.rglob(kind)]
    files = {path.relative_to(ADDON).as_posix(): path.read_bytes() for path in there}
    for name in ("LICENSE", "README.md"):  # F1 opens the latter
        files[name] = (HERE / name).read_bytes()
    return files


def unpacked(wheel: Path) -> dict[str, bytes]:
    with zipfile.ZipFile(wheel) as archive:
        return {name: archive.read(name) for name in archive.namelist() if not name.endswith("/")}


def legacy_zip(platform: str, wheels: list[Path]) -> bytes:
    files = {f"{NAME}/{name}": data for name, data in addon_files().items()}
    files[f"{BUNDLED}/__init__.py"] = b""
    for wheel in wheels:
        python, runs_on = wheel_tags(wheel)
        folder = BUNDLED if is_ours(wheel) else f"{BUNDLED}/{python}"
        if runs_on == platform:
            for name, data in unpacked(wheel).items():
                files[f"{folder}/{name}"] = data
    return zipped(files)


def extension_zip(platforms: list[str], given: list[Path]) -> bytes:
    wheels = {}
    for wheel in given:
        python, runs_on = wheel_tags(wheel)
        is_new = python == "py3" or int(python.removeprefix("cp")) >= OLDEST_EXTENSION_PYTHON
        if runs_on in platforms and is_new:
            wheels[wheel.name] = wheel.read_bytes()
    manifest = (HERE / "blender_manifest.toml").read_text()
    filled = {
        '"@VERSION@"': json.dumps(version()),
        "@PLATFORMS@": json.dumps(platforms),
        "@WHEELS@": json.dumps([f"./wheels/{name}" for name in wheels]),
    }
    for mark, text in filled.items():
        manifest = manifest.replace(mark, text)
    files = {name: data for name, data in addon_files().items() if not name.startswith(LEGACY)}
    files["blender_manifest.toml"] = manifest.encode()
    files |= {f"wheels/{name}": data for name, data in wheels.items()}
    return zipped(files)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("wheel", type=Path, nargs="+", help="of libocean and of OpenEXR")
    parser.add_argument("--output", type=Path, default=Path(), help="the folder for the zips")
    asked = parser.parse_args()
    platforms = []
    for wheel in asked.wheel:
        try:
            platform = wheel_tags(wheel)[1]
        except argparse.ArgumentTypeError as mistake:
            parser.error(str(mistake))
        if not wheel.is_file():
            parser.error(f"{wheel} does not exist")
        if is_ours(wheel):
            platforms.append(platform)
    if not platforms:
        parser.error("no wheel of libocean: libocean/python/make_wheel.py makes it")
    packed = {
        f"{NAME}-{version()}-{platform}.zip": legacy_zip(platform, asked.wheel)
        for platform in platforms
    }
    packed[f"libocean-{version()}.zip"] = extension_zip(platforms, asked.wheel)
    asked.output.mkdir(parents=True, exist_ok=True)
    for name, data in packed.items():
        (asked.output / name).write_bytes(data)
        print(asked.output / name)
    return 0


if __name__ == "__main__":
    sys.exit(main())
