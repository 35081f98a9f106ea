# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Arguments of a wrong type or value: the same sentence from every method of the wrapper."""

import math
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import libocean

POINTS = [[1.0, 2.0]]
# Every method that takes a time, by a function of the sea and the time.
TIMED = {
    "surface": lambda sea, time: sea.surface(time),
    "fill": lambda sea, time: sea.fill(time, [(np.empty((64, 64, 1), np.float32), "height")]),
    "query": lambda sea, time: sea.query(POINTS, time),
    "samples": lambda sea, time: sea.samples(POINTS, time),
    "orbital_velocity": lambda sea, time: sea.orbital_velocity(POINTS, time),
    "water": lambda sea, time: sea.water([[1.0, 2.0, -3.0]], time),
    "gauges": lambda sea, time: sea.gauges([[1.0, 2.0, -3.0]], 0.0, time, 1.0),
    "float_pose": lambda sea, time: sea.float_pose([[1.0, 2.0, 0.0, 4.0, 2.0]], time),
    "detail": lambda sea, time: sea.detail(time),
    "spray": lambda sea, time: sea.spray(time),
    "cover_power": lambda sea, time: sea.cover_power(time),
    "region": lambda sea, time: sea.region(time, (0, 0), (4, 4), 1.0),
    "perform": lambda sea, time: sea.perform(time, "wind_speed", 5),
    "provenance": lambda sea, time: sea.provenance(1, time),
    "time_of_frame": lambda sea, time: sea.time_of_frame(time),
}


@pytest.mark.parametrize("use", TIMED.values(), ids=TIMED.keys())
def test_a_time_is_a_finite_number(sea, use):
    for time in ("5", b"5", None, [1.0], 1j):
        with pytest.raises(TypeError, match="(time|end|frame) must be a number, not"):
            use(sea, time)
    for time in (math.nan, math.inf):
        with pytest.raises(libocean.InvalidValueError, match="finite number"):
            use(sea, time)


def test_a_time_beyond_all_maps_is_refused_at_once(sea):
    with pytest.raises(libocean.InvalidValueError, match="-1e9 .. 1e9"):
        sea.surface(2e9)
    for time in (2, np.float32(2), np.array(2.0), Fraction(2)):
        assert sea.surface(time).time == 2.0


@pytest.mark.parametrize(
    "use",
    [
        lambda sea: sea.set(1, 2),
        lambda sea: sea.get(1),
        lambda sea: sea.set_all({1: 2}),
        lambda sea: sea.perform(0.0, 1, 2),
        lambda sea: sea.add_waves(1),
        lambda sea: sea.remove_waves(1),
        lambda sea: sea.provenance(1, 0.0, 5),
        lambda sea: libocean.terrain(patch_size=200).provenance(5),
        lambda sea: libocean.preset(6),
        lambda sea: libocean.terrain_preset(6),
        lambda sea: libocean.parse(b"libocean = 1"),
        lambda sea: libocean.parse_terrain(b"libocean = 1"),
        lambda sea: libocean.text_of_values({1: 2}),
        lambda sea: libocean.foam_texture(1),
        lambda sea: libocean.foam_texture_period(None),
    ],
)
def test_a_text_is_a_str(sea, use):
    with pytest.raises(TypeError, match=r"must be a text \(str\), not (int|bytes|NoneType)"):
        use(sea)


def test_a_path_is_a_path():
    for use in (libocean.open, libocean.open_terrain, libocean.records):
        with pytest.raises(TypeError, match="must be a path .* not int"):
            use(5)
        with pytest.raises(libocean.InvalidValueError, match="NUL"):
            use("sea.toml\0.txt")


def test_values_are_numbers_texts_paths_and_lists(sea):
    sea.set("wind_speed", Decimal("7.5"))
    assert sea.get("wind_speed") == "7.5"
    sea.set_all({"seabed_origin": np.array([1.0, 2.0]), "depth": np.array(20.0)})
    assert (sea.get("seabed_origin"), sea.get("depth")) == ("[1, 2]", "20")
    for value in (b"7", {7}, object()):
        with pytest.raises(TypeError, match="a value must be"):
            sea.set("wind_speed", value)
    for use in (sea.set_all, libocean.text_of_values):
        with pytest.raises(TypeError, match="a mapping of names, not int"):
            use(5)
    before = sea.text
    with pytest.raises(TypeError, match="a value must be"):
        sea.add_waves(wind_speed=b"7")
    assert sea.text == before


def test_points_are_numbers(sea):
    for points in ([["1", "2"]], "12", [[None, 1.0]], iter(POINTS), None):
        with pytest.raises(TypeError, match=r"points must be numbers, an array \(n, 2\), not"):
            sea.query(points, 0.0)
    with pytest.raises(ValueError, match="points: rows of different lengths"):
        sea.query([[1.0, 2.0], [3.0]], 0.0)
    with pytest.raises(TypeError, match="bodies must be numbers"):
        sea.float_pose([["a"] * 5], 0.0)


@pytest.mark.parametrize(
    "name, use",
    [
        ("threads", lambda sea, value: libocean.preset("beaufort_6", threads=value)),
        ("resolution", lambda sea, value: sea.surface(0.0, value)),
        ("resolution", lambda sea, value: sea.detail(0.0, value)),
        ("resolution", lambda sea, value: sea.cover_power(0.0, value)),
        ("resolution", lambda sea, value: sea.samples(POINTS, 0.0, resolution=value)),
        ("refine", lambda sea, value: sea.samples(POINTS, 0.0, refine=value)),
        ("samples", lambda sea, value: sea.detail(0.0, samples=value)),
        ("most", lambda sea, value: sea.spray(0.0, most=value)),
        ("frame", lambda sea, value: sea.provenance(value, 0.0)),
        ("columns", lambda sea, value: sea.bed_region((0, 0), (value, 4), 1.0)),
        ("rows", lambda sea, value: sea.region(0.0, (0, 0), (4, value), 1.0)),
        ("size", lambda sea, value: libocean.foam_texture("lace", size=value)),
    ],
)
def test_a_whole_number_is_one_and_is_not_cut_off(sea, name, use):
    for value in ("64", 64.5):
        with pytest.raises(TypeError, match=f"{name} must be a whole number, not (str|float)"):
            use(sea, value)
    with pytest.raises(libocean.InvalidValueError, match=f"{name} = 4294967360; allowed"):
        use(sea, 2**32 + 64)


def test_sentences_have_the_words_of_python(sea):
    for heights in (np.zeros((1, 1)), np.zeros((0, 4)), np.zeros((9000, 2)), 5.0):
        with pytest.raises(libocean.InvalidValueError, match="2 .. 8192 samples a side, or None"):
            sea.set_bed(heights)
    for cell in (0, -1.0):
        with pytest.raises(libocean.InvalidValueError, match="cell = .*; allowed: above 0"):
            sea.set_bed(np.zeros((4, 4)), cell=cell)
    with pytest.raises(libocean.InvalidValueError, match=r"origin: an array of shape \(1,\)"):
        sea.set_bed(np.zeros((4, 4)), origin=(1,))
    for use in (sea.detail, sea.cover_power):
        with pytest.raises(libocean.InvalidValueError, match="allowed: a power of two, 32 .. 8192"):
            use(0.0, 33)
    with pytest.raises(libocean.InvalidValueError, match="the name of a field"):
        sea.region(0.0, (0, 0), (4, 4), 1.0, [])
    with pytest.raises(libocean.InvalidValueError, match="unknown field 'detail9'; known: detail1"):
        sea.provenance(1, 0.0, "detail9", detail=sea.detail(0.0))
    with pytest.raises(TypeError, match="samples must be two numbers"):
        sea.bed_region((0, 0), 4, 1.0)
    for buffer in (5, ([0.0], ["height"]), np.zeros((64, 64, 1), np.float32)):
        with pytest.raises(TypeError, match="a buffer must be a pair: a NumPy array"):
            sea.fill(0.0, [buffer])
    with pytest.raises(TypeError, match="progress must be a function"):
        libocean.preset("beaufort_6", progress=5)


def test_a_class_says_who_makes_its_objects():
    for arguments in ((), ("sea.toml",)):
        with pytest.raises(TypeError, match=r"a sea is made by libocean.open\(\), parse\(\)"):
            libocean.Sea(*arguments)
        with pytest.raises(TypeError, match=r"a terrain is made by libocean.terrain\(\)"):
            libocean.Terrain(*arguments)
    with pytest.raises(TypeError, match=r"made by surface\(\)"):
        libocean.Surface()


@pytest.mark.parametrize(
    "use",
    [
        lambda **options: libocean.open("sea.toml", **options),
        lambda **options: libocean.parse("libocean = 1", **options),
        lambda **options: libocean.preset("beaufort_6", **options),
        lambda **options: libocean.open_terrain("terrain.toml", **options),
        lambda **options: libocean.terrain_preset("tujunga", **options),
    ],
)
def test_an_unknown_option_names_the_near_one(use):
    with pytest.raises(TypeError, match=r"unknown option 'thread'; did you mean threads\?"):
        use(thread=3)
    with pytest.raises(TypeError, match="unknown option 'colour'; allowed: threads, backend"):
        use(colour="blue")
