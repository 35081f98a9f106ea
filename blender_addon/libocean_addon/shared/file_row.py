# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The row of a panel with the presets and the files of a subject."""

from __future__ import annotations

from .. import translations
from .drawing import is_narrow


def draw(layout, preset, *, load, save) -> None:
    """Draws the menu of presets and the buttons of files, by their operators; where it is narrow
    each as wide as its word, without a picture."""
    narrow = is_narrow()
    load_icon, save_icon = ("NONE", "NONE") if narrow else ("IMPORT", "EXPORT")
    row = layout.split(factor=0.43, align=True) if narrow else layout.row(align=True)
    row.operator_menu_enum(preset.bl_idname, "preset", text="Preset", text_ctxt=translations.SEA)
    if narrow:
        row = row.split(factor=0.4, align=True)
    row.operator(load.bl_idname, text="Load", icon=load_icon)
    row.operator(save.bl_idname, text="Save", icon=save_icon)
