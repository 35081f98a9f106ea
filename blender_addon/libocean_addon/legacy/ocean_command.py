# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `ocean`, which writes volumes where a Blender before 4.2 has no module of OpenVDB.
No Blender in here."""

from __future__ import annotations

import dataclasses
import json
import os
import shutil
import subprocess
import tempfile
import threading
from pathlib import Path

from ..volumes.volume_job import StoppedError, VolumeError

_FLAGS = getattr(subprocess, "CREATE_NO_WINDOW", 0)


@dataclasses.dataclass(frozen=True)
class Command:
    """An `ocean` that writes volumes."""

    path: str

    def run(
        self, arguments: list[str], folder: Path, sea: str, stop: threading.Event
    ) -> list[dict]:
        """Runs `ocean bake --json` for a frame and returns the events that it reports. sea: the
        text at its standard input. Raises VolumeError, and StoppedError when `stop` is set."""
        with tempfile.TemporaryFile() as given, tempfile.TemporaryFile() as told:
            given.write(sea.encode())
            given.seek(0)
            process = subprocess.Popen(
                [self.path, *arguments, "--json"],
                cwd=folder,
                stdin=given,
                stdout=subprocess.DEVNULL,
                stderr=told,
                creationflags=_FLAGS,
            )
            while process.poll() is None:
                if stop.wait(0.02):
                    process.terminate()  # it leaves whole files only
                    process.wait()
            told.seek(0)
            lines = told.read().decode(errors="replace").splitlines()
        if stop.is_set():
            raise StoppedError
        events = [json.loads(line) for line in lines if line.startswith("{")]
        if process.returncode != 0:
            said = [event["message"] for event in events if event["event"] == "error"]
            raise VolumeError((said or lines or [f"{self.path}: {process.returncode}"])[-1])
        return events


def _writes_volumes(path: str) -> bool:
    """Returns whether a command is libocean's and was built with OpenVDB."""
    try:
        told = subprocess.run(
            [path, "bake", "--help"], capture_output=True, timeout=30, creationflags=_FLAGS
        )
    except (OSError, subprocess.TimeoutExpired):
        return False
    return told.returncode == 0 and b".vdb" in told.stdout


def find(name: str) -> Command | None:
    """Returns the command at that path, or of that name in the system's PATH, where it is one that
    writes volumes."""
    path = shutil.which(name)
    if path is None or not _writes_volumes(path):
        return None
    return Command(os.path.abspath(path))
