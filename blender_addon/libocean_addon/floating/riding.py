# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How the waves move an object that floats.

    own place (parents, constraints, paths count) -> pose of the plane below -> motion -> world

The motion is the transform of an object of its own that is in no scene, and the last constraint of
what floats multiplies it in from the left: whatever put the object where it is stays as it is, and
the own place is found again by taking the motion off.
"""

from __future__ import annotations

import math

import bpy
from mathutils import Matrix, Vector

from ..shared import places, subject
from ..shared.failures import NotReadyError, NotShownError
from ..shared.native import libocean

CONSTRAINT = "Waves (libocean)"

# Single precision holds 24 bits: Blender's products of matrices lose less than this share.
_NOISE = 2.0**-20


def is_water(ob) -> bool:
    """Returns whether things float on an object."""
    return subject.water_of(ob) is not None


def constraint_of(ob):
    """Returns the constraint by which the waves move an object; None without one."""
    motion = ob.libocean_float.motion
    if motion is None:
        return None
    return next((c for c in ob.constraints if c.type == "CHILD_OF" and c.target == motion), None)


def _new_motion(ob):
    motion = bpy.data.objects.new(f".{ob.name} waves", None)
    motion.rotation_mode = "QUATERNION"
    return motion


def _forget_delta(ob) -> None:
    """Earlier versions of the add-on moved it by its delta transform."""
    ob.delta_location = (0.0, 0.0, 0.0)
    ob.delta_rotation_euler = (0.0, 0.0, 0.0)
    ob.delta_rotation_quaternion = (1.0, 0.0, 0.0, 0.0)


def attach(ob) -> bool:
    """Puts the waves behind everything else that moves the object. Returns False for linked objects
    that were not attached in their own file."""
    settings = ob.libocean_float
    constraint = constraint_of(ob)
    if constraint is None:
        if ob.library is not None:
            return False
        if settings.version == 0:
            _forget_delta(ob)
        settings.version = 1
        settings.motion = _new_motion(ob)
        constraint = ob.constraints.new("CHILD_OF")
        constraint.name = CONSTRAINT
        constraint.target = settings.motion
        constraint.set_inverse_pending = False
        constraint.inverse_matrix = Matrix.Identity(4)
    last = len(ob.constraints) - 1
    if ob.library is None and ob.constraints[last] != constraint:
        ob.constraints.move(ob.constraints.find(constraint.name), last)
    return True


def detach(ob) -> None:
    """Releases an object from the waves: it stays where it is unless something else moves it."""
    constraint = constraint_of(ob)
    ob.libocean_float.motion = None
    if constraint is None or ob.library is not None:
        return
    place = ob.matrix_world.copy()
    ob.constraints.remove(constraint)
    if all(other.mute for other in ob.constraints):
        ob.matrix_world = place


def own_place(ob, seen, motion) -> Matrix:
    """Returns the place of a float without waves, in the world. seen, motion: evaluated
    together."""
    constraint = constraint_of(ob)
    if constraint is None or constraint.mute or constraint.influence == 0.0:
        return seen.matrix_world.copy()
    return motion.matrix_world.inverted_safe() @ seen.matrix_world


def _pose(settings, ocean, heading: float, location: Vector, moment):
    """Returns height and axes of the plane below; None where there is no sea. Raises NotShownError
    and NotReadyError."""
    to_world = ocean.matrix_world
    scale = to_world.median_scale
    if not scale > 0.0:
        return None
    water = subject.water_of(ocean)
    if water is None:
        return None
    at_rest = Vector((*location.xy, to_world.translation.z))
    labels, turn = places.to_labels(ocean, in_world=water.is_in_world(ocean))
    level = Matrix.Rotation(math.radians(heading), 3, "Z")
    body = (
        *(labels @ at_rest).xy,
        places.heading(turn.inverted() @ level),
        settings.length / scale,
        settings.width / scale,
    )
    pose = water.float_pose(ocean, body, moment)
    if pose is None:
        return None
    position, up, forward = (Vector(row[0].tolist()) for row in pose[:3])
    axes = turn @ Matrix((forward, up.cross(forward), up)).transposed()
    rest = to_world @ Vector((*(to_world.inverted() @ at_rest).xy, 0.0))
    return rest.z + scale * (turn @ Vector((0.0, 0.0, position.z))).z, axes


def _motion(place: Matrix, height: float, turn: Matrix) -> Matrix:
    """Rises by the height and turns about the place."""
    pivot = place.translation
    rise = Matrix.Translation(pivot + Vector((0.0, 0.0, height)))
    return rise @ turn.to_4x4() @ Matrix.Translation(-pivot)


def _is_same(one: Matrix, other: Matrix) -> bool:
    """Compares to the precision of Blender's matrices: a value comes back slightly different from
    Blender, and to write it again would go on forever."""
    reach = max(1.0, *(abs(x) for x in other.translation))
    return all(
        abs(a - b) <= _NOISE * (reach if column == 3 else 1.0)
        for ours, theirs in zip(one, other, strict=True)
        for column, (a, b) in enumerate(zip(ours, theirs, strict=True))
    )


def _put(motion, wanted: Matrix, place: Matrix) -> None:
    now = motion.matrix_basis
    if now == wanted or _is_same(wanted @ place.normalized(), now @ place.normalized()):
        return
    motion.matrix_basis = wanted


def ride(ob, depsgraph, moment) -> None:
    """Puts an object on the waves of this moment."""
    if not attach(ob):
        return
    settings = ob.libocean_float
    motion, ocean = settings.motion, settings.ocean
    objects = (ob, motion, ocean)
    seen, seen_motion, sea = (o.evaluated_get(depsgraph) if depsgraph else o for o in objects)
    place = own_place(ob, seen, seen_motion)
    rotation = place.to_3x3().normalized()
    heading = places.heading(rotation)
    pose, problem = None, ""
    try:
        pose = _pose(seen.libocean_float, sea, heading, place.translation, moment)
    except NotShownError as failure:
        problem = str(failure)
    except (NotReadyError, libocean.Error):  # the object stays as it is; the water says which
        return
    if settings.problem != problem:
        settings.problem = problem
    if pose is None:
        wanted = Matrix.Identity(4)
    else:
        height, axes = pose
        turn = Matrix.Identity(3)
        if settings.use_tilt:
            turn = axes @ Matrix.Rotation(math.radians(heading), 3, "Z").inverted()
        wanted = _motion(place, height, turn)
    _put(motion, wanted, place)
