# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What holds for every subject, shown with one of a few lines that no file of the add-on names."""

import time
import types

import bpy
import pytest
import toy_subject
from conftest import positions
from libocean_addon import handlers
from libocean_addon.bundled import libocean
from libocean_addon.shared import drafts
from toy_subject import TOY, OpenToy, ToyJob, ToyPanel


@pytest.fixture
def toy():
    with toy_subject.registered():
        yield toy_subject.add()


@pytest.fixture
def slow(monkeypatch):
    """As in a window, with a subject that takes long."""
    monkeypatch.setattr(drafts, "allowed", True)
    monkeypatch.setattr(OpenToy, "is_ready", False)
    yield
    drafts.close()


def rest() -> None:
    """Calls the timer until it has nothing more to do."""
    while (pause := drafts.step()) is not None:
        time.sleep(min(pause, 0.02))


def assert_is_slope(ob, slope: float) -> None:
    places = positions(ob)
    assert len(places) == 9
    assert places[:, 2] == pytest.approx(slope * places[:, 0])


def test_a_change_is_shown_at_once(toy):
    assert_is_slope(toy, 2.0)
    toy.libocean_toy.slope = 3.0
    assert_is_slope(toy, 3.0)


def test_a_keyframed_value_is_shown_at_its_frame(toy, scene):
    toy.libocean_toy.keyframe_insert("slope", frame=1)
    toy.libocean_toy.slope = 4.0
    toy.libocean_toy.keyframe_insert("slope", frame=2)
    scene.frame_set(1)
    assert_is_slope(toy, 2.0)
    scene.frame_set(2)
    assert_is_slope(toy, 4.0)


def test_each_frame_is_baked_as_it_is_shown(toy, scene, tmp_path):
    toy.libocean_toy.keyframe_insert("slope", frame=1)
    toy.libocean_toy.slope = 4.0
    toy.libocean_toy.keyframe_insert("slope", frame=3)
    baked = bpy.ops.libocean.bake(directory=str(tmp_path), frame_start=1, frame_end=3)
    assert baked == {"FINISHED"}
    slopes = [float((tmp_path / f"{frame}.txt").read_text()[8:]) for frame in (1, 2, 3)]
    assert slopes[0] == 2.0 and slopes[2] == 4.0 and 2.0 < slopes[1] < 4.0


def test_undo_brings_the_values_before_back(toy):
    bpy.ops.ed.undo_push(message="Before")
    toy.libocean_toy.slope = 5.0
    bpy.ops.ed.undo_push(message="After")
    bpy.ops.ed.undo()
    ob = bpy.data.objects["Toy"]
    assert ob.libocean_toy.slope == 2.0
    assert_is_slope(ob, 2.0)


def test_a_file_that_is_opened_shows_it(toy, tmp_path):
    path = str(tmp_path / "toy.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    assert_is_slope(bpy.data.objects["Toy"], 2.0)


def test_a_copy_has_images_of_its_own(toy):
    other = toy.copy()
    bpy.context.collection.objects.link(other)
    bpy.context.view_layer.update()
    other.libocean_toy.slope = 1.0
    assert_is_slope(other, 1.0)
    assert_is_slope(toy, 2.0)
    assert len({image.name for image in bpy.data.images if "heights" in image.name}) == 2


def test_a_failure_is_said_in_words_of_the_panel(toy):
    toy.libocean_toy.slope = 11.0
    assert toy.libocean_toy.problem == "Slope is too steep"
    said = []
    layout = types.SimpleNamespace(
        column=lambda **_: types.SimpleNamespace(label=lambda text, **_: said.append(text))
    )
    ToyPanel.draw(types.SimpleNamespace(layout=layout), bpy.context)
    assert " ".join(said) == toy.libocean_toy.problem
    assert_is_slope(toy, 2.0)
    toy.libocean_toy.slope = 1.0
    assert toy.libocean_toy.problem == ""


def test_a_draft_comes_before_the_whole(toy, slow):
    toy.libocean_toy.slope = 3.0
    assert drafts.is_draft(toy.name_full)
    assert_is_slope(toy, 0.0)
    rest()
    assert not drafts.is_draft(toy.name_full)
    assert_is_slope(toy, 3.0)


def test_a_render_has_the_whole(toy, slow):
    toy.libocean_toy.slope = 3.0
    handlers.complete()
    assert_is_slope(toy, 3.0)


def test_work_that_failed_is_not_begun_anew(toy, slow, monkeypatch):
    monkeypatch.setattr(ToyJob, "fault", libocean.Error("lower toy.slope", 0))
    toy.libocean_toy.slope = 3.0
    rest()
    assert toy.libocean_toy.problem == "lower Slope"
    bpy.context.view_layer.update()
    assert not drafts.is_draft(toy.name_full)
    assert toy.libocean_toy.problem == "lower Slope"
    monkeypatch.setattr(ToyJob, "fault", None)
    toy.libocean_toy.slope = 4.0
    rest()
    assert toy.libocean_toy.problem == ""
    assert_is_slope(toy, 4.0)


def test_an_object_that_is_deleted_leaves_neither_work_nor_handle(toy, slow):
    toy.libocean_toy.slope = 3.0
    name, opened = toy.name_full, TOY.opened.of(toy.name_full)
    bpy.data.objects.remove(toy)
    bpy.context.view_layer.update()
    assert not drafts.is_draft(name)
    handle = opened.handle
    handlers._data_replaced()
    assert not handle.is_open


def test_it_is_written_and_read_by_operators(toy, tmp_path):
    path = tmp_path / "toy.toml"
    assert bpy.ops.libocean.save_toy(filepath=str(path)) == {"FINISHED"}
    assert path.read_text() == "slope = 2.0"
    assert bpy.ops.libocean.load_toy(preset="7.0") == {"FINISHED"}
    assert_is_slope(toy, 7.0)
    bpy.context.view_layer.objects.active = None
    assert not bpy.ops.libocean.save_toy.poll()
