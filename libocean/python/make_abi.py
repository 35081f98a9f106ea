#!/usr/bin/python3
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Writes libocean/_abi.py: the structs, enums, callbacks and functions of libocean.h in ctypes.

usage: make_abi.py [--check] [HEADER [OUTPUT]]

Names lose the prefix OCEAN_ or ocean_; a struct or a callback is a class: ocean_query_request is
QueryRequest. A handle is a c_void_p. A declaration that the patterns below do not describe ends the
program with its line. With --check nothing is written; the exit status is 1 if the file is not what
the header says.
"""

from __future__ import annotations

import argparse
import re
import sys
from itertools import pairwise
from pathlib import Path
from typing import NoReturn

HERE = Path(__file__).resolve().parent
COLUMNS = 100

# The declarations of the header, by kind. Each begins where the one before it ends.
PATTERNS = {
    "guard": re.compile(
        r"#ifndef LIBOCEAN_H\n#define LIBOCEAN_H\n|#endif\s*\Z|#include <std(?:def|int)\.h>\n"
        r"|#if defined\(_WIN32\).*\n(?:#(?:define OCEAN_API|elif|else).*\n)+#endif\n"
        r'|#ifdef __cplusplus\n(?:extern "C" \{|\})\n#endif\n'
    ),
    "version": re.compile(r"#define OCEAN_ABI_VERSION (?P<name>\d+)\n"),
    "handle": re.compile(r"typedef struct (?P<name>\w+) (?P=name);"),
    "enum": re.compile(r"enum \{(?P<body>[^{}]*)\};"),
    "struct": re.compile(r"typedef struct \{(?P<body>[^{}]*)\} (?P<name>\w+);"),
    "callback": re.compile(
        r"typedef (?P<result>[\w ]+)\(\*(?P<name>\w+)\)\((?P<body>[^(){};]*)\);"
    ),
    "alias": re.compile(r"typedef (?P<result>\w+) (?P<name>\w+);"),
    "function": re.compile(
        r"OCEAN_API (?P<result>[\w ]+\**) ?\b(?P<name>\w+)\((?P<body>[^(){};]*)\);"
    ),
}
PART = re.compile(
    r"(?:const )?(?P<type>\w+)(?P<stars>(?: ?const|\*)*) ?(?P<name>\b\w+)(?P<count>\[\d+\])?"
)
ENUMERATOR = re.compile(r"OCEAN_(?P<name>\w+)(?: = (?P<value>\d+))?")

NUMBERS = {f"{name}_t": f"c_{name}" for name in ("int32", "int64", "uint32", "uint64")}
NUMBERS |= {"size_t": "c_size_t", "float": "c_float", "double": "c_double"}
# Enums whose enumerators are words in Python, by their first one; others are constants.
WORDS = {
    "DX": "CHANNELS",
    "ZUP": "AXES",
    "CPU": "BACKENDS",
    "FOAM_SETTLED": "FOAM_STARTS",
    "ERROR_WHAT": "ERROR_FIELDS",
}
HEADING = '''\
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""libocean.h in ctypes. make_abi.py writes this file: change the header, then run that."""

import ctypes
from ctypes import (
    POINTER,
    c_char_p,
    c_double,
    c_float,
    c_int32,
    c_int64,
    c_size_t,
    c_uint32,
    c_uint64,
    c_void_p,
)
from typing import Any'''


def class_name(name: str) -> str:
    return "".join(word.capitalize() for word in name.removeprefix("ocean_").split("_"))


def listed(opening: str, items: list[str], closing: str, indent: str = "") -> str:
    """Returns a list on one line, or one item a line where that is too long, as ruff formats it."""
    line = f"{indent}{opening}{', '.join(items)}{closing}"
    if len(line) <= COLUMNS:
        return line
    return "\n".join(
        [indent + opening, *(f"{indent}    {item}," for item in items), indent + closing]
    )


class Header:
    """A header while it is read, and what of _abi.py follows from it."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.text = re.sub(
            r"//[^\n]*|/\*.*?\*/",  # the header has no string that looks like a comment
            lambda comment: "\n" * comment[0].count("\n"),
            path.read_text(),
            flags=re.DOTALL,
        )
        self.values = {"void": "None", **NUMBERS}
        self.pointers = {"void": "c_void_p", "char": "c_char_p"}
        self.blocks: list[str] = []
        self.functions: list[str] = []
        self.results: list[str] = []
        place = 0
        while rest := self.text[place:].lstrip():
            place = len(self.text) - len(rest)
            for kind, pattern in PATTERNS.items():
                if found := pattern.match(self.text, place):
                    getattr(self, f"read_{kind}")(found)
                    place = found.end()
                    break
            else:
                self.refuse(place, rest.partition("\n")[0])

    def refuse(self, place: int, what: str) -> NoReturn:
        line = self.text.count("\n", 0, place) + 1
        sys.exit(f"make_abi: {self.path}:{line}: cannot read '{' '.join(what.split())}'")

    def type_of(self, name: str, stars: int, place: int) -> str:
        """Returns the C type of that name with so many stars in ctypes."""
        types = self.values
        if stars > 0 and name in self.pointers:
            types, stars = self.pointers, stars - 1
        if name not in types:
            self.refuse(place, name)
        return "POINTER(" * stars + types[name] + ")" * stars

    def parts(self, found: re.Match[str], separator: str) -> list[tuple[str, str]]:
        """Returns name and type of each member or argument of a declaration."""
        parts = []
        for text in re.finditer(rf"[^{separator}]+", found["body"]):
            place = found.start("body") + text.start() + len(text[0]) - len(text[0].lstrip())
            words = " ".join(text[0].split())
            if words in ("", "void"):
                continue
            part = PART.fullmatch(words)
            if part is None:
                self.refuse(place, words)
            kind = self.type_of(part["type"], part["stars"].count("*"), place)
            if kind == "None" or part["count"] and separator == ",":
                self.refuse(place, words)
            if part["count"]:
                kind += f" * {part['count'][1:-1]}"
            parts.append((part["name"], kind))
        return parts

    def result(self, found: re.Match[str]) -> str:
        words = found["result"].removeprefix("const ").strip()
        return self.type_of(words.rstrip("* "), words.count("*"), found.start())

    def read_guard(self, _found: re.Match[str]) -> None:
        pass

    def read_version(self, found: re.Match[str]) -> None:
        self.blocks.append(f"ABI_VERSION = {found['name']}")

    def read_handle(self, found: re.Match[str]) -> None:
        self.pointers[found["name"]] = "c_void_p"

    def read_alias(self, found: re.Match[str]) -> None:
        self.values[found["name"]] = self.result(found)

    def read_enum(self, found: re.Match[str]) -> None:
        numbers: dict[str, int] = {}
        following = 0
        for text in re.finditer(r"[^,]+", found["body"]):
            words = text[0].strip()
            enumerator = ENUMERATOR.fullmatch(words)
            if enumerator is None:
                self.refuse(found.start("body") + text.start() + text[0].find(words), words)
            numbers[enumerator["name"]] = int(enumerator["value"] or following)
            following = numbers[enumerator["name"]] + 1
        first = next(iter(numbers))
        if first not in WORDS:
            lines = [f"{name} = {number}" for name, number in numbers.items()]
            self.blocks.append("\n".join(lines))
            return
        prefix = first[: first.find("_") + 1]
        if not all(name.startswith(prefix) for name in numbers):
            prefix = ""
        items = [f'"{name.removeprefix(prefix).lower()}": {n}' for name, n in numbers.items()]
        self.blocks.append(listed(f"{WORDS[first]} = {{", items, "}"))

    def read_callback(self, found: re.Match[str]) -> None:
        name = class_name(found["name"])
        types = [self.result(found), *(kind for _, kind in self.parts(found, ","))]
        self.blocks.append(f"{name} = ctypes.CFUNCTYPE({', '.join(types)})")
        self.values[found["name"]] = name

    def read_struct(self, found: re.Match[str]) -> None:
        name = class_name(found["name"])
        members = [f'        ("{member}", {kind}),' for member, kind in self.parts(found, ";")]
        lines = [f"class {name}(ctypes.Structure):", "    _fields_ = [", *members, "    ]"]
        self.blocks.append("\n".join(lines))
        self.values[found["name"]] = name

    def read_function(self, found: re.Match[str]) -> None:
        name, result = f'"{found["name"]}": ', self.result(found)
        types = [kind for _, kind in self.parts(found, ",")]
        self.functions.append(listed(f"{name}[", types, "],", "    "))
        if result != self.values["ocean_result"]:
            self.results.append(f"    {name}{result},")

    def module(self) -> str:
        """Returns the text of _abi.py."""
        blocks = [
            *(HEADING, *self.blocks),
            "\n".join(["ARGUMENTS: dict[str, list[Any]] = {", *self.functions, "}"]),
            "\n".join(["RESULTS: dict[str, Any] = {", *self.results, "}"])
            + '\n"""The results of functions that do not return ocean_result."""',
        ]
        text = HEADING
        for before, block in pairwise(blocks):
            is_beside_class = "class " in (before[:6], block[:6])
            text += ("\n\n\n" if is_beside_class else "\n\n") + block
        return text + "\n"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="compare the file, write nothing")
    header = HERE.parent / "include/libocean.h"
    parser.add_argument("header", type=Path, nargs="?", default=header)
    parser.add_argument("output", type=Path, nargs="?", default=HERE / "libocean/_abi.py")
    asked = parser.parse_args()
    text = Header(asked.header).module()
    if not asked.check:
        asked.output.write_text(text)
    elif asked.output.read_text() != text:
        print(
            f"{asked.output} is not what {asked.header.name} says; run libocean/python/make_abi.py"
        )
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
