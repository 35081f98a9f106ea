# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Small terrain files of the tests of regions and meshes."""

ISLAND = """libocean = 1
[terrain]
kind = "placed"
origin = [-600.0, 800.0]
size = [2400.0, 1600.0]
resolution = 64
patch_size = 2400.0
rms = 60.0
mean = 120.0
beta = 2.0
island = 300.0
[terrain.coast]
level = 3.0
"""
TILE = """libocean = 1
[terrain]
resolution = 64
patch_size = 1000.0
rms = 60.0
beta = 2.0
"""
