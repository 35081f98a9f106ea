# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The parameters of a terrain by the library's table, and its words about them."""

from __future__ import annotations

from ..shared.messages import Words
from ..shared.native import libocean
from ..shared.parameter_table import ParameterTable
from ..shared.resolutions import Resolutions

PAIRS = 8  # of breaks, at most; also the max number of layers

PARAMETERS = ParameterTable(
    rows=libocean.terrain_parameters(),
    item_section="terrain.layer",
    file_kind="Terrain file",
    files=("measured",),
    copies={"measured": "measured_rings"},
    resolutions={"resolution": ""},
    lengths={"breaks": PAIRS},
)

RESOLUTIONS = Resolutions(PARAMETERS, "As the terrain, at most 512 along a tile")

WORDS = Words(PARAMETERS)
