# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Sea, an open sea file, and Surface, its maps at one time."""

from __future__ import annotations

import ctypes
import json
import numbers
import signal
import threading
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _library
from ._library import (
    DetailRequest,
    Gauge,
    GaugeRequest,
    Options,
    Output,
    QueryRequest,
    Request,
    SprayRequest,
    WaterRequest,
    call,
    text_of,
)

Array = npt.NDArray[np.float32]

# In the order of the C enum.
CHANNELS = (
    *("dx", "dy", "height", "nx", "ny", "nz", "slope_x", "slope_y"),
    *("jacobian", "whitecap", "foam", "vx", "vy", "vz", "dx_x", "dy_y", "dx_y"),
    "cover",
)

# The channels of each field that a Surface has.
PRODUCTS: dict[str, tuple[str, ...]] = {
    "height": ("height",),
    "displacement": ("dx", "dy", "height"),
    "slope": ("slope_x", "slope_y"),
    "normal": ("nx", "ny", "nz"),
    "jacobian": ("jacobian",),
    "whitecap": ("whitecap",),
    "foam": ("foam",),
    "velocity": ("vx", "vy", "vz"),
    "derivatives": ("dx_x", "dy_y", "dx_y"),
    "cover": ("cover",),
}

# Of Sea.gauges.
GAUGE_COLUMNS = (
    *("time", "x", "y", "elevation", "slope_x", "slope_y"),
    *("velocity_x", "velocity_y", "velocity_z", "pressure"),
)


def _choose(what: str, name: str, known: Sequence[str]) -> int:
    if name not in known:
        raise _library.error(
            f"unknown {what} '{name}'; known: {', '.join(known)}", _library.INVALID_VALUE
        )
    return known.index(name)


def _outputs_of(maps: list[tuple[Array, tuple[int, ...]]]) -> Any:
    """Arrays and the numbers of their channels, as the library writes them."""
    outputs = (Output * len(maps))()
    for output, (array, channels) in zip(outputs, maps, strict=True):
        output.data = array.ctypes.data_as(ctypes.POINTER(ctypes.c_float))
        output.row_pitch = array.strides[0] // 4
        output.count = (len(array) - 1) * output.row_pitch + len(array) * len(channels)
        output.channel[: len(channels)] = channels
        output.channels = len(channels)
    return outputs


def _value_text(value: Any) -> str:
    """A Python value as the library reads it; the shortest form that keeps every bit."""
    if value is None:
        return ""
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_value_text(item) for item in value) + "]"
    text = str(value)
    if "\0" in text:  # a C text ends there: the rest would be lost without a word
        raise _library.error("a text with a NUL", _library.INVALID_VALUE)
    return text


# ocean_sample of libocean.h.
SAMPLE = np.dtype(
    [
        *[("height", np.float32), ("normal", np.float32, 3), ("velocity", np.float32, 3)],
        *[("foam", np.float32), ("label", np.float64, 2), ("flags", np.int32)],
        ("reserved", np.int32),
    ]
)
_FOLDED = 1
_UNDECIDED = 2


class Samples(NamedTuple):
    """The shown surface at n points, as arrays of n rows."""

    height: Array
    """(n,), metres."""
    normal: Array
    """(n, 3), unit, up."""
    velocity: Array
    """(n, 3), m/s, of the shown point."""
    foam: Array
    """(n,), 0 .. 1."""
    label: npt.NDArray[np.float64]
    """(n, 2), metres: which point of the undisplaced surface is shown there."""
    folded: npt.NDArray[np.bool_]
    """(n,): several sheets are shown there; this is the top one."""
    undecided: npt.NDArray[np.bool_]
    """(n,): so folded that not all of them were found; perhaps this is not the top one."""
    height_error: float
    """rms of what the heights lack of the exact sum over all waves, metres."""


# ocean_water_sample of libocean.h.
WATER_SAMPLE = np.dtype([("velocity", np.float32, 3), ("pressure", np.float32)])


class Water(NamedTuple):
    """What moves in the water at n points, as arrays of n rows."""

    velocity: Array
    """(n, 3), m/s."""
    pressure: Array
    """(n,), Pa, without the hydrostatic part."""


class FloatPose(NamedTuple):
    """Of n floating bodies: the plane below each, as arrays of n rows."""

    position: Array
    """(n, 3), metres: x and y of the body, height of the plane there."""
    up: Array
    """(n, 3), unit vectors of the tilted bodies."""
    forward: Array
    """(n, 3)"""
    pitch: Array
    """(n,), degrees, bow up."""
    roll: Array
    """(n,), degrees, port side up."""


# ocean_detail_band of libocean.h.
DETAIL_BAND = np.dtype(
    [
        *[("shortest_wave", np.float64), ("longest_wave", np.float64), ("tile", np.float64)],
        *[("variance_x", np.float64), ("variance_y", np.float64), ("covariance", np.float64)],
    ]
)


class DetailBand(NamedTuple):
    """Slopes of waves too short for a map, over a tile that repeats."""

    slope: Array
    """(samples, samples, 2): dh/dx and dh/dy by label, sample [j, i] at (i, j) tile / samples."""
    shortest_wave: float
    """Metres."""
    longest_wave: float
    tile: float
    """Side and period of the map, metres."""
    variance_x: float
    """E[hx^2] of the slopes hx, hy: the integral of the spectrum over the band."""
    variance_y: float
    """E[hy^2]"""
    covariance: float
    """E[hx hy]"""


class Detail(NamedTuple):
    """The waves too short for a map, at one time."""

    bands: list[DetailBand]
    """Longest waves first; none where the map holds all that."""
    residual: float
    """Mean square slope of the waves shorter than all bands: roughness at any distance."""


# ocean_spray_particle of libocean.h.
SPRAY_PARTICLE = np.dtype(
    [
        *[("id", np.uint64), ("position", np.float64, 3), ("velocity", np.float32, 3)],
        *[("age", np.float32), ("life", np.float32), ("radius", np.float32)],
    ]
)


class Spray(NamedTuple):
    """Particles of spray, each a parcel of drops of one size, as arrays of n rows."""

    position: npt.NDArray[np.float64]
    """(n, 3), metres: born within one period, then it may leave it. Copies a period on are as
    true."""
    velocity: Array
    """(n, 3), m/s."""
    age: Array
    """(n,), s since birth."""
    life: Array
    """(n,), s, the age at which it ends."""
    radius: Array
    """(n,), metres, of each of its drops."""
    id: npt.NDArray[np.uint64]
    """(n,): the same from birth to end in every frame, in a loop every time round."""


class _Reporter:
    """What the library calls while it works. It ends a call for Ctrl-C, and for what the sea's own
    progress function raises."""

    def __init__(
        self,
        progress: Callable[[int, int], object] | None,
        jobs: Callable[[Callable[[int], None], int], object] | None,
    ) -> None:
        self._progress = progress
        self._jobs = jobs
        self._signal: tuple[int, Any] | None = None
        self._failure: BaseException | None = None
        self.progress = _library.Progress(self._report)
        self.run_jobs = _library.RunJobs(self._run_jobs) if jobs else _library.RunJobs()

    def _report(self, _user: Any, done: int, total: int) -> int:
        if self._signal is None and self._progress is not None and total > 0:
            try:
                self._progress(done, total)
            except BaseException as failure:
                self._failure = failure
        return int(self._signal is not None or self._failure is not None)

    def _run_jobs(self, _user: Any, job: Any, work: Any, count: int) -> None:
        try:
            self._jobs(lambda index: job(work, index), count)
        except BaseException as failure:
            self._failure = failure

    @contextmanager
    def watched(self) -> Iterator[None]:
        """Ctrl-C reaches Python in the main thread alone, and there between two of its own steps:
        within a call it is noted, and acted on when the library has come back."""
        self._signal = self._failure = None
        before = None
        if threading.current_thread() is threading.main_thread():
            before = signal.getsignal(signal.SIGINT)
        if callable(before):
            signal.signal(signal.SIGINT, self._note)
        cancelled = None
        try:
            yield
        except _library.CancelledError as failure:
            cancelled = failure
        finally:
            if callable(before):
                signal.signal(signal.SIGINT, before)
        if self._failure is not None:
            raise self._failure
        if self._signal is not None and callable(before):
            before(*self._signal)
        if cancelled is not None:
            raise cancelled

    def _note(self, number: int, frame: Any) -> None:
        self._signal = (number, frame)


class Sea:
    """An open sea. Made by open(), parse() and preset(); a context manager. Calls from several
    threads wait for each other: clone the sea for each thread to work in parallel. Ctrl-C ends a
    call, and leaves the sea as it was."""

    def __init__(
        self,
        opener: Callable[[Any, Any], None],
        threads: int = 0,
        backend: str = "cpu",
        foam_start: str = "settled",
        progress: Callable[[int, int], object] | None = None,
        jobs: Callable[[Callable[[int], None], int], object] | None = None,
    ) -> None:
        self._handle: ctypes.c_void_p | None = None
        self._lock = threading.RLock()
        self._changes = 0
        self._asked = (threads, backend, foam_start, progress, jobs)
        self._reporter = _Reporter(progress, jobs)
        options = Options(
            ctypes.sizeof(Options),
            threads,
            _choose("backend", backend, _library.BACKENDS),
            _choose("foam_start", foam_start, _library.FOAM_STARTS),
            0,
            self._reporter.progress,
            None,
            self._reporter.run_jobs,
        )
        handle = ctypes.c_void_p()
        opener(ctypes.byref(options), ctypes.byref(handle))
        self._handle = handle

    def clone(self) -> Sea:
        """The same sea for another thread; shares what this one has built until either changes."""

        def share(options: Any, out: Any) -> None:
            call("ocean_clone", self._open_handle(), options, out)

        with self._lock:
            return Sea(share, *self._asked)

    def close(self) -> None:
        """Frees the sea. Surfaces keep the arrays they have. Closing twice is allowed."""
        with self._lock:
            handle, self._handle = self._handle, None
            if handle is not None:
                _library.library.ocean_free(handle)

    def __enter__(self) -> Sea:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __del__(self) -> None:
        if getattr(self, "_handle", None) is not None:
            self.close()

    def _call(self, name: str, *arguments: Any) -> None:
        with self._lock, self._reporter.watched():
            call(name, self._open_handle(), *arguments)

    def _text(self, name: str) -> str:
        with self._lock, self._reporter.watched():
            return text_of(name, self._open_handle())

    def _open_handle(self) -> ctypes.c_void_p:
        if self._handle is None:
            raise _library.error("this sea is closed", _library.INVALID_ARGUMENT)
        return self._handle

    def set(self, name: str, value: Any) -> None:
        """Sets a parameter ("wind_speed", "waves.1.fetch"); None takes back an optional one."""
        with self._lock:
            self._call("ocean_set", name.encode(), _value_text(value).encode())
            self._changes += 1

    def set_all(self, values: Mapping[str, Any]) -> None:
        """Sets several parameters that are checked together: all of them, or none."""
        with self._lock:
            names = [name.encode() for name in values]
            texts = [_value_text(value).encode() for value in values.values()]
            array = ctypes.c_char_p * len(names)
            self._call("ocean_set_all", array(*names), array(*texts), len(names))
            self._changes += 1

    def add_waves(self, name: str | None = None, **parameters: Any) -> str:
        """A wave system, the last one or that of the name ("waves.1"; those from there on move up),
        with these parameters. Returns its name."""
        with self._lock:
            if name is None:
                name = f"waves.{self.text.count(chr(10) + '[[waves]]')}"
            self._call("ocean_add_waves", name.encode())
            self._changes += 1
            try:
                self.set_all({f"{name}.{key}": value for key, value in parameters.items()})
            except _library.Error:
                self.remove_waves(name)
                raise
            return name

    def remove_waves(self, name: str) -> None:
        """The wave system of that name goes; those behind it move down."""
        with self._lock:
            self._call("ocean_remove_waves", name.encode())
            self._changes += 1

    def perform(self, time: float, name: str, value: Any) -> None:
        """A live parameter glides to the value from that time on, while the sea is shown. The
        sea's own take grows by it: `text` makes every frame again. What was before stays."""
        with self._lock:
            self._call("ocean_perform", time, name.encode(), _value_text(value).encode())
            self._changes += 1

    def get(self, name: str) -> str:
        """The value of a parameter, as text; "" for an optional one that is not set."""
        out = ctypes.create_string_buffer(8192)
        self._call("ocean_get", name.encode(), out, len(out))
        return out.value.decode()

    @property
    def text(self) -> str:
        """The resolved sea file, self-contained: libocean.parse(text) gives the same sea."""
        return self._text("ocean_text")

    @property
    def state(self) -> dict[str, Any]:
        """What `ocean info --json` prints: heights, periods, directions, asked and resolved."""
        return json.loads(self._text("ocean_state_json"))

    def surface(
        self,
        time: float,
        resolution: int | None = None,
        fields: Iterable[str] | None = None,
        axes: str = "zup",
    ) -> Surface:
        """The sea at `time` seconds, on resolution x resolution samples of one period (default:
        the sea's own, four times that for cascades). `fields` are computed at once, in one go;
        without it each is computed when it is first looked at. axes: "zup" (x, y, z), "yup"
        (x, z, -y) or "tnb" (x, z, y)."""
        return Surface(self, time, resolution, fields, axes)

    def fill(
        self,
        time: float,
        buffers: Iterable[tuple[Array, Sequence[str]]],
        axes: str = "zup",
        *,
        seam: bool = False,
        cascade: int | None = None,
    ) -> None:
        """Writes the maps of `time` into arrays that are there, all in one go: each of shape
        (R, R, n) with the names of its n channels, 1 to 4 of CHANNELS ("dx", "dy", "height",
        "foam"). Float32 and of one R, each row without gaps; those aligned to 64 bytes are filled
        fastest. seam: (R + 1, R + 1, n), the first samples again a period on. cascade: of one of
        cascade_periods alone, over its period, of channels that add up."""
        asked = [(array, tuple(names)) for array, names in buffers]
        for array, names in asked:
            shape = (len(array), len(array), len(names))
            rows = array.strides == (array.strides[0], 4 * len(names), 4)
            whole = rows and array.strides[0] % 4 == 0 and array.strides[0] >= len(array) * shape[2]
            if (
                array.dtype != np.float32
                or array.shape != shape
                or not whole
                or not (array.flags.writeable and array.flags.aligned)
            ):
                raise _library.error(
                    f"an array of {array.dtype} and shape {array.shape}; needed: float32, "
                    f"rows C-contiguous, writable, (R, R, {len(names)})",
                    _library.INVALID_ARGUMENT,
                )
        if len({len(array) for array, _ in asked}) > 1:
            raise _library.error("arrays of different R in one call", _library.INVALID_ARGUMENT)
        if asked:
            outputs = [
                (array, tuple(_choose("channel", name, CHANNELS) for name in names))
                for array, names in asked
            ]
            turn = _choose("axes", axes, _library.AXES)
            resolution = len(asked[0][0]) - seam
            number = 0 if cascade is None else cascade + 1
            self._write_maps(time, resolution, turn, outputs, seam, number)

    def query(self, points: npt.ArrayLike, time: float, foam: bool = True) -> Array:
        """The surface that is shown at each of n world points (x, y): (n, 10), the columns of
        `ocean query`: x, y, height, normal x y z, velocity x y z, foam. With foam=False (n, 9),
        and no waiting for the foam's past."""
        return self._answers("ocean_query", points, (time,), 2, 10 if foam else 9)

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
        """All that is known of the surface at each of n world points (x, y). resolution: the waves
        that a map of so many samples holds, at a fraction of the cost. refine: 2, 4 ... for smaller
        errors. exact: the sum over all waves, a hundred times as slow."""
        error = ctypes.c_double()
        how = (resolution, refine, exact, foam, ctypes.pointer(error))
        answers = self._samples(
            "ocean_query_points", QueryRequest, SAMPLE, self._rows(points, 2), time, how
        )
        fields = [answers[name] for name in ("height", "normal", "velocity", "foam", "label")]
        flags = answers["flags"]
        return Samples(*fields, flags & _FOLDED != 0, flags & _UNDECIDED != 0, error.value)

    def orbital_velocity(self, points: npt.ArrayLike, time: float, z: float = 0.0) -> Array:
        """Velocity of the water by linear theory at fixed world points (x, y), z metres above still
        water: (n, 3), m/s. Above 0 it is that of 0, below the bottom there is none."""
        return self._answers("ocean_orbital_velocity", points, (time, z), 2, 3)

    def water(
        self,
        points: npt.ArrayLike,
        time: float,
        *,
        resolution: int = 0,
        refine: int = 1,
        exact: bool = False,
    ) -> Water:
        """Velocity and pressure of the water at n fixed world points (x, y, z) of any depths, as
        orbital_velocity. Each other depth costs two transforms. The rest as samples()."""
        how = (resolution, refine, exact)
        answers = self._samples(
            "ocean_water_points", WaterRequest, WATER_SAMPLE, self._rows(points, 3), time, how
        )
        return Water(answers["velocity"], answers["pressure"])

    def gauges(
        self, gauges: Iterable[npt.ArrayLike], start: float, end: float, rate: float
    ) -> npt.NDArray[np.float64]:
        """What gauges read from `start` to `end`, `rate` times a second: (times, gauges, 10), the
        columns GAUGE_COLUMNS, in double precision. Each gauge is (x, y, z), or (x, y, z, vx, vy)
        for one that moves on, with x, y and z at time 0, or (m, 4): time, x, y, z of a track."""
        tracks = []
        for gauge in gauges:
            track = np.ascontiguousarray(gauge, dtype=np.float64)
            velocity = (0.0, 0.0)
            if track.shape in [(3,), (5,)]:
                velocity = tuple(track[3:]) or velocity
                track = np.array([[0.0, *track[:3]]])
            if track.ndim != 2 or track.shape[1] != 4:
                raise _library.error(
                    f"a gauge of shape {track.shape}; allowed: (3,), (5,) or (m, 4)",
                    _library.INVALID_ARGUMENT,
                )
            tracks.append((track, velocity))
        array = (Gauge * len(tracks))()
        for gauge, (track, velocity) in zip(array, tracks, strict=True):
            gauge.fixes = track.ctypes.data
            gauge.fix_count = len(track)
            gauge.velocity[:] = velocity
        request = GaugeRequest(
            ctypes.sizeof(GaugeRequest), start, end, rate, array, len(array), ctypes.sizeof(Gauge)
        )
        times = ctypes.c_size_t()
        self._call("ocean_gauges", ctypes.byref(request), ctypes.byref(times))
        values = np.empty((times.value, len(array), len(GAUGE_COLUMNS)))
        request.values = values.ctypes.data
        request.value_count = values.size
        self._call("ocean_gauges", ctypes.byref(request), ctypes.byref(times))
        return values

    def detail(self, time: float, resolution: int | None = None, *, samples: int = 512) -> Detail:
        """The waves too short for a map of `resolution` samples a side (default: as surface),
        about half of the sea's slopes, as slope maps of samples x samples, 256, 512 or 1024:
        for materials, which read them as shaders/wave/slope_tiles.glsl does. The first call makes
        the tiles' waves, later ones for the same map only their times."""
        request = DetailRequest(ctypes.sizeof(DetailRequest), time, resolution or 0, samples)
        count = ctypes.c_size_t()
        residual = ctypes.c_double()
        with self._lock:
            self._call("ocean_detail", ctypes.byref(request), ctypes.byref(count), None)
            found = np.empty(count.value, dtype=DETAIL_BAND)
            slopes = [np.empty((samples, samples, 2), np.float32) for _ in found]
            channels = tuple(CHANNELS.index(name) for name in PRODUCTS["slope"])
            outputs = _outputs_of([(array, channels) for array in slopes])
            request.bands, request.band_count = found.ctypes.data, len(found)
            request.band_size = found.itemsize
            request.outputs, request.output_count = outputs, len(outputs)
            request.output_size = ctypes.sizeof(Output)
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
    ) -> Spray:
        """All spray that is alive at a time. lifetime: the greatest age, 0.05 .. 10 s. density:
        particles for each m^2 that turns white, 0 .. 1000; in winds below 11 m/s fewer, below 7
        none. most: alive at once, about; where there would be more they are thinner. The first call
        makes a small map for every tick of the foam's clock within the lifetime, one for a later
        time those that are new."""
        request = SprayRequest(ctypes.sizeof(SprayRequest), time, lifetime, density, most)
        count = ctypes.c_size_t()
        with self._lock:
            self._call("ocean_spray", ctypes.byref(request), ctypes.byref(count))
            found = np.empty(count.value, dtype=SPRAY_PARTICLE)
            request.particles = found.ctypes.data
            request.particle_count = len(found)
            request.particle_size = found.itemsize
            self._call("ocean_spray", ctypes.byref(request), ctypes.byref(count))
        return Spray(*(found[name] for name in Spray._fields))

    def float_pose(self, bodies: npt.ArrayLike, time: float) -> FloatPose:
        """How floating bodies lie on the sea, each (x, y, heading, length, width): metres and
        degrees counter-clockwise from +x, the length along the heading."""
        poses = self._answers("ocean_float_pose", bodies, (time,), 5, 11)
        return FloatPose(poses[:, 0:3], poses[:, 3:6], poses[:, 6:9], poses[:, 9], poses[:, 10])

    def _samples(
        self,
        name: str,
        request_type: type[ctypes.Structure],
        sample: np.dtype[Any],
        asked: Array,
        time: float,
        how: tuple[Any, ...],
    ) -> npt.NDArray[Any]:
        """A sample for each row asked; `how` is what the request's struct has beyond them."""
        answers = np.empty(len(asked), dtype=sample)
        rows = (asked.ctypes.data, len(asked), answers.ctypes.data, sample.itemsize)
        request = request_type(ctypes.sizeof(request_type), time, *rows, *how)
        self._call(name, ctypes.byref(request))
        return answers

    def _answers(
        self, name: str, rows: npt.ArrayLike, when: tuple[float, ...], width: int, columns: int
    ) -> Array:
        """One row of floats for each row of `width` numbers."""
        asked = self._rows(rows, width)
        answers = np.empty((len(asked), columns), dtype=np.float32)
        self._call(name, *when, asked.ctypes.data, len(asked), answers.ctypes.data, columns)
        return answers

    @staticmethod
    def _rows(rows: npt.ArrayLike, width: int) -> npt.NDArray[np.float64]:
        asked = np.ascontiguousarray(rows, dtype=np.float64)
        if asked.shape == (width,) or asked.size == 0:
            asked = asked.reshape(-1, width)
        if asked.ndim != 2 or asked.shape[1] != width:
            raise _library.error(
                f"an array of shape {asked.shape}; allowed: (n, {width})",
                _library.INVALID_ARGUMENT,
            )
        return asked

    def map_resolution(self) -> int:
        """Samples a side of a map where none is asked for."""
        resolution = ctypes.c_int32()
        self._call("ocean_map_resolution", ctypes.byref(resolution))
        return resolution.value

    def cover_power(self, time: float, resolution: int | None = None) -> float:
        """The power of a map's foam that is its cover, for hosts that make one of the other. Some
        tenths of a second after a change of waves or wind."""
        power = ctypes.c_double()
        self._call("ocean_cover_power", time, resolution or 0, ctypes.byref(power))
        return power.value

    @property
    def cascade_periods(self) -> list[float]:
        """The periods of the sea's cascades, metres."""
        count = ctypes.c_size_t(0)
        self._call("ocean_cascade_periods", None, ctypes.byref(count))
        periods = (ctypes.c_double * count.value)()
        self._call("ocean_cascade_periods", periods, ctypes.byref(count))
        return list(periods)

    def _write_maps(
        self,
        time: float,
        resolution: int,
        axes: int,
        maps: list[tuple[Array, tuple[int, ...]]],
        seam: bool = False,
        cascade: int = 0,
    ) -> None:
        """ocean_evaluate of arrays and the numbers of their channels."""
        outputs = _outputs_of(maps)
        for output in outputs:
            output.seam = seam
            output.axes = axes
        request = Request(
            ctypes.sizeof(Request),
            time,
            resolution,
            outputs,
            len(maps),
            ctypes.sizeof(Output),
            cascade,
        )
        self._call("ocean_evaluate", ctypes.byref(request))

    def _evaluate(self, time: float, resolution: int, axes: int, names: list[str]) -> list[Array]:
        """One array for each field, filled by the library in place."""
        maps: list[tuple[Array, tuple[int, ...]]] = []
        for name in names:
            channels = tuple(CHANNELS.index(channel) for channel in PRODUCTS[name])
            vector = (len(channels),) if len(channels) > 1 else ()
            maps.append((np.empty((resolution, resolution, *vector), np.float32), channels))
        self._write_maps(time, resolution, axes, maps)
        return [array for array, _ in maps]


class Surface:
    """The maps of one sea at one time, as numpy arrays [j, i] or [j, i, component], float32."""

    def __init__(
        self,
        sea: Sea,
        time: float,
        resolution: int | None,
        fields: Iterable[str] | None,
        axes: str,
    ) -> None:
        self._sea = sea
        self._changes = sea._changes
        self._axes = _choose("axes", axes, _library.AXES)
        self._arrays: dict[str, Array] = {}
        self.time = float(time)
        self.resolution = self._checked_resolution(resolution)
        names = [fields] if isinstance(fields, str) else list(fields or ())
        if names:
            self._compute(names)

    def _checked_resolution(self, resolution: int | None) -> int:
        if resolution is None:
            return self._sea.map_resolution()
        # Before an array of that size is made.
        if resolution not in [32 << n for n in range(9)]:
            raise _library.error(
                f"resolution = {resolution}; allowed: a power of two, 32 .. 8192",
                _library.INVALID_ARGUMENT,
            )
        return int(resolution)

    def _compute(self, names: list[str]) -> None:
        for name in names:
            _choose("field", name, tuple(PRODUCTS))
        with self._sea._lock:
            if self._changes != self._sea._changes:
                raise _library.error(
                    f"the sea was changed after this surface was made, before {names[0]} was "
                    "looked at: name it in surface(..., fields=[...]), or make a new surface",
                    _library.INVALID_ARGUMENT,
                )
            arrays = self._sea._evaluate(self.time, self.resolution, self._axes, names)
        self._arrays.update(zip(names, arrays, strict=True))

    def _field(self, name: str) -> Array:
        if name not in self._arrays:
            self._compute([name])
        return self._arrays[name]

    @property
    def height(self) -> Array:
        """Metres, (R, R)."""
        return self._field("height")

    @property
    def displacement(self) -> Array:
        """Offset of each sample's point, metres, (R, R, 3); its z is the height."""
        return self._field("displacement")

    @property
    def slope(self) -> Array:
        """dh/dx and dh/dy before displacement, (R, R, 2)."""
        return self._field("slope")

    @property
    def normal(self) -> Array:
        """Unit normal of the displaced surface, (R, R, 3)."""
        return self._field("normal")

    @property
    def jacobian(self) -> Array:
        """Area of the displaced surface over that at rest, seen from above, (R, R)."""
        return self._field("jacobian")

    @property
    def whitecap(self) -> Array:
        """Foam that is made now, 0 .. 1, (R, R)."""
        return self._field("whitecap")

    @property
    def foam(self) -> Array:
        """Foam that is there, 0 .. 1, (R, R)."""
        return self._field("foam")

    @property
    def cover(self) -> Array:
        """Share of the water that foam hides, 0 .. 1, (R, R); from far away its mean is seen."""
        return self._field("cover")

    @property
    def velocity(self) -> Array:
        """d/dt of the displaced point, m/s, (R, R, 3)."""
        return self._field("velocity")

    @property
    def derivatives(self) -> Array:
        """d dx/dx, d dy/dy and d dx/dy (which is d dy/dx) of the offset, by label, (R, R, 3)."""
        return self._field("derivatives")
