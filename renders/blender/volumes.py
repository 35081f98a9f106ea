# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Baked volumes in scenes of Blender: water as a level set, cut open, with the velocity in it, and
mist. Needs the Python module of OpenVDB, which Blender or the system brings."""

import math
from pathlib import Path

import bpy
import numpy as np


def new_material(name: str):
    """With the nodes that a new one has."""
    material = bpy.data.materials.new(name)
    if bpy.app.version < (5, 0):
        material.use_nodes = True
    return material


def load(path: Path, name: str):
    """A baked file as a volume object."""
    data = bpy.data.volumes.new(name)
    data.filepath = str(path)
    ob = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(ob)
    return ob


def water_block(path: Path, material):
    """The level set of a baked file as a mesh."""
    volume = load(path, "Level Set")
    volume.hide_render = True
    ob = bpy.data.objects.new("Water", bpy.data.meshes.new("Water"))
    bpy.context.scene.collection.objects.link(ob)
    mesh = ob.modifiers.new("Mesh", "VOLUME_TO_MESH")
    mesh.object = volume
    mesh.grid_name = "surface"
    mesh.threshold = 0.0
    mesh.use_smooth_shade = True
    # The edges of the box stay edges.
    split = ob.modifiers.new("Edges", "EDGE_SPLIT")
    split.split_angle = math.radians(60.0)
    ob.data.materials.append(material)
    material_of = ob.modifiers.new("Material", "NODES")
    material_of.node_group = set_material(material)
    return ob


def set_material(material):
    group = bpy.data.node_groups.new("Set Material", "GeometryNodeTree")
    if bpy.app.version < (4, 0):
        group.inputs.new("NodeSocketGeometry", "Geometry")
        group.outputs.new("NodeSocketGeometry", "Geometry")
    else:
        for side in ("INPUT", "OUTPUT"):
            group.interface.new_socket("Geometry", in_out=side, socket_type="NodeSocketGeometry")
    start, node, end = (
        group.nodes.new(kind)
        for kind in ("NodeGroupInput", "GeometryNodeSetMaterial", "NodeGroupOutput")
    )
    node.inputs["Material"].default_value = material
    group.links.new(start.outputs[0], node.inputs["Geometry"])
    group.links.new(node.outputs[0], end.inputs[0])
    return group


def velocity_on_a_cut(path: Path, step: float) -> tuple[np.ndarray, np.ndarray]:
    """Places (n, 3) on the plane y = 0 inside the water, and the velocity there, m/s."""
    try:
        import openvdb
    except ImportError:
        import pyopenvdb as openvdb
    velocity = openvdb.read(str(path), "vel")
    surface = openvdb.read(str(path), "surface")
    low, high = (np.array(end) for end in surface.evalActiveVoxelBoundingBox())
    voxel = surface.transform.voxelSize()[0]
    x = np.arange(low[0] * voxel + step, high[0] * voxel - step / 2, step)
    z = np.arange(low[2] * voxel + step, high[2] * voxel, step)
    places = np.stack([axis.ravel() for axis in np.meshgrid(x, z)], -1)
    distance, motion = surface.getConstAccessor(), velocity.getConstAccessor()
    size = velocity.transform.voxelSize()[0]
    kept = []
    for px, pz in places:
        # A little behind the cut, whose own distance is 0.
        if distance.getValue((round(px / voxel), 6, round(pz / voxel))) > -2.0 * voxel:
            continue
        at = (round(px / size), 0, round(pz / size))
        kept.append((px, 0.0, pz, *motion.getValue(at)))
    table = np.array(kept)
    return table[:, :3], table[:, 3:]


def arrows(places: np.ndarray, velocities: np.ndarray, length: float, material):
    """One mesh of arrows in the plane y = 0, `length` long for the fastest, with the attribute
    `speed` of 0 to 1."""
    speeds = np.linalg.norm(velocities[:, [0, 2]], axis=1)
    fastest = speeds.max()
    # An arrow of unit length along x, flat: shaft and head.
    shape = np.array([(0, 1), (0.62, 1), (0.62, 2.6), (1, 0), (0.62, -2.6), (0.62, -1), (0, -1)])
    width = 0.055 * length
    corners, faces, values = [], [], []
    for place, velocity, speed in zip(places, velocities, speeds, strict=True):
        along = velocity[[0, 2]] / max(speed, 1e-9)
        size = length * (0.18 + 0.82 * speed / fastest)
        local = (shape - (0.5, 0.0)) * (size, width * (0.6 + 0.4 * speed / fastest))
        x = place[0] + local[:, 0] * along[0] - local[:, 1] * along[1]
        z = place[2] + local[:, 0] * along[1] + local[:, 1] * along[0]
        first = len(corners)
        corners += [(a, -0.04, b) for a, b in zip(x, z, strict=True)]
        faces.append(tuple(range(first, first + len(shape))))
        values += [speed / fastest] * len(shape)
    mesh = bpy.data.meshes.new("Velocity")
    mesh.from_pydata(corners, [], faces)
    mesh.attributes.new("speed", "FLOAT", "POINT").data.foreach_set("value", values)
    mesh.materials.append(material)
    ob = bpy.data.objects.new("Velocity", mesh)
    bpy.context.scene.collection.objects.link(ob)
    return ob


def speed_paint():
    """Blue where the water is slow, red where it is fast."""
    material = new_material("Speed")
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    speed = nodes.new("ShaderNodeAttribute")
    speed.attribute_name = "speed"
    ramp = nodes.new("ShaderNodeValToRGB")
    colors = ((0.02, 0.09, 0.45), (0.05, 0.55, 0.6), (0.95, 0.75, 0.1), (0.8, 0.06, 0.02))
    ramp.color_ramp.elements.remove(ramp.color_ramp.elements[1])
    ramp.color_ramp.elements[0].color = (*colors[0], 1.0)
    for i, color in enumerate(colors[1:], 1):
        ramp.color_ramp.elements.new(i / 3.0).color = (*color, 1.0)
    light = nodes.new("ShaderNodeEmission")
    output = nodes.new("ShaderNodeOutputMaterial")
    links.new(speed.outputs["Fac"], ramp.inputs["Fac"])
    links.new(ramp.outputs["Color"], light.inputs["Color"])
    links.new(light.outputs["Emission"], output.inputs["Surface"])
    return material


def cut_water():
    """Dark and shiny from above, pale on the walls of the box."""
    material = new_material("Cut Water")
    nodes, links = material.node_tree.nodes, material.node_tree.links
    shader = nodes["Principled BSDF"]
    normal = nodes.new("ShaderNodeNewGeometry")
    up = nodes.new("ShaderNodeSeparateXYZ")
    is_top = nodes.new("ShaderNodeMath")
    is_top.operation, is_top.inputs[1].default_value = "GREATER_THAN", 0.76
    colour = nodes.new("ShaderNodeMixRGB")
    colour.inputs["Color1"].default_value = (0.28, 0.5, 0.56, 1.0)
    colour.inputs["Color2"].default_value = (0.015, 0.09, 0.13, 1.0)
    rough = nodes.new("ShaderNodeMapRange")
    rough.inputs["To Min"].default_value, rough.inputs["To Max"].default_value = 0.9, 0.12
    links.new(normal.outputs["True Normal"], up.inputs[0])
    links.new(up.outputs["Z"], is_top.inputs[0])
    links.new(is_top.outputs[0], colour.inputs["Fac"])
    links.new(is_top.outputs[0], rough.inputs["Value"])
    links.new(colour.outputs[0], shader.inputs["Base Color"])
    links.new(rough.outputs[0], shader.inputs["Roughness"])
    return material


def studio(scene) -> None:
    """An even pale room with one lamp."""
    world = bpy.data.worlds.new("Studio")
    scene.world = world
    if bpy.app.version < (5, 0):
        world.use_nodes = True
    world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.72, 0.78, 0.84, 1.0)
    lamp = bpy.data.lights.new("Lamp", "SUN")
    lamp.energy, lamp.angle = 2.0, math.radians(3.0)
    ob = bpy.data.objects.new("Lamp", lamp)
    ob.rotation_euler = (math.radians(48.0), 0.0, math.radians(-50.0))
    scene.collection.objects.link(ob)
    scene.view_settings.view_transform = "Standard"


def mist(path: Path, amount: float):
    """The fog of a baked file."""
    ob = load(path, "Mist")
    ob.data.materials.append(mist_material(amount))
    return ob


def mist_material(amount: float):
    """Fog of the grid `density`, as it is baked in 1/m."""
    material = new_material("Mist")
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    density = nodes.new("ShaderNodeAttribute")
    density.attribute_name = "density"
    scaled = nodes.new("ShaderNodeMath")
    scaled.operation, scaled.inputs[1].default_value = "MULTIPLY", amount
    scatter = nodes.new("ShaderNodeVolumeScatter")
    scatter.inputs["Color"].default_value = (0.97, 0.98, 1.0, 1.0)
    scatter.inputs["Anisotropy"].default_value = 0.6
    output = nodes.new("ShaderNodeOutputMaterial")
    links.new(density.outputs["Fac"], scaled.inputs[0])
    links.new(scaled.outputs[0], scatter.inputs["Density"])
    links.new(scatter.outputs[0], output.inputs["Volume"])
    return material
