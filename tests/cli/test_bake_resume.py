# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean bake --skip-existing` and --from: damaged files, foreign files, manifests."""

import os
import shutil

import pytest
from bake_runs import BAKE, PLAIN, events, pattern


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
    # A file that no manifest lists has the checksum of its codec only; RLE and none have none.
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
    done = ocean(*bake, *other, "--skip-existing", "--overwrite", "--json")
    assert events(done)[-1]["skipped"] == 0
    assert ocean.hashes("out")["s.displacement.0001.exr"] != before["s.displacement.0001.exr"]


@pytest.mark.parametrize("extension", ["png", "inc"])
def test_other_formats_are_kept_if_the_manifest_lists_them(ocean, extension):
    bake = ["bake", "sea.toml", "-o", f"out/s.####.{extension}", "--frames", "1-3"]
    again = [*bake, "--skip-existing", "--overwrite", "--json"]
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


def test_a_manifest_forgets_files_that_are_gone(ocean, expected):
    ocean.good("bake sea.toml", *PLAIN, "-o", pattern("out"), "--frames", "50-52")
    for path in (ocean.folder / "out").glob("*.exr"):
        path.unlink()
    ocean.good(*BAKE, pattern("out"))
    assert ocean.hashes("out") == expected


def test_a_buoy_sea_re_makes_itself_when_the_buoy_file_is_gone(ocean):
    text = (ocean.folder / "buoy.toml").read_text()
    source = text.split('file = "')[1].split('"')[0]
    stem = os.path.splitext(os.path.basename(source))[0]
    for name in os.listdir(os.path.dirname(source)):
        if name.startswith(stem):
            shutil.copy(os.path.join(os.path.dirname(source), name), ocean.folder / name)
    copy = os.path.basename(source)
    ocean.write("sea.toml", text.replace(source, copy) + "[grid]\nresolution = 64\n")
    ocean.good("bake sea.toml", *PLAIN, "-o", "a/s.####.exr", "--frames", "5-7")
    for path in ocean.folder.glob(f"{stem}*"):
        path.unlink()
    (ocean.folder / "sea.toml").unlink()
    (ocean.folder / "buoy.toml").unlink()
    shutil.move(ocean.folder / "a/s.displacement.0006.exr", ocean.folder / "one.exr")
    ocean.good("bake --from one.exr --products displacement,normal --frames 5-7 -o b/s.####.exr")
    shutil.move(ocean.folder / "one.exr", ocean.folder / "a/s.displacement.0006.exr")
    assert ocean.hashes("b") == ocean.hashes("a")


def test_options_win_over_the_header(ocean):
    ocean.good("bake sea.toml -o a.exr --products height --type float")
    ocean.good("bake sea.toml -o b.exr --products height --set seed=2 --compression zips")
    ocean.good("bake --from a.exr -o c.exr --set seed=2 --type half --compression zips")
    assert (ocean.folder / "c.exr").read_bytes() == (ocean.folder / "b.exr").read_bytes()
    # The sea's own resolution follows the sea; other formats take what they know.
    ocean.good("bake --from a.exr -o d.png --set resolution=32")
    ocean.good("bake sea.toml -o e.png --set resolution=32")
    assert (ocean.folder / "d.png").read_bytes() == (ocean.folder / "e.png").read_bytes()


def test_a_damaged_source_is_refused(ocean):
    ocean.good("bake sea.toml -o a.exr --products height")
    content = (ocean.folder / "a.exr").read_bytes()
    ocean.write("time.exr", content.replace(b"\x01\x00\x00\x000", b"\x01\x00\x00\x007"))
    assert "ocean:time" in ocean.bad("bake --from time.exr -o b.exr")
    ocean.write("field.exr", content.replace(b"height", b"jagged"))
    ocean.bad("bake --from field.exr -o b.exr")
    ocean.write("cut.exr", content[:90])
    assert "cannot read the header" in ocean.bad("bake --from cut.exr -o b.exr")
