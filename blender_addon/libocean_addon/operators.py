# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators of menus, buttons and scripts: bpy.ops.libocean."""

from __future__ import annotations

import bpy
from bpy_extras import object_utils
from bpy_extras.io_utils import ExportHelper, ImportHelper

from . import translations
from .coast import node_group as coast_group
from .look import foam_images, material
from .sea import live, messages, node_group, parameter_values, sea_text
from .sea.resolutions import OF_SEA
from .shared import changes, compat, console, meshes, modifier_groups, paths
from .shared.compat import tr
from .shared.messages import of_file
from .shared.native import libocean
from .terrain import node_group as terrain_group

DEFAULT_PRESET = "beaufort_5"


PRESETS = [
    (name, name.replace("_", " ").capitalize(), f"The sea of {name.replace('_', ' ')}")
    for name in libocean.presets()
]


def adopt(ob, sea) -> None:
    """Puts an open sea into an object."""
    parameter_values.assign(ob.libocean, sea_text.read(sea))


def add_modifier(ob, kind: str = "MESH"):
    """The ocean modifier on an object that has no sea, or already one."""
    return modifier_groups.add(ob, "Ocean", lambda: node_group.get(kind))


def _start_sea(ob, preset: str) -> None:
    """A sea for an object without one."""
    if len(ob.libocean.waves) == 0:
        with libocean.preset(preset) as sea:
            adopt(ob, sea)
    live.parameters_changed(ob)


class OnOcean:
    """Base of operators on the active object's sea."""

    @classmethod
    def poll(cls, context) -> bool:
        ob = context.object
        if ob is not None and node_group.modifiers(ob):
            return True
        cls.poll_message_set(tr("The active object has no ocean modifier"))
        return False


class AddOcean(bpy.types.Operator, object_utils.AddObjectHelper):
    """Add a sea"""

    bl_idname = "libocean.add"
    bl_label = "Ocean"
    bl_options = {"REGISTER", "UNDO"}

    kind: bpy.props.EnumProperty(
        name="Kind",
        description="What the mesh is",
        items=[
            ("PATCH", "Patch", "One period of the sea, a vertex on each sample"),
            ("HORIZON", "Horizon", "Rings around the scene's camera, coarser from one to the next"),
        ],
        default="PATCH",
    )
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
    use_material: bpy.props.BoolProperty(
        name="Material",
        description="Give it a material of sea water with foam",
        default=True,
    )
    water_type: material.water_type_property()

    def execute(self, context):
        with console.work("Ocean", "a new sea"):
            self._make(context)
        return {"FINISHED"}

    def _make(self, context) -> None:
        if self.use_material:
            foam_images.prepare()
        with libocean.preset(self.preset) as sea:
            values = sea_text.read(sea)
        mesh = bpy.data.meshes.new("Ocean")
        ob = object_utils.object_data_add(context, mesh, operator=self)
        add_modifier(ob, self.kind)
        with changes.quiet():
            ob.libocean.kind = self.kind
            ob.libocean.mesh_resolution = int(self.mesh_resolution)
        parameter_values.assign(ob.libocean, values)
        if self.use_material:
            with console.work(ob.name_full, "material"):
                water = material.make(self.water_type)
                material.fit(water, ob, context.scene)
                material.assign(ob, water)


class AddModifier(bpy.types.Operator):
    """Displace the selected meshes by a sea; an object that had one shows it again"""

    bl_idname = "libocean.add_modifier"
    bl_label = "Ocean (libocean)"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context) -> bool:
        ob = context.object
        if ob is None or ob.type not in modifier_groups.DISPLACED:
            cls.poll_message_set(tr("The active object is no mesh, curve or text"))
            return False
        if node_group.modifiers(ob):
            cls.poll_message_set(tr("The active object has an ocean: add wave systems to it"))
            return False
        if terrain_group.modifiers(ob):
            cls.poll_message_set(tr("The active object has a terrain"))
            return False
        if coast_group.modifiers(ob):
            cls.poll_message_set(tr("The active object has a coast"))
            return False
        return True

    def execute(self, context):
        ob = context.object
        if ob.libocean_coast.land is not None or ob.libocean.seabed or ob.libocean.bed_lines:
            return self._mend_coast(ob)
        with changes.quiet():
            if not meshes.is_made(ob.data):
                ob.libocean.kind = "MESH"
        add_modifier(ob, ob.libocean.kind)
        _start_sea(ob, DEFAULT_PRESET)
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
        changes.tell(ob)
        return {"FINISHED"}


class LoadSea(OnOcean, bpy.types.Operator, ImportHelper):
    """Load the sea of a sea file"""

    bl_idname = "libocean.load_sea"
    bl_label = "Load Sea"
    bl_options = {"REGISTER", "UNDO"}

    filter_glob: bpy.props.StringProperty(default="*.toml", options={"HIDDEN"})

    def execute(self, context):
        ob = context.object
        try:
            with libocean.open(str(paths.absolute(self.filepath))) as sea:
                adopt(ob, sea)
        except libocean.Error as failure:
            self.report({"ERROR"}, str(failure))
            return {"CANCELLED"}
        rate = live.frame_rate(context.scene)
        if ob.libocean.fps != rate and ob.libocean.use_scene_frame_rate:
            text = tr(
                "The file says {:g} frames a second; the scene's {:g} are used",
                ob.libocean.fps,
                rate,
            )
            self.report({"INFO"}, text)
        return {"FINISHED"}


class SaveSea(OnOcean, bpy.types.Operator, ExportHelper):
    """Write the sea as a file that every libocean tool reads"""

    bl_idname = "libocean.save_sea"
    bl_label = "Save Sea"

    filename_ext = ".toml"
    filter_glob: bpy.props.StringProperty(default="*.toml", options={"HIDDEN"})

    def execute(self, context):
        values = live.current_values(context.object.libocean, context.scene)
        try:
            with libocean.parse(values.text(), base_dir=paths.blend_folder()) as sea:
                text = sea.text
            paths.write_text(self.filepath, text)
        except libocean.Error as failure:
            self.report({"ERROR"}, messages.of_error(failure))
            return {"CANCELLED"}
        except OSError as failure:
            self.report({"ERROR"}, of_file(failure))
            return {"CANCELLED"}
        return {"FINISHED"}


class LoadPreset(OnOcean, bpy.types.Operator):
    """Load the sea of a preset"""

    bl_idname = "libocean.load_preset"
    bl_label = "Sea Preset"
    bl_options = {"REGISTER", "UNDO"}

    preset: bpy.props.EnumProperty(name="Preset", description="The sea to take", items=PRESETS)

    def execute(self, context):
        with libocean.preset(self.preset) as sea:
            adopt(context.object, sea)
        return {"FINISHED"}


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
        changes.tell(context.object)
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
        changes.tell(context.object)
        return {"FINISHED"}


CLASSES = (AddOcean, AddModifier, LoadSea, SaveSea, LoadPreset, AddWaves, RemoveWaves)


def _draw_add(self, _context) -> None:
    self.layout.operator(AddOcean.bl_idname, icon="MOD_OCEAN")


def _draw_modifier(self, _context) -> None:
    self.layout.operator(AddModifier.bl_idname, icon="MOD_OCEAN")


def register() -> None:
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.VIEW3D_MT_mesh_add.append(_draw_add)
    bpy.types.VIEW3D_MT_object.append(_draw_modifier)


def unregister() -> None:
    bpy.types.VIEW3D_MT_object.remove(_draw_modifier)
    bpy.types.VIEW3D_MT_mesh_add.remove(_draw_add)
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
