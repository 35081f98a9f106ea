# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The values of Object.libocean.hulls as those of a sea file, and back."""

from __future__ import annotations

from ..shared import property_texts
from ..shared.native import libocean
from ..shared.parameter_table import ParameterTable

HULLS = ParameterTable(
    rows=[row for row in libocean.parameters() if row["section"] == "hulls"],
    item_section="hulls",
    file_kind="Sea file",
    files=("track_file",),
    copies={"track_file": "track_lines"},
)


def texts_of(hulls) -> dict[str, str]:
    """Returns the values of hulls by the names that the library knows them by."""
    texts = {}
    for number, hull in enumerate(hulls):
        values = property_texts.texts_of(hull, HULLS, items=True)
        texts.update({f"hulls.{number}.{key}": text for key, text in values.items()})
        if hull.track_lines:
            texts[f"[hulls.{number}.track]"] = hull.track_lines
    return texts


def set_texts(hull, texts: dict[str, str], number: int) -> None:
    """Gives a hull the values of the one of that number."""
    keys = (entry["key"] for entry in HULLS.entries(items=True))
    values = {key: texts[f"hulls.{number}.{key}"] for key in keys}
    property_texts.set_texts(hull, values, HULLS, items=True)
    hull.track_lines = texts.get(f"[hulls.{number}.track]", "")


def assign(group, texts: dict[str, str]) -> None:
    """Puts the hulls of a file into the settings of a sea. The hulls of objects stay beside a file
    that has none."""
    if not texts:
        for number in reversed(range(len(group.hulls))):
            if group.hulls[number].source is None:
                group.hulls.remove(number)
    else:
        group.hulls.clear()
        count = sum(name.endswith(".length") for name in texts)
        for number in range(count):
            hull = group.hulls.add()
            hull.name = f"Hull {number + 1}"
            set_texts(hull, texts, number)
    group.active_hull = min(group.active_hull, max(0, len(group.hulls) - 1))
