# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean check`: every fault of a bake on many machines is a line of its own, and status 1."""

import json

import pytest

FRAMES = ("--frames", "1-6")
FORMATS = {
    "exr": ("--products", "displacement,normal"),
    "vdb": ("--resolution", "32"),
    "ply": (),
}
OTHER_SEA = ("--set", "wind_speed=14")


def shards(ocean, output, *options, numbers=(1, 2, 3)):
    for number in numbers:
        ocean.good("bake sea.toml -q -o", output, *FRAMES, *options, "--shard", f"{number}/3")


def faults(ocean, *arguments) -> dict[str, str]:
    """The faults by the names of their files; the file's fault and the reason."""
    done = ocean("check", *arguments, "--json")
    told = json.loads(done.stdout)
    assert done.returncode == (1 if told["faults"] else 0)
    return {
        each["path"].rsplit("/")[-1]: f"{each['fault']}: {each['reason']}"
        for each in told["faults"]
    }


@pytest.mark.parametrize("extension", FORMATS)
def test_shards_are_joined_to_the_manifest_of_the_whole(ocean, extension):
    output = f"s.####.{extension}"
    options = FORMATS[extension]
    ocean.good("bake sea.toml -q -o", f"whole/{output}", *FRAMES, *options)
    shards(ocean, f"parts/{output}", *options)
    assert "s.manifest.2of3.json" in ocean.files("parts")
    assert "s.manifest.json" not in ocean.files("parts")
    assert faults(ocean, f"parts/{output}") == {}
    # A bake keeps what is complete, whatever manifest lists it.
    again = ("bake sea.toml -o", f"parts/{output}", *FRAMES, *options, "--skip-existing")
    summary = json.loads(ocean.good(*again, "-n", "--summary", "--json"))
    assert summary["kept"] == summary["files"]
    ocean.merge(f"parts/{output}")
    assert ocean.hashes("parts") == ocean.hashes("whole")
    text = ocean.good("check whole/s.manifest.json --frames 1-6")
    count = 12 if extension == "exr" else 6
    assert text.startswith(f"{count} of {count} files are whole")


@pytest.mark.parametrize("extension", FORMATS)
def test_another_sea_is_refused_without_a_flag(ocean, extension):
    output = f"out/s.####.{extension}"
    shards(ocean, output, *FORMATS[extension], numbers=(1, 2))
    before = ocean.hashes("out")
    shard = ("bake sea.toml -q -o", output, *FRAMES, *FORMATS[extension], "--shard", "3/3")
    message = f"-o out/s.0005.{extension}: frames of another sea are there: 1-4; --overwrite"
    assert message in ocean.bad(*shard, *OTHER_SEA)
    assert message in ocean.bad(*shard, *OTHER_SEA, "-n")
    chunk = ("bake sea.toml -q -o", output, *FORMATS[extension], "--frames", "2")
    assert "--overwrite" in ocean.bad(*chunk, *OTHER_SEA)
    # Without a manifest the headers tell.
    for number in (1, 2):
        (ocean.folder / f"out/s.manifest.{number}of3.json").rename(ocean.folder / f"{number}.json")
    assert "are there: 2; --overwrite" in ocean.bad(*chunk, *OTHER_SEA)
    for number in (1, 2):
        (ocean.folder / f"{number}.json").rename(ocean.folder / f"out/s.manifest.{number}of3.json")
    assert ocean.hashes("out") == before
    ocean.good(*shard, *OTHER_SEA, "--overwrite")
    told = faults(ocean, output)
    assert set(told.values()) == {"other: it is of another subject"}
    assert all(".0005." in name or ".0006." in name for name in told)


def test_a_mesh_may_lie_beside_images_of_another_sea(ocean):
    ocean.good("bake sea.toml -q -o out/s.####.exr --frames 1-2")
    ocean.good("bake sea.toml -q -o out/s.ply", *OTHER_SEA)
    assert faults(ocean, "out/s.####.exr") == faults(ocean, "out/s.ply") == {}


def test_each_fault_has_its_word(ocean):
    shards(ocean, "out/s.####.exr", *FORMATS["exr"], numbers=(1, 3))
    out = ocean.folder / "out"
    told = faults(ocean, "out/s.####.exr")
    assert told["s.manifest.2of3.json"] == "missing: shard 2 of 3 has not finished a file"
    assert told["s.manifest.json"] == "missing: it lists no frame 3-4 of s.normal.#.exr"
    # A shard with other options, a file that lacks, one cut off, one exchanged, a stranger.
    other = ("--products", "displacement", "--compression", "zip")
    shards(ocean, "out/s.####.exr", *other, numbers=(2,))
    (out / "s.normal.0001.exr").unlink()
    cut = out / "s.normal.0002.exr"
    cut.write_bytes(cut.read_bytes()[:-1])
    flipped = bytearray((out / "s.normal.0005.exr").read_bytes())
    flipped[-1] ^= 1
    (out / "s.normal.0005.exr").write_bytes(flipped)
    (out / "s.normal.0077.exr").write_bytes(flipped)
    told = faults(ocean, "out/s.manifest.json")
    assert told["s.displacement.0003.exr"] == "other: it is of other options or another version"
    assert told["s.normal.0001.exr"] == "missing: a manifest lists it"
    assert told["s.normal.0002.exr"].startswith("damaged: ") and "were written" in told[cut.name]
    assert told["s.normal.0077.exr"] == "foreign: no manifest lists it"
    (out / "s.manifest.3of3.json").write_text('{"libocean_manifest": 1, "files": [')
    told = faults(ocean, "out/s.manifest.json")
    assert told["s.manifest.3of3.json"].startswith("damaged: it is damaged at byte")
    before = ocean.hashes("out")
    done = ocean("check out/s.####.exr --merge")
    assert done.returncode == 1 and "are not merged" in done.stderr
    assert ocean.hashes("out") == before
    # It is repaired by the shards alone, each of which replaces its own manifest.
    (out / "s.normal.0077.exr").unlink()
    first = ("bake sea.toml -o out/s.####.exr", *FRAMES, *FORMATS["exr"], "--skip-existing")
    told = ocean(*first, "--shard", "1/3").stderr
    assert "s.manifest.3of3.json is damaged" in told and "the files that it lists" in told
    assert "it will be replaced" not in told
    shards(ocean, "out/s.####.exr", *FORMATS["exr"], "--skip-existing")
    ocean.merge("out/s.####.exr")
    shards(ocean, "out/s.####.exr", *FORMATS["exr"], "--overwrite", numbers=(2,))
    assert faults(ocean, "out/s.####.exr", *FRAMES) == {}


def test_a_bake_is_held_against_a_sea(ocean):
    ocean.good("bake sea.toml -q -o out/s.####.exr", *FRAMES, *FORMATS["exr"])
    assert faults(ocean, "out/s.####.exr", "--against", "sea.toml") == {}
    other = (ocean.folder / "sea.toml").read_text().replace("9.0", "14.0")
    ocean.write("other.toml", other)
    told = faults(ocean, "out/s.####.exr", "--against", "other.toml")
    assert len(told) == 12 and set(told.values()) == {"other: it is of another subject"}
    # A manifest of a version that did not name the subject.
    manifest = ocean.folder / "out/s.manifest.json"
    content = json.loads(manifest.read_text())
    lines = []
    for entry in content["files"]:
        del entry["subject"], entry["sequence"]
        lines.append(json.dumps(entry))
    manifest.write_text('{"libocean_manifest": 1, "files": [' + ",".join(lines) + "]}")
    assert faults(ocean, "out/s.####.exr", "--against", "sea.toml") == {}
    told = faults(ocean, "out/s.####.exr", "--against", "other.toml")
    assert set(told.values()) == {"damaged: its header names another subject"}
    assert "are there: 1-6" in ocean.bad("bake other.toml -o out/s.####.exr --frames 9")


def test_what_is_no_bake(ocean):
    done = ocean("check nothing.exr")
    assert done.returncode == 1 and "no manifest, nor one of a shard" in done.stdout


def test_frames_of_open_job_description_are_understood(ocean):
    def names(frames):
        told = ocean.good("bake sea.toml -o s.exr --products height -n --frames", frames)
        return [int(path.split(".")[-2]) for path in told.split()]

    assert names("1-9:4") == names("1-9x4") == [1, 5, 9]


def test_a_summary_is_the_sums_alone(ocean):
    bake = "bake sea.toml -o out/s.####.exr --frames 1-100 --products height"
    told = json.loads(ocean.good(bake, "-n", "--summary", "--json"))
    assert (told["frames"], told["files"], told["kept"]) == (100, 100, 0)
    assert 0 < told["bytes"] < told["free_bytes"] and 0.0 < told["seconds"] < 60.0
    text = ocean.good(bake, "-n", "--summary")
    assert text.startswith("frames   100\nfiles    100, 0 of them kept\n")
    # A shard may be empty.
    told = json.loads(ocean.good(bake, "--shard", "1/200", "-n", "--summary", "--json"))
    assert (told["frames"], told["files"], told["bytes"]) == (0, 0, 0)
