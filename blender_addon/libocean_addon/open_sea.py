# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Seas that are kept open, one for each object: the library's handles, the buffers of their maps,
and what each image was last filled with.
"""

from __future__ import annotations

import threading

import bpy
import numpy as np

from . import atlas, images, node_group, parameter_values, sea_text
from .native import libocean

CHANNELS = atlas.FINEST


class OpenSea:
    """The library's sea of one object, its buffers, and what was shown last."""

    def __init__(self) -> None:
        self.lock = threading.Lock()  # renders run in a thread of their own
        self.sea = None
        self.values: sea_text.SeaValues | None = None
        self.changes = 0
        self.state: dict | None = None  # read_state()
        self.point_sea = None
        self.point_changes = 0
        self.buffers: dict[tuple[str, int], np.ndarray] = {}
        self.shown: dict[str, tuple] = {}  # by image: what it holds

    def follow(self, values: sea_text.SeaValues) -> None:
        """Makes it the sea of these values. Raises libocean.Error and stays what it was."""
        if values == self.values:
            return
        if self.sea is None or values.structure() != self.values.structure():
            self._open(values)
        else:
            before = self.values.by_name()
            try:
                for name, text in values.by_name().items():
                    if before[name] != text:
                        self.sea.set(name, text)
            except libocean.Error:
                # One after the other is not always allowed where all together are.
                self._open(values)
        self.values = values
        self.state = None
        self.changes += 1

    def _open(self, values: sea_text.SeaValues) -> None:
        text = sea_text.write(parameter_values.TABLE, values)
        opened = libocean.parse(text, base_dir=bpy.path.abspath("//") or None)
        if self.sea is not None:
            self.sea.close()
        self.sea = opened

    def for_points(self):
        """The same sea in another handle: maps and points at the same time would each undo what
        the library keeps for the other."""
        if self.point_sea is None or self.point_changes != self.changes:
            if self.point_sea is not None:
                self.point_sea.close()
            self.point_sea = libocean.parse(self.sea.text)
            self.point_changes = self.changes
        return self.point_sea

    def buffer(self, name: str, size: int) -> np.ndarray:
        """What goes into an image for maps of size x size samples."""
        if (name, size) not in self.buffers:
            # Of one size for the viewport and one for renders.
            kept = {s for _, s in self.buffers} - {size}
            if len(kept) > 1:
                self.buffers.clear()
            shape = (size, size) if name in CHANNELS else atlas.shape(size)
            self.buffers[name, size] = images.aligned(shape)
        return self.buffers[name, size]

    def read_state(self) -> dict:
        if self.state is None:
            self.state = self.sea.state
        return self.state

    def show(self, time: float, size: int, targets: dict[str, bpy.types.Image]) -> None:
        """Fills these images, by the inputs of the node group, with the maps of `time`."""
        with self.lock:
            self._show(time, size, targets)

    def _show(self, time: float, size: int, targets: dict[str, bpy.types.Image]) -> None:
        for image in targets.values():
            if images.let_go(image):
                self.shown.pop(image.name_full, None)
        state = (self.changes, time, size)
        stale = {
            name: image
            for name, image in targets.items()
            if self.shown.get(image.name_full) != state
        }
        if not stale:
            return
        far = [field for field in CHANNELS if node_group.far_image(field) in stale]
        fields = [field for field in CHANNELS if field in stale or field in far]
        self.sea.fill(time, [(self.buffer(field, size), CHANNELS[field]) for field in fields])
        if far:
            if "Normal" in far:
                self.buffer("Normal", size)[..., 3] = atlas.lost_slopes(self.read_state(), size)
            finest = {field: self.buffer(field, size) for field in far}
            atlases = {field: self.buffer(node_group.far_image(field), size) for field in far}
            atlas.fill(self.sea, time, size, finest, atlases, self.read_state())
        for name, image in stale.items():
            pixels = self.buffer(name, size)
            images.resize(image, pixels.shape[:2])
            images.fill(image, pixels)
            self.shown[image.name_full] = state

    def close(self) -> None:
        for handle in (self.sea, self.point_sea):
            if handle is not None:
                handle.close()


_seas: dict[str, OpenSea] = {}


def sea_of(ob) -> OpenSea:
    return _seas.setdefault(ob.name_full, OpenSea())


def forget(names: set[str]) -> None:
    """After undo and loading: what images hold is not known any more, and of the seas there are
    those of the objects with these names."""
    for name in list(_seas):
        if name in names:
            _seas[name].shown.clear()
        else:
            _seas.pop(name).close()


def close_all() -> None:
    for sea in _seas.values():
        sea.close()
    _seas.clear()
