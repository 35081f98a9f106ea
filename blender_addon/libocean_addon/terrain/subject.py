# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The row of the terrain."""

from __future__ import annotations

from ..shared.compat import tr
from ..shared.native import libocean
from ..shared.subject import Parameters, Subject
from . import live, node_group, open_terrain, parameter_values, terrain_text
from .parameters import WORDS

PARAMETERS = Parameters(
    settings="libocean_terrain",
    items="layers",
    words=WORDS,
    parse=libocean.parse_terrain,
    open_file=libocean.open_terrain,
    preset=libocean.terrain_preset,
    read=terrain_text.read,
    values_of=lambda ob, _scene: parameter_values.values_of(ob.libocean_terrain),
    assign=lambda ob, values: parameter_values.assign(ob.libocean_terrain, values),
)
TERRAIN = Subject(
    name="terrain",
    family=node_group.FAMILY,
    settings="libocean_terrain",
    parameters=PARAMETERS,
    listens=("terrain",),
    taken=lambda: tr("The active object has a terrain"),
    opened=open_terrain.TERRAINS,
    image_inputs=node_group.image_inputs,
    follow=live.follow,
    picture=live.TerrainPicture,
    job=live.job,
    follow_mesh=live.follow_mesh,
    after_change=live.keep_spectrum,
    sees_camera=live.sees_camera,
)
