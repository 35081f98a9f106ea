# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Playing a bake: the record of it that an object keeps, and the change between live and baked.

record (folder, frames, fields) -> image sequences -> inputs of the baked node group, and the
                                                      slope tiles in the material
"""

from __future__ import annotations

import functools
import hashlib
import json
import os
from pathlib import Path

import bpy

from . import (
    baked_nodes,
    changes,
    detail,
    exr_files,
    meshes,
    node_group,
    parameter_values,
    sea_text,
)
from .compat import tr
from .detail_tiles import Band

# Names of the fields in files, by those of the node group's inputs.
FILES = {name: name.lower() for name in baked_nodes.FIELDS}
FILES |= {node_group.far_image(name): exr_files.far(file) for name, file in FILES.items()}


def exists(ob) -> bool:
    """Whether there is a record of a bake."""
    return bool(ob.libocean.bake.fields)


def wanted_fields(settings) -> list[str]:
    """The maps that a bake of these settings has; slope tiles come to them."""
    switches = {
        "cover": "use_foam",
        "velocity": "use_velocity",
        "normal": "use_normal",
        "jacobian": "use_velocity",
    }
    near = ["displacement", *(field for field, use in switches.items() if getattr(settings, use))]
    if settings.kind != "HORIZON":
        return near
    return [*near, *(exr_files.far(field) for field in near)]


def lacking(ob) -> list[str]:
    """What the bake that there is does not have of it."""
    settings, record = ob.libocean, ob.libocean.bake
    fields = record.fields.split(",")
    found = [field for field in wanted_fields(settings) if field not in fields]
    return [*found, "detail"] if detail.is_wanted(settings) and not record.bands else found


# Where ------------------------------------------------------------------------


_BAKES = "//ocean_bake/"


def default_folder(ob) -> str:
    return f"{_BAKES}{bpy.path.clean_name(ob.name)}/"


def asked_folder(ob) -> str:
    """Where the next bake goes: on, where the last one is, whatever the object is called by now."""
    asked = ob.libocean.bake.directory
    goes_on = not asked and exists(ob) and folder(ob).startswith(_BAKES)
    if goes_on and not others_in(ob, folder_path(ob)):
        return folder(ob)
    return asked or default_folder(ob)


def folder(ob) -> str:
    """Where the bake is, as Blender writes paths. Blender moves the paths of images when a file is
    saved elsewhere, not ours."""
    record = ob.libocean.bake
    for modifier in _playing(ob):
        image = node_group.value(modifier, "Displacement")
        if image is not None:
            return image.filepath[: -len(exr_files.path("", "displacement", record.first).name)]
    return record.folder


def absolute(path: str) -> Path:
    return Path(os.path.normpath(bpy.path.abspath(path)))


def folder_path(ob) -> Path:
    return absolute(folder(ob))


def others_in(ob, path: Path) -> list:
    """Other objects whose bakes lie in that folder."""
    return [
        other
        for other in bpy.data.objects
        if other != ob and exists(other) and folder_path(other) == path
    ]


# Of which sea -----------------------------------------------------------------


def recipe(settings, values: sea_text.SeaValues) -> str:
    """A short text that is another one where the sea shown at a frame is."""
    time = settings.custom_time if settings.use_custom_time else None
    text = sea_text.write(parameter_values.TABLE, values)
    whole = f"{time} {settings.render_resolution}\n{text}"
    return hashlib.sha256(whole.encode()).hexdigest()[:16]


@functools.lru_cache(maxsize=16)
def _recipes(text: str) -> dict[str, str]:
    return json.loads(text or "{}")


def is_other_sea(ob, scene, values: sea_text.SeaValues) -> bool:
    """Whether the parameters are not those of the bake at the scene's frame."""
    recipes = _recipes(ob.libocean.bake.recipes)
    baked = recipes.get("", recipes.get(str(scene.frame_current)))
    return baked is not None and baked != recipe(ob.libocean, values)


def frame_length(scene) -> float:
    """What a frame lasts where the scene's time is remapped."""
    return scene.render.frame_map_old / scene.render.frame_map_new


# Images -----------------------------------------------------------------------


def _sequence(ob, place: str, field: str):
    """The image of a field's files in a folder; None where the first of them is not there."""
    between = "" if place.endswith(("/", "\\")) else "/"
    path = place + between + exr_files.path("", field, ob.libocean.bake.first).name
    for image in bpy.data.images:
        if image.source == "SEQUENCE" and image.filepath == path and image.library is None:
            return image
    try:
        image = bpy.data.images.load(path)
    except RuntimeError:
        return None
    image.name = f".{ob.name} baked {field}"
    image.source = "SEQUENCE"
    image.colorspace_settings.name = "Non-Color"
    image.alpha_mode = "CHANNEL_PACKED"
    return image


def _playing(ob) -> list:
    return [m for m in node_group.modifiers(ob) if node_group.is_baked(m.node_group)]


# Live or baked ----------------------------------------------------------------


def _change_group(modifier, *, to_baked: bool) -> None:
    """Without the images of the other group: where nobody else shows them they go."""
    old = modifier.node_group
    names = node_group.image_inputs(old)
    images = {node_group.value(modifier, name) for name in names} - {None}
    # Nothing stays that the other group would take for something else.
    node_group.assign(modifier, dict.fromkeys(names))
    if node_group.kind_of(old) == "HORIZON":
        node_group.assign(modifier, {"Camera": None})
    modifier.node_group = node_group.get(node_group.kind_of(old), baked=to_baked)
    for image in images:
        if image.users == 0:
            bpy.data.images.remove(image)


def _set_inputs(ob, modifier) -> bool:
    """Whether the files are there."""
    settings, record = ob.libocean, ob.libocean.bake
    fields = record.fields.split(",")
    images = {
        name: _sequence(ob, record.folder, FILES[name]) if FILES[name] in fields else None
        for name in node_group.image_inputs(modifier.node_group)
    }
    node_group.assign(
        modifier,
        {
            **images,
            "Tile Size": record.period,
            "Half Texel": 0.5 / record.resolution,
            node_group.ON_SAMPLES: meshes.is_on_samples(ob, record.resolution),
            "Follow World": settings.follow_world,
            "First": float(record.first),
            "Last": float(record.last),
            "Frame Length": record.frame_length,
            "Slope Variance": record.slope_variance,
            "Mask": settings.mask,
            "Use Mask": bool(settings.mask),
            baked_nodes.COVER_POWER: record.cover_power,
            "Use Foam": settings.use_foam and "cover" in fields,
            "Use Velocity": settings.use_velocity and "velocity" in fields,
            "Use Normal": settings.use_normal and "normal" in fields,
            baked_nodes.USE_JACOBIAN: "jacobian" in fields,
        },
    )
    if node_group.kind_of(modifier.node_group) == "HORIZON":
        node_group.assign(modifier, {"Samples": float(record.samples)})
    there = [images[name] for name in images if FILES[name] in fields]
    return None not in there


def upgrade(ob) -> None:
    """Node groups that an earlier version of the add-on built become today's."""
    if ob.library is not None:
        return
    for modifier in node_group.modifiers(ob):
        if node_group.is_old(modifier.node_group):
            playing = node_group.is_baked(modifier.node_group)
            _change_group(modifier, to_baked=playing)
            if playing:
                _set_inputs(ob, modifier)


def follow(ob) -> bool:
    """Brings the modifiers in line with `use_bake` and the settings. Whether one was changed from
    live to baked or back."""
    settings = ob.libocean
    if settings.use_bake and not exists(ob):
        with changes.quiet():
            settings.use_bake = False
    modifiers = node_group.modifiers(ob)
    changed = [m for m in modifiers if node_group.is_baked(m.node_group) != settings.use_bake]
    if exists(ob):
        settings.bake.folder = folder(ob)
    for modifier in changed:
        _change_group(modifier, to_baked=settings.use_bake)
    if changed:
        detail.clear(ob)
    if settings.use_bake:
        there = [_set_inputs(ob, modifier) for modifier in modifiers]
        missing = tr("The files of the bake are not in {}", settings.bake.folder)
        settings.problem = "" if all(there) else missing
    return bool(changed)


def show_detail(ob) -> None:
    """The slope tiles of the bake in the object's material, where both have any."""
    settings, record = ob.libocean, ob.libocean.bake
    known = json.loads(record.bands or "[]") if detail.is_wanted(settings) else []
    bands = [Band(*numbers) for numbers in known]
    place = folder(ob) if bands else ""
    detail.play(
        ob,
        bands,
        (record.first, record.last),
        lambda number: _sequence(ob, place, exr_files.DETAIL[number]),
    )
