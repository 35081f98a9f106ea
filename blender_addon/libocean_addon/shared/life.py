# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The life of the objects of all subjects: shown at each frame and change, as drafts and as wholes,
with their meshes, their jobs in the background and their errors. The rows of subject.py say what
differs.

    property set -> changed -> opened.follow -> Picture: draft or whole -> mesh
    frame        -> show_all
    draft        -> make_job -> thread -> finish_job -> whole

Objects are found again by the node groups that they use, and what is open for them by their names.
Bakes are left alone.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterable, Iterator

import bpy

from . import (
    console,
    drafts,
    failures,
    hooks,
    meshes,
    modifier_groups,
    stored_meshes,
    subject,
)
from .failures import NotShownError
from .native import libocean
from .subject import Moment, Picture, Shown, Subject

_paused = False
_rendering = False


def all_shown() -> list[Shown]:
    """Returns the objects of all subjects."""
    return [row.look_up(ob) for row in subject.rows for ob in row.family.objects()]


def _has_water(shown: Iterable[Shown]) -> bool:
    return any(one.subject.has_water for one in shown)


def _follow_water(depsgraph, moment: Moment) -> None:
    """Has floats and spray follow the seas of a scene."""
    for follower in hooks.connected().followers:
        follower(depsgraph, moment)


# Showing ------------------------------------------------------------------------


@contextlib.contextmanager
def paused() -> Iterator[None]:
    """Shows nothing of the frames that pass meanwhile."""
    global _paused
    _paused = True
    try:
        yield
    finally:
        _paused = False


def show(shown: Shown, depsgraph, moment: Moment) -> None:
    """Brings images and inputs of an object up to date."""
    row, ob = shown.subject, shown.ob
    row.place(shown, moment)
    if not shown.live:
        row.show_played(shown)
        return
    seen = ob.evaluated_get(depsgraph) if depsgraph else ob
    try:
        shown.opened.follow(row.parameters.values_of(seen, moment.scene))
        row.follow(shown, seen, depsgraph)
        for modifier in shown.live:
            _show_picture(row.picture(shown, seen, modifier, moment))
        problem = row.fault(ob)
    except NotShownError as failure:
        problem = str(failure)
    except (libocean.Error, MemoryError) as failure:
        problem = row.parameters.sentence(ob, failure)
    except Exception as failure:  # a fault of the add-on, which ends neither a frame nor an edit
        problem = failures.sentence(failure)
    settings = getattr(ob, row.settings)
    if settings.problem != problem:
        settings.problem = problem


def _show_picture(picture: Picture) -> None:
    """Shows the whole picture or, where a user would wait, a draft in its place."""
    shown, moment, key = picture.shown, picture.moment, picture.key
    name = shown.ob.name_full
    may_wait = picture.may_wait and (
        moment.moving or (moment.is_redraw and drafts.wants(name, key))
    )
    draft = may_wait and not picture.is_ready()
    if draft:
        picture.show_draft()
        failed_key, sentence = shown.opened.failed or (None, "")
        if failed_key == key:  # the whole was in vain, and would be again
            picture.set_inputs(draft=True)
            raise NotShownError(sentence)
        is_passing = picture.begins_while_playing and drafts.is_playing()
        drafts.ask(name, key, rest=not is_passing)
    else:
        with console.work(name, picture.work):
            picture.show_whole()
        if picture.ends_draft:
            drafts.forget(name, key, more_follows=picture.more_follows)
            if drafts.is_main_thread() and picture.needs_mesh():
                shown.subject.follow_mesh(shown)
    picture.set_inputs(draft=draft)


def show_all(objects, scene, depsgraph=None, *, rendering=False, passing=False) -> None:
    """Shows all these objects. passing: Blender says that the frame has changed."""
    if _paused:
        return
    moment = Moment.of(scene, rendering=rendering, passing=passing)
    for shown in objects:
        show(shown, depsgraph, moment)
    _follow_water(depsgraph, moment)


def show_now(row: Subject, ob) -> None:
    """Shows the whole of an object at the frame of the scene."""
    show(row.look_up(ob), None, Moment(bpy.context.scene, rendering=False))


def changed(ob, name: str) -> None:
    """Shows an object after one of its properties was set in the user interface or by a script.
    name: of the group of properties."""
    looked_up = (row.look_up(ob) for row in subject.rows if name in row.listens)
    shown = next((shown for shown in looked_up if shown.modifiers), None)
    if shown is None:
        return
    row = shown.subject
    ob.update_tag()  # without it the evaluated object keeps the old values
    if row.before_change(shown):
        shown = row.look_up(ob)
    moment = Moment.of_change()
    show(shown, None, moment)
    if row.after_change(shown):
        show(shown, None, moment)
    if row.has_water:
        _follow_water(None, moment)
    # While a draft is shown, the mesh is rebuilt only once values rest, except a new, empty mesh.
    draft = drafts.is_draft(ob.name_full)
    if not draft or meshes.is_empty(ob.data):
        row.follow_mesh(shown, draft=draft)


def own_images(objects: Iterable[Shown]) -> None:
    """Takes the images of another object out of the modifiers of its copies, which then get some
    of their own."""
    owners: dict[str, str] = {}
    for shown in objects:
        for modifier in shown.live:
            modifier_groups.disown(
                shown.ob, modifier, shown.subject.image_inputs(modifier.node_group), owners
            )


# Files and undo -------------------------------------------------------------------


def keep_only(objects: Iterable[Shown]) -> None:
    """Withdraws the requests for objects that were deleted."""
    drafts.keep_only({shown.ob.name_full for shown in objects})


def mesh_parts(shown: Shown) -> list:
    """Returns the objects whose meshes show an object."""
    return [part for part in shown.subject.parts(shown.ob) if meshes.is_mesh(part)]


def put_aside() -> None:
    """Takes large meshes out of a file that is saved, until make_whole()."""
    live, baked = [], []
    for shown in all_shown():
        (live if shown.live else baked).extend(mesh_parts(shown))
    stored_meshes.put_aside(live, baked)


def replaced(scene) -> None:
    """Shows all objects after undo or loading."""
    objects = all_shown()
    keep_only(objects)
    drafts.forget_stops()
    stored_meshes.make_whole()
    for row in subject.rows:
        row.opened.forget({shown.ob.name_full for shown in objects if shown.subject is row})
    for shown in objects:
        shown.subject.upgrade(shown.ob)
    objects = all_shown()  # an upgrade exchanges node groups
    # From 4.0 on nothing knows where it is in the world before it is evaluated.
    sees_camera = any(shown.subject.sees_camera(shown.ob) for shown in objects)
    show_all(objects, scene, bpy.context.evaluated_depsgraph_get() if sees_camera else None)
    for shown in objects:  # one that was absent when the values of an undo step were kept
        shown.subject.follow_mesh(shown)
    if _has_water(objects):
        _follow_water(bpy.context.evaluated_depsgraph_get(), Moment.of_change())


# Renders --------------------------------------------------------------------------


def begin_render() -> None:
    """Has meshes follow the camera of the rendered frames alone, until end_render()."""
    global _rendering
    _rendering = True


def end_render() -> None:
    global _rendering
    _rendering = False


def is_rendering() -> bool:
    return _rendering


def _draft_meshes() -> list[Shown]:
    return [shown for shown in all_shown() if meshes.is_draft(shown.ob.data)]


def complete_meshes() -> None:
    """Makes the meshes whole that are drafts, before a render or for a file that is saved."""
    for shown in _draft_meshes():
        shown.subject.follow_mesh(shown)


def complete() -> None:
    """Blocks until nothing is a draft, before a render. Says so in the console if that fails."""
    is_whole = drafts.complete()
    if drafts.is_main_thread():
        stored_meshes.make_whole()
        complete_meshes()
        return
    few = _draft_meshes()
    if not is_whole or few:
        in_draft = [*few, *(one for one in all_shown() if drafts.is_draft(one.ob.name_full))]
        names = [row.name for row in subject.rows if any(one.subject == row for one in in_draft)]
        said = " and the ".join(names) or "scene"
        print(f"libocean: the render shows a draft of the {said}", flush=True)


# The whole after a draft ------------------------------------------------------------


def make_job(name: str) -> drafts.Job | None:
    """Returns the job of the whole of the object with that full name; None without a job."""
    for row in subject.rows:
        shown = row.named(name)
        if shown is None or not shown.live or getattr(shown.ob, row.settings).problem:
            continue
        job = row.job(shown)
        if job is not None:
            job.subject = row
            return job
    return None


def finish_job(name: str, job: drafts.Job) -> None:
    """Shows the whole of a job that has ended."""
    row = job.subject
    shown = row.named(name)
    if shown is None or job.is_cancelled():
        job.close()
    elif shown.opened.adopt(job):
        row.follow_mesh(shown)
        sees_camera = row.sees_camera(shown.ob)
        depsgraph = bpy.context.evaluated_depsgraph_get() if sees_camera else None
        show_all([shown], bpy.context.scene, depsgraph)
    elif isinstance(job.failure, (libocean.Error, MemoryError)):
        shown.opened.failed = job.key, row.parameters.sentence(shown.ob, job.failure)
        getattr(shown.ob, row.settings).problem = shown.opened.failed[1]
