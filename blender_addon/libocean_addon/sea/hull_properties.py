# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The hulls of a sea: Object.libocean.hulls, each with the parameters of a sea file's [[hulls]] and
its track, and the object whose motion that is."""

from __future__ import annotations

import bpy

from ..shared import registration
from ..shared.overrides import overridable
from ..shared.table_properties import annotations, settings_of
from .hull_values import HULLS
from .resolutions import OF_SEA


@overridable
class OceanHull(bpy.types.PropertyGroup):
    """A hull that makes waves: its size, and the track of its object or of a file"""

    subject = "sea"

    __annotations__ = {
        **annotations(HULLS, OF_SEA, items=True),
        **settings_of("sea")["OceanHull"],
        "source": bpy.props.PointerProperty(
            name="Object",
            description="The object whose animation is the track; empty: the track of a sea file",
            type=bpy.types.Object,
        ),
        "exact": bpy.props.StringProperty(options={"HIDDEN"}),
    }


CLASSES = (OceanHull,)

register, unregister = registration.functions(CLASSES)
