# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension for Blender 4.2 and later: Blender's own tool finds it valid, and it installs into
an empty profile and works there."""

import os
import subprocess
import sys
from pathlib import Path

import bpy
import pytest

pytestmark = pytest.mark.skipif(
    bpy.app.version < (4, 2), reason="Blender before 4.2 has no extensions"
)

INSTALL = """
import os, sys, traceback
import bpy
try:
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
    status = 0
except BaseException:
    traceback.print_exc()
    status = 1
sys.stdout.flush()
sys.stderr.flush()
os._exit(status)
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


def test_it_installs_into_an_empty_profile_and_works(tmp_path):
    script = tmp_path / "install.py"
    script.write_text(INSTALL)
    profile = tmp_path / "profile"
    profile.mkdir()
    kept = {
        name: value for name, value in os.environ.items() if not name.startswith("BLENDER_USER")
    }
    start = [sys.executable, script]
    if bpy.app.binary_path:
        start = [bpy.app.binary_path, "--background", "--factory-startup", "--python", script]
    done = subprocess.run(
        start,
        env={**kept, "BLENDER_USER_RESOURCES": str(profile)},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout + done.stderr
