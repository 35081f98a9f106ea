# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Hints about an object's sea before a user wonders: settings that do something else than they seem
to.
"""

from __future__ import annotations

import math

import bpy

from ..look import detail
from ..shared import compat, meshes, subject_panel
from ..shared.compat import tr, tr_label
from . import facts, node_group, open_sea


def _of_scale(ob) -> str:
    scale = subject_panel.uniform_scale(ob)
    if scale is None:
        return tr_label("The object is scaled unevenly, and so are its waves: apply the scale")
    if scale != 1.0:
        return tr_label("The object is scaled by {:.3g}, and so are its waves", scale)
    return ""


def _of_mask(ob, seen) -> str:
    mask = ob.libocean.mask
    if not subject_panel.lacks_mask(ob, seen, mask):
        return ""
    return tr_label("{} is no vertex group or attribute: the sea stands still", mask)


def _of_limits(ob) -> str:
    share = facts.share_within_limits(ob)
    if share is None or share > 0.995:  # which a whole number of percent does not show
        return ""
    return tr_label("The limits of the wavelength leave {:.0%} of the wave height", share)


def _of_denoiser(scene) -> str:
    if scene.render.engine != "CYCLES" or not compat.denoises_without_denoiser(scene):
        return ""
    return tr_label(
        "Cycles is built without a denoiser here, as in Debian's package blender, and will not "
        "render: switch off Denoise in Render > Sampling"
    )


def _of_detail(settings) -> str:
    if not settings.use_detail or detail.is_wanted(settings):
        return ""
    return tr_label("Near detail has no effect: it needs Foam and Normal")


def spacing(ob, seen) -> float | None:
    """Metres between the vertices of a mesh that is the user's own, about; None for others."""
    if ob.libocean.kind != "MESH" or ob.type != "MESH" or not len(seen.data.polygons):
        return None
    width, depth, _ = sorted(ob.dimensions, reverse=True)
    return math.sqrt(width * depth / len(seen.data.polygons))


def is_too_coarse(ob, seen) -> bool:
    """Returns whether waves pass between the vertices: a wave needs at least two."""
    between, wave = spacing(ob, seen), facts.peak_wavelength(ob)
    return between is not None and wave is not None and between > wave / 2.0


def of_object(ob, seen) -> list[str]:
    """Warnings. seen: as evaluated."""
    denoiser = _of_denoiser(bpy.context.scene)
    said = [_of_scale(ob), _of_mask(ob, seen), _of_limits(ob), _of_detail(ob.libocean), denoiser]
    if len(node_group.modifiers(ob)) > 1:
        said.append(tr_label("Two ocean modifiers show the same sea, and their waves add up"))
    if is_too_coarse(ob, seen):
        text = tr_label(
            "{:.0f} m between vertices are too far for waves of {:.0f} m",
            spacing(ob, seen),
            facts.peak_wavelength(ob),
        )
        said.append(text)
    return [text for text in said if text]


def subdivisions(ob, seen) -> int:
    """How often a coarse mesh is to be divided for the samples of its maps, or as many vertices as
    a patch has by itself; 0 for one that has them."""
    sea = open_sea.sea_of(ob.name_full)
    samples = facts.map_resolution(ob) or meshes.AUTOMATIC
    wanted = float(sea.values.values["patch_size"]) / samples
    most = math.log(meshes.AUTOMATIC**2 / len(seen.data.polygons), 4.0)
    return max(0, min(math.ceil(math.log2(spacing(ob, seen) / wanted)), math.floor(most), 11))


class Subdivide(bpy.types.Operator):
    """Divide the faces before the sea moves them, until they are as fine as its maps: by a
    modifier that can be changed and removed"""

    bl_idname = "libocean.subdivide"
    bl_label = "Subdivide for Waves"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context) -> bool:
        ob = context.object
        if ob is not None and ob.type == "MESH" and node_group.modifiers(ob):
            return True
        cls.poll_message_set(tr("The active object is no mesh with an ocean"))
        return False

    def execute(self, context):
        ob = context.object
        seen = ob.evaluated_get(context.evaluated_depsgraph_get())
        if spacing(ob, seen) is None or facts.map_resolution(ob) is None:
            self.report({"ERROR"}, tr("The active object is no mesh with an ocean"))
            return {"CANCELLED"}
        levels = subdivisions(ob, seen)
        if levels == 0:
            self.report({"ERROR"}, tr("The mesh already has the vertices that its maps need"))
            return {"CANCELLED"}
        modifier = ob.modifiers.new("Subdivide for Waves", "SUBSURF")
        modifier.subdivision_type = "SIMPLE"
        modifier.levels = modifier.render_levels = levels
        first = ob.modifiers.find(node_group.modifiers(ob)[0].name)
        with context.temp_override(object=ob):
            bpy.ops.object.modifier_move_to_index(modifier=modifier.name, index=first)
        return {"FINISHED"}


CLASSES = (Subdivide,)

register, unregister = bpy.utils.register_classes_factory(CLASSES)
