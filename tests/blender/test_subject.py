# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A subject of a few lines that no file of the add-on names has what every subject has. Its life is
in test_life.py."""

import types

import bpy
import pytest
import toy_subject
from conftest import keyed, positions
from libocean_addon import handlers
from toy_subject import TOY, toy_panel


@pytest.fixture
def toy():
    with toy_subject.registered():
        yield toy_subject.add()


def assert_is_slope(ob, slope: float) -> None:
    places = positions(ob)
    assert len(places) == 9
    assert places[:, 2] == pytest.approx(slope * places[:, 0])


def test_each_frame_is_baked_as_it_is_shown(toy, scene, tmp_path):
    keyed(toy.libocean_toy, slope={1: 2.0, 3: 4.0})
    baked = bpy.ops.libocean.bake(directory=str(tmp_path), frame_start=1, frame_end=3)
    assert baked == {"FINISHED"}
    slopes = [float((tmp_path / f"{frame}.txt").read_text()[8:]) for frame in (1, 2, 3)]
    assert slopes[0] == 2.0 and slopes[2] == 4.0 and 2.0 < slopes[1] < 4.0


def test_a_failure_is_said_in_words_of_the_panel(toy):
    toy.libocean_toy.slope = 11.0
    assert toy.libocean_toy.problem == "Slope is too steep"
    said = []
    layout = types.SimpleNamespace(
        column=lambda **_: types.SimpleNamespace(label=lambda text, **_: said.append(text))
    )
    toy_panel.draw(types.SimpleNamespace(layout=layout), bpy.context)
    assert " ".join(said) == toy.libocean_toy.problem


def test_an_object_that_is_deleted_leaves_no_handle(toy):
    handle = TOY.opened.of(toy.name_full).handle
    bpy.data.objects.remove(toy)
    bpy.context.view_layer.update()
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
