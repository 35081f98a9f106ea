#!/usr/bin/python3
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Counts the instructions of a frame under callgrind and compares them with instructions.txt:
within 1 %, of which a stop-watch sees nothing. Some parts may have at most RATIOS times as many as
others. And the lines of memory that it moves: at most LINES times those that it must read and
write. Behind a last cache of 512 KiB, which is to the map of 256 x 256 samples what 8 MiB are to
one of 1024 x 1024; and a map of 512 x 512 behind the caches of an Intel Xeon's core, 48 KiB with
12 ways and 2 MiB with 16. AVX2, because valgrind knows no AVX-512: tests/unit/cache_sets_test.cpp
computes the sets of a cache that the addresses of all widths share.

usage: instructions.py PROGRAM [--update]
PROGRAM --build names its compiler and build type, for whose code alone the numbers hold: another
one is skipped, exit status 77, until --update adds its own.
"""

import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

LIMIT = 0.01
LINES = 1.15
# Also behind the first cache, in which the second sweeps' lines stay: without the pad of
# kernel/layout.hpp it is 1.5 % more, and a rerun differs by 0.1 %.
FIRST_LINES = {"vertices_512": 2.235, "planar_512": 2.37}
# Instructions of a part over those of another, at most. change: the work of a performed change
# before its frame; tick: foam that is kept and shown, for which a second run would make it 2;
# passage: a map while the wind glides between two steps.
RATIOS = {("tick", "map"): 1.3, ("change", "map"): 10.5, ("passage", "map"): 1.15}
# Arguments of the program; then bytes, ways, bytes a line.
SMALL = ((), ("--D1=32768,8,64", "--LL=524288,16,64"))
LARGE = (("large",), ("--D1=49152,12,64", "--LL=2097152,16,64"))
SKIPPED = 77
FILE = Path(__file__).with_name("instructions.txt")


def count(program, arguments, caches):
    """{part: its events} and {part: lines that must be moved}, as the program names its parts."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            [
                "valgrind",
                "--tool=callgrind",
                "--collect-atstart=no",
                "--cache-sim=yes",
                *caches,
                f"--callgrind-out-file={folder}/out",
                program,
                *arguments,
            ],
            env=dict(os.environ, OCEAN_SIMD="avx2"),
            capture_output=True,
            text=True,
        )
        if run.returncode != 0:
            sys.exit(f"instructions: the program failed under valgrind:\n{run.stderr}")
        counts = {}
        for part in Path(folder).glob("out.*"):
            text = part.read_text()
            name = re.search(r"^desc: Trigger: Client Request: (\S+)$", text, re.M)
            events = re.search(r"^events: (.*)$", text, re.M)
            totals = re.search(r"^(?:totals|summary): (.*)$", text, re.M)
            if name and events and totals:
                numbers = map(int, totals[1].split())
                counts[name[1]] = dict(zip(events[1].split(), numbers, strict=False))
        needed = {part: int(lines) for part, lines in map(str.split, run.stdout.splitlines())}
    return counts, needed


def read_known():
    """{(build, part): instructions}"""
    known = {}
    for line in FILE.read_text().splitlines():
        if line and not line.startswith("#"):
            build, part, number = line.split()
            known[build, part] = int(number)
    return known


def write_known(known):
    head = [line for line in FILE.read_text().splitlines() if line.startswith("#")]
    lines = [f"{build} {part} {number}" for (build, part), number in sorted(known.items())]
    FILE.write_text("\n".join(head + lines) + "\n")


def main():
    program = sys.argv[1]
    update = sys.argv[2:] == ["--update"]
    build = subprocess.run([program, "--build"], capture_output=True, text=True, check=True)
    build = build.stdout.strip()
    known = read_known()
    if not update and not any(of_build == build for of_build, _ in known):
        print(f"skipped: instructions.txt has no numbers of {build}")
        return SKIPPED
    with ThreadPoolExecutor() as pool:
        small, large = pool.map(lambda run: count(program, *run), (SMALL, LARGE))
    counts, needed = small[0] | large[0], small[1] | large[1]
    if not counts:
        sys.exit("instructions: callgrind wrote no part that has a name")
    if update:
        others = {key: number for key, number in known.items() if key[0] != build}
        write_known(others | {(build, part): events["Ir"] for part, events in counts.items()})
    failed = False
    for part, events in sorted(counts.items()):
        number = events["Ir"]
        before = known.get((build, part))
        change = number / before - 1 if before else None
        bad = not update and (change is None or abs(change) > LIMIT)
        failed = failed or bad
        verdict = "CHANGED" if bad else "written" if update else "as before"
        of = f"{change:+8.3%} of {before}" if before else "not known before"
        print(f"{part:12} {number:10d}  {of}  {verdict}")
    last = [("DL", part, LINES) for part in sorted(needed)]
    for cache, part, most in last + [("D1", *limit) for limit in FIRST_LINES.items()]:
        moved = counts[part][f"{cache}mr"] + counts[part][f"{cache}mw"]
        ratio = moved / needed[part]
        failed = failed or ratio > most
        verdict = f"MORE than {most}" if ratio > most else "few enough"
        print(
            f"{part:12} {moved:10d}  lines behind {cache}, {ratio:.3f} of {needed[part]}  {verdict}"
        )
    for (part, base), most in RATIOS.items():
        ratio = counts[part]["Ir"] / counts[base]["Ir"]
        failed = failed or ratio > most
        verdict = f"MORE than {most}" if ratio > most else "few enough"
        print(f"{part:12} {ratio:10.3f}  times the instructions of {base}  {verdict}")
    missing = {part for of_build, part in known if of_build == build} - counts.keys()
    if missing and not update:
        print(f"not counted any more: {', '.join(sorted(missing))}")
    if failed:
        print("If these are meant: scripts/bench --instructions --update; say why in the commit.")
    return 1 if failed or (missing and not update) else 0


if __name__ == "__main__":
    sys.exit(main())
