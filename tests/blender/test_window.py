# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders in a real window, which run in a thread of their own: each frame has its own surface,
which is made while the render waits."""

import numpy as np
import pytest
from conftest import pixels
from in_window import needs_window, run_steps
from test_coast import CELL, SEA, write_bed
from test_land import CARVED

STEPS = """
from pathlib import Path

from libocean_addon.shared import drafts

folder, name, last = Path(arguments[0]), arguments[1], int(arguments[2])
scene, camera = bpy.context.scene, bpy.context.scene.camera
ended = []
bpy.app.handlers.render_complete.append(lambda *_: ended.append("complete"))
bpy.app.handlers.render_cancel.append(lambda *_: ended.append("cancel"))


def add():
    camera.rotation_euler, camera.data.type = (0.0, 0.0, 0.0), "ORTHO"
    camera.data.clip_end = 1e5
    with bpy.context.temp_override(window=window):
        ob = add_object()
    assert drafts.is_draft(name)
    made = bpy.data.materials.new("Places")
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    light, place = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeNewGeometry")
    links.new(place.outputs["Position"], light.inputs["Color"])
    output = next(node for node in nodes if node.type == "OUTPUT_MATERIAL")
    links.new(light.outputs[0], output.inputs["Surface"])
    ob.data.materials.clear()
    ob.data.materials.append(made)
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising = 1, False
    scene.render.resolution_x = scene.render.resolution_y = 48
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.frame_start, scene.frame_end = 1, last
    bpy.data.objects["Cube"].hide_render = True


def rest():
    if drafts.is_draft(name):
        steps.insert(0, rest)


def render(picture, **options):
    ended.clear()
    scene.render.filepath = str(folder / picture)
    with bpy.context.temp_override(window=window):
        assert bpy.ops.render.render("INVOKE_DEFAULT", **options) == {"RUNNING_MODAL"}


def render_rests():
    if not ended:
        steps.insert(0, render_rests)
        return 0.1
    assert ended == ["complete"]


def still(picture, frame):
    scene.frame_set(frame)
    drafts.complete()
    scene.render.filepath = str(folder / f"still_{picture}.exr")
    bpy.ops.render.render(write_still=True)


def animate():
    render("window_", animation=True)


def still_frames():
    for frame in range(1, last + 1):
        still(f"{frame:04d}", frame)


def press():
    change(2)
    assert drafts.is_draft(name)
    render("window_pressed.exr", write_still=True)


def still_pressed():
    still("pressed", scene.frame_current)


def animate_anew():
    render("window_anew_", animation=True)
    return 0.05


def change_meanwhile():
    assert not ended  # the render is at work
    change(3)
    assert drafts.is_draft(name)


def still_changed():
    still(f"anew_{last:04d}", last)


steps = [add, rest, animate, render_rests, still_frames, press, render_rests, still_pressed]
"""

COAST = """
def add_object():
    bpy.ops.libocean.add_coast(filepath=str(folder / "sea.toml"), cell=CELL, use_material=False)
    land = bpy.data.objects["Land"]
    land.hide_render = True
    assert len(land.data.vertices) == 0  # nobody waited for the bed
    camera.location, camera.data.ortho_scale = (90.0, 80.0, 60.0), 150.0
    return bpy.data.objects[name]


def change(number):
    bpy.data.objects[name].libocean.waves[0].wind_speed = 4.0 + number


def bed_is_there():
    assert len(bpy.data.objects["Land"].data.vertices) > 0


steps.insert(2, bed_is_there)
""".replace("CELL", str(CELL))

LAND = """
def add_object():
    bpy.ops.libocean.add_terrain_file(filepath=str(folder / "land.toml"), use_material=False)
    camera.data.ortho_scale = 500.0
    for frame in range(1, last + 1):
        camera.location = (256.0 * frame, 960.0, 320.0)
        camera.keyframe_insert("location", frame=frame)
    scene.frame_set(1)
    ob = bpy.data.objects[name]
    ob.libocean_terrain.lod_spacing = 2.0
    ob.libocean_terrain.use_lod = True
    return ob


def change(number):
    bpy.data.objects[name].libocean_terrain.stream_seed = number


steps += [animate_anew, change_meanwhile, render_rests, still_changed]
"""


@needs_window
@pytest.mark.parametrize(
    ("program", "name", "last"), [(COAST, "Water", 3), (LAND, "Terrain", 4)], ids=["coast", "land"]
)
def test_renders_in_a_window_have_the_surface_of_their_frame(tmp_path, program, name, last):
    """Frames of an animation, a frame whose render begins while a draft is shown, and the last
    frame of an animation during which the land changes are those of renders that wait for all."""
    write_bed(tmp_path)
    (tmp_path / "sea.toml").write_text(SEA)
    (tmp_path / "land.toml").write_text(CARVED)
    said = run_steps(tmp_path, STEPS + program, tmp_path, name, last, size=(640, 480))
    assert "a draft" not in said, said
    stills = {path.stem.removeprefix("still_"): pixels(path) for path in tmp_path.glob("still_*")}
    assert len(stills) == last + (1 if program is COAST else 2)
    for picture, wanted in stills.items():
        assert np.ptp(wanted[..., 2]) > (0.5 if program is COAST else 1.0)
        assert np.array_equal(pixels(tmp_path / f"window_{picture}.exr"), wanted), picture
    assert not np.array_equal(stills["0001"], stills["0002"])
    assert not np.array_equal(stills[f"{last:04d}"], stills["pressed"])
