# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The meshes of Add > Mesh > Ocean."""

from __future__ import annotations

import numpy as np

from . import compat


def fill(mesh, vertices: np.ndarray, quads: np.ndarray) -> None:
    """Makes the mesh that of these vertices (n, 3) and faces (m, 4), smooth, all new."""
    mesh.clear_geometry()
    mesh.vertices.add(len(vertices))
    mesh.vertices.foreach_set("co", np.ascontiguousarray(vertices, dtype=np.float32).ravel())
    mesh.loops.add(4 * len(quads))
    mesh.loops.foreach_set("vertex_index", quads.astype(np.int32).ravel())
    mesh.polygons.add(len(quads))
    mesh.polygons.foreach_set("loop_start", np.arange(0, 4 * len(quads), 4, dtype=np.int32))
    if not compat.LOOP_TOTAL_FOLLOWS:
        mesh.polygons.foreach_set("loop_total", np.full(len(quads), 4, dtype=np.int32))
    mesh.update(calc_edges=True)
    compat.shade_smooth(mesh)


def patch(size: float, samples: int) -> tuple[np.ndarray, np.ndarray]:
    """One period around the origin: a vertex on each of samples x samples, and the seam's."""
    side = samples + 1
    along = (np.arange(side) - samples // 2) * (size / samples)
    vertices = np.zeros((side, side, 3))
    vertices[..., 0] = along[None, :]
    vertices[..., 1] = along[:, None]
    corner = (np.arange(samples)[:, None] * side + np.arange(samples)[None, :]).ravel()
    quads = np.stack([corner, corner + 1, corner + side + 1, corner + side], axis=1)
    return vertices.reshape(-1, 3), quads


MAX_SAMPLES = 1024
_MADE_OF = "libocean_patch"  # custom property of a mesh: what it was made of


def follow_patch(mesh, size: float, samples: int) -> None:
    """Makes a patch's mesh anew where the period or the number of samples is another."""
    made_of = f"{size!r} {min(samples, MAX_SAMPLES)}"
    if mesh.get(_MADE_OF) != made_of:
        fill(mesh, *patch(size, min(samples, MAX_SAMPLES)))
        mesh[_MADE_OF] = made_of
