# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The sea at points: its surface, the water below it, floating bodies, wave gauges."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable

import numpy as np
import numpy.typing as npt

from . import _abi, _library
from ._answers import (
    GAUGE_COLUMNS,
    SAMPLE,
    WATER_SAMPLE,
    Array,
    FloatPose,
    Samples,
    Water,
    pointer_to,
)
from ._checks import accuracy, hide, number, numbers, points_of
from ._handle import SeaHandle


def _track(gauge: npt.ArrayLike) -> tuple[npt.NDArray[np.float64], tuple[float, float]]:
    """Returns the fixes of a gauge, (m, 4), and the velocity at which it leaves a single one."""
    allowed = "(3,), (5,) or (m, 4)"
    track = np.ascontiguousarray(numbers("a gauge", gauge, allowed), dtype=np.float64)
    velocity = (0.0, 0.0)
    if track.shape in [(3,), (5,)]:
        velocity = tuple(track[3:]) or velocity
        track = np.array([[0.0, *track[:3]]])
    if track.ndim != 2 or track.shape[1] != 4:
        raise _library.error(
            f"a gauge of shape {track.shape}; allowed: {allowed}",
            _abi.INVALID_ARGUMENT,
        )
    return track, velocity


class Queries(SeaHandle):
    """The part of a Sea that answers about points."""

    def query(self, points: npt.ArrayLike, time: float, foam: bool = True) -> Array:
        """Returns the shown surface at n world points (x, y) as (n, 10), the columns of
        `ocean query`: x, y, height, normal x y z, velocity x y z, foam. With foam=False (n, 9),
        without waiting for the foam's past."""
        return self._answers(
            "ocean_query", "points", points, (number("time", time),), 2, 10 if foam else 9
        )

    def samples(
        self,
        points: npt.ArrayLike,
        time: float,
        *,
        resolution: int = 0,
        refine: int = 1,
        exact: bool = False,
        foam: bool = False,
    ) -> Samples:
        """Returns the shown surface at n world points (x, y), with label, folds and error.
        resolution: counts the waves that a map of that resolution holds, at a fraction of the cost.
        refine: 2, 4 ... for smaller errors. exact: the sum over all waves, a hundred times as
        slow. foam: with foam, which query() has by default; its past takes far longer than all the
        rest. Without it `foam` is NaN."""
        error = ctypes.c_double()
        how = *accuracy(resolution, refine, exact), bool(foam), ctypes.pointer(error)
        where, hidden = points_of("points", points, 2)
        answers = self._samples("ocean_query_points", _abi.QueryRequest, SAMPLE, where, time, how)
        hide(answers, hidden)
        if not foam:
            answers["foam"] = np.nan
        flags = answers["flags"]
        return Samples(
            height=answers["height"],
            normal=answers["normal"],
            velocity=answers["velocity"],
            foam=answers["foam"],
            label=answers["label"],
            folded=flags & _abi.FOLDED != 0,
            undecided=flags & _abi.UNDECIDED != 0,
            height_error=error.value,
        )

    def orbital_velocity(self, points: npt.ArrayLike, time: float, z: float = 0.0) -> Array:
        """Returns the velocity of the water by linear theory at fixed world points (x, y), z metres
        above still water: (n, 3) [m/s]. Above z = 0 it is that of 0, below the bottom it is 0."""
        when = number("time", time), number("z", z)
        return self._answers("ocean_orbital_velocity", "points", points, when, 2, 3)

    def water(
        self,
        points: npt.ArrayLike,
        time: float,
        *,
        resolution: int = 0,
        refine: int = 1,
        exact: bool = False,
    ) -> Water:
        """Returns velocity and pressure of the water at n fixed world points (x, y, z) of any
        depths, by linear theory. Each distinct depth costs two transforms. resolution, refine and
        exact as in samples()."""
        where, hidden = points_of("points", points, 3)
        how = accuracy(resolution, refine, exact)
        answers = self._samples(
            "ocean_water_points", _abi.WaterRequest, WATER_SAMPLE, where, time, how
        )
        hide(answers, hidden)
        return Water(answers["velocity"], answers["pressure"])

    def gauges(
        self, gauges: Iterable[npt.ArrayLike], start: float, end: float, rate: float
    ) -> npt.NDArray[np.float64]:
        """Returns the readings of gauges from `start` to `end` [s], `rate` times a second: (times,
        gauges, 10), the columns GAUGE_COLUMNS, in double precision. Each gauge is (x, y, z), or
        (x, y, z, vx, vy) for one that moves on, with x, y and z at time 0, or (m, 4): time, x, y, z
        of a track."""
        tracks = [_track(gauge) for gauge in gauges]
        array = (_abi.Gauge * len(tracks))()
        for gauge, (track, velocity) in zip(array, tracks, strict=True):
            gauge.fixes = pointer_to(track)
            gauge.fix_count = len(track)
            gauge.velocity[:] = velocity
        request = _abi.GaugeRequest(
            ctypes.sizeof(_abi.GaugeRequest),
            *(number("start", start), number("end", end), number("rate", rate)),
            *(array, len(array), ctypes.sizeof(_abi.Gauge)),
        )
        times = ctypes.c_size_t()
        self._call("ocean_gauges", ctypes.byref(request), ctypes.byref(times))
        values = np.empty((times.value, len(array), len(GAUGE_COLUMNS)))
        request.values = pointer_to(values)
        request.value_count = values.size
        self._call("ocean_gauges", ctypes.byref(request), ctypes.byref(times))
        return values

    def float_pose(self, bodies: npt.ArrayLike, time: float) -> FloatPose:
        """Returns how floating bodies lie on the sea, each (x, y, heading, length, width) [m], the
        heading [degrees counter-clockwise from +x], the length along it."""
        poses = self._answers("ocean_float_pose", "bodies", bodies, (number("time", time),), 5, 11)
        return FloatPose(poses[:, 0:3], poses[:, 3:6], poses[:, 6:9], poses[:, 9], poses[:, 10])

    def _answers(
        self,
        function: str,
        name: str,
        values: npt.ArrayLike,
        when: tuple[float, ...],
        width: int,
        columns: int,
    ) -> Array:
        """Returns one row of floats for each row of `width` numbers."""
        given, hidden = points_of(name, values, width)
        answers = np.empty((len(given), columns), dtype=np.float32)
        given_rows = pointer_to(given), len(given)
        self._call(function, *when, *given_rows, pointer_to(answers), columns)
        hide(answers, hidden)
        return answers
