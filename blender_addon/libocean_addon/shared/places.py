# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Places of the world as the labels that a water has there."""

from __future__ import annotations

import math

from mathutils import Matrix


def to_labels(ob, *, in_world: bool) -> tuple[Matrix, Matrix]:
    """Returns the matrix from places of the world to labels of the water that an object shows, and
    the turn (3 x 3) from the axes of the labels to those of the world. in_world: the water lies in
    the world, however the object lies in it."""
    to_world = ob.matrix_world
    turn = to_world.to_3x3().normalized()
    own = to_world.inverted_safe()
    if not in_world:
        return own, turn
    return Matrix.Translation(to_world.translation) @ turn.to_4x4() @ own, Matrix.Identity(3)


def heading(rotation: Matrix) -> float:
    """Returns the degrees counter-clockwise from +x of the own x axis."""
    forward = rotation.col[0]
    return math.degrees(math.atan2(forward[1], forward[0]))
