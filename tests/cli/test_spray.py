# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Spray as PLY, read by meshio: particles with ids that last, the same however they are baked."""

import json

import meshio
import numpy
import pytest
from conftest import GALE

SPRAY = ("--products", "spray")
FPS = 24.0


@pytest.fixture
def gale(ocean):
    ocean.write("gale.toml", GALE)
    ocean.write("loop.toml", GALE + "\n[time]\nloop_period = 2.0\n")
    return ocean


def read(path) -> dict:
    """The attributes of the particles by name, with `id` and `point`."""
    mesh = meshio.read(path)
    particles = dict(mesh.point_data)
    assert particles["id_low"].dtype == numpy.uint32
    particles["id"] = particles["id_low"] + (particles["id_high"].astype(numpy.uint64) << 32)
    particles["point"] = mesh.points
    particles["velocity"] = numpy.stack([particles[name] for name in ("vx", "vy", "vz")], -1)
    return particles


def expect_to_go_on(first, second) -> None:
    """Checks that particles persist until their end, and that new ones were born since."""
    assert len(first["id"]) > 100 and len(set(first["id"])) == len(first["id"])
    ends = first["age"] + 1 / FPS >= first["life"] - 1e-6
    there = numpy.isin(first["id"], second["id"])
    assert (there | ends).all()
    known = numpy.isin(second["id"], first["id"])
    assert (second["age"][~known] < 1 / FPS + 1e-6).all()
    # The same particles, further on.
    order = {value: i for i, value in enumerate(first["id"])}
    before = numpy.array([order[value] for value in second["id"][known]])
    assert (first["life"][before] == second["life"][known]).all()
    assert (first["radius"][before] == second["radius"][known]).all()
    assert abs(second["age"][known] - first["age"][before] - 1 / FPS).max() < 1e-6
    way = second["point"][known] - first["point"][before]
    mean = 0.5 * (second["velocity"][known] + first["velocity"][before])
    # A parabola through both ends: old particles hardly accelerate any more.
    old = first["age"][before] > 0.5
    assert old.sum() > 20
    assert abs(way - mean / FPS)[old].max() < 0.05


def test_ids_persist_from_frame_to_frame(gale):
    gale.good("bake gale.toml -o out/s.####.ply", *SPRAY, "--frames", "1-12")
    frames = [read(gale.folder / f"out/s.{frame:04}.ply") for frame in range(1, 13)]
    for first, second in zip(frames, frames[1:], strict=False):
        expect_to_go_on(first, second)
    particles = frames[0]
    assert particles["point"][:, 2].min() > -3.0 and particles["point"][:, 2].max() < 10.0
    assert particles["radius"].min() > 20e-6 and particles["radius"].max() < 600e-6
    # The wind blows at 30 degrees.
    mean = particles["velocity"].mean(0)
    assert abs(numpy.degrees(numpy.arctan2(mean[1], mean[0])) - 30) < 5
    assert 10 < numpy.hypot(mean[0], mean[1]) < 20


def test_a_loop_runs_into_its_first_frame(gale):
    gale.good("bake loop.toml -o out/s.####.ply", *SPRAY, "--frames", "1,2,48,49")
    frame = {number: read(gale.folder / f"out/s.{number:04}.ply") for number in (1, 2, 48, 49)}
    expect_to_go_on(frame[1], frame[2])
    expect_to_go_on(frame[48], frame[1])
    assert set(frame[49]["id"]) == set(frame[1]["id"])


def test_a_mesh_and_spray_are_made_of_each_others_files(gale):
    options = ["--spray-lifetime", "1.5", "--spray-density", "0.7", "--axes", "yup"]
    gale.good("bake gale.toml -o a.ply", *SPRAY, *options, "--set", "seed=4")
    assert read(gale.folder / "a.ply")["age"].max() < 1.5
    # Its sea as a mesh, without the options of spray.
    gale.good("bake --from a.ply -o mesh.ply --products normal")
    assert len(meshio.read(gale.folder / "mesh.ply").points) == 129 * 129
    gale.good("bake --from mesh.ply -o c.ply", *SPRAY, *options)
    assert (gale.folder / "a.ply").read_bytes() == (gale.folder / "c.ply").read_bytes()


def test_y_up_turns_places_and_velocities(gale):
    for axes in ("zup", "yup"):
        gale.good("bake gale.toml -o", f"{axes}.ply", *SPRAY, "--axes", axes)
    z, y = (read(gale.folder / name) for name in ("zup.ply", "yup.ply"))
    assert (y["id"] == z["id"]).all()
    for name in ("point", "velocity"):
        assert (y[name] == z[name][:, [0, 2, 1]] * [1, 1, -1]).all()


def test_a_dry_run_says_what_it_takes(gale):
    gale.good("bake gale.toml -o s.ply", *SPRAY)
    size = (gale.folder / "s.ply").stat().st_size

    def plan(*more):
        done = gale("bake gale.toml -o s.ply", *SPRAY, "-n", "--json", *more)
        assert done.returncode == 0, done.stderr
        return json.loads(done.stderr.splitlines()[-1])

    usual = plan()
    assert size <= usual["bytes"] < 8 * size
    assert plan("--spray-density", "25")["memory_bytes"] > usual["memory_bytes"]
    few = plan("--spray-density", "25", "--spray-most", "1000")
    assert few["bytes"] < 1000 * 44 + 8192
    # A calm sea has none, and its file says so.
    gale.good("bake gale.toml -o calm.ply", *SPRAY, "--set", "wind_speed=5")
    assert b"element vertex 0\n" in (gale.folder / "calm.ply").read_bytes()
