# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The wakes of a sea's hulls: a handle of the sea with its hulls, and the images of their waves.

    values with hulls + time -> libocean -> float images around each hull -> wake_nodes.py
    vertices of a patch, maps of the sea -> Vertices.summed -> maps of sea and wakes

The maps of one period come from a handle without hulls: their tracks change, and its foam stays.
"""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from ..bake.baked_nodes import COVER_POWER, ON_SAMPLES
from ..shared import images, meshes, modifier_groups, paths
from ..shared.compat import tr_label
from ..shared.native import libocean
from . import wake_nodes

CHANNELS = {
    "Displacement": ("dx", "dy", "height", "trail"),
    "Velocity": ("vx", "vy", "vz", "jacobian"),
    "Normal": ("nx", "ny", "nz", ""),
}
_STILL = (0.0, 0.0, 0.0, 0.0)
_ADDED = {
    "Displacement": ("dx", "dy", "height", ""),
    "Velocity": ("vx", "vy", "vz", "jacobian"),
    "Normal": ("nx", "ny", "nz", "trail"),
}


@dataclasses.dataclass(frozen=True)
class Vertices:
    """The vertices of a patch, whose maps are sums of sea and wakes there: nodes read one image of
    each field then, as without wakes."""

    cells: int
    """Along a side."""
    cell: float
    """[m]"""
    origin: tuple[float, float]
    """The first vertex in the sea [m]."""

    def inputs(self) -> dict:
        """Returns the inputs that have the vertices read their own samples."""
        side, middle = self.cells + 1, self.cells // 2 * self.cell
        return {
            "Tile Size": side * self.cell,
            "Half Texel": 0.5 / side,
            "Half Texel Render": 0.5 / side,
            "Origin": (middle, middle, 0.0),
            ON_SAMPLES: True,
        }

    def _runs(self, axis: int, samples: int) -> list[tuple[slice, slice]]:
        """Returns the vertices along an axis, and the samples of a map of one period, in two
        runs."""
        step = samples // self.cells
        first = math.floor(self.origin[axis] / self.cell * step + 0.5) % samples
        count = math.ceil((samples - first) / step)
        start = first + count * step - samples
        return [
            (slice(0, count), slice(first, None, step)),
            (slice(count, None), slice(start, first + 1, step)),
        ]

    def _take(self, field: np.ndarray, to: np.ndarray) -> None:
        """Writes the samples of a map of one period at the vertices."""
        rows, columns = (self._runs(axis, len(field)) for axis in (1, 0))
        for to_rows, of_rows in rows:
            for to_columns, of_columns in columns:
                to[to_rows, to_columns] = field[of_rows, of_columns]

    def summed(self, sea, at: float, maps: dict) -> dict:
        """Returns the sums of these maps of one period, by fields, and of the wakes."""
        sums = {}
        for field, map_ in maps.items():
            sums[field] = sea.wakes.buffer(field, self.cells + 1)
            self._take(map_, sums[field])
        if "Normal" in sums:
            sums["Normal"][..., 3] = 0.0  # of the trail
        buffers = [(sum_, _ADDED[field]) for field, sum_ in sums.items()]
        handle = sea.wakes.of(sea.values)
        for hull in range(min(handle.wake_count, wake_nodes.COUNT)):
            handle.add_wake(hull, at, buffers, self.origin, self.cell)
        return sums


def broken(sums: dict, begin: float, width: float, power: float) -> None:
    """Adds the foam where the sums break now. begin, width, power: as the input WHITECAP."""
    cover, jacobian = (sums[field].reshape(-1, 4)[:, 3] for field in ("Displacement", "Velocity"))
    at = np.flatnonzero(jacobian < begin)
    foam = np.minimum((begin - jacobian[at]) / width, 1.0)
    cover[at] = np.maximum(cover[at], foam**power)


def vertices_of(picture) -> Vertices | None:
    """Returns the vertices whose maps show a picture's wakes: of a patch on the samples of its
    maps, which nothing but its own modifier moves; None for others."""
    sea, ob, settings = picture.opened, picture.ob, picture.settings
    if not sea.values.hulls or settings.kind != "PATCH" or picture.is_turned or settings.mask:
        return None
    if not picture.is_shared or not settings.use_normal or ob.mode != "OBJECT":
        return None
    is_linked = picture.modifier.node_group.library is not None
    if is_linked and wake_nodes.IN_MAPS not in modifier_groups.names(picture.modifier):
        return None  # it is of an earlier version
    try:
        sea.wakes.of(sea.values)
    except libocean.Error:  # follow() raises it, once the sea is shown
        return None
    before = ob.modifiers[: ob.modifiers.find(picture.modifier.name)]
    if any(other.show_viewport or other.show_render for other in before):
        return None
    cells, period = meshes.samples_of(ob.data), float(sea.values.values["patch_size"])
    if cells is None or picture.size % cells or not meshes.is_patch(ob.data, period):
        return None
    cell = period / cells
    x, y = (place - cells // 2 * cell for place in picture.place)
    return Vertices(cells, cell, (x, y))


class WakeSea:
    """The library's sea of one object with its hulls, and the buffers of their images."""

    def __init__(self) -> None:
        self.handle = None
        self.values = None
        self._warnings: list[str] | None = None
        self._buffers: dict[tuple[str, int], np.ndarray] = {}

    def of(self, values):
        """Returns the handle of these values; None without hulls. Raises libocean.Error."""
        if values != self.values:
            self.close()
            if values.hulls:
                self.handle = libocean.parse(values.text(), base_dir=paths.blend_folder())
            self.values = values
        return self.handle

    def adopt(self, handle) -> None:
        """Replaces the handle by another one of the same values, which has computed more."""
        if self.handle is not None:
            self.handle.close()
        self.handle = handle

    def warnings(self, values) -> list[str]:
        """Returns the warnings about the hulls of these values."""
        handle = self.of(values)
        if handle is None:
            return []
        if self._warnings is None:
            told = handle.state["warnings"]
            self._warnings = [text for text in told if text.startswith("hulls.")]
        count = handle.wake_count
        if count <= wake_nodes.COUNT:
            return self._warnings
        too_many = tr_label(
            "The sea has {} hulls, and the wakes of the first {} are shown", count, wake_nodes.COUNT
        )
        return [too_many, *self._warnings]

    def buffer(self, field: str, side: int) -> np.ndarray:
        """Returns the buffer of an image of side x side samples."""
        if (field, side) not in self._buffers:
            if len(self._buffers) >= wake_nodes.COUNT * len(CHANNELS):
                self._buffers.clear()
            self._buffers[field, side] = images.aligned((side, side))
        return self._buffers[field, side]

    def close(self) -> None:
        if self.handle is not None:
            self.handle.close()
        self.handle = self.values = self._warnings = None


class _Lattice:
    """The samples of a wake's images: those of the mesh, which then shows the wake as the library
    has it. A mesh that is no patch has every second, fourth ... of them, if these are fine enough
    for the wake."""

    def __init__(self, wake, anchor: tuple[float, float], cell: float | None, cells: int) -> None:
        """wake: the wake's own samples; cell: of the mesh [m], one of whose vertices lies at the
        anchor; None: it may lie anywhere. cells: along a side of a patch, whose middle the anchor
        is; else 0."""
        finest = 0.5 * wake.cell
        if cell is None:
            cell, anchor = finest, wake.origin
        while cell < 0.99 * finest and not cells:
            cell *= 2.0
        self.cell = cell
        self.side = math.ceil(wake.samples * wake.cell / cell) + 2
        steps = [
            math.floor((first - start) / cell)
            for start, first in zip(anchor, wake.origin, strict=True)
        ]
        if cells:  # beyond the patch nothing is shown
            self.side = min(self.side, cells + 1)
            first, last = -(cells // 2), cells - cells // 2 + 1 - self.side
            steps = [min(max(step, first), last) for step in steps]
        self.origin = tuple(start + step * cell for start, step in zip(anchor, steps, strict=True))

    def place(self, ocean: tuple[float, float]) -> tuple[float, float, float]:
        """Returns the value of the input. ocean: where the ocean object is in the sea."""
        per_metre = 1.0 / (self.side * self.cell)
        corner = (first - 0.5 * self.cell for first in self.origin)
        x, y = ((at - low) * per_metre for at, low in zip(ocean, corner, strict=True))
        return x, y, per_metre


def _mesh_cells(picture) -> tuple[float | None, int]:
    """Returns the distance of the vertices of a mesh of the add-on [m], and the cells along a side
    of a patch; None and 0 for a mesh that lies otherwise in the sea."""
    sea, settings = picture.opened, picture.ob.libocean
    period = float(sea.values.values["patch_size"])
    if settings.kind == "HORIZON":
        return period / picture.ring_samples(), 0
    samples = meshes.samples_of(picture.ob.data) if settings.kind == "PATCH" else None
    known = samples is not None and not picture.is_turned
    return (period / samples, samples) if known else (None, 0)


def follow(picture, *, draft: bool) -> None:
    """Shows the wakes of a picture's time that its maps lack. draft: only what moves the mesh."""
    sea, modifier = picture.opened, picture.modifier
    handle = sea.wakes.of(sea.values)
    count = 0 if handle is None else min(handle.wake_count, wake_nodes.COUNT)
    in_maps = picture.vertices is not None and not draft
    uses = {wake_nodes.USE: count > 0 and not in_maps, wake_nodes.IN_MAPS: in_maps}
    modifier_groups.assign(modifier, uses)
    if in_maps:
        return
    _clear(modifier, count)
    if count == 0:
        return
    settings = picture.settings
    fields = ["Displacement"]
    if settings.use_velocity and not draft:
        fields.append("Velocity")
        power = modifier_groups.value(modifier, COVER_POWER)
        modifier_groups.assign(modifier, {wake_nodes.WHITECAP: (*sea.whitecap(), power)})
    if settings.use_normal and not draft:
        fields.append("Normal")
    anchor = (0.0, 0.0) if settings.kind == "HORIZON" else picture.place
    cells = _mesh_cells(picture)
    for hull in range(count):
        wake = handle.wake_domain(hull, picture.time)
        lattice = _Lattice(wake, anchor, *cells)
        _show(picture, hull, fields, lattice)
        place = lattice.place(picture.place)
        modifier_groups.assign(modifier, {wake_nodes.place_input(hull): place})


def _clear(modifier, count: int) -> None:
    """Takes the images of wakes that are no more out of the inputs."""
    known = modifier_groups.names(modifier)
    for hull in range(count, wake_nodes.COUNT):
        names = [wake_nodes.image_input(hull, field) for field in wake_nodes.FIELDS]
        if names[0] not in known or modifier_groups.value(modifier, names[0]) is None:
            return
        modifier_groups.assign(modifier, dict.fromkeys(names))


def _show(picture, hull: int, fields: list[str], lattice: _Lattice) -> None:
    """Fills the stale images of a wake."""
    sea, ob, modifier = picture.opened, picture.ob, picture.modifier
    side = lattice.side
    targets = {}
    for field in fields:
        name = wake_nodes.image_input(hull, field)
        image = modifier_groups.value(modifier, name)
        if image is None:
            image = images.make(ob.name, name.lower(), (side, side), _STILL)
            modifier_groups.assign(modifier, {name: image})
        targets[field] = image
    state = ("wake", sea.changes, picture.time, lattice.origin, lattice.cell)
    with sea.lock:
        stale = sea.stale(targets, state)
        if not stale:
            return
        maps = {field: sea.wakes.buffer(field, side) for field in stale}
        buffers = [(array, CHANNELS[field]) for field, array in maps.items()]
        handle = sea.wakes.handle
        handle.fill_wake(hull, picture.time, buffers, lattice.origin, lattice.cell)
        if "Velocity" in maps:
            maps["Velocity"][..., 3] -= 1.0
        if "Normal" in maps:  # the slopes of the displaced wake
            maps["Normal"][..., :2] /= -maps["Normal"][..., 2:3]
        sea.put(targets, stale, maps, state)
