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


@overridable
class CoastSettings(Limited, bpy.types.PropertyGroup):
    """How the water of a coast is shown"""

    subject = "coast"

    __annotations__ = {
        **SETTINGS["CoastSettings"],
        "land": bpy.props.PointerProperty(
            name="Land",
            description="The object whose mesh is the bed",
            type=bpy.types.Object,
            poll=_is_mesh,
            update=changed,
        ),
        "far_water": bpy.props.PointerProperty(
            name="Far water",
            description="The object whose mesh is the still water around the map",
            type=bpy.types.Object,
            poll=_is_mesh,
            update=changed,
        ),
    }


CLASSES = (CoastSettings,)


register, unregister = registration.functions(CLASSES, settings={"libocean_coast": CoastSettings})
