# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The node group `Ocean Water`: sea water for Cycles and Eevee, tuned by its sockets.

    attributes cover, ocean_normal, slope_variance \\
    colour, roughness, IOR, absorption ...          -> Ocean Water -> Surface, Volume

Deep water has no volume: what its body sends back is a diffuse colour below a dielectric surface,
so that it works on an open mesh and costs nothing. Transparent, it is glass with absorption and
scattering.
"""

from __future__ import annotations

import bpy

from . import compat
from .native import libocean
from .node_builder import Builder

GROUP = "Ocean Water"
VERSION = 2
MARK = "libocean_water"  # custom property of a group: the version that built it

WATER_TYPES = {entry["name"]: entry for entry in libocean.water_types()}
DEFAULT_TYPE = "jerlov_ii"

# Of water between the waves of the mesh: 0.03 is a glint 0.1 degrees wide.
_ROUGHNESS = 0.03
# Share of the attribute's range in which a flake of foam fades in.
_FLAKE_EDGE = 0.4
_NOISE = {"Detail": 8.0, "Roughness": 0.85}
_NOISE_DEVIATION = 0.0446  # of this noise, measured in 3.4 and 5.2; its mean is 0.5


class Tree(Builder):
    """Words for shaders beside those that all nodes share."""

    def shader(self, kind: str, *, settings: dict | None = None, **inputs):
        made = self.node(kind, **(settings or {}))
        for name, value in inputs.items():
            self.feed(value, made.inputs[name])
        return made.outputs[0]

    def mix_shaders(self, factor, off, on):
        made = self.node("ShaderNodeMixShader")
        for socket, value in zip(made.inputs, (factor, off, on), strict=True):
            self.feed(value, socket)
        return made.outputs[0]


def _declare(group) -> None:
    """The sockets: what an artist may tune."""

    def number(name: str, default: float, low: float, high: float, description: str) -> None:
        compat.add_socket(
            group,
            name,
            "NodeSocketFloat",
            default_value=default,
            min_value=low,
            max_value=high,
            description=description,
        )

    def triple(name: str, kind: str, default, description: str) -> None:
        compat.add_socket(
            group, name, f"NodeSocket{kind}", default_value=default, description=description
        )

    kind = WATER_TYPES[DEFAULT_TYPE]
    grey = (kind["foam_albedo"],) * 3
    triple(
        "Water Colour",
        "Color",
        (*kind["albedo"], 1.0),
        "What the body of deep water sends back of the light from above",
    )
    triple("Foam Colour", "Color", (*grey, 1.0), "Of thick, fresh foam")
    number("Foam Amount", 1.0, 0.0, 10.0, "How much of the attribute cover is shown; 0: none")
    number(
        "Foam Scale", 1.0, 0.001, 1000.0, "Size of the flakes that foam breaks up into, in metres"
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
    triple("Absorption", "Vector", kind["absorption"], "Of red, green and blue light, per metre")
    triple("Scattering", "Vector", kind["scattering"], "Of red, green and blue light, per metre")
    number("Anisotropy", kind["anisotropy"], -1.0, 1.0, "Mean cosine of the angle of scattering")
    compat.add_socket(group, "Surface", "NodeSocketShader", output=True)
    compat.add_socket(group, "Volume", "NodeSocketShader", output=True)


def _normal(t: Tree):
    """The sea's own normal where the mesh carries it, else the mesh's; towards the viewer."""
    geometry = t.node("ShaderNodeNewGeometry").outputs
    stored = t.node("ShaderNodeAttribute", attribute_name="ocean_normal").outputs["Vector"]
    # An attribute that is absent reads 0.
    there = t.number("GREATER_THAN", t.math("LENGTH", stored, result="Value"), 0.5)
    # Made a unit vector when it is turned, which 0 cannot be.
    missing = t.vector(0.0, 0.0, t.number("SUBTRACT", 1.0, there))
    turned = t.node(
        "ShaderNodeVectorTransform",
        vector_type="NORMAL",
        convert_from="OBJECT",
        convert_to="WORLD",
    )
    t.feed(t.math("ADD", stored, missing), turned.inputs[0])
    # Shaders turn the mesh's normal round on the back, not an attribute.
    facing = t.number("MULTIPLY_ADD", geometry["Backfacing"], -2.0, 1.0)
    own = t.scale(t.math("NORMALIZE", turned.outputs[0]), facing)
    difference = t.math("SUBTRACT", own, geometry["Normal"])
    return t.math("NORMALIZE", t.math("ADD", geometry["Normal"], t.scale(difference, there)))


def _slopes(t: Tree, roughness):
    """Mean square slope of all that is too short for the mesh: alpha^2 of Beckmann's distribution,
    whose slopes are Gaussian as the sea's are. Blender's roughness is the root of alpha."""
    stored = t.node("ShaderNodeAttribute", attribute_name="slope_variance").outputs["Fac"]
    own = t.number("POWER", roughness, 4.0)
    return t.number("ADD", own, t.number("MAXIMUM", stored, 0.0))


def _reflectance(t: Tree, ior, normal, slopes):
    """Fresnel's for smooth water; rough water reflects less at grazing angles, where only slopes
    towards the viewer are seen: the fit of Bruneton, Neyret and Holzschuch (2010),
    F = 0.02 + 0.98 (1 - cos)^(5 exp(-2.69 s)) / (1 + 22.7 s^1.5), s the slopes' deviation along the
    view, enters as its difference to that of smooth water."""
    fresnel = t.node("ShaderNodeFresnel")
    t.feed(ior, fresnel.inputs["IOR"])
    t.feed(normal, fresnel.inputs["Normal"])
    geometry = t.node("ShaderNodeNewGeometry").outputs
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


def _foam(t: Tree, inputs):
    """Where foam covers the water: none where the attribute is 0, all where it is 1. Noise breaks
    it up."""
    stored = t.node("ShaderNodeAttribute", attribute_name="cover").outputs["Fac"]
    cover = t.number("MULTIPLY", stored, inputs["Foam Amount"], clamp=True)
    place = t.node("ShaderNodeNewGeometry").outputs["Position"]
    # Flakes do not change as waves lift them.
    place = t.math("MULTIPLY", place, (1.0, 1.0, 0.0))
    noise = t.node("ShaderNodeTexNoise")
    size = t.number("DIVIDE", 1.0, t.number("MAXIMUM", inputs["Foam Scale"], 1e-3))
    t.feed(place, noise.inputs["Vector"])
    t.feed(size, noise.inputs["Scale"])
    for name, value in _NOISE.items():
        noise.inputs[name].default_value = value
    # Gaussian noise to a threshold that takes all values of 0 .. 1 alike: its distribution
    # function, by the logistic one.
    away = t.number("SUBTRACT", noise.outputs[0], 0.5)
    tail = t.number("EXPONENT", t.number("MULTIPLY", away, -1.702 / _NOISE_DEVIATION))
    threshold = t.number("DIVIDE", 1.0, t.number("ADD", 1.0, tail))
    begins = t.number("MULTIPLY", threshold, 1.0 - _FLAKE_EDGE)
    edge = t.node("ShaderNodeMapRange", interpolation_type="SMOOTHSTEP", clamp=True)
    t.feed(cover, edge.inputs["Value"])
    t.feed(begins, edge.inputs["From Min"])
    t.feed(t.number("ADD", begins, _FLAKE_EDGE), edge.inputs["From Max"])
    return edge.outputs[0]


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
    both = t.node("ShaderNodeAddShader")
    t.feed(absorption, both.inputs[0])
    t.feed(scattering, both.inputs[1])
    return both.outputs[0]


def _build(group) -> None:
    _declare(group)
    t = Tree(group)
    inputs = t.node("NodeGroupInput").outputs
    normal = _normal(t)
    slopes = _slopes(t, inputs["Roughness"])
    roughness = t.number("POWER", slopes, 0.25)
    reflectance = _reflectance(t, inputs["IOR"], normal, slopes)

    body = t.shader("ShaderNodeBsdfDiffuse", Color=inputs["Water Colour"], Normal=normal)
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
    unbent = t.shader("ShaderNodeBsdfTransparent", Color=passed)
    clear = t.mix_shaders(t.node("ShaderNodeLightPath").outputs["Is Shadow Ray"], clear, unbent)
    water = t.mix_shaders(inputs["Transparency"], deep, clear)
    foam = t.shader("ShaderNodeBsdfDiffuse", Color=inputs["Foam Colour"], Normal=normal)

    output = t.node("NodeGroupOutput")
    t.feed(t.mix_shaders(_foam(t, inputs), water, foam), output.inputs["Surface"])
    t.feed(_volume(t, inputs), output.inputs["Volume"])
    for number, made in enumerate(group.nodes):
        made.location = (220 * (number // 5), -260 * (number % 5))


def get_group():
    """The node group: made when there is none."""
    for group in bpy.data.node_groups:
        if group.get(MARK) == VERSION and group.library is None:
            return group
    group = bpy.data.node_groups.new(GROUP, "ShaderNodeTree")
    group[MARK] = VERSION
    _build(group)
    return group
