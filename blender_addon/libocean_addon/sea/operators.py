# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators of menus, buttons and scripts: bpy.ops.libocean."""

from __future__ import annotations

import bpy
from bpy_extras import object_utils

from .. import translations
from ..coast import node_group as coast_group
from ..look import foam_images, material
from ..shared import changes, compat, console, meshes, modifier_groups, registration
from ..shared.compat import tr
from ..shared.native import libocean
from ..shared.subject_operators import (
    AddToObject,
    LoadFile,
    LoadPreset,
    OnSubject,
    SaveFile,
    give_material,
    new_object,
    preset_values,
)
from . import live, node_group, parameter_values
from .properties import SETTINGS
from .resolutions import OF_SEA
from .subject import SEA

DEFAULT_PRESET = "beaufort_5"
_KIND, _USE_MATERIAL = SETTINGS["AddOcean"].values()


PRESETS = [
    (name, name.replace("_", " ").capitalize(), f"The sea of {name.replace('_', ' ')}")
    for name in libocean.presets()
]


def add_modifier(ob, kind: str = "MESH"):
    """The ocean modifier on an object that has no sea, or already one."""
    return modifier_groups.add(ob, "Ocean", lambda: node_group.get(kind))


class OnOcean(OnSubject):
    """Base of operators on the active object's sea."""

    subject = SEA

    @staticmethod
    def absent() -> str:
        return tr("The active object has no ocean modifier")


class AddOcean(bpy.types.Operator, object_utils.AddObjectHelper):
    """Add a sea"""

    bl_idname = "libocean.add"
    bl_label = "Ocean"
    bl_options = {"REGISTER", "UNDO"}

    kind: _KIND
    preset: bpy.props.EnumProperty(
        name="Preset",
        description="The sea to begin with",
        items=PRESETS,
        default=DEFAULT_PRESET,
    )
    mesh_resolution: bpy.props.EnumProperty(
        name="Mesh resolution",
        description="Vertices along a side of a patch",
        items=OF_SEA.items("Automatic", meshes.MAX_SAMPLES),
        default="0",
        **compat.in_context(translations.SEA),
    )
    use_material: _USE_MATERIAL
    water_type: material.water_type_property()

    def execute(self, context):
        with console.work("Ocean", "a new sea"):
            self._make(context)
        return {"FINISHED"}

    def _make(self, context) -> None:
        if self.use_material:
            foam_images.prepare()
        values = preset_values(SEA.parameters, self.preset)
        ob = new_object(self, context, "Ocean", "Ocean", lambda: node_group.get(self.kind))
        with changes.quiet():
            ob.libocean.kind = self.kind
            ob.libocean.mesh_resolution = int(self.mesh_resolution)
        SEA.parameters.assign(ob, values)
        give_material(self, ob, lambda: self._give_water(context, ob))

    def _give_water(self, context, ob) -> None:
        water = material.make(self.water_type)
        material.fit(water, ob, context.scene)
        material.assign(ob, water)


class AddModifier(AddToObject, bpy.types.Operator):
    """Displace the selected meshes by a sea; an object that had one shows it again"""

    bl_idname = "libocean.add_modifier"
    bl_label = "Ocean (libocean)"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def taken(cls, row) -> str:
        if row is SEA:
            return tr("The active object has an ocean: add wave systems to it")
        return super().taken(row)

    def execute(self, context):
        ob = context.object
        if ob.libocean_coast.land is not None or ob.libocean.seabed or ob.libocean.bed_lines:
            return self._mend_coast(ob)
        with changes.quiet():
            if not meshes.is_made(ob.data):
                ob.libocean.kind = "MESH"
        add_modifier(ob, ob.libocean.kind)
        if len(ob.libocean.waves) == 0:
            SEA.parameters.assign(ob, preset_values(SEA.parameters, DEFAULT_PRESET))
        changes.tell(ob.libocean)
        return {"FINISHED"}

    def _mend_coast(self, ob) -> set[str]:
        """Gives the water of a coast its modifier again."""
        if not meshes.is_made(ob.data):
            text = tr(
                "{} has the sea of a coast, and a mesh of its own: add a coast instead", ob.name
            )
            self.report({"ERROR"}, text)
            return {"CANCELLED"}
        modifier_groups.add(ob, "Coast", coast_group.get)
        changes.tell(ob.libocean)
        return {"FINISHED"}


class LoadSea(OnOcean, LoadFile, bpy.types.Operator):
    """Load the sea of a sea file"""

    bl_idname = "libocean.load_sea"
    bl_label = "Load Sea"
    bl_options = {"REGISTER", "UNDO"}

    def use(self, context, values) -> None:
        super().use(context, values)
        settings, rate = context.object.libocean, live.frame_rate(context.scene)
        if settings.fps != rate and settings.use_scene_frame_rate:
            text = tr(
                "The file says {:g} frames a second; the scene's {:g} are used", settings.fps, rate
            )
            self.report({"INFO"}, text)


class SaveSea(OnOcean, SaveFile, bpy.types.Operator):
    """Write the sea as a file that every libocean tool reads"""

    bl_idname = "libocean.save_sea"
    bl_label = "Save Sea"


class LoadSeaPreset(OnOcean, LoadPreset, bpy.types.Operator):
    """Load the sea of a preset"""

    bl_idname = "libocean.load_preset"
    bl_label = "Sea Preset"
    bl_options = {"REGISTER", "UNDO"}

    preset: bpy.props.EnumProperty(name="Preset", description="The sea to take", items=PRESETS)

    def preset_for(self, ob):
        """Returns the sea of the preset with the crests that the object has."""
        values = super().preset_for(ob)
        values.crests = parameter_values.values_of(ob.libocean).crests
        return values


class OnSea(OnOcean):
    """Base of operators on the waves of the active object's sea, also the sea of a coast."""

    @classmethod
    def poll(cls, context) -> bool:
        ob = context.object
        return (ob is not None and bool(coast_group.modifiers(ob))) or super().poll(context)


class AddWaves(OnSea, bpy.types.Operator):
    """Add a wave system, for example a swell beside a wind sea"""

    bl_idname = "libocean.add_waves"
    bl_label = "Add Wave System"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        settings = context.object.libocean
        with changes.quiet():
            settings.waves.add().spectrum = "jonswap"
            settings.active_wave = len(settings.waves) - 1
        changes.tell(settings)
        return {"FINISHED"}


class RemoveWaves(OnSea, bpy.types.Operator):
    """Remove the active wave system"""

    bl_idname = "libocean.remove_waves"
    bl_label = "Remove Wave System"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        settings = context.object.libocean
        if len(settings.waves) < 2:
            self.report({"ERROR"}, tr("A sea has at least one wave system"))
            return {"CANCELLED"}
        settings.waves.remove(settings.active_wave)
        settings.active_wave = min(settings.active_wave, len(settings.waves) - 1)
        changes.tell(settings)
        return {"FINISHED"}


CLASSES = (AddOcean, AddModifier, LoadSea, SaveSea, LoadSeaPreset, AddWaves, RemoveWaves)


def _draw_add(self, _context) -> None:
    self.layout.operator(AddOcean.bl_idname, icon="MOD_OCEAN")


def _draw_modifier(self, _context) -> None:
    self.layout.operator(AddModifier.bl_idname, icon="MOD_OCEAN")


register, unregister = registration.functions(
    CLASSES, menus={"VIEW3D_MT_mesh_add": _draw_add, "VIEW3D_MT_object": _draw_modifier}
)
