# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Broken TRIAXYS spectra, over frequency and direction."""

from edits import first_lines, replaced, without_line

GOOD = b"""TRIAXYS BUOY DATA REPORT - TAS01970 - TAB01401 - 4857.6668S16631.6837W
TYPE    = DIRECTIONAL SPECTRUM
DATE    = 2018-01-31 21:00(UTC)
NUMBER OF FREQUENCIES   = 3
INITIAL FREQUENCY (Hz)  = 0.000
FREQUENCY SPACING (Hz)  = 0.100
NUMBER OF DIRECTIONS    = 5
DIRECTION SPACING (DEG) = 90
COLUMNS = 0.00 TO 360.00 DEG
ROWS    = 0.00 TO   0.20 Hz
 0.0E+00 0.0E+00 0.0E+00 0.0E+00 0.0E+00
 1.0E-02 2.0E-02 3.0E-02 4.0E-02 1.0E-02
 5.0E-02 6.0E-02 7.0E-02 8.0E-02 5.0E-02
"""


def one(content):
    return {"buoy.DIRSPEC": content}


def changed(old, new):
    return one(replaced(GOOD, old, new))


CASES = [
    ("title_alone", one(first_lines(GOOD, 1)), 1, "the file ends where a line of the header"),
    ("header_cut", one(first_lines(GOOD, 7)), 7, "the file ends where a line of the header"),
    ("no_type", one(without_line(GOOD, 2)), 9, "the header before has no TYPE"),
    ("mean_directions", changed(b"= DIRECTIONAL", b"= MEAN"), 2, "TYPE 'MEAN SPECTRUM'; known"),
    ("no_date", one(without_line(GOOD, 3)), 9, "the header before has no DATE"),
    ("local_date", changed(b"(UTC)", b"(local)"), 3, "is not like 2018-01-31 21:00(UTC)"),
    ("date_in_american", changed(b"2018-01-31", b"01/31/2018"), 3, "the DATE '01/31/2018 21:00"),
    ("no_frequencies", one(without_line(GOOD, 4)), 9, "has no NUMBER OF FREQUENCIES"),
    ("frequencies_1e9", changed(b"= 3", b"= 1000000000"), 4, "'1000000000' frequencies; allowed"),
    ("frequencies_of_letters", changed(b"= 3", b"= three"), 4, "'three' frequencies; allowed"),
    ("no_spacing", one(without_line(GOOD, 6)), 9, "has no FREQUENCY SPACING (Hz)"),
    ("spacing_zero", changed(b"0.100", b"0.000"), 6, "a spacing of '0.000'"),
    ("two_directions", changed(b"= 5", b"= 2"), 7, "'2' directions; allowed: 3 .. 720"),
    ("beyond_the_circle", changed(b"= 90", b"= 120"), 10, "a direction appears twice"),
    (
        "values_3_million",
        one(replaced(replaced(GOOD, b"= 3", b"= 4096"), b"= 5", b"= 720")),
        10,
        "at most 131072 values",
    ),
    ("row_missing", one(first_lines(GOOD, 12)), 12, "the file ends where row 3 of 3 should be"),
    ("row_too_many", one(GOOD + b" 1 1 1 1 1\n"), 14, "where the title TRIAXYS BUOY DATA REPORT"),
    ("value_missing", changed(b" 3.0E-02", b""), 12, "the line ends where a density should be"),
    ("value_too_many", changed(b"3.0E-02", b"3.0E-02 1"), 12, "after the densities of all"),
    ("density_negative", changed(b"3.0E-02", b"-3.0E-02"), None, "is not within 0 .. 1e6 m^2/Hz"),
    ("density_infinite", changed(b"3.0E-02", b"Inf"), 12, "'Inf' is not a density"),
    ("density_1e300", changed(b"3.0E-02", b"1e300"), 12, "0 .. 2500 m^2/Hz/deg"),
    ("second_report_cut", one(GOOD + first_lines(GOOD, 3)), 16, "the file ends where a line"),
]
