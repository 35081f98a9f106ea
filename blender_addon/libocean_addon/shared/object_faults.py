# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of an object that change what it shows unseen: its scale, and a mask that it lacks."""

from __future__ import annotations

_EVEN = 1e-4  # of scales that are meant to be one


def uniform_scale(ob) -> float | None:
    """Returns the factor by which an object is larger than its data, 1.0 if it is meant to be one;
    None if its sides are scaled unevenly."""
    scale = [abs(part) for part in ob.matrix_world.to_scale()]
    if max(scale) - min(scale) > _EVEN * max(scale):
        return None
    return scale[0] if abs(scale[0] - 1.0) > _EVEN else 1.0


def lacks_mask(ob, seen, mask: str) -> bool:
    """Returns whether a mask is neither a vertex group nor an attribute. seen: the object,
    evaluated."""
    if not mask or mask in ob.vertex_groups:
        return False
    meshes_of = [data for data in (ob.data, seen.data) if hasattr(data, "attributes")]
    return not any(mask in data.attributes for data in meshes_of)
