# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean bake --products caustics`: a map of light, with a header that makes it again."""


def test_caustics_are_a_product_beside_others(ocean):
    names = ocean.bake("-o o/s.####.exr --products displacement,caustics")
    assert names == ["o/s.displacement.0001.exr", "o/s.caustics.0001.exr"]
    spec, pixels = ocean.image("o/s.caustics.0001.exr")
    assert spec.channelnames == ("Y",) and str(spec.format) == "half"
    assert spec.getattribute("ocean:field") == "caustics"
    assert spec.getattribute("ocean:unit") == "1" and spec.getattribute("wrapmodes") == "periodic"
    assert spec.getattribute("ocean:caustics_depth") == "10"
    assert spec.getattribute("ocean:sun") == "90,0"
    assert abs(pixels.mean() - 1) < 1e-3 and pixels.std() > 0.03 and pixels.min() >= 0
    assert ocean.image(names[0])[0].getattribute("ocean:sun") is None
    ocean.bake("-o alone.exr --products caustics")
    assert ocean.bytes_of("alone.exr") == ocean.bytes_of(names[1])
    ocean.bake("-o l.exr --products displacement,caustics --layout layered")
    spec, layers = ocean.image("l.exr")
    assert "caustics.V" in spec.channelnames
    assert (layers[..., spec.channelnames.index("caustics.V")] == pixels[..., 0]).all()


def test_caustics_fall_on_the_floor_of_shallow_water(ocean):
    for depth, shown in (("3.5", "3.5"), ("40", "10"), ("inf", "10")):
        ocean.bake("-o", f"{depth}.exr", "--products", "caustics", "--set", f"depth={depth}")
        assert ocean.image(f"{depth}.exr")[0].getattribute("ocean:caustics_depth") == shown
    ocean.bake("-o s.exr --products caustics --caustics-depth 25")
    assert ocean.image("s.exr")[0].getattribute("ocean:caustics_depth") == "25"


def test_options_win_over_the_header(ocean):
    ocean.bake("-o a.exr --products caustics --caustics-depth 4.5 --sun 40,200")
    assert ocean.image("a.exr")[0].getattribute("ocean:sun") == "40,200"
    ocean.good("bake --from a.exr -o other.exr --sun 41,200")
    spec = ocean.image("other.exr")[0]
    assert spec.getattribute("ocean:sun") == "41,200"
    assert spec.getattribute("ocean:caustics_depth") == "4.5"
    # Another product gets none of the strings of caustics.
    ocean.good("bake --from a.exr -o h.exr --products height")
    assert ocean.image("h.exr")[0].getattribute("ocean:sun") is None
