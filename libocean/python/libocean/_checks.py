# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""What a caller passes, checked before it reaches the library, one function for each kind of
argument. A wrong type raises TypeError, a wrong value InvalidValueError."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable
from operator import index
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _abi, _library

_INT32 = 2**31
_MASKED: Any = np.ma  # it has no types
MOST_SAMPLES = 32768
"""The max columns or rows of a region."""


def _type_error(name: str, needed: str, value: object) -> TypeError:
    return TypeError(f"{name} must be {needed}, not {type(value).__name__}")


def _value_error(words: str) -> _library.Error:
    return _library.error(words, _abi.INVALID_ARGUMENT)


def text(name: str, value: object) -> bytes:
    """Returns a text as the library reads it. A C text ends at a NUL, after which the rest would be
    lost silently: InvalidValueError."""
    if not isinstance(value, str):
        raise _type_error(name, "a text (str)", value)
    if "\0" in value:
        raise _value_error(f"{name}: a text with a NUL")
    return value.encode()


def path(name: str, value: Any) -> bytes:
    """Returns a path as the library reads it."""
    if not isinstance(value, (str, bytes, os.PathLike)):
        raise _type_error(name, "a path (str, bytes or os.PathLike)", value)
    encoded = os.fsencode(value)
    if b"\0" in encoded:
        raise _value_error(f"{name}: a path with a NUL")
    return encoded


def number(name: str, value: Any) -> float:
    """Returns a finite number."""
    if isinstance(value, (str, bytes, bytearray)):
        raise _type_error(name, "a number", value)
    try:
        given = float(value)
    except (TypeError, ValueError):
        raise _type_error(name, "a number", value) from None
    if not math.isfinite(given):
        raise _value_error(f"{name} = {given}; allowed: a finite number")
    return given


def time_of_maps(value: Any) -> float:
    """Returns a time [s] that the library has maps of."""
    given = number("time", value)
    if abs(given) > 1e9:
        raise _value_error(f"time = {given:g} s; allowed: -1e9 .. 1e9")
    return given


def whole(name: str, value: Any, low: int = -_INT32, high: int = _INT32 - 1) -> int:
    """Returns a whole number from low to high, beyond which ctypes would silently cut it off."""
    try:
        given = index(value)
    except TypeError:
        raise _type_error(name, "a whole number", value) from None
    if not low <= given <= high:
        raise _value_error(f"{name} = {given}; allowed: {low} .. {high}")
    return given


def resolution(value: Any, *others: int) -> int:
    """Returns the resolution of a map, a power of two or one of the others."""
    side = whole("resolution", value)
    if side not in (*(32 << n for n in range(9)), *others):
        raise _value_error(f"resolution = {side}; allowed: a power of two, 32 .. 8192")
    return side


def resolution_or_0(value: Any) -> int:
    """Returns the resolution of a map; 0, by which the library takes the default, for None."""
    return 0 if value is None else resolution(value, 0)


def accuracy(resolution: int, refine: int, exact: bool) -> tuple[Any, ...]:
    """Returns the members of a request that say which waves count, and how exactly."""
    return whole("resolution", resolution), whole("refine", refine), bool(exact)


def numbers(name: str, values: npt.ArrayLike, allowed: str) -> npt.NDArray[Any]:
    """Returns numbers as an array of the shape that they have. allowed: the shapes that are, for
    the sentence about rows of different lengths."""
    if _MASKED.is_masked(values):
        values = _MASKED.asarray(values).astype(np.float64).filled(np.nan)
    try:
        array = np.asarray(values)
    except ValueError:
        raise _value_error(f"{name}: rows of different lengths; allowed: {allowed}") from None
    if array.dtype.kind not in "biuf":
        held = type(values).__name__ if array.ndim == 0 else f"an array of {array.dtype}"
        raise TypeError(f"{name} must be numbers, an array {allowed}, not {held}")
    return array


def rows(name: str, values: npt.ArrayLike, width: int) -> npt.NDArray[np.float64]:
    """Returns (n, width) numbers; one row may be given as (width,)."""
    allowed = f"(n, {width})"
    array = np.ascontiguousarray(numbers(name, values, allowed), dtype=np.float64)
    if array.shape == (width,) or array.size == 0:
        array = array.reshape(-1, width)
    if array.ndim != 2 or array.shape[1] != width:
        raise _value_error(f"{name}: an array of shape {array.shape}; allowed: {allowed}")
    return array


def points_of(
    name: str, values: npt.ArrayLike, width: int
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.bool_] | None]:
    """Returns rows, and which of them a mask hides, if any: these are 0, for hide()."""
    given = rows(name, values, width)
    if not _MASKED.is_masked(values):
        return given, None
    hidden = _MASKED.getmaskarray(values).reshape(given.shape).any(axis=1)
    given[hidden] = 0.0
    return given, hidden


def hide(answers: npt.NDArray[Any], hidden: npt.NDArray[np.bool_] | None) -> None:
    """Makes all floats of hidden rows NaN."""
    if hidden is None:
        return
    for part in [answers[name] for name in answers.dtype.names or ()] or [answers]:
        if part.dtype.kind == "f":
            part[hidden] = np.nan


def row(name: str, values: npt.ArrayLike, width: int) -> list[float]:
    """Returns a list of so many finite numbers, the coordinates of a place."""
    array = numbers(name, values, f"({width},)")
    if array.shape != (width,):
        raise _value_error(f"{name}: an array of shape {array.shape}; allowed: ({width},)")
    return [number(name, value) for value in array]


def columns_and_rows(samples: Any) -> tuple[int, int]:
    """Returns the numbers of samples of a region, its columns and rows."""
    try:
        columns, rows = samples
    except (TypeError, ValueError):
        raise TypeError(f"samples must be two numbers, columns and rows, not {samples!r}") from None
    return whole("columns", columns, 2, MOST_SAMPLES), whole("rows", rows, 2, MOST_SAMPLES)


def words(name: str, values: Iterable[str] | None) -> list[str]:
    """Returns a list of names; one name may be given alone, None is no name."""
    if values is None or isinstance(values, str):
        return [] if values is None else [values]
    try:
        return list(values)
    except TypeError:
        raise _type_error(name, "a list of names", values) from None
