# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Blender properties of the parameters, made from the library's table.

Numbers mean what they mean in the sea file: metres, seconds, degrees. Giving a value to a parameter
that may be left out turns it on.
"""

from __future__ import annotations

import math
from typing import Any

import bpy

from .. import translations
from ..shared import changes, compat
from . import resolutions, sea_text
from .parameter_values import DIVISORS, NAMES_A_FILE, entries

_UNITS = {"m": "LENGTH", "m/s": "VELOCITY", "m/s^2": "ACCELERATION", "s": "TIME_ABSOLUTE"}


def _description(entry: dict[str, Any]) -> str:
    unit = f" [{entry['unit']}]" if entry["unit"] else ""
    return f"{entry['help'].rstrip('.')}{unit}. Sea file: {entry['section']}.{entry['key']}"


def changed(self, _context) -> None:
    changes.tell(self.id_data)


def _switched_on(switch: str):
    def update(self, context) -> None:
        if not changes.is_quiet():
            with changes.quiet():
                setattr(self, switch, True)
        changed(self, context)

    return update


def _named_anew(lines: str):
    """For the name of what a sea keeps a copy of, as lines of its file: the copy is of what was
    named before."""

    def update(self, _context) -> None:
        if not changes.is_quiet():
            setattr(self, lines, "")
        changed(self, _context)

    return update


# Parameters that name a file, or a part of one, and the property with the copy.
_COPIES = {
    "take": "take_lines",
    "file": "measured_record",
    "record": "measured_record",
    "place": "measured_record",
}


def _label(choice: str) -> str:
    return choice.replace("_", " ").capitalize()


def _number_limits(entry: dict[str, Any]) -> dict[str, Any]:
    keys = ("min", "max", "soft_min", "soft_max")
    limits = {key: entry[key] for key in keys if entry.get(key) is not None}
    if entry["type"] == "int":
        limits = {key: max(-(2**31), min(2**31 - 1, value)) for key, value in limits.items()}
    return limits


def _middle(entry: dict[str, Any]) -> float:
    """Where a parameter without a default begins: the middle of its soft range, by ratio where all
    of it is positive."""
    low, high = entry["soft_min"], entry["soft_max"]
    return float(f"{math.sqrt(low * high):.1g}") if low > 0 else (low + high) / 2


def _properties_of(entry: dict[str, Any]) -> dict[str, Any]:
    """The Blender properties of one parameter, by name."""
    key, kind = entry["key"], entry["type"]
    common = {
        "name": entry["label"],
        "description": _description(entry),
        "update": changed,
        **compat.in_context(translations.SEA),
    }
    if kind == "text":
        if key in NAMES_A_FILE:
            common["options"] = {"ANIMATABLE", *compat.RELATIVE_PATH}
        subtype = "FILE_PATH" if key in NAMES_A_FILE else "NONE"
        common["update"] = _named_anew(_COPIES[key]) if key in _COPIES else changed
        return {key: bpy.props.StringProperty(**common, subtype=subtype)}
    if kind == "enum":
        items = [(choice, _label(choice), "") for choice in entry["choices"]]
        return {key: bpy.props.EnumProperty(**common, items=items, default=entry["default"])}
    if kind == "bool":
        return {key: bpy.props.BoolProperty(**common, default=entry["default"])}
    if kind == "list":
        return {key: bpy.props.IntVectorProperty(**common, size=DIVISORS, min=0)}
    common.update(_number_limits(entry))
    if kind == "int":
        if key in resolutions.PARAMETERS:
            return resolutions.properties(
                key,
                entry["label"],
                common["description"],
                entry["default"],
                none=resolutions.PARAMETERS[key],
            )
        return {key: bpy.props.IntProperty(**common, default=entry["default"])}
    common["unit"] = _UNITS.get(entry["unit"], "NONE")
    common["precision"] = 3
    if not sea_text.is_optional(entry):
        return {key: bpy.props.FloatProperty(**common, default=entry["default"])}
    switch = f"use_{key}"
    common["update"] = _switched_on(switch)
    return {
        switch: bpy.props.BoolProperty(
            name=f"Use {entry['label']}",
            description=f"Whether {entry['label'].lower()} is given",
            update=changed,
            **compat.in_context(translations.SEA),
        ),
        key: bpy.props.FloatProperty(**common, default=_middle(entry)),
    }


def annotations(*, waves: bool) -> dict[str, Any]:
    made: dict[str, Any] = {}
    for entry in entries(waves=waves):
        made.update(_properties_of(entry))
    return made
