# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trees on a terrain or on the land of a coast: a modifier behind that of the land scatters
instances by its attributes. The node group is plain, and its inputs are those of the modifier.

    terrain_height, slope, beach, cliff, streambed, wetness -> density -> points -> instances
"""

from __future__ import annotations

import math

import bpy

from ..shared import compat, life, modifier_groups, registration
from ..shared.compat import tr
from ..shared.modifier_groups import Family
from ..shared.node_builder import Builder
from . import material, node_group, tree_meshes
from .open_terrain import terrain_of
from .subject import TERRAIN

VERSION = 2
FAMILY = Family("libocean_scatter", VERSION)
_NAME = "Terrain Trees"

_INPUTS = (
    ("Density", 250.0, 0.0, 1e5, "Trees a hectare where they grow densest"),
    ("Lowest", -1e5, -1e5, 1e5, "Height below which no tree grows [m]"),
    ("Highest", 1e5, -1e5, 1e5, "Height above which no tree grows [m]"),
    ("Max Slope", 0.7, 0.0, 10.0, "Slope on which no tree grows; at 0.6 of it they begin to thin"),
    ("Wet Share", 0.0, 0.0, 1.0, "Share of the trees that grows by the wetness of the ground"),
    ("Clearings", 0.5, 0.0, 1.0, "Share of the ground that clearings take"),
    ("Clearing Size", 120.0, 0.1, 1e5, "Distance of clearings [m]"),
    ("Scale", 1.0, 0.01, 100.0, "Of the trees, which are 2 to 14 m high"),
    ("Size Variation", 0.33, 0.0, 1.0, "How much smaller and larger than their mean trees are"),
    ("Reach", 0.0, 0.0, 1e6, "Distance from Camera at which trees end [m]; 0: they do not"),
)
MAX_TREES = 60000
"""The trees that a new land has at most."""
_DENSE, _SPARSE = 250.0, 120.0
"""Trees a hectare of a land that can have them all over, and of a larger one around the camera."""
_GROWN = 0.5
"""The share of their densest that slopes and clearings leave, at most, all over a land."""
_CLEAR = (10.0, 20.0)
"""[m] From the camera, between which trees begin: none stands in the picture's way."""
_MEAN_SIZE = 0.9  # of a tree, relative to its mesh
_HECTARE = 1e4  # [m^2]


def _declare(group) -> None:
    socket = compat.add_socket
    socket(group, "Geometry", "NodeSocketGeometry")
    socket(group, "Trees", "NodeSocketCollection", description="One is chosen for each place")
    for row in _INPUTS:
        compat.add_number(group, *row)
    socket(group, "Seed", "NodeSocketInt")
    socket(group, "Camera", "NodeSocketObject", description="Around which trees grow, see Reach")
    socket(group, "Geometry", "NodeSocketGeometry", output=True)


def _named(b: Builder, name: str):
    """Returns an attribute; 0 where the land has none of that name."""
    made = b.node("GeometryNodeInputNamedAttribute", data_type="FLOAT")
    made.inputs["Name"].default_value = name
    return compat.active(made.outputs, "Attribute")


def _without(b: Builder, name: str, begins: float, ends: float):
    """Returns 1 where a mask is below `begins`, and 0 where it is above `ends`."""
    return b.number("SUBTRACT", 1.0, b.eased(begins, ends, _named(b, name)))


def _clearings(b: Builder, inputs):
    """Returns 0 in clearings and 1 elsewhere."""
    noise = b.node("ShaderNodeTexNoise", noise_dimensions="2D")
    place = b.node("GeometryNodeInputPosition").outputs[0]
    b.feed(b.scale(place, b.number("DIVIDE", 1.0, inputs["Clearing Size"])), noise.inputs["Vector"])
    noise.inputs["Scale"].default_value = 1.0
    low = b.number("MULTIPLY_ADD", inputs["Clearings"], 0.5, 0.2)  # noise lies about 0.5
    return b.eased(low, b.number("ADD", low, 0.1), noise.outputs["Fac"])


def _slope(b: Builder):
    """Returns the slope in the attribute, or that of the mesh, whichever is steeper."""
    upward = b.parts(b.node("GeometryNodeInputNormal").outputs[0])[2]
    level = b.number("MAXIMUM", b.number("ABSOLUTE", upward), 0.01)
    across = b.number("SUBTRACT", 1.0, b.number("MULTIPLY", level, level))
    of_mesh = b.number("DIVIDE", b.number("SQRT", across), level)
    return b.number("MAXIMUM", _named(b, node_group.SLOPE), of_mesh)


def _within_reach(b: Builder, inputs):
    """Returns 1 around the camera, 0 at the camera itself and beyond the reach, and 1 everywhere
    without a reach."""
    camera = b.node("GeometryNodeObjectInfo", transform_space="RELATIVE")
    b.link(inputs["Camera"], camera.inputs["Object"])
    place = b.node("GeometryNodeInputPosition").outputs[0]
    away = b.math("DISTANCE", place, camera.outputs["Location"], result="Value")
    reach = inputs["Reach"]
    beyond = b.eased(b.number("MULTIPLY", reach, 0.7), reach, away)
    hidden = b.number("MAXIMUM", beyond, b.number("SUBTRACT", 1.0, b.eased(*_CLEAR, away)))
    return b.number("SUBTRACT", 1.0, b.number("MULTIPLY", hidden, b.number("SIGN", reach)))


def _density(b: Builder, inputs):
    """Returns the density of trees [1/m^2]."""
    slope, height = _slope(b), _named(b, node_group.HEIGHT)
    bare = b.number("MAXIMUM", inputs["Max Slope"], 1e-3)
    share = b.number("SUBTRACT", 1.0, b.eased(b.number("MULTIPLY", bare, 0.6), bare, slope))
    by_wetness = b.number("SUBTRACT", _named(b, "wetness"), 1.0)
    wet = b.number("MULTIPLY_ADD", by_wetness, inputs["Wet Share"], 1.0)
    factors = (
        _without(b, "beach", 0.02, 0.25),
        _without(b, "cliff", 0.02, 0.25),
        _without(b, "streambed", 0.05, 0.3),
        b.number("GREATER_THAN", height, inputs["Lowest"]),
        b.number("LESS_THAN", height, inputs["Highest"]),
        wet,
        _clearings(b, inputs),
        _within_reach(b, inputs),
        b.number("DIVIDE", inputs["Density"], _HECTARE),
    )
    for factor in factors:
        share = b.number("MULTIPLY", share, factor)
    return share


def _random(b: Builder, inputs, low: float, high: float, offset: int):
    made = b.node("FunctionNodeRandomValue", data_type="FLOAT")
    compat.active(made.inputs, "Min").default_value = low
    compat.active(made.inputs, "Max").default_value = high
    b.feed(b.number("ADD", inputs["Seed"], float(offset)), compat.active(made.inputs, "Seed"))
    return compat.active(made.outputs, "Value")


def get_group():
    """Returns the node group, made if it is missing."""
    found = FAMILY.find(_NAME)
    if found is not None:
        return found
    group = FAMILY.new(_NAME)
    _declare(group)
    b = Builder(group)
    inputs = {socket.name: socket for socket in b.node("NodeGroupInput").outputs if socket.name}
    points = b.node("GeometryNodeDistributePointsOnFaces")
    b.link(inputs["Geometry"], points.inputs["Mesh"])
    b.link(_density(b, inputs), compat.active(points.inputs, "Density"))
    b.link(inputs["Seed"], points.inputs["Seed"])
    trees = b.node("GeometryNodeCollectionInfo")
    b.link(inputs["Trees"], trees.inputs["Collection"])
    for name in ("Separate Children", "Reset Children"):
        trees.inputs[name].default_value = True
    placed = b.node("GeometryNodeInstanceOnPoints")
    b.link(points.outputs["Points"], placed.inputs["Points"])
    b.link(trees.outputs[0], placed.inputs["Instance"])
    placed.inputs["Pick Instance"].default_value = True
    turn = b.vector(0.0, 0.0, _random(b, inputs, 0.0, 6.2832, 1))
    b.link(turn, placed.inputs["Rotation"])
    other = b.number("MULTIPLY", _random(b, inputs, -1.0, 1.0, 2), inputs["Size Variation"])
    size = b.number("MULTIPLY_ADD", other, _MEAN_SIZE, _MEAN_SIZE)
    size = b.number("MULTIPLY", size, inputs["Scale"])
    b.link(size, placed.inputs["Scale"])
    joined = b.node("GeometryNodeJoinGeometry")
    b.link(placed.outputs[0], joined.inputs[0])
    b.link(inputs["Geometry"], joined.inputs[0])
    b.link(joined.outputs[0], b.node("NodeGroupOutput").inputs[0])
    b.arrange(rows=5)
    return group


def _land_of(ob):
    """Returns the object on which trees grow, for a terrain, or for the water or the land of a
    coast; None for other objects."""
    if ob is None or node_group.modifiers(ob):
        return ob
    if ob.libocean_coast.land is not None:
        return ob.libocean_coast.land
    is_land = ob.parent is not None and ob.parent.libocean_coast.land == ob
    return ob if is_land else None


def _size_of(ob) -> tuple[float, dict[str, float]]:
    """Returns the area of a land [hectares], and the inputs that fit its water and its forest."""
    values = {}
    if not node_group.modifiers(ob):
        return ob.dimensions.x * ob.dimensions.y / _HECTARE, {"Lowest": 0.5}
    terrain, settings = terrain_of(ob.name_full), ob.libocean_terrain
    if terrain.handle is None:
        return 0.0, values
    water = material.water_of(terrain.values)
    if water is not None:
        values["Lowest"] = water + 2.0
    elif material.grounds(ob):
        inputs = material.grounds(ob)[0].inputs
        line, width = (inputs[name].default_value for name in ("Forest Line", "Line Width"))
        values["Highest"] = line + 0.64 * width
    if "stream" in terrain.groups:
        values["Wet Share"] = 0.7
    (east, north), tiles = terrain.extent.size, settings.tiles
    if settings.use_lod:
        east = north = max(2.0 * settings.lod_farthest, east)
    return east * north / _HECTARE * (tiles**2 if terrain.extent.wraps else 1), values


def _fitted(ob, camera) -> dict:
    """Returns the inputs for a land: no trees in its water, and few enough of them to be shown."""
    hectares, values = _size_of(ob)
    if _DENSE * hectares <= MAX_TREES or camera is None:
        values["Density"] = min(_DENSE, MAX_TREES / max(hectares, 1e-6))
        return values
    values["Density"] = _SPARSE
    area = MAX_TREES / (_GROWN * _SPARSE) * _HECTARE
    values["Reach"] = math.sqrt(area / math.pi)
    return {**values, "Camera": camera}


class AddTrees(bpy.types.Operator):
    """Scatter trees on the active terrain or coast: none on beaches, cliffs, in streams and on
    steep slopes, more where the ground is wet, on a large land around the camera"""

    bl_idname = "libocean.add_trees"
    bl_label = "Add Trees"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context) -> bool:
        land = _land_of(context.object)
        if land is None:
            cls.poll_message_set(tr("The active object is no terrain and no coast with a land"))
            return False
        if FAMILY.modifiers(land):
            cls.poll_message_set(tr("The active object has trees"))
            return False
        return True

    def execute(self, context):
        ob = _land_of(context.object)
        if node_group.modifiers(ob):
            life.show_now(TERRAIN, ob)
        modifier = modifier_groups.add(ob, "Trees", get_group)
        modifier.show_expanded = True
        inputs = {"Trees": tree_meshes.get(), **_fitted(ob, context.scene.camera)}
        modifier_groups.assign(modifier, inputs)
        return {"FINISHED"}


CLASSES = (AddTrees,)


def _draw_object(self, _context) -> None:
    self.layout.operator(AddTrees.bl_idname, icon="OUTLINER_OB_POINTCLOUD")


register, unregister = registration.functions(CLASSES, menus={"VIEW3D_MT_object": _draw_object})
