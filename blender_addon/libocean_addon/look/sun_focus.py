# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""God rays: the sun's light below the surface, gathered by the waves as caustics are.

    map of the frame -> rays, refracted -> light on a level plane below -> image -> Sun Focus

Blender's light goes straight on through the surface (water_shader): where it comes through it has
the light that the plane has in its way. So shafts stand in the water, in the same way at each
depth, and at the plane's they are right. The image is of one period of the sea and lies in the
world, as the sea does that follows it. The library has the same, exact, for `ocean bake
--products caustics`; but not for an add-on to call.
"""

from __future__ import annotations

import math

import numpy as np

from ..sea import atlas
from ..shared import images
from ..shared.shader_builder import Tree
from .water_shader import waters

SOCKET = "Sun Focus"
MARK = "libocean_sun_focus"  # custom property of nodes: their part; of an image: its object's name
_DEPTH = "libocean_depth"  # custom property of the node that reads the image: metres
DEPTH = 10.0

SAMPLES = 1024
"""A side of the image."""
_RAYS = 2  # along each side of a cell of the image
_IOR = 1.333
_LEAST_DESCENT = 0.2  # of a refracted ray: folds alone would send one flatter

# The light of a level plane -------------------------------------------------------


def _slope_of(field: np.ndarray, axis: int) -> np.ndarray:
    """From sample to sample, of a periodic map."""
    return np.float32(0.5) * (np.roll(field, -1, axis) - np.roll(field, 1, axis))


def focus(displacement, normal, period: float, depth: float, sun, samples: int) -> np.ndarray:
    """Light of a plane so deep over what it has below flat water, (samples, samples), a sample in
    the middle of its cell. displacement, normal: maps (n, n, >= 3) of one period; sun: towards it,
    a unit vector. Each sample of the maps sends a ray, refracted, with the light of its area as the
    sun sees it; four cells of half the size share it."""
    side, fine = len(displacement), 2 * samples
    dx, dy, z = (np.ascontiguousarray(displacement[..., axis]) for axis in range(3))
    n = [np.ascontiguousarray(normal[..., axis]) for axis in range(3)]
    light = [-float(part) for part in sun]
    along = np.arange(side, dtype=np.float32)
    per_metre = side / period

    # Where the ray passes the mean level, and the area that this makes of a cell.
    x, y = (offset * per_metre for offset in (dx, dy))
    rise = z * (per_metre / light[2])
    at_x, at_y = x - light[0] * rise, y - light[1] * rise
    area = (1.0 + _slope_of(at_x, 1)) * (1.0 + _slope_of(at_y, 0))
    area -= _slope_of(at_x, 0) * _slope_of(at_y, 1)

    r = 1.0 / _IOR
    c = np.clip(-sum(a * b for a, b in zip(light, n, strict=True)), 0.0, 1.0)
    bend = r * c - np.sqrt(1.0 - r * r * (1.0 - c * c))
    descent = np.maximum(_LEAST_DESCENT, -(r * light[2] + bend * n[2]))
    fall = np.maximum(0.0, depth + z) / descent * per_metre
    x += along[None, :] + (r * light[0] + bend * n[0]) * fall
    y += along[:, None] + (r * light[1] + bend * n[1]) * fall

    x, y = (place.ravel() * (fine / side) + 0.5 for place in (x, y))
    left, low = np.floor(x), np.floor(y)
    x, y = x - left, y - low
    left, low = left.astype(np.int32) % fine, low.astype(np.int32) % fine
    right, high = (left + 1) % fine, (low + 1) % fine
    # Water seen from behind lies in the shadow of the water that has its light.
    area = np.maximum(area, 0.0).ravel()
    lit = np.zeros(fine * fine)
    for column, row, share in (
        (left, low, (1.0 - x) * (1.0 - y)),
        (right, low, x * (1.0 - y)),
        (left, high, (1.0 - x) * y),
        (right, high, x * y),
    ):
        lit += np.bincount(row * fine + column, share * area, fine * fine)
    lit = lit.reshape(samples, 2, samples, 2).mean(axis=(1, 3))
    return (lit / lit.mean()).astype(np.float32)


# In a material ---------------------------------------------------------------------


def _reader(water):
    """Returns the node that reads the image for a water; None for a water without god rays."""
    links = water.inputs[SOCKET].links if SOCKET in water.inputs else ()
    node = links[0].from_node if links else None
    return node if node is not None and _DEPTH in node else None


def add(made, depth: float) -> None:
    """God rays for the water of a material, of this depth. Its image comes with the sea."""
    t = Tree(made.node_tree)
    for water in waters(made.node_tree):
        position = t.node("ShaderNodeNewGeometry")
        place = t.node("ShaderNodeVectorMath", operation="MULTIPLY_ADD")
        t.link(position.outputs["Position"], place.inputs[0])
        image = t.node("ShaderNodeTexImage", interpolation="Linear")
        t.link(place.outputs["Vector"], image.inputs["Vector"])
        t.link(image.outputs["Color"], water.inputs[SOCKET])
        image[_DEPTH] = depth
        for number, node in enumerate((position, place, image)):
            node[MARK] = True
            node.location = (water.location[0] - 780 + 220 * number, water.location[1] + 300)


def _image(owner: str, name: str, before):
    """Returns the image of the object with that full name and name: `before`, if it is that."""
    if before is not None and before.get(MARK) == owner:
        return before
    made = images.make(name, "sun focus", (SAMPLES, SAMPLES), (1.0, 1.0, 1.0, 1.0))
    made[MARK] = owner
    return made


def _sun(water) -> tuple[float, float, float]:
    """Returns the direction to the sun; without a sun, or with one below the horizon, the direction
    at noon."""
    sun = tuple(water.inputs["Sun Direction"].default_value)
    length = math.hypot(*sun)
    if length < 1e-6 or sun[2] < math.sin(math.radians(5.0)) * length:
        return (0.0, 0.0, 1.0)
    return tuple(part / length for part in sun)


def follow(shown, at: float) -> None:
    """Brings the image of a material up to date with a time of a sea [s]. shown: the object as it
    was looked up."""
    ob, sea = shown.ob, shown.opened
    made = ob.material_slots[0].material if ob.material_slots else None
    if made is None or made.library is not None or made.node_tree is None:
        return
    for water in waters(made.node_tree):
        node = _reader(water)
        if node is None:
            continue
        sun, depth = _sun(water), float(node[_DEPTH])
        image = _image(ob.name_full, ob.name, node.image)
        state = (sea.changes, at, depth, sun)
        if node.image == image and sea.shown.get(image.name_full) == state:
            continue
        _fill(image, sea, at, depth, sun)
        node.image = image
        period = float(sea.values.values["patch_size"])
        place = node.inputs["Vector"].links[0].from_node
        place.inputs[1].default_value = (1.0 / period, 1.0 / period, 0.0)
        # Straight on, light comes to the plane from here.
        place.inputs[2].default_value = tuple(
            0.5 / SAMPLES - depth * part / sun[2] / period for part in (sun[0], sun[1], sun[2])
        )
        sea.shown[image.name_full] = state


def _fill(image, sea, at: float, depth: float, sun) -> None:
    """Fills the image with the light on the plane, and packs it, for renders without the add-on."""
    side = SAMPLES * _RAYS
    displacement, normal = (np.empty((side, side, 4), np.float32) for _ in range(2))
    with sea.lock:
        period = float(sea.handle.get("patch_size"))
        maps = (displacement, ("dx", "dy", "height", "height")), (normal, atlas.FINEST["Normal"])
        sea.handle.fill(at, maps)
    lit = focus(displacement, normal, period, depth, sun, SAMPLES)
    images.let_go(image)
    pixels = np.ones((SAMPLES, SAMPLES, 4), np.float32)
    pixels[..., :3] = lit[..., None]
    images.fill(image, pixels)
    image.pack()
    image.update()
