# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels of a terrain's look: its mesh, the region or the camera that the mesh follows, and the
material. They are below those of panels.
"""

from __future__ import annotations

import bpy

from .. import translations
from ..shared import resolutions
from ..shared.compat import tr_label
from ..shared.drawing import draws, field, mask_field, never_raises, say
from . import material, trees
from .panels import ObjectPanel, TerrainPanel
from .parameter_values import is_placed, is_shaped

SIDES = ("West", "South", "East", "North")
"""The labels of the numbers of a region."""


class TerrainLookPanel(ObjectPanel, bpy.types.Panel):
    """How the terrain is shown"""

    bl_idname = "LIBOCEAN_PT_terrain_look"
    bl_parent_id = TerrainPanel.bl_idname
    bl_label = "Look"

    @draws
    def draw(self, layout, ob, context) -> None:
        settings = ob.libocean_terrain
        layout.operator(material.AddTerrainMaterial.bl_idname, text="Material", icon="MATERIAL")
        if settings.shape == "TILE" and not (settings.use_lod or settings.use_region):
            listed = resolutions.listed("mesh_resolution")
            field(layout, settings, listed, text="Mesh", context=translations.SEA)
            if not is_placed(settings):
                layout.prop(settings, "tiles")
        layout.operator(trees.AddTrees.bl_idname, icon="OUTLINER_OB_POINTCLOUD")
        layout.prop(settings, "use_normal")
        if not is_shaped(settings):
            layout.prop(settings, "use_slope")
        mask_field(layout, settings, ob)
        layout.prop(settings, "follow_world")


class RegionPanel(ObjectPanel, bpy.types.Panel):
    """A rectangle of the land, at a distance of samples of its own"""

    bl_idname = "LIBOCEAN_PT_terrain_region"
    bl_parent_id = TerrainLookPanel.bl_idname
    bl_label = "Region"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context) -> bool:
        return super().poll(context) and context.object.libocean_terrain.shape == "TILE"

    @never_raises
    def draw_header(self, context) -> None:
        settings = context.object.libocean_terrain
        self.layout.active = not settings.use_lod
        self.layout.prop(settings, "use_region", text="")

    @draws
    def draw(self, layout, ob, _context) -> None:
        settings = ob.libocean_terrain
        column = layout.column(align=True)
        column.active = settings.use_region and not settings.use_lod
        for index, text in enumerate(SIDES):
            column.prop(settings, "region", index=index, text=text, text_ctxt=translations.SEA)
        column.separator()
        column.prop(settings, "region_cell")


class DetailPanel(ObjectPanel, bpy.types.Panel):
    """A mesh that is fine near the scene's camera and coarse far from it"""

    bl_idname = "LIBOCEAN_PT_terrain_lod"
    bl_parent_id = TerrainLookPanel.bl_idname
    bl_label = "Level of Detail"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context) -> bool:
        return super().poll(context) and context.object.libocean_terrain.shape == "TILE"

    @never_raises
    def draw_header(self, context) -> None:
        self.layout.prop(context.object.libocean_terrain, "use_lod", text="")

    @draws
    def draw(self, layout, ob, context) -> None:
        settings = ob.libocean_terrain
        column = layout.column()
        column.active = settings.use_lod
        for name in ("lod_spacing", "lod_farthest", "lod_snap"):
            column.prop(settings, name)
        if settings.use_lod and context.scene.camera is None:
            say(layout, tr_label("The scene has no camera: the mesh is a plain one"), "INFO")


class GroundPanel(ObjectPanel, bpy.types.Panel):
    """The material: where snow, forest, rock and sand lie"""

    bl_idname = "LIBOCEAN_PT_terrain_ground"
    bl_parent_id = TerrainLookPanel.bl_idname
    bl_label = "Ground"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context) -> bool:
        return super().poll(context) and bool(material.grounds(context.object))

    @draws
    def draw(self, layout, ob, context) -> None:
        column = layout.column()
        for ground in material.grounds(ob)[:1]:
            for socket in ground.inputs:
                if socket.is_linked:
                    continue
                label, context = socket.name, translations.SEA
                if socket.type == "RGBA":
                    field(column, socket, "default_value", text=label, context=context)
                else:
                    column.prop(socket, "default_value", text=label, text_ctxt=context)


CLASSES = (TerrainLookPanel, RegionPanel, DetailPanel, GroundPanel)

register, unregister = bpy.utils.register_classes_factory(CLASSES)
