# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The first minute with the add-on: a draft at once and the whole sea behind it, a console that
says what is computed, a scene without the start-up cube, wrong input refused, and missing parts of
Debian's Blender named."""

import sys
import threading
import time
from types import SimpleNamespace

import bpy
import numpy as np
import other_blender
import pytest
from conftest import (
    add_horizon,
    add_ocean,
    factory_settings,
    finish,
    in_another_blender,
    positions,
    presets_with,
    push,
    save,
)
from libocean_addon import handlers
from libocean_addon.bundled import libocean
from libocean_addon.look import detail, start_up
from libocean_addon.sea import hints, horizon_mesh, open_sea
from libocean_addon.sea.resolutions import OF_SEA
from libocean_addon.sea.subject import SEA
from libocean_addon.shared import compat, console, drafts, life, meshes


def is_whole(ob) -> bool:
    sea = open_sea.sea_of(ob.name_full)
    return sea.ready is not None and sea.ready[0] == sea.changes


PAST = {"foam_lifetime": 0.5}  # short, but a draft leaves it out


@pytest.fixture
def small():
    """Makes any sea in no time."""
    with presets_with(resolution=64, **PAST):
        yield


# A draft at once, the whole sea behind it -------------------------------------------


def test_a_scene_begins_with_few_vertices_and_is_saved_with_fewer(waiting, small, tmp_path):
    assert bpy.ops.libocean.add_scene() == {"FINISHED"}
    ocean = bpy.context.object
    assert not is_whole(ocean) and drafts.is_draft(ocean.name_full)
    assert meshes.is_draft(ocean.data) and np.ptp(positions(ocean)[:, 2]) > 0.3
    assert len(ocean.data.vertices) <= horizon_mesh.DRAFT_VERTICES
    path = save(tmp_path / "sea.blend")
    assert not meshes.is_draft(ocean.data)  # a file never keeps that of a draft
    finish()
    assert is_whole(ocean) and not meshes.is_draft(ocean.data)
    assert not drafts.is_draft(ocean.name_full)
    assert path.stat().st_size < 8e6  # three are the textures of foam; all vertices are sixty
    assert len(ocean.data.vertices) > 4 * horizon_mesh.DRAFT_VERTICES


@pytest.mark.parametrize("add", ["add_coast", "add_terrain", "add_terrain_scene"])
def test_a_default_subject_is_a_small_file(waiting, add, tmp_path):
    """Three MB are the textures of foam; a whole mesh is 25."""
    assert getattr(bpy.ops.libocean, add)() == {"FINISHED"}
    path = save(tmp_path / "shot.blend")
    assert max(len(ob.data.vertices) for ob in bpy.data.objects if meshes.is_mesh(ob)) > 200_000
    assert path.stat().st_size < 10e6


def test_panels_are_drawn_again_where_the_progress_is_another_one(monkeypatch):
    said, drawn = ["1%"], []
    job = SimpleNamespace(is_alive=lambda: True, status_text=lambda _name: said[0])

    def draw() -> None:
        drawn.append(said[0])
        drafts._drawn = said[0]

    monkeypatch.setattr(drafts, "_running", ("Sea", job))
    monkeypatch.setattr(drafts, "_drawn", None)
    monkeypatch.setattr(drafts, "_drawn_at", -1e9)
    monkeypatch.setattr(drafts, "_redraw", draw)
    drafts.step()
    drafts.step()
    assert drawn == ["1%"]
    said[0] = "2%"
    monkeypatch.setattr(drafts, "_drawn_at", time.monotonic() + 1e9)
    drafts.step()
    assert drawn == ["1%"], "too soon"
    monkeypatch.setattr(drafts, "_drawn_at", -1e9)
    drafts.step()
    assert drawn == ["1%", "2%"]


def test_a_render_begins_with_the_whole_sea(scene, waiting):
    ocean = add_horizon(64, 150000, sea=PAST, use_material=False)
    drafts.stop(ocean.name_full)
    handlers.complete()
    assert is_whole(ocean) and not meshes.is_draft(ocean.data)


def test_a_render_in_a_thread_leaves_the_data_to_the_main_thread(waiting, capsys):
    ocean, made_by = add_horizon(64, 150000, sea=PAST, use_material=False), []
    follow = horizon_mesh.follow_horizon

    def noted(*arguments, **settings) -> None:
        made_by.append(threading.current_thread())
        follow(*arguments, **settings)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(horizon_mesh, "follow_horizon", noted)
        render = threading.Thread(target=handlers.complete)
        render.start()
        while render.is_alive():
            drafts.step()
            time.sleep(0.01)
    assert set(made_by) == {threading.main_thread()}
    assert is_whole(ocean) and not meshes.is_draft(ocean.data)
    assert "draft" not in capsys.readouterr().out


def test_a_frame_that_blender_shows_again_stays_a_draft(scene, waiting, small):
    """An edit of a driver has Blender show its frame once more, without any user."""
    ocean = add_ocean(64, sea=PAST, kind="PATCH", use_material=False)
    finish()
    ocean.libocean.choppiness = 0.7
    life.show_all([SEA.look_up(ocean)], scene, passing=True)
    assert not is_whole(ocean) and drafts.progress(ocean.name_full) is not None
    scene.frame_set(scene.frame_current + 30)
    assert is_whole(ocean)


# Without a window --------------------------------------------------------------------


def test_the_console_says_what_is_computed():
    assert console.line(1.0) == ""
    with console.work("Ocean", "maps"):
        assert console.line(3.14) == "libocean: Ocean: maps, 3.1 s"
        with console.work("Sea", lambda: "3 of 9 frames"):
            assert console.line(4.0) == "libocean: Sea: 3 of 9 frames, 4.0 s"
            console.tell(240, 500)
            assert console.line(5.0) == "libocean: Sea: foam, 240 of 500 ticks, 5.0 s"
        assert console.line(6.0) == "libocean: Ocean: maps, 6.0 s"
    assert console.line(7.0) == ""


def test_the_share_of_a_work_of_several_parts_never_falls():
    said = []
    with console.work("Water", "water"):
        for total in (91, 1000, 1000, 501):
            for done in (0, total // 2, total):
                console.tell_part(done, total)
                said.append(float(console.line(1.0).split(", ")[1].rstrip("%")))
    assert said == sorted(said) and said[0] == 0.0 and 90.0 < said[-1] < 100.0


def test_a_line_comes_after_each_interval(monkeypatch, capsys):
    monkeypatch.setattr(console, "INTERVAL", 0.1)
    with console.work("Ocean", "maps"):
        time.sleep(0.35)
    said = capsys.readouterr().out.splitlines()
    assert 2 <= len(said) <= 3 and all(
        line.startswith("libocean: Ocean: maps, 0.") for line in said
    )
    time.sleep(0.2)
    assert capsys.readouterr().out == ""


def test_with_a_window_the_console_is_silent(monkeypatch):
    monkeypatch.setattr(console, "bpy", SimpleNamespace(app=SimpleNamespace(background=False)))
    with console.work("Ocean", "maps"):
        assert console.line(3.0) == ""


def test_the_ticks_of_foam_are_told(monkeypatch, capsys):
    """The library reports them to the thread that waits."""
    monkeypatch.setattr(console, "INTERVAL", 0.004)
    add_ocean(256, kind="PATCH", use_material=False)
    assert "libocean: Ocean: foam, " in capsys.readouterr().out


def test_short_work_says_nothing(small, capsys):
    add_ocean(64, kind="PATCH", use_material=False)
    assert "libocean:" not in capsys.readouterr().out


# Ocean Scene ---------------------------------------------------------------------------


@pytest.fixture
def default_file():
    factory_settings()
    return bpy.context.scene


def names() -> set[str]:
    return {ob.name for ob in bpy.data.objects}


def test_the_start_up_objects_go_and_undo_brings_them_back(default_file, small, waiting):
    push()
    bpy.ops.libocean.add_scene("EXEC_DEFAULT", True)
    assert names() == {"Ocean", "Ocean Camera", "Ocean Sun"}
    assert "Cube" not in bpy.data.meshes and "Material" not in bpy.data.materials
    bpy.ops.ed.undo()
    assert names() == {"Camera", "Cube", "Light"}
    assert start_up.untouched(bpy.context.scene)


def _paint(cube) -> None:
    nodes = cube.data.materials[0].node_tree.nodes
    shader = next(node for node in nodes if node.type == "BSDF_PRINCIPLED")
    shader.inputs["Base Color"].default_value = (1.0, 0.0, 0.0, 1.0)


TOUCHES = (
    lambda cube: setattr(cube.location, "x", 1.0),
    lambda cube: cube.modifiers.new("Bevel", "BEVEL"),
    lambda cube: cube.keyframe_insert("location"),
    lambda cube: setattr(cube.data.vertices[0].co, "x", 3.0),
    lambda cube: cube.data.materials.clear(),
    _paint,
    lambda cube: cube.constraints.new("FLOOR"),
    lambda cube: setattr(cube, "hide_render", True),
    lambda cube: cube.__setitem__("mine", 1),
)


def of_start_up() -> list:
    return [bpy.data.objects[name] for name in ("Cube", "Light", "Camera")]


def test_a_touched_cube_stays(default_file):
    push()
    for number, touch in enumerate(TOUCHES):
        cube, lamp, camera = of_start_up()
        assert start_up.untouched(bpy.context.scene) == [cube, lamp, camera], number
        touch(cube)
        assert start_up.untouched(bpy.context.scene) == [lamp, camera], number
        push()
        bpy.ops.ed.undo()
    cube, lamp, camera = of_start_up()
    cube.location.x = 1.0
    lamp.data.energy = 10.0
    camera.data.lens = 35.0
    assert start_up.untouched(bpy.context.scene) == []


def test_a_lamp_with_nodes_of_its_own_stays(default_file):
    cube, lamp, camera = of_start_up()
    lamp.data.use_nodes = True  # from 5.2 on each lamp has nodes
    emission = next(node for node in lamp.data.node_tree.nodes if node.type == "EMISSION")
    assert start_up.untouched(default_file) == [cube, lamp, camera]
    emission.inputs["Strength"].default_value = 2.0
    assert start_up.untouched(default_file) == [cube, camera]


def test_nothing_goes_from_a_scene_with_other_objects(default_file):
    bpy.ops.object.empty_add()
    assert start_up.untouched(default_file) == []


def test_nothing_goes_if_that_is_switched_off(default_file, small, waiting):
    bpy.ops.libocean.add_scene(remove_start_up=False)
    assert {"Cube", "Light", "Camera"} <= names()


def test_near_detail_is_on(scene, small):
    bpy.ops.libocean.add_scene()
    ocean = bpy.context.object
    assert ocean.libocean.use_detail
    nodes = ocean.material_slots[0].material.node_tree.nodes
    assert any(detail.is_detail(node) for node in nodes)


# Wrong input ----------------------------------------------------------------------------


def test_a_script_gets_the_error_of_a_sea_file():
    ocean = add_ocean(64, kind="PATCH", use_material=False)
    for section, name in (("grid", "resolution"), ("surface", "foam_resolution")):
        before = getattr(ocean.libocean, name)
        for samples in (500, 16, 16384, -1):
            with pytest.raises(libocean.Error) as of_file:
                libocean.parse(libocean.text_of_values({f"{section}.{name}": str(samples)}))
            with pytest.raises(ValueError) as of_script:
                setattr(ocean.libocean, name, samples)
            assert str(of_file.value).endswith(str(of_script.value))
            assert getattr(ocean.libocean, name) == before and ocean.libocean.problem == ""
    for name in ("viewport_resolution", "render_resolution", "mesh_resolution"):
        words = f"^{name} = 500: is not a power of two; allowed: .*0 or"
        with pytest.raises(ValueError, match=words):
            setattr(ocean.libocean, name, 500)
        setattr(ocean.libocean, name, 0)


def test_every_number_of_a_list_may_be_set_and_no_other_one():
    ocean = add_ocean(64, kind="PATCH", use_material=False)
    for item in ocean.libocean.bl_rna.properties["mesh_resolution_list"].enum_items:
        OF_SEA.require_allowed("mesh_resolution", item.value)
    with pytest.raises(TypeError, match="500"):
        bpy.ops.libocean.add(mesh_resolution="500")


# Parts that Debian's Blender lacks --------------------------------------------------------


def test_without_numpy_one_sentence_names_the_package():
    said = in_another_blender(other_blender.enable_without_numpy)
    assert "rror" not in said, said
    assert said.count("install the package python3-numpy (Debian, Ubuntu)") == 1, said
    assert sys.prefix in said


def test_a_missing_denoiser_is_said_and_the_scene_renders(scene, small, waiting, monkeypatch):
    monkeypatch.setattr(compat, "has_denoiser", lambda: False)
    scene.render.engine = "CYCLES"
    scene.cycles.use_denoising = True
    bpy.ops.libocean.add_scene()
    ocean = bpy.context.object
    assert not scene.cycles.use_denoising
    assert "denoiser" not in " ".join(hints.of_object(ocean, ocean))
    scene.cycles.use_denoising = True
    assert "Debian's package blender" in " ".join(hints.of_object(ocean, ocean))


def test_a_denoiser_stays_in_use(scene, small, waiting, monkeypatch):
    monkeypatch.setattr(compat, "has_denoiser", lambda: True)
    scene.cycles.use_denoising = True
    bpy.ops.libocean.add_scene()
    assert scene.cycles.use_denoising
