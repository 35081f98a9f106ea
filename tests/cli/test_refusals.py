# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The first refusal of each group of the folder `refusals` as a user meets it: each command, with
each kind of mistake. refusals_test.cpp says what a group is, and runs all rows in process."""

import re
import shlex
import tomllib
from pathlib import Path

import pytest
from conftest import DATA, Program


def groups():
    for path in sorted(Path(__file__).with_name("refusals").glob("*.toml")):
        table = tomllib.loads(path.read_text())
        for number, group in enumerate(table["group"], 1):
            group["files"] = table.get("files", {}) | group.get("files", {})
            yield pytest.param(group, id=f"{path.stem}-{number}")


GROUPS = list(groups())


@pytest.mark.parametrize("group", GROUPS)
def test_the_program_refuses_in_the_words_of_the_table(tmp_path, group):
    ocean = Program(tmp_path)
    (tmp_path / "data").symlink_to(DATA)
    key, sentence = next(iter(group["says"].items()))
    files = group["files"] | ({group["file"]: key} if "file" in group else {})
    for name, text in files.items():
        if name.endswith("/"):
            (tmp_path / name).mkdir(parents=True)
        else:
            ocean.write(name, text.encode("latin-1"))
    for step in group.get("prepare", []):
        ocean.good(*shlex.split(step))
    line = group["commands"][0]
    if "{}" in line:
        line = line.replace("{}", key)
    elif "file" not in group:
        line += " " + key
    before = sorted(tmp_path.rglob("*"))
    said = ocean.bad(*shlex.split(line), code=group.get("code", 2))
    pattern = ".*".join(re.escape(part) for part in f"ocean: {sentence}".split("(...)"))
    assert re.fullmatch(pattern, said), said
    assert sorted(tmp_path.rglob("*")) == before


def test_there_is_one_of_each_command():
    words = {" ".join(group.values[0]["commands"]).split()[0] for group in GROUPS}
    assert len(GROUPS) >= 50
    assert words >= {
        "info", "bake", "terrain", "povray", "query", "gauge", "foam-texture", "spectrum",
        "records", "params", "presets",
    }  # fmt: skip
