// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One measured sea: the record of a buoy or a wave model for one time at one place. Readers in
// ocean::seafile make it, in libocean's conventions; the directional estimate consumes it.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace ocean {

/// One measured sea: the record of a buoy or a wave model for one time at one place. Readers in
/// ocean::seafile make it; the directional estimate consumes it. A plain value. Angles are
/// converted already: counter-clockwise from east, the direction that waves travel to. A record has
/// no directions, or their first two moments (buoys), or the full distribution (wave models), never
/// both. Vectors are parallel to `frequency` unless stated otherwise.
struct SpectrumRecord {
    std::string station;
    std::string time;  // ISO 8601 in UTC, to the minute: 2020-06-08T03:50; empty = unknown
    double latitude = std::numeric_limits<double>::quiet_NaN();   // north [degrees]
    double longitude = std::numeric_limits<double>::quiet_NaN();  // east [degrees]
    double depth = std::numeric_limits<double>::quiet_NaN();      // [m]; NaN = unknown

    std::vector<double> frequency;  // [Hz], ascending, > 0
    std::vector<double> density;    // S(f) [m^2/Hz], >= 0

    // First and second normalised Fourier moments of the directional distribution, a_n = mean of
    // cos(n theta), b_n = mean of sin(n theta). Empty: not measured. NaN in a bin: missing there.
    // If only a2 and b2 are missing, a mean direction and a spread are known, and the distribution
    // is taken to be cos^2s of half the angle.
    std::vector<double> a1, b1, a2, b2;

    // The spectrum over frequency and direction: piecewise linear and periodic in direction.
    // Its integral over the circle at a frequency is `density` there.
    std::vector<double> direction;            // [degrees], 0 <= d < 360, ascending, 3 or more
    std::vector<double> directional_density;  // [m^2/Hz/degree], >= 0, [frequency][direction]

    // Assumptions, omissions and corrections of the reader: sentences for people.
    std::vector<std::string> warnings;
    // Why the record cannot be used, "PATH:LINE: FAULT"; empty for a good one. A record with a
    // fault has only time and place set.
    std::string fault;

    bool has_moments() const { return !a1.empty(); }
    bool is_directional() const { return !direction.empty(); }
    bool has_directions() const { return has_moments() || is_directional(); }
    bool operator==(const SpectrumRecord&) const = default;
};

}  // namespace ocean
