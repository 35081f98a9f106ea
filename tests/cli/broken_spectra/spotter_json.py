# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Broken JSON of Spotter buoys: one spectrum, from line 2 on."""

from edits import replaced

GOOD = b"""{"data": {"spotterId": "SPOT-0070", "frequencyData": [
{"timestamp": "2018-02-14T00:27:19.000Z", "latitude": -61.0, "longitude": 173.4,
"frequency": [0.1, 0.2, 0.4],
"varianceDensity": [1.5, 2.5, 0.5],
"a1": [0.8, 0, -0.8],
"b1": [0, 0.8, 0],
"a2": [0.5, -0.5, 0.5],
"b2": [0.1, 0.1, 0.1]
}]}}
"""


def one(content):
    return {"spotter.json": content}


def changed(old, new):
    return one(replaced(GOOD, old, new))


CASES = [
    ("cut_in_a_list", one(GOOD[: GOOD.index(b"2.5")]), 4, "ends where its JSON does not"),
    ("cut_at_the_end", one(GOOD[:-4]), 9, "the file ends where its JSON does not"),
    ("two_documents", one(GOOD + GOOD), 10, "'{' is not what JSON has here"),
    ("comma_missing", changed(b"[0.1, 0.2", b"[0.1 0.2"), 3, "is not what JSON has here"),
    ("comma_too_many", changed(b"0.4]", b"0.4,]"), 3, "']' is not what JSON has here"),
    ("single_quotes", changed(b'"a1"', b"'a1'"), 5, "''' is not what JSON has here"),
    ("comment", changed(b"[0.1", b"// Hz\n[0.1"), 3, "'/' is not what JSON has here"),
    ("latin_1", changed(b"SPOT", b"SP\xd6T"), 1, "is not what JSON has here"),
    ("overflow", changed(b"2.5", b"2.5e999"), 4, "the number '2.5e999' is out of range"),
    ("hexadecimal", changed(b"2.5", b"0x10"), 4, "'x' is not what JSON has here"),
    ("density_negative", changed(b"2.5", b"-2.5"), None, "is not within 0 .. 1e6 m^2/Hz"),
    ("density_as_text", changed(b"2.5", b'"2.5"'), 4, "'varianceDensity' has a text"),
    ("density_in_a_list", changed(b"2.5", b"[2.5]"), 4, "'varianceDensity' has a list"),
    ("density_for_all", changed(b"[1.5, 2.5, 0.5]", b"1"), 4, "has a single number"),
    ("density_missing", changed(b", 2.5", b""), 9, "2 values of varianceDensity for 3"),
    ("no_densities", changed(b"varianceDensity", b"density"), 9, "without varianceDensity"),
    ("densities_twice", changed(b'"a1"', b'"varianceDensity"'), 5, "appears twice in one spectrum"),
    ("frequencies_descend", changed(b"0.4]", b"0.15]"), 9, "do not ascend at bin 3"),
    ("frequencies_4097", changed(b"[0.1", b"[" + b"0.1," * 4096 + b"0.1"), 3, "more than 4096"),
    ("moment_beyond_1", changed(b"-0.8", b"-1.8"), 5, "a moment of -1.8; allowed: -1 .. 1"),
    ("latitude_beyond_pole", changed(b"-61.0", b"-610"), 2, "a latitude of -610; allowed"),
    ("time_as_a_number", changed(b'"2018-02-14T00:27:19.000Z"', b"1518568039"), 2, "'timestamp'"),
    ("spectra_twice", changed(b"}]}}", b'}], "frequencyData": []}}'), 9, "appears twice"),
    ("nested_100000_deep", one(b'{"spotterId": ' + b"[" * 100000), 1, "more than 64 deep"),
]
