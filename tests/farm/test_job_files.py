# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Job files are what engines take: their own checker, and their own way to compile a job."""

import json

import jobs


def test_open_job_description_takes_both_templates(tmp_path):
    for render in ("", "scene.pov", "shot.blend"):
        job = jobs.write_job(tmp_path / render, "openjd", range(1, 11), render=render)
        for template in ("template.yaml", "template_shards.yaml"):
            told = jobs.run(jobs.OPENJD, "check", template, folder=job)
            assert "passes validation checks" in told


def test_flamenco_compiles_the_job_to_its_tasks(tmp_path):
    job = jobs.write_job(tmp_path, "flamenco", range(1, 11), render="scene.pov")
    told = jobs.flamenco_graph(job / "ocean_bake.js", job / "job.json")
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
        assert {"--skip-existing", "--products=displacement", "1-10"} <= set(
            command["parameters"]["args"]
        )
    assert "--merge" in tasks["check"]["commands"][0]["parameters"]["args"]


def test_flamenco_renders_a_blend_file_in_chunks(tmp_path):
    job = jobs.write_job(tmp_path, "flamenco", range(1, 11), render="shot.blend")
    told = jobs.flamenco_graph(job / "ocean_bake.js", job / "job.json")
    renders = [task for task in told["tasks"] if task["type"] == "blender"]
    frames = [task["commands"][0]["parameters"]["args"] for task in renders]
    assert frames == [["--render-frame", each] for each in ("1..3", "4..6", "7..9", "10")]
    assert [task["commands"][0]["steps"] for task in renders] == [3, 3, 3, 1]


def test_options_of_a_bake_are_settings_of_flamenco_by_their_names(tmp_path):
    options = ["--products", "height,foam", "--resolution=64", "--overwrite", "--threads=2"]
    options += ["--sun", "-5,90", "--box", "0,0,-1,9,9,crest"]
    job = jobs.write_job(tmp_path, "flamenco", range(1, 11), options=options)
    settings = json.loads((job / "job.json").read_text())["settings"]
    asked = {"products": "height,foam", "resolution": "64", "overwrite": True, "sun": "-5,90"}
    assert asked.items() <= settings.items()
    assert settings["options"] == "--threads=2 --box 0,0,-1,9,9,crest"
    told = jobs.flamenco_graph(job / "ocean_bake.js", job / "job.json")
    args = told["tasks"][0]["commands"][0]["parameters"]["args"]
    words = ["--overwrite", "--products=height,foam", "--resolution=64", "--sun=-5,90"]
    words += ["--threads=2", "--box", "0,0,-1,9,9,crest"]
    assert sorted(args[5 : args.index("--frames")]) == sorted(words)
    assert {"region", "cell", "type", "axes", "layout", "compression"} <= set(told["settings"])
