# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Help, versions, and what goes to which stream."""

import json
import os
import pty
import subprocess

import pytest
from conftest import OCEAN, check_failure

COMMANDS = ["info", "bake", "foam-texture", "spectrum", "params", "presets"]


def test_help_lists_every_command_and_is_not_an_error(ocean):
    text = ocean.good("--help")
    for command in COMMANDS:
        assert f"\n  {command} " in text


@pytest.mark.parametrize("command", COMMANDS)
def test_help_of_a_command_groups_its_options(ocean, command):
    text = ocean.good(command, "--help")
    assert "Usage: ocean " + command in text
    assert "\nOutput:" in text or command == "presets"


def test_long_options_are_kebab_case(ocean):
    for command in COMMANDS:
        for word in ocean.good(command, "--help").split():
            if word.startswith("--"):
                assert word == word.lower() and "_" not in word


def test_version_names_the_libraries(ocean):
    text = ocean.good("--version")
    assert text.startswith("ocean 0.")
    for library in ("OpenEXR 3.", "libpng 1.", "cairo 1.", "toml++ 3."):
        assert library in text


def test_formats_of_params_exclude_each_other(ocean):
    done = ocean("params --json --markdown")
    assert done.returncode == 2 and done.stdout == ""


def test_run_options_may_stand_before_the_command(ocean):
    one, all_cores = (
        ocean.good(*threads, "info", "sea.toml", "--json") for threads in (["--threads", "1"], [])
    )
    assert one == all_cores


def test_a_failed_standard_output_is_an_error(ocean):
    for command in ("info sea.toml", "params", "--help", "spectrum sea.toml"):
        done = ocean.shell(f'"$OCEAN" {command} > /dev/full')
        check_failure(done, 1)


def test_a_closed_pipe_ends_the_program_silently(ocean):
    done = ocean.shell('"$OCEAN" spectrum sea.toml --directional | head -n 1')
    assert done.stderr == ""
    assert done.stdout.startswith("frequency_hz")


def test_progress_is_not_on_standard_output(ocean):
    done = ocean("bake sea.toml -o out/s.####.exr --frames 1-2")
    assert done.stdout.splitlines() == [
        f"out/s.{product}.000{frame}.exr"
        for frame in (1, 2)
        for product in ("displacement", "normal", "foam")
    ]
    assert "frame 2 done (2 of 2)" in done.stderr and "ETA" in done.stderr
    assert "shortest wave" in done.stderr
    assert "\r" not in done.stderr and "\033" not in done.stderr


def test_quiet_says_nothing(ocean):
    done = ocean("bake sea.toml -o out/s.exr -q")
    assert (done.stdout, done.stderr) == ("", "")
    assert ocean("info sea.toml -q --set wind_speed=0").stderr == ""


def test_verbose_says_more(ocean):
    assert "frame 7 is at 0.25 s" in ocean("bake sea.toml -o s.exr -v --frames 7").stderr


def test_json_progress_is_a_line_for_each_event(ocean):
    bake = ["bake", "sea.toml", "-o", "out/s.####.exr", "--frames", "3-5", "--json"]
    done = ocean(*bake, "--set", "fetch=80000")  # of a sea without a warning
    events = [json.loads(line) for line in done.stderr.splitlines()]
    assert [event["event"] for event in events] == ["start", "frame", "frame", "frame", "done"]
    assert [event["frame"] for event in events[1:4]] == [3, 4, 5]
    assert events[0]["total"] == 3 and events[0]["resolution"] == 64
    files = [file for event in events[1:4] for file in event["files"]]
    assert files == done.stdout.splitlines()


def test_each_per_cent_is_a_line_that_engines_read(ocean):
    def numbers(command, line="openjd_progress: #", before="openjd_progress: ", after=""):
        done = ocean(command, "--progress", line, "-q")
        lines = done.stderr.splitlines()
        assert all(each.startswith(before) and each.endswith(after) for each in lines), lines
        return [int(each.removeprefix(before).removesuffix(after)) for each in lines]

    bake = "bake sea.toml -o out/s.####.exr --products height --frames"
    assert numbers(f"{bake} 1-7") == [0, 14, 28, 42, 57, 71, 85, 100]
    assert numbers(f"{bake} 1-7 --skip-existing") == [0, 14, 28, 42, 57, 71, 85, 100]
    assert numbers(f"{bake} 1-2 --shard 1/3", "#%", "", "%") == [100]  # it is empty
    assert numbers("check out/s.####.exr") == [14, 28, 42, 57, 71, 85, 100]
    # A frame that fails is over.
    (ocean.folder / "out/s.height.0002.exr").unlink()
    (ocean.folder / "out/s.height.0002.exr").mkdir()
    done = ocean(f"{bake} 1-4 --keep-going --progress TR_PROGRESS_#%")
    assert done.returncode == 1
    lines = [line for line in done.stderr.splitlines() if line.startswith("TR_PROGRESS")]
    assert lines == [f"TR_PROGRESS_{percent}%" for percent in (0, 25, 50, 75, 100)]
    assert "--json excludes --progress" in ocean(f"{bake} 1 --json --progress #").stderr


def test_json_errors_and_warnings_parse_too(ocean):
    done = ocean("bake", 'no "sea".toml', "-o", "a.exr", "--json")
    assert done.returncode == 2
    assert json.loads(done.stderr)["event"] == "error"
    assert 'no "sea".toml' in json.loads(done.stderr)["message"]
    done = ocean("info sea.toml --json --set wind_speed=0")
    assert json.loads(done.stderr)["event"] == "warning"
    json.loads(done.stdout)


def test_a_terminal_gets_a_bar_with_eta(ocean):
    master, slave = pty.openpty()
    subprocess.run(
        [OCEAN, "bake", "sea.toml", "-o", "s.####.exr", "--frames", "1-4"],
        cwd=ocean.folder,
        stdout=subprocess.DEVNULL,
        stderr=slave,
        check=True,
        timeout=120,
    )
    os.close(slave)
    text = b""
    while True:
        try:
            part = os.read(master, 4096)
        except OSError:
            break
        text += part
    os.close(master)
    assert b"[######......" in text and b"ETA" in text
    assert text.rstrip().endswith(b"s") and b"4 of 4 frames done" in text


def test_params_text_and_json_name_every_parameter(ocean):
    table = json.loads(ocean.good("params --json"))
    text = ocean.good("params")
    for entry in table:
        assert f"  {entry['key']} = " in text
    assert {"depth", "resolution", "wind_speed", "foam_lifetime", "take"} <= {
        entry["key"] for entry in table
    }


def preset_names(ocean) -> list[str]:
    return [entry["name"] for entry in json.loads(ocean.good("presets --json"))]


def test_every_preset_is_listed(ocean):
    names = preset_names(ocean)
    listed = [line for line in ocean.good("presets").splitlines() if line.startswith("  ")]
    assert names == [line.split()[0] for line in listed]
    assert len(names) == 13 + 10 + 2 + 8


# The one carved land of a whole bay takes as long as all others together.
@pytest.mark.parametrize("is_bay", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_every_preset_is_a_file(ocean, is_bay):
    names = [name for name in preset_names(ocean) if (name == "bay_island") == is_bay]
    assert names
    for name in names:
        ocean.write("preset.toml", ocean.good("presets", name))
        state = ocean.good("info preset.toml --json")
        assert state == ocean.good("info", "preset:" + name, "--json")
        # JSON has no NaN or infinity; Python would read both.
        json.loads(state, parse_constant=lambda word: pytest.fail(word))
