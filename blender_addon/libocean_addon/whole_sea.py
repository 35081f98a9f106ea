# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The progress of the whole sea behind a draft: a line in the status bar and in the panel, and its
buttons."""

from __future__ import annotations

import bpy

from .shared import drafts, registration
from .shared.drawing import BUTTON, never_raises, say


class StopDraft(bpy.types.Operator):
    """Stop the work on the whole sea: the draft stays until a value, the frame or a render needs
    the whole sea again"""

    bl_idname = "libocean.stop_draft"
    bl_label = "Keep the Draft"
    bl_options = {"INTERNAL"}

    name: bpy.props.StringProperty(options={"HIDDEN", "SKIP_SAVE"})

    def execute(self, _context):
        drafts.stop(self.name)
        return {"FINISHED"}


class FinishDraft(bpy.types.Operator):
    """Make the whole sea after all"""

    bl_idname = "libocean.finish_draft"
    bl_label = "Make the Whole Sea"
    bl_options = {"INTERNAL"}

    name: bpy.props.StringProperty(options={"HIDDEN", "SKIP_SAVE"})

    def execute(self, _context):
        drafts.resume(self.name)
        return {"FINISHED"}


def draw_draft(layout, name: str, working: str, stopped: str) -> None:
    """Draws the button that stops the work on the whole of a draft, or goes on with it, each behind
    its sentence; nothing without a draft."""
    if drafts.progress(name) is not None:
        row = layout.row()
        say(row, working, "SORTTIME", beside=BUTTON)
        row.operator(StopDraft.bl_idname, text="", icon="X").name = name
    elif drafts.is_stopped(name):
        row = layout.row()
        say(row, stopped, "INFO", beside=3 * BUTTON)
        row.operator(FinishDraft.bl_idname, text="Finish").name = name


CLASSES = (StopDraft, FinishDraft)


@never_raises
def _draw_progress(self, _context) -> None:
    said, name = drafts.line()
    if said:
        row = self.layout.row(align=True)
        row.label(text=said, icon="SORTTIME", translate=False)
        row.operator(StopDraft.bl_idname, text="", icon="X").name = name


register, unregister = registration.functions(
    CLASSES, menus={"STATUSBAR_HT_header": _draw_progress}
)
