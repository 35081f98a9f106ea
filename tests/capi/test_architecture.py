# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Dependencies go one way: core <- seafile <- {io, capi} <- apps.

Reads every include below libocean/ and every target_link_libraries of its CMakeLists.txt. The
table LAYERS is the rule; what it does not allow is a breach.
"""

import re
from dataclasses import dataclass, field
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2] / "libocean"

# The public headers that are not core's.
HEADER_LAYER = {"ocean/seafile.hpp": "seafile", "ocean/io.hpp": "io", "libocean.h": "capi"}


@dataclass(frozen=True)
class Layer:
    below: frozenset[str]  # layers whose headers and targets it may use, itself among them
    libraries: frozenset[str] | None = None  # foreign targets; None: any
    headers: tuple[str, ...] | None = None  # foreign headers by their beginning; None: any
    banned: frozenset[str] = frozenset()  # standard headers it must do without
    excepted: dict[str, tuple[str, ...]] = field(default_factory=dict, hash=False)


def layer(*below: str, **rules) -> Layer:
    return Layer(frozenset(below), **rules)


STREAMS = frozenset({"iostream", "fstream", "cstdio", "stdio.h"})
LAYERS = {
    "core": layer(
        "core",
        libraries=frozenset({"Threads::Threads", "ocean_options"}),
        headers=("wave/",),
        banned=STREAMS,
        # The one file that may know the operating system, and those that know the processor.
        excepted={
            "base/text.cpp": ("cstdio",),  # snprintf alone
            "base/platform.cpp": ("fstream", "sched.h", "sys/", "unistd.h", "windows.h"),
            "kernel/simd.hpp": ("immintrin.h",),
            "kernel/simd_level.cpp": ("cpuid.h",),
        },
    ),
    "seafile": layer(
        "core",
        "seafile",
        libraries=frozenset({"ocean_options", "tomlplusplus::tomlplusplus", "zlib_static"}),
        headers=("toml++/", "zlib.h"),
        banned=frozenset({"iostream"}),
    ),
    "capi": layer(
        "core",
        "seafile",
        "capi",
        libraries=frozenset({"ocean_options"}),
        headers=(),
        banned=STREAMS,
    ),
    "io": layer("core", "seafile", "io"),
    "apps": layer("core", "seafile", "io", "apps"),
}


def layer_of_header(name: str) -> str | None:
    if name in HEADER_LAYER:
        return HEADER_LAYER[name]
    return "core" if name.startswith("ocean/") else None


def include_breaches(layer_name: str, file_name: str, text: str) -> list[str]:
    rule = LAYERS[layer_name]
    breaches = []
    for bracket, name in re.findall(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', text, re.M):
        owner = layer_of_header(name)
        standard = bracket == "<" and re.fullmatch(r"[a-z_0-9]+|stddef\.h|stdint\.h", name)
        folders = (ROOT / layer_name, (ROOT / layer_name / file_name).parent)
        beside = bracket == '"' and ".." not in name and any((f / name).exists() for f in folders)
        excepted = name.startswith(rule.excepted.get(file_name, ("\0",)))
        if owner is not None:
            allowed = owner in rule.below
        elif standard or name in rule.banned:
            allowed = name not in rule.banned or excepted
        else:
            foreign = rule.headers is None or name.startswith(rule.headers or ("\0",))
            allowed = beside or excepted or foreign
        if not allowed:
            breaches.append(f"{layer_name}/{file_name} includes {name}")
    return breaches


def link_breaches(layer_name: str, text: str) -> list[str]:
    rule = LAYERS[layer_name]
    text = re.sub(r"#.*", "", text)
    breaches = []
    for arguments in re.findall(r"target_link_libraries\s*\(([^)]*)\)", text):
        for name in arguments.split()[1:]:
            if name in ("PUBLIC", "PRIVATE", "INTERFACE", "ocean_options"):
                continue
            own = re.fullmatch(r"ocean(?:::|_)(\w+)", name)
            if own is not None:
                part = re.sub("^io_.*|^exr$|^povray$|^mesh$|^vdb$", "io", own[1])
                part = re.sub("^netcdf_spectra$", "apps", part)
                allowed = ("capi" if part == "c" else part) in rule.below
            else:
                allowed = rule.libraries is None or name in rule.libraries
            if not allowed:
                breaches.append(f"{layer_name}/CMakeLists.txt links {name}")
    return breaches


def sources(folder: Path) -> list[Path]:
    return sorted(path for path in folder.rglob("*") if path.suffix in {".cpp", ".hpp", ".h", ".c"})


@pytest.mark.parametrize("layer_name", LAYERS)
def test_includes_go_one_way(layer_name):
    files = sources(ROOT / layer_name)
    breaches = [
        breach
        for path in files
        for breach in include_breaches(
            layer_name, str(path.relative_to(ROOT / layer_name)), path.read_text()
        )
    ]
    assert not breaches


def test_public_headers_go_one_way():
    headers = sources(ROOT / "include")
    assert len(headers) > 10
    for path in headers:
        name = str(path.relative_to(ROOT / "include"))
        owner = layer_of_header(name)
        assert not include_breaches(owner, name, path.read_text())


@pytest.mark.parametrize("layer_name", LAYERS)
def test_links_go_one_way(layer_name):
    lists = list((ROOT / layer_name).rglob("CMakeLists.txt"))
    assert lists
    assert not [b for path in lists for b in link_breaches(layer_name, path.read_text())]


def test_core_seafile_and_capi_have_sources():
    assert all(sources(ROOT / name) for name in ("core", "seafile", "capi"))


@pytest.mark.parametrize(
    ("layer_name", "file_name", "line"),
    [
        ("core", "modes.cpp", '#include "ocean/seafile.hpp"'),
        ("core", "modes.cpp", "#include <iostream>"),
        ("core", "modes.cpp", "#  include <fstream>"),
        ("core", "modes.cpp", "#include <stdio.h>"),
        ("core", "modes.cpp", "#include <unistd.h>"),
        ("core", "modes.cpp", "#include <toml++/toml.h>"),
        ("core", "modes.cpp", '#include "../seafile/text.hpp"'),
        ("core", "base/platform.cpp", "#include <iostream>"),
        ("seafile", "sea_reader.cpp", '#include "ocean/io.hpp"'),
        ("seafile", "sea_reader.cpp", "#include <sys/stat.h>"),
        ("seafile", "sea_reader.cpp", "#include <png.h>"),
        ("capi", "guard.cpp", '#include "ocean/io.hpp"'),
        ("capi", "guard.cpp", "#include <toml++/toml.h>"),
        ("capi", "guard.cpp", "#include <windows.h>"),
        ("io", "exr.cpp", '#include "libocean.h"'),
        ("apps", "info.cpp", '#include "libocean.h"'),
    ],
)
def test_a_wrong_include_is_a_breach(layer_name, file_name, line):
    assert include_breaches(layer_name, file_name, line)


@pytest.mark.parametrize(
    ("layer_name", "library"),
    [
        ("core", "ocean::seafile"),
        ("core", "tomlplusplus::tomlplusplus"),
        ("seafile", "ocean::exr"),
        ("capi", "OpenEXR::OpenEXR"),
        ("capi", "ocean::io"),
        ("io", "libocean::c ocean::c"),
        ("apps", "ocean::c"),
    ],
)
def test_a_wrong_link_is_a_breach(layer_name, library):
    assert link_breaches(layer_name, f"target_link_libraries(t\n  PUBLIC ocean::core {library})")
