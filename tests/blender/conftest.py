# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A fresh Blender for each test, and values to compare its meshes with."""

import contextlib
import inspect
import json
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import bpy
import numpy as np
import other_blender
import pytest
from libocean_addon.shared import drafts


def pytest_configure(config):
    config.addinivalue_line("markers", "only_reads: needs no fresh Blender, half a second to make")
    config.addinivalue_line(
        "markers", "slow: for the stage bpy of scripts/test, not for each change"
    )


@pytest.fixture(autouse=True)
def empty_file(request):
    """Leaves neither data nor handlers nor preferences of the test before. Factory settings, which
    switch add-ons off, take ten times as long as a new file: they serve the first test, and one
    after a test that changed the preferences."""
    preferences = bpy.context.preferences
    is_on = "libocean_addon" in preferences.addons
    if is_on and request.node.get_closest_marker("only_reads"):
        return
    if is_on and not preferences.is_dirty:
        empty()
    else:
        factory_settings(use_empty=True)


def factory_settings(**settings) -> None:
    bpy.ops.wm.read_factory_settings(**settings)
    bpy.ops.preferences.addon_enable(module="libocean_addon")
    bpy.context.preferences.is_dirty = False


@pytest.fixture(scope="session", autouse=True)
def built_once(tmp_path_factory):
    """Building a node group takes Blender up to seconds, by the cube of its nodes: what the add-on
    built in one file is brought into the next ones from there."""
    from libocean_addon.look import foam_images, material, water_shader
    from libocean_addon.sea import node_group

    def has_foam() -> bool:  # a group of its own shows these images
        return any(foam_images.MARK in image for image in bpy.data.images)

    with pytest.MonkeyPatch.context() as patch:
        folder = tmp_path_factory.mktemp("built")
        patch.setattr(node_group, "get", once(node_group.get, folder))
        water = once(water_shader.get_group, folder, unless=has_foam)
        for module in (water_shader, material):
            patch.setattr(module, "get_group", water)
        yield


def once(get, folder: Path, unless=lambda: False):
    """`get`, which makes a node group where the file has none, but only for the first file."""
    made: dict[str, Path] = {}  # by name
    names: dict[tuple, str] = {}

    def found(*arguments, **settings):
        key = (*arguments, *settings.items())
        name = names.get(key)
        if name and name not in bpy.data.node_groups and not unless():
            with bpy.data.libraries.load(str(made[name])) as (_, into):
                into.node_groups = [name]
            bpy.data.libraries.remove(bpy.data.libraries[made[name].name])
        before = set(bpy.data.node_groups.keys())
        group = get(*arguments, **settings)
        if name is None and group.name not in before:
            names[key] = group.name
            made[group.name] = folder / f"{len(made)}_{group.name.strip('.')}.blend"
            bpy.data.libraries.write(str(made[group.name]), {group})
        return group

    return found


@pytest.fixture
def scene():
    return bpy.context.scene


@contextlib.contextmanager
def presets_with(**values):
    """Gives the seas that are added meanwhile these values from the start: a sea with fewer samples
    than its preset, or with foam without a past, is made in no time."""
    from libocean_addon.bundled import libocean

    whole = libocean.preset

    def preset(name: str):
        sea = whole(name)
        sea.set_all({key: str(value) for key, value in values.items()})
        return sea

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(libocean, "preset", preset)
        yield


# Of the foam, in tests that look at something else: hundreds of maps before the first one.
NO_PAST = {"foam_lifetime": 0}


def add_ocean(resolution: int, *, sea: dict | None = None, **arguments):
    """Adds an ocean with maps of so many samples and foam without a past. sea: other values than
    the preset has."""
    with presets_with(**{"resolution": resolution} | NO_PAST | (sea or {})):
        assert bpy.ops.libocean.add(**arguments) == {"FINISHED"}
    return bpy.context.object


def add_horizon(resolution: int, vertices: int, distance: float = 5000.0, **arguments):
    """Adds an ocean with a horizon of so few vertices from the start: the default has thirty times
    as many."""
    from libocean_addon.shared import changes

    ob = add_ocean(resolution, kind="PATCH", **arguments)
    with changes.quiet():
        ob.libocean.kind, ob.libocean.horizon_vertices = "HORIZON", vertices
    ob.libocean.horizon_distance = distance
    return ob


def sea_of(ob):
    """Returns the library's own sea of the values in an ocean's panel."""
    from libocean_addon.bundled import libocean
    from libocean_addon.sea import parameter_values

    return libocean.parse(parameter_values.values_of(ob.libocean).text())


def evaluated_mesh(ob):
    return ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).data


def positions(ob) -> np.ndarray:
    """(n, 3), as evaluated."""
    mesh = evaluated_mesh(ob)
    out = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", out)
    return out.reshape(-1, 3)


def rest(ob) -> np.ndarray:
    """(n, 3), of the mesh itself."""
    out = np.empty(3 * len(ob.data.vertices), np.float32)
    ob.data.vertices.foreach_get("co", out)
    return out.reshape(-1, 3)


def attribute(ob, name: str) -> np.ndarray:
    found = evaluated_mesh(ob).attributes[name]
    width = {"FLOAT": 1, "FLOAT_VECTOR": 3}[found.data_type]
    out = np.empty(width * len(found.data), np.float32)
    found.data.foreach_get("value" if width == 1 else "vector", out)
    return out.reshape(-1, width) if width > 1 else out


def plane(size: float, vertices: int, name: str = "Plane"):
    """A grid around the origin, active and selected."""
    bpy.ops.mesh.primitive_grid_add(
        x_subdivisions=vertices, y_subdivisions=vertices, size=size, location=(0, 0, 0)
    )
    bpy.context.object.name = name
    return bpy.context.object


needs_window = pytest.mark.skipif(
    not bpy.app.binary_path or not shutil.which("xvfb-run"), reason="no Blender with a window"
)


def start_another_blender(program, *arguments, size=(640, 480), **environment) -> subprocess.Popen:
    """Starts a function of other_blender.py in a Blender of its own, with factory settings, a
    generator in a window of so many pixels."""
    start = [bpy.app.binary_path, "--factory-startup", "--python"]
    if inspect.isgeneratorfunction(program):
        width, height = (str(side) for side in size)
        screen = f"-screen 0 {width}x{height}x24 +extension GLX"
        geometry = ["--enable-event-simulate", "--window-geometry", "0", "0", width, height]
        start = ["xvfb-run", "-a", "-s", screen, start[0], *geometry, *start[1:]]
    elif bpy.app.binary_path:
        start.insert(1, "--background")
    else:
        start = [sys.executable]
    words = [program.__name__, *(str(argument) for argument in arguments)]
    return subprocess.Popen(
        [*start, other_blender.__file__, "--", *words],
        env={**os.environ, **environment},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )


def in_another_blender(program, *arguments, **settings) -> str:
    """Runs such a function, which must end well; returns what is said meanwhile."""
    started = start_another_blender(program, *arguments, **settings)
    said, _ = started.communicate(timeout=300)
    assert started.returncode == 0 and "Traceback" not in said, said
    return said


def assert_shown_without_the_add_on(path: Path, wanted: dict, **environment) -> None:
    """Asserts that a file shows values where the add-on is not, to the bit. wanted: arrays by the
    name of an object, that of a value of its mesh, and a frame."""
    keys = {" ".join(str(part) for part in key): values for key, values in wanted.items()}
    np.savez(path.with_suffix(".npz"), **keys)
    in_another_blender(other_blender.shows, path, path.with_suffix(".npz"), **environment)


def save(path: Path) -> Path:
    path.parent.mkdir(exist_ok=True)
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    return path


def meshes_in(path: Path, *names: str) -> list:
    """Returns meshes of a file, as they are stored there."""
    copy = shutil.copy(path, path.with_name("copy.blend"))  # Blender links nothing from its own
    with bpy.data.libraries.load(str(copy), link=True) as (_, into):
        into.meshes = list(names)
    return into.meshes


def opened(path: Path, name: str, frame: int | None = None):
    """Opens a file; returns one of its objects, which becomes the active one."""
    bpy.ops.wm.open_mainfile(filepath=str(path))
    if frame is not None:
        bpy.context.scene.frame_set(frame)
    ob = bpy.data.objects[name, None]
    bpy.context.view_layer.objects.active = ob
    return ob


def reopened(path: Path, name: str, frame: int | None = None):
    """Saves the file and opens it; returns one of its objects."""
    return opened(save(path), name, frame)


def empty() -> None:
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)


def keyed(owner, **values) -> None:
    """Gives properties values at frames."""
    for name, at_frames in values.items():
        for frame, value in at_frames.items():
            setattr(owner, name, value)
            owner.keyframe_insert(name, frame=frame)


def push(message: str = "") -> None:
    """Ends a step of undo."""
    bpy.ops.ed.undo_push(message=message)


def is_of_object(update) -> bool:
    return isinstance(update.id, bpy.types.Object)


def updates_of(ob, times: int, counts=is_of_object) -> set[str]:
    """Returns the names of what Blender evaluates anew while nothing moves."""
    found = set()

    def note(_scene, depsgraph):
        found.update(update.id.name for update in depsgraph.updates if counts(update))

    bpy.app.handlers.depsgraph_update_post.append(note)
    try:
        for _ in range(times):
            bpy.context.view_layer.objects.active = ob
            bpy.context.view_layer.update()
    finally:
        bpy.app.handlers.depsgraph_update_post.remove(note)
    return found


def failing(operator, **arguments) -> str:
    """Returns the message of an operator that must fail."""
    with pytest.raises(RuntimeError) as failure:
        operator(**arguments)
    return str(failure.value)


def times(folder: Path) -> dict[str, int]:
    """Returns when the files of a folder were written."""
    return {path.name: path.stat().st_mtime_ns for path in folder.iterdir() if path.is_file()}


# Work in the background --------------------------------------------------------


@pytest.fixture
def waiting(monkeypatch):
    """As with a window in which somebody waits; the timer is called by hand."""
    monkeypatch.setattr(drafts, "allowed", True)
    yield
    drafts.close()


@pytest.fixture
def small_coast(monkeypatch):
    """Has the coast without a file be a smaller sea over fewer samples, made in no time."""
    from libocean_addon.coast import coast_job, first_coast

    sea = first_coast._SEA.replace("= 512", "= 64").replace("1420.0", "177.5")
    monkeypatch.setattr(first_coast, "_SEA", sea)
    monkeypatch.setattr(first_coast, "_BED", first_coast._BED.replace("= 512", "= 64"))
    monkeypatch.setattr(coast_job, "AUTOMATIC", 64)


def finish() -> None:
    """Calls the timer until it has nothing more to do."""
    while (pause := drafts.step()) is not None:
        time.sleep(min(pause, 0.02))


def work_on() -> drafts.Job:
    """Waits until the whole of an object is in the making; returns the job."""
    while drafts.at_work() is None:
        time.sleep(min(drafts.step(), 0.02))
    return drafts.at_work()[1]


@pytest.fixture
def scripted_volumes(monkeypatch):
    """In the place of OpenVDB: what a file would say of itself."""
    from libocean_addon.shared import compat
    from libocean_addon.volumes import vdb_files, volume_job, volumes

    def write(_job, _sea, _frame, path, strings, _period):
        path.write_text(json.dumps(strings))

    monkeypatch.setattr(volumes, "find_command", lambda: None)
    monkeypatch.setattr(compat, "load_openvdb", lambda: object())
    monkeypatch.setattr(volume_job.VolumeJob, "_by_module", write)
    monkeypatch.setattr(vdb_files, "read_header", lambda path: json.loads(path.read_text()))


# A coast of test_coast.py -------------------------------------------------------


@pytest.fixture
def sea_file(tmp_path):
    from test_coast import SEA, write_bed

    write_bed(tmp_path)
    (tmp_path / "sea.toml").write_text(SEA)
    return tmp_path / "sea.toml"


@pytest.fixture
def coast(sea_file):
    from test_coast import add_coast

    return add_coast(sea_file)


@pytest.fixture
def slow(monkeypatch):
    """As where the maps of a coast take long."""
    from subjects import Coast

    Coast().make_slow(monkeypatch)


# Files --------------------------------------------------------------------------


def read_exr(path: Path) -> tuple[dict[str, str], dict[str, np.ndarray]]:
    """Returns header and channels of a file of floats."""
    from libocean_addon.bake import exr_files

    image = exr_files.load_package().InputFile(str(path))
    header = image.header()
    assert image.isComplete()
    planes = {name: np.frombuffer(image.channel(name), np.float32) for name in header["channels"]}
    return {name: str(value) for name, value in header.items()}, planes


# Pictures -----------------------------------------------------------------------


@pytest.fixture
def shot(scene):
    """A small sea seen from above, its heights as light."""
    ob = add_ocean(64, kind="PATCH", preset="beaufort_6", use_material=False)
    shot_of(scene, ob)
    return ob


def shot_of(scene, ob, place=(0.0, 0.0, 100.0), width: float | None = None):
    """Shows an object from above, its positions as light; returns the camera. width: of the view
    [m]; None: nearly a period of a sea."""
    picture_settings(scene, 48)
    shine_by_places(ob)
    return camera(scene, place, width=width or ob.libocean.patch_size * 0.9)


def picture_settings(scene, side: int, samples: int = 1) -> None:
    """Has Cycles render squares of numbers, of so many pixels a side."""
    scene.render.engine = "CYCLES"
    scene.cycles.samples = samples
    scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
    scene.render.resolution_x = scene.render.resolution_y = side
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"


def shine_by_places(ob) -> None:
    """Has an object shine with its positions as light."""
    made = light()
    shine(ob, made, made.node_tree.nodes.new("ShaderNodeNewGeometry").outputs["Position"])


def camera(scene, place=(0.0, 0.0, 0.0), *, width: float | None = None, far: float = 1000.0):
    """The scene's camera, which looks down. width: of a view without perspective [m]."""
    ob = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    scene.collection.objects.link(ob)
    scene.camera, ob.location, ob.data.clip_end = ob, place, far
    if width:
        ob.data.type, ob.data.ortho_scale = "ORTHO", width
    bpy.context.view_layer.update()
    return ob


def light():
    """A material that shines evenly."""
    from libocean_addon.shared import compat

    made = bpy.data.materials.new("Light")
    compat.use_nodes(made)
    tree = made.node_tree
    tree.nodes.clear()
    lamp, output = tree.nodes.new("ShaderNodeEmission"), tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(lamp.outputs[0], output.inputs["Surface"])
    return made


def white(shader: str = "ShaderNodeBsdfDiffuse"):
    """A material that sends all light back, or lets all through."""
    made = light()
    tree = made.node_tree
    both = tree.nodes.new(shader)
    both.inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    output = next(node for node in tree.nodes if node.type == "OUTPUT_MATERIAL")
    tree.links.new(both.outputs[0], output.inputs["Surface"])
    return made


def pixels(path: Path) -> np.ndarray:
    """[row, column, channel], the bottom row first."""
    return pixels_of(bpy.data.images.load(str(path)))


def pixels_of(image) -> np.ndarray:
    width, height = image.size
    out = np.empty(width * height * image.channels, np.float32)
    image.pixels.foreach_get(out)
    return out.reshape(height, width, image.channels)


def rendered(scene, path: Path) -> np.ndarray:
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    return pixels(path)


# Values of nodes --------------------------------------------------------------


def geometry_group(name: str):
    """A modifier's node group, empty."""
    from libocean_addon.shared import compat

    group = bpy.data.node_groups.new(name, "GeometryNodeTree")
    compat.add_socket(group, "Geometry", "NodeSocketGeometry")
    compat.add_socket(group, "Geometry", "NodeSocketGeometry", output=True)
    return group


def by_nodes(formula, arguments: np.ndarray) -> np.ndarray:
    """Returns the values that nodes compute from these arguments, (n, 3), each at a vertex."""
    from libocean_addon.shared import compat
    from libocean_addon.shared.node_builder import Builder

    mesh = bpy.data.meshes.new("Calls")
    mesh.vertices.add(len(arguments))
    for name, values in zip("abc", arguments.T, strict=True):
        made = mesh.attributes.new(name, "FLOAT", "POINT")
        made.data.foreach_set("value", values.astype(np.float32))
    ob = bpy.data.objects.new("Calls", mesh)
    bpy.context.scene.collection.objects.link(ob)
    group = geometry_group("Calls")
    b = Builder(group)
    read = []
    for name in "abc":
        named = b.node("GeometryNodeInputNamedAttribute", data_type="FLOAT")
        named.inputs["Name"].default_value = name
        read.append(compat.active(named.outputs, "Attribute"))
    stored = b.node("NodeGroupInput").outputs[0]
    stored = b.store(stored, "result", "FLOAT", formula(b, *read))
    b.link(stored, b.node("NodeGroupOutput").inputs[0])
    ob.modifiers.new("Calls", "NODES").node_group = group
    return attribute(ob, "result")


@pytest.fixture
def eye(scene):
    """The scene's camera, low over the land of test_land.py."""
    return camera(scene, (512.0, 1024.0, 64.0), far=1e5)


@pytest.fixture
def studio(scene):
    """Straight down on what shines by itself, each pixel of one point."""
    camera(scene, (0.0, 0.0, 100.0), width=6.0)
    picture_settings(scene, 512)
    scene.cycles.filter_width = 0.01
    return scene


def shine(ob, made, what) -> None:
    """Gives an object a material that shines with an output of a node."""
    tree = made.node_tree
    light = tree.nodes.new("ShaderNodeEmission")
    tree.links.new(what, light.inputs["Color"])
    output = next(node for node in tree.nodes if node.type == "OUTPUT_MATERIAL")
    tree.links.new(light.outputs[0], output.inputs["Surface"])
    ob.data.materials.clear()
    ob.data.materials.append(made)


def taken(scene, tmp_path) -> np.ndarray:
    scene.render.filepath = str(tmp_path / "taken.exr")
    bpy.ops.render.render(write_still=True)
    return pixels(scene.render.filepath)[..., :3]
