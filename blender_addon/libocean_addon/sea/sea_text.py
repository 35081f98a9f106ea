# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A sea as plain values, between the library and Blender's properties. No Blender in here.

A value is a text, as `ocean --set` takes it ("12.3", "inf", "jonswap", "[7, 53]"); "" is a
parameter that is not set.
"""

from __future__ import annotations

import dataclasses
from typing import Any

from ..shared.native import libocean


@dataclasses.dataclass
class WaveValues:
    """One wave system."""

    values: dict[str, str]
    record: str = ""
    """The lines of its measured record."""


@dataclasses.dataclass
class SeaValues:
    """The values of a sea file."""

    values: dict[str, str]
    waves: list[WaveValues]
    take: str = ""
    """The lines of its take."""
    bed: str = ""
    """The lines of its bed."""
    crests: dict[str, str] = dataclasses.field(default_factory=dict)
    """The values of its crests by name, "crests.0.time"."""

    hulls: dict[str, str] = dataclasses.field(default_factory=dict)
    """The values of its hulls by name, "hulls.0.length", and the lines of their tracks by that of
    the table, "[hulls.0.track]"."""

    def structure(self) -> tuple[Any, ...]:
        """Returns the part that cannot be changed parameter by parameter in an open sea."""
        records = (system.record for system in self.waves)
        return (self.take, self.bed, len(self.crests), *records)

    def by_name(self) -> dict[str, str]:
        """Returns every parameter under the name that the library knows it by: "waves.1.fetch"."""
        named = {**self.values, **self.crests}
        for number, system in enumerate(self.waves):
            named.update({f"waves.{number}.{key}": text for key, text in system.values.items()})
        return named

    def without_bed(self) -> SeaValues:
        """Returns the values of the open sea that runs onto a coast."""
        return dataclasses.replace(self, bed="", values={**self.values, "seabed": ""})

    def without_hulls(self) -> SeaValues:
        return dataclasses.replace(self, hulls={})

    def text(self) -> str:
        """Returns the sea file of these values, not resolved."""
        tables = {_record_name(number): system.record for number, system in enumerate(self.waves)}
        tables[_TAKE] = self.take
        tables[self.bed.partition("\n")[0].strip()] = self.bed
        given = {name: text for name, text in tables.items() if text}
        return libocean.text_of_values({**self.by_name(), **self.hulls, **given})


_TAKE = "[take]"  # tables that the library names beside the parameters
_BEDS = ("[water.bed_heights]", "[water.bed_terrain]")


def _record_name(system: int) -> str:
    return f"[waves.{system}.measured_record]"


def read(sea) -> SeaValues:
    """Returns the values of an open sea (libocean.Sea)."""
    found = SeaValues({}, [])
    for name, text in sea.values.items():
        section, _, key = name.strip("[]").partition(".")
        if name == _TAKE:
            found.take = text
        elif name in _BEDS:
            found.bed = text
        elif section == "crests":
            found.crests[name] = text
        elif section == "hulls":
            found.hulls[name] = text
        elif section != "waves":
            found.values[key.rpartition(".")[2]] = text
        else:
            number, _, key = key.partition(".")
            if int(number) == len(found.waves):
                found.waves.append(WaveValues({}))
            system = found.waves[int(number)]
            if name == _record_name(int(number)):
                system.record = text
            else:
                system.values[key] = text
    return found
