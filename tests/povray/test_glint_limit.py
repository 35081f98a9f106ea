# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The limit of the sun's glint: pictures that a user sees first are not white, and Ocean_Material
reports the share of the light that it shows."""

import re
from pathlib import Path

import numpy
import OpenImageIO as oiio
import pytest
from conftest import Folder

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "povray_macros" / "examples"
SCENES = {
    "scene": ROOT / "povray_macros" / "scene.pov",
    **{name: EXAMPLES / f"{name}.pov" for name in ("view", "tiles")},
}
WHITE = 254 / 255


@pytest.fixture(scope="module")
def fresh(tmp_path_factory):
    return Folder(tmp_path_factory.mktemp("fresh"), (EXAMPLES / "open.toml").read_text())


def picture(folder, name, declared=""):
    """Returns the light that a scene of the product shows with declarations after ocean.inc, and
    POV-Ray's log."""
    scene = SCENES[name].read_text().split('#include "ocean.inc"')[1]
    log = folder.run(declared + scene, "+FE", "+Oout.exr", width=112, height=63)
    image = oiio.ImageBuf(str(folder.path / "out.exr"))
    return image.get_pixels(oiio.FLOAT)[::-1, :, :3], log


def screen(light):
    """Returns the 8-bit values, 0 .. 1, of a picture."""
    shown = numpy.where(light < 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    return shown.clip(0, 1)


def clipped(shown):
    """Returns the shares of pixels that are white in all channels, and by their luminance."""
    luminance = shown @ numpy.array([0.2126, 0.7152, 0.0722])
    return float((shown.min(2) >= WHITE).mean()), float((luminance >= WHITE).mean())


def reported(log):
    """Returns the reported share of the light, or None where the log has no report."""
    found = re.search(r"the glint is limited to [\d.]+ of white: (\d+) % of its light", log)
    return found and int(found[1]) / 100


@pytest.mark.parametrize("name", SCENES)
def test_little_of_a_first_picture_is_white_and_the_reported_share_is_shown(fresh, name):
    """Less than three percent; the share within a factor of two: the report is of all directions,
    a picture of some."""
    limited, log = picture(fresh, name)
    whole, silent = picture(fresh, name, "#declare Ocean_Glint_Limit = 0;\n")
    none, _ = picture(fresh, name, "#declare Ocean_Glint_Limit = 1e-6;\n")
    shown = screen(limited)
    channels, luminance = clipped(shown)
    burnt, _ = clipped(screen(whole))
    print(f"\nwhite: {channels:.4f}, by luminance {luminance:.4f}; without the limit {burnt:.4f}")
    assert channels < 0.03 and luminance < 0.03
    assert burnt > 0.1
    # The glint is still the brightest of the water, not a grey film.
    water = shown[: int(0.5 * len(shown))]
    assert numpy.quantile(water.max(2), 0.98) > 0.8
    least = none.max(2).mean()
    share = (limited.max(2).mean() - least) / (whole.max(2).mean() - least)
    print(f"{share:.3f} of the light, reported {reported(log)}")
    assert reported(silent) is None
    assert 0.5 < reported(log) / share < 2


def test_a_faint_sun_is_not_limited(fresh):
    """Far below white nothing is lost, and nothing is reported but that."""
    log = fresh.run(
        """Ocean_Load("sea_0001")
Ocean_Eye_At(<0, 5, 0>, 60)
Ocean_Sun(24, 10)
#declare Ocean_Sun_Colour = 1e-5*Ocean_Sun_Colour;
sphere { 0, 1 Ocean_Material("jerlov_ii") }"""
    )
    assert reported(log) > 0.95
