# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The waves too short for the maps, half of all slope, as the material shows them near the eye.

    libocean's slope tiles of the frame, or those of a bake as image sequences
    -> an image for each band -> group `Ocean Detail`:
    label, footprint of a pixel -> slopes, and their mean square -> Ocean Water: normal, roughness

Over a bed they end with the water, and the mean square lacks that of all waves that the map of the
sea lacks, since no attribute of a coast has it.

The formulas are those of shaders/wave/slope_tiles.glsl and copies.glsl, but for the hash that moves
the copies about: nodes have no whole numbers of 32 bits, and White Noise takes its place.
"""

from __future__ import annotations

from collections.abc import Callable

import bpy

from ..shared import compat, images
from ..shared.shader_builder import Tree
from . import foam_nodes, pixel_angle, water_shader
from .detail_tiles import SAMPLES, Band, band_of, lost_slopes

GROUP = "Ocean Detail"
MARK = "libocean_detail"  # custom property of a group and of images: the object whose sea it is
_MADE_OF = "libocean_bands"  # custom property of a group: of which tiles
SOCKET = "Detail"
_EDGES = 2.0  # slope_tile_triangles
_SHALLOW = 0.5
"""[m] The depth below which these waves end: detail_depth of shaders/preview/water_at.glsl."""

# The formulas -------------------------------------------------------------------


def copies(b, x, y) -> list[tuple]:
    """slope_tile_read: where in the tile to read, and the weight, for each corner of the triangle
    that holds a place, all in tiles."""
    grid_x = b.number(
        "MULTIPLY_ADD", y, -_EDGES * 0.57735026918962576, b.number("MULTIPLY", x, _EDGES)
    )
    grid_y = b.number("MULTIPLY", y, _EDGES * 1.15470053837925153)
    square_x, square_y = b.number("FLOOR", grid_x), b.number("FLOOR", grid_y)
    part_x, part_y = b.number("SUBTRACT", grid_x, square_x), b.number("SUBTRACT", grid_y, square_y)
    rest = b.number("SUBTRACT", b.number("SUBTRACT", 1.0, part_x), part_y)
    other = b.number("LESS_THAN", rest, 0.0)
    same = b.number("SUBTRACT", 1.0, other)

    def turned(share):
        return foam_nodes.blend(b, share, b.number("SUBTRACT", 1.0, share), other)

    corners = [
        (b.number("ABSOLUTE", rest), other, other),
        (turned(part_y), other, same),
        (turned(part_x), same, other),
    ]
    squares = 0.0
    for weight, _, _ in corners:
        squares = b.number("MULTIPLY_ADD", weight, weight, squares)
    deviation = b.number("SQRT", squares)
    found = []
    for weight, right, up in corners:
        noise = b.node("ShaderNodeTexWhiteNoise", noise_dimensions="2D")
        corner = b.vector(b.number("ADD", square_x, right), b.number("ADD", square_y, up), 0.0)
        b.link(corner, noise.inputs["Vector"])
        place = b.math("ADD", b.vector(x, y, 0.0), noise.outputs["Color"])
        found.append((place, b.number("DIVIDE", weight, deviation)))
    return found


def fade(b, footprint, shortest_wave: float, longest_wave: float):
    """slope_tile_fade: the share of a band's slopes that is shown."""
    middle = (shortest_wave * longest_wave) ** 0.5
    made = b.node("ShaderNodeMapRange", interpolation_type="SMOOTHSTEP", clamp=True)
    b.feed(footprint, made.inputs["Value"])
    for name, value in {
        "From Min": 0.25 * middle,
        "From Max": 1.2 * middle,
        "To Min": 1.0,
        "To Max": 0.0,
    }.items():
        made.inputs[name].default_value = value
    return made.outputs[0]


def _play(user, frames: tuple[int, int]) -> None:
    """The file of the scene's frame; beyond the first and the last frame that has one, theirs."""
    first, last = frames
    # Blender counts from 1, but gives earlier frames the number 0, which the first file has.
    user.frame_start, user.frame_duration, user.frame_offset = first + 1, last - first, first
    user.use_auto_refresh = True


def _band(t: Tree, place, footprint, band: Band, image, frames: tuple[int, int] | None):
    """Slopes that a band shows, and their mean square."""
    x, y, _ = t.parts(t.scale(place, 1.0 / band.tile))
    slope = (0.0, 0.0, 0.0)
    found = t.nested("detail copies", lambda t, *at: sum(copies(t, *at), ()), x, y)
    for where, weight in zip(found[::2], found[1::2], strict=True):
        read = t.node("ShaderNodeTexImage", image=image, interpolation="Linear")
        if frames is not None:
            _play(read.image_user, frames)
        # Samples lie at multiples of a texel, which is half a texel before its middle.
        t.link(t.math("ADD", where, (0.5 / SAMPLES, 0.5 / SAMPLES, 0.0)), read.inputs["Vector"])
        slope = t.math("ADD", t.scale(read.outputs["Color"], weight), slope)
    shown = fade(t, footprint, band.shortest_wave, band.longest_wave)
    share = t.number("MULTIPLY", shown, shown)
    return t.scale(slope, shown), t.number("MULTIPLY", share, band.mean_square)


def _end_in_shallows(t: Tree, slope, variance, lost: float):
    """Returns slopes over a bed, and their mean square less that of all waves that its map lacks. A
    depth of 0 is none: far water has no such attribute."""
    depth = t.node("ShaderNodeAttribute", attribute_name="depth").outputs["Fac"]
    is_open = t.number("LESS_THAN", t.number("ABSOLUTE", depth), 1e-5)
    share = t.number("MAXIMUM", t.eased(0.0, _SHALLOW, depth), is_open)
    rest = t.number("MULTIPLY", t.number("SUBTRACT", variance, lost), share)
    return t.scale(slope, t.number("SQRT", share)), rest


# The group of a sea -------------------------------------------------------------


def _owned(blocks, owner: str) -> list:
    """Returns the blocks of the object with that full name."""
    return [block for block in blocks if block.get(MARK) == owner and block.library is None]


def _group(owner: str):
    for group in _owned(bpy.data.node_groups, owner):
        return group
    group = bpy.data.node_groups.new(GROUP, "ShaderNodeTree")
    group[MARK] = owner
    compat.add_socket(
        group,
        "Pixel Angle",
        "NodeSocketFloat",
        default_value=pixel_angle.DEFAULT,
        min_value=0.0,
        description="Of a pixel of the picture, in radians: waves as short as it become roughness",
    )
    compat.add_socket(group, SOCKET, "NodeSocketVector", output=True)
    return group


def _read_by(group) -> set:
    """The images of a group."""
    return {node.image for node in group.nodes if node.type == "TEX_IMAGE"} - {None}


def _empty(group) -> set:
    """Removes all nodes of a group. Returns the images that it had."""
    before = _read_by(group)
    inner = {node.node_tree for node in group.nodes if node.type == "GROUP"}
    group.nodes.clear()
    for tree in inner:
        if tree.users == 0:
            bpy.data.node_groups.remove(tree)
    return before


def _is_made_of(group, made_of: str, shown) -> bool:
    return group.get(_MADE_OF) == made_of and _read_by(group) == set(shown)


def _remove_unused_sequences(found) -> None:
    for image in found:
        if image.source == "SEQUENCE" and image.users == 0:
            bpy.data.images.remove(image)


def _build(
    group,
    made_of: str,
    bands: list[Band],
    shown,
    frames: tuple[int, int] | None = None,
    *,
    lost: float | None,
) -> None:
    """Makes the group anew. shown: the images of the bands; frames: the frames that have files,
    where images are sequences; lost: over a bed the mean square slope that the map lacks."""
    before = _empty(group)
    t = Tree(group)
    inputs = t.node("NodeGroupInput").outputs
    place = water_shader.place(t)
    footprint = water_shader.footprint(t, inputs["Pixel Angle"])
    slope, variance = (0.0, 0.0, 0.0), 0.0
    for band, image in zip(bands, shown, strict=True):
        more, its_variance = _band(t, place, footprint, band, image, frames)
        slope, variance = t.math("ADD", more, slope), t.number("ADD", its_variance, variance)
    if lost is not None:
        slope, variance = _end_in_shallows(t, slope, variance, lost)
    result = t.math("MULTIPLY_ADD", slope, (1.0, 1.0, 0.0), t.vector(0.0, 0.0, variance))
    t.link(result, t.node("NodeGroupOutput").inputs[SOCKET])
    t.arrange(rows=5)
    group[_MADE_OF] = made_of
    _remove_unused_sequences(before)


def is_detail(node) -> bool:
    """Returns whether a node of a material is one of these groups."""
    return node.type == "GROUP" and node.node_tree is not None and MARK in node.node_tree


def waters(ob) -> list[tuple]:
    """Returns the waters of an object's materials that can show it, node tree and node: the socket
    is free, or holds the detail of this sea or of a deleted one. A linked object has none."""
    found = []
    for slot in ob.material_slots if ob.library is None else ():
        made = slot.material
        if made is None or made.library is not None or made.node_tree is None:
            continue
        for node in made.node_tree.nodes:
            if not water_shader.is_water(node) or SOCKET not in node.inputs:
                continue
            links = node.inputs[SOCKET].links
            before = links[0].from_node if links else None
            if before is not None:
                if not is_detail(before):
                    continue
                owner = before.node_tree[MARK]
                if owner != ob.name_full and owner in bpy.data.objects:
                    continue
            found.append((made.node_tree, node))
    return found


def _attach(waters, group) -> None:
    for tree, water in waters:
        links = water.inputs[SOCKET].links
        if links:
            if links[0].from_node.node_tree != group:
                links[0].from_node.node_tree = group
            continue
        node = tree.nodes.new("ShaderNodeGroup")
        node.node_tree = group
        node.location = (water.location[0] - 260, water.location[1] - 200)
        of_node, of_water = node.inputs["Pixel Angle"], water.inputs["Pixel Angle"]
        of_node.default_value = of_water.default_value
        if of_water.is_linked:
            tree.links.new(of_water.links[0].from_socket, of_node)
        tree.links.new(node.outputs[SOCKET], water.inputs[SOCKET])


def clear(ob) -> None:
    """Empties the object's group: files of the same names may be others now."""
    for group in _owned(bpy.data.node_groups, ob.name_full):
        _remove_unused_sequences(_empty(group))


def leave(owner: str) -> None:
    """Shows the sea of the object with that full name without near detail."""
    for group in _owned(bpy.data.node_groups, owner):
        for made in bpy.data.materials:
            tree = made.node_tree if made.library is None else None
            for node in list(tree.nodes) if tree else ():
                if node.type == "GROUP" and node.node_tree == group:
                    tree.nodes.remove(node)
        played = _empty(group)
        bpy.data.node_groups.remove(group)
        _remove_unused_sequences(played)
    for image in _owned(bpy.data.images, owner):
        bpy.data.images.remove(image)


def _images(owner: str, name: str, count: int) -> list:
    """Returns an image for each of `count` bands of the object with that full name and name."""
    there = sorted(_owned(bpy.data.images, owner), key=lambda image: image.name)
    while len(there) < count:
        field = f"detail {len(there) + 1}"
        image = images.make(name, field, (SAMPLES, SAMPLES), (0.0, 0.0, 0.0, 0.0))
        image[MARK] = owner
        there.append(image)
    return there[:count]


def is_wanted(settings) -> bool:
    """Returns whether near detail is shown. It needs the attributes `label`, which comes with foam,
    and `slope_variance`, which comes with normals."""
    return settings.use_detail and settings.use_foam and settings.use_normal


def play(
    ob,
    bands: list[Band],
    frames: tuple[int, int],
    load: Callable[[int], bpy.types.Image | None],
    lost: float | None = None,
) -> None:
    """Shows the tiles of a bake. frames: the first and the last that have files; load: gives the
    image sequence of a band by its number, or None where there are no files; lost: as of
    _build()."""
    shown_on = waters(ob) if bands else []
    shown = [load(number) for number in range(len(bands))] if shown_on else []
    if not shown or None in shown:
        leave(ob.name_full)
        _remove_unused_sequences(set(shown) - {None})
        return
    group, made_of = _group(ob.name_full), repr((bands, frames, lost))
    if not _is_made_of(group, made_of, shown):
        _build(group, made_of, bands, shown, frames, lost=lost)
        for image in _owned(bpy.data.images, ob.name_full):  # of the live sea
            bpy.data.images.remove(image)
    _attach(shown_on, group)


def follow(ob, sea, settings, at: float, size: int | None, *, over_bed: bool = False) -> None:
    """Brings the slopes of a time [s] up to date. sea: the OpenSea of the object; size: of the
    shown maps, in samples per side, None: the sea's own; over_bed: the object is the water of a
    coast."""
    shown_on = waters(ob) if is_wanted(settings) else []
    if not shown_on:
        leave(ob.name_full)
        return
    state = (sea.changes, at, size, "detail")
    group = _group(ob.name_full)
    owned = _owned(bpy.data.images, ob.name_full)
    if owned and all(sea.shown.get(image.name_full) == state for image in owned):
        _attach(shown_on, group)
        return
    with sea.lock:
        found = sea.handle.detail(at, size, samples=SAMPLES)
        shown = _images(ob.name_full, ob.name, len(found.bands))
        if sea.detail_pixels is None:  # as much time goes into new memory as into the slopes
            sea.detail_pixels = images.aligned((SAMPLES, SAMPLES))
        for image, band in zip(shown, found.bands, strict=True):
            images.let_go(image)
            sea.detail_pixels[..., :2] = band.slope
            images.fill(image, sea.detail_pixels)
            image.update()  # without it Eevee without a window keeps the old image
    for image in {*owned, *shown}:
        sea.shown[image.name_full] = state
    # The group is built once for these waves: mean_square, which is the frame's, is left out.
    lost = lost_slopes(found) if over_bed else None
    made_of = repr(([tuple(band)[1:7] for band in found.bands], lost))
    if not _is_made_of(group, made_of, shown):
        _build(group, made_of, [band_of(band) for band in found.bands], shown, lost=lost)
    _attach(shown_on, group)
