# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Files of a coast, read back by the programs of others: EXR by OpenImageIO, PLY and OBJ by meshio,
USD by usd-core, VDB by pyopenvdb. Each has the surface that queries find at its places."""

import csv
import io
import sys
from pathlib import Path

import meshio
import numpy as np
import OpenImageIO
import pytest
from coasts import BEACH, REGION, image

ROOT = Path(__file__).resolve().parent.parent.parent
COLUMNS, ROWS, CELL = 31, 16, 4.0
ORIGIN = np.array([40.0, 20.0])
BAKE = ("bake", "sea.toml", *REGION, "--frames", "9", "-q")


def labels():
    """The undisplaced places of the region, the southern row first."""
    x, y = np.meshgrid(ORIGIN[0] + CELL * np.arange(COLUMNS), ORIGIN[1] + CELL * np.arange(ROWS))
    return np.stack([x, y], -1)


def query(coast, places, *arguments):
    """Columns of what `ocean query` finds at places (n, 2), by name."""
    coast.write("points.csv", "x,y\n" + "".join(f"{x!r},{y!r}\n" for x, y in places.tolist()))
    text = coast.good("query sea.toml --points points.csv --frame 9 --no-foam", *arguments)
    rows = list(csv.DictReader(io.StringIO(text)))
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


def check_surface(coast, points):
    """points (n, 3) of the region in the order of its labels, z up."""
    found = query(coast, np.float64(points[:, :2]))
    height = found["height"].std() * 4.0
    assert height > 0.3
    # A file has coordinates in single precision, 160 m from 0: slopes turn their last bits into
    # heights.
    assert np.abs(points[:, 2] - found["height"]).max() < 1e-5 * height + 1e-5
    offset = points[:, :2] - labels().reshape(-1, 2)
    assert 0.05 < np.abs(offset).max() < 3.0


def test_images_hold_the_region_and_where_it_lies(coast):
    coast.good(
        *BAKE, "-o", "s.exr", "--products", "displacement,depth,velocity", "--type", "float",
        "--axes", "zup",
    )  # fmt: skip
    offsets = image(coast.folder / "s.displacement.0009.exr")
    places = labels() + offsets[..., :2]
    points = np.dstack([places, offsets[..., 2]]).reshape(-1, 3)
    check_surface(coast, points)
    # The ground is linear between its samples: depth = height - bed at the displaced place.
    bed = np.interp(places[..., 0], 4.0 * np.arange(46), np.round(BEACH[0], 3))
    depth = image(coast.folder / "s.depth.0009.exr")
    assert np.abs(depth - (offsets[..., 2] - bed)).max() < 1e-4
    found = query(coast, places.reshape(-1, 2))
    velocity = image(coast.folder / "s.velocity.0009.exr").reshape(-1, 3)
    for axis, name in enumerate(("velocity_x", "velocity_y", "velocity_z")):
        assert np.abs(velocity[:, axis] - found[name]).max() < 1e-3
    header = OpenImageIO.ImageBuf(str(coast.folder / "s.depth.0009.exr")).spec()
    assert (header["ocean:origin"], header["ocean:size"]) == ("40,20", "120,60")
    assert (header["ocean:samples"], header["ocean:wraps"]) == ("31,16", "no")
    assert "[water.bed_heights]" in header["ocean:sea"]


def test_meshes_have_the_vertices_of_the_region(coast):
    for extension in ("ply", "obj"):
        coast.good(*BAKE, "-o", f"s.{extension}", "--products", "normal,foam")
    ply = meshio.read(coast.folder / "s.ply")
    assert len(ply.points) == COLUMNS * ROWS
    check_surface(coast, ply.points)
    triangles = ply.cells_dict["triangle"]
    assert triangles.shape == (2 * (COLUMNS - 1) * (ROWS - 1), 3)
    a, b, c = (ply.points[triangles[:, i]] for i in range(3))
    assert (np.cross(b - a, c - a)[:, 2] > 0).all()
    lines = (coast.folder / "s.obj").read_text().splitlines()
    vertices = np.array([line.split()[1:4] for line in lines if line.startswith("v ")], "f4")
    assert (vertices == ply.points).all()
    found = query(coast, np.float64(ply.points[:, :2]))
    for axis in "xyz":
        assert np.abs(ply.point_data[f"n{axis}"] - found[f"normal_{axis}"]).max() < 1e-3


def test_a_stage_has_the_mesh_and_its_masks(coast):
    sys.path += [str(path) for path in ROOT.glob(".venv/lib/python3.*/site-packages")]
    pxr = pytest.importorskip("pxr", reason="usd-core is not in .venv; scripts/test installs it")
    from pxr import Usd, UsdGeom  # noqa: PLC0415

    assert pxr
    coast.good(*BAKE, "-o", "s.usda", "--products", "normal,foam,depth,breaking,wetness")
    coast.good(*BAKE, "-o", "s.exr", "--products", "depth,breaking,wetness,foam", "--type", "float")
    stage = Usd.Stage.Open(str(coast.folder / "s.usda"))
    assert UsdGeom.GetStageUpAxis(stage) == "Z" and UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    mesh = UsdGeom.Mesh(stage.GetDefaultPrim())
    check_surface(coast, np.array(mesh.GetPointsAttr().Get(9)))
    transform = UsdGeom.Xformable(mesh).GetLocalTransformation()
    assert np.allclose(transform, np.eye(4))
    names = UsdGeom.PrimvarsAPI(mesh)
    for mask in ("depth", "breaking", "wetness", "foam"):
        values = np.array(names.GetPrimvar(mask).Get(9))
        expected = image(coast.folder / f"s.{mask}.0009.exr").ravel()
        assert (values == expected).all() and values.std() > 0.01, mask


def test_a_volume_of_a_coast_is_where_its_water_is(coast):
    pyopenvdb = pytest.importorskip("pyopenvdb", reason="python3-openvdb is not installed")
    coast.good(*BAKE, "-o", "s.vdb", "--voxel", "1", "--products", "surface,vel")
    grid = pyopenvdb.read(str(coast.folder / "s.vdb"), "surface")
    assert grid.gridClass == "level set" and grid.transform.voxelSize()[0] == 1.0
    low, high = (np.array(end) for end in grid.evalActiveVoxelBoundingBox())
    values = np.empty(tuple(high - low + 1), np.float32)
    grid.copyToArray(values, ijk=tuple(int(i) for i in low))
    # From 40 .. 160, 20 .. 80 m, with a band of three voxels around.
    assert (low[:2] <= [40, 20]).all() and (high[:2] >= [160, 80]).all()
    i, j = (axis.ravel() for axis in np.mgrid[41:160:3, 21:80:3])
    columns = values[i - low[0], j - low[1]] < 0
    assert columns.any(axis=1).all()
    top = columns.shape[1] - 1 - columns[:, ::-1].argmax(axis=1)
    below, above = (values[i - low[0], j - low[1], top + step] for step in (0, 1))
    height = low[2] + top + below / (below - above)
    found = query(coast, np.float64(np.stack([i, j], -1)))
    assert np.abs(height - found["height"]).max() < 0.05
    # The water's velocity at 1 m below still water, where the ground is deeper.
    vel = pyopenvdb.read(str(coast.folder / "s.vdb"), "vel")
    size = vel.transform.voxelSize()[0]
    assert size == 2.0
    deep = np.stack([a.ravel() for a in np.mgrid[44:110:6, 24:78:6]], -1)
    found = query(coast, np.float64(deep), "--orbital", "-2")
    reader = vel.getConstAccessor()
    read = np.array([reader.getValue((int(x / size), int(y / size), -1)) for x, y in deep])
    for axis, name in enumerate("xyz"):
        expected = found[f"orbital_velocity_{name}"]
        assert np.abs(read[:, axis] - expected).max() < 1e-5, name
        assert expected.std() > 0.02


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
