# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Before a frame is rendered: the files of the bakes and volumes that it shows are checked, and a
render that would show none, or another sea's, is stopped.

    scene, frame -> oceans that are rendered -> files -> faults -> console -> no camera, no render

Blender ignores what a handler raises. It stops by itself where a scene has no camera: an operator
fails with an error, an animation ends, a command line ends with status 1. So the camera is taken
away until Blender says that the render has ended.
"""

from __future__ import annotations

import dataclasses
import math
import os
import sys

import bpy

from ..shared import compat, life, paths
from ..shared.compat import tr, tr_label
from ..shared.native import ADDON
from ..volumes import volumes
from . import bake_files, bake_record

_ALMOST = 1e-4  # of a frame, as in baked_nodes

_is_first_frame = False
_taken: list[tuple] = []
"""Cameras that were taken away, each with its owner."""


# The rendered objects -------------------------------------------------------------


def _collections(scene) -> set:
    """Returns the collections whose objects are rendered, instanced ones included."""
    found = set()

    def add(collection) -> None:
        if collection in found or collection.hide_render:
            return
        found.add(collection)
        for ob in collection.objects:
            if ob.instance_type == "COLLECTION" and ob.instance_collection and not ob.hide_render:
                add_all(ob.instance_collection)

    def add_all(collection) -> None:
        add(collection)
        for child in collection.children if collection in found else ():
            add_all(child)

    def walk(layer) -> None:
        if layer.exclude or layer.collection.hide_render:
            return
        add(layer.collection)
        for child in layer.children:
            walk(child)

    while scene is not None:
        for layer in scene.view_layers:
            if layer.use:
                walk(layer.layer_collection)
        scene = scene.background_set
    return found


def _rendered(objects: list, scene) -> list:
    """Returns the objects that a render of the scene shows."""
    if not objects or not compat.renders_objects(scene):
        return []
    shown = {ob for collection in _collections(scene) for ob in collection.objects}
    return [ob for ob in objects if ob in shown and not ob.hide_render]


def _is_playing(ob) -> bool:
    playing = bake_record.playing(ob)
    return bake_record.exists(ob) and any(modifier.show_render for modifier in playing)


# Their files ----------------------------------------------------------------------


def _frames_of(ob, scene, frame: float) -> list[int]:
    """The frames whose files a bake plays at a frame of the scene, motion blur included."""
    record, scale = ob.libocean.bake, bake_record.frame_length(scene)
    before, after = compat.shutter(scene)
    first, last = (
        min(max(place * scale / record.frame_length, record.first), record.last)
        for place in (frame - before, frame + after)
    )
    return list(range(math.floor(first + _ALMOST), math.ceil(last - _ALMOST) + 1))


def _faults_of_bake(ob, scene, frames) -> bake_files.Faults:
    return bake_record.faults(
        ob, sorted({n for frame in frames for n in _frames_of(ob, scene, frame)})
    )


def _faults_of_volume(ob, frames) -> bake_files.Faults:
    """Returns the faults of a sequence that the add-on wrote; others are not known to it."""
    volume = ob.data
    marks = volume.get(volumes.MARKS, "").split()
    if not marks or not volume.is_sequence:
        return {}
    first = int(marks[0])
    by_frame = dict(enumerate(marks[1:], first))
    shown = paths.absolute(volume.filepath, volume.library)
    stem = shown.stem.rstrip("0123456789")
    # Which file of the sequence, from 1 on; outside it no volume is shown.
    places = {math.floor(frame) - volume.frame_start + 1 for frame in frames}
    inside = places.intersection(range(1, volume.frame_duration + 1))
    return bake_files.find(
        sorted({place + volume.frame_offset for place in inside} & by_frame.keys()),
        [None],
        lambda _, frame: shown.with_name(f"{stem}{frame:04d}.vdb"),
        bake_files.Expected(by_frame),
    )


def _beyond(ob, scene, frames) -> list[int]:
    """The frames that a bake does not reach: the sea stands still there."""
    record = ob.libocean.bake
    scale = bake_record.frame_length(scene) / record.frame_length
    return [
        math.floor(frame)
        for frame in frames
        if not record.first - _ALMOST <= frame * scale <= record.last + _ALMOST
    ]


@dataclasses.dataclass
class Found:
    """Returns sentences about faults of the frames to be rendered, with the numbers of files."""

    errors: list[str]
    """Sentences about files for which the render would show another sea than the baked one."""
    warnings: list[str]
    """Returns sentences about files that are shown but may not be the intended ones."""


def find(scene, frames) -> Found:
    """Returns the faults of these frames of the scene."""
    frames, found = list(frames), Found([], [])
    playing = [shown.ob for shown in life.all_shown() if _is_playing(shown.ob)]
    for ob in _rendered(playing, scene):
        faults = _faults_of_bake(ob, scene, frames)
        found.errors += bake_record.fault_texts(ob, faults)
        found.warnings += _warnings(ob, scene, frames, faults)
    written = [ob for ob in bpy.data.objects if ob.type == "VOLUME" and volumes.MARKS in ob.data]
    for ob in _rendered(written, scene):
        found.errors += bake_record.fault_texts(ob, _faults_of_volume(ob, frames))
    return found


def _warnings(ob, scene, frames, faults: bake_files.Faults) -> list[str]:
    texts, record = [], ob.libocean.bake
    if beyond := _beyond(ob, scene, frames):
        numbers = bake_files.in_words(beyond)
        text = tr("{}: the sea stands still at frames {}: ", ob.name, numbers)
        texts.append(text + tr_label("Frames {} to {}", record.first, record.last))
    if nameless := faults.get(bake_files.Fault.NAMELESS):
        numbers = bake_files.in_words(nameless)
        texts.append(
            tr("{}: files of the bake do not say which sea they show: {}", ob.name, numbers)
        )
    return texts


# The render -----------------------------------------------------------------------


def begin() -> None:
    """Prepares for a render, of one frame or many."""
    global _is_first_frame
    _is_first_frame = True
    restore()


def _is_ours(package: str | None) -> bool:
    return package is not None and f"{package}.".startswith(f"{ADDON}.")


def _is_from_python() -> bool:
    """Returns whether a script started the render: no Python runs below a handler that Blender
    calls."""
    frame = sys._getframe()
    while frame is not None and _is_ours(frame.f_globals.get("__package__")):
        frame = frame.f_back
    return frame is not None


def _whole_shot(scene) -> list[int]:
    """The frames of an animation that are still to be rendered."""
    frames = range(scene.frame_start, scene.frame_end + 1, scene.frame_step)
    render = scene.render
    if render.use_overwrite or render.is_movie_format:
        return list(frames)
    return [frame for frame in frames if not os.path.exists(render.frame_path(frame=frame))]


def _is_given(*options: str) -> bool:
    """Returns whether the command line has one of these options of Blender's."""
    given = sys.argv[: sys.argv.index("--")] if "--" in sys.argv else sys.argv
    return not set(options).isdisjoint(given)


def check(scene) -> None:
    """Before a frame: stops the render where a file is missing that it would show, or shows another
    sea. `blender --background FILE -a` stops before the first frame where it would at a later one;
    where Blender does not say whether more frames follow, the first of a shot warns of the others.
    """
    global _is_first_frame
    is_first, _is_first_frame = _is_first_frame, False
    frames, later = [scene.frame_current + scene.frame_subframe], []
    if is_first and bpy.app.background and not _is_from_python():
        if _is_given("-a", "--render-anim") and not _is_given("-f", "--render-frame"):
            frames += _whole_shot(scene)
    elif is_first and scene.frame_current == scene.frame_start:
        later = _whole_shot(scene)
    found = find(scene, frames)
    following = find(scene, later) if later and not found.errors else Found([], [])
    if is_first:
        for text in dict.fromkeys([*found.warnings, *following.errors, *following.warnings]):
            _print("Warning", text)
    if found.errors:
        for text in found.errors:
            _print("Error", text)
        _stop(scene)
        if not bpy.app.background:
            _show(found.errors)


def _print(kind: str, text: str) -> None:
    print(f"{kind}: {text}", file=sys.stderr, flush=True)


def _stop(scene) -> None:
    _print("Error", tr("The render stops before this frame: its camera was removed"))
    owners = [scene, *(marker for marker in scene.timeline_markers if marker.camera is not None)]
    _taken.extend((owner, owner.camera) for owner in owners)
    for owner in owners:
        owner.camera = None


def forget() -> None:
    """Another file has been opened, or a step undone: nothing is to be given back."""
    _taken.clear()


def restore() -> None:
    """Gives back the camera that was taken away."""
    while _taken:
        owner, camera = _taken.pop()
        owner.camera = camera


def require_stopped() -> None:
    """Ends a background process whose render goes on nevertheless."""
    if _taken and bpy.app.background:
        sys.stderr.flush()
        sys.exit(1)


def _show(texts: list[str]) -> None:
    """In a window, once Blender is back in it: a render has a thread of its own."""

    def draw(menu, _context) -> None:
        for text in texts:
            menu.layout.label(text=text, translate=False)

    def pop_up() -> None:
        manager = bpy.context.window_manager
        with bpy.context.temp_override(window=manager.windows[0]):
            manager.popup_menu(draw, title=tr_label("The render is stopped"), icon="ERROR")

    bpy.app.timers.register(pop_up, first_interval=0.1)
