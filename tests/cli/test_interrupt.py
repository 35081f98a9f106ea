# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Ctrl-C in the middle of a bake: no half file, no temporary, exit code 130."""

import json
import os
import signal
import subprocess
import time

import OpenImageIO
import pytest
from conftest import OCEAN, children_seconds, cpu_seconds

BAKE = [OCEAN, "bake", "sea.toml", "-o", "out/s.####.exr", "--frames", "1-5000", "--set",
        "resolution=512"]  # fmt: skip
PLAIN = ["--products", "displacement,normal"]


def start(ocean, *more):
    return subprocess.Popen(
        [*BAKE, *(more if "--products" in more else [*PLAIN, *more])],
        cwd=ocean.folder,
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )


def check_whole_files(ocean):
    files = [name for name in ocean.files("out") if name != "s.manifest.json"]
    assert files
    for name in files:
        assert name.endswith(".exr") and not name.startswith(".")
        image = OpenImageIO.ImageBuf(str(ocean.folder / "out" / name))
        assert image.read(force=True), image.geterror()
    return files


def interrupt(process, number=signal.SIGINT):
    """Sends the signal; returns what is left on both streams."""
    process.send_signal(number)
    rest, errors = process.communicate(timeout=120)
    assert process.returncode == 130, errors
    return rest, errors


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_an_interrupted_bake_says_how_far_it_came(ocean, number):
    process = start(ocean)
    for _ in range(4):
        process.stdout.readline()
    rest, errors = interrupt(process, number)
    printed = 4 + len(rest.splitlines())
    last = errors.splitlines()[-1]
    # A frame is counted, then printed: the signal may come between the two, and printing waits for
    # no lock, so that a reader who stalls does not keep the signal from being answered.
    done = [printed // 2, printed // 2 + 1]
    assert last in [f"ocean: interrupted: {n} of 5000 frames are done" for n in done]
    files = check_whole_files(ocean)
    # Two files a frame, of two frames for each core, in hand or waiting for one before them.
    assert printed <= len(files) <= printed + 2 * (2 * len(os.sched_getaffinity(0)) + 1)
    assert set(ocean.manifest("out/s.manifest.json")) == set(files)


@pytest.mark.parametrize("attempt", range(4))
def test_an_interrupt_lets_the_current_file_be_completed(ocean, attempt):
    every = "height,displacement,slope,normal,jacobian,velocity"
    process = start(ocean, "--layout", "layered", "--products", every, "--resolution", "1024")
    out = ocean.folder / "out"
    deadline = time.monotonic() + 120.0
    # The temporary is there: the signal comes in the middle of a file.
    while not list(out.glob(".*.tmp")):
        assert time.monotonic() < deadline
        time.sleep(0.0002)
    interrupt(process)
    files = check_whole_files(ocean)
    assert set(ocean.manifest("out/s.manifest.json")) == set(files)


def test_json_tells_of_the_interruption(ocean):
    process = start(ocean, "--json")
    process.stdout.readline()
    _, errors = interrupt(process)
    events = [json.loads(line) for line in errors.splitlines()]
    assert events[-1]["event"] == "interrupted" and events[-1]["total"] == 5000


def test_a_long_computation_is_left_at_once(ocean):
    process = start(ocean, "--backend", "dft", "--set", "resolution=1024")
    process.stderr.readline()
    while cpu_seconds(process) < 0.3:  # it computes
        assert process.poll() is None
        time.sleep(0.01)
    before = children_seconds()
    interrupt(process)
    # All that it had of the processor. The sums of a 1024 x 1024 frame take 18 s of it.
    assert 0.3 < children_seconds() - before < 5.0
    assert ocean.files("out") == []


def test_an_ignored_signal_stays_ignored(ocean):
    script = """trap '' INT
    "$OCEAN" bake sea.toml -o out/s.####.exr --frames 1-20 > list & process=$!
    until [ -s list ]; do sleep 0.01; done
    kill -INT "$process"; wait "$process"; echo "exit $?" """
    assert "exit 0" in ocean.shell(script).stdout
    assert len(ocean.files("out")) == 61


def test_what_a_killed_bake_leaves_is_removed_by_the_next(ocean):
    process = start(ocean)
    process.stdout.readline()
    process.kill()
    process.communicate(timeout=120)
    assert process.returncode == -signal.SIGKILL
    ocean.write("out/.s.exr.ocean-999999999-0.tmp", "left")
    ocean.good("bake sea.toml -o out/s.####.exr --overwrite")
    check_whole_files(ocean)
