// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The gauges of `ocean gauge`, from a table of points.
#pragma once

#include <string>
#include <vector>

#include "ocean/gauge_series.hpp"

namespace ocean::app {

struct GaugePoints {
    std::vector<Gauge> gauges;
    std::string left_out;  // as PointTable has it
};

/// From a table, "-" = standard input. Columns: x, y; name, the row's number without it; z, default
/// 0; velocity_x, velocity_y of a gauge that is at x, y at the time `from`; or time, and the rows
/// of one name are its track, which must cover from .. to. Throws Error bad_file.
GaugePoints read_gauges(const std::string& path, double from, double to, double depth);

}  // namespace ocean::app
