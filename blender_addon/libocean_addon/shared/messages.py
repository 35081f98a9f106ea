# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences of the library in the words of the panel: labels of fields replace the paths of
parameters.
"""

from __future__ import annotations

import re

import bpy

from .. import translations
from ..sea import parameter_values, sea_text
from .compat import tr
from .native import libocean

_LABELS = {(entry["section"], entry["key"]): entry["label"] for entry in parameter_values.TABLE}
_SECTIONS = "|".join(sorted({section for section, _ in _LABELS} - {"waves"}))
_PATH = re.compile(rf"(?<![^\s(])(?:waves\.\d+|{_SECTIONS})\.[a-z_]+\b")
"""A parameter's path in prose; in quotes or behind a slash it is a part of a file's name."""


def label_of(path: str, systems: int = 1) -> str:
    """The label of the field of a parameter, such as waves.1.fetch; other paths as they are.
    systems: how many wave systems the sea has; of several, a field is named with the number that
    its list shows."""
    section, _, key = path.partition(".")
    number, _, key_of_system = key.partition(".")
    if key_of_system:
        key = key_of_system
    if (section, key) not in _LABELS:
        return path
    label = bpy.app.translations.pgettext_iface(_LABELS[section, key], translations.SEA)
    return f"{label} ({int(number) + 1})" if key_of_system and systems > 1 else label


def in_words(text: str, systems: int = 1) -> str:
    """Prose of the library, such as a warning, with labels for the parameters that it names."""
    return _PATH.sub(lambda found: label_of(found.group(), systems), text)


def of_error(failure: Exception, systems: int = 1) -> str:
    """Returns the sentence of a failure. If the value of a field is wrong it is put together from
    the library's parts: label, value, fault and allowed values."""
    parameter = getattr(failure, "parameter", "")
    text = label_of(parameter, systems)
    if text == parameter or not failure.value:
        return in_words(str(failure), systems)
    text += f" = {failure.value}"
    if failure.what:
        # A text in quotes is the user's, wherever the library says it again.
        own = failure.value[1:-1] if failure.value.startswith('"') else ""
        parts = failure.what.split(own) if own else [failure.what]
        text += ": " + own.join(in_words(part, systems) for part in parts)
    return f"{text}; allowed: {failure.allowed}" if failure.allowed else text


def of_file(failure: OSError) -> str:
    """Returns the system's message about a file, without its number."""
    return f"{failure.filename}: {failure.strerror}" if failure.filename else str(failure)


def require_files(values: sea_text.SeaValues) -> None:
    """Raises libocean.Error for a measured spectrum without a file or record."""
    for system in values.waves:
        if system.values["spectrum"] == "measured" and not (system.values["file"] or system.record):
            raise libocean.Error(tr("A measured spectrum needs a file: choose one below"), 0)
