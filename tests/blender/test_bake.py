# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bakes of a sea: what is baked is what was shown, whatever its time, place and mesh; what cannot
be baked is said; a farm needs no add-on. What every bake has is in test_bake_life.py."""

import json
import os
import shutil
import subprocess
import sys
import types
from pathlib import Path

import bpy
import numpy as np
import other_blender
import pytest
from conftest import (
    add_horizon,
    add_ocean,
    attribute,
    camera,
    evaluated_mesh,
    failing,
    in_another_blender,
    keyed,
    needs_window,
    opened,
    pixels,
    plane,
    positions,
    presets_with,
    read_exr,
    rendered,
    save,
    shot_of,
    start_another_blender,
    times,
)
from libocean_addon.bake import bake_plan, bake_record, bake_state, exr_files, farm
from libocean_addon.sea import node_group, open_sea
from libocean_addon.shared import modifier_groups
from subjects import same

FIELDS = ("displacement", "cover", "velocity", "normal", "jacobian")


@pytest.fixture
def sea(scene, tmp_path):
    """A small sea in a saved file, its shot of four frames. Its foam has no past, which takes
    time."""
    foam = {"foam_coverage": "threshold", "foam_threshold": 0.9}
    ob = add_ocean(64, sea=foam, kind="PATCH", preset="beaufort_6", use_material=False)
    shot_of(scene, ob)
    scene.frame_start, scene.frame_end = 2, 5
    save(tmp_path / "shot.blend")
    return ob


@pytest.fixture
def folder(tmp_path):
    return tmp_path / "ocean_bake" / "Ocean"


def shown(ob) -> dict[str, np.ndarray]:
    """All that the node group gives a mesh."""
    names = ("foam", "cover", "label", "velocity", "ocean_velocity", "ocean_normal", "jacobian")
    return {"position": positions(ob), **{name: attribute(ob, name) for name in names}}


def assert_close(ones, others, tolerance: float) -> None:
    for name, values in ones.items():
        assert np.allclose(values, others[name], atol=tolerance), name


def fields_in(folder: Path) -> set[str]:
    return {path.name.split(".")[1] for path in folder.iterdir()}


def said(ob) -> list[str]:
    """Returns what the panel says of a bake."""
    return [text for text, _ in bake_state.state(ob, bpy.context.scene)]


# Files ------------------------------------------------------------------------


def test_numbers_are_written_as_the_program_writes_them():
    from libocean_addon.volumes.volume_job import shortest

    written = "0 690 1e+05 12.5 0.041666666666666664 1e-04 0.001 -0.5 1.5e-07 -1e+05"
    assert " ".join(shortest(float(text)) for text in written.split()) == written


def test_unused_fields_are_not_baked_and_the_object_keeps_the_sea_of_its_files(sea, folder):
    bpy.context.scene.frame_set(4)
    assert attribute(sea, "foam").max() > 0.1 and attribute(sea, "cover").max() > 0.001
    assert np.ptp(attribute(sea, "jacobian")) > 0.5
    sea.libocean.use_foam = sea.libocean.use_velocity = False
    bpy.ops.libocean.bake(frame_start=3, frame_end=3)
    assert fields_in(folder) == {"displacement", "normal"}
    assert "foam" not in evaluated_mesh(sea).attributes
    header, _ = read_exr(folder / "shot.displacement.0003.exr")
    assert header["ocean:sea"] == str(sea.libocean.bake.sea.encode())


def test_a_write_that_fails_leaves_nothing(sea, folder, monkeypatch):
    """A disk that fills up: the package ends a file early and says nothing."""
    package = exr_files.load_package()
    output_file = package.OutputFile

    class CutOff:
        def __init__(self, path, header):
            self.path, self.image = Path(path), output_file(path, header)

        def writePixels(self, *rows):  # noqa: N802
            self.image.writePixels(*rows)

        def close(self):
            self.image.close()
            self.path.write_bytes(self.path.read_bytes()[:-100])

    monkeypatch.setattr(package, "OutputFile", CutOff)
    assert "is the disk full?" in failing(bpy.ops.libocean.bake)
    assert list(folder.iterdir()) == []
    assert not sea.libocean.use_bake


# Playing ----------------------------------------------------------------------


def test_between_frames_it_lies_between(scene, sea):
    bpy.ops.libocean.bake()
    found = []
    for frame, subframe in ((3, 0.0), (4, 0.0), (3, 0.25)):
        scene.frame_set(frame, subframe=subframe)
        found.append(shown(sea))
    before, after, between = found
    del between["foam"]  # made of cover, which lies between
    expected = {name: 0.75 * before[name] + 0.25 * after[name] for name in between}
    assert_close(between, expected, 2e-5)


def test_a_mesh_of_its_own_plays_it_too(scene, tmp_path):
    save(tmp_path / "shot.blend")
    ob = plane(40.0, 20)
    with presets_with(resolution=64):
        bpy.ops.libocean.add_modifier()
    ob.location = (-1234.5, 77.0, 3.0)
    scene.frame_set(3)
    live = shown(ob)
    bpy.ops.libocean.bake(frame_start=3, frame_end=3)
    assert_close(shown(ob), live, 1e-5)
    # Anchored to the world as a live one is, which moves with the object.
    ob.location.x += 10.0
    bpy.context.view_layer.update()
    moved = shown(ob)
    assert not np.allclose(moved["position"], live["position"], atol=1e-2)
    ob.libocean.use_bake = False
    bpy.context.view_layer.update()
    assert_close(shown(ob), moved, 1e-5)


@pytest.mark.slow
def test_a_horizon_plays_around_the_camera(scene, folder, tmp_path):
    keyed(camera(scene), location={2: (0.0, 0.0, 0.0), 5: (777.0, 0.0, 0.0)})
    ob = add_horizon(64, 20000, preset="beaufort_8")
    scene.frame_start, scene.frame_end = 2, 5
    save(tmp_path / "shot.blend")

    def now(frame: int) -> dict[str, np.ndarray]:
        scene.frame_set(frame)
        return {**shown(ob), "slope_variance": attribute(ob, "slope_variance")}

    live = {frame: now(frame) for frame in (2, 4, 5)}
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    assert fields_in(folder) == {*FIELDS, *(f"{field}_far" for field in FIELDS)}
    for frame, values in live.items():
        for name, baked in now(frame).items():
            assert np.allclose(baked, values[name], atol=2e-6, rtol=1e-6), name
    header, planes = read_exr(folder / "shot.normal_far.0004.exr")
    assert set(planes) == set("RGBA")
    assert eval(header["ocean:field"]) == b"normal_far"
    bpy.ops.libocean.bake()  # all of them are there
    assert bpy.ops.libocean.free_bake() == {"FINISHED"}
    assert same(now(4), live[4])


def test_nothing_is_asked_of_the_library_while_it_plays(scene, sea, monkeypatch):
    sea.libocean.use_detail = True
    bpy.ops.libocean.add_material()
    bpy.ops.libocean.bake()
    monkeypatch.setattr(open_sea.OpenSea, "follow", lambda *_: pytest.fail("the sea was asked"))
    scene.frame_set(4)
    sea.libocean.choppiness = 0.25
    assert sea.libocean.use_bake


def remap_time(sea) -> None:
    bpy.context.scene.render.frame_map_old, bpy.context.scene.render.frame_map_new = 100, 150


def give_time(sea) -> None:
    sea.libocean.use_custom_time = True
    keyed(sea.libocean, custom_time={2: 7.0, 5: 3.0})


@pytest.mark.parametrize("change", [remap_time, give_time])
def test_own_and_remapped_time_is_baked_as_shown(scene, sea, change):
    change(sea)
    live = []
    for frame in (2, 4):
        scene.frame_set(frame)
        live.append(shown(sea))
    bpy.ops.libocean.bake()
    for frame, values in zip((2, 4), live, strict=True):
        scene.frame_set(frame)
        assert same(shown(sea), values)


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
    assert_close(live, baked, 1e-4)


def made_by_an_earlier_version(ob, folder: Path) -> None:
    """Its bake has neither a Jacobian nor detail, in files, record and node group."""
    record = ob.libocean.bake
    later = [name for name in record.fields.split(",") if name.startswith(("jacobian", "detail"))]
    for field in later:
        for path in folder.glob(f"shot.{field}.*.exr"):
            path.unlink()
    fields = [name for name in record.fields.split(",") if name not in later]
    record.fields, record.bands = ",".join(fields), ""
    (modifier,) = node_group.modifiers(ob)
    group = modifier.node_group
    group.name, group[node_group.MARK] = ".libocean.v5 of before", 5
    modifier_groups.assign(modifier, {"Jacobian": None, "Use Jacobian": False})


def test_a_bake_of_an_earlier_version_plays(scene, sea, folder, tmp_path):
    scene.frame_set(4)
    sea.libocean.use_detail = True
    bpy.ops.libocean.add_material()
    bpy.ops.libocean.bake()
    there = shown(sea)
    made_by_an_earlier_version(sea, folder)
    bpy.ops.wm.save_mainfile()
    ob = opened(tmp_path / "shot.blend", "Ocean", 4)
    (modifier,) = node_group.modifiers(ob)
    assert modifier.node_group[node_group.MARK] == node_group.VERSION
    assert ob.libocean.use_bake and ob.libocean.problem == ""
    found = shown(ob)
    assert (found["jacobian"] == 1.0).all() and np.ptp(there["jacobian"]) > 0.5
    assert same({**found, "jacobian": there["jacobian"]}, there)
    assert "Not in the bake: jacobian, detail" in said(ob)
    kept = times(folder)
    bpy.ops.libocean.bake()  # adds it
    after = times(folder)
    assert {name: after[name] for name in kept} == kept
    added = {name.split(".")[1] for name in set(after) - set(kept)}
    assert added == {"jacobian", "detail1", "detail2", "detail3"}
    assert same(shown(ob), there)
    assert not any("Not in the bake" in text for text in said(ob))


@pytest.mark.parametrize("kind", ["PATCH", pytest.param("HORIZON", marks=pytest.mark.slow)])
def test_sizes_are_told(scene, sea, kind):
    """The panel expects the samples of at most three bands, and counts the present files."""
    if kind == "HORIZON":
        bpy.data.objects.remove(sea)
        sea = add_horizon(64, 20000, preset="beaufort_6")
    sea.libocean.use_detail = True
    bpy.ops.libocean.bake(frame_start=2, frame_end=2)
    folder = bake_record.place_of(sea).path
    one = {path.name.split(".")[1]: read_exr(path)[1] for path in folder.glob("*.0002.exr")}
    assert sum(field.startswith("detail") for field in one) == 3
    samples = sum(plane.size for planes in one.values() for plane in planes.values())
    assert bake_plan.size_estimate(sea, (64, 64), 5) == 5 * 4 * samples
    size = sum(path.stat().st_size for path in folder.iterdir())
    assert f"3 of 3 frames, {size / 1e6:.1f} MB" in said(sea)


# Other files, other folders, other names ----------------------------------------


def test_saved_elsewhere_it_still_knows_its_files(scene, sea, tmp_path):
    scene.frame_set(4)
    live = shown(sea)
    bpy.ops.libocean.bake()
    save(tmp_path / "version_2" / "shot.blend")
    sea.libocean.follow_world = False
    sea.libocean.use_bake = False
    sea.libocean.use_bake = True
    assert sea.libocean.problem == ""
    assert same(shown(sea), live)


def test_baked_into_another_folder_it_plays_that(scene, sea, folder, tmp_path):
    bpy.ops.libocean.bake()
    shutil.rmtree(folder)
    sea.libocean.choppiness = 0.5
    sea.libocean.bake.directory = "//second"
    bpy.ops.libocean.bake()
    assert bake_record.place_of(sea).path == tmp_path / "second"
    scene.frame_set(4)
    playing = shown(sea)
    sea.libocean.use_bake = False
    assert same(shown(sea), playing)


def test_an_object_with_another_name_keeps_its_bake(sea, folder):
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    before, written = bake_record.place_of(sea), times(folder)
    recipes = json.loads(sea.libocean.bake.recipes)
    sea.name = "Atlantic"
    assert bake_record.place_of(sea) == bake_record.next_place(sea, recipes) == before
    assert bpy.ops.libocean.bake() == {"FINISHED"}  # goes on, there
    assert times(folder) == written and len(list(folder.parent.iterdir())) == 1
    assert sea.libocean.use_bake
    assert sea.libocean.problem == ""
    twin = sea.copy()  # a bake of its own
    bpy.context.collection.objects.link(twin)
    assert bake_record.next_place(twin, recipes) != before


def test_an_object_that_is_renamed_meanwhile_gets_its_bake(sea, tmp_path):
    there = str(tmp_path / "there")
    started = bake_plan.Bake(bpy.context, sea, there, (2, 3), overwrite=False)
    sea.name = "Atlantic"
    started.job.run()
    assert started.is_of(sea)
    started.finish()
    assert sea.libocean.use_bake
    assert said(sea)


# Why not ------------------------------------------------------------------------


def test_without_files_the_switch_stays_off_or_the_panel_says_so(sea, folder):
    sea.libocean.use_bake = True
    assert not sea.libocean.use_bake
    bpy.ops.libocean.bake()
    sea.libocean.use_bake = False
    shutil.rmtree(folder)
    sea.libocean.use_bake = True
    assert "files of the bake" in sea.libocean.problem


def animate_tiles(sea) -> None:
    sea.libocean.use_detail = True
    keyed(sea.libocean, longest_wavelength={2: 1.0, 5: 0.5})


def contradict(sea) -> None:
    sea.libocean.shortest_wavelength, sea.libocean.longest_wavelength = 50.0, 10.0


def block_the_folder(sea) -> None:
    sea.libocean.bake.directory = "//file/bake"
    Path(bpy.path.abspath("//file")).write_text("")


REFUSED = {
    "a bake has one of each": lambda sea: keyed(sea.libocean, patch_size={2: 100.0, 5: 200.0}),
    "The limits of the wavelength are animated": animate_tiles,
    "Longest wavelength = 10 m: must be more": contradict,
    "cannot be made": block_the_folder,
}


@pytest.mark.parametrize("words", REFUSED)
def test_what_cannot_be_baked_is_told(sea, folder, words):
    REFUSED[words](sea)
    assert words in failing(bpy.ops.libocean.bake)
    assert not sea.libocean.use_bake and folder.exists() == sea.libocean.use_detail
    if sea.libocean.use_detail:
        sea.libocean.use_detail = False
        assert bpy.ops.libocean.bake() == {"FINISHED"}


def test_an_unsaved_file_has_no_folder_for_it():
    add_ocean(32, kind="PATCH", preset="beaufort_6")
    assert "Save the blend file first" in failing(bpy.ops.libocean.bake)


def test_a_bake_of_another_object_is_not_overwritten(sea, folder):
    bpy.ops.libocean.bake()
    bpy.ops.object.duplicate()
    bpy.context.object.libocean.seed = 7
    assert "choose another folder" in failing(bpy.ops.libocean.bake, directory=str(folder))


def test_a_package_that_is_missing_or_not_our_own_is_told(sea, folder, tmp_path, monkeypatch):
    other = types.ModuleType("OpenEXR")
    other.__file__ = str(tmp_path / "OpenEXR.so")
    for found, reason in ((None, "import of OpenEXR halted"), (other, "is not that of the add-on")):
        monkeypatch.setitem(sys.modules, "OpenEXR", found)
        text = failing(bpy.ops.libocean.bake)
        assert "takes the Python package OpenEXR" in text and reason in text
        assert not folder.exists()


@needs_window
def test_escape_stops_it_in_the_interface(tmp_path):
    in_another_blender(other_blender.stop_a_bake_by_escape, tmp_path)


# A farm -----------------------------------------------------------------------


def test_a_farm_renders_it_without_the_add_on(scene, sea, tmp_path):
    live = {}
    for frame in range(2, 6):
        scene.frame_set(frame)
        live[frame] = rendered(scene, tmp_path / f"live_{frame}.exr")
    assert not np.array_equal(live[2], live[3])
    bpy.ops.libocean.bake()
    bpy.ops.wm.save_mainfile()
    render = (other_blender.render, tmp_path / "shot.blend", "//out/f_####", "")
    for node in [start_another_blender(*render) for _ in range(2)]:
        out, _ = node.communicate(timeout=300)
        assert node.returncode == 0, out
    for frame, expected in live.items():
        assert np.array_equal(pixels(tmp_path / "out" / f"f_{frame:04}.exr"), expected)


def test_a_job_bakes_checks_and_renders_without_the_add_on(scene, sea, tmp_path, monkeypatch):
    sea.libocean.use_detail = True
    live = {}
    for frame in (2, 5):
        scene.frame_set(frame)
        live[frame] = rendered(scene, tmp_path / f"live_{frame}.exr")
    before = shown(sea)
    monkeypatch.setattr(farm.PlannedBake, "frames_per_task", lambda *_: 3)
    assert bpy.ops.libocean.bake_on_farm() == {"FINISHED"}
    assert not sea.libocean.use_bake and sea.libocean.bake.fields == ""
    assert same(shown(sea), before)
    job = tmp_path / "ocean_farm" / "Ocean"
    program = str(Path(os.environ["OCEAN"]).resolve())
    for step, tasks in (("bake", 2), ("check", 1)):
        for task in range(1, tasks + 1):
            node = {**os.environ, "OCEAN": program, "SLURM_ARRAY_TASK_ID": str(task)}
            done = subprocess.run(
                ["sh", f"{step}.sbatch"], cwd=job, env=node, capture_output=True, text=True
            )
            assert done.returncode == 0, done.stderr
    assert "--array=1-2" in (job / "bake.sbatch").read_text()
    assert "-b shot.blend -f" in (job / "render.sbatch").read_text()
    moved = tmp_path / "node" / "job"  # it needs nothing beside its folder
    shutil.move(job, moved)
    in_another_blender(other_blender.render, moved / "shot.blend", f"{moved}/f_####.exr", "", 2, 5)
    for frame, expected in live.items():
        assert np.array_equal(pixels(moved / f"f_{frame:04}.exr"), expected)
    with_add_on = opened(moved / "shot.blend", "Ocean")
    assert bake_record.faults(with_add_on) == {}


def test_what_a_farm_cannot_bake_is_told(sea, folder):
    keyed(sea.libocean, choppiness={2: 1.0, 5: 0.5})
    assert "a farm bakes one sea" in failing(bpy.ops.libocean.bake_on_farm)
    assert "the blend file itself" in failing(bpy.ops.libocean.bake_on_farm, directory="//")
    add_horizon(64, 5000, use_material=False)
    assert "bake horizons and coasts here" in failing(bpy.ops.libocean.bake_on_farm)
    bpy.ops.wm.read_homefile(use_empty=True)
    add_ocean(32, kind="PATCH", preset="beaufort_6", use_material=False)
    assert "Save the blend file first" in failing(bpy.ops.libocean.bake_on_farm)
