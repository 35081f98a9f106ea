# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bake of a coast plays what was live, to the bit, without the add-on; it goes on after it was
stopped or killed; its files are those of `ocean bake --region`."""

import os
import shutil
import subprocess

import bpy
import numpy as np
import pytest
from conftest import attribute, in_another_process, positions, start_another_process
from libocean_addon.bake import bake_record, exr_files, render_check
from libocean_addon.bundled import libocean
from libocean_addon.coast import coast_bake, panels
from test_coast import CELL, COLUMNS, ROWS
from test_terrain_panel import drawn_by

OF_WATER = ("foam", "cover", "jacobian", "ocean_velocity", "ocean_normal", "breaking", "depth")
FRAMES = (1, 2, 4)


@pytest.fixture
def shot(coast, scene, tmp_path):
    """A coast in a saved file, with all that a bake has."""
    coast.libocean_coast.use_wetness = True
    scene.frame_start, scene.frame_end = 1, 4
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "shot.blend"))
    return bpy.data.objects["Water"]


def seen(ob) -> dict[str, np.ndarray]:
    land = ob.libocean_coast.land
    found = {name: attribute(ob, name) for name in OF_WATER}
    return {**found, "place": positions(ob), "wetness": attribute(land, "shore_wetness")}


def at_frames(ob) -> list[dict[str, np.ndarray]]:
    found = []
    for frame in FRAMES:
        bpy.context.scene.frame_set(frame)
        found.append(seen(ob))
    return found


def assert_same(ones, others) -> None:
    for one, other in zip(ones, others, strict=True):
        for name, values in one.items():
            assert np.array_equal(values, other[name]), name


def folder_of(ob):
    return bake_record.place_of(ob).path


def test_the_files_are_those_of_the_command(shot, tmp_path):
    command = os.environ.get("OCEAN")
    if not command:
        pytest.skip("no command `ocean`")
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    sea = tmp_path / "sea_of_panel.toml"
    bpy.ops.libocean.save_coast(filepath=str(sea))
    record = shot.libocean.bake
    region = f"10,20,{10 + CELL * (COLUMNS - 1):g},{20 + CELL * (ROWS - 1):g}"
    subprocess.run(
        [command, "-q", "bake", sea, "--region", region, "--cell", f"{CELL:g}", "--frames", "2"]
        + ["--set", "fps=24", "--type", "float", "--products", record.fields]
        + ["-o", tmp_path / "cli.####.exr"],
        check=True,
    )
    for field in record.fields.split(","):
        ours = folder_of(shot) / exr_files.name(record.stem, field, 2)
        theirs = tmp_path / f"cli.{field}.0002.exr"
        assert exr_files.read_header(ours) == exr_files.read_header(theirs), field
        images = [bpy.data.images.load(str(path)) for path in (ours, theirs)]
        values = []
        for image in images:
            pixels = np.empty(image.size[0] * image.size[1] * image.channels, np.float32)
            image.pixels.foreach_get(pixels)
            values.append(pixels)
        assert np.abs(values[0] - values[1]).max() <= 1e-5, field


def test_a_bake_that_is_stopped_goes_on(shot, monkeypatch):
    bake_one = coast_bake.RegionJob._bake

    def stopping(job, *arguments):
        if job.done == 2:
            job.stop.set()
        return bake_one(job, *arguments)

    monkeypatch.setattr(coast_bake.RegionJob, "_bake", stopping)
    assert bpy.ops.libocean.bake() == {"CANCELLED"}
    assert not shot.libocean.use_bake
    monkeypatch.undo()
    folder = exr_files.Path(bpy.path.abspath("//ocean_bake/Water"))
    before = {path: path.stat().st_mtime_ns for path in folder.glob("*.exr")}
    assert len(before) == 2 * 9 and not list(folder.glob(".*"))
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    assert all(path.stat().st_mtime_ns == changed for path, changed in before.items())


def test_the_library_ends_its_work_when_a_bake_is_stopped(shot, monkeypatch):
    seen_job = []

    def watch(job, done, total):
        seen_job.append(job)
        job.stop.set()
        unwatched(job, done, total)

    unwatched = coast_bake.RegionJob._watch
    monkeypatch.setattr(coast_bake.RegionJob, "_watch", watch)
    assert bpy.ops.libocean.bake() == {"CANCELLED"}
    assert len(seen_job) == 1 and seen_job[0].failure is None and seen_job[0].done == 0


def test_what_the_library_refuses_meanwhile_is_said(shot, monkeypatch):
    def failing(_job, _sea, _resolved, frame):
        if frame.number == 2:
            raise libocean.Error("water.level = 9e9: is out of range", 0)
        return True

    monkeypatch.setattr(coast_bake.RegionJob, "_bake", failing)
    with pytest.raises(RuntimeError, match="After 2 frames: .*is out of range"):
        bpy.ops.libocean.bake()
    assert not shot.libocean.use_bake


KILLED = """
bpy.ops.preferences.addon_enable(module="libocean_addon")
bpy.ops.wm.open_mainfile(filepath=arguments[0])
bpy.context.view_layer.objects.active = bpy.data.objects["Water"]
from libocean_addon.coast import coast_bake
from libocean_addon.bake import exr_files
write = exr_files._write_image
def dying(package, path, provenance, field, values):
    write(package, path, provenance, field, values)
    if provenance.frame == 2 and field == "velocity":
        os.kill(os.getpid(), 9)
exr_files._write_image = dying
bpy.ops.libocean.bake()
"""


def test_a_bake_that_is_killed_goes_on(shot, tmp_path):
    bpy.ops.wm.save_mainfile()
    done = start_another_process(tmp_path, KILLED, str(tmp_path / "shot.blend"))
    done.communicate()
    assert done.returncode == -9
    folder = tmp_path / "ocean_bake" / "Water"
    before = {path: path.stat().st_mtime_ns for path in folder.glob("shot.*.exr")}
    assert 9 < len(before) < 6 * 9
    live = at_frames(shot)
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    assert all(path.stat().st_mtime_ns == changed for path, changed in before.items())
    assert_same(live, at_frames(shot))


def test_another_region_is_baked_anew(shot):
    bpy.ops.libocean.bake()
    shot.libocean.use_bake = False
    shot.libocean_coast.region = (50.0, 40.0, 90.0, 100.0)
    shot.libocean_coast.use_region = True
    live = at_frames(shot)
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    assert_same(live, at_frames(shot))


def test_an_animated_region_is_refused(shot):
    for frame, cell in ((1, 4.0), (4, 8.0)):
        shot.libocean_coast.cell = cell
        shot.libocean_coast.keyframe_insert("cell", frame=frame)
    with pytest.raises(RuntimeError, match="region are animated"):
        bpy.ops.libocean.bake()


def test_keyframes_are_baked(shot, scene):
    waves = shot.libocean.waves[0]
    for frame, wind in ((1, 6.0), (4, 8.0)):
        waves.wind_speed = wind
        shot.keyframe_insert("libocean.waves[0].wind_speed", frame=frame)
    live = at_frames(shot)
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    assert_same(live, at_frames(shot))


WITHOUT = """
import numpy as np
assert "libocean_addon" not in bpy.context.preferences.addons
bpy.ops.wm.open_mainfile(filepath=arguments[0])
want = np.load(arguments[1])
for frame in (1, 2, 4):
    bpy.context.scene.frame_set(frame)
    depsgraph = bpy.context.evaluated_depsgraph_get()
    for name, attribute, kind in (("Water", "position", 3), ("Land", "shore_wetness", 1)):
        mesh = bpy.data.objects[name].evaluated_get(depsgraph).data
        out = np.empty(kind * len(mesh.vertices), np.float32)
        if attribute == "position":
            mesh.vertices.foreach_get("co", out)
        else:
            mesh.attributes[attribute].data.foreach_get("value", out)
        assert np.array_equal(out, want[f"{name}{frame}"].ravel()), (name, frame)
"""


def test_it_plays_without_add_on_library_and_path(shot, tmp_path):
    bpy.ops.libocean.bake()
    want = {}
    for frame, shown in zip(FRAMES, at_frames(shot), strict=True):
        want[f"Water{frame}"], want[f"Land{frame}"] = shown["place"], shown["wetness"]
    np.savez(tmp_path / "want.npz", **want)
    bpy.ops.wm.save_mainfile()
    file = str(tmp_path / "shot.blend")
    in_another_process(
        tmp_path, WITHOUT, file, str(tmp_path / "want.npz"), PATH="", LIBOCEAN_LIBRARY="none"
    )


def test_a_render_without_its_files_is_refused(shot, scene):
    bpy.ops.libocean.bake()
    assert render_check.find(scene, [2]).errors == []
    exr_files.path(folder_of(shot), shot.libocean.bake.stem, "depth", 2).unlink()
    (text,) = render_check.find(scene, [2]).errors
    assert "Water: files of the bake are missing, of the frames 2" in text
    other = exr_files.path(folder_of(shot), shot.libocean.bake.stem, "depth", 3)
    shutil.copy(other, other.with_name(other.name.replace("0003", "0002")))
    (text,) = render_check.find(scene, [2]).errors
    assert "show another sea" in text


def test_the_panel_says_what_is_baked(shot):
    said = " ".join(drawn_by(panels.CoastBakePanel))
    assert "Frames 0 to 5 of 41 x 31 samples" in said
    bpy.ops.libocean.bake()
    said = " ".join(drawn_by(panels.CoastBakePanel))
    assert "6 of 6 frames" in said and "another sea" not in said
    shot.libocean.level = 0.5
    assert "another sea" in " ".join(drawn_by(panels.CoastBakePanel))
