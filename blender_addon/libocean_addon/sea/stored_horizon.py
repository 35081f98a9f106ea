# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The form in which a file holds the mesh of a live horizon: a small one of few vertices, and the
words of the whole one, which takes a hundred bytes for each vertex.

    whole mesh -> put_aside(), before a file is saved -> small mesh in the file
    small mesh -> make_whole(), after that, and when one is opened, linked, appended -> whole mesh

Without the add-on a live sea is flat, and a small mesh shows as much of it. A bake plays without
the add-on: its mesh is stored whole, and so is one that a user edited.
"""

from __future__ import annotations

import dataclasses
from collections import defaultdict

import bpy
import numpy as np

from ..shared import meshes
from . import ring_nodes
from .horizon_mesh import Horizon

VERTICES = 5000
"""The max number of vertices of a small horizon."""
_STORED = "stored "  # before the words that the whole mesh is made of
_SMALL_THERE = "libocean_small_there"  # custom property of a linked mesh that is whole in memory

_aside: dict[str, str] = {}
"""The names of whole meshes while a file is saved, by the names of the small meshes in their
place."""


def is_small(mesh) -> bool:
    """Returns whether a mesh is the stored form of a larger one."""
    return meshes.made_of(mesh).startswith(_STORED)


def _read(elements, name: str, kind, width: int = 1) -> np.ndarray:
    out = np.empty(width * len(elements), kind)
    elements.foreach_get(name, out)
    return out


def _layers(mesh) -> set[str]:
    """Returns the names of a mesh's layers; names of Blender's own layers begin with a point."""
    return {layer.name for layer in [*mesh.attributes, *mesh.uv_layers] if layer.name[0] != "."}


def _is_as_made(mesh, shape: Horizon, layers: set[str]) -> bool:
    """Returns whether a mesh equals a result of shape.fill() with these layers."""
    vertices, rings, *faces = shape.parts()
    corners = np.concatenate([of_one_kind.ravel() for of_one_kind in faces])
    counts = len(vertices), sum(map(len, faces)), len(corners)
    if mesh.shape_keys is not None or _layers(mesh) != layers:
        return False
    if (len(mesh.vertices), len(mesh.polygons), len(mesh.loops)) != counts:
        return False
    places = _read(mesh.vertices, "co", np.float32, 3)
    found = _read(mesh.attributes[ring_nodes.RING].data, "vector", np.float32, 3)
    return (
        np.array_equal(places, vertices.astype(np.float32).ravel())
        and np.array_equal(found, rings.astype(np.float32).ravel())
        and np.array_equal(_read(mesh.loops, "vertex_index", np.int32), corners)
        and not _read(mesh.polygons, "material_index", np.int32).any()
        and bool(_read(mesh.polygons, "use_smooth", bool).all())
    )


def _is_live(ob) -> bool:
    """Returns whether an object of the open file shows a live horizon, with nothing on the
    vertices."""
    is_own = ob.library is None and ob.override_library is None and ob.data.library is None
    is_plain = ob.mode == "OBJECT" and not ob.vertex_groups
    return is_own and is_plain and ob.libocean.kind == "HORIZON" and not ob.libocean.use_bake


def put_aside(oceans) -> None:
    """Puts a small mesh in the place of each whole one that can be made again, until make_whole():
    Blender writes no mesh without users. A bake that shows a mesh which is small in its own file
    gets a whole one in the open file."""
    users = defaultdict(list)
    for ob in oceans:
        if ob.library is None and ob.libocean.use_bake and ob.data.get(_SMALL_THERE):
            ob.data = ob.data.copy()
            del ob.data[_SMALL_THERE]
        elif _is_live(ob) and Horizon.of(meshes.made_of(ob.data)) is not None:
            users[ob.data].append(ob)
    for mesh, objects in users.items():
        if mesh.users == len(objects):
            _put_aside(mesh, objects)


def _put_aside(mesh, objects) -> None:
    shape = Horizon.of(meshes.made_of(mesh))
    small_shape = dataclasses.replace(shape, most_vertices=VERTICES)
    small = mesh.copy()
    meshes.make_again(small, _STORED + shape.words(), small_shape.fill)
    if not _is_as_made(mesh, shape, _layers(small)):
        bpy.data.meshes.remove(small)
        return
    name = mesh.name
    mesh.name, small.name = f".{name}", name
    for ob in objects:
        ob.data = small
    _aside[small.name] = mesh.name


def make_whole(oceans) -> None:
    """Makes the small meshes of these objects whole again. Meshes of other files change in memory
    alone."""
    for ob in oceans:
        small = ob.data
        if not is_small(small):
            continue
        words = meshes.made_of(small).removeprefix(_STORED)
        kept = bpy.data.meshes.get(_aside.pop(small.name, "")) if small.library is None else None
        if kept is not None and meshes.made_of(kept) == words:
            name = small.name
            small.user_remap(kept)
            bpy.data.meshes.remove(small)
            kept.name = name
            continue
        meshes.make_again(small, words, Horizon.of(words).fill)
        if small.library is not None:
            small[_SMALL_THERE] = True
    _aside.clear()
