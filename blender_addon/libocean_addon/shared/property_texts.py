# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The values of a group of properties as the texts of a file, and back.

A parameter goes by the key it has in the file; one that may be left out has a switch, `use_KEY`. A
list has a fixed number of places: a number (or the first of a pair) that is 0 is a free place.
"""

from __future__ import annotations

import functools
import json
from typing import Any

import numpy as np

from . import paths
from .parameter_table import ParameterTable, is_optional, off_value

_INT = 2**31


@functools.lru_cache(maxsize=64)
def _exact(text: str) -> dict[str, str]:
    return json.loads(text) if text else {}


def shortest(value: float) -> str:
    """Returns the shortest decimal of a single-precision number: 12.3, not 12.300000190734863."""
    return str(np.float32(value))


def pairs_of(numbers) -> list[tuple[float, float]]:
    """Returns the pairs in the places of a list, without free places."""
    numbers = tuple(numbers)  # Blender's own cannot be sliced by twos
    both = zip(numbers[::2], numbers[1::2], strict=True)
    return [(first, second) for first, second in both if first > 0.0]


def _shown(value, kind: str) -> str:
    """Returns the text of a property that holds numbers."""
    if kind == "list":
        return "[" + ", ".join(str(item) for item in value if item > 0) + "]"
    if kind == "numbers":
        return "[" + ", ".join(map(shortest, value)) + "]"
    if kind == "pairs":
        pairs = (f"[{shortest(first)}, {shortest(second)}]" for first, second in pairs_of(value))
        return "[" + ", ".join(pairs) + "]"
    return shortest(value) if kind == "float" else str(value)


_HELD_INEXACTLY = ("float", "int", "numbers", "pairs")


def text_of(group, entry: dict[str, Any], table: ParameterTable) -> str:
    """Returns a parameter's value as the library reads it."""
    key, kind = entry["key"], entry["type"]
    if is_optional(entry) and not getattr(group, f"use_{key}"):
        return off_value(entry)
    value = getattr(group, key)
    if kind == "bool":
        return "true" if value else "false"
    if kind in ("text", "enum"):
        if value.startswith("//"):
            return str(paths.absolute(value, paths.library_of(group, key)))
        return paths.normal(value) if key in table.files else value
    shown = _shown(value, kind)
    # A file may have more digits than a property holds: they stay while it is not changed.
    exact, shown_then = _exact(group.exact).get(key, ("", "")) if kind != "list" else ("", "")
    return exact if exact and shown == shown_then else shown


def set_text(group, entry: dict[str, Any], text: str, table: ParameterTable) -> None:
    """Sets a property from the text of a file."""
    key, kind = entry["key"], entry["type"]
    if is_optional(entry):
        on = text not in ("", "inf", "[]")
        setattr(group, f"use_{key}", on)
        if not on:
            return
    if kind in ("list", "pairs"):
        numbers = json.loads(text)
        if kind == "pairs":
            numbers = [part for pair in numbers for part in pair]
        places = table.lengths[key] * (2 if kind == "pairs" else 1)
        setattr(group, key, [*numbers, *[0] * (places - len(numbers))])
    elif kind == "numbers":
        setattr(group, key, json.loads(text))
    elif kind == "bool":
        setattr(group, key, text == "true")
    elif kind == "float":
        setattr(group, key, float(text))
    elif kind == "int":
        setattr(group, key, max(-_INT, min(_INT - 1, int(text))))
    else:
        setattr(group, key, text)


def texts_of(group, table: ParameterTable, *, items: bool) -> dict[str, str]:
    """Returns the values of a group by their keys. group: the settings of an object, or one of
    their items, evaluated or not."""
    return {entry["key"]: text_of(group, entry, table) for entry in table.entries(items=items)}


def set_texts(group, values: dict[str, str], table: ParameterTable, *, items: bool) -> None:
    """Sets the properties of a group from the values of a file, by their keys."""
    exact = {}
    for entry in table.entries(items=items):
        key, text = entry["key"], values[entry["key"]]
        set_text(group, entry, text, table)
        if entry["type"] in _HELD_INEXACTLY and text_of(group, entry, table) != text:
            exact[key] = (text, text_of(group, entry, table))
    group.exact = json.dumps(exact) if exact else ""
