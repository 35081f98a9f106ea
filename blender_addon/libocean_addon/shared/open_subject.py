# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The open subject of an object: the library's handle, the values that it has, and the content of
the object's images.

    values -> OpenSubject.follow -> handle, changes; maps -> put -> images
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any, Generic, Protocol, TypeVar

from . import drafts, images


class ShownImages:
    """Fills the images of an object with the library's maps, and knows the content of each."""

    def __init__(self) -> None:
        self.lock = threading.RLock()  # renders run in a thread of their own
        self.changes = 0
        """Counts the values that were given."""
        self.pace = drafts.Pace()
        self.shown: dict[str, Any] = {}
        """The content of images, by their full names."""
        self.failed: tuple[tuple, str] | None = None
        """The key of a job that failed, and the sentence that says why."""

    def stale(self, image_named: dict, content: Any) -> list[str]:
        """Returns the inputs whose images hold anything else. image_named: images by inputs."""
        for image in image_named.values():
            if images.let_go(image):
                self.shown.pop(image.name_full, None)
        return [
            name
            for name, image in image_named.items()
            if self.shown.get(image.name_full) != content
        ]

    def put(self, image_named: dict, names: list[str], maps: dict, content: Any) -> None:
        """Fills the images of these inputs with maps, by inputs too."""
        for name in names:
            image, pixels = image_named[name], maps[name]
            images.resize(image, pixels.shape[:2])
            images.fill(image, pixels)
            self.shown[image.name_full] = content

    def forget_images(self) -> None:
        """Forgets the content of images, after undo and loading."""
        self.shown.clear()


class Values(Protocol):
    """The values of a subject's file."""

    def structure(self) -> tuple:
        """Returns the part that cannot be changed parameter by parameter in an open handle."""

    def by_name(self) -> dict[str, str]: ...


def changed(before: Values, now: Values) -> dict[str, str]:
    """Returns the parameters that differ, by the names that the library knows them by."""
    return dict(now.by_name().items() - before.by_name().items())


class OpenSubject(ShownImages):
    """A handle that follows values at once. A class of its own for each subject has `_open`."""

    def __init__(self) -> None:
        super().__init__()
        self.handle: Any = None
        self.values: Any = None
        self.state: dict | None = None  # read_state()
        self.state_before: dict | None = None  # of the values before these

    def _open(self, values) -> Any:
        """Returns a handle with these values. Raises libocean.Error."""
        raise NotImplementedError

    def follow(self, values) -> None:
        """Gives the handle these values. Raises libocean.Error, and leaves it unchanged then."""
        if values == self.values:
            return
        if self.handle is None or values.structure() != self.values.structure():
            opened = self._open(values)
            self.close()
            self.handle = opened
        else:
            self.handle.set_all(changed(self.values, values))
        self.values = values
        self.state_before = self.state or self.state_before
        self.state = None
        self.changes += 1

    def read_state(self) -> dict:
        if self.state is None:
            self.state = self.handle.state
        return self.state

    def close(self) -> None:
        if self.handle is not None:
            self.handle.close()
        self.handle = None


class Opened(Protocol):
    """A subject that is open for one object."""

    def forget_images(self) -> None:
        """Forgets the content of images."""

    def close(self) -> None: ...


T = TypeVar("T", bound=Opened)


class OpenByObject(Generic[T]):
    """The open subjects of all objects of one kind, by the objects' full names."""

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
