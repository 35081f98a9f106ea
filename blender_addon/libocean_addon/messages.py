# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the library says, in the words of the panel: labels of fields where it names parameters by
their paths, and no lines of a text that nobody sees.
"""

from __future__ import annotations

import re

import bpy

from . import parameter_values, sea_text, translations
from .compat import tr
from .native import libocean

_LABELS = {entry["key"]: entry["label"] for entry in parameter_values.TABLE}
_SECTIONS = sorted({entry["section"] for entry in parameter_values.TABLE} - {"waves"})
_PATH = re.compile(rf"\b(?:waves\.(\d+)|{'|'.join(_SECTIONS)})\.([a-z_]+)\b")
_LINE = re.compile(r"\btext:\d+: ")


def _label(found: re.Match, systems: int) -> str:
    number, key = found.groups()
    if key not in _LABELS:
        return found.group()
    label = bpy.app.translations.pgettext_iface(_LABELS[key], translations.SEA)
    return f"{label} ({int(number) + 1})" if number and systems > 1 else label


def in_words(text: str, systems: int = 1) -> str:
    """A message or warning of the library. systems: how many wave systems the sea has; of several,
    a field is named with the number that its list shows."""
    return _PATH.sub(lambda found: _label(found, systems), _LINE.sub("", text))


def of_file(failure: OSError) -> str:
    """What the system says of a file, without the number of it."""
    return f"{failure.filename}: {failure.strerror}" if failure.filename else str(failure)


def of_field(failure: Exception, changed: dict[str, str]) -> str:
    """What the library says of values that were set: of a file it says no more than its name."""
    text = str(failure)
    named = [name for name, value in changed.items() if value and value in text]
    if _PATH.search(text) or not named:
        return text
    name = max(named, key=lambda name: len(changed[name]))
    sections = [entry["section"] for entry in parameter_values.TABLE if entry["key"] == name]
    path = ".".join([*sections, name])  # those of waves have theirs: waves.1.file
    return f'{path} = "{changed[name]}": {text}'


def require_files(values: sea_text.SeaValues) -> None:
    """Raises libocean.Error for a measured spectrum that nobody has measured."""
    for system in values.waves:
        if system.values["spectrum"] == "measured" and not (system.values["file"] or system.record):
            raise libocean.Error(tr("A measured spectrum needs a file: choose one below"), 0)
