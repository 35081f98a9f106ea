# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The subjects of the add-on, in the order in which they are shown."""

from __future__ import annotations

from .coast.subject import COAST
from .sea.subject import SEA
from .shared import subject
from .terrain.subject import TERRAIN

ROWS = (SEA, TERRAIN, COAST)


def register() -> None:
    for row in ROWS:
        subject.add(row)


def unregister() -> None:
    for row in ROWS:
        subject.remove(row)
