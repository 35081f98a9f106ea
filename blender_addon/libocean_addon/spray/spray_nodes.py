# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How spray is drawn: the node group that puts points beside an ocean's mesh, and their material.

    carrier's vertices, with attributes -> points of their radius -> material -> join with the sea

The carrier is a mesh that the add-on fills (spray.py), of an object that is in no scene.
"""

from __future__ import annotations

import bpy

from ..shared import compat
from ..shared.node_builder import Builder
from ..shared.shader_builder import Tree

NAME = "Ocean Spray"
VERSION = 1
SPHERES = "Spheres"
"""Input: for engines that do not draw points."""
_MARK = "libocean_spray"  # custom property of a group: the version that built it

ATTRIBUTES = {
    "velocity": "FLOAT_VECTOR",  # m/s; Cycles takes it for motion blur
    "age": "FLOAT",
    "life": "FLOAT",
    "radius": "FLOAT",  # m, as drawn: Blender's own attribute of points
    "id": "INT",  # Blender's own: what goes by it stays with its particle
}
"""The attributes of the points, and their types."""


def _build(group) -> None:
    compat.add_socket(group, "Geometry", "NodeSocketGeometry")
    compat.add_socket(group, "Points", "NodeSocketObject")
    compat.add_socket(group, "Material", "NodeSocketMaterial")
    compat.add_socket(
        group, SPHERES, "NodeSocketBool", description="Instances of a sphere in place of points"
    )
    compat.add_socket(group, "Geometry", "NodeSocketGeometry", output=True)
    compat.hide_inputs(group)
    b = Builder(group)
    inputs = b.node("NodeGroupInput").outputs
    carrier = b.node("GeometryNodeObjectInfo", transform_space="ORIGINAL")
    b.link(inputs["Points"], carrier.inputs["Object"])
    named = b.node("GeometryNodeInputNamedAttribute", data_type="FLOAT")
    named.inputs["Name"].default_value = "radius"
    radius = compat.active(named.outputs, "Attribute")
    points = b.node("GeometryNodeMeshToPoints")
    b.link(carrier.outputs["Geometry"], points.inputs[0])
    b.link(radius, points.inputs["Radius"])
    sphere = b.node("GeometryNodeMeshIcoSphere")
    sphere.inputs["Subdivisions"].default_value = 2
    instances = b.node("GeometryNodeInstanceOnPoints")
    b.link(points.outputs[0], instances.inputs["Points"])
    b.link(sphere.outputs["Mesh"], instances.inputs["Instance"])
    b.link(radius, instances.inputs["Scale"])
    drops = b.node("GeometryNodeSetMaterial")
    shape = b.switch("GEOMETRY", inputs[SPHERES], points.outputs[0], instances.outputs[0])
    b.link(shape, drops.inputs["Geometry"])
    b.link(inputs["Material"], drops.inputs["Material"])
    both = b.node("GeometryNodeJoinGeometry")
    for geometry in (drops.outputs["Geometry"], inputs["Geometry"]):
        b.link(geometry, both.inputs[0])
    b.link(both.outputs[0], b.node("NodeGroupOutput").inputs[0])
    b.arrange(width=200)


def is_ours(group) -> bool:
    return group is not None and _MARK in group


def get():
    """The group: made when there is none."""
    for group in bpy.data.node_groups:
        if group.get(_MARK) == VERSION and group.library is None:
            return group
    group = bpy.data.node_groups.new(f".libocean.v{VERSION} Spray", "GeometryNodeTree")
    group[_MARK] = VERSION
    if hasattr(group, "is_modifier"):  # 4.0
        group.is_modifier = True
    _build(group)
    return group


def modifier_of(ob):
    """Returns the modifier that shows an object's spray; None without one."""
    return next((m for m in ob.modifiers if m.type == "NODES" and is_ours(m.node_group)), None)


def users() -> set:
    """Objects with such a modifier."""
    groups = [group for group in bpy.data.node_groups if is_ours(group)]
    if not groups:
        return set()
    found = bpy.data.user_map(subset=groups, value_types={"OBJECT"})
    return {ob for objects in found.values() for ob in objects if modifier_of(ob) is not None}


# The material -------------------------------------------------------------------

_ALBEDO = 0.9
_FADE = 0.2  # share of its life at whose end a particle is gone


def material():
    """White, and half of the light goes through: what a cloud of drops does. Made when there is
    none."""
    for made in bpy.data.materials:
        if made.get(_MARK) == VERSION and made.library is None:
            return made
    made = bpy.data.materials.new(NAME)
    made[_MARK] = VERSION
    compat.use_nodes(made)
    tree = Tree(made.node_tree)
    made.node_tree.nodes.clear()
    white = (_ALBEDO, _ALBEDO, _ALBEDO, 1.0)
    diffuse = tree.shader("ShaderNodeBsdfDiffuse", Color=white)
    drops = tree.mix_shaders(0.5, diffuse, tree.shader("ShaderNodeBsdfTranslucent", Color=white))
    age, life = (
        tree.node("ShaderNodeAttribute", attribute_name=name).outputs["Fac"]
        for name in ("age", "life")
    )
    left = tree.number("SUBTRACT", 1.0, tree.number("DIVIDE", age, life))
    there = tree.number("DIVIDE", left, _FADE, clamp=True)
    output = tree.node("ShaderNodeOutputMaterial")
    nothing = tree.shader("ShaderNodeBsdfTransparent")
    tree.feed(tree.mix_shaders(there, nothing, drops), output.inputs["Surface"])
    tree.arrange(width=200)
    compat.fade_in_eevee(made)
    return made
