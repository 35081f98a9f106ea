# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The ground and the trees of a land follow its masks."""

import bpy
import numpy as np
import pytest
from conftest import plane, positions, rest, taken
from libocean_addon.shared import modifier_groups
from libocean_addon.terrain import ground_shader, material, node_group, tree_meshes, trees
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
        ground.inputs["Noise Amount"].default_value = 0.0
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


ALONE = {
    "sand_line": -1e5,
    "wet_line": -1e5,
    "snow_line": 1e5,
    "forest_line": -1e5,
    "rock_slope": 9.0,
    "dry_share": 0.0,
}
BY_MASKS = ("beach_sand", "cliff_rock", "stream_scree", "flow_forest", "wear_shade")


def test_beaches_are_sand_and_cliffs_rock(tmp_path, seen):
    ob = add_land(tmp_path, CARVED)
    beach, cliff = map_of(ob, "beach", "cliff").values()
    alone = {**ALONE, "scree_slope": 9.0, "flow_forest": 0.0}
    none = seen(ob, **alone, beach_sand=0.0, cliff_rock=0.0, stream_scree=0.0)
    assert share_of(none, "Grass") > 0.98
    sandy = seen(ob, beach_sand=1.0)
    assert share_of(sandy, "Sand") == pytest.approx(float((beach > 0.98).mean()), abs=0.06)
    rocky = seen(ob, beach_sand=0.0, cliff_rock=1.0)
    changed = (np.abs(rocky - none).max(axis=-1) > 0.01).mean()
    assert changed == pytest.approx(float((cliff > 0.08).mean()), abs=0.06) and changed > 0.0


def test_forest_follows_the_water_and_crests_are_light(tmp_path, seen):
    ob = add_land(tmp_path, CARVED)
    alone = {**ALONE, "scree_slope": 9.0, "beach_sand": 0.0, "cliff_rock": 0.0, "stream_scree": 0.0}
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


def trees_on(ob) -> np.ndarray:
    """Returns the places of the trees of an object, (n, 3)."""
    graph = bpy.context.evaluated_depsgraph_get()
    found = [
        tuple(instance.matrix_world.translation)
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


@pytest.mark.parametrize("name", ["beach", "cliff", "streambed", "slope"])
def test_no_tree_grows_where_a_mask_is_1(name):
    ob = plane(200.0, 20)
    east = rest(ob)[:, 0] > 0.0
    mask = ob.data.attributes.new(name, "FLOAT", "POINT")
    mask.data.foreach_set("value", east.astype(np.float32))
    modifier = modifier_groups.add(ob, "Trees", trees.get_group)
    inputs = {"Trees": tree_meshes.get(), "Density": 1000.0, "Clearings": 0.0}
    modifier_groups.assign(modifier, inputs)
    places = trees_on(ob)
    assert (places[:, 0] < 0.0).sum() > 500
    assert (places[:, 0] > 10.0).sum() == 0


def test_trees_of_a_plain_tile_avoid_its_slopes():
    ob = add_terrain(64, "seed_rough")
    assert bpy.ops.libocean.add_trees() == {"FINISHED"}
    assert ob.libocean_terrain.use_slope and len(trees_on(ob)) > 10
    with pytest.raises(RuntimeError, match="has trees"):
        bpy.ops.libocean.add_trees()
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
