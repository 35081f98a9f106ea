# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The kinds of things that objects show, each a row: what a sea, a terrain and a coast do in their
own ways. shared/life.py does the rest for all of them.

    subjects.register -> add(row) -> life: for each row, for each of its objects
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any

import bpy

from . import drafts, meshes
from .messages import Words
from .modifier_groups import Family, is_baked
from .open_subject import OpenByObject


@dataclasses.dataclass(frozen=True)
class Moment:
    """The scene at its frame, and the purpose of showing it."""

    scene: bpy.types.Scene
    rendering: bool
    moving: bool = False
    """True if a draft suffices for now: values move, or time plays."""
    is_redraw: bool = False
    """True if Blender may redraw the same frame unprompted (e.g. after a driver edit): a draft of
    that frame stays one."""

    @classmethod
    def of(cls, scene: bpy.types.Scene, *, rendering: bool, passing: bool) -> Moment:
        """Returns the moment of a scene. passing: Blender reports that the frame has changed."""
        return cls(
            scene,
            rendering,
            moving=drafts.allows_draft(rendering=rendering, passing=passing),
            is_redraw=drafts.is_redraw(rendering=rendering, passing=passing),
        )

    @classmethod
    def of_change(cls) -> Moment:
        """Returns the moment after a change of a property, for which a draft suffices."""
        return cls(bpy.context.scene, rendering=False, moving=drafts.allowed)


@dataclasses.dataclass(frozen=True)
class Shown:
    """An object of a subject, looked up once for a change or a frame and handed on. Not kept from
    call to call: Blender's data may go at any time."""

    subject: Subject
    ob: Any
    modifiers: tuple
    """The subject's modifiers that count."""
    live: tuple
    """Those that play no bake."""
    opened: Any
    """The open subject of the object; None without a modifier."""


class Picture:
    """Fills the images and inputs of one live modifier at a moment. A subject has a class of its
    own."""

    key: tuple
    """The values that the whole picture depends on."""
    work = "maps"
    """The work on the whole, for the console."""
    may_wait = True
    """True if a draft may stand in for the whole."""
    begins_while_playing = True
    """True if the whole of a frame is worth its work while further frames play."""
    more_follows = False
    """True if the job goes on after the maps."""
    ends_draft = True
    """True if the whole picture is what a draft in the viewport waits for."""

    def __init__(self, shown: Shown, seen, modifier, moment: Moment) -> None:
        """seen: the object, evaluated."""
        self.shown, self.ob, self.opened = shown, shown.ob, shown.opened
        self.seen, self.modifier, self.moment = seen, modifier, moment
        self.prepare()

    def prepare(self) -> None:
        """Finds out what the picture shows, and sets its key."""
        raise NotImplementedError

    def is_ready(self) -> bool:
        """Returns whether the whole can be shown without a user waiting."""
        raise NotImplementedError

    def show_draft(self) -> None:
        raise NotImplementedError

    def show_whole(self) -> None:
        raise NotImplementedError

    def needs_mesh(self) -> bool:
        """Returns whether the mesh does not fit the whole picture yet."""
        return meshes.is_draft(self.ob.data)

    def set_inputs(self, *, draft: bool) -> None:
        """Sets the inputs beside the images."""


def _nothing(*_arguments, **_settings) -> None:
    """Stands for a step that a subject does not have."""


@dataclasses.dataclass(frozen=True, kw_only=True)
class Parameters:
    """How the parameters of a subject lie in an object's settings, and in the library's files."""

    settings: str
    """The attribute of an object that holds them."""
    items: str = ""
    """The collection of items among them; "": none."""
    words: Words
    """The words of their panel."""
    parse: Callable[..., Any]
    open_file: Callable[[str], Any]
    preset: Callable[[str], Any]
    """Return the library's handle of a text, a file, a preset. Raise libocean.Error."""
    read: Callable[[Any], Any]
    """Returns the values of a handle."""
    values_of: Callable[[Any, Any], Any]
    """Returns the values to show. Arguments: the object, evaluated or not, and the scene."""
    assign: Callable[[Any, Any], None]
    """Puts values into the properties of an object, and shows it."""

    def sentence(self, ob, failure: Exception) -> str:
        """Returns a failure of the library about an object in the words of its panel."""
        items = getattr(getattr(ob, self.settings), self.items, ())
        return self.words.of_error(failure, len(items))


@dataclasses.dataclass(frozen=True, kw_only=True)
class Subject:
    """A row: how one subject differs. Functions that say "objects" get a list of its objects."""

    name: str
    """Its name in the console: "sea"."""
    family: Family
    """Its node groups."""
    settings: str
    """The attribute of an object that says how it is shown, with `problem`."""
    parameters: Parameters
    listens: tuple[str, ...]
    """The names of the groups of properties whose changes show it again."""
    opened: OpenByObject
    """The open subjects, by object."""
    image_inputs: Callable[[Any], list[str]]
    """Returns the names of the inputs of images. Argument: a node group."""
    picture: Callable[..., Picture]
    """Returns the picture of a modifier. Arguments: shown, seen, modifier, moment."""
    job: Callable[..., Any]
    """Returns the job that makes the whole of an object; None without one. Argument: shown."""
    follow: Callable[..., None] = _nothing
    """Gives the open subject what it needs beside values. Arguments: shown, seen, depsgraph."""
    follow_mesh: Callable[..., None] = _nothing
    """Makes a mesh of the add-on fit. Arguments: shown; draft: with few vertices."""
    has_water: bool = False
    """True if floats and spray follow it."""
    float_pose: Callable[..., Any] | None = None
    """Returns the libocean.FloatPose of a body, None without water. Arguments: object, body,
    moment. Raises NotShownError, NotReadyError, libocean.Error. None: nothing floats."""
    is_in_world: Callable[[Any], bool] = lambda _ob: False
    """Returns whether the water lies in the world, however the object lies in it."""
    bake: Callable[..., Any] | None = None
    """Returns the bake_plan.Work that bakes an object. Arguments: context, object, folder, frames;
    overwrite. Raises BakeError. None: it has no bake."""
    taken: Callable[[], str] = lambda: ""
    """Returns the sentence on an object of the subject, which can show no other one."""
    place: Callable[..., None] = _nothing
    """Sets inputs of all modifiers, also while a bake plays. Arguments: shown, moment."""
    show_played: Callable[..., None] = _nothing
    """Shows what a bake needs beside its files. Argument: shown."""
    fault: Callable[[Any], str] = lambda _ob: ""
    """Returns a sentence on an object that is not shown as requested; "" otherwise."""
    before_change: Callable[..., Any] = _nothing
    """Follows settings that exchange node groups. Returns whether it did. Argument: shown."""
    after_change: Callable[..., Any] = _nothing
    """Keeps what a change brought. Returns whether to show the object again. Argument: shown."""
    sees_camera: Callable[[Any], bool] = lambda _ob: False
    """Returns whether an object follows the evaluated camera."""
    upgrade: Callable[[Any], None] = _nothing
    """Rewrites an object of an earlier version of the add-on."""
    parts: Callable[[Any], list] = lambda ob: [ob]
    """Returns the objects whose meshes show an object."""

    def look_up(self, ob) -> Shown:
        modifiers = tuple(self.family.modifiers(ob))
        live = tuple(m for m in modifiers if not is_baked(m.node_group))
        return Shown(self, ob, modifiers, live, self.opened.of(ob.name_full) if modifiers else None)

    def named(self, name: str) -> Shown | None:
        """Returns the object with that full name; None without one."""
        found = (ob for ob in self.family.objects() if ob.name_full == name)
        return next(map(self.look_up, found), None)


rows: list[Subject] = []
"""The subjects, in the order in which they are shown."""


def water_of(ob) -> Subject | None:
    """Returns the subject of an object on which things float; None for other objects."""
    water = (row for row in rows if row.float_pose is not None)
    return next((row for row in water if row.family.modifiers(ob)), None)


def that_bakes(ob) -> Subject | None:
    """Returns the subject of an object that can be baked; None for other objects."""
    return next((row for row in rows if row.bake is not None and row.family.modifiers(ob)), None)


def add(row: Subject) -> None:
    rows.append(row)


def remove(row: Subject) -> None:
    """Closes what is open of a subject, which is shown no more."""
    rows.remove(row)
    row.opened.close_all()
