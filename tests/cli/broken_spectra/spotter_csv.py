# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Broken CSV of Spotter buoys: two spectra of three bins, with a mean direction and a spread."""

from edits import replaced

HEADER = (
    b"Power (W) ,Epoch Time ,Latitude (deg) ,Longitude (deg) ,f_0 ,f_1 ,f_2 ,"
    b"varianceDensity_0 ,varianceDensity_1 ,varianceDensity_2 ,direction_0 ,direction_1 ,"
    b"direction_2 ,directionalSpread_0 ,directionalSpread_1 ,directionalSpread_2 \n"
)
ROW = b"-0.3 ,1630901521 ,36.7 ,-121.9 ,0.1 ,0.2 ,0.4 ,1.5 ,2.5 ,0.5 ,270 ,180 ,90 ,36 ,35 ,34\n"
GOOD = HEADER + ROW + replaced(ROW, b"1630901521", b"1630890721")


def one(content):
    return {"spotter.csv": content}


def changed(old, new):
    return one(replaced(GOOD, old, new))


def many_bins(count):
    names = b"".join(b",f_%d,varianceDensity_%d" % (i, i) for i in range(count))
    return b"Epoch Time" + names + b"\n0" + b",1,1" * count + b"\n"


CASES = [
    ("no_time", changed(b"Epoch Time", b"Time"), 1, "the column Epoch Time is missing"),
    ("longitude_alone", changed(b"Latitude (deg)", b"Lat"), 1, "need each other"),
    ("time_twice", changed(b"Power (W)", b"Epoch Time"), 1, "Epoch Time appears twice"),
    ("bin_twice", changed(b",f_2", b",f_1"), 1, "the column f_1 appears twice"),
    ("bin_missing", changed(b",varianceDensity_1", b",x"), 1, "varianceDensity_1 is missing"),
    ("last_bin_missing", changed(b",varianceDensity_2", b",x"), 2, "2 values of varianceDensity"),
    ("no_frequencies", changed(b",f_0 ,f_1 ,f_2", b",x,x,x"), 2, "a spectrum without frequency"),
    ("bin_4096", changed(b",f_2", b",f_4096"), 2, "3 values of varianceDensity for 2 freq"),
    ("descending", one(many_bins(2)), 2, "the frequencies do not ascend at bin 2"),
    ("time_in_iso", changed(b"1630901521", b"2021-09-06T04:12"), 2, "is not a number"),
    ("time_in_milliseconds", changed(b"1630901521", b"1.63e15"), 2, "an Epoch Time of '1.63e15'"),
    ("time_missing", changed(b"1630901521", b"-"), 2, "an Epoch Time of '-'; allowed: seconds"),
    ("latitude_95", changed(b",36.7", b",95"), 2, "a latitude of 95; allowed: -90 .. 90"),
    ("density_negative", changed(b",2.5 ", b",-2.5 "), None, "is not within 0 .. 1e6 m^2/Hz"),
    ("density_infinite", changed(b",2.5 ", b",inf "), 2, "'inf' is not a number"),
    ("density_of_letters", changed(b",2.5 ", b",n/a "), 2, "'n/a' is not a number"),
    ("direction_in_3000", changed(b",180 ", b",3000 "), 2, "a direction of 3000; allowed"),
    ("spread_negative", changed(b",35 ", b",-35 "), 2, "a spread of -35; allowed: 0 .. 180"),
    ("field_missing", changed(b",35 ", b""), 2, "fewer fields"),
    ("field_too_many", changed(b",35 ", b",35 ,"), 2, "more fields"),
    ("quote_open", changed(b",35 ", b',"35 '), 2, "a quote is not closed"),
    ("cut_within_a_row", one(GOOD[:-12]), 3, "the file ends within this line"),
]
