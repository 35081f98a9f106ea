# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Sky, sun and the camera's place: the horizon, twilight, how far slope tiles and lace are seen."""

import re

import numpy
import OpenImageIO as oiio
import pytest
from conftest import Folder, floats_of, read_png, sea_text, tell


@pytest.mark.parametrize("height", [2, 60, 2000, 15000])
@pytest.mark.parametrize("told", [True, False])
def test_sky_and_sea_meet_at_the_horizon(choppy, height, told):
    """Black water: all that is not water is sky, as bright at the horizon as above it."""
    columns, rows = 32, 240
    picture = choppy.seen(
        f"""#declare Eye = <0, {height}, 0>;
{"Ocean_Eye_At(Eye, 2)" if told else ""}
#declare Target = Eye + <1, -{numpy.sqrt(2 * height / 6371000.0)}, 0>;
camera {{ location Eye right x*image_width/image_height angle 1.2 look_at Target }}
Ocean_Sun(40, 90)
Ocean_Sky(0)
object {{ Ocean_View(Eye, Target, 1.2, 0.05) pigment {{ rgb 0 }} }}""",
        width=columns,
        height=rows,
    ).mean(axis=2)
    water = picture < 1e-4
    assert 0.2 < water.mean() < 0.8, "there is no horizon in the picture"
    first = int(numpy.argmax(~water[:, columns // 2]))  # rows begin at the bottom
    assert numpy.all(water[: first - 1]) and not numpy.any(water[first + 1 :])
    sky = picture[first + 1 : first + 31]
    assert sky.min() > 0.9 * sky.max() > 0.55


def test_far_water_blurs_the_clouds_that_it_mirrors(tmp_path):
    """Against a mirror on the same mesh: the contrast of columns, which are streaks."""
    folder = Folder(tmp_path, sea_text(resolution=128, period=200.0, wind=12.0))
    smooth = "pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on } }"
    contrast = {}
    for water in (f"{smooth} interior {{ ior Ocean_Water_Ior }}", 'Ocean_Material("jerlov_ii")'):
        picture = folder.seen(
            f"""#declare Eye = <0, 20, 0>;
#declare Target = Eye + <1, -0.012, 0.1>;
camera {{ location Eye right x*image_width/image_height angle 30 look_at Target }}
Ocean_Eye_At(Eye, 30)
#declare Ocean_Sun_Altitude = 45;  // and no light, so no glitter
#declare Ocean_Sun_Direction = <0, 1, 0>;
#declare Ocean_Sun_Colour = <0, 0, 0>;
#declare Ocean_Sun_Shown_ = 0;
Ocean_Sky(0.5)
#declare Ocean_Sky_Light = 0;
object {{ Ocean_View(Eye, Target, 30, 1) {water} no_reflection }}""",
            *("+A0.05", "+AM2", "+R2"), settings="max_trace_level 4", width=320, height=100,
        )  # fmt: skip
        rows = picture.mean(axis=2)
        horizon = int(numpy.argmax(rows.mean(axis=1) > 0.5))
        far = rows[horizon - 18 : horizon - 2]
        columns = far.mean(axis=0)
        contrast[water] = columns.std() / columns.mean()
    mirror, material = contrast.values()
    print(f"\nmirror {mirror:.3f}, material {material:.3f}")
    assert mirror > 0.02, "there are no streaks to blur"
    assert material < 0.5 * mirror


def brightness(folder, altitude):
    """Mean of the sky of a picture of it all, linear."""
    folder.run(
        f"""global_settings {{ assumed_gamma 1.0 }}
Ocean_Eye_At(2*y, 60)
camera {{ location 2*y right x*image_width/image_height angle 60 look_at <10, 8, 0> }}
Ocean_Sun({altitude}, 90)
Ocean_Sky(0)""",
        width=48,
        height=27,
    )
    return read_png(folder.path / "out.png").mean()


@pytest.mark.parametrize("altitude,clouds", [(2, 0.0), (12, 0.0), (35, 0.0), (70, 0.0), (25, 0.5)])
def test_the_light_of_the_sky_is_its_irradiance_over_pi(choppy, altitude, clouds):
    """Integrates a picture of the whole sky, with the sine of the elevation as weight."""
    columns, rows = 360, 180
    log = choppy.run(
        f"""global_settings {{ assumed_gamma 1.0 }}
Ocean_Eye_At(0, 60)
camera {{ spherical angle 360 180 location 0 look_at x }}
Ocean_Sun({altitude}, 40)
Ocean_Sky({clouds})
{tell("Ocean_Sky_Light.x", "Ocean_Sky_Light.y", "Ocean_Sky_Light.z")}""",
        "+FE",
        f"+Osky_{altitude}.exr",
        width=columns,
        height=rows,
    )
    picture = oiio.ImageBuf(str(choppy.path / f"sky_{altitude}.exr")).get_pixels(oiio.FLOAT)[
        : rows // 2, :, :3
    ]
    elevation = numpy.pi / 2 - (numpy.arange(rows // 2) + 0.5) * numpy.pi / rows
    weight = numpy.sin(elevation) * numpy.cos(elevation)
    mean = (picture.mean(1) * weight[:, None]).sum(0) / weight.sum()
    told = floats_of(log)
    print(f"\n{told}, of the picture {mean}: {told / mean}")
    assert told == pytest.approx(mean, rel=0.02)
    if clouds == 0 and altitude > 30:
        assert told[2] > 1.5 * told[0], "a blue sky's light is blue"


def test_twilight_is_as_dark_as_it_is(choppy):
    """Lux of the Explanatory Supplement: 3.4 at -6 degrees, where civil twilight ends."""
    sunset = brightness(choppy, 0)
    for altitude, lux in ((-2.0, 199.0), (-4.0, 29.9)):
        assert brightness(choppy, altitude) / sunset == pytest.approx(lux / 758.6, rel=0.15)
    told = choppy.told(
        """Tell(Ocean_Twilight_(20)) Tell(Ocean_Twilight_(0)) Tell(758.6*Ocean_Twilight_(-6))
Tell(758.6*Ocean_Twilight_(-12)) Tell(758.6*Ocean_Twilight_(-18)) Tell(Ocean_Twilight_(-60))
#for (K, 0, 199) Tell(Ocean_Twilight_(-K/10)) #end"""
    )
    day, sunset, civil, nautical, astronomical, night, *course = told
    assert day == 1 and sunset == pytest.approx(1, rel=1e-6)
    assert civil == pytest.approx(3.4, rel=0.02)
    assert nautical == pytest.approx(0.0083, rel=0.1)
    assert astronomical == pytest.approx(6.5e-4, rel=0.1)
    assert night * 758.6 == pytest.approx(astronomical, rel=1e-3)
    # The pieces of the table meet within 3 %.
    assert numpy.all(numpy.diff(numpy.log(course)) < 0.03)


@pytest.mark.parametrize("altitude,lit", [(10.0, True), (0.0, True), (-0.5, True), (-1.5, False)])
def test_a_sun_that_has_set_lights_nothing(choppy, altitude, lit):
    """A ball of no colour of its own: not from below either."""
    choppy.run(
        f"""global_settings {{ assumed_gamma 1.0 }}
camera {{ location <0, 0, -4> look_at 0 }}
Ocean_Sun({altitude}, -90)
sphere {{ 0, 1 pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 1 }} }}""",
        width=32,
        height=32,
    )
    assert (read_png(choppy.path / "out.png").max() > 1e-4) == lit


def test_tiles_and_lace_reach_as_far_whatever_the_sea_level(choppy):
    """Their reach is a distance in pixels; and a material before the view knows of Ocean_Eye_At."""
    told = choppy.told(
        """#macro Probe(Height, Angle, Distance)  // of tiles; lace two and a half times as far
    Ocean_Eye_At(<3, Height, 5>, Angle)
    #declare Water = Ocean_Material("jerlov_ii")
    Tell(1 - Ocean_Detail_Left_(3, Height - Distance, 5))
    Tell(Ocean_Lace_Seen_(3, Height - 2.5*Distance, 5))
#end
Probe(-2, 60, 12) Probe(0, 60, 12) Probe(700, 60, 12)
Probe(5, 60, 6) Probe(5, 30, 12) Probe(5, 60, 900)""",
        width=480,
    )
    tiles, lace = told.reshape(6, 2).T
    for seen in (tiles, lace):
        assert seen[0] == pytest.approx(seen[1]) == pytest.approx(seen[2])
    assert tiles[3] > tiles[0] > 0.01 > tiles[5]
    assert tiles[4] > tiles[0], "a longer lens sees farther"
    assert lace[0] > 0.5 > 0 == lace[5]


def test_the_page_says_every_name_that_a_scene_may_declare_or_read(choppy):
    text = (choppy.path / "ocean.inc").read_text()
    names = set(re.findall(r"#(?:declare|ifdef\() ?(Ocean_\w*[^_\W])\b", text))
    explained = " ".join(re.findall(r"^//.*$", text, re.MULTILINE))
    assert {"Ocean_Sky_Light", "Ocean_View_Roll", "Ocean_View_Aspect"} <= names
    of_the_export = {"Ocean_Frames", "Ocean_Fine_Samples", "Ocean_Data_Version", "Ocean_Coast_Cell"}
    for name in names - of_the_export - {"Ocean_Inc_Temp", "Ocean_Earth_Radius"}:
        assert name in explained, name
