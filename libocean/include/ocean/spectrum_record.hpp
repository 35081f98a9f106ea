// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One measured sea: what a buoy or a wave model says of one time at one place. Readers in
// ocean::seafile make it, in libocean's conventions; the directional estimate consumes it.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace ocean {

/// Plain value. Angles are already converted: radians counter-clockwise from east, the direction
/// waves travel to. Vectors are parallel to `frequency`.
struct SpectrumRecord {
    std::string station;
    std::string time;  // ISO 8601 in UTC, to the minute: 2020-06-08T03:50
    double latitude = std::numeric_limits<double>::quiet_NaN();   // degrees north
    double longitude = std::numeric_limits<double>::quiet_NaN();  // degrees east
    double depth = std::numeric_limits<double>::quiet_NaN();      // m; NaN = not known

    std::vector<double> frequency;  // Hz, ascending, > 0
    std::vector<double> density;    // S(f), m^2/Hz, >= 0

    // First and second normalised Fourier moments of the directional distribution,
    // a_n = mean of cos(n theta), b_n = mean of sin(n theta). Empty: no directions were measured.
    // NaN in a bin: missing there.
    std::vector<double> a1, b1, a2, b2;

    bool has_directions() const { return !a1.empty(); }
    bool operator==(const SpectrumRecord&) const = default;
};

}  // namespace ocean
