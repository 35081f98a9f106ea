# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines in the console while Blender without a window is at work: the present work, every two
seconds. In a window panels and the status bar have it.

    libocean: Ocean: foam, 240 of 500 ticks, 4.0 s
"""

from __future__ import annotations

import contextlib
import threading
import time
from collections.abc import Callable, Iterator

import bpy

from .progress import Progress

INTERVAL = 2.0  # [s] from line to line; shorter work says nothing

_works: list[tuple[str, str | Callable[[], str]]] = []  # the outermost first
_ticks: tuple[int, int] | None = None
_share: float | None = None
_progress = Progress()  # of innermost work in several parts


def tell(done: int, total: int) -> None:
    """Notes the ticks of foam that are done, of the innermost work."""
    global _ticks
    _ticks = (done, total) if total > 0 else None


def tell_share(done: int, total: int) -> None:
    """Notes the share of the innermost work that is done."""
    global _share
    _share = done / total if total > 0 else None


def tell_part(done: int, total: int) -> None:
    """Notes the share that is done of a part of the innermost work."""
    _progress.note(done, total)
    tell_share(round(1000 * _progress.share), 1000)


def line(seconds: float) -> str:
    """Returns the line of the innermost work, so many seconds after the outermost one began; ""
    without work."""
    if not _works:
        return ""
    name, work = _works[-1]
    said = work if isinstance(work, str) else work()
    if _ticks is not None:
        said = f"foam, {_ticks[0]} of {_ticks[1]} ticks"
    elif _share is not None:
        said = f"{said}, {_share:.0%}"
    return f"libocean: {name}: {said}, {seconds:.1f} s"


def _print_lines(ended: threading.Event) -> None:
    begun = time.monotonic()
    due = begun + INTERVAL
    while not ended.wait(max(0.0, due - time.monotonic())):
        said = line(time.monotonic() - begun)
        if said:
            print(said, flush=True)
        due += INTERVAL


@contextlib.contextmanager
def work(name: str, said: str | Callable[[], str]) -> Iterator[None]:
    """Prints lines about this work while it lasts; with a window none. name: the full name of an
    object; said: the work, or a function that says it. Works may be nested."""
    global _ticks, _share, _progress
    if not bpy.app.background or threading.current_thread() is not threading.main_thread():
        yield
        return
    ended = None
    if not _works:
        ended = threading.Event()
        printer = threading.Thread(target=_print_lines, args=(ended,), daemon=True)
        printer.start()
    before, _ticks, _share, _progress = _ticks, None, None, Progress()
    _works.append((name, said))
    try:
        yield
    finally:
        _works.pop()
        _ticks, _share = before, None
        if ended is not None:
            ended.set()
            printer.join()
