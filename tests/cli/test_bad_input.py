# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Bad input that a table of texts cannot hold gets one clear line and exit code 2: pictures, pipes,
devices; what only the run can know gets 1: memory, limits of files. All else is in refusals."""

import os
from contextlib import contextmanager

import pytest
from conftest import SMALL_SEA, check_failure

WAVES = "libocean = 1\n[[waves]]\n"


def test_an_exr_of_another_program_is_refused(ocean):
    import OpenImageIO

    path = str(ocean.folder / "other.exr")
    image = OpenImageIO.ImageBuf(OpenImageIO.ImageSpec(8, 8, 3, "half"))
    assert image.write(path)
    assert "other.exr" in ocean.bad("info other.exr")


def test_a_folder_in_the_place_of_the_output_is_left_alone(ocean):
    (ocean.folder / "s.exr").mkdir()
    done = ocean("bake sea.toml -o s.exr --products height")
    assert done.returncode == 1 and "s.exr" in done.stderr.splitlines()[-1]
    assert ocean.files("s.exr") == []


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
    of_files = ocean("query sea.toml --time 1 --points points.csv")
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
    assert "is a pipe or a device" in ocean.bad("info measured.toml")
    assert "is a pipe or a device" in ocean.bad("records /dev/zero")


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


def test_help_names_no_internal_types(ocean):
    for command in ("query", "bake", "spectrum", "gauge"):
        assert "{" not in ocean.good(command, "--help").split("Running")[0]
