# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels below the modifiers of an object with a sea: what it is, how it looks, its bake, its
volumes, and what few will need. Parameters come from the library's table; what does not apply is
not there.
"""

from __future__ import annotations

import bpy

from .. import translations, whole_sea
from ..bake import bake, bake_record, bake_state, farm
from ..look import material
from ..shared import drafts, parameter_fields, registration, resolutions, subject_panel
from ..shared.compat import tr_label
from ..shared.drawing import field, is_narrow, mask_field, place_labels, say
from ..spray import spray
from ..volumes import volumes
from . import facts, hints, node_group, operators, parameter_values, records
from .parameter_values import PARAMETERS

SHORT = {
    "wind_speed": "Wind",
    "wind_direction": "Direction",
    "peak_enhancement": "Enhancement",
    "significant_wave_height": "Wave height",
    "foam_coverage": "Coverage",
    "foam_resolution": "Foam map",
    "cutoff_wavelength": "Cut-off",
    "cascade_divisors": "Divisors",
    "shortest_wavelength": "Shortest wave",
    "longest_wavelength": "Longest wave",
    "viewport_resolution": "Viewport",
    "render_resolution": "Render",
    "mesh_resolution": "Mesh",
    "seabed_origin": "Bed origin",
    "seabed_unit": "Bed unit",
    "seabed_sign": "Bed sign",
    "surf_foam_lifetime": "Surf foam",
}
"""Short labels for fields whose label does not fit a panel of default width."""

# Parameters by the panel that shows them; every other one is in Advanced, or of a wave system in
# Spectrum.
WIND = ("wind_speed", "wind_direction", "significant_wave_height")
SEA = ("choppiness", "seed")
SPECTRUM = ("patch_size", "depth")
FOAM = ("foam_lifetime", "foam_coverage", "foam_threshold", "foam_width")
LOOK = ("resolution", *FOAM)
TIME = ("start", "first_frame", "fps", "loop_period", "take", "glide")

_ENTRIES = {entry["key"]: entry for entry in parameter_values.entries(waves=False)}
ADVANCED = tuple(key for key in _ENTRIES if key not in (*SEA, *SPECTRUM, *LOOK, *TIME))


def label_of(entry) -> str:
    return SHORT.get(entry["key"], entry["label"])


_ONLY_IF = {
    "cascade_divisors": lambda settings: settings.cascades > 1,
    **dict.fromkeys(FOAM, lambda settings: settings.use_foam),
    "foam_step": lambda settings: settings.use_foam,
    "foam_resolution": lambda settings: settings.use_foam,
    "fps": lambda settings: not settings.use_scene_frame_rate,
    "glide": lambda settings: bool(settings.take or settings.take_lines),
}


def is_used(group, entry) -> bool:
    """Returns whether a parameter applies, for example to the chosen spectrum."""
    chosen = {
        getattr(group, other["key"])
        for other in parameter_values.TABLE
        if other["section"] == entry["section"] and other["type"] == "enum"
    }
    condition = _ONLY_IF.get(entry["key"])
    if condition is not None and not condition(group):
        return False
    return "used_by" not in entry or not chosen.isdisjoint(entry["used_by"])


def draw_parameter(layout, group, entry) -> None:
    if not is_used(group, entry):
        return
    if entry["type"] == "list":
        _draw_divisors(layout.column(), group, label_of(entry))
    else:
        parameter_fields.draw(layout.column(), group, entry, PARAMETERS, label_of(entry))


def _draw_divisors(layout, settings, label: str) -> None:
    """As many as there are cascades, once they are not chosen by themselves."""
    layout.prop(settings, "use_cascade_divisors")
    if not settings.use_cascade_divisors:
        return
    column = layout.column(align=True)
    for number in range(min(settings.cascades, parameter_values.DIVISORS)):
        text = "" if number else label
        column.prop(
            settings, "cascade_divisors", index=number, text=text, text_ctxt=translations.SEA
        )


def _draw_parameters(layout, settings, keys) -> None:
    for key in keys:
        draw_parameter(layout, settings, _ENTRIES[key])


def _draw_map_size(layout, ob) -> None:
    """Draws the samples of the maps where several cascades need more than Resolution says."""
    own = facts.map_resolution(ob)
    if own is not None and own != ob.libocean.resolution:
        text = tr_label("{} cascades: maps of {} x {} samples", ob.libocean.cascades, own, own)
        say(layout, text, "INFO")


class WavesList(bpy.types.UIList):
    """The wave systems of a sea"""

    bl_idname = "LIBOCEAN_UL_waves"

    def draw_item(self, _context, layout, _data, item, _icon, _active, _property, index=0) -> None:
        row = layout.split(factor=0.12)
        row.label(text=str(index + 1), translate=False)
        row.prop(item, "spectrum", text="", emboss=False)
        if is_narrow():
            return
        wind = layout.row()
        wind.active = item.use_wind_speed
        wind.prop(item, "wind_speed", text="", emboss=False)


def draw_waves(layout, settings) -> None:
    """Draws the list of wave systems, with the buttons that add and remove one."""
    row = layout.row()
    row.template_list(WavesList.bl_idname, "", settings, "waves", settings, "active_wave", rows=2)
    column = row.column(align=True)
    column.operator(operators.AddWaves.bl_idname, text="", icon="ADD")
    column.operator(operators.RemoveWaves.bl_idname, text="", icon="REMOVE")


PANELS = subject_panel.Panels(node_group.modifiers, "libocean")


@PANELS.add("ocean", "Ocean (libocean)", closed=False)
def ocean_panel(layout, ob, context) -> None:
    """The sea of the active object"""
    subject_panel.draw_files(
        layout, operators.LoadSeaPreset, load=operators.LoadSea, save=operators.SaveSea
    )
    playing = ob.libocean.use_bake and bake_record.exists(ob)
    problems = bake_state.faults(ob) if playing else [ob.libocean.problem]
    units = tr_label("The sea takes a Blender unit for a metre")
    subject_panel.draw_problems(layout, context.scene, problems, units)
    share = drafts.progress(ob.name_full) or 0.0
    working = tr_label("A draft; the whole sea: {:.0%}", share)
    stopped = tr_label("A draft, without the past of its foam")
    whole_sea.draw_draft(layout, ob.name_full, working, stopped)
    subject_panel.draw_facts(layout, ob, facts)
    _draw_hints(layout, ob, ob.evaluated_get(context.view_layer.depsgraph))


def _draw_hints(layout, ob, seen) -> None:
    for text in hints.of_object(ob, seen):
        say(layout, text, "ERROR")
    if hints.is_too_coarse(ob, seen):
        layout.operator(hints.Subdivide.bl_idname, icon="MOD_SUBSURF")


def draw_sea(layout, ob) -> None:
    """Draws what an artist changes first: wind and height of the active wave system, the amount of
    foam, the shape of crests, the seed, near detail."""
    settings = ob.libocean
    if len(settings.waves) > 1:
        draw_waves(layout, settings)
    place_labels(layout)
    _draw_system(layout, settings, lambda key: key in WIND)
    for water in material.waters_of(ob):
        amount = water.inputs["Foam Amount"]
        layout.prop(amount, "default_value", text="Foam amount", text_ctxt=translations.SEA)
    _draw_parameters(layout, settings, SEA)
    column = layout.column()
    column.active = settings.use_foam and settings.use_normal
    column.prop(settings, "use_detail")


def draw_spectrum(layout, settings) -> None:
    """Draws the wave systems, and how each of them shares its energy out."""
    draw_waves(layout, settings)
    place_labels(layout)
    _draw_system(layout, settings, lambda key: key not in WIND)


def _draw_system(layout, settings, is_shown) -> None:
    """Draws parameters of the active wave system. is_shown(key): whether to draw one."""
    if settings.active_wave >= len(settings.waves):
        return
    system = settings.waves[settings.active_wave]
    for entry in parameter_values.entries(waves=True):
        if is_shown(entry["key"]):
            draw_parameter(layout, system, entry)


@PANELS.add("waves", "Sea", closed=False, labels=False)
def waves_panel(layout, ob, _context) -> None:
    """The sea as an artist changes it"""
    draw_sea(layout, ob)


@PANELS.add("spectrum", "Spectrum", labels=False)
def spectrum_panel(layout, ob, _context) -> None:
    """The wave systems of the sea with their spectra, and the water they run on"""
    settings = ob.libocean
    draw_spectrum(layout, settings)
    layout.operator(records.PickRecord.bl_idname, icon="FILE_FOLDER").filepath = ""
    layout.separator()
    _draw_parameters(layout, settings, SPECTRUM)


@PANELS.add("look", "Look")
def look_panel(layout, ob, context) -> None:
    """How the sea is shown"""
    settings = ob.libocean
    layout.operator_menu_enum(
        material.AddMaterial.bl_idname, "water_type", text="Material", icon="MATERIAL"
    )
    _draw_parameters(layout, settings, ("resolution",))
    _draw_map_size(layout, ob)
    names = ["viewport_resolution", "render_resolution"]
    if settings.kind == "PATCH":
        names.append("mesh_resolution")
    column = layout.column(align=True)
    for name in names:
        text, listed = SHORT[name], resolutions.listed(name)
        field(column, settings, listed, text=text, context=translations.SEA)
    if settings.kind == "HORIZON":
        layout.prop(settings, "horizon_distance")
        layout.prop(settings, "horizon_vertices")
    column = layout.column(heading="Attributes")
    for name in ("use_foam", "use_velocity", "use_normal"):
        column.prop(settings, name)
    _draw_parameters(layout, settings, FOAM)
    mask_field(layout, settings, ob)
    layout.prop(settings, "follow_world")


@PANELS.add("spray", "Spray", switch="use_spray")
def spray_panel(layout, ob, _context) -> None:
    """Drops that the wind tears off"""
    layout.active = ob.libocean.use_spray
    for name in ("lifetime", "density", "most", "size"):
        layout.prop(ob.libocean, f"spray_{name}")
    field(layout, ob.libocean, "spray_material")
    text, icon = spray.state_of(ob)
    say(layout, text, icon)


@PANELS.add("bake", "Bake")
def bake_panel(layout, ob, context) -> None:
    """The sea as files, which play without the add-on"""
    draw_bake(layout, ob, context.scene)


def draw_bake(layout, ob, scene) -> None:
    """Draws the bake of an ocean or a coast."""
    settings = ob.libocean
    place_labels(layout)
    if bake_record.exists(ob):
        layout.prop(settings, "use_bake")
    field(layout, settings.bake, "directory")
    layout.prop(settings.bake, "use_custom_range")
    if settings.bake.use_custom_range:
        column = layout.column(align=True)
        column.prop(settings.bake, "frame_start")
        column.prop(settings.bake, "frame_end", text="To", text_ctxt=translations.SEA)
    row = layout.row(align=True)
    row.operator(bake.BakeOcean.bl_idname, text="Bake", icon="RENDER_ANIMATION")
    if bake_record.exists(ob):
        row.operator(bake.FreeBake.bl_idname, text="Free")
        row.operator(bake.FreeBake.bl_idname, text="", icon="TRASH").delete_files = True
    layout.operator(farm.BakeOnFarm.bl_idname, text="Bake on a Farm...", icon="NETWORK_DRIVE")
    for text, icon in bake_state.state(ob, scene):
        say(layout, text, icon)


@PANELS.add("volumes", "Volumes")
def volumes_panel(layout, ob, context) -> None:
    """The water in a box as OpenVDB files"""
    settings = ob.libocean.volumes
    field(layout, settings, "directory")
    field(layout, settings, "box")
    if settings.box == "OBJECT":
        field(layout, settings, "box_object")
    elif settings.box == "CORNERS":
        layout.column(align=True).prop(settings, "box_low")
        layout.column(align=True).prop(settings, "box_high")
    column = layout.column(align=True)
    column.prop(settings, "voxel")
    column.prop(settings, "velocity_voxel")
    layout.prop(settings, "use_half")
    layout.operator(volumes.WriteVolumes.bl_idname, icon="VOLUME_DATA")
    for text, icon in bake_state.of_volumes(ob, context.scene):
        say(layout, text, icon)


@PANELS.add("advanced", "Advanced")
def advanced_panel(layout, ob, _context) -> None:
    """The time of the sea, and settings for experts"""
    settings = ob.libocean
    layout.prop(settings, "use_custom_time")
    if settings.use_custom_time:
        layout.prop(settings, "custom_time")
    layout.prop(settings, "use_scene_frame_rate")
    _draw_parameters(layout, settings, TIME)
    layout.separator()
    _draw_parameters(layout, settings, ADVANCED)
    _draw_map_size(layout, ob)


CLASSES = (WavesList, *PANELS.classes)

register, unregister = registration.functions(CLASSES)
