# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shaders that read our EXR files, evaluated by Cycles' OSL at given places: at samples they have
the values of the file, halfway the mean of both neighbours, beyond the period the same again; half
a texel off, upside down or in other axes they have not.

Bound: 1e-6 m, and 1e-6 of a normal and of foam; beyond the period 1e-4 m, where a float's place is
coarser. The sea has waves of 1 m, whose neighbouring samples differ by decimetres.
"""

import hashlib
import os
import subprocess
from pathlib import Path

import bpy
import numpy as np
import pytest
from conftest import pixels

try:
    import _cycles

    HAS_OSL = _cycles.with_osl
except ImportError:
    HAS_OSL = False
pytestmark = pytest.mark.skipif(not HAS_OSL, reason="this Blender has no OSL")

# From 5.2 on Cycles reads images by itself: t runs up, and there is nothing beyond the edges.
OWN_IMAGES = bpy.app.version >= (5, 2, 0)
ROOT = Path(__file__).resolve().parents[2]
N, PERIOD = 32, 40.0
CELL = PERIOD / N
BOUND = 1e-6
PRODUCTS = ("displacement", "normal", "foam")
SEA = f"""libocean = 1
[grid]
resolution = {N}
patch_size = {PERIOD}
[surface]
foam_coverage = "threshold"
foam_threshold = 0.9
[[waves]]
spectrum = "jonswap"
wind_speed = 7.0
wind_direction = 30.0
"""
SOCKETS = {"string": "NodeSocketString", "float": "NodeSocketFloat", "int": "NodeSocketInt"}


@pytest.fixture(scope="module")
def baked(tmp_path_factory):
    """A folder with the maps of the sea in all axes, floats."""
    folder = tmp_path_factory.mktemp("maps")
    (folder / "sea.toml").write_text(SEA)
    for axes in ("zup", "yup", "tnb"):
        command = [os.environ["OCEAN"], "bake", "sea.toml", "-q", "-o", f"{axes}/sea.####.exr"]
        command += ["--products", ",".join(PRODUCTS), "--type", "float", "--axes", axes]
        subprocess.run(command, check=True, cwd=folder, stdout=subprocess.DEVNULL)
    return folder


def map_of(baked: Path, product: str, axes: str = "zup") -> Path:
    return baked / axes / f"sea.{product}.0001.exr"


def truth(baked: Path, product: str) -> np.ndarray:
    """[j, i, component] in the sea's own axes, j from the south; of foam the component 0 counts."""
    return pixels(map_of(baked, product))[..., :3]


def places(shift=(0.0, 0.0)) -> np.ndarray:
    """(x, y, 0) of all samples, moved by so many cells."""
    i, j = np.meshgrid(np.arange(N), np.arange(N))
    return np.stack([(i + shift[0]) * CELL, (j + shift[1]) * CELL, 0 * i], -1).reshape(-1, 3)


def load(node, source: Path) -> None:
    """Compiles a shader into a Script node and gives the node its sockets. Blender does that alone
    until 4.3; then by a module that its wheels lack."""
    if hasattr(_cycles, "osl_update_node"):
        node.mode = "EXTERNAL"
        node.filepath = str(source)
        assert node.outputs, "it does not compile"
        return
    compiled = source.with_suffix(".oso")
    assert _cycles.osl_compile(str(source), str(compiled)), "it does not compile"
    text = compiled.read_text()
    node.mode = "INTERNAL"
    node.bytecode = text
    node.bytecode_hash = hashlib.md5(text.encode()).hexdigest()
    for line in text.splitlines():
        kind, _, rest = line.partition("\t")
        if kind not in ("param", "oparam"):
            continue
        words = rest.split()
        sockets = node.inputs if kind == "param" else node.outputs
        name = words[1]
        socket_type = SOCKETS.get(words[0], "NodeSocketVector")
        socket = sockets.new(type=socket_type, name=name, identifier=name)
        if kind == "param" and words[0] in SOCKETS:
            value = rest.split('"')[1] if words[0] == "string" else words[2]
            kinds = {"string": str, "float": float, "int": int}
            socket.default_value = kinds[words[0]](value)


def evaluate(folder: Path, source: Path, at: np.ndarray, output: str, **inputs) -> np.ndarray:
    """The output of a shader at each place: a picture of faces that have one place each."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.shading_system = True
    scene.cycles.samples = 1
    scene.cycles.use_denoising = False
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.filter_width = 0.01
    scene.view_settings.view_transform = "Raw"
    side = int(np.ceil(np.sqrt(len(at))))
    assert side >= 4, "Blender renders no smaller picture"
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    lower_left = [(k % side, k // side, 0) for k in range(len(at))]
    mesh = bpy.data.meshes.new("Faces")
    mesh.from_pydata(
        [np.add(place, corner) for place in lower_left for corner in corners],
        [],
        [tuple(range(4 * k, 4 * k + 4)) for k in range(len(at))],
    )
    attribute = mesh.attributes.new("place", "FLOAT_VECTOR", "FACE")
    attribute.data.foreach_set("vector", np.asarray(at, np.float32).ravel())
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.data.type = "ORTHO"
    camera.data.ortho_scale = side
    camera.location = (side / 2, side / 2, 5)
    faces = bpy.data.objects.new("Faces", mesh)
    for ob in (camera, faces):
        scene.collection.objects.link(ob)
    scene.camera = camera

    material = bpy.data.materials.new("Shader")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    script = nodes.new("ShaderNodeScript")
    load(script, source)
    for name, value in inputs.items():
        script.inputs[name].default_value = value
    place = nodes.new("ShaderNodeAttribute")
    place.attribute_name = "place"
    if "position" in script.inputs:
        links.new(place.outputs["Vector"], script.inputs["position"])
    # The attribute stays in use whether the shader asks for it by name or by its socket.
    kept = nodes.new("ShaderNodeVectorMath")
    kept.operation = "MULTIPLY_ADD"
    kept.inputs[1].default_value = (0, 0, 0)
    links.new(place.outputs["Vector"], kept.inputs[0])
    links.new(script.outputs[output], kept.inputs[2])
    light = nodes.new("ShaderNodeEmission")
    links.new(kept.outputs[0], light.inputs["Color"])
    links.new(light.outputs[0], nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    mesh.materials.append(material)

    scene.render.resolution_x = scene.render.resolution_y = side
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.filepath = str(folder / "values.exr")
    bpy.ops.render.render(write_still=True)
    return pixels(folder / "values.exr")[..., :3].reshape(-1, 3)[: len(at)]


@pytest.fixture
def shader(tmp_path):
    """A copy, beside which its compiled form may lie."""
    copy = tmp_path / "ocean_displacement.osl"
    copy.write_text((ROOT / "shaders/osl/ocean_displacement.osl").read_text())
    return copy


def read(baked, shader, product, at, axes="tnb", space="zup", **inputs):
    output = "Normal" if product == "normal" else product
    inputs = {f"{product}_map": str(map_of(baked, product, axes)), "axes": axes, **inputs}
    inputs |= {"resolution": N} | ({} if space == "uv" else {"period": PERIOD})
    if OWN_IMAGES:
        inputs = {"top_down": 0, "repeats": 0, **inputs}
    return evaluate(shader.parent, shader, at, output, space=space, **inputs)


def error(found, expected, product) -> float:
    count = 1 if product == "foam" else 3
    return np.abs(found - expected.reshape(-1, 3))[:, :count].max()


def in_axes(vectors: np.ndarray, axes: str) -> np.ndarray:
    x, y, z = np.moveaxis(vectors, -1, 0)
    order = {"zup": (x, y, z), "yup": (x, z, -y), "tnb": (x, z, y)}[axes]
    return np.stack(order, -1)


@pytest.mark.parametrize("axes", ["zup", "yup", "tnb"])
@pytest.mark.parametrize("product", PRODUCTS)
def test_at_samples_it_has_the_values_of_the_file(baked, shader, product, axes):
    expected = truth(baked, product)
    assert expected[..., 0].std() > 0.01, "nothing to see"
    assert error(read(baked, shader, product, places(), axes), expected, product) < BOUND


@pytest.mark.parametrize("product", ["displacement", "normal"])
@pytest.mark.parametrize(("space", "axes"), [("yup", "yup"), ("uv", "tnb")])
def test_the_host_may_have_other_axes(baked, shader, product, space, axes):
    at = in_axes(places(), "yup") if space == "yup" else places() / PERIOD
    found = read(baked, shader, product, at, space=space)
    assert error(found, in_axes(truth(baked, product), axes), product) < BOUND


def test_halfway_it_has_the_mean_of_both_neighbours(baked, shader):
    values = truth(baked, "displacement")
    east = (values + np.roll(values, -1, axis=1)) / 2
    assert error(read(baked, shader, "displacement", places((0.5, 0))), east, "") < BOUND
    north = (values + np.roll(values, -1, axis=0)) / 2
    assert error(read(baked, shader, "displacement", places((0, 0.5))), north, "") < BOUND


@pytest.mark.parametrize("periods", [(1, 0), (0, -1), (-7, 3)])
def test_it_repeats_after_the_period(baked, shader, periods):
    at = places((periods[0] * N, periods[1] * N))
    assert error(read(baked, shader, "displacement", at), truth(baked, "displacement"), "") < 1e-4


@pytest.mark.parametrize(
    ("repeats", "shift"), [(0, (0.25, 0.5)), (1, (0.25, 0.5)), (0, (-N, 2 * N))]
)
def test_four_lookups_are_as_good_as_one(baked, shader, repeats, shift):
    if OWN_IMAGES and repeats:
        pytest.skip("its images end at their edges")
    i, j = (np.floor(part) for part in shift)
    values = np.roll(truth(baked, "displacement"), (-int(j), -int(i)), axis=(0, 1))
    expected = 0
    for row, column in ((0, 0), (0, 1), (1, 0), (1, 1)):
        x, y = shift[0] - i, shift[1] - j
        weight = (x if column else 1 - x) * (y if row else 1 - y)
        expected = expected + weight * np.roll(values, (-row, -column), axis=(0, 1))
    found = read(baked, shader, "displacement", places(shift), repeats=repeats)
    assert error(found, expected, "") < (1e-4 if abs(shift[0]) > 1 else BOUND)


FAULTS = [
    ('from == "tnb"', 'from == "zup"'),
    ("(i + 0.5) / resolution", "(i - 0.5) / resolution"),
    ('top_down ? 1 - t : t, "interp"', 'top_down ? t : 1 - t, "interp"'),
]
if not OWN_IMAGES:
    FAULTS += [
        ("place[0] + 0.5 / resolution", "place[0]"),
        ("place[1] + 0.5 / resolution", "place[1]"),
        ('top_down ? 1 - t : t, "wrap"', 't, "wrap"'),
        ('"wrap", "periodic"', '"wrap", "black"'),
    ]


@pytest.mark.parametrize(("fault", "instead"), FAULTS)
def test_the_bound_would_see_a_fault(baked, shader, fault, instead):
    text = shader.read_text()
    assert text.count(fault) == 1
    shader.write_text(text.replace(fault, instead))
    values = truth(baked, "displacement")
    inputs = {"repeats": 0} if "(i +" in fault or "interp" in fault else {}
    found = [read(baked, shader, "displacement", places((0, shift)), **inputs) for shift in (0, N)]
    assert max(error(one, values, "") for one in found) > 1e4 * BOUND


# ---- the OSL that MaterialX makes of its document


@pytest.fixture(scope="module")
def of_materialx(tmp_path_factory):
    """A folder with displacement.osl, normal.osl and foam.osl."""
    python = ROOT / ".venv/bin/python"
    if not list(ROOT.glob(".venv/lib/python3.*/site-packages/MaterialX")):
        pytest.skip("MaterialX is not in .venv; scripts/test installs it")
    folder = tmp_path_factory.mktemp("materialx")
    document = ROOT / "shaders/materialx/ocean.mtlx"
    clean = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    program = Path(__file__).with_name("materialx_osl.py")
    downwards = [] if OWN_IMAGES else ["--downwards"]
    subprocess.run([python, program, document, folder, *downwards], check=True, env=clean)
    return folder


def read_by_materialx(baked, shaders, product, at, axes="tnb", resolution=N):
    output = f"{product}_out"
    inputs = {f"maps_{product}_map": str(map_of(baked, product, axes))}
    inputs |= {"maps_resolution": float(resolution), "maps_period": PERIOD}
    inputs["maps_axes"] = ("tnb", "zup", "yup").index(axes)
    return evaluate(shaders, shaders / f"{product}.osl", at, output, **inputs)


@pytest.mark.parametrize("axes", ["zup", "yup", "tnb"])
@pytest.mark.parametrize("product", PRODUCTS)
def test_materialx_has_the_values_of_the_file(baked, of_materialx, product, axes):
    found = read_by_materialx(baked, of_materialx, product, places(), axes)
    assert error(found, truth(baked, product), product) < BOUND


def test_materialx_between_samples_and_beyond_the_period(baked, of_materialx):
    values = truth(baked, "displacement")
    if not OWN_IMAGES:
        east = (values + np.roll(values, -1, axis=1)) / 2
        found = read_by_materialx(baked, of_materialx, "displacement", places((0.5, 0)))
        assert error(found, east, "") < BOUND
        found = read_by_materialx(baked, of_materialx, "displacement", places((2 * N, -N)))
        assert error(found, values, "") < 1e-4
    # The half texel is too short for a map that is read as a finer one.
    found = read_by_materialx(baked, of_materialx, "displacement", places(), resolution=2 * N)
    assert error(found, values, "") > 1e4 * BOUND
