# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs the add-on for Blender before 4.2: one zip with the library and its Python wrapper inside.

usage: python3 blender_addon/package.py --library LIBRARY [--output FOLDER]

Prints the path of the zip. The same files give the same bytes.
"""

from __future__ import annotations

import argparse
import sys
import zipfile
from pathlib import Path

HERE = Path(__file__).parent
NAME = "libocean_addon"
WRAPPER = HERE.parent / "libocean" / "python" / "libocean"
BUNDLED = f"{NAME}/bundled"
PLATFORMS = {".so": "linux-x64", ".dll": "windows-x64", ".dylib": "macos-arm64"}


def version() -> str:
    header = HERE.parent / "libocean" / "include" / "ocean" / "version.hpp"
    line = next(line for line in header.read_text().splitlines() if "OCEAN_VERSION " in line)
    return line.split('"')[1]


def contents(library: Path, kind: str) -> dict[str, bytes]:
    """Every file of the zip by its path."""
    files = {f"{NAME}/{path.name}": path for path in (HERE / NAME).glob("*.py")}
    files[f"{NAME}/LICENSE"] = HERE / "LICENSE"
    files |= {f"{BUNDLED}/libocean/{path.name}": path for path in WRAPPER.glob("*.py")}
    files[f"{BUNDLED}/libocean/LICENSE"] = HERE.parent / "LICENSE"
    files[f"{BUNDLED}/libocean/libocean{kind}"] = library
    packed = {name: path.read_bytes() for name, path in files.items()}
    packed[f"{BUNDLED}/__init__.py"] = b""
    return packed


def write_zip(path: Path, files: dict[str, bytes]) -> None:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(name, date_time=(1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, files[name])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--library", type=Path, required=True, help="libocean.so, .dll or .dylib")
    parser.add_argument("--output", type=Path, default=Path(), help="folder for the zip")
    asked = parser.parse_args()
    kind = next((s for s in asked.library.suffixes if s in PLATFORMS), None)  # libocean.so.0.1.0
    if kind is None:
        parser.error(f"{asked.library} is no {', '.join(PLATFORMS)}")
    if not asked.library.is_file():
        parser.error(f"{asked.library} is not there; build it: scripts/test --only tests")
    asked.output.mkdir(parents=True, exist_ok=True)
    path = asked.output / f"{NAME}-{version()}-{PLATFORMS[kind]}.zip"
    write_zip(path, contents(asked.library, kind))
    print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
