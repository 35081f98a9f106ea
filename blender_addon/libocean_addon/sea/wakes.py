# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The wakes of a sea's hulls: a handle of the sea with its hulls, and the images of their waves.

    values with hulls + time -> libocean -> float images around each hull -> wake_nodes.py

The maps of one period come from a handle without hulls: their tracks change, and its foam stays.
"""

from __future__ import annotations

import math

import numpy as np

from ..bake.baked_nodes import COVER_POWER
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


def _mesh_cells(picture, *, turned: bool) -> tuple[float | None, int]:
    """Returns the distance of the vertices of a mesh of the add-on [m], and the cells along a side
    of a patch; None and 0 for a mesh that lies otherwise in the sea."""
    sea, settings = picture.opened, picture.ob.libocean
    period = float(sea.values.values["patch_size"])
    if settings.kind == "HORIZON":
        return period / picture.ring_samples(), 0
    samples = meshes.samples_of(picture.ob.data) if settings.kind == "PATCH" else None
    return (None, 0) if samples is None or turned else (period / samples, samples)


def follow(picture, ocean: tuple[float, float], *, turned: bool, draft: bool) -> None:
    """Shows the wakes of a picture's time. ocean: where the ocean object is in the sea [m], and
    whether it is turned there. draft: only what moves the mesh."""
    sea, modifier = picture.opened, picture.modifier
    handle = sea.wakes.of(sea.values)
    count = 0 if handle is None else min(handle.wake_count, wake_nodes.COUNT)
    _clear(modifier, count)
    modifier_groups.assign(modifier, {wake_nodes.USE: count > 0})
    if count == 0:
        return
    settings = picture.settings
    fields = ["Displacement"]
    if settings.use_velocity and not draft:
        fields.append("Velocity")
        begin, width = sea.read_state()["foam_threshold"], float(sea.values.values["foam_width"])
        power = modifier_groups.value(modifier, COVER_POWER)
        modifier_groups.assign(modifier, {wake_nodes.WHITECAP: (begin, width, power)})
    if settings.use_normal and not draft:
        fields.append("Normal")
    anchor = (0.0, 0.0) if settings.kind == "HORIZON" else ocean
    cells = _mesh_cells(picture, turned=turned)
    for hull in range(count):
        wake = handle.wake_domain(hull, picture.time)
        lattice = _Lattice(wake, anchor, *cells)
        _show(picture, hull, fields, lattice)
        modifier_groups.assign(modifier, {wake_nodes.place_input(hull): lattice.place(ocean)})


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
