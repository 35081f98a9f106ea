# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Helpers of all panels: they never fail to draw, and wrap sentences into lines that fit."""

from __future__ import annotations

import functools
import textwrap
import traceback

from .compat import tr_label

_CHARACTERS = 40  # of a line that a panel of the usual width shows whole

_told: set[str] = set()


def never_raises(draw):
    """Wraps a draw function so that an exception becomes a line of the panel: Blender would leave
    out the rest of the panel at every redraw. The console gets the traceback once."""

    @functools.wraps(draw)
    def drawn(self, context):  # Blender counts the arguments
        try:
            draw(self, context)
        except Exception as failure:
            text = f"{type(failure).__name__}: {failure}"
            if text not in _told:
                _told.add(text)
                traceback.print_exc()
            say(self.layout, tr_label("This cannot be shown: {}", text), "ERROR")

    return drawn


def say(layout, text: str, icon: str = "NONE") -> None:
    """Draws a sentence in as many lines as it takes."""
    column = layout.column(align=True)
    for number, line in enumerate(textwrap.wrap(text, _CHARACTERS)):
        mark = icon if number == 0 else "NONE" if icon == "NONE" else "BLANK1"
        column.label(text=line, icon=mark, translate=False)
