# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Jobs for each engine, of a small sea or as docs/farm.md writes them, and a scene to render."""

import json
import os
import re
import subprocess
from pathlib import Path

import libocean

ROOT = Path(__file__).resolve().parents[2]
OPENJD = ROOT / ".venv/bin/openjd"
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
# The scene that Blender begins with, in 16 x 16 pixels; its pictures lie beside it.
BLEND = """import bpy
scene = bpy.context.scene
scene.render.engine = "CYCLES"
scene.cycles.samples = 1
scene.cycles.use_denoising = False
scene.render.resolution_x = scene.render.resolution_y = 16
scene.render.filepath = "//scene"
bpy.ops.wm.save_as_mainfile(filepath="{}")
"""


def write_job(folder: Path, engine: str, frames: range, **how) -> Path:
    how = {"frames_per_task": 3, "options": ["--products", "displacement"]} | how
    job = folder / engine
    libocean.parse(SEA).write_farm_job(job, engine, "out/sea.####.exr", frames, **how)
    (job / "scene.pov").write_text(SCENE)
    return job


def write_scene(path: Path) -> None:
    path.parent.mkdir(exist_ok=True)
    if path.suffix == ".pov":
        path.write_text(SCENE)
    else:
        run("blender", "-b", "--factory-startup", "--python-exit-code", 1, "--python-expr",
            BLEND.format(path), folder=path.parent)  # fmt: skip


def of_page(folder: Path, engine: str) -> tuple[str, Path]:
    """Makes what a reader of the page has. Returns the page's commands for an engine, and the
    folder of the job that they write."""
    block = rf"^```sh\n(ocean farm [^\n]* --engine {engine} --job (\w+) --render (\S+)\n.*?)^```$"
    page = (ROOT / "docs/farm.md").read_text()
    commands, job, scene = re.search(block, page, re.MULTILINE | re.DOTALL).groups()
    (folder / "sea.toml").write_text(run("ocean", "presets", "beaufort_6", folder=folder))
    write_scene(folder / job / scene)
    return commands, folder / job


def flamenco_graph(script: Path, job: Path) -> dict:
    """Returns what Flamenco's manager makes of a job type and a job."""
    graph = Path(__file__).with_name("flamenco_graph.js")
    return json.loads(run("node", graph, script, job, folder=job.parent))


def run(*words, folder: Path) -> str:
    programs = f"{Path(os.environ['OCEAN']).parent}:{os.environ['PATH']}:{OPENJD.parent}"
    environment = os.environ | {"PATH": programs}
    done = subprocess.run(
        [str(word) for word in words], cwd=folder, env=environment, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=600,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout
    return done.stdout
