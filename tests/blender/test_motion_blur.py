# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Motion blur is as long as the way of the water while the shutter is open."""

import bpy
import numpy as np
import pytest
from conftest import camera, light, picture_settings, rendered
from libocean_addon.bundled import libocean

SEA = """
libocean = 1
[grid]
resolution = 64
patch_size = 100.0
[[waves]]
spectrum = "jonswap"
wind_speed = 20.0
significant_wave_height = 5.0
peak_period = 6.0
"""
CELL = 100.0 / 64
SHUTTER = 0.5  # frames
VIEW, WIDE = 0.3, 300  # metres, pixels a side
SIDE = 0.02  # of the square that is carried


@pytest.fixture
def sea(tmp_path):
    path = tmp_path / "sea.toml"
    path.write_text(SEA)
    with libocean.open(path) as opened:
        yield opened


def place(sea, frame: float) -> np.ndarray:
    """Where the middle between the first two samples is: linear between them, as the mesh is."""
    middle = np.array([CELL / 2, 0.0, 0.0])
    return middle + sea.surface((frame - 1) / 24).displacement[0, :2].astype(np.float64).mean(
        axis=0
    )


def carried_square(path):
    """A small square that faces -y, between two samples; light comes from nothing else."""
    corner = SIDE / 2
    mesh = bpy.data.meshes.new("Square")
    corners = [(-corner, 0, -corner), (corner, 0, -corner), (corner, 0, corner)]
    mesh.from_pydata([*corners, (-corner, 0, corner)], [], [(0, 1, 2, 3)])
    ob = bpy.data.objects.new("Square", mesh)
    bpy.context.collection.objects.link(ob)
    ob.location.x = CELL / 2
    bpy.context.view_layer.objects.active = ob
    bpy.ops.libocean.add_modifier()
    bpy.ops.libocean.load_sea(filepath=str(path))
    mesh.materials.append(light())
    return ob


def look_at(scene, point: np.ndarray) -> None:
    eye = camera(scene, (point[0], point[1] - 5.0, point[2]), width=VIEW)
    eye.rotation_euler.x = np.pi / 2
    picture_settings(scene, WIDE, 64)
    scene.cycles.pixel_filter_type = "BOX"
    scene.render.motion_blur_shutter = SHUTTER


def moments(scene, path, *, blur: bool) -> tuple[np.ndarray, np.ndarray]:
    """Centre and covariance of the light in the picture, metres."""
    scene.render.use_motion_blur = blur
    light = rendered(scene, path)[..., 0].astype(np.float64)
    light /= light.sum()
    along = (np.arange(WIDE) + 0.5 - WIDE / 2) * (VIEW / WIDE)
    centre = np.array([light.sum(axis=0) @ along, light.sum(axis=1) @ along])
    x, z = along - centre[0], along - centre[1]
    cross = z @ light @ x
    return centre, np.array([[light.sum(axis=0) @ x**2, cross], [cross, light.sum(axis=1) @ z**2]])


def test_a_moving_crest_is_blurred_along_its_way(scene, sea, tmp_path):
    frames = range(1, 241)
    speeds = [np.linalg.norm((place(sea, f + 0.25) - place(sea, f - 0.25))[[0, 2]]) for f in frames]
    frame = frames[int(np.argmax(speeds))]
    way = (place(sea, frame + SHUTTER / 2) - place(sea, frame - SHUTTER / 2))[[0, 2]]
    assert np.linalg.norm(way) > 2 * SIDE
    carried_square(tmp_path / "sea.toml")
    scene.frame_set(frame)
    look_at(scene, place(sea, frame))
    _, still = moments(scene, tmp_path / "still.exr", blur=False)
    centre, blurred = moments(scene, tmp_path / "blurred.exr", blur=True)
    # A point that moves by a way w at an even speed adds w w' / 12 to the covariance.
    added = 12 * (blurred - still)
    length = np.sqrt(np.trace(added))
    print(f"\nthe way {np.linalg.norm(way):.4f} m, the blur {length:.4f} m")
    assert length == pytest.approx(np.linalg.norm(way), rel=0.02)
    # Two per cent of a length are four of its square.
    assert added == pytest.approx(np.outer(way, way), abs=0.04 * way @ way)
    assert np.abs(centre).max() < 0.02 * np.linalg.norm(way)
