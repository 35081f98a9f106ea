# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The whole sea behind a draft: a clone of it that has followed its foam."""

from __future__ import annotations

from ..shared import images
from ..shared.compat import tr_label
from ..shared.drafts import Job


class SeaJob(Job):
    """Makes a clone of a sea ready for the map of one time."""

    def __init__(
        self, sea, changes: int, at: float, size: int, channel: str, spray: dict | None, spray_sea
    ) -> None:
        """spray_sea: the clone that makes the spray, which may be the same."""
        super().__init__((changes, at, size, channel))
        self.sea, self.changes, self.time, self.size, self.channel = sea, changes, at, size, channel
        self.spray, self.spray_sea = spray, spray_sea
        self.displacement = images.aligned((size, size))
        """The pixels of that image, once the job has ended."""

    def work(self) -> None:
        self.sea.fill(self.time, [(self.displacement, ("dx", "dy", "height", self.channel))])
        if self.spray is not None:
            self.spray_sea.spray(self.time, **self.spray)

    def close(self) -> None:
        self.sea.close()
        self.spray_sea.close()

    def status_text(self, name: str) -> str:
        return tr_label("{}: foam {:.0%}", name, self.share)
