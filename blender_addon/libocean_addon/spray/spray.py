# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spray of an ocean: the library's particles as points beside its mesh.

    sea.spray(time) -> the period's copies over the mesh -> vertices of a carrier -> points

Spray of a sea with hulls is that of the region around the mesh, which has no copies. The carrier is
an object in no scene that the modifier of spray_nodes shows. What it holds is of one moment: it is
empty in a saved file.
"""

from __future__ import annotations

import contextlib

import bpy
import numpy as np

from ..sea import live, messages
from ..sea.open_sea import OpenSea, sea_of
from ..shared import changes, compat, console, drafts, modifier_groups
from ..shared.compat import tr_label
from ..shared.native import libocean
from . import spray_nodes

LEAST_WIND = 7.0
"""m/s; the library has no spray in weaker ones."""

_COLUMN = {"FLOAT": "value", "FLOAT_VECTOR": "vector", "INT": "value"}


# Where the particles are ----------------------------------------------------------


def _around(turn: np.ndarray, origin, centre, half) -> tuple[np.ndarray, np.ndarray]:
    """Returns middle and half sides of the rectangle of the sea around a region of an object, with
    arguments as those of over_region()."""
    return (turn[:, :2] @ centre)[:2] + origin[:2], np.abs(turn[:2, :2]) @ half


def sea_region(lie: tuple, period: float) -> tuple[float, ...]:
    """Returns the corners x0, y0, x1, y1 of the sea's region around an object. They lie on quarters
    of a period: each region has particles of its own, and those of a moving object should last.
    lie: the last arguments of over_region()."""
    middle, reach = _around(*lie)
    quarter = period / 4.0
    low = np.floor((middle - reach) / quarter + 1e-6)
    high = np.ceil((middle + reach) / quarter - 1e-6)
    return tuple((quarter * np.concatenate([low, high])).tolist())


def over_region(
    position: np.ndarray, period: float, turn: np.ndarray, origin, centre, half
) -> tuple[np.ndarray, np.ndarray]:
    """The rows of position, (n, 3) in the sea's axes, whose copies a period on lie over a region of
    an object, and where these are in its own axes. turn, origin: the object's in the sea, so that a
    place p of its own is turn p + origin there. centre, half: of the region, along its x and y."""
    middle, reach = _around(turn, origin, centre, half)
    low = middle - period / 2.0
    first = position - origin
    first[:, :2] = low + np.mod(position[:, :2] - low, period) - origin[:2]
    copies = np.maximum(np.ceil(reach / period - 0.5 - 1e-9), 0).astype(int)
    rows, places = [], []
    for i in range(-copies[0], copies[0] + 1):
        for j in range(-copies[1], copies[1] + 1):
            place = (first + (i * period, j * period, 0.0)) @ turn
            along = place[:, :2] - centre
            (found,) = np.nonzero(((along >= -half) & (along < half)).all(axis=1))
            rows.append(found)
            places.append(place[found])
    return np.concatenate(rows), np.concatenate(places)


def _region(ob, seen, camera, period: float) -> tuple[np.ndarray, np.ndarray]:
    """Middle and half sides of what spray is shown over, in the object's own axes: of its mesh,
    around the camera of a period of a horizon."""
    one = np.full(2, period / 2.0)
    if ob.libocean.kind == "PATCH":
        return np.zeros(2), one
    if ob.libocean.kind == "HORIZON":
        if camera is None:
            return np.zeros(2), one
        place = seen.matrix_world.inverted_safe() @ camera.matrix_world.translation
        return np.array(place.xy, float), one
    if ob.type == "MESH" and len(ob.data.vertices) > 0:
        corners = np.empty(3 * len(ob.data.vertices), np.float32)
        ob.data.vertices.foreach_get("co", corners)
    else:
        corners = np.array(seen.bound_box, float)
    xy = corners.reshape(-1, 3)[:, :2].astype(float)
    low, high = xy.min(axis=0), xy.max(axis=0)
    return (low + high) / 2.0, (high - low) / 2.0


def _lie(settings, seen) -> tuple[np.ndarray, np.ndarray]:
    """Returns the turn and the origin of an object in the sea, as its node group has them."""
    if not settings.follow_world:
        return np.eye(3), np.zeros(3)
    matrix = seen.matrix_world
    x, y, _ = matrix.translation
    return np.array(matrix.to_euler("XYZ").to_matrix(), float), np.array([x, y, 0.0])


# The carrier ----------------------------------------------------------------------


def _carrier(modifier):
    """The object whose vertices the modifier shows, which may be another file's."""
    identifier = compat.input_identifiers(modifier.node_group)["Points"]
    return compat.get_input(modifier, identifier)


def _new_carrier(ob, modifier):
    name = f".{ob.name} spray"
    carrier = bpy.data.objects.new(name, bpy.data.meshes.new(name))
    modifier_groups.assign(modifier, {"Points": carrier})
    modifier.node_group = modifier.node_group  # has Blender read its inputs again
    return carrier


def _fill(mesh, place: np.ndarray, attributes: dict[str, np.ndarray]) -> None:
    mesh.clear_geometry()
    mesh.vertices.add(len(place))
    mesh.vertices.foreach_set("co", place.astype(np.float32).ravel())
    for name, values in attributes.items():
        kind = spray_nodes.ATTRIBUTES[name]
        made = mesh.attributes.new(name, kind, "POINT")
        made.data.foreach_set(_COLUMN[kind], np.ascontiguousarray(values).ravel())
    mesh.update()


def _empty(ob, modifier) -> None:
    carrier = _carrier(modifier)
    if carrier is None or carrier.library is not None:
        return
    sea_of(ob.name_full).shown.pop(carrier.name_full, None)
    if len(carrier.data.vertices) > 0:
        _fill(carrier.data, np.empty((0, 3)), {})


def _remove(ob, modifier) -> None:
    if ob.library is not None:
        return
    carrier = _carrier(modifier)
    compat.let_go(modifier, compat.input_identifiers(modifier.node_group)["Points"])
    ob.modifiers.remove(modifier)
    if carrier is not None and carrier.library is None and carrier.users == 0:
        mesh = carrier.data
        bpy.data.objects.remove(carrier)
        bpy.data.meshes.remove(mesh)


# Every frame ----------------------------------------------------------------------


def _follow_baked(ob, sea: OpenSea, moment) -> None:
    """Gives the sea its parameters while a bake plays; otherwise live.show does."""
    if ob.libocean.use_bake:
        with contextlib.suppress(libocean.Error):
            sea.follow(live.current_values(ob.libocean, moment.scene))


def _show(ob, modifier, depsgraph, moment) -> None:
    """Fills the carrier of an object with the particles alive at a moment."""
    carrier, sea = _carrier(modifier), sea_of(ob.name_full)
    if carrier is None or carrier.library is not None:
        carrier = _new_carrier(ob, modifier)
    _follow_baked(ob, sea, moment)
    if sea.handle is None:
        _empty(ob, modifier)
        return
    camera = moment.scene.camera
    seen = ob.evaluated_get(depsgraph) if depsgraph else ob
    if camera is not None and depsgraph:
        camera = camera.evaluated_get(depsgraph)
    settings, wanted = seen.libocean, live.spray_settings(seen.libocean)
    at = live.time_of(moment, settings, sea)
    period = float(sea.values.values["patch_size"])
    lie = (*_lie(settings, seen), *_region(ob, seen, camera, period))
    if sea.values.hulls and not ob.libocean.use_bake:  # a bake has no wakes
        wanted = {**wanted, "region": sea_region(lie, period)}
        x0, y0, x1, y1 = wanted["region"]
        period = 2.0 * max(x1 - x0, y1 - y0)  # so that no particle has a copy
    sea.spray_wanted = wanted
    may_wait = moment.moving or (moment.is_redraw and drafts.is_draft(ob.name_full))
    if may_wait and not ob.libocean.use_bake and not sea.is_spray_ready(at, wanted):
        _empty(ob, modifier)
        key = (sea.changes, at, live.map_sizes(settings, sea)[0], live.channel_of(settings))
        drafts.ask(ob.name_full, key, rest=not drafts.is_playing())
        return
    placed = b"".join(part.tobytes() for part in lie)
    state = (sea.changes, at, *wanted.values(), settings.spray_size, placed)
    if sea.shown.get(carrier.name_full) == state:
        return
    with console.work(ob.name_full, "spray"):
        spray = sea.spray(at, wanted)
    rows, place = over_region(spray.position, period, *lie)
    low_bits = (spray.id[rows] & 0xFFFFFFFF).astype(np.uint32)
    _fill(
        carrier.data,
        place,
        {
            "velocity": (spray.velocity[rows] @ lie[0]).astype(np.float32),
            "age": spray.age[rows],
            "life": spray.life[rows],
            "radius": spray.radius[rows] * np.float32(settings.spray_size),
            "id": low_bits.view(np.int32),
        },
    )
    sea.shown[carrier.name_full] = state


def _modifier(ob):
    """Returns the modifier of an object that has spray, made if it is missing; None for a linked
    object."""
    modifier = spray_nodes.modifier_of(ob)
    if modifier is None and ob.library is None:
        if ob.libocean.spray_material is None:
            with changes.quiet():
                ob.libocean.spray_material = spray_nodes.material()
        modifier = ob.modifiers.new("Spray", "NODES")
        modifier.node_group = spray_nodes.get()
        modifier.show_expanded = False
    return modifier


def _own_carriers(oceans: list) -> None:
    """Gives the copy of an object points of its own."""
    owners = {}
    for ob in oceans:
        modifier = spray_nodes.modifier_of(ob)
        carrier = None if modifier is None else _carrier(modifier)
        if carrier is not None and owners.setdefault(carrier.name_full, ob) != ob:
            _new_carrier(ob, modifier)


def show_all(depsgraph, moment) -> None:
    """Brings the spray of every ocean up to date, and removes spray that is switched off."""
    oceans = [ob for ob in live.ocean_objects() if ob.libocean.use_spray]
    for ob in spray_nodes.users().difference(oceans):
        _remove(ob, spray_nodes.modifier_of(ob))
    _own_carriers(oceans)
    for ob in oceans:
        modifier = _modifier(ob)
        if modifier is None:
            continue
        spheres = not compat.draws_points(moment.scene)
        inputs = {"Material": ob.libocean.spray_material, spray_nodes.SPHERES: spheres}
        modifier_groups.assign(modifier, inputs)
        problem = ""
        try:
            _show(ob, modifier, depsgraph, moment)
        except (libocean.Error, MemoryError) as failure:
            problem = messages.of_error(failure, len(ob.libocean.waves))
            _empty(ob, modifier)
        if ob.libocean.spray_problem != problem:
            ob.libocean.spray_problem = problem


def empty_all() -> None:
    """Empties all spray before a file is saved: without the add-on its points would stand still."""
    for ob in spray_nodes.users():
        _empty(ob, spray_nodes.modifier_of(ob))


# Lines of the panel ---------------------------------------------------------------


def _is_calm(values) -> bool:
    winds = [float(system.values.get("wind_speed") or 0.0) for system in values.waves]
    return not values.take and max(winds) <= LEAST_WIND


def state_of(ob) -> tuple[str, str]:
    """Returns a sentence on the spray of an ocean, and its icon."""
    modifier, sea = spray_nodes.modifier_of(ob), sea_of(ob.name_full)
    if ob.libocean.spray_problem:
        return ob.libocean.spray_problem, "ERROR"
    if modifier is None or sea.handle is None or drafts.progress(ob.name_full) is not None:
        return "", "NONE"
    count = len(_carrier(modifier).data.vertices)
    if count > 0:
        half = float(sea.values.values["loop_period"]) / 2.0
        if 0.0 < half < ob.libocean.spray_lifetime:
            return tr_label("{:,} points, max age {:.3g} s: half of the loop", count, half), "INFO"
        return tr_label("{:,} points", count), "NONE"
    if _is_calm(sea.values):
        return tr_label("There is no spray: it needs a wind above 7 m/s"), "INFO"
    return tr_label("There is no spray at this time"), "INFO"
