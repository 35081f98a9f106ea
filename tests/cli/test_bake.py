# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean bake`: names, frames, and files that others read."""

import math
import re
import resource

import numpy as np
import pytest


def test_the_default_frame_is_the_first_of_the_sea(ocean):
    names = ocean.bake("-o s.####.exr --products height --set first_frame=101")
    assert names == ["s.height.0101.exr"]
    spec, _ = ocean.image(names[0])
    assert float(spec["ocean:time"]) == 0.0


def test_time_comes_from_the_sea_not_from_the_range(ocean):
    ocean.bake("-o a/s.####.exr --frames 9 --set start=3")
    spec, _ = ocean.image("a/s.normal.0009.exr")
    assert float(spec["ocean:time"]) == 3.0 + 8.0 / 24.0
    ocean.bake("-o b/s.####.exr --frames 9 --fps 48")
    spec, _ = ocean.image("b/s.normal.0009.exr")
    assert float(spec["ocean:time"]) == 8.0 / 48.0


def test_the_bottom_scanline_is_the_first_row(ocean):
    # A lone wave train that travels north: h(y, t) = h(y - c t, 0) moves up in the picture.
    narrow = ["--products", "height", "--type", "float", "--set", "wind_direction=90", "--set",
              "longest_wavelength=60", "--set", "shortest_wavelength=45"]  # fmt: skip
    ocean.bake("-o s.####.exr --frames 1-2 --fps 4", *narrow)
    first, second = (
        np.fft.fft(ocean.image(f"s.height.000{n}.exr")[1][..., 0].mean(axis=1)) for n in (1, 2)
    )
    wave = 1 + np.argmax(np.abs(first[1:32]))
    turn = np.angle(second[wave] / first[wave])
    omega = math.sqrt(9.81 * 2.0 * math.pi * wave / 200.0)
    assert turn == pytest.approx(-omega * 0.25, rel=0.05)


def test_type_and_compression_are_obeyed(ocean):
    ocean.bake("-o h.exr --products displacement --type half")
    ocean.bake("-o p.exr --products displacement --compression pxr24")
    assert str(ocean.image("h.exr")[0].format) == "half"
    assert ocean.image("p.exr")[0]["compression"] == "pxr24"
    exact = ocean.bake("-o f.exr --products displacement")
    error = np.abs(ocean.image("p.exr")[1] - ocean.image(exact[0])[1]).max()
    assert 0.0 < error < 1e-4


def test_resolution_and_backend_change_no_sample(ocean):
    ocean.bake("-o a.exr --products height --type float")
    ocean.bake("-o b.exr --products height --type float --resolution 128")
    small, large = ocean.image("a.exr")[1], ocean.image("b.exr")[1]
    assert large.shape == (128, 128, 1)
    assert np.abs(large[::2, ::2] - small).max() < 1e-5 * small.std()
    for backend in ("radix2", "dft"):
        ocean.bake(f"-o {backend}.exr --products height --type float --backend {backend}")
        other = ocean.image(f"{backend}.exr")[1]
        assert np.sqrt(((other - small) ** 2).mean()) < 2e-6 * small.std()
        # Another way of summing rounds otherwise: the choice was obeyed.
        assert not np.array_equal(other, small)


def test_meshes_are_mesh2_of_one_period_or_of_a_view(ocean):
    ocean.bake("-o patch.inc")
    camera = ["--eye", "10,20,6", "--heading", "90", "--field-of-view", "50"]
    ocean.bake("-o view.inc", *camera, "--mesh-columns", "64", "--mesh-rows", "80")
    for name in ("patch.inc", "view.inc"):
        text = (ocean.folder / name).read_text()
        assert "#declare Ocean_Surface" in text and "mesh2" in text
        assert "nan" not in text and "inf," not in text
    assert f"{65 * 65}," in (ocean.folder / "patch.inc").read_text()
    assert f"{64 * 80}," in (ocean.folder / "view.inc").read_text()
    view = (ocean.folder / "view.inc").read_text()
    assert "Ocean_Eye = <10, 6, 20>" in view
    assert "Ocean_View_Angle = 50" in view
    forward = re.search(r"Ocean_Forward = <(.*), 0, (.*)>", view)
    assert [float(part) for part in forward.groups()] == pytest.approx([0.0, 1.0], abs=1e-9)


def test_waves_too_short_for_the_map_tilt_the_normals(ocean):
    view = ["--eye", "0,0,6", "--mesh-columns", "16", "--mesh-rows", "16"]
    texts = []
    for variance in (["--slope-variance", "0"], ["--slope-variance", "0.02"], []):
        ocean.bake("-o s.inc", *view, *variance)
        texts.append((ocean.folder / "s.inc").read_text())
    # The default is what the spectrum has beyond the map, and it has some.
    assert len(set(texts)) == 3
    positions = {text.split("normal_vectors")[0] for text in texts}
    assert len(positions) == 1


def test_an_existing_frame_is_replaced_whole(ocean):
    ocean.bake("-o s.exr --products height --set seed=9")
    old = (ocean.folder / "s.exr").read_bytes()
    ocean.bake("-o s.exr --products height --overwrite")
    new = (ocean.folder / "s.exr").read_bytes()
    assert new[:4] == b"\x76\x2f\x31\x01" and new != old
    assert ocean.files(".") == ["buoy.toml", "s.exr", "s.manifest.json", "sea.toml"]


def cpu_seconds(ocean, *arguments):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    ocean.bake(*arguments)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def test_files_are_compressed_where_it_pays(ocean):
    products = "displacement,velocity,height,normal,slope,jacobian,whitecap,foam,derivatives,cover"

    def used(name):
        (path,) = ocean.folder.glob(name)
        return ocean.image(path.name)[0]["compression"]

    small = {"normal", "slope", "jacobian", "whitecap", "foam", "derivatives", "cover"}
    ocean.bake("-o s.exr --products", products)
    ocean.bake("-o f.exr --products", products, "--type", "float")
    ocean.bake("-o l.exr --products normal,foam --layout layered")
    ocean.bake("-o m.exr --products displacement,foam --layout layered")
    for product in products.split(","):
        assert used(f"s.{product}.*exr") == ("rle" if product in small else "none"), product
        always = product in {"slope", "whitecap", "foam", "cover"}
        assert used(f"f.{product}.*exr") == ("rle" if always else "none"), product
    assert used("l.*exr") == "rle"
    assert used("m.*exr") == "none"


def test_compression_costs_less_than_half_a_bake(ocean):
    common = "--resolution 1024 --threads 1 --frames 1-4 --set foam_lifetime=0"
    plain = cpu_seconds(ocean, f"{common} -o p/s.####.exr --compression none")
    usual = cpu_seconds(ocean, f"{common} -o u/s.####.exr")
    assert usual < 1.5 * plain


def test_lists_may_have_blanks_and_rates_be_fractions(ocean):
    ocean.bake("-o a/s.####.exr --frames", " 1-3 , 5", "--products", "height, slope")
    ocean.bake("-o b/s.####.exr --frames 1-3,5 --products height,slope")
    assert ocean.hashes("a") == ocean.hashes("b")
    ocean.bake("-o t.exr --products height --fps 24000/1001 --frames 25")
    assert ocean.manifest("t.manifest.json")["t.exr"]["time"] == pytest.approx(1.001, abs=1e-12)
