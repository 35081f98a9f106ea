// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The header of a spectral file of SWAN: which times, places, frequencies, directions and
// quantities the spectra below it have. swan.cpp documents the format.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "free_form.hpp"
#include "ocean/internal/directional_record.hpp"

namespace ocean {

enum class SwanMeaning { density, direction, spread };

/// A column of a spectrum over frequency, or all of one over directions.
struct SwanQuantity {
    SwanMeaning meaning = SwanMeaning::density;
    double scale = 1.0;   // makes a density m^2/Hz
    bool action = false;  // variance over 2 pi f
    DirectionConvention convention = DirectionConvention::to_cartesian;
    bool spread_is_power = false;
    double exception = 0.0;
};

struct SwanPlace {
    std::string station;
    double latitude = kMissing;
    double longitude = kMissing;
};

struct SwanHeader {
    std::string_view time_pattern = {};  // empty: stationary, or iterations
    bool iterations = false;
    std::vector<SwanPlace> places = {};
    std::vector<double> frequency = {};
    std::optional<DirectionAxis> axis = {};  // none: over frequency only
    std::size_t directions = 0;              // of the axis
    std::vector<SwanQuantity> quantities = {};

    bool directional() const { return axis.has_value(); }
    bool stationary() const { return time_pattern.empty() && !iterations; }
};

/// Reads to the end of the header. Throws Error bad_file.
SwanHeader read_swan_header(FreeForm& in);

}  // namespace ocean
