# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Broken CSV spectra: over frequency, and over frequency and direction."""

from edits import replaced

GOOD = b"""# one buoy
time,station,latitude,longitude,depth,frequency,density
2020-06-08T03:50Z,A,10,20,50,0.1,1.5
2020-06-08T03:50Z,A,10,20,50,0.2,2.5
2020-06-08T03:50Z,A,10,20,50,0.3,0.5
"""
GRID = b"frequency,direction,density\n" + b"".join(
    b"0.%d,%d,%d\n" % (f, d, f + d) for f in (1, 2) for d in (0, 90, 180, 270)
)


def one(content):
    return {"s.csv": content}


def changed(old, new, content=GOOD):
    return one(replaced(content, old, new))


def header(names):
    return one(names + b"\n0.1,1,1,1,1\n")


def many_frequencies():
    return b"frequency,density\n" + b"".join(b"%.5f,1\n" % (1e-3 * (i + 1)) for i in range(4097))


def many_directions():
    return b"frequency,direction,density\n" + b"".join(
        b"0.%d,%.2f,1\n" % (f, 0.25 * d) for f in (1, 2) for d in range(721)
    )


CASES = [
    ("comments_alone", one(b"# frequency,density\n"), None, "not a spectrum file"),
    ("header_alone", one(b"frequency,density\n"), None, "holds no spectrum"),
    ("all_missing", one(b"frequency,density\n.1,\n.2,nan\n"), None, "holds no spectrum"),
    ("mistyped_column", changed(b"density", b"densty"), 2, "did you mean density?"),
    ("unknown_column", changed(b"depth", b"zzzzzzzzzzzzzz"), 2, "unknown column"),
    ("latin_1_column", changed(b"depth", b"Tiefe \xfc"), 2, "unknown column"),
    ("frequency_missing", changed(b",frequency,", b",spread,"), 2, "frequency is missing"),
    ("column_twice", changed(b"station", b"density"), 2, "appears twice"),
    (
        "header_of_1000_columns",
        one(b"frequency,density" + b",time" * 1000 + b"\n"),
        1,
        "appears twice",
    ),
    ("wrong_unit", changed(b"density", b"density (dm5/Hz)"), 2, "units 'dm5/Hz'"),
    (
        "unit_of_a_grid",
        changed(b"density", b"density (m2/Hz/deg)"),
        2,
        "is not a unit of a density over frequency",
    ),
    ("unit_of_no_grid", changed(b"density", b"density (m2/Hz)", GRID), 1, "m2/Hz/deg"),
    ("frequency_in_kilohertz", changed(b"frequency", b"frequency [kHz]"), 2, "'kHz' of frequency"),
    ("depth_in_feet", changed(b"depth", b"depth (ft)"), 2, "'ft' of depth is unknown; allowed: m"),
    ("angular_frequency_alone", changed(b"frequency", b"frequency (rad/s)"), 2, "needs a unit"),
    (
        "two_conventions",
        header(b"frequency,density,direction,direction_to,time"),
        1,
        "more than one of direction",
    ),
    ("mean_without_spread", header(b"frequency,density,mean_direction"), 1, "need each other"),
    ("three_moments", header(b"frequency,density,a1,b1,a2"), 1, "a1, b1, a2 and b2 need"),
    (
        "moments_of_a_grid",
        header(b"frequency,density,direction,spread,mean_direction"),
        1,
        "exclude each other",
    ),
    ("latitude_alone", header(b"frequency,density,latitude"), 1, "need each other"),
    ("quote_in_header", changed(b"station", b'"station'), None, "not a spectrum file"),
    ("quote_in_row", changed(b",A,", b',"A,'), 3, "a quote is not closed"),
    ("cut_within_a_row", one(GOOD[:-8]), 5, "the file ends within this line"),
    ("field_missing", changed(b",A,", b","), 3, "fewer cells"),
    ("field_too_many", changed(b",1.5\n", b",1.5,\n"), 3, "more cells"),
    (
        "other_separator",
        changed(b"2020-06-08T03:50Z,A,10,20,50,0.2,2.5", b"2020-06-08T03:50Z;A;10;20;50;0.2;2.5"),
        4,
        "fewer cells",
    ),
    ("megabyte_of_commas", one(GOOD + b"," * 1000000 + b"\n"), 6, "more cells"),
    (
        "negative_density",
        changed(b",2.5", b",-2.5"),
        5,
        "the density of bin 2 is not within 0 .. 1e6",
    ),
    ("density_infinite", changed(b",2.5", b",inf"), 4, "the density 'inf'"),
    ("density_1e300", changed(b",2.5", b",1e300"), 4, "the density '1e300'"),
    ("density_overflows", changed(b",2.5", b",1e999"), 4, "'1e999' is not a number"),
    ("density_of_letters", changed(b",2.5", b",high"), 4, "'high' is not a number"),
    ("nul_in_a_value", changed(b",2.5", b",2.\0"), 4, "is not a number"),
    ("frequency_is_empty", changed(b",0.2,", b",,"), 4, "the frequency is missing"),
    ("frequency_negative", changed(b",0.2,", b",-0.2,"), 4, "the frequency '-0.2'"),
    ("frequency_too_high", changed(b",0.3,", b",300,"), 5, "within 0 .. 100"),
    ("frequency_twice", changed(b",0.3,", b",0.1,"), 5, "frequency appears twice"),
    ("one_frequency", one(b"frequency,density\r\n0.1,1\r\n"), 2, "at least 2 frequencies"),
    ("date_in_one_word", changed(b"2020-06-08T03:50Z", b"20201345"), 3, "'20201345' is not UTC"),
    ("february_30", changed(b"2020-06-08", b"2020-02-30"), 3, "is not UTC"),
    ("north_of_the_pole", changed(b",10,20", b",91,20"), 3, "the latitude '91'"),
    ("east_of_all", changed(b",10,20", b",10,361"), 3, "the longitude '361'"),
    ("above_the_water", changed(b",50,", b",-50,"), 3, "the depth '-50'"),
    ("depth_changes", changed(b",50,0.3", b",51,0.3"), 5, "the depth differs"),
    ("too_many_frequencies", one(many_frequencies()), 4098, "more rows"),
    ("direction_out_of_range", changed(b"0.1,90,", b"0.1,900,", GRID), 3, "the direction '900'"),
    ("direction_missing", changed(b"0.1,90,", b"0.1,,", GRID), 3, "the direction is missing"),
    ("direction_twice", changed(b"0.2,90,", b"0.2,0,", GRID), 7, "appear twice"),
    (
        "direction_of_one_frequency",
        changed(b"0.1,90,", b"0.1,91,", GRID),
        9,
        "no row for 0.1 Hz and 90 degrees",
    ),
    ("grid_is_cut", one(GRID[: GRID.rindex(b"0.2,270")]), 8, "no row for 0.2 Hz and 270 degrees"),
    (
        "two_directions",
        one(b"frequency,direction,density\n.1,0,1\n.1,90,1\n.2,0,1\n.2,90,1\n"),
        5,
        "at least 3 directions",
    ),
    ("too_many_directions", one(many_directions()), 1443, "at most 720 directions"),
    (
        "moment_beyond_one",
        one(b"frequency,density,a1,b1,a2,b2\n.1,1,1.2,0,0,0\n"),
        2,
        "the a1 '1.2' is not within -1 .. 1",
    ),
    (
        "spread_beyond_the_circle",
        one(b"frequency,density,mean_direction,spread\n.1,1,90,181\n"),
        2,
        "the spread '181'",
    ),
]
