# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Brings the image, the inputs and the mesh of objects with a terrain up to date.

    parameters (evaluated: keyframes and drivers count) -> libocean -> float image -> nodes

Objects are found again by the node group that they use, and terrains (open_terrain) by the names of
their objects. handlers calls it, and changes of properties by way of hooks.
"""

from __future__ import annotations

import threading

import bpy

from ..sea import node_group as sea_group
from ..shared import changes, console, drafts, failures, images, meshes, modifier_groups
from ..shared.native import libocean
from . import camera_mesh, node_group
from .camera_mesh import CameraView
from .extent import Extent, ExtentError
from .open_terrain import OpenTerrain, TerrainJob, terrain_of
from .parameter_values import is_shaped, values_of
from .parameters import WORDS
from .terrain_text import rings_in

terrain_objects = node_group.FAMILY.objects


def show(ob, depsgraph=None, *, moving: bool = False, is_redraw: bool = False) -> None:
    """Brings the images and the inputs of a terrain up to date. moving: a draft suffices for now;
    is_redraw: Blender may redraw the same frame unprompted, and a draft of that frame stays one."""
    seen = ob.evaluated_get(depsgraph) if depsgraph else ob
    terrain, settings = terrain_of(ob.name_full), ob.libocean_terrain
    values = values_of(seen.libocean_terrain)
    problem = ""
    try:
        terrain.follow(values)
        terrain.region = _region_of(seen.libocean_terrain)
        view = terrain.view = wanted_view(ob, depsgraph)
        if _is_main_thread():
            drafts.keep_timer(ob.name_full, kept=view is not None)
        for modifier in node_group.modifiers(ob):
            _show_in(ob, seen, terrain, modifier, view, moving=moving, is_redraw=is_redraw)
    except ExtentError as failure:
        problem = str(failure)
    except (libocean.Error, MemoryError) as failure:
        problem = WORDS.of_error(failure, len(values.layers))
    except Exception as failure:  # a fault of the add-on, which ends neither a frame nor an edit
        problem = failures.sentence(failure)
    if settings.problem != problem:
        settings.problem = problem


_rendering = False


def begin_render() -> None:
    """Has meshes follow the camera of the rendered frames alone, until end_render()."""
    global _rendering
    _rendering = True


def end_render() -> None:
    global _rendering
    _rendering = False


def _is_main_thread() -> bool:
    return threading.current_thread() is threading.main_thread()


def _region_of(settings) -> tuple | None:
    """Returns corners and cell of the region that the settings name, as shown in a panel."""
    if not settings.use_region or settings.use_lod or settings.shape != "TILE":
        return None
    return tuple(round(part, 4) for part in settings.region), round(settings.region_cell, 6)


def wanted_view(ob, depsgraph=None) -> CameraView | None:
    """Returns the view of the scene's camera for the mesh of an object; None for other meshes."""
    settings = ob.libocean_terrain
    if not settings.use_lod or settings.shape != "TILE":
        return None
    if _rendering and (depsgraph is None or depsgraph.mode != "RENDER"):
        return terrain_of(ob.name_full).view  # the view of the rendered frame
    camera = bpy.context.scene.camera if depsgraph is None else depsgraph.scene.camera
    if depsgraph is None or camera is None:
        return camera_mesh.view_of(ob, camera, settings)
    seen = ob.evaluated_get(depsgraph)
    return camera_mesh.view_of(seen, camera.evaluated_get(depsgraph), settings)


def _images_of(ob, terrain: OpenTerrain, modifier) -> dict:
    """Returns the images of a modifier by their inputs, made where they are missing."""
    names = {node_group.GROUND: node_group.BLANK}
    names.update({node_group.image_of(group): (0.0,) * 4 for group in terrain.groups})
    found = {}
    for name, blank in names.items():
        found[name] = modifier_groups.value(modifier, name)
        if found[name] is None:
            kind = "ground" if name == node_group.GROUND else name.lower()
            found[name] = images.make(ob.name, kind, (1, 1), blank)
            modifier_groups.assign(modifier, {name: found[name]})
    return found


def _renew(ob, modifier) -> None:
    """Gives a modifier of an earlier version of the add-on today's node group."""
    if not node_group.FAMILY.is_old(modifier.node_group) or ob.library is not None:
        return
    image = modifier_groups.value(modifier, node_group.GROUND)
    modifier.node_group = node_group.get()
    modifier_groups.assign(modifier, {node_group.GROUND: image})


def _show_in(
    ob,
    seen,
    terrain: OpenTerrain,
    modifier,
    view: CameraView | None,
    *,
    moving: bool,
    is_redraw: bool,
) -> None:
    """Fills the images of a modifier and sets its other inputs. seen: the object, evaluated."""
    _renew(ob, modifier)
    name, key = ob.name_full, (terrain.key, view)
    image_named = _images_of(ob, terrain, modifier)
    # Drafts are kept by names of objects: a sea on the same object has this name already.
    may_wait = (moving or (is_redraw and drafts.wants(name, key))) and not sea_group.modifiers(ob)
    lacks_mesh = view is not None and _lacks_mesh(ob, terrain, view)
    is_slow = _is_large(ob) or not terrain.is_quick()
    draft = may_wait and (lacks_mesh or (is_slow and not terrain.is_whole()))
    if lacks_mesh and not draft and not _is_main_thread():
        # A render in a thread of its own, in which no mesh may be changed.
        drafts.ask(name, key, rest=False)
        drafts.complete()
    if draft:
        shown = terrain.show_draft(image_named)
        drafts.ask(name, key, rest=not drafts.is_playing())
    else:
        with console.work(name, "map"):
            shown = terrain.show(image_named)
        drafts.forget(name, key, more_follows=False)
        if _is_main_thread() and (meshes.is_draft(ob.data) or _has_other_view(ob, terrain, view)):
            follow_mesh(ob, view=view)
    _set_inputs(ob, seen, terrain, modifier, shown, draft=draft)


LARGE = 400000
"""The vertices of a mesh for which Blender takes longer than a user waits."""


def _is_large(ob) -> bool:
    is_plain = meshes.samples_of(ob.data) is not None or meshes.made_of(ob.data).startswith("grid ")
    is_ours = ob.libocean_terrain.shape == "TILE" and is_plain
    return is_ours and isinstance(ob.data, bpy.types.Mesh) and len(ob.data.vertices) > LARGE


def _draft_inputs(ob, shown: Extent) -> dict:
    """Returns the inputs by which the node group shows a coarse grid in place of a large mesh."""
    tiles = ob.libocean_terrain.tiles if shown.wraps else 1
    sides = tuple(side * tiles for side in shown.size)
    middle = (0.0, 0.0)
    if not shown.wraps:
        middle = tuple(low + side / 2.0 for low, side in zip(shown.origin, sides, strict=True))
    cells = max(2, meshes.fitting(meshes.DRAFT_SAMPLES // tiles)) * tiles
    material = ob.material_slots[0].material if ob.material_slots else None
    return {
        node_group.DRAFT_CELLS: cells,
        "Draft Sides": (*sides, 0.0),
        "Draft Middle": (*middle, 0.0),
        "Draft Size": sides[0],  # read by a linked group of an earlier version
        "Draft Material": material,
    }


_ENDLESS = 1e9  # periods: more than a mesh has


def _map_inputs(terrain: OpenTerrain, shown: Extent, place) -> dict:
    """Returns the inputs by which the node group finds a place on the maps. place: of the object in
    the world, where it counts."""
    half = tuple(0.5 / count for count in shown.samples)
    size = shown.map_size
    if shown.wraps:
        # Only the place within a tile counts, and in single precision it counts most near 0.
        origin = tuple(part % period for part, period in zip(place, size, strict=False))
        low, high = (-_ENDLESS,) * 2, (_ENDLESS,) * 2
    else:
        origin = tuple(part - first for part, first in zip(place, shown.origin, strict=False))
        low, high = half, tuple(1.0 - part for part in half)
    return {
        "Map Size": (*size, 1.0),
        "Half Texels": (*half, 0.0),
        "Low": (*low, 0.0),
        "High": (*high, 0.0),
        "Origin": (*origin, 0.0),
        # A linked node group of an earlier version reads these.
        "Tile Size": size[0],
        "Half Texel": half[0],
    }


def _set_inputs(ob, seen, terrain: OpenTerrain, modifier, shown: Extent, *, draft: bool) -> None:
    settings = ob.libocean_terrain
    shows_grid = draft and _is_large(ob)
    is_raised = camera_mesh.is_around_camera(ob.data)
    place, turn = (0.0, 0.0), (0.0, 0.0, 0.0)
    if settings.follow_world and not is_raised:
        place = tuple(seen.matrix_world.translation)[:2]
        turn = tuple(seen.matrix_world.to_euler("XYZ"))
    modifier_groups.assign(
        modifier,
        {
            **_map_inputs(terrain, shown, place),
            "Turn": turn,
            "On Samples": not shows_grid and _is_on_samples(ob, shown),
            node_group.DRAFT_CELLS: 0,
            "Mask": settings.mask,
            "Use Mask": bool(settings.mask),
            "Use Normal": settings.use_normal and not is_raised,
            "Use Slope": settings.use_slope or is_shaped(seen.libocean_terrain),
            "Is Raised": is_raised,
            **{node_group.use_of(group): group in terrain.groups for group in node_group.MASKS},
            **(_draft_inputs(ob, shown) if shows_grid else {}),
        },
    )


def _is_on_samples(ob, shown: Extent) -> bool:
    """Returns whether each vertex of an object's mesh lies on a sample of these maps."""
    if ob.libocean_terrain.shape != "TILE":
        return False
    if shown.wraps:
        side = meshes.samples_of(ob.data)
        return side is not None and meshes.is_on_samples(ob.data, shown.samples[0])
    return meshes.made_of(ob.data).startswith(_grid_words(shown))


def show_all(depsgraph=None, *, rendering: bool = False, passing: bool = False) -> None:
    """Shows all terrains. passing: Blender says that the frame has changed."""
    moving = drafts.allows_draft(rendering=rendering, passing=passing)
    is_redraw = drafts.is_redraw(rendering=rendering, passing=passing)
    for ob in terrain_objects():
        show(ob, depsgraph, moving=moving, is_redraw=is_redraw)


def parameters_changed(ob) -> None:
    """Shows an object after one of its properties was set in the user interface or by a script."""
    if not node_group.modifiers(ob):
        return
    ob.update_tag()  # without it the evaluated object keeps the old values
    show(ob, moving=drafts.allowed)
    if _keep_spectrum(ob):
        show(ob, moving=drafts.allowed)
    # While a draft is shown, the mesh is rebuilt only once values rest, except a new, empty mesh.
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
    return min(wanted, meshes.most_samples(settings.tiles))


def follows_camera(ob) -> bool:
    """Returns whether the add-on may change the mesh of an object: a linked one stays as its file
    has it."""
    return ob.library is None and ob.data.library is None and ob.mode == "OBJECT"


def _has_other_view(ob, terrain: OpenTerrain, view: CameraView | None) -> bool:
    """Returns whether an object's mesh is one around another camera, or none though it should."""
    if view is None:
        return camera_mesh.is_around_camera(ob.data)
    return meshes.made_of(ob.data) != camera_mesh.words_of(terrain.values.text(), view)


def _lacks_mesh(ob, terrain: OpenTerrain, view: CameraView) -> bool:
    """Returns whether the mesh around a camera has still to be made."""
    is_made = terrain.has_mesh_around(view) or not _has_other_view(ob, terrain, view)
    return follows_camera(ob) and not is_made


def follow_mesh(ob, *, draft: bool = False, view: CameraView | None = None) -> None:
    """Makes a mesh of the add-on fit the terrain, and labels a mesh of the user. A linked mesh
    stays as its file has it. draft: with few vertices; view: of the camera that the mesh follows,
    None: the view of the last show()."""
    terrain, settings = terrain_of(ob.name_full), ob.libocean_terrain
    if not follows_camera(ob) or terrain.terrain is None:
        return
    try:
        extent = terrain.extent
    except ExtentError:  # said by show(): the mesh stays
        return
    view = view or terrain.view
    with console.work(ob.name_full, "mesh"):
        if settings.shape == "MESH":
            if extent.wraps:
                meshes.label_users(ob.data, extent.size[0])
        elif view is not None:
            if draft and not terrain.has_mesh_around(view):
                return
            words = camera_mesh.words_of(terrain.values.text(), view)
            camera_mesh.follow(ob, words, lambda: terrain.mesh_around(view))
        elif extent.wraps:
            samples, tiles = samples_of(settings, terrain.size), settings.tiles
            meshes.follow_patch(
                ob, extent.size[0], samples, tiles=tiles, draft=draft, layers={meshes.UV_MAP}
            )
        else:
            _follow_grid(ob, extent, draft=draft)
    # The last show() set the extent of the maps: of a draft, or of the whole.
    for modifier in node_group.modifiers(ob):
        image = modifier_groups.value(modifier, node_group.GROUND)
        shown = None if image is None else terrain.extent_in(image)
        if shown is not None:
            is_raised = camera_mesh.is_around_camera(ob.data)
            modifier_groups.assign(
                modifier,
                {
                    "On Samples": _is_on_samples(ob, shown),
                    "Is Raised": is_raised,
                    "Use Normal": settings.use_normal and not is_raised,
                },
            )


def _grid_words(extent: Extent) -> str:
    (west, south), (columns, rows) = extent.origin, extent.samples
    return f"grid {west!r} {south!r} {extent.cell!r} {columns} {rows} "


def _follow_grid(ob, extent: Extent, *, draft: bool) -> None:
    """Makes the mesh of a rectangle: a region has a vertex on each sample, a placed land so many as
    the mesh resolution says."""
    settings = ob.libocean_terrain
    most = settings.mesh_resolution or meshes.AUTOMATIC
    step = extent.step_for(most) if extent.is_own else 1
    if draft and max(extent.samples) > step * meshes.DRAFT_SAMPLES:
        step = extent.step_for(meshes.DRAFT_SAMPLES)
        words = meshes.draft_of(f"{_grid_words(extent)}{step}")
    else:
        words = f"{_grid_words(extent)}{step}"
    meshes.follow_grid(ob, words, (extent.along(0, step), extent.along(1, step)))


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
    # Not evaluated anew: an update would request this job once more, before it runs.
    return terrain.job(terrain.view if follows_camera(ob) else None)


def finish_draft_job(name: str, job: TerrainJob) -> None:
    ob = _named(name)
    if ob is None or job.is_cancelled():
        job.close()
        return
    terrain = terrain_of(ob.name_full)
    if terrain.adopt(job):
        follow_mesh(ob, view=job.view)
        show(ob, bpy.context.evaluated_depsgraph_get())
    elif isinstance(job.failure, (libocean.Error, MemoryError)):
        ob.libocean_terrain.problem = WORDS.of_error(job.failure, len(terrain.values.layers))
