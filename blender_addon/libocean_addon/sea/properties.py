# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.libocean: the parameters of the sea, how it is shown, its bake and its volumes.

Every parameter goes by the key it has in the sea file; those of a wave system are in `.waves`.
"""

from __future__ import annotations

import bpy

from ..shared import compat, meshes, registration
from ..shared.limits import Limited
from ..shared.overrides import overridable
from ..shared.table_properties import annotations, changed, settings_of
from . import facts, hull_properties, parameter_values
from .resolutions import OF_SEA

SETTINGS = settings_of("sea")


def _parameters(*, waves: bool) -> dict:
    return annotations(parameter_values.PARAMETERS, OF_SEA, items=waves)


_EXACT = bpy.props.StringProperty(options={"HIDDEN"})


@overridable
class OceanWaves(bpy.types.PropertyGroup):
    """One wave system of a sea: a wind sea, a swell, a measured spectrum"""

    subject = "sea"

    __annotations__ = {
        **_parameters(waves=True),
        **SETTINGS["OceanWaves"],
        "exact": _EXACT,
    }


@overridable
class OceanCrest(bpy.types.PropertyGroup):
    """One crest on cue, at the place of an empty"""

    subject = "sea"

    __annotations__ = {
        **SETTINGS["OceanCrest"],
        "empty": bpy.props.PointerProperty(
            type=bpy.types.Object, name="Empty", description="Its place", update=changed
        ),
        "exact": _EXACT,
    }


def _map_resolution(where: str) -> dict:
    return OF_SEA.properties(
        f"{where.lower()}_resolution",
        f"{where} resolution",
        f"Samples a side of the maps in the {where.lower()}; 0: the sea's own",
        0,
        none="Sea's own",
    )


def _directory(description: str):
    return bpy.props.StringProperty(
        name="Folder", description=description, subtype="DIR_PATH", options=compat.RELATIVE_PATH
    )


@overridable
class OceanBake(Limited, bpy.types.PropertyGroup):
    """The folder and the frames to bake, and the record of the present bake"""

    __annotations__ = {
        **SETTINGS["OceanBake"],
        "directory": _directory(
            "Where the next bake goes, in files that begin with the blend file's name; empty: "
            "ocean_bake and the object's name, beside the blend file"
        ),
    }


@overridable
class OceanVolumes(Limited, bpy.types.PropertyGroup):
    """The water to write as volumes"""

    __annotations__ = {
        **SETTINGS["OceanVolumes"],
        "directory": _directory(
            "Where the volumes go, in files that begin with the blend file's name; empty: "
            "ocean_volumes, beside the blend file"
        ),
        "box_object": bpy.props.PointerProperty(
            type=bpy.types.Object, name="Box object", description="Its bounds are the box"
        ),
    }


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
        **SETTINGS["OceanSettings"],
        "exact": _EXACT,
        "waves": bpy.props.CollectionProperty(type=OceanWaves),
        "crests": bpy.props.CollectionProperty(type=OceanCrest),
        "hulls": bpy.props.CollectionProperty(type=hull_properties.OceanHull),
        "use_cascade_divisors": bpy.props.BoolProperty(
            name="Own divisors",
            description="Set the divisor of the patch's period for each cascade, instead of having "
            "it chosen",
            get=_has_divisors,
            set=_set_divisors,
            options=set(),
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
        "spray_material": bpy.props.PointerProperty(
            name="Material",
            description="Material of the points of spray",
            type=bpy.types.Material,
            update=changed,
        ),
        "bake": bpy.props.PointerProperty(
            type=OceanBake, name="Bake", description="The next bake and the present one"
        ),
        "volumes": bpy.props.PointerProperty(
            type=OceanVolumes, name="Volumes", description="The water to write as volumes"
        ),
    }


CLASSES = (OceanWaves, OceanCrest, OceanBake, OceanVolumes, OceanSettings)


register, unregister = registration.functions(CLASSES, settings={"libocean": OceanSettings})
