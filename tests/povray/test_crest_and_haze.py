# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Light of crests with the sun behind them, and haze: what Ocean_Material shows against the
formulas of shaders/wave/crest_light.glsl and haze.glsl."""

import numpy
import pytest
from conftest import PERIOD, flat, floats_of, read_png, surface, tell

COLOUR = numpy.array([0.9, 0.7, 0.4])


def crest_light(height, jacobian, against, toward):
    """crest_light.glsl."""
    high = numpy.clip(height - 0.1, 0, 1)
    squeezed = numpy.clip(1.4 - jacobian, 0, 1)
    away = numpy.clip(0.15 - toward, 0, 1)
    return high * squeezed * numpy.maximum(against, 0) ** 2 * away**0.7


def fresnel(cosine, ior=1.34):
    g = numpy.sqrt(ior**2 - 1 + cosine**2)
    a, b = (g - cosine) / (g + cosine), cosine * (g + cosine) - 1
    return 0.5 * a**2 * (1 + (b / (cosine * (g - cosine) + 1)) ** 2)


def sun(altitude, bearing=0.0):
    """A sun of a colour, which lights nothing itself; what it is, as a vector, x, y, z."""
    a, b = numpy.radians([altitude, bearing])
    way = numpy.array([numpy.cos(a) * numpy.cos(b), numpy.sin(a), numpy.cos(a) * numpy.sin(b)])
    return (
        way,
        f"""#declare Ocean_Sun_Altitude = {altitude};
#declare Ocean_Sun_Direction = <{way[0]:.12f}, {way[1]:.12f}, {way[2]:.12f}>;
#declare Ocean_Sun_Colour = <{COLOUR[0]}, {COLOUR[1]}, {COLOUR[2]}>;
#declare Ocean_Sun_Shown_ = 1;
""",
    )


def crest_of_a_plane(folder, altitude, tilt, height, squeeze, near=True):
    """Returns the rendered and the expected colour of a plane at a height over still water, whose
    normal is tilted towards the sun [degrees] and which is squeezed along x by a share."""
    eye, at = numpy.array([-20.0, 6.0, 4.0]), numpy.array([5.0, height, -2.0])
    way, declared = sun(altitude)
    across, up = numpy.sin(numpy.radians(tilt)), numpy.cos(numpy.radians(tilt))
    log = folder.run(
        f"""global_settings {{ assumed_gamma 1.0 }}
Ocean_Load("sea_0001")
{flat(dx=f"{-squeeze}*x")}
#declare Ocean_Hs = 2;
#declare Ocean_Sky_Light = 0;
#declare Ocean_Repeats_ = {1000 if near else 1e-3};
#declare Ocean_Crest_Light = 2;
#declare Ocean_Detail_Bands_ = 0;
{declared}
Ocean_Eye_At(<{eye[0]}, {eye[1]}, {eye[2]}>, 1)
#declare Ocean_Pixel_ = {1e-9 if near else 1};
#declare P = <{at[0]}, {at[1]}, {at[2]}>;
camera {{ location Ocean_Eye_ right 0.002*x up 0.002*y look_at P }}
#declare A = <{up:.12f}, {-across:.12f}, 0>;
#declare N = <{across:.12f}, {up:.12f}, 0>;
mesh2 {{
    vertex_vectors {{ 3, P - 9*A - 9*z, P - 9*A + 9*z, P + 20*A }}
    // POV-Ray makes a triangle of one normal flat, and leans it by what its corners lean.
    normal_vectors {{ 3, N + 1e-4*z, N - 1e-4*z, N }}
    uv_vectors {{ 3, <0, 0>, <0, 0>, <0, 0> }}
    face_indices {{ 1, <0, 1, 2> }}
    Ocean_Material("jerlov_ii")
}}
#declare C = Ocean_Water_Crest[Ocean_Water_Type_("jerlov_ii")];
"""
        + tell("C.x", "C.y", "C.z", "Ocean_Water_Ior")
    )
    *water, ior = floats_of(log)
    sight = (at - eye) / numpy.linalg.norm(at - eye)
    normal = numpy.array([across, up, 0.0])
    if not near:
        squeeze = 0.0
    level = way * [1, 0, 1]
    light = crest_light(height / 2, 1 - squeeze, sight @ level, normal @ level)
    light *= 1 - fresnel(-sight @ normal, ior)
    return read_png(folder.path / "out.png").mean((0, 1)), 2 * light * COLOUR * numpy.array(water)


@pytest.mark.parametrize("near", [True, False])
@pytest.mark.parametrize(
    "altitude,tilt,height,squeeze",
    [
        (10, -10, 1.8, 0.3),
        (10, -3, 1.8, 0.3),
        (10, 3, 2.4, 0.1),
        (35, -12, 1.2, 0.5),
        (35, 4, 1.2, -0.3),
        (60, -8, 2.4, 0.7),
    ],
)
def test_a_crest_is_as_bright_as_the_formula_says(choppy, altitude, tilt, height, squeeze, near):
    """And less by what its surface mirrors."""
    seen, expected = crest_of_a_plane(choppy, altitude, tilt, height, squeeze, near)
    print(f"\n{seen}, expected {expected}: {seen / expected}")
    assert expected.max() > 0.001
    # The picture has 16 bits, and the colour map of air is interpolated.
    assert seen == pytest.approx(expected, rel=0.02, abs=2e-5)


@pytest.mark.parametrize(
    "altitude,tilt,height,squeeze",
    [(10, 9, 1.8, 0.3), (10, -10, 0.15, 0.3), (170, -10, 1.8, 0.3), (10, -10, 1.8, -0.5)],
    ids=["faces the sun", "low", "the sun behind", "drawn apart"],
)
def test_other_water_has_no_such_light(choppy, altitude, tilt, height, squeeze):
    seen, expected = crest_of_a_plane(choppy, altitude, tilt, height, squeeze)
    assert expected.max() == 0 and seen.max() < 2e-5


def test_what_squeezes_a_crest_is_the_jacobian_of_the_sea(choppy):
    """At labels: differences between samples against the exact one; and as seen at places."""
    sea = surface(choppy)
    j, i = numpy.random.default_rng(3).integers(0, sea.height.shape[0], (2, 300))
    cell = PERIOD / sea.height.shape[0]
    calls = "".join(
        f"""#declare P = Ocean_Point({a * cell:.9f}, {b * cell:.9f});
Tell(Ocean_Squeezed_({a * cell:.9f}, {b * cell:.9f}))
Tell(Ocean_Squeezed_3_(P.x, P.z, P.x - Ocean_DX(P.x, P.z), P.z - Ocean_DZ(P.x, P.z)))
Tell(Ocean_Squeezed_(P.x, P.z))
"""
        for a, b in zip(i, j, strict=True)
    )
    declared = "Ocean_Eye_At(<0, 9, 0>, 60)\n" + sun(20)[1] + "Ocean_Foam_Settings_()\n"
    declared += "Ocean_Declare_Nearness_()\nOcean_Declare_Crest_()\n"
    at_label, at_place, unmoved = choppy.told(declared + calls).reshape(-1, 3).T
    exact = 1.4 - sea.jacobian[j, i]
    alike = numpy.corrcoef(at_label, exact)[0, 1]
    off = (at_label - exact).std() / exact.std()
    found = (at_place - at_label).std() / exact.std()
    without = (unmoved - at_label).std() / exact.std()
    print(
        f"\ncorrelation {alike:.3f}, off by {off:.3f} of its deviation, at places {found:.3f}",
        f"and without steps to the label {without:.3f}",
    )
    assert exact.std() > 0.05
    assert alike > 0.96 and off < 0.26
    assert found < 0.3 * without


def picture(folder, declared, size=(96, 54), angle=60, down=2.0):
    return folder.seen(
        f"""#declare Eye = <0, 3, 0>;
#declare Target = Eye + <10, -{down}, 0>;
camera {{ location Eye right x*image_width/image_height angle {angle} look_at Target }}
Ocean_Eye_At(Eye, {angle})
Ocean_Sun(20, 0)
Ocean_Sky(0)
{declared}
object {{ Ocean_View(Eye, Target, {angle}, 0.5) Ocean_Material("jerlov_ii") no_reflection }}""",
        settings="max_trace_level 4", width=size[0], height=size[1],
    )  # fmt: skip


def test_without_light_of_crests_nothing_changes(choppy):
    """Its layers take nothing from the water; and there is some of it at all."""
    none = picture(choppy, "#declare Ocean_Crest_Light = 0;")
    hidden = picture(choppy, "#declare Ocean_Crest_Light = 1e-9;")
    shown = picture(choppy, "#declare Ocean_Crest_Light = 1;")
    usual = picture(choppy, "")
    assert numpy.array_equal(usual, shown)
    # A thousandth is what its layer hides; 0.4 % POV-Ray's least share of a texture.
    assert numpy.abs(hidden - none).max() < 0.006 * none.max()
    assert numpy.abs(hidden - none).mean() < 0.002 * none.mean()
    bright = picture(choppy, "#declare Ocean_Crest_Light = 4;")
    more, most = shown - none, bright - none
    print(f"\nlight of crests: {most.max((0, 1))}; {most.sum() / more.sum():.3f} times as much")
    assert most[..., 1].max() > 0.008 and most.sum() == pytest.approx(4 * more.sum(), rel=0.05)


VISIBILITY = 9000.0
SKY = numpy.array([0.5, 0.6, 0.7])


DISTANCES = (900.0, 4500.0, 9000.0)


def hazed_plates(folder, bearing, sky):
    """Returns what an eye sees at a bearing: a plate of light 0.25 at the middle distance without
    haze, plates at all distances in haze, the sky at the horizon."""
    b = numpy.radians(bearing)
    ahead, right = numpy.array(
        [[numpy.cos(b), 1e-4, numpy.sin(b)], [-numpy.sin(b), 0, numpy.cos(b)]]
    )
    plates = ""
    for column, distance in enumerate((DISTANCES[1], *DISTANCES)):
        if column == 1:
            plates += f"#declare Ocean_Visibility = {VISIBILITY};\n"
        x, y, z = distance * (ahead + 1e-3 * (column - 2) * right)
        plates += f"""disc {{ 0, -x, {distance / 4e3} rotate {-bearing}*y
    translate Ocean_Eye_ + <{x}, {y}, {z}> Ocean_Hazed(Painted) }}
"""
    folder.run(
        f"""global_settings {{ assumed_gamma 1.0 }}
Ocean_Eye_At(<30, 12, -20>, 1)
Ocean_Sun(20, 0)
{sky}
#declare Painted = texture {{ pigment {{ rgb 0.25 }} finish {{ ambient 0 diffuse 0 emission 1 }} }}
camera {{ location Ocean_Eye_ right 5e-3*<{right[0]}, 0, {right[2]}> up 1e-5*y
         direction <{ahead[0]}, {ahead[1]}, {ahead[2]}> }}
{plates}""",
        width=5,
        height=2,
    )
    return read_png(folder.path / "out.png").mean(0)


@pytest.mark.parametrize("bearing", [12.0, 100.0, 180.0])
@pytest.mark.parametrize(
    "sky", ["Ocean_Sky(0.3)", f"#declare Ocean_Air_Light = <{SKY[0]}, {SKY[1]}, {SKY[2]}>;"]
)
def test_things_are_hidden_by_as_much_air_as_visibility_says(choppy, bearing, sky):
    """At three distances; at the visibility 2 % of the contrast are left. The air is as bright as
    the sky where it meets the sea."""
    clear, *hazed, horizon = hazed_plates(choppy, bearing, sky)
    air = horizon if "Sky" in sky else SKY
    assert clear == pytest.approx(0.25, abs=1e-4)
    for distance, seen in zip(DISTANCES, hazed, strict=True):
        share = 1 - 0.02 ** (distance / VISIBILITY)
        expected = 0.25 * (1 - share) + air * share
        print(f"\n{distance}: {seen}, expected {expected}")
        assert seen == pytest.approx(expected, rel=0.005)


def test_the_sea_fades_into_the_sky_in_haze(choppy):
    """A flat black sea, whose material is hazed as things are; and the horizon of a real one."""
    way, declared = sun(20)
    for distance in (500.0, 2500.0):
        shown = choppy.seen(
            f"""{declared}
#declare Ocean_Sky_Light = 0;
#declare Ocean_Air_Light = <{SKY[0]}, {SKY[1]}, {SKY[2]}>;
#declare Ocean_Visibility = {VISIBILITY};
Ocean_Eye_At(<0, 50, 0>, 1)
camera {{ location Ocean_Eye_ right 1e-4*x up 1e-4*y look_at <{distance}, 0, 0> }}
mesh2 {{
    vertex_vectors {{ 3, <-9, 0, -9e3>, <-9, 0, 9e3>, <2e4, 0, 0> }}
    uv_vectors {{ 3, <0, 0.99>, <0, 0.99>, <0, 0.99> }}
    face_indices {{ 1, <0, 1, 2> }}
    Ocean_Material("jerlov_ii")
}}"""
        )
        share = 1 - 0.02 ** (numpy.hypot(distance, 50) / VISIBILITY)
        seen = shown.mean((0, 1))
        print(f"\n{distance}: {seen}, expected {SKY * share}")
        assert seen == pytest.approx(SKY * share, rel=0.01)
    hazy = picture(choppy, "#declare Ocean_Visibility = 300;", (80, 160), 0.5, 0.01)
    clear = picture(choppy, "", (80, 160), 0.5, 0.01)
    edges = [numpy.abs(numpy.diff(rows.mean((1, 2)))) for rows in (hazy, clear)]
    horizon = int(numpy.argmax(edges[1]))
    left = edges[0][horizon - 2 : horizon + 3].max()
    print(f"\nedge of the horizon {left:.5f}, without haze {edges[1][horizon]:.4f}")
    assert horizon == 79 and edges[1][horizon] > 0.03 and left < 0.02 * edges[1][horizon]
