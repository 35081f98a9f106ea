# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators on the crests on cue of a sea: add, remove, go to, find."""

from __future__ import annotations

import math

import bpy

from ..shared import changes, console, overrides, paths, registration
from ..shared.compat import tr
from ..shared.native import libocean
from . import crests, live, messages, node_group
from .properties import SETTINGS

_HEIGHT, _UNIT = SETTINGS["AddCrest"].values()
_GO_TO_FRAME, _MOVE_CURSOR = SETTINGS["FindCrest"].values()


def ocean_of(context):
    """Returns the active object, if it has a sea, or the sea that has it as the empty of a crest,
    or the only sea of the scene; else None."""
    ob = context.object
    if ob is not None and node_group.modifiers(ob):
        return ob
    oceans = node_group.in_scene(context.scene)
    own = [other for other in oceans if any(row.empty == ob for row in crests.used(other.libocean))]
    found = own if ob is not None and own else oceans
    return found[0] if len(found) == 1 else None


def crest_of(context, index: int):
    """Returns the ocean, and one of its crests by the number of its row, -1: of the active empty or
    the active row; None without one."""
    ob = ocean_of(context)
    if ob is None:
        return None, None
    settings = ob.libocean
    if index < 0:
        rows = [row.empty for row in settings.crests]
        is_own = context.object in rows
        index = rows.index(context.object) if is_own else settings.active_crest
    return ob, index if index < len(settings.crests) else None


class _OnOcean:
    """Base of operators on the sea that ocean_of() finds."""

    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context) -> bool:
        if ocean_of(context) is not None:
            return True
        cls.poll_message_set(tr("Which ocean? Make it the active object"))
        return False


class AddCrest(_OnOcean, bpy.types.Operator):
    """Have the sea make a crest at the 3D cursor and at the frame that is shown. Its place is a new
    empty"""

    bl_idname = "libocean.add_crest"
    bl_label = "Add Crest Here"

    height: _HEIGHT
    unit: _UNIT

    def execute(self, context):
        ob, scene = ocean_of(context), context.scene
        settings = ob.libocean
        if len(crests.used(settings)) >= crests.MOST:
            self.report({"ERROR"}, tr("A sea has at most {} crests", crests.MOST))
            return {"CANCELLED"}
        overrides.make_editable(ob)
        with changes.quiet():
            row = crests.add(ob, scene.cursor.location)
            row.frame, row.height, row.unit = scene.frame_current_final, self.height, self.unit
            at = live.own_time(settings)
            if at is not None:
                row.use_time, row.time = True, at
            settings.active_crest = len(settings.crests) - 1
        changes.tell(settings)
        if settings.problem:
            self.report({"WARNING"}, settings.problem)
        return {"FINISHED"}


class _OnCrest(_OnOcean):
    """Base of operators on one crest."""

    index: bpy.props.IntProperty(default=-1, options={"HIDDEN", "SKIP_SAVE"})

    @classmethod
    def poll(cls, context) -> bool:
        if not super().poll(context):
            return False
        if crest_of(context, -1)[1] is not None:
            return True
        cls.poll_message_set(tr("There is no crest on cue"))
        return False


class RemoveCrest(_OnCrest, bpy.types.Operator):
    """Remove a crest on cue, and its empty"""

    bl_idname = "libocean.remove_crest"
    bl_label = "Remove Crest"

    def execute(self, context):
        ob, index = crest_of(context, self.index)
        if index is None:
            return {"CANCELLED"}
        settings = ob.libocean
        with changes.quiet():
            crests.remove(settings, index)
            settings.active_crest = max(0, min(settings.active_crest, len(settings.crests) - 1))
        changes.tell(settings)
        return {"FINISHED"}


class GoToCrest(_OnCrest, bpy.types.Operator):
    """Go to the frame at which a crest is highest"""

    bl_idname = "libocean.go_to_crest"
    bl_label = "Go to Frame"

    def execute(self, context):
        ob, index = crest_of(context, self.index)
        if index is None:
            return {"CANCELLED"}
        settings, scene = ob.libocean, context.scene
        row = settings.crests[index]
        frame = row.frame
        if row.use_time and not settings.use_custom_time:
            frame = crests.frame_of(live.current_values(settings, scene).values, row.time)
        whole = math.floor(frame + 1e-3)
        scene.frame_set(whole, subframe=max(0.0, min(frame - whole, 0.999)))
        return {"FINISHED"}


class FindCrest(_OnOcean, bpy.types.Operator):
    """Find the highest crest that the sea has by itself in the frames of the scene, without its
    crests on cue"""

    bl_idname = "libocean.find_crest"
    bl_label = "Find Crest"

    go_to_frame: _GO_TO_FRAME
    move_cursor: _MOVE_CURSOR

    def execute(self, context):
        ob, scene = ocean_of(context), context.scene
        values = live.current_values(ob.libocean, scene)
        values.crests = {}
        times = (
            crests.time_of(values.values, frame) for frame in (scene.frame_start, scene.frame_end)
        )
        try:
            with (
                console.work(ob.name_full, "the highest crest"),
                libocean.parse(values.text(), base_dir=paths.blend_folder()) as sea,
            ):
                found = sea.find_crest(*times)
                hs = sea.state["significant_wave_height"]["resolved"]
        except libocean.Error as failure:
            self.report({"ERROR"}, messages.of_error(failure))
            return {"CANCELLED"}
        # The sea repeats: its nearest place to the middle of the object counts.
        labels, _ = crests.to_labels(ob)
        place = labels @ ob.matrix_world.translation
        period = float(values.values["patch_size"])
        place.x += math.remainder(found.x - place.x, period)
        place.y += math.remainder(found.y - place.y, period)
        place = labels.inverted_safe() @ place
        frame = round(crests.frame_of(values.values, found.time))
        if self.move_cursor:
            scene.cursor.location = place
        if self.go_to_frame and not ob.libocean.use_custom_time:
            scene.frame_set(frame)
        text = tr(
            "Highest crest: {:.2f} m, {:.2f} Hs, at frame {} ({:.2f} s) and {:.1f}, {:.1f} m",
            *(found.height, found.height / hs, frame, found.time, place.x, place.y),
        )
        self.report({"INFO"}, text)
        return {"FINISHED"}


CLASSES = (AddCrest, RemoveCrest, GoToCrest, FindCrest)


def _draw_crest(self, _context) -> None:
    self.layout.operator(AddCrest.bl_idname, icon="MOD_OCEAN")


register, unregister = registration.functions(CLASSES, menus={"VIEW3D_MT_object": _draw_crest})
