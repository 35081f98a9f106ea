# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Broken spectra of SWAN, over frequency and direction (GOOD) and over frequency (GOOD_1D).

A case is (name, files, line of the message or None, fragment of the message).
"""

from edits import first_lines, replaced, without_line

GOOD = b"""SWAN   1                                Swan standard spectral file
$ comment
TIME                                    time-dependent data
     1                                  time coding option
LONLAT                                  locations in spherical coordinates
     2                                  number of locations
  174.67  -38.17
  174.77  -38.17
AFREQ                                   absolute frequencies in Hz
     3                                  number of frequencies
    0.0800
    0.1000
    0.1250
NDIR                                    spectral nautical directions in degr
     4                                  number of directions
   45.0
  135.0
  225.0
  315.0
QUANT
     1                                  number of quantities in table
VaDens                                  variance densities in m2/Hz/degr
m2/Hz/degr                              unit
   -99                                  exception value
20161011.000000                         date and time
FACTOR
    0.675611E-04
  51 242 574 956
  61 342 674 856
  71 442 774 756
ZERO
20161011.030000                         date and time
NODATA
FACTOR
    0.975611E-04
  50 240 570 950
  60 340 670 850
  70 440 770 750
"""
# Lines: 6 locations, 7-8, 10 frequencies, 11-13, 15 directions, 16-19, 21-24 quantity, 25 time,
# 26 FACTOR, 27, 28-30 values, 31 ZERO, 32 time, 33 NODATA, 34 FACTOR, 35, 36-38 values.

GOOD_1D = b"""SWAN   1
LOCATIONS
     1
   1000.0   2000.0
RFREQ
     2
    0.0800
    0.1000
QUANT
     3
VaDens
m2/Hz
   -0.9900E+02
CDIR
degr
   -0.9990E+03
DSPRDEGR
degr
   -0.9000E+01
LOCATION     1
  0.2500E+01   190.1    25.0
  0.1500E+01   180.1    26.0
"""


def changed(old, new, content=GOOD):
    return replaced(content, old, new)


def changed_1d(old, new):
    """The same of a spectrum over frequency."""
    return changed(old, new, GOOD_1D)


def lines(count):
    return first_lines(GOOD, count)


def without(number):
    return without_line(GOOD, number)


TWO_DIRECTIONS = changed(b"     4    ", b"     2    ").replace(b"  225.0\n  315.0\n", b"")
MANY_VALUES = (
    GOOD.replace(b"     3    ", b"   400    ")
    .replace(b"    0.1250\n", b"".join(b"%.4f\n" % (0.13 + 0.01 * i) for i in range(398)))
    .replace(b"     4    ", b"   720    ")
)

BROKEN = [
    # Keywords.
    ("version_2", changed(b"SWAN   1", b"SWAN   2"), 1, "version 2 of SWAN's files; known: 1"),
    ("locations_keyword_lost", without(5), 5, "'2' where LONLAT or LOCATIONS should be"),
    ("sections_shuffled", changed(b"AFREQ", b"QUANT"), 9, "'QUANT' where AFREQ or RFREQ"),
    ("quantities_keyword_garbled", changed(b"QUANT", b"QU\xc4NT"), 20, "where QUANT should be"),
    ("time_coding_unknown", changed(b"     1    ", b"     9    "), 4, "9 as time coding option"),
    ("time_coding_without_date", changed(b"     1    ", b"     4    "), 4, "has no dates"),
    # Locations.
    ("locations_1e9", changed(b"     2    ", b"1000000000"), 6, "1000000000 locations; allowed"),
    ("locations_none", changed(b"     2    ", b"     0    "), 6, "0 locations; allowed: 1"),
    ("location_lost", without(8), 8, "'AFREQ' is not a coordinate"),
    ("location_too_many", changed(b"     2    ", b"     1    "), 8, "where AFREQ or RFREQ"),
    ("location_without_latitude", changed(b"  -38.17", b""), 7, "the line ends where a coordinate"),
    (
        "location_latitude_first",
        changed(b"174.77  -38.17", b"-38.17  174.77"),
        8,
        "a latitude of 174.77",
    ),
    ("location_in_metres", changed(b"174.67", b"174670.0"), 7, "a longitude of 174670.0"),
    # Frequencies.
    ("frequencies_5000", changed(b"     3    ", b"  5000    "), 10, "5000 frequencies; allowed"),
    ("frequencies_negative", changed(b"     3    ", b"    -3    "), 10, "-3 frequencies"),
    ("frequencies_too_few", without(13), 13, "'NDIR' is not a frequency"),
    (
        "frequency_alone",
        changed(b"     3    ", b"     1    "),
        10,
        "1 frequencies; allowed: 2 .. 4096",
    ),
    ("frequencies_descend", changed(b"0.1250", b"0.0900"), 13, "do not ascend at bin 3"),
    ("frequency_nan", changed(b"0.1000", b"   NaN"), 12, "'NaN' is not a frequency"),
    ("periods_for_frequencies", changed(b"0.1250", b"125.00"), 13, "a frequency of 125.00"),
    # Directions.
    ("directions_1e9", changed(b"     4    ", b"     1e9  "), 15, "1e9 directions; allowed"),
    ("directions_2", TWO_DIRECTIONS, 15, "2 directions; allowed: 3 .. 720"),
    ("direction_out_of_range", changed(b"315.0", b"3150."), 19, "a direction of 3150."),
    ("direction_twice", changed(b"135.0", b" 45.0"), 19, "a direction appears twice"),
    ("values_288000", MANY_VALUES, 412, "at most 131072 values"),
    # Quantities.
    (
        "quantities_2",
        changed(b"     1" + 34 * b" " + b"number of q", b" 2 number of q"),
        21,
        "2 quantities; allowed: 1 .. 1",
    ),
    (
        "quantity_unknown",
        changed(b"VaDens", b"AcDens"),
        23,
        "is not a unit of AcDens; known: m2s/Hz/degr",
    ),
    ("exception_value_lost", without(24), 25, "'FACTOR' where a time"),
    # Times.
    ("month_13", changed(b"20161011.00", b"20161345.00"), 25, "'20161345.000000' where a time"),
    (
        "time_in_iso",
        changed(b"20161011.030000", b"2016-10-11T03:00"),
        32,
        "'2016-10-11T03:00' where a time",
    ),
    ("time_lost", without(32), 32, "'NODATA' where a time"),
    # Spectra.
    ("factor_keyword_lost", without(26), 26, "'0.675611E-04' where FACTOR, ZERO or NODATA"),
    ("factor_negative", changed(b"0.675611E-04", b"-.675611E-04"), 27, "a factor of -.675611E-04"),
    (
        "factor_huge",
        changed(b"0.675611E-04", b"0.675611E+34"),
        28,
        "51 times the factor is not within",
    ),
    ("value_negative", changed(b" 342 ", b"-342 "), None, "is not within 0 .. 1e6 m^2/Hz"),
    (
        "value_overflow",
        changed(b" 342 ", b" *** "),
        29,
        "'***' is not a density: the number was too wide",
    ),
    ("value_nul_bytes", changed(b" 342 ", b" 3\x002 "), 29, "is not a density"),
    (
        "column_lost",
        changed(b"  61 342 674 856\n", b"  61 342 674\n"),
        30,
        "'442' after the values",
    ),
    (
        "column_too_many",
        changed(b" 856\n", b" 856 0\n"),
        29,
        "'0' after the values of all directions",
    ),
    ("row_lost", without(30), 30, "'ZERO' is not a density"),
    (
        "row_twice",
        changed(b"  71 442", b"  71 442 774 756\n  71 442"),
        31,
        "'71' where FACTOR, ZERO or NODATA",
    ),
    ("zero_garbled", changed(b"ZERO", b"Z\xc9RO"), 31, "where FACTOR, ZERO or NODATA"),
    # Spectra over frequency.
    (
        "unit_over_frequency",
        changed_1d(b"m2/Hz", b"cm2/Hz"),
        12,
        "'cm2/Hz' is not a unit of VaDens",
    ),
    (
        "quantities_without_density",
        changed_1d(b"VaDens\nm2/Hz", b"NDIR\ndegr"),
        14,
        "a second CDIR",
    ),
    (
        "location_out_of_turn",
        changed_1d(b"LOCATION     1", b"LOCATION     7"),
        20,
        "LOCATION 7 where LOCATION 1",
    ),
    (
        "density_negative",
        changed_1d(b"0.2500E+01", b"-.2500E+01"),
        None,
        "is not within 0 .. 1e6 m^2/Hz",
    ),
    ("density_huge", changed_1d(b"0.1500E+01", b"0.1500E+99"), 22, "allowed: 0 .. 1e6 m2/Hz"),
    ("columns_shuffled", changed_1d(b"190.1    25.0", b"25.0    190.1"), 21, "a spread of 190.1"),
    ("spread_lost", changed_1d(b"    26.0", b""), 22, "the file ends where a number should be"),
    ("more_than_stationary", GOOD_1D + b"NODATA\n", 23, "'NODATA' after the last location"),
    # Cut files.
    ("cut_in_the_header", lines(17), 17, "the file ends where a direction should be"),
    ("cut_before_times", lines(24), None, "holds no spectrum"),
    ("cut_after_a_time", lines(32), 32, "the file ends where location 1 of 2 should be"),
    ("cut_in_a_row_crlf", GOOD[:-8].replace(b"\n", b"\r\n"), 38, "the file ends where a density"),
]

CASES = [(name, {"broken.spec": content}, line, words) for name, content, line, words in BROKEN]
