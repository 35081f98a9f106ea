# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The meshes of Add > Mesh > Ocean."""

from __future__ import annotations

import math

import bmesh
import bpy
import numpy as np

from ..shared import compat
from . import ring_nodes


def fill(mesh, vertices: np.ndarray, *faces: np.ndarray) -> None:
    """Replaces all of a mesh by these vertices (n, 3) and smooth faces. faces: (m, k), one array
    for each number of corners k."""
    mesh.clear_geometry()
    mesh.vertices.add(len(vertices))
    mesh.vertices.foreach_set("co", np.ascontiguousarray(vertices, dtype=np.float32).ravel())
    corners = np.concatenate([of_one_kind.ravel() for of_one_kind in faces]).astype(np.int32)
    counts = np.concatenate([np.full(len(f), f.shape[1], np.int32) for f in faces])
    mesh.loops.add(len(corners))
    mesh.loops.foreach_set("vertex_index", corners)
    mesh.polygons.add(len(counts))
    mesh.polygons.foreach_set("loop_start", np.cumsum(counts, dtype=np.int32) - counts)
    if not compat.LOOP_TOTAL_FOLLOWS:
        mesh.polygons.foreach_set("loop_total", counts)
    mesh.update(calc_edges=True)
    compat.shade_smooth(mesh)


LABEL = "label"
UV_MAP = "UVMap"


def _write_labels(mesh, period: float) -> None:
    """Writes the undisplaced coordinate of each vertex [m] as the attribute `label`, z = 0, and its
    share of the period as a UV map. A node group with foam stores a label of the world over it.
    Without shared layers the UV map, 12 bytes a corner, would cost a seventh of each frame: older
    Blenders get the label alone."""
    places = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", places)
    places = places.reshape(-1, 3)
    places[:, 2] = 0.0
    # One after the other: a layer that is added moves the memory of those before it.
    label = mesh.attributes.get(LABEL) or mesh.attributes.new(LABEL, "FLOAT_VECTOR", "POINT")
    label.data.foreach_set("vector", places.ravel())
    if not compat.SHARES_LAYERS:
        return
    corners = np.empty(len(mesh.loops), np.int32)
    mesh.loops.foreach_get("vertex_index", corners)
    uv = mesh.uv_layers.get(UV_MAP) or mesh.uv_layers.new(name=UV_MAP, do_init=False)
    uv.data.foreach_set("uv", (places[:, :2] / np.float32(period))[corners].ravel())


def _is_labelled(mesh) -> bool:
    return LABEL in mesh.attributes and (not compat.SHARES_LAYERS or UV_MAP in mesh.uv_layers)


_LABELLED = "libocean_label"  # custom property of a user's mesh: the period of its UV map [m]


def label_users(mesh, period: float) -> None:
    """Gives a mesh that an ocean modifier displaces labels and a UV map, unless it has a UV map or
    an attribute of that name of its own."""
    if not isinstance(mesh, bpy.types.Mesh) or mesh.library is not None:
        return
    labelled = mesh.get(_LABELLED)
    is_ours = labelled is not None and _is_labelled(mesh)
    is_bare = labelled is None and not mesh.uv_layers and LABEL not in mesh.attributes
    if (is_ours and labelled != period) or is_bare:
        _write_labels(mesh, period)
        mesh[_LABELLED] = period


def _patch_vertices(size: float, samples: int) -> np.ndarray:
    """Returns one period around the origin: a vertex on each of samples x samples, and the
    seam's."""
    side = samples + 1
    along = (np.arange(side) - samples // 2) * (size / samples)
    vertices = np.zeros((side, side, 3), np.float32)
    vertices[..., 0] = along[None, :]
    vertices[..., 1] = along[:, None]
    return vertices.reshape(-1, 3)


def _patch_faces(samples: int) -> np.ndarray:
    side = samples + 1
    corner = (np.arange(samples)[:, None] * side + np.arange(samples)[None, :]).ravel()
    return np.stack([corner, corner + 1, corner + side + 1, corner + side], axis=1)


AUTOMATIC = 512
"""The max samples per side of a mesh that follows the maps by itself: a quarter of a million
vertices."""
MAX_SAMPLES = 4096
DRAFT_SAMPLES = 256
"""The max samples per side of a patch's mesh while its sea is a draft."""
DRAFT_VERTICES = 100000
"""The max number of vertices of a horizon while its sea is a draft: made and drawn in a sixth of
the time."""
_MADE_OF = "libocean_mesh"  # custom property of a mesh: what it was made of


def automatic(own: int) -> int:
    """Returns the samples per side of a patch's mesh that follows a map of `own` samples per
    side."""
    return min(own, AUTOMATIC)


_DRAFT = "draft "


def is_draft(mesh) -> bool:
    """Returns whether a mesh has the few vertices of a draft."""
    return isinstance(mesh, bpy.types.Mesh) and mesh.get(_MADE_OF, "").startswith(_DRAFT)


def samples_of(mesh) -> int | None:
    """Returns the samples per side that a patch's mesh was made for; None for other data."""
    words = mesh.get(_MADE_OF, "").removeprefix(_DRAFT).split()
    return int(words[2]) if words and words[0] == "patch" else None


def is_empty(mesh) -> bool:
    """Returns whether a mesh has not been made yet."""
    return isinstance(mesh, bpy.types.Mesh) and len(mesh.vertices) == 0


def is_on_samples(mesh, samples: int) -> bool:
    """Returns whether each vertex of a patch lies on a sample of a map of `samples` per side."""
    made_for = samples_of(mesh)
    return made_for is None or samples % made_for == 0


def _follow(ob, made_of: str, make) -> None:
    """Has make(mesh) fill the mesh of an object, unless it was made of the same. Objects that share
    a mesh and then differ get one each."""
    if ob.data.get(_MADE_OF) == made_of:
        return
    if ob.data.library is not None:
        _fill_linked(ob.data, make)
    else:
        if ob.data.users > 1:
            ob.data = ob.data.copy()
        make(ob.data)
    ob.data[_MADE_OF] = made_of


def _fill_linked(mesh, make) -> None:
    """Fills a mesh of another file in memory alone; that file keeps its own. Blender refuses to set
    the places of its vertices, but accepts a whole BMesh."""
    local = bpy.data.meshes.new(mesh.name)
    make(local)
    all_of_it = bmesh.new()
    all_of_it.from_mesh(local)
    all_of_it.to_mesh(mesh)
    all_of_it.free()
    bpy.data.meshes.remove(local)


def follow_patch(ob, size: float, samples: int, *, draft: bool = False) -> None:
    """Makes a patch's mesh again if its period or its samples have changed. draft: with few
    vertices."""
    draft = draft and samples > DRAFT_SAMPLES
    samples = DRAFT_SAMPLES if draft else samples

    def make(mesh) -> None:
        before = samples_of(mesh)
        if before == samples and len(mesh.vertices) == (samples + 1) ** 2:
            mesh.vertices.foreach_set("co", _patch_vertices(size, samples).ravel())
            mesh.update()
        else:
            fill(mesh, _patch_vertices(size, samples), _patch_faces(samples))
        _write_labels(mesh, size)

    _follow(ob, f"{_DRAFT if draft else ''}patch {size!r} {samples}", make)
    if ob.data.library is None and not _is_labelled(ob.data):  # of an earlier version
        _write_labels(ob.data, size)


STAND_IN = "stand-in"


def fill_stand_in(mesh, size: float) -> None:
    """Fills a mesh with one face, in place of the mesh that will be made when the object is
    shown."""
    fill(mesh, _patch_vertices(size, 1), _patch_faces(1))
    mesh[_MADE_OF] = STAND_IN


def is_stand_in(mesh) -> bool:
    return isinstance(mesh, bpy.types.Mesh) and mesh.get(_MADE_OF) == STAND_IN


# The rings of a horizon -------------------------------------------------------


def choose_rings(spacing: float, most_vertices: int, distance: float) -> tuple[int, int]:
    """Returns the cells per side of each ring's square, a multiple of eight, and the number of
    rings: out to `distance` [m] from the middle, the first ring of cells of `spacing` [m], each
    other one of cells twice as large. The fewest rings that the vertices allow: they have more
    cells each."""
    rings = 0
    while True:
        rings += 1
        # A ring is three quarters of a square, without its inner edge.
        side = math.sqrt(most_vertices / (1.0 + 0.75 * (rings - 1)))
        cells = max(8, int(side - 2.0) // 8 * 8)
        if cells / 2 * spacing * 2.0 ** (rings - 1) >= distance:
            return cells, rings


def horizon(spacing: float, cells: int, rings: int):
    """Returns vertices, the attribute ring_nodes.RING of each, quads and pentagons. A ring becomes
    the next one in the outer quarter of its half width. Where two rings meet, every vertex of the
    finer one is a corner of the coarser one's faces: the mesh has no crack."""
    half = cells // 2
    hole = half // 2
    along = np.arange(-half, half + 1)
    x, y = np.meshgrid(along, along)
    reach = np.maximum(abs(x), abs(y))
    becoming = np.clip((reach - 3 * hole / 2) / (hole / 2), 0.0, 1.0)
    vertices, ring_of, quads, pentagons = [], [], [], []
    count = 0
    finer = number = np.empty((0, 0), int)
    for ring in range(rings):
        finer, number = number, np.full(x.shape, -1)
        new = reach > (hole if ring else -1)
        number[new] = count + np.arange(new.sum())
        if ring:
            shared = reach == hole
            number[shared] = finer[2 * y[shared] + half, 2 * x[shared] + half]
        count += new.sum()
        place = np.stack([x[new], y[new], np.zeros(new.sum())], axis=1)
        vertices.append(place * (spacing * 2.0**ring))
        share = becoming[new] if ring + 1 < rings else np.zeros(new.sum())
        ring_of.append(np.stack(np.broadcast_arrays(ring, share, 2.0**ring), axis=1))

        corners = [number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]]
        face = np.stack(corners, axis=-1)
        plain = np.ones(face.shape[:2], bool)
        if ring:
            low, high, beside = half - hole - 1, half + hole, slice(half - hole, half + hole)
            plain[beside, beside] = False
            # The cells below, above, left and right of the hole, and their edge towards it.
            for cell, edge, middles in (
                ((low, beside), 2, finer[0, 1::2]),
                ((high, beside), 0, finer[-1, 1::2]),
                ((beside, low), 1, finer[1::2, 0]),
                ((beside, high), 3, finer[1::2, -1]),
            ):
                pentagons.append(np.insert(face[cell], edge + 1, middles, axis=1))
                plain[cell] = False
        quads.append(face[plain])
    return (
        np.concatenate(vertices),
        np.concatenate(ring_of),
        np.concatenate(quads),
        np.concatenate(pentagons) if pentagons else np.empty((0, 5), int),
    )


def follow_horizon(
    ob, spacing: float, most_vertices: int, distance: float, *, draft: bool = False
) -> None:
    """Makes a horizon's mesh again if one of these has changed. draft: with few vertices."""
    draft = draft and most_vertices > DRAFT_VERTICES
    most_vertices = DRAFT_VERTICES if draft else most_vertices

    def make(mesh) -> None:
        vertices, ring_of, *faces = horizon(
            spacing, *choose_rings(spacing, most_vertices, distance)
        )
        fill(mesh, vertices, *faces)
        attribute = mesh.attributes.new(ring_nodes.RING, "FLOAT_VECTOR", "POINT")
        attribute.data.foreach_set("vector", ring_of.astype(np.float32).ravel())

    made_of = f"horizon {spacing!r} {most_vertices} {distance!r}"
    _follow(ob, f"{_DRAFT if draft else ''}{made_of}", make)
