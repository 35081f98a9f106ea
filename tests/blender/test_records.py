# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A measured record becomes a wave system, from a script as from the list."""

from pathlib import Path

import bpy
import pytest
from conftest import add_ocean, failing
from libocean_addon.bundled import libocean
from libocean_addon.sea import facts, open_sea, parameter_values, records
from libocean_addon.shared import changes

SPECTRA = Path(__file__).parents[1] / "data" / "spectra"
BUOY = str(SPECTRA / "ndbc_41010.data_spec")
MODEL = str(SPECTRA / "swan_nz_west_coast.spec")


@pytest.fixture
def ocean():
    return add_ocean(64, preset="beaufort_2", use_material=False)


def height_of(ob) -> float:
    return open_sea.sea_of(ob.name_full).handle.state["significant_wave_height"]["asked"]


@pytest.mark.parametrize(
    ("path", "number", "chosen"),
    [
        (BUOY, -1, lambda record: {"record": record["time"]}),
        (MODEL, -1, lambda record: {"record": record["time"]}),
        (BUOY, 0, lambda _: {}),
        (MODEL, 3, lambda _: {"choice": "3"}),  # from the list
    ],
)
def test_the_sea_is_as_high_as_the_record(ocean, path, number, chosen):
    record = libocean.records(path)[number]
    assert bpy.ops.libocean.pick_record(filepath=path, **chosen(record)) == {"FINISHED"}
    system = ocean.libocean.waves[0]
    assert system.spectrum == "measured" and system.measured_record
    assert ocean.libocean.problem == ""
    assert height_of(ocean) == pytest.approx(record["significant_wave_height"], rel=0.01)


def test_the_wind_of_the_waves_before_is_not_measured(ocean):
    assert ocean.libocean.waves[0].use_wind_speed
    bpy.ops.libocean.pick_record(filepath=BUOY)
    assert not ocean.libocean.waves[0].use_wind_speed
    assert any("the wind is unknown" in warning for warning in facts.warnings_of(ocean))
    ocean.libocean.waves[0].wind_speed = 8.0
    assert ocean.libocean.waves[0].use_wind_speed
    assert not any("no wind" in warning for warning in facts.warnings_of(ocean))


def test_another_record_can_be_typed_in(ocean):
    first, *_, last = libocean.records(BUOY)
    bpy.ops.libocean.pick_record(filepath=BUOY, record=first["time"])
    ocean.libocean.waves[0].record = last["time"]
    assert ocean.libocean.problem == ""
    assert height_of(ocean) == pytest.approx(last["significant_wave_height"], rel=0.01)


def test_the_active_wave_system_alone_becomes_the_record(ocean):
    bpy.ops.libocean.add_waves()
    ocean.libocean.waves[1].significant_wave_height = 3.0
    before = parameter_values.values_of(ocean.libocean).waves[0]
    bpy.ops.libocean.pick_record(filepath=BUOY)
    after = parameter_values.values_of(ocean.libocean)
    assert after.waves[0] == before
    assert after.waves[1].values["spectrum"] == "measured"
    assert after.waves[1].values["significant_wave_height"] == ""
    assert ocean.libocean.active_wave == 1


def test_the_record_needs_its_file_no_more(ocean, tmp_path):
    copy = tmp_path / "model.spec"
    copy.write_bytes(Path(MODEL).read_bytes())
    bpy.ops.libocean.pick_record(filepath=str(copy))
    copy.unlink()
    ocean.libocean.choppiness = 0.5
    assert ocean.libocean.problem == ""


def test_a_file_beside_the_blend_file_is_found_by_its_name(ocean, tmp_path):
    """A sea that is shown can be saved, and have another system measured."""
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "sea.blend"))
    (tmp_path / "buoy.data_spec").write_bytes(Path(BUOY).read_bytes())
    ocean = bpy.data.objects[ocean.name]
    bpy.ops.libocean.add_waves()
    settings = ocean.libocean
    with changes.quiet():
        settings.waves[0].spectrum, settings.waves[0].file = "measured", "buoy.data_spec"
    settings.choppiness = 0.5
    assert settings.problem == ""
    saved = tmp_path / "other" / "sea.toml"
    saved.parent.mkdir()
    assert bpy.ops.libocean.save_sea(filepath=str(saved)) == {"FINISHED"}
    with libocean.open(str(saved)) as sea:
        assert sea.state["significant_wave_height"]["asked"] == height_of(ocean)
    settings.active_wave = 1
    assert bpy.ops.libocean.pick_record(filepath=MODEL) == {"FINISHED"}
    assert [system.spectrum for system in settings.waves] == ["measured", "measured"]


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ({"filepath": BUOY, "record": "1999-01-01T00:00"}, "1999"),
        ({"filepath": str(SPECTRA / "nowhere.spec")}, "nowhere"),
        ({"filepath": __file__}, "test_records"),
    ],
)
def test_what_cannot_be_read_is_refused_and_changes_nothing(ocean, arguments, sentence):
    before = parameter_values.values_of(ocean.libocean)
    assert sentence in failing(bpy.ops.libocean.pick_record, **arguments)
    assert parameter_values.values_of(ocean.libocean) == before


def test_the_list_says_time_place_height_and_period():
    labels = [records._label(record) for record in libocean.records(BUOY)]
    assert labels[0] == "2020-06-08 03:50  41010  1.1 m  5.6 s"
    assert len(set(labels)) == len(labels)
