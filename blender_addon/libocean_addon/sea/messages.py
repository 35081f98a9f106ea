# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences of the library about a sea, in the words of its panel."""

from __future__ import annotations

from ..shared.compat import tr
from ..shared.messages import Words
from ..shared.native import libocean
from . import parameter_values, sea_text

WORDS = Words(parameter_values.PARAMETERS)
label_of = WORDS.label_of
in_words = WORDS.in_words
of_error = WORDS.of_error


def require_files(values: sea_text.SeaValues) -> None:
    """Raises libocean.Error for a measured spectrum without a file or record."""
    for system in values.waves:
        if system.values["spectrum"] == "measured" and not (system.values["file"] or system.record):
            raise libocean.Error(tr("A measured spectrum needs a file: choose one below"), 0)
