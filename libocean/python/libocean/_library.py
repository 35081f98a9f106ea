# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""libocean.h in ctypes: finds and loads the library, turns its codes into exceptions."""

from __future__ import annotations

import ctypes
import os
import sys
from collections.abc import Sequence
from ctypes import (
    POINTER,
    c_char_p,
    c_double,
    c_float,
    c_int32,
    c_int64,
    c_size_t,
    c_uint32,
    c_void_p,
)
from pathlib import Path
from typing import Any

ABI_VERSION = 1

OK = 0
INVALID_ARGUMENT = 1
INVALID_VALUE = 2
UNSUPPORTED = 5
OUT_OF_MEMORY = 7
BUFFER_TOO_SMALL = 8
CANCELLED = 10
BUSY = 11

# The order of these is that of the C enums.
ERROR_FIELDS = ("what", "parameter", "value", "allowed")
BACKENDS = ("cpu", "gl", "radix2", "dft")
AXES = ("zup", "yup", "tnb")
FOAM_STARTS = ("settled", "empty")

Progress = ctypes.CFUNCTYPE(c_int32, c_void_p, c_int64, c_int64)
Job = ctypes.CFUNCTYPE(None, c_void_p, c_int32)
RunJobs = ctypes.CFUNCTYPE(None, c_void_p, Job, c_void_p, c_int32)


class Options(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("threads", c_int32),
        ("backend", c_int32),
        ("foam_start", c_int32),
        ("reserved", c_int32),
        ("progress", Progress),
        ("user", c_void_p),
        ("run_jobs", RunJobs),
        ("jobs_user", c_void_p),
    ]


class Output(ctypes.Structure):
    _fields_ = [
        ("data", POINTER(c_float)),
        ("count", c_size_t),
        ("channel", c_int32 * 4),
        ("channels", c_int32),
        ("axes", c_int32),
        ("row_pitch", c_size_t),
        ("seam", c_int32),
        ("reserved", c_int32),
    ]


class Request(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("time", c_double),
        ("resolution", c_int32),
        ("outputs", POINTER(Output)),
        ("output_count", c_size_t),
        ("output_size", c_size_t),
        ("cascade", c_int32),
        ("reserved", c_int32),
    ]


class RegionRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("x", c_double),
        ("y", c_double),
        ("cell", c_double),
        ("columns", c_int32),
        ("rows", c_int32),
        ("outputs", POINTER(Output)),
        ("output_count", c_size_t),
        ("output_size", c_size_t),
    ]


class MeshRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("x", c_double),
        ("y", c_double),
        ("z", c_double),
        ("ground", c_double),
        ("farthest", c_double),
        ("spacing", c_double),
        ("range", c_double),
        ("positions", c_void_p),
        ("vertex_capacity", c_size_t),
        ("corners", c_void_p),
        ("triangle_capacity", c_size_t),
    ]


class DomainStruct(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("x", c_double),
        ("y", c_double),
        ("cell", c_double),
        ("columns", c_int32),
        ("rows", c_int32),
        ("wraps", c_int32),
        ("reserved", c_int32),
    ]


class QueryRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("time", c_double),
        ("xy", c_void_p),
        ("count", c_size_t),
        ("samples", c_void_p),
        ("sample_size", c_size_t),
        ("resolution", c_int32),
        ("refine", c_int32),
        ("exact", c_int32),
        ("foam", c_int32),
        ("height_error", POINTER(c_double)),
    ]


class WaterRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("time", c_double),
        ("xyz", c_void_p),
        ("count", c_size_t),
        ("samples", c_void_p),
        ("sample_size", c_size_t),
        ("resolution", c_int32),
        ("refine", c_int32),
        ("exact", c_int32),
        ("reserved", c_int32),
    ]


class Gauge(ctypes.Structure):
    _fields_ = [("fixes", c_void_p), ("fix_count", c_size_t), ("velocity", c_double * 2)]


class GaugeRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("start", c_double),
        ("end", c_double),
        ("rate", c_double),
        ("gauges", POINTER(Gauge)),
        ("gauge_count", c_size_t),
        ("gauge_size", c_size_t),
        ("values", c_void_p),
        ("value_count", c_size_t),
    ]


class DetailRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("time", c_double),
        ("resolution", c_int32),
        ("samples", c_int32),
        ("bands", c_void_p),
        ("band_count", c_size_t),
        ("band_size", c_size_t),
        ("outputs", POINTER(Output)),
        ("output_count", c_size_t),
        ("output_size", c_size_t),
    ]


class ProvenanceRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("time", c_double),
        ("frame", c_int32),
        ("axes", c_int32),
        ("field", c_char_p),
        ("band", c_void_p),
        ("band_size", c_size_t),
        ("residual", c_double),
        ("resolution", c_int32),
        ("reserved", c_int32),
    ]


class SprayRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("time", c_double),
        ("lifetime", c_double),
        ("density", c_double),
        ("most", c_int32),
        ("reserved", c_int32),
        ("particles", c_void_p),
        ("particle_count", c_size_t),
        ("particle_size", c_size_t),
    ]


class FoamTextureRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("kind", c_char_p),
        ("size", c_int32),
        ("seed", c_uint32),
        ("data", c_void_p),
        ("count", c_size_t),
    ]


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
    CANCELLED: CancelledError,
    INVALID_ARGUMENT: InvalidValueError,
    INVALID_VALUE: InvalidValueError,
    UNSUPPORTED: UnsupportedError,
    OUT_OF_MEMORY: OutOfMemoryError,
}


def error(message: str, code: int, **fields: str) -> Error:
    return _ERRORS.get(code, Error)(message, code, **fields)


def choose(name: str, word: str, known: Sequence[str]) -> int:
    """Returns the number of a word of a C enum; raises Error for an unknown word."""
    if word not in known:
        raise error(f"unknown {name} '{word}'; known: {', '.join(known)}", INVALID_VALUE)
    return known.index(word)


def last_error(code: int) -> Error:
    """Returns the last failure of this thread, which had this code."""

    def text(given: bytes) -> str:
        return given.decode(errors="replace")

    fields = {
        name: text(library.ocean_last_error_field(number))
        for number, name in enumerate(ERROR_FIELDS)
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
    system = names.get(sys.platform, [f"libocean.so.{ABI_VERSION}"])
    here = Path(__file__).parent
    return [str(here / name) for name in beside if (here / name).exists()] + system


_TEXT = [c_char_p, POINTER(c_size_t)]
_LISTS = [c_void_p, c_size_t, c_void_p, c_size_t]
_SIGNATURES: dict[str, list[Any]] = {
    "ocean_open": [c_char_p, POINTER(Options), POINTER(c_void_p)],
    "ocean_parse": [c_char_p, c_size_t, c_char_p, POINTER(Options), POINTER(c_void_p)],
    "ocean_clone": [c_void_p, POINTER(Options), POINTER(c_void_p)],
    "ocean_set": [c_void_p, c_char_p, c_char_p],
    "ocean_set_all": [c_void_p, POINTER(c_char_p), POINTER(c_char_p), c_size_t],
    "ocean_add_waves": [c_void_p, c_char_p],
    "ocean_remove_waves": [c_void_p, c_char_p],
    "ocean_set_bed": [c_void_p, c_void_p, c_int32, c_int32, c_double, c_double, c_double],
    "ocean_perform": [c_void_p, c_double, c_char_p, c_char_p],
    "ocean_get": [c_void_p, c_char_p, c_char_p, c_size_t],
    "ocean_text": [c_void_p, *_TEXT],
    "ocean_parameters_json": _TEXT,
    "ocean_state_json": [c_void_p, *_TEXT],
    "ocean_records_json": [c_char_p, *_TEXT],
    "ocean_preset": [c_char_p, *_TEXT],
    "ocean_values_json": [c_void_p, *_TEXT],
    "ocean_text_of_values": [POINTER(c_char_p), POINTER(c_char_p), c_size_t, *_TEXT],
    "ocean_time_of_frame": [c_void_p, c_double, POINTER(c_double)],
    "ocean_provenance_json": [c_void_p, POINTER(ProvenanceRequest), *_TEXT],
    "ocean_water_types_json": _TEXT,
    "ocean_map_resolution": [c_void_p, POINTER(c_int32)],
    "ocean_cascade_periods": [c_void_p, POINTER(c_double), POINTER(c_size_t)],
    "ocean_evaluate": [c_void_p, POINTER(Request)],
    "ocean_cover_power": [c_void_p, c_double, c_int32, POINTER(c_double)],
    "ocean_query": [c_void_p, c_double, *_LISTS],
    "ocean_query_points": [c_void_p, POINTER(QueryRequest)],
    "ocean_orbital_velocity": [c_void_p, c_double, c_double, *_LISTS],
    "ocean_water_points": [c_void_p, POINTER(WaterRequest)],
    "ocean_gauges": [c_void_p, POINTER(GaugeRequest), POINTER(c_size_t)],
    "ocean_detail": [c_void_p, POINTER(DetailRequest), POINTER(c_size_t), POINTER(c_double)],
    "ocean_spray": [c_void_p, POINTER(SprayRequest), POINTER(c_size_t)],
    "ocean_float_pose": [c_void_p, c_double, *_LISTS],
    "ocean_terrain_open": [c_char_p, POINTER(Options), POINTER(c_void_p)],
    "ocean_terrain_parse": [c_char_p, c_size_t, c_char_p, POINTER(Options), POINTER(c_void_p)],
    "ocean_terrain_clone": [c_void_p, POINTER(Options), POINTER(c_void_p)],
    "ocean_terrain_set": [c_void_p, c_char_p, c_char_p],
    "ocean_terrain_set_all": [c_void_p, POINTER(c_char_p), POINTER(c_char_p), c_size_t],
    "ocean_terrain_get": [c_void_p, c_char_p, c_char_p, c_size_t],
    "ocean_terrain_text": [c_void_p, *_TEXT],
    "ocean_terrain_state_json": [c_void_p, *_TEXT],
    "ocean_terrain_parameters_json": _TEXT,
    "ocean_terrain_preset": [c_char_p, *_TEXT],
    "ocean_terrain_provenance_json": [c_void_p, c_char_p, c_int32, *_TEXT],
    "ocean_terrain_evaluate": [c_void_p, POINTER(Request)],
    "ocean_terrain_domain": [c_void_p, POINTER(DomainStruct)],
    "ocean_region": [c_void_p, c_double, POINTER(RegionRequest)],
    "ocean_bed_region": [c_void_p, c_double, c_double, c_double, c_int32, c_int32, c_void_p],
    "ocean_terrain_region": [c_void_p, POINTER(RegionRequest)],
    "ocean_terrain_mesh": [
        c_void_p,
        POINTER(MeshRequest),
        POINTER(c_size_t),
        POINTER(c_size_t),
    ],
    "ocean_terrain_query_points": [c_void_p, POINTER(QueryRequest)],
    "ocean_terrain_stage": [c_void_p, c_char_p, c_void_p, c_size_t],
    "ocean_foam_texture": [
        POINTER(FoamTextureRequest),
        POINTER(Options),
        POINTER(c_double),
    ],
}


def _load() -> ctypes.CDLL:
    failures = []
    for path in _candidates():
        try:
            loaded = ctypes.CDLL(path)
        except OSError as failure:
            failures.append(f"{path}: {failure}")
            continue
        loaded.ocean_abi_version.restype = c_uint32
        abi = loaded.ocean_abi_version()
        if abi != ABI_VERSION:
            raise ImportError(
                f"{path} has ABI version {abi}; this wrapper needs {ABI_VERSION}: "
                "take both from the same release"
            )
        loaded.ocean_version.restype = c_char_p
        loaded.ocean_last_error.restype = c_char_p
        loaded.ocean_last_error_field.argtypes = [c_int32]
        loaded.ocean_last_error_field.restype = c_char_p
        for free in (loaded.ocean_free, loaded.ocean_terrain_free):
            free.argtypes = [c_void_p]
            free.restype = None
        for name, arguments in _SIGNATURES.items():
            getattr(loaded, name).argtypes = arguments
            getattr(loaded, name).restype = c_int32
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
    if code != OK:
        raise last_error(code)


def text_of(name: str, *arguments: Any) -> str:
    """Returns the text result of a function whose last arguments are (out, size)."""
    size = c_size_t(1 << 14)
    while True:
        out = ctypes.create_string_buffer(size.value)
        try:
            call(name, *arguments, out, ctypes.byref(size))
        except Error as failure:
            if failure.code != BUFFER_TOO_SMALL:
                raise
            continue
        return out.value.decode()
