# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension for Blender 4.2 and later: Blender's own tool finds it valid, and it installs into
an empty profile and works there without any program of the system: PATH is empty."""

import os
import subprocess
import sys
from pathlib import Path

import bpy
import pytest
from conftest import in_another_process

pytestmark = pytest.mark.skipif(
    bpy.app.version < (4, 2), reason="Blender before 4.2 has no extensions"
)

INSTALL = """
assert os.environ["PATH"] == ""
before = list(sys.path)
bpy.ops.extensions.package_install_files(
    filepath=os.environ["OCEAN_EXTENSION"],
    repo="user_default",
    enable_on_install=True,
    overwrite=True,
)
bpy.ops.libocean.add(kind="PATCH", preset="beaufort_6")
ob = bpy.context.object
bpy.context.scene.frame_set(20)
mesh = ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
heights = [vertex.co.z for vertex in mesh.vertices]
import libocean
assert max(heights) - min(heights) > 1.0
assert "site-packages" in libocean.__file__, libocean.__file__
assert ob.libocean.problem == ""

ob.libocean.resolution = 64
bpy.ops.wm.save_as_mainfile(filepath=arguments[0])
bpy.ops.libocean.bake(frame_start=1, frame_end=1)
import OpenEXR
assert "site-packages" in OpenEXR.__file__, OpenEXR.__file__
assert ob.libocean.use_bake

from bl_ext.user_default.libocean.shared import compat
from bl_ext.user_default.libocean.volumes import volumes
assert volumes.ocean_command is None
preferences = bpy.context.preferences.addons["bl_ext.user_default.libocean"].preferences
assert not hasattr(preferences, "ocean_command")
try:
    told = bpy.ops.libocean.write_volumes(frame_start=1, frame_end=1)
except RuntimeError as failure:
    told = str(failure)
if compat.load_openvdb() is None:
    assert bpy.app.version < (4, 5) and "has no OpenVDB module" in told, told
else:
    assert told == {"FINISHED"}, told
    assert any(other.type == "VOLUME" for other in bpy.data.objects)
sites = [folder for folder in sys.path if folder not in before]
assert all(folder.endswith("site-packages") and ".local" in folder for folder in sites), sites

bpy.ops.libocean.add_scene(preset="beaufort_6", near_detail=False)
bpy.ops.libocean.add_terrain(preset="tujunga")
assert bpy.context.object.libocean_terrain.problem == ""
"""


def test_blenders_tool_finds_it_valid():
    scripts = Path(bpy.utils.system_resource("SCRIPTS"))
    tool = scripts / "addons_core" / "bl_pkg" / "cli" / "blender_ext.py"
    checked = subprocess.run(
        [sys.executable, tool, "validate", os.environ["OCEAN_EXTENSION"]],
        capture_output=True,
        text=True,
    )
    assert checked.returncode == 0, checked.stdout + checked.stderr


def test_it_installs_into_an_empty_profile_and_works(tmp_path, monkeypatch):
    for name in list(os.environ):
        if name.startswith("BLENDER_USER"):
            monkeypatch.delenv(name)
    profile = tmp_path / "profile"
    profile.mkdir()
    in_another_process(
        tmp_path, INSTALL, tmp_path / "baked.blend", BLENDER_USER_RESOURCES=str(profile), PATH=""
    )
