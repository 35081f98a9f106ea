# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""One sea file, the same ocean everywhere: the Python side of libocean.h, with numpy arrays.

    import libocean

    with libocean.open("atlantic.toml") as sea:
        surface = sea.surface(12.0, resolution=1024)
        print(surface.height.std() * 4, sea.state["significant_wave_height"])

Arrays are float32 and indexed [j, i]: i counts east, j north. World z is up; metres, seconds.
"""

from ._answers import (
    GAUGE_COLUMNS,
    Detail,
    DetailBand,
    FloatPose,
    FoundCrest,
    Samples,
    Spray,
    WakeDomain,
    Water,
)
from ._foam import foam_texture, foam_texture_period
from ._library import (
    CancelledError,
    Error,
    InvalidValueError,
    OutOfMemoryError,
    UnsupportedError,
    version,
)
from ._opening import (
    open as open,
)
from ._opening import (
    open_terrain,
    parameters,
    parse,
    parse_terrain,
    preset,
    presets,
    records,
    terrain,
    terrain_parameters,
    terrain_preset,
    terrain_presets,
    text_of_values,
    water_types,
)
from ._sea import Sea
from ._surface import CHANNELS, MASKS, PRODUCTS, Product, Surface
from ._terrain import GroundSamples, Terrain, TerrainDomain, TerrainMesh

__version__ = version

# All public names but open(), which would hide Python's own from `import *`.
__all__ = [
    "CHANNELS",
    "CancelledError",
    "Detail",
    "DetailBand",
    "Error",
    "FloatPose",
    "FoundCrest",
    "GAUGE_COLUMNS",
    "GroundSamples",
    "InvalidValueError",
    "MASKS",
    "OutOfMemoryError",
    "PRODUCTS",
    "Product",
    "Samples",
    "Sea",
    "Spray",
    "Surface",
    "Terrain",
    "TerrainDomain",
    "TerrainMesh",
    "UnsupportedError",
    "WakeDomain",
    "Water",
    "foam_texture",
    "foam_texture_period",
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
