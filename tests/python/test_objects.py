# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Seas, terrains, surfaces and errors as Python objects: copies, pickles, assignments, names."""

import copy
import gc
import multiprocessing
import os
import pickle
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from conftest import SMALL

import libocean
from libocean import _abi

GROUND = "libocean = 1\n[terrain]\nresolution = 64\npatch_size = 500.0\n"


@pytest.fixture(params=["sea", "terrain"])
def subject(request):
    made = libocean.parse(SMALL) if request.param == "sea" else libocean.parse_terrain(GROUND)
    with made:
        yield made


def surface_of(subject):
    return subject.surface(3.0) if isinstance(subject, libocean.Sea) else subject.surface()


def height(subject):
    return surface_of(subject).height


@pytest.mark.parametrize("twin", [copy.copy, copy.deepcopy, lambda subject: subject.clone()])
def test_a_copy_has_a_handle_of_its_own(subject, twin):
    expected = height(subject)
    with ThreadPoolExecutor(3) as pool:  # one for each thread
        for found in pool.map(lambda _: height(twin(subject)), range(3)):
            assert np.array_equal(found, expected)
    copied = twin(subject)
    assert copied._handle.value != subject._handle.value
    assert np.array_equal(height(copied), expected)
    copied.set("seed", 5)
    assert not np.array_equal(height(copied), expected)
    assert np.array_equal(height(subject), expected)
    subject.close()
    assert height(copied).any()
    copied.close()


def test_its_text_gives_the_same_subject(subject):
    parse = libocean.parse if isinstance(subject, libocean.Sea) else libocean.parse_terrain
    with parse(subject.text) as again:
        assert again.text == subject.text
        assert np.array_equal(height(again), height(subject))


def test_a_copied_surface_looks_at_the_same_sea(sea):
    surface = sea.surface(3.0, fields=["height"])
    for copied in (copy.copy(surface), copy.deepcopy(surface)):
        assert np.array_equal(copied.height, surface.height)
        assert np.array_equal(copied.slope, sea.surface(3.0).slope)
    assert copy.deepcopy(surface).height is not surface.height
    del surface, copied
    gc.collect()
    assert sea.surface(3.0).height.any()


def test_a_pickled_subject_is_the_same(subject):
    again = pickle.loads(pickle.dumps(subject))
    assert again.text == subject.text
    assert np.array_equal(height(again), height(subject))
    subject.close()
    with pytest.raises(libocean.Error, match="closed"):
        pickle.dumps(subject)


def test_a_pickled_sea_keeps_its_options_and_its_foam():
    sea = libocean.parse(SMALL, threads=2, foam_start="settled", progress=lambda *_: None)
    sea.set_all({"wind_speed": 15.0, "foam_lifetime": 1.0})
    again = pickle.loads(pickle.dumps(sea))
    assert again._options == (2, "cpu", "settled", None, None)
    assert np.array_equal(again.surface(4.0).foam, sea.surface(4.0).foam)


def test_a_pickled_sea_has_its_bed_or_is_refused(sea, tmp_path, monkeypatch):
    sea.set_bed(np.tile(np.arange(9) - 4.5, (4, 1)), cell=5.0)
    assert pickle.loads(pickle.dumps(sea)).state["bed"] == sea.state["bed"]
    rows = np.tile(np.linspace(-9.0, 3.0, 400, dtype=np.float32), (800, 1))
    sea.set_bed(rows)
    with pytest.raises(libocean.UnsupportedError, match="up to 1 MB"):
        pickle.dumps(sea)
    # The bed of a file is read again, from the folder that it was opened in.
    head = "ncols 400\nnrows 800\nxllcorner 0\nyllcorner 0\ncellsize 1\n"
    lines = (" ".join(f"{value:.2f}" for value in row) for row in rows)
    (tmp_path / "bed.asc").write_text(head + "\n".join(lines) + "\n")
    (tmp_path / "sea.toml").write_text(SMALL + '[water]\nseabed = "bed.asc"\n')
    monkeypatch.chdir(tmp_path)
    with libocean.open("sea.toml") as coast:
        pickled, bed = pickle.dumps(coast.clone()), coast.state["bed"]
    monkeypatch.chdir("/")
    assert pickle.loads(pickled).state["bed"] == bed


def test_a_pickled_surface_has_the_fields_that_were_computed(sea):
    surface = sea.surface(3.0, 32, fields=["height", "slope"])
    again = pickle.loads(pickle.dumps(surface))
    assert (again.time, again.resolution) == (3.0, 32)
    assert np.array_equal(again.height, surface.height)
    assert np.array_equal(again.slope, surface.slope)
    with pytest.raises(libocean.Error, match="normal was not computed .* has height, slope"):
        _ = again.normal
    with pytest.raises(libocean.Error, match="fields="):
        pickle.dumps(sea.surface(3.0))


def errors():
    kinds, found = [libocean.Error], []
    while kinds:
        found.append(kinds.pop())
        kinds += found[-1].__subclasses__()
    return found


@pytest.mark.parametrize("kind", errors())
def test_errors_cross_to_another_process_whole(kind):
    parts = {"what": "is big", "parameter": "fetch", "value": "5", "allowed": "1 .. 2 m"}
    for error in (kind("a sentence", 7), kind("a sentence", 7, **parts)):
        for again in (pickle.loads(pickle.dumps(error)), copy.copy(error)):
            assert type(again) is kind and str(again) == "a sentence"
            assert vars(again) == vars(error) and again.code == 7


def test_a_spawned_process_gets_a_sea_and_sends_arrays_and_errors(sea):
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        answers = pool.apply(libocean.Sea.query, (sea, [[1.0, 2.0]], 3.0))
        assert np.array_equal(answers, sea.query([[1.0, 2.0]], 3.0))
        with pytest.raises(libocean.InvalidValueError, match="wind_speed = -1") as refused:
            pool.apply(libocean.Sea.set, (sea, "wind_speed", -1))
    assert refused.value.parameter == "waves.0.wind_speed" and refused.value.allowed


def test_nothing_is_assigned_without_effect(subject):
    for name in ("wind_speed", "beta", "text", "state"):
        with pytest.raises(AttributeError, match=rf"set\(\"{name}\", 10\)"):
            setattr(subject, name, 10)
    surface = surface_of(subject)
    for name in ("time", "resolution", "height", "wind"):
        with pytest.raises(AttributeError, match="makes a new surface"):
            setattr(surface, name, 10)


def test_a_person_reads_what_an_object_is(sea):
    hs = sea.state["significant_wave_height"]["asked"]
    shown = f"<libocean.Sea: 64 x 64 samples of 200 m, significant wave height {hs:.3g} m asked>"
    assert repr(sea) == shown
    surface = sea.surface(12.5, fields=["height", "slope"])
    assert repr(surface) == "<libocean.Surface: 12.5 s, 64 x 64 samples, computed: height, slope>"
    with libocean.parse_terrain(GROUND) as ground:
        assert repr(ground) == "<libocean.Terrain: a tile of 64 x 64 samples, 7.8125 m apart>"
    sea.set("grid.resolution", 8192)  # whose spectrum takes seconds, and is not needed
    assert "8192 x 8192" in repr(sea)
    sea.close()
    assert repr(sea) == "<libocean.Sea: this sea is closed>"


def test_a_progress_function_is_told_that_it_may_not_use_its_sea():
    said = []

    def progress(_done, _total):
        for use in (lambda: sea.get("fps"), sea.clone, sea.close):
            with pytest.raises(libocean.Error, match=r"clone\(\)") as refused:
                use()
            said.append(refused.value.code)

    with libocean.parse(SMALL, foam_start="empty", progress=progress) as sea:
        sea.surface(1.0, fields=["foam"])
    assert said and set(said) == {_abi.BUSY}


def test_a_star_brings_the_public_names_and_tab_offers_no_others():
    space = {}
    exec("from libocean import *", space)
    brought = set(space) - {"__builtins__"}
    offered = {name for name in dir(libocean) if not name.startswith("_")}
    assert brought == set(libocean.__all__) == offered - {"open"}
    modules = [name for name in offered if isinstance(getattr(libocean, name), type(os))]
    assert not modules
    for name in ("CHANNELS", "GAUGE_COLUMNS", "MASKS", "PRODUCTS"):  # which the help names
        assert len(getattr(libocean, name)) > 9
