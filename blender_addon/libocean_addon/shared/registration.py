# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Registering a part of the add-on with Blender: classes, entries of menus, settings."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import bpy


def functions(
    classes: Sequence[type],
    *,
    menus: Mapping[str, Callable] | None = None,
    settings: Mapping[str, type] | None = None,
) -> tuple[Callable[[], None], Callable[[], None]]:
    """Returns the functions register() and unregister() of a part. menus: functions that draw, by
    the name of Blender's menu; settings: groups of properties, by the attribute of an object."""
    menus, settings = menus or {}, settings or {}

    def register() -> None:
        for cls in classes:
            bpy.utils.register_class(cls)
        for name, group in settings.items():
            pointer = bpy.props.PointerProperty(type=group, override={"LIBRARY_OVERRIDABLE"})
            setattr(bpy.types.Object, name, pointer)
        for name, draw in menus.items():
            getattr(bpy.types, name).append(draw)

    def unregister() -> None:
        for name, draw in menus.items():
            getattr(bpy.types, name).remove(draw)
        for name in settings:
            delattr(bpy.types.Object, name)
        for cls in reversed(classes):
            bpy.utils.unregister_class(cls)

    return register, unregister
