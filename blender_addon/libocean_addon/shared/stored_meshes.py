# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The form in which a file holds the meshes of live objects: a small one of few vertices, with all
of the whole one packed into a custom property; a mesh in a file takes a hundred bytes a vertex.

    whole mesh -> put_aside(), before a file is saved -> small mesh in the file
    small mesh -> make_whole(), after that, and when one is opened, linked, appended -> whole mesh

Without the add-on the small mesh is what is seen. A bake plays without the add-on: its meshes are
stored whole, and so are those that a user edited.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable

import bpy

from . import meshes
from .mesh_content import Content

_PACKED = "packed "  # before the words of a small mesh
_CONTENT = "libocean_packed"
"""Custom property of a small mesh: the whole one. A linked mesh that is small in its file has it
while it is whole in memory too."""

_EARLIER = "stored "  # the same in files of earlier versions, which have no content
earlier: dict[str, Callable] = {}
"""Functions that return the fill function of a small mesh of a file of an earlier version, by the
first of these words, which are the argument."""

_aside: dict[str, str] = {}
"""The names of whole meshes while a file is saved, by the names of the small meshes in their
place."""


def _is_live(ob) -> bool:
    """Returns whether an object of the open file shows a mesh of the add-on, with nothing on the
    vertices."""
    is_own = ob.library is None and ob.override_library is None and ob.data.library is None
    return is_own and ob.mode == "OBJECT" and not ob.vertex_groups


def put_aside(live, baked) -> None:
    """Puts a small mesh in the place of each whole one as the add-on made it, until make_whole():
    Blender writes no mesh without users. live, baked: objects of the add-on with meshes. A bake
    that shows a mesh which is small in its own file gets a whole one in the open file."""
    for ob in baked:
        if ob.library is None and _CONTENT in ob.data:
            if ob.data.library is not None:
                ob.data = ob.data.copy()
            del ob.data[_CONTENT]
    users = defaultdict(list)
    for ob in live:
        if _is_live(ob) and meshes.made_of(ob.data):
            users[ob.data].append(ob)
    for mesh, objects in users.items():
        content = meshes.content_as_made(mesh) if mesh.users == len(objects) else None
        if content is not None and content.is_large:
            _put_aside(mesh, objects, content)


def _put_aside(mesh, objects, content: Content) -> None:
    small = mesh.copy()
    meshes.make_again(small, _PACKED + meshes.made_of(mesh), content.few().fill)
    small[_CONTENT] = content.packed()
    name = mesh.name
    mesh.name, small.name = f".{name}", name
    for ob in objects:
        ob.data = small
    _aside[small.name] = mesh.name


def make_whole(found: Iterable | None = None) -> None:
    """Makes small meshes whole again. found: where they are looked for; None: among all meshes.
    Meshes of other files change in memory alone."""
    for mesh in list(bpy.data.meshes if found is None else found):
        words = meshes.made_of(mesh)
        if words.startswith(_PACKED):
            _unpack(mesh, words.removeprefix(_PACKED))
        elif words.startswith(_EARLIER):
            words = words.removeprefix(_EARLIER)
            meshes.make_again(mesh, words, earlier[words.split()[0]](words))
            if mesh.library is not None:
                mesh[_CONTENT] = b""
    _aside.clear()


def _unpack(small, words: str) -> None:
    kept = bpy.data.meshes.get(_aside.get(small.name, "")) if small.library is None else None
    if kept is not None and meshes.made_of(kept) == words:
        name = small.name
        small.user_remap(kept)
        bpy.data.meshes.remove(small)
        kept.name = name
        return
    meshes.make_again(small, words, Content.unpacked(small[_CONTENT]).fill)
    if small.library is None:
        del small[_CONTENT]
