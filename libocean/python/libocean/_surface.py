# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Surface, the maps of a sea at one time or of a terrain, and the table of its fields."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _abi, _library
from ._answers import Array
from ._checks import resolution as checked_resolution
from ._checks import time_of_maps, words
from ._library import choose
from ._read_only import ReadOnly

if TYPE_CHECKING:
    from ._sea import Sea
    from ._terrain import Terrain

_CHANNELS = tuple(_abi.CHANNELS)

CHANNELS = _CHANNELS[: _CHANNELS.index("wear")]
"""The channels of waves, in the order of the C enum."""

_MASK_TEXTS = {
    "wear": "Floors of gullies -1 .. crests between them 1, (R, R).",
    "gully": "Floors of gullies, 0 .. 1, (R, R).",
    "ridge": "Crests between gullies, 0 .. 1, (R, R).",
    "flow": "The area that drains through each sample [m2], (R, R).",
    "deposit": "Ground that streams laid down, 0 .. 1, (R, R).",
    "streambed": "Channels of streams, 0 .. 1, (R, R).",
    "wetness": "Wetness of the ground by its drainage or by waves that run up, 0 .. 1, (R, R).",
    "beach": "Sand of beaches, above and under water, 0 .. 1, (R, R).",
    "cliff": "Cliffs and rocks of exposed shores, 0 .. 1, (R, R).",
    "shelter": "Shelter of the nearest shore from the sea, 0 .. 1, (R, R).",
    "depth": "The height of the water over the bed [m], below 0 where it is dry, (R, R).",
    "breaking": "Fronts of waves that break by the depth, 0 .. 1, (R, R).",
    "trail": "White water behind hulls, 0 .. 1, (R, R).",
    "dry": "1 inside the water lines of hulls, 0.5 on them, 0 outside, (R, R).",
}
MASKS = _CHANNELS[len(CHANNELS) :]
"""The masks of terrains, of seas over a bed and of seas with hulls, in the order of the C enum."""


def channel_number(name: str) -> int:
    """Returns the number of a channel or a mask in the C enum."""
    if name not in MASKS:
        choose("channel", name, CHANNELS)
    return _abi.CHANNELS[name]


class Product(NamedTuple):
    """A field of a Surface."""

    channels: tuple[str, ...]
    doc: str


PRODUCTS = {
    "height": Product(("height",), "The height of each sample's point [m], (R, R)."),
    "displacement": Product(
        ("dx", "dy", "height"),
        "The offset of each sample's point [m], (R, R, 3); its z is the height.",
    ),
    "slope": Product(("slope_x", "slope_y"), "dh/dx and dh/dy before displacement, (R, R, 2)."),
    "normal": Product(("nx", "ny", "nz"), "The unit normal of the displaced surface, (R, R, 3)."),
    "jacobian": Product(
        ("jacobian",),
        "The area of the displaced surface over its area at rest, seen from above, (R, R).",
    ),
    "whitecap": Product(("whitecap",), "The foam that the sea makes now, 0 .. 1, (R, R)."),
    "foam": Product(("foam",), "The foam that has gathered, 0 .. 1, (R, R)."),
    "velocity": Product(("vx", "vy", "vz"), "d/dt of the displaced point [m/s], (R, R, 3)."),
    "derivatives": Product(
        ("dx_x", "dy_y", "dx_y"),
        "d dx/dx, d dy/dy and d dx/dy (which is d dy/dx) of the offset, by label, (R, R, 3).",
    ),
    "cover": Product(
        ("cover",),
        "The share of the water that foam hides, 0 .. 1, (R, R); its mean is the foam seen from "
        "afar.",
    ),
    **{mask: Product((mask,), text) for mask, text in _MASK_TEXTS.items()},
}
"""The fields of a Surface by name; the last ones are the masks of terrains that make
them, and of seas over a bed."""


class Surface(ReadOnly):
    """The maps of one sea at one time, or of a terrain, as numpy arrays [j, i] or
    [j, i, component], float32. Each field of PRODUCTS is a property. A pickle holds the fields that
    are computed, and no others. A copy looks at the same sea."""

    _noun = "surface"
    _instead = "set() of its sea or terrain sets a parameter, and surface() makes a new surface"

    height: Array
    displacement: Array
    slope: Array
    normal: Array
    jacobian: Array
    whitecap: Array
    foam: Array
    velocity: Array
    derivatives: Array
    cover: Array
    wear: Array
    gully: Array
    ridge: Array
    flow: Array
    deposit: Array
    streambed: Array
    wetness: Array
    beach: Array
    cliff: Array
    shelter: Array
    depth: Array
    breaking: Array
    trail: Array
    dry: Array

    def __init__(
        self,
        subject: Sea | Terrain | None = None,
        time: float = 0.0,
        resolution: int | None = None,
        fields: Iterable[str] | None = None,
        axes: str = "zup",
    ) -> None:
        if subject is None:
            raise TypeError("a surface is made by surface() of a sea or a terrain")
        self._subject: Sea | Terrain | None = subject  # None in one that was pickled
        self._changes = subject._changes
        self._axes = choose("axes", axes, _abi.AXES)
        self._arrays: dict[str, Array] = {}
        self._time = time_of_maps(time)
        own = subject.map_resolution()  # checked before an array of that size is made
        self._resolution = own if resolution is None else checked_resolution(resolution, own)
        names = words("fields", fields)
        if names:
            self._compute(names)

    @property
    def time(self) -> float:
        """The time of the maps [s]."""
        return self._time

    @property
    def resolution(self) -> int:
        """The samples per side of the maps."""
        return self._resolution

    def __repr__(self) -> str:
        side = self.resolution
        names = ", ".join(self._arrays) or "none"
        return f"<libocean.Surface: {self.time:g} s, {side} x {side} samples, computed: {names}>"

    def __copy__(self) -> Surface:
        twin = object.__new__(Surface)
        twin.__dict__.update(self.__dict__, _arrays=dict(self._arrays))
        return twin

    def __deepcopy__(self, memo: dict[int, Any]) -> Surface:
        twin = self.__copy__()
        twin._arrays = {name: array.copy() for name, array in self._arrays.items()}
        return twin

    def __getstate__(self) -> dict[str, Any]:
        """Returns what a pickle holds: the arrays that are computed, without the sea."""
        if not self._arrays:
            raise _library.error(
                "this surface has no field to pickle: name them in surface(..., fields=[...])",
                _abi.INVALID_ARGUMENT,
            )
        return {**self.__dict__, "_subject": None}

    def _compute(self, names: list[str]) -> None:
        for name in names:
            choose("field", name, tuple(PRODUCTS))
        if self._subject is None:
            raise _library.error(
                f"{names[0]} was not computed before this surface was pickled; it has "
                + ", ".join(self._arrays),
                _abi.INVALID_ARGUMENT,
            )
        with self._subject._lock:
            if self._changes != self._subject._changes:
                raise _library.error(
                    f"the {self._subject._noun} was changed after this surface was made, before "
                    f"{names[0]} was looked at: name it in surface(..., fields=[...]), or make a "
                    "new surface",
                    _abi.INVALID_ARGUMENT,
                )
            arrays = self._subject._evaluate(self._time, self._resolution, self._axes, names)
        self._arrays.update(zip(names, arrays, strict=True))

    def _field(self, name: str) -> Array:
        if name not in self._arrays:
            self._compute([name])
        return self._arrays[name]


def _property_of(name: str) -> property:
    return property(lambda surface: surface._field(name), doc=PRODUCTS[name].doc)


for _name in PRODUCTS:
    setattr(Surface, _name, _property_of(_name))
