# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How an object shows a terrain: images and inputs of its modifiers, and its mesh.

    parameters (evaluated: keyframes and drivers count) -> libocean -> float image -> nodes

shared/life.py calls it by the row in subject.py.
"""

from __future__ import annotations

import bpy

from ..sea import node_group as sea_group
from ..shared import changes, console, drafts, life, meshes, modifier_groups
from ..shared.subject import Picture, Shown
from . import camera_mesh, node_group
from .camera_mesh import CameraView
from .extent import Extent, ExtentError
from .open_terrain import OpenTerrain, TerrainJob, terrain_of
from .parameter_values import is_shaped
from .terrain_text import rings_in


def follow(shown: Shown, seen, depsgraph) -> None:
    """Gives the terrain of an object its region and camera. seen: the object, evaluated."""
    ob, terrain = shown.ob, shown.opened
    terrain.region = _region_of(seen.libocean_terrain)
    terrain.view = wanted_view(ob, depsgraph)
    if drafts.is_main_thread():
        drafts.keep_timer(ob.name_full, kept=terrain.view is not None)


def _region_of(settings) -> tuple | None:
    """Returns corners and cell of the region that the settings name, as shown in a panel."""
    if not settings.use_region or settings.use_lod or settings.shape != "TILE":
        return None
    return tuple(round(part, 4) for part in settings.region), round(settings.region_cell, 6)


def sees_camera(ob) -> bool:
    """Returns whether the mesh of an object follows the scene's camera."""
    return ob.libocean_terrain.use_lod and ob.libocean_terrain.shape == "TILE"


def wanted_view(ob, depsgraph=None) -> CameraView | None:
    """Returns the view of the scene's camera for the mesh of an object; None for other meshes."""
    if not sees_camera(ob):
        return None
    if life.is_rendering() and (depsgraph is None or depsgraph.mode != "RENDER"):
        return terrain_of(ob.name_full).view  # the view of the rendered frame
    settings = ob.libocean_terrain
    camera = bpy.context.scene.camera if depsgraph is None else depsgraph.scene.camera
    if depsgraph is None or camera is None:
        return camera_mesh.view_of(ob, camera, settings)
    seen = ob.evaluated_get(depsgraph)
    return camera_mesh.view_of(seen, camera.evaluated_get(depsgraph), settings)


def _images_of(ob, terrain: OpenTerrain, modifier) -> dict:
    """Returns the images of a modifier by their inputs, made where they are missing."""
    blanks = {node_group.GROUND: node_group.BLANK}
    blanks.update({node_group.image_of(group): (0.0,) * 4 for group in terrain.groups})
    return {
        name: modifier_groups.image(modifier, name, ob.name, blank)
        for name, blank in blanks.items()
    }


def _renew(ob, modifier) -> None:
    """Gives a modifier of an earlier version of the add-on today's node group."""
    if not node_group.FAMILY.is_old(modifier.node_group) or ob.library is not None:
        return
    image = modifier_groups.value(modifier, node_group.GROUND)
    modifier.node_group = node_group.get()
    modifier_groups.assign(modifier, {node_group.GROUND: image})


class TerrainPicture(Picture):
    """The maps of a land, and the camera around which its mesh lies."""

    work = "map"

    def prepare(self) -> None:
        ob, terrain = self.ob, self.opened
        _renew(ob, self.modifier)
        self.view = terrain.view
        self.key = (terrain.key, terrain.view)
        self.image_named = _images_of(ob, terrain, self.modifier)
        self.extent: Extent | None = None
        """The samples of the images."""
        # Drafts are kept by names of objects: a sea on the same object has this name already.
        self.may_wait = not sea_group.modifiers(ob)
        self.lacks_mesh = terrain.view is not None and _lacks_mesh(ob, terrain, terrain.view)

    def is_ready(self) -> bool:
        is_slow = _is_large(self.ob) or not self.opened.is_quick()
        return not self.lacks_mesh and (self.opened.is_whole() or not is_slow)

    def show_draft(self) -> None:
        self.extent = self.opened.show_draft(self.image_named)

    def show_whole(self) -> None:
        if self.lacks_mesh and not drafts.is_main_thread():
            # A render in a thread of its own, in which no mesh may be changed.
            drafts.ask(self.ob.name_full, self.key, rest=False)
            drafts.complete()
        self.extent = self.opened.show(self.image_named)

    def needs_mesh(self) -> bool:
        return super().needs_mesh() or _has_other_view(self.ob, self.opened, self.view)

    def set_inputs(self, *, draft: bool) -> None:
        _set_inputs(self.ob, self.seen, self.opened, self.modifier, self.extent, draft=draft)


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
            **shown.inputs(place),
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


def keep_spectrum(shown: Shown) -> bool:
    """Keeps the measured spectrum of a file in the settings, so that a blend file needs no other
    one. Returns whether there was one to keep."""
    settings = shown.ob.libocean_terrain
    if not settings.measured or settings.measured_rings or settings.problem:
        return False
    with changes.quiet():
        settings.measured_rings = rings_in(shown.opened.handle.text)
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


def follow_mesh(shown: Shown, *, draft: bool = False) -> None:
    """Makes a mesh of the add-on fit the terrain, and labels a mesh of the user. A linked mesh
    stays as its file has it. draft: with few vertices."""
    ob, terrain, settings = shown.ob, shown.opened, shown.ob.libocean_terrain
    if not follows_camera(ob) or terrain.handle is None:
        return
    try:
        extent = terrain.extent
    except ExtentError:  # said when it was shown: the mesh stays
        return
    view = terrain.view
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
    # The last picture set the extent of the maps: of a draft, or of the whole.
    for modifier in shown.modifiers:
        image = modifier_groups.value(modifier, node_group.GROUND)
        held = None if image is None else terrain.extent_in(image)
        if held is not None:
            is_raised = camera_mesh.is_around_camera(ob.data)
            modifier_groups.assign(
                modifier,
                {
                    "On Samples": _is_on_samples(ob, held),
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


def job(shown: Shown) -> TerrainJob | None:
    """Returns the job that makes the whole of an object; None without a terrain."""
    terrain = shown.opened
    if terrain.handle is None:
        return None
    # Not evaluated anew: an update would request this job once more, before it runs.
    return terrain.job(terrain.view if follows_camera(shown.ob) else None)
