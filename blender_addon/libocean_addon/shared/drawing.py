# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What panels have in common: they never fail to draw, and say sentences in lines that fit."""

from __future__ import annotations

import functools
import textwrap
import traceback

from .compat import tr_label

_CHARACTERS = 40  # of a line that a panel of the usual width shows whole

_told: set[str] = set()


def never_raises(draw):
    """A draw function that says in the panel what went wrong: Blender would leave the rest of the
    panel out, at every redraw anew. The console gets it once."""

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
    """A sentence, in as many lines as it takes."""
    column = layout.column(align=True)
    for number, line in enumerate(textwrap.wrap(text, _CHARACTERS)):
        mark = icon if number == 0 else "NONE" if icon == "NONE" else "BLANK1"
        column.label(text=line, icon=mark, translate=False)
