# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Runs a test's command and reports a command that passes but exceeds its budget of CPU seconds.

usage: cpu_budget.py NAME SECONDS COMMAND [ARGUMENT...]
       cpu_budget.py --scale      prints how much slower than the reference this machine is

CMakeLists.txt of this folder puts it before each test's command, so that no test grows in silence.
NAME is the test's name in ctest; one that ends in a dot is completed by the --gtest_filter.
What counts is the processor time of the command and of all processes that it waited for: other
work on the machine costs little of it. Budgets are seconds of the reference machine, about twice
of what a test takes there; OCEAN_CPU_SCALE, which scripts/test sets from --scale, multiplies them.

The exit status is the command's: a slow machine has no fault of the product. A command above its
budget appends the line "NAME SECONDS BUDGET" to the file that OCEAN_BUDGET_REPORT names, from which
scripts/test tells it. OCEAN_BUDGET_FACTOR makes a verdict of it: the exit status is then 1 above
that many times the budget.
"""

import os
import resource
import signal
import subprocess
import sys
import time

# CPU seconds of `fixed_work` on the reference machine: two cores of an AMD EPYC of 2022.
REFERENCE_SECONDS = 0.05


def fixed_work() -> float:
    """Returns the CPU seconds of a loop that is the same on every machine."""
    start = time.process_time()
    total = 0
    for number in range(1_000_000):
        total += number * number % 7
    return time.process_time() - start


def scale() -> float:
    """Returns the factor for budgets: 1 on the reference machine and on faster ones."""
    return max(1.0, sorted(fixed_work() for _ in range(5))[2] / REFERENCE_SECONDS)


def full_name(name: str, command: list[str]) -> str:
    """Returns the test's name in ctest, of a GoogleTest case by the filter that selects it."""
    selected = [word for word in command if word.startswith("--gtest_filter=")]
    return name + selected[-1].partition("=")[2] if name.endswith(".") and selected else name


def judge(name: str, seconds: float, budget: float) -> int:
    """Reports a command that passed above its budget; returns its exit status."""
    print(
        f"cpu_budget: OVER BUDGET by {seconds - budget:.2f} s of the processor; make the test"
        " cheaper, or raise its BUDGET in tests/*/CMakeLists.txt and say why in the commit"
    )
    report = os.environ.get("OCEAN_BUDGET_REPORT")
    if report:
        with open(report, "a", encoding="utf-8") as file:
            file.write(f"{name} {seconds:.2f} {budget:g}\n")
    factor = os.environ.get("OCEAN_BUDGET_FACTOR")
    if factor and seconds > float(factor) * budget:
        print(f"cpu_budget: FAILED, above {factor} times the budget")
        return 1
    return 0


def main() -> int:
    if sys.argv[1:] == ["--scale"]:
        print(f"{scale():.2f}")
        return 0
    name, budget, command = sys.argv[1], float(sys.argv[2]), sys.argv[3:]
    if "--gtest_list_tests" in command:
        os.execv(command[0], command)  # CMake reads the names, which are all that it prints
    budget *= float(os.environ.get("OCEAN_CPU_SCALE", "1"))
    child = subprocess.Popen(command)
    # An interrupt reaches the child too, and the child says how it ends.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, lambda *_: child.terminate())
    status = child.wait()
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = used.ru_utime + used.ru_stime
    print(f"cpu_budget: {seconds:.2f} s of {budget:g} s", flush=True)
    if status < 0:
        print(f"cpu_budget: ended by {signal.Signals(-status).name}", flush=True)
        return 128 - status
    if status == 0 and seconds > budget:
        return judge(full_name(name, command), seconds, budget)
    return status


if __name__ == "__main__":
    sys.exit(main())
