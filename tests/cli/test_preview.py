# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The program `ocean-preview` as its users see it: pictures, probes, a window that a hand uses."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
import tomllib
from pathlib import Path

import numpy
import OpenImageIO as oiio
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "renders" / "preview"))
import hosts  # noqa: E402

PREVIEW = os.environ.get("OCEAN_PREVIEW", "")
OCEAN = os.environ["OCEAN"]
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


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "sea.toml").write_text(SEA)
    return tmp_path


def run(folder, *arguments, **environment) -> subprocess.CompletedProcess:
    # The context makes no use of a display that is there.
    kept = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
    return subprocess.run(
        [PREVIEW, *map(str, arguments)],
        cwd=folder,
        env=kept | environment,
        capture_output=True,
        text=True,
        timeout=120,
    )


def good(folder, *arguments, **environment) -> str:
    done = run(folder, *arguments, **environment)
    assert done.returncode == 0, done.stderr
    return done.stdout


def pixels(path: Path) -> numpy.ndarray:
    return oiio.ImageBuf(str(path)).get_pixels(oiio.FLOAT)


def rms(a: numpy.ndarray, b: numpy.ndarray) -> float:
    return float(numpy.sqrt(numpy.mean((a - b) ** 2)))


def test_a_picture_has_sky_horizon_and_water(folder):
    start = time.monotonic()
    assert good(folder, "sea.toml", "--offscreen", "a.png", "--size", "640x360") == "a.png\n"
    # Three seconds are for a quiet machine.
    assert time.monotonic() - start < 10.0
    picture = pixels(folder / "a.png")
    assert picture.shape == (360, 640, 3)
    # -4 degrees of 60 across 640 pixels: the horizon lies 39 above the middle.
    sky, water = picture[:130], picture[160:]
    assert sky[..., 2].mean() > sky[..., 0].mean() and sky.std() < 0.1
    assert water.mean() < 0.7 * sky.mean()
    edges = numpy.abs(numpy.diff(picture.mean(2), axis=0))
    rows = edges[100:180].argmax(0) + 100
    # Straight; here and there a glint is a stronger edge.
    assert (numpy.abs(rows - 141) <= 2).mean() > 0.95


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
    probed = good(folder, "sea.toml", "--time", 12, "--map", 512, *words).splitlines()
    for query, probe in zip(asked, probed, strict=True):
        x, y, expected = map(float, query.split(",")[:3])
        px, py, mesh, maps, shown, handed_on = map(float, probe.split(","))
        assert (px, py) == (x, y)
        assert maps == pytest.approx(expected, abs=0.05)
        assert mesh == pytest.approx(maps, abs=0.1)
        assert shown >= 0.0 and handed_on > 0.0


@pytest.mark.parametrize("view", ["height", "normal", "slope", "jacobian", "whitecap", "foam"])
def test_views_are_other_pictures(folder, view):
    camera = ("--size", "160x90", "--eye", "0,0,40", "--pitch", "-50")
    good(folder, "sea.toml", "--set", "wind_speed=18", "--offscreen", "a.png", *camera)
    good(
        folder,
        "sea.toml",
        "--set",
        "wind_speed=18",
        "--offscreen",
        "b.png",
        "--view",
        view,
        *camera,
    )
    assert rms(pixels(folder / "a.png"), pixels(folder / "b.png")) > 0.1


def test_an_older_opengl_draws_the_same(folder):
    good(folder, "sea.toml", "--offscreen", "new.png", "--size", "320x180")
    old = {"MESA_GL_VERSION_OVERRIDE": "4.1", "MESA_GLSL_VERSION_OVERRIDE": "410"}
    good(folder, "sea.toml", "--offscreen", "old.png", "--size", "320x180", **old)
    assert rms(pixels(folder / "new.png"), pixels(folder / "old.png")) < 2 / 255
    done = run(folder, "sea.toml", "--offscreen", "gl.png", "--backend", "gl", **old)
    assert done.returncode == 1 and "4.3" in done.stderr


def test_computed_by_the_gpu_it_is_the_same_sea(folder):
    for backend in ("cpu", "gl"):
        good(folder, "sea.toml", "--offscreen", f"{backend}.png", "--size", "320x180",
             "--backend", backend, "--foam-map", 128)  # fmt: skip
    assert rms(pixels(folder / "cpu.png"), pixels(folder / "gl.png")) < 1 / 255


def test_a_sequence_is_the_sea_frame_by_frame(folder):
    size = ("--size", "64x36")
    written = good(folder, "sea.toml", "--record", "out", "--frames", "3-9x3", *size)
    assert written.split() == ["out/sea.0003.png", "out/sea.0006.png", "out/sea.0009.png"]
    good(folder, "sea.toml", "--offscreen", "alone.png", "--frame", 9, *size)
    assert (pixels(folder / "alone.png") == pixels(folder / "out/sea.0009.png")).all()
    assert (pixels(folder / "alone.png") != pixels(folder / "out/sea.0003.png")).any()


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("sea.toml", "--size", "640"), "--size"),
        (("sea.toml", "--size", "640x0"), "--size"),
        (("sea.toml", "--eye", "1,2"), "--eye"),
        (("sea.toml", "--eye", "1,2,nan"), "--eye"),
        (("sea.toml", "--sun", "95,0"), "--sun"),
        (("sea.toml", "--angle", "0"), "--angle"),
        (("sea.toml", "--map", "100"), "--map"),
        (("sea.toml", "--cells", "20"), "--cells"),
        (("sea.toml", "--time", "1e10", "--probe", "0,0"), "time"),
        (("sea.toml", "--look-at", "1,1,1", "--heading", "3"), "--look-at"),
        (("sea.toml", "--probe", "1"), "--probe"),
        (("sea.toml", "--frames", "1-3"), "--record"),
        (("sea.toml", "--view", "heights"), "--view"),
        (("none.toml",), "none.toml"),
        (("broken.toml",), "wind_sped"),
    ],
)
def test_what_is_wrong_is_said(folder, arguments, words):
    (folder / "broken.toml").write_text(SEA.replace("wind_speed", "wind_sped"))
    extra = () if "--probe" in arguments else ("--offscreen", "a.png")
    done = run(folder, *arguments, *extra)
    assert done.returncode == 2 and words in done.stderr, done.stderr
    assert len(done.stderr.splitlines()) == 1 or "--help" in done.stderr
    assert not (folder / "a.png").exists()


def test_without_a_display_or_a_place_to_write_it_says_so(folder):
    done = run(folder, "sea.toml")
    assert done.returncode == 1 and "--offscreen" in done.stderr
    done = run(folder, "sea.toml", "--offscreen", "no/folder/a.png", "--size", "64x36")
    assert done.returncode == 1 and "no/folder/a.png" in done.stderr
    # Nor is the sea itself taken for a picture.
    done = run(folder, "sea.toml", "--offscreen", "sea.toml", "--size", "64x36")
    assert done.returncode == 2 and (folder / "sea.toml").read_text() == SEA


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


def test_five_seas_are_those_that_were_looked_at(folder):
    made = subprocess.run(
        [sys.executable, GOLDEN / "make.py", folder], capture_output=True, text=True, timeout=240
    )
    assert made.returncode == 0, made.stderr
    again = "if it was meant: OCEAN_PREVIEW=build/dev/bin/ocean-preview tests/data/preview/make.py"

    # Heights are of any GPU.
    waves = {name: significant_height(hosts.views()[name]["sea"]) for name in hosts.beside()}
    rows = [(path / "heights.csv").read_text().splitlines()[1:] for path in (GOLDEN, folder)]
    for before, now in zip(*rows, strict=True):
        sea, *numbers = before.split(",")
        close = pytest.approx([float(n) for n in numbers], abs=1e-3 * waves[sea])
        assert [float(n) for n in now.split(",")[1:]] == close, f"{sea}; {again}"

    # Pixels are of the renderer that made them: other drivers filter otherwise.
    renderer = run(folder, "sea.toml", "--probe", "0,0", "-v").stderr
    if "drawn by llvmpipe" not in renderer:
        pytest.skip(f"the pictures are llvmpipe's; {renderer}")
    for sea in waves:
        before, now = pixels(GOLDEN / f"{sea}.png"), pixels(folder / f"{sea}.png")
        everywhere = 255 * rms(before, now)
        somewhere = 255 * numpy.abs(blocks(before) - blocks(now)).max()
        off = f"{sea}: off by {everywhere:.2f} of 255, a square by {somewhere:.2f}"
        assert everywhere < 2.0 and somewhere < 4.0, f"{off}; {again}"


class Hand:
    """A window under Xvfb and a hand that uses it."""

    def __init__(self, folder: Path, display: str):
        self.folder = folder
        self.environment = os.environ | {"DISPLAY": display}
        self.program = subprocess.Popen(
            [PREVIEW, "sea.toml", "--size", "1000x700", "-v"],
            cwd=folder,
            env=self.environment,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.window = self.wait_for(lambda: self.do("search", "--name", "ocean-preview").strip())
        # It is there before it listens.
        self.wait_for(lambda: self.key("F12") or (folder / "sea-1.png").exists())
        time.sleep(1.0)

    def do(self, *words) -> str:
        command = ["xdotool", *map(str, words)]
        return subprocess.run(command, env=self.environment, capture_output=True, text=True).stdout

    def key(self, *names):
        self.do("key", "--delay", 60, *names)

    def drag(self, x: int, y: int, to_x: int, to_y: int):
        self.do("mousemove", x, y)
        time.sleep(0.4)
        self.do("mousedown", 1)
        for i in range(1, 6):
            self.do("mousemove", x + (to_x - x) * i // 5, y + (to_y - y) * i // 5)
            time.sleep(0.2)
        self.do("mouseup", 1)
        time.sleep(0.4)

    def click(self, x: int, y: int):
        self.drag(x, y, x, y)

    def wait_for(self, condition, seconds: float = 30.0):
        for _ in range(int(10 * seconds)):
            found = condition()
            if found:
                return found
            assert self.program.poll() is None, self.program.stderr.read()
            time.sleep(0.1)
        raise AssertionError("waited for nothing")

    def picture(self) -> numpy.ndarray:
        number = len(list(self.folder.glob("sea-*.png"))) + 1
        path = self.folder / f"sea-{number}.png"
        self.key("F12")
        self.wait_for(path.exists)
        time.sleep(0.2)
        return pixels(path)

    def seconds_of_processor(self) -> float:
        fields = Path(f"/proc/{self.program.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


@pytest.fixture
def hand(folder):
    if shutil.which("Xvfb") is None or shutil.which("xdotool") is None:
        pytest.fail("Xvfb and xdotool are needed")
    read, write = os.pipe()
    command = ["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x800x24", "-nolisten", "tcp"]
    server = subprocess.Popen(command, pass_fds=[write], stderr=subprocess.DEVNULL)
    os.close(write)
    with os.fdopen(read) as pipe:
        display = ":" + pipe.readline().strip()
    used = None
    try:
        used = Hand(folder, display)
        yield used
    finally:
        if used is not None and used.program.poll() is None:
            used.program.kill()
            used.program.wait()
        server.send_signal(signal.SIGTERM)
        server.wait()


# Places in the panel of a window of 1000 x 700.
WIND_SPEED = (90, 531)
SAVE_SEA = (48, 182)
SEARCH = (90, 439)


def test_a_hand_uses_the_window(hand):
    # The camera: a key, and the mouse beside the panel.
    hand.key("space")
    first = hand.picture()
    hand.do("keydown", "w")
    time.sleep(1.5)
    hand.do("keyup", "w")
    moved = hand.picture()
    assert rms(first, moved) > 0.01
    hand.drag(700, 400, 800, 380)
    assert rms(hand.picture(), moved) > 0.02
    hand.key("v")
    assert rms(hand.picture(), moved) > 0.1  # heights

    # A slider is performed, and saved with the sea; nothing is written over.
    hand.drag(*WIND_SPEED, WIND_SPEED[0] + 40, WIND_SPEED[1])
    hand.click(*SAVE_SEA)
    hand.click(*SAVE_SEA)
    saved = hand.folder / "sea-performed-2.toml"
    hand.wait_for(saved.exists)
    sea = tomllib.loads(saved.read_text())
    played = [float(line.split()[2]) for line in sea["take"]["lines"]]
    assert played[-1] > 12.0 and sea["waves"][0]["wind_speed"] == 9.0
    assert (hand.folder / "sea.toml").read_text() == SEA
    # It is a sea as any other.
    good(hand.folder, saved.name, "--probe", "0,0")

    # Taken back, it glides back.
    hand.key("ctrl+z")
    time.sleep(0.5)
    hand.click(*SAVE_SEA)
    undone = hand.folder / "sea-performed-3.toml"
    hand.wait_for(undone.exists)
    assert tomllib.loads(undone.read_text())["take"]["lines"][-1].endswith("wind_speed 9")

    # Words in the search are no commands.
    hand.click(*SEARCH)
    hand.do("type", "--delay", 60, "foam qv")
    hand.key("Escape")
    time.sleep(0.5)
    assert hand.program.poll() is None

    # Paused and left alone it takes next to nothing.
    hand.do("mousemove", 700, 600)
    time.sleep(2.0)
    before = hand.seconds_of_processor()
    time.sleep(4.0)
    assert hand.seconds_of_processor() - before < 0.05 * 4.0

    # Another size, an icon and back.
    hand.do("windowsize", hand.window, 500, 300)
    hand.do("mousemove", 450, 250)  # keys go where the mouse is: no one manages these windows
    time.sleep(1.0)
    assert hand.picture().shape[:2] == (150, 250)
    hand.do("windowminimize", hand.window)
    time.sleep(0.5)
    hand.do("windowmap", hand.window)
    time.sleep(0.5)
    (hand.folder / "sea.toml").unlink()  # it was read, and is not missed
    hand.key("space")
    time.sleep(1.0)
    hand.key("Escape")
    assert hand.program.wait(timeout=20) == 0, hand.program.stderr.read()
    assert "rror" not in hand.program.stderr.read()
