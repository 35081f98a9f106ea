# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The examples of the macros: each renders, and each is on the page that shows them."""

import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = sorted((ROOT / "povray_macros" / "examples").glob("*.pov"))


def test_every_example_renders(tmp_path):
    done = subprocess.run(
        ["scripts/povray-examples", "--output", str(tmp_path), "--size", "32x18", "--coarse"],
        cwd=ROOT,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    pictures = sorted(path.stem for path in tmp_path.glob("*.jpg"))
    assert pictures == [example.stem for example in EXAMPLES]
    assert len(pictures) > 14


def test_every_example_and_every_macro_is_on_the_page():
    page = (ROOT / "povray_macros" / "README.md").read_text()
    for example in EXAMPLES:
        assert f"](examples/{example.name})" in page
        assert f"renders/povray/macros/{example.stem}.jpg" in page
        assert (ROOT / "renders" / "povray" / "macros" / f"{example.stem}.jpg").is_file()
    for files, prefix in ("ocean/*.inc", "Ocean"), ("terrain.inc.in", "Terrain"):
        sources = (ROOT / "povray_macros").glob(files)
        macros = "".join(path.read_text() for path in sources)
        names = re.findall(rf"^#macro ({prefix}_\w*[^_\W])\(", macros, re.MULTILINE)
        assert len(names) > 7
        for name in names:
            assert name in page, name
    coast = (ROOT / "povray_macros" / "coast.inc").read_text()
    names = re.findall(r"^#macro (Ocean_\w*[^_\W])\(", coast, re.MULTILINE)
    assert len(names) > 4
    head = coast[: coast.index("#ifndef(Coast_Inc_Temp)")]
    for name in names:
        assert name in page and name + "(" in head, name
