# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Compares the exports and dependencies of a built libocean with the committed lists beside this
file.

A symbol too many interposes on the host's, one too few breaks a host; a dependency too many is
missing on somebody's machine. Reads ELF and PE files by nm, readelf and objdump (binutils).

usage: check_library.py LIBRARY [--symbols | --dependencies | --glibc 2.28]   (default: the two)
"""

import argparse
import fnmatch
import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).parent


def output_of(*command: str) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def is_pe(library: Path) -> bool:
    return library.read_bytes()[:2] == b"MZ"


def exported_symbols(library: Path) -> list[str]:
    if is_pe(library):
        table = output_of("objdump", "-p", str(library)).split("[Ordinal/Name Pointer] Table")
        if len(table) != 2:
            return []
        lines = table[1].split("\n\n")[0].splitlines()
        return sorted(match[1] for line in lines if (match := re.search(r"\]\s.*?(\w+)$", line)))
    lines = output_of("nm", "-D", "--defined-only", str(library)).splitlines()
    return sorted(line.split()[-1] for line in lines)


def dependencies(library: Path) -> list[str]:
    if is_pe(library):
        return re.findall(r"DLL Name: (\S+)", output_of("objdump", "-p", str(library)))
    return re.findall(r"\(NEEDED\).*\[(.+)\]", output_of("readelf", "-d", "-W", str(library)))


def newest_glibc(library: Path) -> tuple[int, ...]:
    needed = re.findall(r"GLIBC_([0-9.]+)", output_of("readelf", "-V", "-W", str(library)))
    return max(tuple(int(part) for part in version.split(".")) for version in needed)


def symbol_faults(library: Path) -> list[str]:
    expected = set((HERE / "exported_symbols.txt").read_text().split())
    found = set(exported_symbols(library))
    return [
        f"exports {name}, which is not in exported_symbols.txt" for name in found - expected
    ] + [f"does not export {name} of exported_symbols.txt" for name in expected - found]


def dependency_faults(library: Path) -> list[str]:
    allowed = (HERE / "allowed_dependencies.txt").read_text().split()
    return [
        f"needs {name}, which no line of allowed_dependencies.txt allows"
        for name in dependencies(library)
        if not any(fnmatch.fnmatchcase(name, pattern) for pattern in allowed)
    ]


def glibc_faults(library: Path, newest: str) -> list[str]:
    found = newest_glibc(library)
    if found <= tuple(int(part) for part in newest.split(".")):
        return []
    return [f"needs glibc {'.'.join(map(str, found))}; allowed: up to {newest}"]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("library", type=Path)
    parser.add_argument("--symbols", action="store_true")
    parser.add_argument("--dependencies", action="store_true")
    parser.add_argument("--glibc", metavar="VERSION")
    arguments = parser.parse_args()
    both = not (arguments.symbols or arguments.dependencies)

    faults = []
    if both or arguments.symbols:
        faults += symbol_faults(arguments.library)
    if both or arguments.dependencies:
        faults += dependency_faults(arguments.library)
    if arguments.glibc:
        faults += glibc_faults(arguments.library, arguments.glibc)
    for fault in sorted(faults):
        print(f"{arguments.library.name}: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
