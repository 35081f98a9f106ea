# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Bad input gets one clear line and exit code 2, what only the run can know gets 1."""

import os
from contextlib import contextmanager

import pytest
from conftest import BUOY, SMALL_SEA, check_failure

WAVES = "libocean = 1\n[[waves]]\n"


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        (SMALL_SEA + "wind_sped = 3\n", ["sea.toml:9", "wind_sped", "wind_speed"]),
        (SMALL_SEA + "fetch = 12km\n", ["sea.toml:9", "not TOML", "without their unit"]),
        (WAVES + "[grid]\nresolution = 500\n", ["sea.toml:4", "resolution", "500", "power of two"]),
        ("", ["sea.toml", "libocean = 1"]),
        (b"\x00\xff\xfe\x80", ["sea.toml"]),
    ],
)
def test_a_bad_sea_file_is_named_with_line_key_value_and_range(ocean, text, parts):
    ocean.write("sea.toml", text)
    for command in (["info"], ["spectrum"], ["bake", "-o", "out/s.exr"]):
        message = ocean.bad(command[0], "sea.toml", *command[1:])
        for part in parts:
            assert part in message
    assert not (ocean.folder / "out").exists()


@pytest.mark.parametrize(
    ("assignment", "parts"),
    [
        ("wind_sped=3", ["wind_sped"]),
        ("wind_speed=nan", ["wind_speed", "nan", "75"]),
        ("wind_speed=76", ["76", "75"]),
        ("wind_speed=fast", ["fast", "75"]),
        ("wind_speed=12kn", ["12kn", "is not a number: write it in m/s, without a unit", "75"]),
        ("wind_speed=1,5", ["is not a number; allowed"]),
        ("wind_speed=3 ", ["wind_speed"]),
        ("waves.7.wind_speed=3", ["waves.7"]),
        ("resolution=100", ["100", "power of two"]),
        ("spectrum=measured", ["file"]),
        ("wind_speed", ["NAME=VALUE"]),
        ("=3", ["NAME=VALUE"]),
    ],
)
def test_a_bad_assignment_is_refused(ocean, assignment, parts):
    for command in (["info"], ["bake", "-o", "out/s.exr"]):
        message = ocean.bad(*command, "sea.toml", "--set", assignment)
        for part in parts:
            assert part in message
    assert not (ocean.folder / "out").exists()


@pytest.mark.parametrize(
    "spectrum",
    [
        b"",
        b"hello\n",
        BUOY.read_bytes()[:200],
        BUOY.read_bytes().splitlines()[0] + b"\n",
        b"\x7fELF\x00\x00\x00\xff" * 100,
    ],
    ids=["empty", "text", "truncated", "header only", "binary"],
)
def test_a_bad_spectrum_file_is_refused(ocean, spectrum):
    ocean.write("b.data_spec", spectrum)
    ocean.write("b.toml", WAVES + 'spectrum = "measured"\nfile = "b.data_spec"\n')
    assert "b.data_spec" in ocean.bad("info", "b.toml")


def test_a_missing_record_names_the_nearest(ocean):
    text = WAVES + f'spectrum = "measured"\nfile = "{BUOY}"\nrecord = "2021-01-01T00:00"\n'
    ocean.write("b.toml", text)
    assert "2020-06-08T03:50" in ocean.bad("info", "b.toml")
    assert "2020-06-08T03:50" in ocean.bad("info", "buoy.toml", "--set", "record=2021-01-01T00:00")


@pytest.mark.parametrize("name", ["nowhere.toml", "."])
def test_a_missing_sea_file_is_refused(ocean, name):
    assert f"ocean: {name}: " in ocean.bad("info", name)


def test_an_exr_of_another_program_is_refused(ocean):
    import OpenImageIO

    path = str(ocean.folder / "other.exr")
    image = OpenImageIO.ImageBuf(OpenImageIO.ImageSpec(8, 8, 3, "half"))
    assert image.write(path)
    assert "other.exr" in ocean.bad("info", "other.exr")


def test_a_truncated_baked_file_is_refused(ocean):
    ocean.good("bake", "sea.toml", "-o", "s.exr", "--products", "height")
    whole = (ocean.folder / "s.exr").read_bytes()
    for size in (4, 100, 1000):
        ocean.write("cut.exr", whole[:size])
        assert "cut.exr" in ocean.bad("info", "cut.exr")


@pytest.mark.parametrize(
    ("arguments", "parts"),
    [
        (["--backend", "gpu"], ["gpu", "radix2"]),
        (["--products", "heights"], ["heights", "height"]),
        (["--products", "height,height"], ["height", "repeated"]),
        (["--type", "double"], ["double", "half"]),
        (["--axes", "xyz"], ["xyz", "tnb"]),
        (["--layout", "tiled"], ["tiled", "layered"]),
        (["--compression", "dwaa"], ["dwaa", "zip"]),
        (["--compression", "lzw"], ["lzw", "zip"]),
        (["--resolution", "48"], ["48", "power of two"]),
        (["--resolution", "64.5"], ["64.5", "whole number"]),
        (["--resolution", "1e9"], ["1e9", "8192"]),
        (["--resolution", "nan"], ["nan", "8192"]),
        (["--fps", "0"], ["fps", "0"]),
        (["--eye", "0,0,6"], ["--eye", ".inc"]),
    ],
)
def test_bad_bake_options_are_refused(ocean, arguments, parts):
    message = ocean.bad("bake", "sea.toml", "-o", "out/s.exr", *arguments)
    for part in parts:
        assert part in message
    assert not (ocean.folder / "out").exists()


@pytest.mark.parametrize(
    ("arguments", "parts"),
    [
        (["--products", "height"], ["--products", ".exr"]),
        (["--axes", "zup"], ["--axes", ".exr"]),
        (["--heading", "10"], ["--heading", "--eye"]),
        (["--eye", "1,2"], ["1,2", "X,Y,HEIGHT"]),
        (["--eye", "1,2,nan"], ["nan", "HEIGHT"]),
        (["--eye", "1,2,-3"], ["-3", "HEIGHT"]),
        (["--eye", "0,0,6", "--field-of-view", "200"], ["200", "150"]),
        (["--eye", "0,0,6", "--mesh-rows", "1"], ["--mesh-rows", "1"]),
    ],
)
def test_options_that_a_mesh_cannot_use_are_refused(ocean, arguments, parts):
    message = ocean.bad("bake", "sea.toml", "-o", "s.inc", *arguments)
    for part in parts:
        assert part in message


@pytest.mark.parametrize("name", ["/proc/nowhere/s.exr", "sea.toml/s.exr", "/dev/null/x/s.exr"])
def test_an_output_folder_that_cannot_be_made_is_a_failure_of_the_run(ocean, name):
    assert name.rsplit("/", 1)[0] in ocean.bad("bake", "sea.toml", "-o", name, code=1)


def test_a_folder_in_the_place_of_the_output_is_left_alone(ocean):
    (ocean.folder / "s.exr").mkdir()
    done = ocean("bake", "sea.toml", "-o", "s.exr", "--products", "height")
    assert done.returncode == 1 and "s.exr" in done.stderr.splitlines()[-1]
    assert ocean.files("s.exr") == []


def test_a_full_disk_is_a_failure_that_names_the_file(ocean):
    assert "/dev/full" in ocean.bad("spectrum", "sea.toml", "-o", "/dev/full", code=1)
    assert "No space left" in ocean.bad("spectrum", "sea.toml", "--plot", "/dev/full", code=1)


def test_a_file_size_limit_leaves_nothing_behind(ocean):
    done = ocean.shell('ulimit -f 8; "$OCEAN" bake sea.toml -o out/s.####.exr --frames 1-3')
    assert done.returncode == 1
    assert "out/s.displacement.0001.exr" in done.stderr.splitlines()[-1]
    assert done.stdout == ""
    assert ocean.files("out") == []


@pytest.mark.parametrize("option", ["--resolution 8192", "--set grid.resolution=8192"])
def test_too_much_memory_is_said_before_it_is_allocated(ocean, option):
    script = f'ulimit -v 1000000; "$OCEAN" bake sea.toml -o out/s.exr {option}'
    message = check_failure(ocean.shell(script), 1)
    assert "8192" in message and "memory" in message and "MiB" in message
    assert not (ocean.folder / "out").exists()


def test_a_sea_and_points_may_come_out_of_pipes_and_nothing_else_may(ocean):
    ocean.write("sea.toml", SMALL_SEA)
    ocean.write("points.csv", "x,y\n1,2\n")
    of_files = ocean("query", "sea.toml", "--time", 1, "--points", "points.csv")
    assert of_files.returncode == 0
    # The paths that bash passes for <(command).
    with piped(SMALL_SEA) as sea, piped("x,y\n1,2\n") as points:
        of_pipes = ocean(
            *["query", f"/dev/fd/{sea}", "--time", 1, "--points", f"/dev/fd/{points}"],
            pass_fds=(sea, points),
        )
    assert (of_pipes.returncode, of_pipes.stdout) == (0, of_files.stdout)
    with piped("libocean = 2\n") as sea:
        result = ocean("info", f"/dev/fd/{sea}", pass_fds=(sea,))
    assert result.returncode == 2
    assert "libocean = 1" in result.stderr
    # Named in a sea file, a pipe would be waited for on every machine that reads it.
    os.mkfifo(ocean.folder / "spectrum.csv")
    ocean.write("measured.toml", WAVES + 'spectrum = "measured"\nfile = "spectrum.csv"\n')
    assert "is a pipe or a device" in ocean.bad("info", "measured.toml")
    assert "is a pipe or a device" in ocean.bad("records", "/dev/zero")


@contextmanager
def piped(text):
    """A descriptor from which the text can be read once."""
    read, write = os.pipe()
    os.write(write, text.encode())
    os.close(write)
    try:
        yield read
    finally:
        os.close(read)


def test_a_mistyped_command_is_named_with_the_one_meant(ocean):
    assert "unknown command 'bak'; did you mean bake?" in ocean.bad("bak", "sea.toml")
    assert "unknown command 'zzzzzz' (see" in ocean.bad("zzzzzz")


def test_a_flag_is_echoed_as_it_was_typed(ocean):
    for typed in ("-q=3", "-n=yes"):
        assert typed in ocean.bad("bake", "sea.toml", "-o", "s.exr", typed)
    for command in ("query", "bake", "spectrum", "gauge"):
        assert "{" not in ocean.good(command, "--help").split("Running")[0]


def test_a_picture_is_a_png(ocean):
    assert "allowed is NAME.png" in ocean.bad("spectrum", "sea.toml", "--plot", "s.jpg")
    assert not (ocean.folder / "s.jpg").exists()


def test_a_plan_for_a_folder_that_cannot_be_says_so(ocean):
    message = ocean.bad("bake", "sea.toml", "-o", "sea.toml/out/s.exr", "-n", code=1)
    assert "the folder cannot be written" in message
    assert message.endswith("sea.toml is not a folder")
    message = ocean.bad("povray", "sea.toml", "-o", "sea.toml/out", "-n", code=1)
    assert "the folder cannot be written" in message
