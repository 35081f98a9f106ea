# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The German words of coasts, which translations.py adds to the others."""

from __future__ import annotations

TERMS: dict[str, str] = {}

OPERATORS = {
    "Coast": "Küste",
    "Load Coast": "Küste laden",
    "Save Coast": "Küste speichern",
}

TEXTS = {
    "Coast (libocean)": "Küste (libocean)",
    "Bed": "Grund",
    "Wet ground": "Nasser Grund",
    "Wet ground has no effect: it needs Land, a mesh": (
        "Nasser Grund ist ohne Wirkung: er braucht Land, ein Mesh"
    ),
    "Bed: {:.4g} to {:.4g} m": "Grund: {:.4g} bis {:.4g} m",
    "End at the waterline": "An der Wasserlinie enden",
    "Below land": "Unter dem Land",
    "A draft; the whole coast follows: {:.0%}": "Ein Entwurf; die ganze Küste folgt: {:.0%}",
    "A draft: the coast as it was": "Ein Entwurf: die Küste, wie sie war",
    "Cell: {:.3g} m": "Zelle: {:.3g} m",
    "{}: waves over the bed, {:.0%}": "{}: Wellen über dem Grund, {:.0%}",
    "{}: water and foam, {:.0%}": "{}: Wasser und Schaum, {:.0%}",
    "The active object has a coast": "Das aktive Objekt hat eine Küste",
    "The active object is no water of a coast; Object > Ocean mends one whose modifier was "
    "removed": (
        "Das aktive Objekt ist kein Wasser einer Küste; Objekt > Ozean flickt eines, dessen "
        "Modifikator entfernt wurde"
    ),
    "{} has the sea of a coast, and a mesh of its own: add a coast instead": (
        "{} hat die See einer Küste und ein eigenes Mesh: fügen Sie statt dessen eine Küste hinzu"
    ),
    "At {:.1f}, {:.1f} m {} shows no water": "Bei {:.1f}, {:.1f} m zeigt {} kein Wasser",
    "At {:.1f}, {:.1f} m {} is dry land, {:.1f} m over water": (
        "Bei {:.1f}, {:.1f} m ist {} trockenes Land, {:.1f} m über dem Wasser"
    ),
    "The sea has no bed: choose a terrain file or an elevation model for Sea bed, or load a sea "
    "that has one": (
        "Die See hat keinen Grund: wählen Sie eine Geländedatei oder ein Höhenmodell für "
        "Meeresgrund, oder laden Sie eine See, die einen hat"
    ),
    "{}: the sea has no bed: a coast needs seabed in [water]": (
        "{}: die See hat keinen Grund: eine Küste braucht seabed in [water]"
    ),
}
