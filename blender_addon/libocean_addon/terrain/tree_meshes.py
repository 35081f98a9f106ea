# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Low trees for forests seen from afar: a conifer, a broad-leaved tree and a shrub, each of some
sixty faces, in a collection of no scene.
"""

from __future__ import annotations

import math

import bpy
import numpy as np

from ..shared import compat, meshes

COLLECTION = "Trees (libocean)"
_MARK = "libocean_trees"  # custom property of the collection: the version that made it
_VERSION = 1

_COLOURS = {
    "Bark": (0.060, 0.043, 0.030),
    "Needles": (0.014, 0.030, 0.014),
    "Leaves": (0.034, 0.060, 0.016),
}
"""Linear albedos."""

Part = tuple[np.ndarray, np.ndarray, str]
"""Vertices (n, 3), triangles (m, 3) and the name of the colour."""


def _ring(sides: int, radius: float, z: float, turn: float = 0.0) -> np.ndarray:
    angle = turn + np.arange(sides) * (2.0 * math.pi / sides)
    return np.stack([radius * np.cos(angle), radius * np.sin(angle), np.full(sides, z)], axis=1)


def _lathe(rings: list[np.ndarray], tip: tuple[float, float, float], colour: str) -> Part:
    """Returns the rings, one above the other, joined and closed by a tip at the top."""
    sides = len(rings[0])
    vertices = np.concatenate([*rings, [tip]])
    k, following = np.arange(sides), (np.arange(sides) + 1) % sides
    faces = []
    for below in range(0, sides * (len(rings) - 1), sides):
        faces.append(np.stack([below + k, below + following, below + sides + following], axis=1))
        faces.append(np.stack([below + k, below + sides + following, below + sides + k], axis=1))
    last = sides * (len(rings) - 1)
    faces.append(np.stack([last + k, last + following, np.full(sides, len(vertices) - 1)], axis=1))
    return vertices, np.concatenate(faces), colour


def _trunk(height: float, radius: float) -> Part:
    rings = [_ring(5, radius, -0.4), _ring(5, 0.6 * radius, height)]
    return _lathe(rings, (0.0, 0.0, height), "Bark")


def _conifer() -> list[Part]:
    """Returns a tree 14 m high."""
    parts = [_trunk(2.5, 0.22)]
    for number, (base, radius, top) in enumerate(
        ((1.8, 2.6, 7.6), (5.0, 2.0, 10.6), (8.0, 1.4, 14.0))
    ):
        parts.append(_lathe([_ring(8, radius, base, 0.4 * number)], (0.0, 0.0, top), "Needles"))
    return parts


def _crown(radius: float, low: float, high: float, sides: int) -> Part:
    """Returns a ball that is wider than high, its rings turned against each other."""
    rings = []
    for number, share in enumerate((0.06, 0.32, 0.62, 0.88)):
        wide = radius * math.sqrt(1.0 - (2.0 * share - 1.0) ** 2)
        rings.append(_ring(sides, wide, low + share * (high - low), 0.35 * number))
    return _lathe(rings, (0.0, 0.0, high), "Leaves")


def _broad() -> list[Part]:
    """Returns a tree 10 m high."""
    return [_trunk(4.0, 0.28), _crown(3.6, 2.8, 10.0, 8)]


def _shrub() -> list[Part]:
    """Returns a shrub 2.4 m high."""
    return [_crown(1.5, -0.2, 2.4, 7)]


_TREES = {"Conifer": _conifer, "Broad-leaved": _broad, "Shrub": _shrub}


def _material(colour: str):
    name = f"Tree {colour}"
    found = bpy.data.materials.get(name)
    if found is not None:
        return found
    material = bpy.data.materials.new(name)
    compat.use_nodes(material)
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    ground = nodes.new("ShaderNodeBsdfDiffuse")
    ground.inputs["Color"].default_value = (*_COLOURS[colour], 1.0)
    links.new(ground.outputs[0], nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    material.diffuse_color = (*(part**0.5 for part in _COLOURS[colour]), 1.0)
    return material


def _tree(name: str, parts: list[Part]):
    """Returns an object of these parts."""
    mesh = bpy.data.meshes.new(name)
    first, triangles, slots = 0, [], []
    for slot, (vertices, faces, colour) in enumerate(parts):
        mesh.materials.append(_material(colour))
        triangles.append(faces + first)
        slots.append(np.full(len(faces), slot, np.int32))
        first += len(vertices)
    meshes.fill(mesh, np.concatenate([part[0] for part in parts]), np.concatenate(triangles))
    mesh.polygons.foreach_set("material_index", np.concatenate(slots))
    return bpy.data.objects.new(name, mesh)


def get():
    """Returns the collection of the trees, made if the file has none."""
    for collection in bpy.data.collections:
        if collection.get(_MARK) == _VERSION and collection.library is None:
            return collection
    collection = bpy.data.collections.new(COLLECTION)
    collection[_MARK] = _VERSION
    for name, parts in _TREES.items():
        collection.objects.link(_tree(name, parts()))
    return collection
