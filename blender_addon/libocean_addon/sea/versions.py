# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of earlier versions of the add-on keep what they meant."""

from __future__ import annotations

import json

from ..bake import baked
from ..shared import changes, meshes, resolutions
from . import crests, parameter_values


def upgrade(ob) -> None:
    """Rewrites the settings of an object for today's version; leaves settings of today
    unchanged."""
    if ob.library is not None:
        return
    settings = ob.libocean
    with changes.quiet():
        if settings.crest_values:
            values = parameter_values.values_of(settings)
            values.crests = json.loads(settings.crest_values)
            crests.assign(settings, values)
            settings.crest_values = ""
        parameter_values.switch_on_given(settings)
        # Numbers that no list has, which the library refused.
        for name in ("viewport_resolution", "render_resolution"):
            setattr(settings, name, resolutions.nearest(getattr(settings, name)))
        # A patch had a vertex on each sample of its maps, up to 1024 a side.
        side = meshes.samples_of(ob.data)
        if settings.mesh_resolution == 0 and side is not None and side > meshes.AUTOMATIC:
            settings.mesh_resolution = side
    baked.upgrade(ob)
