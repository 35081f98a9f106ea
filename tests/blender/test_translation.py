# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever the interface says has a German word, and Blender finds it."""

import ast
import re
import string
import unittest.mock
from pathlib import Path

import bpy
import libocean_addon
import pytest
from conftest import add_ocean, failing, plane
from libocean_addon import translations
from libocean_addon.bake import bake_state
from libocean_addon.floating import floating
from libocean_addon.look import water_shader
from libocean_addon.sea import facts, operators, panels, parameter_values
from libocean_addon.shared import compat
from libocean_addon.shared.parameter_table import is_optional
from libocean_addon.terrain import facts as terrain_facts
from libocean_addon.terrain import ground_shader, look_panels
from libocean_addon.terrain import panels as terrain_panels
from libocean_addon.terrain.parameters import PARAMETERS

GERMAN, SEA = translations.TABLE["de_DE"], translations.SEA
CLASSES = [cls for part in libocean_addon.parts() for cls in getattr(part, "CLASSES", ())]
OPERATORS = [cls for cls in CLASSES if issubclass(cls, bpy.types.Operator)]
SOURCES = sorted(Path(libocean_addon.__file__).parent.rglob("*.py"))
# Presets, waters, numbers.
PROPER_NAME = re.compile(
    r"(Beaufort|Douglas|Jerlov|Seed) |(Gabilan Mesa|(Big )?Tujunga|Jacksboro)$|\d+$"
)


# Texts to be translated ---------------------------------------------------------


def own_properties(cls) -> list:
    known = cls.bl_rna.properties
    if cls in OPERATORS:
        known = getattr(bpy.ops.libocean, cls.bl_idname.split(".")[1]).get_rna_type().properties
    ours = [base for base in cls.__mro__ if base.__module__.startswith(libocean_addon.__name__)]
    names = {name for base in ours for name in base.__dict__.get("__annotations__", ())}
    return [known[name] for name in sorted(names)]


def labels_of(cls) -> set[tuple[str, str]]:
    """(context, label) of a class, its properties and their choices."""
    found = set()
    if hasattr(cls, "bl_label"):
        found.add(("Operator" if cls in OPERATORS else "*", cls.bl_label))
    for prop in own_properties(cls):
        # A collection that is no more than drawn as a list has no name.
        if not prop.is_hidden and prop.type != "COLLECTION":
            found.add((prop.translation_context, prop.name))
        if prop.type == "ENUM":
            found |= {(prop.translation_context, item.name) for item in prop.enum_items}
    return {(context, label) for context, label in found if not PROPER_NAME.match(label)}


def calls(path: Path):
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call):
            name = node.func.attr if isinstance(node.func, ast.Attribute) else node.func
            yield name.id if isinstance(name, ast.Name) else name, node


def texts_in(path: Path) -> set[tuple[str, str]]:
    """(context, text) of what a source says beside labels of classes and properties."""
    found = set()
    for name, call in calls(path):
        if name in ("tr", "tr_label"):
            assert isinstance(call.args[0], ast.Constant), ast.unparse(call)
            found.add(("*", call.args[0].value))
        for keyword in call.keywords:
            if keyword.arg in ("text", "heading") and isinstance(keyword.value, ast.Constant):
                is_button = name in ("operator", "operator_menu_enum")
                found.add(("Operator" if is_button else "*", keyword.value.value))
    return {(context, text) for context, text in found if text}


def sockets_of_materials() -> set[tuple[str, str]]:
    groups = (water_shader.get_group(), ground_shader.get_group())
    names = {name for group in groups for name in compat.input_identifiers(group)}
    return {("*", name) for name in {*names, "Surface", "Volume", "Foam", "Colour"}}


def short_labels() -> set[tuple[str, str]]:
    labels = {*panels.SHORT.values(), *terrain_panels.SHORT.values(), *look_panels.SIDES}
    # The fields of a break, which are two of one property.
    return {(SEA, label) for label in {*labels, "Break", "Beta below"}}


def states() -> set[tuple[str, str]]:
    add_ocean(64, use_material=False)
    said = facts.state_of(bpy.context.object)
    bpy.ops.libocean.add_terrain(preset="seed_rough", use_material=False)
    said += terrain_facts.state_of(bpy.context.object)
    return {(SEA, label) for label, _ in said}


# The table ----------------------------------------------------------------------


def used() -> dict[tuple[str, str], str]:
    """Returns all that is said, (context, text), with the place of it."""
    found = dict.fromkeys(states() | short_labels() | sockets_of_materials(), "a state or socket")
    for cls in CLASSES:
        found |= dict.fromkeys(labels_of(cls), cls.__name__)
    for path in SOURCES:
        found |= dict.fromkeys(texts_in(path), path.name)
    return found


def test_all_is_translated_and_no_translation_is_of_something_gone():
    said = used()
    assert {key: place for key, place in said.items() if key not in GERMAN} == {}
    # The sea's terms are those of properties, whose context is "*" in old versions.
    said |= {(SEA, text): place for (context, text), place in said.items() if context == "*"}
    assert translations.GERMAN.keys() - said.keys() == set()


@pytest.mark.only_reads
def test_nothing_is_said_untranslated():
    """Reports and drawn labels are no bare texts, but variables or calls of tr."""
    for name, call in (call for path in SOURCES for call in calls(path)):
        if name in ("report", "poll_message_set", "status_text_set", "BakeError", "LibraryError"):
            said = [node for node in call.args if isinstance(node, (ast.Constant, ast.JoinedStr))]
            assert all(node.value is None for node in said), ast.unparse(call)
        for keyword in call.keywords:
            if keyword.arg in ("text", "heading"):
                assert not isinstance(keyword.value, (ast.JoinedStr, ast.BinOp)), ast.unparse(call)


@pytest.mark.only_reads
def test_a_translation_has_the_same_placeholders():
    def fields(text: str) -> list:
        return [field[1:] for field in string.Formatter().parse(text) if field[1] is not None]

    for key, german in GERMAN.items():
        assert fields(german) == fields(key[1]), key


# The file of gettext --------------------------------------------------------------

PO = r"""
# A header.
msgid ""
msgstr ""
"Language: de\n"
"Content-Type: text/plain; charset=UTF-8\n"

#. A comment.
#: panels.py:3
msgctxt "Operator"
msgid "Bake"
msgstr "Backen"

msgid "Bake"
msgstr "Gebäck"

msgid ""
"The \"sea\", "
"{}\\{}, and a \"tide\""
msgstr "Die „See“: "
"{}\\{} und eine \"Tide\""

msgid "Not yet"
msgstr ""

#~ msgid "Gone"
#~ msgstr "Fort"
"""


@pytest.mark.only_reads
def test_a_file_of_gettext_is_read(tmp_path):
    (tmp_path / "de.po").write_text(PO, encoding="utf-8")
    assert translations.read_po(tmp_path / "de.po") == {
        ("Operator", "Bake"): "Backen",
        ("*", "Bake"): "Gebäck",
        ("*", 'The "sea", {}\\{}, and a "tide"'): 'Die „See“: {}\\{} und eine "Tide"',
    }


@pytest.mark.only_reads
def test_each_german_entry_is_read_and_stands_once():
    text = Path(translations.__file__).with_name("de.po").read_text(encoding="utf-8")
    assert text.count("msgid") == text.count("msgstr") == len(translations.GERMAN) + 1


# In Blender ---------------------------------------------------------------------


@pytest.fixture
def german():
    if "de_DE" not in bpy.app.translations.locales:
        pytest.skip("this build of Blender has no languages")
    view = bpy.context.preferences.view
    view.language = "de_DE"
    for switch in ("interface", "tooltips", "reports"):
        if hasattr(view, f"use_translate_{switch}"):
            setattr(view, f"use_translate_{switch}", True)
    yield
    view.language = "en_US"


def test_panels_and_operators_have_german_names(german):
    look_up = bpy.app.translations.pgettext_iface
    assert look_up(panels.waves_panel.bl_label) == "See"
    assert look_up(floating.float_panel.bl_label) == "Schwimmen (libocean)"
    assert look_up(operators.LoadSea.bl_label, "Operator") == "Seegang laden"


def test_blenders_own_words_do_not_come_before_the_seas(german):
    labels = {entry["label"] for entry in (*parameter_values.TABLE, *PARAMETERS.rows)}
    found = {(label, bpy.app.translations.pgettext_iface(label, SEA)) for label in labels}
    assert found == {(label, translations.GERMAN[SEA, label]) for label in labels}


def test_the_panel_asks_for_the_seas_words():
    add_ocean(64, use_material=False)
    settings = bpy.context.object.libocean
    for entry in parameter_values.TABLE:
        group = settings.waves[0] if entry["section"] == "waves" else settings
        layout = unittest.mock.MagicMock()
        panels.draw_parameter(layout, group, entry)
        drawn = layout.column.return_value
        label, context = panels.label_of(entry), SEA
        if not panels.is_used(group, entry):
            assert not layout.mock_calls
        elif is_optional(entry):
            drawn.row.assert_called_once_with(heading=label, heading_ctxt=context)
        else:
            is_resolution = entry["key"] in ("resolution", "foam_resolution")
            key = f"{entry['key']}_list" if is_resolution else entry["key"]
            drawn.prop.assert_called_once_with(group, key, text=label, text_ctxt=context)


def test_an_operator_that_fails_says_so_in_german(german):
    add_ocean(64, use_material=False)
    assert "Eine See hat mindestens ein Wellensystem" in failing(bpy.ops.libocean.remove_waves)
    said = failing(bpy.ops.libocean.bake, directory="/nowhere", frame_start=5, frame_end=3)
    assert "Das letzte Bild, 3, kommt vor dem ersten, 5" in said


def test_an_operator_that_cannot_run_says_why_in_german(german):
    plane(10.0, 3)
    assert "Das aktive Objekt hat keinen Ozean-Modifikator" in failing(bpy.ops.libocean.load_sea)


def test_the_state_of_a_bake_is_told_in_german(german, scene):
    (text, _icon) = bake_state.state(add_ocean(64, use_material=False), scene)[-1]
    assert re.match(r"Bilder 0 bis 251 mit 64 x 64 Stützstellen: höchstens [\d.]+ MB, in ", text)


def test_the_words_go_with_the_add_on(german):
    bpy.ops.preferences.addon_disable(module="libocean_addon")
    assert bpy.app.translations.pgettext_iface("Load Sea", "Operator") == "Load Sea"
    bpy.ops.preferences.addon_enable(module="libocean_addon")
    assert bpy.app.translations.pgettext_iface("Load Sea", "Operator") == "Seegang laden"


def test_what_the_library_says_stays_as_it_is(german, tmp_path):
    add_ocean(64, use_material=False)
    path = tmp_path / "bad.toml"
    path.write_text("libocean = 1\n[grid]\npatch_size = -3\n")
    assert "patch_size" in failing(bpy.ops.libocean.load_sea, filepath=str(path))
