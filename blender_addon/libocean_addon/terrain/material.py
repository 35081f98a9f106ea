# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The terrain's material, in one click: the node group `Terrain Ground`, fitted to the heights of
the terrain.
"""

from __future__ import annotations

import bpy

from ..look import air, pixel_angle
from ..look.material import put_in_first_slot, visibility_property
from ..shared import compat, life
from ..shared.compat import tr
from ..shared.shader_builder import Tree
from . import ground_shader, node_group
from .open_terrain import terrain_of
from .subject import TERRAIN
from .terrain_text import TerrainValues

_RELIEF = 185.0  # [m] rms height of the land for which the widths of the sockets were chosen
_SWASH = 0.5  # [m] over still water, up to which waves wet the sand
_DRY = 0.75  # share of dry grass far above the forest
_CAMERA_CELL = 0.0183  # 1 / m: cell of a mesh around the camera over spacing and distance
_WAVE_SLOPE = 0.22
"""Along an axis, of the waves of two octaves, over the rms slope of a land whose twenty octaves,
from 16 km to 15 mm, are alike."""
_NOISE_SHARE = 1.0 / 15.0  # of the tile: the largest scale of the noise


def look_of(state: dict, water: float | None = None) -> dict[str, float]:
    """Returns the sockets for a terrain in that state: its highest tenth is white, forest grows in
    its lower half. Widths of edges go with its relief. water: the height of the water at its shore
    [m], for a land that has one: its bed is sand, and the land above it bears no snow."""
    rms, mean = state["rms"]["resolved"], state["mean"]
    relief = max(rms, 1e-3) / _RELIEF
    if water is not None:
        rise = max(state["highest"] - water, 1e-3)
        relief = rise / (3.0 * _RELIEF)
        return {
            "Snow Line": ground_shader.NOWHERE,
            "Forest Line": water + 0.5 * rise,
            "Sand Line": water,
            "Wet Line": water + _SWASH,
            "Dry Share": _DRY,
            "Line Width": 140.0 * relief,
            "Hollow Snow": 260.0 * relief,
            "Noise Size": _NOISE_SHARE * max(state["size"]),
        }
    return {
        "Snow Line": mean + 1.3 * rms,
        "Forest Line": mean + 0.1 * rms,
        "Dry Share": _DRY,
        "Line Width": 140.0 * relief,
        "Sun Melt": 220.0 * relief,
        "Hollow Snow": 260.0 * relief,
        "Noise Size": _NOISE_SHARE * (state["period"] or max(state["size"])),
    }


def camera_look(state: dict, spacing: float) -> dict[str, float]:
    """Returns the sockets for a mesh around the camera with that spacing [m]."""
    slope = _WAVE_SLOPE * state["rms_slope"]["asked"]
    return {"Land Slope": slope, "Mesh Angle": _CAMERA_CELL * spacing}


def water_of(values: TerrainValues) -> float | None:
    """Returns the height of the water that a shore is shaped for [m]; None for a land without a
    shore."""
    return float(values.values["coast_level"] or 0.0) if "coast" in values.groups() else None


def make(values: dict[str, float]):
    """Returns a material of land. values: sockets of Terrain Ground."""
    material = bpy.data.materials.new("Terrain")
    compat.use_nodes(material)
    tree = Tree(material.node_tree)
    material.node_tree.nodes.clear()
    group = ground_shader.get_group()
    ground = tree.node("ShaderNodeGroup", node_tree=group, width=220, location=(-260, 0))
    for name, value in values.items():
        ground.inputs[name].default_value = value
    output = tree.node("ShaderNodeOutputMaterial")
    tree.feed(ground.outputs["Surface"], output.inputs["Surface"])
    compat.light_nothing(material)
    # In the viewport's solid mode, which shows no nodes.
    material.diffuse_color = (*(channel**0.5 for channel in ground_shader.ALBEDOS["Grass"]), 1.0)
    material.roughness = 0.9
    return material


def grounds(ob) -> list:
    """Returns the nodes of Terrain Ground in the materials of an object."""
    trees = [slot.material.node_tree for slot in ob.material_slots if slot.material is not None]
    nodes = [node for tree in trees if tree is not None for node in tree.nodes]
    return [node for node in nodes if ground_shader.is_ground(node)]


def assign(ob, material) -> None:
    """Puts a material into the first slot, in place of the present one."""
    put_in_first_slot(ob, material)
    if not ob.libocean_terrain.use_normal:  # the points must carry the attribute that it reads
        ob.libocean_terrain.use_normal = True


def follow_scene(ob, world) -> None:
    """Has the new material of an object follow the air of a world, and the pixels of the scene that
    is rendered."""
    for ground in grounds(ob):
        pixel_angle.follow(ground.id_data, ground)
        air.follow(ground.id_data, ground, world)


def give(ob, world, *, visibility: float = 0.0) -> None:
    """Gives an object with a terrain a new material that is fitted to it. world: whose sky lends
    the haze its light; visibility: the distance at which haze hides the land [m], 0: no haze."""
    terrain = terrain_of(ob.name_full)
    values = {}
    if terrain.handle is not None:
        state = terrain.state_for_look()
        values = look_of(state, water_of(terrain.values))
        if ob.libocean_terrain.use_lod:
            values |= camera_look(state, ob.libocean_terrain.lod_spacing)
    assign(ob, make({**values, "Visibility": visibility}))
    follow_scene(ob, world)


class AddTerrainMaterial(bpy.types.Operator):
    """Give the selected terrains a material of land, in their first slot: grass, forest, scree and
    rock by height and slope, snow above a line"""

    bl_idname = "libocean.add_terrain_material"
    bl_label = "Terrain Material"
    bl_options = {"REGISTER", "UNDO"}

    visibility: visibility_property()

    @classmethod
    def poll(cls, context) -> bool:
        if node_group.FAMILY.selected(context):
            return True
        cls.poll_message_set(tr("No terrain is selected"))
        return False

    def execute(self, context):
        terrains = [ob for ob in node_group.FAMILY.selected(context) if ob.data.library is None]
        if not terrains:
            self.report({"ERROR"}, tr("Linked data keeps its material"))
            return {"CANCELLED"}
        for ob in terrains:
            life.show_now(TERRAIN, ob)
            give(ob, context.scene.world, visibility=self.visibility)
        return {"FINISHED"}


CLASSES = (AddTerrainMaterial,)

register, unregister = bpy.utils.register_classes_factory(CLASSES)
