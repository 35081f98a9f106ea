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

import numpy
import pytest
import test_preview
from conftest import KEPT, OCEAN, cpu_seconds
from test_bridge import Bridge
from test_preview import PREVIEW, expect_baked_as_shown, good, pixels

SEA = test_preview.SEA.replace("resolution = 128", "resolution = 64")
PATIENCE = 240.0  # s, for what hangs; not for what is slow on a busy machine


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


class Client:
    """A client of the bridge."""

    def __init__(self, bridge: Bridge):
        self.socket = bridge.say()
        self.lines = self.socket.makefile("r", encoding="utf-8")

    def tell(self, line: str):
        self.socket.sendall(f"{line}\r\n".encode())

    def ask(self, line: str) -> str:
        self.tell(line)
        return self.lines.readline().strip()

    def value(self, name: str) -> str:
        return self.ask(f"GET {name}").split()[2]

    def number(self, name: str) -> float:
        return float(self.value(name))

    def found(self, pattern: str) -> re.Match:
        """In the next line that has the pattern."""
        while line := self.lines.readline():
            if found := re.search(pattern, line):
                return found
        raise AssertionError(f"no {pattern!r} to the end")


@pytest.fixture
def hand(bridge) -> Client:
    return Client(bridge)


def opened(folder, *arguments) -> subprocess.Popen:
    """The program without a display."""
    return subprocess.Popen(
        [PREVIEW, *map(str, arguments)], cwd=folder, env=KEPT, stdout=subprocess.PIPE,
        stderr=subprocess.PIPE, text=True,
    )  # fmt: skip


def test_a_sea_is_drawn_as_the_board_has_it(folder, bridge, hand):
    join = ("sea.toml", "--bridge", bridge.address, "--time", 5, "--probe", "3,4")
    # Nobody has moved anything: the sea is the file's.
    assert good(folder, *join) == good(folder, "sea.toml --time 5 --probe 3,4")
    # The first report says where the knob is; from the second on it moves the wind.
    for value in (10, 128):
        assert hand.ask(f"OUT board0/a1 {value}") == "OK"

    def wind_of_the_bridge() -> str:
        value = hand.value("waves.0.wind_speed")
        return value if value != "unset" and float(value) > 10.0 else ""

    wind = wait_for(wind_of_the_bridge)
    moved = good(folder, *join, "--offscreen", "a.png", "--size", "64x36")
    assert (folder / "a.png").exists() and wind_of_the_bridge() == wind
    expected = good(folder, f"sea.toml --set wind_speed={wind} --time 5 --probe 3,4")
    assert moved.splitlines()[0] == expected.strip()


def test_a_coast_is_drawn_as_without_a_bridge(folder, bridge):
    beach = " ".join(str(0.25 * column - 4.0) for column in range(25))
    head = "ncols 25\nnrows 25\nxllcenter 0\nyllcenter 0\ncellsize 4\n"
    (folder / "bed.asc").write_text(head + f"{beach}\n" * 25)
    coast = ("sea.toml", "--set", "water.seabed=bed.asc", "--set", "grid.resolution=32")
    coast += ("--size", "64x36", "--offscreen")
    good(folder, *coast, "alone.png")
    good(folder, *coast, "joined.png", "--bridge", bridge.address)
    assert numpy.array_equal(*(pixels(folder / f"{name}.png") for name in ("alone", "joined")))


def test_a_knob_moves_the_sea_that_is_shown(folder, bridge, hand):
    join = ("sea.toml", "--bridge", bridge.address, "--time", 5, "--probe", "3,4", "--follow")
    follows = opened(folder, *join, 600)
    first = follows.stdout.readline().split(",")
    assert first[1:3] == ["3", "4"]
    start = cpu_seconds(follows)
    hand.ask("OUT board0/a1 10")
    heights = [first[3]]
    for value in (60, 120, 180, 90):
        hand.tell(f"OUT board0/a1 {value}")
        line = follows.stdout.readline().split(",")
        assert line[3] != heights[-1]
        heights.append(line[3])
    # It follows at once: another height is a small part of what the start is.
    assert cpu_seconds(follows) - start < 4 * 0.5 * start
    follows.send_signal(signal.SIGINT)
    assert follows.wait(timeout=PATIENCE) == 130
    # After its seconds it ends by itself.
    assert good(folder, *join, 0.1, "--no-detail")


@pytest.mark.parametrize("backend", ["cpu", "gl"])
def test_what_a_board_performed_is_baked_as_it_was_shown(folder, bridge, hand, backend):
    program = [os.environ["PERFORM_LIVE"], "sea.toml", backend, ".", bridge.address]
    performs = subprocess.Popen(program, cwd=folder, env=KEPT)
    random.seed(3)
    while performs.poll() is None:
        for knob in (1, 2):
            assert hand.ask(f"OUT board0/a{knob} {random.randint(30, 200)}") == "OK"
        time.sleep(0.02)  # as fast as hands are: reports are as many as they like
    assert performs.returncode == 0
    take = tomllib.loads((folder / "performed.toml").read_text())["take"]["lines"]
    assert len(take) > 50 and {line.split()[1] for line in take} > {"waves.0.wind_speed"}
    expect_baked_as_shown(folder, 128)


def test_a_window_that_never_recorded_says_nothing_of_it(window, hand):
    """Its word could end a take that another has just begun."""
    window()
    hand.tell("SUBSCRIBE app.time app.record")
    told = []
    while sum(line.startswith("UPD app.time") for line in told) < 4:
        told.append(hand.lines.readline().strip())
    assert any("WRITER app.time" in line for line in told), told
    assert not any("WRITER app.record" in line for line in told), told


def test_a_window_that_is_joined_writes_the_take(folder, bridge, window, hand):
    shown = window()
    watch = Client(bridge)
    watch.tell("SUBSCRIBE app.time")

    def writer_of_the_time() -> str:
        return watch.found(r"EVT WRITER app.time (\S+)")[1]

    the_window = writer_of_the_time()
    ask = hand.ask

    def time_of_the_sea() -> float:
        return hand.number("app.time")

    # It says how fast it draws, and where its clock is.
    wait_for(lambda: hand.number("app.frame_rate") > 0.0, shown)
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


def test_a_client_drives_a_hull_and_its_way_is_saved(folder, window, hand):
    (folder / "sea.toml").write_text(SEA + HULL)
    shown = window("-v", "--no-detail", stderr=subprocess.PIPE, text=True)
    lines = lines_of(shown.stderr)
    ask, number = hand.ask, hand.number
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


def test_of_two_windows_one_has_the_clock_and_both_follow_it(window, hand):
    told = []

    def open_window() -> subprocess.Popen:
        opened = window("-v", stderr=subprocess.PIPE, text=True)
        told.append(lines_of(opened.stderr))
        return opened

    tell, clock_of = hand.tell, hand.found
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
    follows = opened(folder, *join)
    follows.stdout.readline()
    first.say("SET wind_speed 17")
    moved = follows.stdout.readline().split(",", 1)[1]
    errors = lines_of(follows.stderr)
    first.stop()
    wait_for(lambda: any("lost" in line for line in errors), follows)
    follows.send_signal(signal.SIGINT)
    out = follows.stdout.read()
    assert follows.wait(timeout=PATIENCE) == 130  # until then it was there
    expected = good(folder, "sea.toml --set wind_speed=17 --probe 3,4")
    # Its foam has only begun.
    assert moved.split(",")[:6] == expected.split(",")[:6] and out == ""
