# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A test above its budget passes and is reported; alone and above twice its budget it fails."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

TESTS = Path(__file__).resolve().parents[1]
WORK = ["-c", "sum(range(10_000_000))"]  # a tenth of a second
LITTLE, MUCH = "0.001", "60"  # budgets that the work exceeds and keeps


def run(command: list, **variables: str) -> subprocess.CompletedProcess:
    kept = {key: text for key, text in os.environ.items() if not key.startswith("OCEAN_")}
    return subprocess.run(command, env=kept | variables, text=True, capture_output=True)


def budgeted(budget: str, *command: str, name: str = "cli.sum", **variables: str):
    return run(
        [sys.executable, TESTS / "cpu_budget.py", name, budget, sys.executable, *command],
        **variables,
    )


def test_a_budget_exceeded_is_reported_and_no_failure(tmp_path: Path) -> None:
    report = tmp_path / "report"
    done = budgeted(LITTLE, *WORK, OCEAN_BUDGET_REPORT=str(report))
    assert done.returncode == 0
    assert "OVER BUDGET" in done.stdout
    name, seconds, budget = report.read_text().split()
    assert (name, budget) == ("cli.sum", LITTLE)
    assert float(seconds) > float(budget)
    words = run([TESTS / "over_budget.py", report]).stdout
    assert words == f"  cli.sum: {seconds} s of the processor, of a budget of {LITTLE} s\n"


def test_a_budget_kept_is_not_reported(tmp_path: Path) -> None:
    report = tmp_path / "report"
    done = budgeted(MUCH, *WORK, OCEAN_BUDGET_REPORT=str(report), OCEAN_BUDGET_FACTOR="1")
    assert done.returncode == 0
    assert "OVER BUDGET" not in done.stdout
    assert not report.exists()
    assert run([TESTS / "over_budget.py", report]).stdout == ""


def test_a_failure_stays_a_failure_above_the_budget(tmp_path: Path) -> None:
    report = tmp_path / "report"
    done = budgeted(LITTLE, "-c", f"{WORK[1]}; exit(3)", OCEAN_BUDGET_REPORT=str(report))
    assert done.returncode == 3
    assert not report.exists()


def test_the_factor_is_a_verdict() -> None:
    assert budgeted(LITTLE, *WORK, OCEAN_BUDGET_FACTOR="2").returncode == 1
    assert budgeted(LITTLE, *WORK, OCEAN_BUDGET_FACTOR="1e6").returncode == 0
    assert budgeted(LITTLE, *WORK, OCEAN_BUDGET_FACTOR="2", OCEAN_CPU_SCALE="1e6").returncode == 0


def test_a_case_of_googletest_is_reported_by_its_whole_name(tmp_path: Path) -> None:
    report = tmp_path / "report"
    case = ["--gtest_filter=All/Fft.InvertsItself/3", "--gtest_also_run_disabled_tests"]
    budgeted(LITTLE, *WORK, *case, name="unit.", OCEAN_BUDGET_REPORT=str(report))
    assert report.read_text().split()[0] == "unit.All/Fft.InvertsItself/3"


@pytest.mark.parametrize(("budget", "verdict"), [(LITTLE, 1), (MUCH, 0)])
def test_what_takes_over_twice_its_budget_alone_is_refused(
    tmp_path: Path, budget: str, verdict: int
) -> None:
    """The second run decides, of the test of that very name; a test that is gone is refused too."""
    script = TESTS / "cpu_budget.py"
    (tmp_path / "CTestTestfile.cmake").write_text(
        "".join(
            f'add_test([[{name}]] "{sys.executable}" "{script}" [[{name}]] {seconds}'
            f' "{sys.executable}" -c "{WORK[1]}")\n'
            for name, seconds in (("unit.Sum/1", budget), ("unit.Sum/10", LITTLE))
        )
    )
    report = tmp_path / "report"
    report.write_text("unit.Sum/1 9.00 4\n" * 2)
    done = run([TESTS / "over_budget.py", report, "--judge", tmp_path])
    assert done.returncode == verdict, done.stdout
    assert done.stdout.count("unit.Sum/1 alone: ") == 1
    assert "unit.Sum/10" not in done.stdout
    report.write_text("unit.Gone 9.00 4\n")
    assert run([TESTS / "over_budget.py", report, "--judge", tmp_path]).returncode == 1
