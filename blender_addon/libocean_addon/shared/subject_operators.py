# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bases of the operators that every subject has: on its objects, their files and presets."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import bpy
from bpy_extras import object_utils
from bpy_extras.io_utils import ExportHelper, ImportHelper

from . import console, modifier_groups, paths
from .compat import tr
from .messages import of_file
from .native import libocean
from .subject import Parameters, Subject, rows

FILES = "*.toml"


class OnSubject:
    """Base of operators on the active object, which is one of a subject's. A subclass has the row
    as `subject`."""

    @staticmethod
    def absent() -> str:
        """Returns the sentence about another active object."""
        raise NotImplementedError

    @classmethod
    def poll(cls, context) -> bool:
        if context.object is not None and cls.subject.family.modifiers(context.object):
            return True
        cls.poll_message_set(cls.absent())
        return False


def read_or_report(operator, read: Callable[[], Any]):
    """Returns read(); None if the library refuses, which the operator reports."""
    try:
        return read()
    except libocean.Error as failure:
        operator.report({"ERROR"}, str(failure))
        return None


class LoadFile(ImportHelper):
    """Base of operators that load a subject's file."""

    filter_glob: bpy.props.StringProperty(default=FILES, options={"HIDDEN"})

    def read(self, _context):
        """Returns the values of the file. Raises libocean.Error."""
        with self.subject.parameters.open_file(str(paths.absolute(self.filepath))) as opened:
            return self.subject.parameters.read(opened)

    def use(self, context, values) -> None:
        """Gives the values to the active object."""
        self.subject.parameters.assign(context.object, values)

    def execute(self, context):
        values = read_or_report(self, lambda: self.read(context))
        if values is None:
            return {"CANCELLED"}
        self.use(context, values)
        return {"FINISHED"}


class SaveFile(OnSubject, ExportHelper):
    """Base of operators that write the file of the active object."""

    filename_ext = ".toml"
    filter_glob: bpy.props.StringProperty(default=FILES, options={"HIDDEN"})

    def execute(self, context):
        parameters, ob = self.subject.parameters, context.object
        text = parameters.values_of(ob, context.scene).text()
        try:
            with parameters.parse(text, base_dir=paths.blend_folder()) as opened:
                text = opened.text
            paths.write_text(self.filepath, text)
        except libocean.Error as failure:
            self.report({"ERROR"}, parameters.sentence(ob, failure))
            return {"CANCELLED"}
        except OSError as failure:
            self.report({"ERROR"}, of_file(failure))
            return {"CANCELLED"}
        return {"FINISHED"}


def preset_values(parameters: Parameters, name: str):
    """Returns the values of a preset."""
    with parameters.preset(name) as opened:
        return parameters.read(opened)


class LoadPreset(OnSubject):
    """Base of operators with a list `preset`."""

    def preset_for(self, _ob):
        """Returns the values that an object gets."""
        return preset_values(self.subject.parameters, self.preset)

    def execute(self, context):
        self.subject.parameters.assign(context.object, self.preset_for(context.object))
        return {"FINISHED"}


class AddToObject:
    """Base of operators that give the active object a subject: it has none yet."""

    @classmethod
    def poll(cls, context) -> bool:
        ob = context.object
        if ob is None or ob.type not in modifier_groups.DISPLACED:
            cls.poll_message_set(tr("The active object is no mesh, curve or text"))
            return False
        for row in rows:
            if row.family.modifiers(ob):
                cls.poll_message_set(cls.taken(row))
                return False
        return True

    @classmethod
    def taken(cls, row: Subject) -> str:
        """Returns the sentence about an object that has a subject."""
        return row.taken()


def new_object(operator, context, name: str, label: str, make_group: Callable[[], Any]):
    """Returns a new mesh object with a modifier of that label. operator: adds objects;
    make_group(): the node group."""
    mesh = bpy.data.meshes.new(name)
    ob = object_utils.object_data_add(context, mesh, operator=operator)
    modifier_groups.add(ob, label, make_group)
    return ob


def give_material(operator, ob, give: Callable[[], None]) -> None:
    """Calls give() where the operator's `use_material` says so."""
    if operator.use_material:
        with console.work(ob.name_full, "material"):
            give()
