# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The words of the interface in other languages, by the English ones in the sources.

Blender looks up itself what it draws: names of properties, choices, panels and operators. What is
made of parts (reports, states) is looked up by compat.tr and compat.tr_label. Tool tips are in
English for now, and so is what the library itself says. Names of data, which scripts look for, and
proper names (Beaufort 5, Jerlov II) are not translated.
"""

from __future__ import annotations

import bpy

from .coast import german as coast_german
from .terrain import german as terrain_german

SEA = "libocean"
"""Context of the terms of seas and terrains: in "*" Blender's own words come first, for "Fetch"
those of fetching something. They are in "*" too, where older versions look up a property's
choices."""

GERMAN = {
    SEA: {
        # Parameters of the sea file.
        "Depth": "Wassertiefe",
        "Gravity": "Schwerkraft",
        "Surface tension": "Oberfl.spannung",
        "Density": "Dichte",
        "Sea bed": "Meeresgrund",
        "Sea bed origin": "Ursprung des Grundes",
        "Sea bed unit": "Einheit des Grundes",
        "Sea bed sign": "Vorzeichen des Grundes",
        "Bed origin": "Grund ab",
        "Bed unit": "Grundeinheit",
        "Bed sign": "Grundrichtung",
        "Surf foam": "Brandung",
        "Water level": "Wasserstand",
        "Swash": "Wellenauflauf",
        "Surf foam lifetime": "Brandungsschaum",
        "Resolution": "Auflösung",
        "Patch size": "Kachelgröße",
        "Cascades": "Kaskaden",
        "Cascade divisors": "Kaskadenteiler",
        "Choppiness": "Kammschärfe",
        "Shortest wavelength": "Kürzeste Wellenlänge",
        "Longest wavelength": "Längste Wellenlänge",
        "Foam lifetime": "Schaumdauer",
        "Foam step": "Schaumschritt",
        "Foam resolution": "Schaumauflösung",
        "Foam map": "Schaumkarte",
        "Coverage": "Bedeckung",
        "Foam coverage": "Bedeckung",
        "Foam threshold": "Schwelle",
        "Foam width": "Schaumbreite",
        "Start": "Startzeit",
        "First frame": "Erstes Bild",
        "Frame rate": "Bildrate",
        "Loop period": "Schleifendauer",
        "Glide": "Angleichzeit",
        "Take": "Aufnahme",
        "Seed": "Startwert",
        "Spectrum": "Spektrum",
        "Wind speed": "Windstärke",
        "Wind direction": "Windrichtung",
        "Fetch": "Wirklänge",
        "Peak enhancement": "Überhöhungsfaktor",
        "Spreading": "Verteilung",
        "Swell": "Dünung",
        "Opposing waves": "Gegenwellen",
        "Significant wave height": "Signifikante Wellenhöhe",
        "Wave height": "Wellenhöhe",
        "Enhancement": "Überhöhung",
        "Cut-off": "Grenzwelle",
        "Divisors": "Teiler",
        "Longest wave": "Längste Welle",
        "Viewport": "Ansicht",
        "Render": "Rendern",
        "Mesh": "Mesh",
        "Peak period": "Peakperiode",
        "Viewport resolution": "Auflösung in der Ansicht",
        "Render resolution": "Auflösung beim Rendern",
        "Mesh resolution": "Auflösung des Meshs",
        "Sea's own": "Wie die See",
        "Automatic": "Automatisch",
        "Amplitude": "Amplitude",
        "Alignment": "Ausrichtung",
        "Cut-off wavelength": "Grenzwellenlänge",
        "Spectrum file": "Spektrumsdatei",
        "Record": "Messung",
        "Place": "Ort",
        "Estimator": "Schätzverfahren",
        # Their switches.
        "Use Depth": "Wassertiefe angeben",
        "Use Sea bed origin": "Ursprung des Grundes angeben",
        "Use Wind speed": "Windgeschwindigkeit angeben",
        "Use Wind direction": "Windrichtung angeben",
        "Use Significant wave height": "Signifikante Wellenhöhe angeben",
        "Use Peak period": "Peakperiode angeben",
        # Their choices.
        "Monahan": "Monahan",
        "Threshold": "Schwelle",
        "Phillips": "Phillips",
        "Pierson moskowitz": "Pierson-Moskowitz",
        "Jonswap": "JONSWAP",
        "Tma": "TMA",
        "Measured": "Gemessen",
        "Cosine squared": "Kosinus-Quadrat",
        "Mitsuyasu": "Mitsuyasu",
        "Hasselmann": "Hasselmann",
        "Donelan banner": "Donelan-Banner",
        "Maximum entropy": "Maximale Entropie",
        "Fourier": "Fourier",
        "M": "m",
        "Ft": "ft",
        "Us ft": "US-ft",
        "Up": "Aufwärts",
        "Down": "Abwärts",
        "On": "An",
        "Off": "Aus",
        # Facts about the sea.
        "Energy resolved": "Energieanteil",
        "Shortest wave": "Kürzeste Welle",
        # The menu of presets: Blender's own word is long.
        "Preset": "Vorgabe",
        # The range of a bake.
        "To": "Bis",
    },
    "Operator": {
        "Ocean": "Ozean",
        "Ocean (libocean)": "Ozean (libocean)",
        "Ocean Scene": "Ozean mit Himmel",
        "Load Sea": "Seegang laden",
        "Save Sea": "Seegang speichern",
        "Sea Preset": "Seegangsvorgabe",
        "Add Wave System": "Wellensystem hinzufügen",
        "Remove Wave System": "Wellensystem entfernen",
        "Measured Waves": "Gemessene Wellen",
        "Ocean Material": "Ozeanmaterial",
        "Bake Ocean": "Ozean backen",
        "Free Bake": "Gebackenes freigeben",
        "Float on Ocean": "Auf dem Ozean schwimmen",
        "Stop Floating": "Nicht mehr schwimmen",
        "Write Volumes": "Volumen schreiben",
        "Bake Floating": "Schwimmen backen",
        "Free Floating": "Schwimmen freigeben",
        "Subdivide for Waves": "Für Wellen unterteilen",
        "Make Asset Library": "Asset-Bibliothek anlegen",
        "Preset": "Vorgabe",
        "Load": "Laden",
        "Save": "Speichern",
        "Material": "Material",
        "Bake": "Backen",
        "Free": "Freigeben",
        "Keep the Draft": "Entwurf behalten",
        "Make the Whole Sea": "Ganze See berechnen",
        "Finish": "Fertigstellen",
    },
    "*": {
        # Panels.
        "Ocean (libocean)": "Ozean (libocean)",
        "Sea": "See",
        "Look": "Aussehen",
        "Advanced": "Weiteres",
        "Water": "Wasser",
        "Surface": "Oberfläche",
        "Time": "Zeit",
        "Mesh": "Mesh",
        "Own divisors": "Eigene Teiler",
        "Spray": "Gischt",
        "Lifetime": "Lebensdauer",
        "At most": "Höchstens",
        "Size": "Größe",
        "{:,} points": "{:,} Punkte",
        "{:,} points, max age {:.3g} s: half of the loop": (
            "{:,} Punkte, Höchstalter {:.3g} s: die halbe Schleife"
        ),
        "There is no spray: it needs a wind above 7 m/s": (
            "Keine Gischt: dazu braucht es mehr als 7 m/s Wind"
        ),
        "There is no spray at this time": "Zu dieser Zeit ist keine Gischt da",
        "A draft; the whole sea: {:.0%}": "Ein Entwurf; die ganze See: {:.0%}",
        "A draft, without the past of its foam": "Ein Entwurf, ohne den früheren Schaum",
        "{}: foam {:.0%}": "{}: Schaum {:.0%}",
        "{}: a draft": "{}: ein Entwurf",
        "{} cascades: maps of {} x {} samples": "{} Kaskaden: Karten von {} x {} Stützstellen",
        "This cannot be shown: {}": "Das kann nicht gezeigt werden: {}",
        "{} is a mesh of your own, which no patch or horizon replaces: kind MESH shows the sea on "
        "it": (
            "{} ist ein Mesh von Ihnen, das weder Feld noch Horizont ersetzt: die Art MESH zeigt "
            "die See darauf"
        ),
        # Hints and warnings.
        "Mesh: {:,} vertices": "Mesh: {:,} Punkte",
        "Maps: {} x {} samples, {:,.0f} MB": "Karten: {} x {} Stützstellen, {:,.0f} MB",
        "Maps: {} and, rendered, {}, {:,.0f} MB": "Karten: {} und, gerendert, {}, {:,.0f} MB",
        "The mesh shows one in {} of their samples": "Das Mesh zeigt eine von {} Stützstellen",
        "The object is scaled by {:.3g}, and so are its waves": (
            "Das Objekt ist um {:.3g} skaliert, und seine Wellen auch"
        ),
        "The object is scaled unevenly, and so are its waves: apply the scale": (
            "Das Objekt ist ungleich skaliert, und seine Wellen auch: Skalierung anwenden"
        ),
        "{} is no vertex group or attribute: the sea stands still": (
            "{} ist weder Punktgruppe noch Attribut: die See steht still"
        ),
        "The limits of the wavelength leave {:.0%} of the wave height": (
            "Die Grenzen der Wellenlänge lassen {:.0%} der Wellenhöhe"
        ),
        "Near detail has no effect: it needs Foam and Normal": (
            "Details der Nähe sind ohne Wirkung: sie brauchen Schaum und Normale"
        ),
        "Two ocean modifiers show the same sea, and their waves add up": (
            "Zwei Ozean-Modifikatoren zeigen dieselbe See, ihre Wellen addieren sich"
        ),
        "{:.0f} m between vertices are too far for waves of {:.0f} m": (
            "{:.0f} m zwischen den Punkten sind zu weit für Wellen von {:.0f} m"
        ),
        "Bake": "Backen",
        "Float (libocean)": "Schwimmen (libocean)",
        "Attributes": "Attribute",
        # The sea of an object.
        "Active wave system": "Aktives Wellensystem",
        "Kind": "Art",
        "Sun elevation": "Sonnenhöhe",
        "Sun bearing": "Sonnenrichtung",
        "Camera height": "Kamerahöhe",
        "Remove cube and lamp": "Würfel und Lampe entfernen",
        "Patch": "Kachel",
        "Horizon": "Horizont",
        "Distance": "Entfernung",
        "Vertices": "Punkte",
        "Scene's frame rate": "Bildrate der Szene",
        "Own time": "Eigene Zeit",
        "Foam": "Schaum",
        "Velocity": "Geschwindigkeit",
        "Normal": "Normale",
        "Near detail": "Details der Nähe",
        "Mask": "Maske",
        "Anchor to the world": "In der Welt verankern",
        "Play the bake": "Gebackenes abspielen",
        "Preset": "Vorgabe",
        "Material": "Material",
        "The sea takes a Blender unit for a metre": (
            "Die See nimmt eine Blender-Einheit für einen Meter"
        ),
        "libocean is missing: {}": "libocean fehlt: {}",
        "NumPy is missing in {}, the Python of this Blender: install the package python3-numpy "
        "(Debian, Ubuntu) and start Blender again": (
            "NumPy fehlt in {}, dem Python dieses Blenders: installieren Sie das Paket "
            "python3-numpy (Debian, Ubuntu) und starten Sie Blender neu"
        ),
        "Cycles is built without OpenImageDenoise here, as in Debian's package blender; the "
        "Blender of blender.org has it": (
            "Cycles ist hier ohne OpenImageDenoise gebaut, wie in Debians Paket blender; das "
            "Blender von blender.org hat es"
        ),
        "Cycles is built without a denoiser here, as in Debian's package blender, and will not "
        "render: switch off Denoise in Render > Sampling": (
            "Cycles ist hier ohne Entrauscher gebaut, wie in Debians Paket blender, und rendert "
            "so nicht: schalten Sie Entrauschen unter Rendern > Sampling aus"
        ),
        "Denoise is off: {}": "Entrauschen ist aus: {}",
        # Material.
        "Under water": "Unter Wasser",
        "Visibility": "Sichtweite",
        "God rays": "Sonnenstrahlen",
        "Focus depth": "Brenntiefe",
        "Water Colour": "Wasserfarbe",
        "Crest Light": "Kammlicht",
        "Crest Colour": "Kammfarbe",
        "Sun Direction": "Sonnenrichtung",
        "Sun Light": "Sonnenlicht",
        "Sun Focus": "Sonnenbündelung",
        "Wave Height": "Wellenhöhe",
        "Air Light": "Luftlicht",
        "Foam Colour": "Schaumfarbe",
        "Foam Amount": "Schaummenge",
        "Thin Foam Colour": "Farbe dünnen Schaums",
        "Bubble Colour": "Blasenfarbe",
        "Foam Tile": "Schaumkachel",
        "Foam Edge": "Schaumrand",
        "Foam Stretch": "Schaumstreckung",
        "Foam Streaks": "Schaumstreifen",
        "Wind Direction": "Windrichtung",
        "Pixel Angle": "Pixelwinkel",
        "Detail": "Details",
        "Roughness": "Rauheit",
        "IOR": "Brechungsindex",
        "Transparency": "Transparenz",
        "Absorption": "Absorption",
        "Scattering": "Streuung",
        "Anisotropy": "Anisotropie",
        "Volume": "Volumen",
        # Bake.
        "Folder": "Ordner",
        "Own range": "Eigener Bereich",
        "Frames from": "Bilder von",
        "Last frame": "Letztes Bild",
        "Overwrite": "Überschreiben",
        "Delete files": "Dateien löschen",
        "{} of {} frames, {}": "{} von {} Bildern, {}",
        "{} of {} frames; ESC stops": "{} von {} Bildern; ESC hält an",
        "Baking {}: {} of {} frames; ESC stops it": (
            "{} wird gebacken: {} von {} Bildern; ESC hält an"
        ),
        "Frames {} to {} of {} x {} samples: {} at most, in {}": (
            "Bilder {} bis {} mit {} x {} Stützstellen: höchstens {}, in {}"
        ),
        "Frames {} to {}: the sea stands still beyond them": (
            "Bilder {} bis {}: außerhalb steht die See still"
        ),
        "Not in the bake: {}": "Nicht mitgebacken: {}",
        "The bake is for another time remapping: bake again": (
            "Gebacken für eine andere Zeitneuzuordnung: neu backen"
        ),
        "The bake shows another sea than the parameters: bake again": (
            "Gebacken ist eine andere See als die der Parameter: neu backen"
        ),
        # Volumes.
        "Volumes": "Volumen",
        "Box": "Quader",
        "One period": "Eine Periode",
        "Object": "Objekt",
        "Corners": "Ecken",
        "Box object": "Quaderobjekt",
        "Lower corner": "Untere Ecke",
        "Upper corner": "Obere Ecke",
        "Voxel": "Voxel",
        "Velocity voxel": "Geschw.-Voxel",
        "Half precision": "Halbe Genauigkeit",
        "Import": "Importieren",
        "Command ocean": "Befehl ocean",
        "Frames {} to {}, in {}": "Bilder {} bis {}, in {}",
        # Float.
        "Length": "Länge",
        "Width": "Breite",
        "Tilt": "Neigung",
        "Ocean": "Ozean",
        # The asset library.
        "Seas and skies for the Asset Browser": "Seen und Himmel für den Asset-Browser",
        "Now: {}": "Jetzt: {}",
        "{} assets are in {}": "{} Assets sind in {}",
        "{} is no file of asset catalogues that is known": (
            "{} ist keine bekannte Datei von Asset-Katalogen"
        ),
        "{} was not made here, or has been changed: choose another folder": (
            "{} wurde nicht hier angelegt oder ist geändert: wählen Sie einen anderen Ordner"
        ),
        "Blender could not write the seas: {}": "Blender konnte die Seen nicht schreiben: {}",
        # Why something cannot be done.
        "None of the selected objects floats": "Keines der gewählten Objekte schwimmt",
        "None of the selected objects has baked floating": (
            "Keines der gewählten Objekte hat gebackenes Schwimmen"
        ),
        "No object is the box: choose one": "Kein Objekt ist der Quader: wählen Sie eines",
        "The box is empty: its upper corner must exceed its lower corner": (
            "Der Quader ist leer: jedes Ende liegt jenseits seines Anfangs"
        ),
        "This Blender has no OpenVDB module; 3.4 of Debian, 4.5 and later have it. The command "
        "ocean writes the volumes, where it is installed: {}": (
            "Dieses Blender hat kein Modul für OpenVDB; das 3.4 von Debian, 4.5 und spätere haben "
            "es. Der Befehl ocean schreibt die Volumen, wo er installiert ist: {}"
        ),
        "{}, of the preferences, is no command that writes volumes": (
            "{} aus den Einstellungen ist kein Befehl, der Volumen schreibt"
        ),
        "Blender shows the previous files until it is restarted": (
            "Bis zu seinem nächsten Start zeigt Blender die Dateien von vorher"
        ),
        "No ocean is selected": "Kein Ozean ist gewählt",
        "Select the objects that should float": "Wählen Sie die Objekte, die schwimmen sollen",
        "The active object has no bake": "Vom aktiven Objekt ist nichts gebacken",
        "The active object has no ocean modifier": "Das aktive Objekt hat keinen Ozean-Modifikator",
        "The active object has an ocean: add wave systems to it": (
            "Das aktive Objekt hat einen Ozean: fügen Sie ihm Wellensysteme hinzu"
        ),
        "The mesh already has the vertices that its maps need": (
            "Das Mesh hat schon die Punkte, die seine Karten verlangen"
        ),
        "The active object is no mesh with an ocean": ("Das aktive Objekt ist kein Mesh mit Ozean"),
        "The active object is no mesh, curve or text": (
            "Das aktive Objekt ist weder Mesh noch Kurve noch Text"
        ),
        "The object is linked: bake it in its own file": (
            "Das Objekt ist verknüpft: backen Sie es in seiner eigenen Datei"
        ),
        "Frames {} to {}": "Bilder {} bis {}",
        # Before a render.
        "files of the bake are missing, of the frames": "gebackene Dateien fehlen, der Bilder",
        "files of the bake cannot be read, of the frames": (
            "gebackene Dateien sind nicht lesbar, der Bilder"
        ),
        "files of the bake show another sea, of the frames": (
            "gebackene Dateien zeigen eine andere See, der Bilder"
        ),
        "{}: the sea stands still at frames {}: ": "{}: die See steht still in den Bildern {}: ",
        "{}: files of the bake do not say which sea they show: {}": (
            "{}: gebackene Dateien sagen nicht, welche See sie zeigen: {}"
        ),
        "The render is stopped": "Das Rendern ist angehalten",
        "The render stops before this frame: its camera was removed": (
            "Das Rendern ist vor diesem Bild angehalten: ihm ist die Kamera genommen"
        ),
        # Reports.
        "{} holds another sea, which would be written over at the frames {}: choose another "
        "folder, or delete the files": (
            "In {} ist eine andere See, deren Bilder {} überschrieben würden: wählen Sie einen "
            "anderen Ordner, oder löschen Sie die Dateien"
        ),
        "{} is a path of Windows: choose another folder": (
            "{} ist ein Pfad von Windows: wählen Sie einen anderen Ordner"
        ),
        "The files stay: those of {} show another sea": (
            "Die Dateien bleiben: die der Bilder {} zeigen eine andere See"
        ),
        "A measured spectrum needs a file: choose one below": (
            "Ein gemessenes Spektrum braucht eine Datei: wählen Sie unten eine"
        ),
        "{} could not be written completely: is the disk full?": (
            "{} konnte nicht zu Ende geschrieben werden: ist der Datenträger voll?"
        ),
        "{} files removed": "{} Dateien entfernt",
        "{} frames in {}: {} written, {} kept": (
            "{} Bilder in {}: {} geschrieben, {} waren schon da"
        ),
        "{} is gone; its files are in {}": "{} gibt es nicht mehr; die Dateien sind in {}",
        "A bake of {} is under way": "{} wird gerade gebacken",
        "A sea has at least one wave system": "Eine See hat mindestens ein Wellensystem",
        "After {} frames: {}": "Nach {} Bildern: {}",
        "Linked data keeps its material": "Verknüpfte Daten nehmen kein anderes Material an",
        "Not all files could be removed: {}": "Nicht alle Dateien konnten entfernt werden: {}",
        "Save the blend file first: the bake's folder is relative to it": (
            "Speichern Sie zuerst die Blend-Datei: der Ordner ist relativ zu ihr"
        ),
        "Stopped; {} of {} frames are finished": "Angehalten; {} von {} Bildern sind da",
        "The bake of {} is in {}: choose another folder": (
            "{} ist schon nach {} gebacken: wählen Sie einen anderen Ordner"
        ),
        "The file says {:g} frames a second; the scene's {:g} are used": (
            "Die Datei sagt {:g} Bilder je Sekunde; es gelten die {:g} der Szene"
        ),
        "The files stay: {} plays them too": "Die Dateien bleiben: {} spielt sie auch ab",
        "The folder {} cannot be made: {}": "Der Ordner {} kann nicht angelegt werden: {}",
        "The last frame, {}, comes before the first, {}": (
            "Das letzte Bild, {}, kommt vor dem ersten, {}"
        ),
        "The limits of the wavelength are animated: a bake with near detail has one of each": (
            "Die Grenzen der Wellenlänge sind animiert: mit Details der Nähe wird nur je ein Wert "
            "gebacken"
        ),
        "The size, the resolution, the cascades or the region are animated: a bake has one of "
        "each": (
            "Größe, Auflösung, Kaskaden oder Region sind animiert: gebacken wird nur je ein Wert"
        ),
        "There is not enough memory: choose fewer samples": (
            "Der Speicher reicht nicht: wählen Sie weniger Stützstellen"
        ),
        "To write EXR files takes the Python package OpenEXR, which this copy of the add-on does "
        "not have for Python {}: {}. The add-on's zip has it; the command ocean bake writes such "
        "files without it": (
            "EXR-Dateien zu schreiben braucht das Python-Paket OpenEXR, das dieser Kopie des "
            "Add-ons für Python {} fehlt: {}. Das Zip des Add-ons hat es; der Befehl ocean bake "
            "schreibt solche Dateien ohne es"
        ),
        "Which ocean? Make it the active object, or give its name": (
            "Welcher Ozean? Machen Sie ihn zum aktiven Objekt, oder nennen Sie seinen Namen"
        ),
    },
}

for _german in (terrain_german, coast_german):
    GERMAN[SEA].update(_german.TERMS)
    GERMAN["Operator"].update(_german.OPERATORS)
    GERMAN["*"].update(_german.TEXTS)


def _by_context(language: dict[str, dict[str, str]]) -> dict[tuple[str, str], str]:
    """As Blender takes it."""
    contexts = {**language, "*": {**language[SEA], **language["*"]}}
    return {
        (context, english): translated
        for context, texts in contexts.items()
        for english, translated in texts.items()
    }


TABLE = {"de_DE": _by_context(GERMAN)}


def register() -> None:
    bpy.app.translations.register(__package__, TABLE)


def unregister() -> None:
    bpy.app.translations.unregister(__package__)
