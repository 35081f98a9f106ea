#!/usr/bin/python3
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Lists the tests that exceeded their budgets of CPU seconds, or runs each of them once more.

usage: over_budget.py REPORT                 prints a line for each test of the report
       over_budget.py REPORT --judge BUILD   runs each, alone, by the ctest of that build folder

cpu_budget.py writes the report. The exit status of --judge is 1 if a test takes over twice its
budget when nothing else runs, or fails.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

FACTOR = "2"  # times the budget: what is above it, no busy machine explains


def passes(name: str, build: str) -> bool:
    """Runs a test alone and prints its seconds, or all of its output if it fails."""
    environment = {key: text for key, text in os.environ.items() if key != "OCEAN_BUDGET_REPORT"}
    done = subprocess.run(
        ["ctest", "--test-dir", build, "-R", f"^{re.escape(name)}$", "--no-tests=error", "-V"],
        env=environment | {"OCEAN_BUDGET_FACTOR": FACTOR},
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
    )  # fmt: skip
    seconds = re.search(r"cpu_budget: (.* s of .* s)$", done.stdout, re.M)
    if done.returncode == 0 and seconds:
        print(f"{name} alone: {seconds[1]}, within {FACTOR} times its budget", flush=True)
        return True
    # scripts/test counts the lines of ctest's own summary: these are no such lines.
    print("".join(f"| {line}\n" for line in done.stdout.splitlines()), end="")
    print(f"{name} alone: FAILED, above {FACTOR} times its budget or wrong", flush=True)
    return False


def main() -> int:
    report, *judge = sys.argv[1:]
    lines = Path(report).read_text().splitlines() if Path(report).exists() else []
    if judge:
        names = dict.fromkeys(line.split()[0] for line in lines)
        failed = [name for name in names if not passes(name, judge[1])]
        return 1 if failed else 0
    for line in lines:
        name, seconds, budget = line.split()
        print(f"  {name}: {seconds} s of the processor, of a budget of {budget} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
