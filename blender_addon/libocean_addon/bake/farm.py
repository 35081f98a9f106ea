# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bake on a Farm: a folder with the job that `ocean farm` writes, and a copy of the blend file that
plays the frames of this job.

bake of the object, planned and not written -> record -> copy of the file -> the object as before
                                            -> sea, frames, seconds of a frame -> job
"""

from __future__ import annotations

import dataclasses
import time
from pathlib import Path

import bpy

from ..look import detail_tiles
from ..sea import hulls, messages, node_group
from ..shared import changes, compat, overrides, paths, registration
from ..shared.compat import tr
from ..shared.native import libocean
from . import bake, bake_job, bake_plan, baked
from .bake_plan import BakeError

FRAMES = "frames"
"""The folder of the images in that of the job."""


@dataclasses.dataclass(kw_only=True)
class _PlannedJob(bake_job.MapJob):
    """Knows what the files of each frame show, and writes none."""

    def _write_missing(self, _provenance, _make) -> bool:
        return True


class PlannedBake(bake_plan.Bake):
    """A bake whose frames `ocean bake` writes elsewhere."""

    def __init__(self, context, ob, job: str, shot: tuple[int, int]) -> None:
        if ob.libocean.kind == "HORIZON" or not node_group.modifiers(ob):
            raise BakeError(
                tr("{}: a farm bakes oceans of one period; bake horizons and coasts here", ob.name)
            )
        super().__init__(context, ob, f"{job.rstrip('/')}/{FRAMES}/", shot, overwrite=False)
        frames = self.job.frames
        if any(f.sea != frames[0].sea or f.time is not None or f.shown != f.number for f in frames):
            raise BakeError(
                tr(
                    "{} has keyframes, a custom time or remapped time: a farm bakes one sea; bake "
                    "this one here",
                    ob.name,
                )
            )

    def _range_of(self, context, shot: tuple[int, int]) -> tuple[int, int]:
        # The job renders all its frames, so that margins are for motion blur alone.
        is_blurred = compat.shutter(context.scene) != (0.0, 0.0)
        return bake_plan.with_margins(*shot) if is_blurred else shot

    def _make_job(self, ob, **settings) -> _PlannedJob:
        return _PlannedJob(**settings, resolution=self.resolution)

    def options(self) -> list[str]:
        """Returns the words of `ocean bake` for the same files."""
        job = self.job
        words = ["--products", ",".join(job.fields), "--type", "float"]
        words += ["--resolution", str(job.resolution)]
        return [*words, "--detail-samples", str(detail_tiles.SAMPLES)] if job.bands else words

    def frames_per_task(self, sea, minutes: float) -> int:
        """Returns how many frames a task bakes in that time, by the maps of one frame here."""
        began = time.monotonic()
        sea.surface(sea.time_of_frame(self.range[0]), self.job.resolution, ["displacement"])
        seconds = max(time.monotonic() - began, 1e-3) * len(self.job.fields)
        return max(1, round(60.0 * minutes / seconds))


def _save_copy(ob, planned: PlannedBake, path: Path) -> None:
    """Saves a copy of the blend file in which the object plays the planned bake."""
    settings, record = ob.libocean, ob.libocean.bake
    kept = {
        key: getattr(record, key)
        for key, about in record.bl_rna.properties.items()
        if not about.is_readonly
    }
    was_playing = settings.use_bake
    folder, relative = planned.folder, bpy.path.relpath(str(paths.absolute(planned.folder)))
    try:
        planned.folder = f"{paths.normal(relative)}/"
        planned.finish()
        bpy.ops.wm.save_as_mainfile(filepath=str(path), copy=True, relative_remap=True)
    finally:
        planned.folder = folder
        with changes.quiet():
            settings.use_bake = False
            baked.follow(ob, node_group.modifiers(ob))
            for key, value in kept.items():
                setattr(record, key, value)
            settings.use_bake = was_playing
            settings.problem = ""
        changes.tell(settings)


def write(context, ob, engine: str, asked: str, shot: tuple[int, int], minutes: int, render: bool):
    """Writes a job. Returns the report; raises BakeError."""
    if not bpy.data.filepath:
        raise BakeError(tr("Save the blend file first: the job has a copy of it"))
    job = asked or f"//ocean_farm/{bpy.path.clean_name(ob.name)}/"
    if paths.absolute(job) == paths.absolute("//"):
        raise BakeError(tr("{} is the folder of the blend file itself: choose another one", job))
    planned = PlannedBake(context, ob, job, shot)
    planned.job.run()
    if planned.job.failure is not None:
        raise BakeError(bake.in_words(planned.job.failure))
    folder, scene = paths.absolute(job), f"{planned.stem}.blend"
    frames = range(planned.range[0], planned.range[1] + 1)
    try:
        with libocean.parse(planned.job.first_sea, base_dir=paths.blend_folder()) as sea:
            sea.write_farm_job(
                folder,
                engine,
                f"{FRAMES}/{planned.stem}.####.exr",
                frames,
                options=planned.options(),
                render=scene if render else None,
                frames_per_task=planned.frames_per_task(sea, minutes),
            )
        if render:
            _save_copy(ob, planned, folder / scene)
    except libocean.Error as failure:
        raise BakeError(messages.of_error(failure)) from failure
    except (OSError, RuntimeError) as failure:
        raise BakeError(tr("The job cannot be written: {}", failure)) from failure
    return tr("The job is in {}: frames {} to {}", folder, frames[0], frames[-1])


class BakeOnFarm(bake.OnBaked, bpy.types.Operator):
    """Write a folder with a job for a render farm: it bakes the sea in parts, checks the files and
    renders this scene, on machines without the add-on"""

    bl_idname = "libocean.bake_on_farm"
    bl_label = "Bake on a Farm"

    directory: bpy.props.StringProperty(
        name="Folder",
        description="Empty: ocean_farm beside the blend file",
        subtype="DIR_PATH",
        options=compat.RELATIVE_PATH,
    )
    __annotations__.update(bake.FIELDS["BakeOnFarm"])

    def invoke(self, context, _event):
        return context.window_manager.invoke_props_dialog(self)

    def execute(self, context):
        ob = context.object
        overrides.make_editable(ob)
        shot = bake_plan.asked_range(ob, context.scene)
        try:
            report = write(
                context,
                ob,
                self.engine.lower(),
                self.directory,
                shot,
                self.minutes,
                self.use_render,
            )
        except BakeError as failure:
            self.report({"ERROR"}, str(failure))
            return {"CANCELLED"}
        if len(ob.libocean.hulls) > 0:
            self.report({"WARNING"}, hulls.left_out())
        live = [
            other.name
            for other in context.scene.objects
            if other != ob and node_group.modifiers(other) and not other.libocean.use_bake
        ]
        if self.use_render and live:
            text = tr("{} plays no bake: without the add-on it stands still", ", ".join(live))
            self.report({"WARNING"}, text)
        self.report({"INFO"}, report)
        return {"FINISHED"}


CLASSES = (BakeOnFarm,)
register, unregister = registration.functions(CLASSES)
