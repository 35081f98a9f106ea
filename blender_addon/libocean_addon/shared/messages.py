# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences of the library in the words of a panel: labels of fields replace the paths of
parameters.
"""

from __future__ import annotations

import re

import bpy

from .. import translations
from .compat import tr_label
from .native import libocean
from .parameter_table import ParameterTable, path_of


class Words:
    """The words of a subject's panel, by its table.

    Items are the tables of which a file may have several, such as wave systems; of several, a field
    is named with the number that its list shows.
    """

    def __init__(self, table: ParameterTable) -> None:
        self._labels = {path_of(row): row["label"] for row in table.rows}
        self._items = table.item_section
        sections = {path.rpartition(".")[0] for path in self._labels} - {self._items}
        items = re.escape(self._items)
        # A parameter's path in prose; in quotes or behind a slash it is a part of a file's name.
        words = "|".join([rf"{items}\.\d+", *map(re.escape, sorted(sections, reverse=True))])
        self._path = re.compile(rf"(?<![^\s(])(?:{words})\.[a-z_]+\b")
        self._item_path = re.compile(rf"({items})\.(\d+)\.([a-z_]+)")

    def label_of(self, path: str, items: int = 1) -> str:
        """Returns the label of the field of a parameter, such as waves.1.fetch; other paths as they
        are. items: the number of items of the subject."""
        number, of_table = None, path
        of_item = self._item_path.fullmatch(path)
        if of_item:
            section, number, key = of_item.groups()
            of_table = f"{section}.{key}"
        if of_table not in self._labels:
            return path
        label = bpy.app.translations.pgettext_iface(self._labels[of_table], translations.SEA)
        return f"{label} ({int(number) + 1})" if number is not None and items > 1 else label

    def in_words(self, text: str, items: int = 1) -> str:
        """Returns prose of the library, such as a warning, with labels for the parameters that it
        names."""
        return self._path.sub(lambda found: self.label_of(found.group(), items), text)

    def of_error(self, failure: Exception, items: int = 1) -> str:
        """Returns the sentence of a panel on an error of the library or a lack of memory. If the
        value of a field is wrong, the sentence is put together from the library's parts: label,
        value, fault and allowed values."""
        if isinstance(failure, MemoryError) and not _has_numbers(failure):
            return tr_label("There is not enough memory: choose fewer samples")
        parameter = getattr(failure, "parameter", "")
        text = self.label_of(parameter, items)
        if text == parameter or not failure.value:
            return self.in_words(str(failure), items)
        text += f" = {failure.value}"
        if failure.what:
            # A text in quotes is the user's, wherever the library repeats it.
            own = failure.value[1:-1] if failure.value.startswith('"') else ""
            parts = failure.what.split(own) if own else [failure.what]
            text += ": " + own.join(self.in_words(part, items) for part in parts)
        if not failure.allowed:
            return text
        return f"{text}; allowed: {self.in_words(failure.allowed, items)}"


def _has_numbers(failure: MemoryError) -> bool:
    """Returns whether a lack of memory is an error of the library that says how many bytes are
    needed, and available."""
    return isinstance(failure, libocean.Error) and str(failure) != "out of memory"


def of_file(failure: OSError) -> str:
    """Returns the system's message about a file, without its number."""
    return f"{failure.filename}: {failure.strerror}" if failure.filename else str(failure)
