# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A panel that objects with one of the add-on's modifiers have."""


class ModifierPanel:
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "modifier"

    @staticmethod
    def modifiers(shown) -> list:
        """Returns the modifiers of an object that have the panel; a subclass says which."""
        raise NotImplementedError

    @classmethod
    def poll(cls, context) -> bool:
        return context.object is not None and bool(cls.modifiers(context.object))
