# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The folder of a region of a sea with hulls, as POV-Ray itself reads it.

Claims: functions have the values of the library's region, with trails as foam, and outside of it
those of the open sea; the water has a hole where the hull is, of the water plane's area, and no
other; the scene of the folder shows water and sky; what does not belong is refused in a sentence.
"""

import shutil

import numpy
import pytest
from conftest import Folder, ocean, read_png, render_as_it_is, tell

import libocean

SEA = """libocean = 1
[grid]
resolution = 64
patch_size = 100.0
[[waves]]
wind_speed = 4.0
[[hulls]]
length = 20.0
beam = 5.0
draught = 1.2
wake_resolution = 128
track = [[-100.0, -600.0, 10.0], [50.0, 300.0, 10.0]]
"""
REGION = ["--region", "-80,-30,40,50", "--cell", "1"]
ORIGIN, SAMPLES, STEP = (-80.0, -30.0), (121, 81), 1.0


class Hulls(Folder):
    head = '#include "ocean.inc"\n#include "coast.inc"\n'


@pytest.fixture(scope="module")
def hulls(tmp_path_factory):
    return Hulls(tmp_path_factory.mktemp("hulls"), SEA, *REGION)


def test_functions_have_the_values_of_the_region_and_beside_it_of_the_open_sea(hulls):
    sea = libocean.open(hulls.path / "sea.toml")
    names = ("height", "displacement", "cover", "trail", "dry")
    maps = sea.region(0.0, ORIGIN, SAMPLES, STEP, names)
    # The map fades within 20 m of its sides.
    inner = [(i, j) for j in range(21, 60, 6) for i in range(21, 100, 6)] + [(80, 40), (76, 41)]
    functions = ("Height", "DX", "DZ", "Cover", "Hull_Trail", "Hull_Mask")
    places = [f"({ORIGIN[0] + i}, {ORIGIN[1] + j})" for i, j in inner]
    scene = "".join(tell(*(f"Ocean_{name}{place}" for name in functions)) for place in places)
    told = hulls.told(scene + tell("Ocean_Height(-500, 30)", "Ocean_Hull_Mask(-500, 30)"))
    seen = told[:-2].reshape(-1, 6)
    at = tuple(numpy.array(inner).T[::-1])
    truth = {name: maps[name][at] for name in names}
    assert truth["trail"].max() > 0.7 and truth["dry"].max() == 1
    assert abs(seen[:, 0] - truth["height"]).max() < 1e-6
    assert abs(seen[:, 1:3] - truth["displacement"][:, :2]).max() < 2e-5
    # A byte holds a 255th.
    assert abs(seen[:, 4] - truth["trail"]).max() < 0.5 / 255 + 1e-6
    assert abs(seen[:, 5] - truth["dry"]).max() < 0.5 / 255 + 1e-6
    assert seen[:, 3] == pytest.approx(numpy.maximum(truth["cover"], seen[:, 4]), abs=1e-6)
    open_sea = libocean.parse(SEA[: SEA.index("[[hulls]]")]).surface(0.0, resolution=64)
    i, j = int(-500 / (100 / 64)) % 64, int(30 / (100 / 64)) % 64
    assert told[-1] == 0
    assert abs(told[-2] - open_sea.height[j, i]) < 0.3 * abs(open_sea.height).max()


def test_the_water_has_a_hole_where_the_hull_is_and_no_other(hulls):
    """From above; water is blue, the open sea green, what shines through red."""
    hulls.told(
        """
#macro Plain(Colour)
    texture { pigment { rgb Colour } finish { ambient 0 diffuse 0 emission 1 } }
#end
#declare Eye = <-10, 200, 10>;
camera { orthographic location Eye look_at Eye - 200*y right 80*x up 50*z sky z }
background { rgb <1, 0, 0> }
object { Ocean_Coast_Water(Eye, Eye - 100*y + 0.1*z, 170, 10) Plain(<0, 0, 1>) }
object { Ocean_Coast_Beyond(Eye, Eye - 100*y + 0.1*z, 170, 0.5) Plain(<0, 1, 0>) }
""",
        width=320,
        height=200,
    )
    image = read_png(hulls.path / "out.png")
    hole = image[:, :, 0] > 0.5
    rows, columns = numpy.nonzero(hole)
    x, z = 30 - (columns + 0.5) / 4, 35 - (rows + 0.5) / 4
    print("hole", hole.sum() / 16, "m2, x", x.min(), x.max(), "z", z.min(), z.max())
    # Squares of half a metre that the line of 41 m cuts stay, for the hull to hide.
    plane = 2 / 3 * 20 * 5
    assert plane - 0.3 * 41 < hole.sum() / 16 < plane
    assert -10 < x.min() < -8.5 and 8.5 < x.max() < 10
    assert 7.5 < z.min() < 8 and 12 < z.max() < 12.5


def test_the_scene_of_the_folder_shows_water_and_sky(hulls):
    render_as_it_is(hulls.path, "scene.pov", "+W48", "+H27")
    image = read_png(hulls.path / "scene.png")[:, :, :3]
    red, blue = image[:, :, 0], image[:, :, 2]
    assert blue[-3:].mean() > 1.05 * red[-3:].mean(), "no sky above"
    assert (blue[:13] > 1.02 * red[:13]).mean() > 0.5, "no water below"
    assert image[:13].max() < 1.1 * image[-3:].max(), "the hole is brighter than the sky"


def test_what_does_not_belong_is_refused_in_a_sentence(hulls, tmp_path):
    view = '(<0, 5, 0>, <9, 0, 0>, 60, 1, "jerlov_ii")'
    assert "Ocean_Coast needs the folder of a sea over a bed" in hulls.error(
        hulls.load + "Ocean_Coast" + view
    )
    whole = Hulls(tmp_path / "whole", SEA)
    for name in ("coast.inc", "terrain.inc"):
        shutil.copy(hulls.path / name, whole.path / name)
    needs = "Ocean_Hulls needs the folder of a sea over a bed (water.seabed) or of a region with"
    assert needs in whole.error(whole.load + "Ocean_Hulls" + view)
    words = "povray its_sea.toml -o mesh --format mesh2"
    assert "--format mesh2: a sea with hulls has df3" in ocean(whole.path, words, *REGION).stderr
