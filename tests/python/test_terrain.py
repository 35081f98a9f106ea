# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Terrains through the Python wrapper."""

import numpy as np
import pytest

import libocean


@pytest.fixture
def land():
    with libocean.terrain(resolution=128, patch_size=1280.0, rms=20.0, mean=300.0) as terrain:
        yield terrain


def test_a_terrain_has_what_was_asked_for(land):
    assert land.surface(512).height.shape == (512, 512)
    surface = land.surface()
    assert surface.height.shape == (128, 128) and surface.normal.shape == (128, 128, 3)
    assert surface.height.std() == pytest.approx(20.0, rel=1e-5)
    assert surface.height.mean() == pytest.approx(300.0, abs=1e-3)
    assert land.state["rms"]["resolved"] == pytest.approx(20.0, rel=1e-6)
    slope = np.arccos(surface.normal[..., 2])
    steep = np.arctan(np.hypot(surface.slope[..., 0], surface.slope[..., 1]))
    np.testing.assert_allclose(slope, steep, atol=1e-3)


def test_queries_meet_the_map_at_any_distance(land):
    heights = land.surface().height
    j, i = np.random.default_rng(3).integers(0, 128, (2, 200))
    points = np.column_stack([10.0 * i + 12800.0, 10.0 * j - 1280.0])
    exact = land.query(points, exact=True)
    np.testing.assert_allclose(exact.height, heights[j, i], atol=1e-3)
    found = land.query(points)
    assert np.std(found.height - exact.height) < 2e-3 * 20.0
    assert found.height_error < 1e-3 * 20.0
    np.testing.assert_allclose(np.linalg.norm(found.normal, axis=1), 1.0, atol=1e-6)


def test_stages_end_in_the_height(land):
    height = land.surface().height
    assert np.std(land.stage("height") - height) < 2e-6 * 20.0 + 1e-5
    assert land.stage("noise").std() == pytest.approx(1.0, abs=0.03)
    filtered = land.stage("filtered")
    assert np.sqrt(np.sum(filtered.astype(float) ** 2)) == pytest.approx(20.0, rel=1e-5)
    # The transform of the height, which numpy finds, is the filtered one.
    found = np.abs(np.fft.fftshift(np.fft.fft2(height - 300.0))) / 128**2
    np.testing.assert_allclose(found[1:, 1:], filtered[1:, 1:], atol=2e-4)
    with pytest.raises(libocean.InvalidValueError, match="unknown step"):
        land.stage("smoke")


def test_presets_and_parameters(land):
    assert "tujunga" in libocean.terrain_presets()
    with libocean.terrain_preset("seed_smooth") as preset:
        assert preset.get("beta") == "2.4"
    rows = {row["key"]: row for row in libocean.terrain_parameters()}
    assert rows["breaks"]["type"] == "pairs" and rows["range"]["type"] == "numbers"
    land.set("breaks", [(300.0, 2.5), (20.0, 1.9)])
    assert land.get("breaks") == "[[300, 2.5], [20, 1.9]]"
    assert "ocean:terrain" in land.provenance("height")


def test_what_a_terrain_does_not_have_is_refused(land):
    with pytest.raises(libocean.UnsupportedError, match="a terrain has no channel foam"):
        land.surface(fields=["foam"])
    with pytest.raises(libocean.InvalidValueError, match="terrain.beta"):
        land.set("beta", 9)
    with pytest.raises(libocean.InvalidValueError, match="unknown parameter"):
        libocean.terrain(wind_speed=9)
    surface = land.surface()
    land.set("beta", 2.5)
    with pytest.raises(libocean.InvalidValueError, match="the terrain was changed"):
        surface._field("height")


def test_buffers_with_a_seam_are_filled(land):
    buffer = np.empty((129, 129, 4), np.float32)
    land.fill([(buffer, ("height", "nx", "ny", "nz"))], seam=True)
    np.testing.assert_array_equal(buffer[:128, :128, 0], land.surface().height)
    np.testing.assert_array_equal(buffer[128], buffer[0])
    np.testing.assert_array_equal(buffer[:, 128], buffer[:, 0])


PLACED = """libocean = 1
[terrain]
kind = "placed"
resolution = 64
patch_size = 640.0
size = [640.0, 320.0]
[terrain.gullies]
longest = 150.0
"""


def test_a_region_fills_arrays_of_the_host():
    with libocean.parse_terrain(PLACED) as land:
        want = land.region((32.0, 64.0), (20, 10), 2.0, ["height", "normal", "wear"])
        ground = np.full((10, 20, 4), 7.0, np.float32)
        wear = np.full((10, 20, 2), 7.0, np.float32)
        buffers = [(ground, ("nx", "ny", "nz", "height")), (wear, ("wear", ""))]
        land.fill_region(buffers, (32.0, 64.0), 2.0)
        assert np.array_equal(ground[..., 3], want["height"])
        assert np.array_equal(ground[..., :3], want["normal"])
        assert np.array_equal(wear[..., 0], want["wear"]) and (wear[..., 1] == 7.0).all()
        with pytest.raises(libocean.Error, match="rows, 20"):
            land.fill_region([(ground[..., :2], ("height", "nx"))], (0.0, 0.0), 2.0)
        with pytest.raises(libocean.Error, match="one shape"):
            land.fill_region(
                [(ground, ("nx", "ny", "nz", "height")), (wear[1:], ("wear", ""))], (0.0, 0.0), 2.0
            )


def test_a_mesh_around_a_camera_ends_at_the_edge():
    with libocean.parse_terrain(PLACED) as land:
        mesh = land.mesh((100.0, 100.0, 50.0), spacing=4.0, farthest=1000.0)
        low, high = mesh.positions.min(axis=0), mesh.positions.max(axis=0)
        assert tuple(low[:2]) == (0.0, 0.0) and high[0] == pytest.approx(640.0)
        assert mesh.corners.max() == len(mesh.positions) - 1
        a, b, c = (mesh.positions[mesh.corners[:, k], :2] for k in range(3))
        area = 0.5 * np.cross(b - a, c - a)
        assert area.min() > 0.0 and area.sum() == pytest.approx(640.0 * high[1])
        near = np.hypot(*(mesh.positions[:, :2] - (100.0, 100.0)).T) < 100.0
        height = land.query(mesh.positions[near, :2], resolution=161).height
        assert np.abs(height - mesh.positions[near, 2]).max() < 0.05


def test_a_shaped_land_says_how_far_it_is():
    told = []
    text = PLACED.replace("[terrain.gullies]\nlongest = 150.0\n", "[terrain.stream]\n")
    with libocean.parse_terrain(text, progress=lambda *now: told.append(now)) as land:
        land.region((0.0, 0.0), (8, 8), 10.0)
    assert told and {total for _, total in told} == {1000}
    assert max(done for done, _ in told) == 1000
