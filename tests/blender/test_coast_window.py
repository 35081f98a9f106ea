# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A coast in a real window: its whole is made in the background, and renders, which run in a thread
of their own, have the water of each frame."""

import numpy as np
from conftest import pixels
from in_window import needs_window, run_steps
from test_coast import CELL, SEA, write_bed

FRAMES = 3

STEPS = """
from pathlib import Path

from libocean_addon.shared import drafts

folder, frames, cell = Path(arguments[0]), int(arguments[1]), float(arguments[2])
scene = bpy.context.scene
ended = []
bpy.app.handlers.render_complete.append(lambda *_: ended.append("complete"))
bpy.app.handlers.render_cancel.append(lambda *_: ended.append("cancel"))


def add():
    with bpy.context.temp_override(window=window):
        bpy.ops.libocean.add_coast(
            filepath=str(folder / "sea.toml"), cell=cell, use_material=False
        )
    ob = bpy.data.objects["Water"]
    assert drafts.is_draft("Water")
    assert len(bpy.data.objects["Land"].data.vertices) == 0  # nobody waited for the bed
    made = bpy.data.materials.new("Places")
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    light, place = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeNewGeometry")
    links.new(place.outputs["Position"], light.inputs["Color"])
    output = next(node for node in nodes if node.type == "OUTPUT_MATERIAL")
    links.new(light.outputs[0], output.inputs["Surface"])
    ob.data.materials.append(made)
    camera = scene.camera
    camera.location, camera.rotation_euler = (90.0, 80.0, 60.0), (0.0, 0.0, 0.0)
    camera.data.type, camera.data.ortho_scale = "ORTHO", 150.0
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising = 1, False
    scene.render.resolution_x = scene.render.resolution_y = 48
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.frame_start, scene.frame_end = 1, frames
    bpy.data.objects["Cube"].hide_render = True
    bpy.data.objects["Land"].hide_render = True


def rest():
    if drafts.is_draft("Water"):
        steps.insert(0, rest)
    else:
        assert len(bpy.data.objects["Land"].data.vertices) > 0
    return 0.5


def render(name, **options):
    ended.clear()
    scene.render.filepath = str(folder / name)
    with bpy.context.temp_override(window=window):
        assert bpy.ops.render.render("INVOKE_DEFAULT", **options) == {"RUNNING_MODAL"}


def render_rests():
    if not ended:
        steps.insert(0, render_rests)
        return 0.1
    assert ended == ["complete"]


def still(name, frame):
    scene.frame_set(frame)
    drafts.complete()
    scene.render.filepath = str(folder / f"still_{name}.exr")
    bpy.ops.render.render(write_still=True)


def animate():
    render("window_", animation=True)


def still_frames():
    for frame in range(1, frames + 1):
        still(f"{frame:04d}", frame)


def press():
    bpy.data.objects["Water"].libocean.waves[0].wind_speed = 6.0
    assert drafts.is_draft("Water")
    render("window_pressed.exr", write_still=True)


def still_pressed():
    still("pressed", scene.frame_current)


steps = [add, rest, animate, render_rests, still_frames, press, render_rests, still_pressed]
"""


@needs_window
def test_renders_in_a_window_have_the_water_of_their_frame(tmp_path):
    """Frames of an animation, and a frame whose render begins while the water is a draft, are those
    of renders that wait for all."""
    write_bed(tmp_path)
    (tmp_path / "sea.toml").write_text(SEA)
    said = run_steps(tmp_path, STEPS, tmp_path, FRAMES, CELL, size=(640, 480))
    assert "a draft" not in said, said
    wanted = {}
    for name in (*(f"{frame:04d}" for frame in range(1, FRAMES + 1)), "pressed"):
        seen, wanted[name] = (
            pixels(tmp_path / f"{kind}_{name}.exr") for kind in ("window", "still")
        )
        assert np.ptp(wanted[name][..., 2]) > 0.5
        assert np.array_equal(seen, wanted[name]), name
    assert not np.array_equal(wanted["0001"], wanted["0002"])
    assert not np.array_equal(wanted["0003"], wanted["pressed"])
