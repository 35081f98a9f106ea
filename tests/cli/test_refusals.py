# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The first refusal of each group of the folder `refusals` as a user meets it: each command, with
each kind of mistake. refusals_test.cpp says what a group is, and runs all rows in process."""

import os
import re
import shlex
import subprocess
import tomllib
from pathlib import Path

import pytest
from conftest import DATA, KEPT


def groups():
    for path in sorted(Path(__file__).with_name("refusals").glob("*.toml")):
        table = tomllib.loads(path.read_text())
        for number, group in enumerate(table["group"], 1):
            group["program"] = table.get("program", "ocean")
            group["files"] = table.get("files", {}) | group.get("files", {})
            yield pytest.param(group, id=f"{path.stem}-{number}")


GROUPS = list(groups())


@pytest.mark.parametrize("group", GROUPS)
def test_the_program_refuses_in_the_words_of_the_table(tmp_path, group):
    name = group["program"]
    program = os.environ.get(name.upper().replace("-", "_"))
    if not program:
        pytest.skip(f"{name} was not built")

    def run(line: str) -> subprocess.CompletedProcess:
        return subprocess.run([program, *shlex.split(line)], cwd=tmp_path, env=KEPT,
                              capture_output=True, text=True, timeout=600)  # fmt: skip

    (tmp_path / "data").symlink_to(DATA)
    key, sentence = next(iter(group["says"].items()))
    files = dict(group["files"])
    if "file" in group:
        files[group["file"]] = group.get("text", "{}").replace("{}", key)
    for file, text in files.items():
        path = tmp_path / file
        (path if file.endswith("/") else path.parent).mkdir(parents=True, exist_ok=True)
        if not file.endswith("/"):
            path.write_bytes(text.encode("latin-1"))
    for step in group.get("prepare", []):
        assert run(step).returncode == 0
    line = group["commands"][0]
    if "{}" not in line and "file" not in group:
        line += " {}"
    before = sorted(tmp_path.rglob("*"))
    done = run(line.replace("{}", key))
    pattern = ".*".join(re.escape(part) for part in f"{name}: {sentence}\n".split("(...)"))
    assert re.fullmatch(pattern, done.stderr), done.stderr
    assert (done.returncode, done.stdout) == (group.get("code", 2), "")
    assert sorted(tmp_path.rglob("*")) == before


def test_there_is_one_of_each_command():
    lines = {(group.values[0]["program"], *group.values[0]["commands"][0].split()[:1])
             for group in GROUPS}  # fmt: skip
    assert len(GROUPS) >= 50
    commands = "info bake terrain povray query gauge foam-texture spectrum records params presets"
    assert lines >= {("ocean", command) for command in commands.split()}
    assert {program for program, *_ in lines} == {"ocean", "ocean-preview", "ocean-bridge"}
