#!/usr/bin/python3
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Measures what docs/benchmarks.md shows and writes its measured parts: between two comments,
`measured: NAME` and `end of measured`. `scripts/bench --page` builds what this runs.

usage: page.py [--quick] [--processes N] [--parts PART...]
"""

import argparse
import contextlib
import csv
import functools
import io
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import report

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "bench"
DEV = ROOT / "build" / "dev"
LIBRARY = BUILD / "libocean" / "capi" / "libocean.so"
PAGE = ROOT / "docs" / "benchmarks.md"
PART = re.compile(r"(<!-- measured: (\w+) -->\n).*?(<!-- end of measured -->)", re.DOTALL)
BLENDER_LINE = re.compile(
    r"^(\S+), (\d+)( with detail)?: ([\d.]+) ms, (\d+) vertices; Blender's ([\d.]+) ms, (\d+);",
    re.MULTILINE,
)


def run(*command: str | Path, **environment: str | Path) -> str:
    print("page:", " ".join(str(word) for word in command), file=sys.stderr)
    variables = os.environ | {name: str(value) for name, value in environment.items()}
    done = subprocess.run(
        [str(word) for word in command], cwd=ROOT, env=variables, stdout=subprocess.PIPE, text=True
    )
    if done.returncode != 0:
        sys.exit(f"page: {command[0]} ended with {done.returncode}:\n{done.stdout}")
    return done.stdout


def table(head: list[str], rows: list[list[object]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines)


def printed(function, *arguments) -> str:
    with contextlib.redirect_stdout(io.StringIO()) as text:
        function(*arguments)
    return text.getvalue().strip()


def machine() -> str:
    facts = {}
    for line in run("lscpu", LC_ALL="C").splitlines():
        name, _, value = line.partition(":")
        facts[name.strip()] = value.strip()
    memory = Path("/proc/meminfo").read_text(encoding="utf-8").split(None, 2)[1]
    # Virtual machines often hide the name of the processor; its family and model are there.
    name = facts.get("Model name", "")
    processor = f"{name}, family {facts.get('CPU family', '?')}, model {facts.get('Model', '?')}"
    caches = ", ".join(
        f"{level} {facts[f'{level} cache']}"
        for level in ("L1d", "L2", "L3")
        if f"{level} cache" in facts
    )
    commit = run("git", "rev-parse", "--short", "HEAD").strip()
    count = facts.get("CPU(s)", "?")
    return (
        f"Measured on: {processor}; {count} processors; caches: {caches}; "
        f"{int(memory) / 2**20:.0f} GiB of memory; at commit {commit}."
    )


def runs_of(lines: list[dict]) -> list[list[dict]]:
    """Parts what scripts/bench put into one file: each process begins with its facts."""
    runs: list[list[dict]] = []
    before = ""
    for line in lines:
        if line["kind"] == "fact" and before != "fact":
            runs.append([])
        runs[-1].append(line)
        before = line["kind"]
    return runs


class Frames:
    """The runs of ocean_bench."""

    def __init__(self, words: argparse.Namespace) -> None:
        self.words = words

    @functools.cached_property
    def runs(self) -> list[list[dict]]:
        quick = ["--quick"] if self.words.quick else []
        with tempfile.NamedTemporaryFile("r", suffix=".json") as lines:
            run(
                "scripts/bench", "--with-mkl", *quick, "--processes", self.words.processes,
                "--json", lines.name,
            )  # fmt: skip
            return runs_of([json.loads(line) for line in lines])

    @functools.cached_property
    def ratios(self) -> dict:
        return report.ratios(self.runs)

    def kernel(self) -> str:
        facts = printed(report.print_facts, self.runs)
        return (
            facts
            + "\n\n"
            + printed(report.print_summary, self.ratios, report.milliseconds(self.runs))
        )

    def passes(self) -> str:
        return printed(report.print_traffic, self.runs)

    def figures(self) -> str:
        return printed(report.print_figures, self.runs)

    def losses(self) -> str:
        found = []
        for cell, names in self.ratios.items():
            ratio = report.median(report.worst(names))
            if ratio > 1.0:
                simd, frame, threads, n = cell
                found.append(f"- {simd}, {frame}, {threads} threads, N = {n}: {ratio:.2f}")
        return "\n".join(found) or "Of the frames above: nowhere on this machine."


def by_numpy() -> str:
    python = ROOT / "build" / "fastnoise" / "bin" / "python"  # made by scripts/bench --terrain
    return run(
        python, "tests/bench/whole_sea.py",
        LIBOCEAN_LIBRARY=LIBRARY, PYTHONPATH=ROOT / "libocean" / "python",
    )  # fmt: skip


def by_blender() -> str:
    text = run(
        "/usr/bin/python3", "tests/blender/start_blender.py", "--blender", "blender",
        "--library", LIBRARY, "--profile", BUILD / "profile", "--",
        "-s", "-k", "blenders_own", ROOT / "tests" / "blender" / "test_frame_cost.py",
        OCEAN=BUILD / "bin" / "ocean",
    )  # fmt: skip
    found = BLENDER_LINE.findall(text)
    if not found:
        sys.exit(f"page: Blender's test has printed no times:\n{text}")
    rows = []
    for version, side, detail, ms, vertices, theirs, their_vertices in found:
        ratio = float(ms) / int(vertices) / (float(theirs) / int(their_vertices))
        # The mesh of its modifier has other sizes than ours: a vertex is what can be compared.
        rows.append(
            [version, f"{side}{detail}", f"{ms} ({vertices})", f"{theirs} ({their_vertices})",
             f"{ratio:.2f}"]
        )  # fmt: skip
    return table(
        ["Blender", "N", "ours, ms (vertices)", "Ocean modifier, ms (vertices)", "ratio a vertex"],
        rows,
    )


def by_preview() -> str:
    stages: dict[str, list[str]] = {}
    for backend in ("cpu", "gl"):
        text = run(
            "xvfb-run", "-a", BUILD / "bin" / "ocean-preview", "preset:beaufort_6",
            "--size", "640x360", "--budget", "60", "--no-detail", "--backend", backend,
        )  # fmt: skip
        for row in csv.DictReader(text.splitlines()):
            stages.setdefault(row["stage"], []).append(f"{float(row['median']):.1f}")
    head = ["ms, median", "by `cpu`", "by `gl`"]
    return table(head, [[name, *ms] for name, ms in stages.items()])


def of_coasts() -> str:
    found = json.loads(
        run(
            BUILD / "tests" / "bench" / "ocean_coast_bench", "--benchmark_format=json",
            "--benchmark_filter=show_region/.*/side:500|make_statics",
        )
    )["benchmarks"]  # fmt: skip
    rows = []
    for line in found:
        kind, *options = line["name"].removesuffix("/real_time").split("/")
        threads = options[-1].removeprefix("threads:")
        if kind == "make_statics":
            rows.append(
                ["statics of 4 km2 in cells of 4 m", threads, f"{line['real_time']:.0f} ms"]
            )
        else:
            nanoseconds = 1e9 / line["items_per_second"]
            rows.append([f"a point: {options[0]}", threads, f"{nanoseconds:.0f} ns"])
    return table(["a coast", "threads", "time"], rows)


def of_the_bridge() -> str:
    loads = re.findall(
        r"^(.*?) +p10 .*?, p50 (.*?) ms, p99 (.*?) ms",
        run(DEV / "tests" / "bridge" / "bridge_load"),
        re.MULTILINE,
    )
    chain = re.findall(
        r"^(\S.*?) {2,}([\d.]+) +([\d.]+) +[\d.]+$",
        run("/usr/bin/python3", "tests/bridge/chain.py", "--build", DEV),
        re.MULTILINE,
    )
    rows = [[*row] for row in loads]
    rows += [[f"a report on a mocked bus below libusb: {name}", *row] for name, *row in chain]
    return table(["from a change to who is told", "median, ms", "99 of 100 within, ms"], rows)


def of_terrains() -> str:
    return run("scripts/bench", "--terrain")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--quick", action="store_true", help="as scripts/bench has it")
    parser.add_argument("--processes", default="3", help="as scripts/bench has it")
    parser.add_argument("--parts", nargs="+", help="these parts alone; others stay as they are")
    words = parser.parse_args()
    frames = Frames(words)
    measures = {
        "machine": machine,
        "kernel": frames.kernel,
        "losses": frames.losses,
        "passes": frames.passes,
        "figures": frames.figures,
        "terrain": of_terrains,
        "numpy": by_numpy,
        "blender": by_blender,
        "preview": by_preview,
        "coast": of_coasts,
        "bridge": of_the_bridge,
    }
    page = PAGE.read_text(encoding="utf-8")
    on_page = {name for _, name, _ in PART.findall(page)}
    if on_page != set(measures):
        sys.exit(f"page: {PAGE.name} and this script name other parts: {on_page ^ set(measures)}")
    if unknown := set(words.parts or ()) - on_page:
        sys.exit(f"page: there is no part {', '.join(sorted(unknown))}; {', '.join(measures)}")
    for name, measure in measures.items():
        if words.parts and name not in words.parts:
            continue
        text = measure().strip()
        page = PART.sub(
            lambda part: f"{part[1]}\n{text}\n\n{part[3]}" if part[2] == name else part[0],  # noqa: B023
            page,
        )
        PAGE.write_text(page, encoding="utf-8")  # what was measured is kept, whatever fails later
    print(PAGE.relative_to(ROOT))


if __name__ == "__main__":
    main()
