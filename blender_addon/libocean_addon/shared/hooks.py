# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The functions of modules above that modules below call: one value, connected when the add-on
registers. So no module imports one that imports it.

    handlers.register -> connect(Hooks(...)) -> changes, drafts, life: connected()
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any


@dataclasses.dataclass(frozen=True, kw_only=True)
class Hooks:
    """Each of them is required: a module that is left out fails when the add-on registers."""

    property_changed: Callable[[Any, str], None]
    """Shows an object whose properties were set, in the group of this name."""
    make_draft_job: Callable[[str], Any]
    """Returns the job of the whole subject of an object, by its full name; None without a job."""
    finish_draft_job: Callable[[str, Any], None]
    """Shows the whole subject of a job that has ended."""
    followers: tuple[Callable[[Any, Any], None], ...]
    """Called with the depsgraph, or None, and the moment, after the seas of a scene were shown."""


_NONE = Hooks(
    property_changed=lambda _ob, _name: None,
    make_draft_job=lambda _name: None,
    finish_draft_job=lambda _name, job: job.close(),
    followers=(),
)
_connected = _NONE


def connect(hooks: Hooks) -> None:
    global _connected
    _connected = hooks


def disconnect() -> None:
    connect(_NONE)


def connected() -> Hooks:
    """Returns the connected functions; before connect and after disconnect some that do nothing."""
    return _connected
