# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sea of an object: its parameters, its open handle, its meshes and node group."""
