# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Run by a hidden Blender, which asset_library.py starts: writes the asset library's file.

    blender --background --factory-startup --python write_assets.py -- FILE MODULE_PATH...

The add-on is the folder above this one, installed or not; its library may lie in one of the module
paths.
"""

import importlib.util
import os
import sys
import traceback
from pathlib import Path

import bpy


def load(name: str):
    """Loads the package that this file is in under that name."""
    folder = Path(__file__).parents[1]
    spec = importlib.util.spec_from_file_location(
        name, folder / "__init__.py", submodule_search_locations=[str(folder)]
    )
    module = sys.modules[name] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def main() -> None:
    path, *module_paths = sys.argv[sys.argv.index("--") + 1 :]
    sys.path += [folder for folder in module_paths if folder not in sys.path]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    addon = load("libocean_addon")
    addon.register()
    importlib.import_module("libocean_addon.assets.assets").write(Path(path))


try:
    main()
    status = 0
except Exception:  # its last line goes to the user
    traceback.print_exc()
    status = 1
sys.stdout.flush()
sys.stderr.flush()
os._exit(status)  # the Python module bpy of 4.2 crashes when it is left
