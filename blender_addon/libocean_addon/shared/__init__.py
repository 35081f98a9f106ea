# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared by all entities: Blender across its versions, messages, images, nodes."""
