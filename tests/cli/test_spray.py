# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Spray as PLY, read by meshio: particles with ids that last, the same however they are baked."""

import json

import meshio
import numpy
import pytest
from conftest import GALE

import libocean

SPRAY = ("--products", "spray")


@pytest.fixture
def gale(ocean):
    ocean.write("gale.toml", GALE)
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


@pytest.mark.parametrize("frame", [1, 12])
def test_the_particles_are_those_of_the_library(gale, frame):
    gale.good("bake gale.toml -o s.ply", *SPRAY, "--frames", frame)
    found = read(gale.folder / "s.ply")
    with libocean.open(gale.folder / "gale.toml") as sea:
        expected = sea.spray(sea.time_of_frame(frame))
    assert len(expected.id) > 100 and (found["id"] == expected.id).all()
    assert abs(found["point"] - expected.position).max() < 1e-4
    for name in ("velocity", "age", "life", "radius"):
        assert (found[name] == getattr(expected, name)).all(), name


def test_the_spray_of_a_region_has_the_drops_of_the_bow_wave(gale):
    sea_file = gale.folder / "hull.toml"
    low_waves = "significant_wave_height = 0.05\n[[hulls]]\nfactor = 8.0\nwake_resolution = 64\n"
    sea_file.write_text(GALE + low_waves + "track = [[-20, -160, 0], [20, 160, 0]]\n")
    options = "--region=-50,-20,80,40 --cell 2 --spray-lifetime 0.3 --spray-density 40"
    white = "--set foam_coverage=threshold --set foam_threshold=0.85"
    gale.good("bake hull.toml -o s.ply --frames 3", *SPRAY, *options.split(), *white.split())
    found = read(gale.folder / "s.ply")
    with libocean.open(sea_file) as sea:
        sea.set_all({"foam_coverage": "threshold", "foam_threshold": 0.85})
        settings = {"lifetime": 0.3, "density": 40.0}
        expected = sea.spray(2.0 / 24.0, region=(-50.0, -20.0, 80.0, 40.0), **settings)
        assert len(sea.spray(2.0 / 24.0, **settings).id) == 0
    assert len(expected.id) > 20 and (found["id"] == expected.id).all()
    assert abs(found["point"] - expected.position).max() < 1e-5


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
