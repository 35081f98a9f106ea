# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""USD stages, read by Pixar's own library (usd-core of PyPI, in the project's .venv)."""

import sys
from pathlib import Path

import meshio
import numpy
import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path += [str(path) for path in ROOT.glob(".venv/lib/python3.*/site-packages")]
try:
    from pxr import Sdf, Usd, UsdGeom
except ImportError:
    pytest.skip("usd-core is not in .venv; scripts/test installs it", allow_module_level=True)

N = 64
PERIOD = 200.0


def bake(ocean, *arguments) -> None:
    ocean.good("bake", "sea.toml", *arguments)


def mesh_of(stage) -> UsdGeom.Mesh:
    return UsdGeom.Mesh(stage.GetPrimAtPath("/Ocean"))


def test_a_stage_has_the_points_of_every_frame(ocean):
    bake(ocean, "-o", "out/sea.usda", "--frames", "1-4")
    bake(ocean, "-o", "ply/sea.####.ply", "--frames", "1-4")
    stage = Usd.Stage.Open(str(ocean.folder / "out/sea.usda"))
    assert UsdGeom.GetStageUpAxis(stage) == "Z" and UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    assert (stage.GetStartTimeCode(), stage.GetEndTimeCode()) == (1.0, 4.0)
    assert stage.GetTimeCodesPerSecond() == 24.0
    assert stage.GetDefaultPrim().GetName() == "Ocean"
    mesh = mesh_of(stage)
    foam = UsdGeom.PrimvarsAPI(mesh).GetPrimvar("foam")
    assert foam.GetInterpolation() == "vertex" and mesh.GetNormalsInterpolation() == "vertex"
    assert mesh.GetSubdivisionSchemeAttr().Get() == "none"
    counts = numpy.array(mesh.GetFaceVertexCountsAttr().Get())
    faces = numpy.array(mesh.GetFaceVertexIndicesAttr().Get()).reshape(-1, 4)
    assert (counts == 4).all() and faces.shape == (N * N, 4)
    assert faces.min() == 0 and faces.max() == (N + 1) ** 2 - 1
    assert mesh.GetPointsAttr().GetTimeSamples() == [1.0, 2.0, 3.0, 4.0]
    for frame in range(1, 5):
        ply = meshio.read(ocean.folder / f"ply/sea.{frame:04}.ply")
        data = ply.point_data

        def read(attribute, when=frame):
            return numpy.array(attribute.Get(when))

        assert (read(mesh.GetPointsAttr()) == ply.points).all()
        assert (read(foam) == data["foam"]).all()
        for attribute, names in (
            (mesh.GetNormalsAttr(), ("nx", "ny", "nz")),
            (mesh.GetVelocitiesAttr(), ("vx", "vy", "vz")),
        ):
            assert (read(attribute) == numpy.stack([data[name] for name in names], -1)).all()
    # The seam is closed: the last column is the first of the next period.
    points = numpy.array(mesh.GetPointsAttr().Get(2)).reshape(N + 1, N + 1, 3)
    assert (points[:, -1] == points[:, 0] + [PERIOD, 0, 0]).all()
    # Faces look up.
    a, b, c = (points.reshape(-1, 3)[faces[:, i]] for i in range(3))
    assert (numpy.cross(b - a, c - a)[:, 2] > 0).mean() > 0.99
    # Motion between frames is the velocity's.
    moved = numpy.array(mesh.ComputePointsAtTime(2.5, 2)).reshape(N + 1, N + 1, 3)
    velocity = numpy.array(mesh.GetVelocitiesAttr().Get(2)).reshape(N + 1, N + 1, 3)
    assert abs(moved - points - velocity / 48).max() < 1e-4
    assert abs(velocity).max() > 0.3
    # The sea is in it.
    data = stage.GetRootLayer().customLayerData
    assert "jonswap" in data["ocean:sea"] and data["ocean:resolution"] == str(N)


def test_rates_steps_axes_and_what_is_asked_for(ocean):
    bake(
        ocean, "-o", "out/sea.usda", "--frames", "10-30x10", "--fps", "25", "--axes", "yup",
        "--products", "foam",
    )  # fmt: skip
    stage = Usd.Stage.Open(str(ocean.folder / "out/sea.usda"))
    assert UsdGeom.GetStageUpAxis(stage) == "Y" and stage.GetTimeCodesPerSecond() == 25.0
    mesh = mesh_of(stage)
    assert mesh.GetPointsAttr().GetTimeSamples() == [10.0, 20.0, 30.0]
    assert mesh.GetVelocitiesAttr().Get(20) is None
    assert not mesh.GetNormalsAttr().HasAuthoredValue()
    bake(ocean, "-o", "z.usda", "--frames", "20", "--fps", "25", "--products", "foam")
    turned = numpy.array(mesh.GetPointsAttr().Get(20))
    upright = Usd.Stage.Open(str(ocean.folder / "z.usda"))
    points = numpy.array(mesh_of(upright).GetPointsAttr().Get(20))
    assert (turned == points[:, [0, 2, 1]] * [1, 1, -1]).all()


def test_shards_write_the_same_and_a_gap_is_told(ocean):
    whole = ["bake", "sea.toml", "--frames", "1-6", "-o"]
    ocean.good(*whole, "out/sea.usda")
    first = ocean(*whole, "parts/sea.usda", "--shard", "1/3")
    assert first.returncode == 0 and "not there yet" in first.stderr and "3-6" in first.stderr
    assert '"missing": [3,4,5,6]' in (ocean.folder / "parts/sea.manifest.json").read_text()
    stage = (ocean.folder / "parts/sea.usda").read_bytes()
    ocean.good(*whole, "parts/sea.usda", "--shard", "2/3")
    assert (ocean.folder / "parts/sea.usda").read_bytes() == stage
    last = ocean(*whole, "parts/sea.usda", "--shard", "3/3")
    assert "not there yet" not in last.stderr
    assert "missing" not in (ocean.folder / "parts/sea.manifest.json").read_text()
    out, parts = ocean.hashes("out"), ocean.hashes("parts")
    shared = {"sea.usda", "sea.clips.usda", "sea.topology.usdc"}
    frames = {f"sea.{frame:04}.usdc" for frame in range(1, 7)}
    assert {name for name in out if name.endswith(("usda", "usdc"))} == shared | frames
    for name in out:
        if not name.endswith("json"):
            assert out[name] == parts[name], name
    # What is whole is kept; what is cut off, or gone, is made again.
    (ocean.folder / "out/sea.0002.usdc").write_bytes(b"PXR-USDC")
    (ocean.folder / "out/sea.topology.usdc").unlink()
    kept = (ocean.folder / "out/sea.0003.usdc").stat().st_mtime_ns
    ocean.good(*whole, "out/sea.usda", "--skip-existing")
    assert {n: h for n, h in ocean.hashes("out").items() if "manifest" not in n} == {
        n: h for n, h in out.items() if "manifest" not in n
    }
    assert (ocean.folder / "out/sea.0003.usdc").stat().st_mtime_ns == kept


def test_a_frame_remakes_itself(ocean):
    bake(ocean, "-o", "a.usda", "--frames", "3", "--axes", "yup", "--resolution", "32")
    ocean.good("bake", "--from", "a.0003.usdc", "-o", "b.usda")
    first, second = (ocean.folder / f"{name}.0003.usdc" for name in "ab")
    assert first.read_bytes() == second.read_bytes()
    assert "9 m/s" in ocean.good("info", "a.0003.usdc")


def test_a_file_that_is_cut_off_anywhere_is_refused(ocean):
    bake(ocean, "-o", "a.usda", "--frames", "3", "--resolution", "32")
    whole = (ocean.folder / "a.0003.usdc").read_bytes()
    for size in range(0, len(whole), max(1, len(whole) // 40)):
        cut = ocean.write("cut.usdc", whole[:size])
        assert "cut.usdc" in ocean.bad("bake", "--from", "cut.usdc", "-o", "b.usda")
        with pytest.raises(Exception, match=r"."):
            if Sdf.Layer.OpenAsAnonymous(str(cut)) is None:
                raise ValueError("refused")


def test_what_a_stage_cannot_name_is_refused(ocean):
    for frames in ("1,2,4", "3-1", "-2-2"):
        said = ocean.bad("bake", "sea.toml", "-o", "a.usda", "--frames", frames)
        assert "USD" in said or "--frames" in said
    assert "usda" in ocean.bad("bake", "sea.toml", "-o", "a.usdc")
    ocean.write("a.usda", "#usda 1.0\nmine\n")
    assert "not written by a bake" in ocean.bad("bake", "sea.toml", "-o", "a.usda")


def test_a_large_frame_is_little_more_than_its_floats(ocean):
    bake(ocean, "-o", "a.usda", "--frames", "1", "--resolution", "1024")
    size = (ocean.folder / "a.0001.usdc").stat().st_size
    assert size < 1.02 * 1025 * 1025 * 10 * 4
