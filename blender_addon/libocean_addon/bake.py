# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bake and Free: from an object's sea to files that play without the add-on, and back.

scene and parameters, frame by frame (here) -> bake_job (a thread) -> record, baked group (here)
"""

from __future__ import annotations

import json
import os
import threading
from pathlib import Path

import bpy

from . import (
    bake_job,
    baked,
    compat,
    exr_files,
    live,
    node_group,
    operators,
    properties,
    sea_text,
)
from .compat import tr, tr_label
from .native import libocean


class BakeError(Exception):
    """Why nothing is baked, in a sentence."""


# What is to be baked ----------------------------------------------------------


def asked_range(ob, scene) -> tuple[int, int]:
    """First and last frame of the shot."""
    settings = ob.libocean.bake
    if settings.use_custom_range:
        return settings.frame_start, settings.frame_end
    return scene.frame_start, scene.frame_end


def with_margins(first: int, last: int) -> tuple[int, int]:
    """The frames that have files: motion blur looks beyond the first and the last. Blender's image
    sequences have no negative numbers."""
    return max(first - 1, 0), last + 1


def size_estimate(ob, resolution: int, frames: int) -> int:
    """Bytes at most."""
    samples = 0
    for field in baked.wanted_fields(ob.libocean):
        rows, columns = exr_files.shape(field, resolution)
        samples += rows * columns * len(exr_files.channels(field))
    return frames * 4 * samples


def _require_one_map(values: sea_text.SeaValues, resolution: int, before: set) -> None:
    """A bake has one period and one size."""
    names = ("patch_size", "resolution", "cascades")
    before.add((resolution, *(values.values[name] for name in names)))
    if len(before) > 1:
        raise BakeError(
            tr(
                "The patch size, the resolution or the cascades are animated: "
                "a bake has one of each"
            )
        )


def _plan(context, ob, first: int, last: int) -> tuple[list[bake_job.Frame], dict[str, str]]:
    """What is shown at each frame, and the recipes by frame; one, by "", where all are the same."""
    scene = context.scene
    numbers = range(first, last + 1)
    frames, recipes, maps = [], {}, set()

    def add(number: int, at: float, settings) -> None:
        values = live.current_values(settings, scene)
        _require_one_map(values, settings.render_resolution, maps)
        text = sea_text.write(properties.TABLE, values)
        frames.append(bake_job.Frame(number, live.time_at(at, settings, values), text))
        recipes[str(number)] = baked.recipe(settings, values)

    if ob.animation_data is None and baked.frame_length(scene) == 1.0:
        for number in numbers:
            add(number, float(number), ob.libocean)
    else:
        now, part = scene.frame_current, scene.frame_subframe
        try:
            with live.paused():
                for number in numbers:
                    scene.frame_set(number)
                    seen = ob.evaluated_get(context.evaluated_depsgraph_get())
                    add(number, scene.frame_current_final, seen.libocean)
        finally:
            scene.frame_set(now, subframe=part)
    if len(set(recipes.values())) == 1:
        recipes = {"": next(iter(recipes.values()))}
    return frames, recipes


def _made_folder(ob, asked: str, recipes: dict[str, str]) -> Path:
    if asked.startswith("//") and not bpy.data.filepath:
        raise BakeError(tr("Save the blend file first: the bake's folder is relative to it"))
    path = baked.absolute(asked)
    for other in baked.others_in(ob, path):
        if json.loads(other.libocean.bake.recipes) != recipes:
            text = tr("The bake of {} is in {}: choose another folder", other.name, asked)
            raise BakeError(text)
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as failure:
        text = tr("The folder {} cannot be made: {}", path, failure.strerror)
        raise BakeError(text) from failure
    return path


class Bake:
    """A bake from its plan to the object's record."""

    def __init__(self, context, ob, folder: str, shot: tuple[int, int], *, overwrite: bool) -> None:
        if shot[1] < shot[0]:
            text = tr("The last frame, {}, comes before the first, {}", *reversed(shot))
            raise BakeError(text)
        try:
            package = exr_files.load_package()
        except ImportError as failure:
            text = tr(
                "To write EXR files takes the Python package OpenEXR, which this copy of the "
                "add-on does not have for Python {}: {}",
                exr_files.PYTHON,
                failure,
            )
            raise BakeError(text) from failure
        self.object_name = ob.name
        self.folder = folder
        self.range = with_margins(*shot)
        self.frame_length = baked.frame_length(context.scene)
        frames, self.recipes = _plan(context, ob, *self.range)
        base_dir = bpy.path.abspath("//") or None
        try:
            with libocean.parse(frames[0].sea, base_dir=base_dir) as sea:
                resolution = ob.libocean.render_resolution or sea.map_resolution()
                self.period = float(sea.get("patch_size"))
                self.samples = live.samples_of(ob.libocean, sea.map_resolution())
        except libocean.Error as failure:
            raise BakeError(str(failure)) from failure
        self.job = bake_job.Job(
            _made_folder(ob, folder, self.recipes),
            frames,
            baked.wanted_fields(ob.libocean),
            resolution,
            base_dir,
            overwrite,
            package,
        )

    def finish(self) -> str:
        """The object plays what was baked. Returns what was done, in words."""
        job = self.job
        ob = bpy.data.objects.get(self.object_name)
        if ob is None or not node_group.modifiers(ob):
            text = tr("{} is gone; its files are in {}", self.object_name, self.folder)
            raise BakeError(text)
        settings, record = ob.libocean, ob.libocean.bake
        with properties.quiet():
            # Live first: playing, the folder would be that of the bake before.
            settings.use_bake = False
            baked.follow(ob)
            record.fields = ",".join(job.fields)
            record.folder = self.folder
            record.first, record.last = self.range
            record.resolution, record.period = job.resolution, self.period
            record.samples, record.slope_variance = self.samples, job.slope_variance
            record.frame_length = self.frame_length
            record.sea = job.first_sea
            record.recipes = json.dumps(self.recipes)
            settings.use_bake = True
        properties.tell(ob)
        kept = job.done - job.written
        return tr(
            "{} frames in {}: {} written, {} were there", job.done, self.folder, job.written, kept
        )


# For the panel ----------------------------------------------------------------


def _bytes(count: int) -> str:
    return f"{count / 1e9:.1f} GB" if count >= 1e9 else f"{count / 1e6:.1f} MB"


def _of_the_bake(ob, scene) -> list[tuple[str, str]]:
    record = ob.libocean.bake
    fields = record.fields.split(",")
    there, size = _inventory(str(baked.folder_path(ob)), record.first, record.last, tuple(fields))
    count = record.last - record.first + 1
    lines = [(tr_label("{} of {} frames, {}", there, count, _bytes(size)), "FILE_CACHE")]
    values = live.current_values(ob.libocean, scene)
    if baked.is_other_sea(ob, scene, values):
        text = tr_label("The bake is of another sea than the parameters say: bake again")
        lines.append((text, "ERROR"))
    if abs(record.frame_length - baked.frame_length(scene)) > 1e-6:
        text = tr_label("The bake is for another time remapping: bake again")
        lines.append((text, "ERROR"))
    lacking = [field for field in baked.wanted_fields(ob.libocean) if field not in fields]
    if lacking:
        lines.append((tr_label("Not in the bake: {}", ", ".join(lacking)), "ERROR"))
    first, last = with_margins(*asked_range(ob, scene))
    if first < record.first or last > record.last:
        text = tr_label(
            "Frames {} to {}: the sea stands still beyond them", record.first, record.last
        )
        lines.append((text, "INFO"))
    return lines


def state(ob, scene) -> list[tuple[str, str]]:
    """Lines of text about the bake of an object, with icons."""
    if _running is not None and _running.object_name == ob.name:
        job = _running.job
        return [(tr_label("{} of {} frames; ESC stops", job.done, len(job.frames)), "TIME")]
    lines = _of_the_bake(ob, scene) if baked.exists(ob) else []
    resolution = ob.libocean.render_resolution or live.map_resolution(ob)
    if resolution:
        first, last = with_margins(*asked_range(ob, scene))
        most = size_estimate(ob, resolution, max(last - first + 1, 0))
        text = tr_label(
            "Frames {} to {} of {} x {} samples: {} at most, in {}",
            first,
            last,
            resolution,
            resolution,
            _bytes(most),
            baked.asked_folder(ob),
        )
        lines.append((text, "DISK_DRIVE"))
    return lines


_looked_at: dict[tuple, tuple[float, tuple[int, int]]] = {}


def _inventory(folder: str, first: int, last: int, fields: tuple[str, ...]) -> tuple[int, int]:
    """Frames that are there and their bytes, looked up anew when the folder has changed."""
    asked = (folder, first, last, fields)
    try:
        changed = os.stat(folder).st_mtime
    except OSError:
        return 0, 0
    if asked not in _looked_at or _looked_at[asked][0] != changed:
        _looked_at[asked] = changed, exr_files.inventory(folder, first, last, fields)
    return _looked_at[asked][1]


# Operators --------------------------------------------------------------------


def _words(failure: Exception) -> str:
    """What stopped a job."""
    if isinstance(failure, exr_files.NotWholeError):
        path = failure.args[0]
        return tr("{} could not be written to its end: is the disk full?", path)
    return str(failure) or type(failure).__name__


_running: Bake | None = None
"""The one that a user waits for: there is one status bar."""


class _OnOwnOcean(operators.OnOcean):
    @classmethod
    def poll(cls, context) -> bool:
        if not super().poll(context):
            return False
        if context.object.library is None:
            return True
        cls.poll_message_set(tr("The object is linked: bake it in its own file"))
        return False


class BakeOcean(_OnOwnOcean, bpy.types.Operator):
    """Write the sea of each frame as files, and play those: rendering them takes neither the
    add-on nor the library. Files of the same sea that are there are kept. ESC stops it"""

    bl_idname = "libocean.bake"
    bl_label = "Bake Ocean"
    bl_options = {"UNDO"}  # nothing to adjust: that would bake again

    directory: bpy.props.StringProperty(
        name="Folder",
        description="Empty: that of the object's settings",
        subtype="DIR_PATH",
        options=compat.RELATIVE_PATH,
    )
    frame_start: bpy.props.IntProperty(
        name="First frame", description="-1: that of the object's settings", default=-1, min=-1
    )
    frame_end: bpy.props.IntProperty(
        name="Last frame", description="-1: that of the object's settings", default=-1, min=-1
    )
    overwrite: bpy.props.BoolProperty(
        name="Overwrite", description="Write also the files that are there and of the same sea"
    )

    def _prepare(self, context) -> Bake | None:
        ob = context.object
        first, last = asked_range(ob, context.scene)
        first = first if self.frame_start < 0 else self.frame_start
        last = last if self.frame_end < 0 else self.frame_end
        folder = self.directory or baked.asked_folder(ob)
        if _running is not None:
            self.report({"ERROR"}, tr("A bake of {} is under way", _running.object_name))
            return None
        try:
            return Bake(context, ob, folder, (first, last), overwrite=self.overwrite)
        except BakeError as failure:
            self.report({"ERROR"}, str(failure))
            return None

    def _finish(self, bake: Bake) -> set[str]:
        job = bake.job
        if job.failure is not None:
            self.report({"ERROR"}, tr("After {} frames: {}", job.done, _words(job.failure)))
            return {"CANCELLED"}
        if job.done < len(job.frames):
            text = tr("Stopped; {} of {} frames are there", job.done, len(job.frames))
            self.report({"WARNING"}, text)
            return {"CANCELLED"}
        try:
            self.report({"INFO"}, bake.finish())
        except BakeError as failure:
            self.report({"ERROR"}, str(failure))
            return {"CANCELLED"}
        return {"FINISHED"}

    def execute(self, context):
        bake = self._prepare(context)
        if bake is None:
            return {"CANCELLED"}
        manager = context.window_manager
        manager.progress_begin(0, len(bake.job.frames))
        try:
            bake.job.run(lambda: manager.progress_update(bake.job.done))
        finally:
            manager.progress_end()
        return self._finish(bake)

    def invoke(self, context, _event):
        global _running
        if bpy.app.background:
            return self.execute(context)
        bake = self._prepare(context)
        if bake is None:
            return {"CANCELLED"}
        _running = bake
        self._thread = threading.Thread(target=bake.job.run, daemon=True)
        self._thread.start()
        manager = context.window_manager
        self._timer = manager.event_timer_add(0.1, window=context.window)
        manager.progress_begin(0, len(bake.job.frames))
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        bake = _running
        job = bake.job
        if event.type == "ESC":
            job.stop.set()
        elif event.type != "TIMER":
            return {"PASS_THROUGH"}
        elif self._thread.is_alive():
            context.window_manager.progress_update(job.done)
            text = tr_label(
                "Baking {}: {} of {} frames; ESC stops it",
                bake.object_name,
                job.done,
                len(job.frames),
            )
            context.workspace.status_text_set(text)
            return {"PASS_THROUGH"}
        self._end(context)
        return self._finish(bake)

    def cancel(self, context) -> None:
        """Blender ends it: another file is opened."""
        self._end(context)

    def _end(self, context) -> None:
        global _running
        _running.job.stop.set()
        self._thread.join()
        _running = None
        manager = context.window_manager
        manager.event_timer_remove(self._timer)
        manager.progress_end()
        if context.workspace is not None:
            context.workspace.status_text_set(None)


class FreeBake(_OnOwnOcean, bpy.types.Operator):
    """Show the live sea again and forget the bake"""

    bl_idname = "libocean.free_bake"
    bl_label = "Free Bake"
    bl_options = {"REGISTER", "UNDO"}

    delete_files: bpy.props.BoolProperty(
        name="Delete files", description="Remove the files of the bake, which no undo brings back"
    )

    @classmethod
    def poll(cls, context) -> bool:
        if not super().poll(context):
            return False
        if baked.exists(context.object):
            return True
        cls.poll_message_set(tr("The active object has no bake"))
        return False

    def invoke(self, context, event):
        if self.delete_files:
            return context.window_manager.invoke_confirm(self, event)
        return self.execute(context)

    def execute(self, context):
        ob = context.object
        path = baked.folder_path(ob)
        others = baked.others_in(ob, path)
        with properties.quiet():
            ob.libocean.use_bake = False
            ob.libocean.bake.fields = ""
            ob.libocean.problem = ""
        properties.tell(ob)
        if not self.delete_files:
            return {"FINISHED"}
        if others:
            text = tr("The files stay: {} plays them too", others[0].name)
            self.report({"WARNING"}, text)
            return {"FINISHED"}
        try:
            self.report({"INFO"}, tr("{} files removed", exr_files.remove(path)))
        except OSError as failure:
            self.report({"ERROR"}, tr("Not all files could be removed: {}", failure))
        return {"FINISHED"}


CLASSES = (BakeOcean, FreeBake)


def register() -> None:
    for cls in CLASSES:
        bpy.utils.register_class(cls)


def unregister() -> None:
    if _running is not None:
        _running.job.stop.set()
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
