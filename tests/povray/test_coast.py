# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The folder of a sea over a bed, as POV-Ray itself reads it.

Claims: functions of the coast have the values of the library's region at its labels, and outside of
it those of the open sea; where the map ends within the bed it fades into the open sea without a
step; the land is the bed, and as wet as the library has it; its water lies where its functions say,
and no ray from an eye over the beach that must meet land or water misses both, at the border of the
map neither; land and water, sky and wet sand have their colours in the scene of the folder; what
does not belong is refused in a sentence.
"""

import json
import re
import shutil
from pathlib import Path

import numpy
import pytest
from conftest import Folder, ocean, read_png, render_as_it_is, tell

import libocean

CELL, COLUMNS, ROWS = 8.0, 61, 45
SEA = """libocean = 1
[grid]
resolution = 64
patch_size = 128.0
[water]
depth = 12.0
seabed = "bed.asc"
seabed_origin = [-200.0, 30.0]
[[waves]]
spectrum = "jonswap"
wind_speed = 8.0
significant_wave_height = 1.2
peak_period = 6.0
wind_direction = 0.0
"""


def bed_heights():
    """A beach of 1 in 20 in the east, with a cape in its middle: [j, i] from the south."""
    x, z = numpy.meshgrid(CELL * numpy.arange(COLUMNS), CELL * numpy.arange(ROWS))
    shore = 330.0 - 60.0 * numpy.exp(-(((z - 176.0) / 40.0) ** 2))
    slope = 0.05 + 0.15 * numpy.exp(-(((z - 176.0) / 40.0) ** 2))
    return numpy.maximum(-12.0, numpy.minimum(20.0, slope * (x - shore))).round(3)


def write_bed(folder):
    rows = "\n".join(" ".join(map(str, row)) for row in bed_heights()[::-1])
    (folder / "bed.asc").write_text(
        f"ncols {COLUMNS}\nnrows {ROWS}\nxllcorner 0\nyllcorner 0\ncellsize {CELL}\n{rows}\n"
    )


REGION = ["--region", "-60,70,180,382", "--cell", "4"]
ORIGIN, SAMPLES, STEP = (-60.0, 70.0), (61, 79), 4.0


class Coast(Folder):
    def __init__(self, path, *arguments):
        self.path = path
        path.mkdir(exist_ok=True)
        write_bed(path)
        (path / "its_sea.toml").write_text(SEA)
        command = "povray its_sea.toml -o ."
        self.forecast = ocean(path, command, *arguments, "-n", "--json")
        assert not (path / "sea.toml").exists(), "a dry run wrote a file"
        self.made = ocean(path, command, *arguments)
        assert self.made.returncode == 0, self.made.stderr
        self.sea = libocean.open(path / "sea.toml")

    head = '#include "ocean.inc"\n#include "coast.inc"\n'
    load = 'Ocean_Load("sea_0001") Terrain_Load("land")\n'


@pytest.fixture(scope="module")
def coast(tmp_path_factory):
    """A part of the bed, cut on all sides but the northern one."""
    return Coast(tmp_path_factory.mktemp("coast"), *REGION)


def test_functions_have_the_values_of_the_region_and_beside_it_of_the_open_sea(coast):
    maps = coast.sea.region(0.0, ORIGIN, SAMPLES, STEP, ("height", "displacement", "cover"))
    # Within 64 m of the sides that lie in the bed the map fades; a quarter of 240 m is less.
    inner = [(i, j) for j in range(16, 79, 9) for i in range(16, 45, 5)]
    names = ("Ocean_Height", "Ocean_DX", "Ocean_DZ", "Ocean_Cover")
    scene = "".join(
        tell(*(f"{name}({ORIGIN[0] + STEP * i}, {ORIGIN[1] + STEP * j})" for name in names))
        for i, j in inner
    )
    outside = [(-100.0, 90.0), (50.0, 20.0), (300.0, 210.0), (4000.0, -3000.0)]
    scene += "".join(tell(*(f"{name}({x}, {z})" for name in names[:3])) for x, z in outside)
    scene += tell("Ocean_Height_At(20, 200)")
    told = coast.told(scene)
    seen = told[: 4 * len(inner)].reshape(-1, 4)
    at = tuple(numpy.array(inner).T[::-1])
    assert numpy.ptp(maps["height"][at]) > 0.5 and numpy.ptp(maps["cover"]) > 0.3
    assert abs(seen[:, 0] - maps["height"][at]).max() < 1e-6
    assert abs(seen[:, 1:3] - maps["displacement"][at][:, :2]).max() < 2e-5
    assert abs(seen[:, 3] - maps["cover"][at]).max() < 1e-6
    text = re.sub(r"(?m)^(seabed.*|\[water\.\w+\])$", "", SEA)
    open_sea = libocean.parse(text).surface(0.0, resolution=64)
    step = 128.0 / 64
    beyond = told[4 * len(inner) : -1].reshape(-1, 3)
    for (x, z), (height, dx, dz) in zip(outside, beyond, strict=True):
        i, j = int(x / step) % 64, int(z / step) % 64
        assert height == pytest.approx(open_sea.height[j, i], abs=1e-6)
        assert (dx, dz) == pytest.approx(open_sea.displacement[j, i, :2], abs=2e-5)
    point = coast.sea.query([(20.0, 200.0)], 0.0)
    # Straight lines between samples 4 m apart, of waves of 6 s.
    assert told[-1] == pytest.approx(point[0, 2], abs=0.12)


def test_the_ground_is_as_wet_as_in_the_region(coast):
    wet = coast.sea.region(0.0, ORIGIN, SAMPLES, STEP, ("wetness",))["wetness"]
    places = [(i, j) for j in range(1, 79, 7) for i in range(40, 60)]
    scene = "".join(
        tell(f"Ocean_Wetness({ORIGIN[0] + STEP * i}, {ORIGIN[1] + STEP * j})") for i, j in places
    )
    told = coast.told(scene + tell("Ocean_Wetness(-70, 200)"))
    truth = numpy.array([wet[j, i] for i, j in places])
    assert (truth == 0).any() and (truth == 1).any() and ((truth > 0.1) & (truth < 0.9)).any()
    # A byte holds a 255th.
    assert abs(told[:-1] - truth).max() < 0.5 / 255 + 1e-6
    assert told[-1] == 0, "outside of the map"


def test_damp_sand_is_nearly_as_dark_as_wet_sand(coast):
    """Linear albedos of a beach for the wetness of dry, damp (the 2 % run-up) and wet ground."""
    x, z = 145, 100
    scene = '#include "functions.inc"\n' + tell(f"Terrain_Beach({x}, {z})")
    for wetness in (0, 0.5, 1):
        scene += f"""#ifdef(Terrain_Wetted) #undef Terrain_Wetted #end
#declare Terrain_Wetted = function(x, z) {{ {wetness} }}
#declare Seen = eval_pigment(Terrain_Cover(1e4), <{x}, Terrain_Height({x}, {z}), {z}>);
""" + tell("Seen.green")
    beach, dry, damp, wet = coast.told(scene)
    print(f"beach {beach}, albedo dry {dry:.3f}, damp {damp:.3f}, wet {wet:.3f}")
    assert beach > 0.9
    assert 0.4 < wet / dry < 0.6
    assert wet < damp < 0.6 * dry


def test_the_map_fades_into_the_open_sea_and_ends_on_the_side_of_the_bed(coast):
    inside, outside = 1e-4, -1e-4
    pairs = []
    for k in range(12):
        x, z = -50 + 19 * k, 85 + 23 * k
        pairs += [((-60 + d, z), (180 - d, z), (x, 70 + d)) for d in (inside, outside)]
    told = coast.told(tell(*(f"Ocean_Height({x}, {z})" for row in pairs for x, z in row)))
    told = told.reshape(-1, 2, 3)
    assert abs(told[:, 0] - told[:, 1]).max() < 1e-3
    text = (coast.path / "ocean_parameters.inc").read_text()
    assert "Ocean_Coast_Fades = array[4] { true, true, true, false };" in text


def test_the_land_is_the_bed(coast):
    heights = bed_heights()
    places = [(i, j) for j in range(0, ROWS, 4) for i in range(0, COLUMNS, 5)]
    probes = [f"Terrain_Height({-200 + CELL * i}, {30 + CELL * j})" for i, j in places]
    told = coast.told(tell(*probes, "Terrain_Beach(150, 60)", "Terrain_Beach(280, 60)"))
    truth = numpy.array([heights[j, i] for i, j in places])
    assert abs(told[:-2] - truth).max() < 1e-5
    assert told[-2] > 0.9 and told[-1] < 0.1


# The coast's water is blue, the open sea green, the background that shines through a hole red. No
# land hides a hole.
PLAIN = """
#macro Plain(Colour)
    texture {{ pigment {{ rgb Colour }} finish {{ ambient 0 diffuse 0 emission 1 }} }}
#end
#declare Eye = {eye};
#declare Target = Eye + {forward};
camera {{ location Eye right x*image_width/image_height angle 70 look_at Target }}
background {{ rgb <1, 0, 0> }}
object {{ Ocean_Coast_Water(Eye, Target, 70, 0.3) Plain(<0, 0, 1>) }}
object {{ Ocean_Coast_Beyond(Eye, Target, 70, 0.3) Plain(<0, 1, 0>) }}
""" + tell("Ocean_Coast_Vertices")


@pytest.mark.parametrize(
    "eye,forward",
    [
        ("<150, 3.5, 100>", "<-1, -0.08, 0.4>"),
        ("<100, 3.5, 100>", "<-0.4, -0.08, -1>"),
        ("<60, 60, 75>", "<0.013, -1, 0.004>"),
    ],
)
def test_no_ray_that_must_meet_water_misses_it(coast, eye, forward):
    vertices = coast.told(PLAIN.format(eye=eye, forward=forward), width=160, height=90)[0]
    image = read_png(coast.path / "out.png")
    # The horizon lies 4 degrees over the middle of a level view.
    below = image[:46] if "60, 60" not in eye else image
    red, green, blue = ((image[:, :, k] > 0.5).mean() for k in range(3))
    print(eye, int(vertices), "vertices", red, green, blue)
    assert not (below[:, :, 0] > 0.5).any()
    assert green > 0.01 and blue > 0.1 and vertices < 20000


def test_no_function_has_two_parameters_that_povray_takes_for_one():
    """A function (x, z, u) reads u as x."""
    macros = Path(__file__).parents[2] / "povray_macros"
    found = []
    for path in macros.rglob("*.inc*"):
        for parameters in re.findall(r"function *\(([^()]*)\)", path.read_text()):
            names = {name.strip() for name in parameters.split(",")}
            if {"x", "u"} <= names or {"y", "v"} <= names:
                found.append(f"{path.name}: ({parameters})")
    assert not found


def test_the_water_has_one_tone_on_both_sides_of_the_border_of_the_map(coast):
    """Seen along the western border, which lies in the middle column, 100 .. 300 m away."""
    image = coast.seen(
        """#declare Eye = <-60, 12, 60>;
#declare Target = Eye + <0, -0.06, 1>;
camera { location Eye right x*image_width/image_height angle 40 look_at Target }
Ocean_Eye_At(Eye, 40) Ocean_Sun(40, -90) Ocean_Sky(0)
object { Ocean_Coast_Beyond(Eye, Target, 40, 0.5) Ocean_Material("jerlov_3c") no_reflection }
object { Ocean_Coast_Water(Eye, Target, 40, 0.5) Ocean_Coast_Material("jerlov_3c") no_reflection }
""",
        settings="max_trace_level 6", width=96, height=54,
    )[27 - 12 : 27 + 1, :, :3]  # fmt: skip
    outside, inside = image[:, 30:46].mean((0, 1)), image[:, 50:66].mean((0, 1))
    print("outside", outside.round(4), "inside", inside.round(4))
    assert outside == pytest.approx(inside, rel=0.06)


def test_the_scene_of_the_folder_shows_land_water_and_sky(coast):
    render_as_it_is(coast.path, "scene.pov", "+W48", "+H27")
    image = read_png(coast.path / "scene.png")[:, :, :3]
    red, blue = image[:, :, 0], image[:, :, 2]
    assert (blue[-3:] > 1.15 * red[-3:]).all(), "no sky above"
    sand = red > 1.1 * blue
    water = blue > 1.02 * red
    assert sand[:13].mean() > 0.1 and water[:13].mean() > 0.1
    # The sand that is nearest to the water is the darkest.
    assert image[sand].max() > 1.3 * image[sand].min()


def test_files_that_do_not_belong_are_refused_in_a_sentence(coast):
    assert "Ocean_Coast_Land comes before Ocean_Load" in coast.error("Ocean_Coast_Land()")
    text = (coast.path / "coast_0001.df3.inc").read_text()
    (coast.path / "coast_0001.df3.inc").write_text(re.sub(r'Sea_ = "\w', 'Sea_ = "z', text))
    log = coast.error(coast.load)
    (coast.path / "coast_0001.df3.inc").write_text(text)
    assert "coast_0001.df3.inc is frame 1 at 0.000 s of another sea" in log


def test_a_dry_run_lists_the_whole_folder_and_a_later_chunk_joins_it(tmp_path, coast):
    events = map(json.loads, coast.forecast.stderr.splitlines())
    plan = [event for event in events if event["event"] == "plan"][-1]
    assert coast.made.stdout == coast.forecast.stdout
    assert plan["files"] == len(coast.made.stdout.splitlines())
    folder = tmp_path / "f"
    shutil.copytree(coast.path, folder)
    again = ocean(folder, "povray its_sea.toml -o . --frames 5", *REGION)
    assert again.returncode == 0, again.stderr
    text = (folder / "ocean_parameters.inc").read_text()
    assert "Ocean_Frames = array[2] { 1, 5 };" in text and "Ocean_Coast_Cell = 4;" in text
    assert (folder / "coast_0005.df3").is_file()
