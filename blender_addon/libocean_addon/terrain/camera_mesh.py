# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh of a terrain whose detail falls with the distance to the camera.

    camera -> place in a grid: CameraView -> libocean: CameraVertices -> mesh of the object

The mesh has the land's heights: the node group gives it attributes alone.
"""

from __future__ import annotations

import dataclasses
import hashlib

import numpy as np

from ..shared import meshes

_KIND = "camera"


@dataclasses.dataclass(frozen=True)
class CameraView:
    """A camera over the land, in metres of the land."""

    place: tuple[float, float, float]
    """Its place, in the grid that it snaps to."""
    spacing: float
    """The distance of the vertices at the camera."""
    farthest: float
    """The distance up to which there is a mesh."""


@dataclasses.dataclass(frozen=True)
class CameraVertices:
    """A mesh around a camera."""

    positions: np.ndarray
    """(n, 3), float32 [m]."""
    corners: np.ndarray
    """(m, 3), int32: triangles, counter-clockwise from above."""


def view_of(ob, camera, settings) -> CameraView | None:
    """Returns the view of a camera for an object with a terrain; None without a camera. ob and
    camera: evaluated; settings: of the object."""
    if camera is None:
        return None
    local = ob.matrix_world.inverted_safe() @ camera.matrix_world.translation
    snap = settings.lod_snap
    place = tuple(snap * round(part / snap) for part in local)
    return CameraView(place, round(settings.lod_spacing, 6), round(settings.lod_farthest, 3))


def make_vertices(terrain, view: CameraView) -> CameraVertices:
    """Returns the mesh around a camera. Raises libocean.Error."""
    made = terrain.mesh(view.place, spacing=view.spacing, farthest=view.farthest)
    return CameraVertices(made.positions.astype(np.float32), made.corners.astype(np.int32))


def is_around_camera(mesh) -> bool:
    """Returns whether a mesh is one around a camera."""
    return meshes.made_of(mesh).startswith(f"{_KIND} ")


def words_of(text: str, view: CameraView) -> str:
    """Returns the words by which such a mesh is known. text: the terrain file."""
    digest = hashlib.sha256(f"{text}\n{view!r}".encode()).hexdigest()
    return f"{_KIND} {digest[:32]}"


def follow(ob, words: str, vertices) -> None:
    """Has an object show the mesh of these words. vertices(): CameraVertices."""

    def make(mesh) -> None:
        made = vertices()
        meshes.fill(mesh, made.positions, made.corners)

    meshes.follow(ob, words, make)
