# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Works measured in turn, and their Markdown table."""

import statistics
import time

ROUNDS = 9


def measured(works: dict) -> dict:
    """Returns the median seconds of each work, all of them in turn in every round."""
    seconds = {name: [] for name in works}
    for _ in range(ROUNDS):
        for name, work in works.items():
            start = time.perf_counter()
            work()
            seconds[name].append(time.perf_counter() - start)
    return {name: statistics.median(taken[1:]) for name, taken in seconds.items()}


def print_table(head: str, sides: list[int], columns: list[dict]) -> None:
    """Milliseconds of each work, a column a side; in brackets the ratio to the first work."""
    print(f"| {head} | " + " | ".join(f"N = {side}" for side in sides) + " |")
    print("| --- |" + " --- |" * len(sides))
    first = next(iter(columns[0]))
    for name in columns[0]:
        cells = [
            f"{1e3 * column[name]:.1f}"
            + ("" if name == first else f" ({column[name] / column[first]:.2f})")
            for column in columns
        ]
        print(f"| {name} | " + " | ".join(cells) + " |")
