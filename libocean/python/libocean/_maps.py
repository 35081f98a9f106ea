# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Maps of a sea at one time: written into arrays of the caller, slope tiles, spray."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from . import _abi, _library
from ._answers import DETAIL_BAND, SPRAY_PARTICLE, Array, Detail, DetailBand, Spray, pointer_to
from ._checks import number, resolution_or_0, row, whole, words
from ._handle import Handle, SeaHandle
from ._library import choose
from ._surface import PRODUCTS, channel_number

Map = tuple[Array, tuple[int, ...]]
"""An array and the numbers of its channels."""


def outputs_of(maps: list[Map]) -> Any:
    """Returns the structs by which the library writes into these arrays."""
    outputs = (_abi.Output * len(maps))()
    for output, (array, channels) in zip(outputs, maps, strict=True):
        output.data = pointer_to(array)
        output.row_pitch = array.strides[0] // 4
        output.count = (len(array) - 1) * output.row_pitch + array.shape[1] * len(channels)
        output.channel[: len(channels)] = channels
        output.channels = len(channels)
    return outputs


def named_arrays(
    buffers: Iterable[tuple[Array, Sequence[str]]],
) -> list[tuple[Array, tuple[str, ...]]]:
    """Returns the arrays of a caller with the names of their channels; one name may be given
    alone."""
    arrays = []
    for buffer in buffers:
        is_pair = isinstance(buffer, (tuple, list)) and len(buffer) == 2
        if not is_pair or not isinstance(buffer[0], np.ndarray):
            raise TypeError("a buffer must be a pair: a NumPy array, and the names of its channels")
        arrays.append((buffer[0], tuple(words("channels", buffer[1]))))
    return arrays


def _shape_words(array: Array, columns: int) -> str:
    return "R, R" if columns == len(array) else f"rows, {columns}"


def require_layout(array: Array, names: tuple[str, ...], columns: int) -> None:
    """Raises Error for an array that the library cannot write a map of so many columns into."""
    shape = (len(array), columns, len(names))
    rows = array.strides == (array.strides[0], 4 * len(names), 4)
    whole = rows and array.strides[0] % 4 == 0 and array.strides[0] >= 4 * columns * shape[2]
    usable = array.flags.writeable and array.flags.aligned
    if usable and whole and array.dtype == np.float32 and array.shape == shape:
        return
    raise _library.error(
        f"an array of {array.dtype} and shape {array.shape}; needed: float32, "
        f"rows C-contiguous, writable, ({_shape_words(array, columns)}, {len(names)})",
        _abi.INVALID_ARGUMENT,
    )


class MapWriter(Handle):
    """The part of a Sea or a Terrain that writes maps into arrays."""

    def _fill(
        self,
        time: float,
        buffers: Iterable[tuple[Array, Sequence[str]]],
        axes: str,
        seam: bool,
        cascade: int | None = None,
    ) -> None:
        maps = named_arrays(buffers)
        for array, names in maps:
            require_layout(array, names, len(array))
        if len({len(array) for array, _ in maps}) > 1:
            raise _library.error("arrays of different R in one call", _abi.INVALID_ARGUMENT)
        if maps:
            outputs = [
                (array, tuple(channel_number(name) for name in names)) for array, names in maps
            ]
            turn = choose("axes", axes, _abi.AXES)
            resolution = len(maps[0][0]) - seam
            which = 0 if cascade is None else whole("cascade", cascade) + 1
            self._write_maps(number("time", time), resolution, turn, outputs, seam, which)

    def _write_maps(
        self,
        time: float,
        resolution: int,
        axes: int,
        maps: list[Map],
        seam: bool = False,
        cascade: int = 0,
    ) -> None:
        outputs = outputs_of(maps)
        for output in outputs:
            output.seam = seam
            output.axes = axes
        request = _abi.Request(
            ctypes.sizeof(_abi.Request),
            time,
            resolution,
            outputs,
            len(maps),
            ctypes.sizeof(_abi.Output),
            cascade,
        )
        self._call(self._prefix + "evaluate", ctypes.byref(request))

    def _evaluate(self, time: float, resolution: int, axes: int, names: list[str]) -> list[Array]:
        """Returns one new array for each field, filled by the library."""
        maps: list[Map] = []
        for name in names:
            channels = tuple(channel_number(channel) for channel in PRODUCTS[name].channels)
            vector = (len(channels),) if len(channels) > 1 else ()
            maps.append((np.empty((resolution, resolution, *vector), np.float32), channels))
        self._write_maps(time, resolution, axes, maps)
        return [array for array, _ in maps]


class Maps(MapWriter, SeaHandle):
    """The part of a Sea that makes maps."""

    def fill(
        self,
        time: float,
        buffers: Iterable[tuple[Array, Sequence[str]]],
        axes: str = "zup",
        *,
        seam: bool = False,
        cascade: int | None = None,
    ) -> None:
        """Writes the maps of `time` [s] into existing arrays, all together: each of shape (R, R, n)
        with the names of its n channels, 1 to 4 of CHANNELS ("dx", "dy", "height", "foam").
        The arrays are float32 and of one R, each row without gaps; those aligned to 64 bytes are
        filled fastest. seam: (R + 1, R + 1, n), which repeats the first samples a period on.
        cascade: the map of one of cascade_periods alone, over its period, of channels that add
        up."""
        self._fill(time, buffers, axes, seam, cascade)

    def map_resolution(self) -> int:
        """Returns the samples per side of a map whose resolution is not given."""
        resolution = ctypes.c_int32()
        self._call("ocean_map_resolution", ctypes.byref(resolution))
        return resolution.value

    def cover_power(self, time: float, resolution: int | None = None) -> float:
        """Returns the exponent that turns a map's foam into its cover, for hosts that derive one
        from the other. Takes some tenths of a second after a change of waves or wind."""
        power = ctypes.c_double()
        request = number("time", time), resolution_or_0(resolution)
        self._call("ocean_cover_power", *request, ctypes.byref(power))
        return power.value

    @property
    def cascade_periods(self) -> list[float]:
        """The periods of the sea's cascades [m]."""
        count = ctypes.c_size_t(0)
        self._call("ocean_cascade_periods", None, ctypes.byref(count))
        periods = (ctypes.c_double * count.value)()
        self._call("ocean_cascade_periods", periods, ctypes.byref(count))
        return list(periods)

    def detail(self, time: float, resolution: int | None = None, *, samples: int = 512) -> Detail:
        """Returns the waves too short for a map of `resolution` samples per side (default: as
        surface), about half of the sea's slopes, as slope maps of samples x samples, 256, 512 or
        1024. Materials read them as shaders/wave/slope_tiles.glsl does. The first call makes the
        tiles' waves, later ones for the same map only their times."""
        request = _abi.DetailRequest(
            ctypes.sizeof(_abi.DetailRequest),
            number("time", time),
            resolution_or_0(resolution),
            whole("samples", samples),
        )
        count = ctypes.c_size_t()
        residual = ctypes.c_double()
        with self._lock:
            self._call("ocean_detail", ctypes.byref(request), ctypes.byref(count), None)
            found = np.empty(count.value, dtype=DETAIL_BAND)
            slopes = [np.empty((samples, samples, 2), np.float32) for _ in found]
            channels = tuple(channel_number(name) for name in PRODUCTS["slope"].channels)
            outputs = outputs_of([(array, channels) for array in slopes])
            request.bands, request.band_count = pointer_to(found), len(found)
            request.band_size = found.itemsize
            request.outputs, request.output_count = outputs, len(outputs)
            request.output_size = ctypes.sizeof(_abi.Output)
            counted = ctypes.byref(count)
            self._call("ocean_detail", ctypes.byref(request), counted, ctypes.byref(residual))
        bands = [
            DetailBand(array, *(float(value) for value in band))
            for array, band in zip(slopes, found, strict=True)
        ]
        return Detail(bands, residual.value)

    def spray(
        self,
        time: float,
        *,
        lifetime: float = 2.0,
        density: float = 0.25,
        most: int = 1_000_000,
        region: tuple[float, float, float, float] | None = None,
    ) -> Spray:
        """Returns all particles alive at `time` [s]. lifetime: the max age, 0.05 .. 10 s. density:
        particles per m^2 that turns white, 0 .. 1000; winds below 11 m/s tear off fewer, below
        7 m/s none. most: about the max number alive at once; a larger number is thinned evenly. The
        first call makes a small map for every tick of the foam's clock within the lifetime, a later
        one the new ticks only. region: x0, y0, x1, y1 [m] of a part of a sea with hulls, whose
        wakes throw spray too; without it the spray is that of one period of the open sea."""
        request = _abi.SprayRequest(
            ctypes.sizeof(_abi.SprayRequest),
            number("time", time),
            number("spray: lifetime", lifetime),
            number("spray: density", density),
            whole("spray: most", most),
        )
        if region is not None:
            request.region[:] = row("spray: region", region, 4)
        count = ctypes.c_size_t()
        with self._lock:
            self._call("ocean_spray", ctypes.byref(request), ctypes.byref(count))
            found = np.empty(count.value, dtype=SPRAY_PARTICLE)
            request.particles = pointer_to(found)
            request.particle_count = len(found)
            request.particle_size = found.itemsize
            self._call("ocean_spray", ctypes.byref(request), ctypes.byref(count))
        return Spray(*(found[name] for name in Spray._fields))
