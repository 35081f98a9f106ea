# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels below the modifiers of an object with a terrain: its land and the spectrum of it.
Parameters come from the library's table; those that do not apply are left out. look_panels has the
look.
"""

from __future__ import annotations

import bpy

from .. import translations, whole_sea
from ..shared import drafts, parameter_fields, subject_panel
from ..shared.compat import tr_label
from ..shared.drawing import draws, never_raises, place_labels, say
from ..shared.property_texts import pairs_of
from . import facts, node_group, operators
from .parameter_values import is_measured, is_on, is_placed, is_replaced
from .parameters import PARAMETERS, PLACED, SWITCHES

SHORT = {
    "longest_wavelength": "Longest wave",
    "shortest_wavelength": "Shortest wave",
    "measured": "Measured",
    "mean": "Mean height",
    "ridge_wavelength": "Ridges",
    "ridge_gain": "Gain",
    "ridge_width": "Width",
    "ridge_direction": "Direction",
    "ridge_spread": "Spread",
    "mesh_resolution": "Mesh",
    "detail_wavelength": "Detail",
}
"""Short labels for fields whose label does not fit a panel of default width."""

LAND = ("kind", "patch_size", "resolution", "seed", "rms", "range", "mean")
"""Parameters of the first panel. Those of a placed land and of each group that shapes it have
panels of their own; every other one is in Spectrum."""

_ENTRIES = {entry["key"]: entry for entry in PARAMETERS.entries(items=False)}
GROUPS = {
    group: tuple(key for key in _ENTRIES if key.startswith(f"{group}_")) for group in SWITCHES
}
_ELSEWHERE = {*LAND, *PLACED, *(key for keys in GROUPS.values() for key in keys)}
SPECTRUM = tuple(key for key in _ENTRIES if key not in _ELSEWHERE)

_ONLY_IF = {
    "base_error": lambda settings: bool(settings.base),
    **dict.fromkeys(
        ("ridge_gain", "ridge_width", "ridge_direction"),
        lambda settings: settings.ridge_wavelength > 0.0,
    ),
    "ridge_spread": lambda settings: (
        settings.ridge_wavelength > 0.0 and settings.use_ridge_direction
    ),
    "direction": lambda settings: settings.anisotropy > 1.0,
}


def label_of(entry) -> str:
    return SHORT.get(entry["key"], entry["label"])


def is_used(settings, entry) -> bool:
    """Returns whether a parameter applies. A list of one choice is left out."""
    key = entry["key"]
    if is_replaced(settings, key) or len(entry.get("choices", "..")) == 1:
        return False
    return key not in _ONLY_IF or _ONLY_IF[key](settings)


def _draw_parameters(layout, settings, keys) -> None:
    for key in keys:
        entry = _ENTRIES[key]
        if not is_used(settings, entry):
            continue
        if entry["type"] == "pairs":
            _draw_breaks(layout.column(align=True), settings)
        else:
            parameter_fields.draw(layout.column(), settings, entry, PARAMETERS, label_of(entry))


def _draw_breaks(column, settings) -> None:
    """Draws the wavelength and the exponent of each break, and the buttons that add and remove."""
    pairs = pairs_of(settings.breaks)
    for number in range(len(pairs)):
        row = column.row(align=True)
        fields = row.column(align=True)
        for index, text in ((2 * number, "Break"), (2 * number + 1, "Beta below")):
            fields.prop(settings, "breaks", index=index, text=text, text_ctxt=translations.SEA)
        remove = row.operator(operators.RemoveBreak.bl_idname, text="", icon="X")
        remove.number = number
    column.operator(operators.AddBreak.bl_idname, icon="ADD")


class ObjectPanel(subject_panel.ModifierPanel):
    """A panel that objects with a terrain have"""

    modifiers = staticmethod(node_group.modifiers)


class TerrainPanel(ObjectPanel, bpy.types.Panel):
    """The terrain of the active object"""

    bl_idname = "LIBOCEAN_PT_terrain"
    bl_label = "Terrain (libocean)"

    @draws
    def draw(self, layout, ob, context) -> None:
        subject_panel.draw_files(
            layout,
            operators.LoadTerrainPreset,
            load=operators.LoadTerrain,
            save=operators.SaveTerrain,
        )
        units = tr_label("The land takes a Blender unit for a metre")
        subject_panel.draw_problems(layout, context.scene, [ob.libocean_terrain.problem], units)
        share = drafts.progress(ob.name_full)
        follows = tr_label("A draft; the whole land follows")
        if share:
            follows = tr_label("A draft; the whole land follows: {:.0%}", share)
        stopped = tr_label("A draft, with fewer samples")
        whole_sea.draw_draft(layout, ob.name_full, follows, stopped)
        subject_panel.draw_facts(layout, ob, facts)
        seen = ob.evaluated_get(context.view_layer.depsgraph)
        for text in facts.hints_of(ob, seen, context.scene):
            say(layout, text, "ERROR")


class LandPanel(ObjectPanel, bpy.types.Panel):
    """The size of the tile and its heights"""

    bl_idname = "LIBOCEAN_PT_terrain_land"
    bl_parent_id = TerrainPanel.bl_idname
    bl_label = "Land"

    @draws
    def draw(self, layout, ob, _context) -> None:
        _draw_parameters(layout, ob.libocean_terrain, LAND)


class PlacedPanel(ObjectPanel, bpy.types.Panel):
    """Where a land lies that exists once, and what it begins with"""

    bl_idname = "LIBOCEAN_PT_terrain_placed"
    bl_parent_id = LandPanel.bl_idname
    bl_label = "Place"

    @classmethod
    def poll(cls, context) -> bool:
        return super().poll(context) and is_placed(context.object.libocean_terrain)

    @draws
    def draw(self, layout, ob, _context) -> None:
        _draw_parameters(layout, ob.libocean_terrain, PLACED)


def _draw_group(layout, settings, group: str) -> None:
    """Draws the parameters of a group that shapes the land; its switch is in the header."""
    place_labels(layout)
    column = layout.column()
    column.active = is_on(settings, group)
    _draw_parameters(column, settings, GROUPS[group])


class _SectionPanel(ObjectPanel):
    """The panel of a section that a checkbox in its header switches on."""

    bl_parent_id = TerrainPanel.bl_idname
    bl_options = {"DEFAULT_CLOSED"}
    group = ""
    needs_place = True

    @classmethod
    def poll(cls, context) -> bool:
        if not super().poll(context):
            return False
        return not cls.needs_place or is_placed(context.object.libocean_terrain)

    @never_raises
    def draw_header(self, context) -> None:
        self.layout.prop(context.object.libocean_terrain, f"use_{self.group}", text="")

    @never_raises
    def draw(self, context) -> None:
        _draw_group(self.layout, context.object.libocean_terrain, self.group)


class GulliesPanel(_SectionPanel, bpy.types.Panel):
    """Stripes along the fall line, which shape slopes as rain does"""

    bl_idname = "LIBOCEAN_PT_terrain_gullies"
    bl_label = "Gullies"
    group = "gullies"
    needs_place = False


class StreamsPanel(_SectionPanel, bpy.types.Panel):
    """Valleys that streams cut into a land that exists once"""

    bl_idname = "LIBOCEAN_PT_terrain_stream"
    bl_label = "Streams"
    group = "stream"


class ShorePanel(_SectionPanel, bpy.types.Panel):
    """Beaches and cliffs where a land that exists once meets the water"""

    bl_idname = "LIBOCEAN_PT_terrain_coast"
    bl_label = "Shore"
    group = "coast"


class SpectrumPanel(ObjectPanel, bpy.types.Panel):
    """The law of the heights: how much each wavelength has of them, and in which direction"""

    bl_idname = "LIBOCEAN_PT_terrain_spectrum"
    bl_parent_id = TerrainPanel.bl_idname
    bl_label = "Spectrum"
    bl_options = {"DEFAULT_CLOSED"}

    @draws
    def draw(self, layout, ob, _context) -> None:
        settings = ob.libocean_terrain
        if is_measured(settings):
            say(layout, tr_label("The spectrum is measured: it has no law"), "INFO")
        _draw_parameters(layout, settings, SPECTRUM)


class LayersPanel(ObjectPanel, bpy.types.Panel):
    """Further tiles over the first one, each with a period and a noise of its own"""

    bl_idname = "LIBOCEAN_PT_terrain_layers"
    bl_parent_id = TerrainPanel.bl_idname
    bl_label = "Layers"
    bl_options = {"DEFAULT_CLOSED"}

    @draws
    def draw(self, layout, ob, _context) -> None:
        settings = ob.libocean_terrain
        for number, layer in enumerate(settings.layers):
            row = layout.row(align=True)
            column = row.column(align=True)
            for entry in PARAMETERS.entries(items=True):
                parameter_fields.draw(column, layer, entry, PARAMETERS, entry["label"])
            remove = row.operator(operators.RemoveTerrainLayer.bl_idname, text="", icon="X")
            remove.number = number
        layout.operator(operators.AddTerrainLayer.bl_idname, icon="ADD")


CLASSES = (
    TerrainPanel,
    LandPanel,
    PlacedPanel,
    GulliesPanel,
    StreamsPanel,
    ShorePanel,
    SpectrumPanel,
    LayersPanel,
)

register, unregister = bpy.utils.register_classes_factory(CLASSES)
