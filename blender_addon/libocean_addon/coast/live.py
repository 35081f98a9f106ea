# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How an object shows a coast: images and inputs of its modifiers, and its two meshes.

    sea (evaluated: keyframes and drivers count) + time -> libocean -> float images -> nodes
                                                                    -> heights of the bed -> land

shared/life.py calls it by the row in subject.py.
"""

from __future__ import annotations

from ..look import detail, water_shader
from ..sea import live as sea_live
from ..shared import console, drafts, meshes, modifier_groups
from ..shared.subject import Moment, Picture, Shown
from ..terrain.extent import Extent
from . import coast_bake, cusps, far_water, land, land_nodes, node_group
from .coast_job import CoastJob, View, quick_fields, region_of
from .node_group import BLANKS, DISPLACEMENT, WETNESS, grid_words
from .open_coast import OpenCoast
from .shore_mesh import Grid, steady_height


def follow(shown: Shown, _seen, _depsgraph) -> None:
    """Opens the coast of an object, if its values are the first."""
    if shown.opened.own is None:
        shown.opened.open()


def view_of(coast: OpenCoast, ob, seen, moment: Moment) -> View:
    """Returns the view of the coast of an object. seen: the object, evaluated or not."""
    at = sea_live.own_time(seen.libocean)
    if at is None:
        at = coast.time_of(moment.scene.frame_current_final)
    return View(at, region_of(seen.libocean_coast), node_group.wanted_fields(ob, seen))


def _images_of(ob, modifier, fields) -> dict:
    """Returns the images of a modifier by their inputs, made where they are missing."""
    found = {}
    for name in fields:
        owner = land_nodes.require(ob.libocean_coast.land) if name == WETNESS else modifier
        found[name] = modifier_groups.image(owner, name, ob.name, BLANKS[name])
    return found


class CoastPicture(Picture):
    """The maps of a region at a time."""

    work = "water"
    # The job has the handle, and takes longer than frames that pass.
    begins_while_playing = False

    def prepare(self) -> None:
        self.view = view_of(self.opened, self.ob, self.seen, self.moment)
        self.key = self.opened.key(self.view)
        self.fields = self.view.fields
        """The inputs that are in use."""
        self.extent: Extent | None = None
        """The samples of the images."""

    def is_ready(self) -> bool:
        return self.opened.is_ready(self.view)

    def show_draft(self) -> None:
        quick = quick_fields(self.view.fields)
        image_named = _images_of(self.ob, self.modifier, quick)
        whole = self.view.region.extent(self.opened.own)
        self.extent = self.opened.show_draft(self.view, image_named) or whole
        if not self.opened.is_whole(image_named[DISPLACEMENT]):
            self.fields = quick

    def show_whole(self) -> None:
        image_named = _images_of(self.ob, self.modifier, self.view.fields)
        self.extent = self.opened.show(self.view, image_named)

    def needs_mesh(self) -> bool:
        return False  # set_inputs makes it, also with a draft

    def set_inputs(self, *, draft: bool) -> None:
        if drafts.is_main_thread():
            _follow_meshes(self.ob, self.opened, self.view.region.extent(self.opened.own))
        _wet_land(self.ob, self.opened, WETNESS in self.view.fields)
        inputs = node_group.water_inputs(self.ob, self.extent, self.fields)
        modifier_groups.assign(self.modifier, inputs)
        if not draft:
            self._show_detail()

    def _show_detail(self) -> None:
        coast, settings = self.opened, self.seen.libocean
        if detail.is_wanted(settings) and detail.waters(self.ob):
            coast.open_sea.follow(coast.values.without_bed())
        with console.work(self.ob.name_full, "near detail"):
            detail.follow(self.ob, coast.open_sea, settings, self.view.time, None, over_bed=True)


def _wet_land(ob, coast: OpenCoast, is_wet: bool) -> None:
    """Sets all inputs of the land's modifier but the image, or removes the modifier."""
    ground = ob.libocean_coast.land
    if not meshes.is_ours(ground):
        return
    modifier = land_nodes.modifier_of(ground)
    image = modifier_groups.value(modifier, WETNESS) if modifier is not None else None
    if not is_wet:
        land_nodes.follow(ground, None)
    elif image is not None and coast.extent_in(image) is not None:
        land_nodes.follow(ground, coast.extent_in(image))


def before_change(shown: Shown) -> bool:
    """Follows a change between live and baked. Returns True: modifiers may have changed."""
    if coast_bake.follow(shown.ob):
        drafts.forget(shown.ob.name_full, (), more_follows=False)
    return True


def _follow_meshes(ob, coast: OpenCoast, extent: Extent) -> None:
    """Makes the grid of the water, and the land as soon as its heights are known. Linked meshes
    stay as their file has them."""
    bed, wave_height = coast.bed(extent), 0.0
    if ob.libocean_coast.use_fine_shore:
        wave_height = steady_height(coast.state["significant_wave_height"]["resolved"])
    grid = Grid(extent, bed, wave_height)
    found = cusps.Cusps.of(grid, coast.state) if ob.libocean_coast.use_cusps else None
    if ob.library is None and ob.data.library is None and ob.mode == "OBJECT":
        words = grid_words(extent) + grid.fine_words + ("" if found is None else found.words)

        def make_numbers() -> dict:
            return {} if found is None else {water_shader.CUSP: found.at(grid)[0]}

        meshes.follow_plane(ob, words, lambda: (grid.places, *grid.faces), make_numbers)
    if bed is not None:
        with console.work(ob.name_full, "land"):
            land.follow(ob.libocean_coast.land, grid, land.run_up(coast.state), found)
        far_water.follow(ob.libocean_coast.far_water, extent, coast.state)


def job(shown: Shown) -> CoastJob | None:
    """Returns the job that makes the whole of an object; None without a coast."""
    coast = shown.opened
    if coast.own is None:
        return None
    return coast.job(view_of(coast, shown.ob, shown.ob, Moment.of_change()))
