# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.libocean_terrain: the parameters of the terrain and how it is shown.

Every parameter goes by the key it has in the terrain file; those of a layer are in `.layers`.
"""

from __future__ import annotations

import bpy

from .. import translations
from ..shared import compat, meshes, registration
from ..shared.limits import Limited
from ..shared.overrides import overridable
from ..shared.table_properties import annotations, settings_of
from .extent import MAX_VERTICES
from .parameters import PARAMETERS, RESOLUTIONS, SWITCHES, TYPICAL, switch_of

SETTINGS = settings_of("terrain", samples=meshes.MAX_SAMPLES, vertices=MAX_VERTICES)
_HIDDEN_TEXT = bpy.props.StringProperty(options={"HIDDEN"})


_SECTION_NAMES = {"gullies": "Gullies", "stream": "Streams", "coast": "Shore"}


def _section_switch(group: str):
    """Returns the property that switches a group of parameters on, with the value of a file that
    has its section alone, and off."""
    name = switch_of(group)

    def get(self) -> bool:
        return getattr(self, name) > 0.0

    def set_(self, value: bool) -> None:
        if value != get(self):
            setattr(self, name, TYPICAL[group] if value else 0.0)

    label = _SECTION_NAMES[group]
    return bpy.props.BoolProperty(
        name=label,
        description=f"Whether the land has the section terrain.{group}; on: as a file that has the "
        "section alone",
        get=get,
        set=set_,
        options=set(),
        **compat.in_context(translations.SEA),
    )


@overridable
class TerrainLayer(bpy.types.PropertyGroup):
    """A further tile over the first one, with a period and a noise of its own"""

    subject = "terrain"

    __annotations__ = {
        **annotations(PARAMETERS, RESOLUTIONS, items=True),
        "exact": _HIDDEN_TEXT,
    }


@overridable
class TerrainSettings(Limited, bpy.types.PropertyGroup):
    """The terrain of an object and how it is shown"""

    subject = "terrain"

    def __setattr__(self, name: str, value) -> None:
        """Raises ValueError where a script sets a resolution that a terrain file would refuse:
        Blender only prints exceptions of a property's own functions."""
        RESOLUTIONS.require_allowed(name, value)
        super().__setattr__(name, value)

    __annotations__ = {
        **annotations(PARAMETERS, RESOLUTIONS, items=False),
        **SETTINGS["TerrainSettings"],
        "exact": _HIDDEN_TEXT,
        **{f"use_{group}": _section_switch(group) for group in SWITCHES},
        "layers": bpy.props.CollectionProperty(type=TerrainLayer),
        **RESOLUTIONS.properties(
            "mesh_resolution",
            "Mesh resolution",
            "Vertices along a side of a tile; 0: as the terrain, at most "
            f"{meshes.AUTOMATIC}. More is only made when it is asked for here",
            0,
            none="Automatic",
            most=meshes.MAX_SAMPLES,
        ),
    }


CLASSES = (TerrainLayer, TerrainSettings)


register, unregister = registration.functions(
    CLASSES, settings={"libocean_terrain": TerrainSettings}
)
