# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The node groups of a subject's modifiers, the objects that use them, and their inputs.

Blender's data is never held from call to call: objects are found again by the groups that they use.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import bpy

from . import compat, console, images, meshes

DISPLACED = {"MESH", "CURVE", "SURFACE", "FONT"}
"""Types of objects whose points such a modifier moves."""


BAKED = "libocean_baked"
"""The custom property of a group that plays a bake."""


def is_baked(group) -> bool:
    """Returns whether a node group of the add-on plays a bake."""
    return BAKED in group


class Family:
    """The node groups that the add-on builds for one subject, of all versions."""

    def __init__(self, mark: str, version: int) -> None:
        """mark: the custom property of such a group that holds the version that built it."""
        self.mark, self.version = mark, version

    def is_ours(self, group) -> bool:
        return group is not None and self.mark in group

    def is_old(self, group) -> bool:
        """Returns whether an earlier version of the add-on built a node group into this file."""
        return self.is_ours(group) and group[self.mark] != self.version and group.library is None

    def find(self, name: str):
        """Returns the group of that name in the open file; None without one."""
        for group in bpy.data.node_groups:
            if group.name == name and self.is_ours(group) and group.library is None:
                return group
        return None

    def new(self, name: str):
        """Returns a new, empty group."""
        group = bpy.data.node_groups.new(name, "GeometryNodeTree")
        group[self.mark] = self.version
        if hasattr(group, "is_modifier"):  # 4.0
            group.is_modifier = True
        return group

    def get(self, name: str, build: Callable[[Any], None], *, baked: bool = False):
        """Returns the group of that name in the open file, a new one that build(group) fills if it
        is missing. baked: it plays a bake."""
        group = self.find(name)
        if group is None:
            group = self.new(name)
            if baked:
                group[BAKED] = True
            build(group)
        return group

    def selected(self, context) -> list:
        """Returns the selected objects with such a modifier, and the active object if it has
        one."""
        chosen = dict.fromkeys([*context.selected_objects, context.object])
        return [ob for ob in chosen if ob is not None and self.modifiers(ob)]

    def all_modifiers(self, ob) -> list:
        """Returns all modifiers of an object with such a group, replaced ones of its library
        included."""
        return [m for m in ob.modifiers if m.type == "NODES" and self.is_ours(m.node_group)]

    def modifiers(self, ob) -> list:
        """Returns the modifiers of an object that count: modifiers that a shot added replace the
        library's."""
        found = [m for m in ob.modifiers if m.type == "NODES" and self.is_ours(m.node_group)]
        own = [m for m in found if ob.override_library is None or not m.is_override_data]
        return own or found

    def in_scene(self, scene) -> list[bpy.types.Object]:
        """Returns the objects of a scene with such a modifier."""
        return [ob for ob in scene.objects if self.modifiers(ob)]

    def objects(self) -> list[bpy.types.Object]:
        """Returns every object with such a modifier, linked ones first. Stand-ins in no scene, of
        an asset library that is open, are left out: they show nothing."""
        groups = [group for group in bpy.data.node_groups if self.is_ours(group)]
        if not groups:
            return []
        users = bpy.data.user_map(subset=groups, value_types={"OBJECT"})
        found = {}
        for ob in set().union(*users.values()):
            is_dormant = meshes.is_stand_in(ob.data) and not ob.users_scene
            if not is_dormant and self.modifiers(ob):
                found[ob.library is None, ob.name_full] = ob
        return [found[key] for key in sorted(found)]


def add(ob, name: str, make_group):
    """Returns a new modifier of an object, with the node group that make_group() returns."""
    modifier = ob.modifiers.new(name, "NODES")
    with console.work(ob.name_full, "nodes"):
        modifier.node_group = make_group()
    modifier.show_expanded = False  # its inputs are the add-on's business; the panel is below
    return modifier


def assign(modifier, values: dict) -> None:
    """Sets inputs of a modifier by their names."""
    identifiers = compat.input_identifiers(modifier.node_group)
    for name, value in values.items():
        if name in identifiers:  # a linked group may be of an earlier version
            compat.set_input(modifier, identifiers[name], value)


def names(modifier) -> list[str]:
    """Returns the names of the inputs of a modifier."""
    return list(compat.input_identifiers(modifier.node_group))


def value(modifier, name: str):
    """Returns an input of a modifier by its name."""
    return compat.get_input(modifier, compat.input_identifiers(modifier.node_group)[name])


def image(modifier, name: str, owner: str, blank: tuple[float, float, float, float]):
    """Returns the image in an input of a modifier, a new one if it is missing. owner: the name of
    the object; blank: the colour of an image that nothing fills."""
    found = value(modifier, name)
    if found is None:
        found = images.make(owner, name.lower(), (1, 1), blank)
        assign(modifier, {name: found})
    return found


def disown(ob, modifier, names: list[str], owners: dict[str, str]) -> None:
    """Takes the images of another object out of the inputs of these names. owners: the full names
    of objects by those of the images that they own, which are added here."""
    for name in names:
        found = value(modifier, name)
        if found is not None and owners.setdefault(found.name_full, ob.name_full) != ob.name_full:
            assign(modifier, {name: None})
