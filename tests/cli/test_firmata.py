# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean-bridge` with an Arduino at a pseudo-terminal, which answers as StandardFirmata 2.5 does:
its knobs and buttons move the sea, its lamps follow, and it may be pulled out at any time."""

import fcntl
import os
import pty
import select
import tempfile
import termios
import threading
import time
from pathlib import Path

import pytest
from test_bridge import PATIENCE, Bridge
from test_bridge import start as start_any  # noqa: F401

MAP = """[[device]]
id = "uno"
driver = "firmata"
port = "tty"
analog = [0]
inputs = [2]
outputs = [13]
pwm = [9]
[[map]]
from = "uno/a0"
to = "wind_speed"
in = [0, 1023]
out = [0, 30]
[[map]]
from = "uno/d2"
to = "app.pause"
mode = "toggle"
[[out]]
from = "app.frame_rate"
to = "uno/pwm9"
in = [0, 120]
out = [0, 240]
"""


class Arduino:
    """The board, in a thread; `path` is what it is plugged into."""

    def __init__(self, path: Path, piece: int = 1000):
        self.path = path
        self.piece = piece  # so many bytes it sends at a time
        self.lock = threading.Condition()
        self.running = False
        self.modes, self.levels, self.analog, self.digital = {}, {}, set(), set()

    def plug(self, begins: bool = True, answers: bool = True):
        """Opening the line resets most boards: then the program begins, and says so."""
        self.modes, self.levels, self.analog, self.digital = {}, {}, set(), set()
        self.interval = None
        self.inputs, self.knob = 0, 512
        self.master, slave = pty.openpty()
        self.path.symlink_to(os.ttyname(slave))
        os.close(slave)
        self.running = True
        self.thread = threading.Thread(target=self.run, args=(begins, answers), daemon=True)
        self.thread.start()

    def unplug(self):
        self.path.unlink()
        self.running = False
        self.thread.join()
        os.close(self.master)

    def send(self, *data: int):
        for i in range(0, len(data), self.piece):
            os.write(self.master, bytes(data[i : i + self.piece]))

    def turn(self, value: int):
        assert self.wait(lambda: 0 in self.analog)
        with self.lock:
            self.knob = value
            self.say_knob()

    def press(self, pin: int, down: bool):
        assert self.wait(lambda: pin // 8 in self.digital)
        with self.lock:
            self.inputs = self.inputs & ~(1 << pin) | down << pin
            self.say_inputs()

    def say_knob(self):
        self.send(0xE0, self.knob & 0x7F, self.knob >> 7)

    def say_inputs(self):
        self.send(0x90, self.inputs & 0x7F, self.inputs >> 7 & 1)

    def wait(self, condition) -> bool:
        with self.lock:
            return self.lock.wait_for(condition, timeout=PATIENCE)

    def run(self, begins: bool, answers: bool):
        buffer = b""
        while self.running:
            if not select.select([self.master], [], [], 0.005)[0]:  # to see that it is unplugged
                continue
            try:
                buffer += os.read(self.master, 4096)
            except OSError:  # nobody has it open
                time.sleep(0.005)
                continue
            if not answers:
                continue
            if begins:
                begins = False
                self.send(0xF9, 2, 5, 0xF0, 0x79, 2, 5, ord("U"), 0, 0xF7)
            with self.lock:
                while buffer and (used := self.obey(buffer)):
                    buffer = buffer[used:]
                self.lock.notify_all()

    def obey(self, buffer: bytes) -> int:
        """How many bytes the first message has; 0 if it is not whole."""
        command = buffer[0]
        kind = command & 0xF0 if command < 0xF0 else command
        if kind == 0xF0:
            end = buffer.find(0xF7)
            if end > 0 and buffer[1] == 0x7A:
                self.interval = buffer[2] | buffer[3] << 7
            return end + 1
        length = {0xF9: 1, 0xC0: 2, 0xD0: 2}.get(kind, 3)
        assert kind in (0xF9, 0xF4, 0xF5, 0xC0, 0xD0, 0xE0), f"{buffer.hex()}"
        if len(buffer) < length:
            return 0
        assert all(byte < 0x80 for byte in buffer[1:length])
        if kind == 0xF9:
            self.send(0xF9, 2, 5)
        elif kind == 0xF4:
            self.modes[buffer[1]] = buffer[2]
        elif kind == 0xF5:
            self.levels[buffer[1]] = buffer[2]
        elif kind == 0xE0:
            self.levels[command & 0x0F] = buffer[1] | buffer[2] << 7
        elif kind == 0xC0:
            self.analog.add(command & 0x0F)
            self.say_knob()
        else:
            self.digital.add(command & 0x0F)
            self.say_inputs()
        return length


@pytest.fixture
def board(tmp_path):
    (tmp_path / "map.toml").write_text(MAP)
    arduino = Arduino(tmp_path / "tty")
    yield arduino
    if arduino.running:
        arduino.unplug()


@pytest.fixture
def start(start_any):  # noqa: F811
    return lambda: start_any("--map", "map.toml")


def subscribed(bridge: Bridge, *names: str):
    client = bridge.connect()
    assert bridge.ask(client, f"SUBSCRIBE {' '.join(names)}") == "OK"
    for name in names:
        assert bridge.line_of(client).startswith(f"VAL {name} ")
    return client


def update(bridge: Bridge, client, name: str) -> float:
    while not (line := bridge.line_of(client)).startswith(f"UPD {name} "):
        assert line, "the connection ended"
    return float(line.split()[2])


@pytest.mark.parametrize("piece", [1000, 1, 2])
def test_knobs_and_buttons_move_the_sea(start, board, piece):
    board.piece = piece
    board.plug()
    bridge = start()
    bridge.log.wait_for(r"uno CONNECTED: Firmata 2\.5 at tty")
    client = subscribed(bridge, "wind_speed", "app.pause")
    board.turn(1023)
    assert update(bridge, client, "wind_speed") == 30
    board.turn(0)
    assert update(bridge, client, "wind_speed") == 0
    board.press(2, True)
    assert update(bridge, client, "app.pause") == 1
    assert board.wait(lambda: board.modes == {2: 0, 13: 1, 9: 3} and board.interval == 10)


def test_a_board_that_says_nothing_is_named(start, board):
    board.plug(answers=False)
    bridge = start()
    bridge.log.wait_for("uno BUSY: tty: nothing answers as Firmata at 57600 baud$")
    board.unplug()
    board.plug()
    bridge.log.wait_for("uno CONNECTED")


def test_a_board_that_did_not_begin_anew_is_asked(start, board):
    board.plug(begins=False)
    start().log.wait_for("uno CONNECTED")


@pytest.fixture
def start_as_nobody(board):
    """The bridge without root's rights, to which no line is closed."""
    rights = {"user": 65534, "group": 65534, "extra_groups": []} if os.geteuid() == 0 else {}
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "map.toml").write_text(MAP.replace('"tty"', f'"{board.path.resolve()}"'))
        Path(folder).chmod(0o755)
        started = []

        def one() -> Bridge:
            try:
                started.append(Bridge(Path(folder), "--map", "map.toml", **rights))
            except PermissionError:
                pytest.skip("the program lies where only root reads")
            return started[-1]

        yield one
        for bridge in started:
            bridge.process.kill()
            bridge.process.wait()


@pytest.fixture
def plugged(board):
    board.plug()
    return board.path.resolve()


def test_a_line_without_permission_is_named(plugged, start_as_nobody):
    plugged.chmod(0)
    bridge = start_as_nobody()
    bridge.log.wait_for(
        "uno BUSY: .*: Permission denied; members of the group dialout may open it$"
    )
    plugged.chmod(0o666)
    bridge.log.wait_for("uno CONNECTED")


def test_a_line_that_another_program_has_is_named(plugged, start_as_nobody):
    plugged.chmod(0o666)
    with plugged.open("rb", buffering=0) as other:
        fcntl.ioctl(other, termios.TIOCEXCL)
        bridge = start_as_nobody()
        bridge.log.wait_for("uno BUSY: .*: Device or resource busy: another program has it$")
        fcntl.ioctl(other, termios.TIOCNXCL)
        bridge.log.wait_for("uno CONNECTED")
    assert bridge.stop() == 130
    # As it was before.
    start_as_nobody().log.wait_for("uno CONNECTED")


def test_the_line_is_raw_at_its_speed(start, board):
    board.plug()
    start().log.wait_for("uno CONNECTED")
    attributes = termios.tcgetattr(board.master)
    assert attributes[1] & termios.OPOST == 0
    assert attributes[3] & (termios.ICANON | termios.ECHO | termios.ISIG) == 0
    assert attributes[4:6] == [termios.B57600, termios.B57600]


def test_a_board_at_rest_costs_nothing(start, board):
    board.plug()
    bridge = start()
    bridge.log.wait_for("uno CONNECTED")
    assert board.wait(lambda: 0 in board.analog and 0 in board.digital)

    def wakes() -> int:
        tasks = Path(f"/proc/{bridge.process.pid}/task").glob("*/status")
        lines = [line for task in tasks for line in task.read_text().splitlines()]
        return sum(int(line.split()[1]) for line in lines if line.startswith("voluntary_ctxt"))

    # Rest shows in a time alone: a second, and more on a busy machine, which wakes nobody the more.
    before, begun = wakes(), time.monotonic()
    time.sleep(1)
    assert wakes() - before < 10 * (time.monotonic() - begun)
