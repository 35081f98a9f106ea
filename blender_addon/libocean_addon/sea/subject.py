# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The row of the sea."""

from __future__ import annotations

from ..bake import bake_plan, baked
from ..shared.compat import tr
from ..shared.native import libocean
from ..shared.subject import Parameters, Subject
from . import (
    crests,
    live,
    messages,
    node_group,
    open_sea,
    parameter_values,
    sea_text,
    versions,
)


class _Parameters(Parameters):
    def sentence(self, ob, failure: Exception) -> str:
        return crests.in_words(ob, super().sentence(ob, failure))


PARAMETERS = _Parameters(
    settings="libocean",
    items="waves",
    words=messages.WORDS,
    parse=libocean.parse,
    open_file=libocean.open,
    preset=lambda name: libocean.preset(name),
    read=sea_text.read,
    values_of=lambda ob, scene: live.current_values(ob.libocean, scene),
    assign=lambda ob, values: parameter_values.assign(ob.libocean, values),
)
SEA = Subject(
    name="sea",
    family=node_group.FAMILY,
    settings="libocean",
    parameters=PARAMETERS,
    listens=("sea",),
    taken=lambda: tr("The active object has an ocean"),
    opened=open_sea.SEAS,
    image_inputs=node_group.image_inputs,
    picture=live.SeaPicture,
    job=live.job,
    follow_mesh=live.follow_mesh,
    has_water=True,
    float_pose=live.float_pose,
    is_in_world=lambda ob: ob.libocean.follow_world,
    bake=bake_plan.Bake,
    place=live.place,
    show_played=lambda shown: baked.show_detail(shown.ob),
    fault=live.fault_of,
    before_change=live.before_change,
    upgrade=versions.upgrade,
)
