# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The words of the interface in other languages, by the English ones in the sources.

Blender looks up itself what it draws: names of properties, choices, panels and operators. What is
made of parts (reports, states) is looked up by compat.tr and compat.tr_label. Tool tips are in
English for now, and so is what the library itself says. Names of data, which scripts look for, and
proper names (Beaufort 5, Jerlov II) are not translated.
"""

from __future__ import annotations

import json
import re
from pathlib import Path

import bpy

SEA = "libocean"
"""Context of the terms of seas and terrains: in "*" Blender's own words come first, for "Fetch"
those of fetching something. They are in "*" too, where older versions look up a property's
choices."""

Words = dict[tuple[str, str], str]
"""Translated texts by their context and the English text, as Blender takes them."""

ENTRY = re.compile(r'^(?:msgctxt "(.*)"\n)?msgid (".*")\nmsgstr (".*")$', re.MULTILINE)


def read_po(path: Path) -> Words:
    """Reads a file of gettext, in which a text without a context is one of "*"."""
    one_line_each = path.read_text(encoding="utf-8").replace('"\n"', "")
    words = {
        (context or "*", json.loads(english)): json.loads(translated)
        for context, english, translated in ENTRY.findall(one_line_each)
    }
    # The header is an entry of "", and "" stands where a translation is still missing.
    return {key: text for key, text in words.items() if key[1] and text}


GERMAN = read_po(Path(__file__).with_name("de.po"))
TABLE = {
    "de_DE": {("*", english): text for (context, english), text in GERMAN.items() if context == SEA}
    | GERMAN
}


def register() -> None:
    bpy.app.translations.register(__package__, TABLE)


def unregister() -> None:
    bpy.app.translations.unregister(__package__)
