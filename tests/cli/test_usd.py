# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""USD stages, read by Pixar's own library (usd-core of PyPI, in the project's .venv): their times
and chunks. What a frame holds is in test_files_read_by_others.py."""

import subprocess
import sys
from pathlib import Path

import meshio
import numpy
import pytest
from conftest import OCEAN

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path += [str(path) for path in ROOT.glob(".venv/lib/python3.*/site-packages")]
try:
    from pxr import Sdf, Usd, UsdGeom
except ImportError:
    pytest.skip("usd-core is not in .venv; scripts/test installs it", allow_module_level=True)

N = 64


def mesh_of(stage) -> UsdGeom.Mesh:
    return UsdGeom.Mesh(stage.GetPrimAtPath("/Ocean"))


def test_a_stage_has_the_times_and_bounds_of_every_frame(ocean):
    ocean.bake("-o out/sea.usda --frames 1-4")
    stage = Usd.Stage.Open(str(ocean.folder / "out/sea.usda"))
    assert UsdGeom.GetStageUpAxis(stage) == "Z" and UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    assert (stage.GetStartTimeCode(), stage.GetEndTimeCode()) == (1.0, 4.0)
    assert stage.GetTimeCodesPerSecond() == 24.0
    assert stage.GetDefaultPrim().GetName() == "Ocean"
    mesh = mesh_of(stage)
    foam = UsdGeom.PrimvarsAPI(mesh).GetPrimvar("foam")
    assert foam.GetInterpolation() == "vertex" and mesh.GetNormalsInterpolation() == "vertex"
    assert mesh.GetSubdivisionSchemeAttr().Get() == "none"
    assert mesh.GetPointsAttr().GetTimeSamples() == [1.0, 2.0, 3.0, 4.0]
    # Bounds of each frame, of the mesh and of the model that it is.
    model = UsdGeom.ModelAPI(mesh.GetPrim())
    assert mesh.GetPrim().HasAPI(UsdGeom.ModelAPI) and mesh.GetPrim().IsModel()
    for frame in range(1, 5):
        box = mesh.GetExtentAttr().Get(frame)
        assert box == UsdGeom.PointBased.ComputeExtent(mesh.GetPointsAttr().Get(frame))
        assert box == model.GetExtentsHint(frame)
        assert box == UsdGeom.Boundable.ComputeExtentFromPlugins(mesh, frame)
    assert mesh.GetExtentAttr().Get(1) != mesh.GetExtentAttr().Get(4)
    # The label over the period, one for all frames.
    assert not UsdGeom.PrimvarsAPI(mesh).GetPrimvar("st").ValueMightBeTimeVarying()
    # Motion between frames is the velocity's.
    points, velocity = (
        numpy.array(each.Get(2)) for each in (mesh.GetPointsAttr(), mesh.GetVelocitiesAttr())
    )
    moved = numpy.array(mesh.ComputePointsAtTime(2.5, 2))
    assert abs(moved - points - velocity / 48).max() < 1e-4
    assert abs(velocity).max() > 0.3
    # The sea is in it.
    data = stage.GetRootLayer().customLayerData
    assert "jonswap" in data["ocean:sea"] and data["ocean:resolution"] == str(N)


def test_rates_steps_axes_and_what_is_asked_for(ocean):
    ocean.bake("-o out/sea.usda --frames 10-30x10 --fps 25 --axes yup --products foam")
    stage = Usd.Stage.Open(str(ocean.folder / "out/sea.usda"))
    assert UsdGeom.GetStageUpAxis(stage) == "Y" and stage.GetTimeCodesPerSecond() == 25.0
    mesh = mesh_of(stage)
    assert mesh.GetPointsAttr().GetTimeSamples() == [10.0, 20.0, 30.0]
    assert mesh.GetVelocitiesAttr().Get(20) is None
    assert not mesh.GetNormalsAttr().HasAuthoredValue()
    ocean.bake("-o z.usda --frames 20 --fps 25 --products foam")
    turned = numpy.array(mesh.GetPointsAttr().Get(20))
    assert (numpy.array(mesh.GetExtentAttr().Get(20)) == [turned.min(0), turned.max(0)]).all()
    upright = Usd.Stage.Open(str(ocean.folder / "z.usda"))
    points = numpy.array(mesh_of(upright).GetPointsAttr().Get(20))
    assert (turned == points[:, [0, 2, 1]] * [1, 1, -1]).all()


def test_shards_write_the_same_and_a_gap_is_told(ocean):
    whole = ["bake", "sea.toml", "--frames", "1-6", "-o"]
    ocean.good(*whole, "out/sea.usda")
    first = ocean(*whole, "parts/sea.usda", "--shard", "1/3")
    assert first.returncode == 0 and "do not exist yet" in first.stderr and "3-6" in first.stderr
    told = ocean("check parts/sea.usda")
    assert told.returncode == 1 and "sea.manifest.2of3.json: shard 2 of 3" in told.stdout
    stage = (ocean.folder / "parts/sea.usda").read_bytes()
    ocean.good(*whole, "parts/sea.usda", "--shard", "2/3")
    assert (ocean.folder / "parts/sea.usda").read_bytes() == stage
    last = ocean(*whole, "parts/sea.usda", "--shard", "3/3")
    assert "do not exist yet" not in last.stderr
    ocean.merge("parts/sea.usda")
    out, parts = ocean.hashes("out"), ocean.hashes("parts")
    shared = {"sea.usda", "sea.clips.usda", "sea.topology.usdc"}
    frames = {f"sea.{frame:04}.usdc" for frame in range(1, 7)}
    assert {name for name in out if name.endswith(("usda", "usdc"))} == shared | frames
    assert out == parts


def time_codes(ocean, name="out/sea.usda"):
    """The stage's range, and the frames that its points have as USD itself reads them."""
    stage = Usd.Stage.Open(str(ocean.folder / name))
    return (
        stage.GetStartTimeCode(),
        stage.GetEndTimeCode(),
        mesh_of(stage).GetPointsAttr().GetTimeSamples(),
    )


def test_chunks_in_any_order_and_twice_are_the_stage_of_all(ocean):
    for chunk in ("4-6", "1-3", "1-3", "4-6"):
        ocean.bake("-o out/sea.usda --frames", chunk)
    assert time_codes(ocean) == (1.0, 6.0, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0])
    ocean.bake("-o whole/sea.usda --frames 1-6")
    assert ocean.hashes("out") == ocean.hashes("whole")
    # Steps that meet, chunks that overlap.
    for chunk in ("1-9x4", "3-7x4", "1-3x2"):
        ocean.bake("-o steps/sea.usda --frames", chunk)
    assert time_codes(ocean, "steps/sea.usda") == (1.0, 9.0, [1.0, 3.0, 5.0, 7.0, 9.0])


def test_a_gap_between_chunks_shows_no_other_file_and_is_told(ocean):
    """Frames 4-6 are of another sea: a template of clips would show them."""
    ocean.bake("-o out/sea.usda --frames 4-6 --set seed=2")
    first = ocean("bake sea.toml -o out/sea.usda --frames 1-3 --overwrite")
    left_out = "of another sea or of other options: 4-6; out/sea.usda leaves them out"
    assert first.returncode == 0 and left_out in first.stderr
    assert time_codes(ocean) == (1.0, 3.0, [1.0, 2.0, 3.0])
    second = ocean("bake sea.toml -o out/sea.usda --frames 7-9 --overwrite")
    assert left_out in second.stderr and "do not exist yet" in second.stderr
    assert time_codes(ocean) == (1.0, 9.0, [1.0, 2.0, 3.0, 7.0, 8.0, 9.0])
    stage = Usd.Stage.Open(str(ocean.folder / "out/sea.usda"))
    points = mesh_of(stage).GetPointsAttr()
    assert (numpy.array(points.Get(7)) != numpy.array(points.Get(3))).any()
    mean = (numpy.array(points.Get(3)) + numpy.array(points.Get(7))) / 2
    assert numpy.array(points.Get(5)) == pytest.approx(mean, abs=1e-4)
    del stage, points  # USD reads a layer anew when nobody holds it any more
    assert '"missing": [4,5,6]' in (ocean.folder / "out/sea.manifest.json").read_text()
    done = ocean("bake sea.toml -o out/sea.usda --frames 4-6 --overwrite")
    assert "leaves them out" not in done.stderr and "do not exist yet" not in done.stderr
    ocean.bake("-o whole/sea.usda --frames 1-9")
    assert ocean.hashes("out") == ocean.hashes("whole")
    # A frame that was deleted is a gap again; what has other products or rate is another sea's.
    (ocean.folder / "out/sea.0002.usdc").unlink()
    assert "yet" in ocean("bake sea.toml -o out/sea.usda --frames 9").stderr
    assert time_codes(ocean)[2] == [1.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]
    for options in (["--products", "foam"], ["--fps", "25"], ["--axes", "yup"]):
        said = ocean("bake sea.toml -o out/sea.usda --frames 9 --overwrite", *options).stderr
        assert "1, 3-8; out/sea.usda leaves them out" in said
        assert time_codes(ocean)[2] == [9.0]


def test_chunks_at_the_same_time_lose_none(ocean):
    runs = [
        subprocess.Popen(
            [OCEAN, "bake", "sea.toml", "-o", "out/sea.usda", "--frames", chunk, "-q"]
            + ["--threads", "1", "--products", "position"],
            cwd=ocean.folder,
            stdout=subprocess.DEVNULL,
        )
        for chunk in ("1-8", "9-16", "17-24", "25-32", "9-16")
    ]
    assert [run.wait(timeout=120) for run in runs] == [0] * 5
    assert time_codes(ocean) == (1.0, 32.0, [float(frame) for frame in range(1, 33)])
    ocean.bake("-o whole/sea.usda --frames 1-32 --products position")
    assert ocean.hashes("out") == ocean.hashes("whole")


def test_names_with_quotes_and_at_signs_are_found(ocean):
    for stem in ('Fünen @ "Ost"', "a@@b"):
        for chunk in ("1-2", "5-6"):
            ocean.bake("-o", f"{stem}.usda", "--frames", chunk, "--products", "position")
        assert time_codes(ocean, f"{stem}.usda")[2] == [1.0, 2.0, 5.0, 6.0]
        ocean.bake("-o", f"{stem}.usda", "--frames", "3-4", "--products", "position")
        assert time_codes(ocean, f"{stem}.usda")[2] == [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]


def test_a_file_that_is_cut_off_anywhere_is_refused(ocean):
    ocean.bake("-o a.usda --frames 3 --resolution 32")
    whole = (ocean.folder / "a.0003.usdc").read_bytes()
    for size in range(0, len(whole), max(1, len(whole) // 40)):
        cut = ocean.write("cut.usdc", whole[:size])
        assert "cut.usdc" in ocean.bad("bake --from cut.usdc -o b.usda")
        with pytest.raises(Exception, match=r"."):
            if Sdf.Layer.OpenAsAnonymous(str(cut)) is None:
                raise ValueError("refused")


def test_a_large_frame_is_little_more_than_its_floats(ocean):
    ocean.bake("-o a.usda --frames 1 --resolution 1024")
    size = (ocean.folder / "a.0001.usdc").stat().st_size
    assert size < 1.02 * 1025 * 1025 * 10 * 4


FERRY = """
libocean = 1
[grid]
resolution = 64
patch_size = 200.0
[[hulls]]
length = 20.0
beam = 6.0
draught = 1.0
wake_resolution = 64
track = [[-60.0, -480.0, 0.0], [60.0, 480.0, 0.0]]
"""


def test_each_frame_is_cut_where_its_hull_is(ocean):
    (ocean.folder / "ferry.toml").write_text(FERRY)
    bake = ["bake", "ferry.toml", "--region=-30,-10,60,20", "--cell", "1", "--frames", "1-25x24"]
    ocean.good(*bake, "--products", "foam", "--cut-hulls", "-o", "out/sea.usda")
    ocean.good(*bake, "--products", "position", "--cut-hulls", "-o", "cut/sea.####.ply")
    ocean.good(*bake, "--products", "dry", "-o", "whole/sea.####.ply")
    stage = Usd.Stage.Open(str(ocean.folder / "out/sea.usda"))
    mesh = mesh_of(stage)
    assert not UsdGeom.PrimvarsAPI(mesh).GetPrimvar("st").ValueMightBeTimeVarying()
    assert not UsdGeom.PrimvarsAPI(mesh).GetPrimvar("dry")
    for frame, middle in ((1, 0.0), (25, 8.0)):
        counts = mesh.GetFaceVertexCountsAttr().Get(frame)
        corners = mesh.GetFaceVertexIndicesAttr().Get(frame)
        points = numpy.array(mesh.GetPointsAttr().Get(frame))
        assert UsdGeom.Mesh.ValidateTopology(corners, counts, len(points))
        assert (numpy.array(counts) == 3).all()
        triangles = numpy.array(corners).reshape(-1, 3)
        cut = meshio.read(ocean.folder / f"cut/sea.{frame:04}.ply")
        assert (triangles == cut.cells_dict["triangle"]).all() and not cut.point_data.get("dry")
        # The squares whose diagonal lies inside are gone, and no others.
        whole = meshio.read(ocean.folder / f"whole/sea.{frame:04}.ply")
        squares = whole.cells_dict["triangle"].reshape(-1, 6)
        kept = (whole.point_data["dry"][squares[:, 1:3]] < 0.5).any(1)
        assert (triangles.reshape(-1, 6) == squares[kept]).all()
        assert 50 < (~kept).sum() < 80  # of 80 m2, less the line
        centres = points[triangles].mean(1)
        assert not ((abs(centres[:, 0] - middle) < 5) & (abs(centres[:, 1]) < 1)).any()
    refused = ocean("bake", "ferry.toml", "--cut-hulls", "-o", "sea.ply")
    assert refused.returncode == 2 and "it needs --region" in refused.stderr
    # Its own file says how it was made.
    ocean.good("bake", "--from", "cut/sea.0025.ply", "-o", "again.ply")
    assert (ocean.folder / "again.ply").read_bytes() == (
        ocean.folder / "cut/sea.0025.ply"
    ).read_bytes()
