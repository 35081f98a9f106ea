# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures: another process renders a file as this one does; each frame shows its own time."""

import threading
import types

import bpy
import numpy as np
import other_blender
from conftest import (
    assert_shown_without_the_add_on,
    in_another_blender,
    pixels,
    plane,
    rendered,
    rest,
    save,
)
from libocean_addon import handlers


def test_a_second_process_renders_the_same_picture(scene, shot, tmp_path):
    shot.libocean.render_resolution = 32
    scene.frame_set(17)
    here = rendered(scene, tmp_path / "here.exr")
    heights = here[..., 2]
    assert np.ptp(heights) > 0.5  # metres
    path, there = save(tmp_path / "shot.blend"), tmp_path / "there.exr"
    in_another_blender(other_blender.render, path, there, "addon", 17)
    assert np.array_equal(pixels(there), here)


def test_the_render_resolution_is_what_is_rendered(scene, shot, tmp_path):
    scene.frame_set(17)
    fine = rendered(scene, tmp_path / "fine.exr")[..., 2]
    shot.libocean.viewport_resolution = 32
    again = rendered(scene, tmp_path / "again.exr")[..., 2]
    assert np.array_equal(again, fine)
    shot.libocean.render_resolution = 32
    coarse = rendered(scene, tmp_path / "coarse.exr")[..., 2]
    assert not np.array_equal(coarse, fine)


def test_persistent_data_shows_every_frame_its_own_time(scene, shot, tmp_path):
    scene.render.use_persistent_data = True
    scene.frame_start, scene.frame_end = 1, 3
    scene.render.filepath = str(tmp_path / "frame_####.exr")
    bpy.ops.render.render(animation=True)
    scene.render.use_persistent_data = False
    frames = [pixels(tmp_path / f"frame_{frame:04}.exr") for frame in (1, 2, 3)]
    assert not np.array_equal(frames[0], frames[2])
    for frame in (1, 2, 3):
        scene.frame_set(frame)
        still = rendered(scene, tmp_path / f"still_{frame}.exr")
        assert np.array_equal(frames[frame - 1], still)


def test_the_locked_interface_is_given_back(scene, shot, tmp_path):
    locked = []
    look = bpy.app.handlers.render_pre
    look.append(lambda at, *_: locked.append(at.render.use_lock_interface))
    try:
        rendered(scene, tmp_path / "locked.exr")
    finally:
        look.pop()
    assert locked == [True]
    assert not scene.render.use_lock_interface


def test_the_interface_is_locked_when_the_window_has_been_drawn():
    """Renders of a window run in a thread, where Blender refuses to write while its main thread
    draws."""

    class Render:
        refusals = 3

        def __setattr__(self, name, value):
            if self.refusals > 0:
                Render.refusals -= 1
                raise AttributeError("Writing to ID classes in this context is not allowed")
            super().__setattr__(name, value)

    scene = types.SimpleNamespace(render=Render())
    thread = threading.Thread(target=handlers._set_lock, args=(scene, True))
    thread.start()
    thread.join()
    assert scene.render.use_lock_interface


def test_without_the_add_on_the_sea_is_at_rest(scene, shot, tmp_path):
    scene.frame_set(17)
    normal = np.zeros_like(rest(shot)) + np.float32((0.0, 0.0, 1.0))
    wanted = {"position": rest(shot), "velocity": 0.0 * normal, "ocean_normal": normal}
    wanted["foam"] = np.zeros(len(normal))
    assert_shown_without_the_add_on(
        save(tmp_path / "shot.blend"), {("Ocean", name, 17): at for name, at in wanted.items()}
    )


def test_objects_of_all_kinds_are_found_among_many(scene, shot):
    from libocean_addon.sea import live

    other = plane(10.0, 3)
    bpy.ops.libocean.add_modifier()
    for number in range(200):
        bpy.context.collection.objects.link(bpy.data.objects.new(f"Empty {number}", None))
    assert set(live.ocean_objects()) == {shot, other}


def test_another_scene_is_rendered_at_its_own_time(scene, shot, tmp_path):
    """By its name and by the compositor. Blender renders both at the number of the frame of the
    window's scene, for keyframes too; the other scene's rate makes another time of it."""
    scene.render.fps = 24
    scene.frame_set(29)
    expected = rendered(scene, tmp_path / "expected.exr")
    scene.frame_set(15)
    here = rendered(scene, tmp_path / "here.exr")
    assert not np.allclose(here, expected, atol=0.1)
    bpy.ops.scene.new(type="LINK_COPY")
    other = bpy.context.scene
    other.render.fps = 12
    bpy.context.window.scene = scene
    other.render.filepath = str(tmp_path / "named.exr")
    bpy.ops.render.render(write_still=True, scene=other.name)
    assert other.frame_current == 15
    np.testing.assert_allclose(pixels(tmp_path / "named.exr"), expected, atol=2e-3)
    if bpy.app.version < (5, 0):
        scene.use_nodes = True
        nodes = scene.node_tree.nodes
        nodes.clear()
        layers = nodes.new("CompositorNodeRLayers")
        layers.scene = other
        composite = nodes.new("CompositorNodeComposite")
        scene.node_tree.links.new(layers.outputs["Image"], composite.inputs["Image"])
        composed = rendered(scene, tmp_path / "composed.exr")
        np.testing.assert_allclose(composed, expected, atol=2e-3)
