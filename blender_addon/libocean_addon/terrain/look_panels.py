# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels of a terrain's look: its mesh, the region or the camera that the mesh follows, and the
material. They are below those of panels.
"""

from __future__ import annotations

from .. import translations
from ..shared import registration, resolutions
from ..shared.compat import tr_label
from ..shared.drawing import draws, field, mask_field, say
from . import material, trees
from .panels import PANELS
from .parameter_values import is_placed, is_shaped

SIDES = ("West", "South", "East", "North")
"""The labels of the numbers of a region."""


def _is_tile(ob) -> bool:
    return ob.libocean_terrain.shape == "TILE"


@PANELS.add("terrain_look", "Look", closed=False)
def look_panel(layout, ob, context) -> None:
    """How the terrain is shown"""
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


@PANELS.add("terrain_region", "Region", parent="terrain_look", where=_is_tile)
def region_panel(layout, ob, _context) -> None:
    """A rectangle of the land, at a distance of samples of its own"""
    settings = ob.libocean_terrain
    column = layout.column(align=True)
    column.active = settings.use_region and not settings.use_lod
    for index, text in enumerate(SIDES):
        column.prop(settings, "region", index=index, text=text, text_ctxt=translations.SEA)
    column.separator()
    column.prop(settings, "region_cell")


def _region_header(layout, ob, _context) -> None:
    layout.active = not ob.libocean_terrain.use_lod
    layout.prop(ob.libocean_terrain, "use_region", text="")


region_panel.draw_header = draws(_region_header, labels=False)


@PANELS.add(
    "terrain_lod", "Level of Detail", parent="terrain_look", switch="use_lod", where=_is_tile
)
def detail_panel(layout, ob, context) -> None:
    """A mesh that is fine near the scene's camera and coarse far from it"""
    settings = ob.libocean_terrain
    column = layout.column()
    column.active = settings.use_lod
    for name in ("lod_spacing", "lod_farthest", "lod_snap"):
        column.prop(settings, name)
    if settings.use_lod and context.scene.camera is None:
        say(layout, tr_label("The scene has no camera: the mesh is a plain one"), "INFO")


@PANELS.add("terrain_ground", "Ground", parent="terrain_look", where=material.grounds)
def ground_panel(layout, ob, context) -> None:
    """The material: where snow, forest, rock and sand lie"""
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


CLASSES = (look_panel, region_panel, detail_panel, ground_panel)

register, unregister = registration.functions(CLASSES)
