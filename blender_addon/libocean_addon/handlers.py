# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's handlers: the objects of all subjects follow its frames, edits, undo, files and
renders."""

from __future__ import annotations

import time

import bpy
from bpy.app.handlers import persistent

from .bake import render_check
from .floating import floating
from .look import foam_images
from .sea import hulls
from .shared import compat, drafts, failures, hooks, life, meshes, stored_meshes
from .shared.life import complete
from .spray import spray

_locked_by_us: set[str] = set()  # scenes
_LONGEST_DRAWING = 5.0  # [s]


@persistent
@failures.log_once
def _frame_changed(scene, depsgraph=None) -> None:
    rendering = depsgraph is not None and depsgraph.mode == "RENDER"
    if rendering:
        render_check.require_stopped()
    objects = life.all_shown()
    if not rendering and drafts.is_main_thread():  # some are linked since the last update
        shown_meshes = {part.data for shown in objects for part in life.mesh_parts(shown)}
        stored_meshes.make_whole(shown_meshes)
    life.show_all(objects, scene, depsgraph, rendering=rendering, passing=True)


@persistent
@failures.log_once
def _depsgraph_updated(scene, depsgraph) -> None:
    if depsgraph.mode == "RENDER":
        return
    # A collection or the scene changes when an object comes or goes.
    kinds = (bpy.types.Object, bpy.types.Collection, bpy.types.Scene)
    if any(isinstance(update.id, kinds) for update in depsgraph.updates):
        objects = life.all_shown()
        life.keep_only(objects)
        stored_meshes.make_whole()  # linked, appended, or of a file that was not written
        life.own_images(objects)
        life.show_all(objects, scene, depsgraph)
        for shown in objects:
            if meshes.is_stand_in(shown.ob.data):  # out of the asset library
                shown.subject.follow_mesh(shown)
                foam_images.share()


@persistent
@failures.log_once
def _data_replaced(*_) -> None:
    render_check.forget()
    life.replaced(bpy.context.scene)


@persistent
@failures.log_once
def _saving(*_) -> None:
    render_check.restore()
    life.complete_meshes()
    spray.empty_all()  # which is an update: it comes again
    life.put_aside()


@persistent
@failures.log_once
def _saved(*_) -> None:
    stored_meshes.make_whole()


@persistent
@failures.log_once
def _before_frame(scene, *_) -> None:
    render_check.check(scene)


def _set_lock(scene, is_locked: bool) -> None:
    """Locks or unlocks the interface. Blender refuses that, with an AttributeError, while its main
    thread draws: the drawing is waited for."""
    end = time.monotonic() + _LONGEST_DRAWING
    while True:
        try:
            scene.render.use_lock_interface = is_locked
        except AttributeError:
            if drafts.is_main_thread() or time.monotonic() > end:
                raise
            time.sleep(0.001)
        else:
            return


@persistent
@failures.log_once
def _lock_interface(scene, *_) -> None:
    """Locks the interface: Blender must not draw images that a render in another thread
    rewrites."""
    render_check.begin()
    complete()
    life.begin_render()
    if life.all_shown() and not scene.render.use_lock_interface:
        _set_lock(scene, True)
        _locked_by_us.add(scene.name_full)


@persistent
@failures.log_once
def _unlock_interface(scene, *_) -> None:
    life.end_render()
    render_check.restore()
    if scene.name_full in _locked_by_us:
        _locked_by_us.remove(scene.name_full)
        _set_lock(scene, False)


_HANDLERS = {
    "frame_change_post": _frame_changed,
    "depsgraph_update_post": _depsgraph_updated,
    "load_post": _data_replaced,
    "undo_post": _data_replaced,
    "redo_post": _data_replaced,
    "save_pre": _saving,
    "save_post": _saved,
    "render_init": _lock_interface,
    "render_pre": _before_frame,
    "render_complete": _unlock_interface,
    "render_cancel": _unlock_interface,
}


def _remove_handlers() -> None:
    for name, handler in _HANDLERS.items():
        handlers = getattr(bpy.app.handlers, name)
        if handler in handlers:
            handlers.remove(handler)


def _wake() -> None:
    """Shows the objects of a file that was opened before the add-on was switched on."""
    if life.all_shown():
        _data_replaced()


def _wake_soon() -> None:
    """Calls _wake(): with a window from a timer, without one at once, since no timer runs before
    the script of a command line."""
    if bpy.app.background:
        with compat.all_data():
            _wake()
    elif not bpy.app.timers.is_registered(_wake):
        bpy.app.timers.register(_wake, first_interval=0.0)


def register() -> None:
    for name, handler in _HANDLERS.items():
        getattr(bpy.app.handlers, name).append(handler)
    hooks.connect(
        hooks.Hooks(
            property_changed=life.changed,
            make_draft_job=life.make_job,
            finish_draft_job=life.finish_job,
            followers=(floating.ride_all, spray.show_all, hulls.follow),
        )
    )
    compat.remove_handlers_at_exit(_remove_handlers)
    _wake_soon()


def unregister() -> None:
    if bpy.app.timers.is_registered(_wake):
        bpy.app.timers.unregister(_wake)
    _remove_handlers()
    hooks.disconnect()
    drafts.close()
