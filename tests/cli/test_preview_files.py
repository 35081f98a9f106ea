# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Files that the window opens and saves: dropped by XDND, chosen in a dialog, recent ones."""

import os
import re
import shutil
import subprocess
import tomllib

import numpy
import OpenImageIO as oiio
import pytest
from test_preview import OCEAN, SEA, SIZE, WIND_SPEED, folder, pixels, rms, window  # noqa: F401

DROP_FILES = os.environ.get("DROP_FILES", "")
DIALOG = """#!/bin/sh
PATH=/usr/bin:/bin
printf '%s\\n' "$@" > "{folder}/asked"
while ! test -e "{folder}/answer"; do sleep .02; done
mv "{folder}/answer" "{folder}/answered"
cat "{folder}/answered"
"""


@pytest.fixture
def hand(folder, display, monkeypatch, request):  # noqa: F811
    """A window on a machine without programs that ask for files."""
    (folder / "bin").mkdir()
    (folder / "bin" / "xdotool").symlink_to(shutil.which("xdotool"))
    monkeypatch.setenv("PATH", str(folder / "bin"))
    options = getattr(request, "param", "200x150 --look physical").split()
    with window(folder, display, "--size", *options) as used:
        yield used


def drop(hand, *paths):
    if not DROP_FILES:
        pytest.skip("libX11 is needed")
    subprocess.run([DROP_FILES, "ocean-preview", *map(str, paths)], env=hand.environment,
                   check=True, timeout=120)  # fmt: skip


def shown(hand) -> numpy.ndarray:
    """Returns the picture of a sea that stands still. Its name begins with that of the sea."""
    written = re.compile(r"written: (.*\.png)$")
    before = sum(1 for line in list(hand.lines) if written.search(line.rstrip()))
    hand.key("shift")
    hand.key("F12")

    def picture():
        names = [found[1] for line in list(hand.lines) if (found := written.search(line.rstrip()))]
        return names[before] if len(names) > before else None

    return pixels(hand.folder / hand.wait_for(picture))


def wind(hand, name: str) -> float:
    """Returns the wind of the shown sea, which is saved under a typed name."""
    hand.key("ctrl+s")
    hand.key("ctrl+a")
    hand.type(name)
    hand.key("Return")
    hand.wait_for_line(f"written: {name}.toml")
    return tomllib.loads((hand.folder / f"{name}.toml").read_text())["waves"][0]["wind_speed"]


def wait_for_title(hand, source):
    window = hand.do("search", "--name", "ocean-preview").strip()
    hand.wait_for(lambda: hand.do("getwindowname", window).strip() == f"ocean-preview: {source}")


def recent(hand) -> list[str]:
    return (hand.folder / "state" / "libocean" / "recent").read_text().splitlines()


def test_dropped_files_open_and_wrong_ones_say_why(hand):
    folder = hand.folder  # noqa: F811
    hand.key("space")

    # A sea file whose name has blanks and letters of other alphabets.
    other = folder / "strong wind ü.toml"
    other.write_text(SEA.replace("9.0", "19.0"))
    drop(hand, other)
    hand.wait_for_line(f"opened: {other}")
    wait_for_title(hand, other)
    strong = shown(hand)

    # A picture of it has the sea, too.
    subprocess.run([OCEAN, "bake", "sea.toml", "-q", "-o", "baked.exr", "--products", "height"],
                   cwd=folder, check=True)  # fmt: skip
    drop(hand, folder / "baked.exr")
    hand.wait_for_line(f"opened: {folder / 'baked.exr'}")
    assert rms(shown(hand), strong) > 0.02

    # A wrong file is reported with the reason, and the sea stays.
    (folder / "broken.toml").write_text(SEA.replace("wind_speed", "wind_sped"))
    (folder / "photo.jpg").write_bytes(b"\xff\xd8\xff\xe0\0\x10JFIF")
    for wrong, reason in (
        (folder / "broken.toml", "did you mean waves.0.wind_speed?"),
        (
            folder / "photo.jpg",
            "a window opens seas, terrains, takes, baked files and skies (.exr)",
        ),
        (folder, "is a folder"),
    ):
        before = shown(hand)
        drop(hand, wrong)
        hand.wait_for(lambda reason=reason: any(reason in line for line in hand.lines))
        line = next(line for line in hand.lines if reason in line)
        assert line.startswith("ocean-preview: warning: not opened: ") and str(wrong) in line
        assert rms(shown(hand), before) < 0.01
    wait_for_title(hand, folder / "baked.exr")

    # Undo goes back to the sea before, which was never saved.
    hand.key("ctrl+z")
    wait_for_title(hand, other)
    assert rms(shown(hand), strong) < 0.01
    assert recent(hand) == [str(folder / "baked.exr"), str(other), str(folder / "sea.toml")]
    assert wind(hand, "saved") == 19.0
    drop(hand, folder / "baked.exr")
    assert wind(hand, "again") == 9.0
    assert recent(hand)[0] == str(folder / "again.toml")
    assert "rror" not in hand.end()


@pytest.mark.parametrize("hand", [f"{SIZE} --look physical"], indirect=True)
def test_dropped_takes_and_skies_open_and_no_recording_is_lost(hand):
    folder = hand.folder  # noqa: F811
    hand.key("space")
    before = shown(hand)
    # Two files at once, of which one cannot be opened.
    (folder / "gust.take").write_text("0 wind_speed 3\n1 wind_speed 12\n")
    drop(hand, folder / "gust.take", folder / "none.toml")
    hand.wait_for(lambda: any("none.toml: no such file" in line for line in hand.lines))
    hand.wait_for_line(f"opened: {folder / 'gust.take'}")
    wait_for_title(hand, "sea.toml")

    # A red sky.
    sky = numpy.zeros((32, 64, 3), numpy.float32)
    sky[..., 0] = 1.0
    spec = oiio.ImageSpec(64, 32, 3, oiio.FLOAT)
    output = oiio.ImageOutput.create("sky.exr")
    output.open(str(folder / "sky.exr"), spec)
    output.write_image(sky)
    output.close()
    drop(hand, folder / "sky.exr")
    hand.wait_for_line(f"opened: {folder / 'sky.exr'}")
    red = shown(hand)
    assert red[..., 0].mean() > 3 * red[..., 2].mean() and rms(red, before) > 0.2

    # A recording that is in no file is saved before another sea replaces it.
    hand.key("r")
    hand.drag(*WIND_SPEED, WIND_SPEED[0] + 40, WIND_SPEED[1])
    (folder / "other.toml").write_text(SEA)
    drop(hand, folder / "other.toml")
    hand.wait_for_line(f"opened: {folder / 'other.toml'}")
    lines = tomllib.loads((folder / "sea-performed-1.toml").read_text())["take"]["lines"]
    assert len(lines) > 1
    hand.end()


def test_a_dialog_opens_and_saves_beside_the_drawing(folder, display, monkeypatch):  # noqa: F811
    tools = folder / "tools"
    tools.mkdir()
    dialog = tools / "zenity"
    dialog.write_text(DIALOG.format(folder=folder))
    dialog.chmod(0o755)
    monkeypatch.setenv("PATH", str(tools), prepend=os.pathsep)
    with window(folder, display, "--size", "200x150") as hand:
        hand.key("space")
        (folder / "other.toml").write_text(SEA.replace("9.0", "19.0"))
        hand.key("ctrl+o")
        hand.wait_for(lambda: (folder / "asked").exists())
        # The window is drawn on while the dialog is open.
        hand.key("v")
        assert "--file-selection" in (folder / "asked").read_text()
        answer(folder, folder / "other.toml")
        hand.wait_for_line(f"opened: {folder / 'other.toml'}")

        (folder / "asked").unlink()
        hand.key("ctrl+s")
        hand.wait_for(lambda: (folder / "asked").exists())
        assert f"--filename={folder}/other-changed-1.toml" in (folder / "asked").read_text()
        answer(folder, folder / "mine")
        hand.wait_for_line(f"written: {folder / 'mine.toml'}")
        assert "wind_speed = 19.0" in (folder / "mine.toml").read_text()
        wait_for_title(hand, folder / "mine.toml")

        # The dialog has asked about replacing a sea; no other file is replaced.
        (folder / "notes.txt").write_text("mine\n")
        for name, told in (("mine.toml", "written"), ("notes.txt", "not saved")):
            (folder / "asked").unlink()
            before = len(hand.lines)
            hand.key("ctrl+s")
            hand.wait_for(lambda: (folder / "asked").exists())
            answer(folder, folder / name)
            hand.wait_for(
                lambda before=before, told=told: any(told in x for x in hand.lines[before:])
            )
        assert (folder / "notes.txt").read_text() == "mine\n"
        # A dialog that is open ends with the window.
        hand.key("ctrl+o")
        hand.end()
        assert recent(hand)[0] == str(folder / "mine.toml")


def answer(folder, path):  # noqa: F811
    beside = folder / "answer.new"
    beside.write_text(f"{path}\n")
    beside.rename(folder / "answer")


def test_without_a_dialog_a_path_is_typed(hand):
    other = hand.folder / "typed.toml"
    other.write_text(SEA.replace("9.0", "19.0"))
    hand.key("space")
    # Escape closes the field and not the window.
    hand.key("ctrl+o")
    hand.type("none.toml")
    hand.key("Escape")
    hand.key("v")
    hand.key("ctrl+o")
    hand.key("ctrl+a")
    hand.type("typed.toml")
    hand.key("Return")
    hand.wait_for_line("opened: typed.toml")
    wait_for_title(hand, "typed.toml")
    # A name that is taken is refused: only a dialog has asked.
    hand.key("ctrl+s")
    hand.key("Return")
    hand.wait_for(lambda: any("typed.toml exists: choose another name" in x for x in hand.lines))
    assert recent(hand)[0] == str(other)
    hand.end()
