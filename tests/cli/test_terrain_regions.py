# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Regions of a land in the files of each format, read by the libraries of other programs.

Claims: a region has the samples, the places and the bits that the land has there, in every format
and where it is no square; neighbouring regions join without a seam, in a GIS program too.
"""

import json
import subprocess
import sys
from pathlib import Path

import meshio
import numpy
import OpenImageIO as oiio
import pytest
from lands import ISLAND, TILE

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path += [str(path) for path in ROOT.glob(".venv/lib/python3.*/site-packages")]

GULLIED = (
    TILE
    + """[terrain.gullies]
longest = 250.0
"""
)
CELL = 10.0
WEST, SOUTH, COLUMNS, ROWS = 300.0, 1400.0, 61, 36  # not a square
REGION = ["--region", "300,1400,900,1750", "--cell", "10"]
LANDS = {"island": ISLAND, "tile": GULLIED}


def read_exr(path):
    """[j, i] from the south."""
    image = oiio.ImageInput.open(str(path))
    pixels = image.read_image("float")
    image.close()
    return pixels[::-1, :, 0]


class Part:
    """A region of a land, and its heights [j, i] from the south, cut out of a larger one."""

    def __init__(self, ocean, name: str):
        self.ocean, self.name = ocean, name
        ocean.write("land.toml", LANDS[name])
        wide = ["--region", "200,1300,1000,1800", "--cell", "10"]
        ocean.good("terrain land.toml", *wide, "-o", "wide.exr")
        whole = read_exr(ocean.folder / "wide.exr")
        assert whole.shape == (51, 81)
        self.heights = whole[10 : 10 + ROWS, 10 : 10 + COLUMNS].astype(float)

    def bake(self, name: str, *arguments):
        self.ocean.good("terrain land.toml", *REGION, "-o", name, *arguments)
        return self.ocean.folder / name

    def has_its_points(self, points):
        grid = points.reshape(ROWS, COLUMNS, 3).astype(float)
        assert abs(grid[:, :, 0] - (WEST + CELL * numpy.arange(COLUMNS))).max() < 1e-4
        assert abs(grid[:, :, 1] - (SOUTH + CELL * numpy.arange(ROWS))[:, None]).max() < 1e-4
        assert (grid[:, :, 2] == self.heights).all()


@pytest.fixture(params=LANDS)
def part(ocean, request):
    return Part(ocean, request.param)


def test_an_exr_has_the_bits_of_the_land(part):
    assert (read_exr(part.bake("r.exr")) == part.heights).all()
    mask = "cliff" if part.name == "island" else "wear"
    part.bake("m.exr", "--products", f"height,{mask}")
    assert read_exr(part.ocean.folder / f"m.{mask}.0001.exr").shape == (ROWS, COLUMNS)


def test_neighbouring_geotiffs_merge_without_a_seam(part):
    pythons = list(ROOT.glob(".venv/bin/python"))
    if not pythons or not list(ROOT.glob(".venv/lib/python3.*/site-packages/rasterio")):
        pytest.skip("rasterio is not in .venv; scripts/test installs it")
    halves = ["300,1400,600,1750", "600,1400,900,1750"]
    for name, half in zip(("west.tif", "east.tif"), halves, strict=True):
        part.ocean.good("terrain land.toml --region", half, "--cell", "10", "-o", name)
    judge = Path(__file__).with_name("region_judge.py")
    done = subprocess.run(
        [pythons[0], judge, "merged.npy", "west.tif", "east.tif"],
        cwd=part.ocean.folder,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    said = json.loads(done.stdout)
    merged = numpy.load(part.ocean.folder / "merged.npy")[::-1]
    assert merged.shape == (ROWS, COLUMNS) and (merged == part.heights).all()
    assert said["first"] == [WEST, SOUTH + CELL * (ROWS - 1)] and said["cell"] == [CELL, CELL]


def test_ply_and_obj_have_its_points(part):
    ply = meshio.read(part.bake("r.ply"))
    part.has_its_points(ply.points)
    assert len(ply.cells_dict["triangle"]) == 2 * (ROWS - 1) * (COLUMNS - 1)
    lines = part.bake("r.obj").read_text().splitlines()
    points = [line.split()[1:4] for line in lines if line.startswith("v ")]
    part.has_its_points(numpy.array(points, numpy.float32))


def test_meshes_have_masks_as_attributes(part):
    mask = "cliff" if part.name == "island" else "wear"
    ply = meshio.read(part.bake("r.ply", "--products", f"normal,{mask}"))
    part.bake("m.exr", "--products", mask, "--type", "float")
    truth = read_exr(part.ocean.folder / "m.exr")
    assert (ply.point_data[mask].reshape(ROWS, COLUMNS) == truth).all() and truth.max() > 0.3


def test_usd_has_its_points(part):
    try:
        from pxr import Usd, UsdGeom
    except ImportError:
        pytest.skip("usd-core is not in .venv; scripts/test installs it")
    stage = Usd.Stage.Open(str(part.bake("r.usda")))
    mesh = UsdGeom.Mesh(stage.GetDefaultPrim())
    part.has_its_points(numpy.array(mesh.GetPointsAttr().Get(1)))
    assert len(mesh.GetFaceVertexCountsAttr().Get()) == (ROWS - 1) * (COLUMNS - 1)


def test_a_level_set_is_0_at_its_ground(part):
    pyopenvdb = pytest.importorskip("pyopenvdb", reason="python3-openvdb is not installed")
    grid = pyopenvdb.read(str(part.bake("r.vdb")), "surface")
    voxel = grid.transform.voxelSize()[0]
    values = grid.getConstAccessor()
    random = numpy.random.default_rng(1)
    for _ in range(60):
        i, j = int(random.integers(4, COLUMNS - 4)), int(random.integers(4, ROWS - 4))
        at = [round((WEST + CELL * i) / voxel), round((SOUTH + CELL * j) / voxel)]
        height = part.heights[j, i]
        below = int(numpy.floor(height / voxel))
        low, high = values.getValue((*at, below)), values.getValue((*at, below + 1))
        assert low <= 0.0 <= high
        assert abs(voxel * (below + low / (low - high)) - height) < 0.3


def test_a_png_is_right_to_half_its_quantum(part):
    path = part.bake("r.png")
    image = oiio.ImageInput.open(str(path))
    codes = image.read_image("uint16")[::-1, :, 0].astype(float)
    image.close()
    words = dict(
        line.split("#")[0].split(" = ")
        for line in path.with_suffix(".png.txt").read_text().splitlines()
        if " = " in line and not line.startswith("#")
    )
    base, scale = float(words["base"]), float(words["scale"])
    assert codes.shape == (ROWS, COLUMNS)
    assert abs(base + scale * codes / 65536 - part.heights).max() <= 0.5001 * scale / 65536
    assert words["origin"].strip() == "[300, 1400]" and words["size"].strip() == "[600, 350]"
