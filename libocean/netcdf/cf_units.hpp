// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The units of CF and of the programs that nearly follow it: of spectral densities and of times.
#pragma once

#include <optional>
#include <string_view>

#include "ocean/utc_time.hpp"

namespace ocean::netcdf {

/// What the numbers of a spectrum are: m^2/Hz, per angle or not, or their logarithm.
struct DensityUnits {
    enum class Angle { none, degree, radian };
    Angle angle = Angle::none;
    bool log10 = false;  // log10(density + 1e-12), as WAVEWATCH III packs it
    bool operator==(const DensityUnits&) const = default;
};
/// "m2 s rad-1", "m^{2}.s.degree^{-1}", "m**2 s radian**-1", "m2/Hz/deg", "m2 s", "m^2/Hz" ...
std::optional<DensityUnits> parse_density_units(std::string_view units);

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
