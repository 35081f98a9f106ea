# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Playing a bake, and the change between live and baked.

record (folder, frames, fields) -> image sequences -> inputs of the baked node group, and the
                                                      slope tiles in the material
"""

from __future__ import annotations

import json
import os

import bpy

from ..look import detail
from ..look.detail_tiles import Band
from ..sea import hull_nodes, node_group
from ..shared import changes, meshes, modifier_groups, overrides, paths
from . import bake_record, baked_nodes, exr_files

# The names of the fields in files, by the inputs of the node group.
FILES = {name: name.lower() for name in baked_nodes.FIELDS}
FILES |= {node_group.far_image(name): exr_files.far(file) for name, file in FILES.items()}


# Images -----------------------------------------------------------------------


def sequence(ob, place: bake_record.Place, field: str):
    """Returns the image of a field's files. The first file, which the sequence is named by, may be
    absent: bake_record.faults says which files are."""
    between = "" if place.folder.endswith(("/", "\\")) else "/"
    name = exr_files.name(place.stem, field, ob.libocean.bake.first)
    path = place.folder + between + name
    for image in bpy.data.images:
        if image.source == "SEQUENCE" and image.filepath == path and image.library is None:
            return image
    image = bpy.data.images.new(f".{ob.name} baked {field}", 1, 1, float_buffer=True, is_data=True)
    image.source = "SEQUENCE"
    image.filepath = path
    image.colorspace_settings.name = "Non-Color"
    image.alpha_mode = "CHANNEL_PACKED"
    return image


# Live or baked ----------------------------------------------------------------


def _clear_inputs(modifier) -> set:
    """Returns the images that the modifier showed, and empties its inputs: another group would take
    the values that stay for its own."""
    group = modifier.node_group
    names = node_group.image_inputs(group)
    images = {modifier_groups.value(modifier, name) for name in names} - {None}
    modifier_groups.assign(modifier, dict.fromkeys(names))
    objects = [*hull_nodes.object_inputs(), "Camera"]
    modifier_groups.assign(modifier, dict.fromkeys(objects))
    return images


def remove_unused(images: set) -> None:
    """Removes images without users. Image sequences that are in use, or have an override by
    Blender's count, read their files again: the files may have been replaced."""
    for image in images:
        if image.library is not None:
            continue
        if image.users == 0:
            bpy.data.images.remove(image)
        elif image.source == "SEQUENCE":
            image.reload()


def _change_group(ob, modifier, *, to_baked: bool) -> None:
    """Changes the node group of a modifier, and removes the old group's images unless they are in
    use elsewhere."""
    images = _clear_inputs(modifier)
    modifier.node_group = node_group.get(ob.libocean.kind, baked=to_baked)
    remove_unused(images)


def _serves(ob, modifier) -> bool:
    """Returns whether a modifier shows the sea that the settings choose: live, on a mesh of their
    kind, or the bake of the record."""
    wanted, group = ob.libocean.use_bake, modifier.node_group
    if modifier_groups.is_baked(group) != wanted:
        return False
    if not wanted:
        return node_group.kind_of(group) == ob.libocean.kind
    if not overrides.is_librarys(ob, modifier):
        return True
    return overrides.has_librarys_bake(ob)


def _change(ob, modifier) -> None:
    """Changes a modifier from live to baked or back, from the library's bake to the bake of the
    shot, or to a mesh of another kind."""
    to_baked = ob.libocean.use_bake
    if overrides.is_librarys(ob, modifier):
        overrides.add_own(ob, modifier, node_group.get(ob.libocean.kind, baked=to_baked))
        return
    theirs = [
        other
        for other in node_group.all_modifiers(ob)
        if overrides.is_librarys(ob, other) and _serves(ob, other)
    ]
    if not theirs:
        _change_group(ob, modifier, to_baked=to_baked)
        return
    images = _clear_inputs(modifier)
    ob.modifiers.remove(modifier)
    remove_unused(images)
    for other in theirs:
        overrides.restore(ob, other)


def _set_inputs(ob, modifier) -> None:
    """Has a modifier play the bake of the record."""
    settings, record = ob.libocean, ob.libocean.bake
    fields = record.fields.split(",")
    place = bake_record.place_of(ob)
    if place.library is not None:  # of an override: from now on the shot's own path
        path = str(place.path)
        folder = bpy.path.relpath(path) if bpy.data.filepath else path
        place = bake_record.Place(paths.normal(folder), place.stem)
    images = {
        name: sequence(ob, place, FILES[name]) if FILES[name] in fields else None
        for name in node_group.image_inputs(modifier.node_group)
    }
    if overrides.is_librarys(ob, modifier):  # whose paths go from the library's file
        images = {}
    modifier_groups.assign(
        modifier,
        {
            **images,
            "Tile Size": record.period,
            "Half Texel": 0.5 / record.resolution,
            node_group.ON_SAMPLES: meshes.is_on_samples(ob.data, record.resolution),
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
        modifier_groups.assign(modifier, {"Samples": float(record.samples)})


def upgrade(ob) -> None:
    """Replaces node groups that an earlier version of the add-on built by today's."""
    if ob.library is not None:
        return
    for modifier in node_group.modifiers(ob):
        if node_group.is_old(modifier.node_group):
            playing = modifier_groups.is_baked(modifier.node_group)
            _change_group(ob, modifier, to_baked=playing)
            if playing:
                _set_inputs(ob, modifier)
    modifiers = node_group.modifiers(ob)
    if any(not _serves(ob, modifier) for modifier in modifiers):
        follow(ob, modifiers)  # an override that an earlier version baked has lost its record


def follow(ob, modifiers) -> bool:
    """Brings the ocean modifiers of an object in line with `kind`, `use_bake` and the settings.
    Returns whether one got another node group: look the modifiers up again then."""
    settings = ob.libocean
    if not bake_record.exists(ob):
        if settings.use_bake:
            with changes.quiet():
                settings.use_bake = False
    elif bake_record.shown_image(ob) is not None:
        settings.bake.folder = bake_record.place_of(ob).folder
    names = [modifier.name for modifier in modifiers]
    changed = [name for name in names if not _serves(ob, ob.modifiers[name])]
    for name in changed:
        _change(ob, ob.modifiers[name])
    if changed:
        detail.clear(ob)
    if settings.use_bake:
        for modifier in node_group.modifiers(ob):
            _set_inputs(ob, modifier)
        if changed:
            settings.problem = " ".join(bake_record.fault_texts(ob, bake_record.faults(ob)))
    return bool(changed)


def show_detail(ob) -> None:
    """The slope tiles of the bake in the object's material, where both have any."""
    settings, record = ob.libocean, ob.libocean.bake
    known = json.loads(record.bands or "[]") if detail.is_wanted(settings) else []
    bands = [Band(*numbers) for numbers in known]
    place = bake_record.place_of(ob) if bands else None

    def load(number: int):
        """None: the files of before are gone, and the material goes without."""
        field = exr_files.DETAIL[number]
        return (
            sequence(ob, place, field) if os.path.exists(place.file(field, record.first)) else None
        )

    lost = record.slope_variance if record.extent else None
    detail.play(ob, bands, (record.first, record.last), load, lost)
