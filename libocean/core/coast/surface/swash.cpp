// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Sand and foam of the swash: see swash.hpp.
#include "coast/surface/swash.hpp"

#include <algorithm>

#include "ocean/internal/surf_traces.hpp"

namespace ocean {

float surf_left(float bed) {
    constexpr float kFade = 0.3f;  // [m]
    return breaking_step(-bed / kFade);
}

float covered_by(float depth) {
    constexpr float kWet = 0.02f;                        // [m]
    return std::min(breaking_step(depth / kWet), 1.0f);  // rounding may exceed 1
}

float damp_of(float bed, float run_up) {
    constexpr float kDamp = 0.5f;
    constexpr float kFirst = 0.6f;  // height at which sand begins to dry, in units of the run-up
    if (run_up <= 1e-3f) return 0.0f;
    return kDamp * (1.0f - breaking_step((bed / run_up - kFirst) / (1.0f - kFirst)));
}

float tip_foam(float depth, float slope, float weight) {
    constexpr float kWidth = 1.5f;  // [m]
    constexpr float kMost = 0.8f;
    const float front = kWidth * beach_slope(slope);
    return kMost * weight * breaking_step(4.0f * depth / front) *
           (1.0f - breaking_step((depth - 0.5f * front) / front));
}

}  // namespace ocean
