# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The values of Object.libocean as those of a sea file, and back."""

from __future__ import annotations

from typing import Any

from ..shared import changes, property_texts
from ..shared.native import libocean
from ..shared.parameter_table import ParameterTable, is_optional
from . import crests, hull_values, sea_text

TABLE: list[dict[str, Any]] = [
    row for row in libocean.parameters() if row["section"] not in {"crests", "hulls"}
]
"""The parameters that are properties of a sea and of its wave systems."""

DIVISORS = 5  # of a list of cascades, at most

PARAMETERS = ParameterTable(
    rows=TABLE,
    item_section="waves",
    file_kind="Sea file",
    files=("seabed", "file", "take"),
    copies={
        "seabed": "bed_lines",
        "take": "take_lines",
        "file": "measured_record",
        "record": "measured_record",
        "place": "measured_record",
    },
    resolutions={"resolution": "", "foam_resolution": "Automatic"},
    lengths={"cascade_divisors": DIVISORS},
)


def entries(*, waves: bool) -> list[dict[str, Any]]:
    return PARAMETERS.entries(items=waves)


def values_of(group, fps: str = "") -> sea_text.SeaValues:
    """Returns the values of the properties. group: Object.libocean, evaluated or not; fps: frames a
    second in place of the group's own."""
    values = property_texts.texts_of(group, PARAMETERS, items=False)
    values["fps"] = fps or values["fps"]
    return sea_text.SeaValues(
        values,
        [
            sea_text.WaveValues(
                property_texts.texts_of(system, PARAMETERS, items=True), system.measured_record
            )
            for system in group.waves
        ],
        group.take_lines,
        group.bed_lines,
        crests.values_of(group, values),
        hull_values.texts_of(group.hulls),
    )


def switch_on_given(group) -> None:
    """Switches on the parameters that have a value but no switch: files of add-ons for which they
    were never left out."""
    for owner, waves in [(group, False), *((system, True) for system in group.waves)]:
        for entry in entries(waves=waves):
            key, switch = entry["key"], f"use_{entry['key']}"
            if not is_optional(entry) or owner.is_property_set(switch):
                continue
            if owner.is_property_set(key):
                setattr(owner, switch, True)


def assign(group, sea: sea_text.SeaValues) -> None:
    """Puts a sea into the properties."""
    own_crests = values_of(group).crests
    with changes.quiet():
        group.exact = ""
        group.take_lines = sea.take
        group.bed_lines = sea.bed
        hull_values.assign(group, sea.hulls)
        property_texts.set_texts(group, sea.values, PARAMETERS, items=False)
        group.waves.clear()
        for system in sea.waves:
            added = group.waves.add()
            added.measured_record = system.record
            property_texts.set_texts(added, system.values, PARAMETERS, items=True)
        group.active_wave = 0
        if sea.crests != own_crests:
            crests.assign(group, sea)
    changes.tell(group)
