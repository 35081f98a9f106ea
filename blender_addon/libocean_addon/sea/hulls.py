# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects whose motion makes a wake: the operators, the list of a sea's hulls and its panel, and
tracks that follow their animation.

    Add Wake -> hull_track.py: size, rows -> Object.libocean.hulls of the sea -> wakes.py
    animation changed (key_of) -> a moment later, on a timer -> rows anew
"""

from __future__ import annotations

import dataclasses

import bpy

from ..floating import riding
from ..floating.on_water import OnWater
from ..shared import (
    changes,
    drawing,
    failures,
    meshes,
    parameter_fields,
    registration,
    subject_panel,
)
from ..shared.compat import tr, tr_label
from ..shared.failures import NotShownError
from ..shared.messages import Words
from ..shared.native import libocean
from . import hull_track, hull_values, live, node_group
from .open_sea import sea_of

_PAUSE = 0.4  # [s] from a change of an animation to new rows


_WORDS = Words(hull_values.HULLS)


def left_out() -> str:
    """Returns the sentence on a bake or a volume of a sea with hulls."""
    return tr_label("The wakes of hulls do not repeat: the files of one period leave them out")


def _requires_open_sea(ocean) -> None:
    if ocean.library is not None:
        raise NotShownError(tr("{} is linked: its hulls are those of its own file", ocean.name))
    if ocean.libocean.use_custom_time:
        raise NotShownError(
            tr("{} has a time of its own, in which frames have no place", ocean.name)
        )


@dataclasses.dataclass(frozen=True)
class Found:
    """The hull that an object is."""

    size: hull_track.Size
    track: hull_track.Track
    outline: str
    key: str

    def give(self, hull, ob) -> None:
        """Puts it into the properties. A hull that the object has already keeps its size."""
        if hull.source != ob:
            hull.source, hull.name = ob, ob.name
            size = self.size
            hull.length, hull.beam, hull.draught = size.length, size.beam, size.draught
            hull.outline = self.outline
        hull.track_file, hull.track_lines = "", self.track.lines()
        hull.track_key, hull.problem = self.key, ""


def find(ocean, ob, context) -> Found:
    """Returns the hull that an object is for an ocean. Raises NotShownError."""
    _requires_open_sea(ocean)
    sea = sea_of(ocean.name_full).handle
    if sea is None:
        raise NotShownError(tr("{} shows no sea", ocean.name))
    scene = context.scene
    depsgraph = context.evaluated_depsgraph_get()
    size, middle, along_y = hull_track.measure(ob, ocean, depsgraph)
    outline = hull_track.outline(ob, ocean, depsgraph)
    track = hull_track.sample(ob, ocean, scene, sea, middle=middle, along_y=along_y)
    return Found(size, track, outline, hull_track.key_of(ob, ocean, scene))


def _report(operator, ob, hull, track) -> None:
    text = tr(
        "{}: {:.2f} m long, {:.2f} m wide, {:.2f} m deep; {:.1f} to {:.1f} m/s",
        *(ob.name, hull.length, hull.beam, hull.draught, track.slowest, track.fastest),
    )
    operator.report({"INFO"}, text)
    if track.is_sideways:
        text = tr("{} moves across its longer side, which counts as its length", ob.name)
        operator.report({"WARNING"}, text)


class AddWake(OnWater, bpy.types.Operator):
    """Have the selected objects make waves on an ocean: their size is that of the part below the
    water, and their animation is their track"""

    bl_idname = "libocean.add_wake"
    bl_label = "Wake on Ocean"

    @staticmethod
    def ask() -> str:
        return tr("Select the objects that should make waves")

    def execute(self, context):
        ocean = self.water(context, node_group.in_scene(context.scene))
        if ocean is None:
            return {"CANCELLED"}
        boats = [ob for ob in context.selected_objects if not riding.is_water(ob)]
        made = [ob for ob in boats if self._add(context, ocean, ob)]
        if made:
            changes.tell(ocean.libocean)
        return {"FINISHED"} if made else {"CANCELLED"}

    def _add(self, context, ocean, ob) -> bool:
        settings = ocean.libocean
        try:
            found = find(ocean, ob, context)
        except NotShownError as failure:
            self.report({"ERROR"}, str(failure))
            return False
        place = next((n for n, one in enumerate(settings.hulls) if one.source == ob), None)
        before = hull_values.texts_of(settings.hulls)
        with changes.quiet():
            hull = settings.hulls.add() if place is None else settings.hulls[place]
            hull.source = None
            found.give(hull, ob)
        try:
            sea_of(ocean.name_full).wakes.of(live.current_values(settings, context.scene))
        except libocean.Error as failure:
            text = f"{ob.name}: {_WORDS.of_error(failure)}"
            self.report({"ERROR"}, text)
            with changes.quiet():
                self._take_back(settings, before, place)
            return False
        settings.active_hull = len(settings.hulls) - 1 if place is None else place
        _report(self, ob, hull, found.track)
        return True

    def _take_back(self, settings, before: dict[str, str], place: int | None) -> None:
        if place is None:
            settings.hulls.remove(len(settings.hulls) - 1)
        else:
            hull_values.set_texts(settings.hulls[place], before, place)


class _OnHull:
    """Base of operators on the active hull of the active object's sea."""

    @classmethod
    def poll(cls, context) -> bool:
        ob = context.object
        if ob is not None and node_group.modifiers(ob) and active(ob) is not None:
            return True
        cls.poll_message_set(tr("The active object has no ocean with a hull"))
        return False


def active(ob):
    """Returns the active hull of a sea; None without hulls."""
    hulls, place = ob.libocean.hulls, ob.libocean.active_hull
    return hulls[place] if place < len(hulls) else None


class RemoveWake(_OnHull, bpy.types.Operator):
    """Remove the active hull: it makes no more waves"""

    bl_idname = "libocean.remove_wake"
    bl_label = "Remove Wake"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        settings = context.object.libocean
        settings.hulls.remove(settings.active_hull)
        settings.active_hull = max(0, min(settings.active_hull, len(settings.hulls) - 1))
        changes.tell(settings)
        return {"FINISHED"}


class UpdateWakes(_OnHull, bpy.types.Operator):
    """Take the tracks of all hulls from the animations of their objects again, and their sizes
    from the meshes"""

    bl_idname = "libocean.update_wakes"
    bl_label = "Update Wakes"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        ocean = context.object
        for hull in ocean.libocean.hulls:
            ob = hull.source
            if ob is None:
                continue
            try:
                found = find(ocean, ob, context)
            except NotShownError as failure:
                hull.problem = str(failure)
                self.report({"ERROR"}, hull.problem)
                continue
            with changes.quiet():
                hull.source = None
                found.give(hull, ob)
            _report(self, ob, hull, found.track)
        changes.tell(ocean.libocean)
        return {"FINISHED"}


# Following animations -----------------------------------------------------------------


def _own_seas(scene) -> list:
    """Returns the seas of the open file that have hulls. It is called at each frame."""
    with_hulls = (ob for ob in scene.objects if len(ob.libocean.hulls) > 0)
    return [ob for ob in with_hulls if ob.library is None and node_group.modifiers(ob)]


def _stale(scene) -> list:
    """Returns pairs of sea and hull whose object moves otherwise than its track."""
    return [
        (ocean, hull)
        for ocean in _own_seas(scene)
        for hull in ocean.libocean.hulls
        if hull.source is not None
        and hull.track_key != hull_track.key_of(hull.source, ocean, scene)
    ]


def _let_go(scene) -> None:
    """Removes the hulls of objects that were deleted."""
    for ocean in _own_seas(scene):
        settings = ocean.libocean
        gone = [
            n
            for n, hull in enumerate(settings.hulls)
            if hull.source is not None and not meshes.is_there(hull.source)
        ]
        for number in reversed(gone):
            settings.hulls.remove(number)
        if gone:
            settings.active_hull = min(settings.active_hull, max(0, len(settings.hulls) - 1))
            changes.tell(settings)


@failures.log_once
def _renew() -> None:
    context = bpy.context
    renewed = {}
    for ocean, hull in _stale(context.scene):
        renewed[ocean.name_full] = ocean
        try:
            found = find(ocean, hull.source, context)
        except NotShownError as failure:
            hull.problem = str(failure)
            hull.track_key = hull_track.key_of(hull.source, ocean, context.scene)
            continue
        with changes.quiet():
            found.give(hull, hull.source)
    for ocean in renewed.values():
        changes.tell(ocean.libocean)


def follow(_depsgraph, moment) -> None:
    """Has tracks that are no longer those of their objects taken again soon: a frame must not be
    changed while one is shown."""
    if moment.rendering:
        return
    _let_go(moment.scene)
    if bpy.app.timers.is_registered(_renew):
        return
    stale = _stale(moment.scene)
    if not stale:
        return
    if bpy.app.background:  # where no timer runs
        for _ocean, hull in stale:
            text = tr("The animation of {} has changed: update the wake", hull.source.name)
            if hull.problem != text:
                hull.problem = text
    else:
        bpy.app.timers.register(_renew, first_interval=_PAUSE)


# Panel ----------------------------------------------------------------------------------

_SHOWN = ("length", "beam", "draught", "shape", "factor")


class HullsList(bpy.types.UIList):
    """The hulls of a sea"""

    bl_idname = "LIBOCEAN_UL_hulls"

    def draw_item(self, _context, layout, _data, item, _icon, _active, _property, index=0) -> None:
        icon = "ERROR" if item.problem else ("OBJECT_DATA" if item.source else "FILE")
        layout.prop(item, "name", text="", emboss=False, icon=icon)


@subject_panel.Panels(node_group.modifiers, "libocean").add("hulls", "Wakes", parent="ocean")
def hulls_panel(layout, ob, _context) -> None:
    """The hulls that make waves on the sea"""
    settings = ob.libocean
    if len(settings.hulls) == 0:
        text = tr_label("Object > Wake on Ocean has an object make waves")
        drawing.say(layout, text, "INFO")
        return
    row = layout.row()
    row.template_list(HullsList.bl_idname, "", settings, "hulls", settings, "active_hull", rows=2)
    column = row.column(align=True)
    column.operator(UpdateWakes.bl_idname, text="", icon="FILE_REFRESH")
    column.operator(RemoveWake.bl_idname, text="", icon="REMOVE")
    hull = active(ob)
    if hull is None:
        return
    if hull.problem:
        drawing.say(layout, hull.problem, "ERROR")
    if hull.source is not None:
        drawing.field(layout, hull, "source")
        layout.prop(settings, "use_hull_cut")
    for entry in hull_values.HULLS.entries(items=True):
        if entry["key"] in _SHOWN:
            parameter_fields.draw(layout.column(), hull, entry, hull_values.HULLS, entry["label"])


CLASSES = (AddWake, RemoveWake, UpdateWakes, HullsList, hulls_panel)


def _draw_wake(self, _context) -> None:
    self.layout.operator(AddWake.bl_idname, icon="MOD_OCEAN")


register, unregister = registration.functions(CLASSES, menus={"VIEW3D_MT_object": _draw_wake})
