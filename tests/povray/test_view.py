# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Copies of the sea side by side and to the horizon: seams, memory, far waves."""

import re
import subprocess
from pathlib import Path

import numpy
import pytest
from conftest import PERIOD, Folder, N, sea_text, surface

PEAK_MEMORY = Path(__file__).resolve().parents[1] / "peak_memory.py"


@pytest.mark.parametrize("form", ["df3", "mesh2"])
@pytest.mark.parametrize("neighbour", ["x", "z"])
def test_tiles_meet_without_a_crack(tmp_path, form, neighbour):
    """12 700 rays within 2e-5 m of the seam between two copies; unsnapped vertices lose 1 in 60."""
    folder = Folder(tmp_path, sea_text(), "--format", form)
    maps = surface(folder)
    step = PERIOD / N
    along = numpy.arange(N) * step
    dx, dy = maps.displacement[..., 0], maps.displacement[..., 1]
    if neighbour == "x":
        edge = numpy.stack([PERIOD + dx[:, 0], along + dy[:, 0]], axis=1)
    else:
        edge = numpy.stack([along + dx[0], PERIOD + dy[0]], axis=1)
    points = ",".join(f"<{a:.12f},0,{b:.12f}>" for a, b in edge)
    told = folder.told(
        f"""#declare Tile = Ocean_Mesh()
#declare Two = Ocean_Tiles(Tile, {2 if neighbour == "x" else 1}, {2 if neighbour == "z" else 1})
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
Tell(Misses)"""
    )
    assert told == [0.0]


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


EARTH = 6371000.0


class Camera:
    """POV-Ray's perspective camera: `angle` across, its `sky` turned by `roll` about the sight."""

    def __init__(self, eye, pitch, heading, roll, angle, aspect):
        self.eye, self.roll, self.angle, self.aspect = numpy.array(eye), roll, angle, aspect
        level, turn = numpy.radians(pitch), numpy.radians(heading)
        self.forward = numpy.array(
            [
                numpy.cos(level) * numpy.cos(turn),
                numpy.sin(level),
                numpy.cos(level) * numpy.sin(turn),
            ]
        )

    def declared(self):
        at = self.eye + 100 * self.forward
        return (
            "#declare Eye = <{:.9f}, {:.9f}, {:.9f}>;".format(*self.eye)
            + " #declare Target = <{:.9f}, {:.9f}, {:.9f}>;".format(*at)
            + f" #declare View_Angle = {self.angle}; #declare Ocean_View_Roll = {self.roll};"
            + f" #declare Ocean_View_Aspect = {self.aspect:.9f};"
        )

    def rays(self, columns, rows):
        """Directions to the centres of a picture's pixels, from which its corners are not far."""
        right = numpy.cross([0.0, 1.0, 0.0], self.forward)
        if numpy.linalg.norm(right) < 1e-9:
            right = numpy.array([1.0, 0.0, 0.0])
        right /= numpy.linalg.norm(right)
        up = numpy.cross(self.forward, right)
        turn = numpy.radians(self.roll)  # about the sight, as vaxis_rotate turns: left-handed
        right, up = (
            right * numpy.cos(turn) + up * numpy.sin(turn),
            up * numpy.cos(turn) - right * numpy.sin(turn),
        )
        across = numpy.tan(numpy.radians(self.angle / 2))
        u, v = numpy.meshgrid(
            numpy.linspace(-0.999, 0.999, columns), numpy.linspace(-0.999, 0.999, rows)
        )
        rays = (
            self.forward
            + (u * across)[..., None] * right
            + (v * across / self.aspect)[..., None] * up
        ).reshape(-1, 3)
        return rays / numpy.linalg.norm(rays, axis=1)[:, None]

    def meets_water(self, rays, deepest):
        """Returns true for rays from above the sea that sink below all troughs on a round Earth."""
        fall = -rays[:, 1] / numpy.hypot(rays[:, 0], rays[:, 2])
        return fall > numpy.sqrt(2 * (self.eye[1] + deepest) / EARTH)


def cameras_of_all_attitudes(maps, period, count):
    """From 0.2 m over the highest crest to 3 km, from straight down to 20 degrees up: of 84, each
    height with each pitch."""
    random = numpy.random.default_rng(11)
    j, i = numpy.unravel_index(numpy.argmax(maps.height), maps.height.shape)
    cell = period / len(maps.height)
    x, z = numpy.array([i, j]) * cell + maps.displacement[j, i, :2]
    crest = float(maps.height[j, i])
    heights = [0.2, 0.2, 1.0, 5.0, 30.0, 300.0, 3000.0]
    pitches = [-90.0, -89.7, -70.0, -45.0, -34.0, -30.0, -26.0, -15.0, -5.0, 0.0, 8.0, 20.0]
    cameras = []
    for n in range(count):
        pitch = pitches[n % len(pitches)]
        roll = 0.0 if pitch == -90.0 else random.choice([0.0, 0.0, 25.0, -60.0, 90.0, 180.0])
        cameras.append(
            Camera(
                (x, crest + heights[n % len(heights)], z),
                pitch,
                0.0 if pitch == -90.0 else random.uniform(-180.0, 180.0),
                roll,
                random.choice([30.0, 60.0, 90.0, 120.0]),
                random.choice([1.0, 16 / 9, 2.39]),
            )
        )
    return cameras


@pytest.mark.parametrize(
    "count,detail", [(84, 0.05), pytest.param(14, 0.6, marks=pytest.mark.slow)]
)
def test_no_ray_that_must_meet_water_misses_it(tmp_path, count, detail):
    sea = sea_text(resolution=64, period=200.0, wind=13.0, choppiness=1.0)
    folder = Folder(tmp_path, sea)
    maps = surface(folder, 64)
    deepest = 1.5 * float(numpy.abs(maps.height).max())
    cameras = cameras_of_all_attitudes(maps, 200.0, count)
    scene, asked = "", 0
    for camera in cameras:
        rays = camera.rays(11, 9)
        rays = rays[camera.meets_water(rays, deepest)]
        asked += len(rays)
        if len(rays) == 0:
            rays = numpy.array([[0.0, 1.0, 0.0]])  # but the view must be made
        listed = ",".join("<{:.9f},{:.9f},{:.9f}>".format(*ray) for ray in rays)
        scene += f"""{camera.declared()}
#declare Rays = array[{len(rays)}] {{ {listed} }}
#declare Sea = Ocean_View(Eye, Target, View_Angle, {detail})
#declare Missed = 0;
#for (K, 0, {len(rays) - 1})
    #local Normal = <0, 0, 0>;
    #local Hit = trace(Sea, Eye, Rays[K], Normal);
    #if (vlength(Normal) = 0) #declare Missed = Missed + (Rays[K].y < 0); #end
#end
Tell(Missed) Tell(Ocean_View_Vertices)
"""
    missed, vertices = folder.told(scene, width=480).reshape(count, 2).T
    bad = {
        number: (int(missed[number]), vars(cameras[number])) for number in numpy.nonzero(missed)[0]
    }
    print(f"\n{asked} rays of {count} cameras, {int(missed.sum())} missed")
    assert asked > 40 * count
    assert not bad, bad
    assert vertices.max() <= 500000 * detail**2 + 5000, "more than the macro says"


@pytest.mark.parametrize("pitch,roll", [(-90, 0), (-30, 0), (-34, 40), (0, 90), (-8, -25)])
def test_pictures_have_no_bare_part(tmp_path, pitch, roll):
    """As above, by POV-Ray's own camera: its roll and its aspect are those that are declared."""
    folder = Folder(tmp_path, sea_text(resolution=64, period=200.0, wind=13.0, choppiness=1.0))
    maps = surface(folder, 64)
    camera = Camera((40.0, 9.0, 30.0), pitch, 0.0 if pitch == -90 else 70.0, roll, 70.0, 16 / 9)
    width, height = 96, 54
    picture = folder.seen(
        f"""{camera.declared()}
camera {{ location Eye right x*image_width/image_height angle View_Angle
         {"" if pitch == -90 else "sky vaxis_rotate(y, Target - Eye, Ocean_View_Roll)"}
         look_at Target }}
background {{ rgb 1 }}
object {{ Ocean_View(Eye, Target, View_Angle, 0.1) pigment {{ rgb 0 }} }}""",
        width=width,
        height=height,
    )
    bare = (picture[..., 0] > 0.5).ravel()
    rays = camera.rays(width, height)
    must = camera.meets_water(rays, 1.5 * float(numpy.abs(maps.height).max()))
    if pitch == -90:
        must[:] = True
    # At the horizon a pixel is not its middle.
    pixel = 2 * numpy.tan(numpy.radians(35)) / width
    clear = must & (-rays[:, 1] > 2 * pixel)
    assert clear.sum() > 0.3 * width * height
    assert not numpy.any(bare & clear)
    if pitch == 0:
        assert bare.mean() > 0.3, "there is no sky to tell the sea from"


def test_an_eye_under_water_is_told_so(choppy):
    log = choppy.error(choppy.load + "object { Ocean_View(<9, -3, 9>, <19, -3, 9>, 50, 0.2) }")
    assert re.search(r"the eye is [23]\.\d\d m below the surface", log)
    assert "Ocean_Volume(Centre, Radius, Depth, Detail)" in log


@pytest.mark.parametrize(
    "form,value",
    [
        ("Ocean_View(<9, 8, 9>, <19, 8, 9>, 0, 1)", "Angle is 0"),
        ("Ocean_View(<9, 8, 9>, <19, 8, 9>, -60, 1)", "Angle is -60"),
        ("Ocean_View(<9, 8, 9>, <19, 8, 9>, 60, 0)", "Detail is 0"),
        ("Ocean_Volume(<0, 0, 0>, 0, 5, 1)", "Radius is 0"),
        ("Ocean_Volume(<0, 0, 0>, 50, 5, -1)", "Detail is -1"),
        ("Ocean_Block(-3)", "Depth is -3"),
        ("Ocean_Tiles(sphere { 0, 1 }, 0, 4)", "Columns is 0"),
    ],
)
def test_a_wrong_number_is_refused_with_what_is_allowed(choppy, form, value):
    log = choppy.error(f"{choppy.load}object {{ {form} }}")
    allowed = rf"ocean.inc: Ocean_\w+.*: {value}\S*; allowed: [\d.]+ \.\. \d+"
    assert re.search(allowed, log), log[-500:]


VIEW = """#declare Eye = <{eye}, 8, 0>;
camera {{ location Eye right x*image_width/image_height angle 50 look_at Eye + <1, -0.1, {turn}> }}
Ocean_Sun(24, 12)
Ocean_Sky(0.3)
object {{ Ocean_View(Eye, Eye + <1, -0.1, {turn}>, 50, 0.5) Ocean_Material("jerlov_ii")
         no_reflection }}"""


def test_the_far_sea_holds_still_when_the_camera_moves_a_tenth_of_a_pixel(tmp_path):
    folder = Folder(tmp_path, sea_text(resolution=256, period=200.0, wind=9.0))
    width, height = 320, 180
    pixel = 2 * numpy.tan(numpy.radians(25)) / width
    # The far third of what lies below the horizon, and of it the middle eighth: nothing else is
    # rendered. Rows count from the bottom here, POV-Ray's from 1 at the top.
    sea = int(0.62 * height)
    far, middle = slice(2 * sea // 3, sea), slice(7 * width // 16, 9 * width // 16)
    part = [f"+SR{height - far.stop + 1}", f"+ER{height - far.start}"]
    part += [f"+SC{middle.start + 1}", f"+EC{middle.stop}"]
    pictures = []
    for turn in (0.0, 0.1 * pixel):
        picture = folder.seen(
            VIEW.format(eye=0, turn=turn),
            *("+A0.05", "+R3", "+AM2", *part),
            settings="max_trace_level 4", width=width, height=height,
        )  # fmt: skip
        pictures.append(picture[far, middle])
    assert pictures[0].min() > 0, "a pixel was not rendered"
    rms = numpy.sqrt(numpy.mean(((pictures[1] - pictures[0]) * 255) ** 2))
    print(f"\nrms {rms:.2f}/255 in the far third")
    assert rms < 2.0
    assert numpy.std(pictures[0]) * 255 > 1.0, "there is nothing to be seen"


def test_the_far_sea_does_not_repeat(tmp_path):
    """Rays down on a ring twice five periods away: heights a period apart are not alike. The view
    is narrow and high: the rays lie within half a degree of its middle."""
    folder = Folder(tmp_path, sea_text(wind=10.0, period=150.0))
    heights = folder.told(
        """#declare Ocean_Repeats_ = 1;
#declare Ocean_View_Aspect = 0.17;
#declare Sea = Ocean_View(<0, 60, 0>, <1, 60, 0>, 4, 1.5)
#for (K, 0, 399)
    #local P = <600 + 0.75*K, 900, 5*sin(K)>;
    #local Normal = <0, 0, 0>;
    #local Hit = trace(Sea, P, -y, Normal);
    Tell(Hit.y + (P.x*P.x + P.z*P.z)/2/Ocean_Earth_Radius)
#end""",
        width=960,
        height=540,
    )
    apart = 200  # 150 m
    repeats = numpy.corrcoef(heights[:-apart], heights[apart:])[0, 1]
    assert abs(repeats) < 0.5
    truth = surface(folder).height.std()
    assert 0.5 * truth < heights.std() < 1.5 * truth


def test_the_copies_of_the_far_sea_fade_into_each_other(choppy):
    """No step where one triangle of copies meets the next, and the variance of the sea."""
    heights = choppy.told(
        f"""Ocean_Load_Far_Maps_()
Ocean_Declare_Level_(0)
#for (K, 0, 9999)
    #local Way = 0.03*K;
    Tell(Ocean_Seen_((500 + Way)/{PERIOD}, (90 + 0.7*Way)/{PERIOD}, 0, 0, 1)*Ocean_Metre_)
#end"""
    )
    truth = surface(choppy)
    steepest = numpy.abs(truth.slope).max()
    assert numpy.abs(numpy.diff(heights)).max() < 2 * steepest * 0.03 * 1.22
    assert heights.std() == pytest.approx(truth.height.std(), rel=0.25)
