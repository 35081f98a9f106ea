# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels show the settings that apply, in words that fit, and never a traceback."""

import re
import types

import blf
import bpy
import pytest
from conftest import add_ocean, evaluated_mesh, plane, positions
from libocean_addon import translations
from libocean_addon.floating import floating
from libocean_addon.sea import facts, hints, node_group, panels, parameter_values
from libocean_addon.shared import compat, drafts, drawing, failures, resolutions

PANELS = [cls for cls in panels.CLASSES if issubclass(cls, bpy.types.Panel)]


@pytest.fixture
def ocean():
    bpy.ops.libocean.add(kind="PATCH", preset="beaufort_4", use_material=False)
    ocean = bpy.context.object
    ocean.libocean.resolution = 64
    return ocean


class Layout:
    """Takes what is drawn: names of properties and operators, texts."""

    def __init__(self, drawn: list) -> None:
        self.drawn = drawn

    def prop(self, owner, name, **settings):
        assert name in owner.bl_rna.properties
        getattr(owner, name)
        self.drawn.append(name)

    def operator(self, name, **_settings):
        self.drawn.append(name)
        return types.SimpleNamespace()

    def label(self, *, text, **_settings):
        self.drawn.append(text)

    def prop_search(self, owner, name, *_rest):
        self.prop(owner, name)

    def __getattr__(self, name):
        if name in ("row", "column", "box", "split"):
            return lambda **_settings: Layout(self.drawn)
        return lambda *_rest, **_settings: None  # separator, template_list, operator_menu_enum


def drawn_by(cls) -> list[str]:
    """Returns the widgets that a panel draws; raises where it would."""
    drawn: list[str] = []
    cls.draw.__wrapped__(types.SimpleNamespace(layout=Layout(drawn)), bpy.context)
    return drawn


def said() -> str:
    return " ".join(drawn_by(panels.OceanPanel))


def everything() -> list[str]:
    return [what for cls in PANELS for what in drawn_by(cls)]


# Never a traceback ----------------------------------------------------------------


@pytest.mark.parametrize("spectrum", ["phillips", "jonswap", "tma", "measured"])
@pytest.mark.parametrize("kind", ["PATCH", "HORIZON"])
def test_every_panel_is_drawn_in_every_state(kind, spectrum):
    bpy.ops.libocean.add(kind=kind, use_material=False)
    settings = bpy.context.object.libocean
    settings.resolution, settings.horizon_vertices = 64, 5000
    settings.waves[0].spectrum = spectrum
    assert bool(settings.problem) == (spectrum == "measured")
    everything()
    for name, value in (
        ("use_foam", True),
        ("foam_coverage", "threshold"),
        ("cascades", 3),
        ("use_cascade_divisors", True),
        ("mask", "nothing"),
        ("longest_wavelength", 0.5),
        ("shortest_wavelength", 4.0),
        ("use_custom_time", True),
        ("use_scene_frame_rate", False),
        ("take", "/nowhere.take"),
        ("active_wave", 7),
    ):
        setattr(settings, name, value)
        everything()


def test_a_measured_sea_without_its_file_is_said(ocean):
    ocean.libocean.waves[0].spectrum = "measured"
    assert "needs a file" in said()
    assert "file" in drawn_by(panels.WavesPanel)  # where it is chosen


@pytest.mark.parametrize("cls", [*PANELS, floating.FloatPanel], ids=lambda cls: cls.__name__)
def test_no_draw_function_raises(ocean, cls, monkeypatch, capsys):
    """Whatever fails below it is said in the panel, and in the console once."""
    drawn: list[str] = []
    layout = Layout(drawn)

    def fail(*_rest, **_settings):
        raise ValueError("out of order")

    monkeypatch.setattr(Layout, "prop", fail)
    monkeypatch.setattr(facts, "state_of", fail)
    monkeypatch.setattr(failures, "_logged", set())
    for _ in range(3):
        cls.draw(types.SimpleNamespace(layout=layout), bpy.context)
    assert "out of order" in " ".join(drawn)
    assert capsys.readouterr().err.count("Traceback") == 1


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


def test_every_parameter_is_in_one_panel(ocean):
    settings = ocean.libocean
    settings.waves[0].spectrum, settings.foam_coverage = "jonswap", "threshold"
    settings.cascades = 2
    settings.use_cascade_divisors, settings.use_scene_frame_rate = True, False
    settings.take = "/nowhere.take"
    shown = everything()
    for entry in parameter_values.TABLE:
        group = settings.waves[0] if entry["section"] == "waves" else settings
        key = entry["key"]
        key = resolutions.listed(key) if key in parameter_values.PARAMETERS.resolutions else key
        count = shown.count(key)
        wanted = {"list": settings.cascades, "numbers": 2}.get(entry["type"], 1)
        assert count == (wanted if panels.is_used(group, entry) else 0), key


def test_divisors_are_as_many_as_cascades(ocean):
    settings = ocean.libocean
    assert "use_cascade_divisors" not in drawn_by(panels.AdvancedPanel)
    settings.cascades = 3
    assert "cascade_divisors" not in drawn_by(panels.AdvancedPanel)
    chosen = facts.cascade_divisors(ocean)
    settings.use_cascade_divisors = True
    assert list(settings.cascade_divisors) == [*chosen, 0, 0]
    assert chosen[0] == 1
    assert len(chosen) == 3
    assert settings.problem == ""
    assert drawn_by(panels.AdvancedPanel).count("cascade_divisors") == 3
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


# Pixels at a resolution scale of 1; the editor's region in a window of 1280 and one of 1920, as
# Blender lays it out at first.
NARROW, WIDE = 192, 291
ROW = NARROW - 33  # counted in a picture of it, as are these:
ICON, CHECKBOX, ARROWS, EDGES = 19, 25, 40, 8


class NarrowLayout:
    """Takes what is drawn and compares the widths of words with their space, as Blender divides
    it."""

    def __init__(self, cut: list, space: float, *, share=None, split=False) -> None:
        self.cut, self.space, self.share = cut, space, share
        self.use_property_split = split
        self.is_column = False

    def _child(self, space: float, share: float | None = None):
        return NarrowLayout(self.cut, space, share=share, split=self.use_property_split)

    def _room(self) -> float:
        """Returns the space of the next widget."""
        if self.share is None:
            return self.space
        room = self.space * self.share
        self.space, self.share = self.space - room, None
        return room

    def _take(self, text: str, beside: float) -> None:
        room = self._room()
        if compat.text_width(text) + beside > room:
            self.cut.append(f"{text!r}: {compat.text_width(text):.0f} + {beside:.0f} > {room:.0f}")

    def label(self, *, text="", icon="NONE", text_ctxt="*", translate=True):
        text = bpy.app.translations.pgettext_iface(text, text_ctxt) if translate else text
        self._take(text, 0 if icon == "NONE" else ICON)

    def operator(self, name, *, text=None, icon="NONE"):
        if text is None:
            text = getattr(bpy.types, name.replace("libocean.", "LIBOCEAN_OT_")).bl_label
        word = bpy.app.translations.pgettext_iface(text, "Operator")
        if word:
            self._take(word, EDGES + (0 if icon == "NONE" else ICON))
        return types.SimpleNamespace()

    def operator_menu_enum(self, _name, _property, *, text, icon="NONE", text_ctxt="*"):
        word = bpy.app.translations.pgettext_iface(text, text_ctxt)
        self._take(word, EDGES + 15 + (0 if icon == "NONE" else ICON))

    def prop(self, owner, name, *, text=None, text_ctxt=None, index=-1):
        found = owner.bl_rna.properties[name]
        is_array = getattr(found, "is_array", False) and index < 0
        label, context = (
            (found.name, found.translation_context) if text is None else (text, text_ctxt)
        )
        word = bpy.app.translations.pgettext_iface(label, context or "*")
        if self.use_property_split and word and found.type != "BOOLEAN":
            self._take(word, 2 * self.space / 3)
        elif found.type == "BOOLEAN":
            if word:
                self._take(word, CHECKBOX)
            else:
                self.space -= CHECKBOX
        elif found.type in ("INT", "FLOAT") and not is_array:
            value = getattr(owner, name) if index < 0 else getattr(owner, name)[index]
            shown = bpy.utils.units.to_string("METRIC", found.unit, value, precision=3)
            if found.type == "FLOAT" and found.unit == "NONE" and abs(value) < 1e4:
                shown = f"{value:.3f}"
            self._take(word + shown, ARROWS)
        elif word and not (is_array and self.is_column):
            self.cut.append(f"{word!r} has no place beside the {found.type} of {name}")

    def prop_search(self, owner, name, _data, _found, *, text=None):
        self.prop(owner, name, text=text)

    def row(self, *, heading="", **_settings):
        if heading:
            self.cut.append(f"{heading!r} has no place beside its row")
        return self._child(self._room())

    def column(self, *, heading="", **_settings):  # above the column
        self._take(bpy.app.translations.pgettext_iface(heading), 0)
        column = self._child(self._room())
        column.is_column = True
        return column

    def box(self):
        return self._child(self._room() - 8)

    def split(self, *, factor, **_settings):
        return self._child(self._room(), factor)

    def separator(self):
        pass

    def template_list(self, *_rest, **_settings):
        pass


def shown_wholly() -> list[str]:
    """Sets the properties of the active object one after the other so that each field is drawn."""
    settings = bpy.context.object.libocean
    settings.cascades, settings.use_cascade_divisors = 2, True
    settings.use_scene_frame_rate, settings.use_custom_time = False, True
    settings.foam_coverage, settings.volumes.box = "threshold", "CORNERS"
    settings.bake.use_custom_range = True
    cut: list[str] = []
    for settings.waves[0].spectrum in ("phillips", "tma", "measured"):
        for cls in PANELS:
            context = types.SimpleNamespace(layout=NarrowLayout(cut, ROW))
            cls.draw.__wrapped__(context, bpy.context)
    return cut


@pytest.mark.skipif(bpy.app.version >= (4, 0), reason="the pixels were counted with 3.4's font")
@pytest.mark.parametrize("language", ["en_US", "de_DE"])
@pytest.mark.parametrize("kind", ["PATCH", "HORIZON"])
def test_no_label_is_cut_where_the_editor_is_narrow(monkeypatch, kind, language):
    add_ocean(64, kind=kind, preset="beaufort_6", use_material=False)
    monkeypatch.setattr(drawing, "width", lambda: NARROW)
    view = bpy.context.preferences.view
    view.language, view.use_translate_interface = language, True
    try:
        assert "; ".join(shown_wholly()) == ""
    finally:
        view.language = "en_US"


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
    assert "samples" not in " ".join(drawn_by(panels.LookPanel))
    ocean.libocean.cascades = 2
    size = facts.map_resolution(ocean)
    assert size > ocean.libocean.resolution
    for cls in (panels.LookPanel, panels.AdvancedPanel):
        assert f"2 cascades: maps of {size} x {size} samples" in " ".join(drawn_by(cls))


def test_a_stopped_draft_can_be_finished(ocean, monkeypatch):
    monkeypatch.setattr(drafts, "is_stopped", lambda _name: True)
    shown = drawn_by(panels.OceanPanel)
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
    assert "libocean.stop_draft" in drawn_by(panels.OceanPanel)


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
    with pytest.raises(RuntimeError, match="has an ocean"):
        bpy.ops.libocean.add_modifier()
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
    assert "libocean.subdivide" in drawn_by(panels.OceanPanel)
    assert bpy.ops.libocean.subdivide() == {"FINISHED"}
    assert [modifier.type for modifier in ob.modifiers] == ["SUBSURF", "NODES"]
    assert len(ob.data.vertices) == 4  # the mesh itself stays
    vertices = len(evaluated_mesh(ob).vertices)
    period, samples = ob.libocean.patch_size, facts.map_resolution(ob)
    assert 200.0 / (vertices**0.5 - 1.0) <= period / samples
    assert vertices <= 513**2
    assert positions(ob)[:, 2].std() > 0.2
    assert "between vertices" not in said()
    assert "libocean.subdivide" not in drawn_by(panels.OceanPanel)
    with pytest.raises(RuntimeError, match="already has the vertices"):
        bpy.ops.libocean.subdivide()
    assert len(evaluated_mesh(ob).vertices) == vertices


def test_a_mesh_that_is_fine_enough_is_left_alone():
    plane(100.0, 101)
    bpy.ops.libocean.add_modifier()
    bpy.context.view_layer.update()
    assert not hints.is_too_coarse(bpy.context.object, bpy.context.object)
