# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface from below: the same surface as from above, bent by the detail too, foam that lets
light through, and the sun's light that waves gather."""

import math
import os
import subprocess

import bpy
import numpy as np
import pytest
from conftest import add_ocean, pixels, plane, rendered, white
from libocean_addon.look import sun_focus, water_shader
from libocean_addon.shared import shader_builder
from libocean_addon.shared.native import libocean
from test_material import (
    FAR,
    IOR,
    foam_albedo,
    fresnel,
    light_all_round,
    look,
    put,
    seen,
    studio,  # noqa: F401 (for each test here too)
    water,
)


def without_volume(made) -> None:
    tree = made.node_tree
    for link in [link for link in tree.links if link.to_socket.name == "Volume"]:
        tree.links.remove(link)


SKY, DEEP = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)


@pytest.mark.parametrize("way", ["detail", "ocean_normal"])
@pytest.mark.parametrize(
    "degrees, lean", [(30.0, 20.0), (30.0, -20.0), (20.0, 20.0), (60.0, -20.0)]
)
def test_slopes_bend_it_from_below_as_from_above(scene, tmp_path, degrees, lean, way):
    """A slope upwards away from the viewer is met at as many degrees more from below as it is at
    fewer from above."""
    ob = plane(200.0, 2)
    slope = math.tan(math.radians(lean))
    settings = {"underwater": True, "Roughness": 0.0}
    if way == "detail":
        settings["Detail"] = (0.0, slope, 0.0)
    else:
        put(ob, "ocean_normal", (0.0, -math.sin(math.radians(lean)), math.cos(math.radians(lean))))
    without_volume(water(ob, **settings))
    light_all_round(scene, SKY, below=DEEP)
    look(scene, degrees, below=True)
    mirrored = fresnel(degrees + lean, 1.0 / IOR)
    assert (mirrored == 1.0) == (degrees + lean > 48.6)
    assert seen(scene, tmp_path)[0] == pytest.approx(1.0 - mirrored, abs=0.02)


def test_from_both_sides_it_is_one_surface(scene, tmp_path):
    """At each place shaders get the same normal from below, turned round."""
    ob = add_ocean(64, preset="beaufort_4", use_material=False)
    made = bpy.data.materials.new("Normals")
    if bpy.app.version < (5, 0):
        made.use_nodes = True
    made.node_tree.nodes.clear()
    t = shader_builder.Tree(made.node_tree)
    noise = t.node("ShaderNodeTexNoise")
    t.feed(t.node("ShaderNodeNewGeometry").outputs["Position"], noise.inputs["Vector"])
    slopes = t.math("MULTIPLY_ADD", noise.outputs["Color"], (4.0, 4.0, 0.0), (-2.0, -2.0, 0.0))
    side = shader_builder.facing(t)
    bent = water_shader._bent(t, shader_builder.stored_normal(t, "ocean_normal", side), slopes)
    shown = t.math("MULTIPLY_ADD", t.scale(bent, side), (0.5, 0.5, 0.5), (0.5, 0.5, 0.5))
    light = t.shader("ShaderNodeEmission", Color=shown)
    t.feed(light, t.node("ShaderNodeOutputMaterial").inputs["Surface"])
    ob.data.materials.append(made)
    scene.camera.data.ortho_scale = 5.0
    scene.render.resolution_x = scene.render.resolution_y = 64
    scene.cycles.samples, scene.cycles.filter_width = 1, 0.01
    look(scene, 0.0)
    above = 2.0 * rendered(scene, tmp_path / "above.exr")[..., :3] - 1.0
    scene.camera.rotation_euler = (math.pi, 0.0, 0.0)  # its y goes the other way
    scene.camera.location = (0.0, 0.0, -50.0)
    below = 2.0 * rendered(scene, tmp_path / "below.exr")[::-1, :, :3] - 1.0
    assert above[..., 2].min() > 0.0 and above[..., :2].std() > 0.1
    # Cycles moves the samples of a pixel about within the filter.
    assert np.abs(above + below).max() < 0.02


@pytest.mark.parametrize("degrees", [20.0, 70.0])
def test_foam_from_below_is_bright_of_the_sky(scene, tmp_path, degrees):
    """Inside Snell's window and outside."""
    ob = plane(200.0, 2)
    put(ob, "cover", 1.0)
    without_volume(water(ob, underwater=True, Pixel_Angle=FAR))
    light_all_round(scene, (1.0, 1.0, 1.0), below=(0.0, 0.0, 0.0))
    look(scene, degrees, below=True)
    want = 1.0 - foam_albedo(1.0)
    assert seen(scene, tmp_path) == pytest.approx(want, rel=0.05)
    light_all_round(scene, (0.0, 0.0, 0.0), below=(1.0, 1.0, 1.0))
    assert seen(scene, tmp_path) == pytest.approx(foam_albedo(1.0), rel=0.05)


def test_nothing_comes_through_foam_on_deep_water(scene, tmp_path):
    ob = plane(200.0, 2)
    put(ob, "cover", 1.0)
    water(ob, Pixel_Angle=FAR)
    light_all_round(scene, (0.0, 0.0, 0.0), below=(1.0, 1.0, 1.0))
    look(scene, 20.0)
    assert (seen(scene, tmp_path) < 0.01).all()


def window_edge(scene, tmp_path, name: str) -> np.ndarray:
    """Degrees from the vertical to which the sky is seen, looking straight up, all round."""
    side = 256
    scene.render.resolution_x = scene.render.resolution_y = side
    scene.cycles.samples = 64
    picture = rendered(scene, tmp_path / f"{name}.exr")[..., 0]
    focal = 0.5 * side / math.tan(0.5 * scene.camera.data.angle)
    bearings = np.linspace(0.0, 2.0 * math.pi, 180, endpoint=False)
    degrees = np.arange(20.0, 68.0, 0.25)
    radii = focal * np.tan(np.radians(degrees))
    x = (0.5 * side + radii[None, :] * np.cos(bearings[:, None])).astype(int)
    y = (0.5 * side + radii[None, :] * np.sin(bearings[:, None])).astype(int)
    # As many degrees as there is sky on the way.
    return 20.0 + 0.25 * (picture[y, x] > 0.4).sum(axis=1)


def test_detail_breaks_snells_window(scene, tmp_path):
    """Flat water has the waves of the detail alone, or their roughness."""
    bpy.ops.libocean.add(preset="beaufort_4")
    ob = bpy.context.object
    ob.libocean.use_detail = True
    bpy.ops.libocean.add_material(underwater=True)
    scene.frame_set(20)
    made = ob.material_slots[0].material
    without_volume(made)
    flat = plane(60.0, 2)
    flat.data.materials.append(made)
    bpy.data.objects.remove(ob)
    light_all_round(scene, (1.0, 1.0, 1.0), below=(0.0, 0.0, 0.0))
    scene.camera.data.type = "PERSP"
    scene.camera.data.angle = math.radians(140.0)
    scene.camera.location = (0.3, 0.2, -2.0)
    scene.camera.rotation_euler = (math.pi, 0.0, 0.0)
    node = next(node for node in made.node_tree.nodes if water_shader.is_water(node))
    put(flat, "slope_variance", 0.02)
    edges = [window_edge(scene, tmp_path, "detail")]
    made.node_tree.links.remove(node.inputs["Detail"].links[0])
    edges.append(window_edge(scene, tmp_path, "none"))
    for edge in edges:
        print(f"\n{edge.mean():.1f} +- {edge.std():.1f} degrees")
    critical = math.degrees(math.asin(1.0 / IOR))
    assert edges[1].mean() == pytest.approx(critical, abs=3.0)
    assert edges[0].std() > 3.0 * edges[1].std()


# God rays -------------------------------------------------------------------------


def long_wave(height: float, side: int = 256, period: float = 10.0):
    """Maps of a long-crested wave, and its wavenumber. Its crest is at x = 0."""
    k = 2.0 * math.pi / period
    x = np.arange(side) * period / side
    slope = -height * k * np.sin(k * x)
    displacement, normal = np.zeros((side, side, 3), np.float32), np.zeros((side, side, 3))
    displacement[..., 2] = height * np.cos(k * x)
    normal[..., 0], normal[..., 2] = -slope, 1.0
    normal /= np.linalg.norm(normal, axis=2, keepdims=True)
    return displacement, normal.astype(np.float32), k


@pytest.mark.parametrize("share", [0.3, 0.6])
def test_a_wave_gathers_light_as_a_lens_does(share):
    """[caustics.cpp] 1 / (1 - d / f) below its crest, 1 / (1 + d / f) below its trough; the focus
    is at f = n / (n - 1) / (a k^2), here 1 km, over which the wave is thin. A cell has eight rays
    across: points of a grid on cells of another are uneven by less than 1 %."""
    displacement, normal, k = long_wave(0.01, side=512)
    focus = IOR / (IOR - 1.0) / (0.01 * k * k)
    lit = sun_focus.focus(displacement, normal, 10.0, share * focus, (0.0, 0.0, 1.0), 64)
    assert lit.mean() == pytest.approx(1.0, rel=1e-5)
    assert lit[:, 0] == pytest.approx(1.0 / (1.0 - share), rel=0.03)
    assert lit[:, 32] == pytest.approx(1.0 / (1.0 + share), rel=0.03)


@pytest.mark.skipif("OCEAN" not in os.environ, reason="no command ocean")
@pytest.mark.parametrize("sun", [(90.0, 0.0), (40.0, 70.0)])
def test_light_is_gathered_as_the_command_ocean_bakes_it(scene, tmp_path, sun):
    """By the exact areas of triangles there, by points here: much the same picture."""
    with libocean.preset("beaufort_3") as sea:
        (tmp_path / "sea.toml").write_text(sea.text)
        period = float(sea.get("patch_size"))
        maps = [np.empty((1024, 1024, 3), np.float32) for _ in range(2)]
        sea.fill(0.0, [(maps[0], ("dx", "dy", "height")), (maps[1], ("nx", "ny", "nz"))])
    command = [os.environ["OCEAN"], "-q", "bake", str(tmp_path / "sea.toml"), "--frames", "1"]
    command += ["--products", "caustics", "--caustics-depth", "8", "--resolution", "1024"]
    command += ["--type", "float", "--sun", f"{sun[0]},{sun[1]}", "-o", str(tmp_path / "sea.exr")]
    subprocess.run(command, check=True)
    baked = pixels(next(tmp_path.glob("*.exr")))[..., 0]
    elevation, bearing = (math.radians(angle) for angle in sun)
    level = math.cos(elevation)
    towards = (level * math.cos(bearing), level * math.sin(bearing), math.sin(elevation))
    lit = sun_focus.focus(*maps, period, 8.0, towards, 256)
    # Cells of four of theirs, whose middle one is in the middle: the outer two have half.
    for axis in (0, 1):
        baked = 0.5 * (np.roll(baked, 2, axis) + np.roll(baked, 1, axis))
    wanted = baked.reshape(256, 4, 256, 4).mean(axis=(1, 3))
    alike = np.corrcoef(lit.ravel(), wanted.ravel())[0, 1]
    print(f"\n{sun}: {lit.std():.3f} of {wanted.std():.3f}, correlation {alike:.3f}")
    assert alike > 0.99
    assert lit.std() == pytest.approx(wanted.std(), rel=0.05)


def lit_plane(scene, tmp_path, ob, depth: float) -> np.ndarray:
    """Returns the light of a lamp on a white plane below an ocean, seen from below without anything
    in between."""
    bed = plane(ob.libocean.patch_size, 2, "Bed")
    bed.location.z = -depth
    bed.data.materials.append(white("ShaderNodeBsdfTranslucent"))
    scene.cycles.max_bounces = 0  # between the two of them
    scene.camera.location = (0.0, 0.0, -depth - 10.0)
    scene.camera.rotation_euler = (math.pi, 0.0, 0.0)
    scene.camera.data.ortho_scale = 0.5 * ob.libocean.patch_size
    scene.render.resolution_x = scene.render.resolution_y = 128
    found = rendered(scene, tmp_path / "bed.exr")[..., :3].mean(axis=2)
    bpy.data.objects.remove(bed)
    return found


@pytest.fixture
def shafts(scene):
    """A small sea under a sun, with god rays."""
    light_all_round(scene, (0.0, 0.0, 0.0))
    lamp = bpy.data.lights.new("Sun", "SUN")
    lamp.energy, lamp.angle = math.pi, 0.0
    scene.collection.objects.link(bpy.data.objects.new("Sun", lamp))
    bpy.ops.libocean.add(preset="beaufort_3")
    ob = bpy.context.object
    made = {"underwater": True, "god_rays": True, "focus_depth": 6.0, "foam": False}
    assert bpy.ops.libocean.add_material(**made) == {"FINISHED"}
    without_volume(ob.material_slots[0].material)
    ob.modifiers.remove(ob.modifiers[-1])  # the walls and the floor
    return ob


def test_below_the_sea_light_is_gathered(scene, tmp_path, shafts):
    """As much as there is: in the mean that of flat water."""
    scene.frame_set(1)
    gathered = lit_plane(scene, tmp_path, shafts, 6.0)
    made = shafts.material_slots[0].material
    water_node = next(node for node in made.node_tree.nodes if water_shader.is_water(node))
    made.node_tree.links.remove(water_node.inputs["Sun Focus"].links[0])
    even = lit_plane(scene, tmp_path, shafts, 6.0)
    print(f"\n{gathered.mean():.3f} +- {gathered.std():.3f}, {even.mean():.3f} +- {even.std():.3f}")
    assert gathered.mean() == pytest.approx(even.mean(), rel=0.01)
    assert even.mean() == pytest.approx(1.0 - fresnel(0.0), rel=0.01)
    assert gathered.std() > 5.0 * even.std()


def image_of(ob):
    tree = ob.material_slots[0].material.node_tree
    return next(node.image for node in tree.nodes if node.type == "TEX_IMAGE")


def test_the_image_is_of_the_frame_and_packed(scene, shafts):
    found = []
    for frame in (1, 30, 1):
        scene.frame_set(frame)
        image = image_of(shafts)
        assert image.packed_file is not None
        found.append(np.array(image.pixels[:], np.float32))
    assert np.array_equal(found[0], found[2]) and not np.array_equal(found[0], found[1])
    assert sum(sun_focus.MARK in image for image in bpy.data.images) == 1


def test_above_water_there_are_none(scene):
    bpy.ops.libocean.add(preset="beaufort_3")
    bpy.ops.libocean.add_material(god_rays=True)
    assert len(bpy.context.object.material_slots[0].material.node_tree.nodes) == 2
