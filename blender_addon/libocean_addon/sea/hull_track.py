# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The hull and the track of an object: its size below the water, and where its animation takes it.

frames of the scene, half a second apart -> middle of the bounding box -> rows time, x, y
"""

from __future__ import annotations

import dataclasses
import hashlib
import json
import math

import bpy
import numpy as np
from mathutils import Matrix, Vector

from ..floating import riding
from ..shared import compat, life, places
from ..shared.compat import tr
from ..shared.failures import NotShownError
from . import hull_outline, live

_STEP = 0.5
"""The time between the rows of a track [s]."""
_LEAST_ROWS = 16
_MOVES = 0.1  # [m]: less is no motion
_SLOW = 0.2  # [m/s]: a hull that begins so has no wake behind it
_AFTER = 5.0  # [s] for which a hull goes on after the last frame


@dataclasses.dataclass(frozen=True)
class Size:
    """The part of an object below the water [m]."""

    length: float
    beam: float
    draught: float


@dataclasses.dataclass(frozen=True)
class Track:
    rows: list[tuple[float, float, float]]
    """Time [s], x and y in the sea [m]."""
    slowest: float
    """Of the legs between two frames [m/s]."""
    fastest: float
    is_sideways: bool
    """True if the object mostly moves across its longer side."""

    def lines(self) -> str:
        """Returns the rows as a sea file has them."""
        rows = "".join(f"    [{t:.6g}, {x:.4f}, {y:.4f}],\n" for t, x, y in self.rows)
        return f"track = [\n{rows}]\n"


# Size -------------------------------------------------------------------------------


def _mesh(ob, depsgraph, still: Matrix) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns the vertices of an object in the world, and the ends of its edges and the corners of
    its triangles by their numbers. still: what takes it off the waves."""
    seen = ob.evaluated_get(depsgraph)
    mesh = seen.to_mesh()
    points = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", points)
    edges = np.empty(2 * len(mesh.edges), np.int32)
    mesh.edges.foreach_get("vertices", edges)
    mesh.calc_loop_triangles()
    triangles = np.empty(3 * len(mesh.loop_triangles), np.int32)
    mesh.loop_triangles.foreach_get("vertices", triangles)
    seen.to_mesh_clear()
    matrix = np.array(still @ seen.matrix_world)
    points = points.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]
    return points, edges.reshape(-1, 2), triangles.reshape(-1, 3)


def _below(points: np.ndarray, edges: np.ndarray, level: float) -> np.ndarray:
    """Returns the vertices below a level, and the points where edges cross it, (n, 3)."""
    first, last = (points[ends] for ends in edges.T)
    over = first[:, 2] - level, last[:, 2] - level
    crosses = over[0] * over[1] < 0.0
    first, last, high, low = (ends[crosses] for ends in (first, last, *over))
    crossings = first + (high / (high - low))[:, None] * (last - first)
    return np.concatenate([points[points[:, 2] <= level], crossings])


def _meshes(ob) -> list:
    return [one for one in (ob, *ob.children_recursive) if one.type == "MESH"]


def own_place(ob, depsgraph) -> Matrix:
    """Returns where an object is in the world, without waves."""
    seen, motion = ob.evaluated_get(depsgraph), ob.libocean_float.motion
    if motion is None:
        return seen.matrix_world.copy()
    return riding.own_place(ob, seen, motion.evaluated_get(depsgraph))


def _turned(points: np.ndarray, angle: float) -> np.ndarray:
    """Returns points in axes that are turned by an angle."""
    c, s = math.cos(angle), math.sin(angle)
    return points[:, :2] @ np.array([[c, -s], [s, c]])


def measure(ob, ocean, depsgraph) -> tuple[Size, Vector, bool]:
    """Returns the size of an object below the water, its middle in its own axes, and whether the
    longer side lies along its y axis. Raises NotShownError."""
    level = ocean.matrix_world.translation.z
    parts = _meshes(ob)
    if not parts:
        raise NotShownError(tr("{} has no mesh, from which its size would follow", ob.name))
    own = own_place(ob, depsgraph)
    still = _still(ob, own, depsgraph)
    found = (_mesh(part, depsgraph, still)[:2] for part in parts)
    points = np.concatenate([_below(*one, level) for one in found])
    if len(points) == 0:
        raise NotShownError(tr("{} is above the water: a hull needs a part below it", ob.name))
    sides = np.ptp(_turned(points, math.radians(places.heading(own.to_3x3()))), axis=0)
    scale = ocean.matrix_world.median_scale
    draught = level - points[:, 2].min()
    size = Size(*(float(value / scale) for value in (sides.max(), sides.min(), draught)))
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
    return size, own.inverted_safe() @ Vector(middle.tolist()), bool(sides[1] > sides[0])


def _still(ob, own: Matrix, depsgraph) -> Matrix:
    """Returns what takes an object off the waves. own: own_place()."""
    return own @ ob.evaluated_get(depsgraph).matrix_world.inverted_safe()


def outline(ob, ocean, depsgraph) -> str:
    """Returns the text of the outline of an object; "" where it does not cross still water."""
    level = ocean.matrix_world.translation.z
    own = own_place(ob, depsgraph)
    still, found = _still(ob, own, depsgraph), []
    for part in _meshes(ob):
        points, _, triangles = _mesh(part, depsgraph, still)
        found.append(points[triangles])
    origin, turn = np.array(own.translation), np.array(own.to_3x3().normalized())
    scale = ocean.matrix_world.median_scale
    corners = (np.concatenate(found) - origin) @ turn / scale
    made = hull_outline.of_triangles(corners, float(level - origin[2]) / scale)
    return "" if made is None else made.text()


# Track ------------------------------------------------------------------------------


def _sea_place(ocean, place: Vector) -> tuple[float, float]:
    """Returns x and y in the sea of a place in the world [m]."""
    labels, _ = places.to_labels(ocean, in_world=ocean.libocean.follow_world)
    return tuple((labels @ Vector((*place.xy, ocean.matrix_world.translation.z))).xy)


def frames_of(ob, scene) -> list[int]:
    """Returns the frames at which a track has its rows: of the scene's range, and from the first
    to the last key of the object."""
    first, last = scene.frame_start, scene.frame_end
    action = ob.animation_data.action if ob.animation_data else None
    if action is not None:
        low, high = action.frame_range
        first, last = min(first, math.floor(low)), max(last, math.ceil(high))
    step = max(1, round(_STEP * live.frame_rate(scene)))
    step = max(1, min(step, (last - first) // _LEAST_ROWS))
    return [*range(first, last, step), last]


def _speeds(rows: np.ndarray) -> np.ndarray:
    legs = np.diff(rows, axis=0)
    return np.hypot(legs[:, 1], legs[:, 2]) / legs[:, 0]


def sample(ob, ocean, scene, sea, *, middle: Vector, along_y: bool) -> Track:
    """Returns the track of an object through the frames of a scene, which the scene passes. sea:
    the handle of the ocean's sea. Raises NotShownError."""
    now, part = scene.frame_current, scene.frame_subframe
    rows, headings = [], []
    try:
        with life.paused():
            for frame in frames_of(ob, scene):
                scene.frame_set(frame)
                own = own_place(ob, bpy.context.evaluated_depsgraph_get())
                rows.append((sea.time_of_frame(frame), *_sea_place(ocean, own @ middle)))
                headings.append(math.radians(places.heading(own.to_3x3())))
    finally:
        scene.frame_set(now, subframe=part)
    found = np.array(rows)
    if np.ptp(found[:, 1:], axis=0).max() < _MOVES:
        raise NotShownError(
            tr(
                "{} does not move between the frames {} and {}: animate it first",
                ob.name,
                scene.frame_start,
                scene.frame_end,
            )
        )
    speeds = _speeds(found)
    courses = np.arctan2(*np.diff(found[:, [2, 1]], axis=0).T)
    across = np.abs(np.sin(courses - np.array(headings[:-1]) - along_y * math.pi / 2.0))
    is_sideways = float((across * speeds).sum()) > 0.7 * float(speeds.sum())
    return Track(
        _continued(rows, found, speeds), float(speeds.min()), float(speeds.max()), is_sideways
    )


def _continued(rows: list, found: np.ndarray, speeds: np.ndarray) -> list:
    """Returns rows with what was before the first frame, so that the wake has developed, and what
    comes after the last one: the hull goes straight on."""
    legs = np.diff(found, axis=0)
    velocities = legs[:, 1:] / legs[:, :1]
    whole = list(rows)
    if speeds[0] > _SLOW:
        run_up = 600.0 if speeds[0] < 2.0 else 300.0
        x, y = found[0, 1:] - run_up * velocities[0]
        whole.insert(0, (rows[0][0] - run_up, float(x), float(y)))
    if speeds[-1] > _SLOW:
        x, y = found[-1, 1:] + _AFTER * velocities[-1]
        whole.append((rows[-1][0] + _AFTER, float(x), float(y)))
    return whole


# Changes of the animation -------------------------------------------------------------


def _curves(owner) -> list:
    """Returns what moves an object, or the data of a path: keys by property, or drivers."""
    data = owner.animation_data
    if data is None:
        return []
    told = []
    for curve in compat.curves_of(data):
        keys = np.empty(2 * len(curve.keyframe_points), np.float32)
        curve.keyframe_points.foreach_get("co", keys)
        ends = np.empty_like(keys)
        curve.keyframe_points.foreach_get("handle_right", ends)
        told.append((curve.data_path, curve.array_index, keys.tobytes(), ends.tobytes()))
    told += [(driver.data_path, driver.driver.expression) for driver in data.drivers]
    return told


def _movers(ob) -> list:
    """Returns the object, its parents, and what its constraints follow."""
    found, rest = [], [ob]
    while rest:
        one = rest.pop()
        if one is None or one in found or len(found) > 32:
            continue
        found.append(one)
        rest.append(one.parent)
        rest += [
            constraint.target
            for constraint in one.constraints
            if hasattr(constraint, "target") and constraint.name != riding.CONSTRAINT
        ]
    return found


def _own_values(ob) -> list[float]:
    return [round(part, 5) for part in (*ob.location, *ob.rotation_euler, *ob.scale)]


def key_of(ob, ocean, scene) -> str:
    """Returns a text that differs when the animation of an object does. It is cheap."""
    settings = ocean.libocean
    told = [
        (scene.frame_start, scene.frame_end, live.frame_rate(scene)),
        (settings.start, settings.first_frame, settings.fps, settings.follow_world),
    ]
    if not _curves(ocean):
        told.append(_own_values(ocean))
    for mover in _movers(ob):
        curves = _curves(mover)
        keyed = {curve[0] for curve in curves}
        if "location" not in keyed:
            told.append(_own_values(mover))
        told.append(curves)
        data = getattr(mover, "data", None)
        if isinstance(data, bpy.types.Curve):
            told.append(_curves(data))
    digest = hashlib.sha256(json.dumps(told, default=bytes.hex).encode())
    return digest.hexdigest()[:16]
