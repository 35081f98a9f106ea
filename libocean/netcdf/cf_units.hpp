// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The units of CF and of the programs that nearly follow it: of spectral densities and of times.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ocean/internal/density_units.hpp"
#include "ocean/internal/utc_time.hpp"

namespace ocean::netcdf {

/// What brings the numbers of a spectrum to m^2/Hz, or over directions to m^2/Hz/degree.
struct DensityUnits {
    double factor = 0.0;
    bool log10 = false;  // log10(density + 1e-12), as WAVEWATCH III packs it
    std::string fault;   // why they are no units of such a density; or empty
};
/// What parse_density_unit knows, and "log10(m2 s rad-1 +1E-12)".
DensityUnits parse_density_units(std::string_view units, DensityOver over);

/// "days since 1990-01-01 00:00:00", in UTC.
struct TimeUnits {
    double seconds = 1.0;  // of one unit
    double origin = 0.0;   // seconds since 1970
};
std::optional<TimeUnits> parse_time_units(std::string_view units);
/// To the nearest minute: days as floating-point numbers have no exact seconds. Nothing outside the
/// years of UtcTime.
std::optional<UtcTime> time_at(const TimeUnits& units, double value);

}  // namespace ocean::netcdf
