# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The library's handles of a sea and of a terrain: their life, their lock and their parameters."""

from __future__ import annotations

import ctypes
import difflib
import json
import os
import threading
from collections.abc import Callable, Mapping
from decimal import Decimal
from numbers import Integral, Real
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _abi, _library
from ._answers import pointer_to
from ._checks import number, path, row, text, whole
from ._checks import numbers as numbers_of
from ._library import call, choose, text_of
from ._read_only import ReadOnly
from ._reporter import Reporter

if TYPE_CHECKING:
    from typing import Self


def value_text(value: Any) -> str:
    """Returns a Python value as the library reads it, in the shortest form that keeps every bit."""
    if isinstance(value, np.ndarray):
        return value_text(value.tolist())
    if value is None:
        return ""
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, Integral):
        return str(int(value))
    if isinstance(value, (Real, Decimal)):
        return repr(float(value))
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(value_text(item) for item in value) + "]"
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    raise TypeError(
        "a value must be a number, a text, a path, a list of these or None, not "
        f"{type(value).__name__}"
    )


def value_arrays(values: Mapping[str, Any]) -> tuple[Any, Any, int]:
    """Returns names and values of parameters as two arrays of C texts, and their number."""
    if not isinstance(values, Mapping):
        raise TypeError(f"values must be a mapping of names, not {type(values).__name__}")
    array = ctypes.c_char_p * len(values)
    names = (text("the name of a parameter", name) for name in values)
    texts = (text(f"{name}", value_text(value)) for name, value in values.items())
    return array(*names), array(*texts), len(values)


_OPTIONS = ("threads", "backend", "foam_start", "progress", "jobs")
"""The keywords of the functions that open a subject."""


def _unknown_option(name: str) -> TypeError:
    near = difflib.get_close_matches(name, _OPTIONS, 1)
    words = f"did you mean {near[0]}?" if near else "allowed: " + ", ".join(_OPTIONS)
    return TypeError(f"unknown option '{name}'; {words}")


class Handle(ReadOnly):
    """An open subject of the library. Calls of several threads wait for each other."""

    _noun = "sea"
    _instead = 'set("{name}", {value!r}) sets a parameter of that name'
    _prefix = "ocean_"
    """The beginning of the names of the subject's functions."""
    _makers = "libocean.open(), parse() or preset()"
    _base_dir = b""
    """The folder from which the library takes relative files, b"" = the current one."""

    def __init__(
        self,
        opener: Callable[[Any, Any], None] | None = None,
        threads: int = 0,
        backend: str = "cpu",
        foam_start: str = "settled",
        progress: Callable[[int, int], object] | None = None,
        jobs: Callable[[Callable[[int], None], int], object] | None = None,
        **unknown: Any,
    ) -> None:
        if unknown:
            raise _unknown_option(next(iter(unknown)))
        self._handle: ctypes.c_void_p | None = None
        self._lock = threading.RLock()
        if not callable(opener):
            raise TypeError(f"a {self._noun} is made by {self._makers}")
        for name, function in (("progress", progress), ("jobs", jobs)):
            if function is not None and not callable(function):
                raise TypeError(f"{name} must be a function, not {type(function).__name__}")
        self._changes = 0
        self._options = (threads, backend, foam_start, progress, jobs)
        self._reporter = Reporter(progress, jobs)
        options = _abi.Options(
            ctypes.sizeof(_abi.Options),
            whole("threads", threads),
            choose("backend", backend, _abi.BACKENDS),
            choose("foam_start", foam_start, _abi.FOAM_STARTS),
            0,
            self._reporter.progress,
            None,
            self._reporter.run_jobs,
        )
        handle = ctypes.c_void_p()
        opener(ctypes.byref(options), ctypes.byref(handle))
        self._handle = handle

    @classmethod
    def _opened(cls, file: str | os.PathLike[str], **options: Any) -> Self:
        name = path("path", file)
        opened = cls(lambda given, out: call(cls._prefix + "open", name, given, out), **options)
        opened._base_dir = os.path.dirname(os.path.abspath(name))
        return opened

    @classmethod
    def _parsed(
        cls,
        toml: str,
        base_dir: str | bytes | os.PathLike[str] | None = None,
        *places: Any,
        **options: Any,
    ) -> Self:
        code = text("text", toml)
        base = b"" if base_dir is None else path("base_dir", base_dir)

        def parse(given: Any, out: Any) -> None:
            call(cls._prefix + "parse", code, len(code), base, given, out)

        parsed = cls(parse, *places, **options)
        parsed._base_dir = os.path.abspath(base)
        return parsed

    def clone(self) -> Self:
        """Returns the same subject for another thread; copy.copy() and copy.deepcopy() do so too.
        Both share the data that this one has built, until either changes."""

        def share(options: Any, out: Any) -> None:
            self._call(self._prefix + "clone", options, out)

        twin = type(self)(share, *self._options)
        twin._base_dir = self._base_dir
        return twin

    __copy__ = clone

    def __deepcopy__(self, _memo: dict[int, Any]) -> Self:
        return self.clone()

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickles the subject as its text, which gives the same one in every bit, without
        `progress` and `jobs`."""
        threads, backend, foam_start, *_ = self._options
        base = os.path.abspath(self._base_dir)
        return type(self)._parsed, (self.text, base, threads, backend, foam_start)

    def __repr__(self) -> str:
        return f"<libocean.{type(self).__name__}: {self._description()}>"

    def _description(self) -> str:
        if not self._lock.acquire(blocking=False):
            return "busy in another thread"
        try:
            return self._summary()
        except _library.Error as failure:
            return str(failure)
        finally:
            self._lock.release()

    def _summary(self) -> str:
        raise NotImplementedError

    def __enter__(self) -> Self:
        return self

    def close(self) -> None:
        """Frees the library's memory. Surfaces keep the arrays they have. Closing twice is
        allowed."""
        with self._lock:
            self._reporter.require_outside()
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

    def _change(self, name: str, *arguments: Any) -> None:
        """Calls a function that changes the subject, after which older surfaces compute no more."""
        with self._lock:
            self._call(name, *arguments)
            self._changes += 1

    def _text(self, name: str, *arguments: Any) -> str:
        with self._lock, self._reporter.watched():
            return text_of(name, self._open_handle(), *arguments)

    def _samples(
        self,
        name: str,
        request_type: type[ctypes.Structure],
        sample: np.dtype[Any],
        points: npt.NDArray[np.float64],
        time: float,
        how: tuple[Any, ...],
    ) -> npt.NDArray[Any]:
        """Returns a sample for each point; `how` holds the request's members after them."""
        answers = np.empty(len(points), dtype=sample)
        places = (pointer_to(points), len(points), pointer_to(answers), sample.itemsize)
        when = number("time", time)
        request = request_type(ctypes.sizeof(request_type), when, *places, *how)
        self._call(name, ctypes.byref(request))
        return answers

    def _open_handle(self) -> ctypes.c_void_p:
        if self._handle is None:
            raise _library.error(f"this {self._noun} is closed", _abi.INVALID_ARGUMENT)
        return self._handle

    # Parameters -------------------------------------------------------------------

    def set(self, name: str, value: Any) -> None:
        """Sets a parameter ("wind_speed", "waves.1.fetch", "beta"); None unsets an optional one."""
        self._change(self._prefix + "set", text("name", name), text(name, value_text(value)))

    def set_all(self, values: Mapping[str, Any]) -> None:
        """Sets several parameters and checks them together: either all change or none."""
        self._change(self._prefix + "set_all", *value_arrays(values))

    def get(self, name: str) -> str:
        """Returns the value of a parameter as text; "" for an optional one that is not set."""
        out = ctypes.create_string_buffer(8192)
        self._call(self._prefix + "get", text("name", name), out, len(out))
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


def _bed_of(heights: npt.ArrayLike) -> npt.NDArray[np.float32]:
    """Returns the heights of a bed as the library reads them."""
    array = numbers_of("heights", heights, "[j][i]")
    if array.ndim != 2 or not all(2 <= side <= 8192 for side in array.shape):
        raise _library.error(
            f"heights: an array of shape {array.shape}; allowed: [j][i], 2 .. 8192 samples a side, "
            "or None for no bed",
            _abi.INVALID_ARGUMENT,
        )
    return np.ascontiguousarray(array, dtype=np.float32)


class SeaHandle(Handle):
    """An open sea of the library."""

    def _summary(self) -> str:
        side, patch = self.get("grid.resolution"), self.get("patch_size")
        # The height that was asked for is that of any grid, and a large one takes seconds.
        with self.clone() as small:
            small.set("grid.resolution", 32)
            asked = small.state["significant_wave_height"]["asked"]
        return f"{side} x {side} samples of {patch} m, significant wave height {asked:.3g} m asked"

    def __reduce__(self) -> tuple[Any, ...]:
        bed = self.values.get("[water.bed_heights]", "")
        if bed and "\nsamples" not in bed and not self.get("seabed"):
            raise _library.error(
                "this sea cannot be pickled: its text keeps an array as the bed up to 1 MB, and "
                "this one is larger; give the other process the array and call set_bed() there",
                _abi.UNSUPPORTED,
            )
        return super().__reduce__()

    def add_waves(self, name: str | None = None, **parameters: Any) -> str:
        """Adds a wave system with these parameters, as the last one or as `name` ("waves.1"; the
        systems from that number on are renumbered one higher). Returns its name."""
        with self._lock:
            if name is None:
                name = f"waves.{self.text.count(chr(10) + '[[waves]]')}"
            self._change("ocean_add_waves", text("name", name))
            try:
                self.set_all({f"{name}.{key}": value for key, value in parameters.items()})
            except (_library.Error, TypeError):
                self.remove_waves(name)
                raise
            return name

    def remove_waves(self, name: str) -> None:
        """Removes the wave system of that name; the systems behind it are renumbered one lower."""
        self._change("ocean_remove_waves", text("name", name))

    def set_bed(
        self,
        heights: npt.ArrayLike | None,
        origin: tuple[float, float] = (0.0, 0.0),
        cell: float = 1.0,
    ) -> None:
        """Gives the sea a bed: heights[j][i] over still water [m], positive up, rows from the
        south, samples `cell` [m] apart both ways; `origin` is the place of heights[0][0] [m]. It
        takes the place of `seabed`. None removes the bed."""
        bed = np.zeros((0, 0), np.float32) if heights is None else _bed_of(heights)
        data = None if heights is None else pointer_to(bed)
        rows, columns = bed.shape
        place, step = row("origin", origin, 2), number("cell", cell)
        if step <= 0:
            raise _library.error(f"cell = {step} m; allowed: above 0", _abi.INVALID_ARGUMENT)
        self._change("ocean_set_bed", data, columns, rows, *place, step)

    def perform(self, time: float, name: str, value: Any) -> None:
        """Lets a live parameter glide to the value from `time` [s] on, while the sea is shown. Adds
        an event to the sea's own take: `text` makes every frame again. Everything before that time
        stays."""
        event = number("time", time), text("name", name), text(name, value_text(value))
        self._change("ocean_perform", *event)

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
        self._call("ocean_time_of_frame", number("frame", frame), ctypes.byref(time))
        return time.value
