# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The node group of the terrain's modifier: it reads the normals and heights of one period from an
image, by the parts in field_nodes.py, and raises the mesh.

    image Ground: (nx, ny, nz, height) -> attributes terrain_normal, terrain_height -> position
"""

from __future__ import annotations

from ..shared import compat, field_nodes
from ..shared.field_nodes import Turn
from ..shared.modifier_groups import Family
from ..shared.node_builder import Builder

VERSION = 1
FAMILY = Family("libocean_terrain", VERSION)
modifiers = FAMILY.modifiers

GROUND = "Ground"
CHANNELS = ("nx", "ny", "nz", "height")
BLANK = (0.0, 0.0, 1.0, 0.0)
"""Level ground: the colour of an image that nothing fills."""
DRAFT_CELLS = "Draft Cells"
NORMAL, HEIGHT = "terrain_normal", "terrain_height"


def _declare(group) -> None:
    socket = compat.add_socket
    socket(group, "Geometry", "NodeSocketGeometry")
    socket(group, GROUND, "NodeSocketImage", description="Normal, and in alpha the height [m]")
    socket(group, "Tile Size", "NodeSocketFloat", default_value=1000.0, min_value=1e-3)
    socket(group, "Half Texel", "NodeSocketFloat", description="As a share of the tile")
    socket(group, "Origin", "NodeSocketVector", description="The object's place in its tile [m]")
    socket(
        group, "Turn", "NodeSocketVector", description="Of the object in the world, as Euler XYZ"
    )
    socket(
        group,
        "On Samples",
        "NodeSocketBool",
        description="Each vertex lies on a sample of the map, and takes it as it is",
    )
    socket(
        group,
        DRAFT_CELLS,
        "NodeSocketInt",
        description="Cells along a side of the grid that the viewport shows while values move, in "
        "place of a mesh of many vertices; 0: none",
    )
    socket(group, "Draft Size", "NodeSocketFloat", description="Side of that grid [m]")
    socket(group, "Draft Material", "NodeSocketMaterial", description="Material of that grid")
    socket(group, "Mask", "NodeSocketString")
    for name in ("Use Mask", "Use Normal"):
        socket(group, name, "NodeSocketBool")
    socket(group, "Geometry", "NodeSocketGeometry", output=True)


def _or_draft(b: Builder, inputs):
    """Returns the mesh or, in a viewport while values move, a coarse grid in its place."""
    vertices = b.number("ADD", inputs[DRAFT_CELLS], 1.0)
    grid = b.node("GeometryNodeMeshGrid")
    for axis in ("X", "Y"):
        b.link(inputs["Draft Size"], grid.inputs[f"Size {axis}"])
        b.link(vertices, grid.inputs[f"Vertices {axis}"])
    smooth = b.node("GeometryNodeSetShadeSmooth")
    b.link(grid.outputs["Mesh"], smooth.inputs["Geometry"])
    coloured = b.node("GeometryNodeSetMaterial")
    b.link(smooth.outputs[0], coloured.inputs["Geometry"])
    b.link(inputs["Draft Material"], coloured.inputs["Material"])
    is_draft = b.number("GREATER_THAN", inputs[DRAFT_CELLS], 0.5)
    viewport = b.node("GeometryNodeIsViewport").outputs[0]
    is_shown = b.number("MULTIPLY", is_draft, viewport)
    return b.switch("GEOMETRY", is_shown, inputs["Geometry"], coloured.outputs[0])


def _raised(b: Builder, inputs, turned: bool, interpolation: str):
    """Returns the geometry with its attributes, raised."""
    turn = Turn(b, inputs["Turn"] if turned else None)
    place = field_nodes.place_on_map(
        b,
        turn,
        origin=inputs["Origin"],
        period=inputs["Tile Size"],
        half_texel=inputs["Half Texel"],
    )
    color = b.texture(inputs[GROUND], place, interpolation)
    geometry, color = compat.capture(b.group, inputs["Geometry"], color)
    nx, ny, nz, height = b.components(color)
    mask = field_nodes.mask(b, inputs)
    height = b.number("MULTIPLY", height, mask)
    geometry = b.store(geometry, HEIGHT, "FLOAT", height)
    normal = field_nodes.toward_up(b, b.vector(nx, ny, nz), mask)
    stored = b.store(geometry, NORMAL, "FLOAT_VECTOR", turn.to_local(normal))
    geometry = b.switch("GEOMETRY", inputs["Use Normal"], geometry, stored)
    moved = b.node("GeometryNodeSetPosition")
    b.link(geometry, moved.inputs["Geometry"])
    b.link(turn.to_local(b.vector(0.0, 0.0, height)), moved.inputs["Offset"])
    return moved.outputs["Geometry"]


def get():
    """Returns the group, made if it is missing."""
    name = f".libocean.terrain.v{VERSION}"
    group = FAMILY.find(name)
    if group is not None:
        return group
    group = FAMILY.new(name)
    _declare(group)
    compat.hide_inputs(group)
    b = Builder(group)
    inputs = b.node("NodeGroupInput").outputs
    raised = field_nodes.branches(
        b,
        inputs,
        _raised,
        name=name.removeprefix(".libocean."),
        on_samples=inputs["On Samples"],
        euler=inputs["Turn"],
        geometry=_or_draft(b, inputs),
    )
    b.link(raised, b.node("NodeGroupOutput").inputs[0])
    b.arrange(rows=4, height=240)
    return group


def image_inputs(_group) -> list[str]:
    """Returns the names of the inputs of images."""
    return [GROUND]
