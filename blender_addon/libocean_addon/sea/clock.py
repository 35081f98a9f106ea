# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The times of a sea's frames, from a small sea of the library that has the same times: the sea
itself may be lent to a background job, for which a frame must not wait. No Blender in here.

    SeaValues, frame -> time
"""

from __future__ import annotations

import threading

from ..shared.native import libocean
from .sea_text import SeaValues

_TIMES = ("start", "first_frame", "fps")
"""The parameters that the time of a frame depends on."""


class Clock:
    """A handle of its own, which follows the times of a sea."""

    def __init__(self) -> None:
        self._lock = threading.Lock()  # renders run in a thread of their own
        self._sea = None
        self._times: dict[str, str] = {}

    def time_of(self, values: SeaValues, frame: float) -> float:
        """Returns the time of a sea with these values at a frame [s]. Raises libocean.Error."""
        times = {key: values.values[key] for key in _TIMES}
        with self._lock:
            if self._sea is None:
                self._sea = libocean.parse("libocean = 1\n")
            if times != self._times:
                self._sea.set_all(times)
                self._times = times
            return self._sea.time_of_frame(frame)

    def close(self) -> None:
        """Frees the handle; the next call opens another one."""
        with self._lock:
            if self._sea is not None:
                self._sea.close()
            self._sea, self._times = None, {}
