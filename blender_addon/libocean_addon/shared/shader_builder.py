# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Short words for the parts of a material."""

from __future__ import annotations

from functools import cached_property

import bpy

from .node_builder import Builder


class Tree(Builder):
    """Words for shaders, in addition to the words for all nodes."""

    @cached_property
    def geometry(self):
        """The outputs of the node of the place and its normals: one for the tree."""
        return self.node("ShaderNodeNewGeometry").outputs

    def shader(self, kind: str, *, settings: dict | None = None, **inputs):
        made = self.node(kind, **(settings or {}))
        for name, value in inputs.items():
            self.feed(value, made.inputs[name])
        return made.outputs[0]

    def add_shaders(self, first, second):
        made = self.node("ShaderNodeAddShader")
        self.feed(first, made.inputs[0])
        self.feed(second, made.inputs[1])
        return made.outputs[0]

    def mix_shaders(self, factor, off, on):
        made = self.node("ShaderNodeMixShader")
        for socket, value in zip(made.inputs, (factor, off, on), strict=True):
            self.feed(value, socket)
        return made.outputs[0]


def shader_group(mark: str, version, name: str, build):
    """Returns the node group of a version of the add-on, made by build(group) if it is missing.
    mark: the custom property that holds the version."""
    for group in bpy.data.node_groups:
        if group.get(mark) == version and group.library is None:
            return group
    group = bpy.data.node_groups.new(name, "ShaderNodeTree")
    group[mark] = version
    build(group)
    return group


def facing(t: Tree):
    """Returns 1 from above, -1 from below."""
    backfacing = t.geometry["Backfacing"]
    return t.number("MULTIPLY_ADD", backfacing, -2.0, 1.0)


def stored_normal(t: Tree, attribute: str, side):
    """Returns the normal in an attribute where the mesh carries it, else the mesh's; upwards, from
    whichever side it is seen. side: facing()."""
    stored = t.node("ShaderNodeAttribute", attribute_name=attribute).outputs["Vector"]
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
    own = t.math("NORMALIZE", turned.outputs[0])
    # Shaders turn the mesh's normal towards the viewer, not an attribute.
    of_mesh = t.scale(t.geometry["Normal"], side)
    return t.math("NORMALIZE", t.mix(of_mesh, own, there))
