# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.libocean_terrain: the parameters of the terrain and how it is shown.

Every parameter goes by the key it has in the terrain file; those of a layer are in `.layers`.
"""

from __future__ import annotations

import bpy

from ..shared import meshes
from ..shared.overrides import overridable
from ..shared.table_properties import annotations, changed
from .parameters import PARAMETERS, RESOLUTIONS

_HIDDEN_TEXT = bpy.props.StringProperty(options={"HIDDEN"})


@overridable
class TerrainLayer(bpy.types.PropertyGroup):
    """A further tile over the first one, with a period and a noise of its own"""

    subject = "terrain"

    __annotations__ = {
        **annotations(PARAMETERS, RESOLUTIONS, items=True),
        "exact": _HIDDEN_TEXT,
    }


@overridable
class TerrainSettings(bpy.types.PropertyGroup):
    """The terrain of an object and how it is shown"""

    subject = "terrain"

    def __setattr__(self, name: str, value) -> None:
        """Raises ValueError where a script sets a resolution that a terrain file would refuse:
        Blender only prints exceptions of a property's own functions."""
        RESOLUTIONS.require_allowed(name, value)
        super().__setattr__(name, value)

    __annotations__ = {
        **annotations(PARAMETERS, RESOLUTIONS, items=False),
        "exact": _HIDDEN_TEXT,
        "measured_rings": bpy.props.StringProperty(
            name="Measured rings",
            description="The measured spectrum, as a terrain file holds it",
            options={"HIDDEN"},
        ),
        "layers": bpy.props.CollectionProperty(type=TerrainLayer),
        "shape": bpy.props.EnumProperty(
            name="Shape",
            description="The kind of the object's mesh",
            items=[
                ("MESH", "Mesh", "A mesh of its own, raised as it is"),
                ("TILE", "Tile", "One tile or several, a vertex on each sample"),
            ],
            default="MESH",
        ),
        **RESOLUTIONS.properties(
            "mesh_resolution",
            "Mesh resolution",
            "Vertices along a side of a tile; 0: as the terrain, at most "
            f"{meshes.AUTOMATIC}. More is only made when it is asked for here",
            0,
            none="Automatic",
            most=meshes.MAX_SAMPLES,
        ),
        "tiles": bpy.props.IntProperty(
            name="Tiles",
            description="How often the land is repeated along each side. All tiles together have "
            f"at most {meshes.MAX_SAMPLES} vertices along a side",
            min=1,
            max=32,
            soft_max=8,
            default=1,
            update=changed,
        ),
        "use_normal": bpy.props.BoolProperty(
            name="Normal",
            description="Store the attribute terrain_normal, for shaders",
            default=True,
            update=changed,
        ),
        "mask": bpy.props.StringProperty(
            name="Mask",
            description="A vertex group or attribute: where it is 0 the mesh stays as it is",
            update=changed,
        ),
        "follow_world": bpy.props.BoolProperty(
            name="Anchor to the world",
            description="The land stays where it is while the object moves, and objects side by "
            "side show one land",
            default=False,
            update=changed,
        ),
        "problem": bpy.props.StringProperty(
            name="Problem",
            description="Why the terrain is not shown as requested",
            options={"HIDDEN"},
        ),
    }


CLASSES = (TerrainLayer, TerrainSettings)


def register() -> None:
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Object.libocean_terrain = bpy.props.PointerProperty(
        type=TerrainSettings, override={"LIBRARY_OVERRIDABLE"}
    )


def unregister() -> None:
    del bpy.types.Object.libocean_terrain
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
