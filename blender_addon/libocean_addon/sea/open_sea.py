# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Open seas, one for each object: the library's handles, the buffers of their maps, and the state
that each image was last filled with.
"""

from __future__ import annotations

import time

import bpy
import numpy as np

from ..shared import drafts, images, paths
from ..shared.native import libocean
from ..shared.open_subject import OpenByObject, OpenSubject
from . import atlas, messages, node_group, sea_text, wakes
from .sea_job import SeaJob

CHANNELS = atlas.FINEST

COVER = "cover"  # of foam, which has a past
NO_COVER = "height"  # in its place without foam: a channel that costs nothing
QUICK = {COVER: "whitecap", NO_COVER: NO_COVER}
"""The channel of a draft in its place: whitecaps have no past, and are their own cover."""

_LIMITS = ("shortest_wavelength", "longest_wavelength")

_CHEAP_ADVANCE = 3.0  # [s] of the sea that foam advances while a user waits: sixty of its steps


def _channels(field: str, cover: str) -> tuple[str, ...]:
    return tuple(cover if channel == COVER else channel for channel in CHANNELS[field])


class OpenSea(OpenSubject):
    """The library's sea of one object, its buffers, and the content of its images."""

    def __init__(self) -> None:
        super().__init__()
        self.share: tuple[int, float] | None = None  # changes, share_within_limits()
        self.point_sea = None
        self.point_changes = 0
        self.wakes = wakes.WakeSea()
        self.buffers: dict[tuple[str, int], np.ndarray] = {}
        self.displaced: tuple | None = None  # state and pixels of the job's displacement
        self.detail_pixels: np.ndarray | None = None  # the pixels for the image of a band
        self.ready: tuple | None = (
            None  # changes, size, channel of cover, time: of the last whole map
        )
        self.took: tuple | None = None  # settings, seconds a sample from the start
        self.spray_wanted: dict | None = None  # the arguments of libocean.Sea.spray
        self.spray_ready: tuple | None = None  # changes, settings, time: of the last spray

    def _open(self, values: sea_text.SeaValues):
        base_dir = paths.blend_folder()
        text = values.without_hulls().text()
        return libocean.parse(text, base_dir=base_dir, progress=drafts.tell_watcher)

    def follow(self, values: sea_text.SeaValues) -> None:
        if values == self.values:
            return
        messages.require_files(values)
        super().follow(values)
        if values.crests:
            self._require_waves()

    def _require_waves(self) -> None:
        """Closes the sea and raises libocean.Error if its waves cannot make its crests, which the
        library finds out when it makes them."""
        try:
            self.handle.fill(0.0, [(np.empty((32, 32, 1), np.float32), ("height",))])
        except libocean.Error:
            self.close()
            self.values = None
            raise

    def for_points(self):
        """Returns a second handle of the sea, with its hulls: requests for maps and for points in
        turn would each discard the library's cache for the other."""
        if self.values.hulls:
            return self.wakes.of(self.values)
        if self.point_sea is None or self.point_changes != self.changes:
            if self.point_sea is not None:
                self.point_sea.close()
            self.point_sea = self.handle.clone()
            self.point_changes = self.changes
        return self.point_sea

    def buffer(self, name: str, size: int) -> np.ndarray:
        """Returns the buffer of an image for maps of size x size samples."""
        if (name, size) not in self.buffers:
            # One size for the viewport and one for renders is kept.
            kept = {s for _, s in self.buffers} - {size}
            if len(kept) > 1:
                self.buffers.clear()
            shape = (size, size) if name in CHANNELS else atlas.shape(size)
            self.buffers[name, size] = images.aligned(shape)
        return self.buffers[name, size]

    def cover_power(self, at: float, size: int, channel: str) -> float:
        """Returns the exponent that turns foam into the cover in that channel; 1 for whitecaps."""
        return self.handle.cover_power(at, size) if channel == COVER else 1.0

    def whitecap(self) -> tuple[float, float]:
        """Returns the Jacobian where whitecaps begin, and by how much less they are whole."""
        return self.read_state()["foam_threshold"], float(self.values.values["foam_width"])

    def has_limits(self) -> bool:
        """Returns whether waves of some lengths are left out."""
        return any(float(self.values.values[name]) > 0.0 for name in _LIMITS)

    def share_within_limits(self) -> float:
        """Returns its significant wave height as a share of the height without limits."""
        if self.share is None or self.share[0] != self.changes:
            height = self.read_state()["significant_wave_height"]["resolved"]
            with self.handle.clone() as free:
                free.set_all(dict.fromkeys(_LIMITS, "0"))
                whole = free.state["significant_wave_height"]["resolved"]
            self.share = self.changes, height / whole if whole > 0.0 else 1.0
        return self.share[1]

    # Images ---------------------------------------------------------------------

    def is_ready(self, at: float, size: int, channel: str) -> bool:
        """Returns whether the whole map of a time can be made at once: the sea is unchanged and the
        foam's past is at hand."""
        known = self.ready is not None and self.ready[:3] == (self.changes, size, channel)
        if known and (channel != COVER or 0.0 <= at - self.ready[3] <= _CHEAP_ADVANCE):
            return True
        if self.took is None or self.took[0] != self._costs(channel):
            return False
        return self.took[1] * size**2 < drafts.SECONDS / 2

    def _costs(self, channel: str) -> tuple:
        """Returns the settings that decide the cost of a sample."""
        values = self.values.values
        return (channel, *(values[f"foam_{key}"] for key in ("lifetime", "step", "resolution")))

    def show(
        self,
        at: float,
        size: int,
        targets: dict[str, bpy.types.Image],
        channel: str,
        vertices: wakes.Vertices | None = None,
    ) -> None:
        """Fills these images, by the inputs of the node group, with the maps of a time [s].
        channel: the channel in place of cover; vertices: whose sums with wakes the images hold."""
        with self.lock:
            begun = time.perf_counter()
            known = self.ready is not None and self.ready[:2] == (self.changes, size)
            if self._show(at, size, targets, channel, vertices):
                if not known:
                    seconds = time.perf_counter() - begun
                    self.took = (self._costs(channel), seconds / size**2)
                self.ready = (self.changes, size, channel, at)

    def show_draft(
        self, at: float, size: int, wanted: int, targets: dict[str, bpy.types.Image], channel: str
    ) -> None:
        """Fills these images with a draft, whose cover is the quick channel. wanted: samples per
        side of the whole map."""
        with self.lock:
            begun = time.perf_counter()
            if self._show(at, size, targets, QUICK[channel], None):
                self.pace.note(size, time.perf_counter() - begun, wanted)

    def job(self, at: float, size: int, channel: str, *, spray: bool) -> SeaJob:
        """Returns the job that makes the whole map of a time, and the spray that is wanted."""
        sea, wanted = self.handle.clone(), self.spray_wanted if spray else None
        with_wakes = wanted and "region" in wanted
        spray_sea = self._spray_sea(wanted).clone() if with_wakes else sea
        return SeaJob(sea, self.changes, at, size, channel, wanted, spray_sea)

    def adopt(self, job: SeaJob) -> bool:
        """Replaces the handle by the handle of a job that has ended. Returns False if the job is of
        no use."""
        if job.failure is not None or job.changes != self.changes:
            job.close()
            return False
        with self.lock:
            self.handle.close()
            self.handle = job.sea
            if job.spray_sea is not job.sea:
                self.wakes.adopt(job.spray_sea)
            self.took = (self._costs(job.channel), job.seconds / job.size**2)
            self.ready = (job.changes, job.size, job.channel, job.time)
            state = (job.changes, job.time, job.size, job.channel)
            self.displaced = state, job.displacement
            self.spray_ready = None if job.spray is None else (job.changes, job.spray, job.time)
        return True

    # Spray ----------------------------------------------------------------------

    def _spray_sea(self, settings: dict):
        """Returns the handle that makes spray: for a region the handle with the hulls."""
        return self.wakes.of(self.values) if "region" in settings else self.handle

    def spray(self, at: float, settings: dict):
        """Returns the libocean.Spray of a time [s]."""
        with self.lock:
            found = self._spray_sea(settings).spray(at, **settings)
            self.spray_ready = (self.changes, settings, at)
        return found

    def is_spray_ready(self, at: float, settings: dict) -> bool:
        """Returns whether the library has computed most of it, for example for the frame before."""
        known = self.spray_ready is not None and self.spray_ready[:2] == (self.changes, settings)
        return known and abs(at - self.spray_ready[2]) <= _CHEAP_ADVANCE

    def _show(
        self, at: float, size: int, targets: dict, channel: str, vertices: wakes.Vertices | None
    ) -> bool:
        """Fills stale images. Returns whether there were any."""
        state = (self.changes, at, size, channel)
        content = state if vertices is None else (*state, vertices, *targets)
        stale = self.stale(targets, content)
        if not stale:
            return False
        if vertices is not None:
            stale = list(targets)
        far = [field for field in CHANNELS if node_group.far_image(field) in stale]
        fields = [field for field in CHANNELS if field in stale or field in far]
        maps = {field: (self.buffer(field, size), _channels(field, channel)) for field in fields}
        made, self.displaced = self.displaced, None
        if made is not None and made[0] == state:
            self.buffers["Displacement", size] = made[1]
            maps.pop("Displacement", None)
        if maps:
            self.handle.fill(at, list(maps.values()))
        if far:
            if "Normal" in far:
                self.buffer("Normal", size)[..., 3] = atlas.lost_slopes(self.read_state(), size)
            finest = {field: self.buffer(field, size) for field in far}
            atlases = {field: self.buffer(node_group.far_image(field), size) for field in far}
            atlas.fill(self.handle, at, size, finest, atlases, self.read_state())
        found = {name: self.buffer(name, size) for name in stale}
        if vertices is not None:
            found = vertices.summed(self, at, found)
            if channel == COVER and "Velocity" in found:
                wakes.broken(found, *self.whitecap(), self.cover_power(at, size, channel))
        self.put(targets, stale, found, content)
        return True

    def close(self) -> None:
        if self.point_sea is not None:
            self.point_sea.close()
        self.point_sea = None
        self.wakes.close()
        super().close()


SEAS = OpenByObject(OpenSea)
sea_of = SEAS.of
