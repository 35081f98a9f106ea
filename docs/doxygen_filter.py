#!/usr/bin/python3
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Prints a public header as Doxygen and Sphinx can read it: a filter of Doxyfile.

In C, comments are marked as Doxygen's: one on its own lines describes what follows it, one behind
code describes that code. In C++, what Sphinx cannot parse is left out: first values of members by
their names, functions without a name, and values that one returns.
"""

import re
import sys
from pathlib import Path

COMPUTED = r" = \[\](?:<[^\n]*)? \{\n.*?\n\}\s*\([^;\n]*\);"  # up to the line that ends it
UNNAMED = r"\s*=\s*\[\](?:\([^)]*\))?\s*\{(?:[^{}]|\{[^{}]*\})*\}(?=;)"
NAMED_MEMBERS = r"\{\.(?:[^{}]|\{[^{}]*\})*\}"


def marked(line: str) -> str:
    if re.match(r"\s*/\*(?!\*)", line):
        return line.replace("/*", "/**", 1)
    return re.sub(r"(?<=\S)(\s+)/\*(?!\*)", r"\1/**<", line, count=1)


def without_first_values(text: str) -> str:
    text = re.sub(UNNAMED, "", re.sub(COMPUTED, ";", text, flags=re.DOTALL))
    return re.sub(rf"(?:\s*=\s*|(?<=\w)){NAMED_MEMBERS};", ";", text)


header = Path(sys.argv[1])
text = header.read_text()
if header.suffix == ".h":
    print("\n".join(marked(line) for line in text.splitlines()))
else:
    print(without_first_values(text), end="")
