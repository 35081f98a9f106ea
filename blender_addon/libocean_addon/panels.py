# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels below the modifiers of an object with a sea, made from the parameter table."""

from __future__ import annotations

import textwrap

import bpy

from . import (
    bake,
    bake_state,
    baked,
    live,
    material,
    node_group,
    operators,
    parameter_values,
    records,
    sea_text,
    translations,
)

_CHARACTERS = 50  # of a line that a panel of usual width shows whole

_SECTIONS = {
    "water": "Water",
    "grid": "Grid",
    "surface": "Surface",
    "time": "Time",
    "random": "Random",
}


def is_used(group, entry) -> bool:
    """Whether the spectrum, say, that is chosen has this parameter."""
    chosen = {
        getattr(group, other["key"])
        for other in parameter_values.TABLE
        if other["section"] == entry["section"] and other["type"] == "enum"
    }
    return "used_by" not in entry or not chosen.isdisjoint(entry["used_by"])


def _draw_parameter(layout, group, entry) -> None:
    key = entry["key"]
    layout = layout.column()
    layout.active = is_used(group, entry)
    if not sea_text.is_optional(entry):
        layout.prop(group, key, text=entry["label"], text_ctxt=translations.SEA)
        return
    row = layout.row(heading=entry["label"], heading_ctxt=translations.SEA)
    row.prop(group, f"use_{key}", text="")
    value = row.row()
    value.active = getattr(group, f"use_{key}")
    value.prop(group, key, text="")


def _draw_section(layout, settings, section: str) -> None:
    for entry in parameter_values.entries(waves=False):
        if entry["section"] == section:
            _draw_parameter(layout, settings, entry)


class WavesList(bpy.types.UIList):
    """The wave systems of a sea"""

    bl_idname = "LIBOCEAN_UL_waves"

    def draw_item(self, _context, layout, _data, item, _icon, _active, _property, index=0) -> None:
        layout.label(text=str(index + 1), translate=False)
        layout.prop(item, "spectrum", text="", emboss=False)
        wind = layout.row()
        wind.active = item.use_wind_speed
        wind.prop(item, "wind_speed", text="", emboss=False)


class _Panel:
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "modifier"

    @classmethod
    def poll(cls, context) -> bool:
        return context.object is not None and bool(node_group.modifiers(context.object))


class OceanPanel(_Panel, bpy.types.Panel):
    """The sea of the active object"""

    bl_idname = "LIBOCEAN_PT_ocean"
    bl_label = "Ocean (libocean)"

    def draw(self, context) -> None:
        layout, settings = self.layout, context.object.libocean
        layout.use_property_split = True
        row = layout.row(align=True)
        row.operator_menu_enum(operators.LoadPreset.bl_idname, "preset", text="Preset")
        row.operator(operators.LoadSea.bl_idname, text="Load", icon="IMPORT")
        row.operator(operators.SaveSea.bl_idname, text="Save", icon="EXPORT")
        layout.operator_menu_enum(
            material.AddMaterial.bl_idname, "water_type", text="Material", icon="MATERIAL"
        )
        if settings.problem:
            layout.label(text=settings.problem, icon="ERROR", translate=False)
        if context.scene.unit_settings.scale_length != 1.0:
            layout.label(text="The sea takes a Blender unit for a metre", icon="INFO")
        self._draw_state(layout, context.object)

    @staticmethod
    def _draw_state(layout, ob) -> None:
        state = live.state_of(ob)
        if state is None:
            return
        box = layout.box().column(align=True)
        for label, text in state:
            row = box.row()
            row.label(text=label, text_ctxt=translations.SEA)
            row.label(text=text, translate=False)
        for warning in live.warnings_of(ob):
            for number, line in enumerate(textwrap.wrap(warning, _CHARACTERS)):
                box.label(text=line, icon="BLANK1" if number else "ERROR", translate=False)


class WavesPanel(_Panel, bpy.types.Panel):
    """Its wave systems"""

    bl_idname = "LIBOCEAN_PT_waves"
    bl_parent_id = OceanPanel.bl_idname
    bl_label = "Waves"

    def draw(self, context) -> None:
        layout, settings = self.layout, context.object.libocean
        row = layout.row()
        row.template_list(
            WavesList.bl_idname, "", settings, "waves", settings, "active_wave", rows=2
        )
        column = row.column(align=True)
        column.operator(operators.AddWaves.bl_idname, text="", icon="ADD")
        column.operator(operators.RemoveWaves.bl_idname, text="", icon="REMOVE")
        if settings.active_wave >= len(settings.waves):
            return
        system = settings.waves[settings.active_wave]
        layout.operator(records.PickRecord.bl_idname, icon="FILE_FOLDER").filepath = ""
        layout.use_property_split = True
        for entry in parameter_values.entries(waves=True):
            _draw_parameter(layout, system, entry)


def _section_panel(section: str, label: str) -> type:
    def draw(self, context) -> None:
        self.layout.use_property_split = True
        settings = context.object.libocean
        if section == "time":
            self.layout.prop(settings, "use_scene_frame_rate")
        _draw_section(self.layout, settings, section)
        if section == "time":
            self.layout.prop(settings, "use_custom_time")
            row = self.layout.row()
            row.active = settings.use_custom_time
            row.prop(settings, "custom_time")

    return type(
        f"{label}Panel",
        (_Panel, bpy.types.Panel),
        {
            "__doc__": f"{label} of the sea",
            "bl_idname": f"LIBOCEAN_PT_{section}",
            "bl_parent_id": OceanPanel.bl_idname,
            "bl_label": label,
            "bl_options": {"DEFAULT_CLOSED"},
            "draw": draw,
        },
    )


class MeshPanel(_Panel, bpy.types.Panel):
    """How the sea is put on the mesh"""

    bl_idname = "LIBOCEAN_PT_mesh"
    bl_parent_id = OceanPanel.bl_idname
    bl_label = "Mesh"

    def draw(self, context) -> None:
        layout, settings = self.layout, context.object.libocean
        layout.use_property_split = True
        for name in ("viewport_resolution", "render_resolution"):
            layout.prop(settings, name)
        if settings.kind == "HORIZON":
            layout.prop(settings, "horizon_distance")
            layout.prop(settings, "horizon_vertices")
        column = layout.column(heading="Attributes")
        for name in ("use_foam", "use_velocity", "use_normal"):
            column.prop(settings, name)
        layout.prop_search(settings, "mask", context.object, "vertex_groups")
        layout.prop(settings, "follow_world")


class BakePanel(_Panel, bpy.types.Panel):
    """The sea as files, which play without the add-on"""

    bl_idname = "LIBOCEAN_PT_bake"
    bl_parent_id = OceanPanel.bl_idname
    bl_label = "Bake"

    def draw(self, context) -> None:
        layout, ob = self.layout, context.object
        settings = ob.libocean
        layout.use_property_split = True
        row = layout.row()
        row.enabled = baked.exists(ob)
        row.prop(settings, "use_bake")
        layout.prop(settings.bake, "directory")
        layout.prop(settings.bake, "use_custom_range")
        column = layout.column(align=True)
        column.active = settings.bake.use_custom_range
        column.prop(settings.bake, "frame_start")
        column.prop(settings.bake, "frame_end", text="To", text_ctxt=translations.SEA)
        row = layout.row(align=True)
        row.operator(bake.BakeOcean.bl_idname, text="Bake", icon="RENDER_ANIMATION")
        row.operator(bake.FreeBake.bl_idname, text="Free")
        row.operator(bake.FreeBake.bl_idname, text="", icon="TRASH").delete_files = True
        for text, icon in bake_state.state(ob, context.scene):
            layout.label(text=text, icon=icon, translate=False)


CLASSES = (
    WavesList,
    OceanPanel,
    WavesPanel,
    *(_section_panel(section, label) for section, label in _SECTIONS.items()),
    MeshPanel,
    BakePanel,
)

register, unregister = bpy.utils.register_classes_factory(CLASSES)
