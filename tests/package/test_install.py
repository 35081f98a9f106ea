# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The installed library as other projects use it: C and C++ programs by CMake, C by pkg-config.

All of it is installed into a folder, which then moves: nothing may know where it was built or
installed. CMake takes generator and compilers from the environment.
"""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

import libocean

HERE = Path(__file__).parent
HEADERS = HERE.parents[1] / "libocean" / "include"
BUILD = Path(os.environ["OCEAN_BUILD"])
WORK = BUILD / "tests" / "package" / "work"
CMAKE = os.environ["CMAKE"]

SEA = """libocean = 1
[grid]
resolution = 64
patch_size = 200.0
[[waves]]
spectrum = "jonswap"
wind_speed = 12.0
wind_direction = 30.0
"""


def run(*command, **options) -> str:
    done = subprocess.run(
        [str(word) for word in command], capture_output=True, text=True, check=False, **options
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def install(name: str, *components: str) -> Path:
    """Installs these components, or everything."""
    command = [CMAKE, "--install", BUILD, "--prefix", WORK / "built" / name]
    for component in components or [None]:
        run(*command, *(["--component", component] if component else []))
    return (WORK / "built" / name).rename(WORK / name)


@pytest.fixture(scope="module", autouse=True)
def work():
    shutil.rmtree(WORK, ignore_errors=True)
    yield
    shutil.rmtree(WORK)


@pytest.fixture(scope="module")
def everything():
    return install("everything")


@pytest.fixture(scope="module")
def c_host():
    return install("c_host", "runtime", "library")


@pytest.fixture(scope="module")
def sea_and_height(tmp_path_factory):
    """A sea file, and what the library of the build prints of it."""
    path = tmp_path_factory.mktemp("sea") / "sea.toml"
    path.write_text(SEA)
    with libocean.open(path) as sea:
        height = sea.query([(10.0, 20.0)], 12.0, foam=False)[0, 2]
    assert abs(height) > 0.01
    return path, f"{height:.9g}\n"


KNOWN = "-DCMAKE_PLATFORM_INFO_INITIALIZED=1"


@pytest.fixture(scope="module")
def compilers(tmp_path_factory):
    """What CMake finds out about the compilers, once for all projects that it configures."""
    folder = tmp_path_factory.mktemp("compilers")
    (folder / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25)\nproject(compilers LANGUAGES C CXX)\n"
    )
    run(CMAKE, "-S", folder, "-B", folder)
    return next(folder.glob("CMakeFiles/*/CMakeCXXCompiler.cmake")).parent


@pytest.fixture
def folder(compilers, tmp_path):
    """A folder for a build that knows the compilers, which KNOWN tells CMake."""
    shutil.copytree(compilers, tmp_path / "CMakeFiles" / compilers.name)
    return tmp_path


def build(project: str, folder: Path, prefix: Path) -> Path:
    run(CMAKE, "-S", HERE / project, "-B", folder, f"-DCMAKE_PREFIX_PATH={prefix}", KNOWN)
    run(CMAKE, "--build", folder)
    return folder / "height"


def look_for(prefix: Path, folder: Path, package: str, *options) -> str:
    """What a project prints that looks for the package: messages, or the targets that it has."""
    (folder / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25)\nproject(look LANGUAGES C CXX)\n"
        f"find_package(libocean {package})\nget_directory_property(targets IMPORTED_TARGETS)\n"
        'list(FILTER targets INCLUDE REGEX "^ocean::")\nlist(SORT targets)\n'
        'message("targets: ${targets}")\n'
    )
    done = subprocess.run(
        [CMAKE, "-S", folder, "-B", folder, f"-DCMAKE_PREFIX_PATH={prefix}", KNOWN, *options],
        capture_output=True,
        text=True,
        check=False,
    )
    return " ".join(done.stderr.split())


def test_headers_and_libraries_are_there(everything):
    theirs = {path.relative_to(HEADERS) for path in HEADERS.rglob("*.h*")}
    include = everything / "include"
    installed = {path.relative_to(include) for path in include.rglob("*") if path.is_file()}
    assert installed == {path for path in theirs if path.parts[:2] != ("ocean", "internal")}
    libraries = {path.stem.removeprefix("libocean_") for path in everything.rglob("*.a")}
    formats = (
        *("elevation", "exr", "file", "geotiff", "image", "mesh", "png", "povray", "provenance"),
        "vdb",
    )
    io = {f"io_{name}" for name in formats}
    assert libraries == {"core", "seafile", "bake", "gl"} | io


def test_the_package_names_no_place(everything):
    files = [*everything.rglob("*.cmake"), *everything.rglob("*.pc")]
    assert len(files) > 5
    for path in files:
        assert not re.findall(r"""(?:^|[\s"';=:]|-[IL])/[\w.].*""", path.read_text(), re.M), path


def test_a_cpp_program_shows_the_sea_of_the_build(everything, sea_and_height, folder):
    sea, height = sea_and_height
    assert run(build("cpp", folder, everything), sea) == height


def test_a_cpp_program_shows_the_sea_by_a_gpu(everything, sea_and_height, folder):
    sea, _ = sea_and_height
    by_gpu, by_cpu = map(float, run(build("gpu", folder, everything), sea).split())
    assert abs(by_gpu - by_cpu) < 1e-5
    assert abs(by_cpu) > 1e-3


def test_a_program_bakes_a_format_of_its_own_and_a_shared_library_holds_all(
    everything, sea_and_height, folder
):
    sea, _ = sea_and_height
    run(build("plugin", folder, everything), sea, folder / "sea.peak")
    with libocean.open(sea) as opened:
        peak = opened.surface(0.0).height.max()
    assert abs(float((folder / "sea.peak").read_text()) - peak) < 1e-5


def test_a_c_host_needs_the_components_runtime_and_library_alone(c_host, sea_and_height, folder):
    sea, height = sea_and_height
    assert run(build("c", folder, c_host), sea) == height
    assert not list(c_host.rglob("*.a")) + list(c_host.rglob("*.hpp"))


def test_a_c_program_by_pkg_config(c_host, sea_and_height, tmp_path):
    sea, height = sea_and_height
    libraries = next(c_host.rglob("libocean.pc")).parent
    environment = {**os.environ, "PKG_CONFIG_PATH": str(libraries)}
    flags = run("pkg-config", "--cflags", "--libs", "libocean >= 0.1", env=environment).split()
    run(os.environ["CC"], HERE / "c" / "height.c", *flags, "-o", tmp_path / "height")
    environment = {**os.environ, "LD_LIBRARY_PATH": str(libraries.parent)}
    assert run(tmp_path / "height", sea, env=environment) == height


@pytest.mark.parametrize(
    ("components", "targets"),
    [
        ("", "ocean::c;ocean::core;ocean::seafile"),
        ("COMPONENTS c", "ocean::c"),
        ("COMPONENTS core", "ocean::core"),
        ("COMPONENTS seafile", "ocean::core;ocean::seafile"),
        (
            "COMPONENTS bake",
            "ocean::bake;ocean::core;ocean::io_elevation;ocean::io_exr;ocean::io_file;"
            "ocean::io_geotiff;"
            "ocean::io_image;ocean::io_mesh;ocean::io_png;ocean::io_povray;"
            "ocean::io_provenance;ocean::io_vdb;ocean::seafile",
        ),
        ("COMPONENTS file", "ocean::core;ocean::io_file"),
        ("COMPONENTS gl", "ocean::core;ocean::gl"),
        ("COMPONENTS c OPTIONAL_COMPONENTS vdb", "ocean::c"),
    ],
)
def test_components_bring_what_they_need(everything, folder, components, targets):
    said = look_for(everything, folder, f"0.1 REQUIRED {components}")
    assert said.endswith(f"targets: {targets}")


@pytest.mark.parametrize(
    ("prefix", "missing", "installed"),
    [
        ("everything", "vdb", "c, core, gl, seafile, file, io, bake"),
        ("c_host", "core", "c"),
    ],
)
def test_a_missing_component_is_named(request, folder, prefix, missing, installed):
    said = look_for(request.getfixturevalue(prefix), folder, f"REQUIRED COMPONENTS c {missing}")
    assert f"No component '{missing}' is installed, but these are: {installed}." in said


@pytest.mark.parametrize("version", ["0.2", "1.0", "0.0.9"])
def test_another_minor_version_is_refused(everything, folder, version):
    said = look_for(everything, folder, f"{version} REQUIRED")
    assert f'compatible with requested version "{version}"' in said
    assert f"version: {libocean.__version__}" in said


@pytest.mark.parametrize(
    ("components", "disabled", "lacking"),
    [
        ("COMPONENTS seafile", "ZLIB", "seafile: ZLIB, which seafile needs (Debian: zlib1g-dev)"),
        ("", "ZLIB", "seafile: ZLIB, which seafile needs (Debian: zlib1g-dev)"),
        ("COMPONENTS bake", "OpenSSL", "bake: OpenSSL, which bake needs (Debian: libssl-dev)"),
        ("COMPONENTS io core", "TIFF", "io: TIFF, which io needs (Debian: libtiff-dev)"),
        ("COMPONENTS gl", "PkgConfig", "gl: PkgConfig, which gl needs (Debian: pkg-config)"),
    ],
)
def test_a_missing_dependency_is_named(everything, folder, components, disabled, lacking):
    option = f"-DCMAKE_DISABLE_FIND_PACKAGE_{disabled}=ON"
    for required in ("REQUIRED ", ""):
        said = look_for(everything, folder, f"{required}{components}", option)
        assert f"Packages are missing for {lacking}." in said
    assert said.endswith("targets:")


def test_an_optional_component_without_its_packages_is_left_out(everything, folder):
    said = look_for(
        *(everything, folder, "REQUIRED COMPONENTS seafile OPTIONAL_COMPONENTS bake"),
        "-DCMAKE_DISABLE_FIND_PACKAGE_OpenEXR=ON",
    )
    assert said.endswith("targets: ocean::core;ocean::io_file;ocean::seafile")


@pytest.mark.parametrize("package", ["OpenVDB", "Boost"])
def test_a_program_that_makes_volumes_builds_without_openvdb(everything, folder, package):
    option = f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON"
    said = look_for(everything, folder, "REQUIRED COMPONENTS io", option)
    assert "ocean::io_vdb" in said


def test_a_missing_module_of_pkg_config_is_named(everything, folder, monkeypatch):
    monkeypatch.setenv("PKG_CONFIG_LIBDIR", str(folder))
    said = look_for(everything, folder, "REQUIRED COMPONENTS gl")
    lacking = "epoxy, which gl needs (Debian: libepoxy-dev)"
    assert f"Packages are missing for gl: {lacking}." in said
