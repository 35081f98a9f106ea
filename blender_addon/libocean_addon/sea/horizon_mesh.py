# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh of a horizon: rings around the camera, each of cells twice as large as those of the ring
inside it."""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from ..shared import meshes, stored_meshes
from . import ring_nodes

DRAFT_VERTICES = 100000
"""The max number of vertices of a horizon while its sea is a draft: made and drawn in a sixth of
the time."""


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


_KIND = "horizon"


@dataclasses.dataclass(frozen=True)
class Horizon:
    """The numbers that the mesh of a horizon is made of."""

    spacing: float
    """The sides of the finest cells [m]."""
    most_vertices: int
    distance: float
    """From the middle to the edge, at least [m]."""

    @staticmethod
    def of(words: str) -> Horizon:
        """Returns the horizon that words() describe."""
        _, spacing, most_vertices, distance = words.split()
        return Horizon(float(spacing), int(most_vertices), float(distance))

    def words(self) -> str:
        return f"{_KIND} {self.spacing!r} {self.most_vertices} {self.distance!r}"

    def parts(self):
        """Returns what horizon() returns."""
        return horizon(self.spacing, *choose_rings(self.spacing, self.most_vertices, self.distance))

    def fill(self, mesh) -> None:
        vertices, ring_of, *faces = self.parts()
        meshes.fill(mesh, vertices, *faces)
        attribute = mesh.attributes.new(ring_nodes.RING, "FLOAT_VECTOR", "POINT")
        attribute.data.foreach_set("vector", ring_of.astype(np.float32).ravel())


def follow_horizon(
    ob, spacing: float, most_vertices: int, distance: float, *, draft: bool = False
) -> None:
    """Makes a horizon's mesh again if one of these has changed. draft: with few vertices."""
    draft = draft and most_vertices > DRAFT_VERTICES
    shape = Horizon(spacing, DRAFT_VERTICES if draft else most_vertices, distance)
    made_of = shape.words()
    meshes.follow(ob, meshes.draft_of(made_of) if draft else made_of, shape.fill)


stored_meshes.earlier[_KIND] = lambda words: Horizon.of(words).fill
