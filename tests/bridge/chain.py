#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""From a report on the bus to a vertex of the sea: a K8055 in umockdev's test bed, the real libusb,
ocean-bridge, a client over TCP and ocean-preview --offscreen, with the time of each step.

usage: tests/bridge/chain.py [--build build/dev] [--steps 100] [--rate 1000]
"""

import argparse
import os
import queue
import re
import socket
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

PATIENCE = 120  # s; on a busy machine
SEA = """libocean = 1
[grid]
resolution = 64
patch_size = 200.0
[[waves]]
spectrum = "jonswap"
wind_speed = 9.0
"""
MAP = """[[device]]
id = "board0"
driver = "k8055"
[[map]]
from = "board0/a1"
to = "wind_speed"
out = [5, 30]
[[out]]
from = "app.frame_rate"
to = "board0/dac1"
in = [0, 120]
"""


class Lines:
    """The lines of a stream with the times at which they came."""

    def __init__(self, stream):
        self.queue = queue.Queue()
        threading.Thread(target=self.read, args=(stream,), daemon=True).start()

    def read(self, stream):
        for line in stream:
            self.queue.put((time.monotonic(), line.rstrip("\r\n")))
        self.queue.put((time.monotonic(), None))

    def wait_for(self, pattern: str) -> tuple[float, re.Match]:
        """The next line that has the pattern."""
        while True:
            when, line = self.queue.get(timeout=PATIENCE)
            assert line is not None, f"the stream ended before {pattern!r}"
            if found := re.search(pattern, line):
                return when, found


class MockedBus:
    """A K8055 on a bus of its own, and a program that reads it by libusb."""

    def __init__(self, build: Path, folder: Path, *reader):
        command = ["umockdev-wrapper", build / "tests/bridge/mock_k8055_program", *reader]
        self.program = subprocess.Popen(
            [str(word) for word in command],
            cwd=folder,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.bus = Lines(self.program.stdout)
        self.log = Lines(self.program.stderr)
        self.pid = int(self.bus.wait_for(r"program (\d+)")[1][1])

    def tell(self, command: str):
        self.program.stdin.write(command + "\n")
        self.program.stdin.flush()

    def plug(self, a1: int = 0):
        """With the knob there: the first report says so and moves nothing."""
        self.tell(f"set {a1} 0 0 0 0")
        self.tell("plug")
        self.bus.wait_for("sent")

    def step(self, a1: int) -> float:
        """The knob is there; when the report went out."""
        self.tell(f"set {a1} 0 0 0 0")
        return float(self.bus.wait_for(r"sent ([\d.]+)")[1][1])

    def seconds(self) -> float:
        """The processor time of all threads of the program [s]."""
        tasks = Path(f"/proc/{self.pid}/task").glob("*/schedstat")
        return sum(int(task.read_text().split()[0]) for task in tasks) * 1e-9

    def end(self) -> int:
        """The exit code of the program."""
        self.program.stdin.close()
        return self.program.wait(timeout=PATIENCE)


class MockedBoard(MockedBus):
    """A mocked board and ocean-bridge, which has found it."""

    def __init__(self, build: Path, folder: Path, *arguments):
        listening = [build / "bin/ocean-bridge", "--listen", "127.0.0.1:0"]
        super().__init__(build, folder, *listening, *arguments)
        self.port = int(self.log.wait_for(r"listening on 127\.0\.0\.1:(\d+)")[1][1])
        self.address = f"127.0.0.1:{self.port}"

    def client(self, *lines: str) -> tuple[socket.socket, Lines]:
        connection = socket.create_connection(("127.0.0.1", self.port), timeout=PATIENCE)
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        connection.sendall("".join(f"{line}\r\n" for line in lines).encode())
        return connection, Lines(connection.makefile("r", encoding="utf-8", newline="\n"))


def wait_until(condition):
    end = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < end, "waited for nothing"
        time.sleep(0.01)


def measure(build: Path, steps: int, rate: int) -> dict[str, list[float]]:
    """Milliseconds from the report on the bus on."""
    times = {"UPD at a client": [], "vertex changed": []}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "sea.toml").write_text(SEA)
        (folder / "map.toml").write_text(MAP)
        board = MockedBoard(build, folder, "sea.toml", "--map", "map.toml")
        board.plug(10)
        board.tell(f"rate {rate}")
        board.log.wait_for("board0 CONNECTED")
        _connection, client = board.client("SUBSCRIBE wind_speed")
        client.wait_for("VAL wind_speed")
        preview = subprocess.Popen(
            [str(build / "bin/ocean-preview"), "sea.toml", "--offscreen", "sea.png"]
            + ["--size", "64x36", "--bridge", board.address, "--probe", "3,4", "--follow", "3600"],
            cwd=folder,
            stdout=subprocess.PIPE,
            text=True,
            env={k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")},
        )
        try:
            shown = Lines(preview.stdout)
            shown.wait_for(",")
            # The first picture compiles its shaders, and the first change those of a live sea.
            wait_until((folder / "sea.png").exists)
            board.step(30)
            client.wait_for("UPD wind_speed")
            height = shown.wait_for(",")[1].string.split(",")[3]
            for step in range(steps):
                sent = board.step(40 + step * 53 % 200)
                times["UPD at a client"].append(client.wait_for("UPD wind_speed")[0] - sent)
                when, line = shown.wait_for(",")
                times["vertex changed"].append(when - sent)
                before, height = height, line.string.split(",")[3]
                assert height != before, f"the vertex stays at {height}"
        finally:
            preview.kill()
            preview.wait()
            code = board.end()
        assert code == 130, f"ocean-bridge ends with {code}"  # interrupted
    return {name: [1000 * value for value in values] for name, values in times.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--build", type=Path, default=Path("build/dev"))
    parser.add_argument("--steps", type=int, default=100)
    parser.add_argument("--rate", type=int, default=1000, help="reports a second")
    words = parser.parse_args()
    times = measure(words.build.resolve(), words.steps, words.rate)
    print(f"{'ms from the report on the bus':32}{'median':>8}{'99 of 100':>11}{'longest':>9}")
    for name, values in times.items():
        values.sort()
        late = values[min(len(values) * 99 // 100, len(values) - 1)]
        print(f"{name:32}{statistics.median(values):8.2f}{late:11.2f}{values[-1]:9.2f}")


if __name__ == "__main__":
    sys.exit(main())
