# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The coast of an object: the water of a sea over a bed, which ends at the waterline, and the land
behind it."""
