# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean query`: the shown surface at points of the world."""

import numpy as np
import pytest

HEADER = "x,y,height,normal_x,normal_y,normal_z,velocity_x,velocity_y,velocity_z,foam"


def table(text):
    first, *lines = text.splitlines()
    assert first == HEADER
    rows = np.array([[float(cell) for cell in line.split(",")] for line in lines])
    return dict(zip(HEADER.split(","), rows.reshape(-1, HEADER.count(",") + 1).T, strict=True))


@pytest.fixture
def points(ocean):
    """200 random points, some of them far away."""
    xy = np.random.default_rng(5).uniform(-300.0, 300.0, (200, 2))
    xy[::10] += 1e6
    ocean.write("points.csv", "x,y\n" + "".join(f"{x!r},{y!r}\n" for x, y in xy.tolist()))
    return xy


def test_every_point_has_its_row_in_order(ocean, points):
    rows = table(ocean.good("query sea.toml --time 12 --points points.csv"))
    np.testing.assert_array_equal(rows["x"], points[:, 0])
    np.testing.assert_array_equal(rows["y"], points[:, 1])
    assert 0.2 < rows["height"].std() < 1.0
    normal = np.stack([rows["normal_x"], rows["normal_y"], rows["normal_z"]])
    np.testing.assert_allclose((normal**2).sum(axis=0), 1.0, atol=1e-6)
    assert set(rows["foam"]) <= set(np.clip(rows["foam"], 0.0, 1.0))


def test_points_come_from_standard_input_and_go_to_a_file(ocean, points):
    expected = ocean.good("query sea.toml --time 12 --points points.csv")
    arguments = ("query", "sea.toml", "--time", "12", "--points", "-", "-o", "out/heights.csv")
    done = ocean(*arguments, input=(ocean.folder / "points.csv").read_text())
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert (ocean.folder / "out/heights.csv").read_text() == expected
    assert ocean.files("out") == ["heights.csv"]


def test_a_frame_is_a_time(ocean, points):
    # Frame 25 at 24 frames per second, the first being 1.
    by_frame = ocean.good("query sea.toml --frame 25 --points points.csv")
    assert by_frame == ocean.good("query sea.toml --time 1 --points points.csv")
    assert by_frame != ocean.good("query sea.toml --time 0 --points points.csv")


def test_tables_as_people_write_them_are_read(ocean):
    plain = ocean.good(
        "query sea.toml --time 0 --points", ocean.write("a.csv", "x,y\n1,2\n-30,4e1\n")
    )
    dressed = b"\xef\xbb\xbf# two masts\r\n\r\n y , x \r\n 2.0,+1\r\n# the other\r\n40, -30.\r\n"
    text = ocean.good("query sea.toml --time 0 --points", ocean.write("b.csv", dressed))
    assert text == plain
    empty = ocean.write("empty.csv", "x,y\n")
    assert ocean.good("query sea.toml --time 0 --points", empty) == HEADER + "\n"


def test_unknown_columns_are_ignored_with_a_warning(ocean):
    plain = ocean.good("query sea.toml --time 0 --points", ocean.write("a.csv", "x,y\n1,2\n"))
    ocean.write("b.csv", "depth [m];x;time;y\n12,5;1;2020-06-08;2\n")
    done = ocean("query sea.toml --time 0 --points b.csv")
    assert (done.returncode, done.stdout) == (0, plain)
    assert done.stderr == (
        "ocean: warning: --points: ignored unknown columns: 'depth [m]', 'time'\n"
    )


def test_folded_points_are_counted(ocean):
    words = ("query", "sea.toml", "--time", 12, "--points", "line.csv", "--set")
    ocean.write("line.csv", "x,y\n" + "".join(f"{0.1 * i},50\n" for i in range(2000)))
    done = ocean(*words, "choppiness=4", "--set", "wind_speed=20", "--set", "patch_size=100")
    assert done.returncode == 0
    rows = table(done.stdout)
    assert np.isfinite(list(rows.values())).all()
    line = done.stderr.strip()
    assert line.startswith("ocean: warning: ") and "of 2000 points" in line
    assert 0 < int(line.split()[2]) < 2000
    assert ocean(*words, "choppiness=0.5").stderr == ""
    # Waves of 100 m height on a patch of 10 m: no sheet can be said to be the top.
    beyond = ["choppiness=4", "--set", "significant_wave_height=90", "--set", "patch_size=10"]
    done = ocean(*words, *beyond)
    assert done.returncode == 0
    assert "2000 of 2000 points" in done.stderr and "the first at 0,50" in done.stderr


def test_tables_of_other_programs_are_read(ocean):
    plain = ocean.write("p.csv", "x,y\n1,2\n30,-4\n")
    other = ocean.write("q.csv", 'Name; X [m] ;Y (metres)\n"Buoy; north";1;2\n b ;30; -4\n')
    arguments = ("query", "sea.toml", "--time", "1", "--points")
    expected = ocean.good(*arguments, plain.name).splitlines()
    rows = ocean.good(*arguments, other.name).splitlines()
    assert rows[0] == expected[0] + ",name"
    assert rows[1] == expected[1] + ',"Buoy; north"'
    assert rows[2] == expected[2] + ",b"
    read = ("--from", "0", "--to", "9", "--rate", "2")
    assert "Buoy; north" in ocean.good("gauge sea.toml --points", other.name, *read)


def test_the_sea_comes_from_standard_input(ocean):
    ocean.write("p.csv", "x,y\n1,2\n")
    expected = ocean.good("query sea.toml --time 1 --points p.csv")
    done = ocean.shell('"$OCEAN" query - --time 1 --points p.csv < sea.toml')
    assert (done.returncode, done.stdout) == (0, expected), done.stderr
    done = ocean.shell('cat sea.toml | "$OCEAN" info --json -')
    assert done.stdout == ocean.good("info --json sea.toml")
    both = ocean.shell('"$OCEAN" query - --time 1 --points - < sea.toml')
    assert both.returncode == 2 and "standard input: is read once" in both.stderr
