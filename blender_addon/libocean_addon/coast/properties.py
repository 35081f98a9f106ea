# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.libocean_coast: how the water of a coast is shown. Its sea is in Object.libocean."""

from __future__ import annotations

import bpy

from ..shared.limits import Limited
from ..shared.overrides import overridable
from ..shared.table_properties import changed
from ..terrain.extent import MAX_VERTICES


def _is_mesh(_settings, ob) -> bool:
    return ob.type == "MESH"


@overridable
class CoastSettings(Limited, bpy.types.PropertyGroup):
    """How the water of a coast is shown"""

    subject = "coast"

    __annotations__ = {
        "cell": bpy.props.FloatProperty(
            name="Cell",
            description="Distance of the samples and vertices of water and land; 0: so that the "
            f"longer side has 512 of them. At most {MAX_VERTICES:,} together",
            unit="LENGTH",
            precision=3,
            min=0.0,
            max=1e5,
            soft_max=100.0,
            default=0.0,
            update=changed,
        ),
        "use_region": bpy.props.BoolProperty(
            name="Region",
            description="Show a rectangle instead of all that lies over the bed",
            default=False,
            update=changed,
        ),
        "region": bpy.props.FloatVectorProperty(
            name="Region",
            description="West, south, east and north side of the rectangle, in metres of the sea",
            size=4,
            unit="LENGTH",
            precision=3,
            default=(0.0, 0.0, 500.0, 500.0),
            update=changed,
        ),
        "use_clip": bpy.props.BoolProperty(
            name="End at the waterline",
            description="Leave out the faces of the water that lie dry",
            default=True,
            update=changed,
        ),
        "clip_depth": bpy.props.FloatProperty(
            name="Below land",
            description="How far the water goes on below the land: where the bed lies farther "
            "above the water, its faces are left out",
            unit="LENGTH",
            precision=2,
            min=0.0,
            max=100.0,
            default=0.3,
            update=changed,
        ),
        "land": bpy.props.PointerProperty(
            name="Land",
            description="The object whose mesh is the bed",
            type=bpy.types.Object,
            poll=_is_mesh,
            update=changed,
        ),
        "use_wetness": bpy.props.BoolProperty(
            name="Wet ground",
            description="Give the land the attribute shore_wetness: where waves have been it is "
            "dark, and dries within minutes. Its past takes as long to make as that of foam",
            default=False,
            update=changed,
        ),
        "problem": bpy.props.StringProperty(
            name="Problem",
            description="Why the coast is not shown as requested",
            options={"HIDDEN"},
        ),
    }


CLASSES = (CoastSettings,)


def register() -> None:
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Object.libocean_coast = bpy.props.PointerProperty(
        type=CoastSettings, override={"LIBRARY_OVERRIDABLE"}
    )


def unregister() -> None:
    del bpy.types.Object.libocean_coast
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
