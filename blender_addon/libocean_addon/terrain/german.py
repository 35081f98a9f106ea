# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The German words of terrains, which translations.py adds to the others."""

from __future__ import annotations

TERMS = {
    # Parameters of the terrain file.
    "Kind": "Art",
    "Beta": "Beta",
    "RMS height": "Höhe (RMS)",
    "Range": "Höhenbereich",
    "Mean height": "Mittlere Höhe",
    "Outer scale": "Grundwelle",
    "Breaks": "Knicke",
    "Ridge wavelength": "Gratabstand",
    "Ridge gain": "Gratverstärkung",
    "Ridge width": "Gratbreite",
    "Ridge direction": "Gratrichtung",
    "Ridge spread": "Gratbündelung",
    "Anisotropy": "Anisotropie",
    "Direction": "Richtung",
    "Measured spectrum": "Gemessenes Spektrum",
    "Period": "Periode",
    "Gain": "Verstärkung",
    # Their switches and choices.
    "Use RMS height": "Höhe (RMS) angeben",
    "Use Range": "Höhenbereich angeben",
    "Use Ridge direction": "Gratrichtung angeben",
    "Tile": "Kachel",
    # Short labels.
    "Ridges": "Grate",
    "Width": "Breite",
    "Spread": "Bündelung",
    "Break": "Knick",
    "Beta below": "Beta darunter",
    # Facts about the land.
    "Median slope": "Mittlere Neigung",
    "Steepest 1 %": "Steilstes 1 %",
    # Sockets of the material, of which Blender has words of its own for some.
    "Snow Line": "Schneegrenze",
    "Forest Line": "Waldgrenze",
    "Sand Line": "Sandgrenze",
    "Line Width": "Saumbreite",
    "Sun Melt": "Schmelze",
    "Sun Bearing": "Sonnenrichtung",
    "Snow Slope": "Schneehang",
    "Rock Slope": "Felshang",
    "Scree Slope": "Geröllhang",
    "Noise Size": "Fleckengröße",
    "Noise Amount": "Flecken",
    "Snow Colour": "Schneefarbe",
    "Rock Colour": "Felsfarbe",
    "Scree Colour": "Geröllfarbe",
    "Grass Colour": "Grasfarbe",
    "Forest Colour": "Waldfarbe",
    "Sand Colour": "Sandfarbe",
    "Colour": "Farbe",
}

OPERATORS = {
    "Terrain": "Gelände",
    "Terrain (libocean)": "Gelände (libocean)",
    "Load Terrain": "Gelände laden",
    "Save Terrain": "Gelände speichern",
    "Terrain Preset": "Geländevorgabe",
    "Terrain Material": "Geländematerial",
    "Add Layer": "Ebene hinzufügen",
    "Remove Layer": "Ebene entfernen",
    "Add Break": "Knick hinzufügen",
    "Remove Break": "Knick entfernen",
}

TEXTS = {
    "Terrain (libocean)": "Gelände (libocean)",
    "Land": "Land",
    "Layers": "Ebenen",
    "Layer": "Ebene",
    "Ground": "Boden",
    "Shape": "Form",
    "Tiles": "Kacheln",
    "Earth": "Erde",
    "Map: {} x {} samples, {:,.0f} MB": "Karte: {} x {} Stützstellen, {:,.0f} MB",
    "{}: {} x {} samples": "{}: {} x {} Stützstellen",
    "A draft; the whole land follows": "Ein Entwurf; das ganze Land folgt",
    "A draft, with fewer samples": "Ein Entwurf mit weniger Stützstellen",
    "The land takes a Blender unit for a metre": (
        "Das Land nimmt eine Blender-Einheit für einen Meter"
    ),
    "The spectrum is measured: it has no law": "Das Spektrum ist gemessen und folgt keinem Gesetz",
    # Hints.
    "The object is scaled by {:.3g}, and so is its land": (
        "Das Objekt ist um {:.3g} skaliert, und sein Land auch"
    ),
    "The object is scaled unevenly, and so are its slopes: apply the scale": (
        "Das Objekt ist ungleich skaliert, und seine Hänge auch: Skalierung anwenden"
    ),
    "{} is no vertex group or attribute: the land is flat": (
        "{} ist weder Punktgruppe noch Attribut: das Land ist eben"
    ),
    "The camera sees {:.0f} m far: raise its Clip End": (
        "Die Kamera sieht {:.0f} m weit: erhöhen Sie ihr Clip-Ende"
    ),
    "Two terrain modifiers raise the mesh twice": (
        "Zwei Gelände-Modifikatoren heben das Mesh doppelt"
    ),
    # Why something cannot be done.
    "No terrain is selected": "Kein Gelände ist gewählt",
    "The active object has no terrain modifier": "Das aktive Objekt hat keinen Geländemodifikator",
    "The active object has a terrain or an ocean": (
        "Das aktive Objekt hat schon ein Gelände oder einen Ozean"
    ),
    "The active object has a terrain": "Das aktive Objekt hat ein Gelände",
    "A terrain has at most {} layers": "Ein Gelände hat höchstens {} Ebenen",
    "A terrain has at most {} breaks": "Ein Gelände hat höchstens {} Knicke",
    "The terrain has no layer {}": "Das Gelände hat keine Ebene {}",
    "The terrain has no break {}": "Das Gelände hat keinen Knick {}",
}
