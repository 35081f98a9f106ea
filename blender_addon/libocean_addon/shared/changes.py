# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Who hears of properties that were set: one listener, and silence while many are set at once."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator

import bpy

listener: Callable[[bpy.types.Object], None] | None = None
"""Told of each object whose properties were set."""

_silence = 0


@contextlib.contextmanager
def quiet() -> Iterator[None]:
    """Many properties are set: the listener hears of it when somebody tells it."""
    global _silence
    _silence += 1
    try:
        yield
    finally:
        _silence -= 1


def is_quiet() -> bool:
    return _silence > 0


def tell(ob) -> None:
    if listener is not None and not is_quiet():
        listener(ob)
