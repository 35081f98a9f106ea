# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Terrain, an open terrain file."""

from __future__ import annotations

import ctypes
import json
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from . import _abi
from ._answers import SAMPLE, Array, pointer_to
from ._checks import accuracy, hide, number, points_of, row, text
from ._library import choose
from ._maps import MapWriter
from ._regions import region_arrays, region_buffers, region_request
from ._surface import Surface

STAGES = ("noise", "transform", "filter", "filtered", "height")
"""The steps of the synthesis, in their order."""


class GroundSamples(NamedTuple):
    """The ground at n points, as arrays of n rows."""

    height: Array
    """(n,) [m]."""
    normal: Array
    """(n, 3), unit, up."""
    height_error: float
    """The rms difference of the heights from the exact sum over all waves [m]."""


class TerrainDomain(NamedTuple):
    """The samples of a terrain's own map."""

    origin: tuple[float, float]
    """The place of sample (0, 0) [m]."""
    cell: float
    """The distance of samples [m]."""
    samples: tuple[int, int]
    """Columns and rows."""
    wraps: bool
    """True for a tile that repeats, False for a land that exists once."""


class TerrainMesh(NamedTuple):
    """Triangles of land that share their vertices."""

    positions: npt.NDArray[np.float64]
    """(n, 3): x, y, z of the world [m]."""
    corners: npt.NDArray[np.uint32]
    """(m, 3): numbers of vertices, counter-clockwise from above."""


class Terrain(MapWriter):
    """An open terrain. Made by terrain(), open_terrain(), parse_terrain() and terrain_preset(); a
    context manager. Calls of several threads wait for each other: clone the terrain for each thread
    to work in parallel. Ctrl-C ends a call and leaves the terrain as it was. A pickle holds `text`;
    `progress` and `jobs` are lost."""

    _noun = "terrain"
    _prefix = "ocean_terrain_"
    _makers = "libocean.terrain(), open_terrain(), parse_terrain() or terrain_preset()"

    def _summary(self) -> str:
        own = self.domain
        columns, rows = own.samples
        kind = "a tile" if own.wraps else "land"
        return f"{kind} of {columns} x {rows} samples, {own.cell:g} m apart"

    @property
    def domain(self) -> TerrainDomain:
        """The samples of the terrain's own map."""
        own = _abi.Domain(ctypes.sizeof(_abi.Domain))
        self._call("ocean_terrain_domain", ctypes.byref(own))
        return TerrainDomain((own.x, own.y), own.cell, (own.columns, own.rows), bool(own.wraps))

    def map_resolution(self) -> int:
        """Returns the samples per side of a map whose resolution is not given."""
        return self.domain.samples[0]

    def region(
        self,
        origin: tuple[float, float],
        samples: tuple[int, int],
        cell: float,
        fields: Iterable[str] = ("height",),
        axes: str = "zup",
    ) -> dict[str, Array]:
        """Returns fields of a region by name, arrays (rows, columns) or (rows, columns, 3). origin:
        the place of sample (0, 0) [m]; samples: columns and rows, `cell` apart [m]. A tile repeats;
        beyond the rectangle of a land that exists once the heights are those of its edge. Regions
        of one cell join bit by bit where their corners are whole numbers of cells from (0, 0)."""
        maps = region_arrays(fields, samples)
        request = region_request(origin, cell, maps.values(), axes)
        self._call("ocean_terrain_region", ctypes.byref(request))
        return {name: array for name, (array, _) in maps.items()}

    def fill_region(
        self,
        buffers: Iterable[tuple[Array, Sequence[str]]],
        origin: tuple[float, float],
        cell: float,
        axes: str = "zup",
    ) -> None:
        """Writes a region into existing arrays, all together: each of shape (rows, columns, n) with
        the names of its n channels, 1 to 4 of those of fill() and the terrain's masks; "" leaves a
        component as it is. The arrays are float32 and of one shape, each row without gaps. The
        region is as that of region()."""
        request = region_request(origin, cell, region_buffers(buffers), axes)
        self._call("ocean_terrain_region", ctypes.byref(request))

    def mesh(
        self,
        camera: tuple[float, float, float],
        *,
        ground: float | None = None,
        farthest: float = 150e3,
        spacing: float = 0.5,
        range: float = 140.0,  # the word of the C API
    ) -> TerrainMesh:
        """Returns the land around a camera as one mesh without cracks, fine near it and coarser by
        a factor of 2 with each doubling of the distance. ground: the height under the camera [m],
        from which distances are taken, None: that of the land; farthest: the distance up to which
        there is a mesh [m]; spacing: of the vertices at the camera [m]; range: the distance at
        which it has doubled once, in spacings."""
        place = row("camera", camera, 3)
        if ground is None:
            ground = float(self.query(place[:2]).height[0])
        request = _abi.MeshRequest(
            ctypes.sizeof(_abi.MeshRequest),
            *(*place, number("ground", ground), number("farthest", farthest)),
            *(number("spacing", spacing), number("range", range)),
        )
        counts = ctypes.c_size_t(), ctypes.c_size_t()

        def ask() -> None:
            self._call("ocean_terrain_mesh", ctypes.byref(request), *map(ctypes.byref, counts))

        with self._lock:
            ask()
            positions = np.empty((counts[0].value, 3), np.float64)
            corners = np.empty((counts[1].value, 3), np.uint32)
            request.positions, request.vertex_capacity = pointer_to(positions), len(positions)
            request.corners, request.triangle_capacity = pointer_to(corners), len(corners)
            ask()
        return TerrainMesh(positions, corners)

    def surface(
        self,
        resolution: int | None = None,
        fields: Iterable[str] | None = None,
        axes: str = "zup",
    ) -> Surface:
        """Returns the land on resolution x resolution samples of one tile (default: the terrain's
        own): the same waves on a finer or coarser map; set("resolution", R) adds waves. It has the
        fields height, normal and slope; `fields` are computed now, together. axes: "zup" (x, y, z),
        "yup" (x, z, -y) or "tnb" (x, z, y)."""
        return Surface(self, 0.0, resolution, fields, axes)

    def fill(
        self,
        buffers: Iterable[tuple[Array, Sequence[str]]],
        axes: str = "zup",
        *,
        seam: bool = False,
    ) -> None:
        """Writes maps into existing arrays, all together: each of shape (R, R, n) with the names of
        its n channels, 1 to 4 of "height", "nx", "ny", "nz", "slope_x", "slope_y". The arrays are
        float32 and of one R, each row without gaps. seam: (R + 1, R + 1, n), which repeats the
        first samples a period on."""
        self._fill(0.0, buffers, axes, seam)

    def query(
        self,
        points: npt.ArrayLike,
        *,
        resolution: int = 0,
        refine: int = 1,
        exact: bool = False,
    ) -> GroundSamples:
        """Returns height and normal at n world points (x, y), at any distance. resolution: counts
        the waves that a map of that resolution holds. refine: 2, 4 ... for smaller errors. exact:
        the sum over all waves, a hundred times as slow."""
        where, hidden = points_of("points", points, 2)
        error = ctypes.c_double()
        how = *accuracy(resolution, refine, exact), False, ctypes.pointer(error)
        answers = self._samples(
            "ocean_terrain_query_points", _abi.QueryRequest, SAMPLE, where, 0.0, how
        )
        hide(answers, hidden)
        return GroundSamples(answers["height"], answers["normal"], error.value)

    def stage(self, step: str) -> Array:
        """Returns one step of the synthesis, (R, R): "noise" (white, in space), "transform" (the
        magnitudes of its Fourier transform), "filter" and "filtered" [m], these with k = 0 at
        [R / 2, R / 2], or "height" [m]."""
        choose("step", step, STAGES)
        with self._lock:
            side = self.map_resolution()
            plane = np.empty((side, side), np.float32)
            self._call("ocean_terrain_stage", step.encode(), pointer_to(plane), plane.size)
        return plane

    def provenance(self, field: str | None = None, *, axes: str = "zup") -> dict[str, str]:
        """Returns the strings by which `ocean terrain` labels a file, for headers of other files:
        "ocean:terrain", "ocean:period" ... field: the product in the file, "height", "normal" or
        "slope"; None: without strings about a product."""
        name = None if field is None else text("field", field)
        turn = choose("axes", axes, _abi.AXES)
        strings: dict[str, str] = json.loads(
            self._text("ocean_terrain_provenance_json", name, turn)
        )
        return strings
