# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The record of a bake that an object keeps: its fields, its place, its sea, and the faults of its
files.
"""

from __future__ import annotations

import dataclasses
import functools
import hashlib
import itertools
import json
import os
from pathlib import Path

import bpy

from ..coast import coast_job
from ..coast import node_group as coast_group
from ..look import detail
from ..sea import node_group, sea_text
from ..shared import modifier_groups, overrides, paths
from ..shared.compat import tr
from ..terrain.extent import Extent
from . import bake_files, exr_files


def exists(ob) -> bool:
    """Returns whether an object has a record of a bake."""
    return bool(ob.libocean.bake.fields)


def wanted_fields(settings) -> list[str]:
    """Returns the maps that a bake of these settings has, without slope tiles."""
    switches = {
        "cover": "use_foam",
        "velocity": "use_velocity",
        "normal": "use_normal",
        "jacobian": "use_velocity",
    }
    if coast_group.modifiers(settings.id_data):
        return [*coast_group.wanted_files(settings.id_data)]
    near = ["displacement", *(field for field, use in switches.items() if getattr(settings, use))]
    if settings.kind != "HORIZON":
        return near
    return [*near, *(exr_files.far(field) for field in near)]


def lacking(ob) -> list[str]:
    """Returns the wanted fields that the present bake does not have."""
    settings, record = ob.libocean, ob.libocean.bake
    fields = record.fields.split(",")
    found = [field for field in wanted_fields(settings) if field not in fields]
    return [*found, "detail"] if detail.is_wanted(settings) and not record.bands else found


# Where ------------------------------------------------------------------------


_BAKES = "//ocean_bake/"


@dataclasses.dataclass(frozen=True)
class Place:
    """The place of a bake's files. A folder may hold the files of several bakes."""

    folder: str
    """As Blender writes paths."""
    stem: str
    """The beginning of the files' names."""
    library: object = None
    """The library whose file the folder is relative to."""

    @functools.cached_property
    def path(self) -> Path:
        return paths.absolute(self.folder, self.library)

    def file(self, field: str, frame: int) -> str:
        return os.path.join(self.path, exr_files.name(self.stem, field, frame))

    def is_that_of(self, other: Place) -> bool:
        mine, its = (os.path.normcase(place.path / place.stem) for place in (self, other))
        return mine == its


def playing(ob) -> list:
    """Returns the modifiers of an object that play a bake."""
    found = node_group.modifiers(ob) or coast_group.modifiers(ob)
    return [modifier for modifier in found if modifier_groups.BAKED in modifier.node_group]


def shown_image(ob):
    """Returns the image by which the playing modifier displaces; None without a playing
    modifier."""
    images = (modifier_groups.value(modifier, "Displacement") for modifier in playing(ob))
    return next((image for image in images if image is not None), None)


def place_of(ob) -> Place:
    """Returns the place of the bake. When a file is saved elsewhere, Blender changes the paths of
    its images, but not the paths in the record."""
    record, image = ob.libocean.bake, shown_image(ob)
    stem = record.stem or exr_files.EARLIER_STEM
    if image is None:
        return Place(paths.normal(record.folder), stem, overrides.library_of_bake(ob))
    name = exr_files.name(stem, "displacement", record.first)
    return Place(paths.normal(image.filepath)[: -len(name)], stem, image.library)


def others_in(ob, place: Place) -> list:
    """Other objects whose bakes have the same files."""
    others = (other for other in bpy.data.objects if other != ob and exists(other))
    return [other for other in others if place_of(other).is_that_of(place)]


def _new_place(ob, recipes: dict[str, str], asked: str) -> Place:
    """Returns the requested folder, or a folder with the object's name. Objects whose names lead to
    one folder, but whose seas differ, have a folder each."""
    stem = paths.blend_name()
    if asked:
        return Place(asked, stem)
    name = f"{_BAKES}{bpy.path.clean_name(ob.name)}"
    numbered = (f"{name}_{number}/" for number in itertools.count(2))
    found = (Place(folder, stem) for folder in itertools.chain([f"{name}/"], numbered))
    return next(
        place
        for place in found
        if all(is_same_sea(other.libocean.bake, recipes) for other in others_in(ob, place))
    )


def next_place(ob, recipes: dict[str, str], asked: str = "") -> Place:
    """Returns the place of the next bake, of a sea of these recipes. The same sea continues at the
    place of the last bake, whatever the object is called by now. Another sea never gets the place
    of a bake that a blend file of another name may play. asked: the folder; empty: as the settings
    say."""
    asked = paths.normal(asked or ob.libocean.bake.directory)
    goes_on = exists(ob) and _goes_on(ob, recipes, asked)
    return place_of(ob) if goes_on else _new_place(ob, recipes, asked)


def _goes_on(ob, recipes: dict[str, str], asked: str) -> bool:
    """Returns whether the next bake goes to the place of the last one."""
    last = place_of(ob)
    is_there = last.path == paths.absolute(asked) if asked else last.folder.startswith(_BAKES)
    if not is_there or last.library is not None or others_in(ob, last):
        return False
    if last.stem == paths.blend_name():
        return True
    return is_same_sea(ob.libocean.bake, recipes) and not strangers(ob, last)


# The sea of a bake -------------------------------------------------------------


def region_of(settings) -> str:
    """Returns the region of a coast, in words; "" for an ocean."""
    ob = settings.id_data
    return f" {coast_job.region_of(ob.libocean_coast)}" if coast_group.modifiers(ob) else ""


def recipe(settings, values: sea_text.SeaValues) -> str:
    """Returns a short text that differs if the sea shown at a frame differs."""
    time = settings.custom_time if settings.use_custom_time else None
    whole = (
        f"{time} {settings.render_resolution}{region_of(settings)}\n{values.without_hulls().text()}"
    )
    return hashlib.sha256(whole.encode()).hexdigest()[:16]


@functools.lru_cache(maxsize=16)
def _recipes(text: str) -> dict[str, str]:
    return json.loads(text or "{}")


def is_same_sea(record, recipes: dict[str, str]) -> bool:
    """Returns whether a bake has these recipes, by frame or one for all, at all frames of both."""
    known = _recipes(record.recipes)
    if not known or "" in known or "" in recipes:
        return set(known.values()) == set(recipes.values())
    return all(recipes.get(frame, text) == text for frame, text in known.items())


def is_other_sea(ob, scene, values: sea_text.SeaValues) -> bool:
    """Returns whether the bake shows another sea than the parameters at the scene's frame."""
    recipes = _recipes(ob.libocean.bake.recipes)
    baked = recipes.get("", recipes.get(str(scene.frame_current)))
    return baked is not None and baked != recipe(ob.libocean, values)


def extent_of(words: str) -> Extent:
    """Returns the samples of the bake of a coast, from the words of its record."""
    origin, cell, samples = json.loads(words)
    return Extent(tuple(origin), cell, tuple(samples), wraps=False, is_own=False)


def extent_words(extent: Extent) -> str:
    return json.dumps([extent.origin, extent.cell, extent.samples])


@functools.lru_cache(maxsize=16)
def _expected(
    first: int, marks: str, sea: str, recipes: str, resolution: int, extent: str
) -> bake_files.Expected:
    # A bake of an earlier version has no marks, but a sea where all frames have the same.
    one_sea = bake_files.sea_mark(sea) if sea and "" in _recipes(recipes) else None
    by_frame = dict(enumerate(marks.split(), first))
    region = extent_of(extent).shape if extent else None
    return bake_files.Expected(by_frame, one_sea, resolution, region)


def expected(ob) -> bake_files.Expected:
    """Returns the content that the files of the bake must have, by the object's record."""
    record = ob.libocean.bake
    return _expected(
        record.first, record.marks, record.sea, record.recipes, record.resolution, record.extent
    )


def played_fields(ob) -> list[str]:
    """The fields of the bake that are shown."""
    settings, record = ob.libocean, ob.libocean.bake
    wanted = wanted_fields(settings)
    tiles = exr_files.DETAIL if detail.is_wanted(settings) else ()
    return [field for field in record.fields.split(",") if field in wanted or field in tiles]


def faults(ob, frames=None) -> bake_files.Faults:
    """The faults of the files that show these frames of the bake; None: all of them."""
    record = ob.libocean.bake
    if frames is None:
        frames = range(record.first, record.last + 1)
    return bake_files.find(frames, played_fields(ob), place_of(ob).file, expected(ob))


_SENTENCES = {
    bake_files.Fault.MISSING: lambda: tr("files of the bake are missing, of the frames"),
    bake_files.Fault.BROKEN: lambda: tr("files of the bake cannot be read, of the frames"),
    bake_files.Fault.FOREIGN: lambda: tr("files of the bake show another sea, of the frames"),
}


def fault_texts(ob, found: bake_files.Faults) -> list[str]:
    """Returns a sentence for each kind of fault that stops a render: it names the frames and a
    file."""
    return [
        f"{ob.name}: {say()} {bake_files.in_words(found[fault])} ({min(found[fault].items())[1]})"
        for fault, say in _SENTENCES.items()
        if fault in found
    ]


def strangers(ob, place: Place, frames=None) -> list[int]:
    """Returns the frames that have files of another bake than the object's."""
    record, known = ob.libocean.bake, expected(ob)
    if frames is None:
        frames = range(record.first, record.last + 1)
    found = []
    for frame in frames:
        shown = bake_files.identity(place.file("displacement", frame))
        if isinstance(shown, bake_files.Identity) and not known.knows(shown):
            found.append(frame)
    return found


def frame_length(scene) -> float:
    """Returns the length of a frame in the scene's remapped time [frames]."""
    return scene.render.frame_map_old / scene.render.frame_map_new
