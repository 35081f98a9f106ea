# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The folder of `ocean povray`: what lies in it, its size, what goes wrong."""

import json
import re

import pytest
from conftest import (
    Folder,
    floats_of,
    ocean,
    parse_seconds,
    povray,
    read_png,
    render_as_it_is,
    sea_text,
    surface,
    tell,
)

import libocean


def test_the_frames_are_those_of_a_bake(tmp_path):
    sea = sea_text(resolution=64, period=60.0)
    for form, extension, options in (
        ("df3", "df3", ["--far-maps", "--fine-map", "--detail-map"]),
        ("mesh2", "inc", ["--mesh-foam"]),
    ):
        folder = Folder(tmp_path / form, sea, "--format", form)
        baked = tmp_path / ("baked_" + form)
        output = baked / f"sea_####.{extension}"
        done = ocean(tmp_path, "bake", folder.path / "sea.toml", "-o", output, *options)
        assert done.returncode == 0, done.stderr
        frames = sorted(baked.glob(f"sea_0001*.{extension}"))
        assert len(frames) == (4 if form == "df3" else 1)
        for frame in frames:
            assert frame.read_bytes() == (folder.path / frame.name).read_bytes(), frame.name


def test_every_parameter_is_declared(choppy):
    text = (choppy.path / "ocean_parameters.inc").read_text()
    sea = libocean.open(choppy.path / "sea.toml")
    known = 0
    for parameter in libocean.parameters():
        if parameter["section"] in ("crests", "hulls"):
            continue  # the sea has none
        section = "waves.0" if parameter["section"] == "waves" else parameter["section"]
        path = f"{section}.{parameter['key']}"
        value = sea.get(path)
        if not value or value == "[]":
            continue
        words = [word.capitalize() for word in re.split(r"[._]", path)]
        declared = re.search(rf"^#declare Ocean_{'_'.join(words)} = (.*?);", text, re.MULTILINE)
        assert declared, path
        if value in ("true", "false"):
            assert declared.group(1) == value, path
        elif value not in ("inf", "-inf") and not declared.group(1).startswith('"'):
            assert float(declared.group(1)) == pytest.approx(float(value), rel=1e-12), path
        known += 1
    assert known > 25


def test_a_folder_renders_as_it_is_and_its_loop_closes(tmp_path):
    """povray ocean.ini: a picture for each frame; a period on the sea is the same to the bit."""
    sea = sea_text(resolution=32, period=60.0).replace(
        "[[waves]]", "[time]\nfps = 4.0\nloop_period = 2.0\n[[waves]]", 1
    )
    Folder(tmp_path, sea, "--frames", "1-9")
    render_as_it_is(tmp_path, "ocean.ini", "+W32", "+H18")
    pictures = sorted(path.name for path in tmp_path.glob("scene*.png"))
    assert pictures == [f"scene{frame}.png" for frame in range(1, 10)]
    assert (tmp_path / "sea_0001.df3").read_bytes() == (tmp_path / "sea_0009.df3").read_bytes()
    assert (tmp_path / "sea_0001.df3").read_bytes() != (tmp_path / "sea_0005.df3").read_bytes()


def test_a_mesh_of_one_camera_takes_the_materials_of_the_macros(tmp_path):
    """That of `ocean bake --eye`, as animations of a camera that stands still want it: the names
    of both files live side by side, in either order, and it parses in less than half the time."""
    folder = Folder(tmp_path, sea_text(resolution=256, period=345.0, wind=12.3))
    command = "bake sea.toml -o view_####.inc --frames 1 --eye 0,0,8"
    assert ocean(tmp_path, command + " --mesh-columns 240 --mesh-rows 156").returncode == 0
    mesh = """Ocean_Load("sea_0001")
camera { location Ocean_Eye right x*image_width/image_height angle Ocean_View_Angle
         look_at Ocean_Eye + Ocean_Forward - 0.2*y }
Ocean_Eye_At(Ocean_Eye, Ocean_View_Angle)
Ocean_Sun(30, 20)
Ocean_Sky(0.2)
object { Ocean_Surface Ocean_Material("jerlov_ii") }"""
    few_rows = ["+SR90", "+ER97"]
    arguments = {"width": 288, "height": 162}
    for scene in (
        '#version 3.7;\n#include "ocean.inc"\n#include "view_0001.inc"\n',
        '#version 3.7;\n#include "view_0001.inc"\n#include "ocean.inc"\n',
    ):
        baked = parse_seconds(povray(tmp_path, scene + mesh, *few_rows, **arguments))
    made = parse_seconds(
        folder.run(
            'Ocean_Load("sea_0001")\nobject { Ocean_View(<0, 8, 0>, <10, 7, 0>, 60, 1) }',
            *few_rows,
            **arguments,
        )
    )
    print(f"\nbaked {baked:.2f} s, made {made:.2f} s")
    assert baked < made / 2


def test_the_macros_work_from_a_library_path(choppy, tmp_path):
    """As installed: the scene lies elsewhere, the folder is named by +L."""
    log = povray(
        tmp_path,
        "#version 3.7;\n"
        + choppy.head
        + choppy.load
        + tell("Ocean_Height(0, 0)")
        + "object { Ocean_Mesh() }",
        f"+L{choppy.path}",
    )
    assert floats_of(log)[0] == pytest.approx(surface(choppy).height[0, 0], abs=1e-6)


def test_every_public_macro_is_in_the_table_at_the_top(choppy):
    text = (choppy.path / "ocean.inc").read_text()
    head = text[: text.index("#ifndef(Ocean_Inc_Temp)")]
    macros = set(re.findall(r"^#macro (Ocean_\w*[^_\W])\(", text, re.MULTILINE))
    assert len(macros) > 18
    for macro in macros:
        assert macro + "(" in head, macro
        assert re.search(rf"^//   .*\b{macro}\(", text[len(head) :], re.MULTILINE), macro


def test_a_folder_without_far_maps_says_so_to_the_horizon(tmp_path):
    folder = Folder(tmp_path, sea_text(resolution=64), "--near-only")
    log = folder.error(folder.load + "object { Ocean_View(<0, 9, 0>, <9, 8, 0>, 50, 0.2) }")
    assert "Ocean_View needs the coarser maps, which --near-only left out" in log
    folder.run(folder.load + "object { Ocean_Mesh() }")


@pytest.mark.parametrize("format_", ["df3", "mesh2", "height_field"])
def test_the_scene_of_every_format_renders(tmp_path, format_):
    Folder(tmp_path, sea_text(resolution=32), "--format", format_)
    render_as_it_is(tmp_path, "scene.pov", "+W32", "+H18")
    picture = read_png(tmp_path / "scene.png")
    sky, water = picture[-2].mean(axis=0), picture[2].mean(axis=0)
    assert sky[2] > 1.1 * water[2], "the sea is not darker than the sky"


@pytest.mark.parametrize(
    "scene,words",
    [
        ('Ocean_Load("sea_0007")', ["no sea_0007.df3"]),
        ("object { Ocean_Mesh() }", ["Ocean_Mesh comes before Ocean_Load"]),
        ('Ocean_Load("sea_0001") object { Ocean_Height_Field() }', ["--format height_field"]),
        (
            'Ocean_Load("sea_0001") object { Ocean_Mesh() Ocean_Material("tap") }',
            ['no water type "tap"', "jerlov_9c"],
        ),
        ("Ocean_Sky(0)", ["Ocean_Sky comes before Ocean_Sun"]),
    ],
)
def test_the_macros_explain_errors(choppy, scene, words):
    log = choppy.error(scene)
    assert all(word in log for word in words), log[-600:]


def test_data_of_another_version_are_refused(tmp_path):
    folder = Folder(tmp_path, sea_text(resolution=32))
    path = tmp_path / "ocean_parameters.inc"
    path.write_text(path.read_text().replace("Data_Version = 4", "Data_Version = 5"))
    log = folder.error("")
    assert "data are of version 5, this file reads versions 3 and 4" in log


def test_a_folder_without_its_parameters_says_how_to_make_one(tmp_path):
    folder = Folder(tmp_path, sea_text(resolution=32))
    (tmp_path / "ocean_parameters.inc").unlink()
    assert "ocean povray SEA -o FOLDER" in folder.error(folder.load)


@pytest.mark.parametrize("format_", ["df3", "mesh2", "height_field"])
def test_a_dry_run_counts_the_whole_folder_and_writes_nothing(tmp_path, format_):
    (tmp_path / "its_sea.toml").write_text(sea_text(resolution=64))
    command = f"povray its_sea.toml -o f --frames 1-3 --format {format_}"
    done = ocean(tmp_path, command, "-n", "--json")
    assert done.returncode == 0 and not (tmp_path / "f").exists()
    (plan,) = [e for e in map(json.loads, done.stderr.splitlines()) if e["event"] == "plan"]
    made = ocean(tmp_path, command)
    assert made.returncode == 0 and made.stdout == done.stdout
    paths = made.stdout.splitlines()
    size = sum((tmp_path / path).stat().st_size for path in paths)
    assert plan["files"] == len(paths)
    assert size <= plan["bytes"] < 2 * size + 4096 * len(paths)
    again = ocean(tmp_path, command, "-n")
    assert "f/scene.pov\tkept" in again.stdout.splitlines()


def test_a_scene_that_is_there_is_kept(tmp_path):
    Folder(tmp_path, sea_text(resolution=32))
    (tmp_path / "scene.pov").write_text("// mine\n")
    done = ocean(tmp_path, "povray its_sea.toml -o . -v")
    assert done.returncode == 0
    assert (tmp_path / "scene.pov").read_text() == "// mine\n"
    assert "exists and is kept" in done.stderr
