# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The folder of a terrain and terrain.inc, as POV-Ray itself reads them.

Claims: functions, mesh and height field have the heights and normals of the map, each to the
quantum that is stated, for every format and 2000 m above the sea; copies of a tile meet without a
crack; the cover follows slope and snow line; the haze hides the end of the land; the folder renders
as it is, moved elsewhere; options and files that do not belong are refused in a sentence.
"""

import re
import shutil

import numpy
import pytest
from conftest import floats_of, ocean, parse_seconds, povray, read_png

import libocean

N, PERIOD = 64, 1000.0
CELL = PERIOD / N
HILLS = f"""libocean = 1
[terrain]
resolution = {N}
patch_size = {PERIOD}
rms = 90.0
mean = 2000.0
beta = 2.2
shortest_wavelength = 100.0
"""
FORMATS = ["df3", "mesh2", "height_field"]


class Land:
    """A folder that `ocean povray` wrote of the hills, and their map."""

    def __init__(self, path, *arguments, text=HILLS):
        self.path = path
        self.format = arguments[-1] if arguments else "df3"
        path.mkdir(exist_ok=True)
        (path / "its_hills.toml").write_text(text)
        self.done = ocean(path, "povray", "its_hills.toml", "-o", ".", *arguments)
        assert self.done.returncode == 0, self.done.stderr
        surface = libocean.parse_terrain(text).surface()
        self.heights = numpy.array(surface.height, float)  # [j, i] from the south
        self.normals = numpy.array(surface.normal, float)

    def differences(self):
        """Normals from differences over two cells, [j, i]."""
        east = (numpy.roll(self.heights, -1, 1) - numpy.roll(self.heights, 1, 1)) / (2 * CELL)
        north = (numpy.roll(self.heights, -1, 0) - numpy.roll(self.heights, 1, 0)) / (2 * CELL)
        normal = numpy.dstack([-east, -north, numpy.ones_like(east)])
        return normal / numpy.linalg.norm(normal, axis=2, keepdims=True)

    def run(self, scene: str, *arguments, width=8, height=8, good=True) -> str:
        head = '#version 3.7;\n#include "terrain.inc"\nglobal_settings { assumed_gamma 1 }\n'
        return povray(self.path, head + scene, *arguments, width=width, height=height, good=good)

    def quantum(self):
        return floats_of(self.run(LOAD + tell("Terrain_Quantum")))[0]


LOAD = 'Terrain_Load("land")\n'


def tell(*values):
    return "".join(f'#debug concat("V ", str({value}, 0, 12), "\\n")\n' for value in values)


def for_samples(first, last, body):
    return f"""
#for (J, {first}, {last})
    #for (I, {first}, {last})
        #local X = I*{CELL}; #local Z = J*{CELL};
        {body}
    #end
#end
"""


@pytest.fixture(scope="module", params=FORMATS)
def land(tmp_path_factory, request):
    return Land(tmp_path_factory.mktemp(request.param), "--format", request.param)


def wrapped(values, first, last):
    """The values of samples first .. last of a map that repeats, as rows."""
    index = numpy.arange(first, last + 1) % N
    return values[numpy.ix_(index, index)].reshape(-1, *values.shape[2:])


def test_functions_have_the_heights_and_normals_of_the_map(land):
    body = "#local N_ = Terrain_Normal(X, Z);" + tell(
        "Terrain_Height(X, Z)", "N_.x", "N_.y", "N_.z", "Terrain_Slope(X, Z)"
    )
    told = floats_of(land.run(LOAD + for_samples(-3, N + 2, body))).reshape(-1, 5)
    quantum = land.quantum()
    image = land.path.joinpath("land.png").exists()
    spread = numpy.ptp(land.heights)
    assert quantum == pytest.approx(spread / 49152 if image else spread / 2**32, rel=1e-6)
    height = wrapped(land.heights, -3, N + 2)
    assert abs(told[:, 0] - height).max() <= 0.501 * quantum + 1e-9
    # A height field has differences over two cells instead of derivatives.
    normal = wrapped(land.differences() if image else land.normals, -3, N + 2)[:, [0, 2, 1]]
    assert abs(told[:, 1:4] - normal).max() <= quantum / CELL + 2e-6
    slope = numpy.hypot(normal[:, 0], normal[:, 2]) / normal[:, 1]
    assert abs(told[:, 4] - slope).max() <= 2 * quantum / CELL + 1e-5


@pytest.mark.parametrize("form", ["Terrain_Mesh", "Terrain_Height_Field"])
def test_forms_lie_on_the_map(land, form):
    body = (
        "#local N_ = <0, 0, 0>; #local P_ = trace(Tile, <X + 1e-3, 9000, Z + 1e-3>, -y, N_);"
        + tell("P_.y", "N_.x", "N_.z")
    )
    told = floats_of(land.run(LOAD + f"#declare Tile = {form}()\n" + for_samples(0, N - 1, body)))
    told = told.reshape(-1, 3)
    spread = numpy.ptp(land.heights)
    # Floats of POV-Ray's vertices and of the step of 1 mm beside the sample; 16 bits of a field.
    allowed = 3e-3 + (spread / 49152 if form.endswith("Field") else 3e-4)
    image = land.path.joinpath("land.png").exists()
    allowed += land.quantum() if image else 0
    assert abs(told[:, 0] - land.heights.ravel()).max() <= allowed
    is_field = form.endswith("Field")
    normal = (land.differences() if is_field or image else land.normals).reshape(-1, 3)
    error = numpy.sqrt(((told[:, 1:] - normal[:, :2]) ** 2).sum(1).mean())
    print(form, "normals", error)
    assert error < (0.06 if is_field else 1e-3)


def test_copies_meet_without_a_crack(land, tmp_path):
    """A light below the land would shine through a crack along a seam, in rough land too. The
    camera looks aslant, as a step between two heights is seen only from the side, and stands off
    the axes. A crack of one cell would be hundreds of pixels; in a hundred thousand rays POV-Ray
    misses one or two at the edges of triangles, also within a tile."""
    rough = HILLS.replace("shortest_wavelength = 100.0", "")
    land = Land(tmp_path, "--format", land.format, text=rough)
    scene = (
        LOAD
        + """
#declare Tile = Terrain_Mesh()
object { Terrain_Tiles(Tile, 3, 3) pigment { rgb 0 } finish { ambient 0 diffuse 0 } }
plane { y, -10 pigment { rgb 1 } finish { ambient 0 emission 1 diffuse 0 } }
camera { location <850.0137, 2700, 870.0373> look_at <1000, 2000, 1000> angle 40 }
"""
    )
    land.run(scene, width=400, height=400)
    assert (read_png(land.path / "out.png") > 0).sum() < 18
    land.run(
        scene.replace("Tiles(Tile, 3, 3)", "Around(Tile, <0, 0, 0>, 2000)"), width=400, height=400
    )
    assert (read_png(land.path / "out.png") > 0).sum() < 18


# The cover alone, seen from above over one tile: emission shows the albedo.
COVER = """
#declare Tile = Terrain_Height_Field()
object { Tile pigment { Cover } finish { ambient 0 emission 1 diffuse 0 } }
camera { orthographic location <500, 9000, 500> direction -y up 1000*z right 1000*x }
"""


def cover(land, snow_line, more=""):
    land.run(
        LOAD + more + f"#declare Cover = Terrain_Cover({snow_line})\n" + COVER, width=N, height=N
    )
    # Pixel (i, j) shows the middle of its cell.
    return read_png(land.path / "out.png")[:, :, :3]


def test_the_cover_follows_slope_and_snow_line(land):
    slope = numpy.hypot(*numpy.gradient(numpy.pad(land.heights, 1, mode="wrap"), CELL)[::-1])[
        1:-1, 1:-1
    ]
    near = lambda colour, image: abs(image - colour).max(axis=2) < 0.02  # noqa: E731
    bare = cover(land, 9000)
    assert not near([0.80, 0.83, 0.88], bare).any()
    steep, level = slope > 1.0, slope < 0.3
    assert steep.any() and level.any()
    # Rock is grey, red over blue 1.22; plants are red over blue 1.5 and more.
    ratio = bare[:, :, 0] / bare[:, :, 2]
    assert numpy.median(ratio[steep]) < 1.4 < 1.5 < numpy.median(ratio[level])
    snow = cover(land, 2000)
    high = land.heights > 2080
    low = land.heights < 1920
    assert near([0.80, 0.83, 0.88], snow)[high & level].mean() > 0.9
    assert not near([0.80, 0.83, 0.88], snow)[low].any()
    # No level ground but forest below a tree line that is above the land.
    woods = cover(land, 9000, "#declare Terrain_Tree_Line = 9000;\n")
    assert near([0.028, 0.042, 0.018], woods)[level].mean() > 0.5


def test_the_scene_of_the_folder_renders_and_may_move(land, tmp_path):
    moved = tmp_path / "moved"
    shutil.copytree(land.path, moved)
    log = povray(moved, (moved / "scene.pov").read_text(), width=96, height=54)
    assert "rror" not in log and parse_seconds(log) < 10
    image = read_png(moved / "out.png")[:, :, :3]
    ground, sky = image[:18], image[40:]
    assert sky[:, :, 2].min() > sky[:, :, 0].max() * 0.8 and sky.mean() > 0.3
    assert 0.02 < ground.mean() < 0.35 and ground.std() > 0.01
    # The end of the land is in the haze: no row jumps at the horizon.
    rows = image.mean(axis=(1, 2))
    assert abs(numpy.diff(rows)).max() < 0.15


def test_haze_far_beyond_the_visibility_stays_haze(land):
    log = land.run(
        LOAD
        + """
#declare Terrain_Visibility = 20;
Terrain_Eye_At(<500, 2600, 500>, 60)
Terrain_Sun(50, -60)
Terrain_Sky(0)
object { Terrain_Height_Field() Terrain_Material(9000) }
camera { location <500, 2600, 500> look_at <500, 2000, 501> angle 60 }
"""
    )
    image = read_png(land.path / "out.png")[:, :, :3]
    assert "rror" not in log and image.std(axis=(0, 1)).max() < 0.02 and image.mean() > 0.5


def test_the_sky_goes_on_below_the_horizon(land):
    """Land that ends near the eye ends before the horizon, and no dark line is seen between."""
    land.run(
        LOAD
        + """
Terrain_Eye_At(<0, 40, 0>, 4)
Terrain_Sun(50, -60)
Terrain_Sky(0)
camera { location <0, 40, 0> look_at <100, 35, 0> angle 4 }
"""
    )
    assert read_png(land.path / "out.png")[:, :, :3].min() > 0.5


def test_two_terrains_share_a_scene(tmp_path):
    Land(tmp_path / "north")
    Land(tmp_path / "south", "--format", "height_field", text=HILLS.replace("2000", "100"))
    shutil.copy(tmp_path / "north" / "terrain.inc", tmp_path)
    scene = '#version 3.7;\n#include "terrain.inc"\n' + "".join(
        f'Terrain_Open("{name}") {LOAD}'
        + tell("Terrain_Lowest", "Terrain_Height(0, 0)", "Terrain_Mean")
        for name in ("north", "south")
    )
    north, south = floats_of(povray(tmp_path, scene)).reshape(2, 3)
    assert north[2] == 2000 and south[2] == 100
    assert north[1] - south[1] == pytest.approx(1900, abs=0.01)


def test_parameters_are_declared_by_name(tmp_path):
    more = HILLS + "breaks = [[300.0, 2.5]]\n[[terrain.layer]]\nperiod = 500.0\ngain = 0.5\n"
    land = Land(tmp_path, text=more)
    values = (
        "Terrain_Beta",
        "Terrain_Breaks[0].u",
        "Terrain_Layer_0_Gain",
        "Terrain_Rms",
        "Terrain_Samples",
    )
    assert floats_of(land.run(tell(*values))).tolist() == [2.2, 300.0, 0.5, 90.0, N]
    assert "#undef Terrain_Ridge_Direction" in (tmp_path / "terrain_parameters.inc").read_text()


def test_sources_of_every_kind_are_recognised(tmp_path):
    (tmp_path / "hills.toml").write_text(HILLS)
    assert ocean(tmp_path, "terrain", "hills.toml", "-o", "hills.exr").returncode == 0
    assert ocean(tmp_path, "povray", "hills.exr", "-o", "a").returncode == 0
    assert ocean(tmp_path, "povray", "hills.toml", "-o", "b").returncode == 0
    assert (tmp_path / "a/land.df3").read_bytes() == (tmp_path / "b/land.df3").read_bytes()
    # The folder's own terrain.toml writes it again, and the scene is the user's.
    (tmp_path / "a/scene.pov").write_text("// mine")
    done = ocean(tmp_path / "a", "povray", "terrain.toml", "-o", ".", "-v")
    assert done.returncode == 0 and "scene.pov exists and is kept" in done.stderr
    assert (tmp_path / "a/scene.pov").read_text() == "// mine"
    done = ocean(tmp_path / "a", "povray", "terrain.toml", "-o", ".", "--set", "seed=9")
    assert done.returncode == 2 and "is an input of this command" in done.stderr
    done = ocean(tmp_path, "povray", "preset:seed_rough", "-o", "c", "--dry-run")
    assert done.returncode == 0 and not (tmp_path / "c").exists()
    assert "c/terrain.inc" in done.stdout and "c/land.df3" in done.stdout
    assert re.search(r"\d+ s to read a Terrain_Mesh", done.stderr)
    done = ocean(tmp_path, "povray", "preset:tujunja", "-o", "d")
    assert done.returncode == 2 and "did you mean tujunga?" in done.stderr


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (["--frames", "1-2"], "--frames: only a sea has it, and this is a terrain"),
        (["--fps", "25"], "--fps: only a sea has it, and this is a terrain"),
        (["--near-only"], "--near-only: only a sea has it, and this is a terrain"),
        (["--shard", "1/2"], "--shard: only a sea has it, and this is a terrain"),
        (["--keep-going"], "--keep-going: only a sea has it, and this is a terrain"),
        (["--resolution", "4096"], "allowed is at most 2048"),
        (["--set", "wind_speed=9"], "wind_speed"),
    ],
)
def test_what_a_terrain_cannot_have_is_refused(tmp_path, arguments, reason):
    (tmp_path / "hills.toml").write_text(HILLS)
    done = ocean(tmp_path, "povray", "hills.toml", "-o", "out", *arguments)
    assert done.returncode == 2 and reason in done.stderr
    assert len(done.stderr.splitlines()) == 1 and not (tmp_path / "out").exists()


def test_a_sea_and_a_terrain_have_folders_of_their_own(tmp_path):
    (tmp_path / "hills.toml").write_text(HILLS)
    for first, second in ("preset:beaufort_3", "hills.toml"), ("hills.toml", "preset:beaufort_3"):
        folder = first.split(":")[0].split(".")[0]
        small = ["--resolution", "32"]
        assert ocean(tmp_path, "povray", first, "-o", folder, *small).returncode == 0
        done = ocean(tmp_path, "povray", second, "-o", folder, *small)
        assert done.returncode == 2 and "needs its own" in done.stderr


@pytest.mark.parametrize(
    ("scene", "reason"),
    [
        ("object { Terrain_Mesh() }", "Terrain_Mesh comes before Terrain_Load"),
        ('Terrain_Load("sea_0001")', "the file sea_0001.df3 is neither here"),
        ('Terrain_Open("nowhere")', "the file nowhere/terrain_parameters.inc is neither here"),
        (LOAD + "Terrain_Sky(0)", "Terrain_Sky comes before Terrain_Sun"),
        (LOAD + "object { Terrain_Tiles(box { 0, 1 }, 0, 1) }", "Columns is 0.000; allowed"),
    ],
)
def test_mistakes_of_a_scene_stop_with_a_sentence(tmp_path_factory, scene, reason):
    land = Land(tmp_path_factory.mktemp("mistake"))
    log = " ".join(land.run(scene, good=False).split())
    assert reason in log, log[-600:]


def test_a_map_of_another_terrain_is_refused(tmp_path):
    land, other = Land(tmp_path / "a"), Land(tmp_path / "b", text=HILLS + "seed = 5\n")
    for name in "land.df3", "land.df3.inc":
        shutil.copy(other.path / name, land.path / name)
    log = " ".join(land.run(LOAD, good=False).split())
    assert "land.df3 shows another terrain than that of terrain_parameters.inc" in log
