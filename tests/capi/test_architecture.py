# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Dependencies go one way: core <- seafile <- {io, gl, bridge, capi} <- bake <- apps.

Reads every include below libocean/, every target_link_libraries of its CMakeLists.txt and every
folder that one names. The table layers.toml is the rule, for libraries to come as well; what it
does not allow is a breach.
"""

import re
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2] / "libocean"


@dataclass(frozen=True)
class Library:
    """What layers.toml allows a library; its words are explained there."""

    below: list[str]
    foreign: dict[str, list[str]] = field(default_factory=dict)
    links: list[str] = field(default_factory=list)
    banned: list[str] = field(default_factory=list)
    shared: list[str] = field(default_factory=list)


RULES = tomllib.loads(Path(__file__).with_name("layers.toml").read_text())
LIBRARIES = {name: Library(**row) for name, row in RULES["library"].items()}
HEADER_OWNER = RULES["header_owner"]
HEADER_FOLDER = RULES["header_folder"]
TARGET_LIBRARY = RULES["target_library"]


def owner_of_header(name: str) -> str | None:
    if name in HEADER_OWNER:
        return HEADER_OWNER[name]
    folder = re.match(r"ocean/(?:internal/)?(io|farm|bake|gl|bridge|preview)/", name)
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
            allowed += tuple(headers)
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


@pytest.mark.parametrize(("library", "file_name", "line"), RULES["breaches"]["includes"])
def test_a_wrong_include_is_a_breach(library, file_name, line):
    assert include_breaches(library, file_name, line)


def test_a_bridge_writes_files_and_no_images():
    header = '#include "ocean/internal/io/output_file.hpp"'
    assert not include_breaches("bridge", "recorder.cpp", header)
    assert not link_breaches("bridge", "target_link_libraries(t ocean::io_file)")
    assert link_breaches("bridge", "target_link_libraries(t ocean::io_exr)")


@pytest.mark.parametrize(("library", "target"), RULES["breaches"]["links"])
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
