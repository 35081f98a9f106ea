# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Library overrides: a shot that links an ocean and changes what it needs.

Blender stores of an override the properties that say so, and the modifiers that the shot added. It
drops the inputs of a library's modifier whose node group is exchanged, so an override that changes
between live and baked gets a modifier of its own, and its library's one is switched off.
"""

from __future__ import annotations

import inspect

import bpy


def overridable(cls):
    """Class decorator for a PropertyGroup: a library override may change all its properties, and
    add to its collections."""
    for name, deferred in inspect.get_annotations(cls, eval_str=True).items():
        options = {"LIBRARY_OVERRIDABLE"}
        if deferred.function is bpy.props.CollectionProperty:
            options.add("USE_INSERTION")
        deferred.keywords["override"] = options
        cls.__annotations__[name] = deferred
    return cls


def make_editable(ob) -> None:
    """Has Blender keep the changes of an override. If Blender made the override itself, because
    another object needed it, Blender would drop the changes when the file is opened again."""
    if ob.override_library is not None:
        ob.override_library.is_system_override = False


def is_librarys(ob, modifier) -> bool:
    """Returns whether an override has a modifier from its library."""
    return ob.override_library is not None and modifier.is_override_data


def has_librarys_bake(ob) -> bool:
    """Returns whether an override still has the library's record of the bake."""
    ours, theirs = ob.libocean.bake, ob.override_library.reference.libocean.bake
    names = ("fields", "folder", "stem", "first", "last", "marks", "sea")
    return all(getattr(ours, name) == getattr(theirs, name) for name in names)


def library_of_bake(ob):
    """Returns the library whose file the paths of the record are relative to; None: the open
    file."""
    if ob.library is not None or ob.override_library is None or not has_librarys_bake(ob):
        return ob.library
    return ob.override_library.reference.library


def add_own(ob, modifier, group):
    """Adds a modifier with this node group behind the library's, which is switched off."""
    own = ob.modifiers.new(modifier.name, "NODES")
    own.node_group = group
    own.show_expanded = False
    place = ob.modifiers.find(modifier.name) + 1
    if place < len(ob.modifiers) - 1:
        with bpy.context.temp_override(object=ob):
            bpy.ops.object.modifier_move_to_index(modifier=own.name, index=place)
        own = ob.modifiers[place]
    modifier.show_viewport = modifier.show_render = False
    return own


def restore(ob, modifier) -> None:
    """Switches a modifier of the library on again, as its file has it."""
    theirs = ob.override_library.reference.modifiers[modifier.name]
    modifier.show_viewport = theirs.show_viewport
    modifier.show_render = theirs.show_render
