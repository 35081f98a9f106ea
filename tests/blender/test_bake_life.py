# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What holds for the bake of every subject that has one: what plays is what was live, here and
without the add-on; the files are those of the command; files that are whole are kept, steps and
copies play them."""

import os
import shutil
import subprocess
from pathlib import Path

import bpy
import numpy as np
import pytest
from conftest import assert_shown_without_the_add_on, keyed, opened, push, read_exr, save, times
from libocean_addon.bake import bake_record, bake_state
from libocean_addon.shared import mesh_content
from subjects import BAKED, same

FRAMES = (1, 2, 4)


@pytest.fixture(params=BAKED, ids=str)
def case(request):
    return request.param


@pytest.fixture
def shot(case, scene, tmp_path):
    """An object in a saved file, with all that a bake has, for six frames with their handles."""
    ob = case.add(tmp_path)
    case.prepare_bake(ob)
    scene.frame_start, scene.frame_end = 1, 4
    save(tmp_path / "shot.blend")
    return ob


@pytest.fixture
def folder(case, tmp_path):
    return tmp_path / "ocean_bake" / case.name


def at_frames(case, ob, frames=FRAMES) -> list[dict[str, np.ndarray]]:
    found = []
    for frame in frames:
        bpy.context.scene.frame_set(frame)
        found.append(case.shown(ob))
    return found


def all_same(ones, others) -> bool:
    return all(same(one, other) for one, other in zip(ones, others, strict=True))


def bake(**arguments) -> None:
    assert bpy.ops.libocean.bake(**arguments) == {"FINISHED"}


def said(ob) -> str:
    """Returns what the panel says of a bake."""
    return "\n".join(text for text, _ in bake_state.state(ob, bpy.context.scene))


def test_a_bake_plays_what_was_live(case, shot, scene):
    live = at_frames(case, shot)
    first, last = at_frames(case, shot, (0, 5))
    assert not np.array_equal(live[0]["positions"], live[2]["positions"])
    scene.frame_set(3)
    bake()
    assert scene.frame_current == 3
    assert shot.libocean.use_bake and bake_record.playing(shot)
    assert all_same(live, at_frames(case, shot))
    beyond = at_frames(case, shot, (-3, 40))  # where it stands still
    assert all_same((first, last), beyond)
    shot.libocean.use_bake = False
    assert not bake_record.playing(shot)
    assert all_same(live, at_frames(case, shot))
    shot.libocean.seed = 7
    assert not all_same(live, at_frames(case, shot))
    shot.libocean.use_bake = True
    assert all_same(live, at_frames(case, shot))


@pytest.mark.skipif("OCEAN" not in os.environ, reason="OCEAN is not the path of the program")
def test_the_files_are_those_of_ocean_bake(case, shot, scene, folder, tmp_path):
    shot.libocean.start = 100000.0
    scene.render.fps, scene.render.fps_base = 30, 1.001
    shot.libocean.use_detail = case.has_detail
    bake()
    case.save(tmp_path / "panel.toml")
    fields = shot.libocean.bake.fields.split(",")
    products = {name.rstrip("123") for name in fields}
    subprocess.run(
        [Path(os.environ["OCEAN"]).resolve(), "-q", "bake", "panel.toml"]
        + ["-o", "there/shot.####.exr", "--frames", "0-5"]
        + ["--type", "float", "--products", ",".join(sorted(products)), *case.command],
        cwd=tmp_path,
        check=True,
    )
    theirs = sorted((tmp_path / "there").glob("*.exr"))
    assert len(theirs) == 6 * len(fields)
    assert [path.name for path in theirs] == sorted(path.name for path in folder.iterdir())
    for path in theirs:
        (header, planes), (our_header, ours) = read_exr(path), read_exr(folder / path.name)
        assert our_header | case.unlike == header | case.unlike and ours.keys() == planes.keys()
        for name, values in planes.items():
            assert np.abs(ours[name] - values).max() <= case.tolerance, (path.name, name)


def test_files_that_are_whole_are_kept_and_others_are_mended(case, shot, folder):
    bake()
    before = times(folder)
    whole = {path.name: path.read_bytes() for path in folder.iterdir()}
    assert len(whole) == 6 * len(shot.libocean.bake.fields.split(","))
    damage = {
        "shot.displacement.0001.exr": lambda data: data[:-1],
        "shot.displacement.0002.exr": lambda data: data[:1000],
        "shot.displacement.0003.exr": lambda _: b"",
        "shot.displacement.0004.exr": lambda _: whole["shot.displacement.0005.exr"],
        "shot.velocity.0001.exr": lambda _: whole["shot.normal.0001.exr"],
        "shot.normal.0002.exr": lambda data: data.replace(b"choppiness = 1", b"choppiness = 2"),
    }
    for name, change in damage.items():
        (folder / name).write_bytes(change(whole[name]))
    missing = f"shot.{case.last_field}.0005.exr"
    (folder / f".{missing}.1-1.baking").write_bytes(b"killed")
    (folder / missing).unlink()
    bake()
    assert {path.name: path.read_bytes() for path in folder.glob("*.exr")} == whole
    after = times(folder)
    assert {name for name in before if before[name] != after[name]} == {*damage, missing}
    bake(overwrite=True)
    again = times(folder)
    assert all(again[name] != after[name] for name in before)


def test_a_stopped_bake_keeps_what_is_finished_and_goes_on(case, shot, folder):
    work = case.row(shot).bake(bpy.context, shot, "", (1, 4), overwrite=False)
    work.job.run(lambda: work.job.stop.set() if work.job.done == 2 else None)
    assert work.job.done == 2 and not shot.libocean.use_bake
    finished = times(folder)
    assert {name.split(".")[2] for name in finished} == {"0000", "0001"}
    bake()
    fields = len(shot.libocean.bake.fields.split(","))
    after = times(folder)
    assert (len(finished), len(after)) == (2 * fields, 6 * fields)
    assert {name: after[name] for name in finished} == finished


def test_another_surface_is_baked_over_it(case, shot, folder):
    bake()
    before = times(folder)
    at_frames(case, shot)
    case.change(shot, 1)
    assert "another sea" in said(shot)
    bake()
    after = times(folder)
    assert all(before[name] != after[name] for name in before)
    baked = at_frames(case, shot)
    shot.libocean.use_bake = False
    assert all_same(baked, at_frames(case, shot))


def test_a_keyframed_surface_is_baked_frame_by_frame(case, shot, scene):
    path, first, last = case.keyed
    owner, _, name = path.rpartition(".")
    keyed(shot.path_resolve(owner), **{name: {1: first, 4: last}})

    def seen() -> list[dict[str, np.ndarray]]:
        # Foam is made of cover by the first frame's power.
        return [{**shown, "foam": None} for shown in at_frames(case, shot)]

    live = seen()
    scene.frame_set(3, subframe=0.5)
    bake()
    assert scene.frame_current_final == 3.5
    assert all_same(live, seen())
    for frame in (1, 3):
        scene.frame_set(frame)
        assert "another sea" not in said(shot)
    shot.libocean.seed = 5
    assert "another sea" in said(shot)


def test_the_panel_says_what_is_baked(case, shot, scene):
    assert "Frames 0 to 5 of {} x {} samples".format(*case.samples) in said(shot)
    bake()
    assert "6 of 6 frames" in said(shot) and "another sea" not in said(shot)
    shot.libocean.choppiness = 0.75
    assert "another sea" in said(shot)
    shot.libocean.choppiness = 1.0
    assert "another sea" not in said(shot)
    scene.frame_end = 9
    assert "stands still" in said(shot)
    scene.render.fps = 25
    assert "another sea" in said(shot)


def test_a_copy_plays_the_same_bake(case, shot, folder):
    live = at_frames(case, shot)
    bake()
    before = times(folder)
    bpy.ops.object.duplicate()
    copy = bpy.context.object
    assert copy != shot
    for ob in (shot, copy):
        assert bake_record.shown_image(ob) is not None
        assert all_same(live, at_frames(case, ob))
    bpy.ops.libocean.free_bake(delete_files=True)
    assert all_same(live, at_frames(case, shot))
    assert times(folder) == before


def test_freeing_returns_to_live(case, shot, folder):
    live = at_frames(case, shot)
    bake()
    before = times(folder)
    assert bpy.ops.libocean.free_bake() == {"FINISHED"}
    assert all_same(live, at_frames(case, shot))
    assert times(folder) == before
    assert not bake_record.exists(shot) and not bpy.ops.libocean.free_bake.poll()
    assert not [image for image in bpy.data.images if image.source == "SEQUENCE"]
    bake()
    other = folder / "notes.txt"
    other.write_text("of the user")
    bpy.ops.libocean.free_bake(delete_files=True)
    assert list(folder.iterdir()) == [other]
    other.unlink()
    bake()
    bpy.ops.libocean.free_bake(delete_files=True)
    assert not folder.exists()


def test_a_bake_is_undone_and_redone(case, shot):
    live = at_frames(case, shot)
    push("Before")
    bake()
    push("After")
    bpy.ops.ed.undo()
    assert not case.found().libocean.use_bake and not bake_record.playing(case.found())
    assert all_same(live, at_frames(case, case.found()))
    bpy.ops.ed.redo()
    assert case.found().libocean.use_bake and bake_record.playing(case.found())
    assert all_same(live, at_frames(case, case.found()))


def test_in_another_folder_it_plays_with_and_without_the_add_on(case, shot, tmp_path, monkeypatch):
    monkeypatch.setattr(mesh_content, "_SIDE", 10)  # of a live one
    live = at_frames(case, shot)
    bake()
    bpy.ops.wm.save_mainfile()
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    for name in ("ocean_bake", "shot.blend"):
        shutil.move(tmp_path / name, elsewhere)
    wanted = {
        (ob, value, frame): shown[key]
        for frame, shown in zip(FRAMES, live, strict=True)
        for key, (ob, value) in case.without.items()
    }
    assert_shown_without_the_add_on(
        elsewhere / "shot.blend", wanted, PATH="", LIBOCEAN_LIBRARY="none"
    )
    ob = opened(elsewhere / "shot.blend", case.name)
    assert all_same(live, at_frames(case, ob))
    ob.libocean.use_bake = False
    assert all_same(live, at_frames(case, ob))
