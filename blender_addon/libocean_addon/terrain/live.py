# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Brings the image, the inputs and the mesh of objects with a terrain up to date.

    parameters (evaluated: keyframes and drivers count) -> libocean -> float image -> nodes

Objects are found again by the node group that they use, and terrains (open_terrain) by the names of
their objects. handlers calls it, and changes of properties by way of hooks.
"""

from __future__ import annotations

import bpy

from ..sea import node_group as sea_group
from ..shared import changes, console, drafts, images, meshes, modifier_groups
from ..shared.native import libocean
from . import node_group
from .open_terrain import OpenTerrain, TerrainJob, terrain_of
from .parameter_values import values_of
from .parameters import WORDS
from .terrain_text import rings_in

terrain_objects = node_group.FAMILY.objects


def show(ob, depsgraph=None, *, moving: bool = False, again: bool = False) -> None:
    """Brings the image and the inputs of a terrain up to date. moving: a draft suffices for now;
    again: Blender may show the same once more by itself, and a draft of it stays one."""
    modifiers = node_group.modifiers(ob)
    seen = ob.evaluated_get(depsgraph) if depsgraph else ob
    terrain, settings = terrain_of(ob.name_full), ob.libocean_terrain
    values = values_of(seen.libocean_terrain)
    problem = ""
    try:
        terrain.follow(values)
        for modifier in modifiers:
            _show_in(ob, seen, terrain, modifier, moving=moving, again=again)
    except (libocean.Error, MemoryError) as failure:
        problem = WORDS.of_error(failure, len(values.layers)) or type(failure).__name__
    if settings.problem != problem:
        settings.problem = problem


def _show_in(ob, seen, terrain: OpenTerrain, modifier, *, moving: bool, again: bool) -> None:
    """Fills the image of a modifier and sets its other inputs. seen: the object, evaluated."""
    name, key = ob.name_full, (terrain.changes, terrain.size)
    image = modifier_groups.value(modifier, node_group.GROUND)
    if image is None:
        image = images.make(ob.name, "ground", (1, 1), node_group.BLANK)
        modifier_groups.assign(modifier, {node_group.GROUND: image})
    # Drafts go by the names of objects, of which a sea on the same one would have taken this one.
    may_wait = (moving or (again and drafts.wants(name, key))) and not sea_group.modifiers(ob)
    draft = may_wait and not terrain.is_whole() and (_is_large(ob) or not terrain.is_quick())
    if draft:
        terrain.show_draft(image)
        drafts.ask(name, key, rest=not drafts.is_playing())
    else:
        with console.work(name, "map"):
            terrain.show(image)
        drafts.forget(name, key, more_follows=False)
        if meshes.is_draft(ob.data):
            follow_mesh(ob)
    _set_inputs(ob, seen, terrain, modifier, image.size[0], draft=draft)


LARGE = 400000
"""The vertices of a mesh of which Blender takes longer than a user waits."""


def _is_large(ob) -> bool:
    is_tile = ob.libocean_terrain.shape == "TILE"
    return is_tile and isinstance(ob.data, bpy.types.Mesh) and len(ob.data.vertices) > LARGE


def _draft_inputs(ob, period: float) -> dict:
    """Returns the inputs by which the node group shows a coarse grid in place of a large mesh."""
    tiles = ob.libocean_terrain.tiles
    cells = max(2, meshes.fitting(meshes.DRAFT_SAMPLES // tiles)) * tiles
    material = ob.material_slots[0].material if ob.material_slots else None
    return {
        node_group.DRAFT_CELLS: cells,
        "Draft Size": period * tiles,
        "Draft Material": material,
    }


def _set_inputs(ob, seen, terrain: OpenTerrain, modifier, samples: int, *, draft: bool) -> None:
    settings = ob.libocean_terrain
    shows_grid = draft and _is_large(ob)
    period = float(terrain.values.values["patch_size"])
    # Only the place within a tile counts, and in single precision it counts most near 0.
    place, turn = (0.0, 0.0), (0.0, 0.0, 0.0)
    if settings.follow_world:
        place = seen.matrix_world.translation
        turn = tuple(seen.matrix_world.to_euler("XYZ"))
    modifier_groups.assign(
        modifier,
        {
            "Tile Size": period,
            "Half Texel": 0.5 / samples,
            "Origin": (place[0] % period, place[1] % period, 0.0),
            "Turn": turn,
            "On Samples": settings.shape == "TILE"
            and not shows_grid
            and meshes.is_on_samples(ob.data, samples),
            node_group.DRAFT_CELLS: 0,
            "Mask": settings.mask,
            "Use Mask": bool(settings.mask),
            "Use Normal": settings.use_normal,
            **(_draft_inputs(ob, period) if shows_grid else {}),
        },
    )


def show_all(depsgraph=None, *, rendering: bool = False, passing: bool = False) -> None:
    """Shows all terrains. passing: Blender says that the frame has changed."""
    moving, again = drafts.may_suffice(rendering=rendering, passing=passing)
    for ob in terrain_objects():
        show(ob, depsgraph, moving=moving, again=again)


def parameters_changed(ob) -> None:
    """Shows an object after one of its properties was set in the user interface or by a script."""
    if not node_group.modifiers(ob):
        return
    ob.update_tag()  # else what is evaluated goes on having the values of before
    show(ob, moving=drafts.allowed)
    if _keep_spectrum(ob):
        show(ob, moving=drafts.allowed)
    # Behind a draft the mesh follows when values rest; a new one is not left without vertices.
    draft = drafts.is_draft(ob.name_full)
    if not draft or meshes.is_empty(ob.data):
        follow_mesh(ob, draft=draft)


def _keep_spectrum(ob) -> bool:
    """Keeps the measured spectrum of a file in the settings, so that a blend file needs no other
    one. Returns whether there was one to keep."""
    settings, terrain = ob.libocean_terrain, terrain_of(ob.name_full)
    if not settings.measured or settings.measured_rings or settings.problem:
        return False
    with changes.quiet():
        settings.measured_rings = rings_in(terrain.terrain.text)
    return True


def samples_of(settings, own: int) -> int:
    """Returns the vertices along a side of each tile, so many that all tiles together stay within
    the max. own: the samples of the terrain."""
    wanted = settings.mesh_resolution or min(own, meshes.AUTOMATIC)
    return min(wanted, meshes.fitting(meshes.MAX_SAMPLES // settings.tiles))


def follow_mesh(ob, *, draft: bool = False) -> None:
    """Makes a mesh of the add-on fit the terrain, and labels a mesh of the user. A linked mesh
    stays as its file has it. draft: with few vertices."""
    terrain, settings = terrain_of(ob.name_full), ob.libocean_terrain
    is_local = ob.library is None and ob.data.library is None
    if not is_local or terrain.terrain is None or ob.mode != "OBJECT":
        return
    period = float(terrain.values.values["patch_size"])
    with console.work(ob.name_full, "mesh"):
        if settings.shape == "MESH":
            meshes.label_users(ob.data, period)
        else:
            samples, tiles = samples_of(settings, terrain.size), settings.tiles
            meshes.follow_patch(
                ob, period, samples, tiles=tiles, draft=draft, layers={meshes.UV_MAP}
            )
            for modifier in node_group.modifiers(ob):
                image = modifier_groups.value(modifier, node_group.GROUND)
                on_samples = image is not None and meshes.is_on_samples(ob.data, image.size[0])
                modifier_groups.assign(modifier, {"On Samples": on_samples})


def complete_meshes() -> None:
    """Makes the meshes whole that are drafts, before a render or for a file that is saved."""
    for ob in terrain_objects():
        if meshes.is_draft(ob.data):
            follow_mesh(ob)


def has_draft_meshes() -> bool:
    return any(meshes.is_draft(ob.data) for ob in terrain_objects())


# The whole terrain after a draft ------------------------------------------------


def _named(name: str):
    return next((ob for ob in terrain_objects() if ob.name_full == name), None)


def make_draft_job(name: str) -> TerrainJob | None:
    ob = _named(name)
    terrain = None if ob is None else terrain_of(ob.name_full)
    if terrain is None or terrain.terrain is None or ob.libocean_terrain.problem:
        return None
    return terrain.job()


def finish_draft_job(name: str, job: TerrainJob) -> None:
    ob = _named(name)
    if ob is None or job.is_cancelled():
        job.close()
        return
    if terrain_of(ob.name_full).take_over(job):
        follow_mesh(ob)
        show(ob, bpy.context.evaluated_depsgraph_get())
    elif isinstance(job.failure, (libocean.Error, MemoryError)):
        ob.libocean_terrain.problem = str(job.failure) or type(job.failure).__name__
