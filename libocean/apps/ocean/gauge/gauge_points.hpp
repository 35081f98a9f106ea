// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The gauges of `ocean gauge`, from a table of points.
#pragma once

#include <string>
#include <vector>

#include "ocean/internal/gauge_series.hpp"

namespace ocean::app {

struct GaugePoints {
    std::vector<Gauge> gauges;
    std::string left_out;  // of PointTable
};

/// Returns the gauges of a table; "-" = standard input. Columns: x, y; name, by default the row's
/// number; z, by default 0; velocity_x and velocity_y of a gauge that is at x, y at the time
/// `from`; or time, which makes the rows of one name a track that must cover from .. to. Throws
/// Error bad_file.
GaugePoints read_gauges(const std::string& path, double from, double to, double depth);

}  // namespace ocean::app
