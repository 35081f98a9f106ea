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
    "Origin": "Ursprung",
    "Size": "Größe",
    "Island": "Insel",
    "Base": "Grundlage",
    "Base error": "Fehler der Grundlage",
    "Detail wavelength": "Kleinste Welle",
    "Gully depth": "Rinnentiefe",
    "Gully distance": "Rinnenabstand",
    "Gully octaves": "Rinnenoktaven",
    "Crease": "Schärfe",
    "Flat slope": "Flache Neigung",
    "Gully seed": "Rinnen-Seed",
    "Stream slope": "Hangneigung",
    "Area exponent": "Flächenexponent",
    "Hillslope area": "Hangfläche",
    "Max slope": "Höchste Neigung",
    "Age": "Alter",
    "Creep": "Kriechen",
    "Stream seed": "Bach-Seed",
    "Beach slope": "Strandneigung",
    "Water level": "Wasserstand",
    "Berm": "Strandwall",
    "Beach face": "Strandstirn",
    "Closure depth": "Schlusstiefe",
    "Shelf depth": "Schelftiefe",
    "Shore smoothing": "Uferglättung",
    "Shelter radius": "Schutzradius",
    "Beach width": "Strandbreite",
    # Their switches and choices.
    "Use Origin": "Ursprung angeben",
    "Use Size": "Größe angeben",
    "Use Base error": "Fehler der Grundlage angeben",
    "Use Detail wavelength": "Kleinste Welle angeben",
    "Use Water level": "Wasserstand angeben",
    "Placed": "Einmalig",
    "Gullies": "Rinnen",
    "Streams": "Bäche",
    "Shore": "Ufer",
    "Use RMS height": "Höhe (RMS) angeben",
    "Use Range": "Höhenbereich angeben",
    "Use Ridge direction": "Gratrichtung angeben",
    "Tile": "Kachel",
    "Snap": "Raster",
    "Distance": "Abstand",
    "Spacing": "Punktabstand",
    # Short labels.
    "West": "Westen",
    "South": "Süden",
    "East": "Osten",
    "North": "Norden",
    "Detail": "Detail",
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
    "Beach Sand": "Strandsand",
    "Cliff Rock": "Klippenfels",
    "Stream Scree": "Bachschotter",
    "Flow Forest": "Auwald",
    "Wear Shade": "Rinnenschatten",
    "Noise Size": "Fleckengröße",
    "Noise Amount": "Flecken",
    "Snow Colour": "Schneefarbe",
    "Rock Colour": "Felsfarbe",
    "Scree Colour": "Geröllfarbe",
    "Grass Colour": "Grasfarbe",
    "Forest Colour": "Waldfarbe",
    "Sand Colour": "Sandfarbe",
    "Wet Sand Colour": "Farbe nassen Sands",
    "Dry Grass Colour": "Farbe dürren Grases",
    "Wet Line": "Nasse Höhe",
    "Dry Share": "Dürres Gras",
    "Colour": "Farbe",
}

OPERATORS = {
    "Terrain": "Gelände",
    "Terrain (libocean)": "Gelände (libocean)",
    "Terrain File": "Geländedatei",
    "Load Terrain": "Gelände laden",
    "Save Terrain": "Gelände speichern",
    "Terrain Preset": "Geländevorgabe",
    "Add Trees": "Bäume hinzufügen",
    "Terrain Material": "Geländematerial",
    "Add Layer": "Ebene hinzufügen",
    "Remove Layer": "Ebene entfernen",
    "Add Break": "Knick hinzufügen",
    "Remove Break": "Knick entfernen",
}

TEXTS = {
    "Terrain (libocean)": "Gelände (libocean)",
    "Land": "Land",
    "Place": "Lage",
    "Gullies": "Rinnen",
    "Streams": "Bäche",
    "Shore": "Ufer",
    "Region": "Ausschnitt",
    "Cell": "Zelle",
    "Spacing": "Punktabstand",
    "Distance": "Abstand",
    "Slope": "Neigung",
    "Snap": "Raster",
    "Level of detail": "Detailgrad",
    "Level of Detail": "Detailgrad",
    "The scene has no camera: the mesh is a plain one": (
        "Die Szene hat keine Kamera: das Mesh ist ein einfaches"
    ),
    "The region is smaller than its cell of {:g} m": (
        "Der Ausschnitt ist kleiner als seine Zelle von {:g} m"
    ),
    "The region has {:,} x {:,} vertices; allowed: {:,} together": (
        "Der Ausschnitt hat {:,} x {:,} Punkte; erlaubt: zusammen {:,}"
    ),
    "The region reaches beyond the land, which lies from {:g} to {:g} m east and from {:g} to "
    "{:g} m north": (
        "Der Ausschnitt reicht über das Land hinaus, das von {:g} bis {:g} m Ost und von {:g} bis "
        "{:g} m Nord liegt"
    ),
    "Layers": "Ebenen",
    "Layer": "Ebene",
    "Ground": "Boden",
    "Shape": "Form",
    "Tiles": "Kacheln",
    "Earth": "Erde",
    "Bay Island": "Insel mit Buchten",
    "Map: {} x {} samples, {:,.0f} MB": "Karte: {} x {} Stützstellen, {:,.0f} MB",
    "{}: {} x {} samples": "{}: {} x {} Stützstellen",
    "A draft; the whole land follows": "Ein Entwurf; das ganze Land folgt",
    "A draft; the whole land follows: {:.0%}": "Ein Entwurf; das ganze Land folgt: {:.0%}",
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
    "{} tiles have at most {} vertices along each, not {}": (
        "{} Kacheln haben höchstens {} Punkte entlang jeder, nicht {}"
    ),
    "Mask and Anchor to the world have no effect with Level of Detail": (
        "Maske und In der Welt verankern sind mit Detailgrad ohne Wirkung"
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
    "The active object has trees": "Das aktive Objekt hat schon Bäume",
    "The active object has a terrain": "Das aktive Objekt hat ein Gelände",
    "A terrain has at most {} layers": "Ein Gelände hat höchstens {} Ebenen",
    "A terrain has at most {} breaks": "Ein Gelände hat höchstens {} Knicke",
    "The terrain has no layer {}": "Das Gelände hat keine Ebene {}",
    "The terrain has no break {}": "Das Gelände hat keinen Knick {}",
}
