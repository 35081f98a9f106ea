# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""From a knob of the dummy board through the bridge to the sea that ocean-preview draws."""

import os
import random
import re
import signal
import subprocess
import threading
import time
import tomllib
from pathlib import Path

import numpy
import OpenImageIO as oiio
import pytest
from conftest import OCEAN, cpu_seconds
from test_bridge import Bridge

PREVIEW = os.environ.get("OCEAN_PREVIEW", "")
if not PREVIEW:
    pytest.skip("ocean-preview was not built", allow_module_level=True)
SEA = """libocean = 1
[grid]
resolution = 64
patch_size = 200.0
[random]
seed = 4
[[waves]]
spectrum = "jonswap"
wind_speed = 9.0
wind_direction = 30.0
"""
PATIENCE = 240.0  # s, for what hangs; not for what is slow on a busy machine
KEPT = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}


def wait_for(condition, *programs: subprocess.Popen):
    """Until it is so, while these programs run."""
    deadline = time.monotonic() + PATIENCE
    while time.monotonic() < deadline:
        found = condition()
        if found:
            return found
        assert all(program.poll() is None for program in programs)
        time.sleep(0.02)
    raise AssertionError("waited for nothing")


def lines_of(stream) -> list[str]:
    """All that comes, as it comes."""
    lines = []
    threading.Thread(target=lambda: lines.extend(stream), daemon=True).start()
    return lines


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "sea.toml").write_text(SEA)
    return tmp_path


@pytest.fixture
def bridge(folder):
    started = Bridge(folder, "sea.toml", "--dummy")
    yield started
    started.stop()


@pytest.fixture
def window(folder, bridge, display):
    """Opens windows that have joined the bridge; in the end they are closed."""
    opened = []

    def one(*options, **streams) -> subprocess.Popen:
        command = [PREVIEW, "sea.toml", "--bridge", bridge.address, "--size", "64x64", *options]
        streams = {"stderr": subprocess.DEVNULL} | streams
        environment = os.environ | {"DISPLAY": display}
        opened.append(subprocess.Popen(command, cwd=folder, env=environment, **streams))
        return opened[-1]

    yield one
    for each in opened:
        each.terminate()
        each.wait(timeout=PATIENCE)


def preview(folder: Path, *arguments) -> subprocess.CompletedProcess:
    command = [PREVIEW, *map(str, arguments)]
    return subprocess.run(
        command, cwd=folder, env=KEPT, capture_output=True, text=True, timeout=PATIENCE
    )


def test_a_sea_is_drawn_as_the_board_has_it(folder, bridge):
    join = ("sea.toml", "--bridge", bridge.address, "--time", 5, "--probe", "3,4")
    alone = preview(folder, "sea.toml", "--time", 5, "--probe", "3,4").stdout
    # Nobody has moved anything: the sea is the file's.
    still = preview(folder, *join)
    assert still.returncode == 0, still.stderr
    assert still.stdout == alone
    # The first report says where the knob is; from the second on it moves the wind.
    connection = bridge.say("OUT board0/a1 10", "OUT board0/a1 128")
    reader = connection.makefile("r")

    def wind_of_the_bridge() -> str:
        connection.sendall(b"GET waves.0.wind_speed\r\n")
        value = reader.readline().split()[2]
        return value if value != "unset" and float(value) > 10.0 else ""

    wind = wait_for(wind_of_the_bridge)
    moved = preview(folder, *join, "--offscreen", "a.png", "--size", "64x36")
    assert moved.returncode == 0 and (folder / "a.png").exists()
    assert wind_of_the_bridge() == wind
    expected = preview(
        folder, "sea.toml", "--set", f"wind_speed={wind}", "--time", 5, "--probe", "3,4"
    )
    assert moved.stdout.splitlines()[0] == expected.stdout.strip()


def test_a_coast_is_drawn_as_without_a_bridge(folder, bridge):
    beach = " ".join(str(0.25 * column - 4.0) for column in range(25))
    head = "ncols 25\nnrows 25\nxllcenter 0\nyllcenter 0\ncellsize 4\n"
    (folder / "bed.asc").write_text(head + f"{beach}\n" * 25)
    coast = ("sea.toml", "--set", "water.seabed=bed.asc", "--set", "grid.resolution=32")
    coast += ("--size", "64x36", "--offscreen")
    for name, *join in (("alone.png",), ("joined.png", "--bridge", bridge.address)):
        drawn = preview(folder, *coast, name, *join)
        assert drawn.returncode == 0, drawn.stderr
    alone, joined = (oiio.ImageBuf(str(folder / f"{n}.png")) for n in ("alone", "joined"))
    assert numpy.array_equal(alone.get_pixels(), joined.get_pixels())


def test_a_knob_moves_the_sea_that_is_shown(folder, bridge):
    join = ("sea.toml", "--bridge", bridge.address, "--time", 5, "--probe", "3,4", "--follow")
    follows = subprocess.Popen(
        [PREVIEW, *map(str, join), "600"], cwd=folder, env=KEPT, stdout=subprocess.PIPE, text=True
    )
    first = follows.stdout.readline().split(",")
    assert first[1:3] == ["3", "4"]
    start = cpu_seconds(follows)
    hand = bridge.say("OUT board0/a1 10")
    heights = [first[3]]
    for value in (60, 120, 180, 90):
        hand.sendall(f"OUT board0/a1 {value}\r\n".encode())
        line = follows.stdout.readline().split(",")
        assert line[3] != heights[-1]
        heights.append(line[3])
    # It follows at once: another height is a small part of what the start is.
    assert cpu_seconds(follows) - start < 4 * 0.5 * start
    follows.send_signal(signal.SIGINT)
    assert follows.wait(timeout=PATIENCE) == 130
    # After its seconds it ends by itself.
    done = preview(folder, *join, 0.1, "--no-detail")
    assert done.returncode == 0 and done.stdout, done.stderr


@pytest.mark.parametrize("backend", ["cpu", "gl"])
def test_what_a_board_performed_is_baked_as_it_was_shown(folder, bridge, backend):
    program = [os.environ["PERFORM_LIVE"], "sea.toml", backend, ".", bridge.address]
    performs = subprocess.Popen(program, cwd=folder, env=KEPT)
    hand = bridge.say("OUT board0/a1 10", "OUT board0/a2 10")
    random.seed(3)
    while performs.poll() is None:
        hand.sendall(f"OUT board0/a1 {random.randint(30, 200)}\r\n".encode())
        hand.sendall(f"OUT board0/a2 {random.randint(30, 200)}\r\n".encode())
        hand.recv(4096)
        time.sleep(0.02)  # as fast as hands are: reports are as many as they like
    assert performs.returncode == 0
    take = tomllib.loads((folder / "performed.toml").read_text())["take"]["lines"]
    assert len(take) > 50 and {line.split()[1] for line in take} > {"waves.0.wind_speed"}
    shown = sorted(folder.glob("heights-*.f32"))
    frames = [path.stem.split("-")[1] for path in shown]
    assert len(frames) == 20
    command = [OCEAN, "bake", "performed.toml", "-q", "-o", "####.exr", "--products", "height"]
    command += ["--type", "float", "--resolution", "128", "--frames", ",".join(frames)]
    subprocess.run(command, cwd=folder, check=True, capture_output=True)
    for path, frame in zip(shown, frames, strict=True):
        heights = numpy.fromfile(path, numpy.float32).reshape(128, 128)
        baked = oiio.ImageBuf(str(folder / f"height.{int(frame):04}.exr"))
        baked = baked.get_pixels(oiio.FLOAT)[::-1, :, 0]
        assert baked.std() > 0.05
        assert abs(heights - baked).max() < 1e-5 * 4 * baked.std()


def test_a_window_that_never_recorded_says_nothing_of_it(bridge, window):
    """Its word could end a take that another has just begun."""
    window()
    watch = bridge.say()
    watch.settimeout(PATIENCE)
    watch.sendall(b"SUBSCRIBE app.time app.record\r\n")
    told = []
    for line in watch.makefile("r", encoding="utf-8"):
        told.append(line.strip())
        if sum(line.startswith("UPD app.time") for line in told) == 4:
            break
    assert any("WRITER app.time" in line for line in told), told
    assert not any("WRITER app.record" in line for line in told), told


def test_a_window_that_is_joined_writes_the_take(folder, bridge, window):
    shown = window()
    watch = bridge.say()
    watch.settimeout(PATIENCE)
    watch.sendall(b"SUBSCRIBE app.time\r\n")
    told = watch.makefile("r", encoding="utf-8")

    def writer_of_the_time() -> str:
        while True:
            found = re.search(r"EVT WRITER app.time (\S+)", told.readline())
            if found:
                return found[1]

    the_window = writer_of_the_time()
    hand = bridge.say()
    reader = hand.makefile("r", encoding="utf-8")

    def ask(line: str) -> str:
        hand.sendall(f"{line}\r\n".encode())
        return reader.readline().strip()

    def time_of_the_sea() -> float:
        return float(ask("GET app.time").split()[2])

    # It says how fast it draws, and where its clock is.
    wait_for(lambda: float(ask("GET app.frame_rate").split()[2]) > 0.0, shown)
    assert ask("RECORD START storm.take") == "OK"
    ask("OUT board0/a1 10")
    for value in (60, 120, 180):
        assert ask(f"OUT board0/a1 {value}") == "OK"
        # Each is heard at a time of its own: the window tells its clock when it has heard.
        for _ in range(2):
            before = time_of_the_sea()
            wait_for(lambda before=before: time_of_the_sea() > before, shown)
    # Another sea is shown too, and is in no take.
    assert ask("SET random.seed 12") == "OK"
    assert ask("RECORD STOP") == "OK"
    saved = folder / "storm.toml"
    wait_for(saved.exists, shown)
    sea = tomllib.loads(saved.read_text())
    assert {line.split()[1] for line in sea["take"]["lines"]} == {"waves.0.wind_speed"}
    assert float(sea["take"]["lines"][0].split()[0]) > 0.0
    # Its clock is heard and set.
    assert ask("SET app.pause 1") == "OK"

    def stands() -> bool:
        before = ask("GET app.time")
        time.sleep(1.0)  # of a clock that stands nothing is told: it would be several times
        return ask("GET app.time") == before

    # When it tells this as its own time, it has heard of the pause before.
    assert ask("SET app.time 50") == "OK"
    while writer_of_the_time() == the_window:
        pass
    while writer_of_the_time() != the_window:
        pass
    wait_for(lambda: time_of_the_sea() == 50.0, shown)
    assert stands()
    assert ask("SET app.time 100") == "OK"
    assert ask("SET app.pause 0") == "OK"
    wait_for(lambda: time_of_the_sea() > 100.5, shown)
    # A button that is held for a moment only, perhaps for less than a frame.
    assert ask("SET app.pause 1") == "OK"
    time.sleep(0.2)
    assert ask("SET app.pause 0") == "OK"
    paused_at = time_of_the_sea()
    wait_for(lambda: time_of_the_sea() > paused_at + 1.0, shown)


HULL = """
[[hulls]]
length = 12.0
beam = 3.0
draught = 0.8
wake_resolution = 64
track = [[-60.0, 20.0, -240.0], [0.0, 20.0, 0.0], [900.0, 20.0, 3600.0]]
"""


def test_a_client_drives_a_hull_and_its_way_is_saved(folder, bridge, window):
    (folder / "sea.toml").write_text(SEA + HULL)
    shown = window("-v", "--no-detail", stderr=subprocess.PIPE, text=True)
    lines = lines_of(shown.stderr)
    hand = bridge.say()
    reader = hand.makefile("r", encoding="utf-8")

    def ask(line: str) -> str:
        hand.sendall(f"{line}\r\n".encode())
        return reader.readline().strip()

    def number(name: str) -> float:
        return float(ask(f"GET {name}").split()[2])

    wait_for(lambda: number("app.frame_rate") > 0.0, shown)
    for wrong in ("app.hull.speed 1e9", "app.hull.heading nan", "app.hull.drive 17"):
        assert ask(f"SET {wrong}").startswith("ERR RANGE"), wrong
    # The preview tells what the sea does not have, and the value goes back.
    assert ask("SET app.hull.drive 2") == "OK"
    wait_for(lambda: any("hulls.1: the sea has no such hull" in line for line in lines), shown)
    wait_for(lambda: number("app.hull.drive") == 0.0, shown)
    assert ask("SET app.hull.drive 1") == "OK"
    # The drive begins with the speed and the heading of the track.
    wait_for(lambda: number("app.hull.heading") == pytest.approx(90.0), shown)
    assert number("app.hull.speed") == pytest.approx(4.0)
    assert ask("SET app.hull.heading 20") == "OK"
    assert ask("SET app.hull.speed 6") == "OK"
    assert ask("RECORD START drive.take") == "OK"
    until = number("app.time") + 6.0
    wait_for(lambda: number("app.time") > until, shown)
    assert ask("SET app.hull.drive 0") == "OK"
    assert number("app.hull.speed") == 6.0 and number("app.hull.heading") == 20.0
    assert ask("RECORD STOP") == "OK"
    saved = folder / "drive.toml"
    wait_for(saved.exists, shown)
    (hull,) = tomllib.loads(saved.read_text())["hulls"]
    times, x, y, heading, speed = numpy.array(hull["track"]).T
    assert times[0] == -60.0 and hull["track"][0][1:] == [20.0, -240.0, 90.0, 4.0]
    assert heading[-1] == pytest.approx(20.0) and speed[-1] == pytest.approx(6.0)
    assert 5.0 < times[-1] < 900.0 and x[-1] > 25.0
    # Any frame of it is rendered alone.
    told = subprocess.run([OCEAN, "info", "drive.toml"], cwd=folder, capture_output=True, text=True)
    assert told.returncode == 0, told.stderr


def test_of_two_windows_one_has_the_clock_and_both_follow_it(bridge, window):
    told = []

    def open_window() -> subprocess.Popen:
        opened = window("-v", stderr=subprocess.PIPE, text=True)
        told.append(lines_of(opened.stderr))
        return opened

    hand = bridge.say()
    reader = hand.makefile("r", encoding="utf-8")

    def tell(line: str):
        hand.sendall(f"{line}\r\n".encode())

    def clock_of(pattern: str) -> re.Match:
        while True:
            found = re.search(pattern, reader.readline())
            if found:
                return found

    windows = [open_window()]
    tell("SUBSCRIBE app.time")
    first = clock_of(r"EVT WRITER app.time (\S+)")[1]
    windows.append(open_window())
    # It knows whose clock is shown when it knows the values.
    wait_for(lambda: any("its values have come" in line for line in told[1]), *windows)
    tell("SET app.time 500")
    clock_of(r"EVT WRITER app.time (?!" + first + ")")
    clock_of(r"EVT WRITER app.time " + first)
    # Times that it sent before it heard of the change may come between.
    clock_of(r"UPD app.time [5-8]\d\d")
    # From now on nobody but the first window tells it, until that is closed.
    times = [float(clock_of("UPD app.time (.*)")[1]) for _ in range(4)]
    assert times == sorted(times) and 500.0 < times[0] < times[-1] < 900.0
    windows[0].terminate()
    second = clock_of(r"EVT WRITER app.time (\S+)")[1]
    assert second != first
    assert 500.0 < float(clock_of("UPD app.time (.*)")[1]) < 900.0


def test_a_lost_bridge_is_told_and_what_it_moved_holds(folder):
    first = Bridge(folder, "sea.toml", "--dummy")
    join = ("sea.toml", "--bridge", first.address, "--probe", "3,4", "--follow", 600, "-v")
    follows = subprocess.Popen(
        [PREVIEW, *map(str, join)],
        cwd=folder,
        env=KEPT,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    follows.stdout.readline()
    first.say("SET wind_speed 17")
    moved = follows.stdout.readline().split(",", 1)[1]
    errors = lines_of(follows.stderr)
    first.stop()
    wait_for(lambda: any("lost" in line for line in errors), follows)
    follows.send_signal(signal.SIGINT)
    out = follows.stdout.read()
    assert follows.wait(timeout=PATIENCE) == 130  # until then it was there
    expected = preview(folder, "sea.toml", "--set", "wind_speed=17", "--probe", "3,4").stdout
    # Its foam has only begun.
    assert moved.split(",")[:6] == expected.split(",")[:6] and out == ""
