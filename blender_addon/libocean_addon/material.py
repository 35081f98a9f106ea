# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The ocean's material, in one click: a water type of the library's table in the node group
`Ocean Water`, and walls below the sea where it is to be seen from within.
"""

from __future__ import annotations

import math

import bpy

from . import compat, node_group
from .compat import tr
from .water_shader import DEFAULT_TYPE, WATER_TYPES, Tree, get_group

_ITEMS = [(name, entry["label"], entry["help"]) for name, entry in WATER_TYPES.items()]


def water_type_property():
    return bpy.props.EnumProperty(
        name="Water",
        description="Optical type of the water, by Jerlov",
        items=_ITEMS,
        default=DEFAULT_TYPE,
    )


def make(water_type: str, *, foam: bool = True, underwater: bool = False):
    """A material of this water."""
    kind = WATER_TYPES[water_type]
    material = bpy.data.materials.new(f"Ocean {kind['label']}")
    compat.use_nodes(material)
    tree = Tree(material.node_tree)
    material.node_tree.nodes.clear()
    water = tree.node("ShaderNodeGroup", node_tree=get_group(), width=220, location=(-260, 0))
    for name, value in {
        "Water Colour": (*kind["albedo"], 1.0),
        "Foam Colour": (*(kind["foam_albedo"],) * 3, 1.0),
        "Foam Amount": 1.0 if foam else 0.0,
        "IOR": kind["ior"],
        "Transparency": 1.0 if underwater else 0.0,
        "Absorption": kind["absorption"],
        "Scattering": kind["scattering"],
        "Anisotropy": kind["anisotropy"],
    }.items():
        water.inputs[name].default_value = value
    output = tree.node("ShaderNodeOutputMaterial")
    tree.feed(water.outputs["Surface"], output.inputs["Surface"])
    if underwater:
        tree.feed(water.outputs["Volume"], output.inputs["Volume"])
        compat.refract_in_eevee(material)
    # In the viewport's solid mode, which shows no reflections.
    material.diffuse_color = (*(math.sqrt(channel) for channel in kind["albedo"]), 1.0)
    material.roughness = 0.1
    return material


# Water below an open surface ---------------------------------------------------

BODY = "Water Body"
_DEPTH = 100.0
_BODY_MARK = "libocean_body"  # custom property of a group: the version that built it
_BODY_VERSION = 1


def _black():
    """What closes the body of water: nothing comes back from there."""
    name = ".libocean depth"
    made = bpy.data.materials.get(name) or bpy.data.materials.new(name)
    compat.use_nodes(made)
    tree = Tree(made.node_tree)
    made.node_tree.nodes.clear()
    output = tree.node("ShaderNodeOutputMaterial")
    nothing = tree.shader("ShaderNodeBsdfDiffuse", Color=(0.0, 0.0, 0.0, 1.0))
    tree.feed(nothing, output.inputs["Surface"])
    return made


def _body_group():
    """Walls and a floor below a surface, so that a camera can be inside: only a closed mesh has a
    volume below the surface."""
    for group in bpy.data.node_groups:
        if group.get(_BODY_MARK) == _BODY_VERSION and group.library is None:
            return group
    group = bpy.data.node_groups.new(BODY, "GeometryNodeTree")
    group[_BODY_MARK] = _BODY_VERSION
    if hasattr(group, "is_modifier"):  # 4.0
        group.is_modifier = True
    compat.add_socket(group, "Geometry", "NodeSocketGeometry")
    compat.add_socket(group, "Depth", "NodeSocketFloat", default_value=_DEPTH, min_value=0.0)
    compat.add_socket(group, "Geometry", "NodeSocketGeometry", output=True)
    t = Tree(group)
    inputs = t.node("NodeGroupInput").outputs
    down = t.node("GeometryNodeExtrudeMesh")
    t.feed(inputs["Geometry"], down.inputs["Mesh"])
    # Unlinked, it would be the normals.
    t.feed(t.vector(0.0, 0.0, -1.0), down.inputs["Offset"])
    t.feed(inputs["Depth"], down.inputs["Offset Scale"])
    down.inputs["Individual"].default_value = False
    turned = t.node("GeometryNodeFlipFaces")
    t.feed(down.outputs["Mesh"], turned.inputs["Mesh"])
    dark = t.node("GeometryNodeSetMaterial")
    t.feed(turned.outputs["Mesh"], dark.inputs["Geometry"])
    dark.inputs["Material"].default_value = _black()
    both = t.node("GeometryNodeJoinGeometry")
    t.feed(dark.outputs["Geometry"], both.inputs[0])
    t.feed(inputs["Geometry"], both.inputs[0])
    t.feed(both.outputs[0], t.node("NodeGroupOutput").inputs[0])
    for number, made in enumerate(group.nodes):
        made.location = (200 * number, 0)
    return group


def _is_body(modifier) -> bool:
    return (
        modifier.type == "NODES"
        and bool(modifier.node_group)
        and (_BODY_MARK in modifier.node_group)
    )


def give_body(ob, *, wanted: bool) -> None:
    """Closes a patch or horizon below the surface, or opens it again. Other meshes are as they were
    made."""
    there = [modifier for modifier in ob.modifiers if _is_body(modifier)]
    if wanted and not there and ob.libocean.kind != "MESH":
        ob.modifiers.new(BODY, "NODES").node_group = _body_group()
    for modifier in there if not wanted else ():
        ob.modifiers.remove(modifier)


def assign(ob, material) -> None:
    """Puts it into the first slot, in the place of what is there."""
    if ob.material_slots:
        ob.material_slots[0].material = material
    else:
        ob.data.materials.append(material)
    # What it is made of must be on the points.
    for name in ("use_foam", "use_normal"):
        if not getattr(ob.libocean, name):
            setattr(ob.libocean, name, True)


def _oceans(context) -> list:
    """The oceans that are selected, and the active object if it is one."""
    chosen = dict.fromkeys([*context.selected_objects, context.object])
    return [ob for ob in chosen if ob is not None and node_group.modifiers(ob)]


class AddMaterial(bpy.types.Operator):
    """Give the selected oceans a material of sea water, in their first slot"""

    bl_idname = "libocean.add_material"
    bl_label = "Ocean Material"
    bl_options = {"REGISTER", "UNDO"}

    water_type: water_type_property()
    foam: bpy.props.BoolProperty(name="Foam", description="Show the attribute cover", default=True)
    underwater: bpy.props.BoolProperty(
        name="Under water",
        description="Clear water that absorbs and scatters: for cameras and objects below the "
        "surface, closed meshes, shallow water. Else deep water, which is fast",
    )

    @classmethod
    def poll(cls, context) -> bool:
        if _oceans(context):
            return True
        cls.poll_message_set(tr("No ocean is selected"))
        return False

    def execute(self, context):
        oceans = [ob for ob in _oceans(context) if ob.data.library is None]
        if not oceans:
            self.report({"ERROR"}, tr("Linked data takes no other material"))
            return {"CANCELLED"}
        material = make(self.water_type, foam=self.foam, underwater=self.underwater)
        for ob in oceans:
            assign(ob, material)
            give_body(ob, wanted=self.underwater)
        return {"FINISHED"}


CLASSES = (AddMaterial,)

register, unregister = bpy.utils.register_classes_factory(CLASSES)
