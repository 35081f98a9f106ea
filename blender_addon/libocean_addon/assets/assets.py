# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The content of the asset library: seas to the horizon and as patches, and skies, each with the
preview that the Asset Browser shows. A separate Blender without anything else writes them into one
file (write_assets.py).

A sea of the library has one face for a mesh and small images: it comes alive where it comes into a
scene (handlers.py). So the file is small, opens fast, and is the same for seas of any size.
"""

from __future__ import annotations

import dataclasses
from pathlib import Path

import bpy

from ..look import first_view, material
from ..look.water_shader import DEFAULT_TYPE
from ..sea import live, operators, parameter_values, sea_text
from ..shared import changes, meshes
from ..shared.native import libocean

AUTHOR = "The libocean authors"
LICENSE = "Apache-2.0"  # of the presets, which are the library's
THUMBNAILS = Path(__file__).parents[1] / "thumbnails"
THUMBNAIL_SIDE = 256

CATALOGS = {
    "ALL": ("93d46f0e-b3ae-4357-b614-65402a3f47d8", "Ocean"),
    "HORIZON": ("21d4bdf5-bffa-4507-b165-517637208938", "Ocean/Horizons"),
    "PATCH": ("cd1236eb-b0cc-480e-ab52-d12a81547ba8", "Ocean/Patches"),
    "SKY": ("553f8a6a-61e5-4c2f-bace-0a4a4ea8ec74", "Ocean/Skies"),
}
"""Identifier and path of the catalogue of each kind, and of the one around them. The identifiers
stay: files refer to them."""

WINDS = {
    1: "light air",
    2: "light breeze",
    3: "gentle breeze",
    4: "moderate breeze",
    5: "fresh breeze",
    6: "strong breeze",
    7: "near gale",
    8: "gale",
    10: "storm",
    12: "hurricane",
}
"""The seas to the horizon, by Beaufort's force."""
PATCHES = (2, 4, 6, 8)
SKIES = {"Noon": 60.0, "Morning": 30.0, "Low Sun": 8.0, "Sunset": 1.5}
"""Degrees of the sun above the horizon."""
SUN_AZIMUTH = 240.0  # as Add > Ocean Scene has it


@dataclasses.dataclass(frozen=True)
class Asset:
    """One of the library. kind: HORIZON, PATCH or SKY."""

    name: str
    kind: str
    description: str
    tags: tuple[str, ...]
    preset: str = ""  # of a sea
    elevation: float = 0.0  # of a sky's sun

    @property
    def thumbnail(self) -> Path:
        return THUMBNAILS / f"{self.name.lower().replace(' ', '_')}.jpg"


def _seas(kind: str, forces, what: str) -> list[Asset]:
    found = []
    for force in forces:
        preset = f"beaufort_{force}"
        with libocean.preset(preset) as sea:
            height = sea.state["significant_wave_height"]["resolved"]
        wind = WINDS[force]
        text = f"{wind.capitalize()}, waves of {height:.1f} m. {what}"
        tags = ("ocean", "sea", "water", "libocean", f"beaufort {force}", wind)
        found.append(Asset(f"Beaufort {force} {kind.capitalize()}", kind, text, tags, preset))
    return found


def table() -> list[Asset]:
    """Returns all assets, in the order of the Asset Browser."""
    horizons = _seas("HORIZON", WINDS, "The sea as far as the horizon, around the scene's camera")
    patches = _seas("PATCH", PATCHES, "One period of the sea; patches side by side are one sea")
    skies = [
        Asset(
            f"Ocean Sky {name}",
            "SKY",
            f"A clear sky, the sun {elevation:g} degrees high. Its disc is seen by Cycles; Eevee "
            "takes a sun lamp beside it",
            ("ocean", "sky", "sun", "libocean", name.lower()),
            elevation=elevation,
        )
        for name, elevation in SKIES.items()
    ]
    return [*horizons, *patches, *skies]


def _make_water(preset: str):
    made = material.make(DEFAULT_TYPE)
    with libocean.preset(preset) as sea:
        material.put(made, material.look_of(sea.state))
    return made


def _make_sea(asset: Asset, water):
    with libocean.preset(asset.preset) as sea:
        values = sea_text.read(sea)
        size = float(sea.get("patch_size"))
    ob = bpy.data.objects.new(asset.name, bpy.data.meshes.new(asset.name))
    with changes.quiet():  # nothing is shown here
        modifier = operators.add_modifier(ob, asset.kind)
        ob.libocean.kind = asset.kind
        parameter_values.assign(ob.libocean, values)
        material.assign(ob, water)
    meshes.fill_stand_in(ob.data, size)
    live.prepare(ob, modifier)
    return ob


def make_sky(asset: Asset):
    """A world whose sun lights by itself, in Cycles."""
    world = first_view.make_sky(asset.elevation, SUN_AZIMUTH)
    world.name = asset.name
    texture = next(node for node in world.node_tree.nodes if node.type == "TEX_SKY")
    texture.sun_disc = True
    return world


def _mark(block, asset: Asset) -> None:
    """As an asset, with all that the Asset Browser shows."""
    block.asset_mark()
    data = block.asset_data
    data.author, data.description = AUTHOR, asset.description
    data.catalog_id = CATALOGS[asset.kind][0]
    if hasattr(data, "license"):  # 3.5
        data.license, data.copyright = LICENSE, AUTHOR
    for tag in asset.tags:
        data.tags.new(tag, skip_if_exists=True)
    picture = bpy.data.images.load(str(asset.thumbnail))
    preview = block.preview_ensure()
    preview.image_size = picture.size
    preview.image_pixels_float = picture.pixels[:]
    bpy.data.images.remove(picture)


def write(path: Path) -> None:
    """Makes all assets in the open file, and writes a file with them."""
    assets, blocks = table(), set()
    water = {preset: _make_water(preset) for preset in {asset.preset for asset in assets} - {""}}
    for asset in assets:
        block = make_sky(asset) if asset.kind == "SKY" else _make_sea(asset, water[asset.preset])
        _mark(block, asset)
        blocks.add(block)
    bpy.data.libraries.write(str(path), blocks, fake_user=True, compress=True)
