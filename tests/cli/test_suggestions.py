# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A mistyped name is refused with the one that was probably meant, wherever it stands.
suggestions_test.cpp has the rule over all tables, refusals the places of `ocean`; here the other
programs use it."""

import os
import subprocess

import pytest

PREVIEW = os.environ.get("OCEAN_PREVIEW", "")
BRIDGE = os.environ.get("OCEAN_BRIDGE", "")


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
