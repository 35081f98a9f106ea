# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The asset library: made in a folder of the user's, by this Blender and so for it, and made known
to the Asset Browser.

    hidden Blender (write_assets.py) -> seas.blend   catalogues -> blender_assets.cats.txt

Nothing of the user's is written over: a file that has not been made here, or has been changed
since, stays, and catalogues are added to those that are there. What is open is not touched.
"""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import bpy

from ..shared import compat, messages, paths, registration
from ..shared.compat import tr, tr_label
from ..shared.drawing import say
from ..shared.native import ADDON
from ..volumes.volumes import ocean_command
from . import assets

FILE = "seas.blend"
CATALOGS = "blender_assets.cats.txt"
DIGEST = "seas.blend.sha256"
"""Beside the file: as which it was made."""
_SECONDS = 300  # that the hidden Blender may take; it takes a few

_HEADER = "# This is an Asset Catalog Definition file for Blender.\n\nVERSION 1\n"


class LibraryError(Exception):
    """Why there is no library; for the user."""


def default_folder() -> Path:
    return Path(bpy.utils.user_resource("DATAFILES", path="libocean_assets"))


# The catalogues -----------------------------------------------------------------


def with_catalogs(text: str) -> str:
    """Returns the text of a file of catalogues with ours in it. A catalogue of ours that the file
    has already stays as it is, since it may have been renamed."""
    if not text:
        text = _HEADER
    lines = [line.strip() for line in text.splitlines()]
    said = [line for line in lines if line and not line.startswith("#")]
    if not said or said[0] != "VERSION 1":
        raise LibraryError(tr("{} is no file of asset catalogues that is known", CATALOGS))
    known = {line.split(":")[0].lower() for line in said}
    if not text.endswith("\n"):
        text += "\n"
    for identifier, path in assets.CATALOGS.values():
        if identifier not in known:
            text += f"{identifier}:{path}:{path.replace('/', '-')}\n"
    return text


def _read_text(path: Path) -> str:
    """Reads a text and keeps its line ends."""
    return path.read_bytes().decode("utf-8") if path.exists() else ""


def _replace(files: dict[Path, bytes]) -> None:
    """Writes all files, or none if the disk is full."""
    parts = {path: path.with_name(f".{path.name}.part") for path in files}
    try:
        for path, data in files.items():
            parts[path].write_bytes(data)
        for path, part in parts.items():
            os.replace(part, path)
    finally:
        for part in parts.values():
            part.unlink(missing_ok=True)


# The file -----------------------------------------------------------------------


def _digest(path: Path) -> bytes:
    return hashlib.sha256(path.read_bytes()).hexdigest().encode()


def _require_ours(folder: Path) -> None:
    """Returns whether a present file may be replaced."""
    file, note = folder / FILE, folder / DIGEST
    if file.exists() and not (note.exists() and note.read_bytes().strip() == _digest(file)):
        raise LibraryError(
            tr("{} was not made here, or has been changed: choose another folder", file)
        )


def _written(folder: Path) -> bytes:
    """The file, made by a hidden Blender."""
    path = folder / FILE
    start = [sys.executable]  # of the Python module bpy
    if bpy.app.binary_path:
        start = [bpy.app.binary_path, "--background", "--factory-startup"]
        start += ["--python-exit-code", "1", "--python"]
    script = Path(__file__).with_name("write_assets.py")
    done = subprocess.run(
        [*start, script, "--", path, *sys.path],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        errors="replace",
        timeout=_SECONDS,
        creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
    )
    if done.returncode != 0 or not path.exists():
        print(done.stdout)
        said = done.stdout.strip().splitlines() or [""]
        raise LibraryError(tr("Blender could not write the seas: {}", said[-1]))
    return path.read_bytes()


def make(folder: Path) -> None:
    """Makes the library in that folder. Raises LibraryError or OSError; existing files are
    unchanged then."""
    folder.mkdir(parents=True, exist_ok=True)
    _require_ours(folder)
    try:
        catalogs = with_catalogs(_read_text(folder / CATALOGS))
    except UnicodeDecodeError:
        raise LibraryError(
            tr("{} is no file of asset catalogues that is known", CATALOGS)
        ) from None
    with tempfile.TemporaryDirectory() as scratch:
        try:
            data = _written(Path(scratch))
        except subprocess.TimeoutExpired as late:
            raise LibraryError(tr("Blender could not write the seas: {}", late)) from None
    digest = hashlib.sha256(data).hexdigest()
    _replace(
        {
            folder / DIGEST: f"{digest}\n".encode(),
            folder / FILE: data,
            folder / CATALOGS: catalogs.encode("utf-8"),
        }
    )


# In Blender ---------------------------------------------------------------------


class MakeAssetLibrary(bpy.types.Operator):
    """Make a folder of seas and skies for the Asset Browser, and add it to its libraries. Seas and
    skies that were made there before are made again"""

    bl_idname = "libocean.make_asset_library"
    bl_label = "Make Asset Library"

    directory: bpy.props.StringProperty(
        name="Folder",
        description="Where the library goes; empty: among the user's data files of Blender",
        subtype="DIR_PATH",
        options={"SKIP_SAVE"},
    )

    def execute(self, context):
        folder = paths.absolute(self.directory) if self.directory else default_folder()
        if context.window is not None:
            context.window.cursor_set("WAIT")
        try:
            make(folder)
        except LibraryError as failure:
            self.report({"ERROR"}, str(failure))
            return {"CANCELLED"}
        except OSError as failure:
            self.report({"ERROR"}, messages.of_file(failure))
            return {"CANCELLED"}
        finally:
            if context.window is not None:
                context.window.cursor_set("DEFAULT")
        compat.add_asset_library("libocean", folder)
        self.report({"INFO"}, tr("{} assets are in {}", len(assets.table()), folder))
        return {"FINISHED"}


class OceanPreferences(bpy.types.AddonPreferences):
    """Preferences of the add-on"""

    bl_idname = ADDON

    asset_folder: bpy.props.StringProperty(
        name="Folder",
        description="Where the asset library goes; empty: among the user's data files of Blender",
        subtype="DIR_PATH",
    )
    if ocean_command is not None:
        ocean_command: bpy.props.StringProperty(
            name="Command ocean",
            description="Writes volumes where this Blender has no module of OpenVDB; empty: the "
            "command ocean of the system",
            subtype="FILE_PATH",
        )

    def draw(self, _context) -> None:
        layout = self.layout
        layout.label(text="Seas and skies for the Asset Browser")
        layout.prop(self, "asset_folder")
        if not self.asset_folder:
            layout.label(text=tr_label("Now: {}", default_folder()), translate=False)
        made = layout.operator(MakeAssetLibrary.bl_idname, icon="ASSET_MANAGER")
        made.directory = self.asset_folder
        if ocean_command is not None:
            layout.prop(self, "ocean_command")
        if not compat.has_denoiser():
            say(layout, compat.no_denoiser(), "INFO")


CLASSES = (MakeAssetLibrary, OceanPreferences)


def _draw_menu(self, _context) -> None:
    self.layout.separator()
    self.layout.operator(MakeAssetLibrary.bl_idname, icon="MOD_OCEAN")


register, unregister = registration.functions(CLASSES, menus={compat.ASSET_MENU: _draw_menu})
