# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The Debian packages without a build of their own: the files of their components, their manual
pages and completions, what the desktop, systemd and MIME know of them. scripts/test --only chroot
makes the packages and uses them in a bare root.
"""

import gzip
import hashlib
import importlib.metadata
import json
import os
import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PACKAGING = ROOT / "packaging"
BUILD = Path(os.environ["OCEAN_BUILD"])
VERSION = os.environ["OCEAN_VERSION"]
PROGRAMS = {"tools": "ocean", "preview": "ocean-preview", "bridge": "ocean-bridge"}
PACKAGES = {
    "runtime": "libocean1",
    "library": "libocean-dev",
    "python": "python3-libocean",
    "tools": "ocean-tools",
    "terrain": "ocean-terrain",
    "preview": "ocean-preview",
    "bridge": "ocean-bridge",
    "povray": "povray-ocean",
    "blender": "blender-ocean",
}


def run(*command, **options) -> str:
    done = subprocess.run(
        [str(word) for word in command],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
        **options,
    )
    assert done.returncode == 0, done.stdout
    return done.stdout


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """Returns the root of a component's files, as its package has them."""
    roots: dict[str, Path] = {}

    def install(component: str) -> Path:
        if component not in roots:
            root = tmp_path_factory.mktemp(component)
            command = [os.environ["CMAKE"], "--install", BUILD, "--prefix", "/usr"]
            environment = os.environ | {"DESTDIR": str(root)}
            run(*command, "--component", component, env=environment)
            roots[component] = root
        return roots[component]

    return install


def described(component: str) -> dict:
    return json.loads(run(BUILD / "bin" / PROGRAMS[component], "--describe"))


def pages_of(component: str) -> list[str]:
    program = PROGRAMS[component]
    main, *others = described(component)["commands"]
    assert main["name"] == program
    names = [program, *(f"{program}-{other['name']}".replace(" ", "-") for other in others)]
    return [f"usr/share/man/man1/{name}.1.gz" for name in names]


def files_of_program(component: str) -> list[str]:
    program = PROGRAMS[component]
    return [
        f"usr/bin/{program}",
        f"usr/share/bash-completion/completions/{program}",
        f"usr/share/zsh/vendor-completions/_{program}",
        f"usr/share/fish/vendor_completions.d/{program}.fish",
        *pages_of(component),
    ]


def below(folder: str, destination: str, *patterns: str) -> list[str]:
    found = {path for pattern in patterns for path in (ROOT / folder).rglob(pattern)}
    return [f"{destination}/{path.relative_to(ROOT / folder).as_posix()}" for path in found]


def guides(package: str, *names: str) -> list[str]:
    return [f"usr/share/doc/{package}/guides/{name}.md" for name in names]


SEA_GUIDES = ("sea_file", "parameters", "measured_seas")


def expected_files(component: str) -> list[str]:
    if component in PROGRAMS:
        own = files_of_program(component)
        if component == "tools":
            own.append("usr/lib/libocean/ocean_vdb.so")
            own.append("usr/share/man/man5/ocean-sea.5.gz")
            own.append("usr/share/libocean/flamenco/ocean_bake.js")
            own += below("docs", "usr/share/doc/ocean-tools/guides", "*.md")
        if component == "preview":
            own += guides("ocean-preview", "preview", *SEA_GUIDES)
            own.append("usr/share/applications/ocean-preview.desktop")
            own.append("usr/share/icons/hicolor/scalable/apps/ocean-preview.svg")
            own.append("usr/share/mime/packages/libocean.xml")
        if component == "bridge":
            own += guides("ocean-bridge", "bridge")
            own.append("etc/default/ocean-bridge")
            own.append("usr/share/doc/ocean-bridge/PROTOCOL.md")
            own.append("usr/lib/systemd/system/ocean-bridge.service")
            own.append("usr/lib/udev/rules.d/60-ocean-bridge.rules")
        return own
    if component == "terrain":
        return ["usr/libexec/libocean/ocean-raster"]
    if component == "runtime":
        return ["usr/lib/libocean.so.1", f"usr/lib/libocean.so.{VERSION}"]
    if component == "library":
        package = "usr/lib/cmake/libocean/libocean-"
        # CMake adds a file for the kind of build.
        kind = os.environ["OCEAN_BUILD_TYPE"].lower()
        names = ("c", f"c-{kind}", "config", "config-version")
        examples = "usr/share/doc/libocean-dev/examples"
        return [
            "usr/include/libocean.h",
            "usr/lib/libocean.so",
            "usr/lib/pkgconfig/libocean.pc",
            *(f"{package}{name}.cmake" for name in names),
            *guides("libocean-dev", "c", *SEA_GUIDES),
            *below("tests/package/c", f"{examples}/c", "*"),
            *below("tests/package/cpp", f"{examples}/cpp", "*"),
        ]
    if component == "python":
        folder = "usr/lib/python3/dist-packages/libocean"
        own = below("libocean/python/libocean", folder, "*.py", "py.typed")
        own += guides("python3-libocean", "python", *SEA_GUIDES)
        return [*own, *(f"{folder}-{VERSION}.dist-info/{name}" for name in ("METADATA", "RECORD"))]
    if component == "povray":
        macros = ("ocean", "coast", "terrain")
        own = [f"usr/share/povray-3.7/include/{name}.inc" for name in macros]
        folder = "usr/share/doc/povray-ocean/examples"
        own += [f"{folder}/beach.toml", f"{folder}/bay.toml"]
        own += [*guides("povray-ocean", "povray"), "usr/share/doc/povray-ocean/README.md"]
        return own + below("povray_macros/examples", folder, "*.pov", "*.toml")
    assert component == "blender"
    folder = "usr/share/blender/scripts/addons/libocean_addon"
    own = below("blender_addon/libocean_addon", folder, "*.py", "*.json", "*.po", "*.jpg")
    own.append("usr/share/doc/blender-ocean/examples/scene.py")
    return [*own, f"{folder}/README.md", *guides("blender-ocean", "blender", *SEA_GUIDES)]


@pytest.mark.parametrize("component", PACKAGES)
def test_a_component_has_the_files_of_its_package(installed, component):
    root = installed(component)
    files = {path.relative_to(root).as_posix() for path in root.rglob("*") if not path.is_dir()}
    about = f"usr/share/doc/{PACKAGES[component]}"
    expected = {f"{about}/copyright", f"{about}/changelog.Debian.gz", *expected_files(component)}
    assert files == expected


def test_scenes_find_the_includes_that_folders_have(installed, tmp_path):
    options = ("--set", "resolution=64", "--format", "height_field")
    run(BUILD / "bin/ocean", "-q", "povray", "preset:seed_rough", "-o", tmp_path, *options)
    folder = installed("povray") / "usr/share/povray-3.7/include"
    for path in folder.iterdir():
        assert not re.search(r"^ *@", path.read_text(), re.M), path.name
    assert (folder / "terrain.inc").read_bytes() == (tmp_path / "terrain.inc").read_bytes()


def shown_page(path: Path, *options: str) -> str:
    """Returns the text that man makes of a manual page, without a warning."""
    environment = os.environ | {"LC_ALL": "C.UTF-8", "MANROFFSEQ": "", "MANWIDTH": "80"}
    encoding = ("--encoding=utf-8", "--troff-device=utf8")
    shown = subprocess.run(
        ["man", "--warnings", *encoding, *options, "--local-file", path],
        check=True,
        env=environment,
        capture_output=True,
        text=True,
    )
    assert shown.stderr == ""
    return re.sub(".\x08", "", shown.stdout)  # bold is printed twice


def test_the_sea_file_has_a_manual_page(tmp_path):
    """It shows the guide: each of its paragraphs, and the example line by line."""
    script, guide = PACKAGING / "command_pages.py", ROOT / "docs" / "sea_file.md"
    run(script, "--output", tmp_path, "--sea-file", guide, BUILD / "bin" / "ocean")
    page = tmp_path / "ocean/share/man/man5/ocean-sea.5.gz"
    assert run("lexgrog", page).partition('"')[2].startswith("ocean-sea - file that describes")
    shown = shown_page(page)
    code = guide.read_text().split("```")[1].partition("\n")[2]
    assert all(line.strip() in shown for line in code.splitlines())
    words = " ".join(shown.split())
    assert "is strict TOML: an unknown key or a value out of range" in words
    assert "--set name=value, ocean_set and sea.set. Live parameters" in words


def test_pip_lists_the_files_of_the_python_package(installed):
    folder = installed("python") / "usr/lib/python3/dist-packages"
    (found,) = importlib.metadata.distributions(path=[str(folder)])
    files = {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}
    assert {path.as_posix() for path in found.files} == files
    assert "License-File" not in found.read_text("METADATA")  # Debian has them in share/doc


@pytest.mark.parametrize("component", PROGRAMS)
def test_manual_pages_name_every_option_of_the_help_and_raise_no_warning(installed, component):
    commands = described(component)["commands"]
    for page, command in zip(pages_of(component), commands, strict=True):
        path = installed(component) / page
        shown_page(path, "--ditroff")
        summary = run("lexgrog", path).partition('"')[2]
        assert summary.startswith(f"{Path(page).name.removesuffix('.1.gz')} - ")
        text = gzip.decompress(path.read_bytes()).decode().replace("\\-", "-")
        words = [] if command["name"] == PROGRAMS[component] else command["name"].split()
        known = run(BUILD / "bin" / PROGRAMS[component], *words, "--help")
        options = re.findall(r"^  (?:-\w, )?(--[\w-]+)", known, re.M)
        assert "--help" in options
        assert [name for name in options if f"\\fB{name}\\fR" not in text] == []


@pytest.mark.parametrize(
    ("words", "completed"),
    [
        (["ocean", "ba"], ["bake"]),
        (["ocean", "bake", "--resol"], ["--resolution"]),
        (["ocean", "terrain", "im"], ["import"]),
        (["ocean", "terrain", "import", "--deg"], ["--degrees"]),
        (["ocean", "--ver"], ["--version", "--verbose"]),
        (["ocean", "bake", "--help", "ge"], ["geotiff"]),
        (["ocean", "bake", "--set", "wind"], []),  # the value of an option, which is no file
        (["ocean", "bake", "--from", "sea"], ["sea.exr", "sea.toml"]),
        (["ocean", "info", "sea.t"], ["sea.toml"]),
        # Bash parts words at a colon.
        (["ocean", "info", "preset", ":", "bay_"], ["bay_island"]),
        (["ocean", "presets", "bay_"], ["bay_island"]),
        (["ocean-preview", "preset", ":", "seed_l"], ["seed_lantz"]),
        (["ocean-preview", "--offsc"], ["--offscreen"]),
        (["ocean-bridge", "--token"], ["--token-file"]),
    ],
)
def test_bash_completes(installed, tmp_path, words, completed):
    for name in ("sea.exr", "sea.toml", "wind"):
        (tmp_path / name).touch()
    (component,) = [one for one, program in PROGRAMS.items() if program == words[0]]
    script = installed(component) / f"usr/share/bash-completion/completions/{words[0]}"
    function = "_" + words[0].replace("-", "_")
    typed = " ".join(f"'{word}'" for word in words)
    done = run(
        "bash", "-c", f"compopt() {{ :; }}; source {script}; COMP_WORDS=({typed}); "
        f"COMP_CWORD={len(words) - 1}; {function}; printf '%s\\n' \"${{COMPREPLY[@]}}\"",
        cwd=tmp_path, env=os.environ | {"PATH": f"{BUILD / 'bin'}:{os.environ['PATH']}"},
    )  # fmt: skip
    assert sorted(done.split()) == sorted(completed)


def test_the_desktop_entry_is_valid_and_has_its_icon():
    entry = PACKAGING / "ocean-preview.desktop"
    assert run("desktop-file-validate", entry) == ""
    assert "Icon=ocean-preview\n" in entry.read_text()
    types = re.findall(r'mime-type type="(.*?)"', (PACKAGING / "libocean.xml").read_text())
    assert types
    assert f"MimeType={';'.join(types)};\n" in entry.read_text()


def test_sea_and_terrain_files_have_their_type_and_other_toml_keeps_its_own(tmp_path):
    packages = tmp_path / "mime" / "packages"
    packages.mkdir(parents=True)
    for path in (
        Path("/usr/share/mime/packages/freedesktop.org.xml"),
        PACKAGING / "libocean.xml",
    ):
        (packages / path.name).write_bytes(path.read_bytes())
    environment = os.environ | {"XDG_DATA_DIRS": str(tmp_path), "XDG_DATA_HOME": "/nonexistent"}
    run("update-mime-database", tmp_path / "mime", env=environment)

    def type_of(name: str) -> str:
        said = run("gio", "info", "-a", "standard::content-type", ROOT / name, env=environment)
        return re.search(r"content-type: (.*)", said)[1]

    assert type_of("renders/buoy_41010.toml") == "application/x-libocean+toml"
    assert type_of("povray_macros/examples/island.toml") == "application/x-libocean+toml"
    assert type_of("ruff.toml") == "application/toml"


def test_systemd_takes_the_service_and_rates_its_exposure_low(tmp_path):
    text = (PACKAGING / "ocean-bridge.service").read_text()
    assert "ExecStart=/usr/bin/ocean-bridge $OPTIONS\n" in text
    unit = tmp_path / "ocean-bridge.service"
    unit.write_text(text.replace("/usr/bin/ocean-bridge", str(BUILD / "bin/ocean-bridge")))
    assert run("systemd-analyze", "verify", "--man=no", unit) == ""
    rating = run("systemd-analyze", "security", "--offline=yes", unit)
    exposure = float(re.search(r"Overall exposure level .*?: ([0-9.]+)", rating)[1])
    assert exposure < 2.0  # systemd calls less than 5 "OK", and a service without limits has 9.6


def test_packages_of_the_same_files_have_the_same_bytes_and_name_no_place(tmp_path):
    digests = []
    for attempt in ("first", "second"):
        folder = tmp_path / attempt
        environment = os.environ | {"SOURCE_DATE_EPOCH": "1767225600"}
        components = "CPACK_COMPONENTS_ALL=python;povray"
        run("cpack", "-G", "DEB", "-B", folder, "-D", components, cwd=BUILD, env=environment)
        packages = sorted(folder.glob("*.deb"))
        names = [f"{name}_{VERSION}-1_all.deb" for name in ("povray-ocean", "python3-libocean")]
        assert [path.name for path in packages] == names
        digests.append([hashlib.sha256(path.read_bytes()).hexdigest() for path in packages])
    assert digests[0] == digests[1]
    for package in packages:
        files = subprocess.run(
            ["dpkg-deb", "--fsys-tarfile", package], check=True, stdout=subprocess.PIPE
        )
        assert str(ROOT).encode() not in files.stdout
