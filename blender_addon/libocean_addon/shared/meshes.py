# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The meshes of Add > Mesh: squares of one or several periods, with a vertex on each sample."""

from __future__ import annotations

import bmesh
import bpy
import numpy as np

from . import compat
from .mesh_content import Content, mark_of, write_geometry


def fill(mesh, vertices: np.ndarray, *faces: np.ndarray) -> None:
    """Replaces all of a mesh by these vertices (n, 3) and smooth faces. faces: (m, k), one array
    for each number of corners k."""
    corners = np.concatenate([of_one_kind.ravel() for of_one_kind in faces]).astype(np.int32)
    counts = np.concatenate([np.full(len(f), f.shape[1], np.int32) for f in faces])
    write_geometry(mesh, vertices, corners, counts)


def is_there(ob) -> bool:
    """Returns whether an object is in use: a deleted one stays in the file as long as the settings
    of another name it."""
    return ob is not None and len(ob.users_collection) > 0


def is_mesh(ob) -> bool:
    """Returns whether an object is a mesh in use."""
    return is_there(ob) and ob.type == "MESH"


def is_ours(ob) -> bool:
    """Returns whether an object is a mesh in use that may be changed: a linked one stays as its
    file has it."""
    return is_mesh(ob) and ob.library is None and ob.data.library is None


LABEL = "label"
UV_MAP = "UVMap"


OF_SEA = {LABEL, UV_MAP} if compat.SHARES_LAYERS else {LABEL}
"""The layers of a sea's mesh. Without shared layers the UV map costs a seventh of each frame, 12
bytes a corner: older Blenders get the label alone."""


def _write_labels(
    mesh,
    period: float | tuple[float, float],
    layers: set[str] = OF_SEA,
    origin: tuple[float, float] = (0.0, 0.0),
) -> None:
    """Writes these layers: the undisplaced coordinate of each vertex [m] as the attribute `label`,
    z = 0, its share of the period, or of the sides from an origin on, as a UV map. A node group
    with foam stores a label of the world over it."""
    places = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", places)
    places = places.reshape(-1, 3)
    places[:, 2] = 0.0
    if LABEL in layers:
        # One after the other: adding a layer moves the memory of the earlier ones.
        label = mesh.attributes.get(LABEL) or mesh.attributes.new(LABEL, "FLOAT_VECTOR", "POINT")
        label.data.foreach_set("vector", places.ravel())
    if UV_MAP not in layers:
        return
    corners = np.empty(len(mesh.loops), np.int32)
    mesh.loops.foreach_get("vertex_index", corners)
    shares = (places[:, :2] - np.float32(origin)) / np.float32(period)
    uv = mesh.uv_layers.get(UV_MAP) or mesh.uv_layers.new(name=UV_MAP, do_init=False)
    uv.data.foreach_set("uv", shares[corners].ravel())


def _is_labelled(mesh, layers: set[str] = OF_SEA) -> bool:
    return all(name in mesh.attributes or name in mesh.uv_layers for name in layers)


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


def _patch_vertices(size: float, samples: int, tiles: int = 1) -> np.ndarray:
    """Returns tiles x tiles periods around the origin: a vertex on each of samples x samples of
    each, and the seam's."""
    cells = samples * tiles
    along = (np.arange(cells + 1) - cells // 2) * (size / samples)
    vertices = np.zeros((cells + 1, cells + 1, 3), np.float32)
    vertices[..., 0] = along[None, :]
    vertices[..., 1] = along[:, None]
    return vertices.reshape(-1, 3)


def grid_faces(cells: int, rows: int | None = None) -> np.ndarray:
    """Returns the quads of a rectangle of cells x rows, of a square by default."""
    side, rows = cells + 1, cells if rows is None else rows
    corner = (np.arange(rows)[:, None] * side + np.arange(cells)[None, :]).ravel()
    return np.stack([corner, corner + 1, corner + side + 1, corner + side], axis=1)


AUTOMATIC = 512
"""The max samples per side of a mesh that follows the maps by itself: a quarter of a million
vertices."""
MAX_SAMPLES = 4096
DRAFT_SAMPLES = 256
"""The max samples per side of a patch's mesh while its subject is a draft."""
_MADE_OF = "libocean_mesh"  # custom property of a mesh: the values it was made of
_MARK = "libocean_mark"  # and of what was made: its content


def automatic(own: int) -> int:
    """Returns the samples per side of a patch's mesh that follows a map of `own` samples per
    side."""
    return min(own, AUTOMATIC)


def fitting(most: int) -> int:
    """Returns the largest power of two up to `most`, min 1."""
    return 1 << max(0, most.bit_length() - 1)


def most_samples(tiles: int) -> int:
    """Returns the max samples per side of each of so many tiles along a side."""
    return fitting(MAX_SAMPLES // tiles)


_DRAFT = "draft "


def draft_of(made_of: str) -> str:
    """Returns the words for a draft of a mesh made of these settings."""
    return _DRAFT + made_of


def made_of(mesh) -> str:
    """Returns the words for the settings that a mesh was made of; "" for others."""
    return mesh.get(_MADE_OF, "") if isinstance(mesh, bpy.types.Mesh) else ""


def is_draft(mesh) -> bool:
    """Returns whether a mesh has the few vertices of a draft."""
    return isinstance(mesh, bpy.types.Mesh) and mesh.get(_MADE_OF, "").startswith(_DRAFT)


def samples_of(mesh) -> int | None:
    """Returns the samples per side that a patch's mesh was made for; None for other data."""
    words = mesh.get(_MADE_OF, "").removeprefix(_DRAFT).split()
    return int(words[2]) if words and words[0] == "patch" else None


def is_patch(mesh, size: float) -> bool:
    """Returns whether a mesh is a whole patch of a period [m], whose corners are as made."""
    samples = samples_of(mesh)
    if samples is None or made_of(mesh) != _patch_words(size, samples) or mesh.shape_keys:
        return False
    ends = ((0, -(samples // 2)), (-1, samples - samples // 2))
    return len(mesh.vertices) == (samples + 1) ** 2 and all(
        abs(place * samples / size - cells) < 1e-3
        for vertex, cells in ends
        for place in mesh.vertices[vertex].co[:2]
    )


def is_made(data) -> bool:
    """Returns whether the add-on made an object's data, a mesh, or may make it: it is empty yet.
    What a user made is never replaced."""
    return bool(made_of(data)) or is_empty(data)


def is_empty(mesh) -> bool:
    """Returns whether a mesh has not been made yet."""
    return isinstance(mesh, bpy.types.Mesh) and len(mesh.vertices) == 0


def is_on_samples(mesh, samples: int) -> bool:
    """Returns whether each vertex of a patch lies on a sample of a map of `samples` per side."""
    made_for = samples_of(mesh)
    return made_for is None or samples % made_for == 0


def follow(ob, made_of: str, make) -> None:
    """Has make(mesh) fill the mesh of an object, unless it was made of the same. Objects that share
    a mesh and then differ get one each. made_of: the settings, in words; draft_of() marks a
    draft."""
    if ob.data.get(_MADE_OF) == made_of:
        return
    if ob.data.library is None and ob.data.users > 1:
        ob.data = ob.data.copy()
    make_again(ob.data, made_of, make)


def make_again(mesh, made_of: str, make) -> None:
    """Has make(mesh) fill a mesh; a mesh of another file is filled in memory alone. made_of: as in
    follow()."""
    if mesh.library is not None:
        _fill_linked(mesh, make)
    else:
        make(mesh)
        mesh[_MARK] = mark_of(mesh)
    mesh[_MADE_OF] = made_of


def content_as_made(mesh) -> Content | None:
    """Returns the content of a mesh that nothing has changed since make_again(); None of others."""
    mark = mesh.get(_MARK)
    return Content.of(mesh) if mark and mark == mark_of(mesh) else None


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


def _patch_words(size: float, samples: int, tiles: int = 1) -> str:
    return f"patch {size!r} {samples}" + (f" {tiles}" if tiles > 1 else "")


def follow_patch(
    ob,
    size: float,
    samples: int,
    *,
    tiles: int = 1,
    draft: bool = False,
    layers: set[str] = OF_SEA,
) -> None:
    """Makes a patch's mesh again if its period [m], its samples or its tiles, per side, have
    changed. draft: with few vertices; layers: those of _write_labels."""
    draft = draft and samples * tiles > DRAFT_SAMPLES
    if draft:
        samples = max(2, fitting(DRAFT_SAMPLES // tiles))
    cells = samples * tiles

    def make(mesh) -> None:
        vertices = _patch_vertices(size, samples, tiles)
        if samples_of(mesh) == samples and len(mesh.vertices) == len(vertices):
            mesh.vertices.foreach_set("co", vertices.ravel())
            mesh.update()
        else:
            fill(mesh, vertices, grid_faces(cells))
        _write_labels(mesh, size, layers)

    made_of = _patch_words(size, samples, tiles)
    follow(ob, draft_of(made_of) if draft else made_of, make)
    is_of_earlier_version = not _is_labelled(ob.data, layers)
    if is_of_earlier_version and ob.data.library is None:
        _write_labels(ob.data, size, layers)


def write_numbers(mesh, name: str, values: np.ndarray) -> None:
    """Writes an attribute of numbers (n,) or vectors (n, 3) of the vertices."""
    is_vector = values.ndim == 2
    kind, key = ("FLOAT_VECTOR", "vector") if is_vector else ("FLOAT", "value")
    layer = mesh.attributes.get(name) or mesh.attributes.new(name, kind, "POINT")
    layer.data.foreach_set(key, np.ascontiguousarray(values, np.float32).ravel())


def follow_plane(ob, words: str, make_plane, make_numbers=dict) -> None:
    """Makes a level mesh of make_plane(), vertices (n, 3) [m] and faces as fill() has them, with a
    UV map over its sides and the attributes of make_numbers() by their names, unless it was made of
    the same. words: as made_of of follow()."""

    def make(mesh) -> None:
        vertices, *faces = make_plane()
        fill(mesh, vertices, *faces)
        low, high = vertices[:, :2].min(axis=0), vertices[:, :2].max(axis=0)
        _write_labels(mesh, high - low, {UV_MAP}, low)
        for name, values in make_numbers().items():
            write_numbers(mesh, name, values)

    follow(ob, words, make)


def follow_grid(ob, words: str, along: tuple[np.ndarray, np.ndarray]) -> None:
    """Makes a rectangle as follow_plane() does, with a vertex at each pair of these coordinates
    [m], east and north."""

    def make_plane() -> tuple[np.ndarray, np.ndarray]:
        east, north = along
        vertices = np.zeros((len(north), len(east), 3))
        vertices[..., 0] = east[None, :]
        vertices[..., 1] = north[:, None]
        return vertices.reshape(-1, 3), grid_faces(len(east) - 1, len(north) - 1)

    follow_plane(ob, words, make_plane)


STAND_IN = "stand-in"


def fill_stand_in(mesh, size: float) -> None:
    """Fills a mesh with one face, in place of the mesh that will be made when the object is
    shown."""
    fill(mesh, _patch_vertices(size, 1), grid_faces(1))
    mesh[_MADE_OF] = STAND_IN


def is_stand_in(mesh) -> bool:
    return isinstance(mesh, bpy.types.Mesh) and mesh.get(_MADE_OF) == STAND_IN
