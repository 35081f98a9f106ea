# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Frames are drawn as what they are: those of other seas are refused, several seas are possible."""

import shutil

import pytest
from conftest import Folder, floats_of, povray, sea_text, tell

import libocean

FORMATS = ["df3", "mesh2", "height_field"]
CALM = sea_text(resolution=32, period=60.0, wind=3.0)
ROUGH = sea_text(resolution=64, period=150.0, wind=8.0)


def frames(format_):
    """Arguments of the exports, which the tests share."""
    return "--frames", "1-3", "--format", format_


def refusal(folder, name):
    """Returns the error of Ocean_Load for a frame."""
    return folder.error(f'Ocean_Load("{name}")')


@pytest.mark.parametrize("format_", FORMATS)
def test_frames_that_are_left_of_another_sea_are_refused(tmp_path, format_):
    Folder(tmp_path, ROUGH, *frames(format_))
    folder = Folder(tmp_path, CALM, "--frames", "1-2", "--format", format_, "--overwrite")
    log = refusal(folder, "sea_0003")
    assert "is frame 3 at 0.083 s of another sea" in log and "Ocean_Open" in log
    folder.run('Ocean_Load("sea_0002")\nobject { Ocean_Sheet_() }')


def test_the_same_sea_on_another_map_is_another_sea(tmp_path):
    Folder(tmp_path, CALM, "--frames", "1-2", "--resolution", "64")
    folder = Folder(tmp_path, CALM, "--frames", "1")
    assert "of another sea" in refusal(folder, "sea_0002")


@pytest.mark.parametrize("format_", FORMATS)
def test_frames_of_other_folders_and_names_are_refused(tmp_path, format_):
    other = Folder(tmp_path / "other", ROUGH, *frames(format_))
    folder = Folder(tmp_path / "own", CALM, *frames(format_))
    for path in other.path.glob("sea_0002*"):
        shutil.copy(path, folder.path)
    assert "of another sea" in refusal(folder, "sea_0002")
    for path in folder.path.glob("sea_0001*"):
        shutil.copy(path, path.with_name(path.name.replace("0001", "0007")))
    assert "is frame 1 at 0.000 s, not that of its name" in refusal(folder, "sea_0007")


@pytest.mark.parametrize("resolution", [32, 64])
def test_a_map_without_its_words_is_refused(tmp_path, resolution):
    """Another sea's density file beside the words of ours: of our size and of another."""
    other = Folder(tmp_path / "other", ROUGH.replace("= 64", f"= {resolution}", 1), *frames("df3"))
    folder = Folder(tmp_path / "own", CALM, *frames("df3"))
    shutil.copy(other.path / "sea_0001.df3", folder.path)
    assert "is not the frame that sea_0001.df3.inc tells of" in refusal(folder, "sea_0001")
    (folder.path / "sea_0001.df3.inc").unlink()
    assert "there is no sea_0001.df3.inc" in refusal(folder, "sea_0001")


@pytest.mark.parametrize("format_", FORMATS)
def test_two_seas_in_one_scene_are_each_their_own(tmp_path, format_):
    """By rays from above, after both are made; with a material, which reads the maps when it is
    rendered."""
    for name, sea in (("calm", CALM), ("rough", ROUGH)):
        Folder(tmp_path / name, sea, *frames(format_))
    places = [(7.3, 11.1), (31.0, 18.5), (52.4, 44.0)]
    seas = ("Calm", "Rough", "Calm_Again")
    probes = tell(*(f"trace({sea}, <{x}, 99, {z}>, -y).y" for sea in seas for x, z in places))
    log = povray(
        tmp_path,
        f"""#version 3.7;
#include "calm/ocean.inc"
#macro Make()
    Ocean_Load(Ocean_Frame_Name(0))
    object {{ Ocean_Sheet_() Ocean_Material("jerlov_ii") }}
#end
Ocean_Open("calm")
#declare Calm = Make()
Ocean_Open("rough")
#declare Rough = Make()
Ocean_Open("calm")
#declare Calm_Again = Make()
camera {{ location <20, 9, -9> look_at <20, 0, 20> }}
Ocean_Sun(30, 20)
object {{ Calm }}
object {{ Rough translate 60*x }}
{probes}
""",
    )
    found = floats_of(log).reshape(3, len(places))
    for heights, name in zip(found, ("calm", "rough", "calm"), strict=True):
        sea = libocean.open(tmp_path / name / "sea.toml")
        expected = sea.query(places, 0.0)[:, 2]
        # A facet of the map lies below a crest.
        assert heights == pytest.approx(expected, abs=0.03 if name == "calm" else 0.2)
    assert (found[0] == found[2]).all()
