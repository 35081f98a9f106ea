# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sea files as plain values and back. No Blender in here.

A value is a text, as `ocean --set` takes it ("12.3", "inf", "jonswap", "[7, 53]"); "" is a
parameter that is not set.
"""

from __future__ import annotations

import dataclasses
import json
from typing import Any

# Tables that a resolved sea file carries beside its parameters; kept as they are.
TAKE = "[take]"
RECORD = "[waves.measured_record]"


@dataclasses.dataclass
class WaveValues:
    """One wave system."""

    values: dict[str, str]
    record: str = ""
    """The lines of its measured record."""


@dataclasses.dataclass
class SeaValues:
    """All that a sea file says."""

    values: dict[str, str]
    waves: list[WaveValues]
    take: str = ""
    """The lines of its take."""

    def structure(self) -> tuple[Any, ...]:
        """What cannot be changed parameter by parameter in an open sea."""
        return (self.take, *(system.record for system in self.waves))

    def by_name(self) -> dict[str, str]:
        """Every parameter under the name that the library knows it by: "waves.1.fetch"."""
        named = dict(self.values)
        for number, system in enumerate(self.waves):
            named.update({f"waves.{number}.{key}": text for key, text in system.values.items()})
        return named


def is_optional(entry: dict[str, Any]) -> bool:
    """Whether a parameter is switched on before it has a value; "inf" counts as off."""
    return entry["type"] == "float" and entry["default"] in (None, "inf")


def off_value(entry: dict[str, Any]) -> str:
    return entry["default"] or ""


def _line(entry: dict[str, Any], text: str) -> str:
    quoted = json.dumps(text, ensure_ascii=False) if entry["type"] in ("enum", "text") else text
    return f"{entry['key']} = {quoted}\n"


def _is_written(entry: dict[str, Any], text: str) -> bool:
    """Whether a file has a line for the value. A key that came later has none at its neutral value:
    the texts of older seas stay, and so do the recipes of their bakes."""
    return (text != "" or entry["type"] == "text") and text != entry.get("neutral")


def _section(table: list[dict[str, Any]], section: str, values: dict[str, str]) -> str:
    return "".join(
        _line(entry, values[entry["key"]])
        for entry in table
        if entry["section"] == section and _is_written(entry, values.get(entry["key"], ""))
    )


def write(table: list[dict[str, Any]], sea: SeaValues) -> str:
    """The text of a sea file. table: libocean.parameters()."""
    parts = ["libocean = 1\n"]
    sections = dict.fromkeys(entry["section"] for entry in table)
    for section in sections:
        if section != "waves" and (lines := _section(table, section, sea.values)):
            parts.append(f"\n[{section}]\n{lines}")
    for system in sea.waves:
        parts.append(f"\n[[waves]]\n{_section(table, 'waves', system.values)}")
        parts.extend(["\n", system.record] if system.record else [])
    parts.extend(["\n", sea.take] if sea.take else [])
    return "".join(parts)


def _tables(text: str) -> list[str]:
    """The text cut before each line that opens a table."""
    tables = [""]
    for line in text.splitlines(keepends=True):
        if line.startswith("["):
            tables.append("")
        tables[-1] += line
    return tables


def read(table: list[dict[str, Any]], sea) -> SeaValues:
    """The values of an open sea (libocean.Sea)."""
    values = {entry["key"]: sea.get(entry["key"]) for entry in table if entry["section"] != "waves"}
    waves: list[WaveValues] = []
    take = ""
    for text in _tables(sea.text):
        if text.startswith("[[waves]]"):
            number = len(waves)
            waves.append(
                WaveValues(
                    {
                        entry["key"]: sea.get(f"waves.{number}.{entry['key']}")
                        for entry in table
                        if entry["section"] == "waves"
                    }
                )
            )
        elif text.startswith(RECORD):
            waves[-1].record = text
        elif text.startswith(TAKE):
            take = text
    return SeaValues(values, waves, take)
