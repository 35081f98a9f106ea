# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The samples per side of a sea's maps and meshes."""

from __future__ import annotations

from ..shared.resolutions import Resolutions
from .parameter_values import PARAMETERS

OF_SEA = Resolutions(PARAMETERS, "As many as the sea needs")
