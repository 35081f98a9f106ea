# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""PLY and OBJ of a sea: axes, products, files of earlier versions, cost. What they hold is in
test_files_read_by_others.py."""

import hashlib
import json
import re

import meshio
import numpy
import pytest
from conftest import children_seconds

N = 64


def test_y_up_turns_every_vector(ocean):
    ocean.bake("--frames 3 -o z.ply")
    ocean.bake("--frames 3 -o y.ply --axes yup")
    z, y = (meshio.read(ocean.folder / name) for name in ("z.ply", "y.ply"))
    assert (y.points == z.points[:, [0, 2, 1]] * [1, 1, -1]).all()
    for names in (("nx", "ny", "nz"), ("vx", "vy", "vz")):
        assert (y.point_data[names[1]] == z.point_data[names[2]]).all()
        assert (y.point_data[names[2]] == -z.point_data[names[1]]).all()
    # Faces still look outwards.
    a, b, c = (y.points[y.cells_dict["triangle"][:, i]] for i in range(3))
    assert (numpy.cross(b - a, c - a)[:, 1] > 0).mean() > 0.99


def test_a_mesh_has_the_requested_products_only(ocean):
    ocean.bake("--frames 3 -o a.ply --products foam")
    assert set(meshio.read(ocean.folder / "a.ply").point_data) == {"s", "t", "foam"}
    ocean.bake("--frames 3 -o b.ply --products position")
    assert set(meshio.read(ocean.folder / "b.ply").point_data) == {"s", "t"}
    ocean.bake("--frames 3 -o b.obj --products position --resolution 32")
    assert "\nf 1/1 2/2 34/34\n" in (ocean.folder / "b.obj").read_text()


def without_uv(path):
    """The bytes that version 0.1.0 wrote before meshes had uv."""
    data = path.read_bytes()
    if path.suffix == ".obj":
        lines = data.splitlines(keepends=True)
        return re.sub(rb"(\d+)/\1/\1", rb"\1//\1", b"".join(x for x in lines if x[:3] != b"vt "))
    end = data.index(b"end_header\n") + len(b"end_header\n")
    head = data[:end].replace(b"property float s\nproperty float t\n", b"")
    floats = data[:end].count(b"property float")
    vertices = (N + 1) ** 2
    table = numpy.frombuffer(data, "f4", vertices * floats, end).reshape(vertices, floats)
    rest = data[end + table.nbytes :]
    return head + numpy.delete(table, (6, 7), axis=1).tobytes() + rest


def recipe_without_uv(data, suffix):
    """The recipe in the manifests of that version, from the header of a mesh."""
    mark = {".ply": b"comment ocean:", ".obj": b"# ocean:"}[suffix]
    lines = [line[len(mark) :] for line in data.splitlines() if line.startswith(mark)]
    sea = b"".join(line[4:] + b"\n" for line in lines if line.startswith(b"sea "))
    words = {line.split()[0]: line.split()[1] for line in lines if line[:4] != b"sea "}
    return hashlib.sha256(
        b"libocean %b\nformat %b\nbackend cpu\nresolution %d\nframe 3\nmesh normal,foam zup\n"
        % (words[b"version"], suffix.encode(), N)
        + sea
    ).hexdigest()


@pytest.mark.parametrize("extension", ["ply", "obj"])
def test_a_mesh_of_before_uv_is_known_and_made_again(ocean, extension):
    command = ["-o", f"a.{extension}", "--resolution", str(N), "--products", "normal,foam"]
    ocean.bake("--frames 3", *command)
    path = ocean.folder / f"a.{extension}"
    wanted = path.read_bytes()
    old = without_uv(path)
    assert len(old) < len(wanted)
    path.write_bytes(old)
    assert "9 m/s" in ocean.good("info", path.name)
    # As that version listed it, with the recipe that it had.
    manifest = ocean.folder / "a.manifest.json"
    text = manifest.read_text()
    entry = json.loads(text)["files"][0]
    listed = text.replace(entry["sha256"], hashlib.sha256(old).hexdigest())
    listed = listed.replace(entry["recipe"], recipe_without_uv(wanted, path.suffix))
    manifest.write_text(listed)
    ocean.bake("--frames 3", *command, "--skip-existing")
    assert path.read_bytes() == wanted
    (ocean.folder / "a.manifest.json").unlink()
    path.write_bytes(old)
    ocean.bake("--frames 3", *command)  # it is ours: replaced
    assert path.read_bytes() == wanted


def test_a_mesh_of_512_squared_takes_less_than_two_seconds(ocean):
    """Processor time, which other programs do not change."""
    before = children_seconds()
    ocean.bake("--frames 3 -o a.obj --resolution 512")
    used = children_seconds() - before
    print(f"OBJ of 512 x 512 in {used:.2f} s")
    assert 0.0 < used < 2.0
