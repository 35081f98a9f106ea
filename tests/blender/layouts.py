# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Layouts in the place of Blender's: one notes what a panel draws, one whether it fits a narrow
editor."""

import contextlib
import types

import bpy
from libocean_addon.shared import compat, drawing


class Layout:
    """Takes what is drawn: names of properties and operators, texts."""

    def __init__(self, drawn: list) -> None:
        self.drawn = drawn

    def prop(self, owner, name, **settings):
        assert name in owner.bl_rna.properties
        getattr(owner, name)
        self.drawn.append(name)

    def operator(self, name, **_settings):
        self.drawn.append(name)
        return types.SimpleNamespace()

    def label(self, *, text, **_settings):
        self.drawn.append(text)

    def prop_search(self, owner, name, *_rest):
        self.prop(owner, name)

    def __getattr__(self, name):
        if name in ("row", "column", "box", "split"):
            return lambda **_settings: Layout(self.drawn)
        return lambda *_rest, **_settings: None  # separator, template_list, operator_menu_enum


# Pixels at a resolution scale of 1; the editor's region in a window of 1280 and one of 1920, as
# Blender lays it out at first.
NARROW, WIDE = 192, 291
ROW = NARROW - 33  # counted in a picture of it, as are these:
ICON, CHECKBOX, ARROWS, EDGES = 19, 25, 40, 8


class NarrowLayout:
    """Takes what is drawn and compares the widths of words with their space, as Blender divides
    it."""

    def __init__(self, cut: list, space: float, *, share=None, split=False) -> None:
        self.cut, self.space, self.share = cut, space, share
        self.use_property_split = split
        self.is_column = False

    def _child(self, space: float, share: float | None = None):
        return NarrowLayout(self.cut, space, share=share, split=self.use_property_split)

    def _room(self) -> float:
        """Returns the space of the next widget."""
        if self.share is None:
            return self.space
        room = self.space * self.share
        self.space, self.share = self.space - room, None
        return room

    def _take(self, text: str, beside: float) -> None:
        room = self._room()
        if compat.text_width(text) + beside > room:
            self.cut.append(f"{text!r}: {compat.text_width(text):.0f} + {beside:.0f} > {room:.0f}")

    def label(self, *, text="", icon="NONE", text_ctxt="*", translate=True):
        text = bpy.app.translations.pgettext_iface(text, text_ctxt) if translate else text
        self._take(text, 0 if icon == "NONE" else ICON)

    def operator(self, name, *, text=None, icon="NONE"):
        if text is None:
            text = getattr(bpy.types, name.replace("libocean.", "LIBOCEAN_OT_")).bl_label
        word = bpy.app.translations.pgettext_iface(text, "Operator")
        if word:
            self._take(word, EDGES + (0 if icon == "NONE" else ICON))
        return types.SimpleNamespace()

    def operator_menu_enum(self, _name, _property, *, text, icon="NONE", text_ctxt="*"):
        word = bpy.app.translations.pgettext_iface(text, text_ctxt)
        self._take(word, EDGES + 15 + (0 if icon == "NONE" else ICON))

    def prop(self, owner, name, *, text=None, text_ctxt=None, index=-1):
        found = owner.bl_rna.properties[name]
        is_array = getattr(found, "is_array", False) and index < 0
        label, context = (
            (found.name, found.translation_context) if text is None else (text, text_ctxt)
        )
        word = bpy.app.translations.pgettext_iface(label, context or "*")
        if self.use_property_split and word and found.type != "BOOLEAN":
            self._take(word, 2 * self.space / 3)
        elif found.type == "BOOLEAN":
            if word:
                self._take(word, CHECKBOX)
            else:
                self.space -= CHECKBOX
        elif found.type in ("INT", "FLOAT") and not is_array:
            value = getattr(owner, name) if index < 0 else getattr(owner, name)[index]
            shown = bpy.utils.units.to_string("METRIC", found.unit, value, precision=3)
            if found.type == "FLOAT" and found.unit == "NONE" and abs(value) < 1e4:
                shown = f"{value:.3f}"
            self._take(word + shown, ARROWS)
        elif word and not (is_array and self.is_column):
            self.cut.append(f"{word!r} has no place beside the {found.type} of {name}")

    def prop_search(self, owner, name, _data, _found, *, text=None):
        self.prop(owner, name, text=text)

    def row(self, *, heading="", **_settings):
        if heading:
            self.cut.append(f"{heading!r} has no place beside its row")
        return self._child(self._room())

    def column(self, *, heading="", **_settings):  # above the column
        self._take(bpy.app.translations.pgettext_iface(heading), 0)
        column = self._child(self._room())
        column.is_column = True
        return column

    def box(self):
        return self._child(self._room() - 8)

    def split(self, *, factor, **_settings):
        return self._child(self._room(), factor)

    def separator(self):
        pass

    def template_list(self, *_rest, **_settings):
        pass


def shown_in(layout, cls):
    """A panel of that class as its draw function sees it."""
    return types.SimpleNamespace(layout=layout, group=getattr(cls, "group", ""))


def drawn_by(*classes) -> list[str]:
    """Returns the widgets that panels draw; raises where they would."""
    drawn: list[str] = []
    for cls in classes:
        cls.draw.__wrapped__(shown_in(Layout(drawn), cls), bpy.context)
    return drawn


def cut_in(*classes) -> list[str]:
    """Returns the words of panels that a narrow editor cuts."""
    cut: list[str] = []
    for cls in classes:
        cls.draw.__wrapped__(shown_in(NarrowLayout(cut, ROW), cls), bpy.context)
    return cut


@contextlib.contextmanager
def narrow_editor(language: str, monkeypatch):
    """Has panels be drawn for an editor of NARROW pixels in a language."""
    monkeypatch.setattr(drawing, "width", lambda: NARROW)
    view = bpy.context.preferences.view
    view.language, view.use_translate_interface = language, True
    yield
    view.language = "en_US"
