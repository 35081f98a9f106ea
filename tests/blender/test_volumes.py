# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Volumes: the command and Blender's own module make the same grids, of the sea that is shown, and
an object plays them."""

import os
import re
import shlex
import subprocess
import threading
from pathlib import Path
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from conftest import evaluated_mesh, failing, keyed, positions, save
from libocean_addon.bundled import libocean
from libocean_addon.legacy import ocean_command
from libocean_addon.shared import compat
from libocean_addon.volumes import volume_job, volumes
from mathutils import Vector

OPENVDB = compat.load_openvdb()
needs_openvdb = pytest.mark.skipif(OPENVDB is None, reason="this Blender has no OpenVDB module")
needs_ocean = pytest.mark.skipif("OCEAN" not in os.environ, reason="OCEAN is not set")
COMMAND = str(Path(os.environ.get("OCEAN", "")).resolve())
SEAS = {
    "sea": {},
    "pool": {"depth": 1.5, "patch_size": 8.0},
    "folded": {"choppiness": 4.0},
}


@pytest.fixture
def by(monkeypatch):
    """Chooses what writes."""

    def choose(way: str) -> None:
        command = ocean_command.Command(COMMAND) if way == "command" else None
        module = OPENVDB if way == "module" else None
        monkeypatch.setattr(volumes, "find_command", lambda: command)
        monkeypatch.setattr(compat, "load_openvdb", lambda: module)

    return choose


@pytest.fixture(
    params=[pytest.param("command", marks=needs_ocean), pytest.param("module", marks=needs_openvdb)]
)
def way(request, by) -> str:
    by(request.param)
    return request.param


@pytest.fixture
def sea(scene, shot, tmp_path):
    """A small sea in a saved file, its shot of four frames."""
    scene.frame_start, scene.frame_end = 2, 5
    shot.libocean.patch_size = 100.0
    save(tmp_path / "shot.blend")
    return shot


def write(**arguments) -> None:
    assert bpy.ops.libocean.write_volumes(**arguments) == {"FINISHED"}


def refused(**arguments) -> str:
    return failing(bpy.ops.libocean.write_volumes, **arguments)


def files(folder: Path) -> list[Path]:
    return sorted(path for path in folder.iterdir() if path.suffix != ".json")


def numbers(folder: Path) -> list[int]:
    return [int(path.stem[-4:]) for path in files(folder)]


def times(folder: Path) -> dict[str, int]:
    return {path.name: path.stat().st_mtime_ns for path in folder.glob("*.vdb")}


def dense(grid) -> tuple[np.ndarray, np.ndarray]:
    """All values from two voxels before the first active one, and where that is."""
    low, high = (np.array(end) for end in grid.evalActiveVoxelBoundingBox())
    size = high - low + 5
    vector = not isinstance(grid.background, float)
    values = np.empty((*size, 3) if vector else size, np.float32)
    grid.copyToArray(values, ijk=tuple(int(i) for i in low - 2))
    return values, low - 2


def volume_objects() -> list:
    return [ob for ob in bpy.data.objects if ob.type == "VOLUME"]


def open_sea(path: Path):
    """The sea that a file names, and its time."""
    strings = volume_job.read_header(path)
    return libocean.parse(strings["ocean:sea"]), float(strings["ocean:time"])


# The grids ----------------------------------------------------------------------


def test_frames_that_are_keyed_or_at_their_own_time(scene, sea, way, tmp_path):
    settings = sea.libocean
    keyed(settings, choppiness={2: 0.0, 5: 1.0}, custom_time={2: 30.0, 5: 7.0})
    settings.use_custom_time = True
    write()
    assert scene.frame_current == 1
    folder = tmp_path / "ocean_volumes"
    for frame in (2, 3, 5):
        scene.frame_set(frame)
        seen = sea.evaluated_get(bpy.context.evaluated_depsgraph_get()).libocean
        opened, time = open_sea(folder / f"shot.Ocean_{frame:04d}.vdb")
        with opened as asked:
            assert time == pytest.approx(seen.custom_time)
            assert float(asked.get("choppiness")) == pytest.approx(seen.choppiness)


@needs_openvdb
@needs_ocean
@pytest.mark.parametrize("name", SEAS)
@pytest.mark.parametrize("use_half", [False, True])
def test_both_ways_make_the_same_volume(sea, by, name, use_half, tmp_path, capfd):
    for key, value in SEAS[name].items():
        setattr(sea.libocean, key, value)
    asked = sea.libocean.volumes
    asked.use_half, asked.box = use_half, "PERIOD" if name == "folded" else "CORNERS"
    asked.box_low, asked.box_high = (1.3, -2.0, -4.7), (7.1, 6.0, 20.0)
    asked.voxel, asked.velocity_voxel = (0.1, 0.25) if name == "pool" else (0.4, 0.7)
    found = []
    for way in ("command", "module"):
        by(way)
        write(frame_start=4, frame_end=4, directory=str(tmp_path / way))
        assert ("crests have folded over" in capfd.readouterr().out) == (name == "folded")
        path = tmp_path / way / "shot.Ocean_0004.vdb"
        found.append((volume_job.read_header(path), *OPENVDB.readAll(str(path))[0]))
    (said, *theirs), (ours_said, *ours) = found
    theirs, ours = (sorted(grids, key=lambda grid: grid.name) for grids in (theirs, ours))
    assert said == ours_said
    assert said["ocean:voxel"] == ("0.1" if name == "pool" else "0.4")
    assert [grid.name for grid in ours] == ["surface", "vel"]
    for one, other in zip(theirs, ours, strict=True):
        assert (other.name, other.gridClass, other.vectorType, other.background) == (
            one.name, one.gridClass, one.vectorType, one.background,
        )  # fmt: skip
        assert other.transform.voxelSize() == one.transform.voxelSize()
        assert abs(other.activeVoxelCount() - one.activeVoxelCount()) <= 20
        (a, low), (b, our_low) = dense(one), dense(other)
        assert list(low) == list(our_low)
        error = 2e-3 if use_half else 3e-6
        assert a.shape == b.shape
        assert abs(a - b).max() <= error * max(1.0, abs(a).max())
    surface, velocity = ours
    assert surface.gridClass == "level set"
    assert velocity.vectorType == "contravariant relative"
    assert [grid.saveFloatAsHalf for grid in ours] == [use_half] * 2
    values, _ = dense(surface)
    assert values[0].min() > 0
    assert values.min() == -surface.background


# The box ------------------------------------------------------------------------


@needs_openvdb
def test_the_box_is_that_of_ocean_bake_unless_chosen(sea, way, tmp_path):
    write(frame_start=2, frame_end=2)
    path = tmp_path / "ocean_volumes" / "shot.Ocean_0002.vdb"
    opened, _ = open_sea(path)
    with opened as asked:
        period = float(asked.get("patch_size"))
        wave_height = asked.state["significant_wave_height"]["asked"]
    box = volume_job.read_header(path)["ocean:box"].split(",")
    assert box[-1] == "crest"
    expected = [0.0, 0.0, -max(4.0, 2.0 * wave_height), period, period]
    assert [float(side) for side in box[:-1]] == pytest.approx(expected)
    assert wave_height > 2.0
    sea.libocean.use_depth, sea.libocean.depth = True, 3.0
    write(frame_start=2, frame_end=2)
    assert float(volume_job.read_header(path)["ocean:box"].split(",")[2]) == -3.0


class Cliff:
    """A sea that falls from 9 m to -7 m, as columns do where a crest has folded over."""

    def samples(self, points, time, *, resolution):
        high = points[:, 0] < 11.8
        normal = np.tile([0.0, 0.0, 1.0], (len(points), 1))
        height = np.where(high, 9.0, -7.0)
        return SimpleNamespace(height=height, normal=normal, folded=np.zeros(len(points), bool))


@needs_openvdb
def test_the_module_leaves_no_hole_in_a_cliff():
    settings = volume_job.Settings((0.0, 0.0, -20.0), (24.0, 6.0, 30.0), 0.5, 1.0, False, 64)
    columns = volume_job._Columns(Cliff(), 0.0, settings, threading.Event(), 0.5, volume_job.BAND)
    known = volume_job._make_surface(OPENVDB, columns).getConstAccessor()
    changes = 0
    for i in range(-2, 50):
        for k in range(-42, 24):
            value, is_active = known.probeValue((i, 6, k))
            for beside in ((i + 1, 6, k), (i, 6, k + 1)):
                other, is_too = known.probeValue(beside)
                if (value < 0) != (other < 0):
                    changes += 1
                    assert is_active and is_too, (i, k)
    assert changes > 100


@pytest.mark.parametrize("kind", ["EMPTY", "MESH"])
def test_an_object_is_the_box(sea, way, kind, tmp_path):
    sea.location.z, sea.rotation_euler.z = 10.0, 0.7
    if kind == "EMPTY":
        box = bpy.data.objects.new("Box", None)
        box.empty_display_size, box.scale = 2.0, (2.0, 1.0, 1.5)
        bpy.context.collection.objects.link(box)
    else:
        bpy.ops.mesh.primitive_cube_add(size=4.0, scale=(2.0, 1.0, 1.5))
        box = bpy.context.object
        bpy.context.view_layer.objects.active = sea
    box.location = (50.0, 20.0, 9.5)
    bpy.context.view_layer.update()
    asked = sea.libocean.volumes
    asked.box, asked.box_object = "OBJECT", box
    write(frame_start=2, frame_end=2)
    header = volume_job.read_header(tmp_path / "ocean_volumes" / "shot.Ocean_0002.vdb")
    sides = [float(side) for side in header["ocean:box"].split(",")]
    assert sides == pytest.approx([46.0, 18.0, -3.5, 54.0, 22.0, 2.5])
    asked.box_object = None
    assert "choose one" in refused()
    asked.box, asked.box_low = "CORNERS", (0.0, 0.0, 11.0)
    assert "box is empty" in refused()


def test_a_box_in_the_air_is_told(sea, way, capfd):
    asked = sea.libocean.volumes
    asked.box, asked.box_low, asked.box_high = "CORNERS", (0, 0, 30), (40, 40, 40)
    write(frame_start=2, frame_end=2)
    assert "no water reaches the box" in capfd.readouterr().out


# The object ---------------------------------------------------------------------


def played(volume, frame: int):
    bpy.context.scene.frame_set(frame)
    return volume.evaluated_get(bpy.context.evaluated_depsgraph_get()).data


def test_an_object_plays_them(sea, way, tmp_path):
    before = set(bpy.data.objects)
    write()
    (volume,) = set(bpy.data.objects) - before
    assert bpy.context.object == sea
    assert volume.type == "VOLUME"
    assert volume.users_collection == sea.users_collection
    data = volume.data
    assert data.is_sequence
    assert (data.velocity_grid, data.velocity_unit) == ("vel", "SECOND")
    for frame in (2, 3, 5):
        seen = played(volume, frame)
        assert Path(seen.grids.frame_filepath).name == f"shot.Ocean_{frame:04d}.vdb"
        seen.grids.load()
        kinds = {grid.name: grid.data_type for grid in seen.grids}
        assert kinds == {"surface": "FLOAT", "vel": "VECTOR_FLOAT"}
    assert not played(volume, 6).grids.frame_filepath  # there is no water of
    write(frame_start=4, frame_end=7)
    assert volume_objects() == [volume]
    assert Path(played(volume, 7).grids.frame_filepath).name == "shot.Ocean_0007.vdb"
    write(directory=str(tmp_path / "elsewhere"), use_import=False)
    assert volume_objects() == [volume]
    assert numbers(tmp_path / "elsewhere") == [2, 3, 4, 5]


def heights_of(volume, places: np.ndarray) -> list[float]:
    """Returns the heights of the mesh that Blender makes of the level set, above places of the
    world."""
    ob = bpy.data.objects.new("Meshed", bpy.data.meshes.new("Meshed"))
    bpy.context.collection.objects.link(ob)
    ob.matrix_world = volume.matrix_world
    modifier = ob.modifiers.new("Meshed", "VOLUME_TO_MESH")
    modifier.object, modifier.grid_name, modifier.threshold = volume, "surface", 0.0
    modifier.resolution_mode = "GRID"
    depsgraph = bpy.context.evaluated_depsgraph_get()
    to_own = ob.matrix_world.inverted()
    down = to_own.to_3x3() @ Vector((0.0, 0.0, -1.0))
    heights = []
    # Volume to Mesh put voxels where their corners are.
    half = 0.25 if bpy.app.version < (5, 0) else 0.0
    half = ob.matrix_world.to_3x3() @ Vector((half, half, half))
    for x, y, _ in places:
        above = to_own @ (Vector((x, y, 50.0)) + half)
        is_hit, hit, *_ = ob.evaluated_get(depsgraph).ray_cast(above, down)
        assert is_hit
        heights.append((ob.matrix_world @ hit - half).z)
    bpy.data.objects.remove(ob)
    return heights


@pytest.mark.parametrize("moved", ["risen", "own"])
def test_it_lies_where_the_sea_is_and_shows_what_was_written_last(scene, sea, way, moved, capfd):
    scene.frame_set(3)
    scene.frame_end = 3
    sea.libocean.volumes.voxel = 0.5
    sea.location = (-20.0, 0.0, 7.0)
    if moved == "own":
        sea.libocean.follow_world = False
        sea.location.x, sea.rotation_euler.z = 40.0, 0.5
    for seed in (1, 2):
        sea.libocean.seed = seed
        write()
        told = "Blender shows the previous files" in capfd.readouterr().out
        assert told == (seed == 2 and compat.READS_VOLUMES_ONCE)
        if told:
            break
        (volume,) = volume_objects()
        bpy.context.view_layer.update()
        world = positions(sea) @ np.array(sea.matrix_world.to_3x3()).T + sea.location
        places = volumes.sea_to_world(sea).inverted()
        middle = [p for p in world if all(20 < x < 60 for x in (places @ Vector(p)).xy)][::12]
        assert len(middle) > 10
        shown = heights_of(volume, middle)
        assert shown == pytest.approx([p[2] for p in middle], abs=0.1)
        assert np.std(shown) > 0.2


# Again --------------------------------------------------------------------------


def test_what_is_there_is_kept(sea, way, tmp_path):
    folder = tmp_path / "ocean_volumes"
    write()
    before = times(folder)
    assert numbers(folder) == [2, 3, 4, 5]
    write()
    assert times(folder) == before
    whole = (folder / "shot.Ocean_0003.vdb").read_bytes()
    for size in (0, 10, 60, 4000, len(whole) // 2, len(whole) - 1):
        (folder / "shot.Ocean_0003.vdb").write_bytes(whole[:size])
        write()
        assert volume_job.read_header(folder / "shot.Ocean_0003.vdb")
        assert len((folder / "shot.Ocean_0003.vdb").read_bytes()) == len(whole)
    after = times(folder)
    assert {name for name in after if after[name] != before[name]} == {"shot.Ocean_0003.vdb"}
    changes = {"voxel": 5.0, "velocity_voxel": 20.0, "use_half": True}
    for name, value in changes.items():
        setattr(sea.libocean.volumes, name, value)
        write(frame_start=2, frame_end=2)
        assert times(folder)["shot.Ocean_0002.vdb"] != after["shot.Ocean_0002.vdb"], name
        after = times(folder)
    sea.libocean.seed = 7
    write(frame_start=2, frame_end=2)
    assert times(folder)["shot.Ocean_0002.vdb"] != after["shot.Ocean_0002.vdb"]
    after = times(folder)
    write(frame_start=2, frame_end=2, overwrite=True)
    assert times(folder)["shot.Ocean_0002.vdb"] != after["shot.Ocean_0002.vdb"]


@needs_openvdb
@needs_ocean
def test_what_the_one_way_wrote_the_other_keeps(sea, by, tmp_path):
    for way in ("command", "module"):
        by(way)
        write(directory=str(tmp_path / way))
        before = times(tmp_path / way)
        by("module" if way == "command" else "command")
        write(directory=str(tmp_path / way))
        assert times(tmp_path / way) == before


def begun(sea, folder: Path, shot: tuple[int, int]):
    return volumes.Volumes(bpy.context, sea, str(folder), shot, overwrite=False, shows=True)


def test_stopped_between_frames_it_goes_on_from_there(sea, way, tmp_path):
    folder = tmp_path / "ocean_volumes"
    job = begun(sea, folder, (2, 5)).job
    job.run(lambda: job.stop.set() if job.done == 2 else None)
    assert (job.done, job.failure) == (2, None)
    before = times(folder)
    assert numbers(folder) == [2, 3]
    write()
    after = times(folder)
    assert len(after) == 4
    assert {name: after[name] for name in before} == before


def test_stopped_in_a_frame_it_leaves_whole_files_only(sea, way, tmp_path):
    folder = tmp_path / "ocean_volumes"
    sea.libocean.volumes.voxel = 0.15
    job = begun(sea, folder, (2, 200)).job
    thread = threading.Thread(target=job.run)
    thread.start()
    while thread.is_alive() and job.done < 1:
        thread.join(0.005)
    thread.join(0.05)  # on with the next
    job.stop.set()
    thread.join(30.0)
    assert not thread.is_alive()
    assert job.failure is None
    assert 1 <= job.done < 20
    assert len(files(folder)) == job.done  # nothing half, nothing hidden
    for path in files(folder):
        assert volume_job.read_header(path)
    assert not volume_objects()


@needs_openvdb
def test_a_write_that_fails_leaves_nothing(sea, by, tmp_path, monkeypatch):
    """A disk that fills up, of which OpenVDB says nothing."""

    class CutOff:
        def __getattr__(self, name):
            return getattr(OPENVDB, name)

        def write(self, path, *what):
            OPENVDB.write(path, *what)
            os.truncate(path, os.path.getsize(path) - 100)

    by("module")
    monkeypatch.setattr(compat, "load_openvdb", lambda: CutOff())
    assert "is the disk full?" in refused()
    assert files(tmp_path / "ocean_volumes") == []


# Why not ------------------------------------------------------------------------


def test_with_neither_the_command_lines_are_told(sea, by, tmp_path):
    by("neither")
    asked = sea.libocean.volumes
    asked.velocity_voxel = 12.5
    keyed(sea.libocean, choppiness={2: 0.0, 3: 1.0})
    said = refused()
    assert "no OpenVDB module" in said
    lines = re.findall("ocean bake .*", said)
    assert len(lines) == 2  # frames 3 to 5 are of one sea
    assert "--velocity-voxel=12.5" in lines[0]
    folder = tmp_path / "ocean_volumes"
    if "OCEAN" not in os.environ:
        return
    for line in lines:
        program, *arguments = shlex.split(line)
        subprocess.run([COMMAND, *arguments], cwd="/", check=True, capture_output=True)
    before = times(folder)
    assert len(before) == 4
    by("command")
    write()
    assert times(folder) == before


@needs_ocean
def test_the_command_is_that_of_the_preferences_or_of_the_system(sea, tmp_path, monkeypatch):
    preferences = bpy.context.preferences.addons["libocean_addon"].preferences
    monkeypatch.setenv("PATH", str(tmp_path))
    assert volumes.find_command() is None
    (tmp_path / "ocean").symlink_to("/bin/true")  # of somebody else
    assert volumes.find_command() is None
    (tmp_path / "ocean").unlink()
    (tmp_path / "ocean").symlink_to(COMMAND)
    assert volumes.find_command().path == str(tmp_path / "ocean")
    preferences.ocean_command = COMMAND
    assert volumes.find_command().path == COMMAND
    preferences.ocean_command = "/bin/true"
    monkeypatch.setattr(compat, "load_openvdb", lambda: None)
    assert "/bin/true, of the preferences, is no command that writes volumes" in refused()


@needs_openvdb
def test_blenders_own_module_comes_before_any_command(sea, monkeypatch, tmp_path):
    def find():
        raise AssertionError("a command was looked for")

    monkeypatch.setattr(volumes, "find_command", find)
    write(frame_start=2, frame_end=2)
    assert numbers(tmp_path / "ocean_volumes") == [2]


def test_the_extension_runs_no_command(sea, monkeypatch):
    """It has no legacy/: what is left is the sentence, whatever the system has."""
    monkeypatch.setattr(compat, "load_openvdb", lambda: None)
    monkeypatch.setattr(volumes, "ocean_command", None)
    monkeypatch.setenv("PATH", os.path.dirname(COMMAND))
    assert "no OpenVDB module" in refused()


def test_what_cannot_be_is_told(sea, way, tmp_path):
    assert "comes before the first" in refused(frame_start=5, frame_end=3)
    (tmp_path / "file").write_text("")
    assert "cannot be made" in refused(directory=str(tmp_path / "file" / "folder"))
    sea.libocean.shortest_wavelength, sea.libocean.longest_wavelength = 50.0, 10.0
    assert "Longest wavelength = 10 m: must be more" in refused()
    sea.libocean.longest_wavelength = 0.0
    sea.libocean.volumes.voxel = 1e-4
    assert re.search("memory|too many", refused())
    assert not list(tmp_path.glob("ocean_volumes/*.vdb"))
    assert not volume_objects()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.preferences.addon_enable(module="libocean_addon")
    bpy.ops.libocean.add(kind="PATCH", preset="beaufort_6")
    assert "Save the blend file first" in refused()
    assert evaluated_mesh(bpy.context.object)
