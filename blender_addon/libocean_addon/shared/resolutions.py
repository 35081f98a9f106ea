# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Samples per side: powers of two. Each such property is a number, for scripts, keyframes and
files, and a list of the allowed numbers, for the panel; both are one value. A script that sets
another number gets the error of a file; a keyframe or driver gets the nearest one.
"""

from __future__ import annotations

import math
from typing import Any

import bpy

from .. import translations
from . import changes, compat
from .native import libocean
from .parameter_table import ParameterTable

_ENTRY = next(entry for entry in libocean.parameters() if entry["key"] == "resolution")
SIZES = [1 << k for k in range(20) if _ENTRY["min"] <= 1 << k <= _ENTRY["max"]]
"""The samples per side of maps, of seas as of terrains."""


def nearest(samples: int) -> int:
    """Returns the power of two that is allowed and nearest by ratio; 0 is what stands for none."""
    if samples <= 0:
        return 0
    return max(SIZES[0], min(SIZES[-1], 1 << round(math.log2(samples))))


def _bytes_of(samples: int) -> str:
    """Returns the size of one image, in words."""
    size = 16 * samples * samples
    return f"{size / 2**30:.1f} GB" if size >= 2**30 else f"{size / 2**20:.1f} MB"


def items(none: str, most: int, help_of_none: str) -> list[tuple[str, str, str, str, int]]:
    """Returns the choices of a list. none: the name of the choice 0; "": without that choice."""
    made = [
        (str(n), str(n), f"{n * n:,} samples, {_bytes_of(n)} an image", "NONE", n)
        for n in SIZES
        if n <= most
    ]
    return [("0", none, help_of_none, "NONE", 0), *made] if none else made


def listed(name: str) -> str:
    """Returns the name of the list beside a number."""
    return f"{name}_list"


def _update(name: str):
    def update(self, _context) -> None:
        value = getattr(self, name)
        allowed = nearest(value)
        if allowed != value:
            setattr(self, name, allowed)  # which comes back here
            return
        changes.tell(self)

    return update


def _get(name: str):
    return lambda self: nearest(getattr(self, name))


def _set(name: str):
    return lambda self, value: setattr(self, name, value)


class Resolutions:
    """The properties of samples per side of one subject's settings."""

    def __init__(self, table: ParameterTable, help_of_none: str) -> None:
        """help_of_none: the tool tip of the choice 0."""
        self._sections = {row["key"]: row["section"] for row in reversed(table.rows)}
        self._help_of_none = help_of_none
        self._allowed: dict[str, tuple[bool, int]] = {}  # by name: whether it may be 0; its max

    def require_allowed(self, name: str, value: Any) -> None:
        """Raises ValueError, in the words of a file's error, if a property of samples per side
        cannot have this value."""
        if name not in self._allowed or not isinstance(value, int):  # Blender refuses other types
            return
        may_be_0, most = self._allowed[name]
        if (value == 0 and may_be_0) or (value in SIZES and value <= most):
            return
        is_inside = SIZES[0] <= value <= most
        fault = "is not a power of two" if is_inside else "is out of range"
        allowed = f"a power of two, {'0 or ' if may_be_0 else ''}{SIZES[0]} .. {most}"
        raise ValueError(f"{self._name_in_file(name)} = {value}: {fault}; allowed: {allowed}")

    def _name_in_file(self, name: str) -> str:
        """Returns the name of a property in the subject's file, or its own name."""
        return f"{self._sections[name]}.{name}" if name in self._sections else name

    def items(self, none: str, most: int) -> list[tuple[str, str, str, str, int]]:
        """Returns the choices of a list. none: the name of the choice 0; "": without it."""
        return items(none, most, self._help_of_none)

    def properties(
        self,
        name: str,
        label: str,
        description: str,
        default: int,
        *,
        none: str = "",
        most: int = SIZES[-1],
    ) -> dict[str, Any]:
        """Returns the number and its list. none: the name of the choice 0 in the list."""
        self._allowed[name] = bool(none), most
        common = {"name": label, "description": description, **compat.in_context(translations.SEA)}
        return {
            name: bpy.props.IntProperty(
                **common,
                default=default,
                min=0 if none else SIZES[0],
                max=most,
                soft_max=min(most, _ENTRY.get("soft_max") or most),
                update=_update(name),
            ),
            listed(name): bpy.props.EnumProperty(
                **common,
                items=self.items(none, most),
                get=_get(name),
                set=_set(name),
                options=set(),
            ),
        }
