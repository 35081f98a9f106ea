# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every class and property says what it is; every operator works from a script, or says why not."""

import inspect
import json
import re
from pathlib import Path

import bpy
import libocean_addon
import pytest
from conftest import failing, plane, reopened
from libocean_addon import manual, whole_sea
from libocean_addon.assets import asset_library
from libocean_addon.bake import farm
from libocean_addon.bundled import libocean
from libocean_addon.coast import operators as coast_operators
from libocean_addon.look import first_view
from libocean_addon.sea import operators, panels, parameter_values, sea_text
from libocean_addon.sea.resolutions import OF_SEA
from libocean_addon.shared import changes, property_texts, table_properties
from libocean_addon.shared.parameter_table import is_optional
from libocean_addon.terrain import operators as terrain_operators

UNITS = {"m": "LENGTH", "m/s": "VELOCITY", "m/s^2": "ACCELERATION", "s": "TIME_ABSOLUTE"}


@pytest.fixture
def ocean():
    bpy.ops.libocean.add(kind="PATCH", preset="beaufort_4")
    return bpy.context.object


def text_of(ob) -> str:
    return parameter_values.values_of(ob.libocean).text()


def test_every_parameter_is_a_property(ocean):
    for entry in parameter_values.TABLE:
        owner = ocean.libocean.waves[0] if entry["section"] == "waves" else ocean.libocean
        prop = owner.bl_rna.properties[entry["key"]]
        assert prop.name == entry["label"]
        assert entry["help"].rstrip(".") in prop.description
        if entry["type"] == "float":
            assert prop.unit == UNITS.get(entry["unit"], "NONE")
            assert prop.soft_min == pytest.approx(entry["soft_min"])
        if entry["type"] == "enum":
            assert [item.identifier for item in prop.enum_items] == entry["choices"]
        if is_optional(entry):
            assert owner.bl_rna.properties[f"use_{entry['key']}"].type == "BOOLEAN"


def test_true_and_false_are_a_property_and_words_of_the_file():
    """No parameter of a sea is one yet; a row of a table, as the library's JSON has it, is."""
    entry = {
        "section": "water",
        "key": "frozen",
        "type": "bool",
        "unit": "",
        "label": "Frozen",
        "help": "Whether the water is ice.",
        "neutral": "false",
        "default": False,
    }

    table = parameter_values.PARAMETERS

    class Toy(bpy.types.PropertyGroup):
        subject = "sea"
        __annotations__ = table_properties.properties_of(entry, table, OF_SEA)

    bpy.utils.register_class(Toy)
    bpy.types.Scene.toy = bpy.props.PointerProperty(type=Toy)
    try:
        toy = bpy.context.scene.toy
        prop = toy.bl_rna.properties["frozen"]
        assert prop.type == "BOOLEAN"
        assert prop.name == "Frozen"
        with changes.quiet():
            for text in ("true", "false", "true"):
                property_texts.set_text(toy, entry, text, table)
                assert property_texts.text_of(toy, entry, table) == text
        assert toy.frozen is True
    finally:
        del bpy.types.Scene.toy
        bpy.utils.unregister_class(Toy)


def test_what_the_spectrum_does_not_use_is_not_there(ocean):
    system = ocean.libocean.waves[0]
    entries = {entry["key"]: entry for entry in parameter_values.entries(waves=True)}

    def used() -> set[str]:
        return {key for key, entry in entries.items() if panels.is_used(system, entry)}

    system.spectrum = "jonswap"
    assert {"fetch", "spreading", "wind_speed"} <= used()
    assert not {"amplitude", "file"} & used()
    system.spectrum = "measured"
    assert {"file", "estimator", "wind_speed"} <= used()
    assert not {"fetch", "amplitude"} & used()
    (threshold,) = (e for e in parameter_values.TABLE if e["key"] == "foam_threshold")
    assert not panels.is_used(ocean.libocean, threshold)
    ocean.libocean.foam_coverage = "threshold"
    assert panels.is_used(ocean.libocean, threshold)


CLASSES = [cls for part in libocean_addon.parts() for cls in getattr(part, "CLASSES", ())]
OPERATORS = [cls for cls in CLASSES if issubclass(cls, bpy.types.Operator)]
GROUPS = [cls for cls in CLASSES if issubclass(cls, bpy.types.PropertyGroup)]
NEED_NO_OCEAN = (
    operators.AddOcean,
    terrain_operators.AddTerrain,
    terrain_operators.AddTerrainFile,
    coast_operators.AddCoast,
    coast_operators.AddCoastFile,
    first_view.AddScene,
    first_view.AddCoastScene,
    first_view.AddTerrainScene,
    asset_library.MakeAssetLibrary,
    whole_sea.StopDraft,
    whole_sea.FinishDraft,
)
CHANGE_NO_DATA = (  # which undo would have to restore
    operators.SaveSea,
    terrain_operators.SaveTerrain,
    coast_operators.SaveCoast,
    farm.BakeOnFarm,
    asset_library.MakeAssetLibrary,
    whole_sea.StopDraft,
    whole_sea.FinishDraft,
)


def by_name(classes):
    return pytest.mark.parametrize("cls", classes, ids=lambda cls: cls.__name__)


def operator_of(cls):
    return getattr(bpy.ops.libocean, cls.bl_idname.split(".")[1])


def own_properties(cls) -> list:
    """As registered: those of the class itself, none of Blender's helpers."""
    known = cls.bl_rna.properties
    if issubclass(cls, bpy.types.Operator):
        known = operator_of(cls).get_rna_type().properties
    ours = [base for base in cls.__mro__ if base.__module__.startswith(libocean_addon.__name__)]
    names = {name for base in ours for name in base.__dict__.get("__annotations__", ())}
    return [known[name] for name in sorted(names)]


@pytest.mark.only_reads
@by_name(CLASSES)
def test_every_class_describes_itself(cls):
    assert inspect.getdoc(cls)
    assert not inspect.getdoc(cls).split("\n")[0].endswith(".")  # Blender adds its own
    if issubclass(cls, bpy.types.Operator):
        assert cls.bl_label
        assert cls.bl_idname.startswith("libocean.")
        assert cls in CHANGE_NO_DATA or "UNDO" in cls.bl_options
        assert cls in NEED_NO_OCEAN or hasattr(cls, "poll")
    if issubclass(cls, bpy.types.Panel):
        assert cls.bl_label
        assert cls.poll.__func__


@pytest.mark.only_reads
@by_name(OPERATORS + GROUPS)
def test_every_property_says_what_it_is(cls):
    for prop in own_properties(cls):
        if prop.is_hidden:
            continue
        assert prop.name, prop.identifier
        assert prop.description or prop.type == "COLLECTION", prop.identifier
        assert not prop.description.endswith("."), prop.identifier


@by_name([cls for cls in OPERATORS if cls not in NEED_NO_OCEAN])
def test_an_operator_that_cannot_run_says_why(cls):
    assert not operator_of(cls).poll()
    with pytest.raises(RuntimeError, match=r"active object|[Ss]elect|No ocean"):
        operator_of(cls)()


@pytest.mark.only_reads
@by_name(OPERATORS + GROUPS)
def test_f1_leads_to_a_section_of_the_documentation(cls):
    from bl_operators.wm import WM_OT_doc_view_manual

    readme = Path(__file__).parents[2] / "blender_addon" / "README.md"
    headings = re.findall(r"^#+ (.+)$", readme.read_text(), re.MULTILINE)
    anchors = {"#" + heading.lower().replace(" ", "-") for heading in headings}
    if cls in OPERATORS:
        asked = [f"bpy.ops.{cls.bl_idname}"]
    else:
        asked = [f"bpy.types.{cls.__name__}.{p.identifier}" for p in own_properties(cls)]
    for identifier in asked:
        url = WM_OT_doc_view_manual._lookup_rna_url(identifier)
        assert url is not None, identifier
        assert url.startswith(manual.MANUAL)
        assert url[len(manual.MANUAL) :] in anchors


def test_every_preset_comes_back_from_properties_as_it_was(ocean):
    for preset in libocean.presets():
        with libocean.preset(preset) as sea, changes.quiet():
            parameter_values.assign(ocean.libocean, sea_text.read(sea))
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
    assert parameter_values.values_of(ocean.libocean).values["patch_size"] == "150.0"
    assert parameter_values.values_of(ocean.libocean).values["seed"] == "4294967295"


def test_giving_an_optional_value_turns_it_on(ocean):
    assert not ocean.libocean.use_depth
    ocean.libocean.depth = 12.0
    assert ocean.libocean.use_depth
    assert parameter_values.values_of(ocean.libocean).values["depth"] == "12.0"
    ocean.libocean.use_depth = False
    assert parameter_values.values_of(ocean.libocean).values["depth"] == "inf"


def test_a_wind_saved_without_a_switch_is_given(ocean, tmp_path):
    ocean.libocean.waves[0].wind_speed = 21.0
    ocean.libocean.waves[0].property_unset("use_wind_speed")
    settings = reopened(tmp_path / "old.blend", ocean.name).libocean
    assert settings.waves[0].use_wind_speed
    assert parameter_values.values_of(settings).waves[0].values["wind_speed"] == "21.0"


def test_a_file_that_cannot_be_used_is_named_without_a_number(ocean, tmp_path):
    missing = tmp_path / "none" / "sea.toml"
    for operator in (bpy.ops.libocean.save_sea, bpy.ops.libocean.pick_record):
        said = failing(operator, filepath=str(missing))
        assert f"Error: {missing}: No such file or directory" in said


def test_a_value_beyond_its_limits_is_said_and_stays(ocean):
    system = ocean.libocean.waves[0]
    system.wind_speed = 500.0
    assert system.wind_speed == 500.0
    assert "Wind speed = 500: is out of range; allowed: 0 .. 75 m/s" in ocean.libocean.problem
    system.wind_speed = 12.0
    ocean.libocean.cascades = 7
    assert "Cascades = 7" in ocean.libocean.problem
    ocean.libocean.cascades = 1
    assert ocean.libocean.problem == ""


@pytest.mark.parametrize(
    ("name", "value", "allowed"),
    [
        ("horizon_vertices", 5_000_000, "5000 .. 1500000"),
        ("horizon_distance", 99.0, "100 .. 100000"),
        ("spray_lifetime", 12, "0.05 .. 10"),
        ("spray_size", -1.0, "at least 0"),
        ("bake.frame_start", -5, "at least 0"),
        ("volumes.voxel", -0.1, "at least 0"),
    ],
)
def test_a_script_that_leaves_the_limits_of_a_setting_gets_an_error(ocean, name, value, allowed):
    owner = ocean.libocean
    *path, name = name.split(".")
    for part in path:
        owner = getattr(owner, part)
    before = getattr(owner, name)
    with pytest.raises(ValueError, match=f"{name} = {value:.7g}: .* allowed: {allowed}"):
        setattr(owner, name, value)
    assert getattr(owner, name) == before


def test_limits_include_their_ends_as_written(ocean):
    ocean.libocean.spray_lifetime = 0.05  # which is less in double precision than the property's
    ocean.libocean.spray_lifetime = 10.0
    ocean.libocean.depth = float("inf")
    assert ocean.libocean.spray_lifetime == 10.0


def test_messages_speak_of_the_panels_fields(ocean, tmp_path):
    settings = ocean.libocean
    settings.shortest_wavelength = 50.0
    settings.longest_wavelength = 10.0
    assert settings.problem.startswith("Longest wavelength = 10 m: must be more than Shortest wave")
    settings.longest_wavelength = 0.0
    settings.take = "/nowhere.take"
    assert settings.problem == 'Take = "/nowhere.take": /nowhere.take: no such file'
    settings.take = ""
    bpy.ops.libocean.add_waves()
    settings.waves[1].spectrum = "measured"
    assert "needs a file" in settings.problem
    settings.waves[1].file = "/nowhere.spec"
    assert settings.problem.startswith("Spectrum file (2)")  # of the second wave system
    assert "text:" not in settings.problem
    bpy.ops.libocean.remove_waves()
    assert settings.problem == ""


@pytest.mark.parametrize(
    "name", ["/grid.resolution", "/waves.0.fetch = 5", "/nowhere surface.x", "waves.0.fetch = 5"]
)
def test_messages_take_no_file_for_a_field(ocean, name):
    """A file may be named as a parameter is, or as a whole message. A sea that is open looks where
    Blender was started, and says so."""
    settings, path = ocean.libocean, Path.cwd() / name
    settings.take = name
    assert settings.problem == f'Take = "{name}": {path}: no such file'
    settings.take = ""
    settings.waves[0].spectrum, settings.waves[0].file = "measured", name
    assert settings.problem == f'Spectrum file = "{name}": {path}: no such file'
    bpy.ops.libocean.add_waves()  # the sea is opened anew, from a text
    assert settings.problem == f'Spectrum file (1) = "{name}": {name}: no such file'


def test_a_measured_sea_without_its_file_keeps_the_sea_that_was(ocean):
    from libocean_addon.sea import facts

    before = facts.state_of(ocean)
    ocean.libocean.waves[0].spectrum = "measured"
    assert "needs a file" in ocean.libocean.problem
    assert facts.state_of(ocean) == before
    assert facts.warnings_of(ocean) == []
    ocean.libocean.waves[0].spectrum = "jonswap"
    assert ocean.libocean.problem == ""


def test_a_file_in_which_resolutions_were_plain_numbers(ocean, tmp_path):
    """As the add-on saved it before: a mesh of 1024 samples a side, numbers that no list has."""
    settings = ocean.libocean
    settings.use_foam = False
    settings.viewport_resolution, settings.render_resolution = 128, 256
    settings.resolution = settings.mesh_resolution = 1024
    settings.property_unset("mesh_resolution")
    if bpy.app.version < (5, 0):  # later ones do not let us
        settings["viewport_resolution"] = 100
    settings = reopened(tmp_path / "old.blend", ocean.name).libocean
    assert (settings.resolution, settings.resolution_list) == (1024, "1024")
    assert (settings.viewport_resolution, settings.render_resolution) == (128, 256)
    assert settings.viewport_resolution_list == "128"
    assert len(bpy.context.object.data.vertices) == 1025**2
    assert settings.problem == ""


@pytest.mark.parametrize("name", ["resolution", "viewport_resolution", "render_resolution"])
def test_a_resolution_is_a_number_and_a_list(ocean, name):
    settings, listed = ocean.libocean, f"{name}_list"
    settings.use_foam = False
    choices = [item.identifier for item in settings.bl_rna.properties[listed].enum_items]
    assert choices[-9:] == [str(32 << k) for k in range(9)]
    assert ("0" in choices) == (name != "resolution")
    setattr(settings, listed, "64")
    assert getattr(settings, name) == 64
    setattr(settings, name, 256)
    assert getattr(settings, listed) == "256"


def test_wave_systems_come_and_go(ocean):
    assert bpy.ops.libocean.add_waves() == {"FINISHED"}
    assert len(ocean.libocean.waves) == 2
    assert bpy.ops.libocean.remove_waves() == {"FINISHED"}
    assert "at least one" in failing(bpy.ops.libocean.remove_waves)


def test_resolution_is_a_power_of_two(ocean):
    """Also where a field sets it, past the class of the settings, which refuses it to scripts."""
    bpy.types.PropertyGroup.__setattr__(ocean.libocean, "resolution", 300)
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
    from libocean_addon.sea import facts

    shown = dict(facts.state_of(ocean))
    with libocean.parse(text_of(ocean)) as sea:
        height = sea.state["significant_wave_height"]["resolved"]
    assert shown["Wave height"] == f"{height:.2f} m"
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
