# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Writes the record of ../ndbc_41010.* beside this script in the layout of NDBC's yearly files.

The values are those of the real-time tables; only their arrangement is that of the yearly files:
frequencies in the header, oldest line first, r1 and r2 in hundredths.
"""

import gzip
import pathlib
import re

HERE = pathlib.Path(__file__).parent
TABLES = {"w": "data_spec", "d": "swdir", "i": "swdir2", "j": "swr1", "k": "swr2"}


def yearly(letter, text):
    rows = [line for line in text.splitlines() if not line.startswith("#")]
    frequencies = re.findall(r"\((.*?)\)", rows[0])
    columns = (f"  {float(f):6.4f}".replace(" 0.", "  .") for f in frequencies)
    lines = ["#YY  MM DD hh mm" + "".join(columns)]
    for row in reversed(rows):
        values = [float(v) for v in re.findall(r"(\S+) \(", row)]
        if letter in "jk":
            values = [v if v == 999.0 else 100.0 * v for v in values]
        digits = 1 if letter in "di" else 2 if letter in "jk" else 3
        lines.append(row[:16] + "".join(f" {v:7.{digits}f}" for v in values))
    return "\n".join(lines) + "\n"


for letter, suffix in TABLES.items():
    text = (HERE.parent / f"ndbc_41010.{suffix}").read_text(encoding="ascii")
    with (HERE / f"41010{letter}2020.txt.gz").open("wb") as raw:
        with gzip.GzipFile(fileobj=raw, mode="wb", filename="", mtime=0) as packed:
            packed.write(yearly(letter, text).encode("ascii"))
