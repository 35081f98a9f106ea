# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The parameter table of a subject, a sea or a terrain, and the traits that its Blender properties
have beside it.

    library's table -> ParameterTable -> table_properties: properties
                                      -> property_texts: texts of a file, and back
"""

from __future__ import annotations

import dataclasses
from typing import Any


@dataclasses.dataclass(frozen=True, kw_only=True)
class ParameterTable:
    """A subject's parameters, each a row as the library's JSON has it."""

    rows: list[dict[str, Any]]
    item_section: str
    """The section that a file may have several times: "waves", "terrain.layer"."""
    file_kind: str
    """The name of the subject's file in tool tips: "Sea file"."""
    files: tuple[str, ...] = ()
    """Keys of parameters that name a file."""
    copies: dict[str, str] = dataclasses.field(default_factory=dict)
    """The property with the lines of the file that a parameter names, by the parameter's key."""
    resolutions: dict[str, str] = dataclasses.field(default_factory=dict)
    """Keys of parameters that are samples per side, with the name of the choice 0; "": none."""
    lengths: dict[str, int] = dataclasses.field(default_factory=dict)
    """The max number of entries of a list, by its key."""

    def entries(self, *, items: bool) -> list[dict[str, Any]]:
        """Returns the rows of the items, or the rows of all other sections."""
        return [row for row in self.rows if (row["section"] == self.item_section) == items]


def path_of(entry: dict[str, Any]) -> str:
    """Returns the path of a parameter in its file. A subject whose sections have keys in common
    gives its rows other keys, and keeps the path as "path"."""
    return entry.get("path") or f"{entry['section']}.{entry['key']}"


def is_optional(entry: dict[str, Any]) -> bool:
    """Returns whether a parameter has a switch beside its value; "inf" counts as off."""
    if entry["type"] == "numbers":
        return entry["default"] == []
    return entry["type"] == "float" and entry["default"] in (None, "inf")


def off_value(entry: dict[str, Any]) -> str:
    """Returns the value of a parameter whose switch is off."""
    return "[]" if entry["type"] == "numbers" else entry["default"] or ""
