# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects that ride the waves.

Where an object floats (x, y and heading) stays its own location and rotation, which may be animated
or driven; the waves move it by its delta transform, which they own. Baked, the delta transform has
keyframes and nobody else moves it.
"""

from __future__ import annotations

import contextlib
import math

import bpy
from mathutils import Matrix, Vector

from . import changes, live, node_group
from .compat import tr


def _is_ocean(_self, ob) -> bool:
    return bool(node_group.modifiers(ob))


def _changed(self, context) -> None:
    if not changes.is_quiet() and self.ocean is not None:
        ride(self.id_data, None, live.Moment(context.scene, rendering=False))


class FloatSettings(bpy.types.PropertyGroup):
    """How an object floats: it lies on the plane that fits the surface below it best"""

    ocean: bpy.props.PointerProperty(
        name="Ocean",
        description="The sea that the object rides",
        type=bpy.types.Object,
        poll=_is_ocean,
        update=_changed,
    )
    length: bpy.props.FloatProperty(
        name="Length",
        description="Along the object's own x axis: shorter waves pass below it",
        min=0.0,
        soft_max=400.0,
        default=10.0,
        unit="LENGTH",
        update=_changed,
    )
    width: bpy.props.FloatProperty(
        name="Width",
        description="Across its own x axis",
        min=0.0,
        soft_max=60.0,
        default=3.0,
        unit="LENGTH",
        update=_changed,
    )
    use_tilt: bpy.props.BoolProperty(
        name="Tilt",
        description="Pitch and roll with the waves, not only rise and fall",
        default=True,
        update=_changed,
    )

    baked_first: bpy.props.IntProperty(options={"HIDDEN"})
    baked_last: bpy.props.IntProperty(options={"HIDDEN"}, default=-1)  # no frames: not baked


def is_baked(ob) -> bool:
    """Whether keyframes move it."""
    return ob.libocean_float.baked_last >= ob.libocean_float.baked_first


def _heading(rotation: Matrix) -> float:
    """Degrees counter-clockwise from +x, of the own x axis."""
    forward = rotation.col[0]
    return math.degrees(math.atan2(forward[1], forward[0]))


def _pose(settings, ocean, rotation: Matrix, location: Vector, moment):
    """Height and rotation of the plane below; None where there is no sea."""
    to_world = ocean.matrix_world
    turn, scale = to_world.to_quaternion(), to_world.median_scale
    if not scale > 0.0:
        return None
    local = to_world.inverted() @ Vector((*location.xy, to_world.translation.z))
    anchor = to_world.translation if ocean.libocean.follow_world else Vector()
    body = (
        *(local + anchor).xy,
        _heading(turn.to_matrix().inverted() @ rotation),
        settings.length / scale,
        settings.width / scale,
    )
    pose = live.float_pose(ocean, body, moment)
    if pose is None:
        return None
    position, up, forward = (Vector(row[0].tolist()) for row in pose[:3])
    tilted = turn.to_matrix() @ Matrix((forward, up.cross(forward), up)).transposed()
    return (to_world @ Vector((*local.xy, position.z))).z, tilted


def ride(ob, depsgraph, moment) -> None:
    """Puts an object on the waves of this moment."""
    if is_baked(ob):
        return
    ocean = ob.libocean_float.ocean
    seen, sea = (o.evaluated_get(depsgraph) if depsgraph else o for o in (ob, ocean))
    rotation = _own_rotation(seen)
    pose = _pose(seen.libocean_float, sea, rotation, seen.location, moment)
    if pose is None:
        return
    height, tilted = pose
    delta_location = (0.0, 0.0, height)
    delta = Matrix.Identity(3)
    if ob.libocean_float.use_tilt:
        level = Matrix.Rotation(math.radians(_heading(rotation)), 3, "Z")
        delta = tilted @ level.inverted()
    _set_delta(ob, delta_location, delta)


def ride_all(depsgraph, moment) -> None:
    for ob in moment.scene.objects:
        if ob.libocean_float.ocean is not None:
            ride(ob, depsgraph, moment)


def _own_rotation(ob) -> Matrix:
    if ob.rotation_mode == "QUATERNION":
        return ob.rotation_quaternion.to_matrix()
    if ob.rotation_mode == "AXIS_ANGLE":
        angle, *axis = ob.rotation_axis_angle
        return Matrix.Rotation(angle, 3, axis)
    return ob.rotation_euler.to_matrix()


def _set_delta(ob, location: tuple[float, float, float], rotation: Matrix) -> None:
    """Only where it is another: to write it makes Blender evaluate the object again."""
    if tuple(ob.delta_location) != tuple(Vector(location)):
        ob.delta_location = location
    if ob.rotation_mode == "QUATERNION":
        turn = rotation.to_quaternion()
        if ob.delta_rotation_quaternion != turn:
            ob.delta_rotation_quaternion = turn
        return
    if ob.rotation_mode == "AXIS_ANGLE":
        return
    turn = rotation.to_euler(ob.rotation_mode)
    if ob.delta_rotation_euler != turn:
        ob.delta_rotation_euler = turn


def _delta_paths(ob) -> tuple[str, str]:
    quaternion = ob.rotation_mode == "QUATERNION"
    return "delta_location", "delta_rotation_quaternion" if quaternion else "delta_rotation_euler"


def _free(ob) -> None:
    """Takes the keyframes of the bake away."""
    settings = ob.libocean_float
    for frame in range(settings.baked_first, settings.baked_last + 1):
        for path in _delta_paths(ob):
            with contextlib.suppress(RuntimeError):  # somebody has removed it
                ob.keyframe_delete(path, frame=frame)
    settings.property_unset("baked_first")
    settings.property_unset("baked_last")


class AddFloat(bpy.types.Operator):
    """Make the selected objects ride the waves of an ocean"""

    bl_idname = "libocean.add_float"
    bl_label = "Float on Ocean"
    bl_options = {"REGISTER", "UNDO"}

    ocean: bpy.props.StringProperty(
        name="Ocean", description="Name of the ocean; empty: the active one, or the only one"
    )

    @classmethod
    def poll(cls, context) -> bool:
        if any(not node_group.modifiers(ob) for ob in context.selected_objects):
            return True
        cls.poll_message_set(tr("Select the objects that shall float"))
        return False

    def _find(self, context):
        oceans = [ob for ob in context.scene.objects if node_group.modifiers(ob)]
        if self.ocean:
            return next((ob for ob in oceans if ob.name == self.ocean), None)
        if context.object in oceans:
            return context.object
        return oceans[0] if len(oceans) == 1 else None

    def execute(self, context):
        ocean = self._find(context)
        if ocean is None:
            text = tr("Which ocean? Make it the active object, or give its name")
            self.report({"ERROR"}, text)
            return {"CANCELLED"}
        for ob in context.selected_objects:
            if node_group.modifiers(ob):
                continue
            if ob.rotation_mode == "AXIS_ANGLE":
                # The one mode without a delta that can be set: Blender converts the rotation.
                ob.rotation_mode = "QUATERNION"
                self.report({"INFO"}, tr("{} turns by quaternions now", ob.name))
            settings = ob.libocean_float
            with changes.quiet():
                settings.length, settings.width = ob.dimensions.xy
                settings.ocean = ocean
            ride(ob, None, live.Moment(context.scene, rendering=False))
        return {"FINISHED"}


class _OnFloating:
    """Of operators on what floats among the selected objects."""

    @classmethod
    def poll(cls, context) -> bool:
        if any(ob.libocean_float.ocean for ob in context.selected_objects):
            return True
        cls.poll_message_set(tr("None of the selected objects floats"))
        return False


class RemoveFloat(_OnFloating, bpy.types.Operator):
    """Let the selected objects float no more; they stay where they are"""

    bl_idname = "libocean.remove_float"
    bl_label = "Stop Floating"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        for ob in context.selected_objects:
            _free(ob)
            with changes.quiet():
                ob.libocean_float.ocean = None
        return {"FINISHED"}


class BakeFloat(_OnFloating, bpy.types.Operator):
    """Key how the selected objects float on each frame of the scene, and one more at each end:
    they move without the add-on"""

    bl_idname = "libocean.bake_float"
    bl_label = "Bake Floating"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        scene = context.scene
        floating = [ob for ob in context.selected_objects if ob.libocean_float.ocean]
        for ob in floating:
            _free(ob)
        now, part = scene.frame_current, scene.frame_subframe
        first, last = scene.frame_start - 1, scene.frame_end + 1
        try:
            for frame in range(first, last + 1):
                scene.frame_set(frame)  # which puts them on the waves
                for ob in floating:
                    for path in _delta_paths(ob):
                        ob.keyframe_insert(path, frame=frame)
        finally:
            for ob in floating:
                ob.libocean_float.baked_first, ob.libocean_float.baked_last = first, last
            scene.frame_set(now, subframe=part)
        return {"FINISHED"}


class FreeFloat(bpy.types.Operator):
    """Remove those keyframes: the waves move the selected objects again"""

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
                    ride(ob, None, live.Moment(context.scene, rendering=False))
        return {"FINISHED"}


class FloatPanel(bpy.types.Panel):
    """How the active object floats"""

    bl_idname = "LIBOCEAN_PT_float"
    bl_label = "Float (libocean)"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "object"

    @classmethod
    def poll(cls, context) -> bool:
        return context.object is not None and context.object.libocean_float.ocean is not None

    def draw(self, context) -> None:
        self.layout.use_property_split = True
        for name in ("ocean", "length", "width", "use_tilt"):
            self.layout.prop(context.object.libocean_float, name)
        row = self.layout.row(align=True)
        row.operator(BakeFloat.bl_idname, text="Bake")
        row.operator(FreeFloat.bl_idname, text="Free")
        self.layout.operator(RemoveFloat.bl_idname)


CLASSES = (FloatSettings, AddFloat, RemoveFloat, BakeFloat, FreeFloat, FloatPanel)


def _draw_float(self, _context) -> None:
    self.layout.operator(AddFloat.bl_idname, icon="MOD_OCEAN")


def register() -> None:
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Object.libocean_float = bpy.props.PointerProperty(type=FloatSettings)
    bpy.types.VIEW3D_MT_object.append(_draw_float)
    live.followers.append(ride_all)


def unregister() -> None:
    live.followers.remove(ride_all)
    bpy.types.VIEW3D_MT_object.remove(_draw_float)
    del bpy.types.Object.libocean_float
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
