// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The gauges of `ocean gauge`: from a table of points to places at any time of the record.
#pragma once

#include <string>
#include <vector>

namespace ocean::app {

/// Where a gauge is at one time; z up from still water.
struct GaugePlace {
    double x;  // m
    double y;
    double z;
};

struct Gauge {
    struct Fix {
        double time;  // s
        GaugePlace place;
    };

    std::string name;
    std::vector<Fix> track;   // in order of time, straight between; a single one is left at:
    double velocity_x = 0.0;  // m/s
    double velocity_y = 0.0;

    GaugePlace at(double time) const;
};

/// From CSV, "-" = standard input. Columns: x, y; name, the row's number without it; z, default 0;
/// velocity_x, velocity_y of a gauge that is at x, y at the time `from`; or time, and the rows of
/// one name are its track, which must cover from .. to. Throws Error bad_file.
std::vector<Gauge> read_gauges(const std::string& path, double from, double to, double depth);

}  // namespace ocean::app
