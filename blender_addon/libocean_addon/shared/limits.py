# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Limits of the add-on's own numbers, such as those of spray: a script that sets one beyond them
gets an error. Blender would set the nearest number without a word."""

from __future__ import annotations

from numbers import Real
from typing import Any

import numpy as np

_LARGEST = {"INT": 2**31 - 1, "FLOAT": float(np.finfo(np.float32).max)}
"""The max of a property without one, and, with a minus, about its min."""


def _allowed(prop) -> tuple[float, float, str]:
    """Returns the limits of a property of numbers, an infinite one for none, and words for both."""
    low, high, largest = prop.hard_min, prop.hard_max, _LARGEST[prop.type]
    if high >= largest:
        high = np.inf
    if low <= -largest:
        low = -np.inf
    return low, high, f"at least {low:.7g}" if high == np.inf else f"{low:.7g} .. {high:.7g}"


def _require_within(prop, value: Any) -> None:
    """Raises ValueError, in the words of a file's error, if a number is beyond the limits of its
    property."""
    if prop is None or prop.type not in _LARGEST:
        return
    low, high, allowed = _allowed(prop)
    for number in value if prop.is_array else [value]:
        if not isinstance(number, Real):  # Blender refuses other types
            continue
        kept = np.float32(number) if prop.type == "FLOAT" else number
        if kept < low or kept > high:
            fault = f"{number:.7g}: is out of range; allowed: {allowed}"
            raise ValueError(f"{prop.identifier} = {fault}")


class Limited:
    """Base of a group of properties. Panels show what Blender makes of a number; they, keyframes
    and files do not come here."""

    def __setattr__(self, name: str, value: Any) -> None:
        _require_within(self.bl_rna.properties.get(name), value)
        super().__setattr__(name, value)
