# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Light under water: absorption and caustics, as POV-Ray renders them."""

import numpy
import pytest
from conftest import Folder, floats_of, read_png, sea_text


@pytest.mark.parametrize("hollow", ["", "hollow"])
@pytest.mark.parametrize(
    "form",
    [
        "Ocean_Volume(<30, 0, 30>, 60, 20, 0.25)",
        "Ocean_Block(20)",
        "intersection { object { Ocean_Block(20) } box { <5, -21, 5>, <95, 9, 95> }",
    ],
)
def test_light_is_lost_by_beers_law_for_a_camera_under_water(choppy, form, hollow):
    """Whether or not its user knows of POV-Ray's word `hollow`."""
    form += ' Ocean_Clear_Material("jerlov_3c") ' + hollow + (" }" if "{" in form else "")
    form = form if form.startswith("intersection") else "object { " + form + " }"
    losses = []
    for depth in (4.0, 9.0, 16.0):
        choppy.run(
            f"""global_settings {{ assumed_gamma 1.0 }}
Ocean_Load("sea_0001")
camera {{ orthographic location <30, -3, 30> direction -y right 0.5*x up 0.5*z }}
{form}
box {{ <-500, -{3 + depth} - 1, -500>, <500, -{3 + depth}, 500>
      pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 0 emission 0.9 }} }}"""
        )
        seen = read_png(choppy.path / "out.png").mean(axis=(0, 1)) / 0.9
        absorption = numpy.array([0.314, 0.128, 0.180])  # of jerlov_3c, as water_types.cpp has it
        losses.append(seen / numpy.exp(-absorption * depth))
    print(losses)
    assert numpy.abs(numpy.array(losses) - 1.0).max() < 0.01


@pytest.mark.parametrize("form", ["Ocean_Volume(<30, 0, 30>, 60, 20, 0.25)", "Ocean_Block(20)"])
def test_the_water_glows_without_a_word_from_its_user(choppy, form):
    choppy.run(
        f"""global_settings {{ assumed_gamma 1.0 }}
Ocean_Load("sea_0001")
camera {{ orthographic location <30, -3, 30> direction -y right 0.5*x up 0.5*z }}
object {{ {form} Ocean_Underwater("jerlov_3c", 1) }}"""
    )
    assert read_png(choppy.path / "out.png").mean() > 0.01


def test_light_from_above_is_lost_by_beers_law_too(choppy):
    """A floor 8 m down, lit by a lamp above clear water; seen from below, without the eye's way."""
    lit = []
    for water in ("", 'object { Ocean_Block(20) Ocean_Clear_Material("jerlov_3c") }'):
        choppy.run(
            f"""global_settings {{ assumed_gamma 1.0 max_trace_level 9 }}
Ocean_Load("sea_0001")
camera {{ orthographic location <30, -7.9, 30> direction -y right 0.5*x up 0.5*z }}
light_source {{ <30, 1e5, 30> rgb 0.5 parallel point_at <30, 0, 30> }}
{water}
box {{ <-500, -9, -500>, <500, -8, 500> pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 1 }} }}"""
        )
        lit.append(read_png(choppy.path / "out.png").mean(axis=(0, 1)))
    surface_height = 0.5  # of the sea there, at most
    absorption = numpy.array([0.314, 0.128, 0.180])
    loss = -numpy.log(lit[1] / lit[0])
    assert numpy.abs(loss[0] / loss[1] - absorption[0] / absorption[1]).max() < 0.15
    assert loss[0] == pytest.approx(0.314 * 8, rel=surface_height / 8 + 0.02)


HULL = "union { box { <-4, -9, -2>, <4, 9, 2> } cylinder { <0, -9, 0>, <0, 9, 0>, 3 } }"


@pytest.mark.parametrize(
    "form",
    [
        "Ocean_Mesh()",
        "Ocean_Block(8)",
        "Ocean_Tiles(object { Ocean_Mesh() }, 1, 1)",
        "Ocean_View(<30, 12, 30>, <45, 0, 45>, 60, 0.4)",
        "Ocean_Volume(<30, 0, 30>, 60, 8, 0.25)",
        "Ocean_Isosurface(<0, -4, 0>, <100, 4, 100>)",
        "Ocean_Height_Field()",
    ],
)
def test_no_water_stands_in_a_hull(choppy, tmp_path, form):
    folder = choppy
    if "Height_Field" in form:
        folder = Folder(tmp_path, sea_text(), "--format", "height_field")
    log = folder.run(
        f"""Ocean_Load("sea_0001")
#declare Hull = object {{ {HULL} translate <45, 0, 45> }}
#declare Whole = object {{ {form} }}
#declare Cut = Ocean_Cut_Out(Whole, Hull)
#macro Tell(Water, X, Z)
    #local Normal = <0, 0, 0>;
    #local Hit = trace(Water, <45 + X, 20, 45 + Z>, -y, Normal);
    #debug concat("V ", str(vlength(Normal)*(1 + (Hit.y < -5)), 0, 3), "\n")
#end
#for (K, 0, 6) Tell(Whole, K - 3, 1.2) Tell(Cut, K - 3, 1.2) Tell(Cut, K - 3, 3.5) #end"""
    )
    whole, inside, beside = floats_of(log).reshape(7, 3).T
    assert numpy.all(whole == pytest.approx(1.0, abs=1e-3)), "there was no water to cut"
    assert not numpy.any(inside == pytest.approx(1.0, abs=1e-3))
    assert numpy.all(beside == pytest.approx(1.0, abs=1e-3)), "too much was cut away"


POOL = """global_settings { assumed_gamma 1.0 max_trace_level 10 photons { count 150000 } }
Ocean_Load("sea_0001")
camera { orthographic location <5, 8, 5> direction -y right 5*x up 5*z }
light_source { <20, 60, 10> rgb 0.2 parallel point_at 0 photons { refraction on reflection off } }
intersection {
    object { Ocean_Block(4) }
    box { <1, -1.6, 1>, <9, 1, 9> }
    Ocean_Clear_Material("jerlov_i")
    Ocean_Caustics()
}
box { <-20, -3, -20>, <20, -1.7, 20> pigment { rgb 0.8 } finish { ambient 0 diffuse 1 } }"""


def test_the_waves_of_a_pool_gather_light(tmp_path):
    """Brightest over mean light on its floor, without and with photons."""
    folder = Folder(
        tmp_path,
        sea_text(
            resolution=128,
            period=10.0,
            choppiness=0.5,
            wind=3.0,
            more="shortest_wavelength = 0.4",
            waves="significant_wave_height = 0.12\npeak_period = 1.2",
        ),
    )
    folder.run(POOL, width=100, height=100)
    light = read_png(folder.path / "out.png")[..., 1]
    contrast = numpy.percentile(light, 99.5) / light.mean()
    print(f"\ncontrast {contrast:.2f}")
    assert contrast > 2.0
