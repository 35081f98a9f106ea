#!/usr/bin/python3
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Builds the pages of this folder as a static site.

usage: docs/build.py --library LIBOCEAN_SO --output FOLDER [--no-cpp]

The site goes to FOLDER/html. A warning of Doxygen or Sphinx is an error. With --no-cpp the page of
the C++ reference has no names, of which Sphinx needs a minute. `scripts/docs` installs
what this needs, builds the library and calls it.

The pages are also read in the repository itself, so their links are paths from file to file. In
the site a link to another page leads to its HTML, a link to any other file downloads it, and a
link to a folder, or to a page that the site lacks, becomes plain text. Pages that live beside what
they describe are taken from there.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parent
ROOT = DOCS.parent

# The pages that live elsewhere, and their names in the site.
ADOPTED = {
    "blender_addon/README.md": "blender_addon.md",
    "povray_macros/README.md": "povray_macros.md",
    "shaders/README.md": "shaders.md",
    "tests/README.md": "tests.md",
    "libocean/bridge/PROTOCOL.md": "bridge_protocol.md",
    "libocean/CONVENTIONS.md": "conventions.md",
    "libocean/REFERENCES.md": "literature.md",
    "CHANGELOG.md": "changes.md",
}
# A block of code, or an opening `[text](target`, `![text](target` of a link.
CODE_OR_LINK = re.compile(
    r"^```.*?^```$|`[^`\n]*`(?!\])|(!?)\[((?:[^\[\]]|!\[[^\]]*\]\([^)]*\))*)\]\(([^)\s#]*)(#[^)\s]*)?\)",
    re.M | re.S,
)


def pages() -> dict[Path, str]:
    """Returns the file of each page and its name in the site."""
    own = {path: path.relative_to(DOCS).as_posix() for path in sorted(DOCS.glob("**/*.md"))}
    return own | {ROOT / path: name for path, name in ADOPTED.items()}


def with_links_of_the_site(text: str, folder: Path, output: Path) -> str:
    """Returns a page of `folder` as it is read in `output`."""

    def replaced(match: re.Match) -> str:
        image, words, target, anchor = match.groups()
        if words is None or re.match(r"[a-z]+:", target):
            return match[0]
        anchor = anchor or ""
        if not target:
            return f"[{words}]({anchor})"
        path = (folder / target).resolve()
        name = pages().get(path)
        if name:
            return f"[{words}]({name}{anchor})"
        if path.is_dir() or path.suffix == ".md":
            return words
        return f"{image}[{words}]({os.path.relpath(path, output)})"

    return CODE_OR_LINK.sub(replaced, text)


def stage(output: Path, has_cpp: bool) -> None:
    """Writes the pages of the site as Sphinx reads them."""
    shutil.rmtree(output, ignore_errors=True)
    output.mkdir(parents=True)
    for path, name in pages().items():
        (output / name).parent.mkdir(parents=True, exist_ok=True)
        text = with_links_of_the_site(path.read_text(), path.parent, output)
        if name == "cpp_reference.md" and not has_cpp:
            text = re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S)
        (output / name).write_text(text)


def run(command: list, **options) -> None:
    done = subprocess.run(
        [str(word) for word in command], text=True, capture_output=True, **options
    )
    if done.returncode:
        sys.exit(f"{command[0]} failed:\n{done.stdout[-2000:]}\n{done.stderr[-6000:]}")


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--library", required=True, type=Path)
    parser.add_argument("--output", required=True, type=Path)
    parser.add_argument("--no-cpp", action="store_true")
    options = parser.parse_args()
    output = options.output.resolve()
    output.mkdir(parents=True, exist_ok=True)
    stage(output / "pages", not options.no_cpp)
    environment = os.environ | {
        "OCEAN_DOXYGEN_OUTPUT": str(output),
        "OCEAN_DOXYGEN_XML": str(output / "xml"),
        "LIBOCEAN_LIBRARY": str(options.library.resolve()),
    }
    run(["doxygen", "docs/Doxyfile"], cwd=ROOT, env=environment)
    run(
        ["sphinx-build", "-q", "-W", "--keep-going", "-j", "2", "-c", DOCS]
        + [output / "pages", output / "html"],
        env=environment,
    )


if __name__ == "__main__":
    main()
