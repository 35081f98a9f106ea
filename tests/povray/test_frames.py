# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Which frame of the sea a picture shows: that of its number, or none. Chunks of an export list
the frames of all of them, in any order and at once."""

import re
import subprocess
import sys

import pytest
from conftest import OCEAN, Folder, export, ocean, povray, sea_text

SEA = sea_text(resolution=32, period=60.0)
FAST = ("--format", "height_field")  # no textures of foam
PROBE = """#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1 }
Ocean_Load(NAME)
#debug concat("SHOWN ", str(Ocean_Frame_Number, 0, 0), " ", str(Ocean_Time, 0, 6), " ",
              str(clock, 0, 6), "\\n")
"""


def probe(folder, *arguments, name="Ocean_Frame_Name(frame_number)", good=True):
    """The frames that a run shows, with their times and clocks; what POV-Ray says if it stops."""
    log = povray(folder, PROBE.replace("NAME", name), *arguments, good=good)
    if not good:
        return re.sub(r"\s+", " ", log)
    shown = re.findall(r"^SHOWN (\S+) (\S+) (\S+)$", log, re.MULTILINE)
    return [(int(frame), float(time), float(clock)) for frame, time, clock in shown]


def frame(number, of=30):
    """Options for one frame of an animation."""
    return ["+KFI1", f"+KFF{of}", f"+SF{number}", f"+EF{number}"]


def time_of(number):
    return pytest.approx((number - 1) / 24, abs=1e-6)


def settings(folder):
    text = (folder / "ocean.ini").read_text()
    return dict(re.findall(r"^([A-Z]\w*)=(.*)$", text, re.MULTILINE))


@pytest.mark.parametrize("format_", ["df3", "mesh2", "height_field"])
def test_a_stepped_frame_shows_itself_or_stops(tmp_path, format_):
    Folder(tmp_path, SEA, "--frames", "10-30x10", "--format", format_)
    for number in (10, 30):
        assert [shown[0] for shown in probe(tmp_path, *frame(number))] == [number]
    for number in (1, 7):
        log = probe(tmp_path, *frame(number), good=False)
        assert f"the folder has no frame {number}; it has: 10, 20, 30." in log


def test_frames_beyond_the_export_stop_and_a_still_shows_the_first(tmp_path):
    Folder(tmp_path, SEA, "--frames", "3-5", *FAST)
    assert probe(tmp_path) == [(3, time_of(3), 0.0)]
    assert probe(tmp_path, *frame(5)) == [(5, time_of(5), pytest.approx(4 / 29, abs=1e-6))]
    for options in (frame(6), frame(2), ["+KFI0", "+KFF9", "+EF0"]):
        assert "it has: 3-5." in probe(tmp_path, *options, good=False)
    assert "it has: 3-5." in probe(tmp_path, name="Ocean_Frame_Name(3.5)", good=False)
    assert "that were are: 3-5." in probe(tmp_path, name='"sea_0009"', good=False)


def test_the_clock_is_the_time_of_the_frame(tmp_path):
    """For all frames of ocean.ini, with even and uneven steps; POV-Ray's own clock of one frame is
    NaN."""
    for name, frames in (("even", "10-30x10"), ("one", "5"), ("first", "1"), ("negative", "-2-1")):
        folder = tmp_path / name
        Folder(folder, SEA, "--frames", frames, *FAST)
        lines = (folder / "ocean.ini").read_text().replace("scene.pov", "test.pov")
        (folder / "test.ini").write_text(lines)
        shown = probe(folder, "test.ini")
        assert [clock for _, _, clock in shown] == [pytest.approx(t, abs=1e-6) for _, t, _ in shown]
        wanted = {"even": [10, 20, 30], "one": [5], "first": [1], "negative": [0, 1]}
        assert [number for number, _, _ in shown] == wanted[name]
    assert "Ocean_Frame_Name(-2)" in (tmp_path / "negative/ocean.ini").read_text()
    assert probe(tmp_path / "negative", name="Ocean_Frame_Name(-2)")[0][0] == -2


def test_a_clock_names_a_frame_by_its_time(tmp_path):
    Folder(tmp_path, SEA, "--frames", "10-30x10", *FAST)
    assert probe(tmp_path, f"+K{19 / 24:.6f}")[0][:2] == (20, time_of(20))
    assert probe(tmp_path, "+K0.5", name="Ocean_Frame_At(29/24)")[0][0] == 30
    assert "it has: 10, 20, 30." in probe(
        tmp_path, "+K0.5", name="Ocean_Frame_At(clock)", good=False
    )
    # A still whose clock means something else shows the first, and says so.
    log = povray(tmp_path, PROBE.replace("NAME", "Ocean_Frame_Name(frame_number)"), "+K0.5")
    assert "no frame is at the clock 0.500 s" in re.sub(r"\s+", " ", log) and "SHOWN 10 " in log
    # A clock of one's own from 0 to 1 is one's own.
    assert probe(tmp_path, *frame(20), "+KI0", "+KF1")[0][0] == 20


def test_a_folder_of_an_earlier_version_shows_its_frames(tmp_path):
    Folder(tmp_path, SEA, "--frames", "5-7", *FAST)
    path = tmp_path / "ocean_parameters.inc"
    text = re.sub(r"^#declare Ocean_Frames.*\n", "", path.read_text(), flags=re.MULTILINE)
    path.write_text(text.replace("Data_Version = 4", "Data_Version = 3"))
    assert probe(tmp_path, *frame(6))[0][0] == 6
    assert "no frame 8; it has: 5 to 7." in probe(tmp_path, *frame(8), good=False)


@pytest.mark.parametrize("format_", ["df3", "mesh2", "height_field"])
def test_chunks_in_any_order_list_all_frames(tmp_path, format_):
    for chunk in ("7-9", "1-3", "7-9"):
        export(tmp_path, SEA, "--frames", chunk, "--format", format_)
    found = settings(tmp_path)
    assert (found["Initial_Frame"], found["Final_Frame"]) == ("1", "9")
    assert "Frames: 1-3, 7-9." in (tmp_path / "ocean.ini").read_text()
    export(tmp_path, SEA, "--frames", "4-6", "--format", format_)
    whole = tmp_path / "whole"
    whole.mkdir()
    export(whole, SEA, "--frames", "1-9", "--format", format_)
    for name in ("ocean.ini", "ocean_parameters.inc", "sea.manifest.json"):
        assert (tmp_path / name).read_bytes() == (whole / name).read_bytes(), name
    # A frame that was deleted is listed no more.
    next(tmp_path.glob("sea_0009*.inc")).unlink()
    export(tmp_path, SEA, "--frames", "1", "--format", format_)
    assert settings(tmp_path)["Final_Frame"] == "8"


def test_stepped_chunks_meet(tmp_path):
    export(tmp_path, SEA, "--frames", "1-9x4", *FAST)
    assert settings(tmp_path)["Frame_Step"] == "4"
    export(tmp_path, SEA, "--frames", "3-7x4", *FAST)
    found = settings(tmp_path)
    assert [found[k] for k in ("Initial_Frame", "Final_Frame", "Frame_Step")] == ["1", "9", "2"]


def test_frames_of_another_sea_or_form_are_left_out_with_a_warning(tmp_path):
    sea = sea_text(resolution=64, period=60.0)
    export(tmp_path, sea, "--frames", "1-6", "--near-only")
    for options in (["--set", "seed=2", "--near-only"], ["--fps", "25", "--near-only"], []):
        done = ocean(tmp_path, "povray its_sea.toml -o . --frames 1-3 --overwrite", *options)
        assert done.returncode == 0
        assert "of another sea or of other options: 4-6; ./ocean.ini leaves them out" in done.stderr
        assert settings(tmp_path)["Final_Frame"] == "3"
    assert "it has: 1-3." in probe(tmp_path, *frame(5), good=False)


LOCK = """import fcntl, os
fcntl.flock(os.open("pov", os.O_RDONLY), fcntl.LOCK_EX)
print("locked", flush=True)
input()"""


def test_chunks_at_the_same_time_lose_none(tmp_path):
    """And a lock that a killed process held is none."""
    (tmp_path / "sea.toml").write_text(SEA)
    (tmp_path / "pov").mkdir()
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
    holder = subprocess.Popen([sys.executable, "-c", LOCK], cwd=tmp_path, text=True, **pipes)
    assert holder.stdout.readline() == "locked\n"
    command = [OCEAN, "povray", "sea.toml", "-o", "pov", *FAST, "-q", "--threads", "1"]
    runs = [
        subprocess.Popen([*command, "--frames", chunk], cwd=tmp_path, stdout=subprocess.DEVNULL)
        for chunk in ("1-4", "5-8", "9-12", "13-16")
    ]
    holder.kill()
    holder.communicate()
    assert [run.wait(timeout=120) for run in runs] == [0] * 4
    assert "Frames: 1-16." in (tmp_path / "pov/ocean.ini").read_text()
    text = (tmp_path / "pov/ocean_parameters.inc").read_text()
    assert 'Ocean_Frames_Text_ = "1-16";' in text


def test_any_name_of_a_file_gives_a_scene_without_warnings(tmp_path):
    """An umlaut, blanks, quotes, a backslash, a beaver beyond the first plane; also as folder."""
    name = 'Fünen "Ost" C:\\x 5% \U0001f9ab.csv'
    (tmp_path / name).write_text("frequency,density\n0.05,0\n0.1,2.0\n0.15,1.0\n0.3,0.1\n")
    sea = SEA.replace('"pierson_moskowitz"', f"\"measured\"\nfile = '{name}'").replace(
        "wind_speed = 7.0\n", ""
    )
    (tmp_path / "sea.toml").write_text(sea.replace("60.0", "400.0"))
    done = ocean(tmp_path, "povray sea.toml --near-only -o", "Ausgabe 'ä\"")
    assert (done.returncode, done.stderr.count("warning")) == (0, 0), done.stderr
    folder = tmp_path / "Ausgabe 'ä\""
    assert (folder / "ocean_parameters.inc").read_text().isascii()
    scene = (folder / "scene.pov").read_text()
    told = '#debug concat("NAME ", str(strlen(Ocean_Waves_0_File), 0, 0), "\\n")'
    log = povray(folder, scene + told, height=6)
    noise = ("Warning Stream", "experimental feature", "Parse Warnings")
    said = [
        line
        for line in log.splitlines()
        if re.search("warning|error", line, re.IGNORECASE) and not any(n in line for n in noise)
    ]
    assert said == []
    # POV-Ray's strings count UCS-2: the beaver is two.
    assert f"NAME {len(name) + 1}" in log


def test_a_line_end_in_the_name_of_a_mesh_stays_in_its_comment(tmp_path):
    (tmp_path / "sea.toml").write_text(SEA)
    assert ocean(tmp_path, "bake sea.toml -o", 'a\n"ü.inc').returncode == 0
    (tmp_path / "plain.inc").write_bytes((tmp_path / 'a\n"ü.inc').read_bytes())
    povray(tmp_path, '#version 3.7;\n#include "plain.inc"\nobject { Ocean_Surface }')
