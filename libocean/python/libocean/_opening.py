# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The functions that open seas and terrains, and those that list what the library knows."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import Any

from ._checks import path as _path
from ._checks import text as _encoded
from ._handle import value_arrays
from ._library import Error, text_of
from ._sea import Sea
from ._terrain import Terrain


def open(path: str | os.PathLike[str], **options: Any) -> Sea:
    """Opens a sea file. The options are those of parse() and preset() too:
    threads: 0 = the cores this process may use. backend: "cpu", or the slow "radix2" and "dft".
    foam_start: "settled", or "empty" for live tools, which do not wait for the foam's past.
    progress: called with (done, total) while the library follows foam, or the waves over a bed; its
    exception ends the call.
    jobs: called with (run, count) for a host's own threads: it calls run(0) .. run(count - 1), in
    any order, on any threads, and returns when all have returned."""
    return Sea._opened(path, **options)


def parse(text: str, *, base_dir: str | os.PathLike[str] | None = None, **options: Any) -> Sea:
    """Opens a sea from the text of a sea file. base_dir: the folder that a relative `file` in it
    starts from, None = the current one."""
    return Sea._parsed(text, base_dir, **options)


def preset(name: str, **options: Any) -> Sea:
    """Opens one of the seas of presets(): "beaufort_6", "douglas_4", "seed_thesis"."""
    return parse(text_of("ocean_preset", _encoded("name", name)), **options)


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
    found: list[dict[str, Any]] = json.loads(text_of("ocean_records_json", _path("path", path)))
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
    return text_of("ocean_text_of_values", *value_arrays(values))


def open_terrain(path: str | os.PathLike[str], **options: Any) -> Terrain:
    """Opens a terrain file. The options are threads, backend, progress and jobs of open()."""
    return Terrain._opened(path, **options)


def parse_terrain(
    text: str, *, base_dir: str | os.PathLike[str] | None = None, **options: Any
) -> Terrain:
    """Opens a terrain from the text of a terrain file. base_dir: the folder that a relative
    `measured` in it starts from, None = the current one."""
    return Terrain._parsed(text, base_dir, **options)


def terrain(*, threads: int = 0, backend: str = "cpu", **parameters: Any) -> Terrain:
    """Makes a terrain of these parameters; the others have their defaults:
    libocean.terrain(beta=2.2, rms=40, patch_size=2000)."""
    made = parse_terrain("libocean = 1\n[terrain]\n", threads=threads, backend=backend)
    try:
        made.set_all(parameters)
    except (Error, TypeError):
        made.close()
        raise
    return made


def terrain_preset(name: str, **options: Any) -> Terrain:
    """Opens one of the terrains of terrain_presets(): "tujunga", "seed_smooth"."""
    return parse_terrain(text_of("ocean_terrain_preset", _encoded("name", name)), **options)


def terrain_presets() -> list[str]:
    """Returns the names that terrain_preset() knows."""
    names: list[str] = json.loads(text_of("ocean_terrain_preset", None))
    return names


def terrain_parameters() -> list[dict[str, Any]]:
    """Returns the parameter table of terrains, as parameters() does for seas."""
    table: list[dict[str, Any]] = json.loads(text_of("ocean_terrain_parameters_json"))
    return table
