# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Before a frame is rendered: files of a bake that are missing, broken or of another sea stop it,
with the numbers of their frames; what does not show them does not."""

import os
import shutil
import subprocess
from pathlib import Path

import bpy
import numpy as np
import other_blender
import pytest
from conftest import (
    add_ocean,
    empty,
    in_another_blender,
    keyed,
    needs_window,
    opened,
    positions,
    reopened,
    save,
    shot_of,
)
from libocean_addon.bake import bake_plan, bake_state

FIELDS = ("displacement", "cover", "velocity", "normal", "jacobian")
FIRST, LAST = 4, 8  # of the shot; files from 3 to 9


def small_sea(scene, **foam):
    ob = add_ocean(32, sea=foam, kind="PATCH", preset="beaufort_6", use_material=False)
    shot_of(scene, ob)
    scene.render.resolution_x = scene.render.resolution_y = 4
    scene.render.filepath = "//out/####"
    scene.frame_start, scene.frame_end = FIRST, LAST
    return ob


@pytest.fixture(scope="module")
def baked(tmp_path_factory) -> Path:
    """A folder with a shot and its bake."""
    folder = tmp_path_factory.mktemp("baked")
    empty()
    small_sea(bpy.context.scene, foam_coverage="threshold", foam_threshold=0.9)
    save(folder / "shot.blend")
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    bpy.ops.wm.save_mainfile()
    return folder


@pytest.fixture
def sea(baked, tmp_path):
    shutil.copytree(baked, tmp_path, dirs_exist_ok=True)
    return opened(tmp_path / "shot.blend", "Ocean")


@pytest.fixture
def scene(request):
    """That of the shot, where a test has one."""
    if "sea" in request.fixturenames:
        request.getfixturevalue("sea")
    return bpy.context.scene


def file(tmp_path: Path, frame: int, field: str = "displacement") -> Path:
    return tmp_path / "ocean_bake" / "Ocean" / f"shot.{field}.{frame:04d}.exr"


def render(capfd, frame: int | None = None, subframe: float = 0.0, **arguments) -> list[str]:
    """Renders a frame, or what the arguments say. Returns what the console says of oceans; raises
    RuntimeError where Blender stops."""
    if frame is not None:
        bpy.context.scene.frame_set(frame, subframe=subframe)
    capfd.readouterr()
    try:
        bpy.ops.render.render(**arguments)
    finally:
        said = capfd.readouterr().err.splitlines()
        render.said = [line for line in said if line.startswith(("Error: Oc", "Warning: "))]
    return render.said


def stopped(capfd, *frame, **arguments) -> list[str]:
    """Returns the console's message about a render that is stopped."""
    camera = bpy.context.scene.camera
    with pytest.raises(RuntimeError, match="no camera"):
        render(capfd, *frame, **arguments)
    assert bpy.context.scene.camera == camera is not None
    return render.said


# Kinds of faults ----------------------------------------------------------------


def damage(tmp_path: Path, kind: str, field: str) -> None:
    path, other = file(tmp_path, 6, field), file(tmp_path, 7, field)
    whole = path.read_bytes()
    if kind == "missing":
        path.unlink()
    elif kind == "empty":
        path.write_bytes(b"")
    elif kind == "cut":
        path.write_bytes(whole[:-1])
    elif kind == "no table":  # of a program that was killed while it wrote
        path.write_bytes(whole[:500] + bytes(len(whole) - 500))
    elif kind == "noise":
        path.write_bytes(b"\x76\x2f\x31\x01" + os.urandom(4000))
    elif kind == "other frame":
        path.write_bytes(other.read_bytes())
    elif kind == "other field":
        path.write_bytes(file(tmp_path, 6, "displacement").read_bytes())
    elif kind == "other sea":
        path.write_bytes(whole.replace(b"choppiness = 1", b"choppiness = 2"))
    elif kind == "other seed":
        path.write_bytes(whole.replace(b"seed = 1", b"seed = 9"))
    elif kind == "other size":
        ob = bpy.data.objects["Ocean"]
        ob.libocean.bake.resolution = 64


KINDS = {
    "missing": "are missing",
    "empty": "cannot be read",
    "cut": "cannot be read",
    "no table": "cannot be read",
    "noise": "cannot be read",
    "other frame": "show another sea",
    "other sea": "show another sea",
    "other seed": "show another sea",
}


@pytest.mark.parametrize("kind", KINDS)
def test_a_file_that_is_not_that_of_its_frame_stops_the_render(sea, tmp_path, capfd, kind):
    assert render(capfd, 6) == []
    assert bake_state.faults(sea) == []
    damage(tmp_path, kind, "displacement")
    where = f"Ocean: files of the bake {KINDS[kind]}, of the frames 6 ({file(tmp_path, 6)})"
    assert stopped(capfd, 6) == [f"Error: {where}"]
    os.utime(tmp_path / "ocean_bake" / "Ocean")  # what a copy, a removal or a new file does
    assert bake_state.faults(sea) == [where]
    said = bake_state.state(sea, bpy.context.scene)
    assert (where, "ERROR") in said
    for frame in (5, 7):  # which do not show it
        assert render(capfd, frame) == []
    with_motion(0.5)  # these do, as they are blurred
    assert len(stopped(capfd, 5)) == 1 and len(stopped(capfd, 7)) == 1
    assert render(capfd, 8) == []


def with_motion(shutter: float) -> None:
    render = bpy.context.scene.render
    render.use_motion_blur, render.motion_blur_shutter = True, shutter


def test_each_field_that_is_shown_counts(sea, tmp_path, capfd):
    for field in FIELDS[1:]:
        damage(tmp_path, "other field" if field == "velocity" else "missing", field)
    said = stopped(capfd, 6)
    assert [line.partition("bake ")[2].partition(",")[0] for line in said] == [
        "are missing",
        "show another sea",
    ]
    sea.libocean.use_foam = sea.libocean.use_velocity = sea.libocean.use_normal = False
    assert render(capfd, 6) == []


def test_subframes_take_the_files_beside_them(sea, tmp_path, capfd):
    damage(tmp_path, "missing", "displacement")
    assert len(stopped(capfd, 5, 0.25)) == 1
    assert len(stopped(capfd, 6, 0.75)) == 1
    assert render(capfd, 7, 0.5) == render(capfd, 8, 0.5) == []


def test_the_first_file_may_be_missing(scene, sea, tmp_path, capfd):
    """Blender knows a sequence by it."""
    scene.frame_set(6)
    want = positions(sea).copy()
    file(tmp_path, 3).unlink()
    sea.libocean.use_bake = False
    sea.libocean.use_bake = True
    assert "files of the bake are missing, of the frames 3 " in sea.libocean.problem
    scene.frame_set(5)
    scene.frame_set(6)
    assert np.array_equal(positions(sea), want)
    assert render(capfd, 6) == []
    ob = reopened(tmp_path / "shot.blend", "Ocean", 6)
    assert np.array_equal(positions(ob), want)


def test_another_size_of_the_same_sea_stops_it(sea, tmp_path, capfd):
    damage(tmp_path, "other size", "displacement")
    assert "show another sea, of the frames 6 " in stopped(capfd, 6)[0]


def test_files_without_a_name_play(sea, tmp_path, capfd):
    """A file of another program, or of an earlier bake, may say nothing of a sea: a hint."""
    path = file(tmp_path, 6)
    path.write_bytes(path.read_bytes().replace(b"ocean:", b"other:"))
    assert render(capfd, 6) == [
        "Warning: Ocean: files of the bake do not say which sea they show: 6"
    ]


def test_an_interrupted_bake_of_another_sea_is_found(sea, tmp_path, capfd):
    """Its first frames are those of the new sea, the others of the one that the object plays."""
    sea.libocean.choppiness = 0.5
    job = bake_plan.Bake(bpy.context, sea, "", (FIRST, LAST), overwrite=False).job
    job.run(lambda: job.stop.set() if job.done == 3 else None)
    assert job.done == 3
    assert render(capfd, 6) == []
    assert "show another sea, of the frames 5 " in stopped(capfd, 5)[0]
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    assert render(capfd, 5) == []


def test_a_keyframed_sea_is_known_frame_by_frame(scene, sea, tmp_path, capfd):
    keyed(sea.libocean, choppiness={4: 0.0, 8: 1.0})
    bpy.ops.libocean.bake()
    assert render(capfd, 5) == []
    path = file(tmp_path, 6)
    path.write_bytes(path.read_bytes().replace(b"choppiness = 0.5\n", b"choppiness = 0.6\n"))
    assert "show another sea, of the frames 6 " in stopped(capfd, 6)[0]
    # A bake of an earlier version has no marks: of a keyframed sea its frames are not known.
    sea.libocean.bake.property_unset("marks")
    assert render(capfd, 6) == []


def test_a_bake_of_an_earlier_version_is_compared_with_its_one_sea(sea, tmp_path, capfd):
    sea.libocean.bake.property_unset("marks")
    assert render(capfd, 6) == []
    damage(tmp_path, "other seed", "displacement")
    assert "show another sea, of the frames 6 " in stopped(capfd, 6)[0]


# Which oceans -------------------------------------------------------------------


def test_an_ocean_that_is_not_rendered_stops_nothing(scene, sea, tmp_path, capfd):
    damage(tmp_path, "missing", "displacement")
    stopped(capfd, 6)
    sea.hide_render = True
    assert render(capfd, 6) == []
    sea.hide_render = False
    collection = bpy.data.collections.new("Sea")
    scene.collection.children.link(collection)
    scene.collection.objects.unlink(sea)
    collection.objects.link(sea)
    stopped(capfd, 6)
    layer = bpy.context.view_layer.layer_collection.children["Sea"]
    layer.exclude = True
    assert render(capfd, 6) == []
    instance = bpy.data.objects.new("Instance", None)
    instance.instance_type, instance.instance_collection = "COLLECTION", collection
    scene.collection.objects.link(instance)
    stopped(capfd, 6)
    instance.hide_render = True
    assert render(capfd, 6) == []
    other = bpy.data.scenes.new("Other")
    other.collection.objects.link(sea)
    assert render(capfd, 6) == []
    scene.background_set = other
    stopped(capfd, 6)
    scene.background_set = None
    layer.exclude = False
    editor = scene.sequence_editor_create()
    stopped(capfd, 6)
    strips = editor.strips if hasattr(editor, "strips") else editor.sequences
    length = {"length": 20} if bpy.app.version >= (5, 0) else {"frame_end": 20}
    strips.new_effect(name="Black", type="COLOR", channel=1, frame_start=1, **length)
    assert render(capfd, 6) == []  # which shows the strip alone
    scene.render.use_sequencer = False
    stopped(capfd, 6)
    sea.libocean.use_bake = False
    assert render(capfd, 6) == []


def test_what_lies_beyond_the_bake_is_a_warning(scene, sea, capfd):
    assert render(capfd, 9) == []
    assert render(capfd, 12) == ["Warning: Ocean: the sea stands still at frames 12: Frames 3 to 9"]
    scene.render.frame_map_old, scene.render.frame_map_new = 100, 200
    assert "at frames 5: " in render(capfd, 5)[0]  # the scene's time is 2.5 there


def test_volumes_of_another_sea_stop_it(scene, tmp_path, capfd, scripted_volumes):
    """Written by the add-on, which says what each file must show; of others nothing is known."""
    ob = small_sea(scene)
    save(tmp_path / "shot.blend")
    bpy.ops.libocean.write_volumes()
    (volume,) = (other for other in bpy.data.objects if other.type == "VOLUME")
    files = [tmp_path / "ocean_volumes" / f"shot.Ocean_{frame:04d}.vdb" for frame in range(10)]
    assert render(capfd, 6) == []
    whole = files[6].read_text()
    files[6].write_text(files[7].read_text())
    said = f"show another sea, of the frames 6 ({files[6]})"
    assert stopped(capfd, 6) == [f"Error: Ocean Volumes: files of the bake {said}"]
    files[6].write_text(whole.replace("seed = 1", "seed = 7"))
    assert len(stopped(capfd, 6)) == 1
    files[6].unlink()
    assert "are missing, of the frames 6 " in stopped(capfd, 6)[0]
    assert render(capfd, 7) == render(capfd, 20) == []  # where none is shown
    volume.data.frame_start += 1  # shown a frame later
    assert render(capfd, 6) == []
    assert "are missing, of the frames 6 " in stopped(capfd, 7)[0]
    volume.hide_render = True
    assert render(capfd, 7) == []
    assert ob.libocean.volumes.written == "//ocean_volumes/shot.Ocean"


# Animations ---------------------------------------------------------------------


def rendered_frames(tmp_path: Path) -> list[str]:
    return sorted(path.name for path in (tmp_path / "out").glob("*"))


def test_an_animation_ends_before_the_frame_and_has_warned(scene, sea, tmp_path, capfd):
    scene.render.use_overwrite, scene.render.use_placeholder = False, True
    for frame in (7, 8):
        file(tmp_path, frame).unlink()
    said = stopped(capfd, animation=True)
    assert [line.split("(")[0] for line in said] == [
        "Warning: Ocean: files of the bake are missing, of the frames 7-8 ",
        "Error: Ocean: files of the bake are missing, of the frames 7 ",
    ]
    assert rendered_frames(tmp_path) == ["0004.exr", "0005.exr", "0006.exr"]  # no placeholder
    scene.frame_start, scene.frame_step = 3, 6  # passes over them
    assert render(capfd, animation=True) == []


def test_cameras_of_markers_are_given_back(scene, sea, tmp_path, capfd):
    damage(tmp_path, "missing", "displacement")
    marker = scene.timeline_markers.new("cut", frame=1)
    marker.camera = scene.camera
    stopped(capfd, 6)
    assert marker.camera == scene.camera
    assert render(capfd, 5) == []


@pytest.mark.skipif(not bpy.app.binary_path, reason="the Python module bpy has no command line")
def test_a_command_line_ends_with_a_status(sea, tmp_path):
    """As a farm sees it: the frame or the shot, and what is said."""
    for frame in (5, 7):
        file(tmp_path, frame).unlink()

    def run(*arguments) -> tuple[bool, str, list[str]]:
        command = [bpy.app.binary_path, "--background", "--factory-startup"]
        command += ["--addons", "libocean_addon", tmp_path / "shot.blend"]
        ended = subprocess.run([*command, *arguments], capture_output=True, text=True)
        found = rendered_frames(tmp_path)
        for path in (tmp_path / "out").glob("*"):
            path.unlink()
        lines = [line for line in ended.stderr.splitlines() if "files of the bake" in line]
        return ended.returncode == 0, "\n".join(lines), found

    where = file(tmp_path, 5)
    said = f"Error: Ocean: files of the bake are missing, of the frames 5, 7 ({where})"
    assert run("-a") == (False, said, [])  # before the first frame
    ok, said, found = run("-s", "8", "-e", "8", "-a", "-f", "4,5")
    assert (ok, found) == (False, ["0004.exr", "0008.exr"])
    assert said == f"Error: Ocean: files of the bake are missing, of the frames 5 ({where})"
    script = "import bpy; bpy.context.scene.frame_set(5); bpy.ops.render.render(write_still=True)"
    assert run("--python-expr", script)[0] is False


@pytest.mark.slow
@needs_window
def test_a_render_in_a_window_is_cancelled_and_says_why(tmp_path):
    in_another_blender(other_blender.see_renders_cancelled, tmp_path)
