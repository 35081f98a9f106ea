# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A SLURM of one controller and two nodes, each of which has its own processes, mounts and name."""

import contextlib
import os
import signal
import subprocess
import time
from pathlib import Path

DEADLINE = 120.0  # s; a guard against a farm that hangs
# cred_expire: as long waits a task whose node was lost
CONFIGURATION = """ClusterName=farm
SlurmctldHost=farm(10.9.9.1)
SlurmUser=root
SlurmdUser=root
SlurmdParameters=config_overrides
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
SlurmdTimeout=10
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool.%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.%n.log
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0,bf_interval=1
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
DefMemPerCPU=1
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
JobCompType=jobcomp/filetxt
JobCompLoc={folder}/jobs
ReturnToService=2
NodeName=n1 NodeAddr=10.9.9.1 Port=7001 CPUs=2 RealMemory=8000
NodeName=n2 NodeAddr=10.9.9.1 Port=7002 CPUs=2 RealMemory=8000
PartitionName=ocean Nodes=n1,n2 Default=YES State=UP
"""


def wait_for(what: str, state):
    """Returns what `state` returns once that is true."""
    end = time.monotonic() + DEADLINE
    while not (value := state()):
        assert time.monotonic() < end, f"in vain: {what}"
        time.sleep(0.02)
    return value


class Node:
    """A slurmd as process 1 of its own namespaces; its disks are those of the farm."""

    def __init__(self, farm: "Farm", name: str):
        self.farm, self.name = farm, name
        self.start()

    def start(self) -> None:
        # The shell reaps what slurmd leaves; -b tells the controller that the node was off.
        self.process = self.farm.daemon(
            f"{self.name}.out", "unshare", "--mount", "--uts", "--pid", "--fork", "--kill-child",
            "--mount-proc", "bash", "-c", f"hostname {self.name}; slurmd -b -D; exit",
        )  # fmt: skip

    def lose_power(self) -> None:
        """Ends all processes of the node at once."""
        self.process.kill()
        self.process.wait()

    def come_back(self) -> None:
        """Starts again, once the controller has noticed the loss."""
        wait_for(
            f"{self.name} is down",
            lambda: "down" in self.farm.tell(f"sinfo -h -n {self.name} -o %T"),
        )
        self.start()

    def first_process(self) -> int:
        children = Path(f"/proc/{self.process.pid}/task/{self.process.pid}/children")
        return int(wait_for(f"{self.name} runs", lambda: children.read_text().split())[0])

    def run(self, *command) -> None:
        """Runs a command in the mounts of the node."""
        words = [
            "nsenter",
            f"--target={self.first_process()}",
            "--mount",
            "--pid",
            *map(str, command),
        ]
        subprocess.run(words, check=True)

    @contextlib.contextmanager
    def mounts(self, place: Path, *mount):
        """A mount that this node alone has."""
        self.run("mount", *mount, place)
        yield
        self.run("umount", place)

    def runs(self, program: Path):
        """Makes this the `ocean` of the node."""
        return self.mounts(self.farm.program, "--bind", program)

    def writers(self) -> dict[int, list[str]]:
        """The processes of bakes on this node, with the images that they are writing."""
        own = os.readlink(f"/proc/{self.first_process()}/ns/pid")
        found = {}
        for process in Path("/proc").glob("[0-9]*"):
            try:
                if os.readlink(process / "ns/pid") != own:
                    continue
                if (process / "comm").read_text() != "ocean\n":
                    continue
                links = [os.readlink(one) for one in (process / "fd").iterdir()]
            except OSError:
                continue  # it has ended
            found[int(process.name)] = [one for one in links if ".exr.ocean-" in one]
        return found

    def lose_power_within_a_frame(self) -> None:
        def lost() -> bool:
            for pid in self.writers():
                try:
                    os.kill(pid, signal.SIGSTOP)
                    if self.writers().get(pid):
                        self.lose_power()
                        return True
                    os.kill(pid, signal.SIGCONT)
                except ProcessLookupError:
                    pass
            return False

        wait_for(f"{self.name} is within a frame", lost)


class Farm:
    """The controller and its nodes. `folder` has their files, and bin/ocean, which tasks run."""

    def __init__(self, folder: Path, ocean: str):
        self.folder = folder
        folder.chmod(0o755)  # munged wants it
        for name in ("state", "spool.n1", "spool.n2", "bin"):
            (folder / name).mkdir()
        self.program = self.variant("ocean", f'exec {ocean} "$@"')
        (folder / "key").write_bytes(os.urandom(128))
        (folder / "key").chmod(0o400)
        (folder / "slurm.conf").write_text(CONFIGURATION.format(folder=folder))
        # The scripts of a job would take OCEAN instead of the program that a node has.
        inherited = {name: value for name, value in os.environ.items() if name != "OCEAN"}
        self.environment = inherited | {
            "SLURM_CONF": f"{folder}/slurm.conf", "PATH": f"{folder}/bin:{os.environ['PATH']}",
        }  # fmt: skip
        files = {"key-file": "key", "socket": "munge.socket", "pid-file": "munge.pid",
                 "log-file": "munge.log", "seed-file": "seed"}  # fmt: skip
        self.daemon(
            "munge.out", "munged", "--foreground", "--force",
            *(f"--{option}={folder}/{name}" for option, name in files.items()),
        )  # fmt: skip
        wait_for("munged", (folder / "munge.socket").exists)
        self.daemon("slurmctld.out", "slurmctld", "-D")
        self.nodes = [Node(self, name) for name in ("n1", "n2")]
        self.wait_for_nodes()

    def wait_for_nodes(self) -> None:
        wait_for("two nodes are up", lambda: self.tell("sinfo -N -h -o %T").count("idle") == 2)

    def daemon(self, log: str, *command) -> subprocess.Popen:
        with (self.folder / log).open("ab") as out:
            return subprocess.Popen(command, env=self.environment, stdout=out, stderr=out)

    def tell(self, *words, folder: Path | None = None) -> str:
        """What a command of SLURM, the first words of which may be a line, prints; "" if it fails
        because the controller is not up."""
        done = subprocess.run(
            [*words[0].split(), *map(str, words[1:])], cwd=folder, env=self.environment,
            capture_output=True, text=True, timeout=DEADLINE, check=False,
        )  # fmt: skip
        return done.stdout.strip()

    def variant(self, name: str, script: str) -> Path:
        """A program that runs a line of bash."""
        path = self.folder / "bin" / name
        path.write_text(f"#!/bin/bash\n{script}\n")
        path.chmod(0o755)
        return path

    def wait(self) -> None:
        """Waits until no job is left."""
        wait_for("all jobs end", lambda: self.tell("sinfo -h") and not self.tell("squeue -h"))

    def states(self, job: str) -> dict[str, list[str]]:
        """The states in which the tasks of a job ended, by their numbers, as SLURM has logged them;
        "" is the number of a job without tasks."""
        ended: dict[str, list[str]] = {}
        for line in (self.folder / "jobs").read_text().splitlines():
            told = dict(word.partition("=")[::2] for word in line.split())
            if told.get("ArrayJobId", told["JobId"]) == job:
                ended.setdefault(told.get("ArrayTaskId", ""), []).append(told["JobState"])
        return ended
