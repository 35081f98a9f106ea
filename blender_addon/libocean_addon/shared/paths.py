# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Paths as users write them: relative to a blend file, and with the separators of any system."""

from __future__ import annotations

import os
from pathlib import Path, PureWindowsPath

import bpy

_TO_BLEND = "//"


def is_of_windows(path: str) -> bool:
    """Returns whether a path names a drive or a server of Windows: elsewhere it leads nowhere."""
    return not path.startswith(_TO_BLEND) and PureWindowsPath(path).is_absolute()


def normal(path: str) -> str:
    """Returns a path with `/` between its parts if it is relative, whichever system it was typed
    on. An absolute path is left as it is: on its own system `\\` may be part of a name."""
    if os.path.isabs(path) and not path.startswith(_TO_BLEND) or is_of_windows(path):
        return path
    return path.replace("\\", "/")


def absolute(path: str, library=None) -> Path:
    """Returns the absolute path of a file or folder. library: the library whose file a path that
    begins with `//` is relative to; None: the open file."""
    return Path(os.path.normpath(bpy.path.abspath(normal(path), library=library)))


def write_text(path: str, text: str) -> None:
    """Writes a file where a path leads. Raises OSError."""
    with open(absolute(path), "w", encoding="utf-8") as file:
        file.write(text)


def library_of(group, key: str):
    """Returns the library that a path in a property is relative to, None for the open file. group:
    of an object's settings; an override has the paths of its library until it has its own."""
    ob = group.id_data.original
    if ob.library is not None or ob.override_library is None:
        return ob.library
    theirs = ob.override_library.reference
    try:
        is_theirs = theirs.path_resolve(group.path_from_id(key)) == getattr(group, key)
    except ValueError:  # of a wave system that the library does not have
        return None
    return theirs.library if is_theirs else None


def blend_folder() -> str | None:
    """Returns the folder of the open file, from which relative names of files in values of a sea or
    terrain start; None for a file that was never saved."""
    return bpy.path.abspath(_TO_BLEND) or None


def blend_name() -> str:
    """Returns the beginning of the names of files that belong to the open file: its own name
    without extension. `#` stands for digits of a frame in names for `ocean bake`, and is
    replaced."""
    stem = Path(bpy.data.filepath).stem
    return stem.replace("\\", "_").replace("#", "_") or "untitled"
