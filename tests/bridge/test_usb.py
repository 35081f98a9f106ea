# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A board on a bus that umockdev makes, and the programs that users start."""

import os
from pathlib import Path

import pytest
from chain import MAP, SEA, MockedBoard, measure

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


def test_a_board_that_reports_costs_little(board):
    def seconds() -> float:
        """The processor time of all threads of the bridge [s]."""
        tasks = Path(f"/proc/{board.pid}/task").glob("*/schedstat")
        return sum(int(task.read_text().split()[0]) for task in tasks) * 1e-9

    board.plug()
    board.log.wait_for("CONNECTED")
    before = seconds()
    for report in range(1, 101):  # at 100 Hz, each with news
        board.tell(f"set 0 0 0 {report} 0")
        board.bus.wait_for("sent")
    share = (seconds() - before) / 100 / 0.01
    print(f"a board at 100 Hz takes {100 * share:.2f} % of a core")
    assert share < 0.05
