# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Exceptions that nothing expects, such as faults of the add-on itself: a panel shows a sentence,
and the console the traceback, once each."""

from __future__ import annotations

import functools
import traceback

from .compat import tr_label

_logged: set[str] = set()


class NotShownError(Exception):
    """An object cannot be shown as its settings say, in a sentence for the user."""


class NotReadyError(Exception):
    """The answer is still in the making, and the caller does not wait for it."""


def sentence(failure: Exception) -> str:
    """Returns the sentence of a panel on an exception, and prints its traceback unless that was
    done before."""
    text = f"{type(failure).__name__}: {failure}"
    if text not in _logged:
        _logged.add(text)
        traceback.print_exception(failure)
    return tr_label("This cannot be shown: {}", text)


def log_once(handler):
    """Wraps a handler of Blender, which would print the same traceback at every frame."""

    @functools.wraps(handler)
    def handled(*arguments) -> None:
        try:
            handler(*arguments)
        except Exception as failure:
            sentence(failure)

    return handled
