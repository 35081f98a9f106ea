# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A view of renders/terrain/views.toml in Cycles, through the add-on's operators: the same land,
camera and sun, and the same sky, as renders/terrain/beside.pov draws it all around.

usage: blender --background --python renders/terrain/beside.py -- VIEW LAND.toml SKY.exr \\
           PICTURE.exr SAMPLES WIDTHxHEIGHT

The add-on must be installed. The picture is light, as linear as it was.
"""

import math
import sys
from pathlib import Path

import bpy
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "blender")]
import daylight  # noqa: E402
import lands  # noqa: E402
import scenes  # noqa: E402

EARTH_RADIUS = 6371e3  # [m]
SPACING = 0.5  # [m] of the vertices at the camera
FARTHEST = 150e3  # [m]
WATER_TYPE = "jerlov_ii"
LOSS = (0.294, 0.090, 0.076)  # [1/m] of light: absorption and a tenth of the scattering
SAND = (0.29, 0.25, 0.18)  # albedo of the bed


def drop(ob, eye) -> None:
    """Lowers an object by the curve of the Earth under the eye, after its other modifiers."""
    group = bpy.data.node_groups.new("Earth", "GeometryNodeTree")
    if hasattr(group, "interface"):
        for way in ("INPUT", "OUTPUT"):
            group.interface.new_socket("Geometry", in_out=way, socket_type="NodeSocketGeometry")
    else:
        group.inputs.new("NodeSocketGeometry", "Geometry")
        group.outputs.new("NodeSocketGeometry", "Geometry")
    nodes, links = group.nodes, group.links
    given, made = nodes.new("NodeGroupInput"), nodes.new("NodeGroupOutput")
    place = nodes.new("GeometryNodeInputPosition")
    away = nodes.new("ShaderNodeVectorMath")
    away.operation = "SUBTRACT"
    away.inputs[1].default_value = eye
    level = nodes.new("ShaderNodeVectorMath")
    level.operation = "MULTIPLY"
    level.inputs[1].default_value = (1.0, 1.0, 0.0)
    square = nodes.new("ShaderNodeVectorMath")
    square.operation = "DOT_PRODUCT"
    scaled = nodes.new("ShaderNodeVectorMath")
    scaled.operation = "SCALE"
    scaled.inputs[0].default_value = (0.0, 0.0, -0.5 / EARTH_RADIUS)
    moved = nodes.new("GeometryNodeSetPosition")
    links.new(place.outputs["Position"], away.inputs[0])
    links.new(away.outputs["Vector"], level.inputs[0])
    for number in (0, 1):
        links.new(level.outputs["Vector"], square.inputs[number])
    links.new(square.outputs["Value"], scaled.inputs["Scale"])
    links.new(given.outputs["Geometry"], moved.inputs["Geometry"])
    links.new(scaled.outputs["Vector"], moved.inputs["Offset"])
    links.new(moved.outputs["Geometry"], made.inputs["Geometry"])
    ob.modifiers.new("Earth", "NODES").node_group = group


def add_land(path: str, view: dict):
    """Adds the land, fine at the camera and coarse at the horizon, in its material."""
    bpy.ops.libocean.add_terrain_file(filepath=path, use_material=False)
    ob = bpy.context.object
    settings = ob.libocean_terrain
    settings.lod_spacing, settings.lod_farthest, settings.lod_snap = SPACING, FARTHEST, 0.1
    settings.use_lod = True
    bpy.context.view_layer.update()
    bpy.ops.libocean.add_terrain_material(visibility=view["visibility"])
    for node in ob.active_material.node_tree.nodes:
        if node.type == "GROUP" and "Snow Line" in node.inputs:
            node.inputs["Snow Line"].default_value = min(view["snow_line"], 1e5)
            node.inputs["Forest Line"].default_value = view["tree_line"]
    drop(ob, view["eye"])
    return ob


def water_mesh(land, level: float):
    """Returns a level surface with the attribute depth [m]: the land's vertices and faces, and a
    deep sea around them."""
    made = land.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    places = np.empty(3 * len(made.vertices), np.float32)
    made.vertices.foreach_get("co", places)
    places = places.reshape(-1, 3)
    corners = np.empty(len(made.loops), np.int32)
    made.loops.foreach_get("vertex_index", corners)
    depth = level - places[:, 2]
    places[:, 2] = level
    low, high = places.min(0), places.max(0)
    # Eight rectangles of 40 x 40 faces, around the one of the land.
    ends = [(low[i] - FARTHEST, low[i], high[i], high[i] + FARTHEST) for i in (0, 1)]
    parts, faces, start = [places], [corners.reshape(-1, 3)], len(places)
    side = np.linspace(0.0, 1.0, 41)
    first = (np.arange(40)[:, None] * 41 + np.arange(40)).ravel()
    quad = np.stack([first, first + 1, first + 42, first, first + 42, first + 41], 1).reshape(-1, 3)
    for row in range(3):
        for column in range(3):
            if (row, column) == (1, 1):
                continue
            x = ends[0][column] + side * (ends[0][column + 1] - ends[0][column])
            y = ends[1][row] + side * (ends[1][row + 1] - ends[1][row])
            grid = np.stack([*np.meshgrid(x, y), np.full((41, 41), level)], -1).reshape(-1, 3)
            parts.append(grid.astype(np.float32))
            faces.append((quad + start).astype(np.int32))
            start += len(grid)
    mesh = bpy.data.meshes.new("Water")
    mesh.from_pydata(np.concatenate(parts).tolist(), [], np.concatenate(faces).tolist())
    depths = np.full(start, 1e3, np.float32)
    depths[: len(depth)] = depth
    mesh.attributes.new("depth", "FLOAT", "POINT").data.foreach_set("value", depths)
    mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
    return mesh


def add_water(scene, land, level: float, view: dict) -> None:
    """Adds still water in the material of the sea, through which the bed is seen near the shore."""
    bpy.ops.libocean.add(kind="PATCH", preset="beaufort_0", water_type=WATER_TYPE)
    sea = bpy.context.object
    bpy.ops.libocean.add_material(water_type=WATER_TYPE, visibility=view["visibility"])
    material = sea.active_material
    ob = bpy.data.objects.new("Water", water_mesh(land, level))
    scene.collection.objects.link(ob)
    ob.data.materials.append(material)
    bpy.data.objects.remove(sea)
    nodes, links = material.node_tree.nodes, material.node_tree.links
    output = next(node for node in nodes if node.type == "OUTPUT_MATERIAL")
    water = output.inputs["Surface"].links[0].from_socket

    def number(operation: str, *values, clamp: bool = False):
        node = nodes.new("ShaderNodeMath")
        node.operation, node.use_clamp = operation, clamp
        for socket, value in zip(node.inputs, values, strict=False):
            if isinstance(value, float):
                socket.default_value = value
            else:
                links.new(value, socket)
        return node.outputs[0]

    depth = nodes.new("ShaderNodeAttribute")
    depth.attribute_name = "depth"
    mirrored = nodes.new("ShaderNodeFresnel")
    mirrored.inputs["IOR"].default_value = 1.333
    enters = number("SUBTRACT", 1.0, mirrored.outputs[0], clamp=True)
    albedo = nodes.new("ShaderNodeCombineXYZ")
    for socket, loss, sand in zip(albedo.inputs, LOSS, SAND, strict=True):
        left = number("EXPONENT", number("MULTIPLY", depth.outputs["Fac"], -2.1 * loss))
        links.new(number("MULTIPLY", number("MULTIPLY", left, sand), enters), socket)
    bed = nodes.new("ShaderNodeBsdfDiffuse")
    links.new(albedo.outputs[0], bed.inputs["Color"])
    both = nodes.new("ShaderNodeAddShader")
    links.new(water, both.inputs[0])
    links.new(bed.outputs[0], both.inputs[1])
    links.new(both.outputs[0], output.inputs["Surface"])
    drop(ob, view["eye"])


def main() -> None:
    name, path, sky, picture, samples, size = sys.argv[sys.argv.index("--") + 1 :]
    view = lands.view_of(name)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scenes.enable_addon()
    scene = bpy.context.scene
    camera = scenes.camera(scene, view["eye"], lands.hosts.target(view), 50.0)
    camera.data.angle = math.radians(view["angle"])
    camera.data.clip_start, camera.data.clip_end = 0.05, 2.0 * FARTHEST
    daylight.add_sky(scene, sky)
    daylight.add_sun(scene, *view["sun"])
    land = add_land(str(Path(path).resolve()), view)
    if land.libocean_terrain.problem:
        sys.exit(land.libocean_terrain.problem)
    if land.libocean_terrain.use_coast:
        add_water(scene, land, land.libocean_terrain.coast_level, view)
    daylight.render_light(scene, picture, int(samples), size)


if __name__ == "__main__":
    main()
