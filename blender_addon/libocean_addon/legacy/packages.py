# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Python packages that lie in the zip, a folder for each version of Python. No Blender in here."""

from __future__ import annotations

import sys
from pathlib import Path

from ..shared import modules

_FOLDER = Path(__file__).parents[1] / "bundled" / f"cp{sys.version_info[0]}{sys.version_info[1]}"


def load(name: str):
    """Returns a package of the zip, or, without that zip, one that Python finds. Raises
    ImportError."""
    return modules.load(name, _FOLDER)
