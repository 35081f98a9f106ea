# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The ocean's material, in one click: a water type of the library's table in the node group
`Ocean Water`, and walls below the sea where it is to be seen from within.
"""

from __future__ import annotations

import math

import bpy

from ..sea import facts, node_group
from ..sea.subject import SEA
from ..shared import compat, life
from ..shared.compat import tr
from ..shared.shader_builder import Tree
from ..shared.table_properties import settings_of
from . import air, detail, pixel_angle, sun_focus, sunlight
from .water_shader import DEFAULT_TYPE, WATER_TYPES, clearness, get_group, is_water, waters

_ITEMS = [(name, entry["label"], entry["help"]) for name, entry in WATER_TYPES.items()]


def water_type_property():
    return bpy.props.EnumProperty(
        name="Water",
        description="Optical type of the water, by Jerlov",
        items=_ITEMS,
        default=DEFAULT_TYPE,
    )


def visibility_property():
    return bpy.props.FloatProperty(
        name="Visibility",
        description="How far one sees through the air, 9 km in haze to 60 km in clear weather; 0: "
        "without end",
        subtype="DISTANCE",
        default=0.0,
        min=0.0,
        soft_max=6e4,
        max=1e6,
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
        "Foam Amount": 1.0 if foam else 0.0,
        "IOR": kind["ior"],
        "Transparency": 1.0 if underwater else 0.0,
        "Absorption": kind["absorption"],
        "Scattering": kind["scattering"],
        "Anisotropy": kind["anisotropy"],
        "Crest Colour": (*kind["crest"], 1.0),
        "Clearness": clearness(kind),
    }.items():
        water.inputs[name].default_value = value
    output = tree.node("ShaderNodeOutputMaterial")
    tree.feed(water.outputs["Surface"], output.inputs["Surface"])
    if underwater:
        tree.feed(water.outputs["Volume"], output.inputs["Volume"])
        compat.refract_in_eevee(material)
    compat.light_nothing(material)
    # In the viewport's solid mode, which shows no reflections.
    material.diffuse_color = (*(math.sqrt(channel) for channel in kind["albedo"]), 1.0)
    material.roughness = 0.1
    return material


# The sea and the camera that it is for ------------------------------------------


def _clamped(value: float) -> float:
    return min(max(value, 0.0), 1.0)


def look_of(state: dict) -> dict[str, float]:
    """Inputs of a sea: the way of its foam, streaks and long cells as in gales, as ocean.inc has
    them, and how high its waves are."""
    height = state["significant_wave_height"]["resolved"]
    return {
        "Wind Direction": state["mean_direction"]["resolved"],
        "Foam Stretch": 1.5 + 0.7 * _clamped((height - 4.0) / 3.0),
        "Foam Streaks": 0.3 * _clamped((height - 2.0) / 4.0),
        "Wave Height": height,
    }


def waters_of(ob) -> list:
    """Returns the nodes of water in the material that an object shows first."""
    made = ob.material_slots[0].material if ob.material_slots else None
    return [] if made is None or made.node_tree is None else waters(made.node_tree)


def put(made, values: dict) -> None:
    """Sets inputs of the water of a material."""
    for node in made.node_tree.nodes:
        if is_water(node) or detail.is_detail(node):
            for name in values.keys() & node.inputs.keys():  # it may be of an earlier version
                node.inputs[name].default_value = values[name]


def fit(made, ob, scene) -> None:
    """Adapts a new material to an ocean, the scene's camera, its sun and its air."""
    state = facts.sea_state(ob)
    put(made, look_of(state) if state else {})
    for node in waters(made.node_tree):
        pixel_angle.follow(made.node_tree, node)
        if air.SOCKET in node.inputs:  # it may be of an earlier version
            sunlight.follow(node, scene)
            air.follow(made.node_tree, node, scene.world)


# Water below an open surface ---------------------------------------------------

BODY = "Water Body"
_DEPTH = 100.0
_BODY_MARK = "libocean_body"  # custom property of a group: the version that built it
_BODY_VERSION = 1


def _black():
    """Returns the material that closes the body of water: no light comes back from it."""
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
    t.arrange(width=200)
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


def put_in_first_slot(ob, material) -> None:
    """Puts a material into the first slot, in place of the present one."""
    if ob.material_slots:
        ob.material_slots[0].material = material
    else:
        ob.data.materials.append(material)


def assign(ob, material) -> None:
    """Puts the material into the first slot, in place of the present one."""
    put_in_first_slot(ob, material)
    # The points must carry the attributes that it reads.
    for name in ("use_foam", "use_velocity", "use_normal"):
        if not getattr(ob.libocean, name):
            setattr(ob.libocean, name, True)


class AddMaterial(bpy.types.Operator):
    """Give the selected oceans a material of sea water, in their first slot"""

    bl_idname = "libocean.add_material"
    bl_label = "Ocean Material"
    bl_options = {"REGISTER", "UNDO"}

    water_type: water_type_property()
    __annotations__.update(settings_of("look")["AddMaterial"])
    focus_depth: bpy.props.FloatProperty(
        name="Focus depth",
        description="At which the shafts are as caustics are there: the deeper, the wider and "
        "softer. About where the camera or the bottom is",
        subtype="DISTANCE",
        default=sun_focus.DEPTH,
        min=0.1,
        max=100.0,
    )
    visibility: visibility_property()

    @classmethod
    def poll(cls, context) -> bool:
        if node_group.FAMILY.selected(context):
            return True
        cls.poll_message_set(tr("No ocean is selected"))
        return False

    def draw(self, _context) -> None:
        layout = self.layout
        layout.use_property_split = True
        for name in ("water_type", "foam", "visibility", "underwater"):
            layout.prop(self, name)
        if self.underwater:
            layout.prop(self, "god_rays")
            if self.god_rays:
                layout.prop(self, "focus_depth")

    def execute(self, context):
        oceans = [ob for ob in node_group.FAMILY.selected(context) if ob.data.library is None]
        if not oceans:
            self.report({"ERROR"}, tr("Linked data keeps its material"))
            return {"CANCELLED"}
        material = make(self.water_type, foam=self.foam, underwater=self.underwater)
        put(material, {"Visibility": self.visibility})
        fit(material, oceans[0], context.scene)
        if self.underwater and self.god_rays:
            sun_focus.add(material, self.focus_depth)
        for ob in oceans:
            assign(ob, material)
            give_body(ob, wanted=self.underwater)
        life.show_all(map(SEA.look_up, oceans), context.scene)
        return {"FINISHED"}


CLASSES = (AddMaterial,)

register, unregister = bpy.utils.register_classes_factory(CLASSES)
