# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A file of an earlier version of the add-on shows the sea that it showed."""

import lzma
from pathlib import Path

import bpy
import numpy as np
import pytest
from conftest import attribute, positions, rest, sea_of
from libocean_addon.bake import bake_record
from libocean_addon.sea import node_group, parameter_values
from libocean_addon.shared import modifier_groups

OLD = Path(__file__).parents[1] / "data" / "blender" / "version_1.blend.xz"


@pytest.fixture
def old_file(tmp_path):
    path = tmp_path / "old.blend"
    path.write_bytes(lzma.decompress(OLD.read_bytes()))
    return path


@pytest.fixture
def old(old_file):
    bpy.ops.wm.open_mainfile(filepath=str(old_file))
    bpy.context.scene.frame_set(50)
    return bpy.data.objects


def test_the_file_is_old(old_file):
    """Else the tests below would say nothing."""
    with bpy.data.libraries.load(str(old_file)) as (found, _):
        assert {name.split(" ")[0] for name in found.node_groups} == {".libocean.v1"}


@pytest.mark.parametrize("name", ["Ocean", "Horizon"])
def test_its_node_groups_become_todays(old, name):
    (modifier,) = node_group.modifiers(old[name])
    assert modifier.node_group[node_group.MARK] == node_group.VERSION
    assert not [group for group in bpy.data.node_groups if node_group.is_old(group) and group.users]
    old[name].rotation_euler.z = 0.5  # which the old ones did not know
    bpy.context.view_layer.update()
    assert modifier_groups.value(modifier, "Turn")[2] == pytest.approx(0.5)


def test_its_sea_is_the_same(old):
    ob = old["Ocean"]
    settings = ob.libocean
    assert settings.problem == ""
    assert (settings.resolution, settings.viewport_resolution) == (32, 64)
    assert (settings.resolution_list, settings.viewport_resolution_list) == ("32", "64")
    assert len(ob.data.vertices) == 33**2
    with sea_of(ob) as sea:
        surface = sea.surface(49 / 24, 64)
        index = (np.arange(33) * 2 - 32) % 64
        want = surface.displacement[np.ix_(index, index)].reshape(-1, 3)
        assert np.abs(positions(ob) - rest(ob) - want).max() < 1e-5
        foam = surface.foam[np.ix_(index, index)].ravel()
        assert np.abs(attribute(ob, "foam") - foam).max() < 1e-6


def test_a_bake_of_its_sea_is_its_own(old):
    """The recipe is what the add-on of commit 2c77838 wrote into the file beside such a bake: a key
    that came later is not in it."""
    settings = old["Ocean"].libocean
    assert bake_record.recipe(settings, parameter_values.values_of(settings)) == "554f321c96da373b"


def test_what_floats_in_it_floats(old):
    boat = old["Boat"]
    assert tuple(boat.delta_location) == (0.0, 0.0, 0.0)
    assert len(boat.constraints) == 1
    matrix = np.array(boat.matrix_world)
    with sea_of(old["Ocean"]) as sea:
        pose = sea.float_pose([(10, -5, 30, 8, 8)], 49 / 24)
    assert matrix[:3, 3] == pytest.approx((10, -5, pose.position[0][2]), abs=1e-4)
    assert np.abs(matrix[:3, 2] - pose.up[0]).max() < 1e-5
