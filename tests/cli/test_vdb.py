# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Volumes, read by OpenVDB's own Python module and vdb_print."""

import csv
import io
import shutil
import subprocess
from pathlib import Path

import meshio
import numpy
import pytest
from conftest import GALE, OCEAN, SMALL_SEA

pyopenvdb = pytest.importorskip("pyopenvdb", reason="python3-openvdb is not installed")

N = 64
SEAS = {
    "sea": SMALL_SEA,
    "pool": """libocean = 1
[water]
depth = 1.5
[grid]
resolution = 64
patch_size = 8.0
[[waves]]
spectrum = "tma"
significant_wave_height = 0.2
peak_period = 1.4
""",
    "storm": SMALL_SEA.replace("9.0", "24.0").replace("200.0", "500.0"),
    # Crests that have folded over.
    "folded": SMALL_SEA.replace("9.0", "16.0") + "[surface]\nchoppiness = 2.2\n",
}
ACROSS = 3  # voxels that the level set knows on either side


@pytest.fixture
def bake(ocean):
    for name, text in {**SEAS, "gale": GALE}.items():
        ocean.write(f"{name}.toml", text)

    def made(sea: str, output: str, *arguments):
        ocean.good(f"bake {sea}.toml -o {output}", *arguments)
        return ocean.folder / output.split()[0]

    return made


def query(ocean, sea: str, points: numpy.ndarray, *arguments) -> dict[str, numpy.ndarray]:
    ocean.write("points.csv", "x,y\n" + "".join(f"{x!r},{y!r}\n" for x, y in points.tolist()))
    text = ocean.good("query", f"{sea}.toml", "--points", "points.csv", "--frame", 1, *arguments)
    rows = list(csv.DictReader(io.StringIO(text)))
    return {name: numpy.array([float(row[name]) for row in rows]) for name in rows[0]}


def dense(grid) -> tuple[numpy.ndarray, numpy.ndarray]:
    """All values from two voxels before the first active one, and where that is."""
    low, high = (numpy.array(end) for end in grid.evalActiveVoxelBoundingBox())
    low -= 2
    size = high - low + 3
    vector = not isinstance(grid.background, float)
    values = numpy.empty((*size, 3) if vector else size, numpy.float32)
    grid.copyToArray(values, ijk=tuple(int(i) for i in low))
    return values, low


@pytest.mark.parametrize("sea", SEAS)
def test_the_surface_is_where_the_sea_is(ocean, bake, sea):
    path = bake(sea, "s.vdb --products surface")
    grid = pyopenvdb.read(str(path), "surface")
    voxel = grid.transform.voxelSize()[0]
    values, low = dense(grid)
    inside = values < 0
    # The distance is 0 between the highest voxel of water in a column and the air above it.
    i, j = (axis.ravel() for axis in numpy.mgrid[2:N, 2:N])
    columns = inside[i - low[0], j - low[1]]
    top = columns.shape[1] - 1 - columns[:, ::-1].argmax(axis=1)
    below, above = (values[i - low[0], j - low[1], top + step] for step in (0, 1))
    height = voxel * (low[2] + top + below / (below - above))
    points = numpy.stack([i, j], -1) * voxel
    some = numpy.random.default_rng(1).choice(len(points), 400, replace=False)
    asked = query(ocean, sea, points[some], "--exact", "--no-foam")
    error = abs(height[some] - asked["height"]) / voxel
    assert error.max() < 0.05
    assert asked["height"].std() > 0.02  # there are waves
    # Distances: the gradient's length is 1, but where crests fold.
    if sea != "folded":
        near = numpy.abs(values[1:-1, 1:-1, 1:-1]) < 1.5 * voxel
        near &= (numpy.indices(near.shape)[2] + 1 + low[2]) * voxel > asked["height"].min() - voxel
        inner = near[8:-8, 8:-8]
        steps = [(values[2:, 1:-1, 1:-1] - values[:-2, 1:-1, 1:-1])[8:-8, 8:-8]]
        steps += [(values[1:-1, 2:, 1:-1] - values[1:-1, :-2, 1:-1])[8:-8, 8:-8]]
        steps += [(values[1:-1, 1:-1, 2:] - values[1:-1, 1:-1, :-2])[8:-8, 8:-8]]
        length = numpy.sqrt(sum(step**2 for step in steps)) / (2 * voxel)
        assert abs(numpy.median(length[inner]) - 1.0) < 0.02


@pytest.mark.parametrize("sea", SEAS)
def test_the_level_set_is_closed(bake, sea):
    grid = pyopenvdb.read(str(bake(sea, "s.vdb --products surface")), "surface")
    assert grid.gridClass == "level set"
    voxel = grid.transform.voxelSize()[0]
    assert grid.background == pytest.approx(ACROSS * voxel)
    # From outside one comes to no water without passing a voxel that knows its distance.
    values, _ = dense(grid)
    active = numpy.zeros(values.shape, numpy.float32)
    mask = grid.deepCopy()
    mask.mapOn(lambda _: 9.0)
    low = numpy.array(grid.evalActiveVoxelBoundingBox()[0]) - 2
    mask.copyToArray(active, ijk=tuple(int(i) for i in low))
    active = active == 9.0
    outside = numpy.zeros_like(active)
    outside[0] = outside[-1] = outside[:, 0] = outside[:, -1] = True
    outside[:, :, 0] = outside[:, :, -1] = True
    while True:
        grown = outside.copy()
        for axis in range(3):
            grown |= numpy.roll(outside, 1, axis) | numpy.roll(outside, -1, axis)
        grown &= ~active
        grown |= outside
        if (grown == outside).all():
            break
        outside = grown
    assert not (outside & (values < 0)).any()
    assert (values[~active & ~outside] < 0).all() or sea == "folded"
    # The mesh that others make of it: the faces of a box, however they are bent.
    points, quads = grid.convertToQuads()
    edges = numpy.sort(quads[:, [[0, 1], [1, 2], [2, 3], [3, 0]]].reshape(-1, 2), axis=1)
    unique, counts = numpy.unique(edges, axis=0, return_counts=True)
    if sea != "folded":
        assert (counts == 2).all()
        assert len(points) - len(unique) + len(quads) == 2
    assert (counts % 2 == 0).all()  # no hole
    size = points.max(axis=0) - points.min(axis=0)
    assert size[:2] == pytest.approx(N * voxel, abs=0.1 * voxel)


def test_the_velocity_is_that_of_the_water(ocean, bake):
    path = bake("sea", "s.vdb")
    grid = pyopenvdb.read(str(path), "vel")
    assert grid.vectorType == "contravariant relative"
    voxel = grid.transform.voxelSize()[0]
    assert voxel == pytest.approx(2 * 200 / N)
    values, low = dense(grid)
    for k in (-1, 0, 1):
        i, j = (axis.ravel()[::7] for axis in numpy.mgrid[0:32, 0:32])
        z = min(voxel * k, 0.0)  # above still water there is no more than at it
        # The waves that the voxels hold.
        points = numpy.stack([i, j], -1) * voxel
        ocean.write("coarse.toml", SMALL_SEA.replace(f"= {N}", f"= {N // 2}"))
        asked = query(ocean, "coarse", points, "--exact", "--no-foam", "--orbital", z)
        found = values[i - low[0], j - low[1], k - low[2]]
        there = numpy.abs(found).sum(axis=1) > 0
        assert there.mean() > 0.3
        for axis, name in enumerate("xyz"):
            wanted = asked[f"orbital_velocity_{name}"]
            assert wanted.std() > 0.1
            assert abs(found[there, axis] - wanted[there]).max() < 0.01 * wanted.std()


def test_axes_boxes_and_halves(ocean, bake):
    box = ["--box", "10,20,-12,60,70,crest", "--voxel", "1.5", "--velocity-voxel", "2"]
    upright = pyopenvdb.read(str(bake("sea", "z.vdb", *box)), "surface")
    turned, velocity = (
        pyopenvdb.read(str(bake("sea", "y.vdb", *box, "--axes", "yup")), name)
        for name in ("surface", "vel")
    )
    z, low_z = dense(upright)
    y, low_y = dense(turned)
    # (x, y, z) -> (x, z, -y)
    assert (y == z.transpose(0, 2, 1)[:, :, ::-1]).all()
    assert low_y[0] == low_z[0] and low_y[1] == low_z[2]
    still = pyopenvdb.read(str(ocean.folder / "z.vdb"), "vel")
    v, w = dense(still)[0], dense(velocity)[0]
    expected = v[..., [0, 2, 1]].transpose(0, 2, 1, 3)[:, :, ::-1] * [1, 1, -1]
    assert (w == expected).all() and numpy.abs(w).max() > 0.2
    points, _ = upright.convertToQuads()
    assert points.min(axis=0) == pytest.approx([10, 20, -12], abs=0.1)
    assert points.max(axis=0)[:2] == pytest.approx([60, 70], abs=0.1)
    # A box below the crests is full to its top.
    deep, _ = pyopenvdb.read(
        str(bake("sea", "d.vdb", "--box", "0,0,-30,40,40,-10", "--products", "surface")), "surface"
    ).convertToQuads()
    assert deep.max(axis=0)[2] == pytest.approx(-10, abs=0.1)
    half = bake("sea", "h.vdb", *box, "--type", "half")
    assert half.stat().st_size < 0.8 * (ocean.folder / "z.vdb").stat().st_size
    rough = dense(pyopenvdb.read(str(half), "surface"))[0]
    assert abs(rough - z).max() < 2e-3 * ACROSS * 1.5
    if shutil.which("vdb_print"):
        told = subprocess.run(["vdb_print", "-l", str(half)], capture_output=True, text=True)
        assert told.returncode == 0 and "is_saved_as_half_float: true" in told.stdout
        assert "Name: vel" in told.stdout and "class: level set" in told.stdout


def test_mist_hangs_over_the_crests(ocean, bake):
    arguments = ["--products", "density", "--velocity-voxel", "1.25"]
    box = ["--box", "-20,30,-9,120,150,crest"]
    path = bake("gale", "m.vdb", *arguments, *box)
    grid = pyopenvdb.read(str(path), "density")
    assert grid.gridClass == "fog volume"
    assert grid.background == 0.0
    values, low = dense(grid)
    there = numpy.argwhere(values > 0) + low
    assert len(there) > 1000
    voxel = 1.25
    # None of it more than half a voxel under water, most of it within a few metres above.
    some = numpy.random.default_rng(2).choice(len(there), 400, replace=False)
    asked = query(ocean, "gale", there[some, :2] * voxel, "--no-foam")["height"]
    above = there[some, 2] * voxel - asked
    assert above.min() > -0.51 * voxel
    assert (above < 8.0).mean() > 0.8
    # The period's copies: what is here is there.
    whole = bake("gale", "w.vdb", *arguments, "--box", "-160,0,-9,160,160,crest")
    tiles, corner = dense(pyopenvdb.read(str(whole), "density"))
    n = int(160 / voxel)
    i = numpy.arange(20, n - 20) - corner[0]
    assert numpy.allclose(tiles[i], tiles[i - n], rtol=1e-3, atol=2e-5)
    assert tiles[i].max() > 0.002
    # Twice as much.
    path = bake("gale", "2.vdb", *arguments, *box, "--mist", 0.1)
    twice = dense(pyopenvdb.read(str(path), "density"))
    inner = values > 1e-4
    assert twice[0].shape == values.shape
    assert numpy.allclose(twice[0][inner], 2 * values[inner], rtol=1e-4)
    told = ocean("bake sea.toml -o calm.vdb --products density --set wind_speed=5")
    assert told.returncode == 0 and "no spray" in told.stderr


def test_spray_is_points(ocean, bake):
    arguments = ["--products", "spray"]
    ocean.good("bake gale.toml -o s.ply", *arguments)
    volume = bake("gale", "s.vdb", *arguments)
    points = meshio.read(ocean.folder / "s.ply").points
    assert len(points) > 100
    if shutil.which("vdb_print"):
        told = subprocess.run(
            ["vdb_print", "-l", str(volume)],
            capture_output=True, text=True, check=True,
        ).stdout  # fmt: skip
        assert "ptdataidx" in told and "Name: spray" in told
        cells = len(numpy.unique(numpy.round(points / (160 / 64)), axis=0))
        assert f"active voxels:       {cells:,}" in told
    # Another density, other points.
    few = bake("gale", "d.vdb", "--products", "spray", "--spray-density", "0.1")
    assert few.stat().st_size < volume.stat().st_size


def test_a_volume_tells_its_sea_and_its_grids(ocean, bake):
    path = bake("sea", "s.vdb")
    told = [ocean.good("info", name).splitlines() for name in ("s.vdb", "sea.toml")]
    assert [line for line in told[0][1:] if "about" not in line] == [
        line for line in told[1][1:] if "about" not in line
    ]
    assert {grid["name"] for grid in pyopenvdb.readAllGridMetadata(str(path))} == {"surface", "vel"}


def test_a_box_without_water_is_warned_of(ocean):
    done = ocean("bake sea.toml -o s.vdb --box 0,0,20,40,40,30")
    assert done.returncode == 0 and "no water reaches the box" in done.stderr


@pytest.mark.parametrize("size", [4, 30, 60, 200])
def test_headers_that_end_early_are_refused(ocean, bake, size):
    content = bake("sea", "s.vdb").read_bytes()
    ocean.write("cut.vdb", content[:size])
    assert "cut.vdb" in ocean.bad("info cut.vdb")


def test_a_start_does_not_load_openvdb():
    """Its symbols cost 50 ms, which every run of the command would pay."""
    needed = subprocess.run(["ldd", OCEAN], check=True, capture_output=True, text=True).stdout
    assert "libOpenEXR" in needed and "openvdb" not in needed


def test_a_module_of_something_else_is_said(ocean, bake, monkeypatch):
    bake("sea", "before.vdb", "--voxel", "4")
    shutil.copy(next(Path("/usr/lib").glob("*/libz.so.1")), ocean.folder / "ocean_vdb.so")
    monkeypatch.setenv("LD_LIBRARY_PATH", str(ocean.folder))
    done = ocean("bake sea.toml -o s.vdb --voxel 4")
    assert done.returncode == 1
    assert "ocean_vdb.so is of another libocean than this" in done.stderr.splitlines()[-1]
    assert "s.vdb" not in ocean.files(".")
