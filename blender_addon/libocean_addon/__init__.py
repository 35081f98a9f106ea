# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A sea as a modifier: libocean in Blender."""

from __future__ import annotations

import importlib
import sys

import bpy

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


_PARTS = (
    "translations",
    "sea.hull_properties",
    "sea.properties",
    "look.material",
    "sea.operators",
    "sea.crest_operators",
    "look.first_view",
    "sea.records",
    "bake.bake",
    "bake.farm",
    "volumes.volumes",
    "sea.hints",
    "whole_sea",
    "sea.panels",
    "sea.crest_panels",
    "sea.hulls",
    "terrain.properties",
    "terrain.operators",
    "terrain.material",
    "terrain.trees",
    "terrain.panels",
    "terrain.look_panels",
    "coast.properties",
    "coast.operators",
    "coast.panels",
    "assets.asset_library",
    "floating.floating",
    "subjects",
    "handlers",
    "manual",
)
"""The modules that have something to register, in that order. Without the library, which the others
need, it is the first one alone."""


def parts() -> list:
    """Returns the modules that have something to register, in that order."""
    names = _PARTS[:1] if native.libocean is None else _PARTS
    return [importlib.import_module(f".{name}", __package__) for name in names]


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
