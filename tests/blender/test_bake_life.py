# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What holds for the bake of every subject that has one: what plays is what was live, files that
are whole are kept, steps and copies play them."""

from pathlib import Path

import bpy
import numpy as np
import pytest
from libocean_addon.bake import bake_record
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
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "shot.blend"))
    return ob


def at_frames(case, ob, frames=FRAMES) -> list[dict[str, np.ndarray]]:
    found = []
    for frame in frames:
        bpy.context.scene.frame_set(frame)
        found.append(case.shown(ob))
    return found


def all_same(ones, others) -> bool:
    return all(same(one, other) for one, other in zip(ones, others, strict=True))


def files(case) -> dict[str, Path]:
    folder = Path(bpy.path.abspath(f"//ocean_bake/{case.name}"))
    return {path.name: path for path in sorted(folder.glob("*.exr"))}


def times(case) -> dict[str, int]:
    return {name: path.stat().st_mtime_ns for name, path in files(case).items()}


def bake(**arguments) -> None:
    assert bpy.ops.libocean.bake(**arguments) == {"FINISHED"}


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


def test_files_that_are_whole_are_kept_and_others_are_mended(case, shot):
    bake()
    before = times(case)
    whole = {name: path.read_bytes() for name, path in files(case).items()}
    assert len(whole) == 6 * len(shot.libocean.bake.fields.split(","))
    damage = {
        "shot.displacement.0001.exr": lambda data: data[:-1],
        "shot.displacement.0002.exr": lambda data: data[:1000],
        "shot.displacement.0003.exr": lambda _: b"",
        "shot.displacement.0004.exr": lambda _: whole["shot.displacement.0005.exr"],
        "shot.velocity.0001.exr": lambda _: whole["shot.normal.0001.exr"],
        "shot.normal.0002.exr": lambda data: data.replace(b"choppiness = 1", b"choppiness = 2"),
    }
    there = files(case)
    for name, change in damage.items():
        there[name].write_bytes(change(whole[name]))
    missing = f"shot.{case.last_field}.0005.exr"
    there[missing].with_name(f".{missing}.1-1.baking").write_bytes(b"killed")
    there[missing].unlink()
    bake()
    assert {name: path.read_bytes() for name, path in files(case).items()} == whole
    after = times(case)
    changed = {name for name in after if before[name] != after[name]}
    assert changed == {*damage, missing}
    bake(overwrite=True)
    again = times(case)
    assert all(again[name] != after[name] for name in after)


def test_a_copy_plays_the_same_bake(case, shot):
    live = at_frames(case, shot)
    bake()
    count = len(files(case))
    bpy.ops.object.duplicate()
    copy = bpy.context.object
    assert copy != shot
    for ob in (shot, copy):
        assert bake_record.shown_image(ob) is not None
        assert all_same(live, at_frames(case, ob))
    bpy.ops.libocean.free_bake(delete_files=True)
    assert all_same(live, at_frames(case, shot))
    assert len(files(case)) == count


def test_freeing_returns_to_live(case, shot):
    live = at_frames(case, shot)
    bake()
    count = len(files(case))
    assert bpy.ops.libocean.free_bake() == {"FINISHED"}
    assert all_same(live, at_frames(case, shot))
    assert len(files(case)) == count
    assert not bake_record.exists(shot) and not bpy.ops.libocean.free_bake.poll()
    assert not [image for image in bpy.data.images if image.source == "SEQUENCE"]
    bake()
    folder = bake_record.place_of(shot).path
    bpy.ops.libocean.free_bake(delete_files=True)
    assert not folder.exists()


def test_a_bake_is_undone_and_redone(case, shot):
    live = at_frames(case, shot)
    bpy.ops.ed.undo_push(message="Before")
    bake()
    bpy.ops.ed.undo_push(message="After")
    bpy.ops.ed.undo()
    assert not case.found().libocean.use_bake and not bake_record.playing(case.found())
    assert all_same(live, at_frames(case, case.found()))
    bpy.ops.ed.redo()
    assert case.found().libocean.use_bake and bake_record.playing(case.found())
    assert all_same(live, at_frames(case, case.found()))
