# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Files of a version that knew the first keys alone are this version's own: a key that came later
is in no text, no id and no header of a sea that does not use it."""

import json
import shutil

import pytest
from conftest import DATA

OLD = DATA / "first_keys"
BAKES = {
    "exr": ["--frames", "3-4", "--products", "displacement,foam"],
    "ply": ["--frames", "3"],
}


@pytest.fixture
def old(ocean):
    shutil.copytree(OLD, ocean.folder, dirs_exist_ok=True)
    return ocean


def frames_in(ocean, folder: str) -> dict[str, str]:
    """The hashes of a folder's files but for the manifest."""
    return {name: text for name, text in ocean.hashes(folder).items() if "manifest" not in name}


def sea_of(content: bytes) -> bytes:
    """The attribute ocean:sea of an EXR file: its name, its type, its length and the text."""
    mark = b"ocean:sea\0string\0"
    at = content.index(mark) + len(mark)
    length = int.from_bytes(content[at : at + 4], "little")
    return content[at + 4 : at + 4 + length]


@pytest.mark.parametrize("is_listed", [True, False], ids=["listed", "unlisted"])
def test_old_bakes_are_kept(old, is_listed):
    if not is_listed:
        (old.folder / "bake/s.manifest.json").unlink()
    before = frames_in(old, "bake")
    bake = ["bake", "sea.toml", "-o", "bake/s.####.exr", *BAKES["exr"]]
    done = old(*bake, "--skip-existing", "--json")
    assert done.returncode == 0, done.stderr
    last = json.loads(done.stderr.splitlines()[-1])
    assert last["skipped"] == last["done"] > 0
    assert frames_in(old, "bake") == before


def test_an_old_mesh_is_baked_again_for_its_uv(old):
    bake = ["bake", "sea.toml", "-o", "bake/s.####.ply", *BAKES["ply"]]
    mesh = old.folder / "bake/s.0003.ply"
    assert b"property float s\n" not in mesh.read_bytes()
    old.good(*bake, "--skip-existing")
    assert b"property float s\n" in mesh.read_bytes()


def test_the_text_of_their_sea_is_the_same_to_the_byte(old):
    old.good("bake sea.toml -o new/s.####.exr", *BAKES["exr"])
    names = [name for name in old.files("bake") if name.endswith(".exr")]
    assert len(names) == 4
    for name in names:
        text = sea_of((old.folder / "bake" / name).read_bytes())
        assert text.startswith(b"# A sea, for libocean.")
        assert sea_of((old.folder / "new" / name).read_bytes()) == text


def test_their_sea_is_read_from_them(old):
    sea = json.loads(old.good("info sea.toml --json"))
    for name in ["bake/s.displacement.0003.exr", "bake/s.0003.ply"]:
        again = json.loads(old.good("info", name, "--json"))
        assert again["significant_wave_height"] == sea["significant_wave_height"]
        assert again["peak_period"] == sea["peak_period"]
    # Its take too: what a frame baked of it shows is what the sea file makes.
    old.good("bake bake/s.foam.0004.exr -o of_bake/s.####.exr", *BAKES["exr"])
    old.good("bake sea.toml -o of_sea/s.####.exr", *BAKES["exr"])
    assert frames_in(old, "of_bake") == frames_in(old, "of_sea")


def test_their_take_is_read(old):
    assert "2 changes from 0.05 to 0.1 s" in old.good("info sea.toml")
