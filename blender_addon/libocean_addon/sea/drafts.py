# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Nobody waits for a sea while values move or time plays: a draft is shown at once, and the whole
sea when they rest.

A draft has whitecaps in the place of foam, whose past takes longest, and fewer samples where these
take long. Meanwhile a thread makes the whole sea ready in a handle of its own, which then takes the
place of the one that drew the draft. Without a window no user waits: every map is whole.

    value set -> draft ... rest -> thread: foam's past -> whole
"""

from __future__ import annotations

import dataclasses
import threading
import time
from collections.abc import Callable

import bpy
import numpy as np

from ..shared import hooks
from ..shared.native import libocean

SECONDS = 0.1
"""In which something is to be seen."""
_REST = 0.25  # seconds without a change: values rest
_SMALLEST = 64  # samples a side of a draft
_FIRST = 256

allowed = not bpy.app.background


def is_playing() -> bool:
    """Returns whether time passes, or is dragged along, in a window."""
    manager = bpy.context.window_manager
    screens = [window.screen for window in manager.windows] if manager else []
    return any(screen.is_animation_playing or screen.is_scrubbing for screen in screens)


class Pace:
    """Chooses the samples per side of a draft: it takes half of the time, Blender needs the
    rest."""

    def __init__(self) -> None:
        self.size = _FIRST
        self._last = 0

    def note(self, size: int, seconds: float, wanted: int) -> None:
        """Notes the time of a draft of this size. wanted: samples per side of the whole map. The
        first draft of a size fills caches for the others, and does not count."""
        first, self._last = size != self._last, size
        if first:
            return
        if seconds > SECONDS / 2 and size > _SMALLEST:
            self.size = size // 2
        elif seconds < SECONDS / 8 and size < wanted:  # four times the samples: half of the time
            self.size = size * 2


class CancelledError(Exception):
    """The whole sea is not wanted any more."""


class Job:
    """Makes a clone of a sea ready for the map of one time."""

    def __init__(
        self, sea, changes: int, at: float, size: int, channel: str, spray: dict | None = None
    ) -> None:
        self.sea, self.changes, self.time, self.size, self.channel = sea, changes, at, size, channel
        self.spray = spray
        self.share = 0.0
        self.seconds = 0.0
        self.failure: Exception | None = None
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)

    def start(self) -> None:
        self._thread.start()

    def _run(self) -> None:
        begun = time.perf_counter()
        watchers[threading.get_ident()] = self._watch
        try:
            map_ = np.empty((self.size, self.size, 4), np.float32)
            self.sea.fill(self.time, [(map_, ("dx", "dy", "height", self.channel))])
            if self.spray is not None:
                self.sea.spray(self.time, **self.spray)
        except (libocean.Error, MemoryError, CancelledError) as failure:
            self.failure = failure
        finally:
            del watchers[threading.get_ident()]
        self.seconds = time.perf_counter() - begun

    def _watch(self, done: int, total: int) -> None:
        self.share = done / total
        if self._stop.is_set():
            raise CancelledError

    def is_alive(self) -> bool:
        return self._thread.is_alive()

    def cancel(self) -> None:
        self._stop.set()

    def join(self) -> None:
        self._thread.join()


watchers: dict[int, Callable[[int, int], None]] = {}
"""The progress functions of threads, by thread."""


def tell_watcher(done: int, total: int) -> None:
    """The progress function of every sea."""
    watcher = watchers.get(threading.get_ident())
    if watcher is not None:
        watcher(done, total)


@dataclasses.dataclass
class _Wish:
    since: float
    rest: float


_wishes: dict[str, _Wish] = {}
_running: tuple[str, Job] | None = None


def ask(name: str, *, rest: bool = True) -> None:
    """Requests the whole sea of the object with that full name; rest: once its values rest."""
    if rest or name not in _wishes:
        _wishes[name] = _Wish(time.monotonic(), _REST if rest else 0.0)
    if rest and _running is not None and _running[0] == name:
        _running[1].cancel()
    if not bpy.app.background and not bpy.app.timers.is_registered(step):
        bpy.app.timers.register(step, first_interval=0.05)


def forget(name: str) -> None:
    """Withdraws the request for an object whose whole sea is shown."""
    _wishes.pop(name, None)


def progress(name: str) -> float | None:
    """Returns the finished share of the whole sea, 0 .. 1; None without a request."""
    if _running is not None and _running[0] == name:
        return _running[1].share
    return 0.0 if name in _wishes else None


def step() -> float | None:
    """Ends a job and begins the next, for the timer. Returns the seconds until the next call; None
    without further work."""
    global _running
    if _running is not None:
        name, job = _running
        if job.is_alive():
            _redraw()
            return 0.1
        _running = None
        hooks.connected().finish_draft_job(name, job)
        _redraw()
    now = time.monotonic()
    for name, wish in list(_wishes.items()):
        if now - wish.since >= wish.rest:
            del _wishes[name]
            job = hooks.connected().make_draft_job(name)
            if job is not None:
                _running = name, job
                job.start()
                break
    return 0.05 if _wishes or _running else None


def _redraw() -> None:
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "PROPERTIES":
                area.tag_redraw()


def close() -> None:
    """Withdraws all requests and ends the running job."""
    global _running
    _wishes.clear()
    if _running is not None:
        _running[1].cancel()
        _running[1].join()
        _running[1].sea.close()
        _running = None
    if bpy.app.timers.is_registered(step):
        bpy.app.timers.unregister(step)
