# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The values of Object.libocean as the texts of a sea file, and back.

A parameter goes by the key it has in the sea file; one that may be left out has a switch,
`use_KEY`.
"""

from __future__ import annotations

import functools
import json
from typing import Any

import numpy as np

from ..shared import changes, paths
from ..shared.native import libocean
from . import sea_text

TABLE: list[dict[str, Any]] = libocean.parameters()

DIVISORS = 5  # of a list of cascades, at most

NAMES_A_FILE = ("file", "take")  # parameters


def entries(*, waves: bool) -> list[dict[str, Any]]:
    return [entry for entry in TABLE if (entry["section"] == "waves") == waves]


@functools.lru_cache(maxsize=64)
def _exact(text: str) -> dict[str, str]:
    return json.loads(text) if text else {}


def _shortest(value: float) -> str:
    """Returns the shortest decimal of a single-precision number: 12.3, not 12.300000190734863."""
    return str(np.float32(value))


def _text_of(group, entry: dict[str, Any]) -> str:
    """Returns a parameter's value as the library reads it."""
    key, kind = entry["key"], entry["type"]
    if sea_text.is_optional(entry) and not getattr(group, f"use_{key}"):
        return sea_text.off_value(entry)
    value = getattr(group, key)
    if kind == "bool":
        return "true" if value else "false"
    if kind == "list":
        return "[" + ", ".join(str(item) for item in value if item > 0) + "]"
    if kind == "float":
        shown = _shortest(value)
    elif kind == "int":
        shown = str(value)
    elif value.startswith("//"):
        return str(paths.absolute(value, paths.library_of(group, key)))
    else:
        return paths.normal(value) if key in NAMES_A_FILE else value
    # A file may say more digits than a property holds: they stay while it is not changed.
    exact, shown_then = _exact(group.exact).get(key, ("", ""))
    return exact if exact and shown == shown_then else shown


def _set_text(group, entry: dict[str, Any], text: str) -> None:
    key, kind = entry["key"], entry["type"]
    if sea_text.is_optional(entry):
        on = text not in ("", "inf")
        setattr(group, f"use_{key}", on)
        if not on:
            return
    if kind == "list":
        numbers = json.loads(text)
        setattr(group, key, [*numbers, *[0] * (DIVISORS - len(numbers))])
    elif kind == "bool":
        setattr(group, key, text == "true")
    elif kind == "float":
        setattr(group, key, float(text))
    elif kind == "int":
        setattr(group, key, max(-(2**31), min(2**31 - 1, int(text))))
    else:
        setattr(group, key, text)


def _set_texts(group, values: dict[str, str], *, waves: bool) -> None:
    exact = {}
    for entry in entries(waves=waves):
        key, text = entry["key"], values[entry["key"]]
        _set_text(group, entry, text)
        if entry["type"] in ("float", "int") and _text_of(group, entry) != text:
            exact[key] = (text, _text_of(group, entry))
    group.exact = json.dumps(exact) if exact else ""


def values_of(group) -> sea_text.SeaValues:
    """Returns the values of the properties. group: Object.libocean, evaluated or not."""
    return sea_text.SeaValues(
        {entry["key"]: _text_of(group, entry) for entry in entries(waves=False)},
        [
            sea_text.WaveValues(
                {entry["key"]: _text_of(system, entry) for entry in entries(waves=True)},
                system.measured_record,
            )
            for system in group.waves
        ],
        group.take_lines,
    )


def switch_on_given(group) -> None:
    """Switches on the parameters that have a value but no switch: files of add-ons for which they
    were never left out."""
    for owner, waves in [(group, False), *((system, True) for system in group.waves)]:
        for entry in entries(waves=waves):
            key, switch = entry["key"], f"use_{entry['key']}"
            if not sea_text.is_optional(entry) or owner.is_property_set(switch):
                continue
            if owner.is_property_set(key):
                setattr(owner, switch, True)


def assign(group, sea: sea_text.SeaValues) -> None:
    """Puts a sea into the properties."""
    with changes.quiet():
        group.exact = ""
        group.take_lines = sea.take
        _set_texts(group, sea.values, waves=False)
        group.waves.clear()
        for system in sea.waves:
            added = group.waves.add()
            added.measured_record = system.record
            _set_texts(added, system.values, waves=True)
        group.active_wave = 0
    changes.tell(group.id_data)
