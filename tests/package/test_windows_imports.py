# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Which import tables run beside the C++ runtime of Blender 3.4 to 5.0: a row each."""

import importlib.machinery
import importlib.util
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[2] / "scripts/windows-imports"
LOADER = importlib.machinery.SourceFileLoader("windows_imports", str(SCRIPT))
SPEC = importlib.util.spec_from_loader("windows_imports", LOADER)
RULE = importlib.util.module_from_spec(SPEC)
LOADER.exec_module(RULE)

LOCK, CALL = "_Mtx_lock _Mtx_unlock", "_Mtx_init_in_situ _Mtx_destroy_in_situ"


def headers(linker: int, imports: str) -> str:
    lines = [f"MajorLinkerVersion\t14\nMinorLinkerVersion\t{linker}\n\tDLL Name: KERNEL32.dll"]
    return "\n".join(
        [*lines, *(f"\t{'DLL Name: ' * ('.' in each)}{each}" for each in imports.split())]
    )


@pytest.mark.parametrize(
    ("linker", "imports", "runs"),
    [
        (51, "", True),
        (51, "libstdc++-6.dll", True),
        (38, f"MSVCP140.dll {LOCK} {CALL}", True),  # OpenEXR 3.2.4
        (38, "MSVCP140.dll _Thrd_yield", True),
        (51, f"MSVCP140.dll {LOCK}", False),  # OpenEXR 3.2.10
        (40, f"msvcp140.dll {LOCK} {CALL}", False),  # of several compilers, perhaps
        (0, f"MSVCP140.dll {LOCK}", False),  # linked by LLVM
        (40, "MSVCP140.dll _Thrd_yield", False),
    ],
)
def test_an_import_table_is_judged(linker, imports, runs):
    assert (RULE.fault(headers(linker, imports)) == "") is runs


def test_what_we_compile_imports_no_such_runtime():
    old = headers(29, "MSVCP140.dll _Thrd_yield MSVCP140_1.dll")
    assert RULE.fault(old, allow_none=True) == "imports MSVCP140.dll, MSVCP140_1.dll"
    assert RULE.fault(headers(51, "libwinpthread-1.dll"), allow_none=True) == ""
