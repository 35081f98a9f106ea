# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels of crests on cue: their list below the sea's, and one of the empty of a crest."""

from __future__ import annotations

import bpy

from ..shared import registration, subject_panel
from ..shared.compat import tr_label
from ..shared.drawing import field, say
from . import crest_operators, crests
from .panels import PANELS


def _told(row) -> str:
    """Returns frame, or time, and height of a crest."""
    when = f"{row.time:g} s" if row.use_time else f"{row.frame:g}"
    return f"{when}, {row.height:.3g} " + ("Hs" if row.unit == "HS" else "m")


def _row_of(empty):
    """Returns the crest of an empty in the scene; None for other objects."""
    seas = (ob.libocean.crests for ob in bpy.context.scene.objects)
    return next((row for rows in seas for row in rows if row.empty == empty), None)


class CrestList(bpy.types.UIList):
    """The crests on cue of a sea"""

    bl_idname = "LIBOCEAN_UL_crests"

    def draw_item(self, _context, layout, _data, item, _icon, _active, _property, index=0) -> None:
        row = layout.row()
        if not crests.is_used(item):
            row.label(text=tr_label("Its empty is deleted"), translate=False)
        else:
            row.prop(item.empty, "name", text="", emboss=False, icon="EMPTY_ARROWS")
            row.label(text=_told(item), translate=False)
        row.operator(
            crest_operators.GoToCrest.bl_idname, text="", icon="TIME", emboss=False
        ).index = index


def _draw_crest(layout, row) -> None:
    field(layout, row, "empty")
    layout.prop(row, "use_time")
    layout.prop(row, "time" if row.use_time else "frame")
    column = layout.column(align=True)
    column.prop(row, "height")
    field(column, row, "unit")
    layout.prop(row, "use_direction")


@PANELS.add("crests", "Crests on Cue")
def crests_panel(layout, ob, _context) -> None:
    """Crests that the sea makes at a place and a frame"""
    settings = ob.libocean
    row = layout.row()
    row.template_list(CrestList.bl_idname, "", settings, "crests", settings, "active_crest", rows=2)
    column = row.column(align=True)
    column.operator(crest_operators.AddCrest.bl_idname, text="", icon="ADD")
    remove = column.operator(crest_operators.RemoveCrest.bl_idname, text="", icon="REMOVE")
    remove.index = settings.active_crest
    if settings.active_crest < len(settings.crests):
        _draw_crest(layout, settings.crests[settings.active_crest])
    layout.operator(crest_operators.FindCrest.bl_idname, icon="VIEWZOOM")


def _marks_a_crest(ob) -> bool:
    return ob.type == "EMPTY" and _row_of(ob) is not None


@subject_panel.Panels(_marks_a_crest, place="object").add("crest", "Crest (libocean)", closed=False)
def empty_panel(layout, ob, _context) -> None:
    """The crest at the active empty"""
    row = _row_of(ob)
    if row.id_data.libocean.problem:
        say(layout, row.id_data.libocean.problem, "ERROR")
    _draw_crest(layout, row)
    line = layout.row(align=True)
    line.operator(crest_operators.GoToCrest.bl_idname)
    line.operator(crest_operators.RemoveCrest.bl_idname, text="Remove")


CLASSES = (CrestList, crests_panel, empty_panel)

register, unregister = registration.functions(CLASSES)
