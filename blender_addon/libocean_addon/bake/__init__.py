# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bakes: the sea of each frame as EXR files, and objects that play them."""
