# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel's lines about bakes: the running one, the present one, the next one."""

from __future__ import annotations

import json
import os

from ..coast import facts as coast_facts
from ..coast import node_group as coast_group
from ..sea import facts, hulls, live
from ..shared.compat import tr_label
from ..volumes import volumes
from . import bake, bake_record, exr_files
from .bake_plan import asked_range, size_estimate, with_margins


def _bytes(count: int) -> str:
    return f"{count / 1e9:.1f} GB" if count >= 1e9 else f"{count / 1e6:.1f} MB"


def _of_the_bake(ob, scene) -> list[tuple[str, str]]:
    record = ob.libocean.bake
    fields = record.fields.split(",")
    place = bake_record.place_of(ob)
    there, size = _inventory(place, record.first, record.last, tuple(fields))
    count = record.last - record.first + 1
    lines = [(tr_label("{} of {} frames, {}", there, count, _bytes(size)), "FILE_CACHE")]
    values = live.current_values(ob.libocean, scene)
    if bake_record.is_other_sea(ob, scene, values):
        text = tr_label("The bake shows another sea than the parameters: bake again")
        lines.append((text, "ERROR"))
    if abs(record.frame_length - bake_record.frame_length(scene)) > 1e-6:
        text = tr_label("The bake is for another time remapping: bake again")
        lines.append((text, "ERROR"))
    lines += [(text, "ERROR") for text in faults(ob)]
    if lacking := bake_record.lacking(ob):
        lines.append((tr_label("Not in the bake: {}", ", ".join(lacking)), "ERROR"))
    first, last = with_margins(*asked_range(ob, scene))
    if first < record.first or last > record.last:
        text = tr_label(
            "Frames {} to {}: the sea stands still beyond them", record.first, record.last
        )
        lines.append((text, "INFO"))
    return lines


def _of_what_runs(ob) -> list[tuple[str, str]]:
    if bake.running is None or not bake.running.is_of(ob):
        return []
    job = bake.running.job
    return [(tr_label("{} of {} frames; ESC stops", job.done, len(job.frames)), "TIME")]


def of_volumes(ob, scene) -> list[tuple[str, str]]:
    """Returns the lines about the volumes of an object, with icons."""
    first, last = asked_range(ob, scene)
    folder = volumes.asked_folder(ob)
    text = tr_label("Frames {} to {}, in {}", first, last, folder)
    return _of_what_runs(ob) or [(text, "DISK_DRIVE")]


def _samples(ob) -> tuple[int, int] | None:
    """Returns columns and rows of the maps of the next bake; None before they are known."""
    if coast_group.modifiers(ob):
        return coast_facts.samples_of(ob)
    resolution = ob.libocean.render_resolution or facts.map_resolution(ob)
    return (resolution, resolution) if resolution else None


def state(ob, scene) -> list[tuple[str, str]]:
    """Returns the lines about the bake of an object, with icons."""
    if running := _of_what_runs(ob):
        return running
    lines = _of_the_bake(ob, scene) if bake_record.exists(ob) else []
    if len(ob.libocean.hulls) > 0:
        lines.append((hulls.left_out(), "ERROR"))
    samples = _samples(ob)
    if samples is not None:
        first, last = with_margins(*asked_range(ob, scene))
        most = size_estimate(ob, samples, max(last - first + 1, 0))
        text = tr_label(
            "Frames {} to {} of {} x {} samples: {} at most, in {}",
            first,
            last,
            *samples,
            _bytes(most),
            bake_record.next_place(ob, _recipes_now(ob, scene)).folder,
        )
        lines.append((text, "DISK_DRIVE"))
    return lines


def _recipes_now(ob, scene) -> dict[str, str]:
    """Returns the recipes of the next bake, by the frame that is shown."""
    now = bake_record.recipe(ob.libocean, live.current_values(ob.libocean, scene))
    known = json.loads(ob.libocean.bake.recipes or "{}")
    return {str(scene.frame_current): now} if known and "" not in known else {"": now}


_looked_at: dict[tuple, tuple[float, tuple[int, int]]] = {}
_faults: dict[tuple, tuple[float, list[str]]] = {}


def faults(ob) -> list[str]:
    """Returns sentences about the faults of a bake's files; looks again when the folder has
    changed."""
    place, record = bake_record.place_of(ob), ob.libocean.bake
    asked = (
        str(place.path),
        ob.name_full,
        record.token,
        record.fields,
        *bake_record.played_fields(ob),
    )
    try:
        changed = os.stat(place.path).st_mtime
    except OSError:
        changed = -1.0
    if asked not in _faults or _faults[asked][0] != changed:
        _faults[asked] = changed, bake_record.fault_texts(ob, bake_record.faults(ob))
    return _faults[asked][1]


def _inventory(
    place: bake_record.Place, first: int, last: int, fields: tuple[str, ...]
) -> tuple[int, int]:
    """Returns the number of frames with files, and their bytes, looked up anew when the folder has
    changed."""
    folder = str(place.path)
    asked = (folder, place.stem, first, last, fields)
    try:
        changed = os.stat(folder).st_mtime
    except OSError:
        return 0, 0
    if asked not in _looked_at or _looked_at[asked][0] != changed:
        _looked_at[asked] = changed, exr_files.inventory(*asked)
    return _looked_at[asked][1]
