// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What is checked of a time and of a number of samples where a caller's words first meet the
// mathematics.
#pragma once

#include <cmath>
#include <string>

#include "ocean/error.hpp"
#include "ocean/grid.hpp"

namespace ocean {

inline void require_finite_time(double time) {
    if (std::isfinite(time)) return;
    throw Error(ErrorKind::invalid_value, "time must be a finite number of seconds");
}

inline void require_map_resolution(int resolution) {
    if (is_power_of_two(resolution) && resolution >= kMinResolution &&
        resolution <= kMaxResolution) {
        return;
    }
    throw Error(ErrorKind::invalid_value, "resolution = " + std::to_string(resolution) +
                                              "; allowed: a power of two, 32 .. 8192");
}

}  // namespace ocean
