# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's handlers: the seas follow its frames, edits, undo, files and renders."""

from __future__ import annotations

import bpy
from bpy.app.handlers import persistent

from . import versions
from .bake import render_check
from .floating import floating
from .look import foam_images
from .sea import drafts, live, meshes, node_group, open_sea
from .shared import compat, hooks
from .spray import spray

_locked_by_us: set[str] = set()  # scenes


def _own_images(oceans: list[bpy.types.Object]) -> None:
    """Gives a copy of an object images of its own."""
    owners: dict[str, str] = {}
    for ob in oceans:
        for modifier in node_group.live_modifiers(ob):
            for name in node_group.image_inputs(modifier.node_group):
                image = node_group.value(modifier, name)
                if image is None:
                    continue
                if owners.setdefault(image.name_full, ob.name_full) != ob.name_full:
                    node_group.assign(modifier, {name: None})


@persistent
def _frame_changed(scene, depsgraph=None) -> None:
    rendering = depsgraph is not None and depsgraph.mode == "RENDER"
    if rendering:
        render_check.require_stopped()
    live.show_all(live.ocean_objects(), scene, depsgraph, rendering=rendering, passing=True)


@persistent
def _depsgraph_updated(scene, depsgraph) -> None:
    if depsgraph.mode == "RENDER":
        return
    # A collection or the scene changes when an object comes or goes.
    kinds = (bpy.types.Object, bpy.types.Collection, bpy.types.Scene)
    if any(isinstance(update.id, kinds) for update in depsgraph.updates):
        oceans = live.ocean_objects()
        drafts.keep_only({ob.name_full for ob in oceans})
        _own_images(oceans)
        live.show_all(oceans, scene, depsgraph)
        for ob in oceans:
            if meshes.is_stand_in(ob.data):  # out of the asset library
                live.follow_mesh(ob)
                foam_images.share()


@persistent
def _data_replaced(*_) -> None:
    render_check.forget()
    oceans = live.ocean_objects()
    names = {ob.name_full for ob in oceans}
    drafts.keep_only(names)
    drafts.forget_stops()
    open_sea.forget(names)
    for ob in oceans:
        versions.upgrade(ob)
    live.show_all(oceans, bpy.context.scene)
    for ob in oceans:  # one that was not there yet when the values of an undo step were kept
        live.follow_mesh(ob)
    if oceans:
        # From 4.0 on nothing knows where it is in the world before it is evaluated.
        live.follow(bpy.context.evaluated_depsgraph_get(), bpy.context.scene)


@persistent
def _saving(*_) -> None:
    render_check.restore()
    live.complete_meshes()
    spray.empty_all()  # which is an update: it comes again


@persistent
def _before_frame(scene, *_) -> None:
    render_check.check(scene)


@persistent
def _lock_interface(scene, *_) -> None:
    """Locks the interface: Blender must not draw images that a render in another thread
    rewrites."""
    render_check.begin()
    live.complete()
    if live.ocean_objects() and not scene.render.use_lock_interface:
        scene.render.use_lock_interface = True
        _locked_by_us.add(scene.name_full)


@persistent
def _unlock_interface(scene, *_) -> None:
    render_check.restore()
    if scene.name_full in _locked_by_us:
        _locked_by_us.remove(scene.name_full)
        scene.render.use_lock_interface = False


_HANDLERS = {
    "frame_change_post": _frame_changed,
    "depsgraph_update_post": _depsgraph_updated,
    "load_post": _data_replaced,
    "undo_post": _data_replaced,
    "redo_post": _data_replaced,
    "save_pre": _saving,
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


def register() -> None:
    for name, handler in _HANDLERS.items():
        getattr(bpy.app.handlers, name).append(handler)
    hooks.connect(
        hooks.Hooks(
            property_changed=live.parameters_changed,
            make_draft_job=live.make_draft_job,
            finish_draft_job=live.finish_draft_job,
            followers=(floating.ride_all, spray.show_all),
        )
    )
    compat.remove_handlers_at_exit(_remove_handlers)


def unregister() -> None:
    _remove_handlers()
    hooks.disconnect()
    open_sea.close_all()
