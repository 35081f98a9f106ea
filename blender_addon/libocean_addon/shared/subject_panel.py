# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the panels of all subjects share: the panel below a modifier, the row of files, the lines on
problems and facts, and settings of an object that change what it shows unseen."""

from __future__ import annotations

from collections.abc import Iterable

from .. import translations
from .drawing import is_narrow, say, say_state

_EVEN = 1e-4  # of scales that are meant to be one


class ModifierPanel:
    """A panel that objects with one of the add-on's modifiers have."""

    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "modifier"

    @staticmethod
    def modifiers(shown) -> list:
        """Returns the modifiers of an object that have the panel; a subclass says which."""
        raise NotImplementedError

    @classmethod
    def poll(cls, context) -> bool:
        return context.object is not None and bool(cls.modifiers(context.object))


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
