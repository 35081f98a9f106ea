# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Reads a GeoTIFF as GIS programs do and prints it as JSON: run by the Python of .venv, which has
rasterio, tifffile and imagecodecs. usage: terrain_judge.py FILE HEIGHTS.npy"""

import json
import sys

import numpy
import rasterio
import tifffile

path, heights = sys.argv[1:]
with rasterio.open(path) as grid, tifffile.TiffFile(path) as tiff:
    band = grid.read(1)
    numpy.save(heights, band)
    page = tiff.pages[0]
    x, y = grid.xy(0, 0)  # the middle of the first cell: where its sample is
    print(
        json.dumps(
            {
                "readers_agree": bool((band == tiff.asarray()).all()),
                "type": band.dtype.name,
                "first": [float(x), float(y)],
                "cell": list(grid.res),
                "area_or_point": grid.tags()["AREA_OR_POINT"],
                "crs": grid.crs.to_wkt(),
                "nodata": grid.nodata,
                "tile": [page.tilewidth, page.tilelength],
                "compression": page.compression.name,
                "predictor": page.predictor.name,
                "keys": {
                    k: str(int(v)) for k, v in tiff.geotiff_metadata.items() if isinstance(v, int)
                },
                "description": page.description,
            }
        )
    )
