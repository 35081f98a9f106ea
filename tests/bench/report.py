#!/usr/bin/python3
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Puts the runs of ocean_bench together: Markdown tables of ratios.

usage: report.py RUN.json...
Each run is one process, a JSON object a line. Of a cell, the ratio against a library is that
against its strongest variant; over the processes it is the median; of hot and cold the worse.
"""

import json
import sys
from collections import defaultdict
from statistics import median

STATES = ("hot", "cold")
FRAMES = ("vertices", "planar", "peers")


def read_runs(files):
    runs = []
    for file in files:
        with open(file, encoding="utf-8") as lines:
            runs.append([json.loads(line) for line in lines])
    return runs


def cell_of(line):
    return line["simd"], line["frame"], line["threads"], line["n"]


def cell_order(cell):
    simd, frame, threads, n = cell
    return simd, FRAMES.index(frame), threads, n


def ratios(runs):
    """{cell: {library: {state: [ours / its strongest variant, of each process]}}}. Pairs of fields
    in one complex map are no planes, so planar frames have 'LIBRARY, planes' besides."""
    found = defaultdict(lambda: defaultdict(lambda: defaultdict(list)))
    for run in runs:
        strongest = defaultdict(float)
        for line in run:
            if line["kind"] != "frame" or line["library"] == "ours":
                continue
            names = [line["library"]]
            if line["frame"] == "planar" and not line["pairs"]:
                names.append(f"{line['library']}, planes")
            for name in names:
                key = cell_of(line), name, line["state"]
                strongest[key] = max(strongest[key], line["ratio"])
        for (cell, name, state), ratio in strongest.items():
            found[cell][name][state].append(ratio)
    return found


def milliseconds(runs):
    """{cell: {state: {(library, variant): median over the processes}}}"""
    found = defaultdict(lambda: defaultdict(lambda: defaultdict(list)))
    for run in runs:
        for line in run:
            if line["kind"] == "frame":
                subject = line["library"], line["variant"]
                found[cell_of(line)][line["state"]][subject].append(line["ms"])
    return {
        cell: {
            state: {subject: median(values) for subject, values in subjects.items()}
            for state, subjects in states.items()
        }
        for cell, states in found.items()
    }


def ours(times):
    return next(ms for (library, _), ms in times.items() if library == "ours")


def worst(names):
    """The ratios, one of each process, against whichever library is strongest, hot or cold."""
    return max((values for states in names.values() for values in states.values()), key=median)


def with_spread(values):
    middle = median(values)
    if len(values) == 1:
        return f"**{middle:.2f}**"
    spread = (max(values) - min(values)) / 2 / middle
    return f"**{middle:.2f}** \u00b1 {spread:.0%}"


def print_row(*columns):
    print("| " + " | ".join(str(column) for column in columns) + " |")


def print_head(*columns):
    print_row(*columns)
    print("|---" * len(columns) + "|")


def print_summary(table, times):
    sizes = sorted({n for _, frame, _, n in table if frame != "peers"})
    if not sizes:
        return
    print(
        "Ours / the strongest library, the worse of hot and cold; half the spread of the", end=" "
    )
    print("processes; (our milliseconds, hot):\n")
    print_head("instruction set", "frame", "threads", *(f"N = {n}" for n in sizes))
    rows = {cell[:3] for cell in table if cell[1] != "peers"}
    for row in sorted(rows, key=lambda row: cell_order((*row, 0))):
        columns = []
        for n in sizes:
            cell = (*row, n)
            if cell not in table:
                columns.append("")
                continue
            own = ours(times[cell]["hot"])
            columns.append(f"{with_spread(worst(table[cell]))} ({own:.2f})")
        print_row(*row, *columns)
    print()


def rival_text(library, states, subjects, state, planes):
    ms, variant = min((ms, v) for (lib, v), ms in subjects.items() if lib == library)
    text = f"{library} {ms:.2f} ({variant}) {median(states[state]):.2f}"
    return f"{text}, planes alone {median(planes[state]):.2f}" if planes else text


def print_details(table, times):
    print("Each library's strongest: milliseconds, variant, ratio.\n")
    print_head("instruction set", "frame", "threads", "N", "state", "ours", "rivals")
    for cell in sorted(table, key=cell_order):
        names = table[cell]
        for state in (state for state in STATES if state in times[cell]):
            subjects = times[cell][state]
            rivals = [
                rival_text(name, states, subjects, state, names.get(f"{name}, planes"))
                for name, states in sorted(names.items())
                if not name.endswith(", planes")
            ]
            print_row(*cell, state, f"{ours(subjects):.2f}", "; ".join(rivals))
    print()


def print_traffic(runs):
    """Both passes of a frame, as multiples of what their bytes take at the speed of a copy; and how
    many times as fast two threads are as one, the frame and a copy of memory."""
    found = defaultdict(list)
    for run in runs:
        for line in run:
            if line["kind"] == "traffic":
                found[cell_of(line)].append(line)
    if not found:
        return
    print("Milliseconds of each pass; (over those of its bytes alone, copied). Of two threads, how")
    print("many times as fast as one they are; (as a copy of memory is):\n")
    print_head("instruction set", "frame", "threads", "N", "pass one", "pass two", "gain")
    for cell, lines in found.items():
        columns = []
        for number in (0, 1):
            took = median(line["ms"][number] for line in lines)
            times = median(line["ms"][number] / line["limits"][number] for line in lines)
            columns.append(f"{took:.2f} ({times:.1f})")
        simd, frame, threads, n = cell
        alone = found[simd, frame, 1, n]
        if threads > 1:
            gains = [
                median(sum(a[key]) / sum(b[key]) for a, b in zip(alone, lines, strict=True))
                for key in ("ms", "limits")
            ]
            columns.append("{:.2f} ({:.2f})".format(*gains))
        else:
            columns.append("")
        print_row(*cell, *columns)
    print()


def print_figures(runs):
    found = defaultdict(list)
    for run in runs:
        for line in run:
            if line["kind"] == "figure":
                key = line["name"], line["simd"], line["threads"], line["unit"]
                found[key].append(line["value"])
    if not found:
        return
    print_head("figure", "instruction set", "threads", "value")
    for (name, simd, threads, unit), values in found.items():
        print_row(name, simd, threads, f"{median(values):.4g} {unit}".strip())


def print_facts(runs):
    facts = {}
    rounds = loaded = dropped = 0
    for run in runs:
        for line in run:
            if line["kind"] == "fact" and line["name"] != "instruction set":
                facts[line["name"]] = line["value"]
            elif line["kind"] == "frame" and line["library"] == "ours":
                rounds += line["rounds"]
                loaded += line["loaded"]
                dropped += line["dropped"]
    print("; ".join(f"{name}: {value}" for name, value in facts.items()) + ".")
    print(f"{len(runs)} processes, {rounds} rounds, {loaded} of them beside other work;", end=" ")
    print(f"{dropped} rounds dropped because of it.\n")


def main():
    runs = read_runs(sys.argv[1:])
    table, times = ratios(runs), milliseconds(runs)
    print_facts(runs)
    print_summary(table, times)
    if table:
        print_details(table, times)
    print_traffic(runs)
    print_figures(runs)


if __name__ == "__main__":
    main()
