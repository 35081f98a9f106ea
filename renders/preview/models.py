# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""What floats in the pictures, the same in every host: a weather buoy of 3 m, a workboat of 12 m.
Metres, x ahead, z up, the waterline at 0."""

import math
from dataclasses import dataclass

Point = tuple[float, float, float]


@dataclass
class Part:
    colour: tuple[float, float, float]  # linear
    points: list[Point]
    faces: list[tuple[int, ...]]
    smooth: bool = False


@dataclass
class Model:
    length: float
    width: float
    parts: list[Part]


def lathe(colour, profile, turns: int = 48) -> Part:
    """A profile of (radius, height) from bottom to top, around z."""
    points = [
        (r * math.cos(2 * math.pi * k / turns), r * math.sin(2 * math.pi * k / turns), z)
        for r, z in profile
        for k in range(turns)
    ]
    faces = [
        (row * turns + k, row * turns + n, (row + 1) * turns + n, (row + 1) * turns + k)
        for row in range(len(profile) - 1)
        for k in range(turns)
        for n in [(k + 1) % turns]
    ]
    top = (len(profile) - 1) * turns
    faces += [tuple(range(turns))[::-1], tuple(range(top, top + turns))]
    return Part(colour, points, faces)


def box(colour, low: Point, high: Point) -> Part:
    points = [
        (x, y, z) for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])
    ]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return Part(colour, points, faces)


def rod(colour, start: Point, end: Point, radius: float, turns: int = 10) -> Part:
    way = [e - s for s, e in zip(start, end, strict=True)]
    length = math.hypot(*way)
    w = [c / length for c in way]
    aside = (0.0, 0.0, 1.0) if abs(w[2]) < 0.9 else (1.0, 0.0, 0.0)

    def cross(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

    u = cross(aside, w)
    u = [c / math.hypot(*u) for c in u]
    v = cross(w, u)
    points = [
        tuple(p[i] + radius * (u[i] * math.cos(a) + v[i] * math.sin(a)) for i in range(3))
        for p in (start, end)
        for a in (2 * math.pi * k / turns for k in range(turns))
    ]
    faces = [(k, (k + 1) % turns, turns + (k + 1) % turns, turns + k) for k in range(turns)]
    faces += [tuple(range(turns))[::-1], tuple(range(turns, 2 * turns))]
    return Part(colour, points, faces)


YELLOW, RED, STEEL = (0.72, 0.38, 0.01), (0.25, 0.02, 0.015), (0.30, 0.31, 0.33)
WHITE, DARK, NAVY = (0.75, 0.75, 0.72), (0.012, 0.014, 0.02), (0.015, 0.04, 0.11)


def buoy() -> Model:
    """A discus buoy: hull, well, tripod with panels, mast with sensors."""
    parts = [
        lathe(RED, [(1.0, -0.55), (1.34, -0.5), (1.42, -0.4), (1.42, 0.12)]),
        lathe(YELLOW, [(1.5, 0.12), (1.5, 0.5), (1.45, 0.55), (0.55, 0.56), (0.55, 0.62)]),
        lathe(WHITE, [(0.42, 0.62), (0.42, 1.05)]),
        lathe(WHITE, [(0.42, 2.75), (0.42, 2.81)]),
        rod(STEEL, (0, 0, 2.8), (0, 0, 3.9), 0.03),
        rod(STEEL, (-0.35, 0, 3.55), (0.35, 0, 3.55), 0.02),
        rod(WHITE, (0.22, 0.15, 2.8), (0.22, 0.15, 3.15), 0.09),
    ]
    for turn in range(4):
        c, s = math.cos(math.radians(45 + 90 * turn)), math.sin(math.radians(45 + 90 * turn))
        parts.append(rod(STEEL, (1.15 * c, 1.15 * s, 0.55), (0.22 * c, 0.22 * s, 2.75), 0.035))
        for height, radius in ((1.35, 0.83), (2.1, 0.5)):
            first, second = (radius * c, radius * s, height), (-radius * s, radius * c, height)
            parts.append(rod(STEEL, first, second, 0.022))
    for x in (-0.35, 0.35):
        parts.append(rod(DARK, (x, 0, 3.45), (x, 0, 3.75), 0.06))
    for sign in (-1, 1):
        parts.append(box(DARK, (sign * 0.64 - 0.02, -0.31, 1.45), (sign * 0.64 + 0.02, 0.31, 1.95)))
        parts.append(box(DARK, (-0.31, sign * 0.64 - 0.02, 1.45), (0.31, sign * 0.64 + 0.02, 1.95)))
    return Model(3.0, 3.0, parts)


def _hull(colour, low, high, rows: int, stations: int = 40) -> Part:
    """Both sides between the lines of heights `low` and `high`, which are functions of x."""
    points, faces = [], []
    for side in (-1, 1):
        first = len(points)
        for i in range(stations + 1):
            x = -6.0 + 12.0 * i / stations
            for j in range(rows + 1):
                z = low(x) + (high(x) - low(x)) * j / rows
                points.append((x + _rake(x, z), side * _half_breadth(x, z), z))
        for i in range(stations):
            for j in range(rows):
                a = first + i * (rows + 1) + j
                quad = (a, a + rows + 1, a + rows + 2, a + 1)
                faces.append(quad if side < 0 else quad[::-1])
    # The transom.
    other = (stations + 1) * (rows + 1)
    faces += [(other + j, j, j + 1, other + j + 1) for j in range(rows)]
    return Part(colour, points, faces, smooth=True)


def _keel(x: float) -> float:
    return -1.05 + 0.85 * max(0.0, x / 6.0) ** 3 + 0.35 * max(0.0, -x / 6.0) ** 2


def _sheer(x: float) -> float:
    return 1.05 + 0.75 * max(0.0, (x + 1.0) / 7.0) ** 2


def _rake(x: float, z: float) -> float:
    """The stem leans ahead."""
    return 0.6 * max(0.0, x / 6.0) ** 4 * (z + 0.5)


def _half_breadth(x: float, z: float) -> float:
    u = (z - _keel(x)) / (_sheer(x) - _keel(x))
    ahead = max(0.0, x / 6.0)
    full = 1.9 * (1.0 - ahead ** (2.2 + 1.4 * u)) * (1.0 - 0.12 * max(0.0, -x / 6.0) ** 2)
    return full * (1.0 - (1.0 - u) ** (3.2 - 1.6 * ahead))


def _deck(colour, stations: int = 40) -> Part:
    points, faces = [], []
    for i in range(stations + 1):
        x = -6.0 + 12.0 * i / stations
        z = _sheer(x) - 0.12
        y = _half_breadth(x, z)
        points += [(x + _rake(x, z), -y, z), (x + _rake(x, z), y, z)]
    for i in range(stations):
        faces.append((2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1))
    return Part(colour, points, faces)


def boat() -> Model:
    """A workboat: round bilge, bow with sheer, wheelhouse ahead of the middle."""

    def line(_x: float) -> float:
        return 0.18

    return Model(
        12.0,
        3.8,
        [
            _hull(RED, _keel, line, 10),
            _hull(NAVY, line, _sheer, 8),
            _deck((0.25, 0.24, 0.22)),
            box(WHITE, (-0.4, -1.15, 0.95), (2.6, 1.15, 3.15)),
            box(DARK, (-0.1, -1.17, 2.2), (2.62, 1.17, 2.85)),
            box(WHITE, (-0.6, -1.3, 3.15), (2.9, 1.3, 3.25)),
            box(WHITE, (2.6, -0.8, 1.1), (3.6, 0.8, 1.9)),
            box(YELLOW, (-4.6, -0.7, 0.9), (-3.2, 0.7, 1.5)),
            rod(STEEL, (0.3, 0, 3.2), (0.1, 0, 5.6), 0.05),
            rod(STEEL, (0.2, -0.6, 4.6), (0.2, 0.6, 4.6), 0.03),
            rod(STEEL, (-5.4, -1.2, 0.9), (-5.2, -1.0, 3.6), 0.06),
            rod(STEEL, (-5.4, 1.2, 0.9), (-5.2, 1.0, 3.6), 0.06),
            rod(STEEL, (-5.2, -1.05, 3.55), (-5.2, 1.05, 3.55), 0.06),
        ],
    )


MODELS = {"buoy": buoy, "boat": boat}


def normals(part: Part) -> list[Point]:
    """Of its points: the faces' that meet there, by their areas."""
    sums = [[0.0, 0.0, 0.0] for _ in part.points]
    for face in part.faces:
        a, b, c = (part.points[i] for i in (face[0], face[1], face[-1]))
        u, v = ([q - p for p, q in zip(a, other, strict=True)] for other in (b, c))
        normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        for i in face:
            for axis in range(3):
                sums[i][axis] += normal[axis]
    return [tuple(c / max(math.hypot(*s), 1e-12) for c in s) for s in sums]


def povray(model: Model) -> str:
    """A union of meshes; y up, x and z as Ocean_Float wants them."""

    def vector(p) -> str:
        return f"<{p[0]:.4f},{p[2]:.4f},{p[1]:.4f}>"

    text = "union {\n"
    for part in model.parts:
        triangles = [(f[0], f[k], f[k + 1]) for f in part.faces for k in range(1, len(f) - 1)]
        text += f"mesh2 {{ vertex_vectors {{ {len(part.points)}, "
        text += ",".join(map(vector, part.points)) + " }\n"
        if part.smooth:
            text += f"normal_vectors {{ {len(part.points)}, "
            text += ",".join(map(vector, normals(part))) + " }\n"
        text += f"face_indices {{ {len(triangles)}, "
        text += ",".join(f"<{a},{b},{c}>" for a, b, c in triangles) + " }\n"
        colour = ",".join(f"{channel:g}" for channel in part.colour)
        text += f"texture {{ pigment {{ rgb <{colour}> }} finish {{ Painted }} }} }}\n"
    return text + "}\n"
