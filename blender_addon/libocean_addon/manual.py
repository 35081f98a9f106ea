# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""F1 on a button or a value of the add-on opens the section of its documentation."""

from __future__ import annotations

from pathlib import Path

import bpy

MANUAL = Path(__file__).with_name("README.md").as_uri()

# The first that fits; Blender asks in lower case.
_SECTIONS = (
    ("bpy.ops.libocean.*crest*", "#crests-on-cue"),
    ("bpy.types.oceancrest*", "#crests-on-cue"),
    ("bpy.ops.libocean.*terrain*", "#terrain"),
    ("bpy.ops.libocean.*_break*", "#terrain"),
    ("bpy.types.terrain*", "#terrain"),
    ("bpy.ops.libocean.*coast*", "#coast"),
    ("bpy.types.coastsettings*", "#coast"),
    ("bpy.ops.libocean.add_material*", "#material"),
    ("bpy.ops.libocean.make_asset_library*", "#asset-library"),
    ("bpy.ops.libocean.*bake*", "#bake"),
    ("bpy.ops.libocean.write_volumes*", "#volumes"),
    ("bpy.ops.libocean.*", "#from-scripts"),
    ("bpy.types.oceanpreferences.ocean_command*", "#volumes"),
    ("bpy.types.oceanpreferences*", "#asset-library"),
    ("bpy.types.oceanbake*", "#bake"),
    ("bpy.types.oceanvolumes*", "#volumes"),
    ("bpy.types.oceansettings.spray*", "#spray"),
    ("bpy.types.oceansettings.use_spray*", "#spray"),
    ("bpy.types.oceansettings.use_detail*", "#material"),
    ("bpy.types.oceansettings*", "#use"),
    ("bpy.types.oceanwaves*", "#use"),
    ("bpy.types.oceanhull*", "#use"),
    ("bpy.types.floatsettings*", "#use"),
)


def manual_map():
    return MANUAL, _SECTIONS


def register() -> None:
    bpy.utils.register_manual_map(manual_map)


def unregister() -> None:
    bpy.utils.unregister_manual_map(manual_map)
