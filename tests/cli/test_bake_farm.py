# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A bake for farms: the same bytes come out if it is split, killed or repeated."""

import hashlib
import os
import random
import subprocess

import numpy as np
import OpenImageIO
import pytest
from bake_runs import (
    BAKE,
    BAKE_SOME,
    BOAT,
    PLAIN,
    TRACK,
    events,
    pattern,
    ran_in_a_namespace,
    small_disk,
)
from conftest import OCEAN, children_seconds, kill_at


def test_the_manifest_tells_what_others_compute(ocean):
    ocean.good(*BAKE_SOME, pattern("out"), "--products", "displacement,height", "--type", "half")
    entries = ocean.manifest("out/s.manifest.json")
    assert len(entries) == 20
    for name, entry in entries.items():
        path = ocean.folder / "out" / name
        assert entry["bytes"] == path.stat().st_size
        assert entry["sha256"] == hashlib.sha256(path.read_bytes()).hexdigest()
        image = OpenImageIO.ImageBuf(str(path))
        pixels = image.get_pixels(OpenImageIO.HALF)
        channels = list(image.spec().channelnames)
        # The file's order is the alphabet's: rows from the top, of a row B, then G, then R.
        order = [channels.index(channel) for channel in sorted(channels)]
        rows = np.moveaxis(pixels[..., order], 2, 1).astype("<f2")
        assert entry["pixels_sha256"] == hashlib.sha256(rows.tobytes()).hexdigest()
        assert image.spec()["ocean:frame"] == str(entry["frame"])
        assert float(image.spec()["ocean:time"]) == entry["time"]
        assert image.spec()["ocean:field"] == entry["product"]
    assert len({entry["recipe"] for entry in entries.values()}) == 20


def test_pixels_hash_the_same_whatever_the_compression(ocean):
    for codec in ("zip", "piz", "none"):
        ocean.good("bake sea.toml -o", f"{codec}/s.exr", "--compression", codec)
    zipped, wavelet, raw = (
        ocean.manifest(f"{codec}/s.manifest.json") for codec in ("zip", "piz", "none")
    )
    for name in zipped:
        kinds = [zipped[name], wavelet[name], raw[name]]
        assert len({entry["pixels_sha256"] for entry in kinds}) == 1
        assert len({entry["sha256"] for entry in kinds}) == 3
        assert len({entry["recipe"] for entry in kinds}) == 3


def test_the_manifest_of_a_height_field_has_its_codes(ocean):
    ocean.good("bake sea.toml -o out/s.png")
    entries = ocean.manifest("out/s.manifest.json")
    codes = OpenImageIO.ImageBuf(str(ocean.folder / "out/s.png")).get_pixels(OpenImageIO.UINT16)
    hashed = hashlib.sha256(codes.astype("<u2").tobytes()).hexdigest()
    assert entries["s.png"]["pixels_sha256"] == hashed
    assert "pixels_sha256" not in entries["s.png.txt"]


@pytest.mark.parametrize(
    "bake",
    [
        "bake sea.toml --frames 1,30 -o {}/s.####.exr",
        "bake boat.toml --region=-40,-20,60,40 --cell 2 --frames 1,30 -o {}/s.####.exr",
        "terrain preset:big_tujunga --resolution 64 --products height,normal -o {}/s.exr",
    ],
)
def test_machines_of_all_instruction_sets_write_the_same_bytes(ocean, bake):
    ocean.write("boat.toml", (ocean.folder / "sea.toml").read_text() + BOAT + TRACK)
    for simd in ("avx512", "avx2", "sse4", "portable"):
        done = ocean(bake.format(simd), env={**os.environ, "OCEAN_SIMD": simd})
        assert done.returncode == 0, done.stderr
    for simd in ("avx512", "avx2", "sse4"):
        assert ocean.hashes(simd) == ocean.hashes("portable"), simd


def test_an_unknown_instruction_set_is_refused(ocean):
    done = ocean("bake sea.toml -o s.exr", env={**os.environ, "OCEAN_SIMD": "avx1024"})
    assert done.returncode == 2 and "s.exr" not in ocean.files("")
    assert done.stderr == (
        "ocean: OCEAN_SIMD = avx1024: allowed are portable, sse4, avx2 and avx512\n"
    )


def test_shards_at_the_same_time_mind_no_other_even_their_twin(ocean, expected):
    runs = [
        subprocess.Popen(
            [OCEAN, *BAKE, pattern("out"), "--shard", f"{part}/5", "--threads", "1", "-q"],
            cwd=ocean.folder,
        )
        for part in (1, 2, 3, 4, 5, 3)
    ]
    assert [run.wait(timeout=120) for run in runs] == [0] * 6
    ocean.merge(pattern("out"))
    assert ocean.hashes("out") == expected


def test_shards_are_blocks_and_an_empty_one_succeeds(ocean):
    def frames(shard, count):
        paths = ocean.bake(f"-o s.exr --products height -n --frames 1-{count} --shard {shard}")
        return [int(path.split(".")[2]) for path in paths]

    assert [frames(f"{part}/4", 10) for part in (1, 2, 3, 4)] == [
        [1, 2], [3, 4, 5], [6, 7], [8, 9, 10],
    ]  # fmt: skip
    # One frame to a shard is named as the sequence is.
    assert frames("2/2", 2) == [2]
    done = ocean("bake sea.toml -o out/s.exr --shard 1/2")
    assert (done.returncode, done.stdout) == (0, "")
    assert "empty" in done.stderr and not (ocean.folder / "out").exists()


def test_a_shard_removes_what_its_own_frames_left(ocean):
    left = [f"out/.s.height.000{frame}.exr.ocean-999999999-0.tmp" for frame in (1, 2)]
    for name in left:
        ocean.write(name, "left")
    bake = "bake sea.toml -o out/s.####.exr --products height --frames 1-2"
    ocean.good(f"{bake} --shard 2/2")
    assert [(ocean.folder / name).exists() for name in left] == [True, False]
    ocean.good(f"{bake} --skip-existing")
    assert not (ocean.folder / left[0]).exists()


def test_a_bake_killed_fifty_times_writes_the_same_bytes(ocean):
    bake = ["bake", "sea.toml", *PLAIN, "--set", "resolution=128", "--frames", "1-40", "-o"]
    before = children_seconds()
    ocean.good(*bake, pattern("whole"))
    seconds = children_seconds() - before
    chance = random.Random(4)
    cut_short = 0
    for _ in range(50):
        for path in sorted((ocean.folder / "out").glob("*.exr")):
            if chance.random() < 0.5:
                path.unlink()
        run = subprocess.Popen(
            [OCEAN, *bake, pattern("out"), "--skip-existing", "-q"], cwd=ocean.folder
        )
        kill_at(run, chance.uniform(0.05, 0.5) * seconds)
        cut_short += len(list((ocean.folder / "out").glob("s.*.exr"))) < 80
    assert cut_short >= 25
    ocean.good(*bake, pattern("out"), "--skip-existing")
    assert ocean.hashes("out") == ocean.hashes("whole")


def test_a_full_disk_loses_nothing_that_was_finished(ocean, expected, request):
    if ran_in_a_namespace(ocean, request):
        return
    with small_disk(ocean.folder, 2 << 20) as disk:
        ballast = disk / "ballast"
        ballast.write_bytes(b"x" * (26 << 16))
        done = ocean(*BAKE, pattern("disk"))
        assert done.returncode == 1
        message = done.stderr.splitlines()[-1]
        assert "No space left on device" in message and "disk/s." in message
        assert message.endswith("of 10 frames are complete")
        finished = {name: text for name, text in ocean.hashes("disk").items() if ".exr" in name}
        assert len(finished) >= 4
        assert all(expected[name] == text for name, text in finished.items())
        assert not [name for name in ocean.files("disk") if name.startswith(".")]
        ballast.unlink()
        done = ocean(*BAKE, pattern("disk"), "--skip-existing", "--json")
        assert done.returncode == 0, done.stderr
        assert events(done)[-1]["skipped"] >= len(finished) // 2 - 1
        assert ocean.hashes("disk") == expected


SHIM = r"""
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
int fclose(FILE *file) {
    char link[64], path[4096];
    snprintf(link, sizeof link, "/proc/self/fd/%d", fileno(file));
    ssize_t length = readlink(link, path, sizeof path - 1);
    path[length > 0 ? length : 0] = 0;
    int (*real)(FILE *) = (int (*)(FILE *))dlsym(RTLD_NEXT, "fclose");
    int result = real(file);
    if (strstr(path, ".ocean-") && strstr(path, ".0002.exr")) { errno = EDQUOT; return EOF; }
    return result;
}
"""


def test_an_error_that_only_the_close_reports_is_an_error(ocean):
    source = ocean.write("shim.c", SHIM)
    shim = source.with_suffix(".so")
    subprocess.run(["cc", "-shared", "-fPIC", source, "-o", shim, "-ldl"], check=True)
    arguments = [*BAKE_SOME, pattern("out"), "--products", "height"]
    # A sanitizer wants to be loaded first; here it need not be.
    order = {"ASAN_OPTIONS": "verify_asan_link_order=0"}
    done = ocean(*arguments, env={**os.environ, **order, "LD_PRELOAD": str(shim)})
    assert done.returncode == 1
    message = done.stderr.splitlines()[-1]
    assert "out/s.height.0002.exr': Disk quota exceeded" in message
    files = ocean.files("out")
    assert "s.height.0002.exr" not in files
    assert not [name for name in files if name.startswith(".")]
