# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A measured sea: a file of a buoy or a wave model, and one of its records.

file -> libocean.records -> list to search -> the active wave system, its record inlined
"""

from __future__ import annotations

import functools
import os

import bpy
from bpy_extras.io_utils import ImportHelper

from ..shared import changes, paths
from ..shared.messages import of_file
from ..shared.native import libocean
from . import messages, operators, parameter_values, sea_text


def place_of(record: dict) -> str:
    """As the parameter `place` takes it: a station, or latitude and longitude."""
    if record["station"]:
        return record["station"]
    if record["latitude"] is None:
        return ""
    return f"{record['latitude']!r},{record['longitude']!r}"


def _label(record: dict) -> str:
    height, period = record["significant_wave_height"], record["peak_period"]
    return f"{record['time']}  {place_of(record)}  {height:.1f} m  {period:.1f} s".replace("T", " ")


@functools.lru_cache(maxsize=4)
def _listed(path: str, _changed: float) -> list[dict]:
    return libocean.records(path)


def records_of(path: str) -> list[dict]:
    """Returns the records of a file, read again when it has changed. Raises libocean.Error,
    OSError."""
    return _listed(path, os.stat(path).st_mtime)


_items: list[tuple[str, str, str]] = []  # Blender holds no reference to what it shows


def _choices(self, _context):
    global _items
    try:
        found = records_of(str(paths.absolute(self.filepath)))
    except (libocean.Error, OSError):
        found = []
    _items = [(str(number), _label(record), "") for number, record in enumerate(found)]
    return _items


class PickRecord(operators.OnOcean, bpy.types.Operator, ImportHelper):
    """Make the active wave system one that was measured: a record of a buoy or a wave model"""

    bl_idname = "libocean.pick_record"
    bl_label = "Measured Waves"
    bl_options = {"REGISTER", "UNDO"}
    bl_property = "choice"

    filter_glob: bpy.props.StringProperty(default="*", options={"HIDDEN"})
    record: bpy.props.StringProperty(
        name="Record",
        description="Time of the record, UTC, the nearest within 30 minutes; empty: the first",
    )
    place: bpy.props.StringProperty(
        name="Place",
        description="Station, or latitude,longitude, where the file has several; empty: the first",
    )
    choice: bpy.props.EnumProperty(
        name="Records",
        description="What the file holds",
        items=_choices,
        options={"HIDDEN", "SKIP_SAVE"},
    )

    def invoke(self, context, event):
        if not self.filepath:
            return ImportHelper.invoke(self, context, event)
        context.window_manager.invoke_search_popup(self)
        return {"RUNNING_MODAL"}

    def execute(self, context):
        path = str(paths.absolute(self.filepath))
        try:
            found = records_of(path)
            # Unset, a list shows its first entry.
            if not self.record and self.properties.is_property_set("choice"):
                chosen = found[int(self.choice)]
                self.record, self.place = chosen["time"], place_of(chosen)
            elif not self.record and len(found) > 1 and self.options.is_invoke:
                # From the file browser: now the list.
                bpy.ops.libocean.pick_record("INVOKE_DEFAULT", filepath=self.filepath)
                return {"CANCELLED"}  # nothing was done yet
            self._measure(context, path)
        except libocean.Error as failure:
            self.report({"ERROR"}, messages.of_error(failure))
            return {"CANCELLED"}
        except OSError as failure:
            self.report({"ERROR"}, of_file(failure))
            return {"CANCELLED"}
        return {"FINISHED"}

    def _measure(self, context, path: str) -> None:
        """Makes the active wave system the record. The library reads the file before any setting
        changes; the settings get the record itself."""
        ob = context.object
        settings = ob.libocean
        number = min(settings.active_wave, len(settings.waves) - 1)
        values = parameter_values.values_of(settings)
        system = values.waves[number]
        system.record = ""
        system.values.update(spectrum="measured", file=path, record=self.record, place=self.place)
        # The measured mean, height and period, and no wind of the waves before.
        system.values.update(
            wind_speed="", wind_direction="", significant_wave_height="", peak_period=""
        )
        with libocean.parse(values.text(), base_dir=paths.blend_folder()) as sea:
            parameter_values.assign(settings, sea_text.read(sea))
        settings.active_wave = number
        changes.tell(settings)


CLASSES = (PickRecord,)

register, unregister = bpy.utils.register_classes_factory(CLASSES)
