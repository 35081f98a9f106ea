# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A bake for farms: however it is split, killed or repeated, the same bytes come out."""

import contextlib
import hashlib
import json
import os
import random
import shutil
import signal
import subprocess
import sys

import numpy as np
import OpenImageIO
import pytest
from conftest import DATA, OCEAN, children_seconds, kill_at

FRAMES = "1-10"
# Without foam frames are made side by side; with it one after another.
PLAIN = ["--products", "displacement,normal"]
# Foam of which few ticks before the first frame are left: most of a small bake is those ticks.
SHORT_FOAM = ["--set", "foam_lifetime=0.1"]
BAKE_SOME = ["bake", "sea.toml", "--frames", FRAMES, "-o"]
BAKE = ["bake", "sea.toml", *PLAIN, "--frames", FRAMES, "-o"]


def pattern(folder):
    return f"{folder}/s.####.exr"


@pytest.fixture
def expected(ocean):
    """Names and hashes of a sequence baked in one go, the manifest's too."""
    ocean.good(*BAKE, pattern("whole"))
    hashes = ocean.hashes("whole")
    assert len(hashes) == 21
    return hashes


def test_foam_has_the_same_bytes_however_a_bake_is_split_or_resumed(ocean):
    bake = ["bake", "sea.toml", "--set", "wind_speed=15", "--set", "foam_lifetime=1", "-o"]
    ocean.good(*bake, pattern("whole"), "--frames", "1-6")
    expected = ocean.hashes("whole")
    assert sum(".foam." in name for name in expected) == 6 and len(expected) == 19
    ocean.good(*bake, pattern("back"), "--frames", "6,5,4,3,2,1", "--threads", "3")
    for shard in ("2/3", "1/3", "3/3"):
        ocean.good(*bake, pattern("parts"), "--frames", "1-6", "--shard", shard, "--threads", "1")
    ocean.good(*bake, pattern("some"), "--frames", "2,5")
    ocean.good(*bake, pattern("some"), "--frames", "1-6", "--skip-existing")
    for folder in ("back", "parts", "some"):
        assert ocean.hashes(folder) == expected, folder
    image = OpenImageIO.ImageBuf(str(ocean.folder / "whole/s.foam.0003.exr"))
    pixels = image.get_pixels(OpenImageIO.FLOAT)
    assert str(image.spec().format) == "half" and pixels.shape == (64, 64, 1)
    assert pixels.min() >= 0.0 and 0.1 < pixels.max() <= 1.0


def events(done):
    return [json.loads(line) for line in done.stderr.splitlines()]


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
        ocean.good("bake", "sea.toml", "-o", f"{codec}/s.exr", "--compression", codec)
    zipped, wavelet, raw = (
        ocean.manifest(f"{codec}/s.manifest.json") for codec in ("zip", "piz", "none")
    )
    for name in zipped:
        kinds = [zipped[name], wavelet[name], raw[name]]
        assert len({entry["pixels_sha256"] for entry in kinds}) == 1
        assert len({entry["sha256"] for entry in kinds}) == 3
        assert len({entry["recipe"] for entry in kinds}) == 3


def test_the_manifest_of_a_height_field_has_its_codes(ocean):
    ocean.good("bake", "sea.toml", "-o", "out/s.png")
    entries = ocean.manifest("out/s.manifest.json")
    codes = OpenImageIO.ImageBuf(str(ocean.folder / "out/s.png")).get_pixels(OpenImageIO.UINT16)
    hashed = hashlib.sha256(codes.astype("<u2").tobytes()).hexdigest()
    assert entries["s.png"]["pixels_sha256"] == hashed
    assert "pixels_sha256" not in entries["s.png.txt"]


@pytest.mark.parametrize("threads", ["1", "2", "3"])
def test_any_number_of_threads_gives_the_same_bytes(ocean, expected, threads):
    ocean.good(*BAKE, pattern("out"), "--threads", threads)
    assert ocean.hashes("out") == expected


def test_any_order_and_any_repeated_shard_give_the_same_bytes(ocean, expected):
    order = ",".join(str(frame) for frame in range(10, 0, -1))
    ocean.good("bake", "sea.toml", *PLAIN, "--frames", order, "-o", pattern("back"))
    assert ocean.hashes("back") == expected
    for shard in ("3/4", "1/4", "3/4", "4/4", "2/4", "1/4"):
        ocean.good(*BAKE, pattern("parts"), "--shard", shard)
    assert ocean.hashes("parts") == expected


def test_shards_at_the_same_time_share_a_manifest(ocean, expected):
    runs = [
        subprocess.Popen(
            [OCEAN, *BAKE, pattern("out"), "--shard", f"{part}/5", "--threads", "1", "-q"],
            cwd=ocean.folder,
        )
        for part in (1, 2, 3, 4, 5, 3)
    ]
    assert [run.wait(timeout=120) for run in runs] == [0] * 6
    assert ocean.hashes("out") == expected


def test_shards_are_blocks_and_an_empty_one_succeeds(ocean):
    def frames(shard, count):
        return [
            int(path.split(".")[2])
            for path in ocean.good(
                "bake", "sea.toml", "-o", "s.exr", "--products", "height", "-n",
                "--frames", f"1-{count}", "--shard", shard,
            ).splitlines()
        ]  # fmt: skip

    assert [frames(f"{part}/4", 10) for part in (1, 2, 3, 4)] == [
        [1, 2], [3, 4, 5], [6, 7], [8, 9, 10],
    ]  # fmt: skip
    # One frame to a shard is named as the sequence is.
    assert frames("2/2", 2) == [2]
    done = ocean("bake", "sea.toml", "-o", "out/s.exr", "--shard", "1/2")
    assert (done.returncode, done.stdout) == (0, "")
    assert "empty" in done.stderr and not (ocean.folder / "out").exists()


@pytest.mark.parametrize("shard", ["0/4", "5/4", "x", "1/0", "-1/2", "1/2/3", "1", "1/", "1.5/2"])
def test_impossible_shards_are_refused(ocean, shard):
    message = ocean.bad("bake", "sea.toml", "-o", "out/s.exr", f"--shard={shard}")
    assert f"--shard {shard}" in message


def test_fifty_kills_later_the_bytes_are_the_same(ocean):
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


@contextlib.contextmanager
def small_disk(folder, size):
    """A file system of `size` bytes at `folder`/disk."""
    disk = folder / "disk"
    disk.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", f"size={size}", "none", str(disk)]
    done = subprocess.run(mount, capture_output=True, text=True)
    if done.returncode != 0:
        pytest.skip(f"a tmpfs cannot be mounted here: {done.stderr.strip()}")
    try:
        yield disk
    finally:
        subprocess.run(["umount", str(disk)], check=True)


def ran_in_a_namespace(ocean, request) -> bool:
    """Only root mounts. Anybody else is root in a name space, where the whole test runs again."""
    if os.geteuid() == 0:
        return False
    if subprocess.run(["unshare", "-rm", "true"], capture_output=True).returncode != 0:
        pytest.skip("this user is not root, and user name spaces are not allowed here")
    pytest_again = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider"]
    done = subprocess.run(
        ["unshare", "-rm", *pytest_again, f"--basetemp={ocean.folder}/again", request.node.nodeid],
        cwd=request.config.rootpath,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout
    return True


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
        assert message.endswith("of 10 frames are whole")
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


def damage(path, change):
    content = bytearray(path.read_bytes())
    change(content)
    path.write_bytes(content)


def cut(content):
    del content[-1000:]


def flip(content):
    content[len(content) * 3 // 4] ^= 0x10


def zero(content):
    content[-3000:-2000] = bytes(1000)


@pytest.mark.parametrize("listed", [True, False], ids=["listed", "unlisted"])
@pytest.mark.parametrize("change", [cut, flip, zero, bytearray.clear])
def test_damaged_images_are_baked_again(ocean, change, listed):
    # What no manifest lists has its codec's sum alone, which RLE and none do not have.
    bake = [*BAKE, pattern("out"), *([] if listed else ["--compression", "zip"])]
    ocean.good(*bake)
    expected = ocean.hashes("out")
    damage(ocean.folder / "out/s.normal.0003.exr", change)
    if not listed:
        (ocean.folder / "out/s.manifest.json").unlink()
    done = ocean(*bake, "--skip-existing", "--json")
    assert done.returncode == 0, done.stderr
    log = events(done)
    assert [event["frame"] for event in log if event["event"] == "frame"] == [3]
    assert log[-1]["skipped"] == 9 and log[-1]["done"] == 10
    assert len(done.stdout.splitlines()) == 20
    assert ocean.hashes("out") == expected


def test_the_manifest_finds_what_decoding_does_not(ocean):
    bake = [*BAKE, pattern("out"), "--compression", "none"]
    ocean.good(*bake)
    before = ocean.hashes("out")
    damage(ocean.folder / "out/s.normal.0003.exr", flip)
    done = ocean(*bake, "--skip-existing", "--json")
    assert events(done)[-1]["skipped"] == 9
    assert ocean.hashes("out") == before


@pytest.mark.parametrize(
    "other",
    [
        ["--set", "seed=2"],
        ["--fps", "25"],
        ["--axes", "zup"],
        ["--type", "half"],
        ["--compression", "piz"],
        ["--resolution", "128"],
        ["--backend", "radix2"],
    ],
)
@pytest.mark.parametrize("listed", [True, False], ids=["listed", "unlisted"])
def test_files_of_another_sea_or_other_options_are_baked_again(ocean, other, listed):
    bake = ["bake", "sea.toml", "-o", "out/s.####.exr", "--products", "displacement"]
    ocean.good(*bake)
    before = ocean.hashes("out")
    if not listed:
        (ocean.folder / "out/s.manifest.json").unlink()
    done = ocean(*bake, *other, "--skip-existing", "--json")
    assert events(done)[-1]["skipped"] == 0
    assert ocean.hashes("out")["s.displacement.0001.exr"] != before["s.displacement.0001.exr"]


@pytest.mark.parametrize("extension", ["png", "inc"])
def test_other_formats_are_trusted_if_the_manifest_vouches(ocean, extension):
    bake = ["bake", "sea.toml", "-o", f"out/s.####.{extension}", "--frames", "1-3"]
    again = [*bake, "--skip-existing", "--json"]
    ocean.good(*bake)
    before = ocean.hashes("out")

    def baked(*arguments):
        done = ocean(*again, *arguments)
        assert done.returncode == 0, done.stderr
        assert [event["event"] for event in events(done)][-1] == "done"
        return [event["frame"] for event in events(done) if event["event"] == "frame"]

    assert baked() == []
    damage(ocean.folder / f"out/s.0002.{extension}", flip)
    assert baked() == [2]
    assert ocean.hashes("out") == before
    (ocean.folder / "out/s.manifest.json").unlink()
    assert baked() == [1, 2, 3]
    assert ocean.hashes("out") == before
    assert baked("--set", "seed=2") == [1, 2, 3]
    assert baked("--backend", "dft", "--set", "seed=2") == [1, 2, 3]


DAMAGED = [
    "",
    '{"libocean_manifest": 2, "files": []}',
    '{"libocean_manifest": 1, "files": [{"name": 3}]}',
    '{"libocean_manifest": 1, "files": [{"name": "s.normal.0001.exr"}]}',
    '{"libocean_manifest": 1, "files": {"a": 1}}',
    '{"libocean_manifest": 1, "files": [[]]}',
    '{"libocean_manifest": 1, "files": [{"name": "../x", "sha256": "HASH", "recipe": "HASH"}]}',
    '{"libocean_manifest": 1, "files": [{"frame": 99999999999999999999}]}',
    '{"libocean_manifest": [[[[' + "[" * 80000,
]


@pytest.mark.parametrize("text", DAMAGED, ids=range(len(DAMAGED)))
def test_a_damaged_manifest_is_replaced_with_a_warning(ocean, expected, text):
    ocean.write("out/s.manifest.json", text.replace("HASH", "0" * 64))
    done = ocean(*BAKE, pattern("out"))
    assert done.returncode == 0, done.stderr
    assert ("warning: out/s.manifest.json" in done.stderr) == bool(text)
    assert ocean.hashes("out") == expected


FOREIGN = ["{", "null", '{"name": "some other tool", "version": "1.2"}', b"\xff\xfe\x00\x01" * 100]


@pytest.mark.parametrize("text", FOREIGN, ids=range(len(FOREIGN)))
def test_a_file_of_others_is_no_manifest_and_stays(ocean, text):
    path = ocean.write("out/s.manifest.json", text)
    before = path.read_bytes()
    for more in ([], ["-n"]):
        assert "s.manifest.json' is there" in ocean.bad(*BAKE, pattern("out"), *more)
    assert path.read_bytes() == before
    assert ocean.files("out") == ["s.manifest.json"]


def test_a_manifest_forgets_files_that_are_gone(ocean, expected):
    ocean.good("bake", "sea.toml", *PLAIN, "-o", pattern("out"), "--frames", "50-52")
    for path in (ocean.folder / "out").glob("*.exr"):
        path.unlink()
    ocean.good(*BAKE, pattern("out"))
    assert ocean.hashes("out") == expected


@pytest.mark.parametrize(
    ("options", "name"),
    [
        (["--products", "height,displacement,normal"], "s.displacement.0003.exr"),
        (["--products", "displacement,normal"], "s.normal.0003.exr"),
        (["--layout", "layered", "--products", "displacement,normal,velocity"], "s.0003.exr"),
        (["--layout", "layered", "--products", "height", "--type", "float"], "s.0003.exr"),
        (["--type", "half", "--axes", "yup"], "s.displacement.0003.exr"),
        (["--type", "float", "--compression", "piz"], "s.normal.0003.exr"),
        (["--compression", "none", "--backend", "radix2"], "s.displacement.0003.exr"),
        (
            ["--resolution", "128", "--backend", "dft", "--fps", "30", *SHORT_FOAM],
            "s.normal.0003.exr",
        ),
        (["--products", "slope", "--compression", "pxr24"], "s.slope.0003.exr"),
    ],
)
def test_a_frame_re_makes_itself(ocean, options, name):
    ocean.good("bake", "sea.toml", "-o", "a/s.####.exr", "--frames", "3", *options)
    (ocean.folder / "sea.toml").unlink()
    ocean.good("bake", "--from", f"a/{name}", "-o", "b/s.####.exr")
    original, again = ocean.hashes("a"), ocean.hashes("b")
    assert again[name] == original[name]
    assert len(again) == 2


def test_a_buoy_sea_re_makes_itself_when_the_buoy_file_is_gone(ocean):
    text = (ocean.folder / "buoy.toml").read_text()
    source = text.split('file = "')[1].split('"')[0]
    stem = os.path.splitext(os.path.basename(source))[0]
    for name in os.listdir(os.path.dirname(source)):
        if name.startswith(stem):
            shutil.copy(os.path.join(os.path.dirname(source), name), ocean.folder / name)
    copy = os.path.basename(source)
    ocean.write("sea.toml", text.replace(source, copy) + "[grid]\nresolution = 64\n")
    ocean.good("bake", "sea.toml", *PLAIN, "-o", "a/s.####.exr", "--frames", "5-7")
    for path in ocean.folder.glob(f"{stem}*"):
        path.unlink()
    (ocean.folder / "sea.toml").unlink()
    (ocean.folder / "buoy.toml").unlink()
    shutil.move(ocean.folder / "a/s.displacement.0006.exr", ocean.folder / "one.exr")
    ocean.good(
        "bake", "--from", "one.exr", "--products", "displacement,normal", "--frames", "5-7",
        "-o", "b/s.####.exr",
    )  # fmt: skip
    shutil.move(ocean.folder / "one.exr", ocean.folder / "a/s.displacement.0006.exr")
    assert ocean.hashes("b") == ocean.hashes("a")


def test_options_win_over_the_header(ocean):
    ocean.good("bake", "sea.toml", "-o", "a.exr", "--products", "height", "--type", "float")
    ocean.good("bake", "sea.toml", "-o", "b.exr", "--products", "height", "--set", "seed=2",
               "--compression", "zips")  # fmt: skip
    ocean.good("bake", "--from", "a.exr", "-o", "c.exr", "--set", "seed=2", "--type", "half",
               "--compression", "zips")  # fmt: skip
    assert (ocean.folder / "c.exr").read_bytes() == (ocean.folder / "b.exr").read_bytes()
    # The sea's own resolution follows the sea; other formats take what they know.
    ocean.good("bake", "--from", "a.exr", "-o", "d.png", "--set", "resolution=32")
    ocean.good("bake", "sea.toml", "-o", "e.png", "--set", "resolution=32")
    assert (ocean.folder / "d.png").read_bytes() == (ocean.folder / "e.png").read_bytes()


def test_only_one_source_and_only_our_files(ocean):
    ocean.good("bake", "sea.toml", "-o", "a.exr", "--products", "height")
    assert "SEA or --from" in ocean.bad("bake", "-o", "b.exr")
    assert "one of them" in ocean.bad("bake", "sea.toml", "--from", "a.exr", "-o", "b.exr")
    assert "not an OpenEXR file" in ocean.bad("bake", "--from", "sea.toml", "-o", "b.exr")
    content = (ocean.folder / "a.exr").read_bytes()
    ocean.write("time.exr", content.replace(b"\x01\x00\x00\x000", b"\x01\x00\x00\x007"))
    assert "ocean:time" in ocean.bad("bake", "--from", "time.exr", "-o", "b.exr")
    ocean.write("field.exr", content.replace(b"height", b"jagged"))
    ocean.bad("bake", "--from", "field.exr", "-o", "b.exr")
    ocean.write("cut.exr", content[:90])
    assert "cannot read the header" in ocean.bad("bake", "--from", "cut.exr", "-o", "b.exr")


def test_a_dry_run_tells_and_writes_nothing(ocean):
    done = ocean(*BAKE, pattern("out/deep"), "-n", "--json")
    assert done.returncode == 0 and not (ocean.folder / "out").exists()
    paths = done.stdout.splitlines()
    (plan,) = events(done)
    assert plan["event"] == "plan" and plan["files"] == 20 == len(paths)
    made = ocean.good(*BAKE, pattern("out/deep"), "--compression", "none").splitlines()
    assert made == paths
    size = sum((ocean.folder / path).stat().st_size for path in paths)
    assert size <= plan["bytes"] <= 1.1 * size
    assert plan["free_bytes"] == pytest.approx(shutil.disk_usage(ocean.folder).free, rel=0.5)
    assert 0 < plan["memory_bytes"] < 1 << 30
    for output in ("out/s.png", "out/s.inc", "out/s.df3"):
        done = ocean("bake", "sea.toml", "-o", output, "-n", "--json")
        names = done.stdout.splitlines()
        ocean.good("bake", "sea.toml", "-o", output)
        size = sum((ocean.folder / name).stat().st_size for name in names)
        assert size <= events(done)[0]["bytes"]


def peak_memory(ocean, *arguments):
    done = subprocess.run(
        ["/usr/bin/python3", DATA.parent / "peak_memory.py", OCEAN, *arguments],
        cwd=ocean.folder, capture_output=True, text=True, check=True,
    )  # fmt: skip
    return int(done.stdout)


@pytest.mark.parametrize(
    "options",
    [
        "-o s.exr --set resolution=64",
        "-o s.exr --set resolution=1024 --set foam_lifetime=0.1",
        "-o s.#.exr --set resolution=1024 --products height --frames 1-2 --threads 2",
        "-o s.#.exr --resolution 2048 --products displacement --frames 1-2 --threads 2",
        "-o s.exr --set cascades=3 --set resolution=256 --set foam_lifetime=0.1",
        "-o s.exr --set resolution=512 --layout layered --type half"
        " --products displacement,velocity,normal,slope,jacobian,whitecap",
        "-o s.png --set resolution=512",  # has maps that invert a choppy sea
        "-o s.inc --set resolution=1024",
        "-o s.inc --set resolution=512 --eye 0,0,3",
        "-o s.df3 --set resolution=512",
        "-o s.exr --set resolution=128 --backend dft --set foam_lifetime=0.1",
    ],
)
def test_a_dry_run_tells_the_memory_that_is_used(ocean, options):
    """To a quarter of it; measured 0.91 to 1.12."""
    bake = ["bake", "sea.toml", *options.split()]
    announced = events(ocean(*bake, "-n", "--json"))[0]["memory_bytes"]
    used = peak_memory(ocean, *bake)
    assert used / 1.25 < announced < used * 1.25


def test_a_dry_run_says_what_would_be_kept(ocean):
    ocean.good("bake", "sea.toml", "--frames", "1-3", "-o", "s.####.exr", "--products", "height")
    before = ocean.hashes(".")
    done = ocean(
        "bake", "sea.toml", "--frames", "2-5", "-o", "s.####.exr", "--products", "height",
        "--skip-existing", "-n",
    )  # fmt: skip
    assert done.stdout.splitlines() == [
        "s.height.0002.exr\tkept",
        "s.height.0003.exr\tkept",
        "s.height.0004.exr",
        "s.height.0005.exr",
    ]
    assert ocean.hashes(".") == before


def test_a_dry_run_warns_of_a_disk_that_is_too_small(ocean, request):
    if ran_in_a_namespace(ocean, request):
        return
    with small_disk(ocean.folder, 64 * 1024):
        done = ocean(*BAKE, pattern("disk"), "-n")
        assert done.returncode == 0 and "warning" in done.stderr and "may not fit" in done.stderr
        assert ocean.files("disk") == []


def test_frames_side_by_side_stay_within_half_of_the_memory(ocean):
    def memory(frames, limit):
        script = f"ulimit -v {limit}; " if limit else ""
        script += '"$OCEAN" bake sea.toml --products displacement,normal --set resolution=1024 '
        script += "--threads 64 -n --json -o s.#.exr"
        return events(ocean.shell(f"{script} --frames 1-{frames}"))[0]["memory_bytes"]

    one = memory(1, None)
    assert one < 0.2e9 < 3.5 * one < memory(8, None)
    assert 3.5 * one < memory(64, 1_500_000) < 750_000 * 1024


@pytest.fixture
def blocked(ocean):
    """A sea whose frame 4 has a folder where its file should go."""
    (ocean.folder / "out/s.height.0004.exr").mkdir(parents=True)
    return [*BAKE_SOME, pattern("out"), "--products", "height"]


def test_a_failure_ends_the_bake_and_says_how_far_it_came(ocean, blocked):
    done = ocean(*blocked, "--threads", "1")
    assert done.returncode == 1
    last = done.stderr.splitlines()[-1]
    assert last.startswith("ocean: cannot write 'out/s.height.0004.exr'")
    assert last.endswith("; 3 of 10 frames are whole")
    assert len(done.stdout.splitlines()) == 3
    assert len(ocean.manifest("out/s.manifest.json")) == 3


def test_with_keep_going_the_other_frames_go_on(ocean, blocked):
    done = ocean(*blocked, "--keep-going")
    assert done.returncode == 1
    lines = done.stderr.splitlines()
    assert lines[-1] == "ocean: 1 of 10 frames failed: 4"
    assert any(line.startswith("ocean: frame 4 failed: cannot write") for line in lines)
    assert len(done.stdout.splitlines()) == 9
    assert len(ocean.manifest("out/s.manifest.json")) == 9


def test_json_lines_count_what_became_of_each_frame(ocean, blocked):
    ocean.good("bake", "sea.toml", "-o", pattern("out"), "--products", "height", "--frames", "2-3")
    done = ocean(*blocked, "--keep-going", "--skip-existing", "--json")
    log = events(done)
    assert log[0]["event"] == "start" and log[0]["total"] == 10
    kinds = {event["frame"]: event["event"] for event in log if "frame" in event}
    assert list(kinds) == list(range(1, 11))
    assert {frame for frame, kind in kinds.items() if kind == "skipped"} == {2, 3}
    assert {frame for frame, kind in kinds.items() if kind == "failed"} == {4}
    counts = {key: log[-2][key] for key in ("event", "done", "skipped", "failed", "total")}
    assert counts == {"event": "done", "done": 9, "skipped": 2, "failed": 1, "total": 10}
    assert log[-1]["event"] == "error"


def test_a_reader_who_leaves_ends_the_bake_with_a_manifest(ocean):
    """As `| head` does: without a word, every file whole and listed."""
    done = ocean.shell(
        '"$OCEAN" bake sea.toml --set fetch=80000 --frames 1-5000 -o out/s.####.exr'
        " --products height --json | head -n 2; exit ${PIPESTATUS[0]}"
    )
    assert done.returncode == 128 + signal.SIGPIPE
    assert {event["event"] for event in events(done)} == {"start", "frame"}
    names = [name for name in ocean.files() if name.endswith(".exr")]
    assert 2 <= len(names) < 5000
    assert sorted(ocean.manifest("out/s.manifest.json")) == names
    assert len(ocean.files()) == len(names) + 1


@pytest.mark.parametrize("command", ["presets --help", "info sea.toml", "bake --help"])
def test_no_command_complains_of_a_reader_who_left(ocean, command):
    done = ocean.shell(f'"$OCEAN" {command} | true; exit ${{PIPESTATUS[0]}}')
    assert done.returncode in (0, 128 + signal.SIGPIPE) and done.stderr == ""


def test_a_pipe_gets_no_manifest(ocean):
    os.mkfifo(ocean.folder / "s.png")
    reader = subprocess.Popen(["cat", "s.png"], cwd=ocean.folder, stdout=subprocess.PIPE)
    ocean.good("bake", "sea.toml", "-o", "s.png")
    assert reader.communicate(timeout=120)[0].startswith(b"\x89PNG")
    assert set(ocean.manifest("s.manifest.json")) == {"s.png.txt", "s.png.inc"}
