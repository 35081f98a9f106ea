#!/usr/bin/python3
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Packs the Python package libocean with its shared library inside, a wheel for each library.

usage: make_wheel.py [--output FOLDER] LIBRARY...

A library, libocean.so, .dll or .dylib, is for one platform. The wrapper is plain ctypes, so that a
wheel serves every Python. Prints the paths. The same files give the same bytes.
"""

from __future__ import annotations

import argparse
import base64
import hashlib
import io
import re
import sys
import tomllib
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PACKAGE = HERE / "libocean"

# By the suffix of the library: the tag of its platform. That of Linux is raised to the glibc that
# the library needs.
PLATFORMS = {
    ".so": "manylinux_2_28_x86_64",
    ".dll": "win_amd64",
    ".dylib": "macosx_11_0_arm64",
}


def suffix_of(library: Path) -> str:
    """Returns the suffix by the name: libocean.so, libocean.so.0.1.0, libocean.dll."""
    for suffix in PLATFORMS:
        if suffix in library.suffixes:
            return suffix
    raise argparse.ArgumentTypeError(f"{library} is none of {', '.join(PLATFORMS)}")


def platform_tag(library: Path) -> str:
    tag = PLATFORMS[suffix_of(library)]
    symbols = re.findall(rb"GLIBC_2\.(\d+)", library.read_bytes())
    needed = max(map(int, symbols), default=0)
    return re.sub(r"_2_(\d+)_", lambda oldest: f"_2_{max(needed, int(oldest[1]))}_", tag)


def version() -> str:
    header = (ROOT / "libocean/include/ocean/version.hpp").read_text()
    (version,) = re.findall(r'OCEAN_VERSION "(.*?)"', header)
    return str(version)


def metadata(*licences: str) -> str:
    """Returns what a package index shows, from pyproject.toml. licences: the files beside it."""
    project = tomllib.loads((HERE / "pyproject.toml").read_text())["project"]
    lines = [
        "Metadata-Version: 2.1",
        f"Name: {project['name']}",
        f"Version: {version()}",
        f"Summary: {project['description']}",
        f"License: {project['license']['text']}",
        f"Requires-Python: {project['requires-python']}",
        *(f"Requires-Dist: {requirement}" for requirement in project["dependencies"]),
        *(f"Classifier: {name}" for name in project["classifiers"]),
        f"Keywords: {','.join(project['keywords'])}",
        *(f"License-File: {name}" for name in licences),
        "Description-Content-Type: text/markdown",
    ]
    page = (HERE / project["readme"]).read_text()
    return "\n".join(lines) + f"\n\n{page}"


def zipped(files: dict[str, bytes]) -> bytes:
    """Returns a zip of these files by their paths; nothing in it depends on when it is made."""
    memory = io.BytesIO()
    with zipfile.ZipFile(memory, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(name, date_time=(1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, files[name])
    return memory.getvalue()


def wheel_of(library: Path) -> tuple[str, bytes]:
    """Returns the name of a wheel and its bytes."""
    tag = f"py3-none-{platform_tag(library)}"
    info = f"libocean-{version()}.dist-info"
    sources = [*PACKAGE.glob("*.py"), PACKAGE / "py.typed"]
    files = {f"libocean/{path.name}": path.read_bytes() for path in sources}
    files[f"libocean/libocean{suffix_of(library)}"] = library.read_bytes()
    files[f"{info}/METADATA"] = metadata("LICENSE", "LICENSES-bundled.txt").encode()
    files[f"{info}/WHEEL"] = (
        f"Wheel-Version: 1.0\nGenerator: make_wheel.py\nRoot-Is-Purelib: false\nTag: {tag}\n"
    ).encode()
    files[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    files[f"{info}/LICENSES-bundled.txt"] = (HERE / "LICENSES-bundled.txt").read_bytes()
    record = ""
    for name in sorted(files):
        digest = base64.urlsafe_b64encode(hashlib.sha256(files[name]).digest()).rstrip(b"=")
        record += f"{name},sha256={digest.decode()},{len(files[name])}\n"
    files[f"{info}/RECORD"] = f"{record}{info}/RECORD,,\n".encode()
    return f"libocean-{version()}-{tag}.whl", zipped(files)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("library", type=Path, nargs="+", help="libocean.so, .dll or .dylib")
    parser.add_argument("--output", type=Path, default=Path(), help="the folder for the wheels")
    asked = parser.parse_args()
    asked.output.mkdir(parents=True, exist_ok=True)
    for library in asked.library:
        if not library.is_file():
            parser.error(f"{library} does not exist: build it first")
        try:
            name, data = wheel_of(library)
        except argparse.ArgumentTypeError as mistake:
            parser.error(str(mistake))
        (asked.output / name).write_bytes(data)
        print(asked.output / name)
    return 0


if __name__ == "__main__":
    sys.exit(main())
