# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`--lod`: the land around an eye as one mesh.

Claims: each inner edge of a written mesh has two triangles, in opposite directions, and no triangle
looks down; the open border is that of the land, or beyond --farthest; a vertex has the height and
the normal of the land at its place, for its level; masks are attributes; PLY, OBJ and USD hold one
mesh.
"""

import re
import sys
from pathlib import Path

import meshio
import numpy
import OpenImageIO as oiio
import pytest
from lands import ISLAND, TILE

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path += [str(path) for path in ROOT.glob(".venv/lib/python3.*/site-packages")]

LOW, HIGH = (-600.0, 800.0), (1800.0, 2400.0)
EYE = "101.3,1503.7,150"


class Around:
    """A written mesh: positions, triangles, data of vertices."""

    def __init__(self, path):
        ply = meshio.read(path)
        self.points = ply.points.astype(float)
        self.data = ply.point_data
        self.triangles = ply.cells_dict["triangle"].astype(numpy.int64)

    def normals(self):
        return numpy.stack([self.data[name] for name in ("nx", "ny", "nz")], -1).astype(float)

    def open_edges(self):
        """Vertices of edges with one triangle; all others have two, in opposite directions."""
        t = self.triangles
        edges = numpy.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]])
        keys = edges[:, 0] << 32 | edges[:, 1]
        assert len(numpy.unique(keys)) == len(keys), "an edge twice in one direction"
        return edges[~numpy.isin(keys, edges[:, 1] << 32 | edges[:, 0])]

    def is_seen_from_above(self):
        a, b, c = (self.points[self.triangles[:, k]] for k in range(3))
        assert (numpy.cross(b - a, c - a)[:, 2] > 0).all()


def read_exr(path):
    image = oiio.ImageInput.open(str(path))
    pixels = image.read_image("float")
    image.close()
    return pixels[::-1, :, 0]


def test_the_mesh_of_an_island_is_closed_up_to_its_sides(ocean):
    ocean.write("land.toml", ISLAND)
    done = ocean("terrain land.toml -o l.ply --lod", EYE, "-n")
    most = int(re.search(r"at most (\d+) triangles, up to \d+ m from the eye", done.stderr)[1])
    assert not (ocean.folder / "l.ply").exists()
    ocean.good("terrain land.toml -o l.ply --lod", EYE, "--products", "normal,cliff")
    mesh = Around(ocean.folder / "l.ply")
    assert 0.5 * most < len(mesh.triangles) <= most
    mesh.is_seen_from_above()
    border = mesh.points[mesh.open_edges()].reshape(-1, 3)
    on_side = numpy.zeros(len(border), bool)
    for axis in 0, 1:
        on_side |= (border[:, axis] == LOW[axis]) | (border[:, axis] == HIGH[axis])
        assert mesh.points[:, axis].min() == LOW[axis] and mesh.points[:, axis].max() == HIGH[axis]
    assert on_side.all()
    # An eye 150 m up sees 2 m and more: 3 % of the island's area has a tenth of the vertices.
    near = numpy.hypot(*(mesh.points[:, :2] - [101.3, 1503.7]).T) < 200
    assert near.mean() > 0.1
    assert mesh.data["cliff"].max() > 0.9 and mesh.data["cliff"].min() == 0
    # uv are sides of the land.
    u = (mesh.points[:, 0] - LOW[0]) / 2400.0
    assert abs(mesh.data["s"] - u).max() < 1e-6


@pytest.mark.parametrize("land", ["island", "tile"])
def test_vertices_have_the_heights_and_normals_of_the_land(ocean, land):
    ocean.write("land.toml", ISLAND if land == "island" else TILE)
    eye = "100,1500,0.5"
    ocean.good("terrain land.toml -o l.ply --lod", eye, "--farthest", "900")
    mesh = Around(ocean.folder / "l.ply")
    middle = numpy.array([100.0, 1500.0])
    # Vertices of a level that has not begun to morph lie on its lattice and have its heights. The
    # height of the eye over the ground counts: what is d from it is at most as fine as d says.
    for cell in 0.5, 1.0, 2.0, 4.0:
        half = min(80 * cell, 250.0)
        low = middle - half
        region = f"{low[0]},{low[1]},{low[0] + 2 * half},{low[1] + 2 * half}"
        more = ["--products", "height,normal", "--type", "float", "--axes", "zup"]
        where = ["--region", region, "--cell", cell]
        ocean.good("terrain land.toml", *where, "-o", f"r{cell}.exr", *more)
        heights = read_exr(ocean.folder / f"r{cell}.height.0001.exr")
        index = (mesh.points[:, :2] - low) / cell
        on = (index == numpy.round(index)).all(axis=1) & (index >= 0).all(axis=1)
        on &= (index <= 2 * half / cell).all(axis=1)
        i, j = index[on].astype(int).T
        error = abs(heights[j, i] - mesh.points[on, 2])
        # Those of this level: a lattice that no finer vertex shares.
        same = error < 1e-4
        distance = numpy.hypot(*(mesh.points[on, :2] - middle).T)
        drop = abs(
            mesh.points[numpy.argmin(numpy.hypot(*(mesh.points[:, :2] - middle).T)), 2] - 0.5
        )
        d = numpy.hypot(distance, drop)
        own = (d > 70 * cell * 1.03) & (d < 0.585 * 140 * cell * 0.97)
        if own.sum() == 0:
            continue
        print(land, cell, own.sum(), error[own].max())
        assert same[own].all()
        image = oiio.ImageInput.open(str(ocean.folder / f"r{cell}.normal.0001.exr"))
        normals = image.read_image("float")[::-1][j[own], i[own], :3]
        image.close()
        assert abs(normals - mesh.normals()[on][own]).max() < 1e-4


def test_a_tile_repeats_up_to_the_farthest(ocean):
    ocean.write("land.toml", TILE)
    ocean.good("terrain land.toml -o l.ply --lod 0,0,400")
    mesh = Around(ocean.folder / "l.ply")
    mesh.is_seen_from_above()
    border = mesh.points[mesh.open_edges()].reshape(-1, 3)
    assert numpy.hypot(border[:, 0], border[:, 1]).min() >= 150e3
    assert mesh.data["s"].max() > 100 and len(mesh.triangles) < 1e6
    ocean.good("terrain land.toml -o n.ply --lod 0,0,400 --farthest 5000")
    near = Around(ocean.folder / "n.ply")
    border = near.points[near.open_edges()].reshape(-1, 3)
    assert 5000 <= numpy.hypot(border[:, 0], border[:, 1]).min() < 20000


def test_far_from_the_origin_vertices_are_as_far_apart_as_floats_can_tell(ocean):
    ocean.write("land.toml", TILE)
    eye = "5000000.3,700000,60"
    ocean.good("terrain land.toml -o l.ply --lod", eye, "--farthest", "800")
    mesh = Around(ocean.folder / "l.ply")
    assert len(numpy.unique(mesh.points, axis=0)) == len(mesh.points)
    mesh.open_edges()
    mesh.is_seen_from_above()


def test_ply_obj_and_usd_hold_one_mesh(ocean):
    ocean.write("land.toml", ISLAND)
    options = ["--lod", EYE, "--farthest", "700", "--products"]
    ocean.good("terrain land.toml -o l.ply", *options, "normal,cliff,shelter")
    ocean.good("terrain land.toml -o l.obj", *options, "normal,cliff")
    ocean.good("terrain land.toml -o l.usda", *options, "normal,cliff,shelter")
    mesh = Around(ocean.folder / "l.ply")
    lines = (ocean.folder / "l.obj").read_text().splitlines()
    points = numpy.array([line.split()[1:4] for line in lines if line.startswith("v ")], float)
    assert abs(points - mesh.points).max() < 1e-3
    faces = [
        [part.split("/")[0] for part in line.split()[1:]] for line in lines if line[:2] == "f "
    ]
    assert (numpy.array(faces, int) - 1 == mesh.triangles).all()
    try:
        from pxr import Usd, UsdGeom
    except ImportError:
        pytest.skip("usd-core is not in .venv; scripts/test installs it")
    stage = Usd.Stage.Open(str(ocean.folder / "l.usda"))
    prim = UsdGeom.Mesh(stage.GetDefaultPrim())
    assert (numpy.array(prim.GetPointsAttr().Get(1)) == mesh.points).all()
    assert (numpy.array(prim.GetNormalsAttr().Get(1)) == mesh.normals()).all()
    assert set(prim.GetFaceVertexCountsAttr().Get()) == {3}
    indices = numpy.array(prim.GetFaceVertexIndicesAttr().Get()).reshape(-1, 3)
    assert (indices == mesh.triangles).all()
    primvars = UsdGeom.PrimvarsAPI(prim)
    assert (numpy.array(primvars.GetPrimvar("cliff").Get(1)) == mesh.data["cliff"]).all()
    assert len(primvars.GetPrimvar("st").Get(1)) == len(mesh.points)
