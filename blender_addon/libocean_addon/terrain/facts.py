# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Facts about the terrain of an object, for its panel: heights, slopes, sizes, warnings, and
settings that do something else than they seem to. A panel does not wait for a terrain to get them.
"""

from __future__ import annotations

from ..shared import drafts, meshes, subject_panel
from ..shared.compat import tr_label
from . import node_group
from .extent import ExtentError
from .open_terrain import OpenTerrain, terrain_of
from .parameter_values import is_placed
from .parameters import WORDS


def _state(ob, terrain: OpenTerrain) -> dict:
    """Returns the state of the terrain; while a draft is shown, the last known one."""
    before = terrain.state_before
    if terrain.state is None and before is not None and drafts.is_draft(ob.name_full):
        return before
    return terrain.read_state()


def _metres(value: float) -> str:
    return f"{value:.4g} m" if value < 1e4 else f"{value / 1e3:.4g} km"


def state_of(ob) -> list[tuple[str, str]] | None:
    """Returns labels and texts that describe the terrain of an object; None without a terrain."""
    terrain = terrain_of(ob.name_full)
    if terrain.handle is None:
        return None
    state = _state(ob, terrain)
    middle, _, steep = (angle["resolved"] for angle in state["slope_angles"])
    return [
        ("RMS height", _metres(state["rms"]["resolved"])),
        ("Median slope", f"{middle:.1f}\u00b0"),
        ("Steepest 1 %", f"{steep:.1f}\u00b0"),
        ("Shortest wave", _metres(state["shortest_wave"])),
    ]


def sizes_of(ob) -> list[str]:
    """Returns vertices and samples, in words."""
    lines = []
    if ob.type == "MESH":
        lines.append(tr_label("Mesh: {:,} vertices", len(ob.data.vertices)))
    terrain = terrain_of(ob.name_full)
    if terrain.handle is None:
        return lines
    try:
        extent = terrain.extent
    except ExtentError:  # said above
        return lines
    megabytes = 16e-6 * extent.count * (1 + len(terrain.groups))
    lines.append(tr_label("Map: {} x {} samples, {:,.0f} MB", *extent.samples, megabytes))
    made_for = meshes.samples_of(ob.data)
    if made_for is not None and made_for < terrain.size:
        less = (terrain.size // made_for) ** 2
        lines.append(tr_label("The mesh shows one in {} of their samples", less))
    return lines


def warnings_of(ob) -> list[str]:
    """Returns the library's warnings about the terrain of an object."""
    terrain = terrain_of(ob.name_full)
    if terrain.handle is None:
        return []
    layers = len(terrain.values.layers)
    return [WORDS.in_words(text, layers) for text in _state(ob, terrain)["warnings"]]


# Hints --------------------------------------------------------------------------


def _of_scale(ob) -> str:
    scale = subject_panel.uniform_scale(ob)
    if scale is None:
        return tr_label("The object is scaled unevenly, and so are its slopes: apply the scale")
    if scale != 1.0:
        return tr_label("The object is scaled by {:.3g}, and so is its land", scale)
    return ""


def _of_mask(ob, seen) -> str:
    mask = ob.libocean_terrain.mask
    if not subject_panel.lacks_mask(ob, seen, mask):
        return ""
    return tr_label("{} is no vertex group or attribute: the land is flat", mask)


def _of_camera(ob, scene) -> str:
    """Cameras of a new scene see some hundred metres."""
    camera = scene.camera
    if camera is None or camera.type != "CAMERA":
        return ""
    settings = ob.libocean_terrain
    if camera.data.clip_end >= 0.5 * settings.patch_size:
        return ""
    return tr_label("The camera sees {:.0f} m far: raise its Clip End", camera.data.clip_end)


def _of_tiles(settings) -> str:
    most = meshes.most_samples(settings.tiles)
    is_plain = settings.shape == "TILE" and not (settings.use_lod or settings.use_region)
    if not is_plain or is_placed(settings) or settings.mesh_resolution <= most:
        return ""
    return tr_label(
        "{} tiles have at most {} vertices along each, not {}",
        settings.tiles,
        most,
        settings.mesh_resolution,
    )


def _of_detail(settings) -> str:
    is_used = settings.shape == "TILE" and settings.use_lod
    if not is_used or not (settings.mask or settings.follow_world):
        return ""
    return tr_label("Mask and Anchor to the world have no effect with Level of Detail")


def hints_of(ob, seen, scene) -> list[str]:
    """Returns warnings about settings. seen: the object, evaluated."""
    settings = ob.libocean_terrain
    said = [_of_scale(ob), _of_mask(ob, seen), _of_camera(ob, scene)]
    said += [_of_tiles(settings), _of_detail(settings)]
    if len(node_group.modifiers(ob)) > 1:
        said.append(tr_label("Two terrain modifiers raise the mesh twice"))
    return [text for text in said if text]
