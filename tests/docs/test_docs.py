# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The site builds without a warning, and every block of code in its pages does what the page says.

Blocks of a page run in one folder, in order: `sh` by bash, `python` in one process, `c` and `cpp`
compiled (C also linked and run), `toml` of a whole file read by `ocean info`. Two comments before
a block change that:
    <!-- not run: REASON -->    the block is left out; the reason is counted and printed
    <!-- before: COMMAND -->    the command makes what a reader of the page has
Of `--frames 1-N` only the first frame is computed.
"""

import importlib.machinery
import importlib.util
import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
PROGRAMS = Path(os.environ["OCEAN"]).resolve().parent
LIBRARY = Path(os.environ["LIBOCEAN_LIBRARY"]).resolve()
README_LIMIT = 9000  # bytes: one screen and the quick starts

PAGES = [
    ROOT / "README.md",
    ROOT / "libocean/python/README.md",
    *(page for page in sorted(DOCS.glob("**/*.md")) if page.name != "commands.md"),
]
BLOCK = re.compile(
    r"(?P<comments>(?:^<!--.*?-->\n)*)^```(?P<language>\w+)\n(?P<code>.*?)^```$", re.M | re.S
)
COMMENT = re.compile(r"<!-- (not run|before): (.*?) -->", re.S)
RUNNABLE = ("sh", "python", "c", "cpp", "toml")


def run(command: list, folder: Path, **options) -> str:
    environment = os.environ | {
        "PATH": f"{PROGRAMS}:{os.environ['PATH']}",
        "PYTHONPATH": str(ROOT / "libocean/python"),
        "SOURCE": str(ROOT),
    }
    done = subprocess.run(
        command, cwd=folder, env=environment, text=True, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, timeout=300, **options,
    )  # fmt: skip
    assert done.returncode == 0, f"{command}\n{done.stdout}"
    return done.stdout


def run_shell(code: str, folder: Path) -> None:
    short = re.sub(r"--frames 1-\d+", "--frames 1", code)
    run(["bash", "-euo", "pipefail", "-c", short], folder)


def compiled(code: str, name: str, folder: Path) -> None:
    """Compiles a program; one in C is also linked, run on a preset, and prints what it found."""
    (folder / name).write_text(code)
    include = f"-I{ROOT / 'libocean/include'}"
    if name.endswith(".cpp"):
        run(["g++", "-std=c++20", "-fsyntax-only", "-Wall", "-Werror", include, name], folder)
        return
    link = [str(LIBRARY), f"-Wl,-rpath,{LIBRARY.parent}", "-o", "program"]
    run(["gcc", "-std=c11", "-Wall", "-Werror", include, name, *link], folder)
    run_shell("ocean presets beaufort_4 > calm.toml", folder)
    assert run(["./program", "calm.toml"], folder).startswith("height ")


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_every_block_of_a_page_runs(page: Path, tmp_path: Path, capsys) -> None:
    (tmp_path / "renders").symlink_to(ROOT / "renders")
    counts = {"run": 0, "left out": 0}
    python = ""
    for block in BLOCK.finditer(page.read_text()):
        language, code = block["language"], block["code"]
        if language not in RUNNABLE:
            continue
        comments = COMMENT.findall(block["comments"])
        reasons = [text for kind, text in comments if kind == "not run"]
        if reasons:
            counts["left out"] += 1
            with capsys.disabled():
                print(f"\n{page.name}: not run: {reasons[0]}", end="")
            continue
        counts["run"] += 1
        for kind, command in comments:
            if kind == "before":
                run_shell(command, tmp_path)
        if language == "sh":
            run_shell(code, tmp_path)
        elif language == "python":
            python += code  # what a later block uses, an earlier one has made
        elif language == "toml":
            (tmp_path / "block.toml").write_text(code)
            run(["ocean", "info", "block.toml"], tmp_path)
        else:
            compiled(code, f"block.{language}", tmp_path)
    if python:
        run([sys.executable, "-c", python], tmp_path)
    with capsys.disabled():
        print(f"\n{page.name}: {counts['run']} run, {counts['left out']} left out", end="")


def test_the_cmake_of_the_c_page_is_that_of_the_installed_examples() -> None:
    blocks = re.findall(r"^```cmake\n(.*?)^```$", (DOCS / "c.md").read_text(), re.M | re.S)
    projects = [ROOT / f"tests/package/{name}/CMakeLists.txt" for name in ("c", "cpp")]
    assert blocks == [re.sub(r"^#.*\n", "", path.read_text(), flags=re.M) for path in projects]


def test_the_script_of_the_blender_page_is_the_installed_example() -> None:
    (block,) = re.findall(r"^```python\n(.*?)^```$", (DOCS / "blender.md").read_text(), re.M | re.S)
    assert (ROOT / "blender_addon/examples/scene.py").read_text().endswith("scene.py\n" + block)


def test_every_example_of_povray_says_how_its_folder_is_made() -> None:
    head = re.compile(r"^// ocean povray (\S+) -o (\w+).* && povray (\w+)\.pov \+L(\w+)$", re.M)
    examples = sorted((ROOT / "povray_macros/examples").glob("*.pov"))
    assert len(examples) > 20
    for path in examples:
        sea, output, name, folder = head.search(path.read_text()).groups()
        assert (output, name) == (folder, path.stem)
        beside = (path.parent / sea, ROOT / "renders/coast" / sea)
        assert sea.startswith("preset:") or any(place.exists() for place in beside), path


def test_every_picture_that_a_page_shows_has_its_command() -> None:
    """The gallery says it, or the page. The macros and the steps of a terrain have tables of
    commands."""
    gallery = (DOCS / "gallery.md").read_text()
    shown = 0
    for page in PAGES:
        text = page.read_text()
        for name in re.findall(r"\(\S*?renders/(\S+\.(?:jpg|png))\)", text):
            if name.startswith(("povray/macros/", "terrain/seed_")):
                continue
            shown += 1
            command = f"`scripts/pictures {name}`"
            assert command in gallery or command in text, f"{page.name} shows {name}"
    assert shown > 40


@pytest.mark.parametrize("left_out", [["--no-cpp"], pytest.param([], marks=pytest.mark.slow)])
def test_the_site_builds_without_a_warning(tmp_path: Path, left_out: list[str]) -> None:
    run([DOCS / "build.py", "--library", LIBRARY, "--output", tmp_path, *left_out], tmp_path)
    html = tmp_path / "html"
    assert (html / "index.html").exists()
    for page in html.glob("**/*.html"):
        text = page.read_text()
        loaded = re.findall(r'(?:src|href)="(https?://[^"]*)"', text)
        links = re.findall(r'<a [^>]*href="(https?://[^"]*)"', text)
        assert not set(loaded) - set(links), f"{page.name} asks another host"


def test_links_of_the_pages_lead_to_files() -> None:
    spec = importlib.util.spec_from_file_location("build_docs", DOCS / "build.py")
    build = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(build)
    missing = []
    for page in [ROOT / "README.md", *build.pages()]:
        for link in build.CODE_OR_LINK.finditer(page.read_text()):
            target = link[3]
            if target and not re.match(r"[a-z]+:", target) and not (page.parent / target).exists():
                missing.append(f"{page.relative_to(ROOT)}: {target}")
    assert not missing


def test_claims_of_the_readme_have_their_rows() -> None:
    rows = {row["id"] for row in json.loads((DOCS / "verification.json").read_text())["rows"]}
    linked = set(re.findall(r"verification\.md#([^)]+)", (ROOT / "README.md").read_text()))
    assert len(linked) > 4
    assert linked <= rows


def test_the_numbers_of_the_release_before_stand_beside_those_of_this_one(tmp_path, monkeypatch):
    loader = importlib.machinery.SourceFileLoader("update_docs", str(ROOT / "scripts/update-docs"))
    update = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(update)
    now, before = tmp_path / "verification.json", tmp_path / "verification_before.json"
    monkeypatch.setattr(update, "SUITE", now)
    monkeypatch.setattr(update, "SUITE_BEFORE", before)
    suite = json.loads((DOCS / "verification.json").read_text())
    row = suite["rows"][0]
    program = tmp_path / "ocean"

    def verify(version: str, measured: float) -> str:
        """Runs a suite of one row; returns the cells of that row on the page."""
        told = suite | {"version": version, "rows": [row | {"measured": measured}]}
        program.write_text(f"#!/bin/sh\ncat <<'END'\n{json.dumps(told)}\nEND\n")
        program.chmod(0o755)
        update.run_suite(program)
        return update.verification_table(row["group"]).splitlines()[-1].split(" | ")

    first = verify("0.1.0", 3.25)
    assert (first[2], first[-1]) == ("3.25", "none |")
    assert "This is the first release: none is before it." in update.verification_facts()
    assert verify("0.1.0", 3.5)[-1] == "none |", "the same release, measured again"
    later = verify("0.2.0", 3.75)
    assert (later[2], later[-1]) == ("3.75", "3.5 |")
    assert verify("0.2.0", 4.0)[-1] == "3.5 |"
    assert "The release before is 0.1.0, commit " in update.verification_facts()
    assert json.loads(before.read_text())["rows"][0]["measured"] == 3.5


def test_the_readme_is_one_screen() -> None:
    assert (ROOT / "README.md").stat().st_size <= README_LIMIT
