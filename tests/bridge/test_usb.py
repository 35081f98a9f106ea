# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A board on a bus that umockdev makes, and the programs that users start."""

import os
import sys
from pathlib import Path

import pytest
from chain import MAP, SEA, MockedBoard, MockedBus, measure

BUILD = Path(os.environ["OCEAN_BUILD"]).resolve()
if not (BUILD / "tests/bridge/mock_k8055_program").exists():
    pytest.skip("umockdev or libusb was not there", allow_module_level=True)


@pytest.fixture
def board(tmp_path):
    (tmp_path / "sea.toml").write_text(SEA)
    (tmp_path / "map.toml").write_text(MAP)
    started = MockedBoard(BUILD, tmp_path, "sea.toml", "--map", "map.toml")
    started.folder = tmp_path
    yield started
    if started.program.poll() is None:
        assert started.end() == 130


def test_the_whole_chain():
    times = measure(BUILD, steps=20, rate=100)
    for name, values in times.items():
        print(f"{name}, ms:", [round(value, 1) for value in sorted(values)])
        assert len(values) == 20


def test_clients_hear_of_a_board_that_comes_and_goes(board):
    _connection, client = board.client("SUBSCRIBE wind_speed", "LIST")
    client.wait_for("END LIST")
    board.plug(10)
    client.wait_for("EVT board0 CONNECTED: K8055 on bus 1, device 2")
    board.step(150)
    client.wait_for(r"UPD wind_speed 19\.7")
    board.tell("unplug")
    client.wait_for("EVT board0 LOST: unplugged")
    connection, asks = board.client("OUT board0/o1 1", "GET wind_speed")
    asks.wait_for("ERR .*no board has 'board0/o1'")
    asks.wait_for(r"VAL wind_speed 19\.7")  # it holds
    board.plug(77)
    client.wait_for("EVT board0 CONNECTED: K8055 on bus 1, device 3")
    # Another knob position than before moves nothing until it is turned.
    connection.sendall(b"GET wind_speed\r\n")
    asks.wait_for(r"VAL wind_speed 19\.7")
    board.step(90)
    client.wait_for("UPD wind_speed")


def test_a_value_drives_an_output(board):
    board.tell("plug")
    board.log.wait_for("CONNECTED")
    board.bus.wait_for("out 0500000000000000")
    _connection, client = board.client("SET app.frame_rate 60")
    client.wait_for("OK")
    board.bus.wait_for("out 0500800000000000")
    _connection, client = board.client("OUT board0/o3 1")
    client.wait_for("OK")
    board.bus.wait_for("out 0504800000000000")
    board.program.stdin.close()
    board.bus.wait_for("out 0500000000000000")  # nothing stays lit
    board.bus.wait_for("driver on")
    board.bus.wait_for("exit 130")


def test_a_knob_at_rest_is_still(board):
    board.plug(128)
    board.log.wait_for("CONNECTED")
    _connection, client = board.client("SUBSCRIBE wind_speed")
    client.wait_for("VAL wind_speed")
    for step in range(100):
        board.step(128 + step % 2)
    board.step(200)
    when, found = client.wait_for("UPD wind_speed")
    assert float(found.string.split()[2]) > 24.0  # the first that came


# The least that reads a board: libusb's synchronous transfers from a script.
PLAIN_READER = """
import ctypes, sys, time
usb = ctypes.CDLL("libusb-1.0.so.0")
usb.libusb_open_device_with_vid_pid.restype = ctypes.c_void_p
usb.libusb_init(None)
while not (opened := usb.libusb_open_device_with_vid_pid(None, 0x10CF, 0x5500)):
    time.sleep(0.01)
handle = ctypes.c_void_p(opened)
usb.libusb_set_auto_detach_kernel_driver(handle, 1)
assert usb.libusb_claim_interface(handle, 0) == 0
print("CONNECTED", file=sys.stderr, flush=True)
report, length = (ctypes.c_ubyte * 8)(), ctypes.c_int()
while True:
    usb.libusb_interrupt_transfer(handle, 0x81, report, 8, ctypes.byref(length), 2000)
"""


def processor_time_of_reports(bus: MockedBus) -> float:
    """The program's least processor time for a report of a board at 100 Hz, each with news [s]."""
    stretches = []
    for first in range(1, 101, 20):
        before = bus.seconds()
        for report in range(first, first + 20):
            bus.tell(f"set 0 0 0 {report} 0")
            bus.bus.wait_for("sent")
        stretches.append((bus.seconds() - before) / 20)
    return min(stretches)


def test_a_board_that_reports_costs_little_more_than_libusb(board, tmp_path):
    board.plug()
    board.log.wait_for("CONNECTED")
    ours = processor_time_of_reports(board)
    peer = MockedBus(BUILD, tmp_path, sys.executable, "-c", PLAIN_READER)
    peer.tell("plug")
    peer.log.wait_for("CONNECTED")
    plain = processor_time_of_reports(peer)
    peer.end()
    print(f"a report takes {1e6 * ours:.0f} us, {ours / plain:.2f} of libusb's {1e6 * plain:.0f}")
    assert ours < 1.5 * plain
