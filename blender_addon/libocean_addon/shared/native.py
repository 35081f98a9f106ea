# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The library: bundled with the add-on, or installed as the Python package libocean. It needs
NumPy, which Debian's Blender lacks unless its package is installed."""

from __future__ import annotations

ADDON = __package__.rpartition(".")[0]
"""The add-on's own package, by which Blender knows its preferences."""

libocean = None
problem = ""
"""The reason why the library is missing; "" with the library."""
lacks_numpy = False

try:
    import numpy  # noqa: F401
except ModuleNotFoundError as failure:
    problem, lacks_numpy = str(failure), True
except ImportError as failure:  # of another Python, say
    problem = str(failure)
else:
    try:
        try:
            from ..bundled import libocean
        except ModuleNotFoundError:
            import libocean  # noqa: F401
    except ImportError as failure:
        problem = str(failure)
