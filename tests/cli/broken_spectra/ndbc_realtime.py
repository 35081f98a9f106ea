# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Broken NDBC real-time files: tables of densities, and companions beside good ones."""

from edits import replaced

HEADER = b"#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) spec_2 (freq_2) spec_3 (freq_3) ... >\n"
ROW = b"2020 06 08 03 50 0.225 0.060 (0.100) 1.210 (0.200) 0.500 (0.300) \n"
NEXT = ROW.replace(b" 03 50 ", b" 02 50 ")
GOOD = HEADER + ROW + NEXT
NAMES = {"swdir": b"alpha1", "swdir2": b"alpha2", "swr1": b"r1", "swr2": b"r2"}
VALUES = {"swdir": b"90.0", "swdir2": b"99.0", "swr1": b"0.80", "swr2": b"0.60"}


def alone(content):
    return {"b.data_spec": content}


def changed(old, new, content=GOOD):
    return alone(replaced(content, old, new))


def companion(suffix):
    head = b"#YY  MM DD hh mm %s_1 (freq_1) ... >\n" % NAMES[suffix]
    value = VALUES[suffix]
    pairs = b" ".join(value + b" (%s)" % f for f in (b"0.100", b"0.200", b"0.300"))
    return head + b"2020 06 08 03 50 " + pairs + b"\n2020 06 08 02 50 " + pairs + b"\n"


def beside(suffix, old, new):
    """A good table and its companions, `old` replaced in one of them."""
    files = alone(GOOD) | {f"b.{name}": companion(name) for name in NAMES}
    files[f"b.{suffix}"] = replaced(files[f"b.{suffix}"], old, new)
    return files


def many(count):
    return b" ".join(b"1 (%.5f)" % (0.01 + 1e-4 * i) for i in range(count))


CASES = [
    ("empty", alone(b""), None, "the file is empty"),
    ("header_alone", alone(HEADER), None, "holds no spectrum"),
    (
        "all_missing",
        alone(HEADER + b"2020 06 08 03 50 9.999 999.00 (0.1) MM (0.2)\n"),
        None,
        "holds no spectrum",
    ),
    ("cut_in_the_year", alone(HEADER + ROW + b"20"), 3, "''"),
    ("cut_after_the_date", alone(HEADER + ROW + b"2020 06 08"), 3, "a whole number of a date"),
    ("cut_after_the_time", alone(HEADER + ROW + b"2020 06 08 02 50"), 3, "separation frequency"),
    (
        "cut_after_separation",
        alone(HEADER + ROW + b"2020 06 08 02 50 0.225"),
        3,
        "fewer than 2 frequencies",
    ),
    ("cut_in_a_frequency", alone((HEADER + ROW + NEXT)[:-5]), 3, "pairs"),
    ("cut_before_a_frequency", alone(GOOD[:-10]), 3, "pairs"),
    ("cut_between_pairs", alone(GOOD[: GOOD.rindex(b" 0.500")]), 3, "ends within this line"),
    (
        "row_of_one_pair",
        alone(HEADER + b"2020 06 08 03 50 0.225 0.060 (0.100)\n"),
        2,
        "fewer than 2 frequencies",
    ),
    ("negative_density", changed(b"1.210", b"-1.210"), None, "is not within 0 .. 1e6 m^2/Hz"),
    ("density_nan", changed(b"1.210", b"nan"), 2, "'nan' is not a number"),
    ("density_infinite", changed(b"1.210", b"inf"), 2, "'inf' is not a number"),
    ("density_1e300", changed(b"1.210", b"1e300"), 2, "not 1e300"),
    ("density_overflows", changed(b"1.210", b"1e999"), 2, "'1e999' is not a number"),
    ("density_in_mm2", changed(b"1.210", b"1210000.1"), 2, "0 .. 1e6 m^2/Hz"),
    ("decimal_comma", changed(b"1.210", b"1,210"), 2, "'1,210' is not a number"),
    ("hexadecimal", changed(b"1.210", b"0x1p3"), 2, "'0x1p3' is not a number"),
    ("letters", changed(b"1.210", b"high"), 2, "'high' is not a number"),
    ("latin_1", changed(b"1.210", b"1\xb2"), 2, "is not a number"),
    ("nul_in_a_value", changed(b"1.210", b"1.2\0"), 2, "is not a number"),
    ("nul_block", alone(HEADER + b"\0" * 512 + ROW), 2, "is not a whole number of a date"),
    ("descending", changed(b"(0.300)", b"(0.150)"), 2, "do not ascend at bin 3"),
    ("frequency_twice", changed(b"(0.200)", b"(0.100)"), 2, "do not ascend at bin 2"),
    ("frequency_negative", changed(b"(0.100)", b"(-0.10)"), 2, "a frequency of -0.10"),
    ("frequency_in_millihertz", changed(b"(0.300)", b"(300.0)"), 2, "1e-5 .. 100 Hz"),
    ("frequency_nan", changed(b"(0.200)", b"(nan)"), 2, "'nan' is not a frequency"),
    ("brackets_of_another_kind", changed(b"(0.200)", b"[0.200]"), 2, "pairs"),
    ("brackets_lost", changed(b"(0.200)", b"0.200"), 2, "pairs"),
    ("month_13", changed(b"2020 06", b"2020 13"), 2, "date and time"),
    ("february_30", changed(b"2020 06 08", b"2020 02 30"), 2, "date and time"),
    ("date_in_one_word", changed(b"2020 06 08 03 50", b"20201345 03 50"), 2, "date"),
    ("hour_24", changed(b" 03 50", b" 24 50", GOOD.replace(b"\n", b"\r\n")), 2, "date and time"),
    (
        "too_many_frequencies",
        alone(HEADER + b"2020 06 08 03 50 0.2 " + many(4097) + b"\n"),
        2,
        "more than 4096",
    ),
    (
        "too_many_records",
        alone(HEADER + b"2020 06 08 03 50 0.2 1 (1) 1 (2)\n" * 100001),
        100002,
        "more than 100000 records",
    ),
    ("columns_of_a_companion", {"b.data_spec": companion("swr1")}, 1, "this is a .swr1 table"),
    (
        "companion_of_another_kind",
        beside("swdir", b"alpha1_1", b"alpha2_1"),
        1,
        "this is a .swdir2 table where .swdir is needed",
    ),
    ("companion_without_header", beside("swr2", b"#YY", b"#xx"), 2, "before the header line"),
    (
        "companion_out_of_the_circle",
        beside("swdir2", b"99.0 (0.200)", b"361.0 (0.200)"),
        2,
        "0 .. 360 degrees",
    ),
    (
        "companion_beyond_one",
        beside("swr1", b"0.80 (0.300)\n2020", b"80.0 (0.300)\n2020"),
        2,
        "r1 and r2 are 0 .. 1, not 80.0",
    ),
    (
        "companion_is_cut",
        beside(
            "swr2",
            b" 0.60 (0.300)\n2020 06 08 02 50 0.60 (0.100) 0.60 (0.200) 0.60 (0.300)\n",
            b" 0.60 (0.300)\n2020 06 08 02 50 0.60 (0.1",
        ),
        3,
        "pairs",
    ),
]
