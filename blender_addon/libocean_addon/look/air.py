# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The light of the air in front of a far sea: that of the world's sky at the horizon, in the
direction of the view.

    nodes behind the world's background, copied into a material -> Ocean Water: Air Light

A number of the world that may change is followed by a driver, as the sun is.
"""

from __future__ import annotations

import bpy

from ..shared.shader_builder import Tree
from . import sunlight

SOCKET = "Air Light"
MARK = "libocean_air"  # custom property of the nodes that are made here
_HEIGHT = 0.02
"""The height over the horizon at which the sky is read; some skies are black below it."""

_NUMBERS = {"VALUE", "VECTOR", "RGBA"}
_COPIED = {"ENUM", "BOOLEAN", "INT", "FLOAT", "POINTER"}
_COMMON = set(bpy.types.ShaderNode.bl_rna.properties.keys()) - {"mute"}
_PLACES = {"TEX_COORD", "NEW_GEOMETRY"}
_DRAWN = {"VALTORGB", "CURVE_RGB", "CURVE_VEC", "CURVE_FLOAT"}
"""Nodes with a curve, which is not copied: the copy passes their input on."""
_SKY = (
    "sun_elevation",
    "sun_rotation",
    "altitude",
    "air_density",
    "dust_density",
    "aerosol_density",
    "ozone_density",
    "turbidity",
    "ground_albedo",
    "sun_direction",
)
_DIRECTED = ("PREETHAM", "HOSEK_WILKIE")
"""The models that read the direction of the sun; the others have its elevation and rotation."""


class _Copy:
    """Copies nodes of a world into a material's tree."""

    def __init__(self, t: Tree, world, shown) -> None:
        self.t, self.world = t, world
        self.watched = sunlight.strength(world, shown)
        self.made: dict = {}
        self.direction = self._direction()

    def _direction(self):
        incoming = self.t.node("ShaderNodeNewGeometry").outputs["Incoming"]
        level = self.t.math("NORMALIZE", self.t.math("MULTIPLY", incoming, (-1.0, -1.0, 0.0)))
        return self.t.math("NORMALIZE", self.t.math("ADD", level, (0.0, 0.0, _HEIGHT)))

    def _drive(self, owner, name: str, node, path: str) -> None:
        """Has a property of a copied node, a number or several, follow the same property of the
        original."""
        now = getattr(owner, name)
        indices = range(len(now)) if hasattr(now, "__len__") else (-1,)
        for index in indices:
            part = "" if index < 0 else f"[{index}]"
            sources = {"v": sunlight.of_world(self.world, node, path + part), "k": self.watched}
            sunlight.drive(owner, name, index, "v", sources)

    def feed(self, node, number: int, socket) -> None:
        """Connects a socket to a copy of the link, or of the value, at the input of that number of
        a node."""
        source = node.inputs[number]
        if source.is_linked:
            value = self.output(source.links[0].from_socket)
            if value is not None:
                self.t.link(value, socket)
        elif node.type.startswith("TEX_") and source.type == "VECTOR" and source.hide_value:
            self.t.link(self.direction, socket)
        elif source.type in _NUMBERS and socket.type in _NUMBERS and source.enabled:
            width = len(source.default_value) if source.type != "VALUE" else 1
            if width == 1 or socket.type == source.type:
                socket.default_value = source.default_value
            else:
                socket.default_value = tuple(source.default_value)[:3]
            self._drive(socket, "default_value", node, f"inputs[{number}].default_value")

    def output(self, output):
        """The copy of an output of a node; None where nothing comes."""
        node = output.node
        if node.type in _PLACES:
            return self.direction
        if node.type in _DRAWN:
            linked = [socket for socket in node.inputs if socket.is_linked]
            return self.output(linked[-1].links[0].from_socket) if linked else None
        if node not in self.made:
            self.made[node] = self._node(node)
        return self.made[node].outputs[list(node.outputs).index(output)]

    def _node(self, node):
        made = self.t.node(node.bl_idname)
        for prop in node.bl_rna.properties:
            if prop.identifier in _COMMON or prop.is_readonly or prop.type not in _COPIED:
                continue
            setattr(made, prop.identifier, getattr(node, prop.identifier))
        if node.type == "TEX_SKY":
            if hasattr(made, "sun_disc"):
                made.sun_disc = False
            is_old = node.sky_type in _DIRECTED
            for name in _SKY:
                if hasattr(node, name) and (is_old or name != "sun_direction"):
                    self._drive(made, name, node, name)
        if node.type in {"RGB", "VALUE"}:
            made.outputs[0].default_value = node.outputs[0].default_value
            self._drive(made.outputs[0], "default_value", node, "outputs[0].default_value")
        for number, socket in enumerate(made.inputs):
            self.feed(node, number, socket)
        return made


def _clear(tree, water) -> bool:
    """Removes the nodes that were made before. Returns whether the socket is free then."""
    links = water.inputs[SOCKET].links
    if links and MARK not in links[0].from_node:
        return False
    if links:
        for node in {links[0].from_node, *sunlight.behind(links[0].from_node)}:
            tree.nodes.remove(node)
    water.inputs[SOCKET].driver_remove("default_value")
    water.inputs[SOCKET].default_value = (0.0, 0.0, 0.0, 1.0)
    return True


def follow(tree, water, world) -> None:
    """Gives a water with a visibility the air of this world. A user's own link at the socket
    stays."""
    if not _clear(tree, water) or world is None or water.inputs["Visibility"].default_value <= 0.0:
        return
    shown = sunlight.background(world)
    if shown is None:
        water.inputs[SOCKET].default_value = (*world.color, 1.0)
        return
    there = set(tree.nodes)
    t = Tree(tree)
    copy = _Copy(t, world, shown)
    made = t.node("ShaderNodeVectorMath", operation="SCALE")
    names = [socket.name for socket in shown.inputs]
    copy.feed(shown, names.index("Color"), made.inputs[0])
    copy.feed(shown, names.index("Strength"), made.inputs["Scale"])
    t.link(made.outputs["Vector"], water.inputs[SOCKET])
    new = [node for node in tree.nodes if node not in there]
    for number, node in enumerate(new):
        node[MARK] = True
        node.location = (water.location[0] - 1300 + 220 * (number % 5), -500 - 300 * (number // 5))
