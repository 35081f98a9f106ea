# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The node group of the terrain's modifier: it reads normals, heights and masks from images, by the
parts in field_nodes.py, stores them as attributes and raises the mesh.

    image Ground: (nx, ny, nz, height) -> attributes terrain_normal, terrain_height -> position
                                       -> attribute slope
    images of masks, by group          -> attributes wear, gully, ridge; flow ...; beach ...

A tile's images repeat; those of a land that exists once, and of regions, end at their edges.
"""

from __future__ import annotations

from ..shared import compat, field_nodes
from ..shared.field_nodes import Turn
from ..shared.modifier_groups import Family
from ..shared.node_builder import Builder

VERSION = 2
FAMILY = Family("libocean_terrain", VERSION)
modifiers = FAMILY.modifiers

GROUND = "Ground"
CHANNELS = ("nx", "ny", "nz", "height")
BLANK = (0.0, 0.0, 1.0, 0.0)
"""Level ground: the colour of an image that nothing fills."""
DRAFT_CELLS = "Draft Cells"
NORMAL, HEIGHT = "terrain_normal", "terrain_height"
SLOPE = "slope"
"""The tangent of the steepness."""
MASKS = {
    "gullies": ("wear", "gully", "ridge"),
    "stream": ("flow", "deposit", "streambed", "wetness"),
    "coast": ("beach", "cliff", "shelter"),
}
"""The masks of each group of parameters that shape a land: channels of one image, and the names of
attributes."""


def image_of(group: str) -> str:
    """Returns the input with the image of a group's masks."""
    return f"Masks of {group}"


def use_of(group: str) -> str:
    """Returns the input that says whether the land has a group's masks."""
    return f"Use masks of {group}"


def _declare(group) -> None:
    socket = compat.add_socket
    socket(group, "Geometry", "NodeSocketGeometry")
    socket(group, GROUND, "NodeSocketImage", description="Normal, and in alpha the height [m]")
    for name in MASKS:
        socket(group, image_of(name), "NodeSocketImage")
        socket(group, use_of(name), "NodeSocketBool")
    socket(
        group,
        "Map Size",
        "NodeSocketVector",
        default_value=(1000.0, 1000.0, 1.0),
        description="Sides of all texels of an image together [m]",
    )
    socket(group, "Half Texels", "NodeSocketVector", description="As shares of the map")
    socket(group, "Low", "NodeSocketVector", description="Where the images end, as shares")
    socket(group, "High", "NodeSocketVector", description="Where the images end, as shares")
    socket(group, "Origin", "NodeSocketVector", description="The object's place in the map [m]")
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
    socket(group, "Draft Sides", "NodeSocketVector", description="Sides of that grid [m]")
    socket(group, "Draft Middle", "NodeSocketVector", description="Middle of that grid [m]")
    socket(group, "Draft Material", "NodeSocketMaterial", description="Material of that grid")
    socket(group, "Mask", "NodeSocketString")
    for name in ("Use Mask", "Use Normal", "Use Slope"):
        socket(group, name, "NodeSocketBool")
    socket(
        group,
        "Is Raised",
        "NodeSocketBool",
        description="The vertices have the land's heights: images give attributes alone",
    )
    socket(group, "Geometry", "NodeSocketGeometry", output=True)


def _or_draft(b: Builder, inputs):
    """Returns the mesh or, in a viewport while values move, a coarse grid in its place."""
    vertices = b.number("ADD", inputs[DRAFT_CELLS], 1.0)
    grid = b.node("GeometryNodeMeshGrid")
    for axis, side in zip(("X", "Y"), b.parts(inputs["Draft Sides"]), strict=False):
        b.link(side, grid.inputs[f"Size {axis}"])
        b.link(vertices, grid.inputs[f"Vertices {axis}"])
    moved = b.node("GeometryNodeTransform")
    b.link(grid.outputs["Mesh"], moved.inputs["Geometry"])
    b.link(inputs["Draft Middle"], moved.inputs["Translation"])
    smooth = b.node("GeometryNodeSetShadeSmooth")
    b.link(moved.outputs[0], smooth.inputs["Geometry"])
    coloured = b.node("GeometryNodeSetMaterial")
    b.link(smooth.outputs[0], coloured.inputs["Geometry"])
    b.link(inputs["Draft Material"], coloured.inputs["Material"])
    is_draft = b.number("GREATER_THAN", inputs[DRAFT_CELLS], 0.5)
    viewport = b.node("GeometryNodeIsViewport").outputs[0]
    is_shown = b.number("MULTIPLY", is_draft, viewport)
    return b.switch("GEOMETRY", is_shown, inputs["Geometry"], coloured.outputs[0])


def _slope(b: Builder, normal):
    """Returns the tangent of the steepness of a normal."""
    nx, ny, nz = b.parts(normal)
    level = b.math("LENGTH", b.vector(nx, ny, 0.0), result="Value")
    return b.number("DIVIDE", level, b.number("MAXIMUM", nz, 1e-6))


def _with_masks(b: Builder, geometry, inputs, place, interpolation: str):
    """Returns the geometry with the masks that the land has as attributes."""

    def stored(b: Builder, geometry, image, use, place, names) -> list:
        color = b.texture(image, place, interpolation)
        made, color = compat.capture(b.group, geometry, color)
        for name, value in zip(names, b.components(color), strict=False):
            made = b.store(made, name, "FLOAT", value)
        return [b.switch("GEOMETRY", use, geometry, made)]

    for group, names in MASKS.items():

        def make(b: Builder, *sockets, names=names) -> list:
            return stored(b, *sockets, names)

        given = (geometry, inputs[image_of(group)], inputs[use_of(group)], place)
        (geometry,) = b.nested(f"terrain {group} {interpolation.lower()}", make, *given)
    return geometry


def _raised(b: Builder, inputs, turned: bool, interpolation: str):
    """Returns the geometry with its attributes, raised."""
    turn = Turn(b, inputs["Turn"] if turned else None)
    place = field_nodes.place_in_map(b, turn, inputs)
    color = b.texture(inputs[GROUND], place, interpolation)
    geometry = _with_masks(b, inputs["Geometry"], inputs, place, interpolation)
    geometry, color = compat.capture(b.group, geometry, color)
    nx, ny, nz, height = b.components(color)
    mask = field_nodes.mask(b, inputs)
    height = b.number("MULTIPLY", height, mask)
    own = b.parts(b.node("GeometryNodeInputPosition").outputs[0])[2]
    stored_height = b.switch("FLOAT", inputs["Is Raised"], height, own)
    geometry = b.store(geometry, HEIGHT, "FLOAT", stored_height)
    normal = field_nodes.toward_up(b, b.vector(nx, ny, nz), mask)
    stored = b.store(geometry, NORMAL, "FLOAT_VECTOR", turn.to_local(normal))
    geometry = b.switch("GEOMETRY", inputs["Use Normal"], geometry, stored)
    of_mesh = b.node("GeometryNodeInputNormal").outputs[0]
    steep = b.switch("VECTOR", inputs["Is Raised"], normal, of_mesh)
    sloped = b.store(geometry, SLOPE, "FLOAT", _slope(b, steep))
    geometry = b.switch("GEOMETRY", inputs["Use Slope"], geometry, sloped)
    moved = b.node("GeometryNodeSetPosition")
    b.link(geometry, moved.inputs["Geometry"])
    b.link(turn.to_local(b.vector(0.0, 0.0, height)), moved.inputs["Offset"])
    return b.switch("GEOMETRY", inputs["Is Raised"], moved.outputs["Geometry"], geometry)


def _build(group) -> None:
    _declare(group)
    compat.hide_inputs(group)
    b = Builder(group)
    inputs = b.node("NodeGroupInput").outputs
    raised = field_nodes.branches(
        b,
        inputs,
        _raised,
        name=group.name.removeprefix(".libocean."),
        on_samples=inputs["On Samples"],
        euler=inputs["Turn"],
        geometry=_or_draft(b, inputs),
    )
    b.link(raised, b.node("NodeGroupOutput").inputs[0])
    b.arrange(rows=4, height=240)


def get():
    """Returns the group, made if it is missing."""
    return FAMILY.get(f".libocean.terrain.v{VERSION}", _build)


def image_inputs(group) -> list[str]:
    """Returns the names of the inputs of images."""
    named = compat.input_identifiers(group)  # a linked group may be of an earlier version
    return [name for name in (GROUND, *map(image_of, MASKS)) if name in named]
