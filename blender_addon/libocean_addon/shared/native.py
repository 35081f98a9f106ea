# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The library: bundled with the add-on, or installed as the Python package libocean."""

from __future__ import annotations

ADDON = __package__.rpartition(".")[0]
"""The add-on's own package, by which Blender knows its preferences."""

problem = ""
"""Why there is no library; "" when there is one."""

try:
    try:
        from ..bundled import libocean
    except ModuleNotFoundError:
        import libocean
except ImportError as failure:
    libocean = None
    problem = str(failure)
