# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The water in a box as OpenVDB files: `surface`, a level set, and `vel`, its velocity. No Blender
in here: it runs in a thread of its own, which may be asked to stop at any time.

    frames -> the library's queries -> columns -> OpenVDB's module, or else `ocean bake` -> files

Either way the files have the same headers, by which they are recognised.
"""

from __future__ import annotations

import dataclasses
import math
from decimal import Decimal
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..bake.bake_job import Frame, Job
from ..bake.exr_files import NotWholeError, replacing
from ..shared.native import libocean
from .vdb_files import FileError, read_header

if TYPE_CHECKING:
    from ..legacy.ocean_command import Command

SURFACE, VELOCITY = "surface", "vel"
BAND = 3
"""Voxels on either side of the surface that a level set knows the distance of."""

TO_THE_CREST = math.inf
"""In the place of a box's top."""


class VolumeError(Exception):
    """A volume cannot be written; the sentence says why."""


class StoppedError(Exception):
    """The user has stopped the job."""


def shortest(value: float) -> str:
    """As std::to_chars writes a number: the shorter of 100000 and 1e+05, the first where equal."""
    negative, digits, exponent = Decimal(repr(float(value))).normalize().as_tuple()
    sign = "-" * negative
    text = "".join(map(str, digits))
    if text == "0":
        return sign + text
    power = len(text) - 1 + exponent
    scientific = f"{text[0]}{'.' * (len(text) > 1)}{text[1:]}e{power:+03d}"
    if exponent >= 0:
        plain = str(abs(int(float(value))))
    else:
        whole = text[: max(power + 1, 0)]
        plain = f"{whole or 0}.{text[len(whole) :].rjust(-exponent, '0')}"
    return sign + (plain if len(plain) <= len(scientific) else scientific)


@dataclasses.dataclass(frozen=True)
class Settings:
    """Metres; heights from still water."""

    low: tuple[float, float, float]
    high: tuple[float, float, float]
    voxel: float
    velocity_voxel: float
    use_half: bool
    resolution: int
    """Samples a side of the map that holds the waves."""

    def _texts(self) -> dict[str, str]:
        top = "crest" if self.high[2] == TO_THE_CREST else shortest(self.high[2])
        sides = [shortest(side) for side in (*self.low, *self.high[:2])]
        return {
            "resolution": str(self.resolution),
            "box": ",".join([*sides, top]),
            "voxel": shortest(self.voxel),
            "velocity_voxel": shortest(self.velocity_voxel),
            "type": "half" if self.use_half else "float",
        }

    def options(self) -> list[str]:
        """Returns the settings as options of `ocean bake`."""
        return [f"--{name.replace('_', '-')}={text}" for name, text in self._texts().items()]

    def strings(self, sea, frame: Frame) -> dict[str, str]:
        """Returns the strings of a file's header. sea: the libocean.Sea of the frame."""
        return {
            **sea.provenance(frame.number, frame.time),
            "ocean:axes": "zup",
            "ocean:field": f"{SURFACE},{VELOCITY}",
            "ocean:units": "m, m/s",
            **{f"ocean:{name}": text for name, text in self._texts().items()},
        }


# Files --------------------------------------------------------------------------


def is_there(path: Path, strings: dict[str, str]) -> bool:
    """Returns whether a file is whole and has these strings in its header."""
    try:
        found = read_header(path)
    except (OSError, FileError):
        return False
    return all(found.get(name) == text for name, text in strings.items())


# Grids --------------------------------------------------------------------------

_PIECE = 1 << 16  # columns that are asked for at a time
_MOST_COLUMNS = 1 << 26
_MOST_VOXELS = 1 << 21  # that are copied into a grid at a time
_SMALLEST_MAP = 32  # samples a side


def _voxels(low: float, high: float, size: float, beyond: int) -> np.ndarray:
    """Numbers of the voxels from low to high, and so many beyond each."""
    rounding = 1e-9  # a rounding error of the division is no voxel
    first = math.ceil(low / size - rounding) - beyond
    return np.arange(first, math.floor(high / size + rounding) + beyond + 1)


def _side_distance(low: float, high: float, at: np.ndarray) -> np.ndarray:
    """To a side of the box from outside it; below 0 from inside."""
    return np.maximum(low - at, at - high)


class _Columns:
    """Columns of voxels in a box of the sea, and so many around it, at a time."""

    def __init__(
        self, sea, time: float, settings: Settings, stop, size: float, beyond: int
    ) -> None:
        self.sea, self.time, self.stop, self.size = sea, time, stop, size
        self.i, self.j = (
            _voxels(settings.low[axis], settings.high[axis], size, beyond) for axis in (0, 1)
        )
        self.shape = len(self.i), len(self.j)
        if math.prod(self.shape) > _MOST_COLUMNS:
            raise VolumeError(f"{self.shape[0]} x {self.shape[1]} columns of voxels are too many")
        self.height = np.empty(self.shape)
        self.normal_z = np.empty(self.shape)
        folded = 0
        for piece, points in self._pieces():
            samples = sea.samples(points, time, resolution=settings.resolution)
            self.height.flat[piece] = samples.height
            self.normal_z.flat[piece] = samples.normal[:, 2]
            folded += int(samples.folded.sum())
        self.folded = folded
        # A level set that ends above the crests: the band is whole.
        top = min(settings.high[2], self.height.max() + BAND * size)
        self.low = settings.low
        self.high = (*settings.high[:2], max(top, settings.low[2] + 1e-3))
        self.k = _voxels(self.low[2], self.high[2], size, beyond)

    def _pieces(self):
        """Their places (x, y), piece by piece."""
        for first in range(0, math.prod(self.shape), _PIECE):
            if self.stop.is_set():
                raise StoppedError
            at = np.arange(first, min(first + _PIECE, math.prod(self.shape)))
            i, j = np.divmod(at, self.shape[1])
            yield slice(first, first + len(at)), self.size * np.stack([self.i[i], self.j[j]], 1)

    def velocity(self, z: float, resolution: int) -> np.ndarray:
        """(columns along x, along y, 3), m/s, of the water at that height."""
        velocity = np.empty((math.prod(self.shape), 3), np.float32)
        for piece, points in self._pieces():
            places = np.insert(points, 2, z, axis=1)
            velocity[piece] = self.sea.water(places, self.time, resolution=resolution).velocity
        return velocity.reshape(*self.shape, 3)

    def neighbours(self) -> tuple[np.ndarray, np.ndarray]:
        """Returns the lowest and the highest surface in a column and the four beside it."""
        around = np.pad(self.height, 1, mode="edge")
        beside = [around[2:, 1:-1], around[:-2, 1:-1], around[1:-1, 2:], around[1:-1, :-2]]
        return (
            np.minimum.reduce([self.height, *beside]),
            np.maximum.reduce([self.height, *beside]),
        )

    def box_distance(self, part: slice) -> np.ndarray:
        """To the box, of the columns `part` along x."""
        axes = [self.i[part, None, None], self.j[None, :, None], self.k[None, None, :]]
        sides = [
            _side_distance(low, high, self.size * at).astype(np.float32)
            for low, high, at in zip(self.low, self.high, axes, strict=True)
        ]
        inside = np.maximum(np.maximum(sides[0], sides[1]), sides[2])
        outside = np.sqrt(sum(np.maximum(side, 0.0) ** 2 for side in sides))
        return np.where(inside <= 0.0, inside, outside)

    def surface_distance(self, part: slice, lowest: np.ndarray, highest: np.ndarray) -> np.ndarray:
        """To the plane that touches the surface in each column. Where a crest has folded over,
        columns jump: water and air are never farther apart than the columns, or the level set had
        a hole."""
        z = self.size * self.k
        distance = (z - self.height[part, :, None]) * self.normal_z[part, :, None]
        is_below, is_above = z < highest[part, :, None], z >= lowest[part, :, None]
        np.minimum(distance, self.size, out=distance, where=is_below)
        np.maximum(distance, -self.size, out=distance, where=is_above)
        return distance.astype(np.float32)


def _make_surface(module, columns: _Columns):
    """The level set: negative in the water of the box."""
    size, background = columns.size, np.float32(BAND * columns.size)
    grid = module.FloatGrid(float(background))
    lowest, highest = columns.neighbours()
    step = max(1, _MOST_VOXELS // (columns.shape[1] * len(columns.k)))
    for first in range(0, columns.shape[0], step):
        if columns.stop.is_set():
            raise StoppedError
        part = slice(first, first + step)
        distance = columns.surface_distance(part, lowest, highest)
        np.maximum(distance, columns.box_distance(part), out=distance)
        # Voxels that far away get their sign from their neighbours, at the end.
        distance[np.abs(distance) >= background] = background
        start = (columns.i[first], columns.j[0], columns.k[0])
        grid.copyFromArray(distance, ijk=tuple(map(int, start)))
    grid.signedFloodFill()
    grid.name, grid.gridClass = SURFACE, module.GridClass.LEVEL_SET
    grid.transform = module.createLinearTransform(size)
    return grid


def _velocity_resolution(settings: Settings, period: float) -> int:
    """Samples of the map of the waves that the velocity's voxels hold: two of them, at least."""
    resolution = _SMALLEST_MAP
    while (
        2 * resolution <= settings.resolution
        and 2 * resolution * settings.velocity_voxel <= period * (1.0 + 1e-9)
    ):
        resolution *= 2
    return resolution


def _make_velocity(module, columns: _Columns, resolution: int):
    """Up to the band above the surface."""
    size = columns.size
    grid = module.Vec3SGrid((3e38, 3e38, 3e38))  # marks missing values: no water has it
    moved_at = math.nan  # the height that the motion is of
    for k in columns.k.tolist():
        is_there = size * k <= columns.height + BAND * size
        if not is_there.any():
            break
        z = min(size * k, 0.0)  # above still water as at it
        if z != moved_at:
            motion, moved_at = columns.velocity(z, resolution), z
        layer = np.where(is_there[..., None], motion, np.float32(3e38))
        start = (int(columns.i[0]), int(columns.j[0]), k)
        grid.copyFromArray(layer[:, :, None], ijk=start)
    grid.background = (0.0, 0.0, 0.0)
    grid.name = VELOCITY  # a name that Blender takes for motion
    grid.vectorType = module.VectorType.CONTRAVARIANT_RELATIVE
    grid.transform = module.createLinearTransform(size)
    return grid


# The job ------------------------------------------------------------------------


@dataclasses.dataclass(kw_only=True)
class VolumeJob(Job):
    """Frames that become volumes: by OpenVDB's module, or else by the command `ocean`."""

    folder: Path
    stem: str
    settings: Settings
    module: object | None
    command: Command | None

    replaced: int = 0
    """Frames in the place of others."""

    def path(self, frame: int) -> Path:
        """Blender finds the files of a sequence by the digits at their ends."""
        return self.folder / f"{self.stem}_{frame:04d}.vdb"

    def _bake(self, sea, resolved: str, frame: Frame) -> bool:
        path, period = self.path(frame.number), float(sea.get("patch_size"))
        strings = self.settings.strings(sea, frame)
        if not self.overwrite and is_there(path, strings):
            return not self.stop.is_set()
        is_other = path.exists()
        try:
            if self.module is not None:
                self._by_module(sea, frame, path, strings, period)
            else:
                self._by_command(resolved, frame)
        except StoppedError:
            return False
        self.written += 1
        self.replaced += is_other
        return True

    def arguments(self, sea: str, frames: str) -> list[str]:
        """Returns the arguments of `ocean`, to be run in the folder. A keyed sea is another one in
        each frame, so that the files that are there are replaced."""
        output = ["-o", f"./{self.stem}_####.vdb", "--frames", frames]
        return ["bake", sea, *output, "--overwrite", *self.settings.options()]

    def _by_command(self, sea: str, frame: Frame) -> None:
        arguments = self.arguments("-", str(frame.number))
        for event in self.command.run(arguments, self.folder, sea, self.stop):
            if event["event"] == "warning":
                self.warning = event["message"]

    def _by_module(self, sea, frame: Frame, path: Path, strings: dict, period: float) -> None:
        asked = self.settings
        columns = _Columns(sea, frame.time, asked, self.stop, asked.voxel, BAND)
        self._judge(columns, frame.time)
        grids = [_make_surface(self.module, columns)]
        columns = _Columns(sea, frame.time, asked, self.stop, asked.velocity_voxel, 1)
        resolution = _velocity_resolution(asked, period)
        grids.append(_make_velocity(self.module, columns, resolution))
        for grid in grids:
            grid.saveFloatAsHalf = asked.use_half
        header = {"creator": f"libocean {libocean.version}", **strings}
        with replacing(path) as temporary:
            self.module.write(str(temporary), grids, header)
            # The module does not say when the disk ends before the file does.
            if not is_there(temporary, strings):
                raise NotWholeError(path)

    def _judge(self, columns: _Columns, time: float) -> None:
        """In the words of `ocean bake`."""
        if columns.folded:
            self.warning = (
                f"at {time:g} s {columns.folded} of {columns.height.size} columns lie where the "
                "crests have folded over: they take the top sheet"
            )
        if columns.height.max() < columns.low[2]:
            self.warning = f"at {time:g} s no water reaches the box, and its surface is empty"
