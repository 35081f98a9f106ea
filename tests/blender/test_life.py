# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What holds for every subject of subjects.py: steps, copies, files, frames, and its whole in the
background while a draft is shown."""

import threading

import bpy
import numpy as np
import pytest
import toy_subject
from conftest import (
    empty,
    failing,
    finish,
    keyed,
    meshes_in,
    opened,
    pixels,
    positions,
    push,
    rendered,
    rest,
    save,
    work_on,
)
from libocean_addon import handlers
from libocean_addon.bundled import libocean
from libocean_addon.shared import drafts, life, mesh_content, meshes
from libocean_addon.shared.mesh_content import Content
from subjects import SHOWN, SLOW, Coast, Land, Sea, same


@pytest.fixture(scope="module", autouse=True)
def toy():
    with toy_subject.registered():
        yield


@pytest.fixture(params=SHOWN, ids=str)
def case(request):
    return request.param


@pytest.fixture
def ob(case, tmp_path):
    return case.add(tmp_path)


# Steps ----------------------------------------------------------------------------


def test_each_step_is_undone_and_redone(case, ob, eye):
    push("Before")
    before = case.shown(ob)
    for step, change in case.steps.items():
        change(case.found())
        push(step)
        after = case.shown(case.found())
        assert not same(before, after), step
        bpy.ops.ed.undo()
        assert same(case.shown(case.found()), before), step
        bpy.ops.ed.redo()
        assert same(case.shown(case.found()), after), step
        bpy.ops.ed.undo()
        bpy.context.view_layer.objects.active = case.found()


def test_adding_and_deleting_are_undone_and_redone(case, tmp_path):
    push("Nothing")
    want = case.shown(case.add(tmp_path))
    push("Added")
    bpy.ops.object.delete()
    push("Deleted")
    bpy.ops.ed.undo()
    assert same(case.shown(case.found()), want)
    bpy.ops.ed.undo()
    assert not bpy.data.objects
    bpy.ops.ed.redo()
    assert same(case.shown(case.found()), want)
    case.assert_is_library(case.found())
    bpy.ops.ed.redo()
    assert case.name not in bpy.data.objects


@pytest.mark.parametrize("linked", [True, False], ids=["Alt-D", "Shift-D"])
def test_a_copy_has_a_surface_of_its_own(case, ob, linked):
    before = case.shown(ob)
    bpy.ops.object.duplicate(linked=linked)
    copy = bpy.context.object
    assert copy != ob
    shown = case.shown(copy)
    assert same(shown, before)
    for change in case.of_copy:
        change(copy)
        bpy.context.view_layer.update()
        assert same(case.shown(ob), before)
        last, shown = shown, case.shown(copy)
        assert not same(shown, last)
    case.assert_is_library(copy)


def test_keyframes_and_drivers_move_it(case, ob, scene):
    path, *values = case.keyed
    owner, _, key = path.rpartition(".")
    value_at = dict(zip((1, 11), values, strict=True))
    keyed(ob.path_resolve(owner), **{key: value_at})
    if case.driven:
        ob.driver_add(case.driven).driver.expression = "frame * 2"
    for frame in (6, 11, 1):
        scene.frame_set(frame)
        assert not case.driven or ob.path_resolve(case.driven) == pytest.approx(2.0 * frame)
        assert frame == 6 or ob.path_resolve(path) == pytest.approx(value_at[frame])
        case.assert_is_library(ob)


def test_what_the_library_refuses_is_said_and_changes_nothing(case, ob):
    refused, accepted, words = case.refused
    before = case.shown(ob)
    refused(ob)
    assert all(word in case.problem(ob) for word in words)
    assert same(case.shown(ob), before)
    accepted(ob)
    assert case.problem(ob) == ""
    case.assert_is_library(ob)


@pytest.mark.parametrize(
    ("case", "said"), [(case, said) for case in SHOWN for said in case.bad], ids=str
)
def test_a_bad_file_is_a_sentence_and_changes_nothing(case, said, tmp_path):
    ob, path = case.add(tmp_path), tmp_path / "bad.toml"
    path.write_text(case.bad[said])
    count, before = len(bpy.data.objects), case.values(ob)
    for loader in case.loaders:
        assert said in failing(getattr(bpy.ops.libocean, loader), filepath=str(path))
        nowhere = str(tmp_path / "nowhere.toml")
        assert "nowhere" in failing(getattr(bpy.ops.libocean, loader), filepath=nowhere)
    assert len(bpy.data.objects) == count and case.values(ob) == before
    case.assert_is_library(ob)


@pytest.mark.parametrize("case", [case for case in SHOWN if case.loaders], ids=str)
def test_its_file_comes_back(case, ob, tmp_path):
    case.mark(ob)
    want, path = case.shown(ob), tmp_path / "elsewhere" / "saved.toml"
    path.parent.mkdir()
    case.save(path)
    case.change(ob, 1)
    assert not same(case.shown(ob), want)
    assert getattr(bpy.ops.libocean, case.loaders[-1])(filepath=str(path)) == {"FINISHED"}
    assert same(case.shown(ob), want)
    case.assert_is_library(ob)


def test_applied_it_is_a_mesh_for_good(ob):
    want = positions(ob)
    bpy.ops.object.modifier_apply(modifier=ob.modifiers[0].name)
    assert np.array_equal(rest(ob), want)
    assert len(ob.modifiers) == 0


# Files ----------------------------------------------------------------------------


FEW = 10  # vertices along a side of a small mesh


def made_meshes(case) -> dict[str, Content]:
    """Returns the content of each mesh that the add-on made for an object."""
    ob = case.found()
    found = (part.data for part in case.row(ob).parts(ob) if meshes.is_mesh(part))
    return {mesh.name: meshes.content_as_made(mesh) for mesh in found if meshes.made_of(mesh)}


@pytest.fixture
def saved(case, ob, scene, tmp_path, monkeypatch):
    """Returns a file, without those that it was made of, and how its object looks."""
    monkeypatch.setattr(mesh_content, "_SIDE", FEW)
    scene.frame_set(5)
    case.mark(ob)
    want = case.shown(ob)
    for path in tmp_path.iterdir():
        path.unlink()
    return save(tmp_path / "saved.blend"), want


def fetch(case, path, *, link: bool):
    """Returns the object of another file in a new one."""
    empty()
    bpy.context.scene.frame_set(5)
    with bpy.data.libraries.load(str(path), link=link) as (there, into):
        into.objects = list(there.objects)
    return next(ob for ob in into.objects if ob.name == case.name), into.objects


def put_into_scene(*objects) -> None:
    for ob in objects:
        bpy.context.collection.objects.link(ob)
    bpy.context.view_layer.update()


def test_a_file_is_opened_as_it_was_saved(case, saved):
    """It holds small meshes, in the place of which whole ones are made, equal to the bit."""
    path, want = saved
    before, names = made_meshes(case), sorted(mesh.name for mesh in bpy.data.meshes)
    stored = {mesh.name: len(mesh.vertices) for mesh in meshes_in(path, *before)}
    assert all(stored[name] <= FEW**2 or not made.is_large for name, made in before.items())
    ob = opened(path, case.name)
    assert sorted(mesh.name for mesh in bpy.data.meshes) == names
    after = made_meshes(case)
    assert after.keys() == before.keys()
    for name, made in after.items():
        assert np.array_equal(made.counts, before[name].counts)
        assert np.array_equal(made.places, before[name].places)
        assert np.array_equal(made.corners, before[name].corners)
        assert same(made.layers, before[name].layers)
    assert case.problem(ob) == ""
    assert same(case.shown(ob), want)
    case.assert_is_library(ob)


@pytest.mark.parametrize("link", [True, False], ids=["linked", "appended"])
def test_an_object_of_another_file_shows_what_it_showed_there(case, saved, link):
    path, want = saved
    ob, objects = fetch(case, path, link=link)
    put_into_scene(*objects)
    part = case.linked if link else dict
    assert same(part(case.shown(ob)), part(want))


@pytest.mark.parametrize("case", [case for case in SHOWN if case.of_override], ids=str)
def test_an_override_has_a_surface_of_its_own_and_keeps_it(case, saved, tmp_path):
    path, want = saved
    ob, (*others,) = fetch(case, path, link=True)
    others.remove(ob)
    ob = ob.override_create(remap_local_usages=True)
    put_into_scene(ob, *others)
    assert same(case.linked(case.shown(ob)), case.linked(want))
    for change in case.of_override:
        change(ob)
    changed = case.shown(ob)
    assert not same(changed, want)
    case.assert_is_library(ob)
    assert same(case.shown(opened(save(tmp_path / "shot.blend"), case.name)), changed)


@pytest.mark.parametrize("case", SHOWN[:-1], ids=str)
def test_without_the_add_on_a_file_is_at_rest_until_that_comes(case, ob, tmp_path):
    """As with `blender --background FILE --addons libocean_addon --python SCRIPT`."""
    path = save(tmp_path / "saved.blend")
    bpy.ops.preferences.addon_disable(module="libocean_addon")
    try:
        ob = opened(path, case.name)
        assert np.abs(positions(ob)[:, 2]).max() == 0.0
        assert np.array_equal(positions(ob), rest(ob))
    finally:
        bpy.ops.preferences.addon_enable(module="libocean_addon")
    case.assert_is_library(ob)


@pytest.mark.parametrize("case", [Sea(), Coast(), Land()], ids=str)
def test_frames_of_a_render_have_their_own_surface(case, ob, scene, tmp_path):
    relief = case.film(ob, scene)
    scene.frame_start, scene.frame_end = 1, 2
    scene.render.filepath = str(tmp_path / "live_")
    bpy.ops.render.render(animation=True)
    seen = []
    for frame in (1, 2):
        scene.frame_set(frame)
        still = ob.copy()
        still.data = bpy.data.meshes.new_from_object(
            ob.evaluated_get(bpy.context.evaluated_depsgraph_get())
        )
        still.modifiers.clear()
        scene.collection.objects.link(still)
        ob.hide_render = True
        seen.append(pixels(tmp_path / f"live_{frame:04d}.exr"))
        assert np.array_equal(seen[-1], rendered(scene, tmp_path / "still.exr"))
        assert np.ptp(seen[-1][..., 2]) > relief
        bpy.data.objects.remove(still)
        ob.hide_render = False
    assert np.abs(seen[0] - seen[1])[..., 2].max() > 0.01


# In the background ----------------------------------------------------------------


@pytest.fixture(params=SLOW, ids=str)
def slow_case(request, waiting, monkeypatch):
    """A subject whose whole takes long, in a window in which somebody waits."""
    request.param.make_slow(monkeypatch)
    return request.param


@pytest.fixture
def slow(slow_case, scene, tmp_path):
    """Such an object, whole."""
    drafts.allowed = False
    ob = slow_case.add(tmp_path)
    scene.frame_set(5)
    drafts.allowed = True
    return ob


def test_a_new_object_is_there_at_once(slow_case, tmp_path, monkeypatch):
    monkeypatch.setattr(meshes, "DRAFT_SAMPLES", 128)
    ob = slow_case.add(tmp_path)
    assert drafts.progress(ob.name_full) == 0.0
    assert len(positions(ob)) > 0
    finish()
    assert drafts.progress(ob.name_full) is None and not meshes.is_draft(ob.data)
    slow_case.assert_is_library(ob)


def test_a_moving_value_shows_a_draft_and_then_the_whole(slow_case, slow):
    before = slow_case.shown(slow)
    for number in range(3):
        slow_case.change(slow, number)
        assert drafts.progress(slow.name_full) == 0.0
        slow_case.assert_is_draft(slow, before)
    finish()
    assert drafts.progress(slow.name_full) is None
    assert not same(slow_case.shown(slow), before)
    slow_case.assert_is_library(slow)


def test_the_next_change_stops_the_work_and_others_do_not(slow_case, slow, scene):
    slow_case.change(slow, 0)
    job = work_on()
    slow_case.change(slow, 1)
    assert job.is_cancelled()
    job.join()
    drafts.step()
    job = work_on()
    line, name = drafts.line()
    assert line.startswith(slow_case.status) and name == slow.name_full
    bpy.ops.object.empty_add()
    life.show_all(life.all_shown(), scene)  # as the handler does after any change of the scene
    assert not job.is_cancelled() and drafts.at_work()[1] is job
    finish()
    assert slow_case.problem(slow) == ""
    slow_case.assert_is_library(slow)
    slow_case.change(slow, 0)
    job = work_on()
    bpy.data.objects.remove(slow)
    bpy.context.view_layer.update()
    assert job.is_cancelled()
    finish()
    assert drafts.at_work() is None and drafts.line() == ("", "")


def test_work_is_stopped_and_finished_by_its_buttons(slow_case, slow, scene):
    slow_case.change(slow, 0)
    draft, name = slow_case.shown(slow), slow.name_full
    assert bpy.ops.libocean.stop_draft(name=name) == {"FINISHED"}
    assert drafts.step() == 0.25 and drafts.at_work() is None  # it waits, and does nothing
    assert drafts.is_stopped(name) and same(slow_case.shown(slow), draft)
    assert bpy.ops.libocean.finish_draft(name=name) == {"FINISHED"}
    job = work_on()
    assert bpy.ops.libocean.stop_draft(name=name) == {"FINISHED"}
    job.join()
    drafts.step()
    life.show_all(life.all_shown(), scene)  # without a change it stays stopped
    assert drafts.is_stopped(name) and drafts.progress(name) is None
    assert same(slow_case.shown(slow), draft)
    bpy.ops.libocean.finish_draft(name=name)
    finish()
    assert not drafts.is_draft(name)
    slow_case.assert_is_library(slow)


def test_a_render_holds_no_draft_or_says_so(slow_case, slow, scene, monkeypatch, capsys):
    slow_case.change(slow, 0)
    assert drafts.is_draft(slow.name_full)
    monkeypatch.setattr(drafts, "_PATIENCE", 0.05)  # for a timer, of which there is none
    render = threading.Thread(target=handlers.complete)
    render.start()
    render.join()
    assert f"the render shows a draft of the {slow_case.word}\n" in capsys.readouterr().out
    work_on()
    bpy.ops.libocean.stop_draft(name=slow.name_full)
    handlers.complete()
    slow_case.assert_is_library(slow)
    slow_case.change(slow, 1)
    life.show_all(life.all_shown(), scene, rendering=True, passing=True)
    slow_case.assert_is_library(slow)
    if slow_case.moves:
        slow_case.change(slow, 2)
        work_on()
        scene.frame_set(7)  # as a render of the viewport goes through the frames
        slow_case.assert_is_library(slow)


def test_undo_in_a_draft_brings_the_surface_back(slow_case, slow):
    want = slow_case.shown(slow)
    push("Before")
    slow_case.change(slow, 0)
    push("After")
    bpy.ops.ed.undo()
    finish()
    assert same(slow_case.shown(slow_case.found()), want)
    slow_case.assert_is_library(slow_case.found())


def test_a_file_that_is_saved_meanwhile_opens_whole(slow_case, slow, tmp_path):
    slow_case.change(slow, 0)
    work_on()
    path = save(tmp_path / "saved.blend")
    finish()
    want = slow_case.shown(slow)
    ob = opened(path, slow_case.name)
    finish()
    assert same(slow_case.shown(ob), want)
    slow_case.assert_is_library(ob)
    slow_case.change(ob, 1)
    bpy.ops.libocean.stop_draft(name=ob.name_full)
    assert drafts.is_stopped(ob.name_full)
    ob = opened(save(path), slow_case.name)
    assert drafts.progress(ob.name_full) is not None  # it is not stopped
    finish()
    slow_case.assert_is_library(ob)


SHORT = "There is not enough memory: choose fewer samples"
LONG = "a map needs 900 MiB of memory, 300 MiB are available; lower {}"
FAILURES = (
    (MemoryError, ("of arrays",), SHORT),
    (libocean.OutOfMemoryError, ("out of memory", 7), SHORT),
    (libocean.OutOfMemoryError, (LONG, 7), LONG),
    (libocean.Error, ("lower {}", 0), "lower {}"),
)


def test_a_failure_in_the_background_is_said_in_the_words_of_the_panel(
    slow_case, slow, monkeypatch
):
    for number, (failure, (text, *numbers), sentence) in enumerate(FAILURES):
        raised = failure(text.format(slow_case.parameter), *numbers)
        sentence = sentence.format(slow_case.label)

        def fail(_job, raised=raised):
            raise raised

        with monkeypatch.context() as patch:
            patch.setattr(slow_case.job, "work", fail)
            slow_case.change(slow, number)
            finish()
        assert slow_case.problem(slow) == sentence
        bpy.context.view_layer.update()  # does not begin the work anew
        assert slow_case.problem(slow) == sentence
        assert not drafts.is_draft(slow.name_full)
    refused, accepted, words = slow_case.refused
    refused(slow)
    finish()
    assert all(word in slow_case.problem(slow) for word in words)
    assert not drafts.is_draft(slow.name_full)
    accepted(slow)
    slow_case.change(slow, len(FAILURES))
    assert drafts.is_draft(slow.name_full)
    finish()
    assert slow_case.problem(slow) == ""
    slow_case.assert_is_library(slow)
