# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Samples a side: powers of two. Each such property is a number, for scripts, keyframes and files,
and a list of what is allowed, for the panel; both are one value.
"""

from __future__ import annotations

import math
from typing import Any

import bpy

from .. import translations
from ..shared import changes, compat
from .parameter_values import TABLE

_ENTRY = next(entry for entry in TABLE if entry["key"] == "resolution")
# The parameters that are resolutions, with what their lists call 0.
PARAMETERS = {"resolution": "", "foam_resolution": "Map's own"}
SIZES = [1 << k for k in range(20) if _ENTRY["min"] <= 1 << k <= _ENTRY["max"]]


def nearest(samples: int) -> int:
    """The power of two that is allowed and nearest by ratio; 0 is what stands for none."""
    if samples <= 0:
        return 0
    return max(SIZES[0], min(SIZES[-1], 1 << round(math.log2(samples))))


def _bytes_of(samples: int) -> str:
    """Returns the size of one image, in words."""
    size = 16 * samples * samples
    return f"{size / 2**30:.1f} GB" if size >= 2**30 else f"{size / 2**20:.1f} MB"


def items(none: str, most: int) -> list[tuple[str, str, str, str, int]]:
    """Returns the choices of a list. none: the name of the choice 0; "": without that choice."""
    made = [
        (str(n), str(n), f"{n * n:,} samples, {_bytes_of(n)} an image", "NONE", n)
        for n in SIZES
        if n <= most
    ]
    return [("0", none, "As many as the maps of the sea", "NONE", 0), *made] if none else made


def listed(name: str) -> str:
    """The name of the list beside a number."""
    return f"{name}_list"


def _update(name: str):
    def update(self, _context) -> None:
        value = getattr(self, name)
        allowed = nearest(value)
        if allowed != value:
            setattr(self, name, allowed)  # which comes back here
            return
        changes.tell(self.id_data)

    return update


def _get(name: str):
    return lambda self: nearest(getattr(self, name))


def _set(name: str):
    return lambda self, value: setattr(self, name, value)


def properties(
    name: str, label: str, description: str, default: int, *, none: str = "", most: int = SIZES[-1]
) -> dict[str, Any]:
    """The number and its list. none: what the list calls 0."""
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
            **common, items=items(none, most), get=_get(name), set=_set(name), options=set()
        ),
    }
