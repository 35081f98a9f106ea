# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The node group `Pixel Angle`: the angle of a pixel, by the camera, the lens and the resolution of
the scene that is rendered.

Attributes of the view layer read them in Cycles and Eevee, without drivers and without the add-on.
They do not tell a sensor fitted to the width from one that fits itself: a tall picture gets the
angle by its height.
"""

from __future__ import annotations

from ..shared import compat
from ..shared.shader_builder import Tree, shader_group

GROUP = "Pixel Angle"
MARK = "libocean_pixel_angle"  # custom property of the group: the version that built it
_VERSION = 1

DEFAULT = 36.0 / 50.0 / 1920.0
"""[rad] Behind a lens of 50 mm in a picture 1920 pixels wide."""


def _build(group) -> None:
    compat.add_socket(group, GROUP, "NodeSocketFloat", output=True)
    t = Tree(group)

    def of_scene(path: str):
        made = t.node("ShaderNodeAttribute", attribute_type="VIEW_LAYER", attribute_name=path)
        return made.outputs["Fac"]

    angle = of_scene("camera.data.angle")
    x, y = of_scene("render.resolution_x"), of_scene("render.resolution_y")
    off = t.number("ABSOLUTE", t.number("SUBTRACT", angle, of_scene("camera.data.angle_x")))
    is_by_height = t.number("GREATER_THAN", off, 1e-5)
    side = t.number("MAXIMUM", y, t.number("MULTIPLY", x, t.number("SUBTRACT", 1.0, is_by_height)))
    percent = of_scene("render.resolution_percentage")
    side = t.number("MULTIPLY", side, t.number("MULTIPLY", percent, 0.01))
    wide = t.number("MULTIPLY", 2.0, t.number("TANGENT", t.number("MULTIPLY", angle, 0.5)))
    found = t.number("DIVIDE", wide, t.number("MAXIMUM", side, 1.0))
    # All of a scene without a camera is 0.
    is_absent = t.number("LESS_THAN", angle, 1e-6)
    found = t.number("MULTIPLY_ADD", is_absent, DEFAULT, found)
    t.link(found, t.node("NodeGroupOutput").inputs[0])
    t.arrange(rows=4)


def follow(tree, node) -> None:
    """Has the input `Pixel Angle` of a node of a material's tree follow the rendered scene, unless
    it is connected."""
    if node.inputs[GROUP].is_linked:
        return
    made = tree.nodes.new("ShaderNodeGroup")
    made.node_tree = shader_group(MARK, _VERSION, GROUP, _build)
    made.location = (node.location[0] - 260, node.location[1] + 120)
    tree.links.new(made.outputs[0], node.inputs[GROUP])
