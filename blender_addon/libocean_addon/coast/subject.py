# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The row of the coast: its parameters are those of a sea."""

from __future__ import annotations

from ..bake import baked
from ..sea.subject import PARAMETERS
from ..shared.compat import tr
from ..shared.subject import Subject
from . import coast_bake, floats, live, node_group, open_coast

COAST = Subject(
    name="coast",
    family=node_group.FAMILY,
    settings="libocean_coast",
    parameters=PARAMETERS,
    listens=("coast", "sea"),
    taken=lambda: tr("The active object has a coast"),
    opened=open_coast.COASTS,
    image_inputs=node_group.image_inputs,
    follow=live.follow,
    picture=live.CoastPicture,
    job=live.job,
    has_water=True,
    float_pose=floats.float_pose,
    bake=coast_bake.CoastBake,
    show_played=lambda shown: baked.show_detail(shown.ob),
    before_change=live.before_change,
    parts=lambda ob: [ob, ob.libocean_coast.land, ob.libocean_coast.far_water],
)
