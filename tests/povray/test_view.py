# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Copies of the sea side by side and to the horizon: seams, memory, far waves."""

import subprocess
from pathlib import Path

import numpy
import pytest
from conftest import PERIOD, Folder, N, floats_of, read_png, sea_text, surface

PEAK_MEMORY = Path(__file__).resolve().parents[1] / "peak_memory.py"


@pytest.mark.parametrize("neighbour", ["x", "z"])
def test_tiles_meet_without_a_crack(choppy, neighbour):
    """50 000 rays within 2e-5 m of the seam between two copies."""
    maps = surface(choppy)
    step = PERIOD / N
    along = numpy.arange(N) * step
    dx, dy = maps.displacement[..., 0], maps.displacement[..., 1]
    if neighbour == "x":
        edge = numpy.stack([PERIOD + dx[:, 0], along + dy[:, 0]], axis=1)
    else:
        edge = numpy.stack([along + dx[0], PERIOD + dy[0]], axis=1)
    points = ",".join(f"<{a:.12f},0,{b:.12f}>" for a, b in edge)
    log = choppy.run(
        f"""Ocean_Load("sea_0001")
#declare Tile = Ocean_Mesh()
#declare Two = Ocean_Tiles(Tile, {2 if neighbour == "x" else 1}, {2 if neighbour == "z" else 1})
#declare Edge = array[{N}] {{ {points} }}
#declare Random = seed(3);
#declare Misses = 0;
#for (K, 0, {N - 2})
    #for (L, 1, 400)
        #local At = Edge[K] + (Edge[K + 1] - Edge[K])*rand(Random);
        #local Normal = <0, 0, 0>;
        #local Hit = trace(Two, At + {neighbour}*(rand(Random) - 0.5)*4e-5 + 50*y, -y, Normal);
        #if (vlength(Normal) = 0) #declare Misses = Misses + 1; #end
    #end
#end
#debug concat("V ", str(Misses, 0, 0), "\\n")"""
    )
    assert floats_of(log) == [0.0]


def peak_memory(folder, scene):
    """MiB of a run of POV-Ray."""
    (folder.path / "test.pov").write_text('#version 3.7;\n#include "ocean.inc"\n' + scene)
    command = ["povray", "test.pov", "-O/dev/null", "+W8", "+H8", "-D", "-A"]
    done = subprocess.run(
        ["/usr/bin/python3", PEAK_MEMORY, *command],
        cwd=folder.path,
        capture_output=True,
        text=True,
        check=True,
    )
    return int(done.stdout) / 2**20


def test_ten_thousand_tiles_share_the_memory_of_one(tmp_path):
    folder = Folder(tmp_path, sea_text(resolution=256, period=200.0))
    scene = """global_settings {{ assumed_gamma 1.0 }}
Ocean_Load("sea_0001")
#declare Tile = Ocean_Mesh()
camera {{ location 9*y look_at z*100 }}
object {{ Ocean_Tiles(Tile, {0}, {0}) pigment {{ rgb 1 }} }}"""
    one, many = peak_memory(folder, scene.format(1)), peak_memory(folder, scene.format(100))
    print(f"\n1 tile {one:.0f} MiB, 10 000 tiles {many:.0f} MiB")
    assert many <= 1.5 * one


VIEW = """global_settings {{ assumed_gamma 1.0 max_trace_level 4 }}
Ocean_Load("sea_0001")
#declare Eye = <{eye}, 8, 0>;
camera {{ location Eye right x*image_width/image_height angle 50 look_at Eye + <1, -0.1, {turn}> }}
Ocean_Sun(24, 12)
Ocean_Sky(0.3)
object {{ Ocean_View(Eye, Eye + <1, -0.1, {turn}>, 50, 0.5) Ocean_Material("jerlov_ii")
         no_reflection }}"""


def test_the_far_sea_holds_still_when_the_camera_moves_a_tenth_of_a_pixel(tmp_path):
    folder = Folder(tmp_path, sea_text(resolution=256, period=200.0, wind=9.0))
    width, height = 320, 180
    pixel = 2 * numpy.tan(numpy.radians(25)) / width
    pictures = []
    for turn in (0.0, 0.1 * pixel):
        folder.run(
            VIEW.format(eye=0, turn=turn), "+A0.05", "+R3", "+AM2", width=width, height=height
        )
        pictures.append(read_png(folder.path / "out.png"))
    sea = pictures[0][: int(0.62 * height)]  # below the horizon
    far = slice(2 * len(sea) // 3, len(sea))
    difference = (pictures[1] - pictures[0])[far] * 255
    rms = numpy.sqrt(numpy.mean(difference**2))
    print(f"\nrms {rms:.2f}/255 in the far third")
    assert rms < 2.0
    assert numpy.std(pictures[0][far]) * 255 > 1.0, "there is nothing to be seen"


def test_the_far_sea_does_not_repeat(tmp_path):
    """Rays down on a ring twice five periods away: heights a period apart are not alike."""
    folder = Folder(tmp_path, sea_text(wind=10.0, period=150.0))
    log = folder.run(
        """Ocean_Load("sea_0001")
#declare Ocean_Repeats_ = 1;
#declare Sea = Ocean_View(<0, 60, 0>, <1, 60, 0>, 10, 1.5)
#for (K, 0, 399)
    #local P = <600 + 0.75*K, 900, 5*sin(K)>;
    #local Normal = <0, 0, 0>;
    #local Hit = trace(Sea, P, -y, Normal);
    #debug concat("V ", str(Hit.y + (P.x*P.x + P.z*P.z)/2/Ocean_Earth_Radius, 0, 6), "\\n")
#end"""
    )
    heights = floats_of(log)
    apart = 200  # 150 m
    repeats = numpy.corrcoef(heights[:-apart], heights[apart:])[0, 1]
    assert abs(repeats) < 0.5
    truth = surface(folder).height.std()
    assert 0.5 * truth < heights.std() < 1.5 * truth


def test_the_copies_of_the_far_sea_fade_into_each_other(choppy):
    """No step where one triangle of copies meets the next, and the variance of the sea."""
    log = choppy.run(
        f"""Ocean_Load("sea_0001")
Ocean_Load_Far_Maps_()
#for (K, 0, 9999)
    #local Way = 0.03*K;
    #debug concat("V ", str(Ocean_Seen_((500 + Way)/{PERIOD}, (90 + 0.7*Way)/{PERIOD}, 0, 0, 0, 1)
                            *Ocean_Metre_, 0, 6), "\n")
#end"""
    )
    heights = floats_of(log)
    truth = surface(choppy)
    steepest = numpy.abs(truth.slope).max()
    assert numpy.abs(numpy.diff(heights)).max() < 2 * steepest * 0.03 * 1.22
    assert heights.std() == pytest.approx(truth.height.std(), rel=0.25)
