# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels below the modifiers of an object with a terrain: its land and the spectrum of it.
Parameters come from the library's table; those that do not apply are left out. look_panels has the
look.
"""

from __future__ import annotations

from .. import translations, whole_sea
from ..shared import drafts, parameter_fields, registration, subject_panel
from ..shared.compat import tr_label
from ..shared.drawing import say
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


PANELS = subject_panel.Panels(node_group.modifiers, "libocean_terrain")


def _is_placed(ob) -> bool:
    return is_placed(ob.libocean_terrain)


@PANELS.add("terrain", "Terrain (libocean)", closed=False)
def terrain_panel(layout, ob, context) -> None:
    """The terrain of the active object"""
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


@PANELS.add("terrain_land", "Land", closed=False)
def land_panel(layout, ob, _context) -> None:
    """The size of the tile and its heights"""
    _draw_parameters(layout, ob.libocean_terrain, LAND)


@PANELS.add("terrain_placed", "Place", parent="terrain_land", closed=False, where=_is_placed)
def placed_panel(layout, ob, _context) -> None:
    """Where a land lies that exists once, and what it begins with"""
    _draw_parameters(layout, ob.libocean_terrain, PLACED)


def _add_group(group: str, label: str, tooltip: str, **settings) -> None:
    """Adds the panel of a group that shapes the land; its switch is in the header."""

    def fields(layout, ob, _context) -> None:
        column = layout.column()
        column.active = is_on(ob.libocean_terrain, group)
        _draw_parameters(column, ob.libocean_terrain, GROUPS[group])

    fields.__doc__ = tooltip
    PANELS.add(f"terrain_{group}", label, switch=f"use_{group}", **settings)(fields)


_add_group("gullies", "Gullies", "Stripes along the fall line, which shape slopes as rain does")
_STREAMS = "Valleys that streams cut into a land that exists once"
_add_group("stream", "Streams", _STREAMS, where=_is_placed)
_SHORE = "Beaches and cliffs where a land that exists once meets the water"
_add_group("coast", "Shore", _SHORE, where=_is_placed)


@PANELS.add("terrain_spectrum", "Spectrum")
def spectrum_panel(layout, ob, _context) -> None:
    """The law of the heights: how much each wavelength has of them, and in which direction"""
    settings = ob.libocean_terrain
    if is_measured(settings):
        say(layout, tr_label("The spectrum is measured: it has no law"), "INFO")
    _draw_parameters(layout, settings, SPECTRUM)


@PANELS.add("terrain_layers", "Layers")
def layers_panel(layout, ob, _context) -> None:
    """Further tiles over the first one, each with a period and a noise of its own"""
    settings = ob.libocean_terrain
    for number, layer in enumerate(settings.layers):
        row = layout.row(align=True)
        column = row.column(align=True)
        for entry in PARAMETERS.entries(items=True):
            parameter_fields.draw(column, layer, entry, PARAMETERS, entry["label"])
        remove = row.operator(operators.RemoveTerrainLayer.bl_idname, text="", icon="X")
        remove.number = number
    layout.operator(operators.AddTerrainLayer.bl_idname, icon="ADD")


CLASSES = tuple(PANELS.classes)

register, unregister = registration.functions(CLASSES)
