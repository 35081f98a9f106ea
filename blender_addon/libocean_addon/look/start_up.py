# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The cube, the lamp and the camera of Blender's start-up file, which stand in the way of a sea."""

from __future__ import annotations

import bpy

_PLACES = {
    "Cube": (0.0, 0.0, 0.0),
    "Light": (4.0762453, 1.0054539, 5.9038620),
    "Camera": (7.3588915, -6.9257908, 4.9583092),
}
_TURNS = {
    "Cube": (0.0, 0.0, 0.0),
    "Light": (0.6503280, 0.0552171, 1.8663908),
    "Camera": (1.1093190, 0.0, 0.8149282),
}
# Custom properties that panels make.
_OF_ADDONS = {"cycles", "libocean", "libocean_float", "libocean_terrain"}
_ALMOST = 1e-5  # single precision


def _is_near(values, wanted) -> bool:
    return all(abs(a - b) < _ALMOST for a, b in zip(values, wanted, strict=True))


def _is_plain(block) -> bool:
    """Returns whether a block has neither animation nor custom properties nor other users."""
    return block.animation_data is None and not list(block.keys()) and block.users == 1


def _is_at_its_place(ob) -> bool:
    return (
        _is_near(ob.location, _PLACES[ob.name])
        and _is_near(ob.rotation_euler, _TURNS[ob.name])
        and _is_near(ob.scale, (1.0, 1.0, 1.0))
        and ob.rotation_mode == "XYZ"
        and ob.parent is None
        and not (ob.children or ob.constraints or ob.modifiers)
        and not (ob.hide_render or ob.hide_viewport or ob.hide_get())
    )


def _is_default_material(material) -> bool:
    if material is None or material.name != "Material" or not _is_plain(material):
        return False
    nodes = material.node_tree.nodes if material.node_tree else ()
    if {node.type for node in nodes} != {"BSDF_PRINCIPLED", "OUTPUT_MATERIAL"} or len(nodes) != 2:
        return False
    shader = next(node for node in nodes if node.type == "BSDF_PRINCIPLED")
    return _is_near(shader.inputs["Base Color"].default_value, (0.8, 0.8, 0.8, 1.0))


def _is_default_cube(ob) -> bool:
    mesh = ob.data
    return (
        ob.type == "MESH"
        and _is_plain(mesh)
        and not ob.vertex_groups
        and mesh.shape_keys is None
        and len(mesh.vertices) == 8
        and len(mesh.polygons) == 6
        and all(_is_near(map(abs, vertex.co), (1.0, 1.0, 1.0)) for vertex in mesh.vertices)
        and len(mesh.materials) == 1
        and _is_default_material(mesh.materials[0])
    )


def _has_default_nodes(lamp) -> bool:
    """Returns whether a lamp has no nodes, or only the nodes that Blender 5.2 gives each lamp."""
    if lamp.node_tree is None:
        return True
    nodes = {node.type: node for node in lamp.node_tree.nodes}
    if set(nodes) != {"EMISSION", "OUTPUT_LIGHT"} or len(lamp.node_tree.nodes) != 2:
        return False
    emission = nodes["EMISSION"].inputs
    return (
        _is_near(emission["Color"].default_value, (1.0, 1.0, 1.0, 1.0))
        and emission["Strength"].default_value == 1.0
    )


def _is_default_lamp(ob) -> bool:
    lamp = ob.data
    return (
        ob.type == "LIGHT"
        and _is_plain(lamp)
        and lamp.type == "POINT"
        and _has_default_nodes(lamp)
        and lamp.energy == 1000.0
        and _is_near(lamp.color, (1.0, 1.0, 1.0))
    )


def _is_default_camera(ob) -> bool:
    camera = ob.data
    return (
        ob.type == "CAMERA"
        and _is_plain(camera)
        and camera.type == "PERSP"
        and camera.lens == 50.0
        and camera.shift_x == camera.shift_y == 0.0
        and not (camera.dof.use_dof or camera.background_images)
    )


_DEFAULTS = {"Cube": _is_default_cube, "Light": _is_default_lamp, "Camera": _is_default_camera}


def untouched(scene) -> list:
    """Returns the cube, the lamp and the camera of the start-up file, each if it is unchanged; none
    if the scene has other objects than the start-up file."""
    if any(ob.name not in _PLACES for ob in scene.objects):
        return []
    found = [scene.objects[name] for name in _DEFAULTS if name in scene.objects]
    return [
        ob
        for ob in found
        if ob.library is None
        and ob.animation_data is None
        and set(ob.keys()) <= _OF_ADDONS
        and len(ob.users_collection) == 1
        and len(ob.users_scene) == 1
        and _is_at_its_place(ob)
        and _DEFAULTS[ob.name](ob)
    ]


def remove_untouched(scene) -> list[str]:
    """Removes the untouched objects of the start-up file, with their data. Returns the names
    of the removed objects."""
    found = untouched(scene)
    names = [ob.name for ob in found]
    data = [ob.data for ob in found]
    materials = [material for block in data for material in getattr(block, "materials", ())]
    for blocks in (found, data, materials):
        bpy.data.batch_remove(blocks)
    return names
