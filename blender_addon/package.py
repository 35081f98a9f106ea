# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs the add-on: a zip for Blender before 4.2, an extension for later ones.

usage: python3 blender_addon/package.py --library LIBRARY [--library LIBRARY]...
           [--wheel WHEEL]... [--output FOLDER]

Each library, libocean.so or .dll, is for one platform: it gets a zip of its own for old Blenders,
and a wheel in the one extension. A wheel of another package, such as OpenEXR, goes as it is into
the extension where its Python is one of Blender 4.2's or later, and unpacked into the zip of its
platform. Prints the paths. The same files give the same bytes.
"""

from __future__ import annotations

import argparse
import base64
import dataclasses
import hashlib
import io
import json
import re
import sys
import zipfile
from pathlib import Path

HERE = Path(__file__).parent
NAME = "libocean_addon"
ADDON = HERE / NAME
WRAPPER = HERE.parent / "libocean" / "python" / "libocean"
APACHE = HERE.parent / "LICENSE"
BUNDLED = f"{NAME}/bundled"


@dataclasses.dataclass(frozen=True)
class Platform:
    """A platform of a library, in the words of Blender and of Python wheels."""

    suffix: str
    blender: str
    wheel: str

    def takes(self, tags: str) -> bool:
        """Returns whether a wheel of these platform tags runs on it."""
        system, machine = self.wheel.split("_")[0], self.wheel.rpartition("_")[2]
        return any(tag.startswith(system) and tag.endswith(machine) for tag in tags.split("."))


PLATFORMS = (
    Platform(".so", "linux-x64", "manylinux_2_28_x86_64"),
    Platform(".dll", "windows-x64", "win_amd64"),
    Platform(".dylib", "macos-arm64", "macosx_11_0_arm64"),
)

OLDEST_EXTENSION_PYTHON = 311  # cp311, of Blender 4.2


def platform_of(library: Path) -> Platform:
    """By its name: libocean.so, libocean.so.0.1.0, libocean.dll."""
    for platform in PLATFORMS:
        if platform.suffix in library.suffixes:
            return platform
    known = ", ".join(platform.suffix for platform in PLATFORMS)
    raise argparse.ArgumentTypeError(f"{library} is no {known}")


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
    there = [*ADDON.rglob("*.py"), *ADDON.glob("thumbnails/*.jpg")]
    files = {path.relative_to(ADDON).as_posix(): path.read_bytes() for path in there}
    for name in ("LICENSE", "README.md"):  # F1 opens the latter
        files[name] = (HERE / name).read_bytes()
    return files


def wrapper_files(library: Path) -> dict[str, bytes]:
    """The Python package libocean with its library inside."""
    files = {path.name: path.read_bytes() for path in WRAPPER.glob("*.py")}
    files[f"libocean{platform_of(library).suffix}"] = library.read_bytes()
    return files


def wheel_tags(wheel: Path) -> tuple[str, str]:
    """Python ("cp311") and platforms of a wheel, by its name."""
    parts = wheel.stem.split("-")
    if wheel.suffix != ".whl" or len(parts) < 5 or not parts[-3].startswith("cp"):
        raise argparse.ArgumentTypeError(f"{wheel} is no wheel for one Python")
    return parts[-3], parts[-1]


def unpacked(wheel: Path) -> dict[str, bytes]:
    with zipfile.ZipFile(wheel) as archive:
        return {name: archive.read(name) for name in archive.namelist() if not name.endswith("/")}


def legacy_zip(library: Path, wheels: list[Path]) -> bytes:
    files = {f"{NAME}/{name}": data for name, data in addon_files().items()}
    for name, data in wrapper_files(library).items():
        files[f"{BUNDLED}/libocean/{name}"] = data
    files[f"{BUNDLED}/libocean/LICENSE"] = APACHE.read_bytes()
    files[f"{BUNDLED}/__init__.py"] = b""
    for wheel in wheels:
        python, platforms = wheel_tags(wheel)
        if platform_of(library).takes(platforms):
            for name, data in unpacked(wheel).items():
                files[f"{BUNDLED}/{python}/{name}"] = data
    return zipped(files)


def needed_glibc(library: Path) -> int:
    """The N of the newest glibc 2.N whose symbols it asks for; 0 for a library of no glibc."""
    return max(map(int, re.findall(rb"GLIBC_2\.(\d+)", library.read_bytes())), default=0)


def wheel_platform(library: Path) -> str:
    """Returns the platform tag of its wheel: for Linux, of the glibc that the library really
    needs."""
    tag = platform_of(library).wheel
    oldest = int(re.search(r"manylinux_2_(\d+)", tag)[1]) if "manylinux" in tag else 0
    return tag.replace(f"_2_{oldest}_", f"_2_{max(oldest, needed_glibc(library))}_")


def library_wheel(library: Path) -> tuple[str, bytes]:
    """Name and bytes of a wheel for one platform and every Python: the wrapper is plain ctypes."""
    tag = f"py3-none-{wheel_platform(library)}"
    info = f"libocean-{version()}.dist-info"
    files = {f"libocean/{name}": data for name, data in wrapper_files(library).items()}
    files[f"{info}/METADATA"] = (
        f"Metadata-Version: 2.1\nName: libocean\nVersion: {version()}\nRequires-Dist: numpy>=1.22\n"
    ).encode()
    files[f"{info}/WHEEL"] = (
        f"Wheel-Version: 1.0\nGenerator: libocean\nRoot-Is-Purelib: false\nTag: {tag}\n"
    ).encode()
    files[f"{info}/LICENSE"] = APACHE.read_bytes()
    record = ""
    for name in sorted(files):
        digest = base64.urlsafe_b64encode(hashlib.sha256(files[name]).digest()).rstrip(b"=")
        record += f"{name},sha256={digest.decode()},{len(files[name])}\n"
    files[f"{info}/RECORD"] = f"{record}{info}/RECORD,,\n".encode()
    return f"libocean-{version()}-{tag}.whl", zipped(files)


def extension_zip(libraries: list[Path], others: list[Path]) -> bytes:
    wheels = dict(library_wheel(library) for library in libraries)
    for other in others:
        python, platforms = wheel_tags(other)
        known = any(platform_of(library).takes(platforms) for library in libraries)
        if known and int(python.removeprefix("cp")) >= OLDEST_EXTENSION_PYTHON:
            wheels[other.name] = other.read_bytes()
    manifest = (HERE / "blender_manifest.toml").read_text()
    filled = {
        '"@VERSION@"': json.dumps(version()),
        "@PLATFORMS@": json.dumps([platform_of(library).blender for library in libraries]),
        "@WHEELS@": json.dumps([f"./wheels/{name}" for name in wheels]),
    }
    for mark, text in filled.items():
        manifest = manifest.replace(mark, text)
    files = addon_files()
    files["blender_manifest.toml"] = manifest.encode()
    files |= {f"wheels/{name}": data for name, data in wheels.items()}
    return zipped(files)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "--library",
        type=Path,
        required=True,
        action="append",
        help="libocean.so, .dll or .dylib; once for each platform",
    )
    parser.add_argument(
        "--wheel",
        type=Path,
        default=[],
        action="append",
        help="a wheel of OpenEXR; once for each Python and platform",
    )
    parser.add_argument("--output", type=Path, default=Path(), help="folder for the zips")
    asked = parser.parse_args()
    packed = {}
    for wheel in asked.wheel:
        try:
            wheel_tags(wheel)
        except argparse.ArgumentTypeError as mistake:
            parser.error(str(mistake))
        if not wheel.is_file():
            parser.error(f"{wheel} is not there: scripts/openexr-wheels fetches it")
    for library in asked.library:
        try:
            platform = platform_of(library)
        except argparse.ArgumentTypeError as mistake:
            parser.error(str(mistake))
        if not library.is_file():
            parser.error(f"{library} is not there: build it first")
        packed[f"{NAME}-{version()}-{platform.blender}.zip"] = legacy_zip(library, asked.wheel)
    packed[f"libocean-{version()}.zip"] = extension_zip(asked.library, asked.wheel)
    asked.output.mkdir(parents=True, exist_ok=True)
    for name, data in packed.items():
        (asked.output / name).write_bytes(data)
        print(asked.output / name)
    return 0


if __name__ == "__main__":
    sys.exit(main())
