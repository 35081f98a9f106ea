# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""While values of a coast move, one handle of the library serves, in a thread of its own; new water
comes before the past of its foam."""

import threading

import bpy
import numpy as np
import pytest
from conftest import finish, positions, work_on
from libocean_addon.bundled import libocean
from libocean_addon.coast import coast_job, node_group, open_coast
from libocean_addon.shared import drafts, modifier_groups
from test_coast import COLUMNS, ROWS, add_coast, assert_is_bed, assert_is_sea


@pytest.fixture
def calls(monkeypatch):
    """The threads of the calls of the library, and the seas that it opens. The time of a frame is
    left out, for which a coast has a handle that no job holds."""
    threads = []

    def noting(call):
        def noted(*arguments, **options):
            if "ocean_time_of_frame" not in arguments:
                threads.append(threading.current_thread())
            return call(*arguments, **options)

        return noted

    for name in ("_call", "_text"):
        monkeypatch.setattr(libocean.Sea, name, noting(getattr(libocean.Sea, name)))
    monkeypatch.setattr(libocean, "parse", noting(libocean.parse))
    return threads


SLIDES = {
    "wind": lambda ob, x: setattr(ob.libocean.waves[0], "wind_speed", 5.0 + x),
    "direction": lambda ob, x: setattr(ob.libocean.waves[0], "wind_direction", 20.0 + 5.0 * x),
    "level": lambda ob, x: setattr(ob.libocean, "level", 0.5 + 0.1 * x),
    "foam": lambda ob, x: setattr(ob.libocean, "surf_foam_lifetime", 2.0 + x),
}


@pytest.mark.parametrize("name", SLIDES)
def test_nothing_that_slides_has_the_main_thread_wait(
    coast,
    waiting,
    slow,
    calls,
    name,
):
    opened = open_coast.coast_of(coast.name_full)
    handle, before = opened._held.sea, positions(coast)
    for step in range(3):
        SLIDES[name](coast, step)
        if step == 1:  # also while the work on the value before is under way
            work_on()
    assert np.array_equal(positions(coast), before)
    finish()
    assert coast.libocean_coast.problem == ""
    assert calls and threading.main_thread() not in calls
    assert opened._held.sea is handle
    assert np.array_equal(positions(coast), before) == (name == "foam")
    drafts.allowed = False
    assert_is_sea(coast)


def test_another_bed_is_opened_in_the_background(coast, waiting, slow, calls, sea_file):
    other = sea_file.with_name("other.asc")
    text = sea_file.with_name("bed.asc").read_text()
    other.write_text(text.replace("cellsize 4.0", "cellsize 2.0"))
    coast.libocean.seabed = str(other)
    finish()
    assert coast.libocean_coast.problem == ""
    assert calls and threading.main_thread() not in calls
    assert open_coast.coast_of(coast.name_full).own.cell == 2.0
    coast.libocean.seabed = str(other.with_name("gone.asc"))
    finish()
    assert "gone.asc" in coast.libocean_coast.problem
    assert threading.main_thread() not in calls
    coast.libocean.seabed = str(other)
    finish()
    assert coast.libocean_coast.problem == ""


def test_the_time_of_a_frame_is_the_librarys(coast, monkeypatch):
    opened = open_coast.coast_of(coast.name_full)
    for rate in (24.0, 30000.0 / 1001.0):
        coast.libocean.use_scene_frame_rate = False
        coast.libocean.fps = rate
        with libocean.parse(opened.values.text()) as sea:
            assert opened.time_of(7.5) == sea.time_of_frame(7.5)
    monkeypatch.setattr(libocean.Sea, "time_of_frame", lambda _sea, frame: 100.0 + frame)
    assert opened.time_of(7.5) == 107.5


def test_new_water_comes_before_the_past_of_its_foam(coast, waiting, slow):
    before = positions(coast)
    coast.libocean.waves[0].wind_speed = 6.0
    job = work_on()
    assert job.is_quick and job.progress.share <= 0.5
    job.join()
    drafts.step()
    water = positions(coast)
    assert work_on().progress.share >= 0.5
    assert drafts.is_draft(coast.name_full) and not np.array_equal(water, before)
    coast.libocean_coast.use_clip = False
    water = positions(coast)
    finish()
    assert np.array_equal(positions(coast), water)
    drafts.allowed = False
    assert_is_sea(coast)


def test_the_way_of_the_waves_is_followed_and_stopped(coast, waiting, slow, monkeypatch):
    """The library says how far it is, and ends when the work is stopped meanwhile."""
    seen = []
    begun, stopped = threading.Event(), threading.Event()

    def watch(job, done, total):
        if total > 0:
            seen.append((done, total))
            begun.set()
            stopped.wait(60)
        unwatched(job, done, total)

    unwatched = drafts.Job._watch
    monkeypatch.setattr(drafts.Job, "_watch", watch)
    handle = open_coast.coast_of(coast.name_full)._held.sea
    before = positions(coast)
    coast.libocean.level = 0.3
    job = work_on()
    assert begun.wait(60)
    drafts.stop(coast.name_full)  # of the main thread: no other may touch Blender's windows
    stopped.set()
    job.join()
    assert len(seen) == 1 and seen[0][1] == 1000
    assert isinstance(job.failure, drafts.CancelledError)
    drafts.step()
    assert np.array_equal(positions(coast), before)
    monkeypatch.undo()
    bpy.ops.libocean.finish_draft(name=coast.name_full)
    drafts.allowed = True
    finish()
    assert open_coast.coast_of(coast.name_full)._held.sea is handle
    drafts.allowed = False
    assert_is_sea(coast)


def test_a_new_coast_is_water_at_rest_until_its_whole_is_made(
    sea_file,
    waiting,
    monkeypatch,
):
    threads = []

    def fill(*arguments, **settings):
        threads.append(threading.current_thread())
        return fill_maps(*arguments, **settings)

    fill_maps = coast_job.fill_maps
    monkeypatch.setattr(coast_job, "fill_maps", fill)
    ob = add_coast(sea_file)
    assert drafts.is_draft(ob.name_full)
    assert len(ob.data.vertices) == COLUMNS * ROWS
    assert_is_bed(ob)
    assert len(positions(ob)) == COLUMNS * ROWS and np.abs(positions(ob)[:, 2]).max() == 0.0
    work_on()
    assert "waves over the bed" in drafts.line()[0] or "foam" in drafts.line()[0]
    finish()
    assert threads and threading.main_thread() not in threads
    assert drafts.progress(ob.name_full) is None
    assert_is_bed(ob)
    drafts.allowed = False
    assert_is_sea(ob)


def test_a_frame_of_a_known_sea_is_a_coarser_draft_first(coast, waiting, slow):
    opened = open_coast.coast_of(coast.name_full)
    opened.pace.size = 16
    coast.libocean_coast.use_clip = False
    finish()
    coast.libocean.use_custom_time, coast.libocean.custom_time = True, 3.0
    (modifier,) = node_group.modifiers(coast)
    image = modifier_groups.value(modifier, node_group.DISPLACEMENT)
    assert max(image.size) <= 16 + 1
    draft = positions(coast)
    finish()
    whole = positions(coast)
    assert 0.0 < np.abs(draft - whole).max() < 4.0
    drafts.allowed = coast.libocean.use_custom_time = False
    assert_is_sea(coast)
