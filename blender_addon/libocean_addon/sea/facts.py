# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Facts about the sea of an object, for panels and hints: sizes, heights, periods, warnings. A
panel does not wait for a sea to get them."""

from __future__ import annotations

import math

from ..shared import drafts, meshes
from ..shared.compat import tr_label
from . import atlas, crests, live, messages
from .open_sea import OpenSea, sea_of


def map_resolution(ob) -> int | None:
    """Returns the default samples per side of an object's sea; None without a sea."""
    sea = sea_of(ob.name_full).handle
    return None if sea is None else sea.map_resolution()


def map_sizes(ob) -> tuple[int, int] | None:
    """Returns the samples per side of the maps in the viewport and in renders."""
    sea = sea_of(ob.name_full)
    return None if sea.handle is None else live.map_sizes(ob.libocean, sea)


def image_bytes(ob) -> int:
    """Returns the bytes of the images with the maps: in the viewport and, if the sizes differ, in
    renders."""
    settings, sizes = ob.libocean, set(map_sizes(ob))
    fields = 1 + settings.use_velocity + settings.use_normal
    if settings.kind == "HORIZON":
        samples = sum(size * size + math.prod(atlas.shape(size)) for size in sizes)
    else:
        samples = sum(size * size for size in sizes)
    return 16 * fields * samples


def cascade_divisors(ob) -> list[int]:
    """Returns the divisor of the period for each cascade of the shown sea."""
    sea = sea_of(ob.name_full).handle
    if sea is None:
        return [1]
    period = float(sea.get("patch_size"))
    return [round(period / of_cascade) for of_cascade in sea.cascade_periods]


def peak_wavelength(ob) -> float | None:
    """Returns the wavelength at the peak in deep water [m]; None without waves."""
    sea = sea_of(ob.name_full)
    period = None if sea.handle is None else _state(ob, sea)["peak_period"]["resolved"]
    if not period:
        return None
    return float(sea.values.values["gravity"]) * period**2 / (2.0 * math.pi)


def share_within_limits(ob) -> float | None:
    """Returns the share of the wave height that the limits of the wavelength leave; None without
    limits."""
    sea = sea_of(ob.name_full)
    if sea.handle is None or not sea.has_limits() or drafts.progress(ob.name_full) is not None:
        return None
    return sea.share_within_limits()


def _state(ob, sea: OpenSea) -> dict:
    """Returns the state of the sea; while a draft is shown, the last known one, so that a slider
    does not wait."""
    if sea.state is None and sea.state_before is not None and drafts.progress(ob.name_full) == 0.0:
        return sea.state_before
    return sea.read_state()


def sea_state(ob) -> dict | None:
    """Returns the state of an object's sea, as `ocean info` has it; None without a sea."""
    sea = sea_of(ob.name_full)
    return None if sea.handle is None else _state(ob, sea)


def state_of(ob) -> list[tuple[str, str]] | None:
    """Returns labels and texts that describe the sea of an object."""
    sea = sea_of(ob.name_full)
    if sea.handle is None:
        return None
    state = _state(ob, sea)

    def metres(value: float) -> str:
        return f"{value:.2f} m"

    return [
        ("Wave height", metres(state["significant_wave_height"]["resolved"])),
        ("Peak period", f"{state['peak_period']['resolved']:.1f} s"),
        ("Energy resolved", f"{state['energy_resolved']:.1%}"),
        ("Shortest wave", metres(state["map_shortest_wave"])),
    ]


def sizes_of(ob) -> list[str]:
    """Returns vertices and samples, in words."""
    lines = []
    if ob.type == "MESH":
        lines.append(tr_label("Mesh: {:,} vertices", len(ob.data.vertices)))
    sizes = map_sizes(ob)
    if sizes is None:
        return lines
    megabytes = image_bytes(ob) / 1e6
    text = tr_label("Maps: {} x {} samples, {:,.0f} MB", sizes[0], sizes[0], megabytes)
    if sizes[0] != sizes[1]:
        text = tr_label("Maps: {} and, rendered, {}, {:,.0f} MB", sizes[0], sizes[1], megabytes)
    lines.append(text)
    made_for = meshes.samples_of(ob.data)
    if made_for is not None and made_for < min(sizes) and ob.libocean.kind == "PATCH":
        lines.append(
            tr_label("The mesh shows one in {} of their samples", (sizes[0] // made_for) ** 2)
        )
    return lines


def warnings_of(ob) -> list[str]:
    """Returns the library's warnings about the sea of an object."""
    sea = sea_of(ob.name_full)
    if sea.handle is None:
        return []
    systems = len(sea.values.waves)
    found = [*_state(ob, sea)["warnings"], *sea.wakes.warnings(sea.values)]
    return [crests.in_words(ob, messages.in_words(text, systems)) for text in found]
