# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bakes: the files are those of `ocean bake`, what plays is what was live, and a farm needs no
add-on."""

import json
import os
import shutil
import subprocess
import sys
import types
from pathlib import Path

import bpy
import numpy as np
import pytest
from conftest import (
    add_ocean,
    attribute,
    evaluated_mesh,
    pixels,
    plane,
    positions,
    presets_with,
    rendered,
    shot_of,
    start_another_process,
)

FIELDS = ("displacement", "cover", "velocity", "normal", "jacobian")


@pytest.fixture
def sea(scene, tmp_path):
    """A small sea in a saved file, its shot of four frames."""
    # A sea of few samples has foam by a threshold; a short life makes its past short.
    foam = {"foam_coverage": "threshold", "foam_threshold": 0.9, "foam_lifetime": 1.0}
    ob = add_ocean(64, sea=foam, kind="PATCH", preset="beaufort_6", use_material=False)
    shot_of(scene, ob)
    scene.frame_start, scene.frame_end = 2, 5
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "shot.blend"))
    return ob


def files(tmp_path: Path) -> Path:
    return tmp_path / "ocean_bake" / "Ocean"


def read_exr(path: Path) -> tuple[dict[str, str], dict[str, np.ndarray]]:
    """Header and channels as bit patterns; what is half in the file would be another type."""
    from libocean_addon.bake import exr_files

    image = exr_files.load_package().InputFile(str(path))
    header = image.header()
    planes = {name: np.frombuffer(image.channel(name), np.int32) for name in header["channels"]}
    assert image.isComplete()
    return {name: str(value) for name, value in header.items()}, planes


def shown(ob) -> dict[str, np.ndarray]:
    """All that the node group gives a mesh."""
    names = ("foam", "cover", "label", "velocity", "ocean_velocity", "ocean_normal", "jacobian")
    return {"position": positions(ob), **{name: attribute(ob, name) for name in names}}


def assert_same(one: dict[str, np.ndarray], other: dict[str, np.ndarray]) -> None:
    for name, values in one.items():
        assert np.array_equal(values, other[name]), name


def times(folder: Path) -> dict[str, int]:
    return {path.name: path.stat().st_mtime_ns for path in folder.iterdir()}


def failing(call, **arguments) -> str:
    """Returns the message of an operator that must fail."""
    with pytest.raises(RuntimeError) as failure:
        call(**arguments)
    return str(failure.value)


# Files ------------------------------------------------------------------------


@pytest.mark.skipif("OCEAN" not in os.environ, reason="OCEAN is not the path of the program")
def test_the_files_are_those_of_ocean_bake(scene, sea, tmp_path):
    program = Path(os.environ["OCEAN"]).resolve()
    sea.libocean.start = 100000.0
    sea.libocean.use_detail = True
    scene.render.fps, scene.render.fps_base = 30, 1.001
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    bpy.ops.libocean.save_sea(filepath=str(tmp_path / "sea.toml"))
    subprocess.run(
        [program, "bake", "sea.toml", "-o", "there/shot.####.exr", "--frames", "1-6"]
        + ["--type", "float", "--products", ",".join((*FIELDS, "detail"))],
        cwd=tmp_path,
        check=True,
    )
    theirs = sorted((tmp_path / "there").glob("*.exr"))
    assert len(theirs) == 6 * (len(FIELDS) + 3)
    assert [p.name for p in theirs] == sorted(p.name for p in files(tmp_path).iterdir())
    for path in theirs:
        (header, planes), (our_header, ours) = read_exr(path), read_exr(files(tmp_path) / path.name)
        assert our_header == header
        assert set(ours) == set(planes)
        for name, bits in planes.items():
            assert np.array_equal(ours[name], bits), (path.name, name)


def test_numbers_are_written_as_the_program_writes_them(sea):
    from libocean_addon.volumes.volume_job import shortest

    written = "0 690 1e+05 12.5 0.041666666666666664 1e-04 0.001 -0.5 1.5e-07 -1e+05"
    assert " ".join(shortest(float(text)) for text in written.split()) == written


def test_unused_fields_are_not_baked(sea, tmp_path):
    bpy.context.scene.frame_set(4)
    assert attribute(sea, "foam").max() > 0.1 and attribute(sea, "cover").max() > 0.001
    assert np.ptp(attribute(sea, "jacobian")) > 0.5
    sea.libocean.use_foam = False
    sea.libocean.use_velocity = False
    bpy.ops.libocean.bake(frame_start=3, frame_end=3)
    fields = {path.name.split(".")[1] for path in files(tmp_path).iterdir()}
    assert fields == {"displacement", "normal"}
    assert "foam" not in evaluated_mesh(sea).attributes


def test_another_sea_is_written_again_and_shown(scene, sea, tmp_path):
    bpy.ops.libocean.bake()
    before = times(files(tmp_path))
    scene.frame_set(4)
    shown(sea)
    sea.libocean.choppiness = 0.5
    bpy.ops.libocean.bake()
    after = times(files(tmp_path))
    assert all(before[name] != after[name] for name in before)
    baked = shown(sea)
    sea.libocean.use_bake = False
    assert_same(shown(sea), baked)


def test_a_write_that_fails_leaves_nothing(sea, tmp_path, monkeypatch):
    """A disk that fills up: the package ends a file early and says nothing."""
    from libocean_addon.bake import exr_files

    package = exr_files.load_package()
    output_file = package.OutputFile

    class CutOff:
        def __init__(self, path, header):
            self.path, self.image = path, output_file(path, header)

        def writePixels(self, *rows):  # noqa: N802
            self.image.writePixels(*rows)

        def close(self):
            self.image.close()
            os.truncate(self.path, os.path.getsize(self.path) - 100)

    monkeypatch.setattr(package, "OutputFile", CutOff)
    assert "is the disk full?" in failing(bpy.ops.libocean.bake)
    assert list(files(tmp_path).iterdir()) == []
    assert not sea.libocean.use_bake


# Playing ----------------------------------------------------------------------


def test_between_frames_it_lies_between(scene, sea):
    bpy.ops.libocean.bake()
    scene.frame_set(3)
    before = shown(sea)
    scene.frame_set(4)
    after = shown(sea)
    scene.frame_set(3, subframe=0.25)
    for name, values in shown(sea).items():
        if name == "foam":  # made of cover, which lies between
            continue
        expected = 0.75 * before[name] + 0.25 * after[name]
        assert np.allclose(values, expected, atol=2e-5), name


def test_a_mesh_of_its_own_plays_it_too(scene, tmp_path):
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "shot.blend"))
    ob = plane(40.0, 20)
    with presets_with(resolution=64):
        bpy.ops.libocean.add_modifier()
    ob.location = (-1234.5, 77.0, 3.0)
    scene.frame_set(3)
    live = shown(ob)
    bpy.ops.libocean.bake(frame_start=3, frame_end=3)
    for name, values in shown(ob).items():
        assert np.allclose(values, live[name], atol=1e-5), name
    # Anchored to the world as a live one is, which moves with the object.
    ob.location.x += 10.0
    bpy.context.view_layer.update()
    moved = shown(ob)
    assert not np.allclose(moved["position"], live["position"], atol=1e-2)
    ob.libocean.use_bake = False
    bpy.context.view_layer.update()
    for name, values in shown(ob).items():
        assert np.allclose(values, moved[name], atol=1e-5), name


@pytest.mark.slow
def test_a_horizon_plays_around_the_camera(scene, tmp_path):
    scene.camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    bpy.context.collection.objects.link(scene.camera)
    for frame, x in ((2, 0.0), (5, 777.0)):
        scene.camera.location.x = x
        scene.camera.keyframe_insert("location", frame=frame)
    bpy.ops.libocean.add(kind="HORIZON", preset="beaufort_8")
    ob = bpy.context.object
    ob.libocean.resolution, ob.libocean.horizon_vertices = 64, 20000
    scene.frame_start, scene.frame_end = 2, 5
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "shot.blend"))

    def now() -> dict[str, np.ndarray]:
        return {**shown(ob), "slope_variance": attribute(ob, "slope_variance")}

    live = {}
    for frame in (2, 4, 5):
        scene.frame_set(frame)
        live[frame] = now()
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    names = {path.name.split(".")[1] for path in files(tmp_path).iterdir()}
    assert names == {*FIELDS, *(f"{field}_far" for field in FIELDS)}
    for frame, values in live.items():
        scene.frame_set(frame)
        for name, baked in now().items():
            assert np.allclose(baked, values[name], atol=2e-6, rtol=1e-6), name
    header, planes = read_exr(files(tmp_path) / "shot.normal_far.0004.exr")
    assert set(planes) == set("RGBA")
    assert eval(header["ocean:field"]) == b"normal_far"
    bpy.ops.libocean.bake()  # all of them are there
    assert bpy.ops.libocean.free_bake() == {"FINISHED"}
    scene.frame_set(4)
    assert_same(now(), live[4])


def test_nothing_is_asked_of_the_library_while_it_plays(scene, sea, monkeypatch):
    from libocean_addon.sea import open_sea

    sea.libocean.use_detail = True
    bpy.ops.libocean.add_material()
    bpy.ops.libocean.bake()
    monkeypatch.setattr(open_sea.OpenSea, "follow", lambda *_: pytest.fail("the sea was asked"))
    scene.frame_set(4)
    sea.libocean.choppiness = 0.25
    assert sea.libocean.use_bake


def test_a_keyframed_sea_is_baked_frame_by_frame(scene, sea):
    for frame, value in ((2, 0.0), (5, 1.5)):
        sea.libocean.choppiness = value
        sea.libocean.keyframe_insert("choppiness", frame=frame)
    live = {}
    for frame in (2, 3, 5):
        scene.frame_set(frame)
        live[frame] = shown(sea)
    scene.frame_set(4, subframe=0.5)
    bpy.ops.libocean.bake()
    assert scene.frame_current_final == 4.5
    for frame, values in live.items():
        scene.frame_set(frame)
        baked = shown(sea)
        # Foam is made of cover by the first frame's power.
        del baked["foam"]
        assert_same(baked, values)


def test_own_and_remapped_time_is_baked_as_shown(scene, sea):
    scene.render.frame_map_old, scene.render.frame_map_new = 100, 150
    live = {}
    for frame in (2, 3):
        scene.frame_set(frame)
        live[frame] = shown(sea)
    bpy.ops.libocean.bake()
    for frame, values in live.items():
        scene.frame_set(frame)
        assert_same(shown(sea), values)


def test_own_time_is_baked_as_shown(scene, sea):
    sea.libocean.use_custom_time = True
    for frame, value in ((2, 7.0), (5, 3.0)):
        sea.libocean.custom_time = value
        sea.libocean.keyframe_insert("custom_time", frame=frame)
    scene.frame_set(4)
    live = shown(sea)
    bpy.ops.libocean.bake()
    scene.frame_set(4)
    assert_same(shown(sea), live)


def test_an_animated_period_is_refused(scene, sea, tmp_path):
    for frame, value in ((2, 100.0), (5, 200.0)):
        sea.libocean.patch_size = value
        sea.libocean.keyframe_insert("patch_size", frame=frame)
    assert "a bake has one of each" in failing(bpy.ops.libocean.bake)
    assert not files(tmp_path).exists()


def made_by_an_earlier_version(ob, folder: Path) -> None:
    """Its bake has neither a Jacobian nor detail, in files, record and node group."""
    from libocean_addon.sea import node_group
    from libocean_addon.shared import modifier_groups

    record = ob.libocean.bake
    for field in record.fields.split(","):
        if field.startswith(("jacobian", "detail")):
            for path in folder.glob(f"shot.{field}.*.exr"):
                path.unlink()
    fields = [name for name in record.fields.split(",") if not name.startswith(("jac", "detail"))]
    record.fields, record.bands = ",".join(fields), ""
    (modifier,) = node_group.modifiers(ob)
    group = modifier.node_group
    group.name, group[node_group.MARK] = ".libocean.v5 of before", 5
    modifier_groups.assign(modifier, {"Jacobian": None, "Use Jacobian": False})


def test_a_bake_of_an_earlier_version_plays(scene, sea, tmp_path):
    from libocean_addon.bake import bake_state
    from libocean_addon.sea import node_group

    scene.frame_set(4)
    sea.libocean.use_detail = True
    bpy.ops.libocean.add_material()
    bpy.ops.libocean.bake()
    folder = files(tmp_path)
    there = shown(sea)
    made_by_an_earlier_version(sea, folder)
    bpy.ops.wm.save_mainfile()
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "shot.blend"))
    ob, scene = bpy.data.objects["Ocean"], bpy.context.scene
    scene.frame_set(4)
    (modifier,) = node_group.modifiers(ob)
    assert modifier.node_group[node_group.MARK] == node_group.VERSION
    assert ob.libocean.use_bake and ob.libocean.problem == ""
    found = shown(ob)
    assert (found.pop("jacobian") == 1.0).all() and np.ptp(there["jacobian"]) > 0.5
    assert_same(found, there)
    said = [text for text, _ in bake_state.state(ob, scene)]
    assert "Not in the bake: jacobian, detail" in said
    kept = times(folder)
    bpy.context.view_layer.objects.active = ob
    bpy.ops.libocean.bake()  # adds it
    after = times(folder)
    assert {name: after[name] for name in kept} == kept
    added = {name.split(".")[1] for name in set(after) - set(kept)}
    assert added == {"jacobian", "detail1", "detail2", "detail3"}
    assert_same(shown(ob), there)
    assert not any("Not in the bake" in text for text, _ in bake_state.state(ob, scene))


@pytest.mark.parametrize("kind", ["PATCH", pytest.param("HORIZON", marks=pytest.mark.slow)])
def test_sizes_are_told(scene, sea, kind):
    """The panel expects the samples of at most three bands, and counts the present files."""
    from libocean_addon.bake import bake_plan, bake_record, bake_state

    sea.libocean.use_detail = True
    if kind == "HORIZON":
        bpy.data.objects.remove(sea)
        bpy.ops.libocean.add(kind="HORIZON", preset="beaufort_6")
        sea = bpy.context.object
        sea.libocean.resolution, sea.libocean.horizon_vertices = 64, 20000
        sea.libocean.use_detail = True
    bpy.ops.libocean.bake(frame_start=2, frame_end=2)
    folder = bake_record.place_of(sea).path
    one = {path.name.split(".")[1]: read_exr(path)[1] for path in folder.glob("*.0002.exr")}
    bands = [planes for field, planes in one.items() if field.startswith("detail")]
    assert len(bands) == 3
    samples = sum(plane.size for planes in one.values() for plane in planes.values())
    assert bake_plan.size_estimate(sea, (64, 64), 5) == 5 * 4 * samples
    size = sum(path.stat().st_size for path in folder.iterdir())
    said = [text for text, _ in bake_state.state(sea, scene)]
    assert f"3 of 3 frames, {size / 1e6:.1f} MB" in said
    assert bpy.ops.libocean.free_bake(delete_files=True) == {"FINISHED"}
    assert not folder.exists()


def test_tiles_of_animated_limits_are_refused(scene, sea):
    sea.libocean.use_detail = True
    for frame, value in ((2, 1.0), (5, 0.5)):
        sea.libocean.longest_wavelength = value
        sea.libocean.keyframe_insert("longest_wavelength", frame=frame)
    assert "The limits of the wavelength are animated" in failing(bpy.ops.libocean.bake)
    sea.libocean.use_detail = False
    assert bpy.ops.libocean.bake() == {"FINISHED"}


# Live and baked ---------------------------------------------------------------


def test_without_a_bake_the_switch_stays_off(sea):
    sea.libocean.use_bake = True
    assert not sea.libocean.use_bake


def test_free_deletes_its_own_files_only(sea, tmp_path):
    bpy.ops.libocean.bake()
    other = files(tmp_path) / "notes.txt"
    other.write_text("mine")
    bpy.ops.libocean.free_bake(delete_files=True)
    assert list(files(tmp_path).iterdir()) == [other]


def test_a_bake_of_another_object_is_not_overwritten(sea, tmp_path):
    bpy.ops.libocean.bake()
    bpy.ops.object.duplicate()
    bpy.context.object.libocean.seed = 7
    folder = str(files(tmp_path))
    assert "choose another folder" in failing(bpy.ops.libocean.bake, directory=folder)


def test_a_file_with_a_bake_is_opened_again(scene, sea, tmp_path):
    scene.frame_set(4)
    live = shown(sea)
    bpy.ops.libocean.bake()
    bpy.ops.wm.save_mainfile()
    elsewhere = tmp_path / "elsewhere"
    shutil.copytree(tmp_path / "ocean_bake", elsewhere / "ocean_bake")
    shutil.copy(tmp_path / "shot.blend", elsewhere)
    shutil.rmtree(tmp_path / "ocean_bake")
    bpy.ops.wm.open_mainfile(filepath=str(elsewhere / "shot.blend"))
    ob = bpy.data.objects["Ocean"]
    bpy.context.scene.frame_set(4)
    assert_same(shown(ob), live)
    ob.libocean.use_bake = False
    assert_same(shown(ob), live)


def test_saved_elsewhere_it_still_knows_its_files(scene, sea, tmp_path):
    scene.frame_set(4)
    live = shown(sea)
    bpy.ops.libocean.bake()
    (tmp_path / "version_2").mkdir()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "version_2" / "shot.blend"))
    sea.libocean.follow_world = False
    sea.libocean.use_bake = False
    sea.libocean.use_bake = True
    assert sea.libocean.problem == ""
    assert_same(shown(sea), live)


def test_baked_into_another_folder_it_plays_that(scene, sea, tmp_path):
    from libocean_addon.bake import bake_record

    bpy.ops.libocean.bake()
    shutil.rmtree(files(tmp_path))
    sea.libocean.choppiness = 0.5
    sea.libocean.bake.directory = "//second"
    bpy.ops.libocean.bake()
    assert bake_record.place_of(sea).path == tmp_path / "second"
    scene.frame_set(4)
    playing = shown(sea)
    sea.libocean.use_bake = False
    assert_same(shown(sea), playing)


def test_missing_files_are_told(sea, tmp_path):
    bpy.ops.libocean.bake()
    sea.libocean.use_bake = False
    shutil.rmtree(files(tmp_path))
    sea.libocean.use_bake = True
    assert "files of the bake" in sea.libocean.problem


def test_an_unsaved_file_has_no_folder_for_it(scene):
    add_ocean(32, kind="PATCH", preset="beaufort_6")
    assert "Save the blend file first" in failing(bpy.ops.libocean.bake)


def test_a_folder_that_cannot_be_made_is_told(sea, tmp_path):
    (tmp_path / "file").write_text("")
    asked = str(tmp_path / "file" / "bake")
    assert "cannot be made" in failing(bpy.ops.libocean.bake, directory=asked)
    assert not sea.libocean.use_bake


@pytest.mark.parametrize("turn", [(0.0, 0.0, 0.6), (0.3, 0.0, 0.6)])
def test_what_is_turned_plays_the_same_sea(scene, sea, turn):
    """Also where it is turned while it plays, which takes no add-on."""
    scene.frame_set(3)
    sea.location, sea.rotation_euler = (31.7, -12.2, 3.0), turn
    bpy.context.view_layer.update()
    live = shown(sea)
    sea.rotation_euler = (0.0, 0.0, 0.0)
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    level = positions(sea).copy()
    sea.rotation_euler = turn
    bpy.context.view_layer.update()
    baked = shown(sea)
    assert np.abs(baked["position"] - level).max() > 0.1
    for name, values in live.items():
        assert np.abs(values - baked[name]).max() < 1e-4, name


def test_an_object_with_another_name_keeps_its_bake(scene, sea, tmp_path):
    from libocean_addon.bake import bake_record

    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "shot.blend"))
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    before = bake_record.place_of(sea)
    recipes = json.loads(sea.libocean.bake.recipes)
    sea.name = "Atlantic"
    assert bake_record.place_of(sea) == bake_record.next_place(sea, recipes) == before
    written = sorted((tmp_path / "ocean_bake").rglob("*.exr"))
    assert bpy.ops.libocean.bake() == {"FINISHED"}  # goes on, there
    assert sorted((tmp_path / "ocean_bake").rglob("*.exr")) == written
    assert sea.libocean.use_bake
    assert sea.libocean.problem == ""
    twin = sea.copy()  # a bake of its own
    bpy.context.collection.objects.link(twin)
    assert bake_record.next_place(twin, recipes) != before


def test_an_object_that_is_renamed_meanwhile_gets_its_bake(sea, tmp_path):
    from libocean_addon.bake import bake_plan, bake_state

    folder = str(tmp_path / "there")
    started = bake_plan.Bake(bpy.context, sea, folder, (2, 3), overwrite=False)
    sea.name = "Atlantic"
    started.job.run()
    assert started.is_of(sea)
    started.finish()
    assert sea.libocean.use_bake
    assert bake_state.state(sea, bpy.context.scene)


def test_what_the_library_refuses_is_told(sea, tmp_path):
    sea.libocean.shortest_wavelength, sea.libocean.longest_wavelength = 50.0, 10.0
    assert "Longest wavelength = 10 m: must be more" in failing(bpy.ops.libocean.bake)
    assert not sea.libocean.use_bake


def test_the_panel_says_what_is_baked(scene, sea):
    from libocean_addon.bake import bake_state

    bpy.ops.libocean.bake()

    def said() -> str:
        return "\n".join(text for text, _ in bake_state.state(sea, scene))

    assert "6 of 6 frames" in said()
    assert "another sea" not in said()
    sea.libocean.choppiness = 0.75
    assert "another sea" in said()
    sea.libocean.choppiness = 1.0
    assert "another sea" not in said()
    scene.frame_end = 9
    assert "stands still" in said()
    scene.render.fps = 25
    assert "another sea" in said()


def test_the_panel_compares_a_keyframed_sea_at_its_frame(scene, sea):
    from libocean_addon.bake import bake_state

    for frame, value in ((2, 0.0), (5, 1.5)):
        sea.libocean.choppiness = value
        sea.libocean.keyframe_insert("choppiness", frame=frame)
    bpy.ops.libocean.bake()
    for frame in (2, 4):
        scene.frame_set(frame)
        assert not any("another sea" in text for text, _ in bake_state.state(sea, scene))
    sea.libocean.seed = 5
    assert any("another sea" in text for text, _ in bake_state.state(sea, scene))


def test_the_object_keeps_the_sea_that_its_files_name(sea, tmp_path):
    bpy.ops.libocean.bake()
    header, _ = read_exr(files(tmp_path) / "shot.displacement.0003.exr")
    assert header["ocean:sea"] == str(sea.libocean.bake.sea.encode())


def test_a_package_that_is_missing_or_not_our_own_is_told(sea, tmp_path, monkeypatch):
    other = types.ModuleType("OpenEXR")
    other.__file__ = str(tmp_path / "OpenEXR.so")
    for found, reason in ((None, "import of OpenEXR halted"), (other, "is not that of the add-on")):
        monkeypatch.setitem(sys.modules, "OpenEXR", found)
        said = failing(bpy.ops.libocean.bake)
        assert "takes the Python package OpenEXR" in said and reason in said
        assert not files(tmp_path).exists()


# Stopping ---------------------------------------------------------------------


def test_a_stopped_bake_keeps_what_is_finished_and_goes_on(scene, sea, tmp_path):
    from libocean_addon.bake import bake_plan

    planned = bake_plan.Bake(bpy.context, sea, "//ocean_bake/Ocean/", (2, 5), overwrite=False)
    job = planned.job

    def stop_after_two() -> None:
        if job.done == 2:
            job.stop.set()

    job.run(stop_after_two)
    assert job.done == 2
    assert not sea.libocean.use_bake
    finished = times(files(tmp_path))
    assert {name.split(".")[2] for name in finished} == {"0001", "0002"}
    bpy.ops.libocean.bake()
    after = times(files(tmp_path))
    assert len(after) == 6 * len(FIELDS)
    assert {name: after[name] for name in finished} == finished


IN_A_WINDOW = """
import json

bpy.ops.preferences.addon_enable(module="libocean_addon")
folder = arguments[0]
bpy.ops.wm.save_as_mainfile(filepath=os.path.join(folder, "shot.blend"))
bpy.ops.libocean.add(kind="PATCH", preset="beaufort_6")
ob = bpy.context.object
ob.libocean.resolution = 64
scene = bpy.context.scene
said = {}


def invoke(last):
    scene.frame_start, scene.frame_end = 1, last
    with bpy.context.temp_override(window=bpy.context.window_manager.windows[0]):
        said.setdefault("invoked", []).append(list(bpy.ops.libocean.bake("INVOKE_DEFAULT")))


def steps():
    from libocean_addon.bake import bake, bake_state

    invoke(2000)
    while bake.running.job.done < 3:
        yield
    said["state"] = bake_state.state(ob, scene)[0][0]
    window = bpy.context.window_manager.windows[0]
    window.event_simulate(type="ESC", value="PRESS", x=300, y=300)
    yield
    window.event_simulate(type="ESC", value="RELEASE", x=300, y=300)
    while bake.running is not None:
        yield
    said["after_escape"] = ob.libocean.use_bake
    said["files"] = len(os.listdir(os.path.join(folder, "ocean_bake", "Ocean")))
    invoke(2)
    while bake.running is not None:
        yield
    said["after_the_end"] = ob.libocean.use_bake
    with open(os.path.join(folder, "said.json"), "w") as file:
        json.dump(said, file)
    os._exit(0)


running = steps()
bpy.app.timers.register(lambda: next(running, None) or 0.05, first_interval=1.0)
"""


@pytest.mark.skipif(not bpy.app.binary_path, reason="the Python module bpy has no windows")
@pytest.mark.skipif(shutil.which("xvfb-run") is None, reason="no display can be made")
def test_escape_stops_it_in_the_interface(tmp_path):
    script = tmp_path / "script.py"
    prelude = "import bpy, os, sys\narguments = sys.argv[sys.argv.index('--') + 1 :]\n"
    script.write_text(prelude + IN_A_WINDOW)
    display = ["xvfb-run", "-a", "-s", "-screen 0 1280x800x24 +extension GLX"]
    window = [bpy.app.binary_path, "--factory-startup", "--enable-event-simulate"]
    subprocess.run(
        [*display, *window, "--python", script, "--", tmp_path], timeout=300, capture_output=True
    )
    said = json.loads((tmp_path / "said.json").read_text())
    assert said["invoked"] == [["RUNNING_MODAL"], ["RUNNING_MODAL"]]
    assert "of 2002 frames; ESC stops" in said["state"]
    assert said["after_escape"] is False
    assert 3 * len(FIELDS) <= said["files"] < 2002 * len(FIELDS)
    assert said["after_the_end"] is True


# A farm -----------------------------------------------------------------------

RENDER = """
bpy.ops.wm.open_mainfile(filepath=arguments[0])
assert not hasattr(bpy.types.Object, "libocean")
assert not any("libocean" in name for name in sys.modules)
bpy.context.scene.render.filepath = "//out/f_####"
bpy.context.scene.render.use_overwrite = False
bpy.context.scene.render.use_placeholder = True
bpy.ops.render.render(animation=True)
"""


@pytest.mark.parametrize("kind", ["OPEN_EXR", "PNG"])
def test_a_farm_renders_it_without_the_add_on(scene, sea, tmp_path, kind):
    settings = scene.render.image_settings
    settings.file_format = kind
    settings.color_depth = "32" if kind == "OPEN_EXR" else "16"
    suffix = ".exr" if kind == "OPEN_EXR" else ".png"
    live = {}
    for frame in range(2, 6):
        scene.frame_set(frame)
        live[frame] = rendered(scene, tmp_path / f"live_{frame}{suffix}")
    assert not np.array_equal(live[2], live[3])
    bpy.ops.libocean.bake()
    bpy.ops.wm.save_mainfile()
    farm = tmp_path / "farm"
    farm.mkdir()
    shutil.move(tmp_path / "shot.blend", farm)
    shutil.move(tmp_path / "ocean_bake", farm)
    nodes = []
    for number in range(2):
        (tmp_path / f"node_{number}").mkdir()
        nodes.append(
            start_another_process(tmp_path / f"node_{number}", RENDER, farm / "shot.blend")
        )
    for node in nodes:
        out, _ = node.communicate(timeout=300)
        assert node.returncode == 0, out
    for frame, expected in live.items():
        assert np.array_equal(pixels(farm / "out" / f"f_{frame:04}{suffix}"), expected)
