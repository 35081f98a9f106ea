# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sun of a scene, as drivers of the sockets `Sun Direction` and `Sun Light` of a water.

    sun lamp, or else the disc of the world's sky texture -> drivers -> Ocean Water

Their expressions are simple ones, which Blender works out itself: without Python, scripts allowed
or not, without the add-on.
"""

from __future__ import annotations

import dataclasses

import bpy

from ..shared import compat

DIRECTION, LIGHT = "Sun Direction", "Sun Light"

# Irradiance of a surface that faces the disc of a sky texture at intensity 1: before the air, and
# what a vertical way through its air, its dust and its ozone takes, as optical depths. Fitted to
# renders in Cycles, Blender 3.4 and 5.0, of elevations of 3 to 90 degrees, air of 0.2 to 2, dust of
# 0 to 3, ozone of 1 and 4, altitudes of 0 and 3 km: within 7 % of the brightest channel.
_NISHITA = (
    (165.7, 0.0546, 0.0304, 0.0),
    (144.6, 0.1024, 0.0302, 0.0),
    (138.6, 0.2558, 0.0286, 0.0),
)
_MULTIPLE_SCATTERING = (
    (182.6, 0.0502, 0.0174, 0.0359),
    (166.6, 0.1050, 0.0207, 0.0320),
    (153.3, 0.2694, 0.0275, 0.0),
)
_DISCS = {
    "NISHITA": _NISHITA,
    "SINGLE_SCATTERING": _NISHITA,  # its name from 5.0 on
    "MULTIPLE_SCATTERING": _MULTIPLE_SCATTERING,
}


@dataclasses.dataclass(frozen=True)
class Source:
    """A number in the file that a driver follows."""

    kind: str
    """The type of the datablock, as drivers name it."""
    block: object
    path: str


def drive(owner, name: str, index: int, expression: str, sources: dict[str, Source]) -> None:
    """A property follows an expression of these; index: -1 where it is a single number."""
    driver = owner.driver_add(name, index).driver
    driver.type = "SCRIPTED"
    for variable, source in sources.items():
        made = driver.variables.new()
        made.name = variable
        target = made.targets[0]
        target.id_type, target.id, target.data_path = source.kind, source.block, source.path
    driver.expression = expression


# A lamp -------------------------------------------------------------------------


def _lamp(scene):
    """The first sun that is rendered."""
    return next(
        (
            ob
            for ob in scene.objects
            if ob.type == "LIGHT" and ob.data.type == "SUN" and not ob.hide_render
        ),
        None,
    )


def _follow_lamp(water, ob) -> None:
    lamp = ob.data

    def of_lamp(path: str) -> Source:
        return Source("LIGHT", lamp, path)

    factors, sources = ["c", "e"], {"e": of_lamp("energy")}
    if hasattr(lamp, "exposure"):  # 5.0
        factors.append("pow(2, x)")
        sources["x"] = of_lamp("exposure")
    sources["h"] = Source("OBJECT", ob, "hide_render")
    for axis in range(3):
        # A lamp shines along its -z.
        towards = Source("OBJECT", ob, f"matrix_world[2][{axis}]")
        drive(water.inputs[DIRECTION], "default_value", axis, "z", {"z": towards})
        own, of_channel = list(factors), dict(sources, c=of_lamp(f"color[{axis}]"))
        if hasattr(lamp, "use_temperature"):  # 4.5
            own.append("(t if u else 1)")
            of_channel["t"] = of_lamp(f"temperature_color[{axis}]")
            of_channel["u"] = of_lamp("use_temperature")
        expression = f"{' * '.join(own)} * (1 - h) / pi"
        drive(water.inputs[LIGHT], "default_value", axis, expression, of_channel)


# A sky --------------------------------------------------------------------------


def background(world):
    """Returns the node that the world shows: the node at its output, or the first one."""
    if world is None or not compat.has_nodes(world):
        return None
    nodes = world.node_tree.nodes
    output = next((n for n in nodes if n.type == "OUTPUT_WORLD" and n.is_active_output), None)
    links = output.inputs["Surface"].links if output else ()
    if links and links[0].from_node.type == "BACKGROUND":
        return links[0].from_node
    return next((node for node in nodes if node.type == "BACKGROUND"), None)


def behind(node) -> list:
    """All nodes that an input of a node leads to, the nearest first."""
    found, left = [], [node]
    while left:
        for socket in left.pop(0).inputs:
            for link in socket.links:
                if link.from_node not in found:
                    found.append(link.from_node)
                    left.append(link.from_node)
    return found


def of_world(world, node, path: str) -> Source:
    return Source(
        "WORLD", world, f'node_tree.nodes["{bpy.utils.escape_identifier(node.name)}"].{path}'
    )


def strength(world, shown) -> Source:
    """Returns the source of the background's strength. Blender notices changes of sockets, but not
    of a node's properties: a driver with this beside such a property follows keyframes of both."""
    number = list(shown.inputs).index(shown.inputs["Strength"])
    return of_world(world, shown, f"inputs[{number}].default_value")


def dust(sky) -> str:
    """Returns the name of the property with the density of dust."""
    return "dust_density" if hasattr(sky, "dust_density") else "aerosol_density"  # from 5.0 on


def _sky(scene):
    """The world's sky texture with a sun in it, and the background that shows it."""
    shown = background(scene.world)
    for node in behind(shown) if shown else ():
        if node.type == "TEX_SKY" and node.sky_type in _DISCS and node.sun_disc:
            return node, shown
    return None, None


def _follow_sky(water, world, sky, shown) -> None:
    watched = {"k": strength(world, shown)}
    factor = "i" if shown.inputs["Strength"].is_linked else "k * i"

    def of_sky(**names) -> dict[str, Source]:
        return watched | {short: of_world(world, sky, path) for short, path in names.items()}

    # Blender's rotation is clockwise from +y.
    for axis, towards in enumerate(("sin(r) * cos(e)", "cos(r) * cos(e)", "sin(e)")):
        sources = of_sky(e="sun_elevation", r="sun_rotation")
        drive(water.inputs[DIRECTION], "default_value", axis, towards, sources)
    sources = of_sky(
        e="sun_elevation",
        i="sun_intensity",
        h="altitude",
        a="air_density",
        d=dust(sky),
        o="ozone_density",
    )
    for channel, (most, air, of_dust, ozone) in enumerate(_DISCS[sky.sky_type]):
        # The way through the air [Kasten and Young 1989], and through ozone, high above.
        way = "(sin(e) + .15 * pow(degrees(max(e, 0)) + 3.885, -1.253))"
        depth = f"(a * exp(-h / 8e3) * {air} + d * exp(-h / 1200) * {of_dust}) / {way}"
        if ozone:
            depth += f" + o * {ozone} / sqrt(sin(e) * sin(e) + .0078)"
        expression = f"{factor} * {most} / pi * exp(-({depth})) if e > 0 else 0"
        drive(water.inputs[LIGHT], "default_value", channel, expression, sources)


def follow(water, scene) -> None:
    """Gives the water the sun of the scene and its changes; a scene without a sun gives none."""
    for name in (DIRECTION, LIGHT):
        water.inputs[name].driver_remove("default_value")
    water.inputs[DIRECTION].default_value = (0.0, 0.0, 0.0)
    lamp = _lamp(scene)
    if lamp is not None:
        _follow_lamp(water, lamp)
        return
    sky, shown = _sky(scene)
    if sky is not None:
        _follow_sky(water, scene.world, sky, shown)
