# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The operator Write Volumes: the water in a box as a sequence of OpenVDB files, and the object
that shows them.

scene, parameters and box (here) -> volume_job (a thread) -> volume object (here)
"""

from __future__ import annotations

import itertools
import os
import shlex
import subprocess
from pathlib import Path

import bpy
from mathutils import Matrix, Vector

from ..bake import bake, bake_files, bake_job, bake_plan
from ..bake.bake_plan import BakeError
from ..sea import live, messages
from ..shared import compat, paths
from ..shared.compat import tr
from ..shared.messages import of_file
from ..shared.native import ADDON, libocean
from . import volume_job

try:
    from ..legacy import ocean_command
except ModuleNotFoundError:  # in the extension, which runs no other program
    ocean_command = None

_VOLUMES = "//ocean_volumes/"
MARKS = "libocean_marks"
"""Custom property of a volume: the first frame, and the mark by which the file of each frame is
recognised."""


def asked_folder(ob) -> str:
    """Returns where the next volumes go."""
    return paths.normal(ob.libocean.volumes.directory) or _VOLUMES


def _join(folder: str, name: str) -> str:
    return folder + ("" if folder.endswith("/") else "/") + name


def _stem(ob, folder: str) -> str:
    """Returns the beginning of the files' names: the names of blend file and object, and a number
    if another object has the same name."""
    name = bpy.path.clean_name(ob.name)
    own = f"{paths.blend_name()}.{name}"
    taken = {
        other.libocean.volumes.written
        for other in live.ocean_objects()
        if other != ob and bpy.path.clean_name(other.name) == name
    }
    numbered = (f"{own}_{number}" for number in itertools.count(2))
    free = (stem for stem in itertools.chain([own], numbered) if _join(folder, stem) not in taken)
    return next(free)


# Where the sea is ---------------------------------------------------------------


def sea_to_world(ob) -> Matrix:
    """From metres of the sea, heights from still water, to the world."""
    to_world = ob.matrix_world
    if not ob.libocean.follow_world:
        return to_world.copy()
    # The sea is anchored to the world, however the mesh lies; it grows about the object.
    place = to_world.translation
    grown = Matrix.Scale(to_world.median_scale, 4)
    return Matrix.Translation(place) @ grown @ Matrix.Translation((-place.x, -place.y, 0.0))


def _bounds(ob, box) -> tuple[Vector, Vector]:
    """Returns the corners of an object's bounds in the sea [m]."""
    corners = box.bound_box
    if box.type == "EMPTY":
        size = box.empty_display_size
        corners = itertools.product((-size, size), repeat=3)
    to_sea = sea_to_world(ob).inverted_safe() @ box.matrix_world
    places = [to_sea @ Vector(corner) for corner in corners]
    low, high = (Vector(map(pick, zip(*places, strict=True))) for pick in (min, max))
    return low, high


def _rounded(value: float) -> float:
    """Returns the number that was typed; a property holds it in single precision."""
    return float(f"{value:.7g}")


def _settings(ob, sea) -> volume_job.Settings:
    """Returns the requested settings, with the defaults of `ocean bake`; raises BakeError."""
    asked = ob.libocean.volumes
    period, depth = float(sea.get("patch_size")), float(sea.get("depth"))
    resolution = ob.libocean.render_resolution or sea.map_resolution()
    if asked.box == "PERIOD":
        wave_height = sea.state["significant_wave_height"]["asked"]
        low = (0.0, 0.0, -min(max(4.0, 2.0 * wave_height), depth))
        high = (period, period, volume_job.TO_THE_CREST)
    elif asked.box == "OBJECT":
        if asked.box_object is None:
            raise BakeError(tr("No object is the box: choose one"))
        low, high = _bounds(ob, asked.box_object)
    else:
        low, high = asked.box_low, asked.box_high
    if asked.box != "PERIOD":
        low, high = (tuple(map(_rounded, corner)) for corner in (low, high))
    if any(a >= b for a, b in zip(low, high, strict=True)):
        raise BakeError(tr("The box is empty: its upper corner must exceed its lower corner"))
    voxel = _rounded(asked.voxel) or period / resolution
    velocity_voxel = _rounded(asked.velocity_voxel) or 2.0 * voxel
    return volume_job.Settings(low, high, voxel, velocity_voxel, asked.use_half, resolution)


# Without a module of OpenVDB --------------------------------------------------------


def find_command():
    """Returns the command `ocean` of the preferences, or otherwise of the system, where this copy
    of the add-on may run one; None without one. Raises BakeError if the command of the preferences
    cannot write volumes."""
    if ocean_command is None:
        return None
    addon = bpy.context.preferences.addons.get(ADDON)
    chosen = addon.preferences.ocean_command if addon else ""
    command = ocean_command.find(str(paths.absolute(chosen)) if chosen else "ocean")
    if command is None and chosen:
        raise BakeError(tr("{}, of the preferences, is no command that writes volumes", chosen))
    return command


def _what_to_run(job: volume_job.VolumeJob) -> str:
    """Returns the commands that write the frames on another machine; writes the sea files that they
    read."""
    try:
        lines = _command_lines(job)
    except libocean.Error as failure:
        return messages.of_error(failure)
    except OSError as failure:
        return of_file(failure)
    return tr(
        "This Blender has no OpenVDB module; 3.4 of Debian, 4.5 and later have it. The command "
        "ocean writes the volumes, where it is installed: {}",
        lines,
    )


def _command_lines(job: volume_job.VolumeJob) -> str:
    join = subprocess.list2cmdline if os.name == "nt" else shlex.join
    lines = []
    for text, group in itertools.groupby(job.frames, key=lambda frame: frame.sea):
        frames = [frame.number for frame in group]
        path = job.folder / f"{job.stem}_{frames[0]:04d}.toml"
        with libocean.parse(text, base_dir=job.base_dir) as sea:
            path.write_text(sea.text, encoding="utf-8")
        arguments = job.arguments(str(path), f"{frames[0]}-{frames[-1]}")
        arguments[arguments.index("-o") + 1] = str(job.folder / f"{job.stem}_####.vdb")
        lines.append(join(["ocean", *arguments]))
    return "\n".join(lines)


def _plan(context, ob, first: int, last: int, base_dir: str | None) -> list[bake_job.Frame]:
    """Returns each frame with a sea file in which it has its time."""
    frames = []

    def add(number: int, at: float, settings) -> None:
        values = live.current_values(settings, context.scene).without_hulls()
        time = live.own_time(settings)
        if time is None and at != number:
            with libocean.parse(values.text(), base_dir=base_dir) as sea:
                time = sea.time_of_frame(at)
        if time is not None:
            values.values["start"], values.values["first_frame"] = repr(time), str(number)
        frames.append(bake_job.Frame(number, at, values.text(), time))

    bake_plan.for_each_frame(context, ob, first, last, add)
    return frames


class Volumes(bake_plan.Work):
    """The volumes of a shot, until an object shows them."""

    def __init__(self, context, ob, folder, shot, *, overwrite: bool, shows: bool) -> None:
        super().__init__(ob, shot)
        self.folder, self.shot, self.shows = paths.normal(folder), shot, shows
        base_dir = paths.blend_folder()
        try:
            frames = _plan(context, ob, *shot, base_dir)
            with libocean.parse(frames[0].sea, base_dir=base_dir) as sea:
                settings = _settings(ob, sea)
        except libocean.Error as failure:
            raise BakeError(messages.of_error(failure)) from failure
        module = compat.load_openvdb()
        command = find_command() if module is None else None
        stem = _stem(ob, self.folder)
        self.written = _join(self.folder, stem)
        self.job = volume_job.VolumeJob(
            folder=bake_plan.make_folder(self.folder),
            stem=stem,
            frames=frames,
            settings=settings,
            base_dir=base_dir,
            overwrite=overwrite,
            module=module,
            command=command,
        )
        if module is None and command is None:
            raise BakeError(_what_to_run(self.job))
        is_chosen = self.folder != _VOLUMES
        if is_chosen and not overwrite and ob.libocean.volumes.begun != self.written:
            bake_plan.require_no_strangers(self._strangers(base_dir), self.folder)
        ob.libocean.volumes.begun = self.written

    def _strangers(self, base_dir: str | None) -> list[int]:
        """Returns the frames whose files show other seas; none where this file shows these
        files."""
        found, marks = [], {}
        if any(_is_of(ob.data, self.job.path(self.shot[0])) for ob in _own_volumes()):
            return found
        for frame in self.job.frames:
            shown = bake_files.identity(str(self.job.path(frame.number)))
            if not isinstance(shown, bake_files.Identity):
                continue
            text = frame.sea
            if text not in marks:
                with libocean.parse(text, base_dir=base_dir) as sea:
                    marks[text] = bake_files.sea_mark(sea.text)
            if shown.sea != marks[text]:
                found.append(frame.number)
        return found

    def finish(self) -> str:
        """Has an object show the volumes at the place of the sea."""
        if self.shows:
            ob, job = self.find(), self.job
            first = job.path(self.shot[0])
            volume = _volume_object(ob, first)
            _play(volume.data, _join(self.folder, first.name), *self.shot)
            volume.data[MARKS] = f"{self.shot[0]} {' '.join(job.marks)}"
            ob.libocean.volumes.written = self.written
            volume.matrix_world = sea_to_world(ob)
            if job.replaced and compat.READS_VOLUMES_ONCE:
                job.warning = tr("Blender shows the previous files until it is restarted")
        return self.told()


# The object that shows them -----------------------------------------------------


def _is_of(volume, path: Path) -> bool:
    """Returns whether a volume shows that sequence, whichever its first file is."""
    shown, digits = paths.absolute(volume.filepath), "0123456789"
    is_named = shown.stem.rstrip(digits) == path.stem.rstrip(digits)
    return is_named and shown.parent == path.parent


def _own_volumes() -> list:
    """The volume objects of scenes of this file."""
    return [
        ob
        for ob in bpy.data.objects
        if ob.type == "VOLUME" and ob.library is None and ob.data.library is None and ob.users_scene
    ]


def _volume_object(ob, path: Path):
    """Returns the volume object that shows the sequence, or the one that was written before, or a
    new one beside the sea."""
    written = ob.libocean.volumes.written
    others = (other for other in live.ocean_objects() if other != ob)
    if any(other.libocean.volumes.written == written for other in others):  # of a copy, or its own
        written = ""
    before = written or _join(_VOLUMES, bpy.path.clean_name(ob.name))
    for sequence in (path, paths.absolute(f"{before}_0001.vdb")):
        for other in _own_volumes():
            if _is_of(other.data, sequence):
                return other
    name = f"{ob.name} Volumes"
    volume = bpy.data.objects.new(name, bpy.data.volumes.new(name))
    beside = ob.users_collection or (bpy.context.scene.collection,)
    beside[0].objects.link(volume)
    return volume


def _play(volume, file_path: str, first: int, last: int) -> None:
    # The files may have been replaced: Blender reads none again while an object shows them.
    volume.is_sequence = False
    volume.filepath = ""
    bpy.context.view_layer.update()
    volume.filepath = file_path
    volume.grids.load()  # without it Blender knows no grid of that name
    volume.velocity_grid = volume_job.VELOCITY
    volume.velocity_unit = "SECOND"
    volume.is_sequence = True
    volume.frame_start, volume.frame_duration = first, last - first + 1
    volume.frame_offset = first - 1  # files have the numbers of their frames


class WriteVolumes(bake.Frames, bpy.types.Operator):
    """Write the water in a box as OpenVDB files, its surface as a level set and its velocity, and
    show them as a volume. Existing files of the same sea are kept. ESC stops it"""

    bl_idname = "libocean.write_volumes"
    bl_label = "Write Volumes"

    __annotations__ = bake.FIELDS["WriteVolumes"]

    def begin(self, context, shot: tuple[int, int]) -> Volumes:
        ob = context.object
        folder = self.directory or asked_folder(ob)
        return Volumes(context, ob, folder, shot, overwrite=self.overwrite, shows=self.use_import)


CLASSES = (WriteVolumes,)

register, unregister = bpy.utils.register_classes_factory(CLASSES)
