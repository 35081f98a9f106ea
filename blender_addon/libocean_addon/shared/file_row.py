# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The row of a panel with the presets and the files of a subject."""

from __future__ import annotations

from .. import translations
from .drawing import is_narrow


def draw(layout, preset, *, load, save) -> None:
    """Draws the menu of presets and the buttons of files, by their operators; where it is narrow
    the buttons below the menu."""
    row = layout.column(align=True) if is_narrow() else layout.row(align=True)
    row.operator_menu_enum(preset.bl_idname, "preset", text="Preset", text_ctxt=translations.SEA)
    if is_narrow():
        row = row.row(align=True)
    row.operator(load.bl_idname, text="Load", icon="IMPORT")
    row.operator(save.bl_idname, text="Save", icon="EXPORT")
