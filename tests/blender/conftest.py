# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A fresh Blender for each test, and values to compare its meshes with."""

import contextlib
import os
import subprocess
import sys
import textwrap
import time
from pathlib import Path

import bpy
import numpy as np
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
        bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
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


ANOTHER_PROCESS = """
import os, sys, traceback
import bpy
arguments = sys.argv[sys.argv.index("--") + 1 :]
try:
{body}
    status = 0
except BaseException:
    traceback.print_exc()
    status = 1
sys.stdout.flush()
sys.stderr.flush()
os._exit(status)
"""


def start_another_process(folder: Path, body: str, *arguments, **environment) -> subprocess.Popen:
    """Statements in a Blender of their own, with factory settings. They find `arguments`."""
    script = folder / "script.py"
    script.write_text(ANOTHER_PROCESS.format(body=textwrap.indent(body.strip("\n"), "    ")))
    start = [sys.executable, script]
    if bpy.app.binary_path:
        start = [bpy.app.binary_path, "--background", "--factory-startup", "--python", script]
    return subprocess.Popen(
        [*start, "--", *arguments],
        env={**os.environ, **environment},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )


def in_another_process(folder: Path, body: str, *arguments, **environment) -> None:
    """Runs statements in a Blender of their own, which must end well."""
    started = start_another_process(folder, body, *arguments, **environment)
    said, _ = started.communicate()
    assert started.returncode == 0, said


def reopen(path: Path) -> None:
    """Saves the file and opens it."""
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    bpy.ops.wm.open_mainfile(filepath=str(path))


# Work in the background --------------------------------------------------------


@pytest.fixture
def waiting(monkeypatch):
    """As with a window in which somebody waits; the timer is called by hand."""
    monkeypatch.setattr(drafts, "allowed", True)
    yield
    drafts.close()


def finish() -> None:
    """Calls the timer until it has nothing more to do."""
    while (pause := drafts.step()) is not None:
        time.sleep(min(pause, 0.02))


def work_on() -> drafts.Job:
    """Waits until the whole of an object is in the making; returns the job."""
    while drafts.at_work() is None:
        time.sleep(min(drafts.step(), 0.02))
    return drafts.at_work()[1]


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
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    bpy.context.collection.objects.link(camera)
    camera.location = place
    camera.data.type = "ORTHO"
    camera.data.ortho_scale = width or ob.libocean.patch_size * 0.9
    scene.camera = camera
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 1
    scene.cycles.use_denoising = False
    scene.render.resolution_x = scene.render.resolution_y = 48
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    material = bpy.data.materials.new("Heights")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    place = nodes.new("ShaderNodeNewGeometry")
    light = nodes.new("ShaderNodeEmission")
    links.new(place.outputs["Position"], light.inputs["Color"])
    links.new(light.outputs[0], nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    ob.data.materials.append(material)
    return camera


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


def parallel_camera(scene):
    """The scene's, without perspective; it looks down."""
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    scene.collection.objects.link(camera)
    camera.data.type = "ORTHO"
    camera.data.clip_end = 1000.0
    scene.camera = camera
    return camera


@pytest.fixture
def eye(scene):
    """The scene's camera, low over the land of test_land.py."""
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.location = (512.0, 1024.0, 64.0)
    camera.data.clip_end = 1e5
    scene.collection.objects.link(camera)
    scene.camera = camera
    bpy.context.view_layer.update()
    return camera


@pytest.fixture
def studio(scene):
    """Straight down on what shines by itself, each pixel of one point."""
    parallel_camera(scene).location.z = 100.0
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 1
    scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
    scene.cycles.filter_width = 0.01
    scene.render.resolution_x = scene.render.resolution_y = 512
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
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
