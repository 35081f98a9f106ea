# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender reads the meshes and volumes that `ocean bake` writes, with what it has itself: a USD
stage of several frames, a sequence of VDB files."""

import os
import subprocess
from pathlib import Path

import bpy
import numpy as np
import pytest
from libocean_addon.shared import compat

pytestmark = pytest.mark.skipif(
    "OCEAN" not in os.environ, reason="OCEAN is not the path of the program"
)
OPENVDB = compat.load_openvdb()
FRAMES = range(1, 4)
SEA = """libocean = 1
[grid]
resolution = 64
patch_size = 100.0
[surface]
foam_coverage = "threshold"
foam_threshold = 0.9
[[waves]]
spectrum = "jonswap"
wind_speed = 14.0
"""


def bake(folder: Path, output: str) -> None:
    program = Path(os.environ["OCEAN"]).resolve()
    (folder / "sea.toml").write_text(SEA)
    command = [program, "bake", "sea.toml", "-o", output, "--frames", "1-3"]
    subprocess.run(command, cwd=folder, check=True, capture_output=True)


def read_ply(path: Path) -> np.ndarray:
    """The vertices, a record each."""
    header, _, data = path.read_bytes().partition(b"end_header\n")
    lines = [line.split() for line in header.decode().splitlines()]
    assert ["format", "binary_little_endian", "1.0"] in lines
    (count,) = (int(line[2]) for line in lines if line[:2] == ["element", "vertex"])
    names = [line[2] for line in lines if line[:2] == ["property", "float"]]
    return np.frombuffer(data, np.dtype([(name, "<f4") for name in names]), count)


def columns(vertices: np.ndarray, *names: str) -> np.ndarray:
    return np.stack([vertices[name] for name in names], axis=-1)


def values(found, count: int, width: int, name: str) -> np.ndarray:
    out = np.empty(count * width, np.float32)
    found.foreach_get(name, out)
    return out.reshape(count, width)


@pytest.mark.skipif(not bpy.app.build_options.usd, reason="this Blender is built without USD")
def test_a_usd_stage_is_the_mesh_of_each_frame(scene, tmp_path):
    bake(tmp_path, "sea.usda")
    bake(tmp_path, "sea.####.ply")
    assert bpy.ops.wm.usd_import(filepath=str(tmp_path / "sea.usda")) == {"FINISHED"}
    (ob,) = (ob for ob in bpy.data.objects if ob.type == "MESH")
    assert (scene.frame_start, scene.frame_end) == (1, 3)
    assert ob.matrix_world == ob.matrix_world.Identity(4)
    shown = []
    for frame in FRAMES:
        scene.frame_set(frame)
        mesh = ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
        expected = read_ply(tmp_path / f"sea.{frame:04d}.ply")
        count = len(mesh.vertices)
        assert count == len(expected) == 65**2
        points = values(mesh.vertices, count, 3, "co")
        assert np.array_equal(points, columns(expected, "x", "y", "z"))
        velocity = values(mesh.attributes["velocity"].data, count, 3, "vector")
        assert np.array_equal(velocity, columns(expected, "vx", "vy", "vz"))
        foam = values(mesh.attributes["foam"].data, count, 1, "value")
        assert np.array_equal(foam, columns(expected, "foam"))
        assert foam.max() > 0.1
        # Kept by Blender as two angles of 16 bits.
        normals = values(mesh.corner_normals, len(mesh.loops), 3, "vector")
        corners = np.array([loop.vertex_index for loop in mesh.loops])
        assert np.abs(normals - columns(expected, "nx", "ny", "nz")[corners]).max() < 2e-3
        shown.append(points)
    assert np.abs(shown[2] - shown[0]).max() > 0.1


def test_a_vdb_sequence_is_a_volume_of_each_frame(scene, tmp_path):
    bake(tmp_path, "sea_####.vdb")
    names = [f"sea_{frame:04d}.vdb" for frame in FRAMES]
    bpy.ops.object.volume_import(
        filepath=str(tmp_path / names[0]),
        directory=str(tmp_path),
        files=[{"name": name} for name in names],
        use_sequence_detection=True,
    )
    ob = bpy.context.object
    volume = ob.data
    assert volume.is_sequence
    assert (volume.frame_start, volume.frame_duration) == (1, 3)
    assert tuple(ob.rotation_euler) == (0.0, 0.0, 0.0)
    for frame, name in zip(FRAMES, names, strict=True):
        scene.frame_set(frame)
        seen = ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
        seen.grids.load()
        assert Path(seen.grids.frame_filepath).name == name
        kinds = {grid.name: grid.data_type for grid in seen.grids}
        assert kinds == {"surface": "FLOAT", "vel": "VECTOR_FLOAT"}
        voxels = {grid.name: grid.matrix_object[0][0] for grid in seen.grids}
        assert voxels == pytest.approx({"surface": 100 / 64, "vel": 100 / 32})
    volume.grids.load()
    assert volume.velocity_grid == "vel"


@pytest.mark.skipif(OPENVDB is None, reason="this Blender has no OpenVDB module")
def test_its_module_knows_what_the_grids_are(tmp_path):
    bake(tmp_path, "sea_####.vdb")
    path = str(tmp_path / "sea_0002.vdb")
    surface, velocity = (OPENVDB.read(path, name) for name in ("surface", "vel"))
    assert surface.gridClass == "level set"
    assert surface.background == pytest.approx(3 * 100 / 64)
    assert velocity.vectorType == "contravariant relative"
    metadata = OPENVDB.readMetadata(path)
    assert metadata["ocean:units"] == "m, m/s"
    assert metadata["ocean:frame"] == "2"
