# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of the zip for Blender before 4.2 that the extension must not have: packages in a folder
of the add-on, and a command outside Blender. package.py leaves it out of the extension."""
