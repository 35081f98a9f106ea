# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.libocean_terrain: the parameters of the terrain and how it is shown.

Every parameter goes by the key it has in the terrain file; those of a layer are in `.layers`.
"""

from __future__ import annotations

import bpy

from .. import translations
from ..shared import compat, meshes
from ..shared.limits import Limited
from ..shared.overrides import overridable
from ..shared.table_properties import annotations, changed
from .extent import MAX_VERTICES
from .parameters import PARAMETERS, RESOLUTIONS, SWITCHES, TYPICAL, switch_of

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
        "exact": _HIDDEN_TEXT,
        "measured_rings": bpy.props.StringProperty(
            name="Measured rings",
            description="The measured spectrum, as a terrain file holds it",
            options={"HIDDEN"},
        ),
        **{f"use_{group}": _section_switch(group) for group in SWITCHES},
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
        "use_region": bpy.props.BoolProperty(
            name="Region",
            description="Show a rectangle of the land, at a distance of samples of its own",
            default=False,
            update=changed,
        ),
        "region": bpy.props.FloatVectorProperty(
            name="Region",
            description="West, south, east and north side of the rectangle, in metres of the land. "
            "The mesh has a vertex on each sample from the south-west corner on",
            size=4,
            unit="LENGTH",
            precision=3,
            default=(0.0, 0.0, 500.0, 500.0),
            update=changed,
        ),
        "region_cell": bpy.props.FloatProperty(
            name="Cell",
            description="Distance of the region's samples and vertices, of which there are at most "
            f"{MAX_VERTICES:,}",
            unit="LENGTH",
            precision=3,
            min=0.001,
            max=1e5,
            soft_min=0.05,
            soft_max=100.0,
            default=1.0,
            update=changed,
        ),
        "use_lod": bpy.props.BoolProperty(
            name="Level of detail",
            description="Make the mesh finer near the scene's camera and coarser by a factor of 2 "
            "with each doubling of the distance",
            default=False,
            update=changed,
        ),
        "lod_spacing": bpy.props.FloatProperty(
            name="Spacing",
            description="Distance of the vertices at the camera",
            unit="LENGTH",
            precision=3,
            min=0.01,
            max=1e4,
            soft_min=0.1,
            soft_max=20.0,
            default=0.5,
            update=changed,
        ),
        "lod_farthest": bpy.props.FloatProperty(
            name="Distance",
            description="Distance from the camera up to which there is a mesh",
            unit="LENGTH",
            precision=1,
            min=10.0,
            max=1e6,
            soft_max=150000.0,
            default=20000.0,
            update=changed,
        ),
        "lod_snap": bpy.props.FloatProperty(
            name="Snap",
            description="The mesh is made for the camera's place in a grid of this distance, so "
            "that a small move makes no new one. On frames of an animated camera it is that of the "
            "frame",
            unit="LENGTH",
            precision=1,
            min=0.1,
            max=1e5,
            soft_min=1.0,
            soft_max=1000.0,
            default=64.0,
            update=changed,
        ),
        "use_normal": bpy.props.BoolProperty(
            name="Normal",
            description="Store the attribute terrain_normal, for shaders",
            default=True,
            update=changed,
        ),
        "use_slope": bpy.props.BoolProperty(
            name="Slope",
            description="Store the attribute slope, the tangent of the steepness, also on a tile "
            "without gullies",
            default=False,
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
