# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Helpers of all panels: they never fail to draw, and their words fit a narrow editor."""

from __future__ import annotations

import functools

import bpy

from .. import translations
from . import compat, failures
from .compat import tr_label

# Pixels at a resolution scale of 1, counted in pictures of a properties editor.
NARROW = 285
"""The width of an editor's region below which a label beside its field would be cut. A window 1920
pixels wide begins with a width of 291, a window of 1400 with 204."""
_MARGIN = 48  # left and right of a line of text in a box
_ICON = 26
BUTTON = 26
"""The width of a button with an icon and no text."""
_ANY_WIDTH = 600  # where the width is unknown


def never_raises(draw):
    """Wraps a draw function so that an exception becomes a line of the panel: Blender would leave
    out the rest of the panel at every redraw. The console gets the traceback once."""

    @functools.wraps(draw)
    def drawn(self, context):  # Blender counts the arguments
        try:
            draw(self, context)
        except Exception as failure:
            say(self.layout, failures.sentence(failure), "ERROR")

    return drawn


def draws(fields, labels: bool = True):
    """Returns the draw function of a panel whose fields fields(layout, object, context) draws.
    labels: whether they are in their places before it does."""

    def draw(self, context) -> None:
        if labels:
            place_labels(self.layout)
        fields(self.layout, context.object, context)

    return never_raises(draw)


def width() -> float:
    """Returns the width of the region that is drawn [pixels at a resolution scale of 1]."""
    region = bpy.context.region
    if region is None:
        return _ANY_WIDTH
    return region.width / bpy.context.preferences.system.ui_scale


def is_narrow() -> bool:
    """Returns whether labels go into their fields, since a label beside its field would be cut."""
    return width() < NARROW


def place_labels(layout) -> None:
    """Has fields of a layout show their labels beside them or, where it is narrow, inside."""
    layout.use_property_split = not is_narrow()


_LABEL = 0.38  # of a row: the label before a list, a path or an object
_FIELD = 24  # pixels of a field beside its text: edges, arrow
_ROW = 35  # pixels of a region beside its rows
_ARROWS = 40  # pixels of a number's field beside its text


def _choices(owner, name: str) -> list[str]:
    """Returns the choices that a list shows; none for other properties."""
    found = owner.bl_rna.properties[name]
    if found.type != "ENUM":
        return []
    context = found.translation_context
    return [bpy.app.translations.pgettext_iface(item.name, context) for item in found.enum_items]


def widest(texts: list[str]) -> float:
    return max(map(compat.text_width, texts), default=0.0)


def beside(layout, text: str, choices: list[str]):
    """Returns the layout of a field without a label of its own in a narrow editor. Its label, in
    the user's language, is drawn before it or, if label or choices would be cut, above it."""
    row = width() - _ROW
    fits = compat.text_width(text) <= _LABEL * row - 8
    if fits and widest(choices) <= (1.0 - _LABEL) * row - _FIELD:
        split = layout.split(factor=_LABEL)
        split.label(text=text, translate=False)
        return split.row()
    column = layout.column(align=True)
    column.label(text=text, translate=False)
    return column


def field(layout, owner, name: str, *, text: str | None = None, context: str = "*") -> None:
    """Draws the field of a list, a path or an object, which has no place for a label inside. text:
    the label, in this context; None: the name of the property."""
    found = owner.bl_rna.properties[name]
    label, context = (found.name, found.translation_context) if text is None else (text, context)
    if not is_narrow():
        layout.prop(owner, name, text=label, text_ctxt=context)
        return
    label = bpy.app.translations.pgettext_iface(label, context)
    beside(layout, label, _choices(owner, name)).prop(owner, name, text="")


def number(layout, owner, name: str, text: str, context: str) -> None:
    """Draws the field of a number with a label of this context, in a narrow editor inside or, where
    label and value would be cut, above it."""
    found, value = owner.bl_rna.properties[name], getattr(owner, name)
    label = bpy.app.translations.pgettext_iface(text, context)
    shown = bpy.utils.units.to_string("METRIC", found.unit, value, precision=3)
    if found.type == "FLOAT" and found.unit == "NONE":
        shown = f"{value:.3f}"
    fits = compat.text_width(label + shown) <= width() - _ROW - _ARROWS
    if fits or not is_narrow():
        layout.prop(owner, name, text=text, text_ctxt=context)
        return
    column = layout.column(align=True)
    column.label(text=label, translate=False)
    column.prop(owner, name, text="")


def mask_field(layout, settings, ob) -> None:
    """Draws the field of a mask, which lists the vertex groups of the object."""
    if is_narrow():
        row = beside(layout, tr_label("Mask"), [])
        row.prop_search(settings, "mask", ob, "vertex_groups", text="")
    else:
        layout.prop_search(settings, "mask", ob, "vertex_groups")


def lines(text: str, space: float) -> list[str]:
    """Returns a sentence in lines that fit into so many pixels. A word that is too long alone, such
    as a path, is divided."""
    made, line = [], ""
    for word in text.split():
        joined = f"{line} {word}" if line else word
        if compat.text_width(joined) <= space:
            line = joined
            continue
        if line:
            made.append(line)
        line = word
        while compat.text_width(line) > space and len(line) > 1:
            fits = next(
                n
                for n in range(len(line) - 1, 0, -1)
                if n == 1 or compat.text_width(line[:n]) <= space
            )
            made.append(line[:fits])
            line = line[fits:]
    return [*made, line] if line else made


def say(layout, text: str, icon: str = "NONE", *, beside: float = 0.0) -> None:
    """Draws a sentence in as many lines as it needs. beside: pixels of its row that other widgets
    need."""
    space = width() - _MARGIN - beside - (0 if icon == "NONE" else _ICON)
    column = layout.column(align=True)
    for number, line in enumerate(lines(text, space)):
        mark = icon if number == 0 else "NONE" if icon == "NONE" else "BLANK1"
        column.label(text=line, icon=mark, translate=False)


def say_state(box, state: list[tuple[str, str]]) -> None:
    """Draws a line for each label and its text."""
    for label, text in state:
        if is_narrow():
            label = bpy.app.translations.pgettext_iface(label, translations.SEA)
            say(box, f"{label}: {text}")
            continue
        row = box.split(factor=0.62)
        row.label(text=label, text_ctxt=translations.SEA)
        row.label(text=text, translate=False)
