# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.libocean: the parameters of the sea, how it is shown, its bake and its volumes.

Every parameter goes by the key it has in the sea file; those of a wave system are in `.waves`.
"""

from __future__ import annotations

import bpy

from .sea import facts, parameter_values
from .sea.resolutions import OF_SEA
from .shared import compat, meshes
from .shared.limits import Limited
from .shared.overrides import overridable
from .shared.table_properties import annotations, changed


def _parameters(*, waves: bool) -> dict:
    return annotations(parameter_values.PARAMETERS, OF_SEA, items=waves)


_EXACT = bpy.props.StringProperty(options={"HIDDEN"})


@overridable
class OceanWaves(bpy.types.PropertyGroup):
    """One wave system of a sea: a wind sea, a swell, a measured spectrum"""

    subject = "sea"

    __annotations__ = {
        **_parameters(waves=True),
        "exact": _EXACT,
        "measured_record": bpy.props.StringProperty(
            name="Measured record",
            description="The record of a measured spectrum, as a sea file holds it",
            options={"HIDDEN"},
        ),
    }


def _map_resolution(where: str) -> dict:
    return OF_SEA.properties(
        f"{where.lower()}_resolution",
        f"{where} resolution",
        f"Samples a side of the maps in the {where.lower()}; 0: the sea's own",
        0,
        none="Sea's own",
    )


@overridable
class OceanBake(Limited, bpy.types.PropertyGroup):
    """The folder and the frames to bake, and the record of the present bake"""

    directory: bpy.props.StringProperty(
        name="Folder",
        description="Where the next bake goes, in files that begin with the blend file's name; "
        "empty: ocean_bake and the object's name, beside the blend file",
        subtype="DIR_PATH",
        options=compat.RELATIVE_PATH,
    )
    use_custom_range: bpy.props.BoolProperty(
        name="Own range",
        description="Bake the frames below instead of the scene's",
        options=set(),
    )
    frame_start: bpy.props.IntProperty(
        name="Frames from", description="First frame of the shot", min=0, default=1, options=set()
    )
    frame_end: bpy.props.IntProperty(
        name="To", description="Last frame of the shot", min=0, default=250, options=set()
    )

    # The record. fields: "displacement,cover"; empty: there is no bake.
    fields: bpy.props.StringProperty(options={"HIDDEN"})
    folder: bpy.props.StringProperty(options={"HIDDEN"})
    stem: bpy.props.StringProperty(options={"HIDDEN"})  # empty: of an earlier version
    first: bpy.props.IntProperty(options={"HIDDEN"})
    last: bpy.props.IntProperty(options={"HIDDEN"})
    resolution: bpy.props.IntProperty(options={"HIDDEN"})
    period: bpy.props.FloatProperty(options={"HIDDEN"})
    samples: bpy.props.IntProperty(options={"HIDDEN"})
    slope_variance: bpy.props.FloatProperty(options={"HIDDEN"})
    cover_power: bpy.props.FloatProperty(options={"HIDDEN"}, default=1.0)
    frame_length: bpy.props.FloatProperty(options={"HIDDEN"}, default=1.0)
    sea: bpy.props.StringProperty(options={"HIDDEN"})
    recipes: bpy.props.StringProperty(options={"HIDDEN"})
    # A coast's bake has origin, cell and samples of its region here, as JSON; an ocean's has none.
    extent: bpy.props.StringProperty(options={"HIDDEN"})
    # JSON of detail_tiles.Band; empty: baked without detail.
    bands: bpy.props.StringProperty(options={"HIDDEN"})
    # By which the files of each frame are known, from the first on; empty: of an earlier version.
    marks: bpy.props.StringProperty(options={"HIDDEN"})
    token: bpy.props.StringProperty(options={"HIDDEN"})  # of the last bake that was begun
    begun: bpy.props.StringProperty(options={"HIDDEN"})  # the folder of the last one


@overridable
class OceanVolumes(Limited, bpy.types.PropertyGroup):
    """The water to write as volumes"""

    directory: bpy.props.StringProperty(
        name="Folder",
        description="Where the volumes go, in files that begin with the blend file's name; empty: "
        "ocean_volumes, beside the blend file",
        subtype="DIR_PATH",
        options=compat.RELATIVE_PATH,
    )
    box: bpy.props.EnumProperty(
        name="Box",
        description="The water to write",
        items=[
            (
                "PERIOD",
                "One period",
                "From twice the wave height of the first frame, and at least 4 m, below still "
                "water, or the bottom, to the highest crest",
            ),
            ("OBJECT", "Object", "The bounds of an object at the frame that is shown"),
            ("CORNERS", "Corners", "From one corner to another"),
        ],
        options=set(),
    )
    box_object: bpy.props.PointerProperty(
        type=bpy.types.Object, name="Box object", description="Its bounds are the box"
    )
    box_low: bpy.props.FloatVectorProperty(
        name="Lower corner",
        description="In the sea's world, heights from still water",
        subtype="XYZ",
        unit="LENGTH",
        default=(0.0, 0.0, -10.0),
        options=set(),
    )
    box_high: bpy.props.FloatVectorProperty(
        name="Upper corner",
        description="In the sea's world, heights from still water",
        subtype="XYZ",
        unit="LENGTH",
        default=(100.0, 100.0, 10.0),
        options=set(),
    )
    voxel: bpy.props.FloatProperty(
        name="Voxel",
        description="Voxel size of the surface; 0: the distance between samples of the map",
        min=0.0,
        unit="LENGTH",
        options=set(),
    )
    velocity_voxel: bpy.props.FloatProperty(
        name="Velocity voxel",
        description="Voxel size of the velocity; 0: twice that of the surface",
        min=0.0,
        unit="LENGTH",
        options=set(),
    )
    use_half: bpy.props.BoolProperty(
        name="Half precision",
        description="Write numbers of 16 bits, for smaller files",
        options=set(),
    )

    # Folder and beginning of the names of what was begun last, and of what is shown.
    begun: bpy.props.StringProperty(options={"HIDDEN"})
    written: bpy.props.StringProperty(options={"HIDDEN"})


def _has_divisors(settings) -> bool:
    return any(settings.cascade_divisors)


def _set_divisors(settings, wanted: bool) -> None:
    """Begins with those that were chosen."""
    if wanted == _has_divisors(settings):
        return
    chosen = facts.cascade_divisors(settings.id_data) if wanted else []
    free = parameter_values.DIVISORS - len(chosen)
    settings.cascade_divisors = [*chosen, *[0] * free]


@overridable
class OceanSettings(Limited, bpy.types.PropertyGroup):
    """The sea of an object and how it is shown"""

    subject = "sea"

    def __setattr__(self, name: str, value) -> None:
        """Raises ValueError where a script sets a resolution that a sea file would refuse: Blender
        only prints exceptions of a property's own functions. Panels, keyframes and files do not
        come here."""
        OF_SEA.require_allowed(name, value)
        super().__setattr__(name, value)

    __annotations__ = {
        **_parameters(waves=False),
        "exact": _EXACT,
        "take_lines": bpy.props.StringProperty(options={"HIDDEN"}),
        "bed_lines": bpy.props.StringProperty(options={"HIDDEN"}),
        "waves": bpy.props.CollectionProperty(type=OceanWaves),
        "active_wave": bpy.props.IntProperty(
            name="Active wave system",
            description="The wave system whose values the panel shows",
            min=0,
        ),
        "kind": bpy.props.EnumProperty(
            name="Kind",
            description="The kind of the object's mesh",
            items=[
                ("MESH", "Mesh", "A mesh of its own, displaced as it is"),
                ("PATCH", "Patch", "One period, a vertex on each sample"),
                ("HORIZON", "Horizon", "Rings around the scene's camera"),
            ],
            default="MESH",
            options=set(),
            update=changed,
        ),
        "use_cascade_divisors": bpy.props.BoolProperty(
            name="Own divisors",
            description="Set the divisor of the patch's period for each cascade, instead of having "
            "it chosen",
            get=_has_divisors,
            set=_set_divisors,
            options=set(),
        ),
        "horizon_distance": bpy.props.FloatProperty(
            name="Distance",
            description="How far a horizon reaches from the scene's camera",
            min=100.0,
            max=100000.0,
            default=30000.0,
            unit="LENGTH",
            update=changed,
        ),
        "horizon_vertices": bpy.props.IntProperty(
            name="Vertices",
            description="Max number of vertices; with more of them the finest ring reaches farther",
            min=5000,
            max=1500000,
            soft_min=50000,
            default=600000,
            update=changed,
        ),
        **_map_resolution("Viewport"),
        **_map_resolution("Render"),
        **OF_SEA.properties(
            "mesh_resolution",
            "Mesh resolution",
            "Vertices along a side of a patch; 0: as the maps, at most "
            f"{meshes.AUTOMATIC}. More is only made when it is asked for here",
            0,
            none="Automatic",
            most=meshes.MAX_SAMPLES,
        ),
        "use_scene_frame_rate": bpy.props.BoolProperty(
            name="Scene's frame rate",
            description="Frames last as long as the scene says, else as the sea file does",
            default=True,
            update=changed,
        ),
        "use_custom_time": bpy.props.BoolProperty(
            name="Own time",
            description="Show the time below, which may be animated, instead of the frame's",
            update=changed,
        ),
        "custom_time": bpy.props.FloatProperty(
            name="Time",
            description="The sea's time that is shown, in seconds",
            unit="TIME_ABSOLUTE",
            update=changed,
        ),
        "use_foam": bpy.props.BoolProperty(
            name="Foam",
            description="Store the attributes foam and cover, 0 .. 1, on the points",
            default=True,
            update=changed,
        ),
        "use_velocity": bpy.props.BoolProperty(
            name="Velocity",
            description="Store the attributes velocity, for motion blur, and ocean_velocity, for "
            "shaders, in m/s",
            default=True,
            update=changed,
        ),
        "use_normal": bpy.props.BoolProperty(
            name="Normal",
            description="Store the attribute ocean_normal, for shaders",
            default=True,
            update=changed,
        ),
        "use_detail": bpy.props.BoolProperty(
            name="Near detail",
            description="The ocean material shows the waves too short for the maps, down to "
            "12 mm, near the camera, for a view from a boat say. Needs foam and normal",
            update=changed,
        ),
        "mask": bpy.props.StringProperty(
            name="Mask",
            description="A vertex group or attribute: where it is 0 the mesh stays as it is",
            update=changed,
        ),
        "follow_world": bpy.props.BoolProperty(
            name="Anchor to the world",
            description="The sea stays where it is while the object moves, and objects side by "
            "side show one sea",
            default=True,
            update=changed,
        ),
        "use_spray": bpy.props.BoolProperty(
            name="Spray",
            description="Show the drops that the wind tears off where the sea turns white, as "
            "points with the attributes velocity, age, life, radius and id. Winds of 7 m/s and "
            "less tear off none",
            update=changed,
        ),
        "spray_lifetime": bpy.props.FloatProperty(
            name="Lifetime",
            description="Max age of a point of spray; in a loop max half of the loop",
            min=0.05,
            max=10.0,
            default=2.0,
            unit="TIME_ABSOLUTE",
            update=changed,
        ),
        "spray_density": bpy.props.FloatProperty(
            name="Density",
            description="Points for each square metre that turns white [1/m^2], in winds below "
            "11 m/s fewer",
            min=0.0,
            max=1000.0,
            soft_max=10.0,
            default=0.25,
            update=changed,
        ),
        "spray_most": bpy.props.IntProperty(
            name="At most",
            description="About the max number of points alive at once in one period of the sea; a "
            "larger number is thinned evenly all over the sea",
            min=1,
            max=100000000,
            soft_min=1000,
            soft_max=10000000,
            default=1000000,
            update=changed,
        ),
        "spray_size": bpy.props.FloatProperty(
            name="Size",
            description="Factor by which a point is drawn larger than the drops that it stands "
            "for, whose radii are 0.02 to 0.6 mm",
            min=0.0,
            soft_min=1.0,
            soft_max=1000.0,
            default=100.0,
            update=changed,
        ),
        "spray_material": bpy.props.PointerProperty(
            name="Material",
            description="Material of the points of spray",
            type=bpy.types.Material,
            update=changed,
        ),
        "spray_problem": bpy.props.StringProperty(
            name="Problem of the spray",
            description="Why spray is not shown as requested",
            options={"HIDDEN"},
        ),
        "use_bake": bpy.props.BoolProperty(
            name="Play the bake",
            description="Show the files of the bake instead of the live sea",
            options=set(),
            update=changed,
        ),
        "bake": bpy.props.PointerProperty(
            type=OceanBake, name="Bake", description="The next bake and the present one"
        ),
        "volumes": bpy.props.PointerProperty(
            type=OceanVolumes, name="Volumes", description="The water to write as volumes"
        ),
        "problem": bpy.props.StringProperty(
            name="Problem", description="Why the sea is not shown as requested", options={"HIDDEN"}
        ),
    }


CLASSES = (OceanWaves, OceanBake, OceanVolumes, OceanSettings)


def register() -> None:
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Object.libocean = bpy.props.PointerProperty(
        type=OceanSettings, override={"LIBRARY_OVERRIDABLE"}
    )


def unregister() -> None:
    del bpy.types.Object.libocean
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
