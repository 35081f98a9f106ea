# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean-bridge` as its users meet it: by telnet, netcat and its own client, with a board that is a
script. Nothing here waits for a time to pass, but for a line to come."""

import os
import pty
import queue
import re
import shutil
import signal
import socket
import subprocess
import termios
import threading
import time
from pathlib import Path

import pytest

BRIDGE = os.environ.get("OCEAN_BRIDGE", "")
if not BRIDGE:
    pytest.skip("the bridge is not built", allow_module_level=True)
PATIENCE = 120  # s; on a busy machine
TOKEN = "0123456789abcdef"


class Lines:
    """The lines of a stream, read by a thread."""

    def __init__(self, stream):
        self.queue = queue.Queue()
        self.seen = []
        threading.Thread(target=self.read, args=(stream,), daemon=True).start()

    def read(self, stream):
        try:
            for line in stream:
                self.queue.put(line.rstrip("\r\n"))
        except OSError:  # of a terminal whose other end is gone
            pass
        self.queue.put(None)

    def wait_for(self, pattern: str) -> re.Match:
        """The next line that has the pattern."""
        end = time.monotonic() + PATIENCE
        while True:
            line = self.queue.get(timeout=max(end - time.monotonic(), 0.001))
            assert line is not None, f"no {pattern!r} in {self.seen}"
            self.seen.append(line)
            if found := re.search(pattern, line):
                return found


class Bridge:
    def __init__(self, folder: Path, *arguments, **options):
        self.process = subprocess.Popen(
            [BRIDGE, "--listen", "127.0.0.1:0", *map(str, arguments)],
            cwd=folder,
            stderr=subprocess.PIPE,
            text=True,
            **options,
        )
        self.log = Lines(self.process.stderr)
        self.port = int(self.log.wait_for(r"listening on 127\.0\.0\.1:(\d+)")[1])
        self.address = f"127.0.0.1:{self.port}"

    def connect(self) -> socket.socket:
        client = socket.create_connection(("127.0.0.1", self.port), timeout=PATIENCE)
        assert self.line_of(client).startswith("OBP 1 ")
        return client

    def say(self, *lines: str) -> socket.socket:
        """As a client of its own; the connection, which has been greeted and answered."""
        client = self.connect()
        for line in lines:
            assert self.ask(client, line) == "OK", line
        return client

    @staticmethod
    def line_of(client: socket.socket) -> str:
        line = b""
        while not line.endswith(b"\n"):
            byte = client.recv(1)
            if not byte:
                break
            line += byte
        return line.decode().rstrip("\r\n")

    def ask(self, client: socket.socket, line: str) -> str:
        client.sendall(line.encode() + b"\n")
        return self.line_of(client)

    def stop(self) -> int:
        self.process.send_signal(signal.SIGTERM)
        return self.process.wait(timeout=PATIENCE)


def run(*arguments, **options) -> subprocess.CompletedProcess:
    return subprocess.run([BRIDGE, *arguments], capture_output=True, text=True, timeout=PATIENCE,
                          **options)  # fmt: skip


@pytest.fixture
def start(tmp_path):
    started = []

    def one(*arguments) -> Bridge:
        started.append(Bridge(tmp_path, *arguments))
        return started[-1]

    yield one
    for bridge in started:
        if bridge.process.poll() is None:
            bridge.process.kill()
            bridge.process.wait()


def typed(program: list, text: bytes) -> subprocess.Popen:
    """A program that gets the text, and keeps its standard input open."""
    process = subprocess.Popen(program, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=False)
    process.stdin.write(text)
    process.stdin.flush()
    return process


def telnet(port: int, text: bytes) -> str:
    """Returns the output of telnet until the bridge ends the connection."""
    process = typed([shutil.which("telnet"), "127.0.0.1", str(port)], text)
    out = process.stdout.read()
    process.stdin.close()
    process.wait(timeout=PATIENCE)
    return out.decode().replace("\r", "")


def netcat(port: int, text: bytes) -> str:
    done = subprocess.run(
        [shutil.which("nc"), "127.0.0.1", str(port)],
        input=text,
        capture_output=True,
        timeout=PATIENCE,
    )
    return done.stdout.decode("latin-1").replace("\r", "")


def test_a_script_moves_the_wind_whenever_one_comes(start, tmp_path):
    (tmp_path / "script").write_text("0.5 board0/a1 128\n0.7 board0/a1 255\n")
    bridge = start("--dummy", "script")
    client = bridge.connect()
    assert bridge.ask(client, "SUBSCRIBE wind_speed") == "OK"
    told = [bridge.line_of(client)]
    while told[-1] and not told[-1].endswith(" wind_speed 30"):
        told.append(bridge.line_of(client))
    # A late client begins later, and a slow reader gets the newest values alone.
    whole = [
        told[0],
        "EVT WRITER wind_speed board0/a1",
        "UPD wind_speed 15.0588",
        "UPD wind_speed 30",
    ]
    assert told[0].startswith("VAL wind_speed ")
    assert told == [line for line in whole if line in told]


def test_a_map_and_a_sea_of_ones_own(start, tmp_path):
    (tmp_path / "sea.toml").write_text(
        'libocean = 1\n[[waves]]\nspectrum = "jonswap"\nfetch = 5e4\n'
    )
    (tmp_path / "map.toml").write_text(
        '[[map]]\nfrom = "board0/a2"\nto = "fetch"\nout = [1e4, 2e4]\nhysteresis = 0\n'
    )
    bridge = start("sea.toml", "--map", "map.toml", "--dummy")
    client = bridge.connect()
    assert bridge.ask(client, "GET waves.0.fetch") == "VAL waves.0.fetch 50000"
    assert bridge.ask(client, "OUT board0/a2 255") == "OK"
    assert bridge.ask(client, "GET fetch") == "VAL fetch 20000"
    (tmp_path / "map.toml").write_text('[[map]]\nfrom = "board0/a2"\n')
    bridge.log.wait_for(r"MAP stays as it was: map\.toml:1: to is missing")


def test_telnet_types_commands(start):
    bridge = start("--dummy")
    shown = telnet(bridge.port, b"GET choppiness\nFLY\nset choppiness 0.5\nGET choppiness\nQUIT\n")
    begin = shown.index("OBP 1 ")
    assert shown[begin:].splitlines()[1:6] == [
        "VAL choppiness 1",
        "ERR UNKNOWN-COMMAND 'FLY'; HELP lists them",
        "OK",
        "VAL choppiness 0.5",
        "OK",
    ]
    peer = bridge.log.wait_for(r"(127\.0\.0\.1:\d+) connected")[1]
    bridge.log.wait_for(re.escape(peer) + ": set choppiness 0.5$")
    bridge.log.wait_for(re.escape(peer) + " ended")


def test_telnet_shows_answers_after_control_c(start):
    """telnet asks DO TIMING-MARK then, and throws away what comes until it is answered."""
    bridge = start("--dummy")
    pid, screen = pty.fork()
    if pid == 0:
        os.execv(shutil.which("telnet"), ["telnet", "127.0.0.1", str(bridge.port)])
    try:
        lines = Lines(os.fdopen(os.dup(screen), errors="replace"))
        lines.wait_for("OBP 1 ")
        os.write(screen, b"SET wind_spe")
        os.write(screen, termios.tcgetattr(screen)[6][termios.VINTR])
        os.write(screen, b"GET choppiness\n")
        lines.wait_for("^VAL choppiness 1$")
    finally:
        os.kill(pid, signal.SIGKILL)
        os.waitpid(pid, 0)
        os.close(screen)


def test_netcat_pipes_a_script_and_loses_no_line(start):
    bridge = start()
    shown = netcat(bridge.port, b"PING\n" * 300 + b"QUIT\n")
    assert shown.count("OK\n") == 301


def test_who_has_asked_for_the_last_time_gets_all_answers(start):
    bridge = start()
    client = socket.socket()
    client.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 2048)
    client.connect(("127.0.0.1", bridge.port))
    client.settimeout(PATIENCE)
    client.sendall(b"LIST\n" * 300)  # 330 kB: more than the system takes off the bridge's hands
    client.shutdown(socket.SHUT_WR)
    bridge.log.wait_for(": LIST")
    shown = b""
    while block := client.recv(256):
        shown += block
    assert shown.count(b"END LIST\r\n") == 300


def test_a_take_is_recorded_and_read(start, tmp_path, ocean):
    bridge = start("--dummy")
    client = bridge.connect()
    assert bridge.ask(client, "RECORD START ../../x").startswith("ERR RANGE ")
    assert bridge.ask(client, "RECORD START storm.take") == "OK"
    for wind in (12, 14, 16):
        assert bridge.ask(client, f"SET wind_speed {wind}") == "OK"
    assert bridge.ask(client, "RECORD STOP") == "OK"
    bridge.log.wait_for("TAKE storm.take")
    (tmp_path / "sea.toml").write_text(
        'libocean = 1\n[time]\ntake = "storm.take"\n[[waves]]\nspectrum = "jonswap"\n'
    )
    ocean.good("info", tmp_path / "sea.toml")
    assert (tmp_path / "storm.take").read_text().endswith(" waves.0.wind_speed 16\n")


def test_an_interrupt_saves_the_take_and_lets_all_go(start, tmp_path):
    bridge = start("--dummy")
    client = bridge.connect()
    assert bridge.ask(client, "RECORD START") == "OK"
    assert bridge.ask(client, "SET wind_speed 12") == "OK"
    assert bridge.stop() == 130
    assert bridge.line_of(client) == "EVT STOP"
    assert bridge.line_of(client) == ""
    bridge.log.wait_for("stopped")
    assert "waves.0.wind_speed 12" in (tmp_path / "take_1.take").read_text()


def test_an_interrupt_of_a_bridge_that_has_just_begun_to_listen_ends_it_in_order(start):
    """A client may connect, and a signal come, before the program's first thread runs on."""
    for _ in range(20):
        bridge = start("--dummy")
        assert bridge.stop() == 130
        bridge.log.wait_for("stopped")


def test_a_log_that_nobody_reads_stops_nobody(tmp_path):
    process = subprocess.Popen(
        [BRIDGE, "--listen", "127.0.0.1:0"], stderr=subprocess.PIPE, text=True, bufsize=1
    )
    try:
        port = int(re.search(r"listening on 127\.0\.0\.1:(\d+)", process.stderr.readline())[1])
        client = socket.create_connection(("127.0.0.1", port), timeout=PATIENCE)
        Bridge.line_of(client)
        for _ in range(150):  # of a pipe's 64 KiB
            client.sendall(b"X" * 1000 + b"\n")
            assert Bridge.line_of(client).startswith("ERR UNKNOWN-COMMAND")
        process.send_signal(signal.SIGTERM)
        assert process.wait(timeout=PATIENCE) == 130
    finally:
        process.kill()
        process.wait()
        process.stderr.close()


def test_a_token_guards_it(start, tmp_path):
    (tmp_path / "token").write_text(TOKEN + "\n")
    (tmp_path / "token").chmod(0o600)
    bridge = start("--token-file", "token")
    client = bridge.connect()
    assert bridge.ask(client, "LIST").startswith("ERR AUTH ")
    assert bridge.ask(client, f"AUTH {TOKEN}") == "OK"
    assert bridge.ask(client, "GET choppiness") == "VAL choppiness 1"
    assert bridge.stop() == 130
    bridge.log.wait_for("stopped")
    assert TOKEN not in "".join(bridge.log.seen)


def test_the_terminal_client(start):
    bridge = start("--dummy")
    asked = "SET wind_speed 14\nGET wind_speed\nLIST\nFLY\n"
    done = run("--client", bridge.address, input=asked)
    assert done.returncode == 0, done.stderr
    assert "waves.0.wind_speed = 14\n" in done.stdout
    assert "END LIST\n" in done.stdout
    assert "ERR UNKNOWN-COMMAND 'FLY'; HELP lists them\n" in done.stdout


def test_the_terminal_client_at_a_terminal(start):
    bridge = start("--dummy")
    ours, theirs = pty.openpty()
    process = subprocess.Popen(
        [BRIDGE, "--client", f"127.0.0.1:{bridge.port}"], stdin=theirs, stdout=theirs, stderr=theirs
    )
    os.close(theirs)
    try:
        screen = Lines(os.fdopen(os.dup(ours), errors="replace"))
        os.write(ours, b"SUBSCRIBE choppiness\n")
        screen.wait_for("surface.choppiness = 1")
        other = bridge.connect()
        assert bridge.ask(other, "SET choppiness 0.5") == "OK"
        screen.wait_for(r"surface\.choppiness is set by 127\.0\.0\.1:")
        screen.wait_for("surface.choppiness = 0.5")
        os.write(ours, b"QUIT\n")
        assert process.wait(timeout=PATIENCE) == 0
    finally:
        process.kill()
        process.wait()
        os.close(ours)


@pytest.mark.parametrize("slowly", [False, True], ids=["at_once", "slowly"])
def test_the_terminal_client_where_no_bridge_is(slowly):
    """The result does not depend on whether the refusal comes before all is typed or after."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))  # nobody listens, and nobody else can
        port = probe.getsockname()[1]
        program = subprocess.Popen(
            [BRIDGE, "--client", f"127.0.0.1:{port}"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        try:
            if slowly:
                assert program.stdout.readline() == "(no bridge: Connection refused)\n"
            said = program.communicate("PING\n", timeout=PATIENCE)[1]
        finally:
            program.kill()
    assert program.returncode == 1
    assert said == f"ocean-bridge: 127.0.0.1:{port}: Connection refused\n"


def test_learning_prints_the_map_of_what_is_moved(tmp_path, start):
    """An endless knob, a 14-bit fader and a button of a recording become a map that is taken."""
    (tmp_path / "hand").write_text(
        "".join(f"{0.01 * i:.2f} midi0/cc16 {byte}\n" for i, byte in enumerate([1, 1, 1, 127, 127]))
        + "0.8 midi0/cc7 64\n0.8 midi0/cc39 32\n0.9 midi0/cc7 65\n0.9 midi0/cc39 1\n"
        + "1.8 midi0/n36 1\n"
    )
    program = subprocess.Popen(
        [BRIDGE, "--learn", "choppiness", "--replay", "hand"],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        learnt = Lines(program.stdout)
        for line in [
            'from = "midi0/cc16"',
            'to = "choppiness"',
            'mode = "relative"',
            'code = "twos_complement"',
            'from = "midi0/pair7"',
            r"in = \[0, 16383\]",
            'from = "midi0/n36"',
            'mode = "toggle"',
            "^out = ",
        ]:
            learnt.wait_for(line)
        program.send_signal(signal.SIGINT)
        assert program.wait(timeout=PATIENCE) == 130
        assert program.stderr.read().splitlines()[-1] == "ocean-bridge: interrupted"
    finally:
        program.kill()
        program.wait()
    (tmp_path / "map.toml").write_text("\n".join(learnt.seen) + "\n")
    bridge = start("--map", "map.toml", "--replay", "hand")
    client = bridge.connect()
    # Each of the five bytes is a step of a hundredth of the slider's way, from what it was.
    assert bridge.ask(client, "SUBSCRIBE choppiness") == "OK"
    # A late client is told the value that they have left.
    while not re.match(r"(UPD|VAL) choppiness (?!1$)", bridge.line_of(client)):
        pass


def test_a_port_that_is_taken_is_named(start):
    bridge = start()
    done = run("--listen", bridge.address)
    assert done.returncode == 1
    assert f"cannot listen on {bridge.address}: Address already in use" in done.stderr
