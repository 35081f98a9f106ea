# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The crests on cue of a sea: rows of its settings, each with an empty at its place.

rows, empties -> values_of -> SeaValues.crests -> library
sea file -> assign -> rows, empties
"""

from __future__ import annotations

import json
import math
import re
from collections import defaultdict

import bpy
from mathutils import Matrix, Vector

from ..shared import meshes, places
from ..shared.property_texts import shortest

MOST = 16
_OF_HS = " Hs"
_NAME = re.compile(r"\bcrests\.(\d+)(?:\.([a-z]+))?\b")


def is_used(row) -> bool:
    """Returns whether a crest counts: without its empty it has no place."""
    empty = row.empty and row.empty.original
    return empty is not None and (empty.library is not None or meshes.is_there(empty))


def used(settings) -> list:
    """Returns the rows of the crests that count, numbered as in the library."""
    return [row for row in settings.crests if is_used(row)]


# Times ----------------------------------------------------------------------------


def time_of(values: dict[str, str], frame: float) -> float:
    """Returns the time of a sea with these values at a frame [s]."""
    since = (frame - int(values["first_frame"])) / float(values["fps"])
    return float(values["start"]) + since


def frame_of(values: dict[str, str], time: float) -> float:
    return int(values["first_frame"]) + (time - float(values["start"])) * float(values["fps"])


# Values ---------------------------------------------------------------------------


def _matrix(empty) -> Matrix:
    """Returns the place of an empty in the world, also before Blender has evaluated it. A linked
    one may be in no scene, and Blender 4.2 and later keep no matrix of it then."""
    is_free = empty.parent is None and not empty.constraints
    is_unknown = not empty.is_evaluated or empty.library is not None
    return empty.matrix_basis if is_free and is_unknown else empty.matrix_world


def to_labels(ob) -> tuple[Matrix, Matrix]:
    """Returns places.to_labels() of the sea of an object."""
    return places.to_labels(ob, in_world=ob.libocean.follow_world)


def _number(value: float) -> str:
    """Returns the text of a number as the library writes it."""
    return shortest(value).removesuffix(".0")


def _texts(row, labels: Matrix, turn: Matrix, values: dict[str, str]) -> dict[str, str]:
    there = _matrix(row.empty)
    place = labels @ there.translation
    direction = places.heading(turn.inverted() @ there.to_3x3().normalized())
    return {
        "time": _number(row.time) if row.use_time else f"{time_of(values, row.frame):.12g}",
        "x": _number(place.x),
        "y": _number(place.y),
        "height": _number(row.height) + (_OF_HS if row.unit == "HS" else ""),
        "direction": _number(round(direction, 4)) if row.use_direction else "",
    }


def values_of(settings, values: dict[str, str]) -> dict[str, str]:
    """Returns the values of the crests by their names. settings: Object.libocean, evaluated or not;
    values: of its sea."""
    rows, named = used(settings), {}
    if not rows:
        return named
    labels, turn = to_labels(settings.id_data)
    for number, row in enumerate(rows):
        exact = json.loads(row.exact) if row.exact else {}
        for key, text in _texts(row, labels, turn, values).items():
            # A file may have more digits than a property holds: they stay while it is not changed.
            given, shown_then = exact.get(key, ("", ""))
            named[f"crests.{number}.{key}"] = given if text == shown_then else text
    return named


# Rows and empties -----------------------------------------------------------------


def _collection_for(ob):
    """Returns the collection of an object's empties: its own, if that may be changed."""
    own = (c for c in ob.users_collection if c.library is None and c.override_library is None)
    return next(own, bpy.context.scene.collection)


def add(ob, place: Vector, heading: float = 0.0):
    """Returns a new row of an object's sea, with an empty over that place of the world, on the
    level of the water. heading: of its x axis [degrees]."""
    empty = bpy.data.objects.new(f"{ob.name} crest", None)
    empty.empty_display_type = "ARROWS"
    empty.location = (place.x, place.y, ob.matrix_world.translation.z)
    empty.rotation_euler.z = math.radians(heading)
    _collection_for(ob).objects.link(empty)
    row = ob.libocean.crests.add()
    row.empty = empty
    return row


def remove(settings, index: int) -> None:
    """Removes a row and its empty, unless something else uses that."""
    empty = settings.crests[index].empty
    settings.crests.remove(index)
    is_ours = empty is not None and empty.library is None and empty.override_library is None
    if is_ours and empty.users == len(empty.users_collection):
        bpy.data.objects.remove(empty)


def assign(settings, sea) -> None:
    """Makes the crests those of a sea, each with an empty. sea: SeaValues, which the other settings
    have already."""
    ob = settings.id_data
    while settings.crests:
        remove(settings, 0)
    settings.active_crest = 0
    labels, turn = to_labels(ob)
    to_world = labels.inverted_safe()
    wanted: dict[str, dict[str, str]] = defaultdict(dict)
    for name, text in sea.crests.items():
        _, number, key = name.split(".")
        wanted[number][key] = text
    for texts in wanted.values():
        local = labels @ ob.matrix_world.translation
        local.xy = float(texts["x"]), float(texts["y"])
        direction = texts["direction"]
        heading = float(direction or 0.0) + places.heading(turn)
        row = add(ob, to_world @ local, heading)
        row.use_time, row.time = True, float(texts["time"])
        row.frame = frame_of(sea.values, row.time)
        row.unit = "HS" if texts["height"].endswith(_OF_HS) else "METRES"
        row.height = float(texts["height"].removesuffix(_OF_HS))
        row.use_direction = bool(direction)
        shown = _texts(row, labels, turn, sea.values)
        row.exact = json.dumps({key: (text, shown[key]) for key, text in texts.items()})


# Words ----------------------------------------------------------------------------


def in_words(ob, text: str) -> str:
    """Returns a sentence of the library with the names of empties for those of crests."""
    rows = used(ob.libocean)

    def name(found) -> str:
        number, key = int(found[1]), found[2]
        if number >= len(rows):
            return found[0]
        return f"{rows[number].empty.name}, {key}" if key else rows[number].empty.name

    return _NAME.sub(name, text)
