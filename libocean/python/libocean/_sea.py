# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Sea, an open sea file."""

from __future__ import annotations

import ctypes
import json
import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from . import _abi
from ._answers import DETAIL_BAND, Array, Detail, FoundCrest, WakeDomain, pointer_to
from ._checks import columns_and_rows, number, resolution_or_0, row, text, whole
from ._library import choose
from ._maps import Maps
from ._queries import Queries
from ._regions import region_arrays, region_buffers, region_request
from ._surface import Surface

FARM_MARK = b"Written by `ocean farm`"
"""The words in each file of a job, by which a later job may replace it."""


class Sea(Maps, Queries):
    """An open sea. Made by open(), parse() and preset(); a context manager. Calls of several
    threads wait for each other: clone the sea for each thread to work in parallel. Ctrl-C ends a
    call and leaves the sea as it was.

    A pickle holds `text`, so that multiprocessing can hand a sea to another process. `progress` and
    `jobs` are lost. Files that the text names are read again, from the folder of the sea file. An
    array as the bed is part of the text up to 1 MB; with a larger one pickling raises
    UnsupportedError. The foam is the same, but with foam_start = "empty", where it begins anew."""

    def surface(
        self,
        time: float,
        resolution: int | None = None,
        fields: Iterable[str] | None = None,
        axes: str = "zup",
    ) -> Surface:
        """Returns the sea at `time` [s], on resolution x resolution samples of one period (default:
        the sea's own, four times that for cascades). `fields` are computed now, together; without
        it each field is computed when it is first read. axes: "zup" (x, y, z), "yup" (x, z, -y) or
        "tnb" (x, z, y)."""
        return Surface(self, time, resolution, fields, axes)

    def region(
        self,
        time: float,
        origin: tuple[float, float],
        samples: tuple[int, int],
        cell: float,
        fields: Iterable[str] = ("displacement",),
        axes: str = "zup",
    ) -> dict[str, Array]:
        """Returns fields of a region of a sea over a bed or with hulls at `time` [s] by name,
        arrays (rows, columns) or (rows, columns, 3), by label. origin: the place of sample (0, 0)
        [m]; samples: columns and rows, `cell` apart [m]. Over a bed it has "depth", "breaking" and
        "wetness" beside the fields of every sea, with hulls "trail" and "dry". The first call
        computes where the waves go over the bed, which takes seconds."""
        maps = region_arrays(fields, samples)
        request = region_request(origin, cell, maps.values(), axes)
        self._call("ocean_region", number("time", time), ctypes.byref(request))
        return {name: array for name, (array, _) in maps.items()}

    def fill_region(
        self,
        time: float,
        buffers: Iterable[tuple[Array, Sequence[str]]],
        origin: tuple[float, float],
        cell: float,
        axes: str = "zup",
    ) -> None:
        """Writes a region as region() returns it into existing float32 arrays of one shape, each of
        shape (rows, columns, n) with the names of its n channels, 1 to 4 of those of fill(),
        "depth", "breaking" and "wetness" over a bed, "trail" and "dry" with hulls; "" leaves a
        component as it is."""
        request = region_request(origin, cell, region_buffers(buffers), axes)
        self._call("ocean_region", number("time", time), ctypes.byref(request))

    @property
    def wake_count(self) -> int:
        """The number of hulls, each of which makes a wake."""
        count = ctypes.c_size_t()
        self._call("ocean_wake_count", ctypes.byref(count))
        return count.value

    def wake_domain(self, hull: int, time: float) -> WakeDomain:
        """Returns the samples of the wake of a hull, 0 .. wake_count - 1, at `time` [s]: a square
        that moves with the hull by whole cells."""
        own = _abi.Domain(ctypes.sizeof(_abi.Domain))
        self._of_wake("ocean_wake_domain", hull, time, own)
        return WakeDomain((own.x, own.y), own.cell, own.columns)

    def fill_wake(
        self,
        hull: int,
        time: float,
        buffers: Iterable[tuple[Array, Sequence[str]]],
        origin: tuple[float, float],
        cell: float,
        axes: str = "zup",
    ) -> None:
        """Writes the wake of a hull without the open sea, by label, as fill_region() does. In each
        channel that adds up ("dx", "dy", "height", slopes, velocities, derivatives of the offset) a
        region of the sea is the sum of the open sea and of its wakes. A wake is 0 beyond its
        square; any origin and cell are allowed. It has no foam, and of the masks "trail" alone,
        which fades out towards the border of the square."""
        request = region_request(origin, cell, region_buffers(buffers), axes)
        self._of_wake("ocean_wake_region", hull, time, request)

    def add_wake(
        self,
        hull: int,
        time: float,
        buffers: Iterable[tuple[Array, Sequence[str]]],
        origin: tuple[float, float],
        cell: float,
        axes: str = "zup",
    ) -> None:
        """Adds the wake of a hull to a region of the open sea that the buffers hold; they are as
        those of fill_wake(). Channels that add up, and "trail", are sums then; "jacobian" is one to
        first order, and normals, whole in one buffer, are tilted to first order."""
        request = region_request(origin, cell, region_buffers(buffers), axes)
        self._of_wake("ocean_wake_add", hull, time, request)

    def _of_wake(self, function: str, hull: int, time: float, told: ctypes.Structure) -> None:
        at = number("time", time)
        self._call(function, whole("hull", hull, 0), at, ctypes.byref(told))

    def bed_region(
        self, origin: tuple[float, float], samples: tuple[int, int], cell: float
    ) -> Array:
        """Returns the heights of the bed over still water [m], an array (rows, columns): linear
        between its samples, and beyond the bed those of its border. origin: the place of the first
        one [m]; samples: columns and rows, `cell` apart [m]."""
        columns, rows = columns_and_rows(samples)
        place = *row("origin", origin, 2), number("cell", cell)
        heights = np.empty((rows, columns), np.float32)
        self._call("ocean_bed_region", *place, columns, rows, pointer_to(heights))
        return heights

    def find_crest(
        self, start: float, end: float, box: tuple[float, float, float, float] | None = None
    ) -> FoundCrest:
        """Returns the highest crest of the sea from one time to another [s]. box: west, south, east
        and north of the place to search [m]; None: one period. It computes 24 maps for each peak
        period, max 20000."""
        place = None if box is None else (ctypes.c_double * 4)(*row("box", box, 4))
        crest = _abi.Crest(ctypes.sizeof(_abi.Crest))
        times = number("start", start), number("end", end)
        self._call("ocean_find_crest", *times, place, ctypes.byref(crest))
        return FoundCrest(crest.time, crest.x, crest.y, crest.height)

    def provenance(
        self,
        frame: int,
        time: float,
        field: str | None = None,
        *,
        axes: str = "zup",
        resolution: int | None = None,
        detail: Detail | None = None,
    ) -> dict[str, str]:
        """Returns the strings by which `ocean bake` labels a file of a frame, for headers of other
        files: "ocean:sea", "ocean:frame", "ocean:time" ... time: of the frame [s]. field: the
        product in the file, one of PRODUCTS, or "detail1" .. "detail3" beside maps of `resolution`;
        None: without strings about a product. axes: the order of the file's vectors. detail: of the
        frame, whose band the file holds."""
        size = ctypes.sizeof(_abi.ProvenanceRequest)
        request = _abi.ProvenanceRequest(size, number("time", time), whole("frame", frame))
        request.axes = choose("axes", axes, _abi.AXES)
        request.field = None if field is None else text("field", field)
        request.resolution = resolution_or_0(resolution)
        if detail is not None and field is not None and field.startswith("detail"):
            fields = [f"detail{n}" for n in range(1, len(detail.bands) + 1)]
            band = detail.bands[choose("field", field, fields)].as_struct()
            request.band, request.band_size = pointer_to(band), DETAIL_BAND.itemsize
            request.residual = detail.residual
        strings: dict[str, str] = json.loads(
            self._text("ocean_provenance_json", ctypes.byref(request))
        )
        return strings

    def farm_job(
        self,
        engine: str,
        output: str,
        frames: Iterable[int],
        *,
        options: Iterable[str] = (),
        render: str | None = None,
        frames_per_task: int = 0,
        threads: int = 0,
        minutes: int = 0,
        memory_bytes: int = 0,
    ) -> dict[str, str]:
        """Returns the files of a job for the engine of a render farm ("slurm", "openjd" or
        "flamenco") as texts by name: it bakes the sea in parts, checks them and renders a scene,
        .pov or .blend. output: -o of `ocean bake`; it and `render` start from the folder of the job
        where they are relative. options: further words of `ocean bake`. frames_per_task: 0 = all;
        threads: cores of a task, 0 = those that it gets; minutes: after which the engine ends a
        task, memory_bytes: of a task, 0 = unknown."""
        numbers = [whole("frame", frame) for frame in frames]
        words = [text("an option", word) for word in options]
        request = _abi.FarmRequest(
            ctypes.sizeof(_abi.FarmRequest),
            text("engine", engine),
            text("output", output),
            (ctypes.c_int32 * len(numbers))(*numbers),
            len(numbers),
            (ctypes.c_char_p * len(words))(*words),
            len(words),
            None if render is None else text("render", render),
            whole("frames_per_task", frames_per_task, 0),
            whole("threads", threads, 0),
            whole("minutes", minutes, 0),
            memory_bytes=whole("memory_bytes", memory_bytes, 0, 2**64 - 1),
        )
        files: dict[str, str] = json.loads(self._text("ocean_farm_job_json", ctypes.byref(request)))
        return files

    def write_farm_job(
        self,
        folder: str | os.PathLike[str],
        engine: str,
        output: str,
        frames: Iterable[int],
        **how: Any,
    ) -> list[str]:
        """Writes the files of farm_job() into a folder, which is made, and returns their paths.
        FileExistsError, before any is written, if one of the names is that of another file."""
        files = self.farm_job(engine, output, frames, **how)
        paths = {Path(folder) / name: content for name, content in files.items()}
        for path in paths:
            if path.exists() and FARM_MARK not in path.read_bytes():
                raise FileExistsError(f"{path} exists and is not of a farm job")
        Path(folder).mkdir(parents=True, exist_ok=True)
        for path, content in paths.items():
            path.write_text(content, encoding="utf-8", newline="\n")
        return [str(path) for path in paths]
