# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Finds and loads the library, and turns its codes into exceptions."""

from __future__ import annotations

import ctypes
import os
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from . import _abi


class Error(Exception):
    """A call failed. `code` is that of libocean.h, the text is the library's sentence. The parts of
    the sentence are `what`, `parameter`, `value` and `allowed`, each "" if it has no such part:
    "is out of range", "waves.0.fetch", "5", "1000 .. 10000000 m"."""

    def __init__(
        self,
        message: str,
        code: int,
        *,
        what: str | None = None,
        parameter: str = "",
        value: str = "",
        allowed: str = "",
    ) -> None:
        super().__init__(message)
        self.code = code
        self.what = message if what is None else what
        self.parameter = parameter
        self.value = value
        self.allowed = allowed

    def __reduce__(self) -> tuple[Any, ...]:
        """Lets an error cross to another process with all of its attributes."""
        return type(self), (*self.args, self.code), self.__dict__


class InvalidValueError(Error, ValueError):
    """A parameter or argument is unknown, of a wrong type or out of range."""


class UnsupportedError(Error, NotImplementedError):
    """This version of the library does not have the feature."""


class OutOfMemoryError(Error, MemoryError):
    """A call would need more memory than is available; raised before it allocates any."""


class CancelledError(Error):
    """A progress function or Ctrl-C ended the call."""


_ERRORS = {
    _abi.CANCELLED: CancelledError,
    _abi.INVALID_ARGUMENT: InvalidValueError,
    _abi.INVALID_VALUE: InvalidValueError,
    _abi.UNSUPPORTED: UnsupportedError,
    _abi.OUT_OF_MEMORY: OutOfMemoryError,
}


def error(message: str, code: int, **fields: str) -> Error:
    return _ERRORS.get(code, Error)(message, code, **fields)


def choose(name: str, word: str, known: Mapping[str, int] | Sequence[str]) -> int:
    """Returns the number of a word of a C enum, or its place in a list; raises Error for an unknown
    word."""
    if word not in tuple(known):
        raise error(f"unknown {name} '{word}'; known: {', '.join(known)}", _abi.INVALID_VALUE)
    return known[word] if isinstance(known, Mapping) else known.index(word)


def last_error(code: int) -> Error:
    """Returns the last failure of this thread, which had this code."""

    def text(given: bytes) -> str:
        return given.decode(errors="replace")

    fields = {
        name: text(library.ocean_last_error_field(number))
        for name, number in _abi.ERROR_FIELDS.items()
    }
    return error(text(library.ocean_last_error()), code, **fields)


def _candidates() -> list[str]:
    """Returns where the library may be, best first; a name without a folder is for the system's
    loader."""
    named = os.environ.get("LIBOCEAN_LIBRARY")
    if named:
        return [named]  # and nothing else: another one found by accident would hide the mistake
    names = {"win32": ["libocean.dll"], "darwin": ["libocean.dylib"]}
    beside = names.get(sys.platform, ["libocean.so"])
    system = names.get(sys.platform, [f"libocean.so.{_abi.ABI_VERSION}"])
    here = Path(__file__).parent
    return [str(here / name) for name in beside if (here / name).exists()] + system


def _load() -> ctypes.CDLL:
    failures = []
    for path in _candidates():
        try:
            loaded = ctypes.CDLL(path)
        except OSError as failure:
            failures.append(f"{path}: {failure}")
            continue
        abi = loaded.ocean_abi_version()
        if abi != _abi.ABI_VERSION:
            raise ImportError(
                f"{path} has ABI version {abi}; this wrapper needs {_abi.ABI_VERSION}: "
                "take both from the same release"
            )
        for name, arguments in _abi.ARGUMENTS.items():
            getattr(loaded, name).restype = _abi.RESULTS.get(name, ctypes.c_int32)
            getattr(loaded, name).argtypes = arguments
        return loaded
    raise ImportError(
        "libocean's shared library does not load; set LIBOCEAN_LIBRARY to its path, or install "
        "it. Tried " + "; ".join(failures)
    )


library = _load()
version: str = library.ocean_version().decode()
"""The version of the library."""


def call(name: str, *arguments: Any) -> None:
    """Calls a function that returns a code; raises Error with the library's sentence."""
    code = getattr(library, name)(*arguments)
    if code != _abi.OK:
        raise last_error(code)


def text_of(name: str, *arguments: Any) -> str:
    """Returns the text result of a function whose last arguments are (out, size)."""
    size = ctypes.c_size_t(1 << 14)
    while True:
        out = ctypes.create_string_buffer(size.value)
        try:
            call(name, *arguments, out, ctypes.byref(size))
        except Error as failure:
            if failure.code != _abi.BUFFER_TOO_SMALL:
                raise
            continue
        return out.value.decode()
