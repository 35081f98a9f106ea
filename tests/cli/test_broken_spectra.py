# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Broken spectrum files end in one line that names file and line, and in exit code 2. Where one
record is broken and others are not, a warning has that line.

Of the corpus in tests/seafile, whose sentences are compared in process, one of each kind of each
file; of NetCDF all that broken_netcdf.py makes.
"""

import tomllib
from pathlib import Path

import pytest
from broken_netcdf import CASES as NETCDF

CORPUS = Path(__file__).parents[1] / "seafile/corpus"


def edited():
    """The first edit that costs the file, and the first that costs a record, of each file."""
    for table in sorted(CORPUS.glob("*/**/*.toml")):
        rows = tomllib.loads(table.read_text()).get("broken", [])
        for kind in ("refused", "fault"):
            plain = [
                row for row in rows if row.keys() == {"edit", kind} and "(...)" not in row[kind]
            ]
            row = next(iter(plain), None)
            if row is not None:
                old, new = (text.encode("latin-1") for text in row["edit"])
                content = table.with_suffix("").read_bytes().replace(old, new, 1)
                yield pytest.param(table.stem, content, row[kind], id=f"{table.stem}-{kind}")


CASES = list(edited()) + [
    pytest.param("sea.nc", files["sea.nc"], f"sea.nc: {words}", id=f"netcdf-{name}")
    for name, files, _, words in NETCDF
]


def test_there_are_broken_files_of_each_format():
    assert len(CASES) >= 55
    assert len({case.values[1] for case in CASES}) == len(CASES)


@pytest.mark.parametrize(("name", "content", "sentence"), CASES)
def test_the_error_of_a_broken_file_names_its_line(ocean, name, content, sentence):
    ocean.write(name, content)
    result = ocean("records", name)
    assert result.returncode in (0, 2), result
    where, _, words = sentence.partition(": ")
    message = next(text for text in result.stderr.splitlines() if words in text)
    assert f"{where}: " in message, message
    assert len(message) < 1200 and message.isprintable()
