# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that bring the selected objects to a water of the scene."""

from __future__ import annotations

import bpy

from ..shared.compat import tr
from . import riding


class OnWater:
    """Their base: the choice of the water."""

    bl_options = {"REGISTER", "UNDO"}

    ocean: bpy.props.StringProperty(
        name="Ocean", description="Name of the ocean; empty: the active one, or the only one"
    )

    @staticmethod
    def ask() -> str:
        """Returns the sentence on a selection without objects; a subclass says it."""
        raise NotImplementedError

    @classmethod
    def poll(cls, context) -> bool:
        if any(not riding.is_water(ob) for ob in context.selected_objects):
            return True
        cls.poll_message_set(cls.ask())
        return False

    def water(self, context, waters: list):
        """Returns the one of these waters that is meant; None, with a report, if none is."""
        found = waters[0] if len(waters) == 1 else None
        if self.ocean:
            found = next((ob for ob in waters if ob.name == self.ocean), None)
        elif context.object in waters:
            found = context.object
        if found is None:
            self.report({"ERROR"}, tr("Which ocean? Make it the active object, or give its name"))
        return found
