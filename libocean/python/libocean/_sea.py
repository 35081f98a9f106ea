# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Sea, an open sea file."""

from __future__ import annotations

import ctypes
import json
from collections.abc import Iterable
from typing import Any

from . import _library
from ._answers import DETAIL_BAND, Detail
from ._library import ProvenanceRequest, call, choose
from ._maps import Maps
from ._queries import Queries
from ._surface import Surface


class Sea(Maps, Queries):
    """An open sea. Made by open(), parse() and preset(); a context manager. Calls of several
    threads wait for each other: clone the sea for each thread to work in parallel. Ctrl-C ends a
    call and leaves the sea as it was."""

    def __enter__(self) -> Sea:
        return self

    def clone(self) -> Sea:
        """Returns the same sea for another thread. Both share the data that this one has built,
        until either changes."""

        def share(options: Any, out: Any) -> None:
            call("ocean_clone", self._open_handle(), options, out)

        with self._lock:
            return Sea(share, *self._options)

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
        request = ProvenanceRequest(ctypes.sizeof(ProvenanceRequest), time, frame)
        request.axes = choose("axes", axes, _library.AXES)
        request.field = None if field is None else field.encode()
        request.resolution = resolution or 0
        if detail is not None and field is not None and field.startswith("detail"):
            band = detail.bands[int(field.removeprefix("detail")) - 1].as_struct()
            request.band, request.band_size = band.ctypes.data, DETAIL_BAND.itemsize
            request.residual = detail.residual
        return json.loads(self._text("ocean_provenance_json", ctypes.byref(request)))
