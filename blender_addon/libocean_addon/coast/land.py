# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The land of a coast: a mesh of the bed, with the attributes that the terrain's material reads."""

from __future__ import annotations

import bpy
import numpy as np

from ..shared import meshes
from ..terrain import material as terrain_material
from ..terrain import node_group as terrain_group
from .cusps import Cusps
from .shore_mesh import DRY_SAND, Grid

_RUN_UP = 0.3
"""Height over still water up to which waves wet the land, as a share of the significant wave
height. The value holds for a beach of moderate slope."""

_WET_WIDTH = 0.4
"""The height in which wet sand turns dry, as a share of the run-up; chosen by eye."""

_STEP, _SHARE_STEP = 2.0**-12, 2.0**-8
"""Heights [m], normals and shares of a land with cusps are multiples of these: a file holds them in
half of the bytes, and so no more of them than without cusps."""


def _rounded(values: np.ndarray, step: float) -> np.ndarray:
    return np.rint(values / step) * step


def _tilted(normals: np.ndarray, slopes: np.ndarray) -> np.ndarray:
    """Returns normals, (n, 3), of ground that has these slopes, (n, 2), in addition."""
    tilted = normals.astype(np.float64)
    tilted[:, :2] -= slopes * tilted[:, 2:]
    return tilted / np.linalg.norm(tilted, axis=1)[:, None]


def run_up(state: dict) -> float:
    """Returns the height up to which the waves of a sea in that state wet its land [m]."""
    return _RUN_UP * state["significant_wave_height"]["resolved"]


def follow(land, grid: Grid, wet: float, cusps: Cusps | None = None) -> None:
    """Has an object show the bed of a grid, unless it does, is linked or being edited. wet: the
    run-up of the waves [m]; cusps: of the beach, over the bed."""
    if not meshes.is_ours(land) or land.mode != "OBJECT":
        return
    extent, bed = grid.extent, grid.bed

    def make(mesh) -> None:
        vertices, heights = grid.places, grid.read(bed.heights)
        normals = grid.read(bed.normals)
        # The middle of the edge lies at the end of the sand; on lands without cusps, those of
        # earlier versions, sand thins out up to there.
        ends = wet + DRY_SAND * (1.0 if cusps is None else 1.5)
        beach = np.clip((ends - heights) / DRY_SAND, 0.0, 1.0)
        if cusps is not None:
            higher, slopes = cusps.at(grid)
            heights = _rounded(heights + higher, _STEP)
            normals = _rounded(_tilted(normals, slopes), _STEP)
            beach = _rounded(beach, _SHARE_STEP)
        vertices[:, 2] = heights
        if grid.ratio == 1 and meshes.made_of(mesh).endswith(f" {extent.samples}"):
            mesh.vertices.foreach_set("co", vertices.astype(np.float32).ravel())
            mesh.update()
        else:
            meshes.fill(mesh, vertices, *grid.faces)
        meshes.write_numbers(mesh, terrain_group.HEIGHT, heights)
        meshes.write_numbers(mesh, "beach", beach)
        meshes.write_numbers(mesh, terrain_group.NORMAL, normals)

    words = f"bed {bed.mark} {extent.origin} {extent.cell!r} {extent.samples}{grid.fine_words}"
    words += "" if cusps is None else cusps.words
    meshes.follow(land, words, make)


def look_of(state: dict, size: float) -> dict[str, float]:
    """Returns the sockets of the terrain's material for the land of a sea in that state: sand up to
    the run-up of its waves and a little higher, wet where they reach. size: of the land [m]."""
    bed = state["bed"]
    spread = (bed["highest"] - bed["lowest"]) / 4.0
    ground = {
        "rms": {"resolved": spread},
        "mean": bed["mean"],
        "highest": bed["highest"],
        "size": (size,),
    }
    look = terrain_material.look_of(ground, 0.0)
    wet = run_up(state)
    return {
        **look,
        "Wet Line": wet,
        "Wet Width": max(_WET_WIDTH * wet, 1e-3),
        "Sand Line": wet + DRY_SAND,
    }


def give(land, look: dict[str, float], world) -> None:
    """Gives a land a new material of these sockets. world: whose sky lends the haze its light."""
    terrain_material.put_in_first_slot(land, terrain_material.make(look))
    terrain_material.follow_scene(land, world)


def new_part(water, name: str):
    """Returns a new part of a coast, its land or far water: a child of its water, without vertices
    yet."""
    part = bpy.data.objects.new(name, bpy.data.meshes.new(name))
    for collection in water.users_collection:
        collection.objects.link(part)
    part.parent = water
    return part
