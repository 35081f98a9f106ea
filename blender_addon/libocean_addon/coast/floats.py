# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How bodies lie on the water of a coast, from the handle that its maps come from.

place in the axes of the coast -> bed there -> pose, or the reason why nothing floats there
"""

from __future__ import annotations

from ..sea import live as sea_live
from ..shared.compat import tr_label
from ..shared.failures import NotReadyError, NotShownError
from ..terrain.extent import Extent
from . import live
from .coast_job import Bed
from .open_coast import coast_of


def _height_of_bed(bed: Bed, extent: Extent, place: tuple[float, float]) -> float | None:
    """Returns the height of the bed at a place, linear between its samples [m]; None beyond
    them."""
    cells, parts = [], []
    for axis in range(2):
        along = (place[axis] - extent.origin[axis]) / extent.cell
        if not 0.0 <= along <= extent.samples[axis] - 1:
            return None
        cell = min(int(along), extent.samples[axis] - 2)
        cells.append(cell)
        parts.append(along - cell)
    (i, j), (u, v) = cells, parts
    low, high = (row[i] + u * (row[i + 1] - row[i]) for row in bed.heights[j : j + 2])
    return float(low + v * (high - low))


def require_water(name: str, bed: Bed, extent: Extent, place: tuple[float, float]) -> None:
    """Raises NotShownError where the bed lies above still water, or is not shown. name: of the
    coast."""
    height = _height_of_bed(bed, extent, place)
    where = (*place, name)
    if height is None:
        raise NotShownError(tr_label("At {:.1f}, {:.1f} m {} shows no water", *where))
    if height >= 0.0:
        text = tr_label("At {:.1f}, {:.1f} m {} is dry land, {:.1f} m over water", *where, height)
        raise NotShownError(text)


def float_pose(ob, body: tuple[float, ...], moment):
    """Returns the libocean.FloatPose of one body. Raises NotReadyError while the coast is in the
    making and the moment does not wait for it, NotShownError and libocean.Error."""
    coast = coast_of(ob.name_full)
    coast.follow(sea_live.current_values(ob.libocean, moment.scene))
    if moment.moving and not coast.is_cheap():
        raise NotReadyError
    view = live.view_of(coast, ob.original, ob, moment)
    with coast.lock:
        coast.open()
        extent = view.region.extent(coast.own)
        require_water(ob.name, coast.require_bed(extent), extent, body[:2])
        return coast.sea.float_pose([body], view.time)
