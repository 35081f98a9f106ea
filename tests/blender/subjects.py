# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The subjects as test_life.py sees them: how each is added, changed and made slow, and what the
library says of it. A new subject joins by a class here, a row in SHOWN and one in SLOW."""

import bpy
import numpy as np
import test_land
import test_terrain
import toy_subject
from conftest import add_ocean, attribute, evaluated_mesh, positions, shot_of
from libocean_addon.bundled import libocean
from libocean_addon.coast.coast_job import CoastJob
from libocean_addon.coast.open_coast import OpenCoast
from libocean_addon.sea import live
from libocean_addon.sea.open_sea import OpenSea
from libocean_addon.sea.sea_job import SeaJob
from libocean_addon.shared import drafts, modifier_groups, subject
from libocean_addon.terrain import node_group, open_terrain
from test_coast import (
    CELL,
    COLUMNS,
    ROWS,
    SEA,
    add_coast,
    assert_is_bed,
    assert_is_region,
    write_bed,
)
from test_coast_wetness import assert_is_wet
from test_subject import assert_is_slope
from test_surface import assert_patch


def to(path: str, value):
    """Returns a change: gives a property of an object a value."""
    owner, _, key = path.rpartition(".")
    return lambda ob: setattr(ob.path_resolve(owner), key, value)


class Case:
    """A subject. A class of its own has the values below, `add` and `assert_is_library`."""

    name = ""  # of its objects
    settings = ""  # the attribute of an object with `problem`
    job: type  # the class of its jobs
    word = ""  # in the console
    status = ""  # the beginning of the line about its work
    parameter = ""  # the path of a parameter
    label = "Resolution"  # of that parameter
    attributes: tuple[str, ...] = ()  # that a mesh may have
    moves = False
    last_field = ""  # of the files of a bake
    samples = (64, 64)  # of its maps
    has_detail = False
    saver = ""  # the operator that writes its file
    command = ()  # options with which `ocean bake` bakes the same
    tolerance, unlike = 0.0, {}  # of that: of its values, of its headers
    without = {"positions": ("", "position")}  # what the add-on is not needed for: object and value
    steps = {}  # changes, by name
    mark = None  # a change that files keep
    of_copy = ()  # changes of a copy
    of_override = ()  # changes of a library override
    keyed = ()  # a path, and its values at the frames 1 and 11
    driven = ""  # a path
    bad = {}  # texts of files, by words of the sentence that refuses them
    loaders = ()  # operators that read files
    refused = ()  # a change that the library refuses, the change back, words of the sentence

    def __str__(self) -> str:
        return type(self).__name__

    def add(self, folder):
        """Returns a new object; its files lie in the folder."""
        raise NotImplementedError

    def assert_is_library(self, ob) -> None:
        """Asserts that an object shows what the library says of its values and the frame."""
        raise NotImplementedError

    def linked(self, shown):
        """Returns the part of what an object shows that it shows as linked data too."""
        return shown

    def found(self):
        return bpy.data.objects[self.name]

    def problem(self, ob) -> str:
        return getattr(ob, self.settings).problem

    def row(self, ob):
        return next(row for row in subject.rows if row.family.modifiers(ob))

    def values(self, ob):
        """Returns the values of an object's file."""
        return self.row(ob).parameters.values_of(ob, bpy.context.scene)

    def save(self, path) -> None:
        assert getattr(bpy.ops.libocean, self.saver)(filepath=str(path)) == {"FINISHED"}

    def shown(self, ob) -> dict[str, np.ndarray]:
        """Returns all that an object shows."""
        there = evaluated_mesh(ob).attributes
        found = {name: attribute(ob, name) for name in self.attributes if name in there}
        return {"positions": positions(ob), **found}

    def change(self, ob, number: int) -> None:
        """Makes one of many changes whose whole takes long after make_slow()."""
        raise NotImplementedError

    def make_slow(self, patch) -> None:
        """Has a whole take longer than a user waits."""
        raise NotImplementedError

    def assert_is_draft(self, ob, before) -> None:
        """Asserts that an object shows a draft. before: what it showed, which may stay."""
        assert same(self.shown(ob), before)

    def film(self, ob, scene) -> float:
        """Has frames of a render show a surface that moves; returns its min relief [m]."""
        raise NotImplementedError

    def prepare_bake(self, ob) -> None:
        """Has an object show all that its bake can have."""


def same(one: dict[str, np.ndarray], other: dict[str, np.ndarray]) -> bool:
    return one.keys() == other.keys() and all(np.array_equal(one[key], other[key]) for key in one)


def image_side(ob, name: str) -> int:
    return modifier_groups.value(ob.modifiers[0], name).size[0]


class Sea(Case):
    name, settings, job, word = "Ocean", "libocean", SeaJob, "sea"
    status, parameter = "Ocean: foam ", "grid.resolution"
    moves, last_field, saver, has_detail = True, "cover", "save_sea", True
    without = {"positions": ("Ocean", "position"), "foam": ("Ocean", "foam")}
    attributes = ("foam", "cover", "label", "velocity", "ocean_velocity", "ocean_normal")
    attributes += ("jacobian",)
    steps = {
        "seed": to("libocean.seed", 7),
        "size": to("libocean.patch_size", 100.0),
        "waves": lambda _: bpy.ops.libocean.add_waves(),
        "mesh": to("libocean.mesh_resolution", 32),
        "foam": to("libocean.foam_lifetime", 1.0),
    }
    mark = staticmethod(steps["foam"])
    of_copy = (to("libocean.seed", 2), to("libocean.patch_size", 100.0))
    of_override = (to("libocean.seed", 9),)
    keyed = ("libocean.choppiness", 0.0, 1.0)
    loaders, bad = ("load_sea",), {"patch_size": "libocean = 1\n[grid]\npatch_size = -3\n"}
    driven = "libocean.waves[0].wind_direction"
    refused = (
        to("libocean.waves[0].spectrum", "measured"),
        to("libocean.waves[0].spectrum", "jonswap"),
        ("needs a file",),
    )

    def __init__(self, foam_lifetime: float = 0.0) -> None:
        """The past of foam takes ten times as long as all else."""
        self.foam_lifetime = foam_lifetime

    def add(self, folder):
        values = {"foam_coverage": "threshold", "foam_threshold": 0.9, "patch_size": 200.0}
        values["foam_lifetime"] = self.foam_lifetime
        return add_ocean(64, sea=values, kind="PATCH", preset="beaufort_6", use_material=False)

    def assert_is_library(self, ob) -> None:
        scene = bpy.context.scene
        with libocean.parse(live.current_values(ob.libocean, scene).text()) as sea:
            assert_patch(ob, sea, sea.time_of_frame(scene.frame_current))

    def change(self, ob, number: int) -> None:
        ob.libocean.seed = 10 + number

    def make_slow(self, patch) -> None:
        def is_ready(sea, at, size, channel) -> bool:
            return sea.ready == (sea.changes, size, channel, at)

        patch.setattr(OpenSea, "is_ready", is_ready)
        patch.setattr(drafts, "_FIRST", 32)
        patch.setattr(drafts.Pace, "note", lambda *_: None)

    def assert_is_draft(self, ob, before) -> None:
        assert image_side(ob, "Displacement") == 32
        assert not same(self.shown(ob), before)

    def film(self, ob, scene) -> float:
        shot_of(scene, ob)
        return 0.5


class Coast(Case):
    name, settings, job, word = "Water", "libocean_coast", CoastJob, "coast"
    status, parameter = "Water: ", "grid.resolution"
    moves, last_field, saver, samples = True, "wetness", "save_coast", (COLUMNS, ROWS)
    command = ("--region", f"10,20,{10 + CELL * (COLUMNS - 1):g},{20 + CELL * (ROWS - 1):g}")
    command = (*command, "--cell", f"{CELL:g}")
    tolerance, unlike = 1e-5, {"compression": ""}
    without = {"positions": ("Water", "position"), "wetness": ("Land", "shore_wetness")}
    attributes = ("foam", "cover", "jacobian", "ocean_velocity", "ocean_normal")
    attributes += ("breaking", "depth")
    steps = {
        "wind": to("libocean.waves[0].wind_speed", 6.0),
        "level": to("libocean.level", 0.5),
        "cell": to("libocean_coast.cell", 8.0),
        "clip": to("libocean_coast.use_clip", True),
        "wetness": to("libocean_coast.use_wetness", True),
    }
    mark = staticmethod(steps["wetness"])
    of_copy = (steps["wind"],)
    of_override = (steps["wind"], to("libocean_coast.use_wetness", False))
    bad = {
        "no bed": "libocean = 1\n[grid]\nresolution = 64\n",
        "patch_size": "libocean = 1\n[grid]\npatch_size = -3\n",
        "no such file": 'libocean = 1\n[water]\nseabed = "gone.asc"\n',
        "libocean": "",
    }
    loaders = ("add_coast", "load_coast")
    keyed = ("libocean.waves[0].wind_speed", 6.0, 9.0)
    driven = "libocean.waves[0].wind_direction"
    refused = (
        to("libocean.waves[0].wind_speed", 0.0),
        to("libocean.waves[0].wind_speed", 8.0),
        ("no waves",),
    )

    def __init__(self, *, is_wet: bool = False) -> None:
        self.is_wet = is_wet

    def add(self, folder):
        write_bed(folder)
        (folder / "sea.toml").write_text(SEA)
        ob = add_coast(folder / "sea.toml")
        ob.libocean_coast.use_clip = False
        ob.libocean_coast.use_wetness = self.is_wet
        return ob

    def shown(self, ob) -> dict[str, np.ndarray]:
        land = ob.libocean_coast.land
        found = {**super().shown(ob), "land": positions(land)}
        if "shore_wetness" in evaluated_mesh(land).attributes:
            found["wetness"] = attribute(land, "shore_wetness")
        return found

    def linked(self, shown):
        """A linked land stays as its file has it, dry."""
        return {name: values for name, values in shown.items() if name != "wetness"}

    def assert_is_library(self, ob) -> None:
        assert_is_region(ob)
        assert_is_bed(ob, ob.libocean.level)
        if ob.libocean_coast.use_wetness:
            assert_is_wet(ob, bpy.context.scene.frame_current)

    def change(self, ob, number: int) -> None:
        ob.libocean.waves[0].wind_speed = 6.0 + 0.5 * number

    def make_slow(self, patch) -> None:
        ready = OpenCoast.is_ready

        def is_ready(coast, view) -> bool:
            return coast._filled == coast.key(view) and ready(coast, view)

        patch.setattr(OpenCoast, "is_ready", is_ready)

    def film(self, ob, scene) -> float:
        ob.libocean_coast.land.hide_render = True
        shot_of(scene, ob, (60.0, 80.0, 50.0), 60.0)
        return 0.1

    def prepare_bake(self, ob) -> None:
        ob.libocean_coast.use_clip = ob.libocean_coast.use_wetness = True


class Tile(Case):
    name, settings, word = "Terrain", "libocean_terrain", "terrain"
    job, status, parameter = open_terrain.TerrainJob, "Terrain: ", "terrain.resolution"
    attributes = ("wear",)
    steps = {
        "parameter": to("libocean_terrain.beta", 1.7),
        "resolution": to("libocean_terrain.resolution", 128),
        "size": to("libocean_terrain.patch_size", 300.0),
        "tiles": to("libocean_terrain.tiles", 2),
        "preset": lambda _: bpy.ops.libocean.load_terrain_preset(preset="jacksboro"),
        "break": lambda _: bpy.ops.libocean.add_break(),
        "layer": lambda _: bpy.ops.libocean.add_terrain_layer(),
    }
    mark = staticmethod(steps["break"])
    of_copy = (to("libocean_terrain.seed", 5), to("libocean_terrain.patch_size", 128.0))
    of_override = (
        to("libocean_terrain.seed", 9),
        to("libocean_terrain.use_rms", True),
        to("libocean_terrain.rms", 3.0),
    )
    bad = {
        "beta": "libocean = 1\n[terrain]\nbeta = 9\n",
        "sea": "libocean = 1\n[grid]\n",
        "hills": "libocean = 1\n[terrain]\nhills = 3\n",
        "libocean": "",
    }
    loaders, saver = ("load_terrain",), "save_terrain"
    keyed = ("libocean_terrain.beta", 1.5, 2.5)
    driven = "libocean_terrain.mean"
    refused = (
        to("libocean_terrain.breaks", [20.0, 2.0, 90.0, 2.5, *[0.0] * 12]),
        to("libocean_terrain.breaks", [0.0] * 16),
        ("Breaks", "longest"),
    )

    def __init__(self, samples: int = 64) -> None:
        self.samples = samples

    def add(self, folder):
        return test_terrain.add_terrain(self.samples)

    def assert_is_library(self, ob) -> None:
        test_terrain.assert_is_land(ob)

    def change(self, ob, number: int) -> None:
        ob.libocean_terrain.beta = 1.9 - 0.05 * number

    def make_slow(self, patch) -> None:
        patch.setattr(open_terrain.OpenTerrain, "is_quick", lambda _: False)
        patch.setattr(drafts, "_FIRST", self.samples // 2)
        patch.setattr(drafts.Pace, "note", lambda *_: None)

    def assert_is_draft(self, ob, before) -> None:
        """Nearly the same land: the rms counts the waves that the draft lacks."""
        assert image_side(ob, node_group.GROUND) == self.samples // 2
        with test_terrain.library_of(ob) as terrain:
            want = test_terrain.on_samples(terrain.surface().height)
        assert np.std(positions(ob)[:, 2] - want) < 0.1 * want.std()


def set_region(ob) -> None:
    settings = ob.libocean_terrain
    settings.region_cell, settings.region = 2.0, (0.0, 600.0, 100.0, 700.0)
    settings.use_region = True


class Land(Tile):
    text = test_land.PLACED
    bad = {"libocean": ""}
    loaders = ("add_terrain_file", "load_terrain")
    steps = {
        "gullies": to("libocean_terrain.use_gullies", True),
        "region": set_region,
        "origin": to("libocean_terrain.origin", (10.0, 20.0)),
        "tile": to("libocean_terrain.kind", "tile"),
        "detail": to("libocean_terrain.use_lod", True),
        "file": lambda _: bpy.ops.libocean.load_terrain_preset(preset="seed_smooth"),
    }
    mark = staticmethod(steps["gullies"])
    of_copy = (set_region, steps["gullies"])
    of_override = (to("libocean_terrain.gullies_depth", 0.1),)
    keyed = ("libocean_terrain.island", 30.0, 90.0)
    refused = (
        to("libocean_terrain.base", "//gone.asc"),
        to("libocean_terrain.base", ""),
        ("gone.asc",),
    )

    def add(self, folder):
        return test_land.add_land(folder, self.text)

    def assert_is_library(self, ob) -> None:
        settings = ob.libocean_terrain
        if settings.use_region:
            want = test_land.region_of(ob, settings.region, settings.region_cell)
            assert np.array_equal(positions(ob)[:, 2], want)
        else:
            test_land.assert_is_land(ob)

    def film(self, ob, scene) -> float:
        """The mesh lies around a camera that moves."""
        eye = shot_of(scene, ob, (0.0, 1024.0, 64.0), 500.0)
        eye.data.clip_end = 1e5
        for frame, x in ((1, 0.0), (2, 1024.0)):
            eye.location.x = x
            eye.keyframe_insert("location", frame=frame)
        ob.libocean_terrain.lod_spacing, ob.libocean_terrain.use_lod = 2.0, True
        return 1.0


class CarvedLand(Land):
    """Its drafts take long too."""

    text = test_land.CARVED
    assert_is_draft = Case.assert_is_draft

    def change(self, ob, number: int) -> None:
        ob.libocean_terrain.stream_seed = 2 + number

    def make_slow(self, patch) -> None:
        super().make_slow(patch)
        patch.setattr(open_terrain, "_SLOW_DRAFT", -1.0)


class Toy(Case):
    """The subject of toy_subject.py, while that is registered."""

    name, settings, job, word = "Toy", "libocean_toy", toy_subject.ToyJob, "toy"
    status, parameter, label = "Toy", "toy.slope", "Slope"
    steps = {"slope": to("libocean_toy.slope", 5.0)}
    mark = staticmethod(to("libocean_toy.slope", 3.0))
    of_copy = (to("libocean_toy.slope", 1.0),)
    keyed = ("libocean_toy.slope", 2.0, 4.0)
    refused = (
        to("libocean_toy.slope", 11.0),
        to("libocean_toy.slope", 1.0),
        ("Slope is too steep",),
    )

    def add(self, folder):
        ob = toy_subject.add()
        ob.select_set(True)
        return ob

    def assert_is_library(self, ob) -> None:
        assert_is_slope(ob, ob.libocean_toy.slope)

    def change(self, ob, number: int) -> None:
        ob.libocean_toy.slope = 3.0 + number

    def make_slow(self, patch) -> None:
        is_ready = property(lambda toy: toy.ready == toy.changes)
        patch.setattr(toy_subject.OpenToy, "is_ready", is_ready)

    def assert_is_draft(self, ob, before) -> None:
        assert_is_slope(ob, 0.0)


BAKED = (Sea(foam_lifetime=1.0), Coast())
SHOWN = (Sea(), Coast(), Tile(), Land(), Toy())
SLOW = (Sea(foam_lifetime=1.0), Coast(is_wet=True), Tile(256), CarvedLand(), Toy())
