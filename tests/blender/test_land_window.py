# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A land around an animated camera in renders of a real window, which run in a thread of their own:
each frame has its own mesh, which the main thread makes while the render waits."""

import numpy as np
from conftest import pixels
from in_window import needs_window, run_steps
from test_land import CARVED

FRAMES = 4

STEPS = """
from pathlib import Path

from libocean_addon.shared import drafts

folder, frames = Path(arguments[0]), int(arguments[1])
scene = bpy.context.scene
ended = []
bpy.app.handlers.render_complete.append(lambda *_: ended.append("complete"))
bpy.app.handlers.render_cancel.append(lambda *_: ended.append("cancel"))


def add():
    with bpy.context.temp_override(window=window):
        bpy.ops.libocean.add_terrain_file(filepath=str(folder / "land.toml"), use_material=False)
    ob = bpy.data.objects["Terrain"]
    made = bpy.data.materials.new("Places")
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    light, place = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeNewGeometry")
    links.new(place.outputs["Position"], light.inputs["Color"])
    output = next(node for node in nodes if node.type == "OUTPUT_MATERIAL")
    links.new(light.outputs[0], output.inputs["Surface"])
    ob.data.materials.clear()
    ob.data.materials.append(made)
    camera = scene.camera
    camera.rotation_euler = (0.0, 0.0, 0.0)
    camera.data.type, camera.data.ortho_scale = "ORTHO", 500.0
    camera.data.clip_end = 1e5
    for frame in range(1, frames + 1):
        camera.location = (256.0 * frame, 960.0, 320.0)
        camera.keyframe_insert("location", frame=frame)
    scene.frame_set(1)
    ob.libocean_terrain.lod_spacing = 2.0
    ob.libocean_terrain.use_lod = True
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising = 1, False
    scene.render.resolution_x = scene.render.resolution_y = 48
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.frame_start, scene.frame_end = 1, frames


def rest():
    if drafts.is_draft("Terrain"):
        steps.insert(0, rest)
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


def animate_anew():
    render("window_anew_", animation=True)
    return 0.05


def still_frames():
    for frame in range(1, frames + 1):
        still(f"{frame:04d}", frame)


def press():
    carve(2)
    render("window_pressed.exr", write_still=True)


def still_pressed():
    still("pressed", scene.frame_current)


def carve(seed):
    bpy.data.objects["Terrain"].libocean_terrain.stream_seed = seed
    assert drafts.is_draft("Terrain")


def change():
    assert not ended  # the render is at work
    carve(3)


def still_changed():
    still(f"anew_{frames:04d}", frames)


steps = [add, rest, animate, render_rests, still_frames, press, render_rests, still_pressed]
steps += [animate_anew, change, render_rests, still_changed]
"""


@needs_window
def test_each_frame_of_a_render_in_a_window_has_its_own_mesh(tmp_path):
    """Frames of an animation, a frame whose render begins while the land is a draft, and the last
    frame of an animation during which the land changes are those of renders that wait for all."""
    (tmp_path / "land.toml").write_text(CARVED)
    said = run_steps(tmp_path, STEPS, tmp_path, FRAMES, size=(640, 480))
    assert "a draft" not in said, said
    numbers = [f"{frame:04d}" for frame in range(1, FRAMES + 1)]
    for name in (*numbers, "pressed", f"anew_{numbers[-1]}"):
        seen, wanted = (pixels(tmp_path / f"{kind}_{name}.exr") for kind in ("window", "still"))
        assert np.ptp(wanted[..., 2]) > 1.0
        assert np.array_equal(seen, wanted), name
