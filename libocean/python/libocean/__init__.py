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
from collections.abc import Mapping
from typing import Any

from ._answers import Detail, DetailBand, FloatPose, Samples, Spray, Water
from ._foam import foam_texture, foam_texture_period
from ._handle import text_array, value_text
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
from ._sea import Sea
from ._surface import Surface
from ._terrain import GroundSamples, Terrain, TerrainDomain, TerrainMesh

__all__ = [
    "CancelledError",
    "Detail",
    "DetailBand",
    "Error",
    "FloatPose",
    "GroundSamples",
    "InvalidValueError",
    "OutOfMemoryError",
    "Samples",
    "Sea",
    "Spray",
    "Surface",
    "Terrain",
    "TerrainDomain",
    "TerrainMesh",
    "UnsupportedError",
    "Water",
    "foam_texture",
    "foam_texture_period",
    "open",
    "open_terrain",
    "parameters",
    "parse",
    "parse_terrain",
    "preset",
    "presets",
    "records",
    "terrain",
    "terrain_parameters",
    "terrain_preset",
    "terrain_presets",
    "text_of_values",
    "version",
    "water_types",
]

version: str = library.ocean_version().decode()
__version__ = version


def open(path: str | os.PathLike[str], **options: Any) -> Sea:
    """Opens a sea file. The options are those of parse() and preset() too:
    threads: 0 = the cores this process may use. backend: "cpu", or the slow "radix2" and "dft".
    foam_start: "settled", or "empty" for live tools, which do not wait for the foam's past.
    progress: called with (done, total) while the library follows foam, or the waves over a bed; its
    exception ends the call.
    jobs: called with (run, count) for a host's own threads: it calls run(0) .. run(count - 1), in
    any order, on any threads, and returns when all have returned."""
    name = os.fsencode(path)
    return Sea(lambda given, out: call("ocean_open", name, given, out), **options)


def parse(text: str, *, base_dir: str | os.PathLike[str] | None = None, **options: Any) -> Sea:
    """Opens a sea from the text of a sea file. base_dir: the folder that a relative `file` in it
    starts from, None = the current one."""
    toml = text.encode()
    base = None if base_dir is None else os.fsencode(base_dir)
    return Sea(lambda given, out: call("ocean_parse", toml, len(toml), base, given, out), **options)


def preset(name: str, **options: Any) -> Sea:
    """Opens one of the seas of presets(): "beaufort_6", "douglas_4", "seed_thesis"."""
    return parse(text_of("ocean_preset", name.encode()), **options)


def presets() -> list[str]:
    """Returns the names that preset() knows."""
    names: list[str] = json.loads(text_of("ocean_preset", None))
    return names


def parameters() -> list[dict[str, Any]]:
    """Returns the parameter table: name, type, unit, label, help, default and range of every
    parameter."""
    table: list[dict[str, Any]] = json.loads(text_of("ocean_parameters_json"))
    return table


def records(path: str | os.PathLike[str]) -> list[dict[str, Any]]:
    """Returns the records of a file of measured spectra."""
    found: list[dict[str, Any]] = json.loads(text_of("ocean_records_json", os.fsencode(path)))
    return found


def water_types() -> list[dict[str, Any]]:
    """Returns Jerlov's optical types of sea water, clearest first: name, label, help, ior;
    absorption and scattering [1/m], albedo of the water below its surface, each as red, green and
    blue of linear Rec. 709; anisotropy, the mean cosine of scattering; foam_albedo."""
    types: list[dict[str, Any]] = json.loads(text_of("ocean_water_types_json"))
    return types


def text_of_values(values: Mapping[str, Any]) -> str:
    """Returns a sea file that sets these parameters, named as in Sea.values or Sea.set(). Equal
    values give equal bytes. Unset values are left out, and neutral ones of later parameters. Checks
    no value: parse() of the text does."""
    texts = [value_text(value) for value in values.values()]
    return text_of("ocean_text_of_values", text_array(list(values)), text_array(texts), len(texts))


def open_terrain(path: str | os.PathLike[str], **options: Any) -> Terrain:
    """Opens a terrain file. The options are threads, backend, progress and jobs of open()."""
    name = os.fsencode(path)
    return Terrain(lambda given, out: call("ocean_terrain_open", name, given, out), **options)


def parse_terrain(
    text: str, *, base_dir: str | os.PathLike[str] | None = None, **options: Any
) -> Terrain:
    """Opens a terrain from the text of a terrain file. base_dir: the folder that a relative
    `measured` in it starts from, None = the current one."""
    toml = text.encode()
    base = None if base_dir is None else os.fsencode(base_dir)
    return Terrain(
        lambda given, out: call("ocean_terrain_parse", toml, len(toml), base, given, out),
        **options,
    )


def terrain(*, threads: int = 0, backend: str = "cpu", **parameters: Any) -> Terrain:
    """Makes a terrain of these parameters; the others have their defaults:
    libocean.terrain(beta=2.2, rms=40, patch_size=2000)."""
    made = parse_terrain("libocean = 1\n[terrain]\n", threads=threads, backend=backend)
    try:
        made.set_all(parameters)
    except Error:
        made.close()
        raise
    return made


def terrain_preset(name: str, **options: Any) -> Terrain:
    """Opens one of the terrains of terrain_presets(): "tujunga", "seed_smooth"."""
    return parse_terrain(text_of("ocean_terrain_preset", name.encode()), **options)


def terrain_presets() -> list[str]:
    """Returns the names that terrain_preset() knows."""
    names: list[str] = json.loads(text_of("ocean_terrain_preset", None))
    return names


def terrain_parameters() -> list[dict[str, Any]]:
    """Returns the parameter table of terrains, as parameters() does for seas."""
    table: list[dict[str, Any]] = json.loads(text_of("ocean_terrain_parameters_json"))
    return table
