# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Broken point output of WAVEWATCH III: two points, two times, three frequencies, four directions.

A case is (name, files, line of the message or None, fragment of the message).
"""

from edits import first_lines, replaced, without_line

HEADER = b"""'WAVEWATCH III SPECTRA'     3     4     2 'a grid'
 0.500E-01 0.100E+00 0.200E+00
  0.000E+00  0.157E+01  0.314E+01  0.471E+01
"""
A = b"'A         '  40.98 -71.12      46.6   1.45 225.6   0.18  94.1\n"
B = b"'B         '  41.50 -70.00      30.0   2.00 180.0   0.10  90.0\n"
VALUES = b"""  0.100E+01  0.200E+01  0.300E+01  0.400E+01  0.500E+01  0.600E+01  0.700E+01
  0.800E+01  0.900E+01  0.100E+02  0.110E+02  0.120E+02
"""
POINTS = A + VALUES + B + VALUES
GOOD = HEADER + b"20220912 060000\n" + POINTS + b"20220912 070000\n" + POINTS
# Lines: 1 header, 2 frequencies, 3 directions, 4 time, 5 A, 6-7 values, 8 B, 9-10 values,
# 11 time, 12 A, 13-14 values, 15 B, 16-17 values.


def changed(old, new, content=GOOD):
    return replaced(content, old, new)


def lines(count):
    return first_lines(GOOD, count)


def without(number):
    return without_line(GOOD, number)


BROKEN = [
    # Wrong numbers in the header.
    ("frequencies_1e9", changed(b"     3     4", b"1000000000 4"), 1, "1000000000 frequencies"),
    ("frequencies_none", changed(b"     3     4", b"     0     4"), 1, "0 frequencies; allowed: 2"),
    ("directions_721", changed(b"     4     2", b"   721     2"), 1, "721 directions; allowed"),
    ("directions_negative", changed(b"     4     2", b"    -4     2"), 1, "-4 directions"),
    ("values_3_million", changed(b"     3     4", b"  4096   720"), 1, "at most 131072 values"),
    ("points_1e9", changed(b"     4     2", b"   4 1000000000"), 1, "1000000000 points"),
    ("points_half", changed(b"     4     2", b"     4   1.5"), 1, "1.5 points; allowed"),
    ("counts_missing", changed(b"     3     4     2 ", b""), 1, "is not the number of frequencies"),
    ("frequencies_too_few", changed(b"     3     4", b"     2     4"), 2, "after the frequencies"),
    (
        "frequencies_too_many",
        changed(b"     3     4", b"     5     4"),
        3,
        "the frequencies do not ascend",
    ),
    ("directions_too_few", changed(b"     4     2", b"     3     2"), 3, "after the directions"),
    (
        "directions_too_many",
        changed(b"     4     2", b"     6     2"),
        4,
        "a direction of 20220912",
    ),
    (
        "points_too_many",
        changed(b"     4     2", b"     4     3"),
        11,
        "a time where point 3 of 3 should be",
    ),
    ("points_too_few", changed(b"     4     2", b"     4     1"), 8, "where a time like"),
    # Frequencies and directions.
    (
        "frequencies_swapped",
        changed(b"0.500E-01 0.100E+00", b"0.100E+00 0.500E-01"),
        2,
        "do not ascend at bin 2",
    ),
    ("frequency_twice", changed(b"0.200E+00", b"0.100E+00"), 2, "do not ascend at bin 3"),
    ("frequency_in_mhz", changed(b"0.200E+00", b"0.200E+03"), 2, "1e-5 .. 100 Hz"),
    ("frequency_garbled", changed(b"0.200E+00", b"0.2O0E+00"), 2, "'0.2O0E+00' is not a frequency"),
    ("directions_in_degrees", changed(b"0.157E+01", b"0.900E+02"), 3, "0 .. 2 pi (radians)"),
    ("direction_twice", changed(b"0.157E+01", b"0.000E+00"), 3, "a direction appears twice"),
    ("direction_infinite", changed(b"0.157E+01", b" Infinity"), 3, "'Infinity' is not a direction"),
    # Times.
    ("month_13", changed(b"20220912 07", b"20221312 07"), 11, "'20221312' where a time"),
    ("day_31_of_june", changed(b"20220912 06", b"20220631 06"), 4, "'20220631' where a time"),
    ("hour_24", changed(b"20220912 060000", b"20220912 240000"), 4, "where a time like"),
    (
        "time_in_iso",
        changed(b"20220912 060000", b"2022-09-12T06:00"),
        4,
        "'2022-09-12T06:00' where",
    ),
    ("time_missing", without(11), 11, "where a time like"),
    # Points.
    (
        "latitude_beyond_pole",
        changed(b"40.98", b"98.40"),
        5,
        "a latitude of 98.40; allowed: -90 .. 90",
    ),
    ("longitude_beyond_circle", changed(b"-71.12", b"-711.2"), 5, "a longitude of -711.2"),
    (
        "columns_shuffled",
        changed(b"  41.50 -70.00      30.0", b"      30.0 -70.00 41500.0"),
        8,
        "a depth of 41500.0",
    ),
    ("current_missing", changed(b"   0.18  94.1", b""), 5, "the line ends where a current speed"),
    ("depth_overflow", changed(b"46.6", b"********"), 5, "the number was too wide for its column"),
    # Densities.
    (
        "density_negative",
        changed(b"  0.300E+01", b" -0.300E+01"),
        None,
        "is not within 0 .. 1e6 m^2/Hz",
    ),
    ("density_nan", changed(b"0.300E+01", b"      NaN"), 6, "'NaN' is not a density"),
    ("density_huge", changed(b"0.300E+01", b"0.300+300"), 6, "a density of 0.300+300"),
    ("density_overflow", changed(b"0.300E+01", b"*********"), 6, "'*********' is not a density"),
    (
        "density_decimal_comma",
        changed(b"0.300E+01", b"0,300E+01"),
        6,
        "'0,300E+01' is not a density",
    ),
    ("density_nul_bytes", changed(b"0.300E+01", b"0.30\0E+01"), 6, "is not a density"),
    ("density_missing", changed(b"  0.120E+02\n", b"\n"), 8, "''B' is not a density"),
    (
        "density_too_many",
        changed(b"0.120E+02\n", b"0.120E+02  0.130E+02\n"),
        7,
        "'0.130E+02' after the densities",
    ),
    ("density_latin_1", changed(b"0.300E+01", b"0.3\xb20E+01"), 6, "is not a density"),
    ("density_line_lost", without(13), 14, "''B' is not a density"),
    # Cut files.
    ("cut_in_the_header", GOOD[:60], 2, "the file ends where a frequency should be"),
    ("cut_before_times", lines(3), None, "holds no spectrum"),
    ("cut_after_a_time", lines(11), 11, "the file ends where point 1 of 2 should be"),
    ("cut_after_a_point", lines(14), 14, "the file ends where point 2 of 2 should be"),
    ("cut_in_values_crlf", lines(16).replace(b"\n", b"\r\n"), 16, "the file ends where a density"),
]

CASES = [(name, {"broken.spec": content}, line, words) for name, content, line, words in BROKEN]
