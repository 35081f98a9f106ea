# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Job files are what engines take: their own checker, and their own way to compile a job."""

import json
from pathlib import Path

import jobs

GRAPH = Path(__file__).with_name("flamenco_graph.js")


def test_open_job_description_takes_both_templates(tmp_path):
    for render in ("", "scene.pov", "shot.blend"):
        job = jobs.write_job(tmp_path / render, "openjd", range(1, 11), render=render)
        for template in ("template.yaml", "template_shards.yaml"):
            told = jobs.run(jobs.OPENJD, "check", template, folder=job)
            assert "passes validation checks" in told


def test_flamenco_compiles_the_job_to_its_tasks(tmp_path):
    job = jobs.write_job(tmp_path, "flamenco", range(1, 11), render="scene.pov")
    told = json.loads(jobs.run("node", GRAPH, "ocean_bake.js", "job.json", folder=job))
    tasks = {task["name"]: task for task in told["tasks"]}
    bakes = [f"bake-{part}of4" for part in range(1, 5)]
    renders = [f"render-{frame}" for frame in range(1, 11)]
    assert told["type"] == "ocean-bake"
    assert list(tasks) == [*bakes, "check", *renders]
    assert [tasks[name]["dependencies"] for name in bakes] == [[]] * 4
    assert tasks["check"]["dependencies"] == bakes
    assert all(tasks[name]["dependencies"] == ["check"] for name in renders)
    for part, name in enumerate(bakes, 1):
        (command,) = tasks[name]["commands"]
        assert command["parameters"]["exe"] == "{ocean}"
        assert command["parameters"]["args"][-2:] == ["--shard", f"{part}/4"]
        assert {"--skip-existing", "displacement", "1-10"} <= set(command["parameters"]["args"])
    assert "--merge" in tasks["check"]["commands"][0]["parameters"]["args"]


def test_flamenco_renders_a_blend_file_in_chunks(tmp_path):
    job = jobs.write_job(tmp_path, "flamenco", range(1, 11), render="shot.blend")
    told = json.loads(jobs.run("node", GRAPH, "ocean_bake.js", "job.json", folder=job))
    renders = [task for task in told["tasks"] if task["type"] == "blender"]
    frames = [task["commands"][0]["parameters"]["args"] for task in renders]
    assert frames == [["--render-frame", each] for each in ("1..3", "4..6", "7..9", "10")]
    assert [task["commands"][0]["steps"] for task in renders] == [3, 3, 3, 1]
