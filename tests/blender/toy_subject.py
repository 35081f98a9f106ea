# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A subject of a few lines, a plane with a slope: its row is all that the add-on knows of it."""

import contextlib
import dataclasses
from pathlib import Path

import bpy
import numpy as np
from libocean_addon.bake import bake_job, bake_plan
from libocean_addon.bundled import libocean
from libocean_addon.shared import (
    compat,
    drafts,
    meshes,
    modifier_groups,
    registration,
    subject_panel,
)
from libocean_addon.shared import subject as subjects
from libocean_addon.shared.messages import Words
from libocean_addon.shared.node_builder import Builder
from libocean_addon.shared.open_subject import OpenByObject, OpenSubject
from libocean_addon.shared.parameter_table import ParameterTable
from libocean_addon.shared.subject import Parameters, Picture, Subject
from libocean_addon.shared.subject_operators import LoadPreset, OnSubject, SaveFile
from libocean_addon.shared.table_properties import changed

FAMILY = modifier_groups.Family("libocean_toy", 1)
ROW = {"section": "toy", "key": "slope", "label": "Slope", "type": "float", "default": 0.0}
TABLE = ParameterTable(rows=[ROW], item_section="toy.item", file_kind="Toy file")


@dataclasses.dataclass
class ToyValues:
    slope: float

    def structure(self) -> tuple:
        return ()

    def by_name(self) -> dict[str, str]:
        return {"toy.slope": repr(self.slope)}

    def text(self) -> str:
        return f"slope = {self.slope!r}"


class ToyHandle:
    """Stands for the library's handle."""

    def __init__(self, text: str, **_options) -> None:
        self.slope = float(text.rpartition(" ")[2])
        self.is_open = True

    def set_all(self, values) -> None:
        if float(values["toy.slope"]) > 10.0:
            raise libocean.Error("toy.slope is too steep", 0)
        self.slope = float(values["toy.slope"])

    @property
    def text(self) -> str:
        return f"slope = {self.slope!r}"

    @property
    def state(self) -> dict:
        return {"slope": self.slope}

    def close(self) -> None:
        self.is_open = False

    def __enter__(self):
        return self

    def __exit__(self, *_failure) -> None:
        self.close()


class OpenToy(OpenSubject):
    is_ready = True
    ready: int | None = None
    """The number of changes whose whole was made."""

    def _open(self, values):
        return ToyHandle(values.text())

    def adopt(self, job) -> bool:
        self.ready = self.changes if job.failure is None else None
        return job.failure is None


class ToyJob(drafts.Job):
    def work(self) -> None: ...

    def close(self) -> None: ...

    def status_text(self, name: str) -> str:
        return name


class ToyPicture(Picture):
    def prepare(self) -> None:
        self.key = (self.opened.changes,)
        self.image = modifier_groups.image(self.modifier, "Heights", self.ob.name, (0.0,) * 4)

    def is_ready(self) -> bool:
        return self.opened.is_ready

    def _show(self, slope: float) -> None:
        image_named = {"Heights": self.image}
        stale = self.opened.stale(image_named, slope)
        pixels = np.full((2, 2, 4), slope, np.float32)
        self.opened.put(image_named, stale, {"Heights": pixels}, slope)
        modifier_groups.assign(self.modifier, {"Slope": slope})

    def show_draft(self) -> None:
        self._show(0.0)

    def show_whole(self) -> None:
        self.opened.ready = self.opened.changes
        self._show(self.opened.handle.slope)


@dataclasses.dataclass(kw_only=True)
class ToyFiles(bake_job.Job):
    folder: Path

    def _run(self, tell) -> None:
        for frame in self.frames:
            (self.folder / f"{frame.number}.txt").write_text(frame.sea)
            self.done += 1
            tell()


class ToyBake(bake_plan.Work):
    modifiers = staticmethod(FAMILY.modifiers)

    def __init__(self, context, ob, asked, shot, *, overwrite) -> None:
        super().__init__(ob, shot)
        self.folder, frames = asked, []

        def note(number, shown, settings) -> None:
            text = TOY.parameters.values_of(settings.id_data, context.scene).text()
            frames.append(bake_job.Frame(number, shown, text))

        bake_plan.for_each_frame(context, ob, *shot, note)
        folder = bake_plan.make_folder(asked)
        self.job = ToyFiles(frames=frames, base_dir=None, overwrite=overwrite, folder=folder)

    def finish(self) -> str:
        return self.told()


def build(group) -> None:
    compat.add_socket(group, "Geometry", "NodeSocketGeometry")
    compat.add_socket(group, "Heights", "NodeSocketImage")
    compat.add_socket(group, "Slope", "NodeSocketFloat")
    compat.add_socket(group, "Geometry", "NodeSocketGeometry", output=True)
    b = Builder(group)
    inputs = b.node("NodeGroupInput").outputs
    x = b.parts(b.node("GeometryNodeInputPosition").outputs[0])[0]
    moved = b.node("GeometryNodeSetPosition")
    b.link(inputs["Geometry"], moved.inputs["Geometry"])
    b.link(b.vector(0.0, 0.0, b.number("MULTIPLY", x, inputs["Slope"])), moved.inputs["Offset"])
    b.link(moved.outputs[0], b.node("NodeGroupOutput").inputs[0])


def follow_mesh(shown, *, draft: bool = False) -> None:
    along = np.arange(3, dtype=np.float32)
    meshes.follow_grid(shown.ob, "toy", (along, along))


def assign(ob, values) -> None:
    ob.libocean_toy.slope = values.slope


class ToySettings(bpy.types.PropertyGroup):
    subject = "toy"
    slope: bpy.props.FloatProperty(update=changed)
    problem: bpy.props.StringProperty()


TOY = Subject(
    name="toy",
    family=FAMILY,
    settings="libocean_toy",
    parameters=Parameters(
        settings="libocean_toy",
        words=Words(TABLE),
        parse=ToyHandle,
        open_file=ToyHandle,
        preset=lambda name: ToyHandle(f"slope = {name}"),
        read=lambda handle: ToyValues(handle.slope),
        values_of=lambda ob, _scene: ToyValues(ob.libocean_toy.slope),
        assign=assign,
    ),
    listens=("toy",),
    opened=OpenByObject(OpenToy),
    image_inputs=lambda _group: ["Heights"],
    picture=ToyPicture,
    job=lambda shown: ToyJob((shown.opened.changes,)),
    follow_mesh=follow_mesh,
    bake=ToyBake,
)


class OnToy(OnSubject):
    subject = TOY

    @staticmethod
    def absent() -> str:
        return "No toy"


class SaveToy(OnToy, SaveFile, bpy.types.Operator):
    bl_idname = "libocean.save_toy"
    bl_label = "Save"


class LoadToy(OnToy, LoadPreset, bpy.types.Operator):
    bl_idname = "libocean.load_toy"
    bl_label = "Load"
    preset: bpy.props.StringProperty()


@subject_panel.Panels(FAMILY.modifiers).add("toy", "Toy", closed=False)
def toy_panel(layout, ob, context) -> None:
    problems = [ob.libocean_toy.problem]
    subject_panel.draw_problems(layout, context.scene, problems, "No metres")


@contextlib.contextmanager
def registered():
    """Has the add-on know the subject meanwhile."""
    part = (ToySettings, SaveToy, LoadToy, toy_panel)
    register, unregister = registration.functions(part, settings={"libocean_toy": ToySettings})
    register()
    subjects.add(TOY)
    yield
    subjects.remove(TOY)
    unregister()


def add():
    """Returns a new object with a toy."""
    ob = bpy.data.objects.new("Toy", bpy.data.meshes.new("Toy"))
    bpy.context.collection.objects.link(ob)
    bpy.context.view_layer.objects.active = ob
    modifier_groups.add(ob, "Toy", lambda: FAMILY.get(".libocean.toy", build))
    ob.libocean_toy.slope = 2.0
    return ob
