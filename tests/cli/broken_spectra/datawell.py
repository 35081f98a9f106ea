# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Broken Datawell spectra: twelve lines of one number, then a line for each frequency."""

from edits import first_lines, replaced, without_line

GOOD = b"""10
85.0
4.545
5.4183E-1
25.05
19.65
7
-0.17625
0.37500
0.26250
213.8
68.203
0.100,3.8012E-4,300.9,58.8,1.49,2.34
0.150,1.0000E+0,337.5,71.4,0.22,1.57
0.250,1.0002E-2,244.7,65.4,-0.32,1.99
"""


def one(content):
    return {"buoy}2024-09-09T01h15Z.spt": content}


def changed(old, new):
    return one(replaced(GOOD, old, new))


def many(count):
    return first_lines(GOOD, 12) + b"".join(
        b"%.4f,0.5,300.9,58.8,1.49,2.34\n" % (0.01 * (i + 1)) for i in range(count)
    )


CASES = [
    ("header_short", one(without_line(GOOD, 7)), 12, "is not the magnetic inclination"),
    ("smax_negative", changed(b"5.4183E-1", b"-0.5"), 4, "Smax of -0.5; allowed: 0 .. 1e6"),
    ("smax_huge", changed(b"5.4183E-1", b"1e300"), 4, "Smax of 1e+300; allowed: 0 .. 1e6"),
    ("temperature_missing", changed(b"25.05", b"-"), 5, "'-' is not the reference temperature"),
    ("one_frequency", one(first_lines(GOOD, 13)), 13, "fewer than 2 frequencies"),
    ("too_many_frequencies", one(many(4097)), 4109, "more than 4096 frequencies"),
    ("frequencies_descend", changed(b"0.250,", b"0.125,"), 15, "do not ascend at bin 3"),
    ("frequency_in_millihertz", changed(b"0.250,", b"250,"), 15, "a frequency of 250; allowed"),
    ("absolute_density", changed(b"1.0000E+0", b"5.4183"), 14, "a relative density of 5.4183"),
    ("density_negative", changed(b"1.0000E+0", b"-1"), None, "is not within 0 .. 1e6 m^2/Hz"),
    ("decimal_commas", changed(b"0.150,", b"0,150,"), 14, "more than the 6 numbers"),
    ("semicolons", changed(b"337.5,71.4", b"337.5;71.4"), 14, "fewer than the 6 numbers"),
    ("direction_of_letters", changed(b"337.5", b"NNW"), 14, "'NNW' is not a direction"),
    ("spread_too_wide", changed(b"71.4", b"714"), 14, "a spread of 714; allowed: 0 .. 180"),
    ("cut_within_a_row", one(GOOD[:-12]), 15, "the file ends within this line"),
]
