# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cutting the water out of hulls: the inputs of the node group, and the switch of the material.

hulls with an object and an outline -> hull_nodes.py -> attributes -> Ocean Water
"""

from __future__ import annotations

from ..look import water_shader
from ..shared import compat, images, meshes, modifier_groups
from . import hull_nodes, hull_outline

_NONE = (0.0, 0.0, 0.0, 0.0)


def _cut(settings) -> list[tuple]:
    """Returns pairs of object and outline."""
    if not settings.use_hull_cut:
        return []
    found = []
    for hull in settings.hulls:
        outline = hull_outline.read(hull.outline)
        if outline is not None and meshes.is_there(hull.source):
            found.append((hull.source, outline))
    return found[: hull_nodes.COUNT]


def follow(picture) -> None:
    """Brings the inputs in line with the hulls of a picture's sea."""
    ob, modifier, shown = picture.ob, picture.modifier, picture.opened.shown
    found = _cut(ob.libocean)
    values = dict.fromkeys(hull_nodes.object_inputs()[len(found) :])
    for number, (source, outline) in enumerate(found):
        name = hull_nodes.outline_input(number)
        image = modifier_groups.image(modifier, name, ob.name, _NONE)
        if shown.get(image.name_full) != outline:
            images.let_go(image)
            pixels = outline.pixels()
            images.resize(image, pixels.shape[:2])
            images.fill(image, pixels)
            shown[image.name_full] = outline
        values |= {
            hull_nodes.object_input(number): source,
            hull_nodes.begin_input(number): outline.begin,
            hull_nodes.size_input(number): outline.size,
        }
    modifier_groups.assign(modifier, {**values, hull_nodes.NUMBER: float(len(found))})
    if found:
        _cut_materials(ob)


def _cut_materials(ob) -> None:
    """Has the waters of an object's materials show nothing inside hulls."""
    for slot in ob.material_slots:
        made = slot.material
        if made is None or made.library is not None or made.node_tree is None:
            continue
        for water in water_shader.waters(made.node_tree):
            socket = water.inputs.get(water_shader.HULL_CUT)  # it may be of an earlier version
            if socket is not None and socket.default_value != 1.0:
                socket.default_value = 1.0
                compat.cut_in_eevee(made)
