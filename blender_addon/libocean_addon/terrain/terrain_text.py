# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A terrain as plain values, between the library and Blender's properties. No Blender in here.

    terrain file <-> TerrainValues <-> properties

A value is a text as a terrain file has it without quotes ("12.3", "tile", "[[440, 2.65]]"); "" is a
parameter that is not set.
"""

from __future__ import annotations

import dataclasses
import json

from ..shared.parameter_table import path_of
from .parameters import PARAMETERS, SWITCHES, switch_of

_RINGS = "[terrain.measured_rings]"  # the table in which a resolved file keeps a measured spectrum
_QUOTED = ("text", "enum")
_OFF = ("", "0", "0.0")
_FIRST = "terrain"
_PATHS = {entry["key"]: path_of(entry) for entry in PARAMETERS.entries(items=False)}
_SECTION_SWITCHES = {section: switch_of(group) for group, (section, _) in SWITCHES.items()}


@dataclasses.dataclass
class TerrainValues:
    """The values of a terrain file."""

    values: dict[str, str]
    layers: list[dict[str, str]]
    rings: str = ""
    """The lines of the measured spectrum, as a resolved file has them."""

    def structure(self) -> tuple[str, int]:
        """Returns the part that cannot be changed parameter by parameter in an open terrain."""
        return (self.rings, len(self.layers))

    def groups(self) -> tuple[str, ...]:
        """Returns the groups of parameters that are on: "gullies", "stream", "coast"."""
        return tuple(name for name in SWITCHES if self.values[switch_of(name)] not in _OFF)

    def is_placed(self) -> bool:
        return self.values["kind"] == "placed"

    def by_name(self) -> dict[str, str]:
        """Returns every parameter under its path: "terrain.layer.0.gain"."""
        named = {_PATHS[key]: text for key, text in self.values.items()}
        for number, layer in enumerate(self.layers):
            named.update({f"terrain.layer.{number}.{key}": text for key, text in layer.items()})
        return named

    def text(self) -> str:
        """Returns the terrain file of these values, not resolved."""
        parts = ["libocean = 1\n"]
        for section in dict.fromkeys(row["section"] for row in PARAMETERS.entries(items=False)):
            if section == _FIRST or self.values[_SECTION_SWITCHES[section]] not in _OFF:
                parts += [f"\n[{section}]\n", _lines(self.values, section)]
            if section == _FIRST and self.rings:
                parts += [f"\n{_RINGS}\n", self.rings, "\n"]
        for layer in self.layers:
            parts += [f"\n[[{PARAMETERS.item_section}]]\n", _lines(layer, PARAMETERS.item_section)]
        return "".join(parts)


def _lines(values: dict[str, str], section: str) -> str:
    """Returns the lines of the parameters of a section that have a value."""
    made = ""
    for entry in PARAMETERS.rows:
        text = values.get(entry["key"], "") if entry["section"] == section else ""
        if text:
            key = path_of(entry).rpartition(".")[2]
            made += f"{key} = {json.dumps(text) if entry['type'] in _QUOTED else text}\n"
    return made


def rings_in(text: str) -> str:
    """Returns the lines of the measured spectrum in a resolved file; "" without one."""
    _, found, rest = text.partition(f"\n{_RINGS}\n")
    return rest.partition("\n\n")[0].strip("\n") if found else ""


def read(terrain) -> TerrainValues:
    """Returns the values of an open terrain (libocean.Terrain)."""
    text = terrain.text
    values = {
        entry["key"]: terrain.get(path_of(entry)) for entry in PARAMETERS.entries(items=False)
    }
    layers = [
        {
            entry["key"]: terrain.get(f"terrain.layer.{number}.{entry['key']}")
            for entry in PARAMETERS.entries(items=True)
        }
        for number in range(text.count("\n[[terrain.layer]]\n"))
    ]
    return TerrainValues(values, layers, rings_in(text))
