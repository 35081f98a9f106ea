# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Light of the sun through the crests, and what the air hides, as nodes: the formulas of
shaders/wave/crest_light.glsl and haze.glsl.

    height, attribute jacobian, view, sun -> how much of the sun's light is seen, 0 .. 1
"""

from __future__ import annotations

from ..shared.node_builder import Builder

# The formulas -------------------------------------------------------------------


def crest_light(b: Builder, height, jacobian, against, toward):
    """height: in significant wave heights. against, toward: v.s and n.s, with s the horizontal part
    of the unit vector to the sun. 0 to any power is 0 in a node, so that none needs a branch."""
    high = b.number("SUBTRACT", height, 0.1, clamp=True)
    squeezed = b.number("SUBTRACT", 1.4, jacobian, clamp=True)
    away = b.number("POWER", b.number("SUBTRACT", 0.15, toward, clamp=True), 0.7)
    facing = b.number("MAXIMUM", against, 0.0)
    strong = b.number("MULTIPLY", b.number("MULTIPLY", facing, facing), away)
    return b.number("MULTIPLY", b.number("MULTIPLY", high, squeezed), strong)


def haze(b: Builder, distance, visibility):
    """Returns the share of light that haze takes over a distance. A node divides by a visibility of
    0 to 0: no haze."""
    part = b.number("DIVIDE", b.number("MULTIPLY", distance, -3.912), visibility)
    return b.number("SUBTRACT", 1.0, b.number("EXPONENT", part))


# Inputs of the shader -------------------------------------------------------------


def _height(b: Builder):
    """Over the ocean object's origin, in the sea's metres: waves grow with an object that is
    scaled, and go up in the world whichever way it is turned."""
    place = b.node("ShaderNodeTexCoord").outputs["Object"]
    up = b.node(
        "ShaderNodeVectorTransform",
        vector_type="VECTOR",
        convert_from="WORLD",
        convert_to="OBJECT",
    )
    b.feed((0.0, 0.0, 1.0), up.inputs[0])
    return b.math("DOT_PRODUCT", place, b.math("NORMALIZE", up.outputs[0]), result="Value")


def _jacobian(b: Builder):
    """1, its mean, where the mesh does not carry it: an attribute that is absent reads 0."""
    stored = b.node("ShaderNodeAttribute", attribute_name="jacobian").outputs["Fac"]
    there = b.number("SIGN", b.number("ABSOLUTE", stored))
    return b.number("ADD", stored, b.number("SUBTRACT", 1.0, there))


def seen_crest_light(b: Builder, inputs, normal):
    """The share of the sun's light, from above. normal: of the waves that a mesh has."""
    geometry = b.node("ShaderNodeNewGeometry").outputs
    sun = b.math("MULTIPLY", b.math("NORMALIZE", inputs["Sun Direction"]), (1.0, 1.0, 0.0))
    behind = b.math("DOT_PRODUCT", geometry["Incoming"], sun, result="Value")
    share = crest_light(
        b,
        b.number("DIVIDE", _height(b), inputs["Wave Height"]),
        _jacobian(b),
        b.number("MULTIPLY", behind, -1.0),
        b.math("DOT_PRODUCT", normal, sun, result="Value"),
    )
    from_above = b.number("SUBTRACT", 1.0, geometry["Backfacing"])
    return b.number("MULTIPLY", share, from_above)


def seen_haze(b: Builder, inputs):
    """Returns the share of the water that the air hides: only in a direct view of the camera, and
    only on the side in the air."""
    distance = b.node("ShaderNodeCameraData").outputs["View Distance"]
    direct = b.node("ShaderNodeLightPath").outputs["Is Camera Ray"]
    backfacing = b.node("ShaderNodeNewGeometry").outputs["Backfacing"]
    seen = b.number("MULTIPLY", direct, b.number("SUBTRACT", 1.0, backfacing))
    return b.number("MULTIPLY", haze(b, distance, inputs["Visibility"]), seen)
