# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The bakes of ten frames that several tests share."""

import contextlib
import json
import os
import subprocess
import sys

import pytest

FRAMES = "1-10"
# Frames without foam are baked in parallel, those with foam in order.
PLAIN = ["--products", "displacement,normal"]
# A short foam history, which would otherwise take longer than all the rest of a small bake.
SHORT_FOAM = ["--set", "foam_lifetime=0.1"]
BAKE_SOME = ["bake", "sea.toml", "--frames", FRAMES, "-o"]
BAKE = ["bake", "sea.toml", *PLAIN, "--frames", FRAMES, "-o"]


BOAT = """
[[hulls]]
length = 10.0
beam = 2.5
draught = 0.6
wake_resolution = 64
"""
TRACK = "track = [[-60.0, -240.0, 0.0], [0.0, 0.0, 0.0], [60.0, 200.0, 100.0]]\n"


def pattern(folder):
    return f"{folder}/s.####.exr"


def events(done):
    return [json.loads(line) for line in done.stderr.splitlines()]


@contextlib.contextmanager
def small_disk(folder, size):
    """A file system of `size` bytes at `folder`/disk."""
    disk = folder / "disk"
    disk.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", f"size={size}", "none", str(disk)]
    done = subprocess.run(mount, capture_output=True, text=True)
    if done.returncode != 0:
        pytest.skip(f"a tmpfs cannot be mounted here: {done.stderr.strip()}")
    try:
        yield disk
    finally:
        subprocess.run(["umount", str(disk)], check=True)


def ran_in_a_namespace(ocean, request) -> bool:
    """Returns true if the test ran again as root in a user name space: only root may mount."""
    if os.geteuid() == 0:
        return False
    if subprocess.run(["unshare", "-rm", "true"], capture_output=True).returncode != 0:
        pytest.skip("this user is not root, and user name spaces are not allowed here")
    pytest_again = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider"]
    done = subprocess.run(
        ["unshare", "-rm", *pytest_again, f"--basetemp={ocean.folder}/again", request.node.nodeid],
        cwd=request.config.rootpath,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout
    return True
