# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels of a sea show the settings that apply, in words that fit. What holds for all panels
is in test_panels.py."""

import re

import blf
import bpy
import pytest
from conftest import add_ocean, evaluated_mesh, failing, plane, positions
from layouts import NARROW, ROW, WIDE, NarrowLayout, drawn_by
from libocean_addon import translations
from libocean_addon.look import material
from libocean_addon.sea import facts, hints, node_group, panels, parameter_values
from libocean_addon.shared import compat, drafts, drawing

PANELS = [cls for cls in panels.CLASSES if issubclass(cls, bpy.types.Panel)]


@pytest.fixture
def ocean():
    return add_ocean(64, kind="PATCH", preset="beaufort_4", use_material=False)


def said() -> str:
    return " ".join(drawn_by(panels.ocean_panel))


def everything() -> list[str]:
    return drawn_by(*PANELS)


# Never a traceback ----------------------------------------------------------------


def test_a_measured_sea_without_its_file_is_said(ocean):
    ocean.libocean.waves[0].spectrum = "measured"
    assert "needs a file" in said()
    assert "file" in drawn_by(panels.spectrum_panel)  # where it is chosen


# Settings that apply, in words that fit --------------------------------------------


def test_what_does_not_apply_is_not_there(ocean):
    settings = ocean.libocean
    shown = everything()
    assert "fetch" in shown
    hidden = {"amplitude", "file", "foam_threshold", "glide", "fps", "horizon_distance"}
    hidden |= {"custom_time", "cascade_divisors", "frame_start", "use_bake", "libocean.free_bake"}
    assert not hidden & set(shown)
    settings.waves[0].spectrum = "phillips"
    settings.foam_coverage = "threshold"
    settings.use_custom_time = settings.bake.use_custom_range = True
    settings.use_scene_frame_rate = False
    shown = everything()
    assert {"amplitude", "foam_threshold", "custom_time", "fps", "frame_start"} <= set(shown)
    assert "fetch" not in shown
    settings.use_foam = False
    assert not {"foam_lifetime", "foam_threshold", "foam_step"} & set(everything())


def test_what_opens_is_what_an_artist_changes(ocean):
    opened = [cls for cls in PANELS if "DEFAULT_CLOSED" not in getattr(cls, "bl_options", ())]
    assert opened == [panels.ocean_panel, panels.waves_panel]
    bpy.ops.libocean.add_material()
    shown = drawn_by(panels.waves_panel)
    names = ["wind_speed", "wind_direction", "significant_wave_height", "default_value"]
    names += ["choppiness", "seed", "use_detail"]
    assert [name for name in shown if name in names] == names
    assert not {"spectrum", "fetch", "peak_enhancement", "spreading", "cascades"} & set(shown)
    assert {"fetch", "peak_enhancement", "spreading"} <= set(drawn_by(panels.spectrum_panel))


def test_the_amount_of_foam_is_that_of_the_material(ocean):
    assert "default_value" not in drawn_by(panels.waves_panel)
    bpy.ops.libocean.add_material()
    (water,) = material.waters_of(ocean)
    assert water.inputs["Foam Amount"].default_value == 1.0


def test_divisors_are_as_many_as_cascades(ocean):
    settings = ocean.libocean
    assert "use_cascade_divisors" not in drawn_by(panels.advanced_panel)
    settings.cascades = 3
    assert "cascade_divisors" not in drawn_by(panels.advanced_panel)
    chosen = facts.cascade_divisors(ocean)
    settings.use_cascade_divisors = True
    assert list(settings.cascade_divisors) == [*chosen, 0, 0]
    assert chosen[0] == 1
    assert len(chosen) == 3
    assert settings.problem == ""
    assert drawn_by(panels.advanced_panel).count("cascade_divisors") == 3
    settings.use_cascade_divisors = False
    assert not any(settings.cascade_divisors)


LABEL = 82  # pixels that a label has in a properties editor of 333, as 1920 x 1080 has at first


@pytest.mark.skipif(bpy.app.version >= (4, 0), reason="the pixels were counted with 3.4's font")
def test_labels_fit():
    blf.size(0, 11)
    german = translations.TABLE["de_DE"]
    for entry in parameter_values.TABLE:
        label = panels.label_of(entry)
        for text in (label, german[translations.SEA, label]):
            width, _ = blf.dimensions(0, text)
            assert width <= LABEL, text
    assert blf.dimensions(0, "Significant wave height")[0] > LABEL


def test_labels_are_beside_their_fields_where_there_is_space(ocean, monkeypatch):
    for width, beside in ((NARROW, False), (WIDE, True)):
        monkeypatch.setattr(drawing, "width", lambda width=width: width)
        layout = NarrowLayout([], ROW)
        drawing.place_labels(layout)
        assert layout.use_property_split == beside


def test_a_sentence_is_divided_where_it_must(monkeypatch):
    path = "//" + 30 * "folder/"
    lines = drawing.lines(f"Frames 1 to 250, in {path}", 120)
    assert all(compat.text_width(line) <= 120 for line in lines)
    assert "".join(lines).replace(" ", "") == f"Frames1to250,in{path}"
    assert drawing.lines("", 120) == []


def test_the_samples_of_the_maps_are_said_where_they_are_set(ocean):
    assert "samples" not in " ".join(drawn_by(panels.look_panel))
    ocean.libocean.cascades = 2
    size = facts.map_resolution(ocean)
    assert size > ocean.libocean.resolution
    for cls in (panels.look_panel, panels.advanced_panel):
        assert f"2 cascades: maps of {size} x {size} samples" in " ".join(drawn_by(cls))


def test_a_stopped_draft_can_be_finished(ocean, monkeypatch):
    monkeypatch.setattr(drafts, "is_stopped", lambda _name: True)
    shown = drawn_by(panels.ocean_panel)
    assert "A draft, without the past of its foam" in " ".join(shown)
    assert "libocean.finish_draft" in shown


def test_raw_inputs_are_out_of_sight(ocean):
    (modifier,) = node_group.modifiers(ocean)
    assert not modifier.show_expanded
    if bpy.app.version >= (4, 0):
        for item in modifier.node_group.interface.items_tree:
            assert item.hide_in_modifier or item.in_out == "OUTPUT" or item.name == "Geometry"


# Hints and warnings -----------------------------------------------------------------


def test_the_size_of_mesh_and_maps_is_told(ocean):
    ocean.libocean.resolution = 256
    ocean.libocean.mesh_resolution = 64
    text = said()
    assert "4,225 vertices" in text
    assert "256 x 256 samples, 3 MB" in text
    assert "one in 16 of their samples" in text
    ocean.libocean.render_resolution = 512
    assert "256 and, rendered, 512" in said()


def test_progress_is_told(ocean, monkeypatch):
    monkeypatch.setattr(drafts, "progress", lambda _name: 0.43)
    assert "A draft; the whole sea: 43%" in said()
    assert "libocean.stop_draft" in drawn_by(panels.ocean_panel)


def test_a_scale_is_said(ocean):
    assert "scaled" not in said()
    ocean.rotation_euler = (0.1, 0.2, 0.3)
    bpy.context.view_layer.update()
    assert "scaled" not in said()
    ocean.scale = (2.0, 2.0, 2.0)
    bpy.context.view_layer.update()
    assert "scaled by 2" in said()
    ocean.scale = (2.0, 1.0, 1.0)
    bpy.context.view_layer.update()
    assert "unevenly" in said()


def test_a_mask_that_names_nothing_is_said(ocean):
    ocean.libocean.mask = "shore"
    assert "shore is no vertex group or attribute" in said()
    ocean.vertex_groups.new(name="shore")
    assert "shore" not in said()
    ocean.libocean.mask = "made"
    assert "made is no" in said()
    ocean.data.attributes.new("made", "FLOAT", "POINT")
    assert "made" not in said()


def test_limits_that_flatten_the_sea_are_said(ocean):
    assert "limits" not in said()
    ocean.libocean.longest_wavelength = 1e5  # longer than any wave
    assert "limits" not in said()
    ocean.libocean.longest_wavelength = 15.0
    before = facts.share_within_limits(ocean)
    assert f"leave {before:.0%} of the wave height" in said().replace("  ", " ")
    assert before < 0.5
    ocean.libocean.longest_wavelength = 0.0
    assert "limits" not in said()


def test_near_detail_says_what_it_needs(ocean):
    settings = ocean.libocean
    settings.use_detail = True
    assert "Near detail" not in said()
    for name in ("use_foam", "use_normal"):
        setattr(settings, name, False)
        assert "Near detail has no effect: it needs Foam and Normal" in said()
        setattr(settings, name, True)
    assert "Near detail" not in said()


def test_a_second_sea_on_an_object_is_refused(ocean):
    assert not bpy.ops.libocean.add_modifier.poll()
    assert "has an ocean" in failing(bpy.ops.libocean.add_modifier)
    assert len(node_group.modifiers(ocean)) == 1
    twin = ocean.modifiers.new("Twin", "NODES")
    twin.node_group = node_group.modifiers(ocean)[0].node_group
    assert "their waves add up" in said()


def test_a_plane_of_four_vertices_offers_to_subdivide(scene):
    bpy.ops.mesh.primitive_plane_add(size=200.0)
    ob = bpy.context.object
    bpy.ops.libocean.add_modifier()
    bpy.context.view_layer.update()
    assert re.search(r"20\d m between vertices", said())
    assert "libocean.subdivide" in drawn_by(panels.ocean_panel)
    assert bpy.ops.libocean.subdivide() == {"FINISHED"}
    assert [modifier.type for modifier in ob.modifiers] == ["SUBSURF", "NODES"]
    assert len(ob.data.vertices) == 4  # the mesh itself stays
    vertices = len(evaluated_mesh(ob).vertices)
    period, samples = ob.libocean.patch_size, facts.map_resolution(ob)
    assert 200.0 / (vertices**0.5 - 1.0) <= period / samples
    assert vertices <= 513**2
    assert positions(ob)[:, 2].std() > 0.2
    assert "between vertices" not in said()
    assert "libocean.subdivide" not in drawn_by(panels.ocean_panel)
    assert "already has the vertices" in failing(bpy.ops.libocean.subdivide)
    assert len(evaluated_mesh(ob).vertices) == vertices


def test_a_mesh_that_is_fine_enough_is_left_alone():
    plane(100.0, 101)
    bpy.ops.libocean.add_modifier()
    bpy.context.view_layer.update()
    assert not hints.is_too_coarse(bpy.context.object, bpy.context.object)
