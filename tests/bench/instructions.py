#!/usr/bin/python3
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Counts the instructions of a frame under callgrind and compares them with instructions.txt:
within 1 %, of which a stop-watch sees nothing. Some parts may have at most RATIOS times as many as
others. And the lines of memory that it moves behind a last cache of 512 KiB, which is to this map
of 256 x 256 samples what 8 MiB are to one of 1024 x 1024: at most LINES times those that it must
read and write. AVX2, because valgrind knows no AVX-512.

usage: instructions.py PROGRAM [--update]
PROGRAM --build names its compiler and build type, for whose code alone the numbers hold: another
one is skipped, exit status 77, until --update adds its own.
"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

LIMIT = 0.01
LINES = 1.15
# Instructions of a part over those of another, at most. change: the work of a performed change
# before its frame; tick: foam that is kept and shown. A second run would make it 2.
RATIOS = {("tick", "map"): 1.3, ("change", "map"): 10.5}
# Bytes, ways, bytes a line.
CACHES = ("--cache-sim=yes", "--D1=32768,8,64", "--LL=524288,16,64")
SKIPPED = 77
FILE = Path(__file__).with_name("instructions.txt")


def count(program):
    """{part: (instructions, lines moved)} and {part: lines that must be}, as the program names its
    parts."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            [
                "valgrind",
                "--tool=callgrind",
                "--collect-atstart=no",
                *CACHES,
                f"--callgrind-out-file={folder}/out",
                program,
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
                found = dict(zip(events[1].split(), map(int, totals[1].split()), strict=False))
                counts[name[1]] = found["Ir"], found["DLmr"] + found["DLmw"]
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
    counts, needed = count(program)
    if not counts:
        sys.exit("instructions: callgrind wrote no part that has a name")
    if update:
        others = {key: number for key, number in known.items() if key[0] != build}
        write_known(others | {(build, part): number for part, (number, _) in counts.items()})
    failed = False
    for part, (number, _) in sorted(counts.items()):
        before = known.get((build, part))
        change = number / before - 1 if before else None
        bad = not update and (change is None or abs(change) > LIMIT)
        failed = failed or bad
        verdict = "CHANGED" if bad else "written" if update else "as before"
        of = f"{change:+8.3%} of {before}" if before else "not known before"
        print(f"{part:10} {number:12d}  {of}  {verdict}")
    for part, lines in sorted(needed.items()):
        ratio = counts[part][1] / lines
        failed = failed or ratio > LINES
        verdict = f"MORE than {LINES}" if ratio > LINES else "few enough"
        print(f"{part:10} {counts[part][1]:12d}  lines, {ratio:.3f} of {lines}  {verdict}")
    for (part, base), most in RATIOS.items():
        ratio = counts[part][0] / counts[base][0]
        failed = failed or ratio > most
        verdict = f"MORE than {most}" if ratio > most else "few enough"
        print(f"{part:10} {ratio:12.3f}  times the instructions of {base}  {verdict}")
    missing = {part for of_build, part in known if of_build == build} - counts.keys()
    if missing and not update:
        print(f"not counted any more: {', '.join(sorted(missing))}")
    if failed:
        print("If these are meant: scripts/bench --instructions --update; say why in the commit.")
    return 1 if failed or (missing and not update) else 0


if __name__ == "__main__":
    sys.exit(main())
