# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The folders of lands, terrain.inc and Terrain_View, as POV-Ray itself reads them.

Claims: functions, masks, mesh and height field have the values of the library at their places, each
to the quantum that is stated, for every format, 2000 m above the sea, where the land is no square,
begins anywhere or repeats; copies of a tile meet without a crack, and macros that repeat tiles
leave other land alone; the cover follows slope and snow line; the haze hides the end of the land;
from an eye no ray that must meet land or water misses it, 2 m above a shore, high above and
straight down; a view has the heights of the land less the Earth's curve and ends at the land's
sides; still water lies at its level; the folder renders as it is, moved elsewhere; files that do
not belong are refused in a sentence.
"""

import functools
import re
import shutil
import tempfile
from pathlib import Path

import numpy
import pytest
from conftest import EXPORTS, Folder, floats_of, ocean, parse_seconds, povray, read_png, tell

import libocean

EARTH = 6371000.0
WATER = 3.0
ISLAND = f"""libocean = 1
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
seed = 3
[terrain.coast]
level = {WATER}
shelter = 60.0
"""
GULLIES = """libocean = 1
[terrain]
resolution = 64
patch_size = 2000.0
beta = 2.0
rms = 90.0
mean = 400.0
[terrain.gullies]
longest = 400.0
"""
HILLS = """libocean = 1
[terrain]
resolution = 64
patch_size = 1000.0
rms = 90.0
mean = 2000.0
beta = 2.2
shortest_wavelength = 100.0
"""
REGION = ["--region", "300,1400,900,1750", "--cell", "10"]
FORMATS = ["df3", "mesh2", "height_field"]
# A text, options, and masks with more than one value.
TILES = {f"hills {form}": (HILLS, ["--format", form], ()) for form in FORMATS}
PLACED = {form: (ISLAND, ["--format", form], ("beach", "cliff", "shelter")) for form in FORMATS}
PLACED["region"] = (ISLAND, REGION, ("beach", "cliff", "shelter"))
PLACED["region of a tile"] = (GULLIES, REGION, ("wear",))
LANDS = TILES | PLACED


class Land(Folder):
    """A folder that `ocean povray` wrote of a land, and the library's maps of the same samples."""

    head = '#include "terrain.inc"\nglobal_settings { assumed_gamma 1 }\n'
    load = 'Terrain_Load("land")\n'

    def __init__(self, path, text, *arguments, masks=()):
        self.path, self.text, self.masks = path, text, masks
        path.mkdir(exist_ok=True)
        (path / "its_land.toml").write_text(text)
        self.done = ocean(path, "povray its_land.toml -o .", *arguments)
        assert self.done.returncode == 0, self.done.stderr
        terrain = libocean.parse_terrain(text)
        self.repeats = "--region" not in arguments and "placed" not in text
        self.is_image = (path / "land.png").exists()  # of differences for slopes, without masks
        if "--region" in arguments:
            self.origin, self.samples, self.cell = (300.0, 1400.0), (61, 36), 10.0
        else:
            own = terrain.domain
            self.origin, self.samples, self.cell = own.origin, own.samples, own.cell
        if self.repeats:
            surface = terrain.surface()
            self.maps = {"height": surface.height, "normal": surface.normal}
        else:
            fields = ("height", "normal", *masks)
            self.maps = terrain.region(self.origin, self.samples, self.cell, fields)
        self.heights = numpy.array(self.maps["height"], float)  # [j, i] from the south

    def normals(self, differences: bool):
        """Of the maps, or from differences over two cells; what has no two neighbours is NaN."""
        if not differences:
            return numpy.array(self.maps["normal"], float)
        edge = {"mode": "wrap"} if self.repeats else {"constant_values": numpy.nan}
        north, east = numpy.gradient(numpy.pad(self.heights, 1, **edge), self.cell)
        normal = numpy.dstack([-east, -north, numpy.ones_like(east)])[1:-1, 1:-1]
        return normal / numpy.linalg.norm(normal, axis=2, keepdims=True)

    def told_at_samples(self, body: str, around=0, step=1):
        """Returns Terrain_Quantum, what the body tells at each sample, X and Z, as an array [j, i],
        and the indices j and i; `around`: samples beyond the sides."""
        columns, rows = (range(-around, n + around, step) for n in self.samples)
        scene = f"""{tell("Terrain_Quantum")}
#for (J, {rows[0]}, {rows[-1]}, {step})
    #for (I, {columns[0]}, {columns[-1]}, {step})
        #local X = {self.origin[0]} + I*{self.cell:.12f};
        #local Z = {self.origin[1]} + J*{self.cell:.12f};
        {body}
    #end
#end
"""
        quantum, *values = self.told(scene)
        at = numpy.ix_(numpy.array(rows) % self.samples[1], numpy.array(columns) % self.samples[0])
        return quantum, numpy.array(values).reshape(len(rows), len(columns), -1), at

    def places(self):
        """x and z of each sample, [j, i]."""
        return numpy.meshgrid(
            *(self.origin[axis] + self.cell * numpy.arange(self.samples[axis]) for axis in (0, 1))
        )


@functools.cache
def land_of(name: str) -> Land:
    """A land of the tables, which the tests share."""
    text, arguments, masks = LANDS[name]
    return Land(Path(tempfile.mkdtemp(dir=EXPORTS.name)), text, *arguments, masks=masks)


@pytest.fixture
def land(request) -> Land:
    return land_of(request.param)


lands = pytest.mark.parametrize("land", LANDS, indirect=True)
placed = pytest.mark.parametrize("land", PLACED, indirect=True)
tiles = pytest.mark.parametrize("land", TILES, indirect=True)


@lands
def test_functions_have_the_values_of_the_library_at_their_places(land):
    names = [f"Terrain_{mask.capitalize()}(X, Z)" for mask in land.masks]
    body = "#local N_ = Terrain_Normal(X, Z);" + tell(
        "Terrain_Height(X, Z)", "N_.x", "N_.y", "N_.z", "Terrain_Slope(X, Z)", *names
    )
    quantum, told, at = land.told_at_samples(body, around=3 if land.repeats else 0)
    spread = numpy.ptp(land.heights)
    assert quantum == pytest.approx(spread / (49152 if land.is_image else 2**32), rel=1e-6)
    exact = 1e-9 if land.repeats else 1e-5
    assert abs(told[:, :, 0] - land.heights[at]).max() <= 0.501 * quantum + exact
    normal = land.normals(land.is_image)[at][:, :, [0, 2, 1]]
    known = ~numpy.isnan(normal[:, :, 0])
    assert known.mean() > 0.9
    rounding = 1e-5 if land.is_image and not land.repeats else 2e-6
    rounding += quantum / land.cell if land.is_image or land.repeats else 0
    assert abs(told[:, :, 1:4] - normal)[known].max() <= rounding
    slope = numpy.hypot(normal[:, :, 0], normal[:, :, 2]) / normal[:, :, 1]
    assert abs(told[:, :, 4] - slope)[known].max() <= 2 * quantum / land.cell + 1e-5
    for k, mask in enumerate(land.masks):
        if land.is_image:
            assert (told[:, :, 5 + k] == 0).all()
            continue
        truth = land.maps[mask].astype(float)
        assert numpy.ptp(truth) > 0.3, "a mask of one value proves nothing"
        step = 1 / 127 if mask == "wear" else 1 / 255
        assert abs(told[:, :, 5 + k] - truth).max() <= 0.501 * step + 1e-6


@placed
def test_beyond_its_sides_the_heights_are_those_of_the_sides(land):
    assert land.samples[0] > land.samples[1]
    x, z = (values[[0, 0, -1, -1], [0, -1, 0, -1]] for values in land.places())
    away = [(-99.0, -77.0), (99.0, -77.0), (-99.0, 77.0), (99.0, 77.0)]
    probes = [
        f"Terrain_Height({a + dx}, {b + dz})" for a, b, (dx, dz) in zip(x, z, away, strict=True)
    ]
    quantum, *told = land.told(tell("Terrain_Quantum", *probes))
    corners = land.heights[[0, 0, -1, -1], [0, -1, 0, -1]]
    assert abs(told - corners).max() <= 0.51 * quantum + 1e-5


@lands
@pytest.mark.parametrize("form", ["Terrain_Mesh", "Terrain_Height_Field"])
def test_forms_lie_at_their_place(land, form):
    # Off the samples by a millimetre, inwards: a ray along an edge may miss.
    first = 99 if land.repeats else 2
    body = (
        "#ifndef(Form) #declare Form = " + form + "() #end #local N_ = <0, 0, 0>;"
        f" #local In_ = <(I < {first} ? 1 : -1), 0, (J < {first} ? 1 : -1)>*1e-3;"
        " #local P_ = trace(Form, <X, 9000, Z> + In_, -y, N_);" + tell("P_.y", "N_.x", "N_.z")
    )
    quantum, told, at = land.told_at_samples(body, step=1 if land.repeats else 2)
    is_field = form.endswith("Field")
    # Floats of POV-Ray's vertices and of the step of 1 mm beside the sample; 16 bits of a field.
    allowed = 3e-3 if land.repeats else 6e-3
    allowed += numpy.ptp(land.heights) / 49152 if is_field else 3e-4
    allowed += quantum if land.is_image else 0
    assert abs(told[:, :, 0] - land.heights[at]).max() <= allowed
    if land.repeats:
        normal = land.normals(is_field or land.is_image)[:, :, :2]
        error = numpy.sqrt(((told[:, :, 1:] - normal) ** 2).sum(2).mean())
        print(form, "normals", error)
        assert error < (0.06 if is_field else 1e-3)


@placed
def test_macros_that_repeat_leave_it_alone(land):
    form = "#declare Form = Terrain_Height_Field()\n"
    log = land.error(land.load + form + "object { Terrain_Tiles(Form, 2, 1) }")
    assert "Terrain_Tiles: this land exists once" in log
    east = land.origin[0] + land.cell * (land.samples[0] - 1)
    north = land.origin[1] + land.cell * 3.3
    scene = form + "#declare All = Terrain_Around(Form, 0, 9000)\n"
    for x in (east - 7.7, east + 7.7):
        scene += f"#declare N = <0, 0, 0>; #declare P = trace(All, <{x}, 9000, {north}>, -y, N);"
        scene += tell("vlength(N)")
    inside, outside = land.told(scene)
    assert inside > 0 and outside == 0


@pytest.mark.parametrize("form", FORMATS)
def test_copies_meet_without_a_crack(tmp_path, form):
    """A light below the land would shine through a crack along a seam, in rough land too. The
    camera looks aslant, as a step between two heights is seen only from the side, and stands off
    the axes. A crack of one cell would be hundreds of pixels; in a hundred thousand rays POV-Ray
    misses one or two at the edges of triangles, also within a tile."""
    land = Land(tmp_path, HILLS.replace("shortest_wavelength = 100.0", ""), "--format", form)
    for copies in ("Tiles(Tile, 3, 3)", "Around(Tile, <0, 0, 0>, 2000)"):
        scene = f"""#declare Tile = Terrain_Mesh()
object {{ Terrain_{copies} pigment {{ rgb 0 }} finish {{ ambient 0 diffuse 0 }} }}
plane {{ y, -10 pigment {{ rgb 1 }} finish {{ ambient 0 emission 1 diffuse 0 }} }}
camera {{ location <850.0137, 2700, 870.0373> look_at <1000, 2000, 1000> angle 40 }}
"""
        assert (land.seen(scene, width=400, height=400) > 0).sum() < 18


def cover(land, snow_line, more=""):
    """The cover alone, seen from above over one tile, a pixel for a cell: emission shows it."""
    scene = f"""{more}#declare Cover = Terrain_Cover({snow_line})
#declare Tile = Terrain_Height_Field()
object {{ Tile pigment {{ Cover }} finish {{ ambient 0 emission 1 diffuse 0 }} }}
camera {{ orthographic location <500, 9000, 500> direction -y up 1000*z right 1000*x }}
"""
    return land.seen(scene, width=64, height=64)[:, :, :3]


@tiles
def test_the_cover_follows_slope_and_snow_line(land):
    north, east = numpy.gradient(numpy.pad(land.heights, 1, mode="wrap"), land.cell)
    slope = numpy.hypot(east, north)[1:-1, 1:-1]
    near = lambda colour, image: abs(image - colour).max(axis=2) < 0.02  # noqa: E731
    bare = cover(land, 9000)
    assert not near([0.80, 0.83, 0.88], bare).any()
    steep, level = slope > 1.0, slope < 0.3
    assert steep.any() and level.any()
    # Rock is grey, red over blue 1.22; plants are red over blue 1.5 and more.
    ratio = bare[:, :, 0] / bare[:, :, 2]
    assert numpy.median(ratio[steep]) < 1.4 < 1.5 < numpy.median(ratio[level])
    snow = cover(land, 2000)
    assert near([0.80, 0.83, 0.88], snow)[(land.heights > 2080) & level].mean() > 0.9
    assert not near([0.80, 0.83, 0.88], snow)[land.heights < 1920].any()
    # No level ground but forest below a tree line that is above the land.
    woods = cover(land, 9000, "#declare Terrain_Tree_Line = 9000;\n")
    assert near([0.028, 0.042, 0.018], woods)[level].mean() > 0.5


@tiles
def test_the_scene_of_a_tile_renders_and_may_move(land, tmp_path):
    moved = tmp_path / "moved"
    shutil.copytree(land.path, moved)
    log = povray(moved, (moved / "scene.pov").read_text(), width=96, height=54)
    assert "rror" not in log and parse_seconds(log) < 10
    image = read_png(moved / "out.png")[:, :, :3]
    ground, sky = image[:18], image[40:]
    assert sky[:, :, 2].min() > sky[:, :, 0].max() * 0.8 and sky.mean() > 0.3
    assert 0.02 < ground.mean() < 0.35 and ground.std() > 0.01
    # The end of the land is in the haze: no row jumps at the horizon.
    assert abs(numpy.diff(image.mean(axis=(1, 2)))).max() < 0.15


@pytest.mark.parametrize("land", ["df3", "height_field", "region"], indirect=True)
def test_the_scene_of_an_island_shows_land_water_and_sky(land):
    log = povray(land.path, (land.path / "scene.pov").read_text(), width=128, height=72)
    assert "rror" not in log
    image = read_png(land.path / "out.png")[:, :, :3]
    sky, middle, sea = image[60:], image[30:50, 30:98], image[:6]
    assert sky[:, :, 2].min() > 0.3
    assert sea[:, :, 2].mean() > sea[:, :, 0].mean() and sea.mean() < 0.35

    def land_share(part):  # ground is brown or green, never blue
        return (part[:, :, 1] > 1.02 * part[:, :, 2]).mean()

    assert land_share(middle) > 0.08 and land_share(sea) == 0.0


@tiles
def test_haze_far_beyond_the_visibility_stays_haze(land):
    image = land.seen(
        """#declare Terrain_Visibility = 20;
Terrain_Eye_At(<500, 2600, 500>, 60)
Terrain_Sun(50, -60)
Terrain_Sky(0)
object { Terrain_Height_Field() Terrain_Material(9000) }
camera { location <500, 2600, 500> look_at <500, 2000, 501> angle 60 }
"""
    )[:, :, :3]
    assert image.std(axis=(0, 1)).max() < 0.02 and image.mean() > 0.5


@tiles
def test_the_sky_goes_on_below_the_horizon(land):
    """Land that ends near the eye ends before the horizon, and no dark line is seen between."""
    sky = land.seen(
        """Terrain_Eye_At(<0, 40, 0>, 4)
Terrain_Sun(50, -60)
Terrain_Sky(0)
camera { location <0, 40, 0> look_at <100, 35, 0> angle 4 }
"""
    )
    assert sky[:, :, :3].min() > 0.5


# Place, height of the eye over the ground, where it looks; and by what angle, if not 70 degrees.
POSES = {
    "island": [
        # A beach, 7 m high: it lies 4 m above the water.
        ("<847.6, 0, 1714.3>", 2, "<-0.3, -0.03, 1>"),
        ("<847.6, 0, 1714.3>", 2, "<0.2, -0.1, -1>"),
        ("<500, 0, 1700>", 500, "<0.7, -0.6, -0.3>"),
        ("<500, 0, 1700>", 500, "<0.0137, -1, 0.0041>"),
        ("<-1900, 0, -300>", 200, "<1, -0.02, 0.7>"),
    ],
    "tile": [
        ("<700.3, 0, 900.1>", 2, "<1, -0.05, 0.3>"),
        ("<700.3, 0, 900.1>", 500, "<-1, -0.4, -0.2>"),
        ("<700.3, 0, 900.1>", 500, "<0.0137, -1, 0.0041>"),
        # The end of the land: pixels of a minute of arc about the horizon.
        ("<700.3, 0, 900.1>", 500, "<1, -0.015, 0.2>", 3),
    ],
}
# Land is green, water blue, a background that is seen red.
VIEW = """
#declare Place = {place};
#declare Eye = Place + (Terrain_Height(Place.x, Place.z) + {height})*y;
#declare Forward = vnormalize({forward});
camera {{ location Eye right x*image_width/image_height angle {angle} look_at Eye + Forward }}
background {{ rgb <1, 0, 1> }}
#macro Plain(Colour)
    texture {{ pigment {{ rgb Colour }} finish {{ ambient 0 diffuse 0 emission 1 }} }}
#end
object {{ Terrain_View(Eye, Eye + Forward, {angle}, {pixel}) Plain(<0, 1, 0>) }}
{water}
""" + tell(
    *("Eye.y", "Forward.x", "Forward.y", "Forward.z", "Terrain_Lowest", "Terrain_View_Vertices"),
    "Terrain_Beach(Eye.x, Eye.z)",
)
WIDTH, HEIGHT = 200, 112


def sines_of_pixels(forward, angle):
    """The sine of the elevation of each pixel's ray, the bottom row first."""
    half = numpy.tan(numpy.radians(angle / 2))
    right = numpy.cross([0.0, 1.0, 0.0], forward)
    right /= numpy.linalg.norm(right)
    up = numpy.cross(forward, right)
    across = half * ((numpy.arange(WIDTH) + 0.5) / WIDTH * 2 - 1)
    upright = half * HEIGHT / WIDTH * ((numpy.arange(HEIGHT) + 0.5) / HEIGHT * 2 - 1)
    rays = forward + across[None, :, None] * right + upright[:, None, None] * up
    return (rays / numpy.linalg.norm(rays, axis=2, keepdims=True))[:, :, 1]


@pytest.mark.parametrize("kind", POSES)
def test_no_ray_that_must_meet_land_or_water_misses_it(tmp_path, kind):
    is_island = kind == "island"
    land = land_of("df3") if is_island else Land(tmp_path, GULLIES)
    water = "object { Terrain_Water(Terrain_Water_Level) Plain(<0, 0, 1>) }" if is_island else ""
    asked = 0
    for place, height, forward, *angles in POSES[kind]:
        angle = angles[0] if angles else 70
        pose = {"place": place, "height": height, "forward": forward, "angle": angle}
        scene = VIEW.format(pixel=3 if angle > 10 else 10, water=water, **pose)
        told = land.told(scene, width=WIDTH, height=HEIGHT)
        eye, lowest, vertices = told[0], told[4], told[5]
        level = max(WATER, lowest) if is_island else lowest
        dip = numpy.arccos((EARTH + level) / (EARTH + eye))
        must = numpy.arcsin(sines_of_pixels(told[1:4], angle)) < -dip - 1e-6
        image = read_png(land.path / "out.png")
        bare = image[:, :, 0] > 0.5
        print(kind, place, height, int(must.sum()), "rays", int(vertices), "vertices")
        assert not (must & bare).any(), (place, height, forward, int((must & bare).sum()))
        assert (image[:, :, 1] > 0.5).any() and vertices < 60000
        if height == 2 and is_island:
            assert 4.0 < eye < 12.0 and told[6] > 0.3, "the eye stands on no beach"
        asked += must.sum()
    assert asked > 50000


def test_a_view_has_the_heights_of_the_land_and_ends_at_its_sides():
    scene = (
        """#declare Eye = <500, Terrain_Height(500, 1700) + 30, 1700>;
#declare View = Terrain_View(Eye, Eye + x, 360, 1)
#for (K, 0, 199)
    #declare A = K*2.399963; #declare D = 5 + 3*K;
    #declare X = 500 + D*cos(A); #declare Z = 1700 + D*sin(A);
    #declare N = <0, 0, 0>; #declare P = trace(View, <X, 9000, Z>, -y, N);
    """
        + tell("P.y", "Terrain_Height(X, Z) - Terrain_Drop(X, Z)", "vlength(N)")
        + "#end\n"
        + tell("Terrain_Drop(10500, 1700)")
        + "".join(
            f"#declare N = <0, 0, 0>; #declare P = trace(View, <{x}, 9000, {z}>, -y, N);"
            + tell("vlength(N)")
            for x, z in [(-599, 801), (1799, 2380), (-601, 801), (-599, 799), (1801, 2380)]
        )
    )
    told = land_of("df3").told(scene, width=640, height=360)
    seen = told[:600].reshape(200, 3)
    assert (seen[:, 2] > 0).all()
    error = seen[:, 0] - seen[:, 1]
    print("heights", abs(error).max(), error.std())
    # Vertices are half a cell apart, 19 m: between them the mesh is straight.
    assert abs(error).max() < 6.0 and error.std() < 1.0 and abs(error[:4]).max() < 1.0
    assert told[600] == pytest.approx(1e8 / (2 * EARTH), rel=1e-6)
    assert (told[601:] > 0).tolist() == [True, True, False, False, False]


def test_still_water_lies_at_its_level():
    water = "#declare Water = object { Terrain_Water(Terrain_Water_Level) }\n"
    probe = "#declare N = <0, 0, 0>; #declare P = trace(Water, <{x}, 900, 100>, -y, N);" + tell(
        "P.y"
    )
    scene = tell("Terrain_Water_Level") + water + probe.format(x=-9000)
    scene += "#declare Eye = <500, 300, 1700>;\n#declare View = Terrain_View(Eye, Eye + x, 70, 3)\n"
    scene += water + probe.format(x=500) + probe.format(x=-9500)
    level, even, below, away = land_of("df3").told(scene)
    assert level == WATER and even == pytest.approx(WATER, abs=1e-6)
    assert below == pytest.approx(WATER - 1600**2 / (2 * EARTH), abs=1e-3)
    assert away == pytest.approx(WATER - (1e8 + 1600**2) / (2 * EARTH), abs=1e-3)


def test_two_terrains_share_a_scene(tmp_path):
    Land(tmp_path / "north", HILLS)
    Land(tmp_path / "south", HILLS.replace("2000", "100"), "--format", "height_field")
    shutil.copy(tmp_path / "north" / "terrain.inc", tmp_path)
    scene = '#version 3.7;\n#include "terrain.inc"\n' + "".join(
        f'Terrain_Open("{name}") {Land.load}'
        + tell("Terrain_Lowest", "Terrain_Height(0, 0)", "Terrain_Mean")
        for name in ("north", "south")
    )
    north, south = floats_of(povray(tmp_path, scene)).reshape(2, 3)
    assert north[2] == 2000 and south[2] == 100
    assert north[1] - south[1] == pytest.approx(1900, abs=0.01)


def test_parameters_are_declared_by_name(tmp_path):
    more = HILLS + "breaks = [[300.0, 2.5]]\n[[terrain.layer]]\nperiod = 500.0\ngain = 0.5\n"
    land = Land(tmp_path, more)
    names = ["Beta", "Breaks[0].u", "Layer_0_Gain", "Rms", "Samples"]
    told = land.run(tell(*(f"Terrain_{name}" for name in names)))
    assert floats_of(told).tolist() == [2.2, 300.0, 0.5, 90.0, 64]
    assert "#undef Terrain_Ridge_Direction" in (tmp_path / "terrain_parameters.inc").read_text()


def test_sources_of_every_kind_are_recognised(tmp_path):
    (tmp_path / "hills.toml").write_text(HILLS)
    for command in ("terrain hills.toml -o hills.exr", "povray hills.exr -o a"):
        assert ocean(tmp_path, command).returncode == 0
    assert ocean(tmp_path, "povray hills.toml -o b").returncode == 0
    assert (tmp_path / "a/land.df3").read_bytes() == (tmp_path / "b/land.df3").read_bytes()
    # The folder's own terrain.toml writes it again, and the scene is the user's.
    (tmp_path / "a/scene.pov").write_text("// mine")
    done = ocean(tmp_path / "a", "povray terrain.toml -o . -v")
    assert done.returncode == 0 and "scene.pov exists and is kept" in done.stderr
    assert (tmp_path / "a/scene.pov").read_text() == "// mine"
    done = ocean(tmp_path, "povray preset:seed_rough -o c --dry-run")
    assert done.returncode == 0 and not (tmp_path / "c").exists()
    assert "c/terrain.inc" in done.stdout and "c/land.df3" in done.stdout
    assert re.search(r"\d+ s to read a Terrain_Mesh", done.stderr)


LOAD = Land.load


@pytest.mark.parametrize(
    ("name", "scene", "reason"),
    [
        ("df3", LOAD + "object { Terrain_View(<0, -99, 1500>, 0, 60, 2) }", "m below the ground"),
        ("df3", LOAD + "object { Terrain_View(<0, 900, 15>, <0, 900, 15>, 60, 2) }", "eye itself"),
        ("df3", LOAD + "object { Terrain_View(<0, 900, 15>, 0, 60, 0) }", "Pixel is 0.000; a"),
        ("df3", "object { Terrain_View(<0, 900, 15>, 0, 60, 2) }", "comes before Terrain_Load"),
        ("df3", "object { Terrain_Water(0) }", "Terrain_Water comes before Terrain_Load"),
        ("df3", "object { Terrain_Mesh() }", "Terrain_Mesh comes before Terrain_Load"),
        ("df3", 'Terrain_Load("sea_0001")', "the file sea_0001.df3 is neither here"),
        ("df3", 'Terrain_Open("no")', "the file no/terrain_parameters.inc is neither here"),
        ("df3", LOAD + "Terrain_Sky(0)", "Terrain_Sky comes before Terrain_Sun"),
        ("hills df3", LOAD + "object { Terrain_Tiles(box { 0, 1 }, 0, 1) }", "Columns is 0.000; a"),
    ],
)
def test_mistakes_of_a_scene_stop_with_a_sentence(name, scene, reason):
    log = land_of(name).error(scene)
    assert reason in log, log[-600:]


def test_a_map_of_another_terrain_is_refused(tmp_path):
    land, other = Land(tmp_path / "a", HILLS), Land(tmp_path / "b", HILLS + "seed = 5\n")
    for name in "land.df3", "land.df3.inc":
        shutil.copy(other.path / name, land.path / name)
    log = land.error(Land.load)
    assert "land.df3 shows another terrain than that of terrain_parameters.inc" in log
