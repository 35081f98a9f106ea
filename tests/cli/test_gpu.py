# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean bake --backend gl`: the same frames, by whom they were computed, and what is said when
there is no GPU."""

import json
import os
import shutil
import subprocess
from pathlib import Path

import numpy
import OpenImageIO as oiio
import pytest
from coasts import REGION

SHADERS = Path(__file__).resolve().parents[2] / "shaders"
BAKE = ("bake", "sea.toml", "--products", "displacement,normal,foam", "--type", "float")


def built_with_gl(ocean) -> bool:
    return "libepoxy" in ocean.good("--version")


@pytest.fixture(autouse=True)
def gl(ocean):
    if not built_with_gl(ocean):
        pytest.skip("the command was built without libepoxy")


def pixels(path: Path) -> numpy.ndarray:
    return oiio.ImageBuf(str(path)).get_pixels(oiio.FLOAT)


def with_environment(**variables) -> dict:
    return {"env": {**os.environ, **variables}}


def test_frames_are_those_of_the_cpu_and_say_who_made_them(ocean):
    ocean.good(*BAKE, "-o", "gl/s.####.exr", "--frames", "1-3", "--backend", "gl")
    ocean.good(*BAKE, "-o", "cpu/s.####.exr", "--frames", "1-3")
    for frame in (1, 3):
        for product, bound in (("displacement", 2e-6), ("normal", 2e-6), ("foam", 4 / 512)):
            name = f"s.{product}.{frame:04}.exr"
            made, expected = pixels(ocean.folder / "gl" / name), pixels(ocean.folder / "cpu" / name)
            error = numpy.sqrt(numpy.mean((made - expected) ** 2))
            spread = numpy.sqrt(numpy.mean((expected - expected.mean((0, 1))) ** 2))
            assert error <= bound * (spread if product != "foam" else 1), (name, error, spread)
    header = oiio.ImageInput.open(str(ocean.folder / "gl/s.normal.0001.exr")).spec()
    assert header.getattribute("ocean:backend") == "gl"


def test_auto_takes_the_cpu_on_software_and_the_header_says_so(ocean):
    done = ocean(*BAKE, "-o", "s.####.exr", "--backend", "auto", "-v")
    assert done.returncode == 0, done.stderr
    if "no GPU" not in done.stderr:
        pytest.skip("there is a GPU")
    assert "backend cpu, not gl: " in done.stderr
    header = oiio.ImageInput.open(str(ocean.folder / "s.normal.0001.exr")).spec()
    assert header.getattribute("ocean:backend") == "cpu"


NO_VENDOR = {"__EGL_VENDOR_LIBRARY_FILENAMES": "/nonexistent.json"}


def broken_libraries(*names):
    """Those names, found first, with nothing in them: as if the libraries were not installed."""

    def variables(folder: Path) -> dict:
        for name in names:
            (folder / name).write_text("")
        return {"LD_LIBRARY_PATH": str(folder)}

    return variables


MACHINES = {
    "no driver": (lambda folder: NO_VENDOR, "no GPU can be used (EGL "),
    "no drivers of Mesa": (
        lambda folder: {"LIBGL_DRIVERS_PATH": str(folder)},
        "no GPU can be used (EGL ",
    ),
    "OpenGL 3.3": (lambda folder: {"MESA_GL_VERSION_OVERRIDE": "3.3"}, "has no OpenGL 4.3 core"),
    "no compute shaders": (
        lambda folder: {"MESA_EXTENSION_OVERRIDE": "-GL_ARB_compute_shader"},
        "has no OpenGL 4.3 core",
    ),
    "no EGL": (broken_libraries("libEGL.so.1"), "libEGL.so.1 is missing on this machine"),
    "no OpenGL": (
        broken_libraries("libOpenGL.so.0", "libGL.so.1"),
        "libOpenGL.so.0 and libGL.so.1 are missing on this machine",
    ),
}


@pytest.mark.parametrize("machine", MACHINES)
def test_without_a_gpu_gl_fails_and_auto_does_not(ocean, tmp_path_factory, machine):
    variables, reason = MACHINES[machine]
    environment = with_environment(**variables(tmp_path_factory.mktemp("machine")))
    done = ocean(*BAKE, "-o", "s.exr", "--backend", "gl", **environment)
    if done.returncode == 0:
        pytest.skip("the driver is not Mesa's")
    assert done.returncode == 1
    # Mesa has a word of its own to say.
    said = [line for line in done.stderr.splitlines() if line.startswith("ocean:")]
    assert len(said) == 1 and said[0].startswith("ocean: --backend gl: no GPU can be used")
    assert reason in said[0]
    assert "Error" not in done.stderr and not list(ocean.folder.glob("*.exr"))

    done = ocean(*BAKE, "-o", "s.####.exr", "--backend", "auto", "-v", **environment)
    assert done.returncode == 0, done.stderr
    assert reason in done.stderr.split("backend cpu, not gl: ")[1]
    header = oiio.ImageInput.open(str(ocean.folder / "s.normal.0001.exr")).spec()
    assert header.getattribute("ocean:backend") == "cpu"


def test_a_file_of_the_gpu_is_made_again_by_it_or_not_at_all(ocean):
    ocean.good(*BAKE, "-o", "s.####.exr", "--backend", "gl")
    again = ("bake", "--from", "s.displacement.0001.exr", "-o", "again.exr")
    ocean.good(*again)
    assert (pixels(ocean.folder / "again.exr")
            == pixels(ocean.folder / "s.displacement.0001.exr")).all()  # fmt: skip
    (ocean.folder / "again.exr").unlink()
    assert ocean(*again, **with_environment(**NO_VENDOR)).returncode == 1
    assert not (ocean.folder / "again.exr").exists()


def test_a_missing_device_is_refused(ocean):
    message = ocean.bad(*BAKE, "-o", "s.exr", "--backend", "gl", "--egl-device", "63", code=1)
    assert "EGL device 63: there are " in message
    assert "--egl-device" in ocean.bad(*BAKE, "-o", "s.exr", "--egl-device", "first")


def test_maps_beyond_the_limits_are_refused_with_them(ocean):
    done = ocean(*BAKE, "-o", "s.exr", "--backend", "gl", "--resolution", "8192", "-n")
    if done.returncode == 0:
        pytest.skip("this GPU can do it")
    assert done.returncode == 1
    assert "maps of 8192 samples need 536870912 bytes in a storage block" in done.stderr
    assert not list(ocean.folder.glob("*.exr"))
    done = ocean(*BAKE, "-o", "s.exr", "--backend", "auto", "--resolution", "8192", "-n")
    assert done.returncode == 0, done.stderr


def test_shaders_from_a_folder_take_the_place_of_those_inside(ocean):
    shutil.copytree(SHADERS, ocean.folder / "shaders")
    own = with_environment(OCEAN_SHADER_DIR=str(ocean.folder / "shaders"))
    bake = ("bake", "sea.toml", "-o", "s.exr", "--products", "jacobian", "--backend", "gl")
    channels = ocean.folder / "shaders/compute/channels.glsl"
    text = channels.read_text()

    channels.write_text(text.replace("return surface_jacobian(", "return 7.0 + surface_jacobian("))
    done = ocean(*bake, **own)
    assert done.returncode == 0, done.stderr
    assert abs(pixels(ocean.folder / "s.exr").mean() - 8.0) < 0.1

    channels.write_text(text.replace("return surface_jacobian(", "return surface_jacobean("))
    done = ocean(*bake, **own)
    assert done.returncode == 1
    assert "does not compile the shader compute/columns.comp" in done.stderr
    assert "surface_jacobean" in done.stderr and "compute/channels.glsl" in done.stderr

    shutil.rmtree(ocean.folder / "shaders")
    done = ocean(*bake, **own)
    assert done.returncode != 0
    assert "OCEAN_SHADER_DIR" in done.stderr


def test_a_bake_goes_on_with_the_frames_of_the_same_backend_only(ocean):
    ocean.good(*BAKE, "-o", "s.####.exr", "--backend", "gl")

    def events(*options):
        done = ocean(*BAKE, "-o", "s.####.exr", "--skip-existing", "--json", *options)
        assert done.returncode == 0, done.stderr
        return [json.loads(line)["event"] for line in done.stderr.splitlines()]

    assert "skipped" in events("--backend", "gl")
    assert "skipped" not in events()


def test_stages_lead_from_the_amplitudes_to_the_heights(ocean):
    """h0 to h(k, t) to the map: what numpy makes of one stage is the next."""

    def stage(name, *options):
        ocean.good("bake sea.toml -o", f"{name}.exr", "--stage", name, *options)
        return pixels(ocean.folder / f"{name}.exr")[::-1]  # from the bottom up

    h0, spectrum, butterfly = stage("h0"), stage("spectrum"), stage("butterfly")
    assert h0.shape == (64, 64, 4) and spectrum.shape == (64, 64, 2)
    assert butterfly.shape == (64, 6, 4)
    amplitudes = h0[..., 0] + 1j * h0[..., 1]
    mirrored = numpy.conj(numpy.roll(amplitudes[::-1, ::-1], (1, 1), (0, 1)))
    assert (mirrored == h0[..., 2] + 1j * h0[..., 3]).all()
    # At t = 0 no mode has turned.
    heights = spectrum[..., 0] + 1j * spectrum[..., 1]
    assert numpy.allclose(heights, amplitudes + mirrored, rtol=0, atol=1e-7)

    ocean.good("bake sea.toml -o map.exr --products height --type float")
    expected = pixels(ocean.folder / "map.exr")[::-1, :, 0]
    transformed = numpy.fft.ifft2(numpy.fft.ifftshift(heights), norm="forward").real
    assert numpy.abs(transformed - expected).max() < 2e-6 * expected.std() * 10

    sign = 1.0 - 2.0 * (numpy.add.outer(numpy.arange(64), numpy.arange(64)) % 2)
    last = stage("vertical-6")
    assert numpy.abs(sign * last[..., 0] - expected).max() < 1e-5 * expected.std()
    assert numpy.abs(last[..., 1]).max() < 1e-5 * expected.std()
    rows = stage("horizontal-6")
    alternating = sign[:1]
    along_x = numpy.fft.ifft(numpy.fft.ifftshift(heights, axes=1), axis=1, norm="forward")
    assert numpy.abs(alternating * (rows[..., 0] + 1j * rows[..., 1]) - along_x).max() < 1e-5


def test_stages_of_several_frames_have_names_and_what_is_not_ours_stays(ocean):
    out = ocean.good("bake sea.toml -o s.exr --stage spectrum --frames 1-2")
    assert out.split() == ["s.0001.exr", "s.0002.exr"]
    first, second = (pixels(ocean.folder / name) for name in out.split())
    assert (first != second).any()
    ocean.good("bake sea.toml -o s.exr --stage spectrum --frames 1-2")
    ocean.write("mine.exr", "my own")
    assert "is not replaced" in ocean.bad("bake sea.toml -o mine.exr --stage h0")
    assert (ocean.folder / "mine.exr").read_text() == "my own"
    message = ocean.bad("bake sea.toml -o s.exr --stage horizontal-7")
    assert "horizontal-1 .. horizontal-6" in message
    assert "--stage" in ocean.bad("bake sea.toml -o t.exr --stage h0 --products height")


def test_the_shared_library_knows_no_gl():
    library = os.environ.get("LIBOCEAN_LIBRARY")
    if not library:
        pytest.skip("LIBOCEAN_LIBRARY is not set")
    needed = subprocess.run(["readelf", "-d", library], capture_output=True, text=True).stdout
    assert "epoxy" not in needed and "libGL" not in needed


def test_a_coast_is_that_of_the_cpu(coast):
    region = ("bake", "sea.toml", *REGION, "--frames", "121", "--type", "float")
    products = ("--products", "displacement,depth,breaking")
    coast.good(*region, *products, "-o", "gl/c.####.exr", "--backend", "gl")
    coast.good(*region, *products, "-o", "cpu/c.####.exr")
    for product in ("displacement", "depth", "breaking"):
        made, expected = (
            pixels(coast.folder / of / f"c.{product}.0121.exr") for of in ("gl", "cpu")
        )
        assert numpy.ptp(expected) > 0.02, product
        # The waves are 0.8 m high.
        assert numpy.abs(made - expected).max() <= 1e-5 * 0.8, product
    header = oiio.ImageInput.open(str(coast.folder / "gl/c.depth.0121.exr")).spec()
    assert header.getattribute("ocean:backend") == "gl"
    refused = coast.bad(*region, "-o", "s.exr", "--backend", "radix2")
    assert "a sea over a bed by cpu and gl" in refused
