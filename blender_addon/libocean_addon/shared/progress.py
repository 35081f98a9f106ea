# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The progress of a work with several parts; each part reports its own from 0 to its end."""

from __future__ import annotations


class Progress:
    """The finished share of a work, which never falls. The number of parts is unknown: each takes
    half of the share that the parts before it left."""

    def __init__(self, begin: float = 0.0, end: float = 1.0) -> None:
        """begin, end: the shares of a larger work between which this one lies."""
        self.share, self._begin, self._end = begin, begin, end
        self._before = (0, 0)

    def note(self, done: int, total: int) -> None:
        """Notes that `done` of `total` of a part are finished; a total of 0 says nothing."""
        if total <= 0:
            return
        if total != self._before[1] or done < self._before[0]:
            self._begin = self.share
        self._before = done, total
        self.share = self._begin + 0.5 * (self._end - self._begin) * done / total
