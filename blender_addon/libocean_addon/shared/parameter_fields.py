# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The fields of parameters in a panel."""

from __future__ import annotations

from .. import translations
from . import resolutions
from .drawing import field, is_narrow, number
from .parameter_table import ParameterTable, is_optional


def draw(layout, group, entry: dict, table: ParameterTable, label: str) -> None:
    """Draws the field of a parameter, with its switch if it may be left out. Lists of numbers have
    fields of their own."""
    key = entry["key"]
    if is_optional(entry):
        _draw_switched(layout, group, entry, label)
        return
    key = resolutions.listed(key) if key in table.resolutions else key
    kind = group.bl_rna.properties[key].type
    if kind in ("INT", "FLOAT") and entry["type"] in ("int", "float"):
        number(layout, group, key, label, translations.SEA)
    elif kind in ("INT", "FLOAT", "BOOLEAN"):
        layout.prop(group, key, text=label, text_ctxt=translations.SEA)
    else:
        field(layout, group, key, text=label, context=translations.SEA)


def _draw_switched(layout, group, entry: dict, label: str) -> None:
    """Draws a switch and its value: beside each other, or below where it is narrow."""
    key, switch, is_pair = entry["key"], f"use_{entry['key']}", entry["type"] == "numbers"
    if is_narrow():
        row = layout.column(align=True)
        row.prop(group, switch, text=label, text_ctxt=translations.SEA)
    else:
        row = layout.row(heading=label, heading_ctxt=translations.SEA)
        row.prop(group, switch, text="")
    value = row.column(align=True)
    value.active = getattr(group, switch)
    for index in range(group.bl_rna.properties[key].array_length) if is_pair else (-1,):
        value.prop(group, key, index=index, text="")
