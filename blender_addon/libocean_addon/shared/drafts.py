# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drafts: a subject is shown at once while values move or time plays, and the whole one
when they rest.

A draft has fewer samples where these take long, that of a sea whitecaps in the place of foam, whose
past takes longest. Meanwhile a thread makes the whole one ready in a handle of its own, which then
takes the place of the one that drew the draft. A render waits for it. Without a window every map is
whole at once.

    value set -> draft ... rest -> thread: Job.work -> whole
"""

from __future__ import annotations

import dataclasses
import threading
import time
from collections.abc import Callable
from typing import Any

import bpy

from . import console, hooks
from .compat import tr_label
from .native import libocean

SECONDS = 0.1
"""In which something is to be seen."""
_REST = 0.25  # seconds without a change: values rest
_SMALLEST = 64  # samples a side of a draft
_FIRST = 256

allowed = not bpy.app.background


def is_main_thread() -> bool:
    """Returns whether Blender's data may be changed here: a render may have a thread of its own."""
    return threading.current_thread() is threading.main_thread()


def is_playing() -> bool:
    """Returns whether time passes, or is dragged along, in a window."""
    manager = bpy.context.window_manager
    screens = [window.screen for window in manager.windows] if manager else []
    return any(screen.is_animation_playing or screen.is_scrubbing for screen in screens)


def allows_draft(*, rendering: bool, passing: bool) -> bool:
    """Returns whether a draft suffices for now: values move, or time plays. passing: Blender
    reports that the frame has changed. If nothing plays, it may be a frame of a viewport render,
    which waits for the whole."""
    return allowed and not rendering and (is_playing() or not passing)


def is_redraw(*, rendering: bool, passing: bool) -> bool:
    """Returns whether Blender may redraw the same frame unprompted, as it does after an edit of a
    driver: a draft of that frame stays one. The operator of a viewport render, which waits for the
    whole, runs in the area of its viewport. passing: Blender reports that the frame has changed."""
    return allowed and not rendering and passing and bpy.context.area is None


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
    """A job was cancelled: its subject has changed, or the user stopped it."""


class Job:
    """Makes the whole subject of an object, in a thread. A class of its own for each subject has
    `work`, `close` and `status_text`."""

    def __init__(self, key: tuple) -> None:
        self.key = key
        """The settings of the map: a request with the same key wants this job's map."""
        self.subject: Any = None
        """The row of the subject that is made."""
        self.ticks: tuple[int, int] | None = None
        """The finished ticks of foam and their number; None before the first one."""
        self.seconds = 0.0
        self.failure: Exception | None = None
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)

    def work(self) -> None:
        """Does the work, in the thread. Raises libocean.Error, MemoryError or CancelledError."""
        raise NotImplementedError

    def close(self) -> None:
        """Frees the library's handle of a job without use."""
        raise NotImplementedError

    def status_text(self, name: str) -> str:
        """Returns a line about the work on the object with that full name, for the status bar."""
        raise NotImplementedError

    @property
    def share(self) -> float:
        """Returns the finished share of the foam's past, 0 .. 1."""
        return self.ticks[0] / self.ticks[1] if self.ticks else 0.0

    def start(self) -> None:
        self._thread.start()

    def _run(self) -> None:
        begun = time.perf_counter()
        watchers[threading.get_ident()] = self._watch
        try:
            self.work()
        except (libocean.Error, MemoryError, CancelledError) as failure:
            self.failure = failure
        finally:
            del watchers[threading.get_ident()]
        self.seconds = time.perf_counter() - begun

    def _watch(self, done: int, total: int) -> None:
        if total > 0:
            self.ticks = (done, total)
        self.require_wanted()

    def is_alive(self) -> bool:
        return self._thread.is_alive()

    def cancel(self) -> None:
        self._stop.set()

    def is_cancelled(self) -> bool:
        return self._stop.is_set()

    def require_wanted(self) -> None:
        """Raises CancelledError between two parts of the work."""
        if self.is_cancelled():
            raise CancelledError

    def join(self) -> None:
        self._thread.join()


watchers: dict[int, Callable[[int, int], None]] = {}
"""The progress functions of threads, by thread."""


def tell_watcher(done: int, total: int) -> None:
    """Reports progress to the function of this thread, or otherwise to the console. The progress
    function of handles that count ticks of foam."""
    watchers.get(threading.get_ident(), console.tell)(done, total)


def tell_watcher_of_share(done: int, total: int) -> None:
    """Reports progress as tell_watcher() does, for handles that report the share of their work."""
    watchers.get(threading.get_ident(), console.tell_share)(done, total)


def tell_watcher_of_part(done: int, total: int) -> None:
    """Reports progress as tell_watcher() does, for handles that report the share of each part of
    their work."""
    watchers.get(threading.get_ident(), console.tell_part)(done, total)


@dataclasses.dataclass
class _Wish:
    key: tuple
    since: float
    rest: float


_wishes: dict[str, _Wish] = {}
_running: tuple[str, Job] | None = None
_stopped: dict[str, tuple] = {}
"""The keys of the maps that the user stopped, by object."""
_stepping = False
_step_at = 0.0
"""The time of the last call of `step`, by which another thread knows that the timer runs."""


def ask(name: str, key: tuple, *, rest: bool = True) -> None:
    """Requests the whole subject of the object with that full name. key: of the job. rest: begin
    only once values rest, when the key no longer changes."""
    if _stopped.get(name) == key:
        return
    _stopped.pop(name, None)
    if _running is not None and _running[0] == name:
        if _running[1].key == key:
            return
        if rest:
            _running[1].cancel()
    wish = _wishes.get(name)
    if wish is None or (rest and wish.key != key):
        _wishes[name] = _Wish(key, time.monotonic(), _REST if rest else 0.0)
    _call_step()


def _call_step() -> None:
    if not bpy.app.background and not bpy.app.timers.is_registered(step):
        # A file that is opened would take other timers away, and the draft would stay.
        bpy.app.timers.register(step, first_interval=0.05, persistent=True)


_kept: set[str] = set()
"""The objects for which the timer goes on without work: a render in a thread of its own requests
theirs frame by frame, and cannot start a timer."""


def keep_timer(name: str, *, kept: bool) -> None:
    """Has the timer go on, in a window, while an object is kept that a render may request anew on
    each frame. For the main thread."""
    if not kept or bpy.app.background:
        _kept.discard(name)
    elif name not in _kept:
        _kept.add(name)
        _call_step()


def forget(name: str, key: tuple, *, more_follows: bool) -> None:
    """Withdraws the request for an object that shows the whole map of this key. more_follows: its
    job goes on after the map, with spray."""
    _wishes.pop(name, None)
    if not more_follows or _stopped.get(name) != key:
        _stopped.pop(name, None)
    if _running is not None and _running[0] == name and _running[1].key != key:
        _running[1].cancel()


def keep_only(names: set[str]) -> None:
    """Withdraws the requests for objects without one of these full names: they were deleted."""
    for found in (_wishes, _stopped):
        for name in found.keys() - names:
            del found[name]
    _kept.intersection_update(names)
    if _running is not None and _running[0] not in names:
        _running[1].cancel()


def wants(name: str, key: tuple) -> bool:
    """Returns whether the whole subject of this key is requested, in the making or stopped."""
    wish = _wishes.get(name)
    is_made = _running is not None and _running[0] == name and _running[1].key == key
    return is_made or _stopped.get(name) == key or (wish is not None and wish.key == key)


def stop(name: str) -> None:
    """Stops the work for the object with that full name, whose draft stays until a value, the frame
    or a render requests its sea again."""
    wish = _wishes.pop(name, None)
    if wish is not None:
        _stopped[name] = wish.key
    elif _running is not None and _running[0] == name:
        _stopped[name] = _running[1].key
        _running[1].cancel()
    _redraw()


def resume(name: str) -> None:
    """Requests the whole subject of an object again whose work the user stopped."""
    key = _stopped.pop(name, None)
    if key is not None:
        _wishes[name] = _Wish(key, time.monotonic(), 0.0)  # the timer goes on while one is stopped


def forget_stops() -> None:
    """Forgets which work the user stopped: another file is open, or undo restored other values."""
    _stopped.clear()


def is_stopped(name: str) -> bool:
    return name in _stopped


def progress(name: str) -> float | None:
    """Returns the finished share of the whole subject, 0 .. 1; None if no work is left to do."""
    if name in _stopped:
        return None
    if _running is not None and _running[0] == name:
        return _running[1].share
    return 0.0 if name in _wishes else None


def is_draft(name: str) -> bool:
    """Returns whether the object with that full name shows a draft."""
    return progress(name) is not None or is_stopped(name)


def at_work() -> tuple[str, Job] | None:
    """Returns the full name of the object whose whole subject is being made, and the job."""
    return _running


def step() -> float | None:
    """Ends a job and begins the next, for the timer. Returns the seconds until the next call; None
    without work that is left or stopped."""
    global _stepping, _step_at
    _stepping = True
    try:
        return _step()
    finally:
        _stepping, _step_at = False, time.monotonic()


def _step() -> float | None:
    global _running
    if _running is not None:
        name, job = _running
        if job.is_alive():
            if line()[0] != _drawn and time.monotonic() - _drawn_at >= _REDRAWS:
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
    if _wishes or _running:
        return 0.05
    return 0.25 if _stopped or _kept else None


_PATIENCE = 10.0  # [s] without a call of `step` after which no timer runs: Blender is ending


def complete() -> bool:
    """Blocks until no draft is left, before a render. Returns False if the timer that ends drafts
    does not run any more. A render in a thread of its own leaves the work to the timer: only the
    main thread may change Blender's data."""
    for name in list(_stopped):
        resume(name)
    for wish in list(_wishes.values()):
        wish.rest = 0.0
    if is_main_thread():
        while (pause := step()) is not None and (_wishes or _running is not None):
            time.sleep(min(pause, 0.02))
        return True
    begun = time.monotonic()
    while _wishes or _running is not None or _stepping:
        if time.monotonic() - max(begun, _step_at) > _PATIENCE:
            return False
        time.sleep(0.02)
    return True


_drawn: str | None = None
"""The line that the status bar shows."""
_drawn_at = 0.0
_REDRAWS = 0.4
"""[s] From one picture of the progress to the next, at least: each draws the panels again."""


def line() -> tuple[str, str]:
    """Returns a line on the work for the status bar, and the full name of its object; "" without
    work."""
    if _running is not None:
        name, job = _running
        return job.status_text(name), name
    for name in _wishes:
        return tr_label("{}: a draft", name), name
    return "", ""


def _redraw() -> None:
    """Has the panels drawn again and, if its line is another one, the status bar."""
    global _drawn, _drawn_at
    said, before = line()[0], _drawn
    _drawn, _drawn_at = said, time.monotonic()
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "PROPERTIES":
                area.tag_redraw()
        if said != before:
            # No area of the screen: Blender draws it again when its text is set.
            with bpy.context.temp_override(window=window):
                window.workspace.status_text_set_internal(None)


def close() -> None:
    """Withdraws all requests and ends the running job."""
    global _running
    _wishes.clear()
    _stopped.clear()
    _kept.clear()
    if _running is not None:
        _running[1].cancel()
        _running[1].join()
        _running[1].close()
        _running = None
    if bpy.app.timers.is_registered(step):
        bpy.app.timers.unregister(step)
