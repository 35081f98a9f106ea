# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The program `ocean-preview` as its users see it: pictures, probes, a window that a hand uses."""

import contextlib
import csv
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time
import tomllib
from pathlib import Path

import numpy
import OpenImageIO as oiio
import pytest
from conftest import KEPT, OCEAN, cpu_seconds, words_of

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "renders" / "preview"))
import hosts  # noqa: E402

PREVIEW = os.environ.get("OCEAN_PREVIEW", "")
if not PREVIEW:
    pytest.skip("ocean-preview was not built", allow_module_level=True)
SEA = """libocean = 1
[grid]
resolution = 128
patch_size = 200.0
[random]
seed = 4
[[waves]]
spectrum = "jonswap"
wind_speed = 9.0
wind_direction = 30.0
"""


# Of what a test looks at no more is seen in a fine picture.
COARSE = ("--samples", "1", "--foam-map", "128", "--cells", "32", "--no-detail")


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "sea.toml").write_text(SEA)
    return tmp_path


def run(folder, *arguments, **environment) -> subprocess.CompletedProcess:
    return subprocess.run(
        [PREVIEW, *words_of(arguments)],
        cwd=folder,
        env=KEPT | environment,
        capture_output=True,
        text=True,
        timeout=600,  # a program that hangs; not one on a busy machine
    )


def good(folder, *arguments, **environment) -> str:
    done = run(folder, *arguments, **environment)
    assert done.returncode == 0, done.stderr
    return done.stdout


def pictures(folder: Path, lines: dict[str, str], *arguments) -> dict[str, numpy.ndarray]:
    """All from one start of the program: a name with its ending, and the options of its own."""
    (folder / "list.txt").write_text("".join(f"{name} {own}\n" for name, own in lines.items()))
    told = good(folder, *arguments, "--pictures", "list.txt")
    assert told.splitlines() == list(lines)
    return {name: pixels(folder / name) for name in lines}


def pixels(path: Path) -> numpy.ndarray:
    return oiio.ImageBuf(str(path)).get_pixels(oiio.FLOAT)


def rms(a: numpy.ndarray, b: numpy.ndarray) -> float:
    return float(numpy.sqrt(numpy.mean((a - b) ** 2)))


def test_a_picture_has_sky_horizon_and_water(folder):
    assert good(folder, "sea.toml --offscreen a.png --size 320x180") == "a.png\n"
    picture = pixels(folder / "a.png")
    assert picture.shape == (180, 320, 3)
    # -4 degrees of 60 across 320 pixels: the horizon lies 19 above the middle.
    sky, water = picture[:65], picture[80:]
    assert sky[..., 2].mean() > sky[..., 0].mean() and sky.std() < 0.1
    assert water.mean() < 0.7 * sky.mean()
    # The row of the edge itself is a mean of both. Straight; whitecaps below have stronger ones.
    edges = numpy.abs(picture[2:].mean(2) - picture[:-2].mean(2))
    rows = edges[62:78].argmax(0) + 63
    assert (numpy.abs(rows - 70) <= 1).mean() > 0.95


def test_the_pattern_of_foam_is_kept_for_the_next_run(folder):
    cache = folder / "cache"
    kept = cache / "libocean" / "foam_pattern"

    def picture(name: str) -> numpy.ndarray:
        size = ("--size", "160x90", *COARSE)
        good(folder, "sea.toml --offscreen", name, *size, XDG_CACHE_HOME=str(cache))
        return pixels(folder / name)

    made = picture("a.png")
    whole = kept.read_bytes()
    assert (picture("b.png") == made).all() and kept.read_bytes() == whole
    # A file that was cut or changed is made anew.
    half = len(whole) // 2
    for damaged in (whole[:half], whole[:half] + bytes([whole[half] ^ 1]) + whole[half + 1 :]):
        kept.write_bytes(damaged)
        assert (picture("c.png") == made).all() and kept.read_bytes() == whole
    shutil.rmtree(cache)
    cache.write_text("no folder")
    assert (picture("d.png") == made).all()


def test_the_probe_is_the_query(folder):
    places = [(3.0, 4.0), (-20.5, 11.0), (60.0, -70.0)]
    (folder / "p.csv").write_text("x,y\n" + "".join(f"{x},{y}\n" for x, y in places))
    asked = subprocess.run(
        [OCEAN, "query", "sea.toml", "--points", "p.csv", "--time", "12", "--no-foam"],
        cwd=folder,
        capture_output=True,
        text=True,
        check=True,
    ).stdout.splitlines()[1:]
    words = [word for x, y in places for word in ("--probe", f"{x},{y}")]
    # Maps four times as fine as the sea's grid: what is left is the mesh.
    probed = good(folder, "sea.toml --time 12 --map 512", *words).splitlines()
    for query, probe in zip(asked, probed, strict=True):
        x, y, expected = map(float, query.split(",")[:3])
        px, py, mesh, maps, shown, handed_on, foam = map(float, probe.split(","))
        assert (px, py) == (x, y)
        assert maps == pytest.approx(expected, abs=0.05)
        assert mesh == pytest.approx(maps, abs=0.1)
        assert shown >= 0.0 and handed_on > 0.0 and 0.0 <= foam <= 1.0
    flat = good(folder, "preset:beaufort_0 --probe 1,2").split(",")
    assert list(map(float, flat)) == pytest.approx([1, 2, 0, 0, 0, 0, 0], abs=1e-9)


def test_pictures_of_a_list_are_those_of_single_runs(folder):
    (folder / "list.txt").write_text(
        "# views of one moment, and another one\n"
        '"a b.png" --look-at 10,5,0 # what follows is not read\n'
        "\n"
        "h.png --view=height --wireframe\r\n"
        "later.exr --time 7 --exposure 2 --sun 12,-30\n"
    )
    coarse = ("--foam-map", 128, "--cells", 32)
    asked = ("sea.toml", "--size", "48x27", *coarse, "--frame", 3, "--heading", 20)
    written = ["a b.png", "h.png", "later.exr"]
    told = run(folder, *asked, "--pictures", "list.txt", "--probe", "1,2")
    assert told.returncode == 0 and told.stdout.splitlines()[1:] == written
    listed = [(folder / name).read_bytes() for name in written[::2]]
    straight = "sea.toml --size 48x27 --frame 3 --look-at 10,5,0 --probe 1,2 --offscreen"
    alone = good(folder, straight, "a b.png", *coarse)
    assert alone.splitlines() == told.stdout.splitlines()[:2]
    later = "--heading 20 --time 7 --exposure 2 --sun 12,-30 --offscreen later.exr"
    good(folder, f"sea.toml --size 48x27 {later}", *coarse)
    assert [(folder / name).read_bytes() for name in written[::2]] == listed


@pytest.mark.parametrize("backend", ["cpu", "gl"])
def test_a_frame_has_a_budget(folder, backend):
    told = good(folder, "sea.toml --budget 5 --size 64x36 --foam-map 128 --backend", backend)
    head, *rows = told.splitlines()
    assert head == "stage,median,worst"
    times = {stage: (float(m), float(w)) for stage, m, w in (row.split(",") for row in rows)}
    stages = {"cascades", "foam", "cover", "detail", "state", "sky", "water", "frame"}
    assert set(times) == stages
    assert all(0.0 < median <= worst for median, worst in times.values())
    worst = sum(w for stage, (_, w) in times.items() if stage != "frame")
    assert max(m for m, _ in times.values()) == times["frame"][0] <= times["frame"][1] <= worst


@pytest.mark.parametrize("stage", ["h0", "spectrum"])
def test_spectra_are_shown_as_they_are(folder, stage):
    subprocess.run([OCEAN, "bake", "sea.toml", "-q", "-o", "s.exr", "--stage", stage],
                   cwd=folder, check=True, capture_output=True)  # fmt: skip
    numbers = pixels(next(folder.glob("*.exr")))
    good(folder, "sea.toml --frame 1 --offscreen s.png --view", stage)
    picture = pixels(folder / "s.png")
    assert picture.shape == (720, 1280, 3)
    # The left half has the whole: each wave as a square of four pixels. The right half has its
    # middle, which a frame marks in the whole.
    shown = picture[104:616, 124:636][2::4, 2::4]
    assert shown.shape == (128, 128, 3)
    frame = (picture[104:616, 124:636] == 1.0).all(2)
    rows, columns = frame.any(1).nonzero()[0], frame.any(0).nonzero()[0]
    half = (rows[-1] - rows[0] - 1) // 8
    middle = slice(64 - half, 64 + half + 1)
    times = 636 // (2 * half + 1)
    low = (720 - (2 * half + 1) * times) // 2
    assert columns[0] + rows[-1] == 511 or half == 63
    right = picture[low:, 644:][times // 2 :: times, times // 2 :: times]
    wide = slice(0, 2 * half + 1)
    # k = 0 stands at 64 from the left and from the bottom.
    from_top = slice(128 - middle.stop, 128 - middle.start)
    assert (right[wide, wide] == shown[from_top, middle]).all()
    energy = (numbers[..., :2] ** 2).sum(2)
    inside = energy[from_top, middle].sum() / energy.sum()
    assert inside >= 0.95 or half == 63
    assert half == 8 or energy[from_top, middle][1:-1, 1:-1].sum() < 0.95 * energy.sum()
    amplitude = numpy.hypot(numbers[..., 0], numbers[..., 1])
    expected = 1 + numpy.log10(numpy.maximum(amplitude, 1e-30) / amplitude.max()) / 4
    assert abs(shown.max(2) - expected.clip(0, 1)).max() < 1.5 / 255


def test_a_far_wireframe_fades_before_it_fills_the_picture(folder):
    asked = ("--view", "height", "--samples", 1, "--frame", 1)
    shown = pictures(folder, {"lines.png": "--wireframe", "solid.png": ""}, "sea.toml", *asked)
    lines, solid = shown["lines.png"], shown["solid.png"]
    # The horizon lies 77 pixels above the middle. A pixel of a line has the colour of the water.
    is_line = numpy.abs(lines - solid).max(2) < 0.02
    assert is_line[286:306].mean() < 0.01 and is_line[306:340].mean() < 0.1
    assert 0.1 < is_line[560:].mean() < 0.4 and is_line[286:].mean(1).max() < 0.55


def test_the_plan_of_the_transform_is_shown(folder):
    good(folder, "sea.toml --offscreen s.png --view butterfly")
    picture = pixels(folder / "s.png")
    assert picture.shape == (720, 1280, 3)
    shown = picture[40:680, 3:1277][2::5, 91::182]  # a number is 182 x 5 pixels
    assert shown.shape == (128, 7, 3)
    root = 2 * shown[..., :2] - 1
    assert abs(numpy.hypot(root[..., 0], root[..., 1]) - 1).max() < 0.02


def test_an_older_opengl_draws_the_same(folder):
    size = ("--size", "160x90", "--foam-map", 128)
    good(folder, "sea.toml --offscreen new.png", *size)
    old = {"MESA_GL_VERSION_OVERRIDE": "4.1", "MESA_GLSL_VERSION_OVERRIDE": "410"}
    good(folder, "sea.toml --offscreen old.png", *size, **old)
    assert rms(pixels(folder / "new.png"), pixels(folder / "old.png")) < 2 / 255
    done = run(folder, "sea.toml --offscreen gl.png --backend gl", **old)
    assert done.returncode == 1 and "4.3" in done.stderr


def test_a_sequence_is_the_sea_frame_by_frame(folder):
    size = ("--size", "64x36", "--foam-map", 128, "--cells", 32)
    written = good(folder, "sea.toml --record out --frames 3-9x3", *size)
    assert written.split() == ["out/sea.0003.png", "out/sea.0006.png", "out/sea.0009.png"]
    good(folder, "sea.toml --offscreen alone.png --frame 9", *size)
    assert (pixels(folder / "alone.png") == pixels(folder / "out/sea.0009.png")).all()
    assert (pixels(folder / "alone.png") != pixels(folder / "out/sea.0003.png")).any()


def screen(light: numpy.ndarray) -> numpy.ndarray:
    """Returns the colour that shaders/preview/tone.glsl gives light."""
    above = numpy.maximum(light - 0.6, 0.0)
    rolled = numpy.minimum(light, 0.6) + 0.4 * above / (above + 0.4)
    return numpy.where(rolled < 0.0031308, 12.92 * rolled, 1.055 * rolled ** (1 / 2.4) - 0.055)


def test_an_exr_picture_is_the_light_of_the_png(folder):
    lines = {
        "a.exr": "--exposure 1.7",
        "a.png": "--exposure 1.7",
        "b.exr": "--exposure 3.4",
    }
    # One sample: the mean of a curve is not the curve of a mean.
    made = pictures(folder, lines, "sea.toml", "--size", "160x90", "--sun", "6,0",
                    "--samples", "1")  # fmt: skip
    light, shown = made["a.exr"], made["a.png"]
    spec = oiio.ImageBuf(str(folder / "a.exr")).spec()
    assert spec.channelnames == ("R", "G", "B") and spec.format == oiio.FLOAT
    # Upright, and nothing is lost: the sun is far beyond what a screen shows.
    assert numpy.abs(screen(light) - shown).max() < 0.6 / 255
    assert light.max() > 50.0
    # Twice the exposure is twice the light.
    assert made["b.exr"] == pytest.approx(2.0 * light, rel=1e-5)


def write_exr(path: Path, picture: numpy.ndarray):
    buffer = oiio.ImageBuf(oiio.ImageSpec(picture.shape[1], picture.shape[0], 3, oiio.FLOAT))
    buffer.set_pixels(buffer.roi, picture.astype(numpy.float32))
    assert buffer.write(str(path))


def test_an_environment_is_the_sky_and_its_sun(folder):
    height, width = 128, 256
    elevation, bearing = numpy.meshgrid(
        numpy.radians(90.0 - 180.0 * (numpy.arange(height) + 0.5) / height),
        numpy.radians(180.0 - 360.0 * (numpy.arange(width) + 0.5) / width),
        indexing="ij",
    )
    sky = numpy.array([0.5, 0.5, 1.0]) * (1.0 - 0.5 * numpy.abs(numpy.sin(elevation)))[..., None]
    # 25 degrees up, 90 to the left of the middle; beside it what is no light.
    row, column = int(height * 65 / 180), width // 4
    sky[row, column] = [3000.0, 2500.0, 2000.0]
    sky[5, 5] = [numpy.nan, -7.0, 1.0]
    write_exr(folder / "sky.exr", sky)
    lines = {"east.exr": "", "north.exr": "--heading 90", "turned.exr": "--environment-turn -90"}
    made = pictures(folder, lines, "sea.toml", "--size", "160x90", "--environment", "sky.exr",
                    "--pitch", 0)  # fmt: skip
    east, north, turned = made.values()
    assert east[:40].max() < 1.1
    assert numpy.median(east[:10, :, 2]) == pytest.approx(0.87, abs=0.05)
    for towards in (north, turned):
        # The upper edge is 18 degrees up: the sun is over it, its glitter below.
        assert towards[50:].max() > 2.0 * east[50:].max()
        columns = towards[50:].sum((0, 2)).argsort()[-20:]
        assert numpy.abs(columns - 79.5).mean() < 25.0


def test_the_look_of_the_teaching_programs(folder):
    asked = ("preset:seed_lantz", "--size", "160x90", "--pitch", 0)
    lines = {
        "seed.png": "--look seed",
        "physical.png": "",
        "seed_h.png": "--look seed --view height",
        "physical_h.png": "--look physical --view height",
    }
    made = pictures(folder, lines, *asked)
    seed, physical = made["seed.png"], made["physical.png"]
    assert rms(seed, physical) > 0.1
    # No sky, but one pale grey; below it water, deep blue.
    assert seed[:38].std((0, 1)).max() < 0.001 and seed[0, 0].min() > 0.8
    water = seed[60:].mean((0, 1))
    assert water[0] < 0.2 and water[0] < water[1] < water[2]
    # Fields are fields, whatever the look.
    assert (made["seed_h.png"] == made["physical_h.png"]).all()


def test_one_cascade_alone(folder):
    lines = {
        f"{view}-{name}.png": f"--view {view} {words}"
        for view in ("shaded", "slope")
        for name, words in (("all", ""), ("0", "--cascade 0"), ("1", "--cascade 1"))
    }
    made = pictures(folder, lines, "sea.toml", "--set", "cascades=2", "--no-detail",
                    "--size", "160x90", "--eye", "0,0,40", "--pitch", "-50")  # fmt: skip
    for view in ("shaded", "slope"):
        both, first, second = (made[f"{view}-{name}.png"] for name in ("all", "0", "1"))
        assert rms(both, first) > 0.01 and rms(first, second) > 0.02, view


def expect_baked_as_shown(folder, resolution: int):
    """What PERFORM_LIVE has left, each eighth frame of it and the last one."""
    shown = sorted(folder.glob("heights-*.f32"))
    assert len(shown) == 20
    frames = {int(path.stem.split("-")[1]): path for path in shown[3::8]}
    command = [OCEAN, "bake", "performed.toml", "-q", "-o", "####.exr", "--products", "height"]
    command += ["--type", "float", "--resolution", str(resolution)]
    command += ["--frames", ",".join(map(str, frames))]
    subprocess.run(command, cwd=folder, check=True, capture_output=True)
    step = resolution // 128
    for frame, path in frames.items():
        heights = numpy.fromfile(path, numpy.float32).reshape(128, 128)
        baked = pixels(folder / f"height.{frame:04}.exr")[::-1, :, 0][::step, ::step]
        assert baked.std() > 0.05
        assert abs(heights - baked).max() < 1e-5 * 4 * baked.std()


@pytest.mark.parametrize("backend", ["cpu", "gl"])
def test_a_performance_is_baked_as_it_was_shown(folder, backend):
    # Two cascades, and knobs that turn between the frames.
    two = SEA.replace("patch_size", "cascades = 2\npatch_size")
    (folder / "two.toml").write_text(two)
    subprocess.run([os.environ["PERFORM_LIVE"], "two.toml", backend, "."], cwd=folder, check=True)
    expect_baked_as_shown(folder, 1024)  # as fine as the fine cascade, for all of its waves


GOLDEN = ROOT / "tests" / "data" / "preview"


def blocks(picture: numpy.ndarray, size: int = 5) -> numpy.ndarray:
    """Means of squares of pixels: where a crest lies between pixels does not count."""
    height, width, channels = picture.shape
    return picture.reshape(height // size, size, width // size, size, channels).mean((1, 3))


def significant_height(sea: str) -> float:
    told = subprocess.run(
        [OCEAN, "info", "--json", sea], cwd=ROOT, check=True, capture_output=True, text=True
    )
    return json.loads(told.stdout)["significant_wave_height"]["resolved"]


# The foam of a near gale has all that a picture is made of.
@pytest.mark.parametrize(
    "sea",
    [
        name if name == "foam" else pytest.param(name, marks=pytest.mark.slow)
        for name in hosts.names()
    ],
)
def test_a_sea_is_as_it_was_looked_at(folder, sea):
    made = subprocess.run(
        [sys.executable, GOLDEN / "make.py", folder, sea],
        capture_output=True,
        text=True,
        timeout=600,
    )
    assert made.returncode == 0, made.stderr
    again = "if it was meant: OCEAN_PREVIEW=build/dev/bin/ocean-preview tests/data/preview/make.py"

    # Heights are of any GPU.
    rows = [
        [
            [float(number) for number in numbers]
            for name, *numbers in csv.reader((path / "heights.csv").open())
            if name == sea
        ]
        for path in (GOLDEN, folder)
    ]
    assert len(rows[1]) == 12
    close = 1e-3 * significant_height(hosts.view_of(sea)["sea"])
    assert numpy.array(rows[1]) == pytest.approx(numpy.array(rows[0]), abs=close), again

    # Pixels are of the renderer that made them: other drivers filter otherwise.
    renderer = run(folder, "sea.toml --probe 0,0 --size 16x16 -v", *COARSE).stderr
    if "drawn by llvmpipe" not in renderer:
        pytest.skip(f"the pictures are llvmpipe's; {renderer}")
    before, now = pixels(GOLDEN / f"{sea}.png"), pixels(folder / f"{sea}.png")
    everywhere = 255 * rms(before, now)
    somewhere = 255 * numpy.abs(blocks(before) - blocks(now)).max()
    off = f"off by {everywhere:.2f} of 255, a square by {somewhere:.2f}"
    assert everywhere < 2.0 and somewhere < 4.0, f"{off}; {again}"


class Hand:
    """A window under Xvfb and a hand that uses it. What it does is waited for by what the window
    tells under -v: each line "at rest" says how much of it the window has heard and shown."""

    REST = re.compile(
        r"at rest: (\d+x\d+), mouse at (\d+),(\d+), (\d+) keys, (\d+) clicks, (\d+) held"
    )

    def __init__(self, folder: Path, display: str, *options: str):
        self.folder = folder
        self.gamepad = folder / "gamepad"
        self.seen = folder / "gamepad.seen"
        self.environment = os.environ | {
            "DISPLAY": display,
            "LD_PRELOAD": ":".join(
                os.environ[name] for name in ("FAKE_GAMEPAD_LIBRARY", "FAKE_SCREEN_LIBRARY")
            ),
            "FAKE_SCREEN": str(folder / "scale"),
            "FAKE_GAMEPAD": str(self.gamepad),
            "FAKE_GAMEPAD_SEEN": str(self.seen),
            "XDG_STATE_HOME": str(folder / "state"),
        }
        look = [] if "--look" in options else ["--look", "seed"]  # drawn in a third of the time
        command = [PREVIEW, "sea.toml", *COARSE, *look, "-v", *options]
        self.program = subprocess.Popen(
            command, cwd=folder, env=self.environment, stderr=subprocess.PIPE, text=True
        )
        self.lines = []
        self.reader = threading.Thread(target=lambda: self.lines.extend(self.program.stderr))
        self.reader.start()
        self.keys = self.clicks = self.pictures = 0
        self.wait_for_line("the window is open")

    def do(self, *words) -> str:
        command = ["xdotool", *map(str, words)]
        return subprocess.run(command, env=self.environment, capture_output=True, text=True).stdout

    def wait_for(self, condition):
        """Until there is what is waited for, however busy the machine is."""
        deadline = time.monotonic() + 240.0
        while time.monotonic() < deadline:
            found = condition()
            if found:
                return found
            assert self.program.poll() is None, "".join(self.lines)
            time.sleep(0.01)
        raise AssertionError("waited for nothing\n" + "".join(self.lines))

    def wait_for_line(self, words: str):
        self.wait_for(lambda: any(line.rstrip().endswith(words) for line in list(self.lines)))

    def rest(self, size: str = "", mouse: tuple[int, int] | None = None, held: int = 0):
        """Waits until all that was done is shown and nothing moves any more."""

        def rests() -> bool:
            found = [self.REST.search(line) for line in list(self.lines)]
            told = next((match for match in reversed(found) if match), None)
            if told is None or (mouse and (int(told[2]), int(told[3])) != mouse):
                return False
            counts = tuple(int(told[i]) for i in (4, 5, 6))
            return told[1] == (size or told[1]) and counts == (self.keys, self.clicks, held)

        self.wait_for(rests)

    def key(self, name: str, rest: bool = True):
        """rest: of a sea that stands."""
        self.do("key", "--delay", 1, name)
        self.keys += len(name.split("+"))
        if rest:
            self.rest()

    def type(self, words: str):
        self.do("type", "--delay", 1, words)
        self.keys += len(words)
        self.rest()

    def move(self, x: int, y: int, held: int = 0):
        self.do("mousemove", x, y)
        self.rest(mouse=(x, y), held=held)

    def drag(self, x: int, y: int, to_x: int, to_y: int):
        self.move(x, y)
        self.do("mousedown", 1)
        self.clicks += 1
        self.rest(held=1)
        if (x, y) != (to_x, to_y):
            self.move((x + to_x) // 2, (y + to_y) // 2, held=1)
            self.move(to_x, to_y, held=1)
        self.do("mouseup", 1)
        self.rest()

    def click(self, x: int, y: int):
        self.drag(x, y, x, y)

    def push(self, kind: str, axes: str, buttons: str = "0 0 0 0", polls: int = 3):
        """Sets the state of the gamepad, and waits until the window has read it so often: see
        tests/preview/fake_gamepad.c. Two frames are complete at the third reading."""
        beside = self.gamepad.with_suffix(".new")
        beside.write_text(f"{kind} {axes} {buttons}")
        beside.rename(self.gamepad)
        self.wait_for_polls(polls)

    def wait_for_polls(self, polls: int):
        content = self.gamepad.read_text() if self.gamepad.exists() else ""

        def asked() -> bool:
            times, _, seen = self.seen.read_text().partition(" ")
            return seen == content and int(times) >= polls

        self.wait_for(lambda: self.seen.exists() and asked())

    def saved(self, name: str) -> dict:
        """The sea that is saved now, under that name."""
        self.click(*SAVE_SEA)
        self.wait_for_line(f"written: {name}")
        return tomllib.loads((self.folder / name).read_text())

    def picture(self) -> numpy.ndarray:
        """Returns the picture that is shown now, even while the sea moves."""
        self.pictures += 1
        name = f"sea-{self.pictures}.png"
        self.key("F12", rest=False)
        self.wait_for_line(f"written: {name}")
        return pixels(self.folder / name)

    def screen(self) -> numpy.ndarray:
        """All that is on the screen, panel and mouse too: Xvfb has it in a file, as xwd does."""
        data = (self.folder / "Xvfb_screen0").read_bytes()
        head = numpy.frombuffer(data[:100], ">u4").astype(int)
        begin, stride, rows = head[0] + 12 * head[19], head[12], head[5]
        bgrx = numpy.frombuffer(data, numpy.uint8, stride * rows, begin)
        return bgrx.reshape(rows, -1, 4)[..., 2::-1]

    def go_to_screen(self, scale: float, told: str):
        """See tests/preview/fake_screen.c."""
        beside = self.folder / "scale.new"
        beside.write_text(f"{scale}")
        before = len(self.lines)
        beside.rename(self.folder / "scale")
        words = f"the panel has scale {told}"
        self.wait_for(
            lambda: any(line.rstrip().endswith(words) for line in list(self.lines)[before:])
        )

    def at_rest(self) -> numpy.ndarray:
        """The picture that stays, of a sea that stands still."""
        self.key("shift")  # which does nothing by itself, but is told of when all is shown
        picture = self.picture()
        self.rest()
        return picture

    def until_it_moves(self, before: numpy.ndarray, more_than: float):
        self.wait_for(lambda: rms(self.picture(), before) > more_than)

    def end(self) -> str:
        """By Escape; all that was told."""
        self.key("Escape", rest=False)
        assert self.program.wait(timeout=240) == 0, "".join(self.lines)
        self.reader.join()
        return "".join(self.lines)


@contextlib.contextmanager
def window(folder: Path, display: str, *options: str):
    """A window and its hand, which end with the block."""
    used = Hand.__new__(Hand)
    try:
        used.__init__(folder, display, *options)
        yield used
    finally:
        if used.program.poll() is None:
            used.program.kill()
            used.program.wait()
        used.reader.join()


@pytest.fixture
def hand(request, folder, display):
    """Of a window that has room for the panel, or of the size that the test asks for."""
    if shutil.which("xdotool") is None:
        pytest.fail("xdotool is needed")
    with window(folder, display, "--size", getattr(request, "param", SIZE)) as used:
        yield used


# Places in the panel of the window, and beside it.
SIZE = "400x723"
WIND_SPEED = (90, 682)
COMPUTED_BY = (90, 613)
SAVE_SEA = (48, 218)
SEARCH = (90, 567)
BRIDGE = (60, 540)
BRIDGE_ADDRESS = (90, 563)
DUMMY_BOARD = (25, 609)
BRIDGE_START = (145, 609)  # and restart
BRIDGE_STOP = (207, 609)
BESIDE = (388, 600)


def test_a_hand_uses_the_window(hand):
    # The camera: a key, and the mouse beside the panel.
    hand.key("space")
    first = hand.picture()
    hand.do("keydown", "w")
    hand.keys += 1
    hand.until_it_moves(first, 0.01)
    hand.do("keyup", "w")
    moved = hand.at_rest()
    assert rms(first, moved) > 0.01
    hand.drag(375, 400, 395, 380)
    assert rms(hand.at_rest(), moved) > 0.02
    hand.key("v")
    assert rms(hand.at_rest(), moved) > 0.1  # heights

    # A slider changes the sea; nothing is written over.
    hand.drag(*WIND_SPEED, WIND_SPEED[0] + 20, WIND_SPEED[1])
    changed = hand.saved("sea-changed-1.toml")
    wind = changed["waves"][0]["wind_speed"]
    assert wind > 9.5 and "take" not in changed
    assert hand.saved("sea-changed-2.toml") == changed

    # Recorded, it is a take from there on; and that sea is one as any other.
    hand.key("r")
    hand.drag(*WIND_SPEED, WIND_SPEED[0] + 40, WIND_SPEED[1])
    sea = hand.saved("sea-performed-1.toml")
    played = [float(line.split()[2]) for line in sea["take"]["lines"]]
    assert played[-1] > wind + 2.0 and sea["waves"][0]["wind_speed"] == wind
    assert (hand.folder / "sea.toml").read_text() == SEA
    good(hand.folder, "sea-performed-1.toml --probe 0,0 --no-detail")

    # Taken back, it glides back.
    hand.key("ctrl+z")
    undone = hand.saved("sea-performed-2.toml")
    assert undone["take"]["lines"][-1].endswith(f"wind_speed {wind:g}")
    hand.key("r")

    # The sea file as it was, and as it is: what is bad or gone is told, and the sea stays.
    hand.key("ctrl+r")
    assert hand.saved("sea-changed-3.toml")["waves"][0]["wind_speed"] == 9.0
    shown = hand.at_rest()
    (hand.folder / "sea.toml").write_text(SEA.replace("wind_speed", "wind_sped"))
    hand.key("ctrl+r")
    told = hand.at_rest()
    assert hand.saved("sea-changed-4.toml")["waves"][0]["wind_speed"] == 9.0
    assert rms(shown, told) < 0.01

    # Words in the search are no commands.
    hand.click(*SEARCH)
    hand.type("foam qv")
    hand.key("Escape")
    assert hand.program.poll() is None

    # Paused and left alone it takes next to nothing: of a while in which nothing happens there is
    # nothing to wait for.
    hand.move(*BESIDE)
    before = cpu_seconds(hand.program)
    time.sleep(3.0)
    assert cpu_seconds(hand.program) - before < 0.05 * 3.0

    # Another size, an icon and back.
    window = hand.do("search", "--name", "ocean-preview").strip()
    hand.do("windowsize", window, 500, 300)
    hand.rest(size="500x300")
    hand.move(450, 250)  # keys go where the mouse is: no one manages these windows
    assert hand.at_rest().shape[:2] == (150, 250)
    hand.do("windowminimize", window)
    hand.do("windowmap", window)
    (hand.folder / "sea.toml").unlink()
    hand.key("ctrl+r")
    stands = hand.at_rest()
    hand.key("space", rest=False)
    hand.until_it_moves(stands, 0.0)
    told = hand.end()
    assert "rror" not in told, told


def letters(picture: numpy.ndarray, scale: int) -> tuple[int, int]:
    """Returns the white pixels of the title, and those that are neither white nor its ground."""
    title = picture[11 * scale : 24 * scale, 29 * scale : 140 * scale].astype(int)
    white = (title > 250).all(axis=2)
    ground = numpy.abs(title - picture[11 * scale, 200 * scale]).max(axis=2) < 4
    return white.sum(), (~white & ~ground).sum()


def title_width(picture: numpy.ndarray, row: int) -> int:
    """Returns the width of the panel's blue bar, from its first pixel to its last."""
    red, green, blue = picture[row].astype(int).T
    bar = numpy.flatnonzero((blue > 100) & (blue < 140) & (2 * red < blue))
    return bar[-1] - bar[0] + 1


@pytest.mark.slow
@pytest.mark.parametrize("hand", ["640x723"], indirect=True)
def test_the_panel_follows_the_window_to_another_screen(hand):
    """Twice as large it is the same: letters of 26 pixels have the outlines of those of 13, and no
    grey ones, which letters that are stretched have."""
    hand.key("space")
    hand.move(*BESIDE)
    hand.at_rest()
    small = hand.screen()
    white, grey = letters(small, 1)
    assert white > 150 and grey == 0
    # Within its frame of a pixel on either side.
    assert title_width(small, 18) == 376 - 2 * 8 - 2
    hand.go_to_screen(2.0, "2")
    hand.at_rest()
    large = hand.screen()
    assert letters(large, 2) == (4 * white, 0)
    assert title_width(large, 36) == 640 - 2 * 16 - 2  # 720 are more than the window has
    # A control that is shown twice as large is clicked at twice its place.
    hand.click(*(2 * place for place in SAVE_SEA))
    hand.wait_for_line("written: sea-changed-1.toml")
    # Back it is as wide as before. A hand moves it: it goes where it
    # was, in letters, if the window has room for it there.
    hand.go_to_screen(1.0, "1")
    hand.at_rest()
    assert title_width(hand.screen(), 18) == 376 - 2 * 8 - 2
    hand.drag(200, 18, 240, 58)
    hand.click(SAVE_SEA[0] + 40, SAVE_SEA[1] + 40)
    hand.wait_for_line("written: sea-changed-2.toml")
    hand.go_to_screen(1.5, "1.5")
    # Its height leaves a margin of 12 above and below.
    hand.click(int(1.5 * (SAVE_SEA[0] + 40)), 24 + int(1.5 * (SAVE_SEA[1] - 8)))
    hand.wait_for_line("written: sea-changed-3.toml")
    hand.go_to_screen(100.0, "8")  # nobody's screen
    assert "rror" not in hand.end()


def test_a_scale_is_asked_for(folder, display):
    """In place of the screen's, which is 1.5; of a window whose size is given."""
    (folder / "scale").write_text("1.5")
    with window(folder, display, "--size", SIZE, "--scale", "2") as hand:
        hand.key("space")
        hand.click(*(2 * place for place in SAVE_SEA))
        hand.wait_for_line("written: sea-changed-1.toml")
        assert "the panel has scale 2\n" in hand.end()


@pytest.mark.parametrize("hand", ["200x150"], indirect=True)  # nobody clicks
def test_a_hand_uses_a_gamepad_and_a_joystick(hand):
    hand.key("space")
    still = hand.at_rest()
    rest = "0 0 0 0 -1 -1"
    hand.push("gamepad", rest)
    assert rms(hand.at_rest(), still) == 0.0
    hand.push("gamepad", "0.1 -0.12 0.1 0 -1 -1", polls=20)  # a stick that is worn
    assert rms(hand.at_rest(), still) == 0.0
    for axes in ("0 -1 0 0 -1 -1", "0 0 0.8 0 -1 -1", "0 0 0 0 -1 1"):
        before = hand.at_rest()
        hand.push("gamepad", axes)
        hand.until_it_moves(before, 0.005)
        hand.push("gamepad", rest)
        assert rms(before, hand.at_rest()) > 0.005, axes
    # Y goes back to where it began; a button that is held counts once.
    hand.push("gamepad", rest, "0 0 0 1")
    assert rms(hand.at_rest(), still) == 0.0
    hand.push("gamepad", rest, "0 0 1 0")
    heights = hand.at_rest()
    assert rms(heights, still) > 0.1
    hand.wait_for_polls(20)
    assert rms(hand.at_rest(), heights) == 0.0
    hand.push("gamepad", rest)
    hand.push("gamepad", rest, "1 0 0 0")
    hand.until_it_moves(heights, 0.0)  # the sea goes on

    # Plugged out, and a joystick whose layout nobody knows.
    hand.gamepad.unlink()
    hand.wait_for_polls(3)
    hand.key("space")
    before = hand.at_rest()
    hand.push("joystick", "0 -1 0 0 0 0")
    hand.until_it_moves(before, 0.005)
    hand.push("joystick", "0 0 0 0 0 0")
    assert rms(hand.at_rest(), before) > 0.005


def test_a_hand_places_a_crest_and_drives_a_hull(hand):
    hand.key("space")
    hand.move(*BESIDE)
    hand.do("keydown", "ctrl")
    hand.do("click", 1)
    hand.do("keyup", "ctrl")
    hand.keys, hand.clicks = hand.keys + 1, hand.clicks + 1
    hand.rest()  # before the mouse goes to the panel
    (crest,) = hand.saved("sea-changed-1.toml")["crests"]
    assert crest["height"] == "1.3 Hs" and crest["time"] > 5.0 and crest["x"] > 10.0
    hand.key("ctrl+z")
    assert "crests" not in hand.saved("sea-changed-2.toml")

    # A hull lies ahead of the camera, which goes along with it.
    hand.key("h")
    hand.do("keydown", "Up", "keydown", "Left")
    hand.keys += 2
    for attempt in range(3, 30):
        hand.key("space", rest=False)
        for _ in range(3):
            hand.picture()
        hand.key("space", rest=False)
        hand.rest(held=2)
        hand.do("keyup", "Up", "keyup", "Left")
        hand.rest()
        (hull,) = hand.saved(f"sea-changed-{attempt}.toml")["hulls"]
        if hull["track"][-1][4] > 2.0:
            break
        hand.do("keydown", "Up", "keydown", "Left")
        hand.keys += 2
    assert hull["track"][0][1:] == [60.0, 0.0, 0.0, 0.0]
    assert hull["track"][-1][1] > 61.0 and hull["track"][-1][3] > 2.0
    # The stick of a gamepad steers it too, in place of the camera.
    hand.push("gamepad", "1 0 0 0 -1 -1")
    hand.key("space", rest=False)
    for _ in range(3):
        hand.picture()
    hand.key("space", rest=False)
    hand.push("gamepad", "0 0 0 0 -1 -1")
    hand.rest()
    attempt += 1
    (turned,) = hand.saved(f"sea-changed-{attempt}.toml")["hulls"]
    assert turned["track"][-1][3] < hull["track"][-1][3]
    hull = turned
    # A track that is in no file is saved with the window.
    hand.key("h")
    assert "rror" not in hand.end()
    last = hand.folder / f"sea-changed-{attempt + 1}.toml"
    (kept,) = tomllib.loads(last.read_text())["hulls"]
    assert kept["track"] == hull["track"][: len(kept["track"])]


@pytest.mark.slow
def test_a_hand_compares_backends(hand):
    hand.key("space")
    # The list begins under its own line: gl, cpu, radix2, dft (which refuses 128 samples), thesis.
    for row in (0, 2, 3, 4, 1):
        hand.click(*COMPUTED_BY)
        hand.click(COMPUTED_BY[0], COMPUTED_BY[1] + 22 + 17 * row)
        hand.move(*BESIDE)
        hand.picture()
        if row == 3:  # its list is still open
            hand.key("Escape")
            hand.click(*BESIDE)
    hand.key("r")
    hand.drag(*WIND_SPEED, WIND_SPEED[0] + 20, WIND_SPEED[1])
    said = hand.end()
    used = re.findall(r"the sea by (\w+)", said)
    assert used == ["gl", "radix2", "thesis", "cpu"], said
    # A recording is not lost with the window.
    take = tomllib.loads((hand.folder / "sea-performed-1.toml").read_text())["take"]
    assert take["lines"]


def free_address() -> tuple[str, int]:
    """A free one whose port has no digit twice in a row: a key that is pressed twice in a
    millisecond is text for GLFW, but no second press."""
    while True:
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            address = free.getsockname()
        if not re.search(r"(\d)\1", str(address[1])):
            return address


def test_a_hand_starts_and_stops_a_bridge(hand):
    address = free_address()

    def join():
        """A client that has been greeted; None while nobody is there."""
        try:
            return socket.create_connection(address, timeout=240).makefile("rw", newline="\r\n")
        except ConnectionRefusedError:
            return None

    def ask(client, line: str) -> str:
        client.write(f"{line}\n")
        client.flush()
        return client.readline().strip()

    def click(place):
        return ["mousemove", *place, "click", 1]

    # Faster than any picture: the window sleeps until all of it was done.
    assert join() is None
    words = [*click(BRIDGE), *click(BRIDGE_ADDRESS), "key", "ctrl+a"]
    words += ["type", "--args", 1, "--delay", 1, f"127.0.0.1:{address[1]}", "key", "Return"]
    words += [*click(DUMMY_BOARD), *click(BRIDGE_START), "mousemove", *BESIDE]
    hand.program.send_signal(signal.SIGSTOP)
    hand.do(*words)
    hand.program.send_signal(signal.SIGCONT)
    # Clicks, keys of the address, and those that xdotool holds to type it.
    hand.clicks += 4
    hand.keys += len(["ctrl", "a"]) + len(f"127.0.0.1:{address[1]}") + len(["shift", "Return"])
    client = hand.wait_for(join)
    assert client.readline().startswith("OBP 1 ")
    # The window is a client of its own, which tells how fast it draws.
    hand.wait_for(lambda: float(ask(client, "GET app.frame_rate").split()[2]) > 0.0)
    wind = ask(client, "GET wind_speed").split()[2]
    for value in (100, 200):
        assert ask(client, f"OUT board0/a1 {value}") == "OK"
    assert ask(client, "GET wind_speed").split()[2] not in (wind, "unset")
    others = [join() for _ in range(20)]
    assert ask(client, "SUBSCRIBE wind_speed") == "OK"
    hand.key("space")
    for button in (BRIDGE_START, BRIDGE_STOP):  # the first one starts it anew
        hand.click(*button)
        told = [line.strip() for line in client]
        assert told[-1] == "EVT STOP"
        if button == BRIDGE_START:
            client = hand.wait_for(join)
    hand.wait_for(lambda: join() is None)
    assert all(list(other)[-1].strip() == "EVT STOP" for other in others)
    hand.end()
