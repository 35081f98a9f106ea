# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A sea with a take: found beside the sea file or where the user stands."""

import pytest

SEA = 'libocean = 1\n[time]\ntake = "storm.take"\n[grid]\nresolution = 64\npatch_size = 200.0\n'


def test_info_says_how_long_the_performance_is(ocean):
    ocean.write("take.toml", SEA)
    ocean.write("storm.take", "1 swell 0\n2.5 wind_speed 12\n")
    assert "2 changes from 1 to 2.5 s" in ocean.good("info take.toml")
    assert "change" not in ocean.good("info take.toml --set take=")


def test_a_resolved_sea_needs_no_take_file(ocean):
    ocean.write("take.toml", SEA)
    storm = ocean.write("storm.take", "1 wind_speed 12 # gusts\n3.5 spreading mitsuyasu\n")
    resolved = ocean.good("info take.toml --sea-file")
    assert '"1 waves.0.wind_speed 12"' in resolved
    storm.unlink()
    ocean.write("elsewhere/resolved.toml", resolved)
    assert ocean.good("info elsewhere/resolved.toml --sea-file") == resolved


def test_set_of_a_take_is_relative_to_the_working_directory(ocean):
    ocean.write("folder/sea.toml", SEA)
    ocean.write("folder/storm.take", "1 swell 0\n")
    ocean.write("calm.take", "1 swell 1\n")
    arguments = ("info", "folder/sea.toml", "--sea-file", "--set")
    assert '"1 waves.0.swell 1"' in ocean.good(*arguments, "take=calm.take")
    assert "[take]" not in ocean.good(*arguments, "take=")


def test_queries_and_gauges_follow_a_performance(ocean):
    ocean.write("storm.take", "1 wind_speed 15\n")
    ocean.write("take.toml", SEA)
    ocean.write("calm.toml", SEA.replace('[time]\ntake = "storm.take"\n', ""))
    ocean.write("p.csv", "x,y\n3,4\n")

    def height(sea, time):
        table = ocean.good("query", sea, "--time", time, "--points", "p.csv")
        return float(table.splitlines()[1].split(",")[2])

    assert height("take.toml", "0.5") == height("calm.toml", "0.5")
    assert height("take.toml", "4") != height("calm.toml", "4")
    ocean.good("gauge take.toml --points p.csv --from 0.5 --to 4 --rate 2 -o g.csv -q")
    rows = [line.split(",") for line in (ocean.folder / "g.csv").read_text().splitlines()[1:]]
    rms = sum(float(row[4]) ** 2 for row in rows) ** 0.5
    for row in rows:
        if row[0] in ("0.5", "4"):
            assert float(row[4]) == pytest.approx(height("take.toml", row[0]), abs=2e-3 * rms)
