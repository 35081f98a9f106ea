# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension for Blender 4.2 and later: Blender's own tool finds it valid, and it installs into
an empty profile and works there without any program of the system: PATH is empty."""

import os
import subprocess
import sys
from pathlib import Path

import bpy
import other_blender
import pytest
from conftest import in_another_blender

pytestmark = pytest.mark.skipif(
    bpy.app.version < (4, 2), reason="Blender before 4.2 has no extensions"
)


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
    in_another_blender(
        *(other_blender.install_extension, tmp_path / "baked.blend"),
        BLENDER_USER_RESOURCES=str(profile),
        PATH="",
    )
