# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines that the first panel of every subject has: on problems, and on facts."""

from __future__ import annotations

from collections.abc import Iterable

from .drawing import say, say_state


def draw_problems(layout, scene, problems: Iterable[str], of_units: str) -> None:
    """Draws sentences on what is not shown as requested. of_units: the sentence on a scene whose
    units are no metres."""
    for text in filter(None, problems):
        say(layout, text, "ERROR")
    if scene.unit_settings.scale_length != 1.0:
        say(layout, of_units, "INFO")


def draw_facts(layout, ob, facts) -> None:
    """Draws the facts about an object: state_of, sizes_of and warnings_of of the module `facts`;
    nothing before there is a state."""
    state = facts.state_of(ob)
    if state is None:
        return
    box = layout.box().column(align=True)
    say_state(box, state)
    for text in facts.sizes_of(ob):
        say(box, text)
    for text in facts.warnings_of(ob):
        say(box, text, "ERROR")
