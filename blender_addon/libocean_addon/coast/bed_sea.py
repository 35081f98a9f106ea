# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The library's handle of a sea over a bed, which stays while values change: the library makes
again only what they dirty. No Blender's data in here: one thread at a time has it.

    SeaValues -> adopt: set, or parsed anew for another bed -> sea, state, extent of the bed
"""

from __future__ import annotations

import json

from ..sea.sea_text import SeaValues
from ..shared import drafts
from ..shared.compat import tr
from ..shared.native import libocean
from ..terrain.extent import Extent


def extent_of(origin: str, state: dict) -> Extent:
    """Returns the samples of a bed. origin: seabed_origin of its sea; state: of that."""
    bed = state["bed"]
    origin = json.loads(origin) or [0.0, 0.0]
    return Extent(tuple(map(float, origin)), float(bed["cell"]), tuple(bed["samples"]), False)


class BedSea:
    """A handle, with state and extent of its sea."""

    def __init__(self) -> None:
        self.sea = None
        self.values: SeaValues | None = None
        """The values of the handle; None before the first ones and after a failure."""
        self.state: dict | None = None
        self.own: Extent | None = None
        """The samples of the bed."""

    def adopt(self, values: SeaValues, base_dir: str | None) -> None:
        """Gives the handle these values. base_dir: the folder of relative paths. Raises
        libocean.Error; the next call opens the handle anew then."""
        if values == self.values:
            return
        before, self.values = self.values, None
        if before is not None and values.structure() == before.structure():
            self.sea.set_all(dict(values.by_name().items() - before.by_name().items()))
        else:
            opened = libocean.parse(
                values.text(), base_dir=base_dir, progress=drafts.tell_watcher_of_part
            )
            self.close()
            self.sea = opened
        state = self.sea.state
        if "bed" not in state:
            raise libocean.Error(
                tr(
                    "The sea has no bed: choose a terrain file or an elevation model for Sea bed, "
                    "or load a sea that has one"
                ),
                0,
            )
        self.own = extent_of(values.values["seabed_origin"], state)
        self.values, self.state = values, state

    def close(self) -> None:
        if self.sea is not None:
            self.sea.close()
        self.sea = None
