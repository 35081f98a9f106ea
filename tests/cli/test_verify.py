# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean verify`: lines, JSON and a page of HTML say what passes; a case that fails is status 1."""

import json
from xml.etree import ElementTree

QUICK = ("--only", "spectra")
VERDICTS = {"pass", "fail", "shortfall", "not run"}


def page_of(ocean, name: str) -> ElementTree.Element:
    """A page of ours is XML too, so that a tag that is not closed is found."""
    return ElementTree.fromstring((ocean.folder / name).read_text())


def test_json_page_and_lines_have_the_same_cases(ocean):
    done = ocean("verify", *QUICK, "--only", "sea", "sea.toml", "--json", "-o", "r.html")
    assert done.returncode == 0, done.stderr
    told = json.loads(done.stdout)
    rows = {row["id"]: row for row in told["rows"]}
    assert len(rows) == len(told["rows"])
    assert set(told["counts"]) == VERDICTS
    assert sum(told["counts"].values()) == len(rows)
    assert told["not_modelled"]
    assert all(told[key] for key in ("version", "compiler", "system", "instruction_set", "cores"))
    for row in rows.values():
        assert row["verdict"] in VERDICTS
        assert row["claim"] and row["kind"] in ("equations", "physics")
        if row["verdict"] == "pass":
            assert abs(row["measured"] - row["expected"]) <= 1.01 * row["tolerance"]
            assert row["reference"] and row["method"] and row["bound"]
    assert {"spectra.jonswap_height", "sea.variance", "sea.whitecaps"} <= set(rows)
    events = [json.loads(line) for line in done.stderr.splitlines()]
    assert [event["group"] for event in events] == ["spectra", "sea"]

    page = page_of(ocean, "r.html")
    assert {each.get("id") for each in page.iter("tr")} - {None} == set(rows)
    links = {each.get("href").removeprefix("#") for each in page.iter("a")}
    assert {"spectra", "sea"} <= links <= {each.get("id") for each in page.iter()}
    plots = list(page.iter("svg"))
    assert len(plots) == sum("plot" in row for row in rows.values()) > 1
    assert all(plot.find("title").text for plot in plots)

    lines = ocean.good("verify", *QUICK).splitlines()
    assert lines[-1] == f"{len(lines) - 1} of {len(lines) - 1} cases pass"
    assert {line.split()[1] for line in lines[:-1]} <= set(rows)


def test_runs_have_the_same_bytes(ocean):
    ocean.good("verify -q -o a.html", *QUICK)
    first = (ocean.folder / "a.html").read_bytes()
    ocean.good("verify -q --threads 1 -o a.html", *QUICK)
    assert (ocean.folder / "a.html").read_bytes() == first


def test_a_case_that_fails_is_status_1(ocean):
    # A patch of 20 m holds little of this sea.
    grid = ("--set", "patch_size=20", "--set", "resolution=32")
    done = ocean("verify", "sea.toml", *grid, "--only", "sea", "-o", "r.html")
    assert done.returncode == 1
    assert "sea.energy_of_grid" in done.stderr
    assert "fail      sea.energy_of_grid" in done.stdout
    failures = page_of(ocean, "r.html").find(".//ul/li/a")
    assert failures.get("href") == "#sea.energy_of_grid"
