# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ocean: an object with an ocean, looked up once for a change or a frame and handed on, so that no
module asks again which modifiers count."""

from __future__ import annotations

import dataclasses
from typing import Any

from . import node_group
from .open_sea import OpenSea, sea_of


@dataclasses.dataclass(frozen=True)
class Ocean:
    """Not kept from call to call: Blender's data may go at any time."""

    ob: Any
    modifiers: tuple
    """The ocean modifiers that count."""
    sea: OpenSea

    @property
    def live(self) -> list:
        """The modifiers that play no bake."""
        return [m for m in self.modifiers if not node_group.is_baked(m.node_group)]


def look_up(ob) -> Ocean:
    return Ocean(ob, tuple(node_group.modifiers(ob)), sea_of(ob.name_full))
