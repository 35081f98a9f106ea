# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every class and property says what it is; every operator works from a script, or says why not."""

import inspect
import json

import bpy
import pytest
from conftest import plane
from libocean_addon import bake, floating, operators, panels, properties, sea_text
from libocean_addon.bundled import libocean

UNITS = {"m": "LENGTH", "m/s": "VELOCITY", "m/s^2": "ACCELERATION", "s": "TIME_ABSOLUTE"}


@pytest.fixture
def ocean():
    bpy.ops.libocean.add(kind="PATCH", preset="beaufort_4")
    return bpy.context.object


def text_of(ob) -> str:
    return sea_text.write(properties.TABLE, properties.values_of(ob.libocean))


@pytest.mark.parametrize("entry", properties.TABLE, ids=lambda entry: entry["key"])
def test_every_parameter_is_a_property(ocean, entry):
    owner = ocean.libocean.waves[0] if entry["section"] == "waves" else ocean.libocean
    prop = owner.bl_rna.properties[entry["key"]]
    assert prop.name == entry["label"]
    assert entry["help"].rstrip(".") in prop.description
    if entry["type"] == "float":
        assert prop.unit == UNITS.get(entry["unit"], "NONE")
        assert prop.soft_min == pytest.approx(entry["soft_min"])
    if entry["type"] == "enum":
        assert [item.identifier for item in prop.enum_items] == entry["choices"]
    if sea_text.is_optional(entry):
        assert owner.bl_rna.properties[f"use_{entry['key']}"].type == "BOOLEAN"


@pytest.mark.parametrize(
    "cls",
    [*operators.CLASSES, *panels.CLASSES, *floating.CLASSES, *bake.CLASSES],
    ids=lambda c: c.__name__,
)
def test_every_class_describes_itself(cls):
    assert inspect.getdoc(cls)
    if issubclass(cls, bpy.types.Operator):
        assert cls.bl_label
        assert cls.bl_idname.startswith("libocean.")
        assert not inspect.getdoc(cls).endswith(".")  # Blender adds its own
        assert cls is operators.SaveSea or "UNDO" in cls.bl_options
    if issubclass(cls, bpy.types.Panel):
        assert cls.poll.__func__


def test_every_preset_comes_back_from_properties_as_it_was(ocean):
    for preset in libocean.presets():
        with libocean.preset(preset) as sea, properties.quiet():
            operators.take_over(ocean, sea)
            with libocean.parse(text_of(ocean)) as again:
                assert again.text == sea.text


def test_a_preset_is_loaded(ocean):
    assert bpy.ops.libocean.load_preset(preset="douglas_3") == {"FINISHED"}
    with libocean.preset("douglas_3") as sea, libocean.parse(text_of(ocean)) as again:
        assert again.text == sea.text


def test_digits_that_a_property_cannot_hold_stay(ocean, tmp_path):
    text = (
        "libocean = 1\n[grid]\nresolution = 64\npatch_size = 137.3000001234\n"
        "[random]\nseed = 4294967295\n[[waves]]\nwind_speed = 12.3456789012\n"
    )
    path = tmp_path / "digits.toml"
    path.write_text(text)
    bpy.ops.libocean.load_sea(filepath=str(path))
    with libocean.parse(text) as sea, libocean.parse(text_of(ocean)) as again:
        assert again.text == sea.text
    ocean.libocean.patch_size = 150.0
    assert properties.values_of(ocean.libocean).values["patch_size"] == "150.0"
    assert properties.values_of(ocean.libocean).values["seed"] == "4294967295"


def test_giving_an_optional_value_turns_it_on(ocean):
    assert not ocean.libocean.use_depth
    ocean.libocean.depth = 12.0
    assert ocean.libocean.use_depth
    assert properties.values_of(ocean.libocean).values["depth"] == "12.0"
    ocean.libocean.use_depth = False
    assert properties.values_of(ocean.libocean).values["depth"] == "inf"


def test_save_and_load(ocean, tmp_path):
    path = str(tmp_path / "saved.toml")
    ocean.libocean.waves[0].wind_speed = 21.0
    assert bpy.ops.libocean.save_sea(filepath=path) == {"FINISHED"}
    bpy.ops.libocean.load_preset(preset="beaufort_0")
    assert bpy.ops.libocean.load_sea(filepath=path) == {"FINISHED"}
    assert ocean.libocean.waves[0].wind_speed == 21.0


def test_a_file_that_is_no_sea_is_refused_and_changes_nothing(ocean, tmp_path):
    path = tmp_path / "bad.toml"
    path.write_text("libocean = 1\n[grid]\npatch_size = -3\n")
    before = text_of(ocean)
    with pytest.raises(RuntimeError, match="patch_size"):
        bpy.ops.libocean.load_sea(filepath=str(path))
    with pytest.raises(RuntimeError, match="nowhere"):
        bpy.ops.libocean.load_sea(filepath=str(tmp_path / "nowhere.toml"))
    assert text_of(ocean) == before


def test_what_the_library_refuses_is_said_in_the_panel(ocean):
    ocean.libocean.shortest_wavelength = 50.0
    ocean.libocean.longest_wavelength = 10.0
    assert "wavelength" in ocean.libocean.problem
    ocean.libocean.longest_wavelength = 0.0
    assert ocean.libocean.problem == ""


def test_wave_systems_come_and_go(ocean):
    assert bpy.ops.libocean.add_waves() == {"FINISHED"}
    assert len(ocean.libocean.waves) == 2
    assert bpy.ops.libocean.remove_waves() == {"FINISHED"}
    with pytest.raises(RuntimeError, match="at least one"):
        bpy.ops.libocean.remove_waves()


def test_resolution_is_a_power_of_two(ocean):
    ocean.libocean.resolution = 300
    assert ocean.libocean.resolution == 256
    assert len(ocean.data.vertices) == 257**2
    assert ocean.libocean.problem == ""


def test_operators_of_a_sea_want_one():
    plane(10.0, 3)
    for name in ("load_sea", "save_sea", "load_preset", "add_waves", "remove_waves"):
        assert not getattr(bpy.ops.libocean, name).poll()
    assert bpy.ops.libocean.add_modifier() == {"FINISHED"}
    assert bpy.ops.libocean.load_sea.poll()


def test_the_read_out_is_that_of_the_library(ocean):
    from libocean_addon import live

    shown = dict(live.state_of(ocean))
    with libocean.parse(text_of(ocean)) as sea:
        height = sea.state["significant_wave_height"]["resolved"]
    assert shown["Significant wave height"] == f"{height:.2f} m"
    json.dumps(shown)


def test_the_add_on_goes_away_and_comes_back(ocean):
    handlers = {
        name: len(getattr(bpy.app.handlers, name))
        for name in dir(bpy.app.handlers)
        if isinstance(getattr(bpy.app.handlers, name), list)
    }
    bpy.ops.preferences.addon_disable(module="libocean_addon")
    assert not hasattr(bpy.types.Object, "libocean")
    bpy.ops.preferences.addon_enable(module="libocean_addon")
    for name, count in handlers.items():
        assert len(getattr(bpy.app.handlers, name)) == count
