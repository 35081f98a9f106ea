# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The node group `Ocean Water`: sea water for Cycles and Eevee, tuned by its sockets.

    attributes cover, foam, trail, label, ocean_normal, slope_variance, jacobian, hull \\
    colour, roughness, IOR, absorption, sun, air ...                      -> Ocean Water
    Ocean Water -> Surface, Volume, Foam

Deep water has no volume: what its body sends back is a diffuse colour below a dielectric surface,
so that it works on an open mesh and costs nothing; its crests let the sun through. Transparent, it
is glass with absorption and scattering.
"""

from __future__ import annotations

import functools
import math

from ..sea import hull_nodes
from ..shared import compat
from ..shared.native import libocean
from ..shared.shader_builder import Tree, facing, shader_group, stored_normal
from . import crest_nodes, foam_nodes, pixel_angle

GROUP = "Ocean Water"
HULL_CUT = "Hull Cut"
VERSION = 8
MARK = "libocean_water"  # custom property of a group: the version that built it

WATER_TYPES = {entry["name"]: entry for entry in libocean.water_types()}
DEFAULT_TYPE = "jerlov_ii"

# The roughness of water between the waves of the mesh: 0.03 is a glint 0.1 degrees wide.
_ROUGHNESS = 0.03
_THIN_FOAM = (0.22, 0.29, 0.31)
_THICK_FOAM = (0.80, 0.80, 0.80)
_PLUME = (0.012, 0.060, 0.066)  # light that bubbles below the surface send back
WET_SAND = (0.21, 0.18, 0.13)
"""The linear albedo of wet sand, and of the bed: wet_sand_albedo of shaders/preview/sand.glsl."""
# The film at the end of a swash: as the ground has it that the water has left.
_FILM = 0.02  # m
FILM_ROUGHNESS = 0.12
"""The roughness of a film of water over grains of sand; chosen by eye."""
CUSP = "cusp"
"""The attribute of the height of the ground over the bed that `depth` counts from [m]."""


def clearness(kind: dict) -> tuple[float, ...]:
    """Returns the colour that light has after a metre down and up. kind: a row of WATER_TYPES."""
    lost = map(sum, zip(kind["absorption"], kind["scattering"], strict=True))
    return (*(math.exp(-2.0 * part) for part in lost), 1.0)


def _declare(group) -> None:
    """The sockets, which an artist may tune."""
    number = functools.partial(compat.add_number, group)

    def triple(name: str, kind: str, default, description: str) -> None:
        compat.add_socket(
            group, name, f"NodeSocket{kind}", default_value=default, description=description
        )

    kind = WATER_TYPES[DEFAULT_TYPE]
    triple(
        "Water Colour",
        "Color",
        (*kind["albedo"], 1.0),
        "What the body of deep water sends back of the light from above",
    )
    triple("Foam Colour", "Color", (*_THICK_FOAM, 1.0), "Of thick, fresh foam")
    triple("Thin Foam Colour", "Color", (*_THIN_FOAM, 1.0), "Of foam that lets water through")
    triple(
        "Bubble Colour",
        "Color",
        (*_PLUME, 1.0),
        "What bubbles that breakers drove down add to the water's colour",
    )
    triple(
        "Bed Colour",
        "Color",
        (*WET_SAND, 1.0),
        "Colour of the ground below shallow water, by the attribute depth",
    )
    triple(
        "Clearness",
        "Color",
        clearness(kind),
        "Light that comes back through a metre of water above a bed",
    )
    number("Foam Amount", 1.0, 0.0, 10.0, "How much of the attribute cover is shown; 0: none")
    number(
        "Foam Tile",
        foam_nodes.TILE,
        0.001,
        10000.0,
        "Metres of a tile of the net of foam; of 12 the widest cells are 0.86",
    )
    number("Foam Edge", 0.1, 0.001, 1.0, "From water to foam, as a share of the cover; 1: soft")
    number("Foam Stretch", 1.5, 0.1, 10.0, "Length over width of the cells, along the wind")
    number("Foam Streaks", 0.0, 0.0, 1.0, "How much windrows gather the foam, in a gale 0.3")
    number("Swash Line", 1.0, 0.0, 2.0, "How much foam marks the end of the water on a beach")
    number(
        "Wind Direction",
        0.0,
        -360.0,
        360.0,
        "To which the waves go, in degrees counter-clockwise from +x",
    )
    number(
        "Pixel Angle",
        pixel_angle.DEFAULT,
        0.0,
        1.0,
        "Of a pixel of the picture, in radians: where several cells of foam are in one, their mean "
        "is shown. 0: never",
    )
    number(
        "Roughness",
        _ROUGHNESS,
        0.0,
        1.0,
        "Of ripples that the mesh does not have; the attribute slope_variance adds to it",
    )
    number("IOR", kind["ior"], 1.0, 3.0, "Index of refraction")
    number(
        "Transparency",
        0.0,
        0.0,
        1.0,
        "0: deep water of the colour above; 1: clear, with what Volume does to light below",
    )
    triple(
        "Detail",
        "Vector",
        (0.0, 0.0, 0.0),
        "Slopes of waves too short for the mesh, along x and y, and their mean square, which the "
        "roughness then lacks",
    )
    triple("Absorption", "Vector", kind["absorption"], "Of red, green and blue light, per metre")
    triple("Scattering", "Vector", kind["scattering"], "Of red, green and blue light, per metre")
    number("Anisotropy", kind["anisotropy"], -1.0, 1.0, "Mean cosine of the angle of scattering")
    number("Crest Light", 1.0, 0.0, 10.0, "Of the sun through the crests; 0: none")
    triple("Crest Colour", "Color", (*kind["crest"], 1.0), "Of crests with the sun behind them")
    triple(
        "Sun Direction",
        "Vector",
        (0.0, 0.0, 0.0),
        "Towards the sun, in the world; 0: there is none",
    )
    triple(
        "Sun Light",
        "Color",
        (1.0, 1.0, 1.0, 1.0),
        "What a white surface that faces the sun sends back of its light",
    )
    number("Wave Height", 1.0, 0.001, 100.0, "Significant wave height of the sea, in metres")
    number(
        "Visibility",
        0.0,
        0.0,
        1e6,
        "Metres through the air at which 2 % of the contrast are left; 0: as far as one looks",
    )
    triple("Air Light", "Color", (0.0, 0.0, 0.0, 1.0), "Of the sky at the horizon, behind the haze")
    number(
        "Sun Focus",
        1.0,
        0.0,
        1000.0,
        "Times the light of lamps and the sky that goes through clear water: what waves gather",
    )
    number(HULL_CUT, 0.0, 0.0, 1.0, "1: the water inside hulls is not shown, by the attribute hull")
    compat.add_socket(group, "Surface", "NodeSocketShader", output=True)
    compat.add_socket(group, "Volume", "NodeSocketShader", output=True)
    compat.add_socket(group, "Foam", "NodeSocketFloat", output=True)


def _bent(t: Tree, normal, detail):
    """By slopes, of a normal upwards: normalize(n - max(n_z, 0) (s_x, s_y, 0))."""
    up = t.number("MAXIMUM", t.parts(normal)[2], 0.0)
    slopes = t.math("MULTIPLY", detail, (-1.0, -1.0, 0.0))
    return t.math("NORMALIZE", t.math("ADD", normal, t.scale(slopes, up)))


def _slopes(t: Tree, roughness, shown):
    """Mean square slope of all that is too short for the mesh: alpha^2 of Beckmann's distribution,
    whose slopes are Gaussian as the sea's are. Blender's roughness is the root of alpha.
    shown: what the normal has of it."""
    stored = t.node("ShaderNodeAttribute", attribute_name="slope_variance").outputs["Fac"]
    own = t.number("POWER", roughness, 4.0)
    return t.number("ADD", own, t.number("MAXIMUM", t.number("SUBTRACT", stored, shown), 0.0))


def _reflectance(t: Tree, ior, normal, slopes):
    """Fresnel's for smooth water; rough water reflects less at grazing angles, where only slopes
    towards the viewer are seen: the fit of Bruneton, Neyret and Holzschuch (2010),
    F = 0.02 + 0.98 (1 - cos)^(5 exp(-2.69 s)) / (1 + 22.7 s^1.5), s the slopes' deviation along the
    view, enters as its difference to that of smooth water."""
    fresnel = t.node("ShaderNodeFresnel")
    t.feed(ior, fresnel.inputs["IOR"])
    t.feed(normal, fresnel.inputs["Normal"])
    geometry = t.geometry
    cosine = t.math("DOT_PRODUCT", normal, geometry["Incoming"], result="Value")
    grazing = t.number("SUBTRACT", 1.0, cosine, clamp=True)
    deviation = t.number("SQRT", t.number("MULTIPLY", slopes, 0.5))
    exponent = t.number(
        "MULTIPLY", 5.0, t.number("EXPONENT", t.number("MULTIPLY", deviation, -2.69))
    )
    loss = t.number("MULTIPLY_ADD", t.number("POWER", deviation, 1.5), 22.7, 1.0)
    rough = t.number("DIVIDE", t.number("POWER", grazing, exponent), loss)
    change = t.number(
        "MULTIPLY", t.number("SUBTRACT", rough, t.number("POWER", grazing, 5.0)), 0.98
    )
    from_above = t.number("SUBTRACT", 1.0, geometry["Backfacing"])
    return t.number("ADD", fresnel.outputs[0], t.number("MULTIPLY", change, from_above), clamp=True)


def place(t: Tree):
    """Returns the place of foam and detail: the label, if the mesh carries one from the world, so
    that waves carry the foam along; otherwise the position."""
    stored = t.node("ShaderNodeAttribute", attribute_name="label").outputs["Vector"]
    # An attribute that is absent reads 0.
    there = t.number("GREATER_THAN", t.parts(stored)[2], 0.5)
    position = t.geometry["Position"]
    return t.mix(position, stored, there)


def footprint(t: Tree, pixel_angle):
    """Returns the side of the water that a pixel sees [m]."""
    distance = t.node("ShaderNodeCameraData").outputs["View Distance"]
    incoming = t.geometry["Incoming"]
    return foam_nodes.footprint(t, distance, pixel_angle, t.parts(incoming)[2])


_OF_FOAM = (
    "Foam Amount",
    "Pixel Angle",
    "Foam Tile",
    "Foam Stretch",
    "Foam Streaks",
    "Foam Edge",
    "Wind Direction",
    "Swash Line",
    "Wave Height",
)
"""The inputs that decide foam."""


def _trail(t: Tree):
    """Returns the share of the water that the trails of hulls hide; 0 without them."""
    return t.node("ShaderNodeAttribute", attribute_name="trail").outputs["Fac"]


def _inside_hull(t: Tree):
    """Returns 1 inside a hull, else 0."""
    stored = t.node("ShaderNodeAttribute", attribute_name=hull_nodes.HULL).outputs["Vector"]
    number, to_end, to_side = hull_nodes.beside(t, stored)
    deepest = t.number("MINIMUM", t.number("MINIMUM", to_end, to_side), number)
    return t.number("GREATER_THAN", deepest, 0.0)


def _foam(t: Tree, inputs, depth, there) -> foam_nodes.Foam:
    """Returns the foam on the water and in the trails of hulls: none where the attributes are 0,
    full cover where one is 1. Bubbles gather where foam has been for long. depth, there: as of
    _depth()."""

    def make(t: Tree, depth, there, *sockets) -> list:
        inputs, hidden = dict(zip(_OF_FOAM, sockets, strict=True)), _trail(t)

        def stored(name: str):
            found = t.node("ShaderNodeAttribute", attribute_name=name).outputs["Fac"]
            return t.number("MAXIMUM", found, hidden)

        line = foam_nodes.foam_swash(t, depth, there, inputs["Wave Height"])
        line = t.number("MULTIPLY", line, inputs["Swash Line"])
        cover = t.number("MAXIMUM", stored("cover"), line)
        cover = t.number("MULTIPLY", cover, foam_nodes.foam_tip(t, depth, there))
        cover = t.number("MULTIPLY", cover, inputs["Foam Amount"], clamp=True)
        driven = t.number("POWER", stored("foam"), 3.0)
        driven = t.number("MULTIPLY", driven, t.number("MINIMUM", inputs["Foam Amount"], 1.0))
        side = footprint(t, inputs["Pixel Angle"])
        foam = foam_nodes.foam(t, cover, driven, place(t), side, inputs)
        return [foam.mask, foam.thickness, foam.height, foam.bubbles]

    return foam_nodes.Foam(
        *t.nested("foam", make, depth, there, *(inputs[name] for name in _OF_FOAM))
    )


def _froth(t: Tree, inputs, foam: foam_nodes.Foam, normal):
    """Bubbles absorb no light: light that thick foam does not send back goes through, to all sides,
    where a medium lies below."""
    bump = t.node("ShaderNodeBump")
    t.feed(foam.height, bump.inputs["Height"])
    bump.inputs["Distance"].default_value = 1.0
    t.feed(normal, bump.inputs["Normal"])
    colour = t.mix(inputs["Thin Foam Colour"], inputs["Foam Colour"], foam.thickness)
    back = t.shader("ShaderNodeBsdfDiffuse", Color=colour, Normal=bump.outputs[0])
    through = t.scale(t.math("SUBTRACT", (1.0, 1.0, 1.0), colour), inputs["Transparency"])
    through = t.shader("ShaderNodeBsdfTranslucent", Color=through, Normal=bump.outputs[0])
    return t.add_shaders(back, through)


def _crest(t: Tree, inputs, normal):
    """Light of the sun that comes through crests."""
    share = crest_nodes.seen_crest_light(t, inputs, normal)
    return t.shader(
        "ShaderNodeEmission",
        Color=t.math("MULTIPLY", inputs["Crest Colour"], inputs["Sun Light"]),
        Strength=t.number("MULTIPLY", share, inputs["Crest Light"]),
    )


def _volume(t: Tree, inputs):
    """Absorption and scattering per metre and channel; Blender's nodes want a colour and the
    density of its strongest channel."""

    def strongest(coefficients):
        x, y, z = t.parts(coefficients)
        most = t.number("MAXIMUM", t.number("MAXIMUM", x, y), z)
        return t.number("MAXIMUM", most, 1e-6)

    absorbed, scattered = inputs["Absorption"], inputs["Scattering"]
    most = strongest(absorbed)
    passed = t.math("SUBTRACT", (1.0, 1.0, 1.0), t.scale(absorbed, t.number("DIVIDE", 1.0, most)))
    absorption = t.shader("ShaderNodeVolumeAbsorption", Color=passed, Density=most)
    most = strongest(scattered)
    scattering = t.shader(
        "ShaderNodeVolumeScatter",
        Color=t.scale(scattered, t.number("DIVIDE", 1.0, most)),
        Density=most,
        Anisotropy=inputs["Anisotropy"],
    )
    return t.add_shaders(absorption, scattering)


def _depth(t: Tree):
    """Returns the depth of the water over the ground [m], 0 where the ground is higher, and 1 where
    it is known: an attribute that is absent reads 0."""
    depth, cusp = (
        t.node("ShaderNodeAttribute", attribute_name=name).outputs["Fac"]
        for name in ("depth", CUSP)
    )
    there = t.number("GREATER_THAN", t.number("ABSOLUTE", depth), 1e-7)
    return t.number("MAXIMUM", t.number("SUBTRACT", depth, cusp), 0.0), there


def _over_bed(t: Tree, inputs, below, depth, there):
    """Returns the colour below the surface with that of the bed through the water over it. depth,
    there: as of _depth()."""
    depth = t.number("MULTIPLY_ADD", t.number("SUBTRACT", 1.0, there), 1e4, depth)
    left = t.node("ShaderNodeGamma")
    t.feed(inputs["Clearness"], left.inputs["Color"])
    t.feed(depth, left.inputs["Gamma"])
    seen = t.math("SUBTRACT", inputs["Bed Colour"], below)
    return t.math("MULTIPLY_ADD", seen, left.outputs[0], below)


def _build(group) -> None:
    _declare(group)
    t = Tree(group)
    inputs = t.node("NodeGroupInput").outputs
    side = facing(t)
    of_waves = stored_normal(t, "ocean_normal", side)
    # One surface, bent alike from both sides; shaders want its normal towards the viewer.
    normal = t.scale(_bent(t, of_waves, inputs["Detail"]), side)
    slopes = _slopes(t, inputs["Roughness"], t.parts(inputs["Detail"])[2])
    depth, there = _depth(t)
    # Where the water thins to a film, it is as rough as the film on the ground beside it.
    film = t.number("SUBTRACT", there, t.number("MULTIPLY", there, t.eased(0.0, _FILM, depth)))
    slopes = t.number("MULTIPLY_ADD", film, FILM_ROUGHNESS**4, slopes)
    roughness = t.number("POWER", slopes, 0.25)
    reflectance = _reflectance(t, inputs["IOR"], normal, slopes)

    foam = _foam(t, inputs, depth, there)
    below = t.math("ADD", inputs["Water Colour"], t.scale(inputs["Bubble Colour"], foam.bubbles))
    below = _over_bed(t, inputs, below, depth, there)
    body = t.shader("ShaderNodeBsdfDiffuse", Color=below, Normal=normal)
    body = t.add_shaders(body, _crest(t, inputs, of_waves))
    mirror = t.shader(
        compat.GLOSSY,
        settings={"distribution": "BECKMANN"},
        Color=(1.0, 1.0, 1.0, 1.0),
        Roughness=roughness,
        Normal=normal,
    )
    deep = t.mix_shaders(reflectance, body, mirror)
    clear = t.shader(
        "ShaderNodeBsdfGlass",
        settings={"distribution": "BECKMANN"},
        Color=(1.0, 1.0, 1.0, 1.0),
        Roughness=roughness,
        IOR=inputs["IOR"],
        Normal=normal,
    )
    # Glass would keep lamps and the sun from all that is below: their light passes straight on.
    passed = t.number("SUBTRACT", 1.0, reflectance)
    passed = t.number("MULTIPLY", passed, inputs["Sun Focus"])
    unbent = t.shader("ShaderNodeBsdfTransparent", Color=passed)
    clear = t.mix_shaders(t.node("ShaderNodeLightPath").outputs["Is Shadow Ray"], clear, unbent)
    water = t.mix_shaders(inputs["Transparency"], deep, clear)
    froth = _froth(t, inputs, foam, normal)

    sea = t.mix_shaders(foam.mask, water, froth)
    air = t.shader("ShaderNodeEmission", Color=inputs["Air Light"])

    output = t.node("NodeGroupOutput")
    sea = t.mix_shaders(crest_nodes.seen_haze(t, inputs), sea, air)
    nothing = t.shader("ShaderNodeBsdfTransparent", Color=(1.0, 1.0, 1.0, 1.0))
    cut = t.number("MULTIPLY", inputs[HULL_CUT], _inside_hull(t))
    t.feed(t.mix_shaders(cut, sea, nothing), output.inputs["Surface"])
    t.feed(_volume(t, inputs), output.inputs["Volume"])
    t.feed(foam.mask, output.inputs["Foam"])
    t.arrange(rows=5)


def is_water(node) -> bool:
    """Returns whether a node of a material is one of these groups, of any version."""
    return node.type == "GROUP" and node.node_tree is not None and MARK in node.node_tree


def waters(tree) -> list:
    """The nodes of a material's tree that are; it may be changed while they are gone through."""
    return [node for node in tree.nodes if is_water(node)]


def get_group():
    """The node group: made when there is none."""
    return shader_group(MARK, VERSION, GROUP, _build)
