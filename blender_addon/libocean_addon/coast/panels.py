# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels below the modifiers of the water of a coast: its sea, its waves and its bed, and how
it is shown."""

from __future__ import annotations

from .. import translations, whole_sea
from ..sea import panels as sea_panels
from ..sea import parameter_values
from ..shared import drafts, meshes, registration, subject_panel
from ..shared.compat import tr_label
from ..shared.drawing import field, say
from ..terrain import trees
from ..terrain.look_panels import SIDES
from . import facts, node_group, operators

BED = ("seabed", "seabed_origin", "seabed_unit", "seabed_sign", "level", "depth")
_ENTRIES = {entry["key"]: entry for entry in parameter_values.entries(waves=False)}
SHORE = tuple(key for key, entry in _ENTRIES.items() if entry["section"] == "water.shore")
SPECTRUM = ("patch_size", "resolution")


PANELS = subject_panel.Panels(node_group.modifiers, "libocean_coast")


@PANELS.add("coast", "Coast (libocean)", closed=False)
def coast_panel(layout, ob, context) -> None:
    """The coast of the active object"""
    row = layout.row(align=True)
    row.operator(operators.LoadCoast.bl_idname, text="Load", icon="IMPORT")
    row.operator(operators.SaveCoast.bl_idname, text="Save", icon="EXPORT")
    units = tr_label("The sea takes a Blender unit for a metre")
    subject_panel.draw_problems(layout, context.scene, [ob.libocean_coast.problem], units)
    share = drafts.progress(ob.name_full) or 0.0
    working = tr_label("A draft; the whole coast follows: {:.0%}", share)
    stopped = tr_label("A draft: the coast as it was")
    whole_sea.draw_draft(layout, ob.name_full, working, stopped)
    subject_panel.draw_facts(layout, ob, facts)


@PANELS.add("coast_waves", "Sea", closed=False, labels=False)
def waves_panel(layout, ob, _context) -> None:
    """The sea as an artist changes it"""
    sea_panels.draw_sea(layout, ob)


@PANELS.add("coast_spectrum", "Spectrum", labels=False)
def spectrum_panel(layout, ob, _context) -> None:
    """The wave systems that reach the coast, with their spectra"""
    settings = ob.libocean
    sea_panels.draw_spectrum(layout, settings)
    layout.separator()
    _draw_parameters(layout, settings, SPECTRUM)


def _draw_parameters(layout, settings, keys) -> None:
    for key in keys:
        sea_panels.draw_parameter(layout, settings, _ENTRIES[key])


@PANELS.add("coast_bed", "Bed")
def bed_panel(layout, ob, _context) -> None:
    """The bed and the height of the water over it"""
    _draw_parameters(layout, ob.libocean, (*BED, *SHORE))
    for name in ("land", "far_water"):
        field(layout, ob.libocean_coast, name)


@PANELS.add("coast_look", "Look")
def look_panel(layout, ob, _context) -> None:
    """How the water is shown"""
    settings = ob.libocean_coast
    layout.prop(settings, "cell")
    layout.prop(settings, "use_fine_shore")
    if settings.use_fine_shore:
        layout.prop(settings, "use_cusps")
    layout.prop(settings, "use_region")
    if settings.use_region:
        column = layout.column(align=True)
        for index, text in enumerate(SIDES):
            column.prop(settings, "region", index=index, text=text, text_ctxt=translations.SEA)
    layout.prop(settings, "use_clip")
    if settings.use_clip:
        layout.prop(settings, "clip_depth")
    column = layout.column(heading="Attributes")
    for name in ("use_foam", "use_velocity", "use_normal"):
        column.prop(ob.libocean, name)
    column.prop(settings, "use_wetness")
    if settings.use_wetness and not meshes.is_ours(settings.land):
        say(layout, tr_label("Wet ground has no effect: it needs Land, a mesh"), "ERROR")
    _draw_parameters(layout, ob.libocean, sea_panels.FOAM)
    layout.operator(trees.AddTrees.bl_idname, icon="OUTLINER_OB_POINTCLOUD")


@PANELS.add("coast_bake", "Bake")
def bake_panel(layout, ob, context) -> None:
    """The coast as files, which play without the add-on"""
    sea_panels.draw_bake(layout, ob, context.scene)


CLASSES = tuple(PANELS.classes)

register, unregister = registration.functions(CLASSES)
