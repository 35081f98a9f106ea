#!/usr/bin/python3
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Hands the views of views.toml to the hosts, and measures how alike their pictures are.

usage: lands.py names SHEET               the views of a sheet, one on a line
       lands.py land VIEW                 its land
       lands.py size VIEW                 WIDTHxHEIGHT
       lands.py preview VIEW              words for ocean-preview after the land, one on a line
       lands.py folder VIEW               words for `ocean povray` after the land, one on a line
       lands.py povray VIEW               what renders/terrain/beside.pov includes as view.inc
       lands.py flight FOLDER             a list of pictures for ocean-preview, FOLDER/0001.png ...
       lands.py measure FOLDER            how alike the hosts are, of FOLDER/VIEW.HOST.png
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parent / "preview"))
import hosts  # noqa: E402


def view_of(name: str) -> dict:
    return hosts.view_of(name, HERE)


def preview_words(view: dict) -> list[str]:
    words = {name: ",".join(f"{part:g}" for part in view[name]) for name in ("eye", "sun")}
    for name in ("heading", "pitch", "angle", "visibility", "snow_line"):
        words[name.replace("_", "-")] = f"{view[name]:g}"
    return [word for name, value in words.items() for word in (f"--{name}", value)]


def flight_lines(folder: str) -> list[str]:
    """Returns a line of `ocean-preview --pictures` for each frame of the flight."""
    flight = view_of("flight")
    lines = []
    for frame in range(flight["frames"]):
        share = frame / flight["frames"]
        eye = [a + share * (b - a) for a, b in zip(flight["from"], flight["to"], strict=True)]
        words = preview_words(flight | {"eye": eye})
        lines.append(" ".join([f"{folder}/{frame + 1:04d}.png", *words]))
    return lines


def povray_words(view: dict) -> str:
    return hosts.povray_camera(view) + (
        f"#declare View_Snow_Line = {view['snow_line']};\n"
        f"#declare Terrain_Tree_Line = {view['tree_line']};\n"
        f"#declare Terrain_Visibility = {view['visibility']};\n"
    )


# What the sheet is judged by ---------------------------------------------------
#
# - skyline: in the same row of each column, within 1 pixel in the median and 2 in nine of ten
# - ground: luminance of what lies below the skyline, blurred by 9 pixels, correlates by .85
# - light: of the ground's upper, middle and lower third, within 1.25 times
# - by eye: the same ridges, valleys and bays in the same places; snow, rock, forest, sand and
#   water where the others have them; haze that grows with the distance and takes the colour of the
#   sky above it; shadows on the side away from the sun; ground that is no blur at the eye and no
#   noise far away; no crack, no seam, nothing that repeats


def skyline(view: dict, picture):
    """Returns the row of the highest edge from row to row, by column."""
    import numpy

    found = numpy.abs(numpy.diff(picture, axis=0)).max(2) > view["edge"]
    return numpy.where(found.any(0), found.argmax(0), len(picture))


def measure(folder: Path) -> None:
    """Prints the list above in numbers."""
    import numpy

    for name in hosts.names(folder=HERE):
        view = view_of(name)
        pictures = {host: hosts.read(folder / f"{name}.{host}.png") for host in hosts.HOSTS}
        lines = {host: skyline(view, picture) for host, picture in pictures.items()}
        lowest = max(int(numpy.percentile(line, 90.0)) for line in lines.values()) + 1
        print(f"{name}:")
        for host, picture in pictures.items():
            thirds = numpy.array_split(picture[lowest:], 3)
            light = ["/".join(f"{c:.2f}" for c in third.mean((0, 1))) for third in thirds]
            print(f"  {host:8} skyline {numpy.median(lines[host]):g}, light", *light)
        blurred = {h: hosts.blurred(hosts.luminance(p)[lowest:], 9) for h, p in pictures.items()}
        for first, second in hosts.PAIRS:
            apart = numpy.abs(lines[first] - lines[second])
            alike = numpy.corrcoef(blurred[first].ravel(), blurred[second].ravel())[0, 1]
            print(
                f"  {first} and {second}: skyline {numpy.median(apart):g}, nine of ten "
                f"{numpy.percentile(apart, 90.0):g} pixels; ground {alike:.2f}"
            )


def main() -> None:
    match sys.argv[1:]:
        case ["names", which]:
            print(*hosts.names(which, HERE), sep="\n")
        case ["land", name]:
            print(view_of(name)["land"])
        case ["size", name]:
            print("{}x{}".format(*view_of(name)["size"]))
        case ["preview", name]:
            print(*preview_words(view_of(name)), sep="\n")
        case ["folder", name]:
            print(*view_of(name)["folder"], sep="\n")
        case ["povray", name]:
            print(povray_words(view_of(name)), end="")
        case ["flight", folder]:
            print(*flight_lines(folder), sep="\n")
        case ["measure", folder]:
            measure(Path(folder))
        case _:
            sys.exit(__doc__.partition("usage: ")[2])


if __name__ == "__main__":
    main()
