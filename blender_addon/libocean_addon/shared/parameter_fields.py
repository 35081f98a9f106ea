# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The fields of parameters in a panel."""

from __future__ import annotations

from .. import translations
from . import resolutions
from .drawing import field, is_narrow
from .parameter_table import ParameterTable, is_optional


def draw(layout, group, entry: dict, table: ParameterTable, label: str) -> None:
    """Draws the field of a parameter, with its switch if it may be left out. Lists of numbers have
    fields of their own."""
    key = entry["key"]
    if is_optional(entry):
        _draw_switched(layout, group, entry, label)
        return
    key = resolutions.listed(key) if key in table.resolutions else key
    has_place = group.bl_rna.properties[key].type in ("INT", "FLOAT", "BOOLEAN")
    if has_place:
        layout.prop(group, key, text=label, text_ctxt=translations.SEA)
    else:
        field(layout, group, key, text=label, context=translations.SEA)


def _draw_switched(layout, group, entry: dict, label: str) -> None:
    key, inside = entry["key"], is_narrow()
    row = layout.row(heading="" if inside else label, heading_ctxt=translations.SEA)
    row.prop(group, f"use_{key}", text="")
    value = row.row()
    value.active = getattr(group, f"use_{key}")
    if entry["type"] != "numbers":
        value.prop(group, key, text=label if inside else "", text_ctxt=translations.SEA)
        return
    column = value.column(align=True)
    for index in range(group.bl_rna.properties[key].array_length):
        text = label if inside and index == 0 else ""
        column.prop(group, key, index=index, text=text, text_ctxt=translations.SEA)
