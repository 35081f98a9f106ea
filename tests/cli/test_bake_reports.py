# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Dry runs of `ocean bake`, its failures, and its events."""

import os
import shutil
import signal
import subprocess

import pytest
from bake_runs import BAKE, BAKE_SOME, events, pattern, ran_in_a_namespace, small_disk
from conftest import DATA, OCEAN, children_seconds


def test_a_dry_run_writes_nothing(ocean):
    done = ocean(*BAKE, pattern("out/deep"), "-n", "--json")
    assert done.returncode == 0 and not (ocean.folder / "out").exists()
    paths = done.stdout.splitlines()
    plan = events(done)[0]
    assert plan["event"] == "plan" and plan["files"] == 20 == len(paths)
    made = ocean.good(*BAKE, pattern("out/deep"), "--compression", "none").splitlines()
    assert made == paths
    size = sum((ocean.folder / path).stat().st_size for path in paths)
    assert size <= plan["bytes"] <= 1.1 * size
    assert plan["free_bytes"] == pytest.approx(shutil.disk_usage(ocean.folder).free, rel=0.5)
    assert 0 < plan["memory_bytes"] < 1 << 30
    for output in ("out/s.png", "out/s.inc", "out/s.df3"):
        done = ocean("bake sea.toml -o", output, "-n", "--json")
        names = done.stdout.splitlines()
        ocean.good("bake sea.toml -o", output)
        size = sum((ocean.folder / name).stat().st_size for name in names)
        assert size <= events(done)[0]["bytes"]


def peak_memory(ocean, *arguments):
    done = subprocess.run(
        ["/usr/bin/python3", DATA.parent / "peak_memory.py", OCEAN, *arguments],
        cwd=ocean.folder, capture_output=True, text=True, check=True,
    )  # fmt: skip
    return int(done.stdout)


@pytest.mark.parametrize(
    "options",
    [
        "-o s.exr --set resolution=64",
        "-o s.exr --set resolution=1024 --set foam_lifetime=0.1",
        "-o s.#.exr --set resolution=1024 --products height --frames 1-2 --threads 2",
        "-o s.#.exr --resolution 2048 --products displacement --frames 1-2 --threads 2",
        "-o s.exr --set cascades=3 --set resolution=256 --set foam_lifetime=0.1",
        "-o s.exr --set resolution=512 --layout layered --type half"
        " --products displacement,velocity,normal,slope,jacobian,whitecap",
        "-o s.png --set resolution=512",  # has maps that invert a choppy sea
        "-o s.inc --set resolution=1024",
        "-o s.inc --set resolution=512 --eye 0,0,3",
        "-o s.df3 --set resolution=512",
        "-o s.vdb --set resolution=128 --voxel 4",
        "-o s.exr --set resolution=128 --backend dft --set foam_lifetime=0.1",
    ],
)
def test_a_dry_run_tells_the_memory_that_is_used(ocean, options):
    """To a quarter of it; measured 0.91 to 1.12."""
    bake = ["bake", "sea.toml", *options.split()]
    announced = events(ocean(*bake, "-n", "--json"))[0]["memory_bytes"]
    used = peak_memory(ocean, *bake)
    assert used / 1.25 < announced < used * 1.25


def test_a_dry_run_says_what_would_be_kept(ocean):
    ocean.good("bake sea.toml --frames 1-3 -o s.####.exr --products height")
    before = ocean.hashes(".")
    done = ocean("bake sea.toml --frames 2-5 -o s.####.exr --products height --skip-existing -n")
    assert done.stdout.splitlines() == [
        "s.height.0002.exr\tkept",
        "s.height.0003.exr\tkept",
        "s.height.0004.exr",
        "s.height.0005.exr",
    ]
    assert ocean.hashes(".") == before


@pytest.mark.parametrize("more", [[], ["--skip-existing"]])
def test_a_dry_run_of_a_million_frames_answers_at_once(ocean, more):
    """In a few times what one frame takes; it took thousands of times that."""
    bake = ("bake", "sea.toml", "-o", "s.####.exr", "--products", "height")
    ocean.good(*bake, "--frames", "7-8")
    start = children_seconds()
    one = events(ocean(*bake, "--frames", "7", "-n", "--json"))[0]
    middle = children_seconds()
    done = ocean(*bake, "--frames", "1-1000000", "-n", "--json", *more)
    assert children_seconds() - middle < 20 * (middle - start)
    kept = 2 if more else 0
    assert done.stdout == (
        f"s.height.0001.exr ... s.height.1000000.exr\t1000000 files, {kept} kept\n"
    )
    plan = events(done)[0]
    assert (plan["files"], plan["kept"]) == (1000000, kept)
    assert plan["bytes"] == pytest.approx((1000000 - kept) * one["bytes"], rel=0.01)


def test_a_dry_run_warns_of_a_disk_that_is_too_small(ocean, request):
    if ran_in_a_namespace(ocean, request):
        return
    with small_disk(ocean.folder, 64 * 1024):
        done = ocean(*BAKE, pattern("disk"), "-n")
        assert done.returncode == 0 and "warning" in done.stderr and "may not fit" in done.stderr
        assert ocean.files("disk") == []


def test_frames_side_by_side_stay_within_half_of_the_memory(ocean):
    def memory(frames, limit):
        script = f"ulimit -v {limit}; " if limit else ""
        script += '"$OCEAN" bake sea.toml --products displacement,normal --set resolution=1024 '
        script += "--threads 64 -n --json -o s.#.exr"
        return events(ocean.shell(f"{script} --frames 1-{frames}"))[0]["memory_bytes"]

    one = memory(1, None)
    assert one < 0.2e9 < 3.5 * one < memory(8, None)
    assert 3.5 * one < memory(64, 1_500_000) < 750_000 * 1024


@pytest.fixture
def blocked(ocean):
    """A sea whose frame 4 has a folder where its file should go."""
    (ocean.folder / "out/s.height.0004.exr").mkdir(parents=True)
    return [*BAKE_SOME, pattern("out"), "--products", "height"]


def test_a_failure_ends_the_bake_and_says_how_far_it_came(ocean, blocked):
    done = ocean(*blocked, "--threads", "1")
    assert done.returncode == 1
    last = done.stderr.splitlines()[-1]
    assert last.startswith("ocean: cannot write 'out/s.height.0004.exr'")
    assert last.endswith("; 3 of 10 frames are complete")
    assert len(done.stdout.splitlines()) == 3
    assert len(ocean.manifest("out/s.manifest.json")) == 3


def test_with_keep_going_the_other_frames_go_on(ocean, blocked):
    done = ocean(*blocked, "--keep-going")
    assert done.returncode == 1
    lines = done.stderr.splitlines()
    assert lines[-1] == "ocean: 1 of 10 frames failed: 4"
    assert any(line.startswith("ocean: frame 4 failed: cannot write") for line in lines)
    assert len(done.stdout.splitlines()) == 9
    assert len(ocean.manifest("out/s.manifest.json")) == 9


def test_json_lines_count_what_became_of_each_frame(ocean, blocked):
    ocean.good("bake sea.toml -o", pattern("out"), "--products", "height", "--frames", "2-3")
    done = ocean(*blocked, "--keep-going", "--skip-existing", "--json")
    log = events(done)
    assert log[0]["event"] == "start" and log[0]["total"] == 10
    kinds = {event["frame"]: event["event"] for event in log if "frame" in event}
    assert list(kinds) == list(range(1, 11))
    assert {frame for frame, kind in kinds.items() if kind == "skipped"} == {2, 3}
    assert {frame for frame, kind in kinds.items() if kind == "failed"} == {4}
    counts = {key: log[-2][key] for key in ("event", "done", "skipped", "failed", "total")}
    assert counts == {"event": "done", "done": 9, "skipped": 2, "failed": 1, "total": 10}
    assert log[-1]["event"] == "error"


def test_a_closed_pipe_ends_the_bake_with_a_manifest(ocean):
    """As `| head` does: without a word, every file whole and listed."""
    done = ocean.shell(
        '"$OCEAN" bake sea.toml --set fetch=80000 --frames 1-5000 -o out/s.####.exr'
        " --products height --json | head -n 2; exit ${PIPESTATUS[0]}"
    )
    assert done.returncode == 128 + signal.SIGPIPE
    assert {event["event"] for event in events(done)} == {"start", "frame"}
    names = [name for name in ocean.files() if name.endswith(".exr")]
    assert 2 <= len(names) < 5000
    assert sorted(ocean.manifest("out/s.manifest.json")) == names
    assert len(ocean.files()) == len(names) + 1


@pytest.mark.parametrize("command", ["presets --help", "info sea.toml", "bake --help"])
def test_commands_end_silently_at_a_closed_pipe(ocean, command):
    done = ocean.shell(f'"$OCEAN" {command} | true; exit ${{PIPESTATUS[0]}}')
    assert done.returncode in (0, 128 + signal.SIGPIPE) and done.stderr == ""


def test_a_pipe_gets_no_manifest(ocean):
    os.mkfifo(ocean.folder / "s.png")
    reader = subprocess.Popen(["cat", "s.png"], cwd=ocean.folder, stdout=subprocess.PIPE)
    ocean.good("bake sea.toml -o s.png")
    assert reader.communicate(timeout=120)[0].startswith(b"\x89PNG")
    assert set(ocean.manifest("s.manifest.json")) == {"s.png.txt", "s.png.inc"}
