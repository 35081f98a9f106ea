# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""ReadOnly, whose names nobody assigns by mistake: a parameter is no attribute."""

from __future__ import annotations

from typing import Any


class ReadOnly:
    """Base of a class whose instances take assignments to their own names alone, which begin with
    an underscore."""

    _noun: str
    _instead: str
    """The way that has an effect, with {name} and {value!r} of the assignment."""

    def __setattr__(self, name: str, value: Any) -> None:
        if not name.startswith("_"):
            instead = self._instead.format(name=name, value=value)
            raise AttributeError(f"'{name}' of a {self._noun} cannot be assigned; {instead}")
        super().__setattr__(name, value)
