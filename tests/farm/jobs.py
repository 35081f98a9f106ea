# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A job for each engine, of a small sea and a scene of POV-Ray."""

import os
import subprocess
from pathlib import Path

import libocean

OPENJD = Path(__file__).resolve().parents[2] / ".venv/bin/openjd"
SEA = """\
libocean = 1
[grid]
resolution = 32
patch_size = 100.0
[[waves]]
wind_speed = 9.0
"""
SCENE = """\
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -3> look_at 0 }
light_source { <2, 4, -3> rgb 1 }
sphere { 0, 1 pigment { rgb <0, 0.3, 1> } }
"""


def write_job(folder: Path, engine: str, frames: range, **how) -> Path:
    how = {"frames_per_task": 3, "options": ["--products", "displacement"]} | how
    job = folder / engine
    libocean.parse(SEA).write_farm_job(job, engine, "out/sea.####.exr", frames, **how)
    (job / "scene.pov").write_text(SCENE)
    return job


def run(*words, folder: Path) -> str:
    ocean = Path(os.environ["OCEAN"]).parent
    environment = os.environ | {"PATH": f"{ocean}:{os.environ['PATH']}"}
    done = subprocess.run(
        [str(word) for word in words], cwd=folder, env=environment, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout
    return done.stdout
