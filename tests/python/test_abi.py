# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""_abi.py against libocean.h as a compiler reads it: a program prints the size of every struct, the
place and the type of every member, every enumerator and the type of every function. It is C++11
because a template takes a function's type apart, and const off it; C reads the same layout."""

import ctypes
import os
import re
import subprocess
import sys
import types
from pathlib import Path

import pytest

from libocean import _abi

ROOT = Path(__file__).parents[2]
HEADER = ROOT / "libocean/include/libocean.h"
MAKE_ABI = ROOT / "libocean/python/make_abi.py"

PROGRAM = """
#include "libocean.h"
#include <cstdio>
#include <string>
#include <type_traits>

template <typename T> struct Kind {
    static_assert(std::is_arithmetic<T>::value, "a number");
    static std::string name() {
        const bool is_float = std::is_floating_point<T>::value;
        return (is_float ? "f" : std::is_signed<T>::value ? "i" : "u") + std::to_string(sizeof(T));
    }
};
template <typename T> struct Kind<const T> : Kind<T> {};
template <typename T> struct Kind<T*> {
    static std::string name() { return Kind<T>::name() + "*"; }
};
template <typename T, std::size_t n> struct Kind<T[n]> {
    static std::string name() { return Kind<T>::name() + "[" + std::to_string(n) + "]"; }
};
template <typename Result, typename... Arguments> struct Kind<Result(Arguments...)> {
    static std::string name() {
        std::string list;
        const std::string names[] = {"", Kind<Arguments>::name()...};
        for (const std::string& name : names) list += list.empty() ? name : ", " + name;
        return Kind<Result>::name() + "(" + list + ")";
    }
};
#define NAMED(type, word) \\
    template <> struct Kind<type> { static std::string name() { return word; } };
#define SAY(...) std::printf("%s\\n", std::string(__VA_ARGS__).c_str());
#define NUMBER(number) SAY(std::to_string(number))
#define SIZE(type) SAY(std::to_string(sizeof(type)))
#define TYPE(...) SAY(Kind<__VA_ARGS__>::name())
#define MEMBER(type, member) \\
    SAY(std::to_string(offsetof(type, member)) + " " + Kind<decltype(type::member)>::name())
NAMED(void, "void")
NAMED(char, "char")
NAMED(ocean_sea, "void")
NAMED(ocean_terrain, "void")
"""

PREFIXES = {
    **dict.fromkeys(("CHANNELS", "AXES", "BACKENDS"), "OCEAN_"),
    "FOAM_STARTS": "OCEAN_FOAM_",
    "ERROR_FIELDS": "OCEAN_ERROR_",
}


def c_name(name):
    return "ocean" + re.sub("[A-Z]", lambda letter: "_" + letter[0].lower(), name)


def kind_of(kind):
    """Returns the word of Kind for a type of ctypes."""
    if kind in (None, ctypes.c_void_p, ctypes.c_char_p):
        return {None: "void", ctypes.c_void_p: "void*", ctypes.c_char_p: "char*"}[kind]
    if issubclass(kind, ctypes.Structure):
        return c_name(kind.__name__)
    if issubclass(kind, ctypes.Array):
        return f"{kind_of(kind._type_)}[{kind._length_}]"
    if issubclass(kind, ctypes._Pointer):
        return kind_of(kind._type_) + "*"
    if issubclass(kind, ctypes._CFuncPtr):
        return signature(kind._restype_, *kind._argtypes_) + "*"
    letter = "f" if kind._type_ in "fd" else "i" if kind(-1).value < 0 else "u"
    return f"{letter}{ctypes.sizeof(kind)}"


def signature(result, *arguments):
    return f"{kind_of(result)}({', '.join(map(kind_of, arguments))})"


def facts_of(abi):
    """Returns the words that each statement of PROGRAM has to print, by a module of ctypes."""
    facts = {}
    for name, value in vars(abi).items():
        if isinstance(value, int):
            facts[f"NUMBER(OCEAN_{name})"] = str(value)
        elif name in PREFIXES:
            for word, number in value.items():
                facts[f"NUMBER({PREFIXES[name]}{word.upper()})"] = str(number)
        elif isinstance(value, type) and issubclass(value, ctypes.Structure):
            facts[f"SIZE({c_name(name)})"] = str(ctypes.sizeof(value))
            for member, kind in value._fields_:
                place = getattr(value, member).offset
                facts[f"MEMBER({c_name(name)}, {member})"] = f"{place} {kind_of(kind)}"
        elif isinstance(value, type) and issubclass(value, ctypes._CFuncPtr):
            facts[f"TYPE({c_name(name)})"] = kind_of(value)
    for name, arguments in abi.ARGUMENTS.items():
        result = abi.RESULTS.get(name, ctypes.c_int32)
        facts[f"TYPE(decltype({name}))"] = signature(result, *arguments)
    return facts


@pytest.fixture(scope="module")
def compiled(tmp_path_factory):
    """What a compiler says of libocean.h, for each statement of the wrapper's own table."""
    statements = list(facts_of(_abi))
    structs = re.findall(r"SIZE\((\w+)\)", " ".join(statements))
    named = [f'NAMED({name}, "{name}")' for name in structs]
    folder = tmp_path_factory.mktemp("abi")
    lines = [PROGRAM, *named, "int main() {", *statements, "}"]
    (folder / "abi.cpp").write_text("\n".join(lines))
    compiler = [os.environ.get("CXX", "c++"), "-std=c++11", "-I", HEADER.parent]
    subprocess.run([*compiler, folder / "abi.cpp", "-o", folder / "abi"], check=True)
    done = subprocess.run([folder / "abi"], check=True, capture_output=True, text=True)
    return dict(zip(statements, done.stdout.splitlines(), strict=True))


def test_ctypes_says_what_a_compiler_says(compiled):
    assert facts_of(_abi) == compiled
    exported = (ROOT / "tests/capi/exported_symbols.txt").read_text().split()
    assert sorted(_abi.ARGUMENTS) == exported


@pytest.mark.parametrize(
    ("old", "new", "wrong"),
    [
        (
            '"ocean_cover_power": [c_void_p, c_double',
            '"ocean_cover_power": [c_void_p, c_int32',
            ["TYPE(decltype(ocean_cover_power))"],
        ),
        ('"ocean_free": None', '"ocean_free": c_int32', ["TYPE(decltype(ocean_free))"]),
        (
            "(c_int32, c_void_p, c_int64",
            "(c_int32, c_void_p, c_int32",
            ["TYPE(ocean_progress)", "MEMBER(ocean_options, progress)"],
        ),
        ('("foam", c_int32)', '("foam", c_float)', ["MEMBER(ocean_query_request, foam)"]),
        (
            '("frame", c_int32),\n        ("axes", c_int32)',
            '("axes", c_int32),\n        ("frame", c_int32)',
            [f"MEMBER(ocean_provenance_request, {name})" for name in ("frame", "axes")],
        ),
        (
            '("wraps", c_int32),\n        ("reserved", c_int32),',
            '("wraps", c_int32),\n        ("reserved", c_int32), ("more", c_int64)',
            ["SIZE(ocean_domain)"],
        ),
        ('"wetness": 46', '"wetness": 47', ["NUMBER(OCEAN_WETNESS)"]),
        ("BUSY = 11", "BUSY = 12", ["NUMBER(OCEAN_BUSY)"]),
    ],
)
def test_a_slip_in_the_table_is_noticed(compiled, old, new, wrong):
    text = Path(_abi.__file__).read_text()
    assert text.count(old) == 1
    changed = types.ModuleType("changed")
    exec(text.replace(old, new), vars(changed))
    facts = facts_of(changed)
    assert {fact for fact, words in compiled.items() if facts[fact] != words} == set(wrong)


def make_abi(*arguments):
    return subprocess.run([sys.executable, MAKE_ABI, *arguments], capture_output=True, text=True)


def test_the_table_is_what_make_abi_writes(tmp_path):
    assert make_abi("--check").returncode == 0
    changed = tmp_path / "libocean.h"
    changed.write_text(HEADER.read_text().replace("double lifetime;", "float lifetime;"))
    done = make_abi("--check", changed)
    assert done.returncode == 1 and "_abi.py is not what libocean.h says" in done.stdout
    assert make_abi(changed, tmp_path / "_abi.py").returncode == 0
    assert '("lifetime", c_float),' in (tmp_path / "_abi.py").read_text()


@pytest.mark.parametrize(
    "declaration",
    [
        "typedef struct { bool wraps; } ocean_x;",
        "typedef struct { int32_t bits : 3; } ocean_x;",
        "typedef struct { int32_t x, y; } ocean_x;",
        "typedef struct { ocean_y* later; } ocean_x;",
        "typedef union { int32_t number; } ocean_x;",
        "enum { OCEAN_X = -1 };",
        "enum { OCEAN_X = OCEAN_OK };",
        "enum ocean_x { OCEAN_X };",
        "OCEAN_API ocean_result ocean_x(unsigned n);",
        "OCEAN_API ocean_result ocean_x(double place[2]);",
        "OCEAN_API ocean_result ocean_x(const char* format, ...);",
        "ocean_result ocean_x(void);",
        "typedef ocean_sea ocean_x;",
        "#define OCEAN_X 1",
        "#pragma pack(1)",
    ],
)
def test_a_declaration_that_make_abi_does_not_know_is_named_with_its_line(tmp_path, declaration):
    before, after = HEADER.read_text().split("/* Channels.", 1)
    header, output = tmp_path / "libocean.h", tmp_path / "_abi.py"
    header.write_text(f"{before}{declaration}\n/* Channels.{after}")
    done = make_abi(header, output)
    assert done.returncode == 1 and not output.exists()
    line = before.count("\n") + 1
    assert done.stderr.startswith(f"make_abi: {header}:{line}: cannot read '")
