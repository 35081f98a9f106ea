#!/usr/bin/python3
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Prints a C header with its comments marked as Doxygen's: a filter of Doxyfile.

A comment on its own lines describes what follows it, one behind code describes that code.
"""

import re
import sys
from pathlib import Path


def marked(line: str) -> str:
    if re.match(r"\s*/\*(?!\*)", line):
        return line.replace("/*", "/**", 1)
    return re.sub(r"(?<=\S)(\s+)/\*(?!\*)", r"\1/**<", line, count=1)


for line in Path(sys.argv[1]).read_text().splitlines():
    print(marked(line))
