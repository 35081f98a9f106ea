# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Light under water: absorption and caustics, as POV-Ray renders them."""

import numpy
import pytest
from conftest import Folder, flat, sea_text


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
    """With and without POV-Ray's keyword `hollow`."""
    form += ' Ocean_Clear_Material("jerlov_3c") ' + hollow + (" }" if "{" in form else "")
    form = form if form.startswith("intersection") else "object { " + form + " }"
    depths = numpy.array([4.0, 9.0, 16.0])  # of three steps of the ground, side by side
    sides = [-500, 30 - 1 / 12, 30 + 1 / 12, 500]
    steps = "".join(
        f"box {{ <{sides[i]}, {-4 - depth}, -500>, <{sides[i + 1]}, {-3 - depth}, 500> }}\n"
        for i, depth in enumerate(depths)
    )
    picture = choppy.seen(
        f"""camera {{ orthographic location <30, -3, 30> direction -y right 0.5*x up 0.5*z }}
{form}
union {{ {steps} pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 0 emission 0.9 }} }}""",
        width=9,
        height=3,
    )
    seen = picture.mean(0).reshape(3, 3, 3).mean(1) / 0.9  # [depth, colour]
    absorption = numpy.array([0.314, 0.128, 0.180])  # of jerlov_3c, as water_types.cpp has it
    losses = seen / numpy.exp(-absorption * depths[:, None])
    print(losses)
    assert numpy.abs(losses - 1.0).max() < 0.01


@pytest.mark.parametrize("form", ["Ocean_Volume(<30, 0, 30>, 60, 20, 0.25)", "Ocean_Block(20)"])
def test_the_water_glows_without_a_word_from_its_user(choppy, form):
    picture = choppy.seen(
        f"""camera {{ orthographic location <30, -3, 30> direction -y right 0.5*x up 0.5*z }}
object {{ {form} Ocean_Underwater("jerlov_3c", 1) }}"""
    )
    assert picture.mean() > 0.01


def test_light_from_above_is_lost_by_beers_law_too(choppy):
    """A floor 8 m down, lit by a lamp above clear water; seen from below, without the eye's way."""
    lit = []
    for water in ("", 'object { Ocean_Block(20) Ocean_Clear_Material("jerlov_3c") }'):
        picture = choppy.seen(
            f"""camera {{ orthographic location <30, -7.9, 30> direction -y right 0.5*x up 0.5*z }}
light_source {{ <30, 1e5, 30> rgb 0.5 parallel point_at <30, 0, 30> }}
{water}
box {{ <-500, -9, -500>, <500, -8, 500> pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 1 }} }}""",
            settings="max_trace_level 9",
        )
        lit.append(picture.mean(axis=(0, 1)))
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
    told = folder.told(
        f"""#declare Hull = object {{ {HULL} translate <45, 0, 45> }}
#declare Whole = object {{ {form} }}
#declare Cut = Ocean_Cut_Out(Whole, Hull)
#macro Probe(Water, X, Z)
    #local Normal = <0, 0, 0>;
    #local Hit = trace(Water, <45 + X, 20, 45 + Z>, -y, Normal);
    Tell(vlength(Normal)*(1 + (Hit.y < -5)))
#end
#for (K, 0, 6) Probe(Whole, K - 3, 1.2) Probe(Cut, K - 3, 1.2) Probe(Cut, K - 3, 3.5) #end"""
    )
    whole, inside, beside = told.reshape(7, 3).T
    assert numpy.all(whole == pytest.approx(1.0, abs=1e-3)), "there was no water to cut"
    assert not numpy.any(inside == pytest.approx(1.0, abs=1e-3))
    assert numpy.all(beside == pytest.approx(1.0, abs=1e-3)), "too much was cut away"


POOL = """camera { orthographic location <5, 8, 5> direction -y right 5*x up 5*z }
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
    settings = "max_trace_level 10 photons { count 150000 }"
    light = folder.seen(POOL, settings=settings, width=100, height=100)[..., 1]
    contrast = numpy.percentile(light, 99.5) / light.mean()
    print(f"\ncontrast {contrast:.2f}")
    assert contrast > 2.0


def sheet(folder, height, cover, more, width, pixels=100):
    """A flat surface seen from straight above or below."""
    picture = folder.seen(
        f"""{flat(cover)}
#declare Ocean_Direction = 0;
#declare Ocean_Foam_Streaks = 0;
#declare Ocean_Repeats_ = 1000;
#declare Ocean_Sky_Light = 1;
Ocean_Eye_At(<30, {height}, 40>, 60)
#declare Ocean_Pixel_ = 1e-9;
camera {{ orthographic location <30, {height}, 40> direction {-numpy.sign(height)}*y
         right {width}*x up {width}*z }}
{more}""",
        settings="max_trace_level 5", width=pixels, height=pixels,
    )  # fmt: skip
    # POV-Ray keeps right and up as they are, whichever way it looks.
    return picture[..., 0]


def test_ripples_are_the_same_surface_from_below(choppy):
    """A mirror under a sky that grows brighter towards +x: what a slope leans its mirrored ray to
    from above it leans the other way from below, and by as much."""
    mirror = """sky_sphere { pigment { function { min(0.9999, max(0, 0.5 + 0.4*x)) }
    color_map { [0 rgb 0] [1 rgb 1] } } }
Ocean_Foam_Settings_() Ocean_Declare_Nearness_() Ocean_Declare_Detail_()
plane { y, 0 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 1 }
    Ocean_Ripples_(Ocean_Eye_Is_Under_()) }"""
    above = sheet(choppy, 5.0, 0, mirror, 0.4)
    below = sheet(choppy, -5.0, 0, mirror, 0.4)
    a, b = (above - 0.5) / 0.4, (below - 0.5) / 0.4
    print(f"\nfrom above {a.std():.4f}, from below {b.std():.4f}, their sum {(a + b).std():.5f}")
    assert a.std() > 0.05
    assert (a + b).std() < 0.01 * a.std()


@pytest.mark.parametrize("cover", [0.1, 0.4])
def test_foam_is_seen_from_below(choppy, cover):
    """As much of it as from above, lit by the share that goes through."""
    water = """mesh2 {
    vertex_vectors { 3, <-900, 0, -900>, <-900, 0, 900>, <1900, 0, 0> }
    face_indices { 1, <0, 1, 2> }
    material { Ocean_Clear_Texture_() interior { ior 1 } }
}"""
    above = sheet(choppy, 5.0, cover, water, 60, 150)  # the same places of the net
    below = sheet(choppy, -5.0, cover, water, 60, 150)
    ratio = below.mean() / above.mean()
    print(f"\nfoam {above.mean():.4f} from above, {below.mean():.4f} from below")
    assert above.mean() > 0.2 * cover and above.std() > 0.05
    assert ratio == pytest.approx(0.45, rel=0.02)
    bare = sheet(choppy, -5.0, 0, water, 60, 30)
    assert bare.max() < 1e-3


def test_snells_window_is_broken_by_ripples(choppy):
    """From 3 m down: the sky above a sharp horizon; steps between pixels along its edge."""

    def seen(more):
        return choppy.seen(
            f"""#declare Eye = <30, -3, 40>;
camera {{ location Eye right x*image_width/image_height angle 70 look_at Eye + <10, 9, 0> }}
Ocean_Eye_At(Eye, 70)
{more}
#declare Ocean_Foam_Amount = 0;
sky_sphere {{ pigment {{ rgb 1 }} }}
object {{ Ocean_Volume(<30, 0, 40>, 60, 20, 0.5) Ocean_Clear_Material("jerlov_i") }}""",
            settings="max_trace_level 4", width=120, height=90,
        )[..., 1]  # fmt: skip

    rippled, smooth = seen(""), seen("#declare Ocean_Detail_Bands_ = 0;")
    edges = [numpy.abs(numpy.diff(p, axis=1)).mean() for p in (rippled, smooth)]
    print(f"\nmean step between pixels {edges[0]:.4f}, without ripples {edges[1]:.4f}")
    assert smooth.max() > 0.5 and edges[0] > 1.5 * edges[1]


def test_shafts_of_light_follow_the_refracted_sun(choppy):
    """Between two depths what the waves gather moves by the way of the light in water, and on the
    average over the sea it is as much light as without waves."""
    told = choppy.told(
        """#declare Ocean_Sun_Direction = <cos(radians(40)), sin(radians(40)), 0>;
Ocean_Declare_Focus_()
#declare Way = cos(radians(40))/Ocean_Water_Ior;
#declare Way = Way/sqrt(1 - Way*Way);
#declare Random = seed(4);
#for (I, 0, 1499)
    #local X = 100*rand(Random);
    #local Z = 100*rand(Random);
    Tell(Ocean_Focus_(X, -4, Z)) Tell(Ocean_Focus_(X - Way, -5, Z))
    Tell(Ocean_Focus_(X + Way, -5, Z))
#end"""
    )
    upper, along, against = told.reshape(-1, 3).T
    follows = numpy.corrcoef(upper, along)[0, 1]
    other = numpy.corrcoef(upper, against)[0, 1]
    print(
        f"\nmean {upper.mean():.3f}, deviation {upper.std():.2f}, along {follows:.3f},"
        f" against {other:.3f}"
    )
    assert upper.mean() == pytest.approx(1.0, abs=0.1) and upper.std() > 0.05
    assert follows > 0.8 > 0.5 > other
