# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The files of a terrain, each read by the libraries of other programs.

Claims: heights are right to what each format states, also 2000 m above the sea; a tile and a
rectangle of 2 x 3 tiles have their samples, their places and a closed seam.
"""

import json
import re
import struct
import subprocess
import sys
import zlib
from pathlib import Path

import meshio
import numpy
import OpenImageIO as oiio
import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path += [str(path) for path in ROOT.glob(".venv/lib/python3.*/site-packages")]

N, PERIOD, MEAN = 64, 1000.0, 2000.0
CELL = PERIOD / N
HILLS = f"""libocean = 1
[terrain]
resolution = {N}
patch_size = {PERIOD}
rms = 60.0
mean = {MEAN}
beta = 2.2
"""
TILES = {"1x1": (1, 1), "2x3": (2, 3)}


def read_exr(path):
    """[j, i, c] from the south, and the types of the channels."""
    image = oiio.ImageInput.open(str(path))
    spec, pixels = image.spec(), image.read_image("float")
    image.close()
    return pixels[::-1], {
        name: str(spec.channelformat(c)) for c, name in enumerate(spec.channelnames)
    }


class Hills:
    """A terrain with some tiles, and its heights [j, i] from the south."""

    def __init__(self, ocean, tiles: str):
        self.ocean, self.folder, self.tiles = ocean, ocean.folder, tiles
        self.columns, self.rows = (count * N for count in TILES[tiles])
        ocean.write("hills.toml", HILLS)
        self.heights = read_exr(self.bake("reference.exr"))[0][:, :, 0].astype(float)
        assert self.heights.shape == (self.rows, self.columns)

    def bake(self, name: str, *arguments):
        options = [] if self.tiles == "1x1" else ["--tiles", self.tiles]
        self.ocean.good("terrain hills.toml", *options, "-o", name, *arguments)
        return self.folder / name

    def closed(self, values=None):
        """Heights, or other maps, with the seam: the first column and row again at the end."""
        values = self.heights if values is None else values
        edges = [(0, 1), (0, 1)] + [(0, 0)] * (values.ndim - 2)
        return numpy.pad(values, edges, mode="wrap")


@pytest.fixture(params=TILES)
def hills(ocean, request):
    return Hills(ocean, request.param)


def test_exr_has_heights_as_floats_and_normals_as_halves(hills):
    hills.bake("t.exr", "--products", "height,normal,slope")
    height, types = read_exr(hills.folder / "t.height.0001.exr")
    assert types == {"Y": "float"} and (height[:, :, 0] == hills.heights).all()
    assert abs(hills.heights.mean() - MEAN) < 1e-3 and abs(hills.heights.std() - 60.0) < 1e-3
    normal, types = read_exr(hills.folder / "t.normal.0001.exr")
    assert set(types.values()) == {"half"} and normal.shape == (hills.rows, hills.columns, 3)
    slope, types = read_exr(hills.folder / "t.slope.0001.exr")
    assert set(types.values()) == {"half"}
    # A half is metres off at this height: whoever wants it says so.
    half, types = read_exr(hills.bake("half.exr", "--type", "half"))
    assert types == {"Y": "half"} and abs(half[:, :, 0] - hills.heights).max() > 0.4
    _, types = read_exr(hills.bake("l.exr", "--products", "height,normal", "--layout", "layered"))
    assert types == {
        "height.V": "float",
        "normal.X": "half",
        "normal.Y": "half",
        "normal.Z": "half",
    }


def chunks(png: bytes):
    at = 8
    while at < len(png):
        length, name = struct.unpack(">I4s", png[at : at + 8])
        content = png[at + 8 : at + 8 + length]
        assert struct.unpack(">I", png[at + 8 + length : at + 12 + length])[0] == zlib.crc32(
            name + content
        )
        yield name.decode(), content
        at += 12 + length


def test_a_png_states_its_range_and_is_right_to_half_its_quantum(hills):
    path = hills.bake("t.png")
    image = oiio.ImageInput.open(str(path))
    codes = image.read_image("uint16")[::-1, :, 0].astype(float)
    image.close()
    texts = dict(
        content.split(b"\0", 1) for name, content in chunks(path.read_bytes()) if name == "tEXt"
    )
    low, high = (float(word) for word in texts[b"ocean:range"].split(b","))
    quantum = float(texts[b"ocean:quantum"])
    assert numpy.isclose(quantum, (high - low) / 65535)
    truth = hills.closed()
    assert float(texts[b"ocean:lo"]) == truth.min() and float(texts[b"ocean:hi"]) == truth.max()
    error = abs(low + (high - low) * codes / 65535 - truth).max()
    assert 0.4 * quantum < error <= 0.5001 * quantum
    base, scale = re.fullmatch(
        rb"height \[m\] = (\S+) \+ (\S+) \* code / 65536", texts[b"Description"]
    ).groups()
    assert float(base) == low and numpy.isclose(float(scale), 65536 * quantum)
    beside = (hills.folder / "t.png.txt").read_text()
    assert f"base = {base.decode()}\n" in beside and f"scale = {scale.decode()}\n" in beside
    # Another format, from it.
    hills.ocean.good("terrain --from t.png -o from_png.exr")
    assert (hills.folder / "from_png.exr").read_bytes() == (
        hills.folder / "reference.exr"
    ).read_bytes()


def test_a_geotiff_has_the_heights_and_places_of_the_map(hills):
    pythons = list(ROOT.glob(".venv/bin/python"))
    if not pythons or not list(ROOT.glob(".venv/lib/python3.*/site-packages/rasterio")):
        pytest.skip("rasterio is not in .venv; scripts/test installs it")
    path = hills.bake("t.tif")
    judge = Path(__file__).with_name("terrain_judge.py")
    done = subprocess.run(
        [pythons[0], judge, path, hills.folder / "read.npy"], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    said = json.loads(done.stdout)
    heights = numpy.load(hills.folder / "read.npy")[::-1]  # the first row is the northern one
    assert heights.shape == hills.heights.shape and (heights == hills.heights).all()
    assert said["readers_agree"] and said["type"] == "float32" and said["nodata"] is None
    assert said["first"] == [0.0, (hills.rows - 1) * CELL] and said["cell"] == [CELL, CELL]
    assert said["area_or_point"] == "Point"
    assert (
        'LOCAL_CS["libocean: local grid in metres, x east, y north",UNIT["metre",1' in said["crs"]
    )
    assert said["keys"]["GTRasterTypeGeoKey"] == "2" and said["keys"]["GTModelTypeGeoKey"] == "1"
    assert said["compression"].endswith("DEFLATE") and said["predictor"] == "FLOATINGPOINT"
    assert said["tile"] == [256, 256]
    assert "libocean ocean:terrain rms = 60.0\n" in said["description"]


def meets_the_seam(hills, points):
    """Copies a period on have no cracks: the last column is the first one, to the bit."""
    grid = points.reshape(hills.rows + 1, hills.columns + 1, 3)
    assert (grid[:, -1, 2] == grid[:, 0, 2]).all() and (grid[-1, :, 2] == grid[0, :, 2]).all()
    assert (grid[:, -1, 0] == hills.columns * CELL).all()
    assert (grid[-1, :, 1] == hills.rows * CELL).all()
    x = CELL * numpy.arange(hills.columns + 1)
    y = CELL * numpy.arange(hills.rows + 1)
    assert abs(grid[:, :, 0] - x).max() < 1e-3 and abs(grid[:, :, 1] - y[:, None]).max() < 1e-3
    # Vertices lie on a grid that floats hold up to the size of the mesh, 2^-11 m here.
    assert abs(grid[:, :, 2] - hills.closed()).max() <= 2.0**-11


def uv_of(hills):
    u = numpy.arange(hills.columns + 1) / hills.columns
    v = numpy.arange(hills.rows + 1) / hills.rows
    return numpy.dstack(numpy.meshgrid(u, v)).reshape(-1, 2)


def test_ply_and_obj_have_points_normals_and_uv(hills):
    hills.bake("n.exr", "--products", "height,normal", "--type", "float", "--axes", "zup")
    normals = hills.closed(read_exr(hills.folder / "n.normal.0001.exr")[0]).reshape(-1, 3)
    ply = meshio.read(hills.bake("t.ply"))
    meets_the_seam(hills, ply.points)
    data = ply.point_data
    assert (numpy.stack([data[name] for name in ("nx", "ny", "nz")], -1) == normals).all()
    assert abs(numpy.stack([data["s"], data["t"]], -1) - uv_of(hills)).max() < 1e-7
    assert len(ply.cells_dict["triangle"]) == 2 * hills.rows * hills.columns
    lines = hills.bake("t.obj").read_text().splitlines()
    rows = {
        word: numpy.array(
            [line.split()[1:4] for line in lines if line.startswith(word + " ")], float
        )
        for word in ("v", "vn", "vt")
    }
    assert abs(rows["v"] - ply.points).max() <= 5e-4 and abs(rows["vn"] - normals).max() < 1e-4
    assert abs(rows["vt"][:, :2] - uv_of(hills)).max() < 1e-6
    assert "o terrain" in lines


def test_usd_has_the_prim_terrain(hills):
    try:
        from pxr import Usd, UsdGeom
    except ImportError:
        pytest.skip("usd-core is not in .venv; scripts/test installs it")
    stage = Usd.Stage.Open(str(hills.bake("t.usda")))
    mesh = UsdGeom.Mesh(stage.GetDefaultPrim())
    assert mesh.GetPrim().GetName() == "Terrain" and UsdGeom.GetStageUpAxis(stage) == "Z"
    meets_the_seam(hills, numpy.array(mesh.GetPointsAttr().Get(1)))
    st = UsdGeom.PrimvarsAPI(mesh).GetPrimvar("st")
    assert st.GetTypeName() == "texCoord2f[]" and st.GetInterpolation() == "vertex"
    assert abs(numpy.array(st.Get(1)) - uv_of(hills)).max() < 1e-7
    assert len(mesh.GetNormalsAttr().Get(1)) == (hills.rows + 1) * (hills.columns + 1)
    assert len(mesh.GetFaceVertexCountsAttr().Get()) == hills.rows * hills.columns


def test_a_level_set_is_0_at_the_ground(hills):
    pyopenvdb = pytest.importorskip("pyopenvdb", reason="python3-openvdb is not installed")
    grid = pyopenvdb.read(str(hills.bake("t.vdb")), "surface")
    assert grid.gridClass == "level set" and grid.transform.voxelSize()[0] == CELL
    values = grid.getConstAccessor()
    random = numpy.random.default_rng(1)
    for _ in range(60):
        i, j = int(random.integers(4, hills.columns - 4)), int(random.integers(4, hills.rows - 4))
        height = hills.heights[j, i]
        below = int(numpy.floor(height / CELL))
        low, high = values.getValue((i, j, below)), values.getValue((i, j, below + 1))
        assert low <= 0.0 <= high
        # A query of the map is right to 1e-3 of its rms, and distances are along the normal.
        assert abs(CELL * (below + low / (low - high)) - height) < 0.2


def test_povray_files_have_heights_beyond_a_kilometre(hills):
    data = hills.bake("t.df3").read_bytes()
    assert struct.unpack(">3H", data[:6]) == (hills.columns, hills.rows, 3)
    codes = numpy.frombuffer(data[6:], ">u4").reshape(3, hills.rows, hills.columns)
    words = dict(
        re.findall(r"#declare (Terrain_\w+) = (\S+);", (hills.folder / "t.df3.inc").read_text())
    )
    base, scale = float(words["Terrain_Base_"]), float(words["Terrain_Scale_"])
    assert abs(base + scale * codes[0] / (2.0**32 - 1) - hills.heights).max() <= scale / 2**32
    mesh = hills.bake("t.inc").read_text()
    assert "Terrain_Surface = mesh2" in mesh and "Ocean" not in mesh and "time" not in mesh
    text = mesh[mesh.index("vertex_vectors") : mesh.index("normal_vectors")]
    points = numpy.array(re.findall(r"<([^,>]+),([^,>]+),([^,>]+)>", text), float)
    meets_the_seam(hills, points[:, [0, 2, 1]].astype(numpy.float32).astype(float))
