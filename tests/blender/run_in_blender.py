# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Installs the add-on's zip into a clean profile of the Blender that runs this, then runs pytest.

    blender --background --factory-startup --python-exit-code 1 --python run_in_blender.py \\
        -- ZIP PYTEST_ARGUMENT...

Ends the process itself: what a Python handler does at exit is not what is tested here.
"""

import os
import sys
import traceback
from pathlib import Path

import bpy


def main() -> int:
    archive, *arguments = sys.argv[sys.argv.index("--") + 1 :]
    # The profile's folder must exist before anything is installed into it.
    Path(bpy.utils.user_resource("SCRIPTS", path="addons", create=True)).mkdir(exist_ok=True)
    bpy.ops.preferences.addon_install(filepath=archive, overwrite=True)
    bpy.ops.preferences.addon_enable(module="libocean_addon")

    import pytest

    return pytest.main(["-q", "-p", "no:cacheprovider", *arguments])


try:
    status = int(main())
except BaseException:
    traceback.print_exc()
    status = 1
sys.stdout.flush()
sys.stderr.flush()
os._exit(status)
