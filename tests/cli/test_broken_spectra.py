# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Broken spectrum files end in one line that names file and line, and in exit code 2. Where one
record is broken and others are not, a warning has that line.

The files are made by hand in broken_spectra/, a module for each format.
"""

import runpy
from pathlib import Path

import pytest

FOLDER = Path(__file__).with_name("broken_spectra")
CASES = [
    pytest.param(files, line, fragment, id=f"{path.stem}-{name}")
    for path in sorted(FOLDER.glob("*.py"))
    for name, files, line, fragment in runpy.run_path(str(path))["CASES"]
]


def test_there_are_two_hundred_distinct_broken_files():
    assert len(CASES) >= 200
    assert len({str(case.values[0]) for case in CASES}) == len(CASES)
    without_line = [case.id for case in CASES if case.values[1] is None]
    assert len([name for name in without_line if not name.startswith("netcdf")]) <= 30


@pytest.mark.parametrize(("files", "line", "fragment"), CASES)
def test_the_error_of_a_broken_file_names_its_line(ocean, files, line, fragment):
    for name, content in files.items():
        ocean.write(name, content)
    first = next(iter(files))
    result = ocean("records", first)
    assert result.returncode in (0, 2), result
    message = next(text for text in result.stderr.splitlines() if fragment in text)
    where = f"{first}: " if line is None else f":{line}: "
    assert where in message, message
    assert len(message) < 1200 and message.isprintable()
