# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The node group of the land of a coast: it reads from an image how wet the waves have left the
ground, as the attribute `shore_wetness`; `wetness` is a mask of the streams of a terrain.
"""

from __future__ import annotations

from ..shared import compat, field_nodes, modifier_groups
from ..shared.modifier_groups import Family
from ..shared.node_builder import Builder
from .node_group import (
    WETNESS,
    LiveFields,
    PlayedFields,
    declare_frames,
    declare_place,
)

FAMILY = Family("libocean_coast_land", 1)
ATTRIBUTE = "shore_wetness"


def _build(group, *, baked: bool) -> None:
    compat.add_socket(group, "Geometry", "NodeSocketGeometry")
    compat.add_socket(group, WETNESS, "NodeSocketImage")
    declare_place(group)
    if baked:
        declare_frames(group)
    compat.add_socket(group, "Geometry", "NodeSocketGeometry", output=True)
    compat.hide_inputs(group)
    b = Builder(group)
    inputs = b.node("NodeGroupInput").outputs
    fields = PlayedFields(b, inputs) if baked else LiveFields(b, inputs)
    place = field_nodes.place_in_map(b, field_nodes.Turn(b, None), inputs)
    geometry, _, (wetness, *_) = fields.captured(inputs["Geometry"], WETNESS, place, "Linear")
    stored = b.store(geometry, ATTRIBUTE, "FLOAT", wetness)
    b.link(stored, b.node("NodeGroupOutput").inputs[0])
    b.arrange(rows=4, height=240)


def get(*, baked: bool = False):
    """Returns the group, made if it is missing. baked: one that plays a bake."""
    name = f".libocean.coast_land.v1{' baked' if baked else ''}"
    return FAMILY.get(name, lambda group: _build(group, baked=baked), baked=baked)


def modifier_of(land):
    """Returns the modifier of a land that wets it; None without one."""
    return next(iter(FAMILY.modifiers(land)), None)


def require(land):
    """Returns the modifier of a land that wets it, made if it is missing."""
    return modifier_of(land) or modifier_groups.add(land, "Wetness", get)


def follow(land, extent) -> None:
    """Has the ground be as wet as the image says. extent: the samples that the image holds; None:
    none, and the ground is dry."""
    modifier = modifier_of(land)
    if modifier is not None and extent is None:
        land.modifiers.remove(modifier)
    elif modifier is not None:
        modifier_groups.assign(modifier, extent.inputs())
