# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean farm`: the files of a job bake the bytes of one machine and replace no other file."""

import json

import pytest

OUTPUT = "out/s.####.exr"
FRAMES = ("--frames", "1-5,8")
FILES = {
    "slurm": ["bake.sbatch", "check.sbatch", "sea.toml", "submit.sh"],
    "openjd": [
        "asset_references.yaml",
        "parameter_values.yaml",
        "sea.toml",
        "template.yaml",
        "template_shards.yaml",
    ],
    "flamenco": ["job.json", "ocean_bake.js", "sea.toml", "submit.sh"],
}


def farm(engine, *more):
    return ("farm sea.toml -o", OUTPUT, *FRAMES, "--engine", engine, *more)


@pytest.mark.parametrize("engine", FILES)
def test_a_job_is_a_folder_of_its_own(ocean, engine):
    told = json.loads(ocean.good(*farm(engine, "--tasks", "3", "-n", "--json")))
    assert (told["tasks"], told["frames_per_task"], told["frames"]) == (3, 2, 6)
    assert not (ocean.folder / "farm").exists()
    text = ocean.good(*farm(engine, "--tasks", "3"))
    assert text.startswith("tasks    3 of at most 2 of 6 frames, then a check\n")
    assert ocean.files("farm") == FILES[engine]
    # Another job replaces all files of this one, and no other.
    for mine in ("farm/mine.yaml", "farm/render.sbatch"):
        ocean.write(mine, "mine")
    other = "openjd" if engine == "slurm" else "slurm"
    ocean.good(*farm(other, "--minutes", "1"))
    assert ocean.files("farm") == sorted([*FILES[other], "mine.yaml", "render.sbatch"])


def test_scripts_of_slurm_bake_the_bytes_of_one_machine(ocean):
    options = ("--products", "displacement,foam", "--resolution", "32")
    sea = ("--set", "wind_speed=11", "--fps", "30")
    ocean.good("bake sea.toml -q -o", "whole/s.####.exr", *FRAMES, *options, *sea)
    name = 'it\'s a $HOME "sea".####.exr'
    for output, job in (("s.####.exr", "parts"), (name, "odd 'job'")):
        command = ("farm sea.toml -o", output, *FRAMES, "--engine", "slurm", "--tasks", "3")
        ocean.good(*command, "--job", job, *options, *sea)
        for script in ("bake.sbatch", "bake.sbatch", "check.sbatch"):
            tasks = "3 1 2" if script == "bake.sbatch" else "1"
            done = ocean.shell(
                f"cd {json.dumps(job)} && for i in {tasks}; do"
                f" SLURM_ARRAY_TASK_ID=$i sh {script} || exit 1; done"
            )
            assert done.returncode == 0, done.stderr
        assert done.stdout.startswith("12 of 12 files are whole")
    whole = ocean.hashes("whole")
    assert whole.items() <= ocean.hashes("parts").items()
    images = {digest for name, digest in whole.items() if name.endswith(".exr")}
    assert images <= set(ocean.hashes("odd 'job'").values())


def test_what_farm_itself_prints_is_no_option_of_the_job(ocean):
    ocean.good(*farm("openjd", "--json", "--verbose"))
    template = (ocean.folder / "farm/template.yaml").read_text()
    assert "--json" not in template and "--verbose" not in template
    running = ocean.good("farm --help").split("Running:")[1]
    assert running.count("--threads") == running.count("--json") == 1


def test_a_lost_frame_turns_the_check_red(ocean):
    ocean.good(*farm("slurm", "--tasks", "2", "--threads", "1"))
    bake = "cd farm && for i in 1 2; do SLURM_ARRAY_TASK_ID=$i sh bake.sbatch || exit 1; done"
    assert ocean.shell(bake).returncode == 0
    next((ocean.folder / "farm/out").glob("*.0003.exr")).unlink()
    done = ocean.shell("cd farm && sh check.sbatch")
    assert done.returncode == 1 and done.stdout.startswith("missing")
    assert ocean.shell(f"{bake} && sh check.sbatch").returncode == 0
