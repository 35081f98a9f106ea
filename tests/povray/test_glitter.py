# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The sun's glitter of Ocean_Material, without its limit, against the density of slopes of
[Cox and Munk 1954]."""

import re
from math import erfc

import numpy
import pytest
from conftest import flat, floats_of, read_png, tell
from test_crest_and_haze import fresnel

FAINT = 0.002  # of the sun, so that what it makes of the water is within a PNG's range


def seen_of(rms, slope):
    """visible_area and visible_lean of shaders/wave/visible_slope.glsl."""
    a = slope / rms
    share = 0.5 * erfc(-a / numpy.sqrt(2))
    area = slope * share + rms * numpy.exp(-0.5 * a * a) / numpy.sqrt(2 * numpy.pi)
    return area, rms * rms * share / area


def slopes_of(folder):
    """Mean square slopes: of all waves, and of those that the finest map leaves out."""
    text = (folder.path / "ocean_parameters.inc").read_text()
    whole = float(re.search(r"Ocean_Mean_Square_Slope = (.*?);", text).group(1))
    return whole, float(re.search(r"Ocean_Lost_Slopes = array\[\d+\] { ([^,]*),", text).group(1))


def density(elevation, altitude, slopes, seen, azimuth=0.0):
    """Light of a sun of 1 on flat water, at an azimuth off the far end of the sight."""
    to_eye = numpy.array([-numpy.cos(elevation), numpy.sin(elevation), 0.0])
    flat = numpy.cos(altitude)
    to_sun = numpy.array(
        [flat * numpy.cos(azimuth), numpy.sin(altitude), flat * numpy.sin(azimuth)]
    )
    half = to_eye + to_sun
    cosine = half[1] / numpy.linalg.norm(half)
    facet = fresnel(0.5 * numpy.linalg.norm(half))
    return facet * numpy.exp(-(cosine**-2 - 1) / slopes) / (4 * slopes * seen * cosine**4)


def black_sea(altitude):
    """No light but a sun's at azimuth 0, which water alone mirrors, at labels that are places."""
    a = numpy.radians(altitude)
    return f"""global_settings {{ assumed_gamma 1.0 }}
Ocean_Load("sea_0001")
{flat()}#for (I, 0, dimension_size(Ocean_Water_Albedo, 1) - 1)
    #declare Ocean_Water_Albedo[I] = <0, 0, 0>;
#end
#declare Ocean_Sky_Light = 0;
#declare Ocean_Crest_Light = 0;
#declare Ocean_Glint_Limit = 0;
#declare Ocean_Sun_Altitude = {altitude};
#declare Ocean_Sun_Direction = <{numpy.cos(a):.12f}, {numpy.sin(a):.12f}, 0>;
#declare Ocean_Sun_Colour = <1, 1, 1>;
#declare Ocean_Sun_Shown_ = 1;
#declare Ocean_Sky_Around_ = array[11];
#for (I, 0, 10) #declare Ocean_Sky_Around_[I] = <0, 0, 0>; #end
light_source {{ 1e7*Ocean_Sun_Direction rgb {FAINT} parallel point_at 0 }}
"""


def flat_sheet(lean, share):
    """Water whose normals lean to -x, of whose slopes the mesh has lost a share."""
    return f"""
#declare N = vnormalize(<{-lean}, 1, 0>);
mesh2 {{
    vertex_vectors {{ 3, <-900, 0, -900>, <-900, 0, 900>, <2000, 0, 0> }}
    normal_vectors {{ 3, N + 1e-4*z, N - 1e-4*z, N }}
    uv_vectors {{ 3, <0, {share}>, <0, {share}>, <0, {share}> }}
    face_indices {{ 1, <0, 1, 2> }}
    Ocean_Material("jerlov_ii")
}}
"""


def glitter(folder, elevation, altitude, lean, share, near):
    """A flat black sea whose normals lean to the eye, seen at an elevation, degrees."""
    e = numpy.radians(elevation)
    folder.run(
        f"""{black_sea(altitude)}
#declare Ocean_Detail_Bands_ = 0;
#declare Ocean_Repeats_ = {1000 if near else 1e-3};
Ocean_Eye_At(<{-100 * numpy.cos(e)}, {100 * numpy.sin(e)}, 0>, 1)
#declare Ocean_Pixel_ = {1e-9 if near else 1};
camera {{ location Ocean_Eye_ right 1e-4*x up 1e-4*y look_at 0 }}
{flat_sheet(lean, share)}"""
    )
    return read_png(folder.path / "out.png").mean() / FAINT


def rippled_glitter(folder, elevation, altitude, pixel):
    """30 m of flat sea with ripples, as pixels of so many radians show it: what they hide of the
    slopes, 0 .. 1, the mean of the light, and its deviation over the mean."""
    e = numpy.radians(elevation)
    log = folder.run(
        f"""{black_sea(altitude)}
#declare Ocean_Repeats_ = 1000;
Ocean_Eye_At(<{-1000 * numpy.cos(e)}, {1000 * numpy.sin(e)}, 0>, 1)
#declare Ocean_Pixel_ = {pixel};
camera {{ location Ocean_Eye_ right 0.03*x up 0.03*y look_at 0 }}
{flat_sheet(0.0, 0.0)}
{tell("Ocean_Detail_Left_(0, 0, 0)")}""",
        *("+A0.01", "+AM1", "+R2"), width=36, height=36,
    )  # fmt: skip
    light = read_png(folder.path / "out.png").mean(2) / FAINT
    return floats_of(log)[0], light.mean(), light.std() / light.mean()


@pytest.mark.parametrize("elevation,altitude", [(20, 20), (8, 8), (5, 35), (12, 30)])
def test_near_glitter_is_fresnels_share_of_the_sun_over_what_is_seen(choppy, elevation, altitude):
    """At mirrors, and aside of them by three deviations of the slopes."""
    _, lost = slopes_of(choppy)
    e, a = numpy.radians([elevation, altitude])
    seen = glitter(choppy, elevation, altitude, 0.0, 0.0, True)
    expected = density(e, a, lost, seen_of(numpy.sqrt(lost / 2), numpy.tan(e))[0] * numpy.cos(e))
    print(f"\n{seen:.4f}, expected {expected:.4f}: {seen / expected:.3f}")
    assert seen == pytest.approx(expected, rel=0.20)


def test_what_ripples_show_and_what_they_hide_glitter_together(choppy):
    """On the way from ripples to none the mean goes straight from one to the other, and what is
    shown moves the glitter of what is hidden."""
    shown, some, most, hidden = (
        rippled_glitter(choppy, 12, 30, pixel) for pixel in (1e-9, 1e-4, 2e-4, 4e-4)
    )
    assert shown[0] < 0.05 and 0.5 < some[0] < 0.7 and 0.8 < most[0] < 0.95 and hidden[0] > 0.99
    for share, mean, contrast in (some, most):
        straight = shown[1] + share * (hidden[1] - shown[1])
        print(f"\n{share:.2f} hidden: {mean / straight:.3f} of the line, contrast {contrast:.3f}")
        assert mean == pytest.approx(straight, rel=0.20)
        assert contrast > 0.15


@pytest.mark.parametrize("altitude", [12.0, 20.0, 35.0, 50.0])
@pytest.mark.parametrize("elevation", [0.5, 3.0, 10.0])
def test_far_glitter_is_that_of_all_slopes(choppy, elevation, altitude):
    """For normals that are tilted to the eye by the visible slopes."""
    whole, _ = slopes_of(choppy)
    e, a = numpy.radians([elevation, altitude])
    area, lean = seen_of(numpy.sqrt(whole / 2), numpy.tan(e))
    lean = min(lean, 0.5 * numpy.tan(a))  # Ocean_View's own, see Ocean_Facing_Sun_
    seen = glitter(choppy, elevation, altitude, lean, 0.99999, False)
    expected = density(e, a, whole, area * numpy.cos(e))
    print(f"\n{seen:.4f}, expected {expected:.4f}: {seen / expected:.3f}")
    assert seen == pytest.approx(expected, rel=0.10)


@pytest.mark.parametrize("altitude", [2.0, 4.0, 10.0, 30.0])
def test_glitter_reaches_the_horizon(choppy, altitude):
    """The last degree of a view, beside the sun's column: what the formula says, which knows no
    shadows. Normals that lean to the eye alone would show none of a sun as low as 4 degrees."""
    whole, _ = slopes_of(choppy)
    picture = choppy.seen(
        f"""#declare Eye = <0, 12, 0>;
#declare Target = Eye + <100, -1, 0>;
camera {{ location Eye right x*image_width/image_height angle 4 look_at Target }}
Ocean_Eye_At(Eye, 4)
#declare Ocean_Sun_Altitude = {altitude};
#declare Ocean_Sun_Direction = <cos(radians({altitude})), sin(radians({altitude})), 0>;
#declare Ocean_Sun_Colour = <1, 1, 1>;
#declare Ocean_Sun_Shown_ = 1;
#declare Ocean_Sky_Light = 0;
#declare Ocean_Crest_Light = 0;
#declare Ocean_Glint_Limit = 0;
#declare Ocean_Foam_Amount = 0;
light_source {{ 1e7*Ocean_Sun_Direction rgb {FAINT} parallel point_at 0 }}
object {{ Ocean_View(Eye, Target, 4, 0.5) Ocean_Material("jerlov_ii") no_reflection }}""",
        settings="max_trace_level 3", width=40, height=80,
    )  # fmt: skip
    # Columns within a degree of the sun's: beside a sun of 4 degrees the light halves in one.
    light, wanted = [], []
    pixel = 2 * numpy.tan(numpy.radians(2)) / 40
    horizon = 40 + int(numpy.tan(numpy.radians(0.573)) / pixel)
    for row in range(horizon - 12, horizon - 3):
        e = numpy.arctan(0.01) - numpy.arctan((row + 0.5 - 40) * pixel)
        area, _ = seen_of(numpy.sqrt(whole / 2), numpy.tan(e))
        for column in range(10, 30):
            azimuth = numpy.arctan((column + 0.5 - 20) * pixel)
            light.append(picture[row, column].mean() / FAINT)
            wanted.append(density(e, numpy.radians(altitude), whole, area * numpy.cos(e), azimuth))
    ratio = numpy.mean(light) / numpy.mean(wanted)
    print(f"\n{numpy.mean(light):.3f}, expected {numpy.mean(wanted):.3f}: {ratio:.2f}")
    assert ratio == pytest.approx(1, rel=0.05)
