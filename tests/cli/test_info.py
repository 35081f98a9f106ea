# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean info` and `ocean spectrum`: the numbers of a sea."""

import json
import math
import re

import numpy as np
import OpenImageIO
import pytest
from conftest import BUOY

PAIRS = ["significant_wave_height", "peak_period", "energy_period", "mean_period",
         "peak_wavelength", "mean_square_slope", "mean_direction",
         "directional_spread"]  # fmt: skip
NUMBERS = ["energy_resolved", "shortest_wave", "longest_wave", "period", "memory_bytes",
           "foam_preroll_seconds", "loop_error", "folded_share"]  # fmt: skip


def state_of(ocean, *arguments):
    return json.loads(ocean.good("info --json", *arguments))


def columns(text):
    header, body = text.split("\n", 1)
    names = header.split(",")
    for empty, number in ((",,", ",nan,"), (",,", ",nan,"), (",\n", ",nan\n"), ("\n", ",")):
        body = body.replace(empty, number)
    numbers = np.fromstring(body.rstrip(","), sep=",").reshape(-1, len(names))
    return dict(zip(names, numbers.T, strict=True))


SWELL = """libocean = 1
[grid]
resolution = 64
[[waves]]
spectrum = "jonswap"
significant_wave_height = 1.0
peak_period = 14.0
"""


def test_a_sea_that_cannot_be_is_warned_of(ocean):
    ocean.write("swell.toml", SWELL)
    calm = ocean("info swell.toml")
    assert re.search(r"Whitecaps +none", calm.stdout)
    assert "warning: the wind is unknown" in calm.stderr
    assert "wind_speed" not in ocean.good("info --sea-file swell.toml")
    blown = ocean("info swell.toml --set wind_speed=10")
    assert re.search(r"Whitecaps +0\.99 % of the sea", blown.stdout)
    assert "no wind" not in blown.stderr
    shallow = ("--set", "depth=1.5", "--set", "wind_speed=10", "--set", "choppiness=4")
    done = ocean("info swell.toml", *shallow)
    assert "warning: waves of 1.00 m in water.depth = 1.50 m" in done.stderr
    state = state_of(ocean, "swell.toml", *shallow)
    assert state["folded_share"] > 0.01
    assert any("folded over on" in warning for warning in state["warnings"])


LIGHT = """libocean = 1
[grid]
resolution = 32
patch_size = 200.0
[[waves]]
spectrum = "jonswap"
wind_speed = 5.0
"""


def test_a_fetch_beyond_full_development_is_warned_of_wherever_the_sea_goes(ocean):
    """5 m/s over the default fetch of 300 km: JONSWAP [Hasselmann 1973] gives 1.97 m, the fully
    developed sea [Pierson and Moskowitz 1964] has 0.561 m, which JONSWAP has at 30.5 km."""
    ocean.write("light.toml", LIGHT)
    warning = r"warning: waves\.0\.fetch = 300000 m .* 1\.97 m, .* 0\.561 m .* 30500 m"
    assert re.search(warning, ocean("info light.toml").stderr)
    assert state_of(ocean, "light.toml")["significant_wave_height"]["asked"] == pytest.approx(
        1.974, abs=5e-4
    ), "the sea is what was asked for"
    for command in (
        ["bake", "light.toml", "--frames", "1-3", "-o", "out/sea_####.exr"],
        ["povray", "light.toml", "-o", "folder"],
    ):
        done = ocean(*command)
        assert done.returncode == 0, done.stderr
        assert len(re.findall(warning, done.stderr)) == 1, done.stderr
    developed = ocean("info light.toml --set fetch=30500").stderr
    assert "full development" not in developed


def test_a_take_that_lets_the_wind_fall_is_warned_of_by_its_bake(ocean):
    ocean.write(
        "fall.toml", LIGHT.replace("5.0", "20.0") + '[take]\nlines = ["0.1 wind_speed 5"]\n'
    )
    done = ocean("bake fall.toml --frames 1-24 -o out/sea_####.exr")
    assert done.returncode == 0, done.stderr
    found = re.findall(r"warning: frame (\d+): waves\.0\.fetch", done.stderr)
    assert len(found) == 1 and int(found[0]) > 3, done.stderr


def test_json_has_the_documented_keys(ocean):
    state = state_of(ocean, "sea.toml")
    for name in PAIRS:
        assert set(state[name]) == {"asked", "resolved"}
    for name in NUMBERS:
        assert isinstance(state[name], (int, float))
    assert state["period"] == 200.0
    assert state["loop_errors"] == []
    slopes = {entry["resolution"]: entry["mean_square_slope"] for entry in state["map_slopes"]}
    assert list(slopes) == [2**power for power in range(14)]
    assert 0.0 < slopes[16] < slopes[64]
    assert slopes[8192] == pytest.approx(state["mean_square_slope"]["resolved"])
    looped = state_of(ocean, "sea.toml", "--set", "loop_period=8")
    assert looped["loop_error"] > 0.0
    assert set(looped["loop_errors"][0]) == {"wavelength", "speed_error"}
    assert state["mean_direction"]["asked"] == pytest.approx(30.0, abs=0.01)


def test_a_baked_file_says_which_frame_it_is(ocean):
    ocean.good("bake sea.toml --frames 12 -o s.####.exr --products height")
    assert "s.height.0012.exr, frame 12 at 0.458333 s\n" in ocean.good("info s.height.0012.exr")
    state = state_of(ocean, "s.height.0012.exr")
    assert (state["frame"], state["time"]) == (12, pytest.approx(11 / 24))
    assert not {"frame", "time"} & state_of(ocean, "sea.toml").keys()


def table_of(suffix, columns_before):
    """Time -> [(frequency, value)] of an NDBC table, read by these few lines alone."""
    table = {}
    for line in BUOY.with_suffix(suffix).read_text().splitlines():
        cells = line.split()
        if line.startswith("#"):
            continue
        pairs = zip(cells[columns_before::2], cells[columns_before + 1 :: 2], strict=True)
        time = "{}-{}-{}T{}:{}".format(*cells[:5])
        table[time] = np.array([(float(f.strip("()")), float(v)) for v, f in pairs])
    return table


def test_every_record_of_the_buoy_has_the_files_own_height_and_direction(ocean):
    density, alpha, spread = (
        table_of(*table) for table in [(".data_spec", 6), (".swdir", 5), (".swr1", 5)]
    )
    ocean.write("buoy.toml", f'libocean = 1\n[[waves]]\nspectrum = "measured"\nfile = "{BUOY}"\n')
    assert len(density) > 40
    for time, bins in density.items():
        f, s = bins.T
        m0 = np.trapz(s, f)
        known = (alpha[time][:, 1] < 900) & (spread[time][:, 1] < 90)
        weight = (s * np.gradient(f) * spread[time][:, 1])[known]
        towards = np.deg2rad(270.0 - alpha[time][known, 1])
        mean = np.rad2deg(np.angle(np.sum(weight * np.exp(1j * towards))))
        state = state_of(ocean, "buoy.toml", "--set", f"record={time}")
        for part in ("asked", "resolved"):
            height = state["significant_wave_height"][part]
            assert height == pytest.approx(4.0 * math.sqrt(m0), rel=0.01), (time, part)
            turned = (state["mean_direction"][part] - mean + 180.0) % 360.0 - 180.0
            assert abs(turned) < 5.0, (time, part)


def test_text_says_the_same_as_json(ocean):
    text = ocean.good("info sea.toml")
    state = state_of(ocean, "sea.toml")
    found = re.search(r"Significant height +(\S+) m +(\S+) m", text)
    assert float(found[1]) == pytest.approx(state["significant_wave_height"]["asked"], rel=1e-3)
    assert float(found[2]) == pytest.approx(state["significant_wave_height"]["resolved"], rel=1e-3)
    assert "-0.0" not in ocean.good("info preset:beaufort_6")


def test_direction_is_ours_and_nautical(ocean):
    # Towards 30 degrees from east is towards 060 on the compass, so from 240.
    text = ocean.good("info sea.toml")
    assert re.search(r"Mean direction, to +30\.0 deg", text)
    assert re.search(r"nautical, from +240\.0 deg", text)


def test_a_measured_sea_names_its_station_and_time(ocean):
    text = ocean.good("info buoy.toml")
    assert "measured: 41010, 2020-06-08T03:50 UTC" in text


def test_set_changes_a_parameter_and_may_be_repeated(ocean):
    state = state_of(ocean, "sea.toml", "--set", "wind_direction=75", "--set", "patch_size=400")
    assert state["mean_direction"]["asked"] == pytest.approx(75.0, abs=0.01)
    assert state["period"] == 400.0


def test_set_of_a_record_reads_that_record(ocean):
    text = ocean.good("info buoy.toml --set record=2020-06-08T02:50")
    assert "2020-06-08T02:50" in text
    assert state_of(ocean, "buoy.toml") != state_of(
        ocean, "buoy.toml", "--set", "record=2020-06-08T02:50"
    )


def test_a_grid_that_holds_too_little_is_warned_of(ocean):
    done = ocean("info sea.toml --set patch_size=20")
    assert done.returncode == 0
    assert "ocean: warning: " in done.stderr
    assert "warning" not in done.stdout


@pytest.mark.parametrize("sea", ["sea.toml", "buoy.toml"])
def test_info_of_a_baked_file_is_info_of_the_sea(ocean, sea):
    ocean.good("bake", sea, "-o", "out/s.exr", "--products", "height")
    assert state_of(ocean, "out/s.exr") == {**state_of(ocean, sea), "frame": 1, "time": 0.0}
    assert ocean.good("info out/s.exr --sea-file") == ocean.good("info", sea, "--sea-file")


@pytest.mark.parametrize("sea", ["sea.toml", "buoy.toml"])
def test_trapezoid_over_the_csv_is_the_asked_height(ocean, sea):
    table = columns(ocean.good("spectrum", sea))
    m0 = np.trapz(table["density_m2_per_hz"], table["frequency_hz"])
    height = state_of(ocean, sea)["significant_wave_height"]["asked"]
    assert 4.0 * math.sqrt(m0) == pytest.approx(height, rel=1e-5)


def test_directional_csv_sums_to_the_frequency_csv(ocean):
    flat = columns(ocean.good("spectrum sea.toml"))
    full = columns(ocean.good("spectrum sea.toml --directional"))
    rows = len(flat["frequency_hz"])
    density = full["density_m2_per_hz_per_deg"].reshape(rows, -1)
    step = 360.0 / density.shape[1]
    assert density.sum(axis=1) * step == pytest.approx(flat["density_m2_per_hz"], rel=1e-6)
    direction = full["direction_deg"].reshape(rows, -1)
    peak = np.unravel_index(density.argmax(), density.shape)
    assert direction[peak] == pytest.approx(30.0, abs=step)
    assert np.nanmax(np.abs(flat["mean_direction_deg"] - 30.0)) < 0.01


def test_csv_has_no_nan(ocean):
    for sea in ("sea.toml", "buoy.toml", "preset:beaufort_0"):
        text = ocean.good("spectrum", sea)
        assert "nan" not in text.lower()
        for line in text.splitlines()[1:]:
            _, density, direction, spread = line.split(",")
            # Where there is no energy there is no direction, not even 0.
            assert (direction == "") == (spread == "") == (float(density) == 0.0)


def test_csv_goes_into_a_file_whose_folder_is_made(ocean):
    text = ocean.good("spectrum sea.toml")
    assert ocean.good("spectrum sea.toml -o new/s.csv") == "new/s.csv\n"
    assert (ocean.folder / "new/s.csv").read_text() == text
    assert ocean.files("new") == ["s.csv"]


@pytest.mark.parametrize("sea", ["sea.toml", "buoy.toml", "preset:beaufort_0"])
def test_plot_is_a_picture(ocean, sea):
    assert ocean.good("spectrum", sea, "--plot", "new/p.png") == "new/p.png\n"
    pixels = OpenImageIO.ImageBuf(str(ocean.folder / "new/p.png")).get_pixels(OpenImageIO.UINT8)
    height, width, _ = pixels.shape
    assert width >= 1280 and height >= 720
    # Paper all around, ink inside.
    assert (pixels[0] == 255).all() and (pixels[:, -1] == 255).all()
    assert 0.01 < (pixels < 255).any(axis=2).mean() < 0.6


def test_plot_shows_as_much_resolved_as_asked_energy(ocean):
    large = ["--set", "patch_size=1000", "--set", "resolution=512"]
    ocean.good("spectrum sea.toml --plot p.png", *large)
    image = OpenImageIO.ImageBuf(str(ocean.folder / "p.png"))
    # The left panel up to its legend; its scale of pixels is 1.5 to the point.
    panel = image.get_pixels(OpenImageIO.UINT8)[159:795, 126:570].astype(int)

    def close(color, distance):
        return np.abs(panel - np.array(color)).max(axis=2) < distance

    curve = close([13, 69, 112], 40)
    rows = np.arange(panel.shape[0])[:, None]
    drawn = curve.any(axis=0)
    assert drawn.mean() > 0.95
    level = (curve * rows).sum(axis=0)[drawn] / curve.sum(axis=0)[drawn]
    asked = (panel.shape[0] - level).sum()
    # Columns are filled from their highest orange pixel down to the axis.
    orange = (panel[..., 0] - panel[..., 2]) > 30
    resolved = (panel.shape[0] - orange.argmax(axis=0))[orange.any(axis=0)].sum()
    assert resolved / asked == pytest.approx(1.0, abs=0.1)


HERO = """libocean = 1
[grid]
resolution = 64
patch_size = 400.0
[[waves]]
spectrum = "jonswap"
significant_wave_height = 3.0
peak_period = 8.0
wind_speed = 12.0
[[crests]]
time = 7.5
x = 120.0
y = 250.0
height = "1.3 Hs"
"""


def test_a_crest_on_cue_is_told_and_found_where_it_was_asked_for(ocean):
    ocean.write("hero.toml", HERO)
    state = state_of(ocean, "hero.toml")
    (crest,) = state["crests"]
    assert crest["height"] == pytest.approx(3.9, abs=1e-3)
    assert 1e5 < crest["one_in_forristall"] < crest["one_in_rayleigh"] < 1e6
    assert any("1.30 Hs: one crest in" in warning for warning in state["warnings"])
    text = ocean.good("info", "hero.toml")
    assert re.search(r"Crest +3\.9 m, 1\.3 Hs, at \(120, 250\) m and 7\.5 s", text)
    ocean.write("points.csv", "x,y\n120,250\n")
    table = columns(
        ocean.good("query", "hero.toml", "--time", "7.5", "--points", "points.csv", "--exact")
    )
    assert table["height"][0] == pytest.approx(3.9, abs=1e-4)

    window = ("--find-crest", "--from", "0", "--to", "20")
    found = json.loads(ocean.good("info", "hero.toml", "--json", *window))
    assert found["height"] == pytest.approx(3.9, rel=0.03)
    assert math.hypot(found["x"] - 120.0, found["y"] - 250.0) < 8.0
    assert found["time"] == pytest.approx(7.5, abs=0.5)
    elsewhere = json.loads(
        ocean.good("info", "hero.toml", "--json", *window, "--box", "220,0,320,100")
    )
    assert elsewhere["height"] < 3.0 and 220.0 <= elsewhere["x"] <= 320.0
    assert "Highest crest" in ocean.good("info", "hero.toml", *window)
    ocean.write("swell.toml", SWELL)
    assert "crests" not in state_of(ocean, "swell.toml"), "a sea without them"
