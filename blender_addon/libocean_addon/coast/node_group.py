# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The node group of the water of a coast: it reads finished fields of a region from images, by the
parts in field_nodes.py, and leaves out the faces that lie dry.

    position - origin, / map size, + half a texel -> images -> attributes, offset -> wet faces

The images end at their edges: a sea over a bed does not repeat.
"""

from __future__ import annotations

from ..bake.baked_nodes import BakedFields
from ..shared import compat, field_nodes, meshes
from ..shared.field_nodes import Turn
from ..shared.modifier_groups import Family
from ..shared.node_builder import Builder
from ..terrain.extent import Extent

VERSION = 1
FAMILY = Family("libocean_coast", VERSION)
modifiers = FAMILY.modifiers

DISPLACEMENT, VELOCITY, NORMAL, FOAM = "Displacement", "Velocity", "Normal", "Foam"
WETNESS = "Wetness"
CHANNELS = {
    DISPLACEMENT: ("dx", "dy", "height", "depth"),
    VELOCITY: ("vx", "vy", "vz", "jacobian"),
    NORMAL: ("nx", "ny", "nz", "breaking"),
    FOAM: ("foam", "cover"),
    WETNESS: ("wetness",),
}
"""The channels of the image in each input. The last one is of the group of the land."""
FILES = {
    DISPLACEMENT: ("displacement", "depth"),
    VELOCITY: ("velocity", "jacobian"),
    NORMAL: ("normal", "breaking"),
    FOAM: ("foam", "cover"),
    WETNESS: ("wetness",),
}
"""The fields of the files in which a bake has the channels of each input."""


def wanted_files(ob) -> list[str]:
    """Returns the fields of the next bake of a coast."""
    return [file for name in wanted_fields(ob) for file in FILES[name]]


def wanted_fields(ob, seen=None) -> tuple[str, ...]:
    """Returns the inputs that the settings of a coast ask for. seen: the object, evaluated."""
    settings = (seen or ob).libocean
    wanted = {
        DISPLACEMENT: True,
        VELOCITY: settings.use_velocity,
        NORMAL: settings.use_normal,
        FOAM: settings.use_foam,
        WETNESS: (seen or ob).libocean_coast.use_wetness and meshes.is_ours(ob.libocean_coast.land),
    }
    return tuple(name for name, is_used in wanted.items() if is_used)


VECTORS = (DISPLACEMENT, VELOCITY, NORMAL)
"""The inputs that hold a vector and a number behind it."""
BLANKS = {
    DISPLACEMENT: (0.0, 0.0, 0.0, 0.0),
    VELOCITY: (0.0, 0.0, 0.0, 1.0),
    NORMAL: (0.0, 0.0, 1.0, 0.0),
    FOAM: (0.0, 0.0, 0.0, 0.0),
    WETNESS: (0.0, 0.0, 0.0, 0.0),
}
"""The colours of images that nothing fills: water at rest, wet everywhere."""


def declare_place(group) -> None:
    """Adds the inputs of Extent.inputs() and field_nodes.place_in_map()."""
    vectors = {
        "Map Size": "Sides of all texels of an image together [m]",
        "Half Texels": "As shares of the map",
        "Low": "Where the images end, as shares",
        "High": "Where the images end, as shares",
        "Origin": "The place of the object's origin in the map [m]",
    }
    for name, description in vectors.items():
        compat.add_socket(group, name, "NodeSocketVector", description=description)


def grid_words(extent: Extent) -> str:
    """Returns the words by which the grid of the water on these samples is known."""
    return f"grid {extent.origin} {extent.cell!r} {extent.samples}"


def water_inputs(ob, extent: Extent, fields) -> dict:
    """Returns all inputs of the water but its images. extent: the samples of the images; fields:
    the inputs that are in use."""
    settings = ob.libocean_coast
    return {
        **extent.inputs(),
        "On Samples": meshes.made_of(ob.data) == grid_words(extent),
        "Use Velocity": VELOCITY in fields,
        "Use Normal": NORMAL in fields,
        "Use Foam": FOAM in fields,
        "Use Clip": settings.use_clip,
        "Clip Depth": settings.clip_depth,
    }


def image_of(file: str) -> str:
    """Returns the name of the input for the files of a field, in a group that plays a bake."""
    return file.capitalize()


def declare_frames(group) -> None:
    """Adds the inputs of BakedFields, the scene's frames that have files."""
    for name in ("First", "Last", "Frame Length"):
        compat.add_socket(group, name, "NodeSocketFloat", default_value=1.0)


class LiveFields:
    """The fields in images that the add-on fills."""

    def __init__(self, b: Builder, inputs) -> None:
        self.b, self.inputs = b, inputs

    def captured(self, geometry, name: str, place, interpolation: str):
        """Returns the geometry with the image of an input read, a vector of its first channels, and
        its numbers: all channels, or that behind a vector."""
        texture = self.b.texture(self.inputs[name], place, interpolation)
        geometry, color = compat.capture(self.b.group, geometry, texture)
        return (
            geometry,
            color,
            [self.b.alpha(color)] if name in VECTORS else self.b.components(color),
        )


class PlayedFields:
    """The fields in the files of a bake."""

    def __init__(self, b: Builder, inputs) -> None:
        self.b, self.inputs, self.frames = b, inputs, BakedFields(b, inputs)

    def captured(self, geometry, name: str, place, interpolation: str):
        """As LiveFields.captured."""
        b, found = self.b, []
        for file in FILES[name]:
            images = self.frames.read(image_of(file), place, interpolation)
            geometry, color = compat.capture(
                b.group, geometry, b.mix(*images, self.frames.fraction)
            )
            found.append(color)
        if name in VECTORS:
            return geometry, self.frames.from_file(found[0], 1.0), [b.parts(found[1])[0]]
        return geometry, None, [b.parts(color)[0] for color in found]


def _declare(group, *, baked: bool) -> None:
    socket = compat.add_socket
    socket(group, "Geometry", "NodeSocketGeometry")
    for name, channels in CHANNELS.items():
        if name == WETNESS:
            continue
        if not baked:
            socket(group, name, "NodeSocketImage", description=", ".join(channels))
        for file in FILES[name] if baked else ():
            socket(group, image_of(file), "NodeSocketImage")
    declare_place(group)
    if baked:
        declare_frames(group)
    socket(
        group,
        "On Samples",
        "NodeSocketBool",
        description="Each vertex lies on a sample of the map, and takes it as it is",
    )
    for name in ("Use Velocity", "Use Normal", "Use Foam", "Use Clip"):
        socket(group, name, "NodeSocketBool")
    socket(
        group,
        "Clip Depth",
        "NodeSocketFloat",
        default_value=0.3,
        description="How far the bed lies above the water where faces are left out [m]",
    )
    socket(group, "Geometry", "NodeSocketGeometry", output=True)


def _stored(b: Builder, inputs, fields, place, interpolation: str):
    """Returns the geometry with the attributes that are in use."""
    geometry = inputs["Geometry"]
    made, _, (foam, cover, *_) = fields.captured(geometry, FOAM, place, interpolation)
    made = b.store(made, "foam", "FLOAT", foam)
    made = b.store(made, "cover", "FLOAT", cover)
    geometry = b.switch("GEOMETRY", inputs["Use Foam"], geometry, made)

    made, velocity, (jacobian,) = fields.captured(geometry, VELOCITY, place, interpolation)
    made = b.store(made, "jacobian", "FLOAT", jacobian)
    # Cycles takes `velocity` for motion blur and shows shaders zeros in its place.
    made = b.store(made, "velocity", "FLOAT_VECTOR", velocity)
    made = b.store(made, "ocean_velocity", "FLOAT_VECTOR", velocity)
    geometry = b.switch("GEOMETRY", inputs["Use Velocity"], geometry, made)

    made, normal, (breaking,) = fields.captured(geometry, NORMAL, place, interpolation)
    made = b.store(made, "ocean_normal", "FLOAT_VECTOR", normal)
    made = b.store(made, "breaking", "FLOAT", breaking)
    return b.switch("GEOMETRY", inputs["Use Normal"], geometry, made)


def _without_dry(b: Builder, geometry, inputs, depth):
    """Returns the geometry without the faces whose corners are all dry."""
    is_wet = b.number("GREATER_THAN", depth, b.number("MULTIPLY", inputs["Clip Depth"], -1.0))
    geometry, wet = compat.capture(b.group, geometry, b.color(is_wet, is_wet, is_wet, 1.0))
    node = b.node("GeometryNodeDeleteGeometry", domain="FACE")
    b.link(geometry, node.inputs["Geometry"])
    # On a face it is the share of its corners that are wet.
    b.link(b.number("LESS_THAN", b.components(wet)[0], 1e-3), node.inputs["Selection"])
    # The node may put the vertices that it leaves in another order.
    return b.switch("GEOMETRY", inputs["Use Clip"], geometry, node.outputs[0])


def _displaced(b: Builder, inputs, fields, interpolation: str):
    """Returns the geometry with its attributes, moved and clipped."""
    place = field_nodes.place_in_map(b, Turn(b, None), inputs)
    geometry = _stored(b, inputs, fields, place, interpolation)
    geometry, offset, (depth,) = fields.captured(geometry, DISPLACEMENT, place, interpolation)
    geometry = b.store(geometry, "depth", "FLOAT", depth)
    # z = 1 tells the label of a place from an absent attribute.
    position = b.node("GeometryNodeInputPosition").outputs[0]
    label = b.math("MULTIPLY_ADD", position, (1.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    geometry = b.store(geometry, "label", "FLOAT_VECTOR", label)
    moved = b.node("GeometryNodeSetPosition")
    b.link(geometry, moved.inputs["Geometry"])
    b.link(offset, moved.inputs["Offset"])
    return _without_dry(b, moved.outputs["Geometry"], inputs, depth)


def _build(group, *, baked: bool) -> None:
    _declare(group, baked=baked)
    compat.hide_inputs(group)
    b = Builder(group)
    inputs = b.node("NodeGroupInput").outputs
    given = {socket.name: socket for socket in inputs if socket.name}
    make_fields = PlayedFields if baked else LiveFields

    def branch(interpolation: str):
        def make(b: Builder, *sockets):
            inside = dict(zip(given, sockets, strict=True))
            return [_displaced(b, inside, make_fields(b, inside), interpolation)]

        part = f"{group.name.removeprefix('.libocean.')} {interpolation.lower()}"
        return b.nested(part, make, *given.values())[0]

    shown = b.switch("GEOMETRY", inputs["On Samples"], branch("Linear"), branch("Closest"))
    b.link(shown, b.node("NodeGroupOutput").inputs[0])
    b.arrange(rows=4, height=240)


def get(*, baked: bool = False):
    """Returns the group, made if it is missing. baked: one that plays a bake."""
    name = f".libocean.coast.v{VERSION}{' baked' if baked else ''}"
    return FAMILY.get(name, lambda group: _build(group, baked=baked), baked=baked)


def image_inputs(group) -> list[str]:
    """Returns the names of the inputs of images."""
    named = compat.input_identifiers(group)  # a linked group may be of an earlier version
    files = [image_of(file) for name in CHANNELS for file in FILES[name]]
    return [name for name in dict.fromkeys([*CHANNELS, *files]) if name in named]
