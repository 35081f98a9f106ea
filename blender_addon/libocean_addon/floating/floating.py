# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects that ride the waves: their settings, what can be done with them, their panel.

Where an object floats (x, y and heading) stays its own, whatever makes it: keyframes, drivers,
parents, constraints, paths. The waves move it from there (riding.py). Baked, their motion has
keyframes, and nothing else moves it.
"""

from __future__ import annotations

import contextlib

import bpy

from ..shared import changes, meshes, subject_panel
from ..shared.compat import tr
from ..shared.drawing import field, say
from ..shared.limits import Limited
from ..shared.subject import Moment
from ..shared.table_properties import settings_of
from . import riding
from .on_water import OnWater


def _is_ocean(_self, ob) -> bool:
    return riding.is_water(ob)


def _changed(self, context) -> None:
    if changes.is_quiet():
        return
    if self.ocean is None:
        riding.detach(self.id_data)
        return
    self.version = 1
    ride(self.id_data, None, Moment(context.scene, rendering=False))


class FloatSettings(Limited, bpy.types.PropertyGroup):
    """How an object floats: it lies on the plane that fits the surface below it best"""

    __annotations__ = {
        **settings_of("floating", _changed)["FloatSettings"],
        "ocean": bpy.props.PointerProperty(
            name="Ocean",
            description="The sea that the object rides",
            type=bpy.types.Object,
            poll=_is_ocean,
            update=_changed,
        ),
        "motion": bpy.props.PointerProperty(
            type=bpy.types.Object, options={"HIDDEN"}, description="What the waves do to it"
        ),
    }


def is_baked(ob) -> bool:
    """Returns whether keyframes move an object."""
    return ob.libocean_float.baked_last >= ob.libocean_float.baked_first


def ride(ob, depsgraph, moment) -> None:
    """Puts an object on the waves of a moment, or frees it if its ocean is gone."""
    if not meshes.is_there(ob.libocean_float.ocean):
        _let_go(ob)
    elif not is_baked(ob):
        riding.ride(ob, depsgraph, moment)


def _let_go(ob) -> None:
    _free(ob)
    riding.detach(ob)
    with changes.quiet():
        ob.libocean_float.ocean = None
        ob.libocean_float.problem = ""


def _own_motions(floating: list) -> None:
    """Gives the copy of an object a motion of its own."""
    owners = {}
    for ob in floating:
        motion = ob.libocean_float.motion
        if motion is None or owners.setdefault(motion, ob) == ob or ob.library is not None:
            continue
        constraint = riding.constraint_of(ob)
        ob.libocean_float.motion = motion.copy()
        if constraint is not None:
            constraint.target = ob.libocean_float.motion


def ride_all(depsgraph, moment) -> None:
    floating = [ob for ob in moment.scene.objects if ob.libocean_float.ocean is not None]
    _own_motions(floating)
    for ob in floating:
        ride(ob, depsgraph, moment)


# Paths of keyframes from before the waves had an object for their motion.
_OLD_PATHS = ("delta_location", "delta_rotation_euler", "delta_rotation_quaternion")


def _free(ob) -> None:
    """Removes the keyframes of the bake."""
    settings = ob.libocean_float
    if settings.motion is not None:
        settings.motion.animation_data_clear()
    elif is_baked(ob):
        for frame in range(settings.baked_first, settings.baked_last + 1):
            for path in _OLD_PATHS:
                with contextlib.suppress(RuntimeError):  # the user has removed it
                    ob.keyframe_delete(path, frame=frame)
    settings.property_unset("baked_first")
    settings.property_unset("baked_last")


class AddFloat(OnWater, bpy.types.Operator):
    """Make the selected objects ride the waves of an ocean"""

    bl_idname = "libocean.add_float"
    bl_label = "Float on Ocean"

    @staticmethod
    def ask() -> str:
        return tr("Select the objects that should float")

    def execute(self, context):
        waters = [ob for ob in context.scene.objects if riding.is_water(ob)]
        ocean = self.water(context, waters)
        if ocean is None:
            return {"CANCELLED"}
        for ob in context.selected_objects:
            if riding.is_water(ob):
                continue
            settings = ob.libocean_float
            with changes.quiet():
                settings.length, settings.width = ob.dimensions.xy
                settings.version = 1
                settings.ocean = ocean
            ride(ob, None, Moment.of_change())
            if settings.problem:
                text = f"{ob.name}: {settings.problem}"
                self.report({"ERROR"}, text)
                _let_go(ob)
        is_afloat = any(ob.libocean_float.ocean == ocean for ob in context.selected_objects)
        return {"FINISHED"} if is_afloat else {"CANCELLED"}


class _OnFloating:
    """Base of operators on the floats among the selected objects."""

    @classmethod
    def poll(cls, context) -> bool:
        if any(ob.libocean_float.ocean for ob in context.selected_objects):
            return True
        cls.poll_message_set(tr("None of the selected objects floats"))
        return False


class RemoveFloat(_OnFloating, bpy.types.Operator):
    """Stop the selected objects from floating; they stay where they are"""

    bl_idname = "libocean.remove_float"
    bl_label = "Stop Floating"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        for ob in context.selected_objects:
            if ob.libocean_float.ocean is not None:
                _let_go(ob)
        return {"FINISHED"}


class BakeFloat(_OnFloating, bpy.types.Operator):
    """Bake the motion of the selected floats to keyframes, on each frame of the scene and one more
    at each end: they move without the add-on then"""

    bl_idname = "libocean.bake_float"
    bl_label = "Bake Floating"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        scene = context.scene
        moment = Moment(scene, rendering=False)
        floating = [ob for ob in context.selected_objects if ob.libocean_float.ocean]
        for ob in floating:
            _free(ob)
            ride(ob, None, moment)
        floating = [ob for ob in floating if ob.libocean_float.motion]
        now, part = scene.frame_current, scene.frame_subframe
        first, last = scene.frame_start - 1, scene.frame_end + 1
        try:
            for frame in range(first, last + 1):
                scene.frame_set(frame)  # which puts them on the waves
                for ob in floating:
                    for path in ("location", "rotation_quaternion"):
                        ob.libocean_float.motion.keyframe_insert(path, frame=frame)
        finally:
            for ob in floating:
                ob.libocean_float.baked_first, ob.libocean_float.baked_last = first, last
            scene.frame_set(now, subframe=part)
        return {"FINISHED"}


class FreeFloat(bpy.types.Operator):
    """Remove the keyframes of baked floating: the waves move the selected objects again"""

    bl_idname = "libocean.free_float"
    bl_label = "Free Floating"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context) -> bool:
        if any(is_baked(ob) for ob in context.selected_objects):
            return True
        cls.poll_message_set(tr("None of the selected objects has baked floating"))
        return False

    def execute(self, context):
        for ob in context.selected_objects:
            if is_baked(ob):
                _free(ob)
                if ob.libocean_float.ocean is not None:
                    ride(ob, None, Moment(context.scene, rendering=False))
        return {"FINISHED"}


def _floats(ob) -> bool:
    return ob.libocean_float.ocean is not None


@subject_panel.Panels(_floats, place="object").add("float", "Float (libocean)", closed=False)
def float_panel(layout, ob, _context) -> None:
    """How the active object floats"""
    if ob.libocean_float.problem:
        say(layout, ob.libocean_float.problem, "ERROR")
    field(layout, ob.libocean_float, "ocean")
    for name in ("length", "width", "use_tilt"):
        layout.prop(ob.libocean_float, name)
    row = layout.row(align=True)
    row.operator(BakeFloat.bl_idname, text="Bake")
    row.operator(FreeFloat.bl_idname, text="Free")
    layout.operator(RemoveFloat.bl_idname)


CLASSES = (FloatSettings, AddFloat, RemoveFloat, BakeFloat, FreeFloat, float_panel)


def _draw_float(self, _context) -> None:
    self.layout.operator(AddFloat.bl_idname, icon="MOD_OCEAN")


def register() -> None:
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Object.libocean_float = bpy.props.PointerProperty(type=FloatSettings)
    bpy.types.VIEW3D_MT_object.append(_draw_float)


def unregister() -> None:
    bpy.types.VIEW3D_MT_object.remove(_draw_float)
    del bpy.types.Object.libocean_float
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
