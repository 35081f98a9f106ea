# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Seconds that POV-Ray takes to read. ctest runs nothing beside these: of two that wait for memory
at once one may take half as long again as alone, and the other not."""

from conftest import Folder, parse_seconds, sea_text


def test_a_choppy_frame_is_small_and_parses_fast(tmp_path):
    sea = sea_text(resolution=512, period=400.0, wind=10.0)
    exact = Folder(tmp_path / "df3", sea, "--near-only")
    text = Folder(tmp_path / "mesh2", sea, "--format", "mesh2")
    scene = 'Ocean_Load("sea_0001")\nobject { Ocean_Mesh() }'
    seconds = {"df3": [], "mesh2": []}
    for _ in range(3):
        seconds["df3"].append(parse_seconds(exact.run(scene)))
        seconds["mesh2"].append(parse_seconds(text.run(scene)))
    ratio = min(seconds["df3"]) / min(seconds["mesh2"])
    size = (exact.path / "sea_0001.df3").stat().st_size
    share = size / (text.path / "sea_0001.inc").stat().st_size
    print(f"\n{seconds}, ratio {ratio:.2f}; {size} bytes, {share:.3f} of the text")
    assert ratio <= 2.5
    assert share <= 0.25


def test_the_view_parses_as_fast_as_a_period_of_its_sea(tmp_path):
    """At 512 samples; before its rows lay where pixels are it took 5.7 times as long."""
    folder = Folder(tmp_path, sea_text(resolution=512, period=690.0, wind=12.3))
    seconds = {"Ocean_Mesh()": [], "Ocean_View(<0, 8, 0>, <10, 7, 0>, 60, 1)": []}
    for _ in range(3):
        for form, times in seconds.items():
            scene = f'Ocean_Load("sea_0001")\nobject {{ {form} }}'
            times.append(parse_seconds(folder.run(scene, width=480, height=270)))
    mesh, view = map(min, seconds.values())
    print(f"\nview {view:.2f} s, mesh {mesh:.2f} s: {view / mesh:.2f}")
    assert view <= 5.7 / 4 * mesh
