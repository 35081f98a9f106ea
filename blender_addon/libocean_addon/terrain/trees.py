# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trees on a terrain: a modifier behind the terrain's that scatters instances by its attributes. An
example to begin with: the node group is plain, and its inputs are those of the modifier.

    terrain_height, slope, beach, cliff, streambed, wetness -> density -> points -> instances
"""

from __future__ import annotations

import bpy

from ..shared import compat, life, modifier_groups
from ..shared.compat import tr
from ..shared.modifier_groups import Family
from ..shared.node_builder import Builder
from . import material, node_group, tree_meshes
from .open_terrain import terrain_of
from .subject import TERRAIN

VERSION = 1
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
)
MAX_TREES = 60000
"""The trees that the first density of a large land gives at most."""
_HECTARE = 1e4  # [m^2]


def _declare(group) -> None:
    socket = compat.add_socket
    socket(group, "Geometry", "NodeSocketGeometry")
    socket(group, "Trees", "NodeSocketCollection", description="One is chosen for each place")
    for name, default, low, high, description in _INPUTS:
        socket(
            group,
            name,
            "NodeSocketFloat",
            default_value=default,
            min_value=low,
            max_value=high,
            description=description,
        )
    socket(group, "Seed", "NodeSocketInt")
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


def _density(b: Builder, inputs):
    """Returns the density of trees [1/m^2]."""
    slope, height = _named(b, node_group.SLOPE), _named(b, node_group.HEIGHT)
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
    size = b.number("MULTIPLY", _random(b, inputs, 0.6, 1.2, 2), inputs["Scale"])
    b.link(size, placed.inputs["Scale"])
    joined = b.node("GeometryNodeJoinGeometry")
    b.link(placed.outputs[0], joined.inputs[0])
    b.link(inputs["Geometry"], joined.inputs[0])
    b.link(joined.outputs[0], b.node("NodeGroupOutput").inputs[0])
    b.arrange(rows=5)
    return group


def _fitted(ob) -> dict[str, float]:
    """Returns the inputs for the land of an object: no trees in the water and few enough of them to
    be shown."""
    terrain = terrain_of(ob.name_full)
    values = {}
    if terrain.handle is None:
        return values
    water = material.water_of(terrain.values)
    if water is not None:
        values["Lowest"] = water + 2.0
    if "stream" in terrain.groups:
        values["Wet Share"] = 0.7
    (east, north), tiles = terrain.extent.size, ob.libocean_terrain.tiles
    hectares = east * north / _HECTARE * (tiles**2 if terrain.extent.wraps else 1)
    values["Density"] = min(250.0, MAX_TREES / max(hectares, 1e-6))
    return values


class AddTrees(bpy.types.Operator):
    """Scatter trees on the active terrain: none on beaches, cliffs, in streams and on steep slopes,
    more where the ground is wet"""

    bl_idname = "libocean.add_trees"
    bl_label = "Add Trees"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context) -> bool:
        ob = context.object
        if ob is None or not node_group.modifiers(ob):
            cls.poll_message_set(tr("The active object has no terrain modifier"))
            return False
        if FAMILY.modifiers(ob):
            cls.poll_message_set(tr("The active object has trees"))
            return False
        return True

    def execute(self, context):
        ob = context.object
        if not ob.libocean_terrain.use_slope:
            ob.libocean_terrain.use_slope = True
        life.show_now(TERRAIN, ob)
        modifier = modifier_groups.add(ob, "Trees", get_group)
        modifier.show_expanded = True
        modifier_groups.assign(modifier, {"Trees": tree_meshes.get(), **_fitted(ob)})
        return {"FINISHED"}


CLASSES = (AddTrees,)

register, unregister = bpy.utils.register_classes_factory(CLASSES)
