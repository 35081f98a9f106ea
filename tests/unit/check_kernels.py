# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""No function compiled for one instruction set may stand in for another's.

The linker keeps one of several equal inline functions, from any file: one of <algorithm> compiled
with AVX-512 would end a program on a machine without. So whatever a kernel's object file shares
must have its instruction set in its name. Reads the archive of core by nm (binutils).

usage: check_kernels.py ARCHIVE
"""

import re
import subprocess
import sys

KERNELS = ("avx512", "avx2", "sse4", "portable")


def shared_by(listing: str) -> list[str]:
    """Weak and unique symbols of kernel objects that do not belong to their kernel alone."""
    faults = []
    kernel = None
    for line in listing.splitlines():
        if member := re.match(r"(\S+):$", line):
            name = re.match(r"[a-z0-9_]+_([a-z0-9]+)\.", member[1])
            kernel = name[1] if name and name[1] in KERNELS else None
        elif (
            kernel
            and (symbol := re.match(r"[0-9a-f]+ [uVvWw] (.+)$", line))
            and f"ocean::{kernel}::" not in symbol[1]
        ):
            faults.append(f"kernel_{kernel} shares {symbol[1]}")
    return faults


def main() -> None:
    listing = subprocess.run(
        ("nm", "-C", "--defined-only", sys.argv[1]), check=True, capture_output=True, text=True
    ).stdout
    if "kernel_portable." not in listing:
        sys.exit(f"{sys.argv[1]} has no kernels")
    broken = "batch_fft_avx2.cpp.o:\n0000 W void std::fill<int*>(int*)\n0000 W ocean::avx2::f()\n"
    assert shared_by(broken) == ["kernel_avx2 shares void std::fill<int*>(int*)"]
    sys.exit("\n".join(shared_by(listing)) or 0)


if __name__ == "__main__":
    main()
