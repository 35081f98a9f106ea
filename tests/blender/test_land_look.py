# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The ground of a land follows its heights, its slopes and its masks, and so do its trees."""

import re
from pathlib import Path

import bpy
import numpy as np
import pytest
from conftest import camera, failing, plane, positions, rest, taken
from libocean_addon.shared import modifier_groups
from libocean_addon.terrain import (
    ground_relief,
    ground_shader,
    material,
    node_group,
    tree_meshes,
    trees,
)
from test_land import CARVED, PLACED, WORN, add_land, library_of, map_of
from test_terrain import add_terrain

# The material ---------------------------------------------------------------------


@pytest.fixture
def seen(studio, tmp_path):
    """Returns a function that gives the colour of an object's ground, from above, by row and
    column."""
    studio.render.resolution_x = studio.render.resolution_y = 64

    def colours(ob, **sockets) -> np.ndarray:
        low, high = positions(ob).min(0), positions(ob).max(0)
        studio.camera.location = (*(low + high)[:2] / 2.0, 1000.0)
        studio.camera.data.ortho_scale = float((high - low)[:2].min())
        studio.camera.data.clip_end = 5000.0
        if not material.grounds(ob):
            bpy.ops.libocean.add_terrain_material()
        (ground,) = material.grounds(ob)
        for name in ("Noise Amount", "Relief"):
            ground.inputs[name].default_value = 0.0
        for name, value in sockets.items():
            ground.inputs[name.replace("_", " ").title()].default_value = value
        tree = ob.material_slots[0].material.node_tree
        light = tree.nodes.new("ShaderNodeEmission")
        tree.links.new(ground.outputs["Colour"], light.inputs["Color"])
        output = next(node for node in tree.nodes if node.type == "OUTPUT_MATERIAL")
        tree.links.new(light.outputs[0], output.inputs["Surface"])
        return taken(studio, tmp_path)

    return colours


def share_of(image: np.ndarray, name: str) -> float:
    near = np.abs(image - np.array(ground_shader.ALBEDOS[name])).max(axis=-1) < 0.01
    return float(near.mean())


# No cover but grass, wherever masks say nothing.
LEVEL = {"snow_line": 1e5, "forest_line": -1e5, "sand_line": -1e5, "wet_line": -1e5}
LEVEL |= {"dry_share": 0.0, "rock_slope": 9.0, "scree_slope": 9.0}
LEVEL |= {"snow_slope": 9.0, "sun_melt": 0.0, "line_width": 1.0}
GRASS = {"Noise Amount": 0.0, "Rock Slope": 9.0, "Scree Slope": 9.0, "Forest Line": -1e5}
SNOW = np.array(ground_shader.ALBEDOS["Snow"])
BY_MASKS = ("beach_sand", "cliff_rock", "stream_scree", "flow_forest", "wear_shade")


@pytest.fixture
def terrain():
    return add_terrain(64, use_material=True)


def test_the_material_fits_the_heights(terrain):
    settings = terrain.libocean_terrain
    settings.use_rms, settings.rms, settings.mean = True, 200.0, 1000.0
    assert bpy.ops.libocean.add_terrain_material(visibility=9000.0) == {"FINISHED"}
    inputs = material.grounds(terrain)[0].inputs
    assert inputs["Snow Line"].default_value == pytest.approx(1260.0, abs=1.0)
    assert inputs["Forest Line"].default_value == pytest.approx(1020.0, abs=1.0)
    assert inputs["Visibility"].default_value == 9000.0
    for name, albedo in ground_shader.ALBEDOS.items():
        assert tuple(inputs[f"{name} Colour"].default_value)[:3] == pytest.approx(albedo)


def test_covers_lie_where_heights_and_slopes_let_them(terrain, seen):
    middle = float(np.median(positions(terrain)[:, 2]))
    rows = (
        ("Grass", {}, 0.99, 1.0),
        ("Snow", {"snow_line": middle, "line_width": 0.1}, 0.4, 0.6),
        ("Snow", {"snow_line": -1e4}, 0.99, 1.0),
        ("Snow", {"snow_line": -1e4, "snow_slope": 0.0}, 0.0, 0.6),  # it slides off
        ("Rock", {}, 0.0, 0.0),
        ("Rock", {"rock_slope": -1.0}, 0.99, 1.0),
        ("Scree", {}, 0.0, 0.0),
        ("Scree", {"scree_slope": -1.0}, 0.99, 1.0),
        ("Forest", {"forest_line": 1e4}, 0.2, 1.0),
        ("Dry Grass", {"dry_share": 1.0, "forest_line": middle}, 0.4, 0.6),
    )
    pictures = {}
    for cover, sockets, low, high in rows:
        key = str(sockets)
        if key not in pictures:
            pictures[key] = seen(terrain, **{**LEVEL, **sockets})
        share = share_of(pictures[key], cover)
        assert low <= share <= high, (cover, sockets, share)


def test_snow_melts_on_the_side_of_the_sun(terrain, seen):
    middle = float(np.median(positions(terrain)[:, 2]))
    sockets = {**LEVEL, "snow_line": middle, "sun_melt": 200.0}
    north, south = (
        np.abs(seen(terrain, **sockets, sun_bearing=bearing) - SNOW).max(-1) < 0.01
        for bearing in (90.0, -90.0)
    )
    heights = positions(terrain)[:, 2].reshape(65, 65)[:64, :64]
    northward = np.gradient(heights, axis=0) > 0.5  # it rises to the north: it faces south
    assert north[northward].mean() > south[northward].mean() + 0.3


def test_sand_below_the_wet_line_is_dark(terrain, seen):
    dry = seen(terrain, **{**LEVEL, "sand_line": 1e4})
    wet = seen(terrain, wet_line=1e4)
    assert share_of(dry, "Sand") > 0.05
    # The darker a colour is, the more mixtures are within a hundredth of it.
    assert share_of(wet, "Wet Sand") == pytest.approx(share_of(dry, "Sand"), abs=0.03)
    assert share_of(wet, "Sand") == share_of(dry, "Wet Sand") == 0.0


def test_noise_has_four_scales(terrain):
    group = ground_shader.get_group()
    (inner,) = {
        node.node_tree
        for node in group.nodes
        if node.type == "GROUP" and "ground noise" in node.node_tree.name
    }
    noises = [node for node in inner.nodes if node.type == "TEX_NOISE"]
    scales = sorted(node.inputs["Scale"].default_value for node in noises)
    assert len(scales) == 4
    assert np.diff(np.log(scales)) == pytest.approx([np.log(1.0 / 0.23)] * 3, rel=1e-4)


def test_beaches_are_sand_and_cliffs_rock(tmp_path, seen):
    ob = add_land(tmp_path, CARVED)
    beach, cliff = map_of(ob, "beach", "cliff").values()
    alone = {**LEVEL, "flow_forest": 0.0}
    none = seen(ob, **alone, beach_sand=0.0, cliff_rock=0.0, stream_scree=0.0)
    assert share_of(none, "Grass") > 0.98
    sandy = seen(ob, beach_sand=1.0)
    assert share_of(sandy, "Sand") == pytest.approx(float((beach > 0.7).mean()), abs=0.06)
    rocky = seen(ob, beach_sand=0.0, cliff_rock=1.0)
    changed = (np.abs(rocky - none).max(axis=-1) > 0.01).mean()
    assert changed == pytest.approx(float((cliff > 0.08).mean()), abs=0.06) and changed > 0.0


def test_forest_follows_the_water_and_crests_are_light(tmp_path, seen):
    ob = add_land(tmp_path, CARVED)
    alone = {**LEVEL, "beach_sand": 0.0, "cliff_rock": 0.0, "stream_scree": 0.0}
    dry = seen(ob, **alone, flow_forest=0.0)
    lush = seen(ob, flow_forest=1.0)
    flow = map_of(ob, "flow")["flow"]
    changed = (np.abs(lush - dry).max(axis=-1) > 0.005).mean()
    assert 0.0 < changed < (flow > 5e4).mean() + 0.05
    worn = add_land(tmp_path, WORN)
    level = seen(worn, **alone, wear_shade=0.0)
    ratio = seen(worn, wear_shade=1.0)[..., 1] / level[..., 1]
    wear = map_of(worn, "wear")["wear"]
    assert ratio.max() == pytest.approx(1.0 + wear.max(), abs=0.15)
    assert ratio.min() == pytest.approx(max(1.0 + wear.min(), 0.2), abs=0.15)


def contrast(image: np.ndarray) -> float:
    """Returns the deviation of the green of a picture, relative to its mean."""
    return float(image[..., 1].std() / image[..., 1].mean())


def with_relief(ob, studio, width: float):
    """Returns the ground of an object, whose relief is seen from above over a width [m]."""
    studio.camera.location.z, studio.camera.data.ortho_scale = 20.0, width
    (ground,) = material.grounds(ob)
    ground.inputs["Relief"].default_value = 1.0
    return ground


def test_relief_is_seen_near_the_eye_and_is_its_mean_from_afar(tmp_path, seen, studio):
    ob = plane(60.0, 2)
    ob.data.materials.append(material.make({**GRASS, "Pixel Angle": 0.01}))
    smooth = seen(ob)
    ground = with_relief(ob, studio, 4.0)
    near = taken(studio, tmp_path)
    assert contrast(smooth) < 0.01 and contrast(near) > 0.1
    ground.inputs["Pixel Angle"].default_value = 1.0
    assert contrast(taken(studio, tmp_path)) < 0.01


def test_waves_of_the_land_are_seen_where_the_mesh_is_too_coarse(tmp_path, studio):
    """In the light of a low sun, without the relief of covers."""
    ob = plane(60.0, 2)
    ob.data.materials.append(material.make({**GRASS, "Relief": 0.0, "Pixel Angle": 0.0001}))
    sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    studio.collection.objects.link(sun)
    sun.rotation_euler, sun.data.energy = (0.9, 0.0, 0.0), 3.0
    studio.render.resolution_x = studio.render.resolution_y = 64
    (ground,) = material.grounds(ob)
    ground.inputs["Noise Amount"].default_value = 0.0
    ground.inputs["Land Slope"].default_value = 0.2
    studio.camera.location.z, studio.camera.data.ortho_scale = 100.0, 60.0
    found = []
    for angle in (0.0, 0.005, 0.05):  # cells of 0, 0.5 and 5 m
        ground.inputs["Mesh Angle"].default_value = angle
        found.append(contrast(taken(studio, tmp_path)))
    assert max(found[:2]) < 0.02 and found[2] > 0.1


def test_a_scene_of_land_says_how_coarse_its_mesh_is():
    bpy.ops.libocean.add_terrain_scene()
    ob = bpy.context.object
    (ground,) = material.grounds(ob)
    assert ground.inputs["Mesh Angle"].default_value == pytest.approx(0.00915)
    slope = library_of(ob).state["rms_slope"]["asked"]
    assert ground.inputs["Land Slope"].default_value == pytest.approx(0.22 * slope, rel=1e-4)


def test_relief_breaks_the_edge_of_a_cover_and_keeps_its_share(tmp_path, seen, studio):
    """Snow of half a share all over lies in patches near the eye, and covers half of the ground."""
    ob = plane(60.0, 2)
    line = {"Snow Line": 0.0, "Line Width": 1.0, "Snow Slope": 9.0, "Pixel Angle": 0.0001}
    ob.data.materials.append(material.make({**GRASS, **line}))
    smooth = seen(ob)
    with_relief(ob, studio, 20.0)
    broken = taken(studio, tmp_path)
    assert contrast(smooth) < 0.01 and contrast(broken) > 0.3
    assert broken[..., 2].mean() == pytest.approx(smooth[..., 2].mean(), rel=0.15)


@pytest.mark.only_reads
def test_preview_and_povray_have_the_same_relief():
    shader = Path(__file__).parents[2] / "shaders" / "preview" / "ground_relief.glsl"
    text = shader.read_text(encoding="utf-8")
    macros = shader.parents[2] / "povray_macros" / "terrain.inc.in"
    povray = macros.read_text(encoding="utf-8")
    for cover, steepness in ground_relief.STEEPNESS.items():
        name = cover.removeprefix("Dry ").lower()
        numbers = re.search(rf"{name}_relief = vec4\((.*)\);", text).group(1)
        assert tuple(map(float, numbers.split(","))) == steepness, cover
        assert f"Terrain_{name.title()}_Relief_ = <{numbers}>" in povray, cover
    for name in ("cleft", "dark", "round", "straw", "uneven"):
        number = re.search(rf"relief_{name} = ([0-9.]+);", text).group(1)
        assert float(number) == getattr(ground_relief, f"_{name.upper()}"), name


def test_snow_lies_on_the_floors_of_gullies(tmp_path, seen):
    ob = add_land(tmp_path, WORN)
    middle = float(np.median(positions(ob)[:, 2]))
    sockets = {**LEVEL, "snow_line": middle, "wear_shade": 0.0}
    wear = map_of(ob, "wear")["wear"]
    even, hollow = (
        np.abs(seen(ob, **sockets, hollow_snow=rise) - SNOW).max(-1) < 0.01 for rise in (0.0, 200.0)
    )
    assert 0.3 < even.mean() < 0.7
    assert hollow.mean() == pytest.approx(
        float((positions(ob)[:, 2] > middle + 200.0 * wear).mean()), abs=0.1
    )


def test_without_masks_the_ground_is_as_it_was(seen):
    ob = add_terrain(64)
    without = seen(ob, **dict.fromkeys(BY_MASKS, 0.0))
    assert np.array_equal(seen(ob, **dict.fromkeys(BY_MASKS, 1.0)), without)


def test_the_material_knows_the_water_of_the_shore(tmp_path):
    level = CARVED.replace("[terrain.coast]\n", "[terrain.coast]\nlevel = 5.0\n")
    ob = add_land(tmp_path, level, use_material=True)
    (ground,) = material.grounds(ob)
    assert ground.inputs["Sand Line"].default_value == 5.0
    assert ground.inputs["Wet Line"].default_value == 5.5
    top = float(positions(ob)[:, 2].max())
    assert ground.inputs["Snow Line"].default_value > top
    assert 5.0 < ground.inputs["Forest Line"].default_value < top


# Trees ----------------------------------------------------------------------------


def trees_on(ob, part: str = "translation") -> np.ndarray:
    """Returns the places of the trees of an object, (n, 3), or another part of their matrices."""
    graph = bpy.context.evaluated_depsgraph_get()
    found = [
        tuple(getattr(instance.matrix_world, "to_" + part)())
        for instance in graph.object_instances
        if instance.is_instance and instance.parent.original == ob
    ]
    return np.array(found).reshape(-1, 3)


def at(ob, name: str, places: np.ndarray) -> np.ndarray:
    """Returns a mask at the nearest samples of places."""
    with library_of(ob) as terrain:
        own = terrain.domain
        field = terrain.region(own.origin, own.samples, own.cell, (name,))[name]
    column, row = np.rint((places[:, :2] - np.array(own.origin)) / own.cell).astype(int).T
    return field[row, column]


def test_trees_grow_where_the_masks_let_them(tmp_path):
    ob = add_land(tmp_path, CARVED)
    assert bpy.ops.libocean.add_trees() == {"FINISHED"}
    places = trees_on(ob)
    assert 500 < len(places) <= trees.MAX_TREES
    assert places[:, 2].min() >= 2.0 - 1e-3
    for name in ("beach", "cliff"):
        assert np.quantile(at(ob, name, places), 0.9) < 0.3, name
    (modifier,) = trees.FAMILY.modifiers(ob)
    modifier_groups.assign(modifier, {"Wet Share": 0.0})
    bpy.context.view_layer.update()
    anywhere = trees_on(ob)
    modifier_groups.assign(modifier, {"Wet Share": 1.0})
    bpy.context.view_layer.update()
    wet = trees_on(ob)
    assert len(wet) < len(anywhere)
    assert at(ob, "wetness", wet).mean() > at(ob, "wetness", anywhere).mean() + 0.02


def test_no_tree_grows_where_a_mask_is_1():
    ob = plane(200.0, 20)
    east = rest(ob)[:, 0] > 0.0
    modifier = modifier_groups.add(ob, "Trees", trees.get_group)
    inputs = {"Trees": tree_meshes.get(), "Density": 1000.0, "Clearings": 0.0}
    modifier_groups.assign(modifier, inputs)
    for name in ("beach", "cliff", "streambed", "slope"):
        mask = ob.data.attributes.new(name, "FLOAT", "POINT")
        mask.data.foreach_set("value", east.astype(np.float32))
        bpy.context.view_layer.update()
        places = trees_on(ob)
        assert (places[:, 0] < 0.0).sum() > 500, name
        assert (places[:, 0] > 10.0).sum() == 0, name
        ob.data.attributes.remove(ob.data.attributes[name])


def test_trees_of_a_large_land_grow_around_the_camera_and_differ_in_size(scene):
    ob = add_terrain(64, "seed_smooth")
    ob.libocean_terrain.patch_size = 8000.0
    camera(scene, (3000.0, 2000.0, 100.0), width=6.0)
    assert bpy.ops.libocean.add_trees() == {"FINISHED"}
    (modifier,) = trees.FAMILY.modifiers(ob)
    reach = modifier_groups.value(modifier, "Reach")
    places = trees_on(ob)
    assert 1000 < len(places) <= trees.MAX_TREES
    away = np.linalg.norm(places - np.array((3000.0, 2000.0, 100.0)), axis=1)
    assert 0.8 * reach < away.max() < reach + 1.5 * 8000.0 / 64
    assert trees_on(ob, "scale").std() > 0.1
    modifier_groups.assign(modifier, {"Size Variation": 0.0, "Reach": 500.0})
    bpy.context.view_layer.update()
    assert np.ptp(trees_on(ob, "scale")) < 1e-5 and 0 < len(trees_on(ob)) < len(places)


def test_trees_of_a_plain_tile_avoid_its_slopes():
    ob = add_terrain(64, "seed_rough")
    assert bpy.ops.libocean.add_trees() == {"FINISHED"}
    assert len(trees_on(ob)) > 10
    assert "has trees" in failing(bpy.ops.libocean.add_trees)
    (modifier,) = trees.FAMILY.modifiers(ob)
    modifier_groups.assign(modifier, {"Max Slope": 0.0})
    bpy.context.view_layer.update()
    assert len(trees_on(ob)) == 0


def test_trees_are_undone_and_share_their_meshes(tmp_path):
    ob = add_land(tmp_path, PLACED)
    name = ob.name
    bpy.ops.ed.undo_push(message="Before")
    bpy.ops.libocean.add_trees()
    bpy.ops.ed.undo_push(message="After")
    many = len(trees_on(ob))
    assert many > 100
    bpy.ops.ed.undo()
    ob = bpy.data.objects[name]
    assert len(trees_on(ob)) == 0 and len(ob.modifiers) == 1
    bpy.ops.ed.redo()
    ob = bpy.data.objects[name]
    assert len(trees_on(ob)) == many
    assert tree_meshes.get() is tree_meshes.get() and len(tree_meshes.get().objects) == 3
    assert all(len(tree.data.polygons) < 120 for tree in tree_meshes.get().objects)
    # The land itself is as it was, and the trees stand on it.
    assert node_group.modifiers(ob)[0].name == "Terrain"
