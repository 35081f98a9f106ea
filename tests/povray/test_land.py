# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The folder of land that exists once, and Terrain_View, as POV-Ray itself reads them.

Claims: functions, masks, mesh and height field of a placed land and of a region have the values of
the library at their places, where the land is no square and begins anywhere; macros that repeat
tiles refuse such land or leave it alone; from an eye no ray that must meet land or water misses it,
2 m above a shore, high above and straight down, for land that ends and land that repeats; a view
has the heights of the land less the Earth's curve and ends at the land's sides; still water lies at
its level; the folder renders as it is; options that do not belong are refused in a sentence.
"""

import numpy
import pytest
from conftest import floats_of, ocean, povray, read_png

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
REGION = ["--region", "300,1400,900,1750", "--cell", "10"]
LOAD = 'Terrain_Load("land")\n'


class Land:
    """A folder that `ocean povray` wrote, and the library's maps of the same samples."""

    def __init__(self, path, text, *arguments, fields=("height", "normal")):
        self.path = path
        path.mkdir(exist_ok=True)
        (path / "its_land.toml").write_text(text)
        self.done = ocean(path, "povray", "its_land.toml", "-o", ".", *arguments)
        assert self.done.returncode == 0, self.done.stderr
        terrain = libocean.parse_terrain(text)
        if "--region" in arguments:
            self.origin, self.samples, self.cell = (300.0, 1400.0), (61, 36), 10.0
        else:
            own = terrain.domain
            self.origin, self.samples, self.cell = own.origin, own.samples, own.cell
        self.maps = terrain.region(self.origin, self.samples, self.cell, fields)
        self.heights = self.maps["height"].astype(float)  # [j, i] from the south

    def places(self):
        """x and z of each sample, [j, i]."""
        return numpy.meshgrid(
            *(self.origin[axis] + self.cell * numpy.arange(self.samples[axis]) for axis in (0, 1))
        )

    def run(self, scene: str, *arguments, width=8, height=8, good=True) -> str:
        head = '#version 3.7;\n#include "terrain.inc"\nglobal_settings { assumed_gamma 1 }\n'
        return povray(self.path, head + scene, *arguments, width=width, height=height, good=good)


def tell(*values):
    return "".join(f'#debug concat("V ", str({value}, 0, 9), "\\n")\n' for value in values)


def for_samples(land, body, step=1):
    return f"""
#for (J, 0, {land.samples[1] - 1}, {step})
    #for (I, 0, {land.samples[0] - 1}, {step})
        #local X = {land.origin[0]} + I*{land.cell:.12f};
        #local Z = {land.origin[1]} + J*{land.cell:.12f};
        {body}
    #end
#end
"""


FOLDERS = {
    "df3": (ISLAND, []),
    "height_field": (ISLAND, ["--format", "height_field"]),
    "mesh2": (ISLAND, ["--format", "mesh2"]),
    "region": (ISLAND, REGION),
    "region of a tile": (GULLIES, REGION),
}


@pytest.fixture(scope="module", params=FOLDERS)
def land(tmp_path_factory, request):
    text, arguments = FOLDERS[request.param]
    masks = ("wear",) if text == GULLIES else ("beach", "cliff", "shelter")
    land = Land(
        tmp_path_factory.mktemp("land"), text, *arguments, fields=("height", "normal", *masks)
    )
    land.image = request.param == "height_field"
    land.masks = masks
    return land


def test_functions_have_the_values_of_the_library_at_their_places(land):
    assert land.samples[0] > land.samples[1]
    names = [f"Terrain_{mask.capitalize()}(X, Z)" for mask in land.masks]
    body = "#local N_ = Terrain_Normal(X, Z);" + tell(
        "Terrain_Height(X, Z)", "N_.x", "N_.z", *names
    )
    log = land.run(LOAD + tell("Terrain_Quantum") + for_samples(land, body))
    quantum, *told = floats_of(log)
    told = numpy.array(told).reshape(*land.heights.shape, -1)
    assert abs(told[:, :, 0] - land.heights).max() <= 0.51 * quantum + 1e-5
    inner = (slice(1, -1), slice(1, -1))
    if land.image:  # it has differences for slopes, and no masks
        north, east = numpy.gradient(land.heights, land.cell)
        length = numpy.sqrt(1 + east**2 + north**2)
        assert abs(told[:, :, 1] + east / length)[inner].max() <= quantum / land.cell + 1e-5
        assert (told[:, :, 3:] == 0).all()
        return
    assert abs(told[:, :, 1] - land.maps["normal"][:, :, 0]).max() < 2e-6
    assert abs(told[:, :, 2] - land.maps["normal"][:, :, 1]).max() < 2e-6
    for k, mask in enumerate(land.masks):
        truth = land.maps[mask].astype(float)
        assert numpy.ptp(truth) > 0.3, "a mask of one value proves nothing"
        step = 1 / 127 if mask == "wear" else 1 / 255
        assert abs(told[:, :, 3 + k] - truth).max() <= 0.501 * step + 1e-6


def test_beyond_its_sides_the_heights_are_those_of_the_sides(land):
    x, z = (values[[0, 0, -1, -1], [0, -1, 0, -1]] for values in land.places())
    away = [(-99.0, -77.0), (99.0, -77.0), (-99.0, 77.0), (99.0, 77.0)]
    told = floats_of(
        land.run(
            LOAD
            + tell("Terrain_Quantum")
            + "".join(
                tell(f"Terrain_Height({a + dx}, {b + dz})")
                for a, b, (dx, dz) in zip(x, z, away, strict=True)
            )
        )
    )
    corners = land.heights[[0, 0, -1, -1], [0, -1, 0, -1]]
    assert abs(told[1:] - corners).max() <= 0.51 * told[0] + 1e-5


@pytest.mark.parametrize("form", ["Terrain_Mesh", "Terrain_Height_Field"])
def test_forms_lie_at_their_place(land, form):
    # Off the samples by a millimetre, inwards: a ray along an edge may miss.
    body = (
        "#local N_ = <0, 0, 0>; #local In_ = <(I < 2 ? 1 : -1), 0, (J < 2 ? 1 : -1)>*1e-3;"
        " #local P_ = trace(Form, <X, 9000, Z> + In_, -y, N_);" + tell("P_.y")
    )
    log = land.run(
        LOAD + tell("Terrain_Quantum") + f"#declare Form = {form}()\n" + for_samples(land, body, 2)
    )
    quantum, *told = floats_of(log)
    told = numpy.array(told).reshape(land.heights[::2, ::2].shape)
    allowed = 6e-3 + (numpy.ptp(land.heights) / 49152 if form.endswith("Field") else 3e-4)
    assert abs(told - land.heights[::2, ::2]).max() <= allowed + (quantum if land.image else 0)


def test_macros_that_repeat_leave_it_alone(land):
    scene = LOAD + "#declare Form = Terrain_Height_Field()\n"
    log = " ".join(land.run(scene + "object { Terrain_Tiles(Form, 2, 1) }", good=False).split())
    assert "Terrain_Tiles: this land exists once" in log
    east = land.origin[0] + land.cell * (land.samples[0] - 1)
    north = land.origin[1] + land.cell * 3.3
    told = floats_of(
        land.run(
            scene
            + "#declare All = Terrain_Around(Form, 0, 9000) #declare N = <0, 0, 0>;\n"
            + f"#declare P = trace(All, <{east - 7.7}, 9000, {north}>, -y, N);"
            + tell("vlength(N)")
            + "#declare N = <0, 0, 0>;"
            + f"#declare P = trace(All, <{east + 7.7}, 9000, {north}>, -y, N);"
            + tell("vlength(N)")
        )
    )
    assert told[0] > 0 and told[1] == 0


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
    "Eye.y",
    "Forward.x",
    "Forward.y",
    "Forward.z",
    "Terrain_Lowest",
    "Terrain_View_Vertices",
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
    land = Land(tmp_path, ISLAND if kind == "island" else GULLIES)
    water = "object { Terrain_Water(Terrain_Water_Level) Plain(<0, 0, 1>) }"
    asked = 0
    for place, height, forward, *angles in POSES[kind]:
        angle = angles[0] if angles else 70
        scene = VIEW.format(
            place=place,
            height=height,
            forward=forward,
            angle=angle,
            pixel=3 if angle > 10 else 10,
            water=water if kind == "island" else "",
        )
        told = floats_of(land.run(LOAD + scene, width=WIDTH, height=HEIGHT))
        eye, lowest, vertices = told[0], told[4], told[5]
        level = max(WATER, lowest) if kind == "island" else lowest
        dip = numpy.arccos((EARTH + level) / (EARTH + eye))
        must = numpy.arcsin(sines_of_pixels(told[1:4], angle)) < -dip - 1e-6
        image = read_png(tmp_path / "out.png")
        bare = image[:, :, 0] > 0.5
        print(kind, place, height, int(must.sum()), "rays", int(vertices), "vertices")
        assert not (must & bare).any(), (place, height, forward, int((must & bare).sum()))
        assert (image[:, :, 1] > 0.5).any() and vertices < 60000
        if height == 2 and kind == "island":
            assert 4.0 < eye < 12.0 and told[6] > 0.3, "the eye stands on no beach"
        asked += must.sum()
    assert asked > 50000


def test_a_view_has_the_heights_of_the_land_and_ends_at_its_sides(tmp_path):
    land = Land(tmp_path, ISLAND)
    scene = (
        LOAD
        + """
#declare Eye = <500, Terrain_Height(500, 1700) + 30, 1700>;
#declare View = Terrain_View(Eye, Eye + x, 360, 1)
#for (K, 0, 199)
    #declare A = K*2.399963; #declare D = 5 + 3*K;
    #declare X = 500 + D*cos(A); #declare Z = 1700 + D*sin(A);
    #declare N = <0, 0, 0>; #declare P = trace(View, <X, 9000, Z>, -y, N);
    """
        + tell("P.y", "Terrain_Height(X, Z) - Terrain_Drop(X, Z)", "vlength(N)")
        + "#end\n"
        + tell("Terrain_Drop(10500, 1700)")
        + "#declare N = <0, 0, 0>;\n"
        + "".join(
            f"#declare N = <0, 0, 0>; #declare P = trace(View, <{x}, 9000, {z}>, -y, N);"
            + tell("vlength(N)")
            for x, z in [(-599, 801), (1799, 2380), (-601, 801), (-599, 799), (1801, 2380)]
        )
    )
    told = floats_of(land.run(scene, width=640, height=360))
    seen = told[:600].reshape(200, 3)
    assert (seen[:, 2] > 0).all()
    error = seen[:, 0] - seen[:, 1]
    print("heights", abs(error).max(), error.std())
    # Vertices are half a cell apart, 19 m: between them the mesh is straight.
    assert abs(error).max() < 6.0 and error.std() < 1.0 and abs(error[:4]).max() < 1.0
    assert told[600] == pytest.approx(1e8 / (2 * EARTH), rel=1e-6)
    assert (told[601:] > 0).tolist() == [True, True, False, False, False]


def test_still_water_lies_at_its_level(tmp_path):
    land = Land(tmp_path, ISLAND)
    probe = "#declare N = <0, 0, 0>; #declare P = trace(Water, <{x}, 900, 100>, -y, N);" + tell(
        "P.y"
    )
    scene = (
        LOAD
        + tell("Terrain_Water_Level")
        + "#declare Water = object { Terrain_Water(Terrain_Water_Level) }\n"
        + probe.format(x=-9000)
        + "#declare Eye = <500, 300, 1700>;\n"
        + "#declare View = Terrain_View(Eye, Eye + x, 70, 3)\n"
        + "#declare Water = object { Terrain_Water(Terrain_Water_Level) }\n"
        + probe.format(x=500)
        + probe.format(x=-9500)
    )
    level, flat, below, away = floats_of(land.run(scene))
    assert level == WATER and flat == pytest.approx(WATER, abs=1e-6)
    assert below == pytest.approx(WATER - 1600**2 / (2 * EARTH), abs=1e-3)
    assert away == pytest.approx(WATER - (1e8 + 1600**2) / (2 * EARTH), abs=1e-3)


@pytest.mark.parametrize("arguments", [[], ["--format", "height_field"], REGION])
def test_the_scene_of_the_folder_shows_land_water_and_sky(tmp_path, arguments):
    land = Land(tmp_path, ISLAND, *arguments)
    log = povray(tmp_path, (tmp_path / "scene.pov").read_text(), width=128, height=72)
    assert "rror" not in log and land.done.returncode == 0
    image = read_png(tmp_path / "out.png")[:, :, :3]
    sky, middle, sea = image[60:], image[30:50, 30:98], image[:6]
    assert sky[:, :, 2].min() > 0.3
    assert sea[:, :, 2].mean() > sea[:, :, 0].mean() and sea.mean() < 0.35

    def land_share(part):  # ground is brown or green, never blue
        return (part[:, :, 1] > 1.02 * part[:, :, 2]).mean()

    assert land_share(middle) > 0.08 and land_share(sea) == 0.0


@pytest.mark.parametrize(
    ("source", "arguments", "reason"),
    [
        (ISLAND, ["--region", "300,1400,900,1750"], "--region and --cell: give both"),
        (ISLAND, ["--cell", "10"], "--region and --cell: give both"),
        (ISLAND, [*REGION, "--resolution", "64"], "--resolution is for a whole land"),
        (ISLAND, ["--region", "0,0,9,9", "--cell", "1"], "and the land from"),
        (ISLAND, [*REGION[:2], "--cell", "0"], "--cell = 0; allowed"),
        (ISLAND, [*REGION[:2], "--cell", "0.1"], "allowed are at most 2048"),
        (None, REGION, "--region and --cell: only a terrain and a sea over a bed"),
    ],
)
def test_regions_that_cannot_be_are_refused(tmp_path, source, arguments, reason):
    if source is not None:
        (tmp_path / "land.toml").write_text(source)
    done = ocean(
        tmp_path, "povray", "land.toml" if source else "preset:beaufort_3", "-o", "out", *arguments
    )
    assert done.returncode == 2 and reason in done.stderr, done.stderr
    assert len(done.stderr.splitlines()) == 1 and not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("scene", "reason"),
    [
        (LOAD + "object { Terrain_View(<0, -99, 1500>, 0, 60, 2) }", "m below the ground"),
        (LOAD + "object { Terrain_View(<0, 900, 1500>, <0, 900, 1500>, 60, 2) }", "the eye itself"),
        (LOAD + "object { Terrain_View(<0, 900, 1500>, 0, 60, 0) }", "Pixel is 0.000; allowed"),
        ("object { Terrain_View(<0, 900, 1500>, 0, 60, 2) }", "comes before Terrain_Load"),
        ("object { Terrain_Water(0) }", "Terrain_Water comes before Terrain_Load"),
    ],
)
def test_mistakes_of_a_scene_stop_with_a_sentence(tmp_path, scene, reason):
    land = Land(tmp_path, ISLAND)
    log = " ".join(land.run(scene, good=False).split())
    assert reason in log, log[-600:]
