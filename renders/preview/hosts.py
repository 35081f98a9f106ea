#!/usr/bin/python3
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Hands the views of views.toml to the hosts, and puts their pictures side by side.

usage: hosts.py names SHEET               the views of a sheet, one on a line
       hosts.py sea VIEW                  its sea
       hosts.py folder VIEW               words for `ocean povray` after the sea, one on a line
       hosts.py preview VIEW              words for ocean-preview after the sea, one on a line
       hosts.py povray VIEW               what renders/preview/beside.pov includes as view.inc
       hosts.py size VIEW                 WIDTHxHEIGHT
       hosts.py screen IN.exr OUT.png     light as ocean-preview shows it
       hosts.py sheet OUT PICTURE...      three pictures a row, each 426 pixels wide
       hosts.py measure FOLDER            rows of the horizon, how alike the hosts are
"""

import math
import sys
import tomllib
from pathlib import Path

import models

HERE = Path(__file__).resolve().parent
HOSTS = ("preview", "povray", "blender")
PAIRS = (HOSTS[:2], HOSTS[::2], HOSTS[1:])


def tables(folder: Path = HERE) -> dict:
    return tomllib.loads((folder / "views.toml").read_text(encoding="utf-8"))


def names(sheet: str = "beside", folder: Path = HERE) -> list[str]:
    """Returns the names of the views of a sheet."""
    return tables(folder)[sheet]


def view_of(name: str, folder: Path = HERE) -> dict:
    """Returns a view, with what is default."""
    read = tables(folder)
    if name not in read:
        sys.exit(f"{folder / 'views.toml'}: there is no view '{name}'")
    return read["default"] | read[name]


def target(view: dict) -> tuple[float, float, float]:
    """A point that the camera looks at, z up."""
    if "look_at" in view:
        return tuple(view["look_at"])
    heading, pitch = (math.radians(view[name]) for name in ("heading", "pitch"))
    way = (
        math.cos(pitch) * math.cos(heading),
        math.cos(pitch) * math.sin(heading),
        math.sin(pitch),
    )
    return tuple(e + w for e, w in zip(view["eye"], way, strict=True))


def preview_words(view: dict) -> list[str]:
    def joined(values) -> str:
        return ",".join(f"{value:g}" for value in values)

    when = "frames" if "frames" in view else "frame"
    words = {when: view[when], "eye": joined(view["eye"])}
    if "look_at" in view:
        words["look-at"] = joined(view["look_at"])
    else:
        words |= {"heading": f"{view['heading']:g}", "pitch": f"{view['pitch']:g}"}
    words |= {"angle": f"{view['angle']:g}", "sun": joined(view["sun"]), "water": view["water"]}
    if "region" not in view:
        words |= {"map": view["map"], "foam-map": view["foam_map"]}
    words |= {"visibility": f"{view['visibility']:g}"}
    return [str(word) for name, value in words.items() for word in (f"--{name}", value)]


def povray_camera(view: dict) -> str:
    """Returns the declarations of camera and sun."""

    def vector(of) -> str:
        return f"<{of[0]:.9g}, {of[2]:.9g}, {of[1]:.9g}>"

    return (
        f"#declare View_Eye = {vector(view['eye'])};\n"
        f"#declare View_Target = {vector(target(view))};\n"
        f"#declare View_Angle = {view['angle']};\n"
        f"#declare View_Sun_Altitude = {view['sun'][0]};\n"
        f"#declare View_Sun_Bearing = {view['sun'][1]};\n"
    )


def povray_words(view: dict) -> str:
    floats = ""
    for name, x, y, heading in view["floats"]:
        model = models.MODELS[name]()
        sides = f"{model.length}, {model.width}"
        floats += (
            f"object {{ Ocean_Float({models.povray(model)}, {x}, {y}, {heading}, {sides}) }}\n"
        )
    coast = "#declare View_Coast = 1;\n" if "region" in view else ""
    return povray_camera(view) + (
        f'{coast}#declare View_Water = "{view["water"]}";\n'
        f"#declare Ocean_Visibility = {view['visibility']};\n"
        f"#macro View_Floats()\n{floats}#end\n"
    )


def folder_words(view: dict) -> list[str]:
    words = ["--frames", str(view["frame"])]
    if "region" in view:
        corners = ",".join(f"{value:g}" for value in view["region"])
        words += [f"--region={corners}", "--cell", f"{view['cell']:g}"]
    return words


# Pictures ---------------------------------------------------------------------


def read(path):
    """[row, column, rgb], as it stands in the file."""
    import OpenImageIO as oiio

    image = oiio.ImageBuf(str(path))
    if image.has_error:
        sys.exit(f"{path}: {image.geterror()}")
    return image.get_pixels(oiio.FLOAT)[..., :3]


def write(path, picture, quality: int = 90) -> None:
    import numpy
    import OpenImageIO as oiio

    height, width, _ = picture.shape
    spec = oiio.ImageSpec(width, height, 3, oiio.UINT8)
    spec.attribute("compression", f"jpeg:{quality}" if str(path).endswith(".jpg") else "zip")
    image = oiio.ImageBuf(spec)
    image.set_pixels(oiio.ROI(), numpy.ascontiguousarray(picture.clip(0.0, 1.0)))
    if not image.write(str(path)):
        sys.exit(f"{path}: {image.geterror()}")


def screen_colour(light):
    """shaders/preview/tone.glsl at exposure 1."""
    import numpy

    light = numpy.maximum(light, 0.0)
    above = numpy.maximum(light - 0.6, 0.0)
    rolled = numpy.minimum(light, 0.6) + 0.4 * above / (above + 0.4)
    bright = 1.055 * numpy.maximum(rolled, 1e-6) ** (1.0 / 2.4) - 0.055
    return numpy.where(rolled < 0.0031308, 12.92 * rolled, bright)


def resized(picture, width: int, height: int):
    import OpenImageIO as oiio

    image = oiio.ImageBuf(oiio.ImageSpec(picture.shape[1], picture.shape[0], 3, oiio.FLOAT))
    image.set_pixels(oiio.ROI(), picture)
    smaller = oiio.ImageBufAlgo.resize(image, roi=oiio.ROI(0, width, 0, height, 0, 1, 0, 3))
    return smaller.get_pixels(oiio.FLOAT)


def sheet(pictures: list, width: int = 426, height: int = 240, gap: int = 4):
    import numpy

    rows = len(pictures) // 3
    made = numpy.ones((rows * (height + gap) - gap, 3 * (width + gap) - gap, 3), numpy.float32)
    for i, picture in enumerate(pictures):
        y, x = (i // 3) * (height + gap), (i % 3) * (width + gap)
        made[y : y + height, x : x + width] = resized(picture, width, height)
    return made


# What the sheet is judged by ---------------------------------------------------
#
# - horizon: in the same row of all three, within 2 pixels
# - crests: at the same places: luminance of the water, blurred by 5 pixels, less what each row
#   smoothly falls from side to side, correlates
# - glint: its middle at the sun's bearing, and as bright
# - light: of the water's upper, middle and lower third, which is far, in between and near
# - near detail: deviation of the lower half from its means of 9 x 9 pixels, within 1.5 times
# - foam: share of bright pixels away from the glint, in each third, within 1.5 times from 1 % on
# - by eye: colour of crests, edges of foam, haze at the horizon, nothing that repeats


def luminance(picture):
    return picture @ [0.2126, 0.7152, 0.0722]


def horizon_row(view: dict, picture) -> float:
    """Of the strongest edge from row to row, between pixels; the median of the columns that have
    one, of all but the sun's glint, within 15 rows of where still water would end."""
    import numpy

    height, width, _ = picture.shape
    dip = math.degrees(math.sqrt(2 * view["eye"][2] / 6371e3))
    focal = 0.5 * width / math.tan(math.radians(view["angle"]) / 2)
    first = int(0.5 * height + focal * math.tan(math.radians(view["pitch"] + dip))) - 15
    edges = -numpy.diff(luminance(picture)[first : first + 30], axis=0)
    clear = edges.max(0) > min(0.1, 0.5 * float(numpy.median(edges.max(0))))  # in haze
    return float(numpy.median(edges.argmax(0)[clear])) + first + 1


def blurred(field, size: int = 5):
    """Means of size x size pixels."""
    import numpy

    for axis in (0, 1):
        sums = numpy.cumsum(numpy.moveaxis(field, axis, 0), axis=0)
        field = numpy.moveaxis((sums[size:] - sums[:-size]) / size, 0, axis)
    return field


def crests(picture, horizon: float):
    """What of the water's luminance is no smooth fall along its row."""
    import numpy

    field = blurred(luminance(picture)[int(horizon) + 8 :])
    across = numpy.linspace(-1.0, 1.0, field.shape[1])
    fall = numpy.polynomial.polynomial.polyfit(across, field.T, 6)
    return field - numpy.polynomial.polynomial.polyval(across, fall)


def glint(view: dict, picture, horizon: float) -> tuple[float, float]:
    """Bearing of the water's brightest columns, degrees, and how bright they are."""
    import numpy

    columns = blurred(luminance(picture)[int(horizon) + 2 :], 15).mean(0)
    weight = numpy.maximum(columns - 0.5 * (columns.max() + numpy.median(columns)), 0.0) + 1e-12
    width = picture.shape[1]
    x = (weight * numpy.arange(7.5, 7.5 + len(columns))).sum() / weight.sum() - 0.5 * width
    focal = 0.5 * width / math.tan(math.radians(view["angle"]) / 2)
    pitch = math.radians(view["pitch"])
    # Of the picture's middle row of water; the sides of a camera that looks down bear farther off.
    y = 0.5 * (horizon + picture.shape[0]) - 0.5 * picture.shape[0]
    ahead = focal * math.cos(pitch) + y * math.sin(pitch)
    return view["heading"] - math.degrees(math.atan2(x, ahead)), float(columns.max())


def fine_contrast(picture) -> float:
    """Of the lower half."""
    field = luminance(picture)[picture.shape[0] // 2 :]
    return float((field[5:-4, 5:-4] - blurred(field, 9)).std())


def foam_share(view: dict, third) -> float:
    """Of bright pixels in the half that is away from the sun's glitter."""
    half = third.shape[1] // 2
    left = math.sin(math.radians(view["sun"][1] - view["heading"])) > 0.0
    return float((luminance(third[:, half:] if left else third[:, :half]) > 0.6).mean())


def measure(folder: Path) -> None:
    """Prints the list above in numbers, of FOLDER/VIEW.HOST.png."""
    import numpy

    for name in names():
        view = view_of(name)
        pictures = {host: read(folder / f"{name}.{host}.png") for host in HOSTS}
        rows = {host: horizon_row(view, picture) for host, picture in pictures.items()}
        print(f"{name}: sun at {view['sun'][1]:g}, camera {view['heading']:g}")
        for host, picture in pictures.items():
            bearing, bright = glint(view, picture, rows[host])
            thirds = numpy.array_split(picture[int(rows[host]) + 2 :], 3)
            light = [" ".join(f"{c:.2f}" for c in third.mean((0, 1))) for third in thirds]
            where = f"horizon {rows[host]:g}, glint {bearing:6.1f} of {bright:.2f}"
            print(f"  {host:8} {where}, light", *light, sep="  ")
            foam = " ".join(f"{100 * foam_share(view, third):.1f} %" for third in thirds)
            print(f"{'':11}fine contrast {fine_contrast(picture):.4f}, foam {foam}")
        lowest = max(rows.values())
        fields = {host: crests(picture, lowest).ravel() for host, picture in pictures.items()}
        for first, second in PAIRS:
            alike = numpy.corrcoef(fields[first], fields[second])[0, 1]
            print(f"  {first} and {second}: {alike:.2f}")


def main() -> None:
    match sys.argv[1:]:
        case ["names", which]:
            print(*names(which), sep="\n")
        case ["sea", name]:
            print(view_of(name)["sea"])
        case ["size", name]:
            print("{}x{}".format(*view_of(name)["size"]))
        case ["folder", name]:
            print(*folder_words(view_of(name)), sep="\n")
        case ["preview", name]:
            print(*preview_words(view_of(name)), sep="\n")
        case ["povray", name]:
            print(povray_words(view_of(name)), end="")
        case ["screen", light, picture]:
            write(picture, screen_colour(read(light)))
        case ["sheet", out, *pictures] if pictures and len(pictures) % 3 == 0:
            write(out, sheet([read(picture) for picture in pictures]))
        case ["measure", folder]:
            measure(Path(folder))
        case _:
            sys.exit(__doc__.partition("usage: ")[2])


if __name__ == "__main__":
    main()
