# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels of a terrain show the settings that apply, in words that fit, and never a traceback;
its material is tuned in them."""

import types

import bpy
import numpy as np
import pytest
from conftest import positions, taken
from libocean_addon.shared import drawing, failures, meshes, resolutions
from libocean_addon.shared.property_texts import pairs_of
from libocean_addon.terrain import ground_shader, look_panels, material, panels
from libocean_addon.terrain.parameters import PARAMETERS, SWITCHES
from test_panel import NARROW, ROW, Layout, NarrowLayout

PANELS = (*panels.CLASSES, *look_panels.CLASSES)
GROUP_PANELS = (panels.GulliesPanel, panels.StreamsPanel, panels.ShorePanel)


@pytest.fixture
def terrain():
    bpy.ops.libocean.add_terrain(preset="seed_smooth")
    return bpy.context.object


def shown_in(layout, cls):
    """A panel of that class as its draw function sees it."""
    return types.SimpleNamespace(layout=layout, group=getattr(cls, "group", ""))


def drawn_by(cls) -> list[str]:
    drawn: list[str] = []
    cls.draw.__wrapped__(shown_in(Layout(drawn), cls), bpy.context)
    return drawn


def said() -> str:
    return " ".join(drawn_by(panels.TerrainPanel))


def everything() -> list[str]:
    return [what for cls in PANELS for what in drawn_by(cls)]


def show_all_fields(settings) -> None:
    """Sets the properties so that each field is drawn."""
    settings.use_range, settings.measured, settings.measured_rings = False, "", ""
    settings.ridge_wavelength, settings.use_ridge_direction = 30.0, True
    settings.anisotropy = 2.0
    if not pairs_of(settings.breaks):
        bpy.ops.libocean.add_break()
    if not settings.layers:
        bpy.ops.libocean.add_terrain_layer()
    settings.kind = "placed"
    for group in SWITCHES:
        setattr(settings, f"use_{group}", True)


def test_every_panel_is_drawn_in_every_state(terrain):
    settings = terrain.libocean_terrain
    everything()
    for name, value in (
        ("ridge_wavelength", 30.0),
        ("use_ridge_direction", True),
        ("use_range", True),
        ("anisotropy", 3.0),
        ("measured", "/nowhere.csv"),
        ("mask", "nothing"),
        ("kind", "placed"),
        ("use_coast", True),
        ("use_region", True),
        ("use_lod", True),
        ("shape", "MESH"),
        ("tiles", 3),
    ):
        setattr(settings, name, value)
        everything()
    terrain.data.materials.clear()
    everything()


@pytest.mark.parametrize("cls", PANELS, ids=lambda cls: cls.__name__)
def test_no_draw_function_raises(terrain, cls, monkeypatch, capsys):
    drawn: list[str] = []

    def fail(*_rest, **_settings):
        raise ValueError("out of order")

    for name in ("prop", "operator"):
        monkeypatch.setattr(Layout, name, fail)
    monkeypatch.setattr(failures, "_logged", set())
    for _ in range(3):
        cls.draw(shown_in(Layout(drawn), cls), bpy.context)
    assert "out of order" in " ".join(drawn)
    assert capsys.readouterr().err.count("Traceback") == 1


def test_every_parameter_is_in_one_panel(terrain):
    settings = terrain.libocean_terrain
    show_all_fields(settings)
    parts = (panels.LandPanel, panels.PlacedPanel, panels.SpectrumPanel, *GROUP_PANELS)
    shown = [what for cls in parts for what in drawn_by(cls)]
    for entry in PARAMETERS.entries(items=False):
        key = entry["key"]
        listed = resolutions.listed(key) if key in PARAMETERS.resolutions else key
        wanted = {"numbers": 2, "pairs": 2}.get(entry["type"], 1)
        assert shown.count(listed) == (wanted if panels.is_used(settings, entry) else 0), key
    assert {entry["key"] for entry in PARAMETERS.entries(items=True)} <= set(
        drawn_by(panels.LayersPanel)
    )


def test_what_does_not_apply_is_not_there(terrain):
    settings = terrain.libocean_terrain
    shown = set(everything())
    assert {"rms", "mean", "beta", "outer_scale", "libocean.add_break"} <= shown
    assert not {"ridge_gain", "ridge_spread", "direction", "breaks"} & shown
    settings.use_range = True
    assert not {"rms", "mean"} & set(everything())
    settings.measured = "/nowhere.csv"
    assert not {"beta", "outer_scale", "libocean.add_break"} & set(everything())
    settings.shape = "MESH"
    assert not {"tiles", "mesh_resolution_list"} & set(everything())


@pytest.mark.skipif(bpy.app.version >= (4, 0), reason="the pixels were counted with 3.4's font")
@pytest.mark.parametrize("language", ["en_US", "de_DE"])
def test_no_label_is_cut_where_the_editor_is_narrow(terrain, monkeypatch, language):
    show_all_fields(terrain.libocean_terrain)
    monkeypatch.setattr(drawing, "width", lambda: NARROW)
    view = bpy.context.preferences.view
    view.language, view.use_translate_interface = language, True
    cut: list[str] = []
    try:
        for cls in PANELS:
            cls.draw.__wrapped__(shown_in(NarrowLayout(cut, ROW), cls), bpy.context)
    finally:
        view.language = "en_US"
    assert "; ".join(cut) == ""


def test_what_is_unusual_is_said(terrain, scene):
    assert "Clip End" not in said()
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.data.clip_end = 100.0
    scene.collection.objects.link(camera)
    scene.camera = camera
    assert "sees 100 m far" in said()
    scene.camera = None
    terrain.scale.x = 2.0
    bpy.context.view_layer.update()
    assert "scaled unevenly" in said()
    terrain.libocean_terrain.mask = "nothing"
    assert "nothing is no vertex group" in said()
    scene.unit_settings.scale_length = 0.01
    assert "takes a Blender unit for a metre" in said()
    assert "66,049 vertices" in said() and "256 x 256 samples" in said()


def test_settings_that_others_undo_are_said(terrain, monkeypatch):
    monkeypatch.setattr(meshes, "MAX_SAMPLES", 8 * 32)  # 4096 take seconds
    settings = terrain.libocean_terrain
    settings.tiles, settings.mesh_resolution = 8, 32
    assert "vertices along each" not in said()
    settings.mesh_resolution = 64
    assert "8 tiles have at most 32 vertices along each, not 64" in said()
    settings.tiles, settings.mesh_resolution = 1, 64
    settings.use_lod = True
    assert "no effect" not in said()
    settings.follow_world = True
    assert "Mask and Anchor to the world have no effect with Level of Detail" in said()


def test_the_library_warns_in_the_words_of_the_panel(terrain):
    terrain.libocean_terrain.beta = 0.5
    assert "look like noise; a larger Beta" in said() or "a larger beta" in said()
    terrain.libocean_terrain.rms = 0.0
    assert "flat" in said()


def test_a_sea_and_a_terrain_are_not_on_one_object(terrain):
    with pytest.raises(RuntimeError, match="has a terrain"):
        bpy.ops.libocean.add_modifier()
    bpy.ops.libocean.add(use_material=False)
    with pytest.raises(RuntimeError, match="has a terrain or an ocean"):
        bpy.ops.libocean.add_terrain_modifier()


# Material -------------------------------------------------------------------------


def ground_of(ob):
    (ground,) = material.grounds(ob)
    return ground


def test_the_material_fits_the_heights(terrain):
    settings = terrain.libocean_terrain
    settings.use_rms, settings.rms, settings.mean = True, 200.0, 1000.0
    assert bpy.ops.libocean.add_terrain_material(visibility=9000.0) == {"FINISHED"}
    inputs = ground_of(terrain).inputs
    assert inputs["Snow Line"].default_value == pytest.approx(1260.0, abs=1.0)
    assert inputs["Forest Line"].default_value == pytest.approx(1020.0, abs=1.0)
    assert inputs["Visibility"].default_value == 9000.0
    for name, albedo in ground_shader.ALBEDOS.items():
        assert tuple(inputs[f"{name} Colour"].default_value)[:3] == pytest.approx(albedo)


@pytest.fixture
def colours(terrain, studio, tmp_path):
    """Returns a function that gives the colour of the ground at each vertex, seen from above."""
    studio.render.resolution_x = studio.render.resolution_y = 64
    settings = terrain.libocean_terrain
    settings.resolution = 64
    studio.camera.data.ortho_scale = settings.patch_size * 64 / 64
    studio.camera.location.z = 1000.0
    studio.camera.data.clip_end = 5000.0
    made = terrain.material_slots[0].material
    ground = ground_of(terrain)
    ground.inputs["Noise Amount"].default_value = 0.0
    light = made.node_tree.nodes.new("ShaderNodeEmission")
    made.node_tree.links.new(ground.outputs["Colour"], light.inputs["Color"])
    output = next(node for node in made.node_tree.nodes if node.type == "OUTPUT_MATERIAL")
    made.node_tree.links.new(light.outputs[0], output.inputs["Surface"])

    def seen(**sockets) -> np.ndarray:
        for name, value in sockets.items():
            ground.inputs[name.replace("_", " ").title()].default_value = value
        return taken(studio, tmp_path)

    return seen


def share_of(image: np.ndarray, name: str) -> float:
    """Returns the share of the pixels that have the colour of a cover."""
    near = np.abs(image - np.array(ground_shader.ALBEDOS[name])).max(axis=-1) < 0.01
    return float(near.mean())


NONE = {"snow_line": 1e5, "forest_line": -1e5, "sand_line": -1e5, "dry_share": 0.0}


def test_snow_lies_above_its_line(terrain, colours):
    steep = {**NONE, "rock_slope": 9.0, "scree_slope": 9.0, "snow_slope": 9.0, "sun_melt": 0.0}
    assert share_of(colours(**steep), "Grass") > 0.99
    middle = float(np.median(positions(terrain)[:, 2]))
    half = colours(**{**steep, "snow_line": middle, "line_width": 0.1})
    assert 0.4 < share_of(half, "Snow") < 0.6
    assert share_of(colours(snow_line=-1e4), "Snow") > 0.99
    assert share_of(colours(snow_slope=0.0), "Snow") < 0.6  # it slides off


def test_snow_melts_on_the_side_of_the_sun(terrain, colours):
    middle = float(np.median(positions(terrain)[:, 2]))
    level = {**NONE, "rock_slope": 9.0, "scree_slope": 9.0, "snow_slope": 9.0}
    sides = {}
    for bearing in (-90.0, 90.0):
        image = colours(
            **{**level, "snow_line": middle, "line_width": 1.0, "sun_melt": 200.0},
            sun_bearing=bearing,
        )
        sides[bearing] = np.abs(image - np.array(ground_shader.ALBEDOS["Snow"])).max(-1) < 0.01
    heights = positions(terrain)[:, 2].reshape(65, 65)[:64, :64]
    northward = np.gradient(heights, axis=0) > 0.5  # it rises to the north: it faces south
    assert sides[90.0][northward].mean() > sides[-90.0][northward].mean() + 0.3


@pytest.mark.parametrize("cover", ["Rock", "Scree"])
def test_steep_ground_is_bare(colours, cover):
    bare = {**NONE, "rock_slope": 9.0, "scree_slope": 9.0}
    assert share_of(colours(**bare), cover) == 0.0
    assert share_of(colours(**{**bare, f"{cover.lower()}_slope": -1.0}), cover) > 0.99


def test_forest_grows_below_its_line_and_sand_on_the_level(colours):
    bare = {**NONE, "rock_slope": 9.0, "scree_slope": 9.0}
    assert share_of(colours(**{**bare, "forest_line": 1e4}), "Forest") > 0.2
    assert share_of(colours(**{**bare, "sand_line": 1e4}), "Sand") > 0.05


def test_grass_is_dry_far_above_the_forest(terrain, colours):
    bare = {**NONE, "rock_slope": 9.0, "scree_slope": 9.0, "line_width": 1.0}
    middle = float(np.median(positions(terrain)[:, 2]))
    dry = colours(**{**bare, "dry_share": 1.0, "forest_line": middle})
    assert 0.4 < share_of(dry, "Dry Grass") < 0.6


def test_sand_below_the_wet_line_is_dark(colours):
    sandy = {**NONE, "rock_slope": 9.0, "scree_slope": 9.0, "sand_line": 1e4}
    dry, wet = colours(**sandy), colours(**sandy, wet_line=1e4)
    assert share_of(dry, "Sand") > 0.05
    # The darker a colour is, the more mixtures are within a hundredth of it.
    assert share_of(wet, "Wet Sand") == pytest.approx(share_of(dry, "Sand"), abs=0.03)
    assert share_of(wet, "Sand") == share_of(dry, "Wet Sand") == 0.0


def test_noise_has_four_scales(terrain):
    group = ground_shader.get_group()
    inner = [node.node_tree for node in group.nodes if node.type == "GROUP"]
    noises = [node for tree in inner for node in tree.nodes if node.type == "TEX_NOISE"]
    scales = sorted(node.inputs["Scale"].default_value for node in noises)
    assert len(scales) == 4
    assert np.diff(np.log(scales)) == pytest.approx([np.log(1.0 / 0.23)] * 3, rel=1e-4)
