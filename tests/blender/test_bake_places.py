# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where bakes and volumes go: no sea is written over that another blend file, or another object,
plays."""

import os
import shutil
from pathlib import Path

import bpy
import numpy as np
import pytest
from conftest import add_ocean, empty, failing, opened, positions, save, times
from libocean_addon.bake import bake_record, bake_state
from libocean_addon.sea import parameter_values
from libocean_addon.shared import paths


def small(wind: float, frames=(2, 2)):
    """A sea without foam, of few samples, in the open file."""
    sea = {"waves.0.wind_speed": wind, "patch_size": 100.0}
    ob = add_ocean(32, sea=sea, kind="PATCH", preset="beaufort_6", use_material=False)
    ob.libocean.use_foam = ob.libocean.use_velocity = ob.libocean.use_normal = False
    bpy.context.scene.frame_start, bpy.context.scene.frame_end = frames
    return ob


def shown(ob) -> np.ndarray:
    bpy.context.scene.frame_set(2)
    return positions(ob).copy()


def files(folder: Path) -> set[str]:
    """Paths below a folder, without frames."""
    found = (path.relative_to(folder) for path in folder.rglob("*.exr"))
    return {str(path).rsplit(".", 2)[0] for path in found}


def texts(ob) -> list[str]:
    return bake_state.faults(ob)


# Blend files in one folder ------------------------------------------------------


@pytest.mark.parametrize("names", [("shot_020", "shot_010"), ("shöt 1.v2", "shöt 1.v1")])
@pytest.mark.parametrize("asked", ["", "absolute"])
def test_two_files_in_one_folder_keep_their_seas(tmp_path, names, asked):
    """The first is a storm, the second a calm; each shows its own when it is opened again."""
    asked = str(tmp_path / "cache") if asked == "absolute" else asked
    baked = []
    for name, wind in zip(names, (20.0, 6.0), strict=True):
        empty()
        ob = small(wind)
        ob.libocean.bake.directory = asked
        save(tmp_path / f"{name}.blend")
        assert bpy.ops.libocean.bake() == {"FINISHED"}
        save(tmp_path / f"{name}.blend")
        baked.append(shown(ob))
    assert 4 * baked[0][:, 2].std() > 1.5 * 4 * baked[1][:, 2].std() > 0.1
    place = "cache" if asked else "ocean_bake/Ocean"
    assert files(tmp_path) == {f"{place}/{name}.displacement" for name in names}
    for name, mesh in zip(names, baked, strict=True):
        ob = opened(tmp_path / f"{name}.blend", "Ocean")
        assert np.array_equal(shown(ob), mesh)
        assert texts(ob) == []


def test_saved_as_another_version_it_plays_on_and_is_baked_apart(tmp_path):
    """The bake keeps its files; another sea never goes where shot_v001 plays."""
    ob = small(14.0)
    save(tmp_path / "shot_v001.blend")
    bpy.ops.libocean.bake()
    save(tmp_path / "shot_v001.blend")
    first = shown(ob)
    save(tmp_path / "shot_v002.blend")
    assert np.array_equal(shown(ob), first)
    bpy.ops.libocean.bake(frame_end=3)  # the same sea goes on where it is
    assert files(tmp_path) == {"ocean_bake/Ocean/shot_v001.displacement"}
    ob.libocean.choppiness = 0.5
    bpy.ops.libocean.bake()
    assert bake_record.place_of(ob).stem == "shot_v002"
    save(tmp_path / "shot_v002.blend")
    second = shown(ob)
    assert not np.array_equal(second, first)
    assert np.array_equal(shown(opened(tmp_path / "shot_v001.blend", "Ocean")), first)
    assert np.array_equal(shown(opened(tmp_path / "shot_v002.blend", "Ocean")), second)


def test_the_files_move_with_the_blend_file(tmp_path):
    ob = small(14.0)
    save(tmp_path / "first" / "a.b c.blend")
    bpy.ops.libocean.bake()
    save(tmp_path / "first" / "a.b c.blend")
    want = shown(ob)
    (tmp_path / "first").rename(tmp_path / "second")
    ob = opened(tmp_path / "second" / "a.b c.blend", "Ocean")
    assert np.array_equal(shown(ob), want)
    assert texts(ob) == []
    # On a system that renames it, the bake is still found.
    shutil.move(tmp_path / "second" / "a.b c.blend", tmp_path / "second" / "other.blend")
    ob = opened(tmp_path / "second" / "other.blend", "Ocean")
    assert np.array_equal(shown(ob), want) and texts(ob) == []


def test_an_appended_object_plays_its_bake_and_is_baked_apart(tmp_path):
    ob = small(14.0)
    save(tmp_path / "shot_010.blend")
    bpy.ops.libocean.bake()
    save(tmp_path / "shot_010.blend")
    want = shown(ob)
    empty()
    save(tmp_path / "elsewhere" / "shot_020.blend")
    with bpy.data.libraries.load(str(tmp_path / "shot_010.blend")) as (_, into):
        into.objects = ["Ocean"]
    ob = into.objects[0]
    bpy.context.collection.objects.link(ob)
    bpy.context.view_layer.objects.active = ob
    assert np.array_equal(shown(ob), want)
    assert texts(ob) == []
    ob.libocean.choppiness = 0.5
    bpy.ops.libocean.bake(frame_start=2, frame_end=2)
    assert files(tmp_path / "elsewhere") == {"ocean_bake/Ocean/shot_020.displacement"}
    assert np.array_equal(shown(opened(tmp_path / "shot_010.blend", "Ocean")), want)


def test_another_files_sea_in_a_chosen_folder_is_not_written_over(tmp_path):
    """Two files of one name, as of two shots, with one folder for both."""
    cache = str(tmp_path / "cache")
    ob = small(20.0)
    save(tmp_path / "020" / "light.blend")
    bpy.ops.libocean.bake(directory=cache)
    want = shown(ob)
    save(tmp_path / "020" / "light.blend")
    empty()
    ob = small(6.0)
    save(tmp_path / "010" / "light.blend")
    with pytest.raises(RuntimeError, match="holds another sea.* at the frames 1-3"):
        bpy.ops.libocean.bake(directory=cache)
    assert not ob.libocean.use_bake
    assert np.array_equal(shown(opened(tmp_path / "020" / "light.blend", "Ocean")), want)
    # Its own files it may write over, also where a bake was interrupted.
    ob = bpy.data.objects["Ocean"]
    ob.libocean.choppiness = 0.5
    assert bpy.ops.libocean.bake(directory=cache) == {"FINISHED"}
    assert texts(ob) == []
    # The first one, still open elsewhere, would not play them without a word.
    empty()
    ob = opened(tmp_path / "020" / "light.blend", "Ocean")
    assert [f"show another sea, of the frames 1-3 ({cache}" in text for text in texts(ob)] == [True]
    bpy.ops.libocean.free_bake(delete_files=True)
    assert len(list(Path(cache).iterdir())) == 3


def test_a_bake_of_an_earlier_version_keeps_its_files(tmp_path):
    """They begin with `sea`, and their object has neither marks nor a name for them."""
    ob = small(14.0)
    save(tmp_path / "shot.blend")
    bpy.ops.libocean.bake()
    want = shown(ob)
    folder = tmp_path / "ocean_bake" / "Ocean"
    for path in folder.iterdir():
        path.rename(folder / path.name.replace("shot.", "sea."))
    record = ob.libocean.bake
    for image in bpy.data.images:
        image.filepath = image.filepath.replace("shot.disp", "sea.disp")
    record.property_unset("stem")
    record.property_unset("marks")
    save(tmp_path / "shot.blend")
    ob = opened(tmp_path / "shot.blend", "Ocean")
    assert np.array_equal(shown(ob), want)
    assert texts(ob) == []
    before = times(folder)
    bpy.ops.libocean.bake(frame_end=3)  # the same sea goes on
    after = times(folder)
    assert {name: after[name] for name in before} == before
    assert set(after) - set(before) == {"sea.displacement.0004.exr"}
    ob.libocean.choppiness = 0.5  # another one: these files may be those of another blend file
    bpy.ops.libocean.bake()
    assert bake_record.place_of(ob).stem == "shot"
    assert before.items() <= times(folder).items()


# Objects of one file ------------------------------------------------------------


def test_a_copy_that_is_changed_is_baked_apart(tmp_path):
    ob = small(14.0)
    save(tmp_path / "shot.blend")
    bpy.ops.libocean.bake()
    want = shown(ob)
    bpy.ops.object.duplicate()
    copy = bpy.context.object
    assert np.array_equal(shown(copy), want)
    copy.libocean.choppiness = 0.25
    bpy.ops.libocean.bake()
    assert np.array_equal(shown(ob), want) and not np.array_equal(shown(copy), want)
    assert texts(ob) == texts(copy) == []
    # The original too, while a copy plays the same files.
    bpy.ops.object.select_all(action="DESELECT")
    bpy.context.view_layer.objects.active = ob
    ob.select_set(True)
    bpy.ops.object.duplicate()
    second, theirs = bpy.context.object, shown(bpy.context.object)
    bpy.context.view_layer.objects.active = ob
    ob.libocean.choppiness = 0.75
    bpy.ops.libocean.bake()
    assert np.array_equal(shown(second), theirs)
    assert texts(ob) == texts(second) == []


@pytest.mark.parametrize("names", [("Sea 1", "Sea_1"), ("Ocean", "Ocean")])
def test_objects_whose_names_make_one_folder_have_two(tmp_path, names):
    """The second pair: the first was given another name after its bake."""
    one = small(14.0)
    one.name = names[0]
    save(tmp_path / "shot.blend")
    bpy.ops.libocean.bake()
    want = shown(one)
    if names[0] == names[1]:
        one.name = "Atlantic"
    other = small(6.0)
    other.name = names[1]
    bpy.ops.libocean.bake()
    assert other.name == names[1]
    assert np.array_equal(shown(one), want) and not np.array_equal(shown(other), want)
    folder = bpy.path.clean_name(names[1])
    assert {path.name for path in (tmp_path / "ocean_bake").iterdir()} == {folder, f"{folder}_2"}


# Paths --------------------------------------------------------------------------


@pytest.mark.parametrize(
    "asked", ["//bakes\\sea\\", "//bakes\\sea", "//bakes/sea/", "//.\\bakes\\x\\..\\sea"]
)
def test_backslashes_of_a_relative_path_part_folders(tmp_path, asked):
    ob = small(14.0)
    save(tmp_path / "shot.blend")
    ob.libocean.bake.directory = asked
    live = shown(ob)
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    assert files(tmp_path) == {os.path.join("bakes", "sea", "shot.displacement")}
    assert np.array_equal(shown(ob), live)
    assert ob.libocean.bake.folder.startswith("//") and "\\" not in ob.libocean.bake.folder
    save(tmp_path / "shot.blend")
    assert np.array_equal(shown(opened(tmp_path / "shot.blend", "Ocean")), live)


@pytest.mark.skipif(os.name == "nt", reason="they lead somewhere in Windows")
@pytest.mark.parametrize("asked", ["C:\\bakes\\sea", "\\\\server\\share\\sea"])
def test_a_path_of_windows_is_refused_elsewhere(tmp_path, monkeypatch, asked):
    monkeypatch.chdir(tmp_path)
    small(14.0)
    save(tmp_path / "shot.blend")
    assert "is a path of Windows" in failing(bpy.ops.libocean.bake, directory=asked)
    assert files(tmp_path) == set()


@pytest.mark.only_reads
def test_paths_are_those_of_their_system():
    assert paths.normal("//a\\b/c") == "//a/b/c"
    assert paths.normal("a\\b") == "a/b"
    for kept in ("C:\\a\\b", "C:/a\\b", "\\\\server\\share\\a"):
        assert paths.normal(kept) == kept
    if os.name != "nt":
        assert paths.normal("/a/b\\c") == "/a/b\\c"  # a name may hold one


def test_a_measured_file_is_found_behind_backslashes(tmp_path):
    ob = small(14.0)
    save(tmp_path / "shot.blend")
    (waves,) = ob.libocean.waves
    waves.file = "//buoys\\n1.csv"
    values = parameter_values.values_of(ob.libocean)
    assert values.waves[0].values["file"] == str(tmp_path / "buoys" / "n1.csv")


# Volumes ------------------------------------------------------------------------


def volumes_of(folder: Path) -> set[str]:
    return {path.name for path in (folder / "ocean_volumes").glob("*.vdb")}


def test_volumes_of_two_files_in_one_folder_lie_apart(tmp_path, scripted_volumes):
    for name in ("shot_020", "shot.010"):
        empty()
        small(14.0)
        save(tmp_path / f"{name}.blend")
        assert bpy.ops.libocean.write_volumes() == {"FINISHED"}
        (volume,) = bpy.data.volumes
        assert bpy.path.abspath(volume.filepath) == str(
            tmp_path / "ocean_volumes" / f"{name}.Ocean_0002.vdb"
        )
    assert volumes_of(tmp_path) == {"shot_020.Ocean_0002.vdb", "shot.010.Ocean_0002.vdb"}
    # Saved as another version and written again, the object that shows them shows the new ones.
    save(tmp_path / "v2.blend")
    bpy.ops.libocean.write_volumes()
    (volume,) = bpy.data.volumes
    assert "v2.Ocean_0002" in volume.filepath
    assert len(volumes_of(tmp_path)) == 3


def test_volumes_of_objects_of_like_names_lie_apart(tmp_path, scripted_volumes):
    save(tmp_path / "shot.blend")
    for name in ("Sea 1", "Sea_1"):
        small(14.0).name = name
        bpy.ops.libocean.write_volumes()
    assert volumes_of(tmp_path) == {"shot.Sea_1_0002.vdb", "shot.Sea_1_2_0002.vdb"}
    assert len(bpy.data.volumes) == 2


def test_volumes_of_another_sea_in_a_chosen_folder_stay(tmp_path, scripted_volumes):
    folder = str(tmp_path / "ocean_volumes")
    for number in ("010", "020"):
        empty()
        ob = small(float(number))
        save(tmp_path / number / "fx.blend")
        ob.libocean.volumes.directory = folder
        if number == "010":
            bpy.ops.libocean.write_volumes()
            ob.libocean.choppiness = 0.5  # its own it may write over
            bpy.ops.libocean.write_volumes()
        else:
            with pytest.raises(RuntimeError, match="holds another sea.* at the frames 2:"):
                bpy.ops.libocean.write_volumes()
            assert bpy.ops.libocean.write_volumes(overwrite=True) == {"FINISHED"}
