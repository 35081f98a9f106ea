# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Blender properties of a subject's parameters, made from the library's table, and of its other
settings, made from a table of the add-on.

Numbers have the units of the subject's file: metres, seconds, degrees. Giving a value to a
parameter that may be left out turns it on.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import bpy

from .. import translations
from . import changes, compat
from .parameter_table import ParameterTable, is_optional, path_of
from .resolutions import Resolutions

_ADDON = Path(__file__).parents[1]
_UNITS = {"m": "LENGTH", "m/s": "VELOCITY", "m/s^2": "ACCELERATION", "s": "TIME_ABSOLUTE"}


def _description(entry: dict[str, Any], file_kind: str) -> str:
    unit = f" [{entry['unit']}]" if entry["unit"] else ""
    return f"{entry['help'].rstrip('.')}{unit}. {file_kind}: {path_of(entry)}"


def changed(self, _context) -> None:
    """The update function of a property. The group has the attribute `subject`."""
    changes.tell(self)


def _switched_on(switch: str):
    def update(self, context) -> None:
        if not changes.is_quiet():
            with changes.quiet():
                setattr(self, switch, True)
        changed(self, context)

    return update


def _named_anew(lines: str):
    """Returns the update function of a file's name. The settings keep the lines of the file as a
    copy, and a new name makes the copy void."""

    def update(self, _context) -> None:
        if not changes.is_quiet():
            setattr(self, lines, "")
        changed(self, _context)

    return update


def _label(choice: str) -> str:
    return choice.replace("_", " ").capitalize()


def _number_limits(entry: dict[str, Any]) -> dict[str, Any]:
    """Returns the soft limits of a slider. A property has no hard ones, at which Blender would set
    another value without a word: the library checks values, and the panel shows its sentence."""
    limits = {key: entry[key] for key in ("soft_min", "soft_max") if entry.get(key) is not None}
    if entry["type"] == "int":
        limits = {key: max(-(2**31), min(2**31 - 1, value)) for key, value in limits.items()}
    return limits


def _middle(entry: dict[str, Any]) -> float:
    """Where a parameter without a default begins: the middle of its soft range, by ratio where all
    of it is positive, and 0 where 0 is inside."""
    low, high = entry["soft_min"], entry["soft_max"]
    if low < 0.0 < high:
        return 0.0
    return float(f"{math.sqrt(low * high):.1g}") if low > 0 else (low + high) / 2


def _text_property(common: dict[str, Any], key: str, table: ParameterTable):
    names_a_file = key in table.files
    if names_a_file:
        common["options"] = {"ANIMATABLE", *compat.RELATIVE_PATH}
    if key in table.copies:
        common["update"] = _named_anew(table.copies[key])
    return bpy.props.StringProperty(**common, subtype="FILE_PATH" if names_a_file else "NONE")


def _switch(entry: dict[str, Any]):
    return bpy.props.BoolProperty(
        name=f"Use {entry['label']}",
        description=f"Whether {entry['label'].lower()} is given",
        update=changed,
        **compat.in_context(translations.SEA),
    )


def _vector(entry: dict[str, Any], common: dict[str, Any], size: int, **settings):
    """Returns a property of several numbers. Its limits hold for all numbers together: the library
    checks each."""
    unit = _UNITS.get(entry["unit"], "NONE")
    return bpy.props.FloatVectorProperty(**common, size=size, unit=unit, precision=3, **settings)


def properties_of(
    entry: dict[str, Any], table: ParameterTable, resolutions: Resolutions
) -> dict[str, Any]:
    """Returns the Blender properties of one parameter, by name."""
    key, kind = entry["key"], entry["type"]
    common = {
        "name": entry["label"],
        "description": _description(entry, table.file_kind),
        "update": changed,
        **compat.in_context(translations.SEA),
    }
    if kind == "text":
        return {key: _text_property(common, key, table)}
    if kind == "enum":
        items = [(choice, _label(choice), "") for choice in entry["choices"]]
        return {key: bpy.props.EnumProperty(**common, items=items, default=entry["default"])}
    if kind == "bool":
        return {key: bpy.props.BoolProperty(**common, default=entry["default"])}
    if kind == "list":
        return {key: bpy.props.IntVectorProperty(**common, size=table.lengths[key], min=0)}
    if kind == "pairs":
        return {key: _vector(entry, common, 2 * table.lengths[key], min=0.0)}
    common.update(_number_limits(entry))
    switch = f"use_{key}"
    if kind == "numbers":
        common["update"] = _switched_on(switch)
        low, high = entry["soft_min"], entry["soft_max"]
        if low > 0.0 or low == -high:  # two lengths or coordinates, no range
            ends = (_middle(entry),) * 2
        else:
            ends = tuple(float(f"{entry[end] / 10.0:.1g}") for end in ("soft_min", "soft_max"))
        return {switch: _switch(entry), key: _vector(entry, common, 2, default=ends)}
    if kind == "int":
        if key in table.resolutions:
            return resolutions.properties(
                key,
                entry["label"],
                common["description"],
                entry["default"],
                none=table.resolutions[key],
            )
        return {key: bpy.props.IntProperty(**common, default=entry["default"])}
    common["unit"] = _UNITS.get(entry["unit"], "NONE")
    common["precision"] = 3
    if not is_optional(entry):
        return {key: bpy.props.FloatProperty(**common, default=entry["default"])}
    common["update"] = _switched_on(switch)
    return {
        switch: _switch(entry),
        key: bpy.props.FloatProperty(**common, default=_middle(entry)),
    }


def annotations(table: ParameterTable, resolutions: Resolutions, *, items: bool) -> dict[str, Any]:
    """Returns the properties of the items, or of all other parameters, by name."""
    made: dict[str, Any] = {}
    for entry in table.entries(items=items):
        made.update(properties_of(entry, table, resolutions))
    return made


_MAKERS = {
    "bool": bpy.props.BoolProperty,
    "int": bpy.props.IntProperty,
    "float": bpy.props.FloatProperty,
    "floats": bpy.props.FloatVectorProperty,
    "text": bpy.props.StringProperty,
    "enum": bpy.props.EnumProperty,
}
_KEYWORDS = {"label": "name", "help": "description"}


def _setting(row: dict[str, Any], update: Callable[[Any, Any], None]) -> Any:
    """Returns the Blender property of a row: `key`, `type`, `label`, `help`, Blender's keywords for
    limits and units, `update` if a change counts at once, and a `note` for readers."""
    keywords = {_KEYWORDS.get(word, word): value for word, value in row.items()}
    make = _MAKERS[keywords.pop("type")]
    for word in ("key", "note"):
        keywords.pop(word, None)
    if "options" in keywords:
        keywords["options"] = set(keywords["options"])
    if "items" in keywords:
        keywords["items"] = [tuple(item) for item in keywords["items"]]
    if "update" in keywords:
        keywords["update"] = update
    return make(**keywords)


def settings_of(
    folder: str, update: Callable[[Any, Any], None] = changed, **limits: int
) -> dict[str, dict]:
    """Returns the properties in the table settings.json of a folder of the add-on, by group and
    name: those of its settings and of its operators. update: the function that Blender calls after
    a change. limits: numbers that texts of the table name, as {limit:,}."""
    tables = json.loads((_ADDON / folder / "settings.json").read_text(encoding="utf-8"))
    for row in (row for rows in tables.values() for row in rows):
        if "help" in row:
            row["help"] = row["help"].format(**limits)
    return {
        group: {row["key"]: _setting(row, update) for row in rows} for group, rows in tables.items()
    }
