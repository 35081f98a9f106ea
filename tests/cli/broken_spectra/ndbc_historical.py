# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Broken NDBC historical files: tables of densities, and companions beside good ones."""

import gzip

from edits import replaced

HEADER = b"#YY  MM DD hh mm   .1000   .2000   .3000\n"
ROW = b"2019 01 02 03 40    0.06    1.21    0.50\n"
NEXT = ROW.replace(b" 03 40 ", b" 04 40 ")
GOOD = HEADER + ROW + NEXT
VALUES = {"d": b"  90.0", "i": b"  99.0", "j": b" 80.00", "k": b" 60.00"}


def alone(content):
    return {"41010w2019.txt": content}


def changed(old, new, content=GOOD):
    return alone(replaced(content, old, new))


def companion(letter):
    values = b" ".join([VALUES[letter]] * 3)
    return HEADER + b"2019 01 02 03 40 " + values + b"\n2019 01 02 04 40 " + values + b"\n"


def beside(letter, old, new):
    """A good table and its companions, `old` replaced in one of them."""
    files = alone(GOOD) | {f"41010{name}2019.txt": companion(name) for name in VALUES}
    path = f"41010{letter}2019.txt"
    files[path] = replaced(files[path], old, new)
    return files


def wide(count):
    return b"#YY MM DD hh mm" + b"".join(b" %.5f" % (0.01 + 1e-4 * i) for i in range(count)) + b"\n"


CASES = [
    ("header_alone", alone(HEADER), None, "holds no spectrum"),
    ("header_cut", alone(HEADER[:24]), 1, "fewer than 2 frequencies"),
    (
        "all_missing",
        alone(HEADER + b"2019 01 02 03 40 99.00 999.00 MM\n"),
        None,
        "holds no spectrum",
    ),
    (
        "meteorology",
        alone(b"#YY  MM DD hh mm WDIR WSPD GST\n2019 01 02 03 40 90 5 6\n"),
        None,
        "not a spectrum file",
    ),
    ("first_row_before_header", alone(ROW + HEADER), None, "not a spectrum file"),
    ("cut_in_the_year", alone(HEADER + ROW + b"20"), 3, "a whole number of a date"),
    ("cut_after_the_date", alone(HEADER + ROW + b"2019 01 02"), 3, "a whole number of a date"),
    ("cut_after_the_time", alone(HEADER + ROW + b"2019 01 02 04 40"), 3, "ends within this line"),
    ("cut_between_values", alone(GOOD[:-9]), 3, "ends within this line"),
    ("short_row", changed(b"    1.21", b""), 2, "2 values for the 3 frequencies"),
    ("long_row", changed(b"1.21", b"1.21 1.22"), 2, "more values than the 3 frequencies"),
    ("rows_run_together", alone(HEADER + ROW[:-1] + b" " + NEXT), 2, "more values"),
    ("row_without_time", alone(HEADER + b"0.06 1.21 0.50\n"), 2, "whole number of a date"),
    ("row_without_minutes", changed(b" 03 40 ", b" 03 "), 2, "'0.06' is not a whole number"),
    ("header_without_minutes", changed(b" hh mm ", b" hh "), 2, "more values than the 3"),
    ("shuffled_columns", changed(b"MM DD", b"DD MM"), 1, "YY MM DD hh [mm]"),
    ("hours_missing", changed(b" hh mm", b" mm"), 1, "YY MM DD hh [mm]"),
    ("descending", changed(b".3000", b".1500"), 1, "do not ascend at bin 3"),
    ("frequency_twice", changed(b".2000", b".1000"), 1, "do not ascend at bin 2"),
    ("frequency_negative", changed(b".1000", b"-.100"), 1, "1e-5 .. 100 Hz"),
    ("frequency_in_millihertz", changed(b".3000", b"300.0"), 1, "1e-5 .. 100 Hz"),
    ("frequency_nan", changed(b".2000", b"nan"), 1, "'nan' is not a frequency"),
    ("frequency_infinite", changed(b".3000", b"inf"), 1, "'inf' is not a frequency"),
    ("frequency_of_letters", changed(b".2000", b"spec2"), 1, "'spec2' is not a frequency"),
    ("one_frequency", alone(b"#YY MM DD hh mm .1\n2019 01 02 03 40 1\n"), 1, "fewer than 2"),
    ("too_many_frequencies", alone(wide(4097)), 1, "more than 4096"),
    ("second_header_is_bad", alone(GOOD + b"#YY MM DD hh mm .3 .2 .1\n"), 4, "do not ascend"),
    ("negative_density", changed(b"1.21", b"-1.2"), None, "is not within 0 .. 1e6 m^2/Hz"),
    ("density_nan", changed(b"1.21", b"NaN"), 2, "'NaN' is not a number"),
    ("density_infinite", changed(b"1.21", b"-inf"), 2, "'-inf' is not a number"),
    ("density_1e300", changed(b"1.21", b"1e300"), 2, "not 1e300"),
    ("decimal_comma", changed(b"1.21", b"1,21"), 2, "'1,21' is not a number"),
    ("latin_1", changed(b"1.21", b"1\xb721"), 2, "is not a number"),
    ("nul_in_a_value", changed(b"1.21", b"1.2\0"), 2, "is not a number"),
    (
        "month_13_with_crlf",
        changed(b"2019 01", b"2019 13", GOOD.replace(b"\n", b"\r\n")),
        2,
        "date and time",
    ),
    ("no_leap_year", changed(b"2019 01 02 04", b"2019 02 29 04"), 3, "date and time"),
    ("date_in_one_word", changed(b"2019 01 02", b"20201345"), 2, "date"),
    ("too_many_records", alone(HEADER + ROW * 100001), 100002, "more than 100000 records"),
    ("table_of_directions", {"41010d2019.txt": companion("d")}, 1, "the table with 'w'"),
    ("direction_out_of_the_circle", beside("d", b"90.0", b"361."), 2, "0 .. 360 degrees"),
    ("negative_direction", beside("i", b"99.0", b"-9.0"), 2, "0 .. 360 degrees"),
    ("r1_beyond_one_hundred", beside("j", b"80.00", b"106.0"), 2, "0 .. 100 hundredths"),
    ("companion_row_is_short", beside("k", b"60.00", b""), 2, "2 values for the 3"),
    ("companion_without_header", beside("k", b"#YY", b"#xx"), 2, "before the header line"),
    (
        "packed_file_is_cut",
        {"41010w2019.txt.gz": gzip.compress(GOOD, mtime=0)[:-12]},
        None,
        "41010w2019.txt.gz",
    ),
]
