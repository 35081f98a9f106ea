# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""What ocean-preview and ocean-bridge refuse, as a user meets it. A file of the folder `mistakes`
is of one program. Each row of a group is what stands for {} in its command or in the text of its
file, and words of the one line that is said; `also` are words of every row. Nothing is written.
refusals has the sentences of `ocean`."""

import os
import shlex
import subprocess
import tomllib
from pathlib import Path

import pytest

# The context makes no use of a display that is there.
KEPT = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}


def rows():
    for path in sorted(Path(__file__).with_name("mistakes").glob("*.toml")):
        table = tomllib.loads(path.read_text())
        for number, group in enumerate(table["group"], 1):
            group["files"] = table.get("files", {}) | group.get("files", {})
            for row in group["says"]:
                yield pytest.param(path.stem, group, row, id=f"{path.stem}-{number}-{row!r}")


@pytest.mark.parametrize(("name", "group", "row"), rows())
def test_what_is_wrong_is_said_in_one_line(tmp_path, name, group, row):
    program = os.environ.get(f"OCEAN_{name.upper()}")
    if not program:
        pytest.skip(f"ocean-{name} was not built")
    files = dict(group["files"])
    if "file" in group:
        files[group["file"]] = group.get("text", "{}").replace("{}", row)
    for file, text in files.items():
        (tmp_path / file).write_text(text)
    words = shlex.split(group["command"].replace("{}", row))
    done = subprocess.run([program, *words], cwd=tmp_path, env=KEPT, capture_output=True, text=True,
                          timeout=600)  # fmt: skip
    assert done.returncode == group.get("code", 2) and done.stdout == "", done
    assert done.stderr.startswith(f"ocean-{name}: "), done.stderr
    assert len(done.stderr.splitlines()) == 1 or "--help" in done.stderr, done.stderr
    assert group["says"][row] in done.stderr and group.get("also", "") in done.stderr, done.stderr
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == files
