# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Meshes, points, stages, volumes and coasts on a full disk, and killed at any time: files that are
there are whole, and what is baked again has the same bytes."""

import os
import subprocess

import pytest
from coasts import BEACH, REGION, grid
from conftest import OCEAN, children_seconds, kill_at
from test_bake_farm import ran_in_a_namespace, small_disk

pytest.importorskip("pyopenvdb", reason="OpenVDB is not installed")
FRAMES = [
    *["bake", "sea.toml", "--set", "wind_speed=14", "--frames", "1-12", "--threads", "2"],
    "-o",
]
OUTPUTS = {
    "ply": ["s.####.ply"],
    "spray": ["s.####.ply", "--products", "spray", "--spray-density", "20"],
    "usd": ["s.usda"],
    "vdb": ["s.####.vdb"],
    "coast": [
        *["s.####.exr", "--set", "seabed=bed.asc", "--set", "water.depth=12"],
        *[*REGION, "--products", "displacement,foam,wetness", "--set", "foam_step=0.2"],
    ],
}


@pytest.fixture(params=OUTPUTS)
def baked(ocean, request):
    """How to bake into a folder, the hashes of what comes out, and the processor's time for it."""

    def command(folder: str) -> list[str]:
        name, *more = OUTPUTS[request.param]
        return [*FRAMES, f"{folder}/{name}", *more]

    ocean.write("bed.asc", grid(BEACH))
    before = children_seconds()
    ocean.good(*command("whole"))
    return command, ocean.hashes("whole"), children_seconds() - before


def test_a_full_disk_is_told_and_leaves_whole_files(ocean, baked, request):
    if ran_in_a_namespace(ocean, request):
        return
    command, expected, _ = baked
    bytes_of_all = sum(path.stat().st_size for path in (ocean.folder / "whole").iterdir())
    with small_disk(ocean.folder, 2 * bytes_of_all) as disk:
        ballast = disk / "ballast"
        ballast.write_bytes(bytes(int(1.4 * bytes_of_all)))
        done = ocean(*command("disk"))
        assert done.returncode == 1
        assert "No space left on device" in done.stderr.splitlines()[-1]
        there = {name: text for name, text in ocean.hashes("disk").items() if name != "ballast"}
        finished = {n: text for n, text in there.items() if not n.endswith("manifest.json")}
        assert len(finished) >= 3
        assert all(expected[name] == text for name, text in finished.items())
        ballast.unlink()
        ocean.good(*command("disk"), "--skip-existing")
        assert ocean.hashes("disk") == expected


def test_a_bake_killed_at_any_time_is_resumed(ocean, baked):
    command, expected, seconds = baked
    out = ocean.folder / "out"
    for twentieth in range(1, 11):  # half of it, as half of the files is left from before
        run = subprocess.Popen([OCEAN, *command("out"), "--skip-existing", "-q"], cwd=ocean.folder)
        kill_at(run, 0.05 * twentieth * seconds)
        if not out.exists():
            continue
        for name, text in ocean.hashes("out").items():
            if not name.startswith(".") and not name.endswith("manifest.json"):
                assert expected[name] == text, name
        for path in sorted(out.iterdir())[::2]:
            os.unlink(path)
    ocean.good(*command("out"), "--skip-existing")
    assert ocean.hashes("out") == expected
