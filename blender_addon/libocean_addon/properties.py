# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.libocean: the parameters of the sea, made from the library's parameter table.

Every parameter goes by the key it has in the sea file; those of a wave system are in `.waves`.
Numbers mean what they mean in the sea file: metres, seconds, degrees. A parameter that may be left
out has a switch, `use_KEY`; giving it a value turns it on.
"""

from __future__ import annotations

import contextlib
import functools
import json
import math
from collections.abc import Callable, Iterator
from typing import Any

import bpy
import numpy as np

from . import compat, sea_text, translations
from .native import libocean

TABLE: list[dict[str, Any]] = libocean.parameters()

_UNITS = {"m": "LENGTH", "m/s": "VELOCITY", "m/s^2": "ACCELERATION", "s": "TIME_ABSOLUTE"}
_DIVISORS = 5


listener: Callable[[bpy.types.Object], None] | None = None
"""Told of each object whose properties were set."""

_silence = 0


@contextlib.contextmanager
def quiet() -> Iterator[None]:
    """Many properties are set: the listener hears of it when somebody tells it."""
    global _silence
    _silence += 1
    try:
        yield
    finally:
        _silence -= 1


def is_quiet() -> bool:
    return _silence > 0


def tell(ob) -> None:
    if listener is not None and not is_quiet():
        listener(ob)


def entries(*, waves: bool) -> list[dict[str, Any]]:
    return [entry for entry in TABLE if (entry["section"] == "waves") == waves]


# From the table to properties -------------------------------------------------


def _description(entry: dict[str, Any]) -> str:
    unit = f" [{entry['unit']}]" if entry["unit"] else ""
    return f"{entry['help'].rstrip('.')}{unit}. Sea file: {entry['section']}.{entry['key']}"


def _changed(self, _context) -> None:
    tell(self.id_data)


def _switched_on(switch: str):
    def changed(self, context) -> None:
        if not is_quiet():
            with quiet():
                setattr(self, switch, True)
        _changed(self, context)

    return changed


def _named_anew(lines: str):
    """For the name of what a sea keeps a copy of, as lines of its file: the copy is of what was
    named before."""

    def changed(self, _context) -> None:
        if not is_quiet():
            setattr(self, lines, "")
        _changed(self, _context)

    return changed


# Parameters that name a file, or a part of one, and the property with the copy.
_COPIES = {
    "take": "take_lines",
    "file": "measured_record",
    "record": "measured_record",
    "place": "measured_record",
}


def _to_power_of_two(self, context) -> None:
    power = 1 << round(math.log2(self.resolution))
    if power != self.resolution:
        self.resolution = power  # which comes back here
        return
    _changed(self, context)


def _label(choice: str) -> str:
    return choice.replace("_", " ").capitalize()


def _number_limits(entry: dict[str, Any]) -> dict[str, Any]:
    keys = ("min", "max", "soft_min", "soft_max")
    limits = {key: entry[key] for key in keys if entry.get(key) is not None}
    if entry["type"] == "int":
        limits = {key: max(-(2**31), min(2**31 - 1, value)) for key, value in limits.items()}
    return limits


def _middle(entry: dict[str, Any]) -> float:
    """Where a parameter without a default begins: the middle of its soft range, by ratio where all
    of it is positive."""
    low, high = entry["soft_min"], entry["soft_max"]
    return float(f"{math.sqrt(low * high):.1g}") if low > 0 else (low + high) / 2


def _properties_of(entry: dict[str, Any]) -> dict[str, Any]:
    """The Blender properties of one parameter, by name."""
    key, kind = entry["key"], entry["type"]
    common = {
        "name": entry["label"],
        "description": _description(entry),
        "update": _changed,
        **compat.in_context(translations.SEA),
    }
    if kind == "text":
        subtype = "FILE_PATH" if key in ("file", "take") else "NONE"
        common["update"] = _named_anew(_COPIES[key]) if key in _COPIES else _changed
        return {key: bpy.props.StringProperty(**common, subtype=subtype)}
    if kind == "enum":
        items = [(choice, _label(choice), "") for choice in entry["choices"]]
        return {key: bpy.props.EnumProperty(**common, items=items, default=entry["default"])}
    if kind == "list":
        return {key: bpy.props.IntVectorProperty(**common, size=_DIVISORS, min=0)}
    common.update(_number_limits(entry))
    if kind == "int":
        if key == "resolution":
            common["update"] = _to_power_of_two
        return {key: bpy.props.IntProperty(**common, default=entry["default"])}
    common["unit"] = _UNITS.get(entry["unit"], "NONE")
    common["precision"] = 3
    if not sea_text.is_optional(entry):
        return {key: bpy.props.FloatProperty(**common, default=entry["default"])}
    switch = f"use_{key}"
    common["update"] = _switched_on(switch)
    return {
        switch: bpy.props.BoolProperty(
            name=f"Use {entry['label']}",
            description=f"Whether {entry['label'].lower()} is given",
            update=_changed,
            **compat.in_context(translations.SEA),
        ),
        key: bpy.props.FloatProperty(**common, default=_middle(entry)),
    }


def _annotations(*, waves: bool) -> dict[str, Any]:
    made: dict[str, Any] = {}
    for entry in entries(waves=waves):
        made.update(_properties_of(entry))
    return made


# Values -----------------------------------------------------------------------


@functools.lru_cache(maxsize=64)
def _exact(text: str) -> dict[str, str]:
    return json.loads(text) if text else {}


def _shortest(value: float) -> str:
    """The shortest decimal that is this single-precision number: 12.3, not 12.300000190734863."""
    return str(np.float32(value))


def _text_of(group, entry: dict[str, Any]) -> str:
    """A parameter's value as the library reads it."""
    key, kind = entry["key"], entry["type"]
    if sea_text.is_optional(entry) and not getattr(group, f"use_{key}"):
        return sea_text.off_value(entry)
    value = getattr(group, key)
    if kind == "list":
        return "[" + ", ".join(str(item) for item in value if item > 0) + "]"
    if kind == "float":
        shown = _shortest(value)
    elif kind == "int":
        shown = str(value)
    else:
        return bpy.path.abspath(value) if kind == "text" and value.startswith("//") else value
    # A file may say more digits than a property holds: they stay while it is not changed.
    exact, shown_then = _exact(group.exact).get(key, ("", ""))
    return exact if exact and shown == shown_then else shown


def _set_text(group, entry: dict[str, Any], text: str) -> None:
    key, kind = entry["key"], entry["type"]
    if sea_text.is_optional(entry):
        on = text not in ("", "inf")
        setattr(group, f"use_{key}", on)
        if not on:
            return
    if kind == "list":
        numbers = json.loads(text)
        setattr(group, key, [*numbers, *[0] * (_DIVISORS - len(numbers))])
    elif kind == "float":
        setattr(group, key, float(text))
    elif kind == "int":
        setattr(group, key, max(-(2**31), min(2**31 - 1, int(text))))
    else:
        setattr(group, key, text)


def _set_texts(group, values: dict[str, str], *, waves: bool) -> None:
    exact = {}
    for entry in entries(waves=waves):
        key, text = entry["key"], values[entry["key"]]
        _set_text(group, entry, text)
        if entry["type"] in ("float", "int") and _text_of(group, entry) != text:
            exact[key] = (text, _text_of(group, entry))
    group.exact = json.dumps(exact) if exact else ""


def values_of(group) -> sea_text.SeaValues:
    """What the properties say. group: Object.libocean, evaluated or not."""
    return sea_text.SeaValues(
        {entry["key"]: _text_of(group, entry) for entry in entries(waves=False)},
        [
            sea_text.WaveValues(
                {entry["key"]: _text_of(system, entry) for entry in entries(waves=True)},
                system.measured_record,
            )
            for system in group.waves
        ],
        group.take_lines,
    )


def assign(group, sea: sea_text.SeaValues) -> None:
    """Puts a sea into the properties."""
    with quiet():
        group.exact = ""
        group.take_lines = sea.take
        _set_texts(group, sea.values, waves=False)
        group.waves.clear()
        for system in sea.waves:
            added = group.waves.add()
            added.measured_record = system.record
            _set_texts(added, system.values, waves=True)
        group.active_wave = 0
    tell(group.id_data)


# Classes ----------------------------------------------------------------------

_EXACT = bpy.props.StringProperty(options={"HIDDEN"})


class OceanWaves(bpy.types.PropertyGroup):
    """One wave system of a sea: a wind sea, a swell, a measured spectrum"""

    __annotations__ = {
        **_annotations(waves=True),
        "exact": _EXACT,
        "measured_record": bpy.props.StringProperty(
            name="Measured record",
            description="The record of a measured spectrum, as a sea file holds it",
            options={"HIDDEN"},
        ),
    }


def _map_resolution(where: str):
    return bpy.props.IntProperty(
        name=f"{where} resolution",
        description=f"Samples a side of the maps in the {where.lower()}, a power of two; "
        "0: the sea's own",
        min=0,
        max=8192,
        soft_max=2048,
        update=_changed,
    )


class OceanBake(bpy.types.PropertyGroup):
    """Where and what to bake, and the record of the bake that there is"""

    directory: bpy.props.StringProperty(
        name="Folder",
        description="Where the next bake goes; empty: ocean_bake and the object's name, beside the "
        "blend file",
        subtype="DIR_PATH",
        options=compat.RELATIVE_PATH,
    )
    use_custom_range: bpy.props.BoolProperty(
        name="Own range",
        description="Bake the frames below instead of the scene's",
        options=set(),
    )
    frame_start: bpy.props.IntProperty(
        name="Frames from", description="First frame of the shot", min=0, default=1, options=set()
    )
    frame_end: bpy.props.IntProperty(
        name="To", description="Last frame of the shot", min=0, default=250, options=set()
    )

    # The record. fields: "displacement,foam"; empty: there is no bake.
    fields: bpy.props.StringProperty(options={"HIDDEN"})
    folder: bpy.props.StringProperty(options={"HIDDEN"})
    first: bpy.props.IntProperty(options={"HIDDEN"})
    last: bpy.props.IntProperty(options={"HIDDEN"})
    resolution: bpy.props.IntProperty(options={"HIDDEN"})
    period: bpy.props.FloatProperty(options={"HIDDEN"})
    samples: bpy.props.IntProperty(options={"HIDDEN"})
    slope_variance: bpy.props.FloatProperty(options={"HIDDEN"})
    frame_length: bpy.props.FloatProperty(options={"HIDDEN"}, default=1.0)
    sea: bpy.props.StringProperty(options={"HIDDEN"})
    recipes: bpy.props.StringProperty(options={"HIDDEN"})


class OceanSettings(bpy.types.PropertyGroup):
    """The sea of an object and how it is shown"""

    __annotations__ = {
        **_annotations(waves=False),
        "exact": _EXACT,
        "take_lines": bpy.props.StringProperty(options={"HIDDEN"}),
        "waves": bpy.props.CollectionProperty(type=OceanWaves),
        "active_wave": bpy.props.IntProperty(
            name="Active wave system",
            description="The wave system whose values the panel shows",
            min=0,
        ),
        "kind": bpy.props.EnumProperty(
            name="Kind",
            description="What the object's mesh is",
            items=[
                ("MESH", "Mesh", "A mesh of its own, displaced as it is"),
                ("PATCH", "Patch", "One period, a vertex on each sample"),
                ("HORIZON", "Horizon", "Rings around the scene's camera"),
            ],
            default="MESH",
        ),
        "horizon_distance": bpy.props.FloatProperty(
            name="Distance",
            description="How far a horizon reaches from the scene's camera",
            min=100.0,
            max=100000.0,
            default=30000.0,
            unit="LENGTH",
            update=_changed,
        ),
        "horizon_vertices": bpy.props.IntProperty(
            name="Vertices",
            description="At most so many: more of them, and the finest ring reaches farther",
            min=5000,
            max=1500000,
            soft_min=50000,
            default=600000,
            update=_changed,
        ),
        "viewport_resolution": _map_resolution("Viewport"),
        "render_resolution": _map_resolution("Render"),
        "use_scene_frame_rate": bpy.props.BoolProperty(
            name="Scene's frame rate",
            description="Frames last as long as the scene says, else as the sea file does",
            default=True,
            update=_changed,
        ),
        "use_custom_time": bpy.props.BoolProperty(
            name="Own time",
            description="Show the time below, which may be animated, instead of the frame's",
            update=_changed,
        ),
        "custom_time": bpy.props.FloatProperty(
            name="Time",
            description="Seconds of the sea that are shown",
            unit="TIME_ABSOLUTE",
            update=_changed,
        ),
        "use_foam": bpy.props.BoolProperty(
            name="Foam",
            description="Store the attribute foam, 0 .. 1, on the points",
            default=True,
            update=_changed,
        ),
        "use_velocity": bpy.props.BoolProperty(
            name="Velocity",
            description="Store the attributes velocity, for motion blur, and ocean_velocity, for "
            "shaders, in m/s",
            default=True,
            update=_changed,
        ),
        "use_normal": bpy.props.BoolProperty(
            name="Normal",
            description="Store the attribute ocean_normal, for shaders",
            default=True,
            update=_changed,
        ),
        "mask": bpy.props.StringProperty(
            name="Mask",
            description="A vertex group or attribute: where it is 0 the mesh stays as it is",
            update=_changed,
        ),
        "follow_world": bpy.props.BoolProperty(
            name="Anchor to the world",
            description="The sea stays where it is while the object moves, and objects side by "
            "side show one sea",
            default=True,
            update=_changed,
        ),
        "use_bake": bpy.props.BoolProperty(
            name="Play the bake",
            description="Show the files of the bake instead of the live sea",
            options=set(),
            update=_changed,
        ),
        "bake": bpy.props.PointerProperty(
            type=OceanBake, name="Bake", description="What to bake, and the bake that there is"
        ),
        "problem": bpy.props.StringProperty(
            name="Problem", description="Why the sea is not shown as asked", options={"HIDDEN"}
        ),
    }


CLASSES = (OceanWaves, OceanBake, OceanSettings)


def register() -> None:
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Object.libocean = bpy.props.PointerProperty(type=OceanSettings)


def unregister() -> None:
    del bpy.types.Object.libocean
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
