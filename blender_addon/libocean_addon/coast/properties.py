# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.libocean_coast: how the water of a coast is shown. Its sea is in Object.libocean."""

from __future__ import annotations

import bpy

from ..shared import registration
from ..shared.limits import Limited
from ..shared.overrides import overridable
from ..shared.table_properties import changed, settings_of
from ..terrain.extent import MAX_VERTICES

SETTINGS = settings_of("coast", vertices=MAX_VERTICES)


def _is_mesh(_settings, ob) -> bool:
    return ob.type == "MESH"


def _part(name: str, description: str):
    """Returns the property of an object that belongs to a coast."""
    return bpy.props.PointerProperty(
        name=name, description=description, type=bpy.types.Object, poll=_is_mesh, update=changed
    )


@overridable
class CoastSettings(Limited, bpy.types.PropertyGroup):
    """How the water of a coast is shown"""

    subject = "coast"

    __annotations__ = {
        **SETTINGS["CoastSettings"],
        "land": _part("Land", "The object whose mesh is the bed"),
        "far_water": _part("Far water", "The object whose mesh is the still water around the map"),
    }


CLASSES = (CoastSettings,)


register, unregister = registration.functions(CLASSES, settings={"libocean_coast": CoastSettings})
