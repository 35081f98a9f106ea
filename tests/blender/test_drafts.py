# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""While values move a draft is shown, which asks for no past of the foam; at rest the whole sea."""

import threading
import time

import bpy
import numpy as np
import pytest
from conftest import attribute, evaluated_mesh, positions
from libocean_addon.bundled import libocean
from libocean_addon.sea import live, open_sea
from libocean_addon.shared import drafts, modifier_groups


@pytest.fixture
def ocean():
    bpy.ops.libocean.add(kind="PATCH", preset="beaufort_6", use_material=False)
    return bpy.context.object


@pytest.fixture
def past():
    """Returns the progress that the library reported to the main thread while it followed foam."""
    told = []
    drafts.watchers[threading.get_ident()] = lambda done, total: told.append((done, total))
    yield told
    drafts.watchers.pop(threading.get_ident(), None)


def rest(ob) -> list[float]:
    """Until the timer has nothing more to do; the progress that it showed."""
    shares = []
    pause = 0.0
    while pause is not None:
        pause = drafts.step()
        shares.append(drafts.progress(ob.name_full))
        time.sleep(pause or 0.0)
    return [share for share in shares if share is not None]


def image_side(ob) -> int:
    (modifier,) = live.node_group.modifiers(ob)
    return modifier_groups.value(modifier, "Displacement").size[0]


def seconds(action) -> float:
    begun = time.perf_counter()
    action()
    return time.perf_counter() - begun


def test_a_moving_value_waits_for_no_foam(scene, ocean, waiting, past, monkeypatch):
    drafts.allowed = False
    ocean.libocean.resolution = 1024
    scene.frame_set(50)
    assert past  # the whole sea follows its foam
    whole = seconds(lambda: setattr(ocean.libocean.waves[0], "wind_speed", 14.0))
    drafts.allowed = True
    past.clear()
    draft = max(
        seconds(lambda value=value: setattr(ocean.libocean.waves[0], "wind_speed", value))
        for value in (14.5, 15.0, 15.5)
    )
    assert past == []
    assert draft < whole / 4
    assert image_side(ocean) <= 512
    assert drafts.progress(ocean.name_full) == 0.0
    fill, filled = libocean.Sea.fill, []

    def noted(sea, at, maps) -> None:
        filled.extend(channels for _, channels in maps)
        fill(sea, at, maps)

    monkeypatch.setattr(libocean.Sea, "fill", noted)
    shares = rest(ocean)
    assert filled.count(("dx", "dy", "height", "cover")) == 1  # its map is what is shown
    with libocean.parse(live.current_values(ocean.libocean, scene).text()) as sea:
        want = sea.surface(sea.time_of_frame(50), 1024).cover
    assert np.array_equal(open_sea.sea_of("Ocean").buffers["Displacement", 1024][..., 3], want)
    assert past == []  # a thread of its own followed it
    assert max(shares) > 0.0  # and told how far it was
    assert drafts.progress(ocean.name_full) is None
    assert image_side(ocean) == 1024


def test_a_draft_shows_the_waves_where_they_are(scene, ocean, waiting):
    scene.frame_set(50)
    ocean.libocean.waves[0].wind_speed = 9.0
    assert image_side(ocean) < 512
    draft = positions(ocean).copy()
    rest(ocean)
    whole = positions(ocean)
    assert np.std(draft - whole) < 0.2 * np.std(whole[:, 2])


def test_a_draft_has_as_many_samples_as_time_allows():
    pace = drafts.Pace()
    first = pace.size
    for _ in range(2):
        pace.note(pace.size, 10 * drafts.SECONDS, 1024)
    assert pace.size == first // 2
    for _ in range(20):
        pace.note(pace.size, 10 * drafts.SECONDS, 1024)
    assert pace.size == 64
    for _ in range(20):
        pace.note(pace.size, drafts.SECONDS / 100, 1024)
    assert pace.size == 1024
    pace.note(1024, drafts.SECONDS / 3, 1024)
    assert pace.size == 1024


def test_without_foam_nobody_pays_for_its_past(scene, ocean, past):
    ocean.libocean.use_foam = False
    past.clear()
    ocean.libocean.resolution = 1024
    for frame in (50, 10, 200):
        scene.frame_set(frame)
    ocean.libocean.choppiness = 0.7
    assert past == []
    assert "foam" not in evaluated_mesh(ocean).attributes
    ocean.libocean.use_foam = True
    assert past
    assert attribute(ocean, "foam").max() > 0.5


def test_time_that_plays_goes_on_without_its_foam_until_it_is_there(
    scene, ocean, waiting, past, monkeypatch
):
    scene.frame_set(200)
    monkeypatch.setattr(drafts, "is_playing", lambda: True)
    past.clear()
    scene.frame_set(1)  # from the end to the beginning
    assert past == []
    assert image_side(ocean) == 512  # the waves are whole
    while drafts._running is None or drafts._running[1].is_alive():
        time.sleep(drafts.step())
    for frame in range(2, 6):
        scene.frame_set(frame)
        drafts.step()
    assert drafts.progress(ocean.name_full) is None
    with libocean.parse(open_sea.sea_of(ocean.name_full).handle.text) as sea:
        assert attribute(ocean, "foam").mean() == pytest.approx(
            sea.surface(4 / 24).foam.mean(), rel=0.02
        )


def test_the_mesh_does_not_grow_without_being_asked(ocean):
    """Four maps of 1024 and 2048 samples a side, of one mesh."""
    before = len(ocean.data.vertices)
    assert before == 513**2
    ocean.libocean.resolution = 1024
    assert len(ocean.data.vertices) == before
    ocean.libocean.resolution = 512
    ocean.libocean.use_foam = False
    ocean.libocean.cascades = 2
    assert open_sea.sea_of(ocean.name_full).handle.map_resolution() == 2048
    assert len(ocean.data.vertices) == before
    ocean.libocean.mesh_resolution = 1024
    assert len(ocean.data.vertices) == 1025**2
