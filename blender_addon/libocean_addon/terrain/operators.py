# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators of terrains: bpy.ops.libocean."""

from __future__ import annotations

import bpy
from bpy_extras import object_utils

from .. import translations
from ..shared import changes, compat, console, meshes, modifier_groups, registration
from ..shared.compat import tr
from ..shared.native import libocean
from ..shared.property_texts import pairs_of
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
from . import material, node_group
from .parameters import PAIRS, RESOLUTIONS
from .properties import SETTINGS
from .subject import TERRAIN

DEFAULT_PRESET = "big_tujunga"
"""Mountains with gullies."""
_MESH_PRESET = "tujunga"
"""The terrain of the user's own mesh, which may be small: a tile of any size can have its law."""
_START_UP_CLIP = (100.0, 1000.0)
"""[m] How far the cameras of Blender's start-up files see, which ends before most lands do."""
_TILES, _USE_MATERIAL = SETTINGS["AddTerrain"].values()

PRESETS = [
    (name, name.replace("_", " ").title(), f"The terrain of {name.replace('_', ' ').title()}")
    for name in libocean.terrain_presets()
]


class OnTerrain(OnSubject):
    """Base of operators on the active object's terrain."""

    subject = TERRAIN

    @staticmethod
    def absent() -> str:
        return tr("The active object has no terrain modifier")


def _show_all_of(context, size: float) -> None:
    """Has the 3D view that an operator was called from show a new terrain of that size [m], which
    is larger than most scenes."""
    space, region = context.space_data, context.region
    if space is None or space.type != "VIEW_3D" or region is None or region.type != "WINDOW":
        return
    space.clip_end = max(space.clip_end, 10.0 * size)
    context.view_layer.update()
    bpy.ops.view3d.view_selected()


def _mesh_resolution_property():
    return bpy.props.EnumProperty(
        name="Mesh resolution",
        description="Vertices along a side of a tile, and cells along that of a land that exists "
        "once",
        items=RESOLUTIONS.items("Automatic", meshes.MAX_SAMPLES),
        default="0",
        **compat.in_context(translations.SEA),
    )


class AddTerrain(bpy.types.Operator, object_utils.AddObjectHelper):
    """Add a terrain: land by a spectrum that repeats after its tile"""

    bl_idname = "libocean.add_terrain"
    bl_label = "Terrain"
    bl_options = {"REGISTER", "UNDO"}

    preset: bpy.props.EnumProperty(
        name="Preset",
        description="The terrain to begin with",
        items=PRESETS,
        default=DEFAULT_PRESET,
    )
    mesh_resolution: _mesh_resolution_property()
    tiles: _TILES
    use_material: _USE_MATERIAL

    def execute(self, context):
        values = preset_values(TERRAIN.parameters, self.preset)
        _add(self, context, values, int(self.mesh_resolution), self.tiles)
        return {"FINISHED"}


def _add(operator, context, values, mesh_resolution: int, tiles: int = 1) -> None:
    """Adds an object with the terrain of these values. operator: one that adds objects, and has
    `use_material`."""
    with console.work("Terrain", "a new terrain"):
        ob = new_object(operator, context, "Terrain", "Terrain", node_group.get)
        settings = ob.libocean_terrain
        with changes.quiet():
            settings.shape = "TILE"
            settings.mesh_resolution = mesh_resolution
            settings.tiles = tiles
        TERRAIN.parameters.assign(ob, values)
        give_material(operator, ob, lambda: material.give(ob, context.scene.world))
    size = settings.patch_size * tiles
    camera = context.scene.camera
    if camera is not None and camera.type == "CAMERA" and camera.data.clip_end in _START_UP_CLIP:
        camera.data.clip_end = 10.0 * size
    _show_all_of(context, size)


class AddTerrainFile(LoadFile, bpy.types.Operator, object_utils.AddObjectHelper):
    """Add the terrain of a terrain file: a tile, or a land that lies where the file places it"""

    bl_idname = "libocean.add_terrain_file"
    bl_label = "Terrain File"
    bl_options = {"REGISTER", "UNDO"}

    subject = TERRAIN
    mesh_resolution: _mesh_resolution_property()
    use_material: _USE_MATERIAL

    def use(self, context, values) -> None:
        _add(self, context, values, int(self.mesh_resolution))


class AddTerrainModifier(AddToObject, bpy.types.Operator):
    """Raise the active mesh by a terrain"""

    bl_idname = "libocean.add_terrain_modifier"
    bl_label = "Terrain (libocean)"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        modifier_groups.add(context.object, "Terrain", node_group.get)
        TERRAIN.parameters.assign(context.object, preset_values(TERRAIN.parameters, _MESH_PRESET))
        return {"FINISHED"}


class LoadTerrain(OnTerrain, LoadFile, bpy.types.Operator):
    """Load the terrain of a terrain file"""

    bl_idname = "libocean.load_terrain"
    bl_label = "Load Terrain"
    bl_options = {"REGISTER", "UNDO"}


class SaveTerrain(OnTerrain, SaveFile, bpy.types.Operator):
    """Write the terrain as a file that every libocean tool reads"""

    bl_idname = "libocean.save_terrain"
    bl_label = "Save Terrain"


class LoadTerrainPreset(OnTerrain, LoadPreset, bpy.types.Operator):
    """Load the terrain of a preset"""

    bl_idname = "libocean.load_terrain_preset"
    bl_label = "Terrain Preset"
    bl_options = {"REGISTER", "UNDO"}

    preset: bpy.props.EnumProperty(name="Preset", description="The terrain to load", items=PRESETS)


# Items of the parameters ------------------------------------------------------


class AddTerrainLayer(OnTerrain, bpy.types.Operator):
    """Add a layer: a further tile over the first one, of half its period"""

    bl_idname = "libocean.add_terrain_layer"
    bl_label = "Add Layer"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        settings = context.object.libocean_terrain
        if len(settings.layers) >= PAIRS:
            self.report({"ERROR"}, tr("A terrain has at most {} layers", PAIRS))
            return {"CANCELLED"}
        with changes.quiet():
            layer = settings.layers.add()
            layer.period = settings.patch_size / 2.0
            layer.seed = 1 + len(settings.layers)
        changes.tell(settings)
        return {"FINISHED"}


class RemoveTerrainLayer(OnTerrain, bpy.types.Operator):
    """Remove this layer"""

    bl_idname = "libocean.remove_terrain_layer"
    bl_label = "Remove Layer"
    bl_options = {"REGISTER", "UNDO"}

    number: bpy.props.IntProperty(
        name="Layer", description="The number of the layer, from 0", min=0
    )

    def execute(self, context):
        settings = context.object.libocean_terrain
        if self.number >= len(settings.layers):
            self.report({"ERROR"}, tr("The terrain has no layer {}", self.number + 1))
            return {"CANCELLED"}
        settings.layers.remove(self.number)
        changes.tell(settings)
        return {"FINISHED"}


def _set_breaks(ob, pairs) -> None:
    """Sets the breaks, in descending order of their wavelengths."""
    numbers = [part for pair in sorted(pairs, reverse=True) for part in pair]
    ob.libocean_terrain.breaks = [*numbers, *[0.0] * (2 * PAIRS - len(numbers))]


class AddBreak(OnTerrain, bpy.types.Operator):
    """Add a break: waves shorter than its wavelength follow another exponent"""

    bl_idname = "libocean.add_break"
    bl_label = "Add Break"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        settings = context.object.libocean_terrain
        pairs = pairs_of(settings.breaks)
        if len(pairs) >= PAIRS:
            self.report({"ERROR"}, tr("A terrain has at most {} breaks", PAIRS))
            return {"CANCELLED"}
        longest, beta = min(pairs) if pairs else (settings.patch_size / 8.0, settings.beta)
        _set_breaks(context.object, [*pairs, (longest / 2.0, min(beta + 0.5, 6.0))])
        return {"FINISHED"}


class RemoveBreak(OnTerrain, bpy.types.Operator):
    """Remove this break"""

    bl_idname = "libocean.remove_break"
    bl_label = "Remove Break"
    bl_options = {"REGISTER", "UNDO"}

    number: bpy.props.IntProperty(
        name="Break", description="The number of the break, from 0", min=0
    )

    def execute(self, context):
        pairs = pairs_of(context.object.libocean_terrain.breaks)
        if self.number >= len(pairs):
            self.report({"ERROR"}, tr("The terrain has no break {}", self.number + 1))
            return {"CANCELLED"}
        del pairs[self.number]
        _set_breaks(context.object, pairs)
        return {"FINISHED"}


CLASSES = (
    AddTerrain,
    AddTerrainFile,
    AddTerrainModifier,
    LoadTerrain,
    SaveTerrain,
    LoadTerrainPreset,
    AddTerrainLayer,
    RemoveTerrainLayer,
    AddBreak,
    RemoveBreak,
)


def _draw_add(self, _context) -> None:
    self.layout.operator(AddTerrain.bl_idname, icon="RNDCURVE")
    self.layout.operator(AddTerrainFile.bl_idname, icon="RNDCURVE")


def _draw_modifier(self, _context) -> None:
    self.layout.operator(AddTerrainModifier.bl_idname, icon="RNDCURVE")


register, unregister = registration.functions(
    CLASSES, menus={"VIEW3D_MT_mesh_add": _draw_add, "VIEW3D_MT_object": _draw_modifier}
)
