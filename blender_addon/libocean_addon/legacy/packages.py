# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Python packages that lie in the zip, a folder for each version of Python. No Blender in here."""

from __future__ import annotations

import sys
from importlib.machinery import PathFinder
from pathlib import Path

from ..shared import modules

_FOLDER = Path(__file__).parents[1] / "bundled" / f"cp{sys.version_info[0]}{sys.version_info[1]}"


def load(name: str):
    """Returns a package of the zip, or, without that zip, one that Python finds. Raises
    ImportError."""
    return modules.load(name, _FOLDER)


def load_bundled(name: str):
    """Returns a package of the zip, never another one that Python finds: with OpenEXR 3.5.3 of PyPI
    Debian's Blender 3.4 ended in a segmentation fault. Raises ImportError."""
    if name not in sys.modules and PathFinder.find_spec(name, [str(_FOLDER)]) is None:
        raise ModuleNotFoundError(f"No module named {name!r} in {_FOLDER}", name=name)
    module = load(name)
    if _FOLDER not in Path(module.__file__).parents:
        raise ImportError(f"{module.__file__} is not that of the add-on", name=name)
    return module
