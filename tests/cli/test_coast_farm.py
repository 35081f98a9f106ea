# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Bakes of a coast for farms: foam and wet sand have a past, and yet the same bytes come out if a
bake is split, killed or repeated."""

import random
import subprocess

import pytest
from coasts import REGION
from conftest import OCEAN, children_seconds, kill_at

PRODUCTS = ("--products", "displacement,foam,depth,wetness")
BAKE = ("bake", "sea.toml", *REGION, *PRODUCTS, "-q", "-o")
EXR = "s.####.exr"


def test_shards_chunks_and_single_frames_have_the_bytes_of_the_whole(coast):
    coast.good(*BAKE, f"whole/{EXR}", "--frames", "196-200")
    expected = coast.hashes("whole")
    assert len(expected) == 5 * 4 + 1
    for shard in ("3/3", "1/3", "2/3"):
        coast.good(*BAKE, f"parts/{EXR}", "--frames", "196-200", "--shard", shard, "--threads", "1")
    coast.merge(f"parts/{EXR}")
    coast.good(*BAKE, f"back/{EXR}", "--frames", "200,199,198,197,196", "--threads", "2")
    coast.good(*BAKE, f"some/{EXR}", "--frames", "197")
    coast.good(*BAKE, f"some/{EXR}", "--frames", "196-200", "--skip-existing")
    for folder in ("parts", "back", "some"):
        assert coast.hashes(folder) == expected, folder
    coast.good(*BAKE, f"alone/{EXR}", "--frames", "200")
    alone = coast.hashes("alone")
    del alone["s.manifest.json"]
    assert len(alone) == 4 and alone.items() <= expected.items()


def test_a_bake_killed_at_any_moment_goes_on_to_the_same_bytes(coast):
    bake = (*BAKE[:-1], "--frames", "40-47", "-o")
    before = children_seconds()
    coast.good(*bake, f"whole/{EXR}")
    seconds = children_seconds() - before
    chance = random.Random(7)
    cut_short = 0
    for _ in range(8):
        for path in sorted((coast.folder / "out").glob("*.exr")):
            if chance.random() < 0.5:
                path.unlink()
        run = subprocess.Popen([OCEAN, *bake, f"out/{EXR}", "--skip-existing"], cwd=coast.folder)
        kill_at(run, chance.uniform(0.1, 0.9) * seconds)
        cut_short += len(list((coast.folder / "out").glob("s.*.exr"))) < 32
    assert cut_short >= 4
    coast.good(*bake, f"out/{EXR}", "--skip-existing")
    assert coast.hashes("out") == coast.hashes("whole")


@pytest.mark.parametrize(
    ("output", "products"),
    [
        ("sea.usda", "normal,foam,wetness"),
        ("s.####.ply", "foam,depth"),
        ("s.####.vdb", "surface"),
        ("s.####.vdb", "spray"),
        ("s.####.df3", ""),
    ],
    ids=["usda", "ply", "vdb", "spray", "df3"],
)
def test_other_formats_do_not_mind_shards_either(coast, output, products):
    chosen = ("--products", products) if products else ()
    bake = ("bake", "sea.toml", *REGION, *chosen, "--set", "foam_step=0.2", "--frames", "7-10")
    coast.good(*bake, "-q", "-o", f"whole/{output}")
    for shard in ("2/2", "1/2"):
        coast.good(*bake, "-q", "-o", f"parts/{output}", "--shard", shard, "--threads", "1")
    coast.merge(f"parts/{output}")
    assert coast.hashes("parts") == coast.hashes("whole")
    assert len(coast.hashes("whole")) >= 5
