# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Light under water: absorption and caustics, as POV-Ray renders them."""

import numpy
import pytest
from conftest import Folder, read_png, sea_text


@pytest.mark.parametrize("form", ["Ocean_Volume(<30, 0, 30>, 60, 20, 0.25)", "Ocean_Block(20)"])
def test_light_is_lost_by_beers_law_for_a_camera_under_water(choppy, form):
    losses = []
    for depth in (4.0, 9.0, 16.0):
        choppy.run(
            f"""global_settings {{ assumed_gamma 1.0 }}
Ocean_Load("sea_0001")
camera {{ orthographic location <30, -3, 30> direction -y right 0.5*x up 0.5*z }}
object {{ {form} Ocean_Clear_Material("jerlov_3c") hollow }}
box {{ <-500, -{3 + depth} - 1, -500>, <500, -{3 + depth}, 500>
      pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 0 emission 0.9 }} }}"""
        )
        seen = read_png(choppy.path / "out.png").mean(axis=(0, 1)) / 0.9
        absorption = numpy.array([0.314, 0.128, 0.180])  # of jerlov_3c, as water_types.cpp has it
        losses.append(seen / numpy.exp(-absorption * depth))
    print(losses)
    assert numpy.abs(numpy.array(losses) - 1.0).max() < 0.01


POOL = """global_settings { assumed_gamma 1.0 max_trace_level 10 photons { count 150000 } }
Ocean_Load("sea_0001")
camera { orthographic location <5, 8, 5> direction -y right 5*x up 5*z }
light_source { <20, 60, 10> rgb 0.2 parallel point_at 0 photons { refraction on reflection off } }
intersection {
    object { Ocean_Block(4) }
    box { <1, -1.6, 1>, <9, 1, 9> }
    Ocean_Clear_Material("jerlov_i")
    hollow
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
