# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators Bake and Free: from a sea to files that play without the add-on, and back."""

from __future__ import annotations

import threading

import bpy

from ..sea import hulls, messages, operators
from ..shared import changes, compat, console, overrides, registration, subject
from ..shared.compat import tr, tr_label
from ..shared.table_properties import settings_of
from . import bake_files, bake_job, bake_record, exr_files
from .bake_plan import BakeError, Work, asked_range

FIELDS = settings_of("bake")
"""The fields of operators, by the names of their classes."""


def in_words(failure: Exception) -> str:
    """Returns the sentence about the failure that stopped a job."""
    if isinstance(failure, exr_files.NotWholeError):
        path = failure.args[0]
        return tr("{} could not be written completely: is the disk full?", path)
    if isinstance(failure, bake_job.OtherTilesError):
        return tr(
            "The limits of the wavelength are animated: a bake with near detail has one of each"
        )
    return messages.of_error(failure) or type(failure).__name__


running: Work | None = None
"""The work that a user waits for. There is a single one, since there is one status bar."""


def _is_own(cls, context) -> bool:
    if context.object.library is None:
        return True
    cls.poll_message_set(tr("The object is linked: bake it in its own file"))
    return False


class _OnOwnOcean(operators.OnOcean):
    @classmethod
    def poll(cls, context) -> bool:
        return super().poll(context) and _is_own(cls, context)


class OnBaked:
    """Base of operators on an object of a subject that can be baked."""

    @classmethod
    def poll(cls, context) -> bool:
        if context.object is not None and subject.that_bakes(context.object) is not None:
            return _is_own(cls, context)
        cls.poll_message_set(operators.OnOcean.absent())
        return False


class Frames(_OnOwnOcean):
    """Base of operators that write the frames of a sea: with a window in a thread of its own, which
    ESC stops; else at once."""

    bl_options = {"UNDO"}  # nothing to adjust: that would write them again

    directory: bpy.props.StringProperty(
        name="Folder",
        description="Empty: the folder of the object's settings",
        subtype="DIR_PATH",
        options=compat.RELATIVE_PATH,
    )
    __annotations__.update(FIELDS["Frames"])

    def begin(self, context, shot: tuple[int, int]) -> Work:
        """Returns the work for the active object, of those frames; raises BakeError."""
        raise NotImplementedError

    def _prepare(self, context) -> Work | None:
        first, last = asked_range(context.object, context.scene)
        first = first if self.frame_start < 0 else self.frame_start
        last = last if self.frame_end < 0 else self.frame_end
        if running is not None:
            self.report({"ERROR"}, tr("A bake of {} is under way", running.object_name))
            return None
        overrides.make_editable(context.object)
        if len(context.object.libocean.hulls) > 0:
            self.report({"WARNING"}, hulls.left_out())
        try:
            return self.begin(context, (first, last))
        except BakeError as failure:
            self.report({"ERROR"}, str(failure))
            return None

    def _finish(self, bake: Work) -> set[str]:
        job = bake.job
        if job.failure is not None:
            self.report({"ERROR"}, tr("After {} frames: {}", job.done, in_words(job.failure)))
            return {"CANCELLED"}
        if job.done < len(job.frames):
            text = tr("Stopped; {} of {} frames are finished", job.done, len(job.frames))
            self.report({"WARNING"}, text)
            return {"CANCELLED"}
        try:
            self.report({"INFO"}, bake.finish())
        except BakeError as failure:
            self.report({"ERROR"}, str(failure))
            return {"CANCELLED"}
        if job.warning:
            self.report({"WARNING"}, messages.in_words(job.warning))
        return {"FINISHED"}

    def execute(self, context):
        bake = self._prepare(context)
        if bake is None:
            return {"CANCELLED"}
        manager = context.window_manager
        manager.progress_begin(0, len(bake.job.frames))

        def said() -> str:
            return f"{bake.job.done} of {len(bake.job.frames)} frames"

        try:
            with console.work(bake.object_name, said):
                bake.job.run(lambda: manager.progress_update(bake.job.done))
        finally:
            manager.progress_end()
        return self._finish(bake)

    def invoke(self, context, _event):
        global running
        if bpy.app.background:
            return self.execute(context)
        bake = self._prepare(context)
        if bake is None:
            return {"CANCELLED"}
        running = bake
        self._thread = threading.Thread(target=bake.job.run, daemon=True)
        self._thread.start()
        manager = context.window_manager
        self._timer = manager.event_timer_add(0.1, window=context.window)
        manager.progress_begin(0, len(bake.job.frames))
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        bake = running
        job = bake.job
        if event.type == "ESC" and event.value == "PRESS":  # its release may be of the bake before
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
        """Ends the work when Blender opens another file."""
        self._end(context)

    def _end(self, context) -> None:
        global running
        running.job.stop.set()
        self._thread.join()
        running = None
        manager = context.window_manager
        manager.event_timer_remove(self._timer)
        manager.progress_end()
        if context.workspace is not None:
            context.workspace.status_text_set(None)


class BakeOcean(OnBaked, Frames, bpy.types.Operator):
    """Write the sea of each frame as files, and play those: rendering them takes neither the
    add-on nor the library. Existing files of the same sea are kept. ESC stops it"""

    bl_idname = "libocean.bake"
    bl_label = "Bake Ocean"

    def begin(self, context, shot: tuple[int, int]) -> Work:
        bake = subject.that_bakes(context.object).bake
        return bake(context, context.object, self.directory, shot, overwrite=self.overwrite)


class FreeBake(OnBaked, bpy.types.Operator):
    """Show the live sea again and forget the bake"""

    bl_idname = "libocean.free_bake"
    bl_label = "Free Bake"
    bl_options = {"REGISTER", "UNDO"}

    __annotations__ = FIELDS["FreeBake"]

    @classmethod
    def poll(cls, context) -> bool:
        if not super().poll(context):
            return False
        if bake_record.exists(context.object):
            return True
        cls.poll_message_set(tr("The active object has no bake"))
        return False

    def invoke(self, context, event):
        if self.delete_files:
            return context.window_manager.invoke_confirm(self, event)
        return self.execute(context)

    def execute(self, context):
        ob = context.object
        place = bake_record.place_of(ob)
        others, strangers = bake_record.others_in(ob, place), bake_record.strangers(ob, place)
        overrides.make_editable(ob)
        with changes.quiet():
            ob.libocean.use_bake = False
            ob.libocean.bake.fields = ""
            getattr(ob, subject.that_bakes(ob).settings).problem = ""
        changes.tell(ob.libocean)
        if not self.delete_files:
            return {"FINISHED"}
        if others:
            text = tr("The files stay: {} plays them too", others[0].name)
            self.report({"WARNING"}, text)
            return {"FINISHED"}
        if strangers:
            numbers = bake_files.in_words(strangers)
            self.report({"WARNING"}, tr("The files stay: those of {} show another sea", numbers))
            return {"FINISHED"}
        try:
            self.report({"INFO"}, tr("{} files removed", exr_files.remove(place.path, place.stem)))
        except OSError as failure:
            self.report({"ERROR"}, tr("Not all files could be removed: {}", failure))
        return {"FINISHED"}


CLASSES = (BakeOcean, FreeBake)


register, _unregister = registration.functions(CLASSES)


def unregister() -> None:
    if running is not None:
        running.job.stop.set()
    _unregister()
