# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean-bridge --osc` with the programs of liblo, which know nothing of ours: oscsend and oscdump,
beside a client of the line protocol."""

import shutil
import socket
import subprocess

import pytest
from test_bridge import PATIENCE, Bridge, Lines, run
from test_bridge import start as start  # a fixture

if "\nliblo " not in run("--version").stdout:
    pytest.skip("the bridge is built without liblo", allow_module_level=True)
SEND = shutil.which("oscsend")
DUMP = shutil.which("oscdump")


def oscsend(port: int, *words: str, **options):
    subprocess.run([SEND, "127.0.0.1", str(port), *words], check=True, timeout=PATIENCE, **options)


class Dump:
    """oscdump at a free port."""

    def __init__(self):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
            probe.bind(("127.0.0.1", 0))
            self.port = probe.getsockname()[1]
        # Line by line, whatever the C library would do with a pipe.
        self.process = subprocess.Popen(
            ["stdbuf", "-oL", DUMP, str(self.port)], stdout=subprocess.PIPE, text=True
        )
        self.lines = Lines(self.process.stdout)
        while True:  # until it listens
            with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
                probe.connect(("127.0.0.1", self.port))
                try:
                    probe.send(b"/are_you_there\0\0,\0\0\0")
                    probe.settimeout(0.1)
                    probe.recv(1)
                except ConnectionRefusedError:
                    continue
                except TimeoutError:
                    break
        self.lines.wait_for("/are_you_there")


@pytest.fixture
def dump():
    one = Dump()
    yield one
    one.process.kill()
    one.process.wait()


def osc_port(bridge: Bridge) -> int:
    return int(bridge.log.wait_for(r"osc on .*:(\d+), from")[1])


def test_what_oscsend_sets_a_client_gets(start):
    bridge = start("--osc", "0")
    port = osc_port(bridge)
    client = bridge.connect()
    assert bridge.ask(client, "SUBSCRIBE wind_speed fetch spectrum app.pause seed") == "OK"
    for _ in range(5):
        assert bridge.line_of(client).startswith("VAL ")
    for words, update in [
        (("/ocean/wind_speed", "f", "14.1"), "wind_speed 14.1"),
        (("/ocean/waves/0/fetch", "d", "100000"), "fetch 100000"),
        (("/ocean/waves.0.spectrum", "s", "jonswap"), "spectrum jonswap"),
        (("/ocean/app/pause", "T"), "app.pause 1"),
        (("/ocean/random/seed", "h", "4294967295"), "seed 4294967295"),
    ]:
        oscsend(port, *words)
        assert bridge.line_of(client) == f"EVT WRITER {update.split()[0]} osc:127.0.0.1"
        assert bridge.line_of(client) == f"UPD {update}"
    assert bridge.ask(client, "GET waves.0.wind_speed") == "VAL waves.0.wind_speed 14.1"


def test_oscdump_is_told_the_start_and_each_change(start, dump):
    bridge = start("--osc-to", f"127.0.0.1:{dump.port}")
    dump.lines.wait_for(r" /ocean/grid/resolution i 512$")
    dump.lines.wait_for(r" /ocean/waves/0/spectrum s \"phillips\"$")
    dump.lines.wait_for(r" /ocean/waves/0/wind_speed s \"unset\"$")
    dump.lines.wait_for(r" /ocean/app/frame_rate f 0\.0+$")
    client = bridge.connect()
    assert bridge.ask(client, "SET wind_speed 14") == "OK"
    assert bridge.ask(client, "SET app.pause 1") == "OK"
    dump.lines.wait_for(r" /ocean/waves/0/wind_speed f 14\.0+$")
    dump.lines.wait_for(r" /ocean/app/pause i 1$")
    assert bridge.stop() == 130


def test_only_the_allowed_are_heard(start):
    bridge = start("--osc", "0.0.0.0:0", "--osc-allow", "127.0.0.1", "--osc-allow", "192.0.2.7")
    port = int(bridge.log.wait_for(r"osc on 0\.0\.0\.0:(\d+), from 127\.0\.0\.1 192\.0\.2\.7$")[1])
    client = bridge.connect()
    assert bridge.ask(client, "SUBSCRIBE wind_speed") == "OK"
    assert bridge.line_of(client).startswith("VAL ")
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
        stranger.bind(("127.0.0.2", 0))
        for _ in range(5):
            stranger.sendto(b"/ocean/wind_speed\0\0\0,i\0\0\0\0\0\x20", ("127.0.0.1", port))
    oscsend(port, "/ocean/wind_speed", "i", "14")
    assert bridge.line_of(client) == "EVT WRITER wind_speed osc:127.0.0.1"
    assert bridge.line_of(client) == "UPD wind_speed 14"
    bridge.log.wait_for(r"osc 127\.0\.0\.2 is not allowed; its packets are dropped$")
    assert bridge.stop() == 130
    bridge.log.wait_for("osc: 5 packets of addresses that are not allowed were dropped")
