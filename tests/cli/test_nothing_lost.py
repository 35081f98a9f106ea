# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""No command writes over what is the user's: what it reads, and files that are not its own."""

import os

import pytest

POINTS = "x,y\n1,2\n3,4\n"
QUERY = ("query", "sea.toml", "--time", "1", "--points", "p.csv")
GAUGE = ("gauge", "sea.toml", "--points", "p.csv", "--from", "0", "--to", "9", "--rate", "2")


@pytest.fixture
def lot(ocean):
    """The program in a folder with links to its inputs."""
    ocean.write("p.csv", POINTS)
    os.symlink("sea.toml", ocean.folder / "link.toml")
    os.link(ocean.folder / "p.csv", ocean.folder / "hard.csv")
    return ocean


@pytest.mark.parametrize(
    ("command", "file"),
    [
        (("spectrum", "link.toml", "-o", "sea.toml"), "sea.toml"),
        (("spectrum", "sea.toml", "--plot", "link.toml"), "sea.toml"),
        ((*QUERY, "-o", "hard.csv"), "p.csv"),
        ((*GAUGE, "--spectrum", "hard.csv"), "p.csv"),
    ],
)
def test_inputs_are_not_overwritten_by_their_other_names(lot, command, file):
    content = (lot.folder / file).read_bytes()
    names = lot.files(".")
    assert "is an input of this command" in lot.bad(*command)
    assert (lot.folder / file).read_bytes() == content
    assert lot.files(".") == names


EXTENSIONS = ["exr", "df3", "png", "inc", "ply", "obj", "usda", "vdb"]


@pytest.mark.parametrize(
    ("extension", "spray"),
    [
        *((extension, False) for extension in EXTENSIONS),
        ("ply", True),
    ],
)
def test_frames_of_a_killed_bake_are_replaced(ocean, extension, spray):
    kind = ["--products", "spray"] if spray else []
    command = ("bake", "sea.toml", "-o", f"s.{extension}", *kind)
    ocean.good(*command)
    expected = ocean.hashes(".")
    (ocean.folder / "s.manifest.json").unlink()
    ocean.good(*command)
    assert ocean.hashes(".") == expected


def test_a_frame_replaces_a_link_to_another_frame(ocean):
    command = ("bake", "sea.toml", "-o", "s.####.exr", "--products", "height", "--frames")
    ocean.good(*command, "1-2")
    expected = ocean.hashes(".")
    second = ocean.folder / "s.height.0002.exr"
    second.unlink()
    second.symlink_to("s.height.0001.exr")
    ocean.good(*command, "2")
    assert not second.is_symlink()
    assert ocean.hashes(".") == expected


def test_links_to_another_disk_are_written_through(ocean):
    """A farm links frames, manifests and folders."""
    bake = ("bake", "sea.toml", "--products", "height", "--frames")
    (ocean.folder / "disk").mkdir()
    ocean.good(*bake, "1", "-o", "disk/s.exr")
    before = (ocean.folder / "disk" / "s.exr").read_bytes()
    for name in ("s.exr", "s.manifest.json"):
        (ocean.folder / name).symlink_to(f"disk/{name}")
    (ocean.folder / "folder").symlink_to("disk")
    ocean.good(*bake, "7", "-o", "s.exr")
    assert (ocean.folder / "s.exr").is_symlink() and (ocean.folder / "s.manifest.json").is_symlink()
    assert (ocean.folder / "disk" / "s.exr").read_bytes() != before
    ocean.good(*bake, "7", "-o", "folder/through.exr")
    assert (ocean.folder / "folder").is_symlink() and "through.exr" in ocean.files("disk")
    (ocean.folder / "dangling.exr").symlink_to("nowhere/x.exr")
    done = ocean(*bake, "1", "-o", "dangling.exr")
    assert done.returncode == 1
    assert done.stderr.splitlines()[-1].startswith("ocean: cannot write 'dangling.exr': No such")
    assert (ocean.folder / "dangling.exr").is_symlink()


def test_a_folder_for_povray_is_made_again_from_its_own_sea(ocean):
    ocean.good("povray sea.toml -o scene")
    expected = ocean.hashes("scene")
    ocean.good("povray scene/sea.toml -o scene")
    assert ocean.hashes("scene") == expected
    ocean.good("povray sea.toml -o scene --resolution 32")
    assert "is an input of this command" in ocean.bad(
        "povray scene/sea.toml -o scene --set wind_speed=3"
    )


@pytest.mark.parametrize(
    ("name", "command"),
    [
        ("mine.png", ("foam-texture", "lace", "--size", "64", "-o", "mine.png")),
        ("mine.exr", ("foam-texture", "lace", "--size", "64", "-o", "mine.exr")),
        ("mine.png", ("spectrum", "sea.toml", "--plot", "mine.png")),
        ("mine.exr", ("bake", "sea.toml", "--stage", "h0", "-o", "mine.exr")),
    ],
)
def test_an_image_does_not_replace_a_file_of_the_user(ocean, name, command):
    path = ocean.write(name, "my own picture, or text")
    error = ocean.bad(*command)
    assert f"'{name}' exists and was not written by `ocean " in error
    assert path.read_text() == "my own picture, or text"
    path.unlink()
    ocean.good(*command)
    first = path.read_bytes()
    ocean.good(*command)  # its own is made again
    assert path.read_bytes() == first
    other = (
        ("spectrum", "sea.toml", "--plot", name)
        if "texture" in command[0]
        else ("foam-texture", "lace", "--size", "64", "-o", name)
    )
    if name.endswith(".png"):
        assert "was not written by" in ocean.bad(*other)


def test_a_plot_holds_its_sea(ocean):
    ocean.good("spectrum sea.toml --plot a.png")
    assert ocean.good("info a.png --sea-file") == ocean.good("info sea.toml --sea-file")
    ocean.good("foam-texture lace --size 64 -o b.png")
    assert "b.png: shows a foam_texture instead of a sea" in ocean.bad("info b.png")


@pytest.mark.parametrize("stem", ["a" * 251, "ü" * 125 + "x"])
def test_the_longest_names_are_written(ocean, stem):
    """255 bytes, which file systems take: temporaries and manifests have names that fit."""
    before = {*ocean.files("."), "bed.asc"}
    ocean.write("bed.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2\n3 4\n")
    ocean.good("terrain import bed.asc -o", f"{stem}.flt")
    for frame in "12":  # the second finds the manifest of the first
        ocean.good(
            *("bake", "sea.toml", "-o", f"{stem}.exr", "--products", "height", "--frames", frame)
        )
    manifest = f"{stem}.man"  # for ".manifest.json" is no place
    assert list(ocean.manifest(manifest)) == [f"{stem}.exr"]
    made = {f"{stem}{ending}" for ending in (".exr", ".flt", ".hdr", ".prj")}
    assert set(ocean.files(".")) == before | made | {manifest}
