# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The terrain of an object: its parameters, its open handle, its node group, material and panel."""
