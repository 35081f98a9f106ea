# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators of coasts: bpy.ops.libocean."""

from __future__ import annotations

import bpy
from bpy_extras import object_utils
from bpy_extras.io_utils import ImportHelper

from ..look import foam_images
from ..look import material as water_material
from ..sea import node_group as sea_group
from ..sea import sea_text
from ..sea.sea_text import SeaValues
from ..shared import changes, console, paths, registration
from ..shared.compat import tr
from ..shared.native import libocean
from ..shared.subject_operators import (
    LoadFile,
    OnSubject,
    SaveFile,
    give_material,
    new_object,
    read_or_report,
)
from . import first_coast, land, node_group
from .open_coast import coast_of
from .properties import SETTINGS
from .subject import COAST

DEFAULT_PRESET = "beaufort_5"
"""The sea over a bed that is added while no ocean is active."""
_BEDS = (".asc", ".flt", ".hdr")
_FILES = ";".join(f"*{ending}" for ending in (".toml", *_BEDS))


def _is_bed(path) -> bool:
    """Returns whether a file holds a bed, by its name or as a terrain file."""
    if path.suffix.lower() in _BEDS:
        return True
    try:
        libocean.open_terrain(str(path)).close()
    except libocean.Error:
        return False
    return True


def read(filepath: str, ob, scene) -> SeaValues:
    """Returns the sea of a sea file with a bed; of a file that holds a bed alone, the sea of an
    object, or else of the default preset, over it. Raises libocean.Error."""
    path = paths.absolute(filepath)
    if not _is_bed(path):
        with libocean.open(str(path)) as sea:
            if "bed" not in sea.state:
                raise libocean.Error(
                    tr("{}: the sea has no bed: a coast needs seabed in [water]", path), 0
                )
            return sea_text.read(sea)
    with _sea_of(ob, scene) as sea:
        sea.set("seabed", str(path))
        return sea_text.read(sea)


def _sea_of(ob, scene):
    """Returns the open sea of an object, or else of the default preset."""
    has_sea = ob is not None and (sea_group.modifiers(ob) or node_group.modifiers(ob))
    if not has_sea:
        return libocean.preset(DEFAULT_PRESET)
    text = COAST.parameters.values_of(ob, scene).text()
    return libocean.parse(text, base_dir=paths.blend_folder())


class OnCoast(OnSubject):
    """Base of operators on the active object's coast."""

    subject = COAST

    @staticmethod
    def absent() -> str:
        return tr(
            "The active object is no water of a coast; Object > Ocean mends one whose modifier "
            "was removed"
        )


class _AddCoast(ImportHelper, object_utils.AddObjectHelper):
    """Base of operators that add the coast of a file; without a file an island."""

    bl_options = {"REGISTER", "UNDO"}

    filter_glob: bpy.props.StringProperty(default=_FILES, options={"HIDDEN"})
    __annotations__.update(SETTINGS["AddCoast"])
    water_type: water_material.water_type_property()

    def execute(self, context):
        has_file = self.filepath and not paths.absolute(self.filepath).is_dir()

        def values_of_file() -> SeaValues:
            return read(self.filepath, context.object, context.scene)

        values = read_or_report(self, values_of_file if has_file else first_coast.values)
        if values is None:
            return {"CANCELLED"}
        with console.work("Coast", "a new coast"):
            self._make(context, values)
        return {"FINISHED"}

    def _make(self, context, values: SeaValues) -> None:
        if self.use_material:
            foam_images.prepare()
        ob = new_object(self, context, "Water", "Coast", node_group.get)
        with changes.quiet():
            ob.libocean_coast.cell = self.cell
            ob.libocean_coast.use_fine_shore = self.use_fine_shore
            ob.libocean_coast.use_cusps = self.use_cusps
            ob.libocean.use_detail = self.near_detail
            if self.use_land:
                ob.libocean_coast.land = land.new_part(ob, "Land")
                ob.libocean_coast.use_wetness = self.use_wetness
            if self.use_far_water:
                ob.libocean_coast.far_water = land.new_part(ob, "Far Water")
        COAST.parameters.assign(ob, values)
        state = coast_of(ob.name_full).state
        if state is not None:
            give_material(self, ob, lambda: self._give_materials(context, ob, state))

    def _give_materials(self, context, ob, state: dict) -> None:
        made = water_material.make(self.water_type)
        water_material.fit(made, ob, context.scene)
        water_material.put(made, water_material.look_of(state))
        water_material.assign(ob, made)
        if self.use_far_water:
            water_material.put_in_first_slot(ob.libocean_coast.far_water, made)
        if self.use_land:
            size = max(coast_of(ob.name_full).own.size)
            land.give(ob.libocean_coast.land, land.look_of(state, size), context.scene.world)


class AddCoast(_AddCoast, bpy.types.Operator):
    """Add a coast, water and land: an island with bays and beaches, or the coast of a file"""

    bl_idname = "libocean.add_coast"
    bl_label = "Coast"

    def invoke(self, context, _event):
        return self.execute(context)


class AddCoastFile(_AddCoast, bpy.types.Operator):
    """Add a coast: the water of a sea file that has a bed, and the land. A file that holds a bed
    alone, a terrain or an elevation model, gets the sea of the active object, or a moderate one.
    Without a file an island is made"""

    bl_idname = "libocean.add_coast_file"
    bl_label = "Coast File"


class LoadCoast(OnCoast, LoadFile, bpy.types.Operator):
    """Load the sea of a sea file that has a bed; a file that holds a bed alone, a terrain or an
    elevation model, lays it below the present sea"""

    bl_idname = "libocean.load_coast"
    bl_label = "Load Coast"
    bl_options = {"REGISTER", "UNDO"}

    filter_glob: bpy.props.StringProperty(default=_FILES, options={"HIDDEN"})

    def read(self, context):
        return read(self.filepath, context.object, context.scene)


class SaveCoast(OnCoast, SaveFile, bpy.types.Operator):
    """Write the sea and its bed as a file that every libocean tool reads"""

    bl_idname = "libocean.save_coast"
    bl_label = "Save Coast"


CLASSES = (AddCoast, AddCoastFile, LoadCoast, SaveCoast)


def _draw_add(self, _context) -> None:
    self.layout.operator(AddCoast.bl_idname, icon="MOD_OCEAN")
    self.layout.operator(AddCoastFile.bl_idname, icon="MOD_OCEAN")


register, unregister = registration.functions(CLASSES, menus={"VIEW3D_MT_mesh_add": _draw_add})
