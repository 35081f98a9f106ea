# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Slope tiles in the material: read as slope_tiles.glsl says, as much slope as the sea has at every
distance, of the frame, and gone where they are not wanted."""

import math

import bpy
import numpy as np
import other_blender
import pytest
from conftest import (
    NO_PAST,
    add_ocean,
    attribute,
    by_nodes,
    in_another_blender,
    opened,
    picture_settings,
    pixels,
    pixels_of,
    plane,
    presets_with,
    reopened,
    save,
    shine,
    taken,
)
from libocean_addon.bundled import libocean
from libocean_addon.look import detail, water_shader
from libocean_addon.sea import facts
from test_material import put

# The formulas -------------------------------------------------------------------


def corners(x, y):
    """Returns weights and corners of the grid, [3][n], as slope_tiles.glsl and copies.glsl do."""
    scale = 2.0 / 1.6
    grid_x = 1.6 * scale * (x - 0.57735026918962576 * y)
    grid_y = 1.6 * scale * 1.15470053837925153 * y
    square_x, square_y = np.floor(grid_x), np.floor(grid_y)
    part_x, part_y = grid_x - square_x, grid_y - square_y
    rest = 1.0 - part_x - part_y
    other = (rest < 0.0).astype(int)
    weights = np.stack(
        [
            np.abs(rest),
            np.where(other == 1, 1.0 - part_y, part_y),
            np.where(other == 1, 1.0 - part_x, part_x),
        ]
    )
    right, up = np.stack([other, other, 1 - other]), np.stack([other, 1 - other, other])
    weights /= np.sqrt((weights**2).sum(axis=0))
    return weights, square_x + right, square_y + up


@pytest.fixture(scope="module")
def somewhere():
    random = np.random.default_rng(5)
    places = random.uniform(-30.0, 30.0, (4000, 3)).astype(np.float32)
    return places, *corners(*places[:, :2].astype(np.float64).T)


@pytest.mark.parametrize("corner", range(3))
def test_copies_are_weighed_as_slope_tiles_glsl_does(somewhere, corner):
    places, weights, *_ = somewhere
    found = by_nodes(lambda b, x, y, _: detail.copies(b, x, y)[corner][1], places)
    # Some places lie on an edge of a triangle, to the last bits of 30 tiles.
    assert np.abs(found - weights[corner]).max() < 1e-4


def test_a_corner_moves_its_copy_by_the_same_everywhere(somewhere):
    """And evenly over the tile, each corner by its own."""
    places, weights, right, up = somewhere
    moved = {}

    def place(b, x, y, corner: int, axis: int):
        return b.parts(detail.copies(b, x, y)[corner][0])[axis]

    for corner in range(3):
        x, y = (
            by_nodes(lambda b, x, y, _, c=corner, k=k: place(b, x, y, c, k), places) - places[:, k]
            for k in (0, 1)
        )
        for at in np.flatnonzero(weights[corner] > 0.01):
            moved.setdefault((right[corner, at], up[corner, at]), []).append((x[at], y[at]))
    spread = [np.ptp(np.array(offsets), axis=0).max() for offsets in moved.values()]
    assert max(len(offsets) for offsets in moved.values()) > 3
    assert max(spread) < 1e-5
    offsets = np.array([offsets[0] for offsets in moved.values()])
    assert offsets.min() > -1e-5 and offsets.max() < 1.0 + 1e-5
    count = len(offsets)
    assert len(np.unique(np.rint(offsets * 1e5), axis=0)) > 0.99 * count
    # Four standard errors of what is uniform.
    assert np.abs(offsets.mean(axis=0) - 0.5).max() < 4 * math.sqrt(1 / 12 / count)
    assert abs(np.corrcoef(offsets.T)[0, 1]) < 4 / math.sqrt(count)


def test_bands_fade_as_slope_tiles_glsl_says():
    shortest, longest = 0.15, 0.9
    footprints = np.linspace(0.0, 1.0, 300)
    t = np.clip((footprints / math.sqrt(shortest * longest) - 0.25) / 0.95, 0.0, 1.0)
    arguments = np.stack([footprints] * 3, axis=1)
    found = by_nodes(lambda b, a, *_: detail.fade(b, a, shortest, longest), arguments)
    assert np.abs(found - (1.0 - t * t * (3.0 - 2.0 * t))).max() < 1e-6


# As much slope as the sea has -----------------------------------------------------

PRESET = "beaufort_4"


def ocean(kind: str = "PATCH"):
    with presets_with(**NO_PAST):
        bpy.ops.libocean.add(kind=kind, preset=PRESET)
    ob = bpy.context.object
    ob.libocean.use_detail = True
    return ob


def small_shot(scene, folder):
    """An ocean of few samples in a saved file, its shot of two frames."""
    ob = ocean()
    ob.libocean.resolution = 64
    scene.frame_start, scene.frame_end = 1, 2
    save(folder / "shot.blend")
    return ob


def nodes_of(ob):
    tree = ob.material_slots[0].material.node_tree
    water = next(node for node in tree.nodes if water_shader.is_water(node))
    return next((node for node in tree.nodes if detail.is_detail(node)), None), water


def bands_of(at: float = 0.0):
    with libocean.preset(PRESET) as sea:
        return sea.detail(at)


def as_read(band) -> float:
    """Its mean square slope between samples too: bilinear, at 64 places of each texel."""
    slope = band.slope.astype(np.float64)
    between = (slope, np.roll(slope, -1, 1), np.roll(slope, -1, 0), np.roll(slope, -1, (0, 1)))
    mean, shares = 0.0, (np.arange(8) + 0.5) / 8
    for x in shares:
        for y in shares:
            low, high = (a * (1 - x) + b * x for a, b in (between[:2], between[2:]))
            mean += ((low * (1 - y) + high * y) ** 2).mean() / 64
    return 2.0 * mean


SLOW = pytest.mark.slow


def set_pixel_angle(ob, angle: float) -> None:
    """In the place of that of the rendered scene."""
    tree = ob.material_slots[0].material.node_tree
    for node in nodes_of(ob):
        socket = node.inputs["Pixel Angle"]
        for link in socket.links:
            tree.links.remove(link)
        socket.default_value = angle


# Over a bed -------------------------------------------------------------------------


def coast_with_detail(sea_file):
    """Returns the water of a small coast with a material."""
    bpy.ops.libocean.add_coast(filepath=str(sea_file), cell=8.0, use_land=False)
    return bpy.context.object


def open_bands(sea_file, at: float):
    """Returns the bands of the sea of a coast's file, without its bed."""
    text = "\n".join(line for line in sea_file.read_text().split("\n") if "seabed" not in line)
    with libocean.parse(text) as sea:
        return sea.detail(at)


def test_the_water_of_a_coast_has_the_slopes_of_its_open_sea(scene, sea_file):
    ob = coast_with_detail(sea_file)
    for frame in (1, 30):
        scene.frame_set(frame)
        wanted = open_bands(sea_file, (frame - 1) / 24).bands
        for one, band in zip(shown_by(ob), wanted, strict=True):
            assert np.array_equal(one, band.slope)
    ob.libocean.use_detail = False
    assert nodes_of(ob)[0] is None and blocks() == 0


def test_over_a_bed_it_ends_with_the_water(studio, tmp_path, sea_file):
    """And the roughness gets what a map lacks of the sea's slopes less what is seen, all of it
    times the share of the depth."""
    ob = coast_with_detail(sea_file)
    found = open_bands(sea_file, 0.0)
    said = sum(as_read(band) for band in found.bands)
    lost = found.residual + sum(band.variance_x + band.variance_y for band in found.bands)
    flat = above(ob, studio)
    set_pixel_angle(ob, 0.0)
    squares = []
    for depth, share in ((None, 1.0), (0.25, 0.5), (4.0, 1.0), (-0.2, 0.0)):
        if depth is not None:
            put(flat, "depth", depth)
        seen = taken(studio, tmp_path).astype(np.float64)
        assert seen[..., 2].mean() == pytest.approx(share * (said - lost), rel=0.01, abs=1e-9)
        squares.append((seen[..., :2] ** 2).sum(axis=2).mean())
        assert squares[-1] == pytest.approx(share * squares[0], rel=1e-3)
    assert squares[0] > 0.3 * said


@pytest.mark.parametrize(
    "pixel", [0.0, pytest.param(0.05, marks=SLOW), 0.15, pytest.param(0.4, marks=SLOW), 2.0]
)
def test_mesh_and_detail_and_roughness_are_the_sea(studio, tmp_path, pixel):
    """pixel: its width in metres. Of the sea's mean square slope the mesh has what its map has, the
    detail what is seen of it, and the roughness all but what is said to be seen."""
    ob = ocean()
    studio.frame_set(1)
    with libocean.preset(PRESET) as sea:
        state, bands = sea.state, sea.detail(0.0).bands
    slopes = {m["resolution"]: m["mean_square_slope"] for m in state["map_slopes"]}
    mapped, asked = slopes[facts.map_resolution(ob)], state["mean_square_slope"]["asked"]
    left_out = attribute(ob, "slope_variance")[0]
    node, _ = nodes_of(ob)
    set_pixel_angle(ob, pixel / 100.0)
    flat = plane(60.0, 2)
    shine(flat, ob.material_slots[0].material, node.outputs["Detail"])
    bpy.data.objects.remove(ob)
    # A lens this long sees everything at one distance.
    studio.camera.data.ortho_scale = 50.0 if pixel == 0.0 else 5.0
    studio.render.resolution_x = studio.render.resolution_y = 600 if pixel == 0.0 else 100
    seen = taken(studio, tmp_path).astype(np.float64)
    said = 0.0
    for band in bands:
        t = (pixel / math.sqrt(band.shortest_wave * band.longest_wave) - 0.25) / 0.95
        t = min(max(t, 0.0), 1.0)
        said += (1.0 - t * t * (3.0 - 2.0 * t)) ** 2 * as_read(band)
    assert seen[..., 2].mean() == pytest.approx(said, rel=0.01, abs=1e-9)
    shown = (seen[..., :2] ** 2).sum(axis=2).mean()
    print(f"\n{pixel} m: {mapped:.5f} + {shown:.5f} + {left_out - said:.5f} of {asked:.5f}")
    if pixel in (0.0, 2.0):  # else a few tiles are no mean
        assert mapped + shown + (left_out - said) == pytest.approx(asked, rel=0.01)
    assert (shown > 0.4 * asked) == (pixel == 0.0)
    assert left_out - said > 0.0


# Seen, and when -------------------------------------------------------------------


def fine_contrast(picture: np.ndarray) -> float:
    """Returns how far each pixel of the lower half differs from the mean of the 9 x 9 around it."""
    grey = picture[: len(picture) // 2].mean(axis=2)
    sums = np.pad(grey, ((1, 0), (1, 0))).cumsum(axis=0).cumsum(axis=1)
    means = (sums[9:, 9:] - sums[:-9, 9:] - sums[9:, :-9] + sums[:-9, :-9]) / 81
    return float((grey[4:-4, 4:-4] - means).std())


@pytest.mark.slow
def test_near_water_is_no_silk(scene, tmp_path):
    """At 1.6 m above Beaufort 4."""
    bpy.ops.libocean.add_scene(preset=PRESET, camera_height=1.6)
    ob = bpy.context.object
    picture_settings(scene, 320, 64)
    scene.render.resolution_y = 160
    scene.camera.rotation_euler.x = math.radians(80.0)
    contrasts = []
    for wanted in (False, True):
        ob.libocean.use_detail = wanted
        bpy.ops.libocean.add_material()
        scene.frame_set(20)
        contrasts.append(fine_contrast(taken(scene, tmp_path)))
    print(f"\nfine contrast {contrasts[0]:.5f}, with detail {contrasts[1]:.5f}")
    assert contrasts[1] > 3.0 * contrasts[0]


def shown_by(ob) -> list[np.ndarray]:
    """Returns the pixels of the images in an object's material, longest waves first."""
    node, _ = nodes_of(ob)
    images = {n.image for n in node.node_tree.nodes if n.type == "TEX_IMAGE"}
    images = sorted(images, key=lambda image: image.name)
    return [pixels_of(image)[..., :2] for image in images]


def test_the_tiles_are_those_of_the_frame_and_the_sea(scene):
    ob = ocean()
    for frame in (1, 30):
        scene.frame_set(frame)
        found, wanted = shown_by(ob), bands_of((frame - 1) / 24).bands
        assert len(found) == len(wanted) == 2
        for one, band in zip(found, wanted, strict=True):
            assert np.array_equal(one, band.slope)
    ob.libocean.waves[0].wind_speed = 15.0
    scene.frame_set(1)
    assert not np.array_equal(shown_by(ob)[0], bands_of().bands[0].slope)


def blocks() -> int:
    return sum(
        detail.MARK in block for all_ in (bpy.data.images, bpy.data.node_groups) for block in all_
    )


def test_without_it_nothing_is_left(scene):
    ob = ocean()
    scene.frame_set(1)
    assert nodes_of(ob)[1].inputs["Detail"].is_linked and blocks() == 3
    ob.libocean.use_detail = False
    node, water = nodes_of(ob)
    assert node is None and not water.inputs["Detail"].is_linked and blocks() == 0


def test_without_it_in_a_bake_nothing_is_left(scene, tmp_path):
    ob = small_shot(scene, tmp_path)
    bpy.ops.libocean.bake()
    assert nodes_of(ob)[0] is not None and blocks() == 1 and len(sequences(ob)) == 3
    ob.libocean.use_detail = False
    assert nodes_of(ob)[0] is None and blocks() == 0 and len(sequences(ob)) == 0
    ob.libocean.use_detail = True
    assert nodes_of(ob)[1].inputs["Detail"].is_linked and len(sequences(ob)) == 3
    (tmp_path / "ocean_bake").rename(tmp_path / "elsewhere")
    ob.libocean.use_bake = False
    ob.libocean.use_bake = True
    assert nodes_of(ob)[0] is None and blocks() == 0 and len(sequences(ob)) == 0


def sequences(ob) -> list:
    return [
        image
        for image in bpy.data.images
        if image.source == "SEQUENCE" and "detail" in image.filepath
    ]


def above(ob, scene):
    """Has the scene show the value that the detail gives to the water, from straight above.
    Returns the plane that shows it."""
    ob.hide_render = True
    flat = plane(60.0, 2)
    node = nodes_of(ob)[0]
    set_pixel_angle(ob, 0.001)
    shine(flat, ob.material_slots[0].material, node.outputs["Detail"])
    scene.camera.data.ortho_scale = 5.0
    scene.render.resolution_x = scene.render.resolution_y = 200
    return flat


@pytest.mark.slow
@pytest.mark.parametrize("remapped", [100, 150])
def test_a_bake_shows_the_slopes_of_the_live_sea(studio, tmp_path, remapped):
    """Also where the files are others than before; beyond them those of the first and the last.
    Files have the numbers of the scene's frames, whatever its time."""
    ob = ocean()
    studio.render.frame_map_new = remapped
    studio.frame_start, studio.frame_end = 3, 7
    save(tmp_path / "shot.blend")
    studio.frame_set(2)
    above(ob, studio)
    before = None
    for wind in (5.0, 14.0):
        ob.libocean.use_bake = False
        ob.libocean.waves[0].wind_speed = wind
        live = {}
        for frame in (2, 3, 7, 8):
            studio.frame_set(frame)
            live[frame] = taken(studio, tmp_path)
        assert before is None or np.abs(live[3] - before).max() > 0.02
        before = live[3]
        bpy.context.view_layer.objects.active = ob
        assert bpy.ops.libocean.bake() == {"FINISHED"}
        for frame, same in ((7, 7), (3, 3), (2, 2), (1, 2), (-20, 2), (8, 8), (30, 8)):
            studio.frame_set(frame)
            found = taken(studio, tmp_path)
            error = np.abs(found - live[same])
            print(f"\nwind {wind}, frame {frame}: {error.max():.2g} of {np.abs(found).max():.2f}")
            assert error[..., :2].max() < 1e-5 and np.abs(found[..., :2]).max() > 0.2
            assert error[..., 2].max() < 0.02 * found[..., 2].max()
        assert np.abs(live[3] - live[7])[..., :2].max() > 0.1


def near_water(scene, tmp_path):
    """Crests against the sun, from a boat."""
    with presets_with(resolution=64):
        bpy.ops.libocean.add_scene(
            preset="beaufort_6", sun_elevation=0.2, sun_bearing=0.0, near_detail=False
        )
    ob = bpy.context.object
    ob.libocean.horizon_vertices = 20000
    scene.frame_set(2)  # the first that has files: its mean square slope is kept
    ob.libocean.use_detail = True
    picture_settings(scene, 120, 16)
    scene.render.resolution_y = 60
    scene.camera.rotation_euler.x = math.radians(80.0)
    scene.frame_start, scene.frame_end = 3, 7
    save(tmp_path / "shot.blend")
    return ob


@pytest.mark.slow  # test_bake.py renders bakes without the add-on too
def test_without_the_addon_a_bake_looks_the_same(scene, tmp_path):
    ob = near_water(scene, tmp_path)
    live = {}
    for frame in (3, 7):
        scene.frame_set(frame)
        live[frame] = taken(scene, tmp_path)
    assert bpy.ops.libocean.bake() == {"FINISHED"}
    bpy.ops.wm.save_mainfile()
    in_another_blender(
        other_blender.render, tmp_path / "shot.blend", tmp_path / "farm_####.exr", "", 3, 7
    )
    farm = {frame: pixels(tmp_path / f"farm_{frame:04}.exr")[..., :3] for frame in (3, 7)}
    without = {}
    for name in ("use_detail", "use_velocity"):  # of which the crests have their Jacobian
        setattr(ob.libocean, name, False)
        scene.frame_set(7)
        without[name] = np.abs(taken(scene, tmp_path) - live[7]).max()
        setattr(ob.libocean, name, True)
    for frame, picture in farm.items():
        error = np.abs(picture - live[frame]).max()
        print(f"\nframe {frame}: {error:.2g} of {picture.max():.2f}, without {without}")
        assert error < 1e-3
    assert min(without.values()) > 0.01
    assert np.abs(live[3] - live[7]).max() > 0.1


def test_after_a_bake_the_live_tiles_are_back(scene, tmp_path):
    ob = ocean()
    scene.frame_start = scene.frame_end = 2
    save(tmp_path / "shot.blend")
    bpy.ops.libocean.bake()
    for leave in (lambda: setattr(ob.libocean, "use_bake", False), bpy.ops.libocean.free_bake):
        ob.libocean.use_bake = True
        scene.frame_set(2)
        assert len(sequences(ob)) == 2 and blocks() == 1
        leave()
        assert len(sequences(ob)) == 0 and blocks() == 3
        for frame in (2, 30):
            scene.frame_set(frame)
            for one, band in zip(shown_by(ob), bands_of((frame - 1) / 24).bands, strict=True):
                assert np.array_equal(one, band.slope)


@pytest.mark.slow
def test_baked_again_nothing_of_the_old_files_is_shown(scene, tmp_path):
    """Which Blender keeps in memory, by the image."""
    ob = small_shot(scene, tmp_path)
    shown = []
    for wind in (5.0, 14.0):
        ob.libocean.waves[0].wind_speed = wind  # while it plays, the second time
        bpy.ops.libocean.bake()
        shown.append(np.array(sequences(ob)[0].pixels[:], np.float32))
        assert shown[-1].reshape(-1, 4)[:, :2].std() > 0.01
    assert len(sequences(ob)) == 3 and np.abs(shown[1] - shown[0]).max() > 0.02


def test_saved_elsewhere_it_plays_on(scene, tmp_path):
    ob = small_shot(scene, tmp_path)
    bpy.ops.libocean.bake()
    other = save(tmp_path / "version_2" / "shot.blend")
    played = {image.name for image in sequences(ob)}
    scene.frame_set(2)
    assert len(played) == 3 and {image.name for image in sequences(ob)} == played
    ob = opened(other, ob.name, 1)
    assert {image.name for image in sequences(ob)} == played
    assert nodes_of(ob)[1].inputs["Detail"].is_linked and blocks() == 1


def test_another_material_shows_it_too(scene):
    ob = ocean()
    scene.frame_set(1)
    bpy.ops.libocean.add_material(water_type="jerlov_9c")
    scene.frame_set(2)
    assert nodes_of(ob)[1].inputs["Detail"].is_linked and blocks() == 3


def test_a_second_sea_with_the_same_material_leaves_it_alone(scene):
    ob = ocean()
    scene.frame_set(1)
    other = add_ocean(64, preset="beaufort_8", use_material=False)
    other.libocean.use_detail = True
    other.data.materials.append(ob.material_slots[0].material)
    scene.frame_set(2)
    scene.frame_set(1)
    assert blocks() == 3
    for one, band in zip(shown_by(ob), bands_of().bands, strict=True):
        assert np.array_equal(one, band.slope)


def test_what_somebody_put_there_stays(scene):
    with presets_with(**NO_PAST):
        bpy.ops.libocean.add(preset=PRESET)
    ob = bpy.context.object
    tree = ob.material_slots[0].material.node_tree
    own = tree.nodes.new("ShaderNodeCombineXYZ")
    tree.links.new(own.outputs[0], nodes_of(ob)[1].inputs["Detail"])
    ob.libocean.use_detail = True
    scene.frame_set(1)
    assert nodes_of(ob)[1].inputs["Detail"].links[0].from_node == own and blocks() == 0


def test_it_is_there_again_after_loading(scene, tmp_path):
    ob = ocean()
    scene.frame_set(30)
    found = shown_by(reopened(tmp_path / "sea.blend", ob.name))
    assert np.array_equal(found[0], bands_of(29 / 24).bands[0].slope) and blocks() == 3
