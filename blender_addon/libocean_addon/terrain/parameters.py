# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The parameters of a terrain by the library's table, and its words about them."""

from __future__ import annotations

from typing import Any

from ..shared.messages import Words
from ..shared.native import libocean
from ..shared.parameter_table import ParameterTable, path_of
from ..shared.resolutions import Resolutions

PAIRS = 8  # of breaks, at most; also the max number of layers

SWITCHES = {
    "gullies": ("terrain.gullies", "depth"),
    "stream": ("terrain.stream", "slope"),
    "coast": ("terrain.coast", "slope"),
}
"""The section of each group of parameters that shape a land, and the key that is 0 where it is
off. Properties of a group begin with its name: coast_slope."""

_NAMES = {section: name for name, (section, _) in SWITCHES.items()}


def switch_of(group: str) -> str:
    """Returns the property that is 0 where a group is off."""
    return f"{group}_{SWITCHES[group][1]}"


def _rows() -> list[dict[str, Any]]:
    """Returns the library's rows; rows of a group have the names of their properties."""
    rows = libocean.terrain_parameters()
    for row in rows:
        if row["section"] in _NAMES:
            row["path"] = f"{row['section']}.{row['key']}"
            row["key"] = f"{_NAMES[row['section']]}_{row['key']}"
    return rows


def _typical(section: str, key: str) -> float:
    """Returns the value of a group's switch in a file that sets nothing else in the section."""
    text = f'libocean = 1\n[terrain]\nkind = "placed"\n[{section}]\n'
    with libocean.parse_terrain(text) as terrain:
        return float(terrain.get(f"{section}.{key}"))


TYPICAL = {name: _typical(*switch) for name, switch in SWITCHES.items()}

PARAMETERS = ParameterTable(
    rows=_rows(),
    item_section="terrain.layer",
    file_kind="Terrain file",
    files=("measured", "base"),
    copies={"measured": "measured_rings"},
    resolutions={"resolution": ""},
    lengths={"breaks": PAIRS},
)

PLACED = ("origin", "size", "island", "base", "base_error", "detail_wavelength")
"""Parameters that only a land that exists once has."""


def _defaults() -> dict[str, str]:
    """Returns the values of a file that sets none, by property."""
    with libocean.parse_terrain("libocean = 1\n[terrain]\n") as terrain:
        return {row["key"]: terrain.get(path_of(row)) for row in PARAMETERS.entries(items=False)}


DEFAULTS = _defaults()

RESOLUTIONS = Resolutions(PARAMETERS, "As the terrain, at most 512 along a tile")

WORDS = Words(PARAMETERS)
