# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Bakes as jobs of a SLURM with two nodes: whatever is lost or wrong on one of them, the frames
have the bytes of one machine, or the job ends in a named line and status 1."""

import hashlib
import os
import subprocess
from pathlib import Path

import jobs
import pytest
from slurm import Farm

OCEAN = os.environ["OCEAN"]
OPTIONS = "--products height,foam"


@pytest.fixture(scope="session")
def farm(tmp_path_factory):
    return Farm(tmp_path_factory.mktemp("farm"), OCEAN)


class Job:
    """A job that `ocean farm` writes, in a folder of its own, and its frames by one machine."""

    def __init__(self, farm: Farm, folder: Path, frames: int, shards: int, options: str = OPTIONS):
        self.farm, self.folder, self.shards = farm, folder, shards
        (folder / "asked.toml").write_text(jobs.SEA)
        what = f"asked.toml -o out/s.####.exr --frames 1-{frames} {options}"
        self.ocean(f"ocean farm {what} --engine slurm --job . --tasks {shards} --threads 1")
        self.check = f"ocean check out/s.####.exr --frames 1-{frames} --against sea.toml --merge"
        self.ocean(f"ocean bake -q {what.replace('out/', 'whole/')}")

    def ocean(self, command: str) -> subprocess.CompletedProcess:
        return subprocess.run(
            command, shell=True, cwd=self.folder, env=self.farm.environment, capture_output=True,
            text=True, check=False,
        )  # fmt: skip

    def submit(self) -> tuple[str, str]:
        """Sends the job as it is; returns the numbers of the bake and the check."""
        bake, check = self.farm.tell("sh submit.sh", folder=self.folder).split()
        return bake, check

    def send(self, tasks: str = "", node: str = "", more: str = "") -> str:
        """Sends tasks, by default all, to a node, by default to any; returns the job's number."""
        script = (self.folder / "bake.sbatch").read_text()
        (self.folder / "sent.sbatch").write_text(
            script.replace(" --skip-existing", f" --skip-existing {more}")
        )
        return self.farm.tell(
            f"sbatch --parsable --array={tasks or f'1-{self.shards}'}",
            *([f"--nodelist={node}"] if node else []), "sent.sbatch", folder=self.folder,
        )  # fmt: skip

    def send_check(self, after: str) -> str:
        return self.farm.tell(
            f"sbatch --parsable --kill-on-invalid-dep=yes --dependency=afterok:{after}",
            "check.sbatch", folder=self.folder,
        )  # fmt: skip

    def hashes(self, folder: str) -> dict[str, str]:
        return {
            path.name: hashlib.sha256(path.read_bytes()).hexdigest()
            for path in (self.folder / folder).iterdir()
        }

    def log(self, name: str) -> str:
        return (self.folder / name).read_text()

    def faults(self) -> list[str]:
        """The faults of a check, which ends with status 1 and merges nothing."""
        before = self.hashes("out")
        done = self.ocean(self.check)
        assert done.returncode == 1 and "are not merged" in done.stderr, done
        assert self.hashes("out") == before
        return done.stdout.splitlines()

    def is_whole(self) -> None:
        """Checks and merges, and compares all bytes with those of one machine."""
        done = self.ocean(self.check)
        assert done.returncode == 0, done.stdout
        assert self.hashes("out") == self.hashes("whole")


@pytest.fixture
def job(farm, tmp_path):
    return lambda *sizes: Job(farm, tmp_path, *sizes)


def test_a_bake_survives_the_loss_of_both_nodes(farm, job):
    job = job(1000, 20, "--products height")
    bake, check = job.submit()
    for node in farm.nodes:
        node.lose_power_within_a_frame()
    for node in farm.nodes:
        node.come_back()
    farm.wait()
    states = farm.states(bake)
    assert len(states) == 20 and all(each[-1] == "COMPLETED" for each in states.values()), states
    assert sum(each[0] == "NODE_FAIL" for each in states.values()) >= 2
    assert farm.states(check) == {"": ["COMPLETED"]}
    assert "1000 of 1000 files are whole" in job.log("check.log")
    assert job.hashes("out") == job.hashes("whole")


def test_all_instruction_sets_bake_the_same_bytes(farm, job):
    job = job(8, 4)
    choice = "simd=(avx512 portable sse4 avx2); OCEAN_SIMD=${simd[SLURM_ARRAY_TASK_ID - 1]}"
    program = farm.variant("old", f'{choice} exec {OCEAN} "$@"')
    with farm.nodes[1].runs(program):
        job.send(node="n2")
        farm.wait()
    job.is_whole()


def test_a_full_disk_on_one_node_stops_the_job(farm, job):
    job = job(16, 2)
    (job.folder / "out").mkdir()
    with farm.nodes[1].mounts(job.folder / "out", "-t", "tmpfs", "-o", "size=40k", "small"):
        good = job.send("1", "n1")
        bad = job.send("2", "n2")
        check = job.send_check(f"{good}:{bad}")
        farm.wait()
    assert farm.states(good) == {"1": ["COMPLETED"]}
    assert farm.states(bad) == {"2": ["FAILED"]}
    assert farm.states(check) == {"": ["CANCELLED"]}
    assert "No space left on device; " in job.log("bake.2.log")
    told = job.faults()
    assert any("shard 2 of 2 has not finished a file" in line for line in told), told
    job.send("2", "n2")  # which has the disk of all again
    farm.wait()
    job.is_whole()


def test_a_build_of_another_version_on_one_node_is_told(farm, job):
    job = job(8, 2)
    version = job.ocean("ocean --version").stdout.split()[1].encode()
    program = farm.folder / "bin" / "newer"
    # A compiler may have the text in an instruction, of four bytes and the rest.
    program.write_bytes(Path(OCEAN).read_bytes().replace(version[:4], b"9.9."))
    newer = b"9.9." + version[4:]
    program.chmod(0o755)
    with farm.nodes[1].runs(program):
        job.send("1", "n1")
        job.send("2", "n2")
        farm.wait()
    assert newer in (job.folder / "out/s.height.0005.exr").read_bytes()
    told = job.faults()
    assert sum("of other options or another version" in line for line in told) == 8, told
    job.send()  # keeps the frames of this version, and bakes the others again
    farm.wait()
    job.is_whole()


def test_a_shard_of_other_options_is_told(farm, job):
    job = job(8, 2)
    job.send("1")
    job.send("2", more="--compression zip")
    farm.wait()
    told = job.faults()
    assert sum("of other options or another version" in line for line in told) == 8, told
    job.send()
    farm.wait()
    job.is_whole()


def test_a_task_that_runs_on_both_nodes_at_once_writes_whole_files(farm, job):
    job = job(60, 2)
    tasks = [job.send("1", "n1"), job.send("1", "n2"), job.send("2", "n2"), job.send("2", "n1")]
    farm.wait()
    assert [set(*farm.states(each).values()) for each in tasks] == [{"COMPLETED"}] * 4
    job.is_whole()


def test_a_clock_that_is_off_changes_nothing(farm, job):
    job = job(8, 2)
    program = farm.variant("late", f'exec faketime -f "-400d x3" {OCEAN} "$@"')
    with farm.nodes[1].runs(program):
        job.send("2", "n2")
        farm.wait()
        job.send("1", "n1")
        job.send("2", "n2")  # finds its own files
        farm.wait()
    job.is_whole()


def test_the_commands_of_the_page_bake_check_and_render(farm, tmp_path):
    commands, job = jobs.of_page(tmp_path, "slurm")
    sent = farm.tell("bash -euc", commands, folder=tmp_path).split()[-3:]
    farm.wait()
    states = [farm.states(each) for each in sent]
    assert [len(each) for each in states] == [2, 1, 4]
    assert all(set(ended) == {"COMPLETED"} for each in states for ended in each.values()), states
    assert "4 of 4 files are whole" in (job / "check.log").read_text()
    assert len(list(job.glob("scene*.png"))) == 4
