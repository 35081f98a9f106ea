# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Facts about the coast of an object, for its panel: heights, sizes, warnings. A panel does not
wait for a coast to get them."""

from __future__ import annotations

from ..sea import messages
from ..shared.compat import tr_label
from ..terrain.extent import ExtentError
from .coast_job import region_of
from .open_coast import coast_of


def state_of(ob) -> list[tuple[str, str]] | None:
    """Returns labels and texts that describe the coast of an object; None without a coast."""
    state = coast_of(ob.name_full).state
    if state is None:
        return None
    return [
        ("Wave height", f"{state['significant_wave_height']['resolved']:.2f} m"),
        ("Peak period", f"{state['peak_period']['resolved']:.1f} s"),
    ]


def samples_of(ob) -> tuple[int, int] | None:
    """Returns columns and rows of the region; None before they are known."""
    own = coast_of(ob.name_full).own
    try:
        return None if own is None else region_of(ob.libocean_coast).extent(own).samples
    except ExtentError:  # said by the panel
        return None


def sizes_of(ob) -> list[str]:
    """Returns vertices and samples, in words."""
    coast = coast_of(ob.name_full)
    if coast.state is None:
        return []
    settings = ob.libocean
    try:
        extent = region_of(ob.libocean_coast).extent(coast.own)
    except ExtentError:  # said above
        return []
    fields = 1 + settings.use_velocity + settings.use_normal + settings.use_foam
    megabytes = 16e-6 * extent.count * fields
    bed = coast.state["bed"]
    return [
        tr_label("Bed: {:.4g} to {:.4g} m", bed["lowest"], bed["highest"]),
        tr_label("Map: {} x {} samples, {:,.0f} MB", *extent.samples, megabytes),
        tr_label("Cell: {:.3g} m", extent.cell),
    ]


def warnings_of(ob) -> list[str]:
    """Returns the library's warnings about the coast of an object."""
    state = coast_of(ob.name_full).state
    if state is None:
        return []
    systems = len(ob.libocean.waves)
    return [messages.in_words(text, systems) for text in state["warnings"]]
