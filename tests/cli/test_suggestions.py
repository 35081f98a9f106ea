# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A mistyped name is refused with the one that was probably meant, wherever it stands.
suggestions_test.cpp has the rule over all tables; here each place uses it."""

import os
import subprocess

import pytest

PREVIEW = os.environ.get("OCEAN_PREVIEW", "")
BRIDGE = os.environ.get("OCEAN_BRIDGE", "")
BAKE = ("bake", "sea.toml", "-o")

PLACES = {
    "commands": (["spectrun", "sea.toml"], "spectrum"),
    "options": ([*BAKE, "s.exr", "--farmes", "1"], "--frames"),
    "options before what is required": (["bake", "sea.toml", "--farmes", "1"], "--frames"),
    "options with an equals sign": ([*BAKE, "s.exr", "--fraems=1"], "--frames"),
    "short options": (["info", "sea.toml", "-V"], "-v"),
    "one dash": ([*BAKE, "s.exr", "-frames", "1"], "--frames"),
    "parameters": (["info", "sea.toml", "--set", "wnd_speed=1"], "waves.0.wind_speed"),
    "paths of parameters": (["info", "sea.toml", "--set", "waves.1.ftch=1"], "waves.0.fetch"),
    "a lost dot": (["info", "sea.toml", "--set", "timefps=1"], "time.fps"),
    "words of parameters": (["info", "sea.toml", "--set", "spectrum=jonswp"], "jonswap"),
    "formats": ([*BAKE, "s.exs"], ".exr"),
    "products": ([*BAKE, "s.exr", "--products", "foam,slpoe"], "slope"),
    "the beginning of a product": ([*BAKE, "s.exr", "--products", "disp"], "displacement"),
    "products of a mesh": ([*BAKE, "s.ply", "--products", "positqon"], "position"),
    "compression": ([*BAKE, "s.exr", "--compression", "pxr42"], "pxr24"),
    "axes": ([*BAKE, "s.exr", "--axes", "zpu"], "zup"),
    "type": ([*BAKE, "s.exr", "--type", "flqoat"], "float"),
    "layout": ([*BAKE, "s.exr", "--layout", "layred"], "layered"),
    "backend": ([*BAKE, "s.exr", "--backend", "radix"], "radix2"),
    "povray": (["povray", "sea.toml", "-o", "d", "--format", "mesh"], "mesh2"),
    "presets": (["presets", "seed_lanz"], "seed_lantz"),
    "preset: in a SEA": (["info", "preset:seed_thesi"], "seed_thesis"),
    "foam textures": (["foam-texture", "lce", "-o", "a.png"], "lace"),
}
SEA_FILES = {
    "[grd]\nresolution = 64\n": "grid",
    "[taek]\n": "take",
    "[grid]\nresoluton = 64\n": "grid.resolution",
    '[[waves]]\nspreading = "mitsyasu"\n': "mitsuyasu",
}


@pytest.mark.parametrize("place", PLACES)
def test_ocean_suggests(ocean, place):
    words, meant = PLACES[place]
    assert f"; did you mean {meant}?" in ocean.bad(*words)
    assert [path.name for path in ocean.folder.iterdir() if path.suffix != ".toml"] == []


@pytest.mark.parametrize("text", SEA_FILES)
def test_a_sea_file_suggests(ocean, text):
    ocean.write("k.toml", "libocean = 1\n" + text)
    assert f"; did you mean {SEA_FILES[text]}?" in ocean.bad("info", "k.toml")


def test_all_names_that_are_equally_near_are_listed(ocean):
    message = ocean.bad("presets", "beaufort_13")
    assert (
        "did you mean beaufort_1, beaufort_3, beaufort_10, beaufort_11 or beaufort_12?" in message
    )


@pytest.mark.parametrize(
    "words",
    [
        ["foam_textures_x"],
        ["info", "sea.toml", "--set", "wind_directions_x=1"],
        [*BAKE, "s.exr", "--compressors", "1"],
        [*BAKE, "s.exr", "--products", "nothing"],
        ["presets", "storm"],
    ],
)
def test_another_word_gets_no_suggestion(ocean, words):
    assert "did you mean" not in ocean.bad(*words)


def test_a_known_option_of_the_program_itself_is_named(ocean):
    assert "'--version' stands before the command" in ocean.bad("info", "--version")


def refusal(program: str, folder, *words: str) -> str:
    environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
    done = subprocess.run([program, *words], cwd=folder, env=environment, capture_output=True,
                          text=True, timeout=60)  # fmt: skip
    assert done.returncode == 2 and done.stdout == "" and done.stderr.count("\n") == 1, done
    return done.stderr


@pytest.mark.skipif(not PREVIEW, reason="no ocean-preview in this build")
def test_the_preview_suggests(ocean):
    ocean.write("list.txt", "a.png --haeding 90\n")
    for words, meant in (
        (["--ofscreen", "a.png"], "--offscreen"),
        (["--offscreen", "a.png", "--view", "butterlfy"], "butterfly"),
        (["--offscreen", "a.png", "--water", "jerlov_iiii"], "jerlov_iii"),
        (["--pictures", "list.txt"], "--heading"),
    ):
        assert f"did you mean {meant}?" in refusal(PREVIEW, ocean.folder, "sea.toml", *words)


@pytest.mark.skipif(not BRIDGE, reason="no ocean-bridge in this build")
def test_the_bridge_suggests(ocean):
    rule = '[[map]]\nfrom = "board0/a1"\nto = "wind_speed"\nout = [0, 30]\n'
    for text, meant in (
        ("[[mpa]]\n", "map"),
        (rule + "debonce_ms = 1\n", "debounce_ms"),
        (rule + 'mode = "togqle"\n', "toggle"),
        (rule.replace("wind_speed", "apps.peed"), "app.speed"),
        ('[[device]]\nid = "b"\ndriver = "k8505"\n', "k8055"),
        ('[[device]]\nid = "b"\ndriver = "midi"\nchanel = 1\n', "channel"),
    ):
        ocean.write("map.toml", text)
        message = refusal(BRIDGE, ocean.folder, "--map", "map.toml", "--listen", "127.0.0.1:0")
        assert f"did you mean {meant}?" in message
    assert "did you mean --dummy?" in refusal(BRIDGE, ocean.folder, "--dumy")
