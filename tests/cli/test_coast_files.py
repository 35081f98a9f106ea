# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Regions, volumes and spray of a coast, read by pyopenvdb and meshio. Its other files are in
test_files_read_by_others.py."""

import meshio
import numpy as np
import pytest
from coasts import REGION, image

import libocean

BAKE = ("bake", "sea.toml", *REGION, "--frames", "9", "-q")


def test_without_a_region_the_whole_bed_is_baked(coast):
    coast.good("bake sea.toml -o s.exr --products height")
    assert image(coast.folder / "s.exr").shape == (26, 46)


def test_a_volume_of_a_coast_has_the_motion_of_its_water(coast):
    """At 1 m below still water, where the ground is deeper."""
    pyopenvdb = pytest.importorskip("pyopenvdb", reason="python3-openvdb is not installed")
    coast.good(*BAKE, "-o", "s.vdb", "--voxel", "1", "--products", "surface,vel")
    vel = pyopenvdb.read(str(coast.folder / "s.vdb"), "vel")
    size = vel.transform.voxelSize()[0]
    assert size == 2.0
    deep = np.stack([a.ravel() for a in np.mgrid[44:110:6, 24:78:6]], -1)
    with libocean.open(coast.folder / "sea.toml") as sea:
        expected = sea.orbital_velocity(np.float64(deep), sea.time_of_frame(9), -2.0)
    reader = vel.getConstAccessor()
    read = np.array([reader.getValue((int(x / size), int(y / size), -1)) for x, y in deep])
    assert np.abs(read - expected).max() < 1e-5
    assert expected.std(axis=0).min() > 0.02


def test_spray_of_a_coast_is_points_and_mist_over_the_surf(coast):
    pyopenvdb = pytest.importorskip("pyopenvdb", reason="python3-openvdb is not installed")
    gale = ("--set", "wind_speed=14", "--set", "foam_step=0.2", "--spray-density", "4")
    coast.good(*BAKE, "-o", "s.ply", "--products", "spray", *gale)
    points = meshio.read(coast.folder / "s.ply").points
    # Over the whole bed, whatever the region, and one wind's way beyond.
    assert len(points) > 200
    assert points[:, 0].min() > -5.0 and points[:, 0].max() < 180.0 + 60.0
    assert (points[:, 0] > 90.0).mean() > 0.2  # the surf begins where 4.5 m are left
    coast.good(*BAKE, "-o", "s.vdb", "--products", "density", "--voxel", "2", *gale)
    mist = pyopenvdb.read(str(coast.folder / "s.vdb"), "density")
    assert mist.gridClass == "fog volume" and mist.activeVoxelCount() > 50
    low, high = mist.evalActiveVoxelBoundingBox()
    assert low[0] * mist.transform.voxelSize()[0] >= 40.0 - 4.0
    assert high[0] * mist.transform.voxelSize()[0] <= 160.0 + 4.0
