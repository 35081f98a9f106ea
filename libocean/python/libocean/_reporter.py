# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The functions that the library calls while it works: progress, and jobs for a host's threads."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from . import _abi, _library


class Reporter:
    """Hands progress and jobs to Python functions. Ends a call of the library for Ctrl-C, and when
    one of these functions raises."""

    def __init__(
        self,
        progress: Callable[[int, int], object] | None,
        jobs: Callable[[Callable[[int], None], int], object] | None,
    ) -> None:
        self._progress = progress
        self._jobs = jobs
        self._signal: tuple[int, Any] | None = None
        self._failure: BaseException | None = None
        self._inside = False
        self.progress = _abi.Progress(self._report)
        self.run_jobs = _abi.RunJobs(self._run_jobs) if jobs else _abi.RunJobs()

    def _report(self, _user: Any, done: int, total: int) -> int:
        if self._signal is None and self._progress is not None and total > 0:
            try:
                self._progress(done, total)
            except BaseException as failure:
                self._failure = failure
        return int(self._signal is not None or self._failure is not None)

    def _run_jobs(self, _user: Any, job: Any, work: Any, count: int) -> None:
        assert self._jobs is not None  # without jobs the library has no function to call
        try:
            self._jobs(lambda index: job(work, index), count)
        except BaseException as failure:
            self._failure = failure

    def require_outside(self) -> None:
        """Raises Error within a call of the library, which no function that it calls may enter."""
        if self._inside:
            raise _library.error(
                "a progress or jobs function uses the subject whose call it serves; give it a "
                "clone()",
                _abi.BUSY,
            )

    @contextmanager
    def watched(self) -> Iterator[None]:
        """Raises, after the call inside it, the exception of a Python function, and handles Ctrl-C:
        Python's handlers run in the main thread alone, between two steps of Python. A signal within
        a call is noted and handled when the library has returned."""
        self.require_outside()
        self._signal = self._failure = None
        before = None
        if threading.current_thread() is threading.main_thread():
            before = signal.getsignal(signal.SIGINT)
        if callable(before):
            signal.signal(signal.SIGINT, self._note)
        cancelled = None
        try:
            self._inside = True
            yield
        except _library.CancelledError as failure:
            cancelled = failure
        finally:
            self._inside = False
            if callable(before):
                signal.signal(signal.SIGINT, before)
        if self._failure is not None:
            raise self._failure
        if self._signal is not None and callable(before):
            before(*self._signal)
        if cancelled is not None:
            raise cancelled

    def _note(self, number: int, frame: Any) -> None:
        self._signal = (number, frame)
