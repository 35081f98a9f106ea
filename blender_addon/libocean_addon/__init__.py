# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A sea as a modifier: libocean in Blender."""

from __future__ import annotations

import sys

import bpy

from . import translations
from .shared import native
from .shared.compat import tr_label
from .shared.drawing import say

bl_info = {  # of Blender before 4.2; later ones read blender_manifest.toml
    "name": "Ocean (libocean)",
    "author": "The libocean authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "Add > Ocean, Coast or Terrain Scene, Add > Mesh, Modifier properties",
    "description": "A sea as a modifier, the same as in every other libocean tool",
    "category": "Mesh",
}


def _problem() -> str:
    """Returns a sentence on the reason why the add-on does nothing."""
    if native.lacks_numpy:
        return tr_label(
            "NumPy is missing in {}, the Python of this Blender: install the package "
            "python3-numpy (Debian, Ubuntu) and start Blender again",
            sys.prefix,
        )
    return tr_label("libocean is missing: {}", native.problem)


class MissingLibrary(bpy.types.AddonPreferences):
    """Says in the preferences why the rest of the add-on is absent"""

    bl_idname = __package__

    def draw(self, _context) -> None:
        say(self.layout, _problem(), "ERROR")


def parts() -> list:
    """The modules that have something to register, in that order."""
    if native.libocean is None:
        return [translations]
    from . import handlers, manual, subjects, whole_sea
    from .assets import asset_library
    from .bake import bake, farm
    from .coast import operators as coast_operators
    from .coast import panels as coast_panels
    from .coast import properties as coast_properties
    from .floating import floating
    from .look import first_view, material
    from .sea import (
        crest_operators,
        crest_panels,
        hints,
        hull_properties,
        hulls,
        operators,
        panels,
        properties,
        records,
    )
    from .terrain import look_panels as terrain_look_panels
    from .terrain import material as terrain_material
    from .terrain import operators as terrain_operators
    from .terrain import panels as terrain_panels
    from .terrain import properties as terrain_properties
    from .terrain import trees
    from .volumes import volumes

    return [
        translations,
        hull_properties,
        properties,
        material,
        operators,
        crest_operators,
        first_view,
        records,
        bake,
        farm,
        volumes,
        hints,
        whole_sea,
        panels,
        crest_panels,
        hulls,
        terrain_properties,
        terrain_operators,
        terrain_material,
        trees,
        terrain_panels,
        terrain_look_panels,
        coast_properties,
        coast_operators,
        coast_panels,
        asset_library,
        floating,
        subjects,
        handlers,
        manual,
    ]


def register() -> None:
    if native.libocean is None:
        bpy.utils.register_class(MissingLibrary)
        print(f"Ocean (libocean): {_problem()}", file=sys.stderr, flush=True)
    for part in parts():
        part.register()


def unregister() -> None:
    for part in reversed(parts()):
        part.unregister()
    if native.libocean is None:
        bpy.utils.unregister_class(MissingLibrary)
