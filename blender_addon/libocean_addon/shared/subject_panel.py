# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the panels of all subjects share: how they are made, the row of files, the lines on
problems and facts, and settings of an object that change what it shows unseen."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import bpy

from .. import translations
from .drawing import draws, is_narrow, say, say_state

_EVEN = 1e-4  # of scales that are meant to be one


class Panels:
    """The panels of objects with one of the add-on's modifiers or settings, made by add() out of
    functions that draw them. `classes` are those that Blender registers; the first one is the
    parent of those that name no other."""

    def __init__(self, has: Callable, settings: str = "", place: str = "modifier") -> None:
        """has(object): whether it has them, such as its modifiers of a subject. settings: the
        attribute of an object that has the properties of switches. place: Blender's word for the
        tab of the editor."""
        self.has, self.settings, self.place = has, settings, place
        self.classes: list[type] = []

    def add(
        self,
        name: str,
        label: str,
        *,
        parent: str = "",
        closed: bool = True,
        labels: bool = True,
        switch: str = "",
        where: Callable = lambda _ob: True,
    ) -> Callable[[Callable], type]:
        """Returns what makes fields(layout, object, context) the panel LIBOCEAN_PT_name. parent:
        the end of another one's name. labels: whether they are in their places before it draws.
        switch: the property in its header. where(object): whether an object has it."""

        def made(fields: Callable) -> type:
            class Panel(bpy.types.Panel):
                __doc__ = fields.__doc__
                bl_idname = f"LIBOCEAN_PT_{name}"
                bl_label = label
                bl_options = {"DEFAULT_CLOSED"} if closed else set()
                bl_space_type = "PROPERTIES"
                bl_region_type = "WINDOW"
                bl_context = self.place
                draw = draws(fields, labels)

                @classmethod
                def poll(cls, context) -> bool:
                    ob = context.object
                    return ob is not None and bool(self.has(ob) and where(ob))

            def header(layout, ob, _context) -> None:
                layout.prop(getattr(ob, self.settings), switch, text="")

            if parent:
                Panel.bl_parent_id = f"LIBOCEAN_PT_{parent}"
            elif self.classes:
                Panel.bl_parent_id = self.classes[0].bl_idname
            if switch:
                Panel.draw_header = draws(header, labels=False)
            self.classes.append(Panel)
            return Panel

        return made


def draw_files(layout, preset, *, load, save) -> None:
    """Draws the menu of presets and the buttons of files, by their operators; where it is narrow
    the buttons below the menu."""
    row = layout.column(align=True) if is_narrow() else layout.row(align=True)
    row.operator_menu_enum(preset.bl_idname, "preset", text="Preset", text_ctxt=translations.SEA)
    if is_narrow():
        row = row.row(align=True)
    row.operator(load.bl_idname, text="Load", icon="IMPORT")
    row.operator(save.bl_idname, text="Save", icon="EXPORT")


def draw_problems(layout, scene, problems: Iterable[str], of_units: str) -> None:
    """Draws sentences on what is not shown as requested. of_units: the sentence on a scene whose
    units are no metres."""
    for text in filter(None, problems):
        say(layout, text, "ERROR")
    if scene.unit_settings.scale_length != 1.0:
        say(layout, of_units, "INFO")


def draw_facts(layout, ob, facts) -> None:
    """Draws the facts about an object: state_of, sizes_of and warnings_of of the module `facts`;
    nothing before there is a state."""
    state = facts.state_of(ob)
    if state is None:
        return
    box = layout.box().column(align=True)
    say_state(box, state)
    for text in facts.sizes_of(ob):
        say(box, text)
    for text in facts.warnings_of(ob):
        say(box, text, "ERROR")


def uniform_scale(ob) -> float | None:
    """Returns the factor by which an object is larger than its data, 1.0 if it is meant to be one;
    None if its sides are scaled unevenly."""
    scale = [abs(part) for part in ob.matrix_world.to_scale()]
    if max(scale) - min(scale) > _EVEN * max(scale):
        return None
    return scale[0] if abs(scale[0] - 1.0) > _EVEN else 1.0


def lacks_mask(ob, seen, mask: str) -> bool:
    """Returns whether a mask is neither a vertex group nor an attribute. seen: the object,
    evaluated."""
    if not mask or mask in ob.vertex_groups:
        return False
    meshes_of = [data for data in (ob.data, seen.data) if hasattr(data, "attributes")]
    return not any(mask in data.attributes for data in meshes_of)
