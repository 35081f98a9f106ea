# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Changes of properties are reported, but not while many are set at once."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator

from . import hooks

_silence = 0


@contextlib.contextmanager
def quiet() -> Iterator[None]:
    """Keeps changes from being reported while many properties are set; `tell` reports them."""
    global _silence
    _silence += 1
    try:
        yield
    finally:
        _silence -= 1


def is_quiet() -> bool:
    return _silence > 0


def tell(group) -> None:
    """Has an object shown whose properties were set. group: its group of properties, which has the
    attribute `subject`."""
    if not is_quiet():
        hooks.connected().property_changed(group.id_data, group.subject)
