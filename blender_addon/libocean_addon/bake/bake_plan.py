# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The plan of a bake, frame by frame, and the record of it that the object keeps.

scene and parameters (here) -> bake_job (a thread) -> record, baked group (here)
"""

from __future__ import annotations

import json
import os
import uuid
from collections.abc import Callable
from pathlib import Path

import bpy

from ..look import detail
from ..sea import live, messages, node_group, sea_text
from ..shared import changes, life, paths
from ..shared.compat import tr
from ..shared.native import libocean
from . import bake_files, bake_job, bake_record, baked, exr_files


class BakeError(Exception):
    """A bake is refused; the sentence says why."""


def asked_range(ob, scene) -> tuple[int, int]:
    """Returns the first and last frame of the shot."""
    settings = ob.libocean.bake
    if settings.use_custom_range:
        return settings.frame_start, settings.frame_end
    return scene.frame_start, scene.frame_end


def with_margins(first: int, last: int) -> tuple[int, int]:
    """Returns the first and last frame that get files: motion blur also reads a frame before and
    behind the shot. Blender's image sequences have no negative numbers."""
    return max(first - 1, 0), last + 1


def size_estimate(ob, samples: tuple[int, int], frames: int) -> int:
    """Returns the max size of a bake [bytes]. samples: columns and rows of its maps."""
    fields = bake_record.wanted_fields(ob.libocean)
    if detail.is_wanted(ob.libocean):  # the library says how many bands there are, not at once
        fields = [*fields, *exr_files.DETAIL]
    is_ocean = bool(node_group.modifiers(ob))
    numbers = 0
    for field in fields:
        is_square = is_ocean or field in exr_files.DETAIL
        columns, rows = reversed(exr_files.shape(field, samples[0])) if is_square else samples
        numbers += rows * columns * len(exr_files.channels(field))
    return frames * 4 * numbers


def _require_one_map(values: sea_text.SeaValues, shown: tuple, before: set) -> None:
    """Raises BakeError unless all frames have one period, one size and one region. shown: the last
    two, of this frame."""
    names = ("patch_size", "resolution", "cascades")
    before.add((*shown, *(values.values[name] for name in names)))
    if len(before) > 1:
        raise BakeError(
            tr(
                "The size, the resolution, the cascades or the region are animated: a bake has one "
                "of each"
            )
        )


def for_each_frame(context, ob, first: int, last: int, take: Callable[..., None]) -> None:
    """Calls take(number, shown frame, settings of the object at that frame) for each frame."""
    scene = context.scene
    numbers = range(first, last + 1)
    if ob.animation_data is None and bake_record.frame_length(scene) == 1.0:
        for number in numbers:
            take(number, float(number), ob.libocean)
        return
    now, part = scene.frame_current, scene.frame_subframe
    try:
        with life.paused():
            for number in numbers:
                scene.frame_set(number)
                seen = ob.evaluated_get(context.evaluated_depsgraph_get())
                take(number, scene.frame_current_final, seen.libocean)
    finally:
        scene.frame_set(now, subframe=part)


def _plan(context, ob, first: int, last: int) -> tuple[list[bake_job.Frame], dict[str, str]]:
    """Returns each frame with its sea, and the recipes by frame; a single one, by "", if all are
    the same."""
    scene = context.scene
    frames, recipes, maps = [], {}, set()

    def add(number: int, at: float, settings) -> None:
        values = live.current_values(settings, scene).without_hulls()  # they do not repeat
        shown = (settings.render_resolution, bake_record.region_of(settings))
        _require_one_map(values, shown, maps)
        frames.append(bake_job.Frame(number, at, values.text(), live.own_time(settings)))
        recipes[str(number)] = bake_record.recipe(settings, values)

    for_each_frame(context, ob, first, last, add)
    if len(set(recipes.values())) == 1:
        recipes = {"": next(iter(recipes.values()))}
    return frames, recipes


def _require_own(ob, place: bake_record.Place, recipes: dict[str, str]) -> None:
    for other in bake_record.others_in(ob, place):
        if not bake_record.is_same_sea(other.libocean.bake, recipes):
            text = tr("The bake of {} is in {}: choose another folder", other.name, place.folder)
            raise BakeError(text)


def require_no_strangers(frames: list[int], asked: str) -> None:
    """Raises BakeError if files of another sea would be overwritten. frames: the frames of such
    files."""
    if frames:
        numbers = bake_files.in_words(frames)
        raise BakeError(
            tr(
                "{} holds another sea, which would be written over at the frames {}: choose "
                "another folder, or delete the files",
                asked,
                numbers,
            )
        )


def _strangers(
    ob, place: bake_record.Place, frames: list[bake_job.Frame], base_dir: str | None
) -> list[int]:
    """Returns the frames whose files in a chosen folder belong neither to the object's bake nor to
    the planned one. In a folder where the object has begun a bake all files are its own."""
    if ob.libocean.bake.begun == place.folder:
        return []
    found = set(bake_record.strangers(ob, place, [frame.number for frame in frames]))
    if not found:
        return []
    marks: dict[str, str] = {}
    for frame in frames:
        if frame.number not in found:
            continue
        if frame.sea not in marks:
            with libocean.parse(frame.sea, base_dir=base_dir) as sea:
                marks[frame.sea] = bake_files.sea_mark(sea.text)
        shown = bake_files.identity(place.file("displacement", frame.number))
        if shown.sea == marks[frame.sea]:
            found.discard(frame.number)
    return sorted(found)


def make_folder(asked: str) -> Path:
    if asked.startswith("//") and not bpy.data.filepath:
        raise BakeError(tr("Save the blend file first: the bake's folder is relative to it"))
    if paths.is_of_windows(asked) and os.name != "nt":
        raise BakeError(tr("{} is a path of Windows: choose another folder", asked))
    path = paths.absolute(asked)
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as failure:
        text = tr("The folder {} cannot be made: {}", path, failure.strerror)
        raise BakeError(text) from failure
    return path


class Work:
    """A job for an object, from its plan to the changed object."""

    job: bake_job.Job
    modifiers = staticmethod(node_group.modifiers)
    """Returns the modifiers by which the work recognises its object."""

    def __init__(self, ob, shot: tuple[int, int]) -> None:
        if shot[1] < shot[0]:
            text = tr("The last frame, {}, comes before the first, {}", *reversed(shot))
            raise BakeError(text)
        self.object_name, self.folder = ob.name, ""
        # The object is found by it even if it gets another name meanwhile.
        self.token = ob.libocean.bake.token = uuid.uuid4().hex

    def is_of(self, ob) -> bool:
        return ob.libocean.bake.token == self.token

    def find(self):
        """Returns the object, not one of the copies that were made of it meanwhile."""
        found = [ob for ob in bpy.data.objects if ob.library is None and self.is_of(ob)]
        ob = min(found, key=lambda ob: ob.name != self.object_name, default=None)
        if ob is None or not self.modifiers(ob):
            text = tr("{} is gone; its files are in {}", self.object_name, self.folder)
            raise BakeError(text)
        return ob

    def finish(self) -> str:
        """Completes the work when all files are written. Returns a report."""
        raise NotImplementedError

    def told(self) -> str:
        done, written = self.job.done, self.job.written
        kept = done - written
        return tr("{} frames in {}: {} written, {} kept", done, self.folder, written, kept)


class Bake(Work):
    """A bake, until the object plays it."""

    def __init__(self, context, ob, asked: str, shot: tuple[int, int], *, overwrite: bool) -> None:
        """asked: the folder; empty: the folder of the object's settings, or the default one."""
        super().__init__(ob, shot)
        try:
            package = exr_files.load_package()
        except ImportError as failure:
            text = tr(
                "To write EXR files takes the Python package OpenEXR, which this copy of the "
                "add-on does not have for Python {}: {}. The add-on's zip has it; the command "
                "ocean bake writes such files without it",
                exr_files.PYTHON,
                failure,
            )
            raise BakeError(text) from failure
        self.range = self._range_of(context, shot)
        self.frame_length = bake_record.frame_length(context.scene)
        frames, self.recipes = _plan(context, ob, *self.range)
        base_dir = paths.blend_folder()
        try:
            with libocean.parse(frames[0].sea, base_dir=base_dir) as sea:
                self._look(ob, sea)
            is_chosen = bool(asked or ob.libocean.bake.directory)
            place = bake_record.next_place(ob, self.recipes, asked)
            _require_own(ob, place, self.recipes)
            if is_chosen and not overwrite:
                require_no_strangers(_strangers(ob, place, frames, base_dir), place.folder)
            self.folder, self.stem = place.folder, place.stem
        except libocean.Error as failure:
            raise BakeError(messages.of_error(failure)) from failure
        self.job = self._make_job(
            ob,
            folder=make_folder(self.folder),
            stem=self.stem,
            frames=frames,
            fields=bake_record.wanted_fields(ob.libocean),
            base_dir=base_dir,
            overwrite=overwrite,
            package=package,
            use_detail=detail.is_wanted(ob.libocean),
        )
        ob.libocean.bake.begun = self.folder

    def _range_of(self, _context, shot: tuple[int, int]) -> tuple[int, int]:
        return with_margins(*shot)

    def _look(self, ob, sea) -> None:
        """Notes the parameters of the maps, from the object and the sea of its first frame."""
        self.resolution = ob.libocean.render_resolution or sea.map_resolution()
        self.period = float(sea.get("patch_size"))
        self.samples = live.samples_of(ob.libocean, sea.map_resolution())

    def _make_job(self, ob, **settings) -> bake_job.Job:
        return bake_job.MapJob(**settings, resolution=self.resolution)

    def _follow(self, ob) -> None:
        """Has the object show the live sea or the bake, as its settings say."""
        baked.follow(ob, node_group.modifiers(ob))

    def _note(self, record) -> None:
        """Writes the parameters of these maps into the record."""
        job = self.job
        record.extent = ""
        record.resolution, record.period = job.resolution, self.period
        record.samples, record.cover_power = self.samples, job.cover_power

    def finish(self) -> str:
        """Has the object play its bake."""
        job, ob = self.job, self.find()
        settings, record = ob.libocean, ob.libocean.bake
        with changes.quiet():
            # Switch to the live sea first: while a bake plays, the folder is the playing one's.
            settings.use_bake = False
            self._follow(ob)
            record.fields = ",".join(job.fields)
            record.folder, record.stem = self.folder, self.stem
            record.first, record.last = self.range
            record.bands = json.dumps(job.bands) if job.use_detail else ""
            record.slope_variance = job.slope_variance
            self._note(record)
            record.frame_length = self.frame_length
            record.sea = job.first_sea
            record.recipes = json.dumps(self.recipes)
            record.marks = " ".join(job.marks)
            settings.use_bake = True
        changes.tell(ob.libocean)
        return self.told()
