// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Units of spectral densities and of times, as CF and programs close to CF write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ocean/internal/density_units.hpp"
#include "ocean/internal/utc_time.hpp"

namespace ocean::netcdf {

/// The conversion of a spectrum's numbers to [m^2/Hz], or over directions to [m^2/Hz/degree].
struct DensityUnits {
    double factor = 0.0;
    bool log10 = false;  // log10(density + 1e-12), as WAVEWATCH III packs it
    std::string fault;   // the reason why the units are not those of a density; or empty
};
/// Parses the units that parse_density_unit knows, and "log10(m2 s rad-1 +1E-12)".
DensityUnits parse_density_units(std::string_view units, DensityOver over);

/// A unit such as "days since 1990-01-01 00:00:00", in UTC.
struct TimeUnits {
    double seconds = 1.0;  // length of one unit [s]
    double origin = 0.0;   // [s] since 1970
};
std::optional<TimeUnits> parse_time_units(std::string_view units);
/// Returns the time to the nearest minute, because days as floating-point numbers have no exact
/// seconds. Returns nothing outside the years of UtcTime.
std::optional<UtcTime> time_at(const TimeUnits& units, double value);

}  // namespace ocean::netcdf
