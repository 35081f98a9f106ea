# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What holds for the panels of a sea, a terrain and a coast: they are drawn in every state, with
each parameter in one place, in words that fit, and say what fails instead of a traceback."""

import bpy
import pytest
from conftest import add_ocean
from layouts import Layout, cut_in, drawn_by, narrow_editor, shown_in
from libocean_addon.coast import panels as coast_panels
from libocean_addon.floating import floating
from libocean_addon.sea import crest_panels, facts, panels, parameter_values
from libocean_addon.shared import changes, failures, resolutions
from libocean_addon.shared.property_texts import pairs_of
from libocean_addon.terrain import look_panels
from libocean_addon.terrain import panels as terrain_panels
from libocean_addon.terrain.parameters import PARAMETERS, SWITCHES
from test_terrain import add_terrain


class Panels:
    classes: tuple[type, ...] = ()
    settings = "libocean"
    states = ()  # names and values of properties, in turn
    kinds, spectra = (), ()  # with each of which they are drawn
    table = parameter_values.PARAMETERS
    lists = {"numbers": 2}  # how many fields a parameter of a type has
    is_used = staticmethod(panels.is_used)

    def __str__(self) -> str:
        return type(self).__name__

    def add(self, request) -> None:
        """Adds an object, which is then the active one."""

    def show_all(self, settings) -> None:
        """Sets the properties so that each field is drawn."""

    def each_kind(self, settings):
        with changes.quiet():
            for settings.kind in self.kinds:
                for settings.waves[0].spectrum in self.spectra:
                    yield


class SeaPanels(Panels):
    classes = (
        *(cls for cls in panels.CLASSES if issubclass(cls, bpy.types.Panel)),
        crest_panels.crests_panel,
    )
    states = (
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
        ("active_crest", 7),
    )
    kinds, spectra = ("HORIZON", "PATCH"), ("phillips", "tma", "measured", "jonswap")
    lists = {"list": 2, "numbers": 2}

    def add(self, request) -> None:
        add_ocean(64, kind="PATCH", preset="beaufort_6", use_material=False)
        bpy.ops.libocean.add_crest()

    def show_all(self, settings) -> None:
        settings.cascades, settings.use_cascade_divisors = 2, True
        settings.use_scene_frame_rate, settings.use_custom_time = False, True
        settings.foam_coverage, settings.volumes.box = "threshold", "CORNERS"
        settings.bake.use_custom_range, settings.take = True, "/nowhere.take"


class TerrainPanels(Panels):
    classes = (*terrain_panels.CLASSES, *look_panels.CLASSES)
    settings = "libocean_terrain"
    states = (
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
    )
    table = PARAMETERS
    lists = {"numbers": 2, "pairs": 2}
    is_used = staticmethod(terrain_panels.is_used)

    def add(self, request) -> None:
        add_terrain(use_material=True)

    def show_all(self, settings) -> None:
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


class CoastPanels(Panels):
    classes = (*coast_panels.CLASSES, floating.float_panel)
    settings = "libocean_coast"
    states = (("use_region", True), ("region", (50.0, 40.0, 90.0, 100.0)), ("use_wetness", True))

    def add(self, request) -> None:
        request.getfixturevalue("coast")

    def show_all(self, settings) -> None:
        settings.use_region = True


@pytest.fixture(params=[SeaPanels(), TerrainPanels(), CoastPanels()], ids=str)
def case(request):
    request.param.add(request)
    return request.param


@pytest.fixture
def settings(case):
    return getattr(bpy.context.object, case.settings)


def test_every_panel_is_drawn_in_every_state(case, settings):
    drawn_by(*case.classes)
    for name, value in case.states:
        setattr(settings, name, value)
        drawn_by(*case.classes)
        for _ in case.each_kind(settings):
            drawn_by(*case.classes)
    bpy.context.object.data.materials.clear()
    drawn_by(*case.classes)


def test_no_draw_function_raises(case, monkeypatch, capsys):
    """Whatever fails below it is said in the panel, and in the console once."""

    def fail(*_rest, **_settings):
        raise ValueError("out of order")

    for owner, name in ((Layout, "prop"), (Layout, "operator"), (facts, "state_of")):
        monkeypatch.setattr(owner, name, fail)
    for cls in case.classes:
        drawn: list[str] = []
        monkeypatch.setattr(failures, "_logged", set())
        for _ in range(3):
            cls.draw(shown_in(Layout(drawn), cls), bpy.context)
        assert "out of order" in " ".join(drawn), cls
        assert capsys.readouterr().err.count("Traceback") == 1, cls


def test_every_parameter_is_in_one_panel(case, settings):
    if case.settings == "libocean_coast":
        return  # it shows parameters of its sea, and has none
    case.show_all(settings)
    shown = drawn_by(*(cls for cls in case.classes if cls is not terrain_panels.layers_panel))
    for entry in case.table.rows:
        is_item = entry["section"] == case.table.item_section
        group = settings.waves[0] if is_item and case.table is not PARAMETERS else settings
        key = entry["key"]
        listed = resolutions.listed(key) if key in case.table.resolutions else key
        wanted = case.lists.get(entry["type"], 1)
        if is_item and case.table is PARAMETERS:
            assert key in drawn_by(terrain_panels.layers_panel)
        else:
            assert shown.count(listed) == (wanted if case.is_used(group, entry) else 0), key


@pytest.mark.skipif(bpy.app.version >= (4, 0), reason="the pixels were counted with 3.4's font")
@pytest.mark.parametrize("language", ["en_US", "de_DE"])
def test_no_label_is_cut_where_the_editor_is_narrow(case, settings, language, monkeypatch):
    case.show_all(settings)
    with narrow_editor(language, monkeypatch):
        for _ in case.each_kind(settings):
            assert "; ".join(cut_in(*case.classes)) == ""
        assert "; ".join(cut_in(*case.classes)) == ""
