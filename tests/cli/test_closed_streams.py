# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Programs that were started without standard streams, as by daemons and some farms: the first file
that such a program opens would be what it prints to."""

import os
import subprocess
import time
from pathlib import Path

import pytest

CLOSED = [">&-", "2>&-", "<&-", ">&- 2>&-", "<&- >&- 2>&-"]


@pytest.mark.parametrize("closed", CLOSED)
def test_frames_have_the_same_bytes(ocean, closed):
    bake = "bake sea.toml --frames 1-8 --products displacement,height -o {}/sea.####.exr"
    ocean.good(*bake.format("want").split())
    for attempt in "abc":  # threads open files in any order
        done = ocean.shell(f'exec {closed}; "$OCEAN" {bake.format(attempt)}')
        assert done.returncode == 0, done.stderr
        assert ocean.hashes(attempt) == ocean.hashes("want")


def test_a_bridge_has_no_socket_among_its_standard_streams(ocean):
    program = os.environ.get("OCEAN_BRIDGE")
    if not program:
        pytest.skip("ocean-bridge was not built")
    start = ["bash", "-c", 'exec <&- >&- 2>&-; exec "$@"', "bash"]
    bridge = subprocess.Popen([*start, program, "--dummy", "--listen", "127.0.0.1:0"])
    try:
        numbers = Path(f"/proc/{bridge.pid}/fd")
        links: dict[str, str] = {}
        while not any(link.startswith("socket:") for link in links.values()):
            assert bridge.poll() is None
            time.sleep(0.02)
            links = {path.name: os.readlink(path) for path in numbers.iterdir()}
        assert {links[number] for number in "012"} == {"/dev/null"}
    finally:
        bridge.terminate()
        bridge.wait()


def test_a_picture_is_the_same(ocean):
    program = os.environ.get("OCEAN_PREVIEW")
    if not program:
        pytest.skip("ocean-preview was not built")
    for name, closed in (("a.png", ""), ("b.png", "exec <&- >&- 2>&-; ")):
        show = f'"$OCEAN_PREVIEW" sea.toml --size 64x36 --cells 16 --offscreen {name}'
        assert ocean.shell(closed + show).returncode == 0
    assert (ocean.folder / "b.png").read_bytes() == (ocean.folder / "a.png").read_bytes()
