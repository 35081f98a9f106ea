# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The Blender add-on for this machine alone, by the rules of Blender's site for extensions
(blender_addon/PUBLISHING.md), the list of a release's parts, and what a release refuses."""

import ast
import json
import os
import re
import shutil
import subprocess
import tomllib
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def script(name: str, *arguments) -> subprocess.CompletedProcess:
    return subprocess.run(
        [ROOT / "scripts" / name, *map(str, arguments)], capture_output=True, text=True
    )


def thumbnails() -> dict[str, bytes]:
    folder = ROOT / "blender_addon" / "libocean_addon" / "thumbnails"
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def thumbnails_in(archive: zipfile.ZipFile, folder: str) -> dict[str, bytes]:
    names = [name for name in archive.namelist() if name.startswith(folder)]
    return {name.removeprefix(folder): archive.read(name) for name in names}


@pytest.fixture(scope="module")
def built(tmp_path_factory) -> Path:
    """The folder with the zips for this machine, and the wheel beside them."""
    folder = tmp_path_factory.mktemp("addon")
    for name, place in (("build-addon", folder), ("wheels", folder / "wheels")):
        done = script(name, "--linux", "--output", place)
        assert done.returncode == 0, done.stderr
    return folder


@pytest.fixture(scope="module")
def extension(built) -> dict[str, bytes]:
    """The files of the extension by their names."""
    (path,) = built.glob("libocean-*.zip")
    with zipfile.ZipFile(path) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


@pytest.fixture(scope="module")
def manifest(extension) -> dict:
    return tomllib.loads(extension["blender_manifest.toml"].decode())


@pytest.fixture(scope="module")
def code(extension) -> dict[str, list[ast.AST]]:
    """All nodes of each Python file of the extension."""
    return {
        name: list(ast.walk(ast.parse(data)))
        for name, data in extension.items()
        if name.endswith(".py")
    }


def test_the_addon_for_this_linux_needs_no_other_compiler(built):
    """The wheel says which glibc the library really needs."""
    names = sorted(path.name for path in built.glob("*.zip"))
    assert len(names) == 2 and names[1].endswith("-linux-x64.zip")
    library = Path(os.environ["LIBOCEAN_LIBRARY"])
    needed = max(map(int, re.findall(rb"GLIBC_2\.(\d+)", library.read_bytes())))
    with zipfile.ZipFile(built / names[0]) as extension:
        wheels = [name for name in extension.namelist() if "wheels/libocean" in name]
        assert len(wheels) == 1
        assert thumbnails_in(extension, "thumbnails/") == thumbnails()
        assert wheels[0].endswith(f"-py3-none-manylinux_2_{max(28, needed)}_x86_64.whl")
        assert 'platforms = ["linux-x64"]' in extension.read("blender_manifest.toml").decode()
    with zipfile.ZipFile(built / names[1]) as legacy:
        assert thumbnails_in(legacy, "libocean_addon/thumbnails/") == thumbnails()
        (bundled,) = (name for name in legacy.namelist() if name.endswith("libocean.so"))
        assert legacy.read(bundled) == library.read_bytes()


# The rules of extensions -----------------------------------------------------------


def test_a_wheel_that_needs_a_later_runtime_than_blender_has_is_refused(tmp_path):
    folder = ROOT / "build" / "openexr"
    done = script("windows-imports", *folder.glob("*.whl"))
    assert (done.returncode, done.stderr) == (0, "")
    (newest,) = folder.glob("*-cp313-cp313-win_amd64.whl")  # Blender 5.1 has its MSVCP140
    for name in ("OpenEXR-1-cp311-cp311-win_amd64.whl", "libocean-1-py3-none-win_amd64.whl"):
        wheel = tmp_path / name
        shutil.copy(newest, wheel)
        addon = tmp_path / "addon.zip"
        with zipfile.ZipFile(addon, "w") as archive:
            archive.write(wheel, f"wheels/{name}")
        for refused in (wheel, addon):
            done = script("windows-imports", refused)
            assert done.returncode == 1
            assert f"{name}: OpenEXR.pyd imports MSVCP140.dll" in done.stderr
    with zipfile.ZipFile(newest) as archive:
        done = script("windows-imports", archive.extract("OpenEXR.pyd", tmp_path))
    assert done.returncode == 1


def test_the_wheels_in_the_extension_are_the_released_ones_byte_for_byte(built, extension):
    released = [*(built / "wheels").glob("*.whl"), *(ROOT / "build" / "openexr").glob("*.whl")]
    ours = {path.name: path.read_bytes() for path in released}
    bundled = {name: data for name, data in extension.items() if name.endswith(".whl")}
    assert sum("libocean" in name for name in bundled) == 1
    assert any("openexr" in name for name in bundled)
    for name, data in bundled.items():
        assert data == ours[Path(name).name], name


def test_the_manifest_lists_what_is_there_and_asks_for_files_alone(manifest, extension):
    wheels = {f"./{name}" for name in extension if name.endswith(".whl")}
    assert set(manifest["wheels"]) == wheels
    assert list(manifest["permissions"]) == ["files"]
    for text in (manifest["tagline"], *manifest["permissions"].values()):
        assert len(text) <= 64 and text[-1].isalnum()
    assert manifest["license"] == ["SPDX:GPL-3.0-or-later"]
    assert all(re.match(r"\d{4}(-\d{4})? \S", holder) for holder in manifest["copyright"])
    holders = " ".join(manifest["copyright"])
    bundled = (ROOT / "libocean" / "python" / "LICENSES-bundled.txt").read_text()
    for holder in ("Mark Gillard", "Niels Lohmann", "Jean-loup Gailly", "OpenEXR Project"):
        assert holder in holders
        assert holder in bundled or holder == "OpenEXR Project"
    for text in (manifest["name"], manifest["tagline"], manifest["id"]):
        assert "blender" not in text.lower()


def test_the_extension_holds_sources_pictures_texts_and_wheels_alone(extension):
    kinds = {Path(name).suffix for name in extension}
    assert kinds == {".py", ".jpg", ".json", ".md", ".po", ".toml", ".whl", ""}
    assert [name for name in extension if not Path(name).suffix] == ["LICENSE"]
    assert not [name for name in extension if name.startswith(("legacy/", "bundled/"))]


def imported(node: ast.AST) -> list[str]:
    """Returns the names of modules that a statement imports, those of this package without one."""
    if isinstance(node, ast.Import):
        return [alias.name.split(".")[0] for alias in node.names]
    if isinstance(node, ast.ImportFrom) and node.level == 0:
        return [node.module.split(".")[0]]
    return []


# No network: so no updater, and no installer of packages.
NETWORK = {"ftplib", "http", "pip", "requests", "smtplib", "socket", "ssl", "urllib", "xmlrpc"}


def test_its_code_uses_no_network_and_runs_nothing_but_blender(code):
    for name, nodes in code.items():
        modules = {module for node in nodes for module in imported(node)}
        assert not modules & NETWORK, name
        calls = {ast.unparse(node.func) for node in nodes if isinstance(node, ast.Call)}
        assert not calls & {"eval", "exec", "os.system", "os.popen"}, name
        # The asset library is written by a second Blender, whose path Blender itself names.
        runs = {call for call in calls if call.startswith("subprocess.")}
        expected = {"subprocess.run"} if name == "assets/asset_library.py" else set()
        assert runs - {"subprocess.list2cmdline"} == expected, name
    started = [
        ast.unparse(node)
        for node in code["assets/asset_library.py"]
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "start"
    ]
    assert len(started) == 2
    assert all("sys.executable" in line or "bpy.app.binary_path" in line for line in started)


def test_its_code_changes_no_path_of_modules_and_writes_nothing_beside_itself(code):
    for name, nodes in code.items():
        text = {ast.unparse(node) for node in nodes if isinstance(node, ast.Attribute)}
        # The second Blender gets the paths of the first one.
        allowed = {"assets/asset_library.py", "assets/write_assets.py"}
        assert "sys.path" not in text or name in allowed, name
        files = [node for node in nodes if isinstance(node, ast.Name) and node.id == "__file__"]
        # Thumbnails, the page that F1 opens, German texts, tables of settings, the script for the
        # second Blender: they are read.
        readers = {"assets/assets.py", "manual.py", "translations.py"} | allowed
        readers.add("shared/table_properties.py")
        assert not files or name in readers, name


def test_pictures_in_it_are_small(extension):
    pictures = {name: data for name, data in extension.items() if name.endswith(".jpg")}
    assert len(pictures) > 10
    for name, data in pictures.items():
        assert len(data) < 20_000, name


def test_each_rule_of_the_check_list_names_a_test_that_exists():
    page = (ROOT / "blender_addon" / "PUBLISHING.md").read_text()
    rules = re.findall(r"^\| (.+?) \| (.+?) \|$", page, re.M)[2:]
    assert len(rules) > 15
    sources = {}
    for folder in ("package", "blender"):
        for path in (ROOT / "tests" / folder).glob("test_*.py"):
            sources[path.name] = path.read_text()
    for rule, check in rules:
        named = re.findall(r"`(test_\w+\.py)::(test_\w+)`", check)
        assert named or check.startswith("By hand: "), rule
        for file, function in named:
            assert f"def {function}(" in sources[file], (rule, function)


# A release -------------------------------------------------------------------------


@pytest.fixture(scope="module")
def listed(built, tmp_path_factory) -> Path:
    """The list of the parts of wheel and add-on."""
    folder = tmp_path_factory.mktemp("release")
    for path in [*built.glob("*.zip"), *(built / "wheels").glob("*.whl")]:
        shutil.copy(path, folder)
    done = script("sbom", folder)
    assert done.returncode == 0, done.stderr
    return Path(done.stdout.strip())


def test_the_list_of_parts_has_each_file_and_what_is_inside(listed):
    document = json.loads(listed.read_text())
    names = {package["SPDXID"]: package["name"] for package in document["packages"]}
    files = {path.name for path in listed.parent.iterdir()} - {listed.name}
    assert files <= set(names.values())
    (wheel,) = (name for name in files if name.endswith(".whl"))
    found = {
        (
            names.get(line["spdxElementId"]),
            line["relationshipType"],
            names[line["relatedSpdxElement"]],
        )
        for line in document["relationships"]
    }
    for part in ("toml++", "nlohmann-json", "libstdc++", "zlib"):
        assert (wheel, "STATIC_LINK", part) in found
    for name in files - {wheel}:
        assert {(name, "CONTAINS", part) for part in (wheel, "OpenEXR")} <= found
    before = listed.read_bytes()
    assert script("sbom", listed.parent).returncode == 0
    assert listed.read_bytes() == before


def test_the_list_of_parts_is_valid_spdx(listed):
    judge = ROOT / ".venv" / "bin" / "pyspdxtools"
    if not judge.exists():
        pytest.skip("spdx-tools are not in .venv; scripts/test installs them")
    done = subprocess.run([judge, "--infile", listed], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.skipif(not (ROOT / ".git").exists(), reason="these sources are no clone")
def test_a_release_is_of_what_is_committed(tmp_path):
    """In a clone with a change that no commit holds."""
    clone = tmp_path / "clone"
    subprocess.run(["git", "clone", "-q", "--depth", "1", f"file://{ROOT}", clone], check=True)
    (clone / "README.md").write_text("changed")
    done = subprocess.run([clone / "scripts" / "release"], capture_output=True, text=True)
    assert done.returncode == 1 and "changes that no commit holds" in done.stderr
    assert not (clone / "build").exists()
