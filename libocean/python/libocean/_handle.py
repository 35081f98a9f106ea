# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The library's handles of a sea and of a terrain: their life, their lock and their parameters."""

from __future__ import annotations

import ctypes
import json
import numbers
import threading
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _library
from ._library import Options, call, choose, text_of
from ._reporter import Reporter


def value_text(value: Any) -> str:
    """Returns a Python value as the library reads it, in the shortest form that keeps every bit."""
    if value is None:
        return ""
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(value_text(item) for item in value) + "]"
    text = str(value)
    if "\0" in text:  # a C text ends at a NUL: the rest would be lost silently
        raise _library.error("a text with a NUL", _library.INVALID_VALUE)
    return text


def text_array(texts: list[str]) -> Any:
    """Returns texts as an array of C texts."""
    return (ctypes.c_char_p * len(texts))(*(text.encode() for text in texts))


class Handle:
    """An open subject of the library. Calls of several threads wait for each other."""

    _noun = "sea"
    _prefix = "ocean_"
    """The beginning of the names of the subject's functions."""

    def __init__(
        self,
        opener: Callable[[Any, Any], None],
        threads: int = 0,
        backend: str = "cpu",
        foam_start: str = "settled",
        progress: Callable[[int, int], object] | None = None,
        jobs: Callable[[Callable[[int], None], int], object] | None = None,
    ) -> None:
        self._handle: ctypes.c_void_p | None = None
        self._lock = threading.RLock()
        self._changes = 0
        self._options = (threads, backend, foam_start, progress, jobs)
        self._reporter = Reporter(progress, jobs)
        options = Options(
            ctypes.sizeof(Options),
            threads,
            choose("backend", backend, _library.BACKENDS),
            choose("foam_start", foam_start, _library.FOAM_STARTS),
            0,
            self._reporter.progress,
            None,
            self._reporter.run_jobs,
        )
        handle = ctypes.c_void_p()
        opener(ctypes.byref(options), ctypes.byref(handle))
        self._handle = handle

    def close(self) -> None:
        """Frees the library's memory. Surfaces keep the arrays they have. Closing twice is
        allowed."""
        with self._lock:
            handle, self._handle = self._handle, None
            if handle is not None:
                getattr(_library.library, self._prefix + "free")(handle)

    def __exit__(self, *_: object) -> None:
        self.close()

    def __del__(self) -> None:
        if getattr(self, "_handle", None) is not None:
            self.close()

    def _call(self, name: str, *arguments: Any) -> None:
        with self._lock, self._reporter.watched():
            call(name, self._open_handle(), *arguments)

    def _text(self, name: str, *arguments: Any) -> str:
        with self._lock, self._reporter.watched():
            return text_of(name, self._open_handle(), *arguments)

    def _open_handle(self) -> ctypes.c_void_p:
        if self._handle is None:
            raise _library.error(f"this {self._noun} is closed", _library.INVALID_ARGUMENT)
        return self._handle

    # Parameters -------------------------------------------------------------------

    def set(self, name: str, value: Any) -> None:
        """Sets a parameter ("wind_speed", "waves.1.fetch", "beta"); None unsets an optional one."""
        with self._lock:
            self._call(self._prefix + "set", name.encode(), value_text(value).encode())
            self._changes += 1

    def set_all(self, values: Mapping[str, Any]) -> None:
        """Sets several parameters and checks them together: either all change or none."""
        with self._lock:
            texts = [value_text(value) for value in values.values()]
            self._call(
                self._prefix + "set_all", text_array(list(values)), text_array(texts), len(texts)
            )
            self._changes += 1

    def get(self, name: str) -> str:
        """Returns the value of a parameter as text; "" for an optional one that is not set."""
        out = ctypes.create_string_buffer(8192)
        self._call(self._prefix + "get", name.encode(), out, len(out))
        return out.value.decode()

    @property
    def text(self) -> str:
        """The resolved file, self-contained: parsing it gives the same subject."""
        return self._text(self._prefix + "text")

    @property
    def state(self) -> dict[str, Any]:
        """The output of `ocean info --json`, statistics as asked and as resolved."""
        state: dict[str, Any] = json.loads(self._text(self._prefix + "state_json"))
        return state


class SeaHandle(Handle):
    """An open sea of the library."""

    def add_waves(self, name: str | None = None, **parameters: Any) -> str:
        """Adds a wave system with these parameters, as the last one or as `name` ("waves.1"; the
        systems from that number on are renumbered one higher). Returns its name."""
        with self._lock:
            if name is None:
                name = f"waves.{self.text.count(chr(10) + '[[waves]]')}"
            self._call("ocean_add_waves", name.encode())
            self._changes += 1
            try:
                self.set_all({f"{name}.{key}": value for key, value in parameters.items()})
            except _library.Error:
                self.remove_waves(name)
                raise
            return name

    def remove_waves(self, name: str) -> None:
        """Removes the wave system of that name; the systems behind it are renumbered one lower."""
        with self._lock:
            self._call("ocean_remove_waves", name.encode())
            self._changes += 1

    def set_bed(
        self,
        heights: npt.ArrayLike | None,
        origin: tuple[float, float] = (0.0, 0.0),
        cell: float = 1.0,
    ) -> None:
        """Gives the sea a bed: heights[j][i] over still water [m], positive up, rows from the
        south, samples `cell` [m] apart both ways; `origin` is the place of heights[0][0] [m]. It
        takes the place of `seabed`. None removes the bed."""
        rows = np.zeros((0, 0)) if heights is None else np.asarray(heights)
        if rows.ndim != 2:
            raise ValueError(f"heights: {rows.ndim} dimensions; allowed: 2, [j][i]")
        rows = np.ascontiguousarray(rows, dtype=np.float32)
        data = None if heights is None else rows.ctypes.data
        with self._lock:
            self._call("ocean_set_bed", data, rows.shape[1], rows.shape[0], *origin, cell)
            self._changes += 1

    def perform(self, time: float, name: str, value: Any) -> None:
        """Lets a live parameter glide to the value from `time` [s] on, while the sea is shown. Adds
        an event to the sea's own take: `text` makes every frame again. Everything before that time
        stays."""
        with self._lock:
            self._call("ocean_perform", time, name.encode(), value_text(value).encode())
            self._changes += 1

    @property
    def values(self) -> dict[str, str]:
        """Every parameter as text: "grid.resolution": "512", "waves.0.fetch": "1e+05"; "" for one
        that is not set. "[take]", "[waves.0.measured_record]", "[water.bed_heights]" and
        "[water.bed_terrain]" are the lines of tables that the resolved file carries.
        libocean.text_of_values() is the inverse."""
        values: dict[str, str] = json.loads(self._text("ocean_values_json"))
        return values

    def time_of_frame(self, frame: float) -> float:
        """Returns the sea's time at a frame [s]: start + (frame - first_frame) / fps."""
        time = ctypes.c_double()
        self._call("ocean_time_of_frame", frame, ctypes.byref(time))
        return time.value
