# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Python modules in folders that Python does not look into. No Blender in here."""

from __future__ import annotations

import importlib
import importlib.util
import sys
from importlib.machinery import PathFinder
from pathlib import Path


def load(name: str, folder: Path):
    """Returns the module of that name in a folder, or otherwise one that Python finds. `sys.path`
    stays as it is. Raises ImportError."""
    spec = None if name in sys.modules else PathFinder.find_spec(name, [str(folder)])
    if spec is None:
        return importlib.import_module(name)
    module = sys.modules[name] = importlib.util.module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
    except BaseException:
        del sys.modules[name]
        raise
    return module
