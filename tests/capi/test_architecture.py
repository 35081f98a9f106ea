# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Dependencies go one way: core <- seafile <- {io, gl, bridge, capi} <- bake <- apps.

Reads every include below libocean/, every target_link_libraries of its CMakeLists.txt and every
folder that one names. The table LIBRARIES is the rule, for libraries to come as well; what it does
not allow is a breach.
"""

import re
from dataclasses import dataclass, field
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2] / "libocean"

# Public headers that are not core's. io, bake, gl and bridge have folders of their names.
HEADER_OWNER = {
    "libocean.h": "capi",
    "ocean/internal/elevation_file.hpp": "seafile",
    "ocean/internal/checked_text.hpp": "seafile",
    "ocean/internal/child_process.hpp": "sandbox",
    "ocean/internal/csv_rows.hpp": "seafile",
    "ocean/internal/density_units.hpp": "seafile",
    "ocean/internal/directional_record.hpp": "seafile",
    "ocean/internal/elevation_import.hpp": "elevation",
    "ocean/internal/elevation_rules.hpp": "seafile",
    "ocean/internal/send_raster.hpp": "elevation",
    "ocean/io.hpp": "io",
    "ocean/internal/line_reader.hpp": "seafile",
    "ocean/internal/netcdf_spectra.hpp": "netcdf",
    "ocean/internal/record_rules.hpp": "seafile",
    "ocean/seafile.hpp": "seafile",
    "ocean/terrainfile.hpp": "seafile",
    "ocean/internal/toml_sections.hpp": "seafile",
    "ocean/internal/utc_time.hpp": "seafile",
}

STREAMS = frozenset({"iostream", "fstream", "cstdio", "stdio.h"})
SYSTEM = ("fcntl.h", "sys/", "unistd.h")


@dataclass(frozen=True)
class Library:
    """The headers and targets a library may use besides itself; paths are files or folders in it,
    "" is all of it."""

    below: tuple[str, ...]  # libraries; io/file is a part of one: its target and its header
    foreign: dict[str, tuple[str, ...]] = field(default_factory=dict)  # path -> headers begin with
    links: tuple[str, ...] = ()  # foreign targets
    banned: frozenset[str] = frozenset()  # standard headers, but where `foreign` names them
    shared: tuple[str, ...] = ()  # its folders whose headers all of it includes


LIBRARIES = {
    "standard": Library(below=()),  # the standard library, precompiled
    "core": Library(
        below=(),
        # The one file that may know the operating system, that which reads its files, and those
        # that know the processor.
        foreign={
            "": ("wave/", "land/land.hpp", "land/gullies.glsl"),  # formulas of shaders/
            "base/control_groups.cpp": ("fstream",),
            "base/platform.cpp": (
                "fstream",
                "locale.h",
                "sched.h",
                "sys/",
                "unistd.h",
                "windows.h",
                "xlocale.h",
                "xmmintrin.h",
            ),
            "base/text.cpp": ("cstdio",),  # snprintf alone
            "base/simd/simd.hpp": ("immintrin.h",),
            "kernels.cpp": ("cpuid.h",),
        },
        links=("Threads::Threads",),
        banned=STREAMS,
    ),
    "seafile": Library(
        below=("core",),
        foreign={"": ("toml++/", "zlib.h"), "formats/spotter_json.cpp": ("nlohmann/",)},
        links=(
            "nlohmann_json::nlohmann_json",
            "tomlplusplus::tomlplusplus",
            "zlib",
            "ZLIB::ZLIB",
        ),
        banned=frozenset({"iostream"}),
    ),
    "io": Library(
        below=("core", "seafile"),
        foreign={
            "exr": ("Imf",),
            "file": (*SYSTEM, "io.h", "process.h"),
            "mesh": ("wave/",),
            "geotiff": ("tiffio.h",),
            "png": ("png.h", "zlib.h"),
            "povray": ("png.h", "wave/"),
            "vdb": ("dlfcn.h", "openvdb/", "tbb/"),
        },
        links=(
            "${CMAKE_DL_LIBS}",
            "OpenEXR::OpenEXR",
            "OpenVDB::openvdb",
            "PNG::PNG",
            "TIFF::TIFF",
            "ZLIB::ZLIB",
        ),
    ),
    "gl": Library(
        below=("core", "seafile"),
        # The dynamic linker says whether EGL and GLX are present.
        foreign={"": ("dlfcn.h", "epoxy/", "wave/")},
        links=("${CMAKE_DL_LIBS}", "PkgConfig::epoxy"),
    ),
    "preview": Library(
        below=("core", "seafile", "gl"),
        foreign={"": ("epoxy/", "glm/", "wave/", "land/land.hpp")},
        links=("PkgConfig::epoxy", "glm::glm"),
    ),
    "bridge": Library(
        below=("core", "seafile", "io/file"),
        foreign={
            # No header that others include knows the network library, nor a library of boards.
            "address.hpp": ("asio",),
            "connection.cpp": ("asio",),
            "connection.hpp": ("asio",),
            "endpoint.cpp": (*SYSTEM, "arpa/", "ifaddrs.h", "net/", "netinet/"),
            "firmata_source.cpp": ("poll.h",),
            "k8055_usb.hpp": ("libusb.h",),
            "usb_bus.hpp": ("libusb.h",),
            "line_client.cpp": ("asio",),
            "line_server.cpp": ("asio",),
            "osc_message.cpp": ("lo/",),
            "osc_port.hpp": ("asio",),
            "rtmidi_ports.cpp": (*SYSTEM, "RtMidi.h"),
            "serial_port.cpp": (*SYSTEM, "termios.h"),
        },
        links=(
            "PkgConfig::liblo",
            "PkgConfig::libusb",
            "PkgConfig::rtmidi",
            "Threads::Threads",
        ),
        banned=STREAMS,
    ),
    "sandbox": Library(below=("core",), foreign={"child_process.cpp": SYSTEM}),
    "netcdf": Library(
        below=("core", "seafile", "sandbox"),
        foreign={"netcdf_file.cpp": ("netcdf.h",)},
        links=("PkgConfig::netcdf",),
    ),
    "elevation": Library(
        below=("core", "seafile", "io", "sandbox"),
        foreign={
            "exr_raster.cpp": ("Imf",),
            # ocean-raster alone links the target of these files.
            "gdal_place.hpp": ("gdal.h",),
            "gdal_place.cpp": ("gdal", "cpl_", "ogr_"),
            "gdal_raster.cpp": ("gdal", "cpl_", "ogr_", "tiffio.h"),
        },
        links=("OpenEXR::OpenEXR", "PkgConfig::gdal", "TIFF::TIFF"),
    ),
    "capi": Library(below=("core", "seafile"), banned=STREAMS),
    "bake": Library(
        below=("core", "seafile", "io", "gl"),
        foreign={
            "manifest.cpp": SYSTEM,  # its lock
            "manifest_json.cpp": ("nlohmann/",),
            "sha256_openssl.cpp": ("openssl/",),
            "sha256_windows.cpp": ("windows.h", "bcrypt.h"),
        },
        links=("OpenSSL::Crypto", "bcrypt", "nlohmann_json::nlohmann_json"),
    ),
    "apps": Library(
        below=("core", "seafile", "io", "netcdf", "elevation", "gl", "preview", "bridge", "bake"),
        foreign={
            "common/interrupt_windows.cpp": ("windows.h",),
            "common/standard_streams.cpp": ("fcntl.h", "io.h", "unistd.h"),
            "ocean/plot": ("cairo.h",),
            "ocean-bridge/line_input.cpp": ("editline/", "poll.h", "unistd.h"),
            "ocean-preview/window/file_dialog.cpp": (*SYSTEM, "spawn.h"),  # a child beside it
            "ocean-preview": ("GLFW/", "epoxy/", "imgui", "backends/"),
        },
        links=(
            "PkgConfig::cairo",
            "PkgConfig::epoxy",
            "PkgConfig::imgui",
            "PkgConfig::libedit",
            "glfw",
        ),
        shared=("common",),
    ),
}


def owner_of_header(name: str) -> str | None:
    if name in HEADER_OWNER:
        return HEADER_OWNER[name]
    folder = re.match(r"ocean/(?:internal/)?(io|bake|gl|bridge|preview)/", name)
    if folder is not None:
        return folder[1]
    return "core" if name.startswith("ocean/") else None


def may_use(library: str, owner: str, part: str = "") -> bool:
    below = LIBRARIES[library].below
    return owner == library or owner in below or f"{owner}/{part}" in below


def foreign_headers(library: str, file_name: str) -> tuple[str, ...]:
    """Returns the headers the file may include that are neither ours nor the standard library's."""
    allowed = ()
    for path, headers in LIBRARIES[library].foreign.items():
        if path in ("", file_name) or file_name.startswith(path + "/"):
            allowed += headers
    return allowed


def is_beside(library: str, file_name: str, header: str) -> bool:
    """Returns whether it is a header of the library, beside the file or in a folder above it."""
    folder = ROOT / library
    folders = [folder / parent for parent in Path(file_name).parents]
    folders += [folder / shared for shared in LIBRARIES[library].shared]
    return ".." not in header and any((f / header).exists() for f in folders)


def include_breaches(library: str, file_name: str, text: str) -> list[str]:
    banned = LIBRARIES[library].banned
    named = foreign_headers(library, file_name) or ("\0",)
    breaches = []
    for bracket, name in re.findall(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', text, re.M):
        owner = owner_of_header(name)
        standard = bracket == "<" and re.fullmatch(r"[a-z_0-9]+|stddef\.h|stdint\.h", name)
        if owner is not None:
            part = "file" if name.endswith("/io/output_file.hpp") else ""
            allowed = may_use(library, owner, part)
        elif name.startswith(named):
            allowed = True
        elif standard or name in banned:
            allowed = name not in banned
        else:
            allowed = bracket == '"' and is_beside(library, file_name, name)
        if not allowed:
            breaches.append(f"{library}/{file_name} includes {name}")
    return breaches


# Targets that are not named ocean::LIBRARY or ocean::LIBRARY_PART.
TARGET_LIBRARY = {"app_common": "apps", "c": "capi", "commands": "apps"}


def unrolled(text: str) -> str:
    """A CMakeLists.txt whose loops over items are written out."""

    def each(loop: re.Match) -> str:
        name, items, body = loop.groups()
        return "".join(body.replace("${" + name + "}", item) for item in items.split())

    return re.sub(r"foreach\s*\((\w+) IN ITEMS([^)]*)\)(.*?)endforeach\(\)", each, text, flags=re.S)


def link_breaches(library: str, text: str) -> list[str]:
    text = unrolled(re.sub(r"#.*", "", text))
    calls = re.findall(r"target_link_libraries\s*\(\S+([^)]*)\)", text)
    calls += re.findall(r"\bLIBRARIES\s([^)]*)\)", text)  # of ocean_io_library()
    breaches = []
    for arguments in calls:
        wrapped = r"\$<(?:BUILD_INTERFACE|INSTALL_INTERFACE|LINK_ONLY):(\S+)>"
        for name in re.sub(wrapped, r"\1", arguments).split():
            if name in ("PUBLIC", "PRIVATE", "INTERFACE", "ocean_options", "${arg_LIBRARIES}"):
                continue
            own = re.fullmatch(r"ocean(?:::|_)([a-z]+)(?:_(\w+))?", name)
            if own is None:
                allowed = name in LIBRARIES[library].links
            else:
                target = "_".join(filter(None, own.groups()))
                allowed = may_use(library, TARGET_LIBRARY.get(target, own[1]), own[2] or "")
            if not allowed:
                breaches.append(f"{library}/CMakeLists.txt links {name}")
    return breaches


def folder_breaches(library: str, text: str) -> list[str]:
    """Folders of other libraries that a CMakeLists.txt names: what is private stays there."""
    text = re.sub(r"#.*", "", text)
    text = text.replace("$ORIGIN/../", "")  # of a program that is installed
    others = re.findall(r"\blibocean/(\w+)", text)
    foreign = [name for name in others if name in LIBRARIES and name != library]
    foreign += re.findall(r"\S*\.\./\S*|\S*/\.\.(?=\s|\))", text)
    return [f"{library}/CMakeLists.txt reaches into {name}" for name in foreign]


# Folders of core that public headers without a source file of their name belong to.
HEADER_FOLDER = {
    "backend": "waves/modes",
    "channel": "field",
    "coast_waves": "coast/loops",
    "detail": "waves/detail",
    "domain": "field",
    "enum_words": "base",
    "foam_clock": "waves/foam",
    "foam_follower": "waves/foam",
    "foam_layer": "field",
    "gauge": "waves/gauge",
    "linear_shape": "field",
    "platform": "base",
    "land_mask": "field",
    "land_quadtree": "field",
    "map_request": "waves/modes",
    "measured_rings": "land/model",
    "ocean_options": "",
    "page_vector": "base",
    "parameters": "waves/parameters",
    "query": "field",
    "revision": "base",
    "spray": "waves/spray",
    "subject": "",
    "surf_traces": "coast/surface",
    "surface_query": "waves/query",
    "table": "base",
    "terrain_base": "land/model",
    "terrain_model": "land/model",
    "version": "base",
    "world_heights": "",
}


def header_folders() -> dict[str, str]:
    """The folder of core that each public header of core belongs to; "" is core itself."""
    core = ROOT / "core"
    of_stem = {path.stem: str(path.parent.relative_to(core)) for path in core.rglob("*.cpp")}
    folders = {}
    for path in sources(ROOT / "include" / "ocean"):
        name = str(path.relative_to(ROOT / "include"))
        stem = name.removeprefix("ocean/").removeprefix("internal/").removesuffix(".hpp")
        if owner_of_header(name) == "core":
            folder = HEADER_FOLDER.get(stem, of_stem.get(Path(stem).name))
            assert folder is not None, f"{name}: add it to HEADER_FOLDER"
            folders[name] = folder.replace(".", "")
    return folders


def folder_arrows(folder_of: dict[str, str], includes: dict[str, list[str]]) -> dict[str, set]:
    """The folders that each folder includes headers of; both dictionaries have files as keys."""
    arrows = {}
    for name, included in includes.items():
        for header in included:
            if folder_of.get(header, folder_of[name]) != folder_of[name]:
                arrows.setdefault(folder_of[name], set()).add(folder_of[header])
    return arrows


def circle(arrows: dict[str, set]) -> list[str]:
    """The folders that are left when those that no arrow leaves or reaches are taken away, again
    and again."""
    left = {name: set(to) for name, to in arrows.items()}
    while True:
        reached = {to for targets in left.values() for to in targets}
        inner = {name: to & set(left) for name, to in left.items() if name in reached}
        inner = {name: to for name, to in inner.items() if to}
        if inner == left:
            return sorted(left)
        left = inner


def core_arrows() -> dict[str, set]:
    core = ROOT / "core"
    folder_of, includes = header_folders(), {}
    for path in sources(core):
        folder_of[str(path.relative_to(core))] = str(path.parent.relative_to(core)).replace(".", "")
    for path in sources(core) + [ROOT / "include" / name for name in header_folders()]:
        beside = path.parent.relative_to(core) if core in path.parents else None
        name = str(path.relative_to(core if beside is not None else ROOT / "include"))
        included = re.findall(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', path.read_text(), re.M)
        includes[name] = [
            str(beside / header)
            if beside is not None and (path.parent / header).exists()
            else header
            for header in included
        ]
    return folder_arrows(folder_of, includes)


def sources(folder: Path) -> list[Path]:
    return sorted(path for path in folder.rglob("*") if path.suffix in {".cpp", ".hpp", ".h", ".c"})


def cmake_lists(library: str) -> list[Path]:
    return sorted((ROOT / library).rglob("CMakeLists.txt"))


def test_every_library_is_in_the_table():
    folders = {path.name for path in ROOT.iterdir() if (path / "CMakeLists.txt").exists()}
    assert folders <= set(LIBRARIES)
    assert {"core", "seafile", "io", "netcdf", "capi", "apps"} <= folders
    assert all(sources(ROOT / name) for name in folders)


def test_the_table_has_no_circle():
    known = set()
    for name, library in LIBRARIES.items():
        assert {below.split("/")[0] for below in library.below} <= known, name
        known.add(name)


@pytest.mark.parametrize("library", LIBRARIES)
def test_includes_go_one_way(library):
    folder = ROOT / library
    breaches = [
        breach
        for path in sources(folder)
        for breach in include_breaches(library, str(path.relative_to(folder)), path.read_text())
    ]
    assert not breaches


def test_public_headers_go_one_way():
    headers = sources(ROOT / "include")
    assert len(headers) > 10
    for path in headers:
        name = str(path.relative_to(ROOT / "include"))
        assert not include_breaches(owner_of_header(name), name, path.read_text())


def test_folders_of_core_have_no_circle():
    """A folder is a room: what it includes never leads back to it."""
    arrows = core_arrows()
    assert len(arrows) > 20
    inside = circle(arrows)
    assert not inside, {name: sorted(arrows[name] & set(inside)) for name in inside}


def test_a_circle_of_folders_is_found():
    folder_of = {"a/x.cpp": "a", "b/y.hpp": "b", "c/z.hpp": "c"}
    one_way = {"a/x.cpp": ["b/y.hpp"], "b/y.hpp": ["c/z.hpp", "elsewhere.hpp"]}
    assert not circle(folder_arrows(folder_of, one_way))
    assert circle(folder_arrows(folder_of, {**one_way, "c/z.hpp": ["b/y.hpp"]})) == ["b", "c"]


def test_no_folder_of_core_is_wide():
    wide = {
        str(folder.relative_to(ROOT)): count
        for folder in (ROOT / "core").rglob("*")
        if folder.is_dir()
        and (count := len([p for p in folder.iterdir() if p.suffix in (".cpp", ".hpp")])) > 30
    }
    assert not wide
    assert all(
        (folder / "README.md").exists() for folder in (ROOT / "core").rglob("*") if folder.is_dir()
    )


def test_installed_headers_include_installed_ones_alone():
    """ocean/internal/ is for the library's own sources and is not installed."""
    include = ROOT / "include"
    headers = [path for path in sources(include) if "internal" not in path.parts]
    assert 30 < sum(path.suffix == ".hpp" for path in headers) <= 40
    for path in headers:
        assert '"ocean/internal/' not in path.read_text(), path


@pytest.mark.parametrize("library", LIBRARIES)
def test_links_go_one_way(library):
    lists = cmake_lists(library)
    assert not [b for path in lists for b in link_breaches(library, path.read_text())]


@pytest.mark.parametrize("library", LIBRARIES)
def test_private_folders_stay_private(library):
    lists = cmake_lists(library)
    assert not [b for path in lists for b in folder_breaches(library, path.read_text())]


@pytest.mark.parametrize(
    ("library", "file_name", "line"),
    [
        ("core", "modes.cpp", '#include "ocean/seafile.hpp"'),
        ("core", "modes.cpp", "#include <iostream>"),
        ("core", "modes.cpp", "#  include <fstream>"),
        ("core", "modes.cpp", "#include <stdio.h>"),
        ("core", "modes.cpp", "#include <unistd.h>"),
        ("core", "modes.cpp", "#include <toml++/toml.h>"),
        ("core", "modes.cpp", '#include "../seafile/take.hpp"'),
        ("core", "base/platform.cpp", "#include <iostream>"),
        ("seafile", "sea_reader.cpp", '#include "ocean/io/image.hpp"'),
        ("seafile", "sea_reader.cpp", "#include <sys/stat.h>"),
        ("seafile", "sea_reader.cpp", "#include <png.h>"),
        ("capi", "guard.cpp", '#include "ocean/io/image.hpp"'),
        ("capi", "guard.cpp", '#include "ocean/internal/netcdf_spectra.hpp"'),
        ("capi", "guard.cpp", "#include <toml++/toml.h>"),
        ("capi", "guard.cpp", "#include <windows.h>"),
        ("io", "exr/exr_writer.cpp", '#include "libocean.h"'),
        ("io", "exr/exr_writer.cpp", '#include "ocean/bake/plan.hpp"'),
        ("io", "exr/exr_writer.cpp", "#include <png.h>"),
        ("io", "povray/df3.cpp", "#include <ImfIO.h>"),
        ("gl", "program.cpp", '#include "ocean/io/image.hpp"'),
        ("gl", "program.cpp", "#include <GLFW/glfw3.h>"),
        ("bridge", "server.cpp", '#include "ocean/io/image.hpp"'),
        ("bridge", "server.cpp", '#include "ocean/gl/maps.hpp"'),
        ("bridge", "mapping.cpp", "#include <toml++/toml.h>"),
        ("bridge", "hub.cpp", "#include <asio.hpp>"),
        ("bridge", "devices.cpp", "#include <libusb.h>"),
        ("bridge", "osc_port.hpp", "#include <lo/lo.h>"),
        ("netcdf", "cf_units.cpp", "#include <netcdf.h>"),
        ("netcdf", "cf_units.cpp", '#include "take.hpp"'),
        ("netcdf", "cf_units.cpp", '#include "ocean/io/image.hpp"'),
        ("bake", "plan.cpp", '#include "ocean/internal/netcdf_spectra.hpp"'),
        ("bake", "plan.cpp", '#include "console.hpp"'),
        ("bake", "plan.cpp", "#include <openssl/evp.h>"),
        ("apps", "ocean/info_command.cpp", '#include "libocean.h"'),
        ("apps", "ocean/info_command.cpp", "#include <CLI/CLI.hpp>"),
        ("apps", "common/console.cpp", "#include <CLI/CLI.hpp>"),
        ("apps", "ocean/info_command.cpp", '#include "take.hpp"'),
        ("apps", "ocean/info_command.cpp", "#include <cairo.h>"),
    ],
)
def test_a_wrong_include_is_a_breach(library, file_name, line):
    assert include_breaches(library, file_name, line)


def test_a_bridge_writes_files_and_no_images():
    header = '#include "ocean/internal/io/output_file.hpp"'
    assert not include_breaches("bridge", "recorder.cpp", header)
    assert not link_breaches("bridge", "target_link_libraries(t ocean::io_file)")
    assert link_breaches("bridge", "target_link_libraries(t ocean::io_exr)")


@pytest.mark.parametrize(
    ("library", "target"),
    [
        ("core", "ocean::seafile"),
        ("core", "tomlplusplus::tomlplusplus"),
        ("seafile", "ocean::io_exr"),
        ("seafile", "PkgConfig::netcdf"),
        ("seafile", "$<BUILD_INTERFACE:PNG::PNG>"),
        ("capi", "OpenEXR::OpenEXR"),
        ("capi", "ocean::io_file"),
        ("capi", "ocean::netcdf"),
        ("io", "ocean::c"),
        ("io", "ocean::bake"),
        ("gl", "ocean::io_file"),
        ("bridge", "ocean::gl"),
        ("netcdf", "ocean::io_file"),
        ("bake", "ocean::app_common"),
        ("bake", "ocean::netcdf"),
        ("bake", "PkgConfig::cairo"),
        ("apps", "ocean::c"),
        ("apps", "PNG::PNG"),
    ],
)
def test_a_wrong_link_is_a_breach(library, target):
    assert link_breaches(library, f"target_link_libraries(t\n  PUBLIC ocean::core {target})")


def test_a_loop_hides_no_link():
    link = "target_link_libraries(t PRIVATE PkgConfig::${m})"
    loop = f"foreach(m IN ITEMS libusb zlib)\n {link}\nendforeach()"
    assert link_breaches("bridge", loop) == ["bridge/CMakeLists.txt links PkgConfig::zlib"]


@pytest.mark.parametrize(
    "folder",
    ["${PROJECT_SOURCE_DIR}/libocean/seafile", "${CMAKE_CURRENT_SOURCE_DIR}/../io", "../core/base"],
)
def test_a_foreign_folder_is_a_breach(folder):
    line = f"target_include_directories(t PRIVATE {folder})"
    assert folder_breaches("apps", line)
    assert not folder_breaches("apps", line.replace(folder, "${CMAKE_CURRENT_SOURCE_DIR}"))
