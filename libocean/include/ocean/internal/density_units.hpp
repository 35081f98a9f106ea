// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Units of spectral densities as people spell them: "m2 s rad-1", "m^2/(Hz deg)", "meter^2 second",
// "J/m2/Hz", "m² per Hz". A small grammar parses them; readers of spectra multiply by the resulting
// factor.
#pragma once

#include <string>
#include <string_view>

namespace ocean {

/// The variables that a spectrum is a density over.
enum class DensityOver { frequency, frequency_and_direction };

struct DensityUnit {
    double factor = 0.0;  // converts values to m^2/Hz, over directions to m^2/Hz/degree
    std::string fault;    // empty, or why the unit does not fit, and how it was parsed
};

/// Parses a unit; upper and lower case are the same. Blanks, `.`, `*`, `_` and `-` between names
/// multiply. `/` and `per` divide by the name that follows, or by everything that follows if only
/// then the unit is a density ("m2/Hz deg"). Powers are `2`, `^2`, `**2`, `^{-1}`, `²`, `squared`.
/// Energies per area (J/m2/Hz) are divided by rho g = 1025 kg/m^3 * 9.81 m/s^2, the defaults of
/// SWAN. Without directions, "m2 s rad-1" is a density per angular frequency; over directions it is
/// a density per Hz and radian, and an angular frequency needs a further angle: "m2/(rad/s)/deg".
DensityUnit parse_density_unit(std::string_view text, DensityOver over);

}  // namespace ocean
