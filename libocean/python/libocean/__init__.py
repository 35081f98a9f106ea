# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""One sea file, the same ocean everywhere: the Python side of libocean.h, with numpy arrays.

    import libocean

    with libocean.open("atlantic.toml") as sea:
        surface = sea.surface(12.0, resolution=1024)
        print(surface.height.std() * 4, sea.state["significant_wave_height"])

Arrays are float32 and indexed [j, i]: i counts east, j north. World z is up; metres, seconds.
"""

from __future__ import annotations

import json
import os
from typing import Any

from ._foam import foam_texture, foam_texture_period
from ._library import (
    CancelledError,
    Error,
    InvalidValueError,
    OutOfMemoryError,
    UnsupportedError,
    call,
    library,
    text_of,
)
from ._sea import Detail, DetailBand, FloatPose, Samples, Sea, Spray, Surface, Water

__all__ = [
    "CancelledError",
    "Detail",
    "DetailBand",
    "Error",
    "FloatPose",
    "InvalidValueError",
    "OutOfMemoryError",
    "Samples",
    "Sea",
    "Spray",
    "Surface",
    "UnsupportedError",
    "Water",
    "foam_texture",
    "foam_texture_period",
    "open",
    "parameters",
    "parse",
    "preset",
    "presets",
    "records",
    "version",
    "water_types",
]

version: str = library.ocean_version().decode()
__version__ = version


def open(path: str | os.PathLike[str], **options: Any) -> Sea:
    """Opens a sea file. Options, of parse() and preset() too:
    threads: 0 = the cores this process may use. backend: "cpu", or the slow "radix2" and "dft".
    foam_start: "settled", or "empty" for live tools, which do not wait for the foam's past.
    progress: called with (done, total) while foam is followed; what it raises ends the call.
    jobs: called with (run, count) for a host's own threads: it calls run(0) .. run(count - 1), in
    any order, on any threads, and returns when all have returned."""
    name = os.fsencode(path)
    return Sea(lambda given, out: call("ocean_open", name, given, out), **options)


def parse(text: str, *, base_dir: str | os.PathLike[str] | None = None, **options: Any) -> Sea:
    """A sea from the text of a sea file; base_dir is where a relative `file` in it starts."""
    toml = text.encode()
    base = None if base_dir is None else os.fsencode(base_dir)
    return Sea(lambda given, out: call("ocean_parse", toml, len(toml), base, given, out), **options)


def preset(name: str, **options: Any) -> Sea:
    """One of the seas of presets(): "beaufort_6", "douglas_4", "seed_thesis"."""
    return parse(text_of("ocean_preset", name.encode()), **options)


def presets() -> list[str]:
    """The names that preset() takes."""
    return json.loads(text_of("ocean_preset", None))


def parameters() -> list[dict[str, Any]]:
    """The parameter table: name, type, unit, label, help, default and range of every parameter."""
    return json.loads(text_of("ocean_parameters_json"))


def records(path: str | os.PathLike[str]) -> list[dict[str, Any]]:
    """What a file of measured spectra holds, record by record."""
    return json.loads(text_of("ocean_records_json", os.fsencode(path)))


def water_types() -> list[dict[str, Any]]:
    """What sea water does to light, by Jerlov's types, clearest first: name, label, help, ior;
    absorption and scattering in 1/m, albedo of the water below its surface, each as red, green and
    blue of linear Rec. 709; anisotropy, the mean cosine of scattering; foam_albedo."""
    return json.loads(text_of("ocean_water_types_json"))
