# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the library has open for each object of a kind, by the object's full name."""

from __future__ import annotations

from collections.abc import Callable
from typing import Generic, Protocol, TypeVar


class Opened(Protocol):
    """What is open for one object."""

    def forget_images(self) -> None:
        """Forgets the content of images."""

    def close(self) -> None: ...


T = TypeVar("T", bound=Opened)


class OpenByObject(Generic[T]):
    def __init__(self, make: Callable[[], T]) -> None:
        self._make = make
        self._opened: dict[str, T] = {}

    def of(self, name: str) -> T:
        """Returns the open subject of the object with that full name, opened if it is missing."""
        if name not in self._opened:
            self._opened[name] = self._make()
        return self._opened[name]

    def forget(self, names: set[str]) -> None:
        """Forgets the content of images, after undo and loading, and closes the subjects of objects
        without one of these names."""
        for name in list(self._opened):
            if name in names:
                self._opened[name].forget_images()
            else:
                self._opened.pop(name).close()

    def close_all(self) -> None:
        for opened in self._opened.values():
            opened.close()
        self._opened.clear()
