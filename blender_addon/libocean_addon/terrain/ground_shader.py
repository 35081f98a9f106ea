# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The node group `Terrain Ground`: land for Cycles and Eevee, tuned by its sockets.

    attributes terrain_normal, terrain_height -> slope, height     \\
    object coordinates -> noise of four scales                     -> grass, forest, scree, rock,
    lines, slopes, colours                                         /  snow, sand -> Surface, Colour
    attributes beach, cliff, streambed, flow, wear: sand, rock, scree, forest and shades where the
    land has them; shore_wetness: dark sand and a film of water; an attribute that is absent reads
    0 and changes nothing

Each cover lies over those before it, with an edge that the noise moves up and down. Noise of a
single scale would make spots all of one size. Near the eye the covers have a relief of their own
(ground_relief.py), which breaks the edges.
"""

from __future__ import annotations

from ..look import air, crest_nodes, foam_nodes, water_shader
from ..shared import compat
from ..shared.shader_builder import Tree, facing, shader_group, stored_normal
from . import ground_relief
from .node_group import HEIGHT, NORMAL

GROUP = "Terrain Ground"
VERSION = 7
MARK = "libocean_ground"  # custom property of a group: the version that built it

ALBEDOS = {
    "Snow": (0.80, 0.83, 0.88),
    "Rock": (0.165, 0.150, 0.135),
    "Scree": (0.220, 0.195, 0.165),
    "Grass": (0.082, 0.092, 0.036),
    "Dry Grass": (0.19, 0.16, 0.075),
    "Forest": (0.028, 0.042, 0.018),
    "Sand": (0.42, 0.36, 0.26),
    "Wet Sand": water_shader.WET_SAND,
}
"""Linear albedos, chosen by eye against photographs of mountains; wet sand has half of dry sand."""

NOWHERE = 1e5
"""[m] A line so high that nothing lies above it."""

_NUMBERS = (
    ("Snow Line", NOWHERE, -1e5, 1e5, "Height above which snow lies on level ground [m]"),
    ("Forest Line", NOWHERE, -1e5, 1e5, "Height up to which forest grows [m]"),
    ("Dry Share", 0.0, 0.0, 1.0, "Share of dry grass far above the forest"),
    ("Sand Line", -NOWHERE, -1e5, 1e5, "Height up to which level ground is sand [m]"),
    ("Wet Line", -NOWHERE, -1e5, 1e5, "Height up to which waves wet the sand [m]"),
    (
        "Wet Width",
        0.4,
        0.001,
        1e5,
        "Height in which wet sand turns dry at the wet line, from 0.75 below to 1.25 above it [m]",
    ),
    ("Line Width", 140.0, 0.0, 1e5, "Half width of the edge at a line [m]"),
    ("Sun Melt", 220.0, 0.0, 1e5, "Rise of the snow line on a slope of 1 that faces the sun [m]"),
    (
        "Sun Bearing",
        -90.0,
        -360.0,
        360.0,
        "Direction of the sun at noon, in degrees counter-clockwise from +x",
    ),
    (
        "Hollow Snow",
        260.0,
        0.0,
        1e5,
        "How much higher snow begins on the crests of gullies, and lower on their floors, by the "
        "attribute wear [m]",
    ),
    ("Snow Slope", 0.75, 0.0, 10.0, "Slope at which snow begins to slide off, gone at 0.5 more"),
    ("Rock Slope", 0.62, 0.0, 10.0, "Slope at which rock begins, everywhere at 0.3 more"),
    ("Scree Slope", 0.50, 0.0, 10.0, "Slope at which scree begins, everywhere at 0.18 more"),
    ("Noise Size", 1100.0, 0.001, 1e6, "Largest of the four scales of the noise [m]"),
    ("Noise Amount", 1.0, 0.0, 10.0, "How much the noise moves edges and colours; 0: none"),
    ("Beach Sand", 1.0, 0.0, 1.0, "Share of sand on beaches, by the attribute beach"),
    ("Cliff Rock", 1.0, 0.0, 1.0, "Share of rock on cliffs, by the attribute cliff"),
    ("Stream Scree", 0.8, 0.0, 1.0, "Share of scree in streams, by the attribute streambed"),
    (
        "Flow Forest",
        0.6,
        0.0,
        1.0,
        "Share of forest where much water drains, by the attribute flow",
    ),
    ("Wear Shade", 0.35, 0.0, 1.0, "How much lighter crests and darker floors of gullies are"),
    (
        "Visibility",
        0.0,
        0.0,
        1e6,
        "Distance through the air at which 2 % of the contrast are left [m]; 0: no haze",
    ),
    ("Roughness", 0.5, 0.0, 1.0, "Of the ground, as Oren and Nayar have it: 0 is smooth and matt"),
    *ground_relief.NUMBERS,
)
_WATER_IOR = 1.33
_FILM_RELIEF = 0.25
"""The share of the ground's relief that the film of water on it has; chosen by eye."""
_SHADE = 0.35  # share of a colour that the finer noise takes or adds

# The scales of the noise, each as a share of the previous scale, and their weights.
_STEP = 0.23
_WEIGHTS = (0.40, 0.30, 0.18, 0.12)
_CONTRAST = 2.4  # Blender's noise has a deviation of about 0.13 around 0.5


def _declare(group) -> None:
    for row in _NUMBERS:
        compat.add_number(group, *row)
    for name, albedo in ALBEDOS.items():
        compat.add_socket(group, f"{name} Colour", "NodeSocketColor", default_value=(*albedo, 1.0))
    compat.add_socket(
        group,
        air.SOCKET,
        "NodeSocketColor",
        default_value=(0.0, 0.0, 0.0, 1.0),
        description="Of the sky at the horizon, behind the haze",
    )
    compat.add_socket(group, "Surface", "NodeSocketShader", output=True)
    compat.add_socket(group, "Colour", "NodeSocketColor", output=True)


def _noise(t: Tree, size, amount) -> list:
    """Returns the noise of all four scales, about -1 .. 1, and the noise of the two finer
    scales."""
    place = t.math("MULTIPLY", t.node("ShaderNodeTexCoord").outputs["Object"], (1.0, 1.0, 0.0))
    place = t.scale(place, t.number("DIVIDE", 1.0, size))
    total = fine = 0.0
    for number, weight in enumerate(_WEIGHTS):
        made = t.node("ShaderNodeTexNoise", noise_dimensions="2D")
        # Each scale begins elsewhere: at one origin their cells would meet.
        moved = t.math("ADD", place, (17.3 * (number + 1), 9.1 * (number + 1), 0.0))
        t.feed(moved, made.inputs["Vector"])
        made.inputs["Scale"].default_value = _STEP**-number
        made.inputs["Detail"].default_value = 1.0
        centred = t.number("SUBTRACT", made.outputs["Fac"], 0.5)
        term = t.number("MULTIPLY", centred, 2.0 * _CONTRAST * weight)
        total = t.number("ADD", term, total)
        if number >= 2:
            fine = t.number("ADD", term, fine)
    return [t.number("MULTIPLY", total, amount), t.number("MULTIPLY", fine, amount)]


def _sunward(t: Tree, slopes, bearing):
    """Returns the slope towards the sun: positive where the ground faces it. slopes: of the normal,
    (nx, ny) / nz; bearing: in degrees."""
    angle = t.number("RADIANS", bearing)
    sun = t.vector(t.number("COSINE", angle), t.number("SINE", angle), 0.0)
    return t.math("DOT_PRODUCT", slopes, sun, result="Value")


def _below(t: Tree, line, width, height):
    """Returns 1 below a line and 0 above it, across an edge of twice that width."""
    low, high = t.number("SUBTRACT", line, width), t.number("ADD", line, width)
    return t.number("SUBTRACT", 1.0, t.eased(low, high, height))


def _from(t: Tree, begins, width: float, slope, noise, share: float):
    """Returns 1 on slopes steeper than `begins` + width, and 0 on those below `begins`. share: by
    which the noise moves it."""
    moved = t.number("MULTIPLY_ADD", noise, share, slope)
    return t.eased(begins, t.number("ADD", begins, width), moved)


_COVERS = ("Sand", "Dry Grass", "Forest", "Scree", "Rock", "Snow")
_OF_COVERS = (
    "Snow Line",
    "Forest Line",
    "Dry Share",
    "Sand Line",
    "Line Width",
    "Sun Melt",
    "Sun Bearing",
    "Hollow Snow",
    "Snow Slope",
    "Rock Slope",
    "Scree Slope",
)
"""The inputs that decide where each cover lies."""


_OF_WEAR = {"Forest": -0.3, "Scree": -0.08, "Rock": 0.10}
"""A crest of gullies adds it to the noise that lets forest grow, and to the slopes that decide
scree and rock; their floors subtract it."""


def _covers(t: Tree, inputs, height, slopes, noise, wear, by_masks) -> list:
    """Returns the share of each cover over the covers before it, in the order of _COVERS. wear: 1
    on the crests of gullies, -1 on their floors. by_masks: shares that masks give to forest, scree,
    rock."""
    lush, gravel, cliff = by_masks
    slope = t.math("LENGTH", slopes, result="Value")
    width = inputs["Line Width"]
    rough = t.number("MULTIPLY_ADD", t.number("MULTIPLY", noise, 0.7), width, height)
    level = t.number("SUBTRACT", 1.0, t.eased(0.20, 0.35, slope))
    # Sand ends where waves end, not where land begins to rise.
    narrow = t.number("MULTIPLY", width, 0.02)
    rippled = t.number("MULTIPLY_ADD", t.number("MULTIPLY", noise, 0.7), narrow, height)
    sand = t.number("MULTIPLY", _below(t, inputs["Sand Line"], narrow, rippled), level)
    grows = t.number("SUBTRACT", 1.0, _from(t, 0.60, 0.35, slope, noise, 0.12))
    # Forest leaves clearings.
    open_ = t.number("MULTIPLY_ADD", wear, _OF_WEAR["Forest"], t.number("ADD", noise, 0.2))
    forest = t.number("MULTIPLY", grows, t.eased(-0.55, 0.15, open_))
    below = _below(t, inputs["Forest Line"], t.number("MULTIPLY", width, 0.64), rough)
    forest = t.number("MAXIMUM", t.number("MULTIPLY", forest, below), lush)
    of_scree = t.number("MULTIPLY_ADD", wear, _OF_WEAR["Scree"], slope)
    of_rock = t.number("MULTIPLY_ADD", wear, _OF_WEAR["Rock"], slope)
    scree = t.number(
        "MAXIMUM", _from(t, inputs["Scree Slope"], 0.18, of_scree, noise, 0.20), gravel
    )
    rock = t.number("MAXIMUM", _from(t, inputs["Rock Slope"], 0.30, of_rock, noise, 0.22), cliff)
    melt = t.number("MULTIPLY", inputs["Sun Melt"], _sunward(t, slopes, inputs["Sun Bearing"]))
    melt = t.number("MULTIPLY_ADD", wear, inputs["Hollow Snow"], melt)
    snow_line = t.number("ADD", inputs["Snow Line"], melt)
    snow = t.number("SUBTRACT", 1.0, _below(t, snow_line, width, rough))
    lies = t.number("SUBTRACT", 1.0, _from(t, inputs["Snow Slope"], 0.50, slope, noise, 0.15))
    lower = t.number("SUBTRACT", inputs["Forest Line"], t.number("MULTIPLY", width, 0.6))
    upper = t.number("MULTIPLY_ADD", width, 2.5, inputs["Forest Line"])
    dry = t.number("MULTIPLY", t.eased(lower, upper, rough), inputs["Dry Share"])
    return [sand, dry, forest, scree, rock, t.number("MULTIPLY", snow, lies)]


_FLOW_BEGINS, _FLOW_ENDS = 4.7, 6.3
"""Decimal logarithms of the drained areas [m^2] between which forest follows the water."""


def _mask(t: Tree, name: str, share=None):
    """Returns the value of a mask, times a share."""
    value = t.node("ShaderNodeAttribute", attribute_name=name).outputs["Fac"]
    return value if share is None else t.number("MULTIPLY", value, share)


def _by_masks(t: Tree, inputs) -> tuple:
    """Returns the shares that masks give to forest, scree and rock."""
    area = t.number("LOGARITHM", t.number("MAXIMUM", _mask(t, "flow"), 1.0), 10.0)
    lush = t.number("MULTIPLY", t.eased(_FLOW_BEGINS, _FLOW_ENDS, area), inputs["Flow Forest"])
    return (
        lush,
        _mask(t, "streambed", inputs["Stream Scree"]),
        _mask(t, "cliff", inputs["Cliff Rock"]),
    )


def _dry(t: Tree, height, line, width, wetness, noise) -> list:
    """Returns how dry sand is, 0 .. 1, with the numbers of shaders/preview/ground_light.glsl:
    ragged at the line up to which waves wet it, and dark where they have wetted it now."""
    above = t.number("DIVIDE", t.number("SUBTRACT", height, line), width)
    above = t.number("MULTIPLY_ADD", noise, 0.5, above)
    wet = t.number("MULTIPLY", wetness, t.number("MULTIPLY_ADD", noise, -2.0, -5.0))
    bright = t.number("EXPONENT", t.number("MINIMUM", wet, 0.0))
    return [t.number("MULTIPLY", t.eased(-0.75, 1.25, above), bright)]


def _build(group) -> None:
    _declare(group)
    t = Tree(group)
    inputs = t.node("NodeGroupInput").outputs
    normal = stored_normal(t, NORMAL, facing(t))
    nz = t.number("MAXIMUM", t.parts(normal)[2], 0.01)
    slopes = t.math("MULTIPLY", t.scale(normal, t.number("DIVIDE", 1.0, nz)), (1.0, 1.0, 0.0))
    height = t.node("ShaderNodeAttribute", attribute_name=HEIGHT).outputs["Fac"]
    noise, fine = t.nested("ground noise", _noise, inputs["Noise Size"], inputs["Noise Amount"])

    wear = _mask(t, "wear")

    def covers(t: Tree, height, slopes, noise, wear, lush, gravel, cliff, *sockets) -> list:
        named = dict(zip(_OF_COVERS, sockets, strict=True))
        return _covers(t, named, height, slopes, noise, wear, (lush, gravel, cliff))

    given = [inputs[name] for name in _OF_COVERS]
    by_masks = _by_masks(t, inputs)
    shares = t.nested("ground covers", covers, height, slopes, noise, wear, *by_masks, *given)
    # Sand is dark where waves have wetted it, by the first water most [Lobell and Asner 2002].
    wetness = _mask(t, "shore_wetness")
    dry = t.nested(
        "ground dry", _dry, height, inputs["Wet Line"], inputs["Wet Width"], wetness, noise
    )[0]
    sand = t.mix(inputs["Wet Sand Colour"], inputs["Sand Colour"], dry)
    grain = ground_relief.Grain(t, inputs, normal, noise)
    straw = grain.straw(t)
    colour = t.mix(inputs["Grass Colour"], inputs["Dry Grass Colour"], straw)
    *steepness, stones = ground_relief.STEEPNESS["Grass"]
    steepness = tuple(steepness)
    for name, share in zip(_COVERS, shares, strict=True):
        if name == "Snow":  # noise and wear shade the ground, not the snow on it
            beach = t.number("MULTIPLY_ADD", noise, 0.12, _mask(t, "beach"))
            beach = grain.broken(t, t.eased(0.3, 0.7, beach))
            beach = t.number("MULTIPLY", beach, inputs["Beach Sand"])
            colour = t.mix(colour, sand, beach)
            steepness = t.mix(steepness, ground_relief.STEEPNESS["Sand"][:3], beach)
            stones = foam_nodes.blend(t, stones, ground_relief.STEEPNESS["Sand"][3], beach)
            shade = t.number("MULTIPLY_ADD", fine, 2.0 * _SHADE, 1.0)
            shade = t.number("MULTIPLY_ADD", wear, inputs["Wear Shade"], shade)
            colour = t.scale(colour, t.number("MAXIMUM", shade, 0.2))
        cover = sand if name == "Sand" else inputs[f"{name} Colour"]
        broken = grain.broken(t, share)
        colour = t.mix(colour, cover, broken)
        steepness = t.mix(steepness, ground_relief.STEEPNESS[name][:3], broken)
        stones = foam_nodes.blend(t, stones, ground_relief.STEEPNESS[name][3], broken)
    level = normal
    colour, normal = grain.relief(t, colour, steepness, stones)
    ground = t.shader(
        "ShaderNodeBsdfDiffuse", Color=colour, Roughness=inputs["Roughness"], Normal=normal
    )
    # A film lies over the grains and fills the hollows between them.
    rough = t.scale(t.math("SUBTRACT", normal, level), _FILM_RELIEF)
    filmed = t.math("NORMALIZE", t.math("ADD", level, rough))
    film = t.shader(
        "ShaderNodeBsdfGlossy",
        Color=(1.0, 1.0, 1.0, 1.0),
        Roughness=water_shader.FILM_ROUGHNESS,
        Normal=filmed,
    )
    fresnel = t.node("ShaderNodeFresnel")
    fresnel.inputs["IOR"].default_value = _WATER_IOR
    t.feed(filmed, fresnel.inputs["Normal"])
    # It is left for some seconds after the water: damp sand has none.
    share = t.number("MULTIPLY", fresnel.outputs[0], t.eased(0.6, 0.95, wetness))
    ground = t.mix_shaders(share, ground, film)
    output = t.node("NodeGroupOutput")
    haze = t.shader("ShaderNodeEmission", Color=inputs[air.SOCKET])
    hazy = t.mix_shaders(crest_nodes.seen_haze(t, inputs), ground, haze)
    t.link(hazy, output.inputs["Surface"])
    t.link(colour, output.inputs["Colour"])
    t.arrange(rows=4)


def get_group():
    """Returns the node group, made if it is missing."""
    return shader_group(MARK, VERSION, GROUP, _build)


def is_ground(node) -> bool:
    return node.type == "GROUP" and node.node_tree is not None and MARK in node.node_tree
