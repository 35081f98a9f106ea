# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Merges GeoTIFFs as GIS programs do, saves the heights, the northern row first, and prints where
the middle of the first cell lies: run by the Python of .venv, which has rasterio.
usage: region_judge.py HEIGHTS.npy FILE..."""

import json
import sys

import numpy
import rasterio
from rasterio.merge import merge

heights, *paths = sys.argv[1:]
grids = [rasterio.open(path) for path in paths]
merged, transform = merge(grids)
numpy.save(heights, merged[0])
x, y = transform * (0.5, 0.5)
print(json.dumps({"first": [x, y], "cell": [transform.a, -transform.e]}))
