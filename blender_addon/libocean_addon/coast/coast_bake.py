# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bake of a coast: its region as image files, which the water and the wet ground play without
the add-on.

    frames (number, seconds, sea file), extent -> library -> fields of the region -> EXR files
    record -> image sequences -> inputs of the baked node groups
"""

from __future__ import annotations

import dataclasses

from ..bake import bake_job, bake_plan, bake_record, baked, exr_files
from ..look import detail, detail_tiles
from ..sea import sea_text
from ..shared import meshes, modifier_groups
from ..shared.native import libocean
from ..terrain.extent import Extent, ExtentError
from . import land_nodes, node_group
from .bed_sea import extent_of
from .coast_job import region_of
from .node_group import CHANNELS, FILES, WETNESS


@dataclasses.dataclass(kw_only=True)
class RegionJob(bake_job.FieldsJob):
    """Frames that become the fields of a region as EXR files."""

    extent: Extent

    def _bake(self, sea, resolved: str, frame: bake_job.Frame) -> bool:
        if self.done == 0:
            self._begin(sea, resolved, frame)
        extent = self.extent
        provenance = exr_files.Provenance(sea, frame.number, frame.time, 0, extent)

        def make(missing: list[str]):
            where = (extent.origin, extent.samples, extent.cell)
            return sea.region(frame.time, *where, missing, axes=exr_files.AXES)

        return self._write_missing(provenance, make)

    def _detail(self, sea, time: float):
        text = sea_text.read(sea).without_bed().text()
        with libocean.parse(text, base_dir=self.base_dir) as open_sea:
            return open_sea.detail(time, samples=detail_tiles.SAMPLES)


class CoastBake(bake_plan.Bake):
    """The bake of a coast, until the object plays it."""

    modifiers = staticmethod(node_group.modifiers)

    def _look(self, ob, sea) -> None:
        state = sea.state
        if "bed" not in state:
            raise bake_plan.BakeError(ob.libocean_coast.problem)
        origin = sea.get("seabed_origin")
        try:
            self.extent = region_of(ob.libocean_coast).extent(extent_of(origin, state))
        except ExtentError as failure:
            raise bake_plan.BakeError(str(failure)) from failure

    def _make_job(self, ob, **settings) -> RegionJob:
        return RegionJob(**settings, extent=self.extent)

    def _follow(self, ob) -> None:
        follow(ob)

    def _note(self, record) -> None:
        record.extent = bake_record.extent_words(self.extent)


# Playing ------------------------------------------------------------------------


def _change(modifier, group) -> None:
    """Gives a modifier another node group, and removes the old one's images unless they are in use
    elsewhere."""
    names = node_group.image_inputs(modifier.node_group)
    images = {modifier_groups.value(modifier, name) for name in names} - {None}
    modifier_groups.assign(modifier, dict.fromkeys(names))
    modifier.node_group = group
    baked.remove_unused(images)


def _play(ob, modifier, files: list[str]) -> None:
    """Has a modifier play the files of these fields, as far as the bake of the record has them."""
    record, place = ob.libocean.bake, bake_record.place_of(ob)
    known = record.fields.split(",")
    images = {
        node_group.image_of(file): baked.sequence(ob, place, file) if file in known else None
        for file in files
    }
    frames = {"First": float(record.first), "Last": float(record.last)}
    frames["Frame Length"] = record.frame_length
    modifier_groups.assign(modifier, {**images, **frames})


def _follow_water(ob, is_playing: bool) -> None:
    for modifier in node_group.modifiers(ob):
        if modifier_groups.is_baked(modifier.node_group) != is_playing:
            _change(modifier, node_group.get(baked=is_playing))
            detail.clear(ob)
        if is_playing:
            record = ob.libocean.bake
            files = [file for name in CHANNELS if name != WETNESS for file in FILES[name]]
            _play(ob, modifier, files)
            known = record.fields.split(",")
            fields = [name for name in node_group.wanted_fields(ob) if FILES[name][0] in known]
            extent = bake_record.extent_of(record.extent)
            modifier_groups.assign(modifier, node_group.water_inputs(ob, extent, fields))


def _follow_land(ob, is_playing: bool) -> None:
    ground = ob.libocean_coast.land
    if not meshes.is_ours(ground):
        return
    modifier = land_nodes.modifier_of(ground)
    has_files = is_playing and "wetness" in ob.libocean.bake.fields.split(",")
    if not ob.libocean_coast.use_wetness or (is_playing and not has_files):
        land_nodes.follow(ground, None)
    elif has_files or modifier is not None:
        modifier = land_nodes.require(ground)
        if modifier_groups.is_baked(modifier.node_group) != is_playing:
            _change(modifier, land_nodes.get(baked=is_playing))
        if is_playing:
            _play(ob, modifier, list(FILES[WETNESS]))
            land_nodes.follow(ground, bake_record.extent_of(ob.libocean.bake.extent))


def follow(ob) -> bool:
    """Brings a coast in line with `use_bake` and its settings. Returns whether it plays a bake."""
    settings = ob.libocean
    is_playing = settings.use_bake and bool(settings.bake.extent) and bake_record.exists(ob)
    if bake_record.shown_image(ob) is not None:
        settings.bake.folder = bake_record.place_of(ob).folder
    was_playing = bool(bake_record.playing(ob))
    _follow_water(ob, is_playing)
    _follow_land(ob, is_playing)
    if is_playing and not was_playing:
        ob.libocean_coast.problem = " ".join(bake_record.fault_texts(ob, bake_record.faults(ob)))
    return is_playing
