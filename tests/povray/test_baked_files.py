# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""POV-Ray renders the heights of a height_field and of mesh2 files.

The height is rendered as a grey value by an orthographic camera whose pixel centres are the grid's
vertices, in 16 bits: it must agree with the library's heights to the quantum of the picture and of
the file. Choppy meshes are probed with trace() at their vertices, seams with rays along them.
"""

import os
import re
import subprocess
import tomllib

import numpy
import pytest
from conftest import PERIOD, N, read_png
from conftest import povray as run_povray

LO, HI = -3.0, 3.0  # of the rendered grey values; the sea stays inside
WAVES = [  # as in make_povray_samples.cpp
    (1, 2, 1.2, 0.3),
    (3, -1, 0.8, 1.1),
    (-2, 5, 0.5, 2.2),
    (6, 4, 0.25, 4.0),
    (9, -7, 0.1, 5.0),
    (14, 3, 0.05, 0.7),
]


def sea(choppiness=0.0):
    """x, y, height of the displaced vertices, [j, i]."""
    i, j = numpy.meshgrid(numpy.arange(N), numpy.arange(N))
    x, y = i * PERIOD / N, j * PERIOD / N
    out = [x.copy(), y.copy(), numpy.zeros((N, N))]
    for n, m, amplitude, phase in WAVES:
        k = 2 * numpy.pi * numpy.array([n, m]) / PERIOD
        angle = k[0] * x + k[1] * y + phase
        offset = choppiness * amplitude * numpy.cos(angle) / numpy.hypot(*k)
        out[0] += offset * k[0]
        out[1] += offset * k[1]
        out[2] += amplitude * numpy.sin(angle)
    return out


def slopes():
    i, j = numpy.meshgrid(numpy.arange(N), numpy.arange(N))
    x, y = i * PERIOD / N, j * PERIOD / N
    out = [numpy.zeros((N, N)), numpy.zeros((N, N))]
    for n, m, amplitude, phase in WAVES:
        k = 2 * numpy.pi * numpy.array([n, m]) / PERIOD
        angle = k[0] * x + k[1] * y + phase
        for axis in (0, 1):
            out[axis] += amplitude * k[axis] * numpy.cos(angle)
    return out


@pytest.fixture(scope="session")
def folder(tmp_path_factory):
    path = tmp_path_factory.mktemp("povray")
    subprocess.run([os.environ["OCEAN_POVRAY_SAMPLES"], str(path)], check=True)
    return path


def povray(folder, scene, width=8, height=8):
    head = "#version 3.7;\nglobal_settings{assumed_gamma 1.0}\n"
    return run_povray(folder, head + scene, width=width, height=height)


def render(folder, declare, texture):
    """Seen from above, [j, i] as the grid: pixel centres are vertices."""
    cell = PERIOD / N
    centre = PERIOD / 2 - cell / 2
    povray(
        folder,
        f"""background{{rgb <1,0,1>}}
camera{{orthographic location <{centre},50,{centre}> direction -y right {PERIOD}*x up {PERIOD}*z}}
{declare}
object{{Sea {texture}}}
""",
        N,
        N,
    )
    pixels = read_png(folder / "out.png")
    assert numpy.all(pixels[1:, 1:, 0] == pixels[1:, 1:, 1]), "a ray missed the sea"
    return pixels[..., 0]


GREY = "finish{ambient 0 diffuse 0 emission 1}"
HEIGHT_TEXTURE = (
    f"texture{{pigment{{gradient y color_map{{[0 rgb 0][1 rgb 1]}} "
    f"scale {HI - LO} translate {LO}*y}} {GREY}}}"
)
QUANTUM = (HI - LO) / 65535


def height_field(folder):
    side = tomllib.loads((folder / "height.png.txt").read_text())
    return side, (
        f'#declare Sea = height_field {{ png "height.png" smooth '
        f"scale <{PERIOD}, {side['scale']}, {PERIOD}> translate {side['base']}*y }}"
    )


def test_height_field_shows_the_heights(folder):
    side, declare = height_field(folder)
    # A pixel of the far and of the right edge lies on the border of the sheet.
    error = render(folder, declare, HEIGHT_TEXTURE) * (HI - LO) + LO - sea()[2]
    assert numpy.abs(error[1:, 1:]).max() <= 0.5 * (QUANTUM + side["quantum"]) + 2e-6
    assert abs(error[1:, 1:].mean()) < 0.1 * (QUANTUM + side["quantum"])


def test_mesh2_shows_the_heights(folder):
    declare = '#include "flat.inc"\n#declare Sea = object { Ocean_Surface }'
    error = render(folder, declare, HEIGHT_TEXTURE) * (HI - LO) + LO - sea()[2]
    vertex_grid = 2.0**-16
    plane = 2.0**-18  # POV-Ray keeps a triangle's distance from the origin, up to 141 m, as a float
    assert numpy.abs(error[1:, 1:]).max() <= 0.5 * (QUANTUM + vertex_grid) + plane + 2e-6


@pytest.mark.parametrize("shape,bound", [("mesh", 0.01), ("height_field", 3.0)])
def test_smooth_normals(folder, shape, bound):
    """Degrees. `slope` gives the angle between the normal and an axis, in units of pi."""
    declare = (
        '#include "flat.inc"\n#declare Sea = object { Ocean_Surface }'
        if shape == "mesh"
        else height_field(folder)[1]
    )
    slope_x, slope_y = slopes()
    length = numpy.sqrt(slope_x**2 + slope_y**2 + 1)
    expected = {"x": -slope_x / length, "z": -slope_y / length}
    for axis, truth in expected.items():
        texture = f"texture{{pigment{{slope {axis} color_map{{[0 rgb 0][1 rgb 1]}}}} {GREY}}}"
        seen = -numpy.cos(numpy.pi * render(folder, declare, texture))
        angle = numpy.degrees(numpy.arccos(numpy.clip(seen, -1, 1)) - numpy.arccos(truth))
        assert numpy.abs(angle[2:-2, 2:-2]).max() < bound


def test_choppy_mesh_has_its_vertices_where_they_belong(folder):
    x, y, height = sea(1.0)
    pick = [(j, i) for j in range(1, N, 5) for i in range(1, N, 3)]
    probes = "".join(f"Probe({x[j, i]:.9f}, {y[j, i]:.9f})\n" for j, i in pick)
    povray(
        folder,
        f"""#include "choppy.inc"
#fopen Out "probes.txt" write
#macro Probe(X, Z)
    #local Normal = <0, 0, 0>;
    #local Hit = trace(Ocean_Surface, <X, 50, Z>, -y, Normal);
    #write(Out, str(Hit.y, 0, 9), " ", str(vlength(Normal), 0, 3), "\\n")
#end
{probes}
#fclose Out
#if (Ocean_Time != 3.5 | Ocean_Period != 100 | Ocean_Frame_Number != 4) #error "parameters" #end
sphere{{0, 1}}
""",
    )
    found = numpy.loadtxt(folder / "probes.txt")
    assert len(found) == len(pick)
    assert numpy.all(found[:, 1] > 0.9), "a ray missed the sea"
    truth = numpy.array([height[j, i] for j, i in pick])
    # Half a vertex grid in each direction, on slopes of up to 1.
    assert numpy.abs(found[:, 0] - truth).max() < 5e-5


@pytest.mark.parametrize("neighbour", ["x", "z"])
def test_tiles_meet_without_a_crack(folder, neighbour):
    """Rays within 2e-5 m of the seam between two copies; unsnapped vertices lose 1 in 60."""
    x, y, _ = sea(1.0)
    edge = numpy.stack(
        [x[:, 0] + PERIOD, y[:, 0]] if neighbour == "x" else [x[0, :], y[0, :] + PERIOD], axis=1
    )
    edge = numpy.round(edge * 65536) / 65536
    points = ",".join(f"<{a:.12f},0,{b:.12f}>" for a, b in edge)
    log = povray(
        folder,
        f"""#include "choppy.inc"
#declare Two = union {{ object {{ Ocean_Surface }}
                        object {{ Ocean_Surface translate Ocean_Period*{neighbour} }} }}
#declare Edge = array[{N}] {{ {points} }}
#declare Random = seed(3);
#declare Misses = 0;
#for (K, 0, {N - 2})
    #for (L, 1, 100)
        #local At = Edge[K] + (Edge[K + 1] - Edge[K])*rand(Random);
        #local Normal = <0, 0, 0>;
        #local Hit = trace(Two, At + {neighbour}*(rand(Random) - 0.5)*4e-5 + 50*y, -y, Normal);
        #if (vlength(Normal) = 0) #declare Misses = Misses + 1; #end
    #end
#end
#debug concat("MISSES ", str(Misses, 0, 0), "\\n")
sphere{{0, 1}}
""",
    )
    assert re.search(r"MISSES (\d+)", log).group(1) == "0"
