# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The values of Object.libocean_terrain as those of a terrain file, and back."""

from __future__ import annotations

from ..shared import changes, property_texts
from .parameters import DEFAULTS, PARAMETERS, PLACED, SWITCHES, switch_of
from .terrain_text import TerrainValues

_BY_RANGE = {"rms": "", "mean": "0"}
_BY_BASE = ("rms", "size", "measured", "breaks")
_BY_MEASURED = {"outer_scale": "0", "breaks": "[]"}


def is_measured(group) -> bool:
    """Returns whether the spectrum comes from a file."""
    return bool(group.measured or group.measured_rings)


def is_placed(group) -> bool:
    """Returns whether the land exists once."""
    return group.kind == "placed"


def is_on(group, name: str) -> bool:
    """Returns whether a group of parameters shapes the land: "gullies", "stream", "coast"."""
    return getattr(group, switch_of(name)) > 0.0 and (name in OF_TILES or is_placed(group))


def is_shaped(group) -> bool:
    """Returns whether the land is more than waves."""
    return is_placed(group) or is_on(group, "gullies")


OF_TILES = ("gullies",)
"""The groups that a tile may have too."""


def _has_no_effect(group) -> list[str]:
    """Returns the properties that count as unset, by kind, switches and base."""
    keys = [] if is_placed(group) else list(PLACED)
    for name in SWITCHES:
        if not is_on(group, name):
            keys += [key for key in DEFAULTS if key.startswith(f"{name}_")]
    if is_placed(group):
        keys += _BY_BASE if group.base else ["base_error"]
    return keys


def is_replaced(group, key: str) -> bool:
    """Returns whether a parameter has no effect since another one takes its place: a range replaces
    rms and mean, a measured spectrum the law, an elevation model the waves."""
    if key in _BY_RANGE and group.use_range:
        return True
    if key in _BY_BASE and is_placed(group) and group.base:
        return True
    return (key in _BY_MEASURED or key == "beta") and is_measured(group)


def values_of(group) -> TerrainValues:
    """Returns the values of the properties; properties without effect have the values of a file
    that leaves them out. group: Object.libocean_terrain, evaluated or not."""
    values = property_texts.texts_of(group, PARAMETERS, items=False)
    if group.use_range:
        values.update(_BY_RANGE)
    if is_measured(group):
        values.update(_BY_MEASURED)
    values.update({key: DEFAULTS[key] for key in _has_no_effect(group)})
    layers = [property_texts.texts_of(layer, PARAMETERS, items=True) for layer in group.layers]
    return TerrainValues(values, layers, group.measured_rings)


def assign(group, terrain: TerrainValues) -> None:
    """Puts a terrain into the properties."""
    with changes.quiet():
        group.exact = ""
        property_texts.set_texts(group, terrain.values, PARAMETERS, items=False)
        group.measured_rings = terrain.rings
        group.layers.clear()
        for layer in terrain.layers:
            property_texts.set_texts(group.layers.add(), layer, PARAMETERS, items=True)
    changes.tell(group)
