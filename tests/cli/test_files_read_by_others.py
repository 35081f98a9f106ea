# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Files of each subject and format, read by the programs of others: EXR and PNG by OpenImageIO,
TIFF by rasterio and tifffile, PLY by meshio, USD by usd-core, VDB by pyopenvdb; OBJ and what
POV-Ray reads by a few lines here. Each has the values and places that the library says, to what its
format states. A row is a subject over a domain, a column a format with its reader."""

import json
import re
import struct
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import meshio
import numpy
import OpenImageIO as oiio
import pytest
from bake_runs import BOAT, TRACK
from coasts import BEACH, REGION, SEA, grid
from conftest import SMALL_SEA, Program
from lands import ISLAND, TILE

import libocean

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path += [str(path) for path in ROOT.glob(".venv/lib/python3.*/site-packages")]
FRAME = 9


class Row(NamedTuple):
    text: str
    masks: tuple[str, ...]
    words: str = ""
    tiles: tuple[int, int] = (1, 1)  # columns and rows of a land that repeats
    # A level set [m] has distances along the normal, and a query of a map is right to 1e-3
    # of the rms of its heights.
    zero_error: float = 0.3


PART = "--region 300,1400,900,1750 --cell 10"
HILLS = TILE + "mean = 2000.0\n"  # beyond a half's last metre
ROWS = {
    "sea": Row(SMALL_SEA, ("foam",)),
    "coast": Row(SEA, ("foam", "depth", "breaking", "wetness"), " ".join(REGION), zero_error=0.05),
    "boat": Row(SMALL_SEA + BOAT + TRACK, ("trail", "dry"), "--region=-40,-20,60,40 --cell 2"),
    "tile": Row(HILLS, (), zero_error=0.2),
    "tiles": Row(HILLS, (), "--tiles 2x3", (2, 3), zero_error=0.2),
    "part of an island": Row(ISLAND, ("cliff",), PART),
    "part of a tile": Row(TILE + "[terrain.gullies]\nlongest = 250.0\n", ("wear",), PART),
}


class Made:
    """A row's subject in a folder, and what the library says of it. Maps are [j, i] from the south;
    those of `closed` have the first column and row again at the end where the domain wraps."""

    def __init__(self, folder, row: Row):
        self.row, self.program, self.folder = row, Program(folder), folder
        self.is_land = "[terrain]" in row.text
        path = self.program.write("subject.toml", row.text)
        self.program.write("bed.asc", grid(BEACH))
        self.sea = (libocean.open_terrain if self.is_land else libocean.open)(path)
        moving = () if self.is_land else ("displacement", "velocity")
        self.fields = ("height", "normal", *moving, *row.masks)
        self.images = (*self.fields, *(() if "--region" in row.words else ("slope",)))
        at = () if self.is_land else (self.sea.time_of_frame(FRAME),)
        place = re.search(r"--region[ =](\S+) --cell (\S+)", row.words)
        self.wraps = place is None
        if place:
            west, south, east, north = map(float, place[1].split(","))
            self.origin, self.cell = (west, south), float(place[2])
            samples = [round(side / self.cell) + 1 for side in (east - west, north - south)]
            self.maps = self.sea.region(*at, self.origin, samples, self.cell, self.fields)
        else:
            surface = self.sea.surface(*at)
            columns, rows = row.tiles
            self.maps = {}
            for name in self.images:
                values = getattr(surface, name)
                repeated = (rows, columns) + (1,) * (values.ndim - 2)
                self.maps[name] = numpy.tile(values, repeated)
            period = float(self.sea.get("patch_size"))
            self.origin, self.cell = (0.0, 0.0), period / surface.resolution
        self.rows, self.columns = self.maps["height"].shape

    def closed(self, name: str) -> numpy.ndarray:
        values = self.maps[name]
        if not self.wraps:
            return values
        return numpy.pad(values, [(0, 1), (0, 1)] + [(0, 0)] * (values.ndim - 2), mode="wrap")

    def labels(self) -> numpy.ndarray:
        """The places of the vertices without displacement."""
        sides = (numpy.arange(count + self.wraps) for count in (self.columns, self.rows))
        steps = numpy.stack(numpy.meshgrid(*sides), -1)
        return numpy.float64(self.origin) + self.cell * steps

    def uv(self) -> numpy.ndarray:
        rows, columns = self.labels().shape[:2]
        sides = (numpy.arange(n, dtype="f4") / (n - 1) for n in (columns, rows))
        return numpy.stack(numpy.meshgrid(*sides), -1)

    def points(self) -> numpy.ndarray:
        """The places of the vertices."""
        labels = self.labels()
        if self.is_land:
            return numpy.dstack([labels, self.closed("height")])
        return numpy.dstack([labels, 0.0 * labels[..., 0]]) + self.closed("displacement")

    def heights_at_labels(self) -> numpy.ndarray:
        """Heights over the labels, where water is displaced to other places."""
        if self.is_land:
            return self.closed("height").astype(float)
        labels, time = self.labels(), self.sea.time_of_frame(FRAME)
        found = self.sea.samples(labels.reshape(-1, 2), time, refine=2)
        return found.height.reshape(labels.shape[:2])

    def bake(self, name: str, *options) -> Path:
        command = "terrain" if self.is_land else f"bake --frames {FRAME}"
        words = f"{command} subject.toml -q {self.row.words}".split()
        self.program.good(*words, "-o", name, *options)
        return self.folder / name

    def judged(self, judge: str, *arguments) -> dict:
        """What a script of this folder says, run by the Python of .venv."""
        pythons = list(ROOT.glob(".venv/bin/python"))
        if not pythons or not list(ROOT.glob(".venv/lib/python3.*/site-packages/rasterio")):
            pytest.skip("rasterio is not in .venv; scripts/test installs it")
        command = [pythons[0], Path(__file__).with_name(judge), *arguments]
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout)


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """The subject of each row, opened when it is first asked for."""
    known = {}

    def made_once(name: str) -> Made:
        if name not in known:
            known[name] = Made(tmp_path_factory.mktemp(name.replace(" ", "_")), ROWS[name])
        return known[name]

    return made_once


# Formats --------------------------------------------------------------------------


def exr(made: Made):
    """Layers of all products, as floats or, where a reader needs no more, as halves."""
    image = oiio.ImageInput.open(
        str(made.bake("s.exr", "--products", ",".join(made.images), "--layout", "layered",
                      "--axes", "zup"))
    )  # fmt: skip
    spec, pixels = image.spec(), image.read_image("float")[::-1]
    image.close()
    found = {}
    for c, name in enumerate(spec.channelnames):
        product = name.partition(".")[0] if "." in name else "displacement"
        found.setdefault(product, []).append((pixels[..., c], str(spec.channelformat(c))))
    exact = {"depth", "displacement", "velocity"} | ({"height"} if made.is_land else set())
    assert set(found) == set(made.images)
    for name in made.images:
        truth = made.maps[name].reshape(made.rows, made.columns, -1)
        assert len(found[name]) == truth.shape[2] + (name == "displacement"), name  # and alpha
        for c, (values, kind) in enumerate(found[name][: truth.shape[2]]):
            assert kind == ("float" if name in exact else "half"), name
            error = abs(values - truth[..., c])
            rounding = 0.0 if kind == "float" else 2.0**-11 * abs(truth[..., c]) + 1e-7
            assert (error <= rounding).all(), name
    if not made.wraps:
        west, south = made.origin
        assert spec["ocean:origin"] == f"{west:g},{south:g}" and spec["ocean:wraps"] == "no"
        east, north = (made.cell * (count - 1) for count in (made.columns, made.rows))
        assert spec["ocean:size"] == f"{east:g},{north:g}"
        assert spec["ocean:samples"] == f"{made.columns},{made.rows}"


def png(made: Made):
    """Right to half of the quantum that it states, inside and beside."""
    path = made.bake("s.png")
    image = oiio.ImageInput.open(str(path))
    spec, codes = image.spec(), image.read_image("uint16")[::-1, :, 0].astype(float)
    image.close()
    assert spec.nchannels == 1 and spec.format == oiio.UINT16
    if made.wraps:
        assert (codes[0] == codes[-1]).all() and (codes[:, 0] == codes[:, -1]).all()
    lines = path.with_suffix(".png.txt").read_text().splitlines()
    words = dict(line.split("#")[0].split(" = ") for line in lines if re.match(r"\w+ = ", line))
    base, scale = float(words["base"]), float(words["scale"])
    truth, quantum = made.heights_at_labels(), scale / 65536
    error = abs(base + quantum * codes - truth).max()
    assert 0.4 * quantum < error <= 0.5001 * quantum + (0.0 if made.is_land else 1e-6)
    if not made.wraps:
        assert words["origin"].strip() == "[300, 1400]" and words["size"].strip() == "[600, 350]"
    if not made.is_land:
        return
    low, high = map(float, spec["ocean:range"].split(","))
    assert numpy.isclose(float(spec["ocean:quantum"]), (high - low) / 65535)
    assert (float(spec["ocean:lo"]), float(spec["ocean:hi"])) == (truth.min(), truth.max())
    assert low == base and numpy.isclose(high - low, 65535 * quantum)
    said = re.fullmatch(r"height \[m\] = (\S+) \+ (\S+) \* code / 65536", spec["ImageDescription"])
    assert said.groups() == (words["base"].strip(), words["scale"].strip())


def tif(made: Made):
    said = made.judged("terrain_judge.py", made.bake("s.tif"), made.folder / "read.npy")
    heights = numpy.load(made.folder / "read.npy")[::-1]  # the first row is the northern one
    assert heights.shape == (made.rows, made.columns) and (heights == made.maps["height"]).all()
    assert said["readers_agree"] and said["type"] == "float32" and said["nodata"] is None
    west, south = made.origin
    assert said["first"] == [west, south + (made.rows - 1) * made.cell]
    assert said["cell"] == [made.cell, made.cell] and said["area_or_point"] == "Point"
    grid = 'LOCAL_CS["libocean: local grid in metres, x east, y north",UNIT["metre",1'
    assert grid in said["crs"]
    assert said["keys"]["GTRasterTypeGeoKey"] == "2" and said["keys"]["GTModelTypeGeoKey"] == "1"
    assert said["compression"].endswith("DEFLATE") and said["predictor"] == "FLOATINGPOINT"
    assert said["tile"] == [256, 256]
    assert "libocean ocean:terrain rms = 60.0\n" in said["description"]


def check_points(made: Made, points):
    """Vertices lie on a grid that floats hold up to the size of the mesh, 2^-11 m of a land that
    repeats, where a copy a period on has no crack: the last column is the first one, to the bit."""
    points, wanted = points.reshape(made.points().shape), made.points()
    if not made.wraps:
        assert abs(points - wanted).max() < 1e-5 * max(1.0, abs(wanted).max() / 160.0)
        if made.is_land:
            assert (points[..., 2] == wanted[..., 2]).all()
        return
    assert abs(points - wanted).max() <= (2.0**-11 if made.is_land else 2e-5)
    east, north = (made.cell * count for count in (made.columns, made.rows))
    assert (points[:, -1] == points[:, 0] + numpy.float32([east, 0, 0])).all()
    assert (points[-1] == points[0] + numpy.float32([0, north, 0])).all()


def check_triangles(points, triangles, sides: int):
    """Every inner edge belongs to two triangles, and all look up but where crests fold."""
    edges = numpy.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    counts = numpy.unique(edges, axis=0, return_counts=True)[1]
    assert (counts == 1).sum() == sides and (counts <= 2).all()
    a, b, c = (points[triangles[:, i]] for i in range(3))
    assert (numpy.cross(b - a, c - a)[:, 2] > 0).mean() > 0.99


def check_attributes(made: Made, read):
    """read(name) returns the values of the vertices, whose uv are those of the domain's sides."""
    for name in made.fields:
        if name not in ("height", "displacement"):
            truth = made.closed(name)
            assert (read(name).reshape(truth.shape) == truth).all(), name
            assert truth.std() > 0.01, f"{name} of one value proves nothing"
    uv = made.uv()
    assert abs(read("uv").reshape(uv.shape) - uv).max() < 1e-7


def products(made: Made) -> tuple[str, str]:
    moving = () if made.is_land else ("velocity",)
    return "--products", ",".join(("normal", *moving, *made.row.masks))


COLUMNS = {"normal": ("nx", "ny", "nz"), "velocity": ("vx", "vy", "vz"), "uv": ("s", "t")}


def ply(made: Made):
    mesh = meshio.read(made.bake("s.ply", *products(made)))
    check_points(made, mesh.points)
    check_attributes(
        made,
        lambda name: numpy.stack([mesh.point_data[c] for c in COLUMNS.get(name, (name,))], -1),
    )
    rows, columns = (count - 1 for count in made.labels().shape[:2])
    triangles = mesh.cells_dict["triangle"]
    assert triangles.shape == (2 * rows * columns, 3)
    check_triangles(mesh.points, triangles, 2 * (rows + columns))


def obj(made: Made):
    """As a PLY, in decimal digits; a scalar stands behind the place of its vertex."""
    scalars = made.row.masks[:1]
    path = made.bake("s.obj", "--products", ",".join(("normal", *scalars)))
    lines = [line.split() for line in path.read_text().splitlines()]

    def rows(word: str) -> numpy.ndarray:
        return numpy.array([line[1:] for line in lines if line[:1] == [word]], "f4")

    vertices, normals = rows("v"), rows("vn")
    check_points(made, vertices[:, :3])
    for k, name in enumerate(scalars):
        assert (vertices[:, 3 + k] == made.closed(name).ravel()).all()
    assert (normals == made.closed("normal").reshape(-1, 3)).all()
    assert abs(rows("vt") - made.uv().reshape(-1, 2)).max() < 1e-6
    corners = [corner.split("/") for line in lines if line[:1] == ["f"] for corner in line[1:]]
    assert all(len(corner) == 3 and len(set(corner)) == 1 for corner in corners)
    triangles = numpy.array([corner[0] for corner in corners], int).reshape(-1, 3) - 1
    count = 2 * numpy.subtract(made.labels().shape[:2], 1).sum()
    check_triangles(vertices[:, :3], triangles, count)
    assert not made.is_land or ["o", "terrain"] in lines
    if not scalars:  # which meshio takes for coordinates
        mesh = meshio.read(path)
        assert (numpy.float32(mesh.points) == vertices).all()
        assert (mesh.cells_dict["triangle"] == triangles).all()


def usd(made: Made):
    try:
        from pxr import Usd, UsdGeom
    except ImportError:
        pytest.skip("usd-core is not in .venv; scripts/test installs it")
    stage = Usd.Stage.Open(str(made.bake("s.usda", *products(made))))
    assert UsdGeom.GetStageUpAxis(stage) == "Z" and UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    prim = stage.GetDefaultPrim()
    mesh, primvars = UsdGeom.Mesh(prim), UsdGeom.PrimvarsAPI(prim)
    assert prim.GetName() == ("Terrain" if made.is_land else "Ocean")
    assert numpy.allclose(UsdGeom.Xformable(mesh).GetLocalTransformation(), numpy.eye(4))
    at = 1 if made.is_land else FRAME
    points = numpy.array(mesh.GetPointsAttr().Get(at))
    check_points(made, points)
    own = {"normal": mesh.GetNormalsAttr(), "velocity": mesh.GetVelocitiesAttr()}
    st = primvars.GetPrimvar("st")
    assert st.GetTypeName() == "texCoord2f[]" and st.GetInterpolation() == "vertex"

    def read(name: str) -> numpy.ndarray:
        attribute = own.get(name) or primvars.GetPrimvar("st" if name == "uv" else name)
        return numpy.array(attribute.Get(at))

    check_attributes(made, read)
    rows, columns = (count - 1 for count in made.labels().shape[:2])
    assert (numpy.array(mesh.GetFaceVertexCountsAttr().Get()) == 4).all()
    quads = numpy.array(mesh.GetFaceVertexIndicesAttr().Get()).reshape(-1, 4)
    assert len(quads) == rows * columns
    halves = quads[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)
    check_triangles(points, halves, 2 * (rows + columns))


def vdb(made: Made):
    """A level set is 0 at the ground, or the water."""
    pyopenvdb = pytest.importorskip("pyopenvdb", reason="python3-openvdb is not installed")
    options = ("--voxel", "1") if made.row.zero_error < 0.1 else ()
    grid = pyopenvdb.read(str(made.bake("s.vdb", "--products", "surface", *options)), "surface")
    voxel, values = grid.transform.voxelSize()[0], grid.getConstAccessor()
    assert grid.gridClass == "level set" and voxel == (1.0 if options else made.cell)
    heights, random = made.heights_at_labels(), numpy.random.default_rng(1)
    for _ in range(60):
        i, j = (int(random.integers(4, count - 4)) for count in (made.columns, made.rows))
        x, y = (round(value / voxel) for value in made.labels()[j, i])
        below = int(numpy.floor(heights[j, i] / voxel))
        low, high = values.getValue((x, y, below)), values.getValue((x, y, below + 1))
        assert abs(voxel * (below + low / (low - high)) - heights[j, i]) < made.row.zero_error


def df3(made: Made):
    path = made.bake("s.df3")
    data = path.read_bytes()
    assert struct.unpack(">3H", data[:6])[:2] == (made.columns, made.rows)
    codes = numpy.frombuffer(data[6:], ">u4").reshape(-1, made.rows, made.columns)
    text = path.with_suffix(".df3.inc").read_text()
    words = dict(re.findall(r"#declare (Terrain_\w+) = (\S+);", text))
    base, scale = float(words["Terrain_Base_"]), float(words["Terrain_Scale_"])
    assert abs(base + scale * codes[0] / (2.0**32 - 1) - made.maps["height"]).max() <= scale / 2**32


def mesh2(made: Made):
    mesh = made.bake("s.inc").read_text()
    assert "Terrain_Surface = mesh2" in mesh and "Ocean" not in mesh and "time" not in mesh
    text = mesh[mesh.index("vertex_vectors") : mesh.index("normal_vectors")]
    points = numpy.array(re.findall(r"<([^,>]+),([^,>]+),([^,>]+)>", text), "f4")
    check_points(made, points[:, [0, 2, 1]])


LANDS = {name for name, row in ROWS.items() if "[terrain]" in row.text}
TILES = {"tile", "tiles"}
FORMATS = {
    exr: set(ROWS),
    png: LANDS | {"sea"},
    tif: LANDS,
    ply: set(ROWS),
    obj: set(ROWS),
    usd: set(ROWS),
    vdb: LANDS | {"coast"},  # that of a sea is in test_vdb.py
    df3: TILES,  # those of others are read by POV-Ray itself
    mesh2: TILES,
}


@pytest.mark.parametrize(
    ("check", "name"),
    [
        pytest.param(check, name, id=f"{check.__name__} of {name}")
        for check, names in FORMATS.items()
        for name in ROWS
        if name in names
    ],
)
def test_a_file_has_what_the_library_says(made, check, name):
    check(made(name))
